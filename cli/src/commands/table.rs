//! The short table at the end of a build: elements, sizes, planarity before and after, files, where.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use ifs_compiler::analysis::{Analysis, Elements, Fabrication, PanelsMade, PlanksMade, value_words};
use ifs_compiler::geometry::{MeshSummary, QuadMeasure, QuadMesh};
use ifs_compiler::outputs::nests::Nests;
use ifs_compiler::planarize::Method;

/// The table, with a final line end.
pub(super) fn table(analysis: &Analysis, nests: &Nests, files: &[&str], out: &Path) -> String {
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
    nest_rows(&mut text, nests);
    // The manifest is one more.
    row(&mut text, "files", &format!("{} in {}", files.len() + 1, out.display()));
    for line in file_lines(files) {
        row(&mut text, "", &line);
    }
    text
}

/// The files by their names, those of folders and numbered ones counted: `96 boards/*.nc, 96 boards/*.dxf`, and on a line
/// of their own `cutlist.csv, 4 labels*.svg, model.glb`.
fn file_lines(files: &[&str]) -> Vec<String> {
    let mut groups: BTreeMap<(bool, String), usize> = BTreeMap::new();
    for file in files.iter().chain(&["manifest.json"]) {
        let (stem, ending) = file.rsplit_once('.').unwrap_or((file, ""));
        let key = match file.rsplit_once('/') {
            Some((folder, _)) => (false, format!("{folder}/*.{ending}")),
            None => {
                let number = |digits: &str| !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
                let numbered = stem.rsplit_once('-').filter(|(_, digits)| number(digits));
                let name = numbered.map_or(stem, |(name, _)| name);
                (true, format!("{name}.{ending}"))
            }
        };
        *groups.entry(key).or_default() += 1;
    }
    let line = |single: bool| {
        let group = groups.iter().filter(|((kind, _), _)| *kind == single);
        let words = group.map(|((_, name), count)| match (single, count) {
            (true, 1) => name.clone(),
            (true, count) => format!("{count} {}", name.replacen('.', "*.", 1)),
            (false, count) => format!("{count} {name}"),
        });
        words.collect::<Vec<_>>().join(", ")
    };
    [line(false), line(true)].into_iter().filter(|line| !line.is_empty()).collect()
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
    if let Some(method) = &panels.planarizing {
        let moved = panels.panels.iter().map(|panel| panel.moved).fold(0.0, f64::max);
        row(text, "", &format!("planarized:  {} (moved up to {moved:.1} mm)", words(&after)));
        row(text, "", &run_words(method, panels));
    }
}

/// How planarizing went, all surfaces of a block together.
fn run_words(method: &Method, panels: &PanelsMade) -> String {
    let name = match method {
        Method::Perturbation(_) => "perturbation",
        Method::Projection(_) => "projection",
    };
    let outcomes = || panels.figures.iter().filter_map(|figure| figure.outcome.as_ref());
    let steps: u32 = outcomes().map(|outcome| outcome.iterations).sum();
    let inverted: usize = outcomes().map(|outcome| outcome.inverted).sum();
    let moves = || {
        let pairs = panels.figures.iter().map(|figure| (&figure.designed.vertices, &figure.built.vertices));
        pairs.flat_map(|(from, to)| from.iter().zip(to)).map(|(from, to)| from.distance(*to))
    };
    let mean = moves().sum::<f64>() / moves().count().max(1) as f64;
    let plural = if steps == 1 { "" } else { "s" };
    format!("by {name}: {steps} step{plural}, moved {mean:.1} mm on average, {inverted} quads inverted")
}

fn plank_rows(text: &mut String, figure: &str, planks: &PlanksMade) {
    let settings = &planks.settings;
    let section = format!("{} mm by {} mm", settings.depth, settings.width);
    row(text, figure, &format!("{} planks of {}, {section}", planks.planks.len(), settings.material.name));
    row(text, "  lengths", &range(planks.planks.iter().map(|plank| plank.length), "mm"));
    let mitres = planks.planks.iter().flat_map(|plank| plank.mitres).map(|mitre| mitre.abs().to_degrees());
    row(text, "  mitres", &range(mitres, "deg"));
}

/// Sheets and bars: how many, what they yield, and below which number nobody gets.
fn nest_rows(text: &mut String, nests: &Nests) {
    let share =
        |share: Option<f64>| share.map_or(String::new(), |share| format!(", yield {:.1} %", 100.0 * share));
    for nest in &nests.sheets {
        let (count, sheet) = (nest.nested.sheets, &nest.sheet);
        let size = format!("{} mm by {} mm", sheet.length, sheet.width);
        let yielded = share(nest.whole_yield());
        row(
            text,
            "sheets",
            &format!("{count} of {}, {size}{yielded}, at least {}", nest.material, nest.least),
        );
        unplaced(text, nest.nested.unplaced.len());
    }
    for nest in &nests.bars {
        let (count, length) = (nest.sawn.bars.len(), nest.stock.length);
        let yielded = share(nest.whole_yield());
        row(
            text,
            "bars",
            &format!("{count} of {}, {length} mm{yielded}, at least {}", nest.material, nest.least),
        );
        unplaced(text, nest.sawn.too_long.len());
    }
}

fn unplaced(text: &mut String, count: usize) {
    if count > 0 {
        row(text, "  unplaced", &format!("{count}, too large: see the list"));
    }
}

fn range(values: impl Iterator<Item = f64>, unit: &str) -> String {
    let (least, most) = values
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (least.min(value), most.max(value)));
    if least > most { "none".to_owned() } else { format!("{least:.1} to {most:.1} {unit}") }
}
