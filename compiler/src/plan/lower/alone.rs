//! One ifs by itself, as an editor asks for it where no figure uses it: nothing is reported and nothing is planned.

use super::Lowering;
use super::states::States;
use crate::hir::evaluate::{Evaluator, Overrides};
use crate::hir::tree::{Hir, ItemId, ItemKind};
use crate::hir::value::Instance;
use crate::ifs::{Automaton, StateId};

/// The automaton that an ifs leads to with the defaults of its parameters, and its state in it; `None` where a parameter
/// has no default or the ifs has errors.
pub fn alone(hir: &Hir, id: ItemId, overrides: &Overrides) -> Option<(Automaton, StateId)> {
    let ItemKind::Ifs(ifs) = &hir.item(id).kind else { return None };
    let mut evaluator = Evaluator::new(hir, overrides);
    let defaults = ifs.parameters.iter().map(|parameter| evaluator.body(parameter.default.as_ref()?).ok());
    let arguments = defaults.collect::<Option<Vec<_>>>()?;
    let mut lowering = Lowering {
        hir,
        evaluator: &mut evaluator,
        overrides,
        states: States::default(),
        diagnostics: Vec::new(),
        failed: false,
    };
    let state = lowering.state(&Instance { ifs: id, arguments })?;
    Some((lowering.automaton()?, state))
}
