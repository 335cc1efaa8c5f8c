//! A fabricate block worked out: the figure's elements as boards or planks, planarized first where that is asked for.

mod flat;
mod materials;
mod nest;
mod panels;
mod planks;
mod refusals;
mod scale;

pub(crate) use nest::{nested_panel, nested_plank};

use super::measures;
use super::placed::{FigureGeometry, figure_geometry};
use super::requirements::{LimitValue, RequirementResult, conflicts, evaluate_limit};
use super::settings::{self, SettingValue};
use super::watch::Watch;
use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::label::Label;
use crate::fabricate::panel::{Corner, Panel, PanelRefusal, PanelSettings, RefusedPanel};
use crate::fabricate::plank::{Plank, PlankRefusal, PlankSettings, RefusedPlank};
use crate::geometry::QuadMesh;
use crate::hir::evaluate::{Evaluator, Planarizing};
use crate::hir::schema::{Measure, SchemaKind};
use crate::hir::tree::{Fabricate, Hir};
use crate::hir::value::Value;
use crate::nest::{bars::Stock, sheets::Sheet};
use crate::plan::FigurePlan;
use crate::plan::lower::Lowered;
use crate::planarize::{Method, Outcome};
use glam::DVec3;

/// What a fabricate block makes.
#[derive(Clone, Debug)]
pub struct Fabrication {
    /// The figure's name.
    pub figure: String,
    /// What its geometry was scaled by: 1 for the building, 1/20 for a model.
    pub scale: f64,
    /// The boards or planks, of the size they are made in.
    pub elements: Elements,
    /// Settings as worked out.
    pub settings: Vec<SettingValue>,
    /// What they are cut from together, where that is asked for.
    pub nest: Option<Nest>,
    /// The requirements in order, measured.
    pub requirements: Vec<RequirementResult>,
}

/// What the elements of a block are cut from together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Nest {
    /// Boards from raw boards, and what of them gets a program.
    Sheets(Sheet, Programs),
    /// Planks from raw bars.
    Bars(Stock),
}

/// What of nested boards gets a program where there is a machine. The places are those of the words of
/// [`ChoiceKind::Programs`](crate::hir::schema::ChoiceKind::Programs).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Programs {
    /// Each board alone, and each sheet.
    Both,
    /// Each board alone.
    Boards,
    /// Each sheet, and boards that lie on none.
    Sheets,
}

/// Boards or planks.
#[derive(Clone, Debug)]
pub enum Elements {
    /// Boards.
    Panels(PanelsMade),
    /// Planks.
    Planks(PlanksMade),
}

impl Elements {
    /// How many there are, also of those that cannot be made.
    pub fn total(&self) -> usize {
        match self {
            Elements::Panels(made) => made.panels.len() + made.refused.len(),
            Elements::Planks(made) => made.planks.len() + made.refused.len(),
        }
    }

    /// Those that are too large for the raw board or bar, each with its size in words.
    pub(super) fn too_large(&self) -> Vec<(&Label, String)> {
        match self {
            Elements::Panels(made) => {
                let refused = made.refused.iter();
                refused
                    .filter(|refused| matches!(refused.reason, PanelRefusal::TooLarge { .. }))
                    .map(|refused| (&refused.label, refused.reason.to_string()))
                    .collect()
            }
            Elements::Planks(made) => {
                let refused = made.refused.iter();
                refused
                    .filter(|refused| matches!(refused.reason, PlankRefusal::TooLong { .. }))
                    .map(|refused| (&refused.label, refused.reason.to_string()))
                    .collect()
            }
        }
    }
}

/// The boards of a block.
#[derive(Clone, Debug)]
pub struct PanelsMade {
    /// How they were asked for.
    pub settings: PanelSettings,
    /// How they were planarized, if they were.
    pub planarizing: Option<Method>,
    /// The surfaces, in order.
    pub figures: Vec<PanelFigure>,
    /// All boards, surface by surface.
    pub panels: Vec<Panel>,
    /// Quads no board can be made for.
    pub refused: Vec<RefusedPanel>,
    /// The corners where boards have to be cut back.
    pub corners: Vec<Corner>,
}

