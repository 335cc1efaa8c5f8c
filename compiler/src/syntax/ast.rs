//! The tree of one file, as written: names unresolved, types unchecked, every node with its span. Places where the text
//! could not be understood are [`ItemKind::Error`], [`MemberKind::Error`], [`EntryKind::Error`] and
//! [`ExprKind::Error`]; a diagnostic has been given for each.

mod ifs;
pub(super) mod moved;

pub use super::unit::Unit;
pub use ifs::{ControlPoint, Ifs, JoinPart, Member, MemberKind, Space, Transform};

use crate::source::Span;

/// A whole file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct File {
    /// The `//!` lines before the first item, without the marks.
    pub docs: Vec<String>,
    /// The empty span where the first item begins with the `///` lines before it; the end of a text without items.
    pub first: Span,
    /// The items in order.
    pub items: Vec<Item>,
}

impl File {
    /// The change by which the file knows a name of a module, written as `std.curves` or in quotes: where, and the text that
    /// is put there.
    pub fn to_import(&self, module: &str, name: &str) -> (u32, String) {
        let uses = self.items.iter().filter_map(|item| match &item.kind {
            ItemKind::Use(import) => Some((item, import)),
            _ => None,
        });
        let mut last = None;
        for (item, import) in uses {
            if let Some(end) = import.names.last()
                && import.module.written() == module
            {
                return (end.span.end, format!(", {name}"));
            }
            last = Some(item.span.end);
        }
        match last {
            Some(end) => (end, format!("\nuse {module} ({name})")),
            None => (self.first.start, format!("use {module} ({name})\n\n")),
        }
    }
}

/// A name and where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The name.
    pub text: String,
    /// Where.
    pub span: Span,
}

/// One item of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// From the keyword (or `pub`) to the end, without the docs.
    pub span: Span,
    /// The `///` lines before it, without the marks.
    pub docs: Vec<String>,
    /// Where `pub` stands, if it does.
    pub public: Option<Span>,
    /// What it is.
    pub kind: ItemKind,
}

/// What an item is.
#[derive(Clone, Debug, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "items are few, and boxes would be in the way of every reader")]
pub enum ItemKind {
    /// `use std.curves (bezier3)`
    Use(Use),
    /// `param span: Length = 6m in 4m .. 9m step 100mm`
    Param(Param),
    /// `let width = 27mm`
    Let(Let),
    /// `fn arch(i: Int) -> Curve = …`
    Function(Function),
    /// `record Radius { across: Length, along: Length }`
    Record(Record),
    /// `ifs bezier3(t: Number = 1/2) on (p0, p1, p2, p3) { … }`
    Ifs(Ifs),
    /// `figure shell = … at level 2`
    Figure(Figure),
    /// `fabricate shell as panels { … }`
    Fabricate(Fabricate),
    /// `test "…" { … }`
    Test(Test),
    /// Not understood.
    Error,
}

/// An import.
#[derive(Clone, Debug, PartialEq)]
pub struct Use {
    /// Where the items come from.
    pub module: ModulePath,
    /// The names asked for.
    pub names: Vec<Name>,
}

/// The place items are imported from.
#[derive(Clone, Debug, PartialEq)]
pub enum ModulePath {
    /// `std.curves`: the dotted names.
    Library(Vec<Name>),
    /// `"./ribs.ifs"`
    File(TextLiteral),
}

impl ModulePath {
    /// As it is written: `std.curves`, `"./ribs.ifs"`.
    pub fn written(&self) -> String {
        match self {
            ModulePath::Library(names) => {
                names.iter().map(|name| name.text.as_str()).collect::<Vec<_>>().join(".")
            }
            ModulePath::File(path) => format!("\"{}\"", path.value),
        }
    }

    /// Where the path stands.
    pub fn span(&self) -> Span {
        match self {
            ModulePath::Library(names) => match (names.first(), names.last()) {
                (Some(first), Some(last)) => first.span.to(last.span),
                _ => Span::default(),
            },
            ModulePath::File(text) => text.span,
        }
    }
}

