//! Curves as planks: settings, planks, and why a curve cannot be made of them.

use super::super::placed::{FigureGeometry, segment_labels};
use super::super::settings;
use super::{PlankFigure, PlanksMade, Work};
use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::plank::{Ends, PlankError, PlankSettings, closed_planks, planks};
use crate::hir::value::Value;
use crate::plan::FigurePlan;

/// The length of stock where a design names none, mm: longer than any bar.
const ANY_STOCK: f64 = 1e9;

impl Work<'_> {
    pub(super) fn planks(&mut self) -> Option<PlanksMade> {
        let (depth, width) = settings::size(&self.setting("section")?.1)?;
        let number =
            |work: &Self, name: &str| work.setting(name).and_then(|(_, value, _)| Value::number(value));
        let settings = PlankSettings {
            material: settings::material(self.hir, &self.setting("material")?.1),
            depth,
            width,
            ends: match settings::choice(self.setting("ends")) {
                Some(0) => Ends::Square,
                _ => Ends::Mitred,
            },
            gap: number(self, "gap").unwrap_or(0.0),
            stock: number(self, "stock").unwrap_or(ANY_STOCK),
            first: None,
            last: None,
        };
        let mut made = PlanksMade { settings, figures: Vec::new(), planks: Vec::new(), refused: Vec::new() };
        let figures: Vec<(usize, FigurePlan)> =
            self.figures().into_iter().map(|(place, figure)| (place, figure.clone())).collect();
        for (place, figure) in figures {
            self.curve(place, &figure, &mut made)?;
        }
        self.refused_planks(&made.refused);
        Some(made)
    }

    fn curve(&mut self, place: usize, figure: &FigurePlan, made: &mut PlanksMade) -> Option<()> {
        let FigureGeometry::Curve(mut points) = self.geometry(figure)? else {
            self.wrong_shape(figure, "surface", "panels");
            return None;
        };
        self.scale_points(&mut points);
        let labels = segment_labels(&self.plan.plan, figure, points.len().saturating_sub(1));
        let closed = figure.shape.closed().0;
        let made_of = match closed {
            true => closed_planks(&points, &labels, &made.settings),
            false => planks(&points, &labels, &made.settings),
        };
        match made_of {
            Ok(mut done) => {
                // Curves are put up one after the other.
                let before = made.planks.len() as u32;
                done.planks.iter_mut().for_each(|plank| plank.order += before);
                made.planks.extend(done.planks);
                made.refused.extend(done.refused);
            }
            Err(error @ PlankError::NoSection { what, .. }) => {
                let given = ["gap", "stock"]
                    .into_iter()
                    .find(|setting| what.starts_with(setting) || what.ends_with(setting));
                let setting = given.unwrap_or("section");
                self.refuse(setting, &error.to_string());
                return None;
            }
            Err(error) => {
                let why = format!("no planks can be made of `{figure}`: {error}");
                let diagnostic =
                    Diagnostic::new(Code::E0802, self.block.figure_span, why).label("this figure");
                let hint = match error {
                    PlankError::NotPlanar { .. } => "move its control points into one plane",
                    _ => "are its control points and its level right?",
                };
                self.diagnostics.push(diagnostic.hint(hint));
                return None;
            }
        }
        made.figures.push(PlankFigure { figure: place, points, closed, labels });
        Some(())
    }
}
