//! `report.html`: the report with the shapes of the analysis.

use super::model::{built_planarity, plain_figures};
use crate::analysis::{
    Analysis, Elements, Fabrication, FigureGeometry, PanelsMade, PlanksMade, figure_geometry,
};
use crate::export::html::{self, CurveShape, Document, Made, PanelShapes, Plain, PlankShapes, SurfaceShape};
use crate::export::report::Report;
use crate::plan::evaluate::PiecesEvaluator;
use glam::DVec3;
use std::convert::Infallible;

/// Lines of figures nothing is made of, at most; a polygon counts for [`POLYGON`] of them.
const MOST_PLAIN: usize = 48_000;

/// What a polygon takes in the file, in lines.
const POLYGON: usize = 4;

/// The bytes of `report.html`.
pub(super) fn html(analysis: &Analysis, report: &Report) -> String {
    let made = analysis.fabrications.iter().map(|made| shapes(analysis, made)).collect();
    let mut left = MOST_PLAIN;
    let plain = plain_figures(analysis).filter_map(|place| plain(analysis, place, &mut left)).collect();
    html::html(&Document { report, made, plain })
}

fn shapes<'a>(analysis: &'a Analysis, made: &'a Fabrication) -> Made<'a> {
    match &made.elements {
        Elements::Panels(panels) => Made::Panels(panel_shapes(analysis, made, panels)),
        Elements::Planks(planks) => Made::Planks(plank_shapes(analysis, planks)),
    }
}

fn name(analysis: &Analysis, place: usize) -> String {
    let figures = analysis.plan.as_ref().map_or(&[][..], |lowered| lowered.plan.figures());
    figures.get(place).map(ToString::to_string).unwrap_or_default()
}

fn panel_shapes<'a>(
    analysis: &'a Analysis,
    made: &'a Fabrication,
    panels: &'a PanelsMade,
) -> PanelShapes<'a> {
    let surfaces = panels.figures.iter().map(|figure| SurfaceShape {
        name: name(analysis, figure.figure),
        designed: &figure.designed,
        built: &figure.built,
        labels: &figure.labels,
    });
    PanelShapes {
        surfaces: surfaces.collect(),
        panels: &panels.panels,
        required: built_planarity(made, panels),
    }
}

fn plank_shapes<'a>(analysis: &'a Analysis, planks: &'a PlanksMade) -> PlankShapes<'a> {
    let curves = planks.figures.iter().map(|figure| CurveShape {
        name: name(analysis, figure.figure),
        points: &figure.points,
        labels: &figure.labels,
    });
    PlankShapes { curves: curves.collect(), planks: &planks.planks }
}

/// A figure nothing is made of, as far as `left` elements allow.
fn plain(analysis: &Analysis, place: usize, left: &mut usize) -> Option<Plain> {
    let lowered = analysis.plan.as_ref()?;
    let mut plain = Plain::default();
    match figure_geometry(&lowered.plan, &lowered.plan.figures()[place])? {
        FigureGeometry::Curve(points) => {
            let kept = points.len().min(*left);
            *left -= kept;
            plain.left_out = (points.len() - kept) as u64;
            plain.lines.push(points.into_iter().take(kept).collect());
        }
        FigureGeometry::Surface(mesh) => {
            let kept = mesh.quads.len().min(*left / POLYGON);
            *left -= kept * POLYGON;
            plain.left_out = (mesh.quads.len() - kept) as u64;
            plain.polygons = (0..kept).map(|quad| mesh.corners_of(quad).to_vec()).collect();
        }
        FigureGeometry::Pieces(evaluator) => pieces(&evaluator, &mut plain, left),
    }
    Some(plain)
}

fn pieces(evaluator: &PiecesEvaluator, plain: &mut Plain, left: &mut usize) {
    use crate::ifs::GermShape;
    let mut vertices = Vec::new();
    let Ok(()) = evaluator.stream(|tile| {
        for element in tile.elements() {
            let taken = match &element.drawn.shape {
                GermShape::Point | GermShape::Segment | GermShape::Strut { .. } => 1,
                GermShape::Polygon => POLYGON,
                GermShape::Mesh { faces } => POLYGON * faces.len(),
            };
            if taken > *left {
                plain.left_out += 1;
                continue;
            }
            *left -= taken;
            tile.copy_vertices(&element, &mut vertices);
            let points: Vec<DVec3> = vertices.iter().copied().map(DVec3::from_array).collect();
            match &element.drawn.shape {
                GermShape::Point | GermShape::Segment => plain.lines.push(points),
                GermShape::Strut { .. } => plain.lines.push(points.into_iter().take(2).collect()),
                GermShape::Polygon => plain.polygons.push(points),
                GermShape::Mesh { faces } => {
                    let corners =
                        |face: &Vec<u32>| face.iter().map(|corner| points[*corner as usize]).collect();
                    plain.polygons.extend(faces.iter().map(corners));
                }
            }
        }
        Ok::<(), Infallible>(())
    });
}
