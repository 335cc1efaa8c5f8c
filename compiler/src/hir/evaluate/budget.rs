//! How long an evaluation may take.

use super::{Evaluator, Limits, Outcome, Planarizing, Stop};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::scalar::Scalar;
use crate::source::Span;

/// The most elements one list, and the most bytes one text, may have.
pub const MOST_ELEMENTS: usize = 1_000_000;

/// How deeply calls and expressions may be nested while they are worked out.
const DEEPEST: u32 = 5_000;

/// With so many values waiting for each other, it is they that are nested too deeply, not calls.
const MANY_OPEN: usize = 500;

#[derive(Default)]
pub(super) struct Budget {
    steps: u64,
    depth: u32,
    calls: u32,
    exhausted: bool,
    symbolic: Option<u64>,
}

/// The most work spent on checking one ifs for all values of its parameters, in terms of polynomials.
const MOST_SYMBOLIC_WORK: u64 = 500_000;

impl Evaluator<'_> {
    /// What the design may ask for.
    pub fn limits(&self) -> Limits {
        self.overrides.limits
    }

    /// How surfaces are planarized.
    pub fn planarizing(&self) -> &Planarizing {
        &self.overrides.planarizing
    }

    /// Counts a step at an expression.
    pub(super) fn step(&mut self, span: Span) -> Outcome<()> {
        self.spend(1, span)
    }

    /// Counts many steps at once.
    pub(super) fn spend(&mut self, steps: u64, span: Span) -> Outcome<()> {
        self.budget.steps = self.budget.steps.saturating_add(steps);
        let most = self.overrides.limits.steps;
        if self.budget.steps <= most {
            return Ok(());
        }
        if !self.budget.exhausted {
            self.budget.exhausted = true;
            let message = format!("the design takes more than {most} steps to work out");
            let diagnostic = Diagnostic::new(Code::E0703, span, message).label("given up here");
            self.report(diagnostic.hint("use fewer elements in lists, or fewer nested lists"));
        }
        Err(Stop::Reported)
    }

    /// From here on, work is that of a check for all values of parameters, which gives up in silence.
    pub(super) fn begin_symbolic(&mut self) {
        self.budget.symbolic = Some(MOST_SYMBOLIC_WORK);
    }

    /// Back to work that is reported when there is too much of it.
    pub(super) fn end_symbolic(&mut self) {
        self.budget.symbolic = None;
    }

    /// Sets the work of a check for all values of parameters aside, for a value that does not depend on them.
    pub(super) fn suspend_symbolic(&mut self) -> Option<u64> {
        self.budget.symbolic.take()
    }

    /// Goes on with what was set aside.
    pub(super) fn resume_symbolic(&mut self, left: Option<u64>) {
        self.budget.symbolic = left;
    }

    /// Counts arithmetic on these numbers with a factor of this cost; zeros cost nothing.
    pub(super) fn work(&mut self, numbers: &[Scalar], factor: u64, span: Span) -> Outcome<()> {
        let counted = numbers.iter().filter(|number| !number.is_zero());
        let cost = counted.map(Scalar::cost).sum::<u64>().saturating_mul(factor);
        match self.budget.symbolic {
            None => self.spend(cost / 16, span),
            Some(left) => {
                self.budget.symbolic = left.checked_sub(cost);
                if self.budget.symbolic.is_some() {
                    return Ok(());
                }
                self.budget.symbolic = Some(0);
                Err(Stop::Undetermined)
            }
        }
    }

    /// Enters a nested expression; pair it with [`Evaluator::leave`].
    pub(super) fn enter(&mut self, span: Span) -> Outcome<()> {
        self.budget.depth += 1;
        if self.budget.depth <= DEEPEST {
            return Ok(());
        }
        if !self.budget.exhausted {
            self.budget.exhausted = true;
            let (open, calls) = (self.open.len(), self.budget.calls);
            let waiting = format!("more than {DEEPEST} expressions wait for each other");
            let (message, at, hint) = if open > MANY_OPEN {
                (
                    format!("values are nested too deeply: {waiting}, in {open} values"),
                    span,
                    "write each value before those that are made of it: then none has to wait",
                )
            } else {
                (
                    format!("calls are nested too deeply: {waiting}, in {calls} calls"),
                    self.calls.last().map_or(span, |call| call.span),
                    "a function that calls itself needs an end: `if n <= 0 then … else …`",
                )
            };
            self.report(Diagnostic::new(Code::E0703, at, message).label("given up here").hint(hint));
        }
        self.budget.depth -= 1;
        Err(Stop::Reported)
    }

    pub(super) fn leave(&mut self) {
        self.budget.depth = self.budget.depth.saturating_sub(1);
    }

    /// Enters a call, or a default of what is called; pair it with [`Evaluator::leave_call`].
    pub(super) fn enter_call(&mut self) {
        self.budget.calls += 1;
    }

    pub(super) fn leave_call(&mut self) {
        self.budget.calls = self.budget.calls.saturating_sub(1);
    }

    /// Refuses a text that is too long.
    pub(super) fn text_length(&mut self, bytes: usize, span: Span) -> Outcome<()> {
        if bytes <= MOST_ELEMENTS {
            return Ok(());
        }
        let message = format!("this text would be {bytes} bytes long; the limit is {MOST_ELEMENTS}");
        let diagnostic = Diagnostic::new(Code::E0704, span, message).label("too long");
        Err(self.report(diagnostic.hint("put fewer texts together, or shorter ones")))
    }

    /// Refuses a list that is too long.
    pub(super) fn length(&mut self, elements: usize, span: Span) -> Outcome<()> {
        if elements <= MOST_ELEMENTS {
            return Ok(());
        }
        let message = format!("this list has more than {MOST_ELEMENTS} elements");
        let diagnostic = Diagnostic::new(Code::E0704, span, message).label("too long");
        Err(self.report(diagnostic.hint("use shorter ranges")))
    }
}
