//! An ifs: its control points, named points, transforms and germ.

use super::{Checker, Frame};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::tree::{Expr, ExprKind, Ifs, ItemId, ItemKind, Transform};
use crate::hir::types::{PointSpace, Type};
use crate::source::Span;
use crate::syntax::ast;

impl Checker<'_> {
    pub(super) fn ifs(&mut self, id: ItemId, module: usize, ifs: &ast::Ifs) -> ItemKind {
        let parameters = self.fields(id, module, &ifs.parameters);
        let ast::Space::On(points, points_span) = &ifs.space else {
            return self.later_space(&ifs.space);
        };
        let mut frame = Frame::new(module);
        frame.own_ifs = Some(id);
        for (field, parameter) in ifs.parameters.iter().zip(&parameters) {
            frame.declare(&field.name, parameter.ty.clone());
        }
        for point in points {
            self.refuse_twice(&frame, point);
            frame.declare(point, Type::Point(PointSpace::Control));
        }
        let mut typed = Ifs {
            parameters,
            control_points: points.iter().map(|point| point.text.clone()).collect(),
            lets: Vec::new(),
            transforms: Vec::new(),
            germ: None,
            keep: Vec::new(),
            boundaries: Vec::new(),
            joins: Vec::new(),
            slots: 0,
        };
        if points.is_empty() {
            let message = "an ifs needs at least one control point";
            self.report(Diagnostic::new(Code::E0507, *points_span, message).label("no control points"));
        }
        // Its own control points must be known to the `on` of its own transforms.
        self.items[id.0 as usize].kind = ItemKind::Ifs(typed.clone());
        for member in &ifs.members {
            self.member(&mut frame, &mut typed, member);
        }
        self.joins_name_parts(ifs, &typed);
        self.complete(ifs, &typed);
        typed.slots = frame.slots;
        ItemKind::Ifs(typed)
    }

    fn later_space(&mut self, space: &ast::Space) -> ItemKind {
        let (span, word) = match space {
            ast::Space::Plane(span) => (*span, "in plane"),
            ast::Space::Space(span) | ast::Space::On(_, span) => (*span, "in space"),
        };
        let message = format!("an ifs `{word}` is not available yet");
        let diagnostic = Diagnostic::new(Code::E0001, span, message).label("a classical ifs");
        self.report(
            diagnostic.hint("an ifs `on (p0, p1, …)` is: transforms list the images of its control points"),
        );
        ItemKind::Broken
    }

    fn refuse_twice(&mut self, frame: &Frame, name: &ast::Name) {
        if let Some(first) = frame.locals.iter().find(|local| local.name == name.text) {
            let message = format!("`{}` is declared twice", name.text);
            let diagnostic = Diagnostic::new(Code::E0302, name.span, message).label("declared again here");
            self.report(diagnostic.also(first.span, "first declared here"));
        }
    }

    fn member(&mut self, frame: &mut Frame, typed: &mut Ifs, member: &ast::Member) {
        match &member.kind {
            ast::MemberKind::Let(value) => {
                self.refuse_twice(frame, &value.name);
                let expected = value.ty.as_ref().map(|ty| self.type_expr(frame.module, ty));
                let checked = match &expected {
                    Some(expected) => self.expect(frame, &value.value, expected),
                    None => self.expr(frame, &value.value, None),
                };
                let slot = frame.declare(&value.name, expected.unwrap_or_else(|| checked.ty.clone()));
                typed.lets.push((slot, checked));
            }
            ast::MemberKind::Transform(transform) => self.transform(frame, typed, transform),
            ast::MemberKind::Germ(germ) => {
                let checked = self.expect(frame, germ, &Type::Germ);
                if let Some(first) = &typed.germ {
                    let diagnostic = Diagnostic::new(Code::E0302, germ.span, "an ifs has one germ, not two");
                    self.report(diagnostic.label("a second germ").also(first.span, "the first one"));
                    return;
                }
                typed.germ = Some(checked);
            }
            ast::MemberKind::Keep(germ) => {
                let checked = self.expect(frame, germ, &Type::Germ);
                typed.keep.push(checked);
            }
            ast::MemberKind::Boundary(name, value) => self.boundary(frame, typed, name, value),
            ast::MemberKind::Join(left, right) => self.join(typed, left, right, member.span),
            ast::MemberKind::Error => {}
        }
    }

    fn transform(&mut self, frame: &mut Frame, typed: &mut Ifs, transform: &ast::Transform) {
        if let Some(first) = typed.transforms.iter().find(|other| other.name == transform.name.text) {
            let message = format!("the transform `{}` is declared twice", transform.name.text);
            let diagnostic =
                Diagnostic::new(Code::E0302, transform.name.span, message).label("declared again here");
            self.report(diagnostic.also(first.name_span, "first declared here"));
        }
        if let Some((name, _)) = &transform.family {
            let message = "families of transforms are not available yet";
            let diagnostic = Diagnostic::new(Code::E0001, name.span, message).label("an indexed family");
            self.report(diagnostic.hint("write the transforms one by one"));
            return;
        }
        let ast::ExprKind::On(target, placement) = &transform.value.kind else {
            if transform.value.kind != ast::ExprKind::Error {
                self.not_placed(frame, &transform.value);
            }
            return;
        };
        let target = self.expect(frame, target, &Type::Ifs);
        let ast::Placement::Points(points, points_span) = placement else {
            let message = "a transform lists the images of the control points in brackets";
            let diagnostic =
                Diagnostic::new(Code::E0503, transform.value.span, message).label("no list of points");
            self.report(diagnostic.hint("write `self on (p, q, …)`"));
            return;
        };
        let image = Type::Point(PointSpace::Control);
        let points: Vec<Expr> = points.iter().map(|point| self.expect(frame, point, &image)).collect();
        if points.iter().all(|point| point.ty != Type::Error) {
            self.count_images(typed, &target, points.len(), *points_span);
        }
        typed.transforms.push(Transform {
            name: transform.name.text.clone(),
            name_span: transform.name.span,
            target,
            points,
            points_span: *points_span,
        });
    }

    fn not_placed(&mut self, frame: &mut Frame, value: &ast::Expr) {
        let checked = self.expr(frame, value, None);
        if checked.ty == Type::Error {
            return;
        }
        let message = "a transform of an ifs on control points says where they go";
        let diagnostic = Diagnostic::new(Code::E0503, value.span, message).label("no list of points");
        self.report(diagnostic.hint("write `self on (p, q, …)`, one image for each control point"));
    }

    fn count_images(&mut self, typed: &Ifs, target: &Expr, given: usize, at: Span) {
        let (needed, name) = match &target.kind {
            ExprKind::SelfIfs => (typed.control_points.len(), "self".to_owned()),
            ExprKind::Ifs(id, _) => match &self.items[id.0 as usize].kind {
                ItemKind::Ifs(ifs) => (ifs.control_points.len(), self.items[id.0 as usize].name.clone()),
                _ => match &self.declared[id.0 as usize].item.kind {
                    ast::ItemKind::Ifs(ast::Ifs { space: ast::Space::On(points, _), .. }) => {
                        (points.len(), self.items[id.0 as usize].name.clone())
                    }
                    _ => return,
                },
            },
            _ => return,
        };
        if needed == given {
            return;
        }
        let message = format!("`{name}` has {needed} control points, but the transform lists {given}");
        let label = if given == 1 { "one point".to_owned() } else { format!("{given} points") };
        let diagnostic = Diagnostic::new(Code::E0503, at, message).label(label);
        let hint = match needed.checked_sub(given) {
            Some(1) => "one is missing".to_owned(),
            Some(missing) => format!("{missing} are missing"),
            None if given == needed + 1 => "one is too many".to_owned(),
            None => format!("{} are too many", given - needed),
        };
        self.report(diagnostic.hint(hint));
    }

    fn complete(&mut self, ifs: &ast::Ifs, typed: &Ifs) {
        let broken = typed.control_points.is_empty()
            || ifs.members.iter().any(|member| member.kind == ast::MemberKind::Error);
        let attempted = ifs.members.iter().any(|member| matches!(member.kind, ast::MemberKind::Transform(_)));
        if typed.transforms.is_empty() && !attempted && !broken {
            let message = format!("`{}` has no transforms", ifs.name.text);
            let diagnostic =
                Diagnostic::new(Code::E0507, ifs.name.span, message).label("made of no copies of itself");
            self.report(diagnostic.hint("add `transform left = self on (…)`"));
        }
        let attempted = ifs.members.iter().any(|member| matches!(member.kind, ast::MemberKind::Germ(_)));
        if typed.germ.is_none() && !attempted && !broken {
            let message = format!("`{}` has no germ", ifs.name.text);
            let diagnostic = Diagnostic::new(Code::E0507, ifs.name.span, message).label("draws nothing");
            self.report(diagnostic.hint("add `germ segment(p, q)`: what is drawn at the last level"));
        }
    }
}
