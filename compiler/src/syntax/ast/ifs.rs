//! The nodes of an ifs: its space, its members.

use super::{Expr, Field, Let, Name};
use crate::source::Span;

/// An iterated function system.
#[derive(Clone, Debug, PartialEq)]
pub struct Ifs {
    /// Its name.
    pub name: Name,
    /// What it takes.
    pub parameters: Vec<Field>,
    /// Where it lives.
    pub space: Space,
    /// The members in order.
    pub members: Vec<Member>,
}

/// The space of an ifs.
#[derive(Clone, Debug, PartialEq)]
pub enum Space {
    /// `on (p0, p1, …)` with the span of the brackets.
    On(Vec<ControlPoint>, Span),
    /// `in plane`
    Plane(Span),
    /// `in space`
    Space(Span),
}

/// A control point, or a list of them.
#[derive(Clone, Debug, PartialEq)]
pub struct ControlPoint {
    /// Its name.
    pub name: Name,
    /// `p[n]`: how many, for a list of control points.
    pub count: Option<Expr>,
}

/// A member of an ifs.
#[derive(Clone, Debug, PartialEq)]
pub struct Member {
    /// The whole member.
    pub span: Span,
    /// The `///` lines before it.
    pub docs: Vec<String>,
    /// What it is.
    pub kind: MemberKind,
}

/// What a member of an ifs is.
#[derive(Clone, Debug, PartialEq)]
pub enum MemberKind {
    /// `let a = lerp(p0, p1, t)`
    Let(Let),
    /// `transform left = self on (…)`, `transform branch[i in 0..3] = …`
    Transform(Transform),
    /// `germ segment(p0, p3)`
    Germ(Expr),
    /// `keep strut(…)`
    Keep(Expr),
    /// `boundary start = bspline3_end on (p0, p1, p2)`
    Boundary(Name, Expr),
    /// `join left.end = right.start`: two dotted paths of one or two parts each.
    Join(Vec<JoinPart>, Vec<JoinPart>),
    /// Not understood.
    Error,
}

/// A part of a path in a join: a boundary, a transform, or a member of a family of them.
#[derive(Clone, Debug, PartialEq)]
pub struct JoinPart {
    /// Its name.
    pub name: Name,
    /// `[0]`: which member of the family.
    pub member: Option<Expr>,
}

/// A transform, or an indexed family of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Transform {
    /// Its name.
    pub name: Name,
    /// `[i in 0..3]`
    pub family: Option<(Name, Expr)>,
    /// What it continues with, and where.
    pub value: Expr,
}
