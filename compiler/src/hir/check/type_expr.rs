//! Types as written, and types in words.

use super::Checker;
use super::scope::Symbol;
use crate::diagnostic::{Code, Diagnostic, closest};
use crate::hir::dimension::Dimension;
use crate::hir::tree::ItemKind;
use crate::hir::type_names::{PLAIN, type_name};
use crate::hir::types::Type;
use crate::syntax::ast;

impl Checker<'_> {
    pub(super) fn type_expr(&mut self, module: usize, ty: &ast::TypeExpr) -> Type {
        match &ty.kind {
            ast::TypeExprKind::Error => Type::Error,
            ast::TypeExprKind::List(element) => Type::List(Box::new(self.type_expr(module, element))),
            ast::TypeExprKind::Name(name) => self.named_type(module, name, ty),
        }
    }

    fn named_type(&mut self, module: usize, name: &str, ty: &ast::TypeExpr) -> Type {
        if let Some(dimension) = Dimension::named(name) {
            return Type::Quantity(dimension);
        }
        if let Some((_, plain)) = PLAIN.iter().find(|(known, _)| *known == name) {
            return plain.clone();
        }
        let symbol = self.symbol(module, name, ty.span);
        if symbol == Some(Symbol::Lost) {
            return Type::Error;
        }
        if let Some(Symbol::Item(id)) = symbol
            && matches!(self.declared[id.0 as usize].item.kind, ast::ItemKind::Record(_))
        {
            return Type::Record(id);
        }
        let records =
            self.modules[module].own.keys().copied().filter(|name| name.starts_with(char::is_uppercase));
        let library = self.modules.iter().filter(|scope| scope.is_library());
        let library = library.flat_map(|scope| scope.public.keys().copied());
        let library = library.filter(|name| name.starts_with(char::is_uppercase));
        let mut known: Vec<String> = Dimension::names().map(str::to_owned).collect();
        known.extend(PLAIN.iter().map(|(known, _)| (*known).to_owned()));
        known.extend(records.chain(library).map(str::to_owned));
        let message = format!("there is no type `{name}`");
        let mut diagnostic = Diagnostic::new(Code::E0409, ty.span, message).label("not a type");
        diagnostic = match closest(name, known.iter().map(String::as_str)) {
            Some(candidate) => {
                diagnostic.fix(format!("did you mean `{candidate}`?"), ty.span, candidate.to_owned())
            }
            None => diagnostic
                .hint("types are `Number`, `Length`, `Angle`, `Point`, `[Length]` and the like, or records"),
        };
        self.report(diagnostic);
        Type::Error
    }

    /// A value of a type in words, for messages: `a Length`, `a whole number`, `a list of Length`.
    pub(super) fn described(&self, ty: &Type) -> String {
        match ty {
            Type::Int => "a whole number".to_owned(),
            Type::Quantity(Dimension::NUMBER) => "a number without a unit".to_owned(),
            Type::Quantity(dimension) if !dimension.is_named() => {
                format!("a quantity in {}", dimension.name())
            }
            Type::Bool => "true or false".to_owned(),
            Type::Point(space) => space.thing("point"),
            Type::Vector(space) => space.thing("vector"),
            Type::Map(space) => space.thing("map"),
            Type::WeightedSum(space) => match space.things("point") {
                Some(points) => format!("a weighted sum of {points}"),
                None => "a weighted sum of points".to_owned(),
            },
            Type::Weighted(space) => space.thing("weighted point"),
            Type::List(element) => {
                let elements = things_of_space(element);
                format!("a list of {}", elements.unwrap_or_else(|| self.type_name(element)))
            }
            Type::Choice(_) => format!("one of {}", self.type_name(ty)),
            Type::Settings(_) => self.type_name(ty),
            _ => {
                let name = self.type_name(ty);
                let article = if name.starts_with(['A', 'E', 'I', 'O', 'U', 'a', 'e', 'i', 'o', 'u']) {
                    "an"
                } else {
                    "a"
                };
                format!("{article} {name}")
            }
        }
    }

    /// The name of a type as it is written, or would be.
    pub(super) fn type_name(&self, ty: &Type) -> String {
        type_name(&self.items, ty)
    }

    /// Whether a record can say what a board is made of: it has a thickness, or a density. What is told of a board that
    /// is made has a thickness too.
    pub(super) fn is_material(&mut self, ty: &Type) -> bool {
        let Type::Record(id) = ty else { return false };
        if self.modules[self.declared[id.0 as usize].module].name == "boards" {
            return false;
        }
        self.ensure_checked(*id, self.items[id.0 as usize].name_span);
        match &self.items[id.0 as usize].kind {
            ItemKind::Record(fields) => {
                fields.iter().any(|field| field.name == "thickness" && field.ty == Type::LENGTH)
                    || fields.iter().any(|field| field.name == "density")
            }
            _ => false,
        }
    }
}

/// Values of a type that has a space which is known, in words: `points in space`. By their names alone points of the plane and
/// of space are the same.
fn things_of_space(ty: &Type) -> Option<String> {
    match ty {
        Type::Point(space) => space.things("point"),
        Type::Vector(space) => space.things("vector"),
        Type::Map(space) => space.things("map"),
        Type::Weighted(space) => space.things("weighted point"),
        Type::WeightedSum(space) => space.things("point").map(|points| format!("weighted sums of {points}")),
        Type::List(element) => things_of_space(element).map(|elements| format!("lists of {elements}")),
        _ => None,
    }
}
