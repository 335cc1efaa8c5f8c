//! The report of a design: its parameters, figures and fabrications, measured.

use super::parameter_texts;
use crate::analysis::{Analysis, Elements, Fabrication, PanelsMade, RequirementResult};
use crate::export::number::Fixed;
use crate::export::part::Part;
use crate::export::report::{
    self, Counts, ExtentReport, FigureReport, HistoryPoint, MaterialReport, MovedReport, OptionReport,
    Parameter, PlanarityReport, PlanarizeReport, Quantity, Report, Requirement, SurfaceSummary,
};
use crate::fabricate::label::Label;
use crate::geometry::{MeshSummary, QuadMeasure, QuadMesh};
use crate::hir::schema::Measure;
use crate::plan::extent::Extent;
use crate::plan::{Depth, Each, Shape};
use crate::planarize::{Method, Outcome, Pin, StopReason};

/// The report with the parts of each block.
pub(super) fn report(analysis: &Analysis, parts: Vec<Vec<Part>>) -> Report {
    let mut out = Report::new(&analysis.design_name());
    out.parameters = parameter_texts(analysis)
        .into_iter()
        .map(|(name, value)| Parameter { set: analysis.set_parameters.contains(&name), name, value })
        .collect();
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
    let (kind, material, counts, masses, planarity) = match &made.elements {
        Elements::Panels(panels) => {
            let (done, refused) = (panels.panels.len(), panels.refused.len());
            let masses: Option<Vec<f64>> = panels.panels.iter().map(|panel| panel.mass).collect();
            ("panels", &panels.settings.material, (done, refused), masses, planarity(panels))
        }
        Elements::Planks(planks) => {
            let (done, refused) = (planks.planks.len(), planks.refused.len());
            let masses: Option<Vec<f64>> = planks.planks.iter().map(|plank| plank.mass).collect();
            ("planks", &planks.settings.material, (done, refused), masses, None)
        }
    };
    report::Fabrication {
        figure: made.figure.clone(),
        kind,
        scale: Fixed::ratio(made.scale),
        material: MaterialReport {
            name: material.name.clone(),
            thickness_mm: material.thickness.map(Fixed::mm),
            mass_kg: masses.map(|masses| Fixed::kilograms(masses.iter().sum())),
        },
        counts: Counts { elements: counts.0 + counts.1, made: counts.0, refused: counts.1 },
        planarity,
        requirements: made
            .requirements
            .iter()
            .map(|requirement| requirement_report(analysis, requirement))
            .collect(),
        parts,
    }
}

fn requirement_report(analysis: &Analysis, requirement: &RequirementResult) -> Requirement {
    let text =
        analysis.sources.get(requirement.span.file).map_or("", |source| source.slice(requirement.span));
    let quantity = match requirement.measure {
        Measure::Planarity => Quantity::Planarity,
        Measure::Mitre => Quantity::Angle,
        Measure::Edge | Measure::Length | Measure::Overlap | Measure::BendRadius => Quantity::Length,
    };
    Requirement::of(text, quantity, &requirement.result)
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
        planarize: planarize.map(|(options, outcome)| planarize_report(options, outcome)),
        moved: MovedReport::between(&joined(|figure| &figure.designed), &joined(|figure| &figure.built)),
    })
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
            let values = vec![
                ("threshold", options.threshold.to_string()),
                ("iterations", options.iterations.to_string()),
                ("pin", pin.to_owned()),
            ];
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
