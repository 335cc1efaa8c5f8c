//! Levels found by size, with a diagnostic at the line of those that cannot be.

use super::{FigureSource, Lowering};
use crate::diagnostic::{Code, Diagnostic, Fix};
use crate::hir::dimension::Dimension;
use crate::hir::evaluate::quantity_words;
use crate::hir::size::{SizeBound, Until};
use crate::ifs::{Automaton, Count, GermShape, StateId, Word, count, size_bound};
use crate::plan::budget::MAX_LEVEL;
use crate::plan::evaluate::{EachError, PiecesEvaluator};
use crate::plan::figure::{Depth, Each, FigurePlan, Shape};
use crate::plan::until::{Sized, UntilError, set_level, smallest_level};
use crate::source::Span;

/// Letters of a branch that are said.
const LETTERS_SAID: usize = 6;

/// How many zeros a length is written with before it is written with a power of ten.
const MOST_ZEROS: usize = 9;

impl Lowering<'_, '_> {
    /// Gives every figure that says `until` its level; whether all could be found.
    pub(super) fn find_levels(
        &mut self,
        automaton: &Automaton,
        figures: &mut [(FigurePlan, FigureSource)],
    ) -> bool {
        let mut good = true;
        for (figure, source) in figures {
            let Some(until) = source.until else { continue };
            if let Err(diagnostic) = self.find_level(automaton, figure, source, &until) {
                // Figures of one list say the same mistake.
                if !self.diagnostics.contains(&diagnostic) {
                    self.diagnostics.push(*diagnostic);
                }
                good = false;
            }
        }
        good
    }

    fn find_level(
        &self,
        automaton: &Automaton,
        figure: &mut FigurePlan,
        source: &FigureSource,
        until: &Until,
    ) -> Result<(), Box<Diagnostic>> {
        let Until { each, bound, least } = *until;
        if each {
            let depth = self.each(automaton, figure, source, bound)?;
            if let Shape::Pieces(pieces) = &mut figure.shape {
                pieces.depth = depth;
            }
            return Ok(());
        }
        let found = smallest_level(automaton, figure, bound, least, self.evaluator.limits().elements);
        let found = found.map_err(|error| {
            let diagnostic = self.no_level(automaton, source, until, &error);
            let promised = match error {
                UntilError::NotReached { .. } => promised_level(automaton, figure, bound),
                _ => None,
            };
            match promised {
                Some(promised) => Box::new(diagnostic.note(promised)),
                None => diagnostic,
            }
        })?;
        let shift = self.level_shift(&figure.name);
        set_level(&mut figure.shape, found.level.saturating_add_signed(shift));
        Ok(())
    }

    fn each(
        &self,
        automaton: &Automaton,
        figure: &FigurePlan,
        source: &FigureSource,
        bound: SizeBound,
    ) -> Result<Depth, Box<Diagnostic>> {
        let Shape::Pieces(pieces) = &figure.shape else {
            let what = if matches!(figure.shape, Shape::Curve { .. }) { "a curve" } else { "a surface" };
            let message = format!(
                "`{}` is {what}: its elements are joined, and `each` would tear them apart",
                figure.name
            );
            let diagnostic =
                Diagnostic::new(Code::E0553, source.level_span, message).label("joined elements");
            let measure = bound.measure.word();
            let hint = format!("leave out `each`: `until {measure} <= …` is one level for all");
            return Err(Box::new(diagnostic.hint(hint)));
        };
        let (drawn, deepest) = PiecesEvaluator::new(automaton, pieces)
            .count_each(bound, self.evaluator.limits().elements)
            .map_err(|error| self.not_each(automaton, source, bound, &error))?;
        Ok(Depth::Each(Each { bound, drawn, deepest }))
    }

