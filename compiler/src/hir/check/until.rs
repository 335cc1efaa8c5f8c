//! `… until edge <= 600mm`, `… each until size <= 20mm`.

use super::{Checker, Frame, error_expr};
use crate::diagnostic::{Code, Diagnostic, Fix, closest};
use crate::hir::index::Target;
use crate::hir::size::{SizeMeasure, UntilExpr};
use crate::hir::tree::{Expr, ExprKind, Limit};
use crate::hir::types::Type;
use crate::source::Span;
use crate::syntax::ast::{self, Comparison};

impl Checker<'_> {
    pub(super) fn until(
        &mut self,
        frame: &mut Frame,
        figure: Expr,
        each: bool,
        measure: &ast::Name,
        limit: &ast::Limit,
        span: Span,
    ) -> Expr {
        let known = self.size_measure(measure);
        let checked = match limit {
            ast::Limit::Compare(comparison, value) => {
                let value = self.expect(frame, value, &Type::LENGTH);
                Limit::Compare(*comparison, value)
            }
            ast::Limit::Within(range) => {
                let least = self.expect(frame, &range.from, &Type::LENGTH);
                Limit::Within(least, self.expect(frame, &range.to, &Type::LENGTH))
            }
        };
        let (at, wrong) = match &checked {
            Limit::Compare(_, value) => (measure.span.to(value.span), value.ty == Type::Error),
            Limit::Within(from, to) => {
                (measure.span.to(to.span), from.ty == Type::Error || to.ty == Type::Error)
            }
        };
        let bounded = self.bounds(each, measure, &checked, at);
        let Some(measure) = known.filter(|_| bounded && !wrong && figure.ty != Type::Error) else {
            return error_expr(span);
        };
        let ty = figure.ty.clone();
        let until = UntilExpr { each, measure, limit: checked, span: at };
        Expr { kind: ExprKind::Until(Box::new(figure), Box::new(until)), ty, span }
    }

    fn size_measure(&mut self, measure: &ast::Name) -> Option<SizeMeasure> {
        let known = SizeMeasure::named(&measure.text);
        if let Some(size) = known {
            self.refer(measure.span, Target::Size(size));
        }
        if known.is_none() {
            let message = format!("`{}` is nothing a level is found by", measure.text);
            let diagnostic =
                Diagnostic::new(Code::E0550, measure.span, message).label("not a size of an element");
            let words = SizeMeasure::ALL.map(SizeMeasure::word);
            let all = "a level is found by `edge`, `length` or `size`";
            self.report(match closest(&measure.text, words) {
                Some(near) => diagnostic.fix(format!("did you mean `{near}`?"), measure.span, near),
                None => diagnostic.hint(all),
            });
        }
        known
    }

    /// Whether a limit has the one bound a level is found by: a largest size.
    fn bounds(&mut self, each: bool, measure: &ast::Name, limit: &Limit, at: Span) -> bool {
        let at_most = |value: &Expr| {
            let sign = Span::new(at.file, measure.span.end, value.span.start);
            Fix::titled("ask for a largest size: `<=`").with(sign, " <= ")
        };
        let (message, label, hint, fixes) = match limit {
            Limit::Compare(Comparison::AtMost | Comparison::Less, _) => return true,
            Limit::Within(..) if !each => return true,
            Limit::Within(from, to) => (
                "a branch that stops on its own has no smallest size",
                "only a largest size",
                format!("write `each until {} <= …`", measure.text),
                vec![
                    Fix::titled("ask for a largest size alone: `<=`")
                        .with(Span::new(at.file, measure.span.end, from.span.end.max(to.span.start)), " <= "),
                ],
            ),
            Limit::Compare(_, value) => (
                "elements get smaller with every level: `until` needs a largest size",
                "no largest size",
                format!("write `until {} <= …`, or `in … .. …` for both ends", measure.text),
                vec![at_most(value)],
            ),
        };
        self.report(Diagnostic::new(Code::E0551, at, message).label(label).ways(hint, fixes));
        false
    }
}
