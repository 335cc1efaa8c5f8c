//! Tests: their lines, and what they may ask of the figures of the design.

use super::{Checker, Frame, error_expr};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::index::{DeclarationKind, Target};
use crate::hir::tree::{Expr, ExprKind, ItemId, Made, Test, TestStep};
use crate::hir::types::Type;
use crate::source::Span;
use crate::syntax::ast;

fn step_end(step: &ast::TestStep) -> u32 {
    match step {
        ast::TestStep::Let(value) => value.value.span.end,
        ast::TestStep::Assert(_, span) | ast::TestStep::Error(span) => span.end,
    }
}

impl Checker<'_> {
    /// Checks a test of the design's own file.
    pub(super) fn test(&mut self, test: &ast::Test) {
        let mut frame = Frame::new(0);
        frame.test = true;
        let mut steps = Vec::new();
        for step in &test.steps {
            match step {
                ast::TestStep::Let(value) => {
                    let expected = value.ty.as_ref().map(|ty| self.type_expr(0, ty));
                    let expr = match &expected {
                        Some(expected) => self.expect(&mut frame, &value.value, expected),
                        None => self.expr(&mut frame, &value.value, None),
                    };
                    if let Some(first) = frame.locals.iter().find(|local| local.name == value.name.text) {
                        let message = format!("`{}` is declared twice", value.name.text);
                        let diagnostic = Diagnostic::new(Code::E0302, value.name.span, message)
                            .label("declared again here")
                            .also(first.span, "first declared here");
                        self.report(diagnostic.hint("give one of them another name"));
                    }
                    let ty = expected.unwrap_or_else(|| expr.ty.clone());
                    let end = test.steps.last().map_or(value.value.span.end, step_end);
                    let scope = Span::new(value.name.span.file, value.value.span.end, end);
                    let slot = self.declare(&mut frame, &value.name, ty, DeclarationKind::Local, scope);
                    steps.push(TestStep::Let(slot, expr));
                }
                ast::TestStep::Assert(value, span) => {
                    let truth = self.expect(&mut frame, value, &Type::Bool);
                    steps.push(TestStep::Assert(truth, *span));
                }
                ast::TestStep::Error(_) => {}
            }
        }
        let (name, name_span) = (test.name.value.clone(), test.name.span);
        self.tests.push(Test { name, name_span, steps, slots: frame.slots });
    }

    /// `shell.boards` and the like; `None` where `base` is no figure or has no such thing.
    pub(super) fn made(&mut self, frame: &Frame, base: &Expr, name: &ast::Name, span: Span) -> Option<Expr> {
        let figure = match &base.ty {
            Type::List(element) => element.is_figure(),
            ty => ty.is_figure(),
        };
        let known = Made::ALL.into_iter().find(|(known, _, _)| *known == name.text);
        let (_, made, _) = known.filter(|_| figure)?;
        let item = match base.kind {
            ExprKind::Global(id) if self.is_figure_item(id) => id,
            _ => {
                let message = format!("`{}` is known only of a figure of the design", name.text);
                let diagnostic = Diagnostic::new(Code::E1002, base.span, message);
                let diagnostic = diagnostic.label("not a name declared with `figure`");
                self.report(diagnostic.hint("declare it: `figure … = …`, and ask that one"));
                return Some(error_expr(span));
            }
        };
        if !frame.test {
            let message = format!("`{}` is known only in a test", name.text);
            let diagnostic = Diagnostic::new(Code::E1002, name.span, message);
            let diagnostic = diagnostic.label("not known while the design is worked out");
            self.report(diagnostic.hint("write it in a test: `test \"…\" { assert … }`"));
            return Some(error_expr(span));
        }
        self.refer(name.span, Target::Made(made));
        let ty = match made {
            Made::Elements | Made::Vertices => self.planned(item, name, base.span)?,
            Made::Boards => self.board_type(item, base.span)?,
        };
        Some(Expr {
            kind: if ty == Type::Error { ExprKind::Error } else { ExprKind::Made(item, made) },
            ty,
            span,
        })
    }

    fn is_figure_item(&self, id: ItemId) -> bool {
        matches!(self.declared[id.0 as usize].item.kind, ast::ItemKind::Figure(_))
    }

    /// A count of a figure that is worked out: the design's own, and those it makes boards of.
    fn planned(&mut self, figure: ItemId, name: &ast::Name, at: Span) -> Option<Type> {
        if self.declared[figure.0 as usize].module == 0 || self.block_of(figure).is_some() {
            return Some(Type::Int);
        }
        let message = format!("`{}` is known only of a figure of this file", name.text);
        let diagnostic = Diagnostic::new(Code::E1002, at, message).label("a figure of another file");
        self.report(diagnostic.hint("write the test in the file that declares the figure"));
        Some(Type::Error)
    }

    /// The type of a figure's boards: a list of the library's records.
    fn board_type(&mut self, figure: ItemId, at: Span) -> Option<Type> {
        let record = match self.block_of(figure) {
            Some(block) if block.kind.text == "planks" => "Plank",
            Some(_) => "Board",
            None => {
                let name = self.items[figure.0 as usize].name.clone();
                let message = format!("`{name}` has no boards: no `fabricate` block makes them");
                let diagnostic = Diagnostic::new(Code::E1002, at, message).label("not fabricated");
                let hint = format!("add `fabricate {name} as panels {{ … }}`, or `as planks`");
                self.report(diagnostic.hint(hint));
                return Some(Type::Error);
            }
        };
        let module = self.modules.iter().find(|module| module.name == "boards")?;
        let id = module.own.get(record).copied()?;
        self.ensure_checked(id, at);
        Some(Type::List(Box::new(Type::Record(id))))
    }

    /// The block of the design that makes boards of a figure.
    fn block_of(&self, figure: ItemId) -> Option<&ast::Fabricate> {
        let name = self.items[figure.0 as usize].name.as_str();
        let root = &self.modules[0];
        let known = root.own.get(name) == Some(&figure)
            || root
                .imports
                .get(name)
                .is_some_and(|import| import.symbol == super::scope::Symbol::Item(figure));
        let blocks = root.ast.items.iter().filter_map(|item| match &item.kind {
            ast::ItemKind::Fabricate(block) => Some(block),
            _ => None,
        });
        blocks.into_iter().find(|block| known && block.figure.text == name)
    }
}