/// One surface of a block.
#[derive(Clone, Debug)]
pub struct PanelFigure {
    /// Its place in the plan.
    pub figure: usize,
    /// As designed, at the block's scale.
    pub designed: QuadMesh,
    /// As it is built, at the block's scale.
    pub built: QuadMesh,
    /// What planarizing did, before anything was scaled.
    pub outcome: Option<Outcome>,
    /// Whether its quads are planar by construction, and so never planarized.
    pub planar: bool,
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
    /// Its vertices, at the block's scale; where it is closed the first is also the last.
    pub points: Vec<DVec3>,
    /// Whether it goes round.
    pub closed: bool,
    /// One for each segment.
    pub labels: Vec<Label>,
}

/// Works a block out, with another machine than its own where one is given; `None` after a report.
pub(super) fn fabricate(
    hir: &Hir,
    evaluator: &mut Evaluator<'_>,
    plan: &Lowered,
    (block, machine): (&Fabricate, Option<&Value>),
    watch: &mut dyn Watch,
) -> (Option<Fabrication>, Vec<Diagnostic>) {
    let planarizing = evaluator.planarizing().clone();
    let mut work = Work {
        hir,
        plan,
        block,
        machine,
        watch,
        scale: 1.0,
        settings: Vec::new(),
        diagnostics: Vec::new(),
        planarizing,
    };
    let made = work.run(evaluator);
    (made, work.diagnostics)
}

struct Work<'a> {
    hir: &'a Hir,
    plan: &'a Lowered,
    block: &'a Fabricate,
    machine: Option<&'a Value>,
    watch: &'a mut dyn Watch,
    scale: f64,
    settings: Vec<SettingValue>,
    diagnostics: Vec<Diagnostic>,
    planarizing: Planarizing,
}

impl Work<'_> {
    fn run(&mut self, evaluator: &mut Evaluator<'_>) -> Option<Fabrication> {
        for setting in &self.block.settings {
            let value = evaluator.in_block(&setting.value, self.block.slots, None).ok()?;
            self.settings.push((setting.name, value, setting.value.span));
        }
        self.put_machine();
        self.scale = self.scale_asked()?;
        self.check_material()?;
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
        self.possible(&limits, material.as_ref())?;
        self.within_board_limit(evaluator.limits().boards)?;
        let elements = match self.block.kind {
            SchemaKind::Planks => Elements::Planks(self.planks()?),
            _ => Elements::Panels(self.panels(&limits)?),
        };
        let nest = self.nest(&elements)?;
        let mut requirements = Vec::new();
        for (requirement, limit) in self.block.requirements.iter().zip(limits) {
            self.goes_on()?;
            let (measure, span) = (requirement.measure, requirement.span);
            let result = measures::measure(&elements, measure, &limit);
            requirements.push(RequirementResult { measure, span, limit, result });
        }
        let figure = self.hir.item(self.block.figure).name.clone();
        let settings = std::mem::take(&mut self.settings);
        Some(Fabrication { figure, scale: self.scale, elements, settings, nest, requirements })
    }

    /// `None` where whoever watches says stop.
    fn goes_on(&mut self) -> Option<()> {
        self.watch.step().is_continue().then_some(())
    }

    /// Puts the machine that is named from outside in the place of the block's own, or gives it to one without.
    fn put_machine(&mut self) {
        let Some(machine) = self.machine else { return };
        match self.settings.iter_mut().find(|(name, _, _)| *name == "machine") {
            Some((_, value, _)) => *value = machine.clone(),
            None => self.settings.push(("machine", machine.clone(), self.block.figure_span)),
        }
    }

    /// Reports what no figure can hold, and masses that are not known.
    fn possible(&mut self, limits: &[LimitValue], material: Option<&Value>) -> Option<()> {
        let found = conflicts(&self.block.requirements, limits);
        let possible = found.is_empty();
        self.diagnostics.extend(found);
        let material = settings::material(self.hir, material?);
        let mass = self.block.requirements.iter().find(|requirement| requirement.measure == Measure::Mass);
        if let Some(mass) = mass.filter(|_| material.density.is_none()) {
            let message = format!("the mass is not known: {} has no density", material.name);
            let diagnostic = Diagnostic::new(Code::E0832, mass.span, message).label("cannot be measured");
            let hint =
                "give the record of the material a field `density`, such as `density: Density = 450kg/m3`";
            self.diagnostics.push(diagnostic.hint(hint));
            return None;
        }
        possible.then_some(())
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
}
