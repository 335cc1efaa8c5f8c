//! The evaluator: from the typed tree to values, with a budget of steps. It never loops for ever, and every failure is a
//! diagnostic at the expression that failed.

mod boundary;
mod budget;
mod combination;
mod control_points;
mod conversion;
mod expression;
mod germ;
mod instance;
mod limits;
mod list;
mod map;
mod maths;
mod mesh;
mod native;
mod operator;
mod overrides;
mod placement;
mod plane;
mod points;
mod swept;
mod symbolic;
mod test;
mod told;
mod transform;
mod until;
mod vectors;

pub use boundary::{InstanceBoundary, InstanceJoin, InstanceJoinPart};
pub use budget::MOST_ELEMENTS;
pub use expression::{quantity_words, quantity_words_to, words};
pub use instance::{InstanceBody, InstanceGerm, InstanceTransform, instance_name};
pub use limits::Limits;
pub use overrides::{MachineName, OverrideError, Overrides, ParameterValue, Planarizing, read_value};
pub use symbolic::{SymbolicSum, SymbolicTransform};
pub use test::MadeValues;
pub use told::value_words;

use super::tree::{Body, Hir, ItemId, ItemKind, LocalId};
use super::value::{Instance, Value};
use crate::diagnostic::{Code, Diagnostic, Diagnostics};
use crate::exact::AtomId;
use crate::source::Span;
use std::collections::{BTreeMap, BTreeSet};

/// Why an expression has no value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// A diagnostic says why.
    Reported,
    /// It depends on parameters that are symbols here.
    Undetermined,
}

/// What an expression gives.
pub type Outcome<T> = Result<T, Stop>;

/// Evaluates the items of one design.
pub struct Evaluator<'a> {
    hir: &'a Hir,
    globals: BTreeMap<ItemId, Outcome<Value>>,
    diagnostics: Diagnostics,
    budget: budget::Budget,
    calls: Vec<Call>,
    overrides: &'a Overrides,
    /// Names of the atoms of the ifs being checked for all its parameters.
    atoms: Vec<String>,
    /// Names of the control points of the ifs being worked out.
    points: Vec<String>,
    /// Every ifs that is used where its pieces must join.
    must_join: Vec<MustJoin>,
    /// Every ifs with an error in it, reported once.
    broken: BTreeSet<ItemId>,
    /// The ifs with its arguments that is being worked out, for messages.
    within: Option<String>,
    /// The values that are being worked out.
    open: BTreeSet<ItemId>,
    /// What each sum of control points was made of, by the places they were made at.
    sums: BTreeMap<Span, Vec<Span>>,
    /// Sums found to be neither points nor vectors where one was needed; what is made of them is wrong for their sake.
    wrong_sums: BTreeSet<Span>,
    /// Whether a rounded number went into the weights of the ifs being worked out.
    rounded: bool,
    /// What is made of figures, for tests.
    made: Option<&'a MadeValues>,
    /// Whether nothing was said yet of what could not be typed.
    reports_untyped: bool,
}

/// An ifs used where its pieces must join.
#[derive(Clone, Debug, PartialEq)]
pub struct MustJoin {
    /// The ifs.
    pub ifs: Instance,
    /// Where it is used.
    pub span: Span,
    /// Why they must.
    pub why: String,
}

/// A call of a function, or a use of an ifs, that is being worked out.
#[derive(Clone, Copy)]
struct Call {
    /// Where it stands.
    span: Span,
    /// The function or the ifs.
    of: ItemId,
}

/// The slots of a call, and the ifs around.
struct Frame {
    /// What stands in each slot, or why nothing does.
    slots: Vec<Outcome<Value>>,
    own_ifs: Option<Instance>,
}

impl Frame {
    fn new(slots: u32) -> Self {
        Frame { slots: vec![Err(Stop::Reported); slots as usize], own_ifs: None }
    }

    fn set(&mut self, id: LocalId, value: Value) {
        if let Some(slot) = self.slots.get_mut(id.0 as usize) {
            *slot = Ok(value);
        }
    }

    /// Remembers why a slot has no value: whoever reads it stops for the same reason.
    fn stopped(&mut self, id: LocalId, reason: Stop) {
        if let Some(slot) = self.slots.get_mut(id.0 as usize) {
            *slot = Err(reason);
        }
    }
}

impl<'a> Evaluator<'a> {
    /// An evaluator of a design with some of its parameters set from outside.
    pub fn new(hir: &'a Hir, overrides: &'a Overrides) -> Self {
        Evaluator {
            hir,
            globals: BTreeMap::new(),
            diagnostics: Diagnostics::default(),
            budget: budget::Budget::default(),
            calls: Vec::new(),
            overrides,
            atoms: Vec::new(),
            points: Vec::new(),
            must_join: Vec::new(),
            broken: BTreeSet::new(),
            within: None,
            reports_untyped: false,
            open: BTreeSet::new(),
            sums: BTreeMap::new(),
            wrong_sums: BTreeSet::new(),
            rounded: false,
            made: None,
        }
    }

