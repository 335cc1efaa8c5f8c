//! Parameters as symbols: what an ifs is checked with for all its parameters at once.

use super::instance::Parts;
use super::{Evaluator, Outcome, Stop};
use crate::exact::RationalFunction;
use crate::hir::scalar::Scalar;
use crate::hir::tree::{Ifs, ItemId, ItemKind};
use crate::hir::types::Type;
use crate::hir::value::{Instance, Value};

/// A transform of an ifs for all values of its parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SymbolicTransform {
    /// Its name.
    pub name: String,
    /// The name of the ifs that it continues with.
    pub target: String,
    /// One row of weights an image, as functions of the parameters: `1 - t`.
    pub rows: Vec<Vec<String>>,
}

impl Evaluator<'_> {
    /// Checks the weights of an ifs for all values of its parameters, as rational functions of them.
    ///
    /// What depends on more than arithmetic (a condition, a count) is left to each instance.
    pub fn check_symbolically(&mut self, id: ItemId) {
        // Whatever it finds is reported; what it cannot know here is found at each instance.
        let _ = self.symbolic_parts(id);
    }

    /// The transforms of an ifs for all values of its parameters; `None` where they depend on more than arithmetic, or
    /// after a report.
    pub fn symbolic_transforms(&mut self, id: ItemId) -> Option<Vec<SymbolicTransform>> {
        let ItemKind::Ifs(ifs) = &self.hir.item(id).kind else { return None };
        let parts = self.symbolic_parts(id).ok()?;
        let words = |row: &Vec<Scalar>| row.iter().map(|weight| self.scalar_words(weight)).collect();
        let transforms = parts.pieces.iter().map(|piece| SymbolicTransform {
            name: piece.name(ifs),
            target: self.hir.item(piece.target.ifs).name.clone(),
            rows: piece.rows.iter().map(words).collect(),
        });
        Some(transforms.collect())
    }

    fn symbolic_parts(&mut self, id: ItemId) -> Outcome<Parts> {
        let hir = self.hir;
        let ItemKind::Ifs(ifs) = &hir.item(id).kind else { return Err(Stop::Reported) };
        self.atoms.clear();
        let arguments = self.symbolic_arguments(ifs)?;
        self.begin_symbolic();
        let parts = self.parts(&Instance { ifs: id, arguments }, ifs);
        self.end_symbolic();
        parts
    }

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
