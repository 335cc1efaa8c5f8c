//! What is known of an ifs: where its transforms go, their matrices, how much they contract, whether its pieces join. In words, as Markdown. It is
//! that of the figures where they use it, else that of the ifs by itself.

use std::borrow::Cow;

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::dimension::Dimension;
use ifs_compiler::hir::evaluate::{Evaluator, quantity_words_to};
use ifs_compiler::hir::tree::ItemId;
use ifs_compiler::ifs::{Automaton, Contraction, Matrix, StateId, StateSpace, contraction, step_factor};
use ifs_compiler::plan::lower::{FigureKind, alone, figure_kind};

use super::facts::WorkedOut;

/// The most numbers of a matrix that is shown.
const MOST_ENTRIES: usize = 64;

/// The most sets of arguments of an ifs that are told.
const MOST_STATES: usize = 4;

/// The most members of a family of transforms that are told.
const MOST_MEMBERS: usize = 3;

/// An automaton and the states of an ifs in it, one for each set of arguments.
struct States<'a> {
    automaton: Cow<'a, Automaton>,
    of_ifs: Vec<StateId>,
}

impl<'a> States<'a> {
    /// Those that figures lead to.
    fn of_figures(made: &'a Analysis, name: &str) -> Option<States<'a>> {
        let automaton = made.plan.as_ref()?.plan.automaton();
        let states = automaton.states().iter().zip(0..);
        let own = states.filter(|(state, _)| state.name.split('(').next() == Some(name));
        let of_ifs: Vec<StateId> = own.map(|(_, place)| StateId(place)).collect();
        (!of_ifs.is_empty()).then_some(States { automaton: Cow::Borrowed(automaton), of_ifs })
    }

    /// That of the ifs by itself, with the defaults of its parameters.
    fn of_defaults(analysis: &Analysis, known: WorkedOut<'_>, id: ItemId) -> Option<States<'a>> {
        let (automaton, state) = alone(&analysis.hir, id, known.overrides)?;
        Some(States { automaton: Cow::Owned(automaton), of_ifs: vec![state] })
    }

    /// Those of the text as it is now.
    fn now(analysis: &Analysis, known: WorkedOut<'a>, id: ItemId) -> Option<States<'a>> {
        let made = known.made.filter(|_| known.current);
        let of_figures = made.and_then(|made| States::of_figures(made, &analysis.hir.item(id).name));
        of_figures.or_else(|| States::of_defaults(analysis, known, id))
    }

    /// Those of the text as it was.
    fn before(analysis: &Analysis, known: WorkedOut<'a>, id: ItemId) -> Option<States<'a>> {
        States::of_figures(known.made?, &analysis.hir.item(id).name)
    }
}

/// How much an ifs contracts and what it is where it is placed, for each set of arguments.
pub(super) fn of_ifs(analysis: &Analysis, known: WorkedOut<'_>, id: ItemId) -> Option<String> {
    let words = |States { automaton, of_ifs }: States<'_>| {
        let told = of_ifs.iter().take(MOST_STATES);
        let lines = told.map(|id| {
            let (name, contracts) = (&automaton.state(*id).name, contracts(&automaton, *id));
            format!("`{name}`: {contracts}; {}", kind(&automaton, *id))
        });
        lines.collect::<Vec<_>>().join("\n\n")
    };
    let now = States::now(analysis, known, id).map(words);
    now.or_else(|| States::before(analysis, known, id).map(|states| known.dated(words(states))))
}

fn contracts(automaton: &Automaton, id: StateId) -> String {
    let number = |value: f64| quantity_words_to(value, Dimension::NUMBER, 4);
    match contraction(automaton, id) {
        Contraction::Proved { length: 1, bound, .. } => {
            format!("contracts, by {} at most in each step", number(bound))
        }
        Contraction::Proved { length, bound, .. } => {
            format!("contracts, by {} at most in {length} steps", number(bound))
        }
        Contraction::Refuted { word } => format!("does not contract along `{}`", word.display(automaton)),
        Contraction::Open { length, bound } => {
            format!("contraction not proved: {length} steps come to {}", number(bound))
        }
    }
}

/// What an ifs is where it is placed, and which joint is open where it is of separate pieces.
pub(super) fn kind(automaton: &Automaton, id: StateId) -> String {
    match figure_kind(automaton, id) {
        FigureKind::Curve { rounded: false } => "a `Curve`: its pieces meet".to_owned(),
        FigureKind::Curve { rounded: true } => "a `Curve`: its pieces meet but for rounding".to_owned(),
        FigureKind::Surface => "a `Surface`: its pieces share their edges".to_owned(),
        FigureKind::Figure { why } => format!("a `Figure` of separate pieces: {why}"),
    }
}

/// Where a transform of an ifs goes and its matrix.
pub(super) fn of_transform(
    analysis: &Analysis,
    known: WorkedOut<'_>,
    ifs: ItemId,
    name: &str,
) -> Option<String> {
    let now = States::now(analysis, known, ifs).and_then(|states| in_state(&states, name));
    now.or_else(|| for_all_parameters(analysis, known, ifs, name)).or_else(|| {
        let before = in_state(&States::before(analysis, known, ifs)?, name)?;
        Some(known.dated(before))
    })
}

/// Whether a transform is the named one or a member of the named family.
fn is_of(transform: &str, name: &str) -> bool {
    transform == name || transform.strip_prefix(name).is_some_and(|rest| rest.starts_with(['.', '[']))
}

/// A transform with the first set of arguments of its ifs.
fn in_state(states: &States<'_>, name: &str) -> Option<String> {
    let (automaton, id) = (&states.automaton, *states.of_ifs.first()?);
    let transforms = automaton.state(id).transforms.iter().filter(|transform| is_of(&transform.name, name));
    let parts = transforms.take(MOST_MEMBERS).map(|transform| {
        let target = &automaton.state(transform.target).name;
        let is_map = automaton.state(id).space != StateSpace::Control
            && automaton.state(transform.target).space != StateSpace::Control;
        let (what, matrix) = match is_map {
            true => ("lengths", map(&transform.matrix)),
            false => ("differences", weights(&transform.matrix)),
        };
        let factor = quantity_words_to(step_factor(automaton, id, transform), Dimension::NUMBER, 4);
        format!(
            "`{}` continues in `{target}`; in one step {what} are at most {factor} as large{matrix}",
            transform.name
        )
    });
    let parts: Vec<String> = parts.collect();
    let state = &automaton.state(id).name;
    (!parts.is_empty()).then(|| format!("{}\n\n`{state}` {}", parts.join("\n\n"), contracts(automaton, id)))
}

/// A transform whose matrix is told in the parameters of its ifs.
fn for_all_parameters(analysis: &Analysis, known: WorkedOut<'_>, ifs: ItemId, name: &str) -> Option<String> {
    let all = Evaluator::new(&analysis.hir, known.overrides).symbolic_transforms(ifs)?;
    let own = all.iter().filter(|transform| is_of(&transform.name, name));
    let parts = own.take(MOST_MEMBERS).map(|transform| {
        let columns = transform.rows.first().map_or(0, Vec::len);
        let matrix = matrix(&transform.rows.concat(), columns);
        format!("`{}` continues in `{}`{matrix}", transform.name, transform.target)
    });
    let parts: Vec<String> = parts.collect();
    (!parts.is_empty()).then(|| parts.join("\n\n"))
}

/// The barycentric weights of the images of control points, exact where that is short.
fn weights(rows: &Matrix) -> String {
    let entries = rows.entries().iter().map(|entry| {
        let exact = entry.to_string();
        if exact.len() <= 8 { exact } else { quantity_words_to(entry.to_f64(), Dimension::NUMBER, 6) }
    });
    matrix(&entries.collect::<Vec<_>>(), rows.columns())
}

/// A map of the plane or of space: its linear part, and behind it how far it moves the origin. Its weights are those of the
/// images of a frame, the origin and a point at 1 mm along each axis.
fn map(rows: &Matrix) -> String {
    let size = rows.columns() - 1;
    let origin: Vec<f64> = (1..=size).map(|axis| rows.row(0)[axis].to_f64()).collect();
    let linear = |axis: usize, point: usize| rows.row(point)[axis].to_f64() - origin[axis - 1];
    let entries = (1..=size).flat_map(|axis| (1..=size).map(move |point| (axis, point)));
    let entries = entries
        .map(|(axis, point)| quantity_words_to(linear(axis, point), Dimension::NUMBER, 6))
        .collect::<Vec<_>>();
    let moved = origin.iter().map(|moved| quantity_words_to(*moved, Dimension::LENGTH, 6));
    let lines = lines(&entries, size).into_iter().zip(moved);
    fenced(lines.map(|(line, moved)| format!("{line}  + {moved}")).collect())
}

/// A matrix as a block of text; nothing where it is large.
fn matrix(entries: &[String], columns: usize) -> String {
    if entries.len() > MOST_ENTRIES { String::new() } else { fenced(lines(entries, columns)) }
}

/// The rows of a matrix, in columns of one width.
fn lines(entries: &[String], columns: usize) -> Vec<String> {
    let width = entries.iter().map(|text| text.chars().count()).max().unwrap_or(0);
    entries
        .chunks(columns.max(1))
        .map(|row| row.iter().map(|text| format!("{text:>width$}")).collect::<Vec<_>>().join("  "))
        .collect()
}

/// Lines as a block below a line of text.
fn fenced(lines: Vec<String>) -> String {
    format!("\n```text\n{}\n```", lines.join("\n"))
}

#[cfg(test)]
mod tests {
    use crate::features::fixture::fixture;
    use crate::features::hover::hover;

    /// A segment divided by some number, and what stands behind it.
    fn halves(parameters: &str, weight: &str, behind: &str) -> String {
        format!(
            "ifs hal$2ves{parameters} on (a, b) {{\n    let m = lerp(a, b, {weight})\n    transform le$1ft = self on (a, m)\n    transform right = self on (m, b)\n    germ segment(a, b)\n}}\n{behind}"
        )
    }

    /// What is told at a mark of a text, worked out or not.
    fn shown(text: &str, mark: &str, worked_out: bool) -> String {
        let other = if mark == "$1" { "$2" } else { "$1" };
        let design = fixture(&text.replace(other, "").replace(mark, "$0"));
        let made = worked_out.then(|| design.made());
        let known = design.known(made.as_ref());
        hover(&design.analysis, known, design.analysis.root, design.at)
            .map_or(String::new(), |found| found.markdown)
    }

    fn contains(text: &str, parts: &[&str]) {
        for part in parts {
            assert!(text.contains(part), "no {part:?} in\n{text}");
        }
    }

    const FIGURE: &str = "figure line = halves on ((0m, 0m), (4m, 2m)) at level 3\n";

    #[test]
    fn an_ifs_of_a_figure() {
        let text = halves("", "1/4", FIGURE);
        let parts = [
            "transform of `halves`",
            "continues in `halves`; in one step differences are at most 0.25 as large",
            "  1    0\n3/4  1/4",
            "contracts, by 0.75 at most in each step",
        ];
        contains(&shown(&text, "$1", true), &parts);
        let said = "`halves`: contracts, by 0.75 at most in each step; a `Curve`: its pieces meet";
        contains(&shown(&text, "$2", true), &[said]);
    }

    #[test]
    fn an_ifs_that_no_figure_uses_by_its_defaults() {
        let text = halves("(t: Number = 1/4)", "t", "");
        let parts = ["continues in `halves(t: 1/4)`", "  1    0\n3/4  1/4"];
        contains(&shown(&text, "$1", true), &parts);
        contains(&shown(&text, "$2", true), &["`halves(t: 1/4)`: contracts, by 0.75"]);
    }

    #[test]
    fn an_ifs_beside_mistakes() {
        let text = halves("", "1/4", "figure line = halves on (0m, at level\nlet wrong = 1m + 2kg\n");
        contains(&shown(&text, "$1", false), &["  1    0\n3/4  1/4", "contracts, by 0.75"]);
    }

    #[test]
    fn a_transform_is_told_as_it_is_written() {
        let text = "ifs one on (a, b) { transform le$1ft =\n    self on (a, lerp(a, b, 1/2)) transform right = self on (lerp(a, b, 1/2), b) germ segment(a, b) }\n";
        let said = shown(text, "$1", false);
        contains(&said, &["```ifs\ntransform left =\n    self on (a, lerp(a, b, 1/2))\n```"]);
    }

    #[test]
    fn a_map_of_the_plane() {
        let text = "ifs grow in plane {\n    transform b$1ranch = translate(0m, 1.6m) * rotate(90deg) * scale(0.5) * self\n    germ segment((0m, 0m), (0m, 1m))\n}\n";
        let said = shown(text, "$1", false);
        let parts = [
            "in one step lengths are at most 0.5 as large",
            "   0  -0.5  + 0mm\n 0.5     0  + 1600mm",
            "contracts, by 0.5 at most",
        ];
        contains(&said, &parts);
    }

    #[test]
    fn an_ifs_with_parameters_that_nothing_gives() {
        let text = halves("(t: Number)", "t", "");
        contains(&shown(&text, "$1", true), &["`left` continues in `halves`", "    1      0\n1 - t      t"]);
    }
}
