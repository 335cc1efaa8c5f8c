//! Every program of `LANGUAGE.md` parses as written (its ellipses filled in).

use crate::source::SourceMap;
use crate::syntax::parse;

fn show(text: &str) -> String {
    let mut map = SourceMap::default();
    let id = map.add("a.ifs", text);
    let parse = parse(map.get(id).unwrap());
    parse
        .diagnostics
        .iter()
        .map(|d| format!("{} {} {:?}\n", d.code.name(), d.message, &text[d.span.range()]))
        .collect()
}

pub(super) const PROGRAMS: &[(&str, &str)] = &[
    ("bezier", include_str!("language/bezier.ifs")),
    ("classical", include_str!("language/classical.ifs")),
    ("surfaces", include_str!("language/surfaces.ifs")),
    ("panels", include_str!("language/panels.ifs")),
    ("planks", include_str!("language/planks.ifs")),
    ("records", include_str!("language/records.ifs")),
    ("boundaries", include_str!("language/boundaries.ifs")),
];

#[test]
fn all_programs_parse() {
    for (name, text) in PROGRAMS {
        assert_eq!(show(text), "", "{name}");
    }
}
