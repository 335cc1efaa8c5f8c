//! Parameters as symbols: what an ifs is checked with for all its parameters at once.

use super::{Evaluator, Outcome, Stop};
use crate::exact::RationalFunction;
use crate::hir::scalar::Scalar;
use crate::hir::tree::Ifs;
use crate::hir::types::Type;
use crate::hir::value::Value;

impl Evaluator<'_> {
    /// A symbol for every number an ifs takes, the default for anything else.
    pub(super) fn symbolic_arguments(&mut self, ifs: &Ifs) -> Outcome<Vec<Value>> {
        let mut arguments = Vec::new();
        for parameter in &ifs.parameters {
            let value = match (&parameter.ty, &parameter.default) {
                (Type::Quantity(_), _) => {
                    let atom = self.atom(parameter.name.clone());
                    Value::Scalar(Scalar::Symbolic(RationalFunction::from_atom(atom)))
                }
                (_, Some(default)) => self.body(default)?,
                _ => return Err(Stop::Undetermined),
            };
            arguments.push(value);
        }
        Ok(arguments)
    }

    /// A function of symbols that is no rational function of them: a symbol of its own, the same for the same argument.
    pub(super) fn opaque(&mut self, function: &str, argument: &Scalar) -> Scalar {
        let name = format!("{function}({})", self.scalar_words(argument));
        let atom = self.atom(name);
        Scalar::Symbolic(RationalFunction::from_atom(atom))
    }
}
