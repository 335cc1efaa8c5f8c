//! Parameters as symbols: what an ifs is checked with for all its parameters at once.

use super::instance::Parts;
use super::{Evaluator, Outcome, Stop};
use crate::exact::{Rational, RationalFunction};
use crate::hir::scalar::Scalar;
use crate::hir::tree::{Ifs, ItemId, ItemKind};
use crate::hir::types::Type;
use crate::hir::value::{Instance, Terms, Value};
use crate::source::Span;

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

/// A `let` of an ifs that is a sum of its control points, for all values of its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct SymbolicSum {
    /// Where its value stands.
    pub value: Span,
    /// A point where its weights sum to 1, a vector where they sum to 0; none else.
    pub ty: Option<Type>,
    /// Its weights: `1/2 a + 1/2 b`.
    pub weights: String,
}

impl Evaluator<'_> {
    /// Those of the `let` of an ifs that are sums of its control points; a report leaves one out.
    pub fn symbolic_sums(&mut self, id: ItemId) -> Vec<SymbolicSum> {
        let hir = self.hir;
        let ItemKind::Ifs(ifs) = &hir.item(id).kind else { return Vec::new() };
        self.atoms.clear();
        let Ok(arguments) = self.symbolic_arguments(ifs) else { return Vec::new() };
        self.begin_symbolic();
        let values = self.lets(&Instance { ifs: id, arguments }, ifs);
        self.end_symbolic();
        let sums = ifs.lets.iter().zip(values.unwrap_or_default()).filter_map(|((_, expr), value)| {
            let Ok(Value::Combination(sum)) = value else { return None };
            let Terms::Weights(weights) = &sum.terms else { return None };
            let ty = match sum.weight.to_rational() {
                Some(weight) if weight == Rational::ONE => Some(Type::Point(ifs.space)),
                Some(weight) if weight == Rational::ZERO => Some(Type::Vector(ifs.space)),
                _ => None,
            };
            Some(SymbolicSum { value: expr.span, ty, weights: self.weights_words(weights) })
        });
        sums.collect()
    }

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
