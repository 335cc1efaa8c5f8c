//! Surfaces as boards: settings, planarizing, panels.

use super::super::placed::{FigureGeometry, quad_labels};
use super::super::requirements::LimitValue;
use super::super::settings;
use super::{PanelFigure, PanelsMade, Work};
use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::panel::{Edges, Grain, PanelSettings, Side, panels};
use crate::hir::schema::Measure;
use crate::plan::FigurePlan;
use crate::planarize::{Perturbation, perturb};
use std::ops::ControlFlow;

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
        let perturbation = self.planarize(limits)?;
        let mut made = PanelsMade {
            settings,
            perturbation,
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
    fn planarize(&mut self, limits: &[LimitValue]) -> Option<Option<Perturbation>> {
        let Some((_, value, span)) = self.setting("planarize").cloned() else { return Some(None) };
        if self.leave_unplanarized {
            return Some(None);
        }
        match settings::perturbation(&value, span, self.goal(limits)) {
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

    /// The planarity that `require planarity >= …` asks for.
    fn goal(&self, limits: &[LimitValue]) -> Option<f64> {
        let required = self.block.requirements.iter().zip(limits);
        required
            .filter(|(requirement, _)| requirement.measure == Measure::Planarity)
            .find_map(|(_, limit)| limit.least())
    }

    fn surface(&mut self, place: usize, figure: &FigurePlan, made: &mut PanelsMade) -> Option<()> {
        let FigureGeometry::Surface(designed) = self.geometry(figure)? else {
            self.wrong_shape(figure, "curve", "planks");
            return None;
        };
        let (rows, columns) = self.plan.counts[place].grid;
        let labels = quad_labels(&self.plan.plan, figure, rows, columns);
        let planar = figure.shape.planar_by_construction();
        let outcome = made
            .perturbation
            .as_ref()
            .filter(|_| !planar)
            .map(|options| perturb(&designed, options, &mut |_| ControlFlow::Continue(())));
        let built = outcome.as_ref().map_or_else(|| designed.clone(), |outcome| outcome.mesh.clone());
        let (designed, built) = (self.scaled_mesh(designed), self.scaled_mesh(built));
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
}
