//! Surfaces as boards: settings and panels. Planarizing is in `flat`.

use super::super::placed::{FigureGeometry, quad_labels};
use super::super::requirements::LimitValue;
use super::super::settings;
use super::{PanelFigure, PanelsMade, Work};
use crate::fabricate::panel::{Edges, Grain, PanelSettings, Side, panels};
use crate::plan::FigurePlan;

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
}
