//! What begins an item, a member or a line, with places to fill in.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::schema::SchemaKind;
use ifs_compiler::hir::types::PointSpace;
use ifs_compiler::source::Span;

use super::{Kind, Offer, needed};

/// A text that stands for itself in a snippet.
pub(crate) fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for c in text.chars() {
        if matches!(c, '$' | '}' | '\\') {
            escaped.push('\\');
        }
        escaped.push(c);
    }
    escaped
}

/// A call with places for arguments.
pub(super) fn call<'n>(name: &str, needed: impl Iterator<Item = &'n str>) -> String {
    let places = needed.enumerate().map(|(place, name)| format!("${{{}:{name}}}", place + 1));
    let places: Vec<String> = places.collect();
    if places.is_empty() { format!("{name}($0)") } else { format!("{name}({})", places.join(", ")) }
}

/// A snippet with what its places say already, for a client that fills in none.
pub(super) fn filled(snippet: &str) -> String {
    let mut text = String::new();
    let mut letters = snippet.chars().peekable();
    let mut inside = false;
    while let Some(letter) = letters.next() {
        match letter {
            '\\' => text.extend(letters.next()),
            '$' => {
                let braces = letters.next_if_eq(&'{').is_some();
                while letters.next_if(char::is_ascii_digit).is_some() {}
                inside = braces && letters.next_if_eq(&':').is_some();
                if braces && !inside {
                    letters.next_if_eq(&'}');
                }
            }
            '}' if inside => inside = false,
            letter => text.push(letter),
        }
    }
    text
}

fn statements(all: &[(&str, &str, &str)]) -> Vec<Offer> {
    let offers = all.iter().enumerate().map(|(place, (word, detail, snippet))| {
        Offer::new(word, Kind::Keyword).detail(*detail).snippet(*snippet).rank(place as u8)
    });
    offers.collect()
}

/// What begins an item.
pub(super) fn items(analysis: &Analysis, place: Span) -> Vec<Offer> {
    let mut offers = statements(&[
        ("use", "names of the library or of another file", "use ${1:std.curves} ($0)"),
        (
            "param",
            "a number that can be set from outside",
            "param ${1:span}: ${2:Length} = ${3:6m} in ${4:4m} .. ${5:9m}",
        ),
        ("let", "a named value", "let ${1:name} = $0"),
        ("fn", "a function", "fn ${1:name}(${2:i: Int}) -> ${3:Length} = $0"),
        (
            "ifs",
            "an iterated function system on control points",
            "ifs ${1:name} on (${2:a, b}) {\n    transform ${3:left} = self on ($4)\n    germ segment(${5:a, b})\n}",
        ),
        (
            "ifs in plane",
            "an iterated function system of maps of the plane",
            "ifs ${1:name} in plane {\n    transform ${2:first} = ${3:scale(1/2)} * self\n    germ ${4:segment((0m, 0m), (1m, 0m))}\n}",
        ),
        ("figure", "an ifs at a level", "figure ${1:name} = $2 at level ${3:3}"),
        ("record", "a type with fields", "record ${1:Name} {\n    ${2:field}: ${3:Length}\n}"),
        ("test", "what is stated of the design", "test \"${1:what it shows}\" {\n    assert $0\n}"),
        ("pub", "for other files too", "pub "),
    ]);
    // After `figure`, before what is rarer.
    let blocks =
        [SchemaKind::Panels, SchemaKind::Planks].map(|kind| needed::block(analysis, place, kind).rank(6));
    offers.extend(blocks);
    offers
}

/// What begins a member of an ifs that lives there: a map moves one in the plane or in space, and only one on control
/// points stands on the boundary of another.
pub(super) fn members(space: Option<PointSpace>) -> Vec<Offer> {
    let by_map = matches!(space, Some(PointSpace::Plane | PointSpace::Space));
    let transform = if by_map {
        "transform ${1:name} = ${2:scale(1/2)} * self"
    } else {
        "transform ${1:name} = ${2:self on ($3)}"
    };
    let mut members = statements(&[
        ("transform", "a smaller copy", transform),
        ("let", "a named point or value", "let ${1:name} = $0"),
        ("germ", "what is drawn at the last level", "germ $0"),
        ("keep", "what is drawn at every level", "keep $0"),
        ("boundary", "an ifs on the end or side of this one", "boundary ${1:start} = $2 on ($3)"),
        ("join", "two boundaries that are the same", "join ${1:left.end} = ${2:right.start}"),
        ("transform […]", "a family of smaller copies", "transform ${1:branch}[${2:i} in ${3:0..3}] = $0"),
    ]);
    members.retain(|member| !by_map || member.label != "boundary");
    members
}

/// What begins a line of a test.
pub(super) fn steps() -> Vec<Offer> {
    statements(&[
        ("assert", "what must be true", "assert $0"),
        ("let", "a named value", "let ${1:name} = $0"),
    ])
}
