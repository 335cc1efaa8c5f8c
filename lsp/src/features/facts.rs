//! What a worked-out design knows of a name: values of parameters, counts, levels, sizes and planarity of figures,
//! contraction of an ifs, matrices of transforms. In words, as Markdown.

use ifs_compiler::analysis::{Analysis, Elements, value_words};
use ifs_compiler::geometry::MeshSummary;
use ifs_compiler::hir::dimension::Dimension;
use ifs_compiler::hir::evaluate::quantity_words_to;
use ifs_compiler::hir::schema::Measure;
use ifs_compiler::ifs::{Automaton, Contraction, Matrix, StateId, contraction, difference_norm};
use ifs_compiler::outputs::parameter_texts;

/// The most numbers of a matrix that is shown.
const MOST_ENTRIES: usize = 64;

/// What was made of a parameter, a figure or an ifs.
pub(super) fn of_item(made: &Analysis, name: &str) -> Option<String> {
    if let Some((_, value)) = parameter_texts(made).into_iter().find(|(parameter, _)| parameter == name) {
        return Some(format!("value `{value}`"));
    }
    of_figure(made, name).or_else(|| of_ifs(made, name))
}

fn of_figure(made: &Analysis, name: &str) -> Option<String> {
    let lowered = made.plan.as_ref()?;
    let counted = lowered.plan.figures().iter().zip(&lowered.counts);
    let figures: Vec<_> = counted.filter(|(figure, _)| figure.name == name).collect();
    let (first, _) = figures.first()?;
    let elements: u64 = figures.iter().map(|(_, count)| count.elements).sum();
    let vertices: u64 = figures.iter().map(|(_, count)| count.vertices).sum();
    let mut text = match figures.len() {
        1 => format!("{elements} elements, {vertices} vertices at level {}", first.shape.level_words()),
        several => format!("{several} figures, {elements} elements, {vertices} vertices"),
    };
    if figures.iter().all(|(figure, _)| figure.shape.planar_by_construction()) {
        text += ", planar by construction";
    }
    for fabrication in made.fabrications.iter().filter(|fabrication| fabrication.figure == name) {
        match &fabrication.elements {
            Elements::Panels(panels) => {
                text += &format!("\n\n{} boards", panels.panels.len());
                for figure in &panels.figures {
                    text += &surface(&MeshSummary::of(&figure.built));
                }
            }
            Elements::Planks(planks) => text += &format!("\n\n{} planks", planks.planks.len()),
        }
    }
    Some(text)
}

/// Planarity and edges of a surface as it is built.
fn surface(summary: &MeshSummary) -> String {
    let mut text = String::new();
    if let (Some(worst), Some(mean)) = (summary.worst, summary.mean) {
        let words = |value| value_words(Measure::Planarity, value);
        text += &format!(", planarity {} at worst and {} in the mean", words(worst.value), words(mean));
    }
    if let (Some(shortest), Some(longest)) = (summary.shortest_edge, summary.longest_edge) {
        let words = |value| value_words(Measure::Edge, value);
        text += &format!(", edges {} .. {}", words(shortest.value), words(longest.value));
    }
    text
}

/// The states of an ifs: one for each set of arguments that the design has of it.
fn states<'a>(automaton: &'a Automaton, name: &'a str) -> impl Iterator<Item = StateId> + 'a {
    let states = automaton.states().iter().enumerate();
    states
        .filter(move |(_, state)| state.name.split('(').next() == Some(name))
        .map(|(place, _)| StateId(place as u32))
}

fn of_ifs(made: &Analysis, name: &str) -> Option<String> {
    let automaton = made.plan.as_ref()?.plan.automaton();
    let lines: Vec<String> = states(automaton, name)
        .take(4)
        .map(|id| format!("`{}`: {}", automaton.state(id).name, contracts(automaton, id)))
        .collect();
    (!lines.is_empty()).then(|| lines.join("\n\n"))
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

/// Where a transform goes and its matrix, for each set of arguments that the design has of its ifs.
pub(super) fn of_transform(made: &Analysis, ifs: &str, name: &str) -> Option<String> {
    let automaton = made.plan.as_ref()?.plan.automaton();
    let id = states(automaton, ifs).next()?;
    let own = |letter: &str| {
        letter == name || letter.strip_prefix(name).is_some_and(|rest| rest.starts_with(['.', '[']))
    };
    let transforms = automaton.state(id).transforms.iter().filter(|transform| own(&transform.name));
    let parts: Vec<String> = transforms
        .take(3)
        .map(|transform| {
            let target = &automaton.state(transform.target).name;
            let matrix =
                matrix(&transform.matrix).map_or_else(String::new, |text| format!("\n```text\n{text}\n```"));
            let factor = quantity_words_to(difference_norm(transform).to_f64(), Dimension::NUMBER, 4);
            format!(
                "`{}` continues in `{target}`; in one step differences are at most {factor} as large{matrix}",
                transform.name
            )
        })
        .collect();
    if parts.is_empty() {
        return None;
    }
    Some(format!("{}\n\n`{}` {}", parts.join("\n\n"), automaton.state(id).name, contracts(automaton, id)))
}

/// The rows of a matrix, exact where that is short.
fn matrix(matrix: &Matrix) -> Option<String> {
    if matrix.entries().len() > MOST_ENTRIES {
        return None;
    }
    let texts: Vec<String> = matrix
        .entries()
        .iter()
        .map(|entry| {
            let exact = entry.to_string();
            if exact.len() <= 8 { exact } else { quantity_words_to(entry.to_f64(), Dimension::NUMBER, 6) }
        })
        .collect();
    let width = texts.iter().map(String::len).max().unwrap_or(0);
    let rows = texts
        .chunks(matrix.columns().max(1))
        .map(|row| row.iter().map(|text| format!("{text:>width$}")).collect::<Vec<_>>().join("  "));
    Some(rows.collect::<Vec<_>>().join("\n"))
}

#[cfg(test)]
mod tests {
    use crate::features::fixture::fixture;
    use crate::features::hover::hover;

    fn shown(text: &str) -> String {
        let design = fixture(text);
        let made = design.made();
        hover(&design.analysis, Some(&made), design.analysis.root, design.at)
            .map_or(String::new(), |found| found.markdown)
    }

    #[test]
    fn what_was_made_of_a_name() {
        let curve = "ifs halves on (a, b) {\n    let m = lerp(a, b, 1/4)\n    transform le$0ft = self on (a, m)\n    transform right = self on (m, b)\n    germ segment(a, b)\n}\nfigure line = halves on ((0m, 0m), (4m, 2m)) at level 3\n";
        let text = shown(curve);
        for part in [
            "transform of `halves`",
            "continues in `halves`; in one step differences are at most 0.25 as large",
            "  1    0\n3/4  1/4",
            "contracts, by 0.75 at most in each step",
        ] {
            assert!(text.contains(part), "no {part:?} in\n{text}");
        }
        let text = shown(&curve.replace("$0", "").replace("figure line", "figure li$0ne"));
        assert!(text.contains("8 elements, 9 vertices at level 3"), "{text}");
        let text = shown(&curve.replace("$0", "").replace("ifs halves", "ifs hal$0ves"));
        assert!(text.contains("`halves`: contracts, by 0.75"), "{text}");
        let text = shown(
            "param width: Length = 2$0m in 1m .. 3m\n"
                .replace("2$0m", "2m")
                .replace("param w", "param w$0")
                .as_str(),
        );
        assert!(text.contains("value `2000mm`") || text.contains("value `2m`"), "{text}");
    }
}
