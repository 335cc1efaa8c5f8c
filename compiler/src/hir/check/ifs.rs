//! An ifs: its control points, named points, transforms and germ.

use super::{Checker, Frame};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::index::DeclarationKind;
use crate::hir::tree::{ControlPoint, Expr, ExprKind, Ifs, ItemId, ItemKind};
use crate::hir::types::{PointSpace, Type};
use crate::source::Span;
use crate::syntax::ast;

/// The names of the points of an affine frame, for messages.
const FRAME: [&str; 4] = ["origin", "x", "y", "z"];

impl Checker<'_> {
    pub(super) fn ifs(&mut self, id: ItemId, module: usize, ifs: &ast::Ifs) -> ItemKind {
        let parameters = self.fields(id, module, &ifs.parameters);
        let (space, points, points_span): (_, &[ast::ControlPoint], _) = match &ifs.space {
            ast::Space::On(points, span) => (PointSpace::Control, points, *span),
            ast::Space::Plane(span) => (PointSpace::Plane, &[], *span),
            ast::Space::Space(span) => (PointSpace::Space, &[], *span),
        };
        let mut frame = Frame::new(module);
        frame.own_ifs = Some(id);
        let scope = self.declared[id.0 as usize].item.span;
        for (place, (field, parameter)) in ifs.parameters.iter().zip(&parameters).enumerate() {
            let kind = DeclarationKind::Field(id, place);
            self.declare(&mut frame, &field.name, parameter.ty.clone(), kind, scope);
        }
        let mut counts = Vec::new();
        for point in points {
            let count = point.count.as_ref().map(|count| self.expect(&mut frame, count, &Type::Int));
            self.refuse_twice(&frame, &point.name);
            counts.push(count);
        }
        for (point, count) in points.iter().zip(&counts) {
            let ty = Type::Point(PointSpace::Control);
            let ty = if count.is_some() { Type::List(Box::new(ty)) } else { ty };
            self.declare(&mut frame, &point.name, ty, DeclarationKind::ControlPoint, scope);
        }
        let mut typed = Ifs {
            parameters,
            space,
            control_points: match space.coordinates() {
                Some(count) => FRAME[..=count]
                    .iter()
                    .map(|name| ControlPoint { name: (*name).to_owned(), count: None })
                    .collect(),
                None => points
                    .iter()
                    .zip(counts)
                    .map(|(point, count)| ControlPoint { name: point.name.text.clone(), count })
                    .collect(),
            },
            lets: Vec::new(),
            transforms: Vec::new(),
            germ: None,
            keep: Vec::new(),
            boundaries: Vec::new(),
            joins: Vec::new(),
            slots: 0,
        };
        if typed.control_points.is_empty() {
            let message = "an ifs needs at least one control point";
            self.report(Diagnostic::new(Code::E0507, points_span, message).label("no control points"));
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

    /// From the end of a member to the end of the ifs around it.
    fn after(&self, frame: &Frame, member: Span) -> Span {
        let around = frame.own_ifs.map_or(member, |id| self.declared[id.0 as usize].item.span);
        Span::new(member.file, member.end, around.end.max(member.end))
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
                let ty = expected.unwrap_or_else(|| checked.ty.clone());
                let scope = self.after(frame, member.span);
                let slot = self.declare(frame, &value.name, ty, DeclarationKind::Local, scope);
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
            ast::MemberKind::Join(left, right) => self.join(frame, typed, (left, right), member.span),
            ast::MemberKind::Error => {}
        }
    }

    /// Whether a transform gives an image of each control point, as far as that is known without arguments; where it does not,
    /// that has been said.
    pub(super) fn count_images(&mut self, typed: &Ifs, target: &Expr, given: usize, at: Span) -> bool {
        let (needed, name) = match &target.kind {
            ExprKind::SelfIfs(_) => (typed.fixed_points(), "self".to_owned()),
            ExprKind::Ifs(id, _) => (self.fixed_points(*id), self.items[id.0 as usize].name.clone()),
            _ => return true,
        };
        // How many points a list of them has is known only with its arguments.
        let Some(needed) = needed.filter(|needed| *needed != given) else { return true };
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
        false
    }

    /// How many control points an ifs is declared on, where that does not depend on its arguments.
    pub(super) fn fixed_points(&self, id: ItemId) -> Option<usize> {
        match &self.declared[id.0 as usize].item.kind {
            ast::ItemKind::Ifs(ast::Ifs { space: ast::Space::On(points, _), .. }) => {
                points.iter().all(|point| point.count.is_none()).then_some(points.len())
            }
            _ => None,
        }
    }

    fn complete(&mut self, ifs: &ast::Ifs, typed: &Ifs) {
        let broken = typed.control_points.is_empty()
            || ifs.members.iter().any(|member| member.kind == ast::MemberKind::Error);
        let attempted = ifs.members.iter().any(|member| matches!(member.kind, ast::MemberKind::Transform(_)));
        if typed.transforms.is_empty() && !attempted && !broken {
            let message = format!("`{}` has no transforms", ifs.name.text);
            let diagnostic =
                Diagnostic::new(Code::E0507, ifs.name.span, message).label("made of no copies of itself");
            self.report(diagnostic.hint(match typed.space {
                PointSpace::Control => "add `transform left = self on (…)`",
                _ => "add `transform left = scale(1/2) * self`",
            }));
        }
        let attempted = ifs.members.iter().any(|member| matches!(member.kind, ast::MemberKind::Germ(_)));
        if typed.germ.is_none() && !attempted && !broken {
            let message = format!("`{}` has no germ", ifs.name.text);
            let diagnostic = Diagnostic::new(Code::E0507, ifs.name.span, message).label("draws nothing");
            self.report(diagnostic.hint("add `germ segment(p, q)`: what is drawn at the last level"));
        }
    }
}
