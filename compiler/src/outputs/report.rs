//! The report of a design: its parameters, figures and fabrications, measured.

use super::nests::Nests;
use super::programs::{engraving, machines_of};
use super::sheets::{bars_report, sheets_report};
use super::{design_hash, machine_text, names, parameter_texts, project_sources};
use crate::analysis::{Analysis, Elements, Fabrication, LimitValue, PanelsMade, RequirementResult};
use crate::export::number::Fixed;
use crate::export::part::Part;
use crate::export::report::{
    self, Counts, Distribution, ExtentReport, FigureReport, HistoryPoint, MachineReport, MaterialReport,
    MovedReport, OptionReport, Parameter, PlanarityReport, PlanarizeReport, Quantity, ReliefReport, Report,
    Requirement, SourceReport, SurfaceSummary,
};
use crate::fabricate::checks::Limit;
use crate::fabricate::label::Label;
use crate::geometry::{MeshSummary, QuadMeasure, QuadMesh};
use crate::hir::schema::Measure;
use crate::plan::extent::Extent;
use crate::plan::{Depth, Each, Shape};
use crate::planarize::{Method, Outcome, Pin, StopReason};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// The report with the parts of each block; `sheet_files` are the files made for each sheet.
pub(super) fn report(
    analysis: &Analysis,
    parts: Vec<Vec<Part>>,
    nests: &Nests,
    sheet_files: &BTreeMap<String, Vec<String>>,
) -> Report {
    let mut out = Report::new(&analysis.design_name());
    let docs = analysis.files.first().map_or(&[][..], |file| &file.parse.ast.docs);
    let paragraph = docs.iter().map(|line| line.trim()).take_while(|line| !line.is_empty());
    out.summary = paragraph.collect::<Vec<_>>().join(" ");
    out.design_hash = design_hash(analysis);
    let source =
        |(path, bytes): (String, &[u8])| SourceReport { path, sha256: names::hex(&Sha256::digest(bytes)) };
    out.sources = project_sources(analysis).into_iter().map(source).collect();
    out.parameters = parameter_texts(analysis)
        .into_iter()
        .map(|(name, value)| Parameter { set: analysis.set_parameters.contains(&name), name, value })
        .collect();
    out.machine = machine_text(analysis);
    if let Some(lowered) = &analysis.plan {
        let counted = lowered.plan.figures().iter().zip(&lowered.counts).zip(&lowered.extents);
        out.figures = counted
            .map(|((figure, count), extent)| {
                let shape = &figure.shape;
                let level = match shape {
                    Shape::Pieces(pieces) => depth_words(&pieces.depth),
                    _ => shape.level_words(),
                };
                let kind = match shape {
                    Shape::Pieces(_) => "figure",
                    _ if shape.is_curve() => "curve",
                    _ => "surface",
                };
                FigureReport {
                    name: figure.to_string(),
                    kind: kind.to_owned(),
                    level,
                    elements: count.elements,
                    planar_by_construction: shape.planar_by_construction(),
                    extent: extent.as_ref().map(extent_report),
                }
            })
            .collect();
    }
    let made = analysis.fabrications.iter().zip(parts);
    out.fabrications = made.map(|(made, parts)| fabrication(analysis, made, parts)).collect();
    out.sheets = nests.sheets.iter().map(|nest| sheets_report(nest, sheet_files)).collect();
    out.bars = nests.bars.iter().map(bars_report).collect();
    out
}

fn extent_report(extent: &Extent) -> ExtentReport {
    ExtentReport {
        low_mm: extent.low.map(Fixed::mm),
        high_mm: extent.high.map(Fixed::mm),
        smallest_mm: extent.sizes.map(|sizes| Fixed::mm(sizes.least)),
        largest_mm: extent.sizes.map(|sizes| Fixed::mm(sizes.most)),
    }
}

/// `9`, or `each until size <= 20mm`
fn depth_words(depth: &Depth) -> String {
    match depth {
        Depth::Level(level) => level.to_string(),
        Depth::Each(Each { bound, .. }) => {
            let sign = if bound.strict { "<" } else { "<=" };
            format!("each until {} {sign} {}mm", bound.measure.word(), bound.most)
        }
    }
}

