//! Tests of annotations: reading, comparing, updating.

use super::*;

fn found(code: &str, start: (usize, usize), end: (usize, usize), message: &str) -> Found {
    Found { file: None, start, end, code: code.into(), message: message.into() }
}

#[test]
fn what_is_written_is_read() {
    let text = "//@ set span=4m\nlet a = b //~ no annotation\n  //~ E0301 2:9..2:10 `b` is not known\n\
                //~ W0002 parts/ribs.ifs 1:1..12:4\n";
    let read = Annotations::parse(text).unwrap();
    assert_eq!(read.settings, [("span".to_owned(), "4m".to_owned())]);
    assert_eq!(read.expected[0], (3, found("E0301", (2, 9), (2, 10), "`b` is not known")));
    let other = Found { file: Some("parts/ribs.ifs".into()), ..found("W0002", (1, 1), (12, 4), "") };
    assert_eq!(read.expected[1], (4, other.clone()));
    assert_eq!(other.to_string(), "//~ W0002 parts/ribs.ifs 1:1..12:4");
}

#[test]
fn what_cannot_be_read_is_an_error_and_never_left_out() {
    for line in [
        "//~",
        "//~ E0301",
        "//~ 1:1..1:2",
        "//~ E0301 1:1-1:2 x",
        "//~ E0301 1:0..1:2 x",
        "//~ E03x1 1:1..1:2",
        "//~ e0301 1:1..1:2",
        "//~ E0301 a.ifs",
        "//@ sett a=1",
        "//@ set a",
    ] {
        let error = Annotations::parse(&format!("let a = 1\n{line}\n")).unwrap_err();
        assert!(error.starts_with("line 2: "), "{line}: {error}");
    }
}

#[test]
fn every_property_is_compared() {
    let stated = Annotations::parse("//~ E0301 2:1..2:3 not known\n").unwrap();
    let right = found("E0301", (2, 1), (2, 3), "`b` is not\n  known here");
    assert!(stated.compare(std::slice::from_ref(&right)).is_empty());
    for wrong in [
        Found { code: "E0302".into(), ..right.clone() },
        Found { start: (2, 2), ..right.clone() },
        Found { end: (3, 3), ..right.clone() },
        Found { file: Some("a.ifs".into()), ..right.clone() },
        Found { message: "known".into(), ..right.clone() },
    ] {
        let difference = stated.compare(std::slice::from_ref(&wrong));
        assert_eq!((difference.missing.len(), difference.unexpected.len()), (1, 1), "{wrong}");
    }
}

#[test]
fn counts_are_compared() {
    let stated = Annotations::parse("//~ E0301 2:1..2:3\n").unwrap();
    let one = found("E0301", (2, 1), (2, 3), "x");
    assert_eq!(stated.compare(&[one.clone(), one]).unexpected.len(), 1);
    assert_eq!(stated.compare(&[]).missing.len(), 1);
    assert!(stated.compare(&[]).to_string().contains("stated in line 1 and not found"));
}

#[test]
fn a_short_part_does_not_take_what_a_long_one_needs() {
    let stated = Annotations::parse("//~ E0301 3:1..3:3 ab\n//~ E0301 3:1..3:3 abc\n").unwrap();
    let all = [found("E0301", (3, 1), (3, 3), "abc"), found("E0301", (3, 1), (3, 3), "abd")];
    assert!(stated.compare(&all).is_empty());
}

#[test]
fn an_update_agrees_with_what_is_found_in_it() {
    // A compiler that finds every `b`, and one thing in another file.
    let analyse = |text: &str| -> Vec<Found> {
        let place = |(at, _)| found("E0301", position(text, at), position(text, at + 1), "`b` is not known");
        let code: Vec<usize> = text.match_indices('b').map(|(at, _)| at).collect();
        let in_code = |at: &usize| !text[..*at].rsplit('\n').next().unwrap_or_default().contains("//");
        let mut all: Vec<Found> = code.into_iter().filter(in_code).map(|at| place((at, ()))).collect();
        all.push(Found { file: Some("c.ifs".into()), ..found("E0001", (7, 1), (7, 2), "gone") });
        all
    };
    for text in [
        "",
        "let a = b",
        "//! Head.\r\n//~ E0301 3:9..3:10 b\r\nlet a = b\r\nlet é = b b\r\n",
        "let a = b\n//~ E0301 1:9..1:10 not\nlet c = b\n//~ E0999 1:1..1:2 old\n",
        "b\n//~ E0001 c.ifs 7:1..7:2\n",
    ] {
        let updated = update(text, &analyse(text)).unwrap();
        let again = analyse(&updated);
        let difference = Annotations::parse(&updated).unwrap().compare(&again);
        assert!(difference.is_empty(), "{text:?} became {updated:?}:\n{difference}");
        assert_eq!(update(&updated, &again).unwrap(), updated, "updating twice changes nothing");
        let without = |text: &str| -> String {
            text.split_inclusive('\n').filter(|line| !line.starts_with("//~")).collect()
        };
        assert_eq!(without(&updated), without(text), "the program itself stays");
    }
}

#[test]
fn an_update_keeps_the_wording_that_fits() {
    let text = "let a = b\n//~ E0301 1:9..1:10 not\n";
    let updated = update(text, &[found("E0301", (1, 9), (1, 10), "`b` is not known")]).unwrap();
    assert_eq!(updated, "//~ E0301 2:9..2:10 not\nlet a = b\n");
}

#[test]
fn positions_count_characters() {
    let text = "aé𝄞b\nc";
    assert_eq!(position(text, 0), (1, 1));
    assert_eq!(position(text, 3), (1, 3));
    assert_eq!(position(text, 5), (1, 3), "inside a character");
    assert_eq!(position(text, 7), (1, 4));
    assert_eq!(position(text, 9), (2, 1));
    assert_eq!(position(text, 99), (2, 2));
}