    fn not_each(
        &self,
        automaton: &Automaton,
        source: &FigureSource,
        bound: SizeBound,
        error: &EachError,
    ) -> Box<Diagnostic> {
        let measure = bound.measure.word();
        let at = source.level_span;
        Box::new(match error {
            EachError::NoMeasure { state } => {
                return self.no_level(
                    automaton,
                    source,
                    &Until { each: true, bound, least: None },
                    &UntilError::NoMeasure { state: Some(*state) },
                );
            }
            EachError::TooMany { word, size } => {
                let most = self.evaluator.limits().elements;
                let message = format!("this asks for more than {most} elements, which is the limit");
                let (branch, size) = (branch(word, automaton), length(*size));
                Diagnostic::new(Code::E0705, at, message)
                    .label("too small a size")
                    .note(format!("the branch {branch} is next; its {measure} is {size}"))
                    .hint("ask for a larger size")
            }
            EachError::TooDeep { word, size, halfway } => {
                let message = format!(
                    "the branch {} does not get small enough: its {measure} is {} after {MAX_LEVEL} letters",
                    branch(word, automaton),
                    length(*size)
                );
                let diagnostic = Diagnostic::new(Code::E0706, at, message)
                    .label(format!("not reached, nor after {} letters", word.letters.len() / 2))
                    .note(format!("after {} letters it was {}", word.letters.len() / 2, length(*halfway)));
                let letter = word.names(automaton).last().copied().unwrap_or_default();
                diagnostic.hint(format!("let `{letter}` make its copies smaller"))
            }
        })
    }

    fn no_level(
        &self,
        automaton: &Automaton,
        source: &FigureSource,
        until: &Until,
        error: &UntilError,
    ) -> Box<Diagnostic> {
        let (at, measure) = (source.level_span, until.bound.measure.word());
        Box::new(match error {
            UntilError::NoMeasure { state } => {
                let what = match state {
                    Some(state) => format!("what `{}` draws", automaton.state(*state).name),
                    None => "a quad".to_owned(),
                };
                let message = format!("{what} has no `{measure}`");
                let mut diagnostic = Diagnostic::new(Code::E0554, at, message).label("cannot be measured");
                if let Some(germ) = state.and_then(|state| self.germ_span(state)) {
                    diagnostic = diagnostic.also(germ, "what is drawn");
                }
                let word = Span::new(at.file, at.start, at.start + measure.len() as u32);
                let edge = (measure == "length" && state.is_none_or(|state| has_edges(automaton, state)))
                    .then(|| Fix::replacing(word, "edge"));
                let hint = "points have no size, and only segments and struts a `length`: use `edge` or `size`, or give the level as a number";
                diagnostic.ways(hint, edge.into_iter().collect())
            }
            UntilError::NotReached { last } => {
                let most = self.evaluator.limits().elements;
                let message = format!(
                    "no level within the limit of {most} elements has every {measure} {}",
                    limit(until)
                );
                let diagnostic = Diagnostic::new(Code::E0705, at, message).label("not reached");
                let diagnostic = match last {
                    Some(last) => diagnostic.note(gives(measure, last)),
                    None => diagnostic.note("level 0 has more elements already"),
                };
                diagnostic.hint("ask for a larger size, or let the transforms make smaller copies")
            }
            UntilError::TooSmall { before, found } => {
                let message = format!("no level has every {measure} {}", limit(until));
                let diagnostic =
                    Diagnostic::new(Code::E0552, at, message).label("both ends cannot be met at once");
                let diagnostic = match before {
                    Some(before) => diagnostic.note(gives(measure, before)),
                    None => diagnostic,
                };
                let widest = before.map_or(found.sizes.most, |before| before.sizes.most);
                let hint = match before {
                    Some(before) => format!(
                        "a range that level {} meets goes to {}; one that level {} meets starts at {}",
                        before.level,
                        length(widest),
                        found.level,
                        length(found.sizes.least)
                    ),
                    None => format!("a range that level 0 meets starts at {}", length(found.sizes.least)),
                };
                diagnostic.note(gives(measure, found)).ways(hint, ranges(until, at, before.as_ref(), found))
            }
        })
    }
}

fn has_edges(automaton: &Automaton, state: StateId) -> bool {
    automaton.state(state).germ.shape == GermShape::Polygon
}

