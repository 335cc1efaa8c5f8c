//! States: every ifs with every set of arguments that figures reach, as exact matrices.

use super::Lowering;
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::evaluate::{InstanceBody, InstanceGerm, instance_name};
use crate::hir::tree::ItemId;
use crate::hir::types::PointSpace;
use crate::hir::value::{self, Instance};
use crate::ifs::{
    Automaton, AutomatonError, Germ, GermShape, MAX_STATES, Matrix, State, StateId, StateSpace, Transform,
};
use crate::source::Span;
use std::collections::BTreeMap;

/// The states met so far.
#[derive(Default)]
pub(super) struct States {
    pub(super) instances: Vec<Instance>,
    pub(super) bodies: Vec<Option<InstanceBody>>,
    /// The states of each ifs.
    of_ifs: BTreeMap<ItemId, Vec<StateId>>,
    overflow: bool,
}

impl States {
    /// The state of an ifs with its arguments, where it was met.
    pub(super) fn find(&self, instance: &Instance) -> Option<StateId> {
        let of_ifs = self.of_ifs.get(&instance.ifs)?;
        of_ifs.iter().copied().find(|id| self.instances[id.index()] == *instance)
    }

    fn add(&mut self, instance: &Instance) -> StateId {
        let id = StateId(self.instances.len() as u32);
        self.instances.push(instance.clone());
        self.of_ifs.entry(instance.ifs).or_default().push(id);
        id
    }
}

impl Lowering<'_, '_> {
    /// The state of an ifs with its arguments, with every state it leads to; `None` after a report.
    pub(super) fn state(&mut self, instance: &Instance) -> Option<StateId> {
        let id = self.enter(instance)?;
        let mut next = id.index();
        while next < self.states.instances.len() {
            if self.states.bodies.len() <= next {
                let instance = self.states.instances[next].clone();
                let body = self.evaluator.instantiate(&instance).ok();
                let targets: Vec<Instance> = body
                    .iter()
                    .flat_map(|body| {
                        let transforms = body.transforms.iter().map(|transform| transform.target.clone());
                        transforms.chain(body.boundaries.iter().map(|boundary| boundary.target.clone()))
                    })
                    .collect();
                self.states.bodies.push(body);
                for target in targets {
                    self.enter(&target)?;
                }
            }
            next += 1;
        }
        let complete = self.states.bodies.iter().all(Option::is_some);
        complete.then_some(id)
    }

    fn enter(&mut self, instance: &Instance) -> Option<StateId> {
        if let Some(known) = self.states.find(instance) {
            return Some(known);
        }
        if self.states.instances.len() >= MAX_STATES {
            if !self.states.overflow {
                self.states.overflow = true;
                let item = self.hir.item(instance.ifs);
                let message = format!(
                    "`{}` leads to more than {MAX_STATES} states: each set of arguments is a state",
                    item.name
                );
                let diagnostic =
                    Diagnostic::new(Code::E0702, item.name_span, message).label("too many states");
                let hint =
                    "let transforms continue with the same arguments, or with one of a few sets of them";
                self.diagnostics.push(diagnostic.hint(hint));
            }
            return None;
        }
        Some(self.states.add(instance))
    }

    /// The automaton of all states met; `None` after a report.
    pub(super) fn automaton(&mut self) -> Option<Automaton> {
        let mut states = Vec::new();
        for (instance, body) in self.states.instances.iter().zip(&self.states.bodies) {
            let Some(body) = body else { return None };
            let transforms = body.transforms.iter().map(|transform| {
                let target = self.states.find(&transform.target)?;
                let matrix = Matrix::from_rows(transform.rows.clone()).ok()?;
                Some(Transform { name: transform.name.clone(), target, matrix })
            });
            let name = instance_name(self.hir, instance);
            let transforms = transforms.collect::<Option<Vec<Transform>>>()?;
            let mut state = State::new(name, body.points.len(), transforms, germ(&body.germ)?);
            state.point_names.clone_from(&body.points);
            state.space = match body.space {
                PointSpace::Plane => StateSpace::Plane,
                PointSpace::Space => StateSpace::Space,
                PointSpace::Control | PointSpace::Any => StateSpace::Control,
            };
            state.rounded = body.rounded;
            state.boundaries = self.boundaries(body)?;
            state.keep = body.keep.iter().map(germ).collect::<Option<Vec<Germ>>>()?;
            states.push(state);
        }
        if self.states.bodies.len() < self.states.instances.len() {
            return None;
        }
        self.state_joins(&mut states)?;
        match Automaton::try_new(states) {
            Ok(automaton) => Some(automaton),
            Err(error) => {
                self.not_an_automaton(&error);
                None
            }
        }
    }

    fn not_an_automaton(&mut self, error: &AutomatonError) {
        let (state, code) = match error {
            AutomatonError::WrongSize { state, .. } => (state, Code::E0503),
            AutomatonError::NoControlPoints { state } | AutomatonError::NoTransforms { state } => {
                (state, Code::E0507)
            }
            AutomatonError::TooManyStates { .. } => return,
            AutomatonError::UnknownTarget { state, .. }
            | AutomatonError::WeightSum { state, .. }
            | AutomatonError::GermVertices { state }
            | AutomatonError::GermWeights { state, .. } => (state, Code::E0501),
            AutomatonError::Boundary { state, .. } => (state, Code::E0541),
            AutomatonError::StatedJoin { state, .. } => (state, Code::E0540),
        };
        let instance =
            self.states.instances.iter().find(|instance| instance_name(self.hir, instance) == *state);
        let span = instance.map_or(Span::default(), |instance| self.hir.item(instance.ifs).name_span);
        self.diagnostics.push(Diagnostic::new(code, span, error.to_string()).label("this ifs"));
    }

    /// Where a transform of a state stands: its name.
    pub(super) fn transform_span(&self, state: StateId, transform: usize) -> Option<Span> {
        let body = self.states.bodies.get(state.index())?.as_ref()?;
        body.transforms.get(transform).map(|transform| transform.name_span)
    }

    /// Where the germ of a state stands.
    pub(super) fn germ_span(&self, state: StateId) -> Option<Span> {
        Some(self.states.bodies.get(state.index())?.as_ref()?.germ_span)
    }
}

/// A germ with exact numbers; `None` where its width is not determined.
fn germ(germ: &InstanceGerm) -> Option<Germ> {
    let shape = match &germ.shape {
        value::GermShape::Point => GermShape::Point,
        value::GermShape::Segment => GermShape::Segment,
        value::GermShape::Polygon => GermShape::Polygon,
        value::GermShape::Strut { width } => GermShape::Strut { width: width.to_rational()? },
        value::GermShape::Mesh { faces } => GermShape::Mesh { faces: faces.clone() },
    };
    Some(Germ { shape, vertices: germ.vertices.clone() })
}
