//! Texts and their tokens.

use super::parsed;
use crate::diagnostic::Code;
use crate::syntax::TokenKind::{self, *};
use crate::syntax::ast::Unit;

/// The tokens without space.
fn tokens(text: &str) -> Vec<(TokenKind, &str)> {
    let tokens = parsed(text).tokens;
    let shown = tokens.iter().filter(|token| token.kind != Whitespace);
    shown.map(|token| (token.kind, &text[token.span.range()])).collect()
}

/// The codes and places of all diagnostics.
fn said(text: &str) -> Vec<(Code, &str)> {
    parsed(text).diagnostics.iter().map(|said| (said.code, &text[said.span.range()])).collect()
}

#[test]
fn numbers_end_before_dots() {
    let plain = |text| (Number(None), text);
    assert_eq!(tokens("0..7"), [plain("0"), (DotDot, ".."), plain("7")]);
    assert_eq!(tokens("0.5e-3 1E5"), [plain("0.5e-3"), plain("1E5")]);
    assert_eq!(tokens("3.x"), [plain("3"), (Dot, "."), (Name, "x")]);
}

#[test]
fn every_unit_is_glued() {
    for unit in Unit::ALL {
        let text = format!("2.5{} x", unit.suffix());
        let number = &text[..text.len() - 2];
        assert_eq!(tokens(&text), [(Number(Some(*unit)), number), (Name, "x")]);
    }
}

#[test]
fn the_longest_unit_that_ends_there_is_taken() {
    let unit = |unit, text| (Number(Some(unit)), text);
    assert_eq!(tokens("3m/min")[0], unit(Unit::MetrePerMinute, "3m/min"));
    assert_eq!(tokens("1m/min(a, b)")[0], unit(Unit::MetrePerMinute, "1m/min"));
    assert_eq!(tokens("1m / min(a, b)")[..2], [unit(Unit::Metre, "1m"), (Slash, "/")]);
    assert_eq!(tokens("3m/minute")[..3], [unit(Unit::Metre, "3m"), (Slash, "/"), (Name, "minute")]);
    assert_eq!(tokens("3m/s2")[..2], [unit(Unit::Metre, "3m"), (Slash, "/")]);
    assert_eq!(tokens("2in"), [unit(Unit::Inch, "2in")]);
    assert_eq!(tokens("650kg/m3"), [unit(Unit::KilogramPerCubicMetre, "650kg/m3")]);
    assert_eq!(tokens("50%"), [unit(Unit::Percent, "50%")]);
    assert_eq!(tokens("1e3m"), [unit(Unit::Metre, "1e3m")]);
}

#[test]
fn words_glued_to_numbers_are_unknown_units() {
    for (text, word) in [
        ("12mmm", "mmm"),
        ("3foo", "foo"),
        ("2e", "e"),
        ("50%x", "%x"),
        ("1m_", "m_"),
        ("3ß", "ß"),
        ("35°", "°"),
    ] {
        assert_eq!(tokens(text), [(BadNumber, text)]);
        assert!(said(&format!("let a = {text}")).contains(&(Code::E0105, word)), "{text}");
        assert_eq!(said(&format!("let a = {text}")).len(), 1, "{text}");
    }
}

#[test]
fn numbers_have_a_largest_size() {
    let long = "1".repeat(101);
    for text in ["1e999", "1e301", "0e999", "1e-999", "1e99999999999999999999", "0.1e-300", &long, "1e999mm"]
    {
        assert_eq!(said(&format!("let a = {text}")), [(Code::E0104, text)]);
    }
    let large = format!("1{}", "0".repeat(99));
    let small = format!("0.{}1", "0".repeat(98));
    for text in ["1e300", "1e-300", "0.0", "10e299", &large, &small] {
        assert_eq!(said(&format!("let a = {text}")), []);
    }
    assert_eq!(said(&format!("let a = {}", "1".repeat(302))), [(Code::E0104, &*"1".repeat(302))]);
}

#[test]
fn texts_end_on_their_line() {
    assert_eq!(tokens(r#""a\"b" x"#), [(Text, r#""a\"b""#), (Name, "x")]);
    assert_eq!(tokens("\"a\nb"), [(Text, "\"a"), (Name, "b")]);
    assert_eq!(said("let a = \"b\\\nlet c = 3"), [(Code::E0103, "\"b")]);
    assert_eq!(said("let a = \"b\nlet c = 3"), [(Code::E0103, "\"b")]);
    assert_eq!(said(r#"let a = "C:\temp\x""#), [(Code::E0102, r"\x")]);
}

#[test]
fn comments_of_four_kinds() {
    assert_eq!(
        tokens("//! a\n/// b\n//// c\n// d\n//"),
        [(FileDocs, "//! a"), (ItemDocs, "/// b"), (Comment, "//// c"), (Comment, "// d"), (Comment, "//"),]
    );
}

#[test]
fn other_comments_are_passed_over_with_one_error() {
    assert_eq!(said("let a = 3 /* b\n c */ + 4"), [(Code::E0102, "/*")]);
    assert_eq!(said("# a b c\nlet a = 3"), [(Code::E0102, "#")]);
    assert_eq!(said("/* a\nlet a = 3"), [(Code::E0102, "/*")]);
}

#[test]
fn lookalikes_are_taken_for_what_is_meant() {
    for (strange, kind) in
        [("×", Star), ("−", Minus), ("≤", AtMost), ("&&", Name), ("→", Arrow), ("÷", Slash)]
    {
        assert!(tokens(&format!("a {strange} b")).contains(&(kind, strange)));
        assert_eq!(said(&format!("let a = b {strange} c")).len(), 1, "{strange}");
    }
    assert_eq!(said("let a = “text”"), [(Code::E0102, "“text”")]);
    assert_eq!(said("let a =\u{a0}3"), [(Code::E0102, "\u{a0}")]);
    assert_eq!(said("let a = 3;"), [(Code::E0102, ";")]);
    assert_eq!(said("let a = @ 3"), [(Code::E0102, "@")]);
    assert_eq!(said("let höhe = 3"), [(Code::E0102, "höhe")]);
}

#[test]
fn bidirectional_characters_are_errors_everywhere() {
    for text in ["// a\u{202e}b", "let a = \"x\u{2066}\"", "let a\u{200f} = 3"] {
        let codes: Vec<Code> = said(text).into_iter().map(|(code, _)| code).collect();
        assert_eq!(codes, [Code::E0106], "{text:?}");
    }
}

#[test]
fn a_byte_order_mark_is_space() {
    assert_eq!(said("\u{feff}let a = 3\r\nlet b = 4\r\n"), []);
}
