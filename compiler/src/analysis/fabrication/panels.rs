//! Surfaces as boards: settings, planarizing, panels.

use super::super::placed::{FigureGeometry, quad_labels};
use super::super::planarizing::{Goals, planarizing};
use super::super::requirements::LimitValue;
use super::super::settings;
use super::{PanelFigure, PanelsMade, Work};
use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::panel::{Edges, Grain, PanelSettings, Side, panels};
use crate::geometry::QuadMesh;
use crate::hir::schema::Measure;
use crate::plan::FigurePlan;
use crate::planarize::{Method, Outcome, StopReason};

impl Work<'_> {
    pub(super) fn panels(&mut self, limits: &[LimitValue]) -> Option<PanelsMade> {
        let settings = PanelSettings {
            material: settings::material(self.hir, &self.setting("material")?.1),
            board: settings::size(&self.setting("board")?.1)?,
            side: match settings::choice(self.setting("side")) {
                Some(0) => Side::Inner,
                Some(2) => Side::Outer,
                _ => Side::Centred,
            },
            grain: match settings::choice(self.setting("grain")) {
                Some(0) => Grain::U,
                Some(1) => Grain::V,
                _ => Grain::Free,
            },
            edges: match settings::choice(self.setting("edges")) {
                Some(1) => Edges::Bevelled,
                Some(2) => Edges::Stepped,
                _ => Edges::Square,
            },
        };
        let planarizing = self.planarize(limits)?;
        let mut made = PanelsMade {
            settings,
            planarizing,
            figures: Vec::new(),
            panels: Vec::new(),
            refused: Vec::new(),
            corners: Vec::new(),
        };
        let figures: Vec<(usize, FigurePlan)> =
            self.figures().into_iter().map(|(place, figure)| (place, figure.clone())).collect();
        for (place, figure) in figures {
            self.surface(place, &figure, &mut made)?;
        }
        self.refused_panels(&made.refused);
        Some(made)
    }

    /// How to planarize, where that is asked for and of use; `None` after a report of an error.
    fn planarize(&mut self, limits: &[LimitValue]) -> Option<Option<Method>> {
        let Some((_, value, span)) = self.setting("planarize").cloned() else { return Some(None) };
        if self.leave_unplanarized {
            return Some(None);
        }
        match planarizing(&value, span, self.goals(limits)) {
            Ok(_) if self.figures().iter().all(|(_, figure)| figure.shape.planar_by_construction()) => {
                let message =
                    "the quads of this surface are planar by construction: there is nothing to planarize";
                let diagnostic = Diagnostic::new(Code::W0525, span, message).label("left aside");
                self.diagnostics.push(diagnostic.hint("take `planarize` out"));
                Some(None)
            }
            Ok(options) => Some(Some(options)),
            Err(diagnostic) => {
                self.diagnostics.push(diagnostic);
                None
            }
        }
    }

    /// What `require planarity >= …` and `require diagonal ratio <= …` ask for.
    fn goals(&self, limits: &[LimitValue]) -> Goals {
        let of = |measure: Measure| {
            let required = self.block.requirements.iter().zip(limits);
            required.filter(move |(requirement, _)| requirement.measure == measure).map(|(_, limit)| limit)
        };
        Goals {
            planarity: of(Measure::Planarity).find_map(LimitValue::least),
            diagonal_ratio: of(Measure::DiagonalRatio).find_map(LimitValue::most),
        }
    }

    fn surface(&mut self, place: usize, figure: &FigurePlan, made: &mut PanelsMade) -> Option<()> {
        let FigureGeometry::Surface(designed) = self.geometry(figure)? else {
            self.wrong_shape(figure, "curve", "planks");
            return None;
        };
        let (rows, columns) = self.plan.counts[place].grid;
        let labels = quad_labels(&self.plan.plan, figure, rows, columns);
        let planar = figure.shape.planar_by_construction();
        let method = made.planarizing.filter(|_| !planar);
        let outcome = match method {
            Some(method) => Some(self.planarized(figure, &designed, &method)?),
            None => None,
        };
        let built = outcome.as_ref().map_or_else(|| designed.clone(), |outcome| outcome.mesh.clone());
        let (designed, built) = (self.scaled_mesh(designed), self.scaled_mesh(built));
        self.goes_on()?;
        match panels(&designed, &built, &labels, &made.settings) {
            Ok(mut done) => {
                // Surfaces are put up one after the other.
                let before = made.panels.len() as u32;
                done.panels.iter_mut().for_each(|panel| panel.order += before);
                made.panels.extend(done.panels);
                made.corners.extend(done.corners);
                made.refused.extend(done.refused);
            }
            Err(error) => {
                let setting = match error {
                    crate::fabricate::panel::PanelError::NoBoard { .. } => "board",
                    _ => "material",
                };
                self.refuse(setting, &error.to_string());
                return None;
            }
        }
        made.figures.push(PanelFigure { figure: place, designed, built, outcome, planar, labels });
        Some(())
    }

    /// Planarizes a surface; `None` where whoever watches says stop.
    fn planarized(&mut self, figure: &FigurePlan, designed: &QuadMesh, method: &Method) -> Option<Outcome> {
        let (name, watch) = (figure.to_string(), &mut *self.watch);
        let outcome = method.run(designed, &mut |progress| watch.planarizing(&name, &progress));
        watch.planarized(&name);
        if outcome.stop == StopReason::Cancelled {
            return None;
        }
        self.moved_far(&name, designed, &outcome);
        Some(outcome)
    }

    /// Warns where the surface that is built is no longer the one that was designed.
    fn moved_far(&mut self, name: &str, designed: &QuadMesh, outcome: &Outcome) {
        let size = extent(designed);
        if outcome.moved.max <= FAR * size {
            return;
        }
        let (most, mean) = (outcome.moved.max, outcome.moved.mean);
        let percent = 100.0 * most / size;
        let message = format!(
            "planarizing moved vertices of `{name}` by up to {most:.0}mm ({mean:.0}mm on average): {percent:.1}% of its size"
        );
        let span = self.setting("planarize").map_or(self.block.figure_span, |(_, _, span)| *span);
        let diagnostic = Diagnostic::new(Code::W0826, span, message).label("far from the design");
        self.diagnostics.push(diagnostic.hint(
            "look at both in model.glb; a lower `require planarity`, a higher level or flatter control points need less",
        ));
    }
}

/// The part of a surface's size beyond which its vertices moved far.
const FAR: f64 = 0.025;

/// The diagonal of the box around a surface, mm.
fn extent(mesh: &QuadMesh) -> f64 {
    let mut vertices = mesh.vertices.iter().copied();
    let Some(first) = vertices.next() else { return 0.0 };
    let (least, most) = vertices.fold((first, first), |(least, most), at| (least.min(at), most.max(at)));
    least.distance(most)
}
