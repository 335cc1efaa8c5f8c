//! Calls of the functions of the program, and what they give.

use super::fields::Callee;
use super::items::Parameter;
use super::{Checker, Frame, error_expr};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::native::{Native, NativeParameter, Takes};
use crate::hir::tree::{Expr, ExprKind};
use crate::hir::types::{PointSpace, Type};
use crate::source::Span;
use crate::syntax::ast;

impl Checker<'_> {
    pub(super) fn native(
        &mut self,
        frame: &mut Frame,
        native: Native,
        arguments: &[ast::Argument],
        at: Span,
        span: Span,
    ) -> Expr {
        if native == Native::Polygon {
            return self.polygon(frame, arguments, at, span);
        }
        if native == Native::Import {
            return self.import_mesh(frame, arguments, at, span);
        }
        self.native_by_parameters(frame, native, arguments, at, span)
    }

    pub(super) fn native_by_parameters(
        &mut self,
        frame: &mut Frame,
        native: Native,
        arguments: &[ast::Argument],
        at: Span,
        span: Span,
    ) -> Expr {
        let declaration = native.declaration();
        let parameters: Vec<Parameter> = declaration
            .parameters
            .iter()
            .map(|parameter| Parameter {
                name: parameter.name.to_owned(),
                ty: match parameter.takes {
                    // One length alone is no movement: one argument is a vector.
                    Takes::LengthOrVector if arguments.len() == 1 => Type::Vector(PointSpace::Any),
                    takes => takes.expected().unwrap_or(Type::Error),
                },
                required: parameter.required,
            })
            .collect();
        let bound = self.bind(frame, Callee::Native(native), &parameters, arguments, at);
        let complete = bound.iter().zip(declaration.parameters).all(|(value, takes)| match value {
            Some(value) => self.takes(declaration.name, value, takes),
            None => !takes.required,
        });
        let complete = complete && !self.has_gap(native, &bound, at);
        let values: Vec<Expr> = bound.into_iter().flatten().collect();
        if !complete || values.iter().any(|value| value.ty == Type::Error) {
            return error_expr(span);
        }
        let ty = match native {
            Native::Translate
            | Native::Rotate
            | Native::Turn
            | Native::Scale
            | Native::Mirror
            | Native::Affine => self.map_type(native, &values, at),
            Native::Point
            | Native::Segment
            | Native::Polygon
            | Native::Quad
            | Native::Strut
            | Native::Mesh
            | Native::Import => self.germ_type(frame, &values),
            _ => self.native_type(native, &values),
        };
        match ty {
            Some(ty) => Expr { kind: ExprKind::Native(native, values), ty, span },
            None => error_expr(span),
        }
    }

    /// Whether a number is left out before another one that is given by name.
    fn has_gap(&mut self, native: Native, bound: &[Option<Expr>], at: Span) -> bool {
        let parameters = native.declaration().parameters;
        let missing = bound.windows(2).position(|pair| matches!(pair, [None, Some(_)]));
        let Some(missing) = missing.filter(|place| parameters[*place].takes == parameters[*place + 1].takes)
        else {
            return false;
        };
        let (name, next) = (parameters[missing].name, parameters[missing + 1].name);
        let what = native.declaration().name;
        let message = format!("`{what}` needs `{name}` where `{next}` is given");
        self.report(Diagnostic::new(Code::E0403, at, message).label(format!("no `{name}`")));
        true
    }

    fn takes(&mut self, native: &str, value: &Expr, parameter: &NativeParameter) -> bool {
        let list_of_numbers = match &value.ty {
            Type::List(element) => element.dimension().is_some() || **element == Type::Error,
            _ => false,
        };
        let list_of_vectors = matches!(&value.ty, Type::List(element) if element.point_space().is_some());
        let fits = value.ty == Type::Error
            || match parameter.takes {
                Takes::Quantity => value.ty.dimension().is_some(),
                Takes::QuantityOrList => value.ty.dimension().is_some() || list_of_numbers,
                Takes::Quantities => list_of_numbers,
                Takes::Summands => list_of_numbers || list_of_vectors,
                Takes::List => matches!(value.ty, Type::List(_)),
                Takes::Lists => {
                    matches!(&value.ty, Type::List(inner) if matches!(**inner, Type::List(_) | Type::Error))
                }
                Takes::Plain => value.ty.dimension().is_some() || matches!(value.ty, Type::Bool | Type::Text),
                _ => true,
            };
        if !fits {
            let wanted = match parameter.takes {
                Takes::Quantity => "a number",
                Takes::QuantityOrList => "a number or a list of numbers",
                Takes::Quantities => "a list of numbers",
                Takes::Summands => "a list of numbers, points or vectors",
                Takes::Lists => "a list of lists",
                Takes::Plain => "a number, a truth or a text",
                _ => "a list",
            };
            let is = self.described(&value.ty);
            let message = format!("`{native}` takes {wanted}, but this is {is}");
            self.report(Diagnostic::new(Code::E0401, value.span, message).label(is));
        }
        fits
    }

    fn native_type(&mut self, native: Native, values: &[Expr]) -> Option<Type> {
        let first = &values.first()?.ty;
        Some(match native {
            Native::Sin | Native::Cos | Native::Tan => Type::NUMBER,
            Native::Floor | Native::Round | Native::Len => Type::Int,
            Native::Abs => first.clone(),
            Native::Sum => match element(first)? {
                Type::Point(space) => Type::WeightedSum(space),
                other => other,
            },
            Native::Mean => Type::Quantity(element(first)?.dimension()?),
            Native::All | Native::Any => Type::Bool,
            Native::Close => return self.closeness(values),
            Native::Sqrt => return self.root(&values[0]),
            Native::Min | Native::Max => return self.extreme(native, values),
            Native::Lerp => {
                let space = values[0].ty.point_space()?.join(values[1].ty.point_space()?);
                match space {
                    Some(space) => Type::Point(space),
                    None => {
                        let message = "`lerp` needs two points of one space";
                        let diagnostic = Diagnostic::new(Code::E0402, values[1].span, message);
                        self.report(diagnostic.label("of another space").also(values[0].span, "this one"));
                        return None;
                    }
                }
            }
            Native::Interpolate => {
                if *first != Type::LENGTH {
                    let is = self.described(first);
                    let message = format!("`interpolate` looks up a Length, but this is {is}");
                    self.report(Diagnostic::new(Code::E0401, values[0].span, message).label(is));
                    return None;
                }
                Type::LENGTH
            }
            Native::Tensor => Type::Ifs,
            Native::Sheet => Type::Figure,
            Native::Chain => Type::Curve,
            Native::Plane => Type::Plane,
            Native::Cut => Type::Cut,
            Native::Weighted => return self.weighted(&values[0]),
            Native::Translation
            | Native::ScaleTranslation
            | Native::ProjectiveSum
            | Native::Revolution
            | Native::Extrusion => Type::Surface,
            _ => return self.value_type(native, values),
        })
    }

    /// `close(a, b, within)`: three numbers of one dimension.
    fn closeness(&mut self, values: &[Expr]) -> Option<Type> {
        let first = values.first()?;
        let other = values.iter().find(|value| value.ty.dimension() != first.ty.dimension());
        let Some(other) = other else { return Some(Type::Bool) };
        let (a, b) = (self.described(&first.ty), self.described(&other.ty));
        let message = format!("`close` does not fit {a} and {b}");
        let diagnostic = Diagnostic::new(Code::E0402, other.span, message).label(b).also(first.span, a);
        self.report(diagnostic.hint("it takes three numbers of one dimension: `close(a, 2m, 1mm)`"));
        None
    }

    fn weighted(&mut self, point: &Expr) -> Option<Type> {
        match &point.ty {
            Type::Point(PointSpace::Control) => {
                let message = "the points of an ifs have no weights of their own";
                let diagnostic =
                    Diagnostic::new(Code::E0402, point.span, message).label("a point of the ifs");
                let hint = "give weights where the ifs is placed: `… on (weighted(p, w: 2), …)`";
                self.report(diagnostic.hint(hint));
                None
            }
            Type::Point(space) => Some(Type::Weighted(*space)),
            _ => Some(Type::Weighted(PointSpace::Any)),
        }
    }

    fn root(&mut self, value: &Expr) -> Option<Type> {
        let dimension = value.ty.dimension()?;
        if let Some(root) = dimension.root() {
            return Some(Type::Quantity(root));
        }
        let is = self.described(&value.ty);
        let message = format!("there is no square root of {is}");
        let diagnostic = Diagnostic::new(Code::E0402, value.span, message).label(is);
        self.report(diagnostic.hint("the square root of an area is a length: `sqrt(a * a + b * b)`"));
        None
    }

    fn extreme(&mut self, native: Native, values: &[Expr]) -> Option<Type> {
        let name = native.declaration().name;
        match values {
            [list] => match element(&list.ty) {
                Some(ty) => Some(ty),
                None => {
                    let message = format!("`{name}` needs two numbers, or a list of numbers");
                    self.report(Diagnostic::new(Code::E0403, list.span, message).label("one number only"));
                    None
                }
            },
            [a, b] => {
                let ty = a.ty.join(&b.ty).filter(|ty| ty.dimension().is_some());
                if ty.is_none() {
                    let (first, second) = (self.described(&a.ty), self.described(&b.ty));
                    let message = format!("`{name}` does not fit {first} and {second}");
                    let diagnostic =
                        Diagnostic::new(Code::E0402, b.span, message).label(second).also(a.span, first);
                    self.report(
                        diagnostic.hint("it takes two numbers of one dimension, or one list of them"),
                    );
                }
                ty
            }
            _ => None,
        }
    }
}

fn element(ty: &Type) -> Option<Type> {
    match ty {
        Type::List(element) => Some((**element).clone()),
        _ => None,
    }
}
