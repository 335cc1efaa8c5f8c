//! Curves as planks: settings, planks, and why a curve cannot be made of them.

use super::super::placed::{FigureGeometry, segment_labels};
use super::super::settings;
use super::{PlankFigure, PlanksMade, Work};
use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::plank::{CutPlane, Ends, Plank, PlankError, PlankSettings, closed_planks, planks};
use crate::hir::value::Value;
use crate::plan::FigurePlan;
use glam::DVec3;

/// The length of stock where a design names none, mm: longer than any bar.
const ANY_STOCK: f64 = 1e9;

/// Ends that lean by no more than this are square for a machine, rad: 0.01 degrees, 0.02 mm over 120 mm.
const SQUARE_ENOUGH: f64 = 0.01 * std::f64::consts::PI / 180.0;

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
            first: self.cut_plane("first"),
            last: self.cut_plane("last"),
        };
        let mut made = PlanksMade { settings, figures: Vec::new(), planks: Vec::new(), refused: Vec::new() };
        let figures: Vec<(usize, FigurePlan)> =
            self.figures().into_iter().map(|(place, figure)| (place, figure.clone())).collect();
        for (place, figure) in figures {
            self.curve(place, &figure, &mut made)?;
        }
        self.refused_planks(&made.refused);
        self.beyond_the_machine(&made.planks);
        Some(made)
    }

    /// The plane of an end, at the block's scale.
    fn cut_plane(&self, name: &str) -> Option<CutPlane> {
        let Some((_, Value::Cut(plane), _)) = self.setting(name) else { return None };
        let mut point = [DVec3::from(plane.point)];
        self.scale_points(&mut point);
        Some(CutPlane { point: point[0], normal: plane.normal.into() })
    }

    /// A machine that cuts planks as they lie flat makes end cuts square to that face, and no others.
    fn beyond_the_machine(&mut self, planks: &[Plank]) {
        let Some((_, _, span)) = self.setting("machine").cloned() else { return };
        let leaning = |plank: &&Plank| plank.bevels.iter().any(|bevel| bevel.abs() > SQUARE_ENOUGH);
        let mut leaning = planks.iter().filter(leaning);
        let Some(first) = leaning.next() else { return };
        let bevel = first.bevels.iter().fold(0.0, |most: f64, bevel| most.max(bevel.abs()));
        let message = format!(
            "{} ({}) gets no program: an end leans {:.2}deg out of square to the plane of its curve, and a \
             three-axis machine cuts square to the face that lies up",
            first.label.alias,
            first.label.address,
            bevel.to_degrees()
        );
        let mut diagnostic = Diagnostic::new(Code::E0850, span, message).label("cannot cut this bevel");
        for name in ["first", "last"] {
            if let Some((_, _, setting)) = self.setting(name) {
                diagnostic = diagnostic.also(*setting, "cut to this plane");
            }
        }
        let others = leaning.count();
        if others > 0 {
            diagnostic = diagnostic.note(format!("and {others} more"));
        }
        let hint = "choose a plane square to the plane of the curve, or leave `machine` out: the cut list has the \
                    mitre and the bevel for the saw";
        self.diagnostics.push(diagnostic.hint(hint));
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
            Err(error @ PlankError::NoEnds) => {
                let setting = if made.settings.first.is_some() { "first" } else { "last" };
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
