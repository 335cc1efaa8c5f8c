//! What the tree says of the pieces: which begin statements, which signs and brackets belong to what stands beside
//! them, which ranges are closed.

use super::piece::{Mark, Piece, Statement};
use crate::syntax::ast::*;

/// Marks the pieces of a file.
pub(super) fn mark(file: &File, pieces: &mut [Piece<'_>]) {
    let mut marker = Marker { pieces };
    for item in &file.items {
        marker.item(item);
    }
}

struct Marker<'p, 's> {
    pieces: &'p mut [Piece<'s>],
}

impl Marker<'_, '_> {
    /// The index of the first piece at or after a byte.
    fn from(&self, offset: u32) -> usize {
        self.pieces.partition_point(|piece| piece.start < offset)
    }

    /// Changes the mark of the first piece at or after a byte.
    fn at(&mut self, offset: u32, change: impl FnOnce(&mut Mark)) {
        let at = self.from(offset);
        if let Some(piece) = self.pieces.get_mut(at) {
            change(&mut piece.mark);
        }
    }

    /// Changes the mark of the piece before the one at a byte.
    fn before(&mut self, offset: u32, change: impl FnOnce(&mut Mark)) {
        let before = self.from(offset).checked_sub(1);
        if let Some(piece) = before.and_then(|before| self.pieces.get_mut(before)) {
            change(&mut piece.mark);
        }
    }

    /// The bracket that follows belongs to what ends here.
    fn glue(&mut self, end: u32) {
        let at = self.from(end);
        if let Some(piece) = self.pieces.get_mut(at).filter(|piece| piece.kind.closer().is_some()) {
            piece.mark.glued = true;
        }
    }

    fn item(&mut self, item: &Item) {
        let statement = match &item.kind {
            ItemKind::Let(_) => Statement::Let,
            ItemKind::Param(_) => Statement::Param,
            ItemKind::Figure(_) => Statement::Figure,
            ItemKind::Record(_) | ItemKind::Fabricate(_) => Statement::Fields,
            ItemKind::Ifs(_) | ItemKind::Test(_) => Statement::Members,
            ItemKind::Use(_) | ItemKind::Function(_) | ItemKind::Error => Statement::Other,
        };
        self.at(item.span.start, |mark| mark.statement = Some(statement));
        match &item.kind {
            ItemKind::Let(it) => self.named(it),
            ItemKind::Param(it) => self.param(it),
            ItemKind::Figure(it) => self.typed(it.ty.as_ref(), Some(&it.value)),
            ItemKind::Record(it) => self.fields(&it.fields, true),
            ItemKind::Fabricate(it) => it.entries.iter().for_each(|entry| self.entry(entry)),
            ItemKind::Ifs(it) => {
                self.glue(it.name.span.end);
                self.fields(&it.parameters, false);
                self.space(&it.space);
                it.members.iter().for_each(|member| self.member(member));
            }
            ItemKind::Test(it) => it.steps.iter().for_each(|step| self.step(step)),
            ItemKind::Function(it) => {
                self.glue(it.name.span.end);
                self.fields(&it.parameters, false);
                self.typed(it.result.as_ref(), Some(&it.body));
            }
            ItemKind::Use(_) | ItemKind::Error => {}
        }
    }

    fn space(&mut self, space: &Space) {
        let Space::On(points, _) = space else { return };
        for point in points {
            if let Some(count) = &point.count {
                self.glue(point.name.span.end);
                self.expr(count);
            }
        }
    }

    fn named(&mut self, it: &Let) {
        self.typed(it.ty.as_ref(), Some(&it.value));
    }

    fn typed(&mut self, ty: Option<&TypeExpr>, value: Option<&Expr>) {
        let mut inner = ty;
        while let Some(TypeExpr { span, kind: TypeExprKind::List(of) }) = inner {
            self.at(span.start, |mark| mark.fixed = true);
            inner = Some(of);
        }
        if let Some(value) = value {
            self.expr(value);
        }
    }

    fn param(&mut self, it: &Param) {
        self.typed(Some(&it.ty), Some(&it.default));
        if let Some(range) = &it.range {
            self.before(range.from.span.start, |mark| (mark.column, mark.breakable) = (Some(1), true));
            self.range(range, true);
        }
        if let Some(step) = &it.step {
            self.before(step.span.start, |mark| (mark.column, mark.breakable) = (Some(2), true));
            self.expr(step);
        }
    }

    fn fields(&mut self, fields: &[Field], entries: bool) {
        for field in fields {
            if entries {
                self.at(field.name.span.start, |mark| mark.statement = Some(Statement::Other));
            }
            self.typed(Some(&field.ty), field.default.as_ref());
        }
    }

    fn entry(&mut self, entry: &Entry) {
        let setting = matches!(entry.kind, EntryKind::Setting(..));
        let statement = if setting { Statement::Setting } else { Statement::Other };
        self.at(entry.span.start, |mark| mark.statement = Some(statement));
        match &entry.kind {
            EntryKind::Setting(_, value) => {
                let record = matches!(value.kind, ExprKind::Fields(_));
                self.at(value.span.start, |mark| mark.column = (!record).then_some(0));
                self.expr(value);
            }
            EntryKind::Require(it) => self.limit(&it.limit),
            EntryKind::Error => {}
        }
    }