fn fabrication(analysis: &Analysis, made: &Fabrication, parts: Vec<Part>) -> report::Fabrication {
    let (kind, counts, masses, planarity) = match &made.elements {
        Elements::Panels(panels) => {
            let (done, refused) = (panels.panels.len(), panels.refused.len());
            let masses: Option<Vec<f64>> = panels.panels.iter().map(|panel| panel.mass).collect();
            ("panels", (done, refused), masses, planarity(panels))
        }
        Elements::Planks(planks) => {
            let (done, refused) = (planks.planks.len(), planks.refused.len());
            let masses: Option<Vec<f64>> = planks.planks.iter().map(|plank| plank.mass).collect();
            ("planks", (done, refused), masses, None)
        }
    };
    report::Fabrication {
        figure: made.figure.clone(),
        kind,
        scale: Fixed::ratio(made.scale),
        material: material_report(made, masses, &parts),
        machine: machine(analysis, made),
        counts: Counts { elements: counts.0 + counts.1, made: counts.0, refused: counts.1 },
        planarity,
        relief: match &made.elements {
            Elements::Panels(panels) => Some(ReliefReport::of(&panels.corners)),
            Elements::Planks(_) => None,
        },
        requirements: made
            .requirements
            .iter()
            .map(|requirement| requirement_report(analysis, requirement))
            .collect(),
        parts,
    }
}

/// What cuts a block; none where it names no machine, or one that cannot work.
fn machine(analysis: &Analysis, made: &Fabrication) -> Option<MachineReport> {
    let (machines, _) = machines_of(analysis, made).ok()??;
    MachineReport::of(&machines.iter().collect::<Vec<_>>(), engraving(&analysis.hir, made))
}

fn material_report(made: &Fabrication, masses: Option<Vec<f64>>, parts: &[Part]) -> MaterialReport {
    let sum = |figure: fn(&Part) -> Option<Fixed>| -> f64 {
        parts.iter().filter_map(figure).map(|figure| figure.value).sum()
    };
    let area_m2 = sum(|part| part.area_m2);
    let (material, board, bar) = match &made.elements {
        Elements::Panels(panels) => (&panels.settings.material, Some(panels.settings.board), None),
        Elements::Planks(planks) => (&planks.settings.material, None, Some(planks.settings.stock)),
    };
    let length = bar.map(|_| sum(|part| part.length_mm));
    let held = match (board, bar.zip(length)) {
        (Some((length, width)), _) => area_m2 / (length * width * 1e-6),
        (_, Some((bar, length))) => length / bar,
        _ => 0.0,
    };
    MaterialReport {
        name: material.name.clone(),
        thickness_mm: material.thickness.map(Fixed::mm),
        mass_kg: masses.map(|masses| Fixed::kilograms(masses.iter().sum())),
        area_m2: Fixed { value: area_m2, ..Fixed::square_metres(0.0) },
        length_mm: length.map(Fixed::mm),
        board_mm: board.map(|(length, width)| [length, width].map(Fixed::mm)),
        bar_mm: bar.map(Fixed::mm),
        raw_at_least: if held.is_finite() { (held - 1e-9).ceil().max(0.0) as u64 } else { 0 },
    }
}

fn limits(limit: &LimitValue) -> Vec<(&'static str, f64)> {
    match *limit {
        LimitValue::Plain(limit) => match limit {
            Limit::AtLeast(least) => vec![("at least", least)],
            Limit::AtMost(most) => vec![("at most", most)],
            Limit::Within(least, most) => vec![("at least", least), ("at most", most)],
            Limit::Above(bound) => vec![("above", bound)],
            Limit::Below(bound) => vec![("below", bound)],
            Limit::Equal(value) => vec![("equal to", value)],
        },
        LimitValue::Grain(least) => {
            vec![("at least, across the grain", least.across), ("at least, along the grain", least.along)]
        }
    }
}

fn requirement_report(analysis: &Analysis, requirement: &RequirementResult) -> Requirement {
    let text =
        analysis.sources.get(requirement.span.file).map_or("", |source| source.slice(requirement.span));
    let (measure, limits) = (requirement.measure, limits(&requirement.limit));
    Requirement::of(text, measure.words(), quantity(measure), &limits, &requirement.result)
}

/// The quantity that a measure is of.
fn quantity(measure: Measure) -> Quantity {
    match measure {
        Measure::Planarity => Quantity::Planarity,
        Measure::DiagonalRatio => Quantity::Ratio,
        Measure::Fold | Measure::Angle | Measure::Mitre | Measure::Bevel => Quantity::Angle,
        Measure::Edge | Measure::Length | Measure::Width | Measure::BendRadius | Measure::Overlap => {
            Quantity::Length
        }
        Measure::Area => Quantity::Area,
        Measure::Mass => Quantity::Mass,
        Measure::Count => Quantity::Count,
    }
}