/// Ranges that a level meets, in place of one that none does: a lower start for the level that is small enough, a higher end
/// for the level before it.
fn ranges(until: &Until, at: Span, before: Option<&Sized>, found: &Sized) -> Vec<Fix> {
    let (measure, most) = (until.bound.measure.word(), until.bound.most);
    let Some(least) = until.least else { return Vec::new() };
    let mut fixes = Vec::new();
    let low = whole(found.sizes.least, f64::floor);
    if low > 0.0 {
        let title = format!("begin at {}, which level {} meets", length(low), found.level);
        fixes.push(Fix::titled(title).with(at, format!("{measure} in {} .. {}", length(low), length(most))));
    }
    if let Some(before) = before.filter(|before| before.sizes.least >= least) {
        let high = whole(before.sizes.most, f64::ceil);
        let title = format!("end at {}, which level {} meets", length(high), before.level);
        fixes
            .push(Fix::titled(title).with(at, format!("{measure} in {} .. {}", length(least), length(high))));
    }
    fixes
}

/// A length rounded to millimetres, a short one to thousandths of them.
fn whole(millimetres: f64, round: fn(f64) -> f64) -> f64 {
    let parts = if millimetres >= 10.0 { 1.0 } else { 1000.0 };
    round(millimetres * parts) / parts
}

/// What the proof of contraction promises, without evaluating anything: from which level on every element is small enough.
fn promised_level(automaton: &Automaton, figure: &FigurePlan, bound: SizeBound) -> Option<String> {
    let (state, points) = match &figure.shape {
        Shape::Curve { state, points, .. } => (*state, points),
        Shape::Pieces(pieces) => (pieces.state, &pieces.points),
        _ => return None,
    };
    let proved = size_bound(automaton, state)?;
    let level = (0..=MAX_LEVEL).find(|level| bound.holds(proved.size(*level, points)))?;
    let count = match count(automaton, state, level, u64::MAX) {
        Count::Exactly(elements) => format!("{elements} elements"),
        Count::Exceeds => "more elements than can be counted".to_owned(),
    };
    Some(format!("its contraction promises it from level {level} on, which has {count}"))
}

/// `level 3 gives edges from 480mm to 910mm`
fn gives(measure: &str, found: &Sized) -> String {
    let (least, most) = (length(found.sizes.least), length(found.sizes.most));
    if least == most {
        return format!("level {} gives {measure} {least}", found.level);
    }
    format!("level {} gives {measure} from {least} to {most}", found.level)
}

/// `<= 600mm`, `in 150mm .. 600mm`
fn limit(until: &Until) -> String {
    let most = length(until.bound.most);
    match (until.least, until.bound.strict) {
        (Some(least), _) => format!("in {} .. {most}", length(least)),
        (None, true) => format!("< {most}"),
        (None, false) => format!("<= {most}"),
    }
}

/// Three decimals; what is smaller, with its first three digits.
fn length(millimetres: f64) -> String {
    if millimetres == 0.0 || millimetres.abs() >= 0.01 {
        return quantity_words(millimetres, Dimension::LENGTH);
    }
    let short = format!("{millimetres:.2e}");
    let power: usize = short.split("e-").nth(1).and_then(|power| power.parse().ok()).unwrap_or(0);
    if power > MOST_ZEROS {
        return format!("{short}mm");
    }
    let decimals = power + 2;
    format!("{}mm", format!("{millimetres:.decimals$}").trim_end_matches('0'))
}

/// The first letters of a branch, `left.left…`, and how many there are.
fn branch(word: &Word, automaton: &Automaton) -> String {
    let names = word.names(automaton);
    match names.len() {
        0 => "with no letters yet".to_owned(),
        few if few <= LETTERS_SAID => format!("`{}`", names.join(".")),
        many => {
            let last = names.last().copied().unwrap_or_default();
            format!("`{}…{last}` of {many} letters", names[..LETTERS_SAID].join("."))
        }
    }
}
