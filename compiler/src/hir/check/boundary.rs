//! Boundaries of an ifs, and the joins that are stated of them (LANGUAGE 9): names and counts, no proofs.

use super::{Checker, Frame};
use crate::diagnostic::{Code, Diagnostic, Fix, closest};
use crate::hir::index::{DeclarationKind, Target};
use crate::hir::tree::{Boundary, Expr, ExprKind, Ifs, Image, Join, JoinPart};
use crate::hir::types::{PointSpace, Type};
use crate::source::Span;
use crate::syntax::ast;

/// The boundaries that every chain of segments has.
const ENDS: [&str; 2] = ["start", "end"];

impl Checker<'_> {
    /// `boundary start = bspline3_end on (p0, p1, p2)`
    pub(super) fn boundary(
        &mut self,
        frame: &mut Frame,
        typed: &mut Ifs,
        name: &ast::Name,
        value: &ast::Expr,
    ) {
        if let Some(first) = typed.boundaries.iter().find(|other| other.name == name.text) {
            self.name_taken(&name.text, first.name_span, name.span);
        }
        if let Some(id) = frame.own_ifs {
            self.note(name, DeclarationKind::Boundary(id), Type::Error, None);
        }
        let ast::ExprKind::On(target, ast::Placement::Points(points, points_span)) = &value.kind else {
            let placed = matches!(value.kind, ast::ExprKind::Error | ast::ExprKind::On(..));
            if !placed && self.expr(frame, value, Some(&Type::Ifs)).ty == Type::Error {
                return;
            }
            if value.kind != ast::ExprKind::Error {
                let message = format!("the boundary `{}` says no points it stands on", name.text);
                let diagnostic = Diagnostic::new(Code::E0541, value.span, message).label("no list of points");
                let hint =
                    "write an ifs on points of this one: `boundary start = spline_end on (p0, p1, p2)`";
                self.report(diagnostic.hint(hint));
            }
            return;
        };
        let target = self.expect(frame, target, &Type::Ifs);
        let point = Type::Point(PointSpace::Control);
        let points: Vec<Expr> = points.iter().map(|given| self.expect(frame, given, &point)).collect();
        if points.iter().all(|point| point.ty != Type::Error) {
            self.boundary_points(typed, name, &target, points.len(), *points_span);
        }
        let (name, name_span) = (name.text.clone(), name.span);
        typed.boundaries.push(Boundary { name, name_span, target, points, points_span: *points_span });
    }

    fn boundary_points(&mut self, typed: &Ifs, name: &ast::Name, target: &Expr, given: usize, at: Span) {
        let (needed, ifs, declared) = match &target.kind {
            ExprKind::SelfIfs(_) => (typed.fixed_points(), "self".to_owned(), None),
            ExprKind::Ifs(id, _) => {
                let item = &self.items[id.0 as usize];
                (self.fixed_points(*id), item.name.clone(), Some(item.name_span))
            }
            _ => return,
        };
        let Some(needed) = needed.filter(|needed| *needed != given) else { return };
        let (name, points) = (&name.text, if given == 1 { "point" } else { "points" });
        let message = format!(
            "`{ifs}` has {needed} control points, but the boundary `{name}` puts it on {given} {points}"
        );
        let diagnostic = Diagnostic::new(Code::E0541, at, message).label(format!("{given} {points}"));
        let diagnostic = match declared {
            Some(declared) => diagnostic.also(declared, "declared here"),
            None => diagnostic,
        };
        self.report(
            diagnostic.hint("name one point of this ifs for each control point of the boundary's ifs"),
        );
    }

    pub(super) fn join(
        &mut self,
        frame: &mut Frame,
        typed: &mut Ifs,
        (left, right): (&[ast::JoinPart], &[ast::JoinPart]),
        span: Span,
    ) {
        let mut path = |parts: &[ast::JoinPart]| -> Vec<JoinPart> {
            let part = |part: &ast::JoinPart| JoinPart {
                name: part.name.text.clone(),
                span: part.name.span,
                member: part.member.as_ref().map(|member| self.expect(frame, member, &Type::Int)),
            };
            parts.iter().map(part).collect()
        };
        let (left, right) = (path(left), path(right));
        typed.joins.push(Join { left, right, span });
    }

    /// Whether the names in joins are those of transforms and boundaries, as far as the text says. Called when all
    /// members are known.
    pub(super) fn joins_name_parts(&mut self, ifs: &ast::Ifs, typed: &Ifs) {
        if ifs.members.iter().any(|member| member.kind == ast::MemberKind::Error) {
            return;
        }
        for transform in &typed.transforms {
            if let Some(other) = typed.boundaries.iter().find(|other| other.name == transform.name) {
                let (a, b) = (transform.name_span, other.name_span);
                let (first, again) = if a.start < b.start { (a, b) } else { (b, a) };
                self.name_taken(&transform.name, first, again);
            }
        }
        for join in &typed.joins {
            for path in [&join.left, &join.right] {
                match path.as_slice() {
                    [own] => self.own_boundary(typed, own),
                    [first, second] => self.piece(ifs, typed, first, second),
                    _ => {}
                }
            }
        }
    }

    fn name_taken(&mut self, name: &str, first: Span, again: Span) {
        let message = format!("`{name}` is declared twice");
        let diagnostic = Diagnostic::new(Code::E0302, again, message).label("declared again here");
        self.report(diagnostic.also(first, "first declared here"));
    }

    fn own_boundary(&mut self, typed: &Ifs, JoinPart { name, span, .. }: &JoinPart) {
        let known = typed.boundaries.iter().find(|boundary| boundary.name == *name);
        if let Some(boundary) = known {
            self.refer(*span, Target::Declared(boundary.name_span));
        }
        if known.is_some() || ENDS.contains(&name.as_str()) {
            return;
        }
        if typed.transforms.iter().any(|transform| transform.name == *name) {
            let message = format!("`{name}` is a transform; a join is between boundaries");
            let diagnostic =
                Diagnostic::new(Code::E0540, *span, message).label("which boundary of this piece?");
            let ends = ENDS.iter().map(|end| Fix::replacing(*span, format!("{name}.{end}"))).collect();
            self.report(diagnostic.ways(format!("name one: `{name}.end`"), ends));
            return;
        }
        let names: Vec<&str> = typed.boundaries.iter().map(|boundary| boundary.name.as_str()).collect();
        self.nothing_of_that_name(format!("there is no boundary `{name}`"), name, *span, &names);
    }

    /// `left.end`, a boundary of a piece; or `bottom.left`, a piece of a boundary.
    fn piece(
        &mut self,
        ifs: &ast::Ifs,
        typed: &Ifs,
        JoinPart { name: first, span: first_span, .. }: &JoinPart,
        JoinPart { name: second, span: second_span, .. }: &JoinPart,
    ) {
        let transform = typed.transforms.iter().find(|transform| transform.name == *first);
        let boundary = typed.boundaries.iter().find(|boundary| boundary.name == *first);
        let named = transform.map(|transform| transform.name_span);
        if let Some(declared) = named.or(boundary.map(|boundary| boundary.name_span)) {
            self.refer(*first_span, Target::Declared(declared));
        }
        let (target, of_piece) = match (transform, boundary) {
            (Some(transform), _) => match &transform.image {
                Image::Points { target, .. } => (target, true),
                Image::Mapped(_) | Image::If(..) => return,
            },
            (None, Some(boundary)) => (&boundary.target, false),
            (None, None) if ENDS.contains(&first.as_str()) => return,
            (None, None) => {
                let family = ifs.members.iter().any(|member| {
                    matches!(&member.kind, ast::MemberKind::Transform(ast::Transform { name, family: Some(_), .. }) if name.text == *first)
                });
                if family {
                    return;
                }
                let transforms = typed.transforms.iter().map(|transform| transform.name.as_str());
                let boundaries = typed.boundaries.iter().map(|boundary| boundary.name.as_str());
                let names: Vec<&str> = transforms.chain(boundaries).collect();
                let message = format!("there is no transform or boundary `{first}`");
                return self.nothing_of_that_name(message, first, *first_span, &names);
            }
        };
        let (members, name) = match &target.kind {
            ExprKind::SelfIfs(_) => (&ifs.members, ifs.name.text.clone()),
            ExprKind::Ifs(id, _) => match &self.declared[id.0 as usize].item.kind {
                ast::ItemKind::Ifs(other) => (&other.members, other.name.text.clone()),
                _ => return,
            },
            _ => return,
        };
        let names: Vec<&ast::Name> = members
            .iter()
            .filter_map(|member| match &member.kind {
                ast::MemberKind::Boundary(name, _) if of_piece => Some(name),
                ast::MemberKind::Transform(transform) if !of_piece => Some(&transform.name),
                _ => None,
            })
            .collect();
        let meant = names.iter().find(|name| name.text == *second);
        if let Some(meant) = meant {
            self.refer(*second_span, Target::Declared(meant.span));
        }
        if meant.is_some() || (of_piece && ENDS.contains(&second.as_str())) {
            return;
        }
        let names: Vec<&str> = names.iter().map(|name| name.text.as_str()).collect();
        let kind = if of_piece { "boundary" } else { "transform" };
        let message = format!("`{name}`, the ifs of `{first}`, has no {kind} `{second}`");
        self.nothing_of_that_name(message, second, *second_span, &names);
    }

    fn nothing_of_that_name(&mut self, message: String, name: &str, span: Span, names: &[&str]) {
        let diagnostic = Diagnostic::new(Code::E0540, span, message).label("not declared");
        let diagnostic = match closest(name, names.iter().copied()) {
            Some(near) => diagnostic.fix(format!("did you mean `{near}`?"), span, near.to_owned()),
            None if names.is_empty() => {
                diagnostic.hint("declare one: `boundary start = spline_end on (p0, p1, p2)`")
            }
            None => diagnostic.hint(format!("there are `{}`", names.join("`, `"))),
        };
        self.report(diagnostic);
    }
}
