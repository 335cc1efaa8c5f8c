//! The tree at another place of a text, or in another file.

use super::{
    Argument, Clause, ControlPoint, Entry, EntryKind, Expr, ExprKind, Fabricate, Field, Figure, Function,
    Ifs, Item, ItemKind, JoinPart, Let, Level, Limit, Member, MemberKind, ModulePath, Name, Param, Placement,
    RangeExpr, Record, Requirement, Space, Test, TestStep, TextLiteral, Transform, TypeExpr, TypeExprKind,
    Use,
};
use crate::source::{FileId, Span};

/// By how much places move, and the file they are in then.
#[derive(Clone, Copy, Debug)]
pub(in crate::syntax) struct Shift {
    pub(in crate::syntax) file: FileId,
    /// Bytes.
    pub(in crate::syntax) by: i64,
}

/// What has places that can move.
pub(in crate::syntax) trait Places {
    /// Moves every place in it.
    fn shift(&mut self, by: Shift);
}

impl Places for Span {
    fn shift(&mut self, by: Shift) {
        let moved = |offset: u32| u32::try_from(i64::from(offset) + by.by).unwrap_or(0);
        *self = Span::new(by.file, moved(self.start), moved(self.end));
    }
}

impl<T: Places> Places for Vec<T> {
    fn shift(&mut self, by: Shift) {
        self.iter_mut().for_each(|one| one.shift(by));
    }
}

impl<T: Places> Places for Option<T> {
    fn shift(&mut self, by: Shift) {
        self.iter_mut().for_each(|one| one.shift(by));
    }
}

impl<T: Places> Places for Box<T> {
    fn shift(&mut self, by: Shift) {
        (**self).shift(by);
    }
}

impl<A: Places, B: Places> Places for (A, B) {
    fn shift(&mut self, by: Shift) {
        self.0.shift(by);
        self.1.shift(by);
    }
}

/// Structures whose named fields have places.
macro_rules! fields {
    ($($structure:ident { $($field:ident),+ })+) => {
        $(impl Places for $structure {
            fn shift(&mut self, by: Shift) {
                $(self.$field.shift(by);)+
            }
        })+
    };
}

fields! {
    Name { span }
    TextLiteral { span }
    Item { span, public, kind }
    Use { module, names }
    Param { name, ty, default, range, step }
    RangeExpr { from, to, span }
    Let { name, ty, value }
    Function { name, parameters, result, body }
    Field { name, ty, default }
    Record { name, fields }
    Figure { name, ty, value }
    Fabricate { figure, kind, entries }
    Entry { span, kind }
    Requirement { measure, limit }
    Test { name, steps }
    TypeExpr { span, kind }
    Expr { span, kind }
    Argument { name, value }
    Ifs { name, parameters, space, members }
    ControlPoint { name, count }
    Member { span, kind }
    JoinPart { name, member }
    Transform { name, family, value }
}

/// Variants, each with what has places in it.
macro_rules! variants {
    ($($choice:ident { $($variant:ident($($part:ident),*)),+ ; $($bare:pat),* })+) => {
        $(impl Places for $choice {
            fn shift(&mut self, by: Shift) {
                match self {
                    $($choice::$variant($($part),*) => { $($part.shift(by);)* })+
                    $($bare => {})*
                }
            }
        })+
    };
}

variants! {
    ItemKind {
        Use(a), Param(a), Let(a), Function(a), Record(a), Ifs(a), Figure(a), Fabricate(a), Test(a);
        ItemKind::Error
    }
    ModulePath { Library(names), File(path); }
    EntryKind { Setting(name, value), Require(a); EntryKind::Error }
    TestStep { Let(a), Assert(value, span), Error(span); }
    Placement { Points(points, span), Value(value); }
    Clause { For(name, list), If(condition); }
    Space { On(points, span), Plane(span), Space(span); }
    MemberKind {
        Let(a), Transform(a), Germ(a), Keep(a), Boundary(name, on), Join(from, to);
        MemberKind::Error
    }
}

impl Places for TypeExprKind {
    fn shift(&mut self, by: Shift) {
        match self {
            TypeExprKind::List(element) => element.shift(by),
            TypeExprKind::Name(_) | TypeExprKind::Error => {}
        }
    }
}

impl Places for Limit {
    fn shift(&mut self, by: Shift) {
        match self {
            Limit::Compare(_, value) => value.shift(by),
            Limit::Within(range) => range.shift(by),
        }
    }
}

impl Places for Level {
    fn shift(&mut self, by: Shift) {
        match self {
            Level::Uniform(level) => level.shift(by),
            Level::Pair(u, v) => {
                u.shift(by);
                v.shift(by);
            }
            Level::Until { measure, limit, .. } => {
                measure.shift(by);
                limit.shift(by);
            }
        }
    }
}

impl Places for ExprKind {
    fn shift(&mut self, by: Shift) {
        match self {
            ExprKind::Number { .. }
            | ExprKind::Text(_)
            | ExprKind::Bool(_)
            | ExprKind::Name(_)
            | ExprKind::Error => {}
            ExprKind::Group(inner) | ExprKind::Unary(_, inner) => inner.shift(by),
            ExprKind::Tuple(all) | ExprKind::List(all) => all.shift(by),
            ExprKind::Comprehension { body, clauses } => {
                body.shift(by);
                clauses.shift(by);
            }
            ExprKind::Fields(fields) => fields.shift(by),
            ExprKind::Call { callee, arguments } => {
                callee.shift(by);
                arguments.shift(by);
            }
            ExprKind::Field(base, name) => {
                base.shift(by);
                name.shift(by);
            }
            ExprKind::Index(base, places) => {
                base.shift(by);
                places.shift(by);
            }
            ExprKind::Binary(_, operator, left, right) => {
                operator.shift(by);
                left.shift(by);
                right.shift(by);
            }
            ExprKind::Range(range) => range.shift(by),
            ExprKind::If(condition, yes, no) => {
                condition.shift(by);
                yes.shift(by);
                no.shift(by);
            }
            ExprKind::On(ifs, placement) => {
                ifs.shift(by);
                placement.shift(by);
            }
            ExprKind::At(figure, level) => {
                figure.shift(by);
                level.shift(by);
            }
        }
    }
}