    /// What has been found so far.
    pub fn finish(self) -> Vec<Diagnostic> {
        self.diagnostics.finish()
    }

    /// The value of a param, let or figure; each is worked out once.
    ///
    /// # Errors
    /// After a report.
    pub fn global(&mut self, id: ItemId) -> Outcome<Value> {
        if let Some(known) = self.globals.get(&id) {
            return known.clone();
        }
        let hir = self.hir;
        if !self.open.insert(id) {
            return Err(self.needs_itself(id));
        }
        let outcome = match &hir.item(id).kind {
            ItemKind::Param(param) => self.parameter(id, param),
            ItemKind::Let(body) | ItemKind::Figure(body) => self.body(body),
            _ => Err(Stop::Reported),
        };
        self.open.remove(&id);
        self.globals.insert(id, outcome.clone());
        outcome
    }

    /// A circle through a function, which the checker lets pass: what it gives is written down.
    fn needs_itself(&mut self, id: ItemId) -> Stop {
        let item = self.hir.item(id);
        let message = format!("`{}` depends on itself", item.name);
        let diagnostic = Diagnostic::new(Code::E0305, item.name_span, message).label("needs its own value");
        let diagnostic = diagnostic.hint("give one of the definitions in the circle a value of its own");
        self.calls.clear();
        self.report(diagnostic)
    }

    /// The value of an expression with a frame of its own.
    ///
    /// # Errors
    /// After a report.
    pub fn body(&mut self, body: &Body) -> Outcome<Value> {
        // A global's value does not depend on who asked for it first: neither do its messages.
        let (calls, within) = (std::mem::take(&mut self.calls), self.within.take());
        let symbolic = self.suspend_symbolic();
        let outcome = self.expr(&mut Frame::new(body.slots), &body.value);
        self.resume_symbolic(symbolic);
        (self.calls, self.within) = (calls, within);
        outcome
    }

    /// The value of an expression of a fabricate block, `material` in its first slot.
    ///
    /// # Errors
    /// After a report.
    pub fn in_block(
        &mut self,
        value: &super::tree::Expr,
        slots: u32,
        material: Option<&Value>,
    ) -> Outcome<Value> {
        let mut frame = Frame::new(slots.max(1));
        if let Some(material) = material {
            frame.set(LocalId(0), material.clone());
        }
        self.expr(&mut frame, value)
    }

    /// Reports what could not be typed, from here on. In a design in which the checker found no errors, that is what is
    /// made of an element of an empty list.
    pub fn report_untyped(&mut self) {
        self.reports_untyped = true;
    }

    fn untyped(&mut self, span: Span) -> Stop {
        if !self.reports_untyped {
            return Stop::Reported;
        }
        let message = "this is made of an element of an empty list, which has none";
        let diagnostic = Diagnostic::new(Code::E0602, span, message).label("cannot be worked out");
        self.report(diagnostic.hint("put at least one element into the list"))
    }

    /// The uses of ifs whose pieces must join, met so far.
    pub fn must_join(&self) -> &[MustJoin] {
        &self.must_join
    }

    fn report(&mut self, mut diagnostic: Diagnostic) -> Stop {
        let own = |span: &Span| !self.hir.is_library(span.file);
        if !own(&diagnostic.span)
            && let Some(call) = self.calls.iter().rev().find(|call| own(&call.span)).copied()
        {
            // What goes wrong inside the library is the matter of the line that called it, and of what it called.
            let inside = std::mem::replace(&mut diagnostic.span, call.span);
            diagnostic = diagnostic.also(inside, "found here");
            diagnostic = match self.told_of(call.of) {
                Some(told) => diagnostic.note(told),
                None => diagnostic,
            };
        } else if let Some(call) = self.calls.iter().rev().find(|call| call.span != diagnostic.span) {
            let is_ifs = matches!(self.hir.item(call.of).kind, ItemKind::Ifs(_));
            diagnostic = diagnostic.also(call.span, if is_ifs { "used here" } else { "called here" });
        }
        if let Some(within) = &self.within {
            diagnostic = diagnostic.note(format!("in {within}"));
        }
        self.diagnostics.push(diagnostic);
        Stop::Reported
    }

    /// What a function of the library says of itself: the first paragraph of its docs.
    fn told_of(&self, id: ItemId) -> Option<String> {
        let item = self.hir.item(id);
        let lines = item.docs.iter().map(|line| line.trim());
        let paragraph: Vec<&str> = lines.take_while(|line| !line.is_empty()).collect();
        (!paragraph.is_empty()).then(|| format!("`{}`: {}", item.name, paragraph.join(" ")))
    }

    fn atom(&mut self, name: String) -> AtomId {
        let index = self.atoms.iter().position(|known| *known == name).unwrap_or_else(|| {
            self.atoms.push(name);
            self.atoms.len() - 1
        });
        AtomId(index as u32)
    }
}