    fn member(&mut self, member: &Member) {
        let statement = match &member.kind {
            MemberKind::Let(_) => Statement::Let,
            MemberKind::Transform(_) => Statement::Transform,
            MemberKind::Boundary(..) => Statement::Boundary,
            _ => Statement::Other,
        };
        self.at(member.span.start, |mark| mark.statement = Some(statement));
        match &member.kind {
            MemberKind::Let(it) => self.named(it),
            MemberKind::Transform(it) => {
                if let Some((_, over)) = &it.family {
                    self.glue(it.name.span.end);
                    self.at(it.name.span.end, |mark| mark.fixed = true);
                    self.expr(over);
                }
                self.expr(&it.value);
            }
            MemberKind::Germ(value) | MemberKind::Keep(value) | MemberKind::Boundary(_, value) => {
                self.expr(value);
            }
            MemberKind::Join(left, right) => {
                for part in left.iter().chain(right) {
                    if let Some(member) = &part.member {
                        self.glue(part.name.span.end);
                        self.expr(member);
                    }
                }
            }
            MemberKind::Error => {}
        }
    }

    fn step(&mut self, step: &TestStep) {
        match step {
            TestStep::Let(it) => {
                self.before(it.name.span.start, |mark| mark.statement = Some(Statement::Let));
                self.named(it);
            }
            TestStep::Assert(condition, span) => {
                self.at(span.start, |mark| mark.statement = Some(Statement::Other));
                self.expr(condition);
            }
            TestStep::Error(_) => {}
        }
    }

    fn limit(&mut self, limit: &Limit) {
        match limit {
            Limit::Compare(_, value) => self.expr(value),
            Limit::Within(range) => self.range(range, true),
        }
    }

    fn range(&mut self, range: &RangeExpr, closed: bool) {
        let loose = closed || !is_operand(&range.from) || !is_operand(&range.to);
        self.at(range.from.span.end, |mark| mark.loose = loose);
        self.expr(&range.from);
        self.expr(&range.to);
    }

    fn exprs(&mut self, all: &[Expr]) {
        all.iter().for_each(|one| self.expr(one));
    }

    fn arguments(&mut self, given: &[Argument], fields: bool) {
        for argument in given {
            if let Some(name) = argument.name.as_ref().filter(|_| fields) {
                self.at(name.span.start, |mark| mark.field = true);
            }
            self.expr(&argument.value);
        }
    }

    fn expr(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Number { .. } | ExprKind::Text(_) | ExprKind::Bool(_) | ExprKind::Name(_) => {}
            ExprKind::Error => {}
            ExprKind::Group(inner) | ExprKind::Field(inner, _) => self.expr(inner),
            ExprKind::Tuple(parts) | ExprKind::List(parts) => self.exprs(parts),
            ExprKind::Comprehension { body, clauses } => {
                self.expr(body);
                clauses.iter().for_each(|clause| self.clause(clause));
            }
            ExprKind::Fields(fields) => self.arguments(fields, true),
            ExprKind::Call { callee, arguments } => {
                self.expr(callee);
                self.glue(callee.span.end);
                self.arguments(arguments, false);
            }
            ExprKind::Index(left, indices) => {
                self.expr(left);
                self.glue(left.span.end);
                self.exprs(indices);
            }
            ExprKind::Unary(operator, inner) => {
                let sign = *operator == UnaryOperator::Negate;
                self.at(expr.span.start, |mark| mark.sign = sign);
                self.expr(inner);
            }
            ExprKind::Binary(_, span, left, right) => {
                self.at(span.start, |mark| mark.operator = true);
                self.expr(left);
                self.expr(right);
            }
            ExprKind::Range(range) => self.range(range, false),
            ExprKind::If(condition, yes, no) => {
                self.expr(condition);
                self.expr(yes);
                self.expr(no);
            }
            ExprKind::On(left, placement) => {
                self.expr(left);
                match placement {
                    Placement::Points(points, _) => self.exprs(points),
                    Placement::Value(value) => self.expr(value),
                }
            }
            ExprKind::At(left, level) => self.level(left, level),
        }
    }

    fn clause(&mut self, clause: &Clause) {
        let start = match clause {
            Clause::For(name, _) => name.span.start,
            Clause::If(condition) => condition.span.start,
        };
        self.before(start, |mark| mark.clause = true);
        match clause {
            Clause::For(_, value) | Clause::If(value) => self.expr(value),
        }
    }

    fn level(&mut self, left: &Expr, level: &Level) {
        self.expr(left);
        match level {
            Level::Uniform(value) => self.expr(value),
            Level::Pair(u, v) => {
                self.expr(u);
                self.expr(v);
            }
            Level::Until { limit, .. } => {
                self.at(left.span.end, |mark| mark.breakable = true);
                self.limit(limit);
            }
        }
    }
}

/// Whether an expression is one operand, as between tight operators.
fn is_operand(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Binary(..)
        | ExprKind::If(..)
        | ExprKind::On(..)
        | ExprKind::At(..)
        | ExprKind::Range(_) => false,
        ExprKind::Unary(operator, inner) => *operator == UnaryOperator::Negate && is_operand(inner),
        _ => true,
    }
}