/// All surfaces of a block together; planarizing is told for each of them in turn.
fn planarity(panels: &PanelsMade) -> Option<PlanarityReport> {
    let labels: Vec<&Label> = panels.figures.iter().flat_map(|figure| &figure.labels).collect();
    let address =
        |quad: u32| labels.get(quad as usize).map_or_else(String::new, |label| label.address.clone());
    let summary = |mesh: fn(&crate::analysis::PanelFigure) -> &QuadMesh| {
        let quads = panels.figures.iter().flat_map(|figure| {
            let mesh = mesh(figure);
            (0..mesh.quads.len()).map(|quad| QuadMeasure::of(mesh.corners_of(quad)))
        });
        SurfaceSummary::of(&MeshSummary::of_measures(quads), address)
    };
    let joined = |mesh: fn(&crate::analysis::PanelFigure) -> &QuadMesh| QuadMesh {
        vertices: panels.figures.iter().flat_map(|figure| mesh(figure).vertices.iter().copied()).collect(),
        quads: Vec::new(),
    };
    let first = panels.figures.first()?;
    let planarize = panels.planarizing.as_ref().zip(first.outcome.as_ref());
    Some(PlanarityReport {
        before: summary(|figure| &figure.designed),
        after: summary(|figure| &figure.built),
        folds_deg: folds(panels),
        planarize: planarize.map(|(options, outcome)| planarize_report(options, outcome)),
        moved: MovedReport::between(&joined(|figure| &figure.designed), &joined(|figure| &figure.built)),
    })
}

/// The larger folds as designed and as built, in bins from 0 to the largest of all.
fn folds(panels: &PanelsMade) -> Option<[Distribution; 2]> {
    let of = |mesh: fn(&crate::analysis::PanelFigure) -> &QuadMesh| -> Vec<f64> {
        let quads = panels.figures.iter().flat_map(|figure| {
            let mesh = mesh(figure);
            (0..mesh.quads.len()).filter_map(|quad| QuadMeasure::of(mesh.corners_of(quad)).larger_fold())
        });
        quads.collect()
    };
    let (before, after) = (of(|figure| &figure.designed), of(|figure| &figure.built));
    let most = before.iter().chain(&after).copied().fold(0.0, f64::max);
    let over = |values: Vec<f64>| Distribution::over(values, (0.0, most), Fixed::degrees);
    Some([over(before)?, over(after)?])
}

fn planarize_report(method: &Method, outcome: &Outcome) -> PlanarizeReport {
    let (name, values) = used(method);
    PlanarizeReport {
        method: name,
        options: values.into_iter().map(|(name, value)| OptionReport { name, value }).collect(),
        stop: stop_words(outcome.stop).to_owned(),
        iterations: outcome.iterations,
        best_iteration: outcome.best_iteration,
        inverted: outcome.inverted,
        history: outcome
            .history
            .iter()
            .map(|record| HistoryPoint {
                worst: record.worst.map(Fixed::planarity),
                mean: record.mean.map(Fixed::planarity),
            })
            .collect(),
    }
}

/// The method's name, and the settings it was run with.
fn used(method: &Method) -> (&'static str, Vec<(&'static str, String)>) {
    let pin = match method.pin() {
        Pin::Boundary => "boundary",
        Pin::None => "none",
        Pin::Corners => "corners",
    };
    match method {
        Method::Perturbation(options) => {
            let values = vec![
                ("worst", options.worst.to_string()),
                ("average", options.average.to_string()),
                ("select", options.select.to_string()),
                ("threshold", options.threshold.to_string()),
                ("step", format!("{}mm", options.step)),
                ("move", format!("{}mm", options.move_length)),
                ("iterations", options.iterations.to_string()),
                ("pin", pin.to_owned()),
            ];
            ("perturbation", values)
        }
        Method::Projection(options) => {
            let ratio = options.diagonal_ratio.map(|most| ("diagonal ratio", most.to_string()));
            let mut values = vec![
                ("threshold", options.threshold.to_string()),
                ("iterations", options.iterations.to_string()),
                ("pin", pin.to_owned()),
            ];
            values.extend(ratio);
            ("projection", values)
        }
    }
}

fn stop_words(stop: StopReason) -> &'static str {
    match stop {
        StopReason::Reached => "reached the threshold",
        StopReason::IterationsUsed => "used all iterations",
        StopReason::Stalled => "no further progress",
        StopReason::Cancelled => "cancelled",
        StopReason::NothingSelected => "nothing to do",
        StopReason::OnlyPinnedLeft => "only pinned vertices left",
        StopReason::OnlyFoldedLeft => "only quads folded over in the design left",
        StopReason::TooLarge => "too large for projection",
    }
}
