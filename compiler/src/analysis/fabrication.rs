//! A fabricate block worked out: the figure's elements as boards or planks, planarized first where that is asked for.

mod refusals;

use super::measures;
use super::placed::{FigureGeometry, figure_geometry, quad_labels, segment_labels};
use super::requirements::{LimitValue, RequirementResult, evaluate_limit};
use super::settings::{self, SettingValue};
use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::label::Label;
use crate::fabricate::panel::{Grain, Panel, PanelSettings, RefusedPanel, Side, panels};
use crate::fabricate::plank::{Ends, Plank, PlankError, PlankSettings, RefusedPlank, planks};
use crate::geometry::QuadMesh;
use crate::hir::evaluate::Evaluator;
use crate::hir::schema::{Measure, SchemaKind};
use crate::hir::tree::{Fabricate, Hir};
use crate::hir::value::Value;
use crate::plan::FigurePlan;
use crate::plan::lower::Lowered;
use crate::planarize::{Outcome, Perturbation, perturb};
use glam::DVec3;
use std::ops::ControlFlow;

/// The length of stock where a design names none, mm: longer than any bar.
const ANY_STOCK: f64 = 1e9;

/// What a fabricate block makes.
#[derive(Clone, Debug)]
pub struct Fabrication {
    /// The figure's name.
    pub figure: String,
    /// The boards or planks.
    pub elements: Elements,
    /// Settings as worked out.
    pub settings: Vec<SettingValue>,
    /// The requirements in order, measured.
    pub requirements: Vec<RequirementResult>,
}

/// Boards or planks.
#[derive(Clone, Debug)]
pub enum Elements {
    /// Boards.
    Panels(PanelsMade),
    /// Planks.
    Planks(PlanksMade),
}

/// The boards of a block.
#[derive(Clone, Debug)]
pub struct PanelsMade {
    /// How they were asked for.
    pub settings: PanelSettings,
    /// How they were planarized, if they were.
    pub perturbation: Option<Perturbation>,
    /// The surfaces, in order.
    pub figures: Vec<PanelFigure>,
    /// All boards, surface by surface.
    pub panels: Vec<Panel>,
    /// Quads no board can be made for.
    pub refused: Vec<RefusedPanel>,
}

/// One surface of a block.
#[derive(Clone, Debug)]
pub struct PanelFigure {
    /// Its place in the plan.
    pub figure: usize,
    /// As designed.
    pub designed: QuadMesh,
    /// As it is built.
    pub built: QuadMesh,
    /// What planarizing did.
    pub outcome: Option<Outcome>,
    /// One for each quad.
    pub labels: Vec<Label>,
}

/// The planks of a block.
#[derive(Clone, Debug)]
pub struct PlanksMade {
    /// How they were asked for.
    pub settings: PlankSettings,
    /// The curves, in order.
    pub figures: Vec<PlankFigure>,
    /// All planks, curve by curve.
    pub planks: Vec<Plank>,
    /// Segments no plank can be made for.
    pub refused: Vec<RefusedPlank>,
}

/// One curve of a block.
#[derive(Clone, Debug)]
pub struct PlankFigure {
    /// Its place in the plan.
    pub figure: usize,
    /// Its vertices.
    pub points: Vec<DVec3>,
    /// One for each segment.
    pub labels: Vec<Label>,
}

/// Works a block out; `None` after a report.
pub(super) fn fabricate(
    hir: &Hir,
    evaluator: &mut Evaluator<'_>,
    plan: &Lowered,
    block: &Fabricate,
) -> (Option<Fabrication>, Vec<Diagnostic>) {
    let mut work = Work { hir, plan, block, settings: Vec::new(), diagnostics: Vec::new() };
    let made = work.run(evaluator);
    (made, work.diagnostics)
}

struct Work<'a> {
    hir: &'a Hir,
    plan: &'a Lowered,
    block: &'a Fabricate,
    settings: Vec<SettingValue>,
    diagnostics: Vec<Diagnostic>,
}

