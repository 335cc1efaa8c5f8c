//! Arguments put in the places of parameters: by position, by name, by default.

use super::items::Parameter;
use super::units::placeholder;
use super::{Checker, Frame};
use crate::diagnostic::{Code, Diagnostic, Fix, closest};
use crate::hir::index::Target;
use crate::hir::native::Native;
use crate::hir::tree::{Expr, ItemId};
use crate::hir::types::Type;
use crate::source::Span;
use crate::syntax::ast;

/// What is called.
#[derive(Clone, Copy)]
pub(super) enum Callee<'n> {
    /// An item, with its name.
    Item(ItemId, &'n str),
    /// A function of the program.
    Native(Native),
}

impl<'n> Callee<'n> {
    fn name(self) -> &'n str {
        match self {
            Callee::Item(_, name) => name,
            Callee::Native(native) => native.declaration().name,
        }
    }
}

impl Checker<'_> {
    /// The argument of each parameter; `None` where its default serves, or where it is missing (then reported).
    ///
    /// `at` is where the callee stands.
    pub(super) fn bind(
        &mut self,
        frame: &mut Frame,
        callee: Callee<'_>,
        parameters: &[Parameter],
        arguments: &[ast::Argument],
        at: Span,
    ) -> Vec<Option<Expr>> {
        let what = callee.name();
        let mut places: Vec<Option<&ast::Argument>> = vec![None; parameters.len()];
        let mut next = 0;
        let mut misnamed = false;
        for argument in arguments {
            let Some(place) = self.place(what, parameters, argument, &mut next) else {
                misnamed |= argument.name.is_some();
                self.expr(frame, &argument.value, None);
                continue;
            };
            if let Some(earlier) = places[place] {
                let message = format!("`{}` of `{what}` is given twice", parameters[place].name);
                let diagnostic =
                    Diagnostic::new(Code::E0405, argument_span(argument), message).label("given again");
                self.report(
                    diagnostic.also(argument_span(earlier), "first given here").hint("remove one of them"),
                );
                continue;
            }
            if let Some(name) = &argument.name {
                match callee {
                    Callee::Item(id, _) => self.refer_field(name.span, id, place),
                    Callee::Native(native) => self.refer(name.span, Target::NativeParameter(native, place)),
                }
            }
            places[place] = Some(argument);
        }
        let missing: Vec<&Parameter> = parameters
            .iter()
            .zip(&places)
            .filter(|(parameter, place)| parameter.required && place.is_none())
            .map(|(parameter, _)| parameter)
            .collect();
        // A name that is not known is most likely the missing one: one mistake.
        if !missing.is_empty() && !misnamed {
            self.missing(what, &missing, at, arguments.last().map(argument_span));
        }
        let bound = parameters.iter().zip(places);
        bound
            .map(|(parameter, place)| {
                place.map(|argument| self.expect(frame, &argument.value, &parameter.ty))
            })
            .collect()
    }

    /// `last` is the last argument there is.
    fn missing(&mut self, what: &str, missing: &[&Parameter], at: Span, last: Option<Span>) {
        let names: Vec<String> = missing.iter().map(|parameter| format!("`{}`", parameter.name)).collect();
        let examples: Vec<String> = missing
            .iter()
            .map(|parameter| match &parameter.ty {
                Type::Error => format!("`{}: …`", parameter.name),
                ty => format!("`{}: …`, {}", parameter.name, self.described(ty)),
            })
            .collect();
        let message = format!("`{what}` needs {}", names.join(" and "));
        let label = format!("no {}", names.join(", no "));
        let diagnostic = Diagnostic::new(Code::E0403, at, message).label(label);
        let given: Option<Vec<String>> = missing
            .iter()
            .map(|parameter| Some(format!("{}: {}", parameter.name, placeholder(&parameter.ty)?)))
            .collect();
        let fix = given.zip(last).map(|(given, last)| {
            let given = given.join(", ");
            Fix::titled(format!("add `{given}`")).with(last.after(), format!(", {given}"))
        });
        self.report(diagnostic.ways(format!("add {}", examples.join(", and ")), fix.into_iter().collect()));
    }

    fn place(
        &mut self,
        what: &str,
        parameters: &[Parameter],
        argument: &ast::Argument,
        next: &mut usize,
    ) -> Option<usize> {
        let Some(name) = &argument.name else {
            let place = *next;
            *next += 1;
            if place < parameters.len() {
                return Some(place);
            }
            let count = match parameters.len() {
                0 => "no arguments".to_owned(),
                1 => "one argument".to_owned(),
                n => format!("{n} arguments"),
            };
            let message = format!("`{what}` takes {count}");
            // However many there are, they are one mistake.
            if place == parameters.len() {
                let mut diagnostic =
                    Diagnostic::new(Code::E0406, argument.value.span, message).label("too many");
                if !parameters.is_empty() {
                    let names: Vec<&str> =
                        parameters.iter().map(|parameter| parameter.name.as_str()).collect();
                    diagnostic = diagnostic.note(format!("it takes {}", names.join(", ")));
                }
                self.report(diagnostic);
            }
            return None;
        };
        if let Some(place) = parameters.iter().position(|parameter| parameter.name == name.text) {
            return Some(place);
        }
        let known: Vec<&str> = parameters.iter().map(|parameter| parameter.name.as_str()).collect();
        let message = format!("`{what}` has no `{}`", name.text);
        let mut diagnostic = Diagnostic::new(Code::E0404, name.span, message).label("not known here");
        diagnostic = match closest(&name.text, known.iter().copied()) {
            Some(candidate) => diagnostic.fix(format!("did you mean `{candidate}`?"), name.span, candidate),
            None if known.is_empty() => diagnostic.hint("it takes no arguments"),
            None => diagnostic.note(format!("it takes {}", known.join(", "))),
        };
        self.report(diagnostic);
        None
    }
}

fn argument_span(argument: &ast::Argument) -> Span {
    argument.name.as_ref().map_or(argument.value.span, |name| name.span.to(argument.value.span))
}