/// A quoted text, its escapes resolved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextLiteral {
    /// The text.
    pub value: String,
    /// With the quotes.
    pub span: Span,
}

/// A parameter of the design.
#[derive(Clone, Debug, PartialEq)]
pub struct Param {
    /// Its name.
    pub name: Name,
    /// Its type, as written.
    pub ty: TypeExpr,
    /// Its value unless set from outside.
    pub default: Expr,
    /// The closed range after `in`.
    pub range: Option<RangeExpr>,
    /// The expression after `step`.
    pub step: Option<Expr>,
}

/// `a .. b`
#[derive(Clone, Debug, PartialEq)]
pub struct RangeExpr {
    /// From here.
    pub from: Expr,
    /// To here; whether it is inside is said by the place (`LANGUAGE.md` 10).
    pub to: Expr,
    /// The whole.
    pub span: Span,
}

/// A named value.
#[derive(Clone, Debug, PartialEq)]
pub struct Let {
    /// Its name.
    pub name: Name,
    /// Its type, where one is written.
    pub ty: Option<TypeExpr>,
    /// Its value.
    pub value: Expr,
}

/// A function.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// Its name.
    pub name: Name,
    /// What it takes.
    pub parameters: Vec<Field>,
    /// What it gives, where written.
    pub result: Option<TypeExpr>,
    /// Its body.
    pub body: Expr,
}

/// A parameter of a function or of an ifs, or a field of a record: `t: Number = 1/2`.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// The `///` lines before it.
    pub docs: Vec<String>,
    /// Its name.
    pub name: Name,
    /// Its type.
    pub ty: TypeExpr,
    /// Its value when none is given.
    pub default: Option<Expr>,
}

/// A record type.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// Its name.
    pub name: Name,
    /// Its fields.
    pub fields: Vec<Field>,
}

/// A figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Its name.
    pub name: Name,
    /// Its type, where one is written.
    pub ty: Option<TypeExpr>,
    /// Its value.
    pub value: Expr,
}

/// A fabricate block.
#[derive(Clone, Debug, PartialEq)]
pub struct Fabricate {
    /// The figure, by name.
    pub figure: Name,
    /// The word after `as`.
    pub kind: Name,
    /// Settings and requirements in order.
    pub entries: Vec<Entry>,
}

/// One line of a fabricate block.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The whole line.
    pub span: Span,
    /// What it is.
    pub kind: EntryKind,
}

/// What a line of a fabricate block is.
#[derive(Clone, Debug, PartialEq)]
pub enum EntryKind {
    /// `board: 2500mm by 1250mm`
    Setting(Name, Expr),
    /// `require edge in 150mm .. 1200mm`
    Require(Requirement),
    /// Not understood.
    Error,
}

/// A requirement.
#[derive(Clone, Debug, PartialEq)]
pub struct Requirement {
    /// The measure: the words up to the operator, joined by one space.
    pub measure: Name,
    /// The limit.
    pub limit: Limit,
}

/// The limit of a requirement, of `until`.
#[derive(Clone, Debug, PartialEq)]
pub enum Limit {
    /// `>= 80mm`, `<= 45deg`, `== 1`, …
    Compare(Comparison, Box<Expr>),
    /// `in 150mm .. 1200mm`, both ends inside.
    Within(Box<RangeExpr>),
}

/// A comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    AtMost,
    /// `>`
    Greater,
    /// `>=`
    AtLeast,
}

/// A block of tests.
#[derive(Clone, Debug, PartialEq)]
pub struct Test {
    /// What it shows.
    pub name: TextLiteral,
    /// Lines in order.
    pub steps: Vec<TestStep>,
}

/// A line of a test.
#[derive(Clone, Debug, PartialEq)]
pub enum TestStep {
    /// `let n = …`
    Let(Let),
    /// `assert …`, with the span of the whole.
    Assert(Expr, Span),
    /// Not understood.
    Error(Span),
}

/// A type as written.
#[derive(Clone, Debug, PartialEq)]
pub struct TypeExpr {
    /// Where.
    pub span: Span,
    /// What.
    pub kind: TypeExprKind,
}