impl Work<'_> {
    fn run(&mut self, evaluator: &mut Evaluator<'_>) -> Option<Fabrication> {
        for setting in &self.block.settings {
            let value = evaluator.in_block(&setting.value, self.block.slots, None).ok()?;
            self.settings.push((setting.name, value, setting.value.span));
        }
        let material = self.setting("material").map(|(_, value, _)| value.clone());
        let mut limits: Vec<LimitValue> = Vec::new();
        for requirement in &self.block.requirements {
            let found = &mut self.diagnostics;
            limits.push(evaluate_limit(
                self.hir,
                evaluator,
                self.block,
                requirement,
                material.as_ref(),
                found,
            )?);
        }
        self.within_board_limit(evaluator.limits().boards)?;
        let elements = match self.block.kind {
            SchemaKind::Planks => Elements::Planks(self.planks()?),
            _ => Elements::Panels(self.panels(&limits)?),
        };
        let requirements = self.block.requirements.iter().zip(limits).map(|(requirement, limit)| {
            let result = measures::measure(&elements, requirement.measure, &limit);
            RequirementResult { measure: requirement.measure, span: requirement.span, limit, result }
        });
        let requirements = requirements.collect();
        let figure = self.hir.item(self.block.figure).name.clone();
        Some(Fabrication { figure, elements, settings: std::mem::take(&mut self.settings), requirements })
    }

    fn setting(&self, name: &str) -> Option<&SettingValue> {
        self.settings.iter().find(|(known, _, _)| *known == name)
    }

    fn figures(&self) -> Vec<(usize, &FigurePlan)> {
        let sources = self.plan.sources.iter().enumerate();
        let own = sources.filter(|(_, source)| source.item == self.block.figure).map(|(place, _)| place);
        own.map(|place| (place, &self.plan.plan.figures()[place])).collect()
    }

    fn within_board_limit(&mut self, most: u64) -> Option<()> {
        let total: u64 = self.figures().iter().map(|(place, _)| self.plan.counts[*place].elements).sum();
        if total <= most {
            return Some(());
        }
        let message = format!("this asks for {total} boards; the limit is {most}");
        let diagnostic =
            Diagnostic::new(Code::E0701, self.block.figure_span, message).label("too many boards");
        self.diagnostics.push(diagnostic.hint("lower the level of the figure"));
        None
    }

    fn geometry(&mut self, figure: &FigurePlan) -> Option<FigureGeometry> {
        let geometry = figure_geometry(&self.plan.plan, figure);
        if geometry.is_none() {
            let message = format!("`{figure}` has coordinates beyond what can be built");
            let diagnostic = Diagnostic::new(Code::E0802, self.block.figure_span, message).label("too large");
            self.diagnostics.push(diagnostic.hint("are the units of its control points right?"));
        }
        geometry
    }

    fn wrong_shape(&mut self, figure: &FigurePlan, is: &str, makes: &str) {
        let kind = self.block.kind.name();
        let message = format!("`{figure}` is a {is}: {kind} cannot be made of it");
        let diagnostic =
            Diagnostic::new(Code::E0802, self.block.kind_span, message).label(format!("not of a {is}"));
        let figure_span = self.block.figure_span;
        self.diagnostics
            .push(diagnostic.also(figure_span, format!("a {is}")).hint(format!("write `as {makes}`")));
    }

    fn refuse(&mut self, setting: &str, why: &str) {
        let span = self.setting(setting).map_or(self.block.figure_span, |(_, _, span)| *span);
        self.diagnostics.push(Diagnostic::new(Code::E0804, span, why.to_owned()).label("cannot be used"));
    }

    fn panels(&mut self, limits: &[LimitValue]) -> Option<PanelsMade> {
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
        };
        let perturbation = match self.setting("planarize").cloned() {
            None => None,
            Some((_, value, span)) => match settings::perturbation(&value, span, self.goal(limits)) {
                Ok(options) => Some(options),
                Err(diagnostic) => {
                    self.diagnostics.push(diagnostic);
                    return None;
                }
            },
        };
        let mut made = PanelsMade {
            settings,
            perturbation,
            figures: Vec::new(),
            panels: Vec::new(),
            refused: Vec::new(),
        };
        let figures: Vec<(usize, FigurePlan)> =
            self.figures().into_iter().map(|(place, figure)| (place, figure.clone())).collect();
        for (place, figure) in figures {
            self.surface(place, &figure, &mut made)?;
        }
        self.refused_panels(&made.refused);
        Some(made)
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
        let outcome = made
            .perturbation
            .as_ref()
            .map(|options| perturb(&designed, options, &mut |_| ControlFlow::Continue(())));
        let built = outcome.as_ref().map_or_else(|| designed.clone(), |outcome| outcome.mesh.clone());
        match panels(&designed, &built, &labels, &made.settings) {
            Ok(done) => {
                made.panels.extend(done.panels);
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
        made.figures.push(PanelFigure { figure: place, designed, built, outcome, labels });
        Some(())
    }

    fn planks(&mut self) -> Option<PlanksMade> {
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
        let FigureGeometry::Curve(points) = self.geometry(figure)? else {
            self.wrong_shape(figure, "surface", "panels");
            return None;
        };
        let labels = segment_labels(&self.plan.plan, figure, points.len().saturating_sub(1));
        match planks(&points, &labels, &made.settings) {
            Ok(done) => {
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
        made.figures.push(PlankFigure { figure: place, points, labels });
        Some(())
    }
}
