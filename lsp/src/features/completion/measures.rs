//! What a block can require, what a level can be found by, and the limits of both.

use ifs_compiler::hir::schema::{Measure, SchemaKind};
use ifs_compiler::hir::size::SizeMeasure;

use super::snippets::escaped;
use super::{Kind, Offer};

/// What such a block can require.
pub(super) fn measures(kind: Option<SchemaKind>) -> Vec<Offer> {
    let fitting = fitting(kind).enumerate();
    fitting.map(|(place, measure)| whole(measure, measure.words(), place)).collect()
}

fn fitting(kind: Option<SchemaKind>) -> impl Iterator<Item = Measure> {
    Measure::ALL.into_iter().filter(move |measure| kind.is_none_or(|kind| measure.applies_to(kind)))
}

/// A measure of which `words` are not written yet, with a limit to begin with.
fn whole(measure: Measure, words: &str, place: usize) -> Offer {
    let example = measure.example();
    Offer::new(words, Kind::Measure)
        .detail(measure.dimension().name())
        .docs(format!("```ifs\nrequire {} {example}\n```", measure.words()))
        .snippet(format!("{words} ${{1:{}}}", escaped(example)))
        .rank(place as u8)
}

/// What goes on after these words: the rest of a measure, or the limit of a whole one, the usual kind first.
pub(super) fn limits(kind: Option<SchemaKind>, words: &str) -> Vec<Offer> {
    let mut offers = Vec::new();
    for measure in fitting(kind) {
        let Some(rest) = measure.words().strip_prefix(words) else { continue };
        match rest.strip_prefix(' ') {
            Some(rest) => offers.push(whole(measure, rest, offers.len())),
            None if rest.is_empty() => offers.extend(limits_of(measure)),
            None => {}
        }
    }
    offers
}

/// The limits that a measure can have, with the values of its example.
fn limits_of(measure: Measure) -> Vec<Offer> {
    let example = measure.example();
    let value = example.split_once(' ').map_or("", |(_, value)| value);
    let (least, most) = value.split_once(" .. ").unwrap_or((value, value));
    let limits = [
        ("<=", format!("<= ${{1:{}}}", escaped(most)), "no more than"),
        (">=", format!(">= ${{1:{}}}", escaped(least)), "no less than"),
        (
            "in",
            format!("in ${{1:{}}} .. ${{2:{}}}", escaped(least), escaped(most)),
            "both ends of what is required",
        ),
    ];
    let limits = limits.into_iter().enumerate().map(|(place, (word, snippet, detail))| {
        let usual = example.starts_with(word);
        let offer = Offer::new(word, Kind::Keyword).snippet(snippet).detail(detail);
        offer.rank(if usual { 0 } else { 1 + place as u8 })
    });
    limits.collect()
}

/// What a level can be found by.
pub(super) fn sizes() -> Vec<Offer> {
    let sizes = SizeMeasure::ALL.into_iter();
    sizes
        .map(|size| {
            let offer = Offer::new(size.word(), Kind::Measure).docs(size.doc());
            offer.snippet(format!("{} <= ${{1:20mm}}", size.word()))
        })
        .collect()
}

/// What goes on after such a size.
pub(super) fn size_limits() -> Vec<Offer> {
    vec![Offer::new("<=", Kind::Keyword).snippet("<= ${1:20mm}").detail("no more than")]
}
