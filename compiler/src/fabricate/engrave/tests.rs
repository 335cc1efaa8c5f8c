//! The font has what aliases need, keeps its promises, and no two glyphs look alike.

use super::*;

#[test]
fn every_promised_character_is_there_once() {
    let wanted: String = ('!'..='~').collect();
    let mut table: Vec<char> = characters().collect();
    table.sort_unstable();
    let mut wanted: Vec<char> = wanted.chars().collect();
    wanted.sort_unstable();
    assert_eq!(table, wanted);
    assert!(glyph(' ').unwrap().strokes.is_empty());
}

#[test]
fn an_unknown_character_is_named_never_dropped() {
    assert_eq!(letter("shell-ä").unwrap_err(), UnknownCharacter('ä'));
    assert_eq!(letter("a\tb").unwrap_err(), UnknownCharacter('\t'));
}

#[test]
fn no_two_glyphs_have_the_same_strokes() {
    let all: Vec<(char, Lettering)> = characters().map(|c| (c, glyph(c).unwrap())).collect();
    for (i, (a, first)) in all.iter().enumerate() {
        assert_ne!(first.strokes, up_mark().strokes);
        for (b, second) in &all[i + 1..] {
            assert_ne!(first.strokes, second.strokes, "{a} and {b}");
        }
    }
}

#[test]
fn glyphs_stay_in_their_cells() {
    for c in characters() {
        let glyph = glyph(c).unwrap();
        assert!(!glyph.strokes.is_empty());
        for p in glyph.strokes.iter().flatten() {
            assert!(p.x >= 0.0 && p.x <= glyph.advance - GAP / CAP + 1e-12, "{c} leaves its width");
            assert!((-4.0 / CAP..=14.0 / CAP).contains(&p.y), "{c} leaves its height");
        }
        assert!(glyph.strokes.iter().all(|s| s.len() >= 2 && s.windows(2).all(|w| w[0] != w[1])));
    }
}

#[test]
fn text_advances_glyph_by_glyph() {
    let word = letter("a b").unwrap();
    let [a, space, b] = ['a', ' ', 'b'].map(|c| glyph(c).unwrap());
    assert!((word.advance - (a.advance + space.advance + b.advance)).abs() < 1e-12);
    let shift = DVec2::new(a.advance + space.advance, 0.0);
    assert!((word.strokes[1][0] - (b.strokes[0][0] + shift)).length() < 1e-12);
}
