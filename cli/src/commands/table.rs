//! The short table at the end of a build: elements, sizes, planarity before and after, files, where.

use std::fmt::Write as _;
use std::path::Path;

use ifs_compiler::analysis::{Analysis, Elements, Fabrication, PanelsMade, PlanksMade, value_words};
use ifs_compiler::geometry::{MeshSummary, QuadMeasure, QuadMesh};

/// The table, with a final line end.
pub(super) fn table(analysis: &Analysis, files: usize, out: &Path) -> String {
    let mut text = String::new();
    if let Some(lowered) = &analysis.plan {
        let counted = lowered.plan.figures().iter().zip(&lowered.counts).zip(&lowered.extents);
        for ((figure, count), extent) in counted {
            let made = analysis.fabrications.iter().any(|made| made.figure == figure.name);
            if !made {
                let planar = if figure.shape.planar_by_construction() { PLANAR } else { "" };
                row(&mut text, &figure.to_string(), &format!("{} elements{planar}", count.elements));
            }
            if let Some(sizes) = extent.and_then(|extent| extent.sizes) {
                row(&mut text, "  sizes", &range([sizes.least, sizes.most].into_iter(), "mm"));
            }
        }
    }
    for made in &analysis.fabrications {
        fabrication(&mut text, made);
    }
    row(&mut text, "files", &format!("{files} in {}", out.display()));
    text
}

/// What is said of surfaces whose quads are planar whatever their control points are.
const PLANAR: &str = ", planar by construction";

fn row(text: &mut String, name: &str, value: &str) {
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{name:<14}  {value}");
}

fn fabrication(text: &mut String, made: &Fabrication) {
    match &made.elements {
        Elements::Panels(panels) => panel_rows(text, &made.figure, panels),
        Elements::Planks(planks) => plank_rows(text, &made.figure, planks),
    }
    if made.scale != 1.0 {
        row(text, "  scale", &format!("{}, sizes are those of the model", scale_words(made.scale)));
    }
    for requirement in &made.requirements {
        let (measure, result) = (requirement.measure, &requirement.result);
        let limit = requirement.limit.words(measure);
        let found = result.extremes.map_or_else(String::new, |(least, most)| {
            let (least, most) = (value_words(measure, least), value_words(measure, most));
            if least == most { format!(", {least}") } else { format!(", {least} .. {most}") }
        });
        row(text, "  require", &format!("{} {limit}: holds for {}{found}", measure.words(), result.total));
    }
}

/// The scale of a model: `1:20`, or the factor where it is no whole one.
fn scale_words(scale: f64) -> String {
    let whole = (1.0 / scale).round();
    if (whole * scale - 1.0).abs() <= 1e-9 { format!("1:{whole}") } else { scale.to_string() }
}

fn panel_rows(text: &mut String, figure: &str, panels: &PanelsMade) {
    let thickness = panels.settings.material.thickness.unwrap_or(0.0);
    let material = &panels.settings.material.name;
    row(text, figure, &format!("{} boards of {material}, {thickness} mm", panels.panels.len()));
    let edges = panels.panels.iter().flat_map(|panel| panel.edges);
    row(text, "  edges", &range(edges, "mm"));
    let summary = |mesh: fn(&ifs_compiler::analysis::PanelFigure) -> &QuadMesh| {
        MeshSummary::of_measures(panels.figures.iter().flat_map(|figure| {
            let mesh = mesh(figure);
            (0..mesh.quads.len()).map(|quad| QuadMeasure::of(mesh.corners_of(quad)))
        }))
    };
    let (before, after) = (summary(|figure| &figure.designed), summary(|figure| &figure.built));
    let words = |summary: &MeshSummary| match (&summary.worst, summary.mean) {
        (Some(worst), Some(mean)) => format!("worst {:.6}, mean {mean:.6}", worst.value),
        _ => "not measured".to_owned(),
    };
    let planar = panels.figures.iter().all(|figure| figure.planar);
    let planar = if planar { PLANAR } else { "" };
    row(text, "  planarity", &format!("as designed: {}{planar}", words(&before)));
    if panels.perturbation.is_some() {
        let moved = panels.panels.iter().map(|panel| panel.moved).fold(0.0, f64::max);
        row(text, "", &format!("planarized:  {} (moved up to {moved:.1} mm)", words(&after)));
    }
}

fn plank_rows(text: &mut String, figure: &str, planks: &PlanksMade) {
    let settings = &planks.settings;
    let section = format!("{} mm by {} mm", settings.depth, settings.width);
    row(text, figure, &format!("{} planks of {}, {section}", planks.planks.len(), settings.material.name));
    row(text, "  lengths", &range(planks.planks.iter().map(|plank| plank.length), "mm"));
    let mitres = planks.planks.iter().flat_map(|plank| plank.mitres).map(|mitre| mitre.abs().to_degrees());
    row(text, "  mitres", &range(mitres, "deg"));
}

fn range(values: impl Iterator<Item = f64>, unit: &str) -> String {
    let (least, most) = values
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (least.min(value), most.max(value)));
    if least > most { "none".to_owned() } else { format!("{least:.1} to {most:.1} {unit}") }
}
