//! Parsing again after edits gives what parsing alone gives, whatever is edited.

use super::language::PROGRAMS;
use super::properties::PIECES;
use crate::hir::LIBRARY;
use crate::source::{FileId, Source, floor_boundary};
use crate::syntax::again::Earlier;
use crate::syntax::{counted, parse, parse_again};
use proptest::prelude::*;

/// A change: how far along it begins, in thousandths, how much goes, and what comes.
type Change = (usize, usize, String);

fn change() -> impl Strategy<Value = Change> {
    let pieces = prop::collection::vec(prop::sample::select(PIECES), 1..4);
    let come = prop_oneof![
        3 => pieces.prop_map(|pieces| pieces.join(" ")),
        1 => "[ -~\n]{0,3}",
        1 => Just(String::new()),
        1 => any::<prop::sample::Index>().prop_map(|index| index.get(PROGRAMS).1.to_owned()),
    ];
    let go = prop_oneof![Just(0), 0..4usize, 0..400usize];
    (0..1000usize, go, come)
}

fn changed(text: &str, (along, go, come): &Change) -> String {
    let start = floor_boundary(text, text.len() * along / 1000);
    let end = floor_boundary(text, start + go);
    format!("{}{come}{}", &text[..start], &text[end.max(start)..])
}

/// Goes through the changes, each time with what came out before.
fn check(first: &str, changes: &[Change]) {
    let mut text = first.to_owned();
    let mut before = Source::new(FileId(0), "a.ifs", &*text);
    let mut known = parse(&before);
    for (turn, change) in changes.iter().enumerate() {
        text = changed(&text, change);
        // In turn as the same file and as another.
        let now = Source::new(FileId(turn as u32 / 3), "a.ifs", &*text);
        known = parse_again(&now, &before, known);
        assert!(known == parse(&now), "after {change:?}:\n{text}");
        before = now;
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(400) })]

    #[test]
    fn edits_of_programs(
        programs in prop::collection::vec(prop::sample::select(PROGRAMS), 1..4),
        changes in prop::collection::vec(change(), 1..12),
    ) {
        let texts: Vec<&str> = programs.iter().map(|(_, text)| *text).collect();
        check(&texts.join("\n"), &changes);
    }

    #[test]
    fn edits_of_the_library(
        module in prop::sample::select(LIBRARY),
        changes in prop::collection::vec(change(), 1..6),
    ) {
        check(module.1, &changes);
    }

    #[test]
    fn edits_of_what_is_no_program(changes in prop::collection::vec(change(), 1..20)) {
        check("", &changes);
    }
}

#[test]
fn only_what_has_changed_is_read() {
    let text: String = (0..1000).map(|place| format!("let a{place} = f({place}, b: [1, 2])\n")).collect();
    let before = Source::new(FileId(0), "a.ifs", &*text);
    let (known, whole) = counted(&before, None);
    let now = Source::new(FileId(0), "a.ifs", text.replace("a500 = ", "a500 = 2 * "));
    let (_, again) = counted(&now, Earlier::of(&now, &before, known));
    assert!(again * 100 < whole, "{again} of {whole} steps");
}
