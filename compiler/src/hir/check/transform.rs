//! A transform of an ifs: what it continues with, and where. Families of them.

use super::{Checker, Frame, error_expr};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::index::DeclarationKind;
use crate::hir::tree::{Expr, ExprKind, Ifs, Image, ItemId, Transform};
use crate::hir::types::{PointSpace, Type};
use crate::source::Span;
use crate::syntax::ast;

impl Checker<'_> {
    pub(super) fn transform(&mut self, frame: &mut Frame, typed: &mut Ifs, transform: &ast::Transform) {
        if let Some(first) = typed.transforms.iter().find(|other| other.name == transform.name.text) {
            let message = format!("the transform `{}` is declared twice", transform.name.text);
            let diagnostic =
                Diagnostic::new(Code::E0302, transform.name.span, message).label("declared again here");
            self.report(diagnostic.also(first.name_span, "first declared here"));
        }
        if let Some(id) = frame.own_ifs {
            self.note(&transform.name, DeclarationKind::Transform(id), Type::Error, None);
        }
        let outer = frame.locals.len();
        let family = transform.family.as_ref().map(|(name, over)| {
            let over = self.expr(frame, over, None);
            let ty = self.iterated(&over, "a family");
            (self.declare(frame, name, ty, DeclarationKind::Running, transform.value.span), over)
        });
        let image = self.image(frame, typed, &transform.value);
        frame.locals.truncate(outer);
        if let Some(image) = image {
            let (name, name_span) = (transform.name.text.clone(), transform.name.span);
            typed.transforms.push(Transform { name, name_span, family, image });
        }
    }

    fn image(&mut self, frame: &mut Frame, typed: &Ifs, value: &ast::Expr) -> Option<Image> {
        stacker::maybe_grow(128 * 1024, 1024 * 1024, || match &value.kind {
            ast::ExprKind::Error => None,
            ast::ExprKind::Group(inner) => self.image(frame, typed, inner),
            ast::ExprKind::On(target, placement) => {
                self.image_on_points(frame, typed, value.span, (target, placement))
            }
            ast::ExprKind::If(condition, yes, no) => {
                let condition = self.expect(frame, condition, &Type::Bool);
                let (yes, no) = (self.image(frame, typed, yes), self.image(frame, typed, no));
                Some(Image::If(condition, Box::new(yes?), Box::new(no?)))
            }
            _ if typed.space == PointSpace::Control => {
                self.not_placed(frame, value);
                None
            }
            _ => self.mapped(frame, typed, value),
        })
    }

    fn image_on_points(
        &mut self,
        frame: &mut Frame,
        typed: &Ifs,
        span: Span,
        (target, placement): (&ast::Expr, &ast::Placement),
    ) -> Option<Image> {
        let target = self.expect(frame, target, &Type::Ifs);
        let points_span = match placement {
            ast::Placement::Points(_, span) => span,
            ast::Placement::Value(list) => &list.span,
        };
        if self.refuse_points(&target, *points_span) {
            return None;
        }
        let image = Type::Point(typed.space);
        let points = match placement {
            ast::Placement::Points(points, _) => points,
            ast::Placement::Value(list) => {
                let list = self.expect(frame, list, &Type::List(Box::new(image)));
                return Some(Image::Points { target, points: vec![list], span: *points_span });
            }
        };
        let points: Vec<Expr> = points.iter().map(|point| self.expect(frame, point, &image)).collect();
        let typed_points = points.iter().all(|point| point.ty != Type::Error);
        if typed_points && !self.count_images(typed, &target, points.len(), *points_span) {
            return Some(Image::Mapped(error_expr(span)));
        }
        Some(Image::Points { target, points, span: *points_span })
    }

    fn not_placed(&mut self, frame: &mut Frame, value: &ast::Expr) {
        let checked = self.expr(frame, value, Some(&Type::Ifs));
        if checked.ty == Type::Error {
            return;
        }
        let message = "a transform of an ifs on control points says where they go";
        let diagnostic = Diagnostic::new(Code::E0503, value.span, message).label("no list of points");
        self.report(diagnostic.hint("write `self on (p, q, …)`, one image for each control point"));
    }

    fn mapped(&mut self, frame: &mut Frame, typed: &Ifs, value: &ast::Expr) -> Option<Image> {
        let checked = self.expr(frame, value, Some(&Type::Ifs));
        match &checked.ty {
            Type::Error => return Some(Image::Mapped(error_expr(value.span))),
            Type::Ifs => {}
            other => {
                let is = self.described(other);
                let message = "a transform is a map times the ifs it continues with";
                let diagnostic = Diagnostic::new(Code::E0537, value.span, message).label(is);
                self.report(match other {
                    Type::Map(_) => diagnostic.fix(
                        "continue with this ifs: end with `* self`",
                        value.span.after(),
                        " * self",
                    ),
                    _ => diagnostic.hint("write `scale(1/2) * self`, or `other on (p, q, …)`"),
                });
                return None;
            }
        }
        match self.ifs_space(&checked) {
            Some(space) if space != typed.space => {
                self.other_space(typed.space, space, checked.span);
                None
            }
            _ => Some(Image::Mapped(checked)),
        }
    }

    fn other_space(&mut self, own: PointSpace, other: PointSpace, at: Span) {
        let (own, is) = (own.words(), other.words());
        let message = format!("an ifs {own} cannot continue with one {is} in this way");
        let diagnostic = Diagnostic::new(Code::E0531, at, message).label(format!("an ifs {is}"));
        self.report(match other {
            PointSpace::Control => diagnostic.hint("say where its control points go: `other on (p, q, …)`"),
            _ => diagnostic.hint("let both live in the plane, or both in space"),
        });
    }

    /// Whether an ifs has no control points to be placed on; then that has been said.
    pub(super) fn refuse_points(&mut self, ifs: &Expr, at: Span) -> bool {
        let space = self.ifs_space(ifs);
        let Some(space @ (PointSpace::Plane | PointSpace::Space)) = space else { return false };
        let message = format!("an ifs {} has no control points to be placed on", space.words());
        let diagnostic = Diagnostic::new(Code::E0531, at, message).label("no place for points");
        self.report(diagnostic.also(ifs.span, format!("lives {}", space.words())).hint(
            "it is placed by a map, `translate(…) * name at level 4`, or where it is; other ifs `in plane` and `in space` \
             continue with it by a map too",
        ));
        true
    }

    /// The space of an ifs, as far as it is known before evaluation.
    pub(super) fn ifs_space(&self, ifs: &Expr) -> Option<PointSpace> {
        match &ifs.kind {
            ExprKind::Ifs(id, _) => self.space_of(*id),
            ExprKind::SelfIfs(id) => self.space_of(*id),
            ExprKind::Arithmetic(_, _, _, right) => self.ifs_space(right),
            ExprKind::Convert(inner) => self.ifs_space(inner),
            ExprKind::If(_, yes, no) => {
                let (yes, no) = (self.ifs_space(yes)?, self.ifs_space(no)?);
                (yes == no).then_some(yes)
            }
            _ => None,
        }
    }

    pub(super) fn space_of(&self, id: ItemId) -> Option<PointSpace> {
        match &self.declared.get(id.0 as usize)?.item.kind {
            ast::ItemKind::Ifs(ifs) => Some(match ifs.space {
                ast::Space::On(..) => PointSpace::Control,
                ast::Space::Plane(_) => PointSpace::Plane,
                ast::Space::Space(_) => PointSpace::Space,
            }),
            _ => None,
        }
    }

    /// The space of the ifs around.
    pub(super) fn own_space(&self, frame: &Frame) -> Option<PointSpace> {
        frame.own_ifs.and_then(|id| self.space_of(id))
    }
}