/// What a written type is.
#[derive(Clone, Debug, PartialEq)]
pub enum TypeExprKind {
    /// `Length`, `Plywood`
    Name(String),
    /// `[T]`
    List(Box<TypeExpr>),
    /// Not understood.
    Error,
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// Where.
    pub span: Span,
    /// What.
    pub kind: ExprKind,
}

/// What an expression is.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// `0.46`, `12mm`, `3m/min`: the digits as written, the unit without them.
    Number {
        /// Digits, point and exponent, as written.
        digits: String,
        /// The unit, one of the closed table.
        unit: Option<Unit>,
    },
    /// `"joint.glb"`
    Text(String),
    /// `true`, `false`
    Bool(bool),
    /// A name; `self` too.
    Name(String),
    /// `(x)`: kept for the formatter.
    Group(Box<Expr>),
    /// `(a, b)` or more: a point or a vector, or arguments of `on`.
    Tuple(Vec<Expr>),
    /// `[a, b]`
    List(Vec<Expr>),
    /// `[ body for i in 0..7 if … for j in … ]`
    Comprehension {
        /// What each element is.
        body: Box<Expr>,
        /// `for` and `if` clauses in order; the first is a `for`.
        clauses: Vec<Clause>,
    },
    /// `{ worst: 1, average: 2 }`: a record whose type the place knows.
    Fields(Vec<Argument>),
    /// `f(a, b: c)`
    Call {
        /// What is called.
        callee: Box<Expr>,
        /// Arguments in order.
        arguments: Vec<Argument>,
    },
    /// `material.density`
    Field(Box<Expr>, Name),
    /// `list[i]`, `list[a..b]`, `grid[a..b, c..d]`
    Index(Box<Expr>, Vec<Expr>),
    /// `-x`, `not x`
    Unary(UnaryOperator, Box<Expr>),
    /// `a + b`; the span is the operator's.
    Binary(BinaryOperator, Span, Box<Expr>, Box<Expr>),
    /// `a .. b`
    Range(Box<RangeExpr>),
    /// `if c then a else b`
    If(Box<Expr>, Box<Expr>, Box<Expr>),
    /// `bezier3 on (…)`: the left side, and the control points.
    On(Box<Expr>, Placement),
    /// `… at level 4`, `… until edge <= 600mm`
    At(Box<Expr>, Level),
    /// Not understood.
    Error,
}

/// What stands after `on`.
#[derive(Clone, Debug, PartialEq)]
pub enum Placement {
    /// `(p0, a, b, m)`, with the span of the brackets.
    Points(Vec<Expr>, Span),
    /// Any other expression: a list or a grid.
    Value(Box<Expr>),
}

/// How deep a figure goes.
#[derive(Clone, Debug, PartialEq)]
pub enum Level {
    /// `at level 4`
    Uniform(Box<Expr>),
    /// `at level (4, 3)`
    Pair(Box<Expr>, Box<Expr>),
    /// `until edge <= 600mm`, `each until size <= 20mm`
    Until {
        /// Whether `each` stands before it.
        each: bool,
        /// The measure: words joined by one space.
        measure: Name,
        /// The limit.
        limit: Limit,
    },
}

/// An argument, or a field of a record literal.
#[derive(Clone, Debug, PartialEq)]
pub struct Argument {
    /// `name:`
    pub name: Option<Name>,
    /// The value.
    pub value: Expr,
}

/// A clause of a comprehension.
#[derive(Clone, Debug, PartialEq)]
pub enum Clause {
    /// `for i in 0..7`
    For(Name, Expr),
    /// `if i != 3`
    If(Expr),
}

/// An operator before its operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnaryOperator {
    /// `-`
    Negate,
    /// `not`
    Not,
}

/// An operator between its operands, loosest first: `or`, `and`, comparisons (not chained), `by`, `+ -`, `* /`.
/// `..` stands between comparisons and `by`; `on` and `at` are looser than all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOperator {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `by`: a size out of two lengths.
    By,
    /// `and`
    And,
    /// `or`
    Or,
    /// `==` and the like.
    Compare(Comparison),
}
