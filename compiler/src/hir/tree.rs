//! The typed tree: names resolved, every expression with its type, defaults filled in, conversions explicit.

use super::native::Native;
use super::scalar::Scalar;
use super::schema::{ChoiceKind, Measure, SchemaKind};
use super::size::UntilExpr;
use super::types::{PointSpace, Type};
use super::value::{Germ, OwnGerm};
use crate::source::{FileId, Span};
use crate::syntax::ast::Comparison;
use std::sync::Arc;

/// The identity of an item across all modules.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ItemId(pub u32);

/// A slot of the frame an expression is evaluated in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LocalId(pub u32);

/// Everything a design and the modules it uses declare.
#[derive(Clone, Debug, Default)]
pub struct Hir {
    /// The items, by [`ItemId`].
    pub items: Vec<Item>,
    /// The fabricate blocks of the design, in order.
    pub fabricates: Vec<Fabricate>,
    /// The tests of the design, in order.
    pub tests: Vec<Test>,
    /// The file of the design itself.
    pub root: FileId,
    /// The files of the library.
    pub library: Vec<FileId>,
    /// The file in which a machine is named from outside, where there is one.
    pub machine_file: Option<FileId>,
}

impl Hir {
    /// An item.
    pub fn item(&self, id: ItemId) -> &Item {
        &self.items[id.0 as usize]
    }

    /// The items that the design's own file declares, in order.
    pub fn own_items(&self) -> impl Iterator<Item = (ItemId, &Item)> {
        let ids = (0..self.items.len() as u32).map(ItemId);
        ids.zip(&self.items).filter(|(_, item)| item.name_span.file == self.root)
    }

    /// The items that the design's own file and the files it uses declare, in order.
    pub fn project_items(&self) -> impl Iterator<Item = (ItemId, &Item)> {
        let ids = (0..self.items.len() as u32).map(ItemId);
        ids.zip(&self.items).filter(|(_, item)| !self.is_library(item.name_span.file))
    }

    /// Whether a file is one of the library's.
    pub fn is_library(&self, file: FileId) -> bool {
        self.library.contains(&file)
    }
}

/// A declared thing.
#[derive(Clone, Debug)]
pub struct Item {
    /// Its name.
    pub name: String,
    /// Where the name stands.
    pub name_span: Span,
    /// Its doc comment.
    pub docs: Vec<String>,
    /// What it is; `Broken` where it could not be understood.
    pub kind: ItemKind,
}

/// What an item is.
#[derive(Clone, Debug)]
pub enum ItemKind {
    /// A parameter.
    Param(Box<Param>),
    /// A named value.
    Let(Body),
    /// A figure.
    Figure(Body),
    /// A function.
    Function(Function),
    /// A record type.
    Record(Vec<Field>),
    /// An iterated function system.
    Ifs(Ifs),
    /// Something with an error in it.
    Broken,
}

/// An expression with the frame it needs.
#[derive(Clone, Debug)]
pub struct Body {
    /// The expression.
    pub value: Expr,
    /// How many slots its frame has.
    pub slots: u32,
}

/// A parameter of the design.
#[derive(Clone, Debug)]
pub struct Param {
    /// Its type: a number of some dimension, a truth or a text.
    pub ty: Type,
    /// Its default.
    pub default: Body,
    /// The closed range, where given.
    pub range: Option<(Body, Body)>,
    /// The step, where given.
    pub step: Option<Body>,
}

/// A function.
#[derive(Clone, Debug)]
pub struct Function {
    /// What it takes; their slots are the first ones.
    pub parameters: Vec<Field>,
    /// Its body.
    pub body: Body,
}

/// A parameter of a function or an ifs, or a field of a record.
#[derive(Clone, Debug)]
pub struct Field {
    /// Its name.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// Its value when none is given.
    pub default: Option<Body>,
}

/// An iterated function system.
#[derive(Clone, Debug)]
pub struct Ifs {
    /// Its parameters; their slots are the first ones.
    pub parameters: Vec<Field>,
    /// The plane, space, or its control points.
    pub space: PointSpace,
    /// The names of its control points, whose slots follow the parameters'; in the plane and in space, of the points of
    /// its frame, which have no slots.
    pub control_points: Vec<ControlPoint>,
    /// Its named points in order, each with its slot.
    pub lets: Vec<(LocalId, Expr)>,
    /// Its transforms in order.
    pub transforms: Vec<Transform>,
    /// What it draws.
    pub germ: Option<Expr>,
    /// What it draws at every level on the way.
    pub keep: Vec<Expr>,
    /// Its named boundaries.
    pub boundaries: Vec<Boundary>,
    /// The joins that are stated of it.
    pub joins: Vec<Join>,
    /// How many slots a frame has.
    pub slots: u32,
}

/// A transform of an ifs.
#[derive(Clone, Debug)]
pub struct Transform {
    /// Its name.
    pub name: String,
    /// Where the name stands.
    pub name_span: Span,
    /// The slot of the index and what it runs through, for a family.
    pub family: Option<(LocalId, Expr)>,
    /// What it continues with, and where.
    pub image: Image,
}

/// A control point of an ifs, or a list of them; one slot of the frame.
#[derive(Clone, Debug)]
pub struct ControlPoint {
    /// Its name.
    pub name: String,
    /// How many there are, for a list.
    pub count: Option<Expr>,
}

impl Ifs {
    /// How many control points it has, where that does not depend on its arguments.
    pub fn fixed_points(&self) -> Option<usize> {
        self.control_points.iter().all(|point| point.count.is_none()).then_some(self.control_points.len())
    }
}

/// What a transform continues with, and where.
#[derive(Clone, Debug)]
pub enum Image {
    /// `self on (p, q)`: the images of the target's control points.
    Points {
        /// The ifs it continues with.
        target: Expr,
        /// The images of the target's control points, one by one; or one list of them.
        points: Vec<Expr>,
        /// Where the images stand.
        span: Span,
    },
    /// `map * self`: an ifs of the plane or of space, mapped.
    Mapped(Expr),
    /// `if c then … else …`
    If(Expr, Box<Image>, Box<Image>),
}

impl Image {
    /// Where the images stand, or the whole expression.
    pub fn span(&self) -> Span {
        match self {
            Image::Points { span, .. } => *span,
            Image::Mapped(value) => value.span,
            Image::If(condition, _, no) => condition.span.to(no.span()),
        }
    }
}

/// A test: what is stated of the design, and run only when asked for.
#[derive(Clone, Debug)]
pub struct Test {
    /// What it shows.
    pub name: String,
    /// Where that is written.
    pub name_span: Span,
    /// Its lines in order.
    pub steps: Vec<TestStep>,
    /// How many slots its frame has.
    pub slots: u32,
}

/// A line of a test.
#[derive(Clone, Debug)]
pub enum TestStep {
    /// A named value.
    Let(LocalId, Expr),
    /// What must be true, with the whole line.
    Assert(Expr, Span),
}

/// What a test can ask of a figure of the design.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Made {
    /// Its boards or planks, a list of records.
    Boards,
    /// How many elements it has.
    Elements,
    /// How many vertices it has, joined ones counted once.
    Vertices,
}

impl Made {
    /// All of them with their words, each with one line for people.
    pub const ALL: [(&'static str, Made, &'static str); 3] = [
        ("boards", Made::Boards, "the boards or planks that are made of it"),
        ("elements", Made::Elements, "how many elements it has"),
        ("vertices", Made::Vertices, "how many vertices it has, joined ones counted once"),
    ];
}

/// A boundary of an ifs: another ifs on points of this one.
#[derive(Clone, Debug)]
pub struct Boundary {
    /// Its name.
    pub name: String,
    /// Where the name stands.
    pub name_span: Span,
    /// The ifs that it is.
    pub target: Expr,
    /// The points that ifs stands on.
    pub points: Vec<Expr>,
    /// Where the points stand.
    pub points_span: Span,
}

/// `join left.end = right.start`, as written; what the names stand for is known with the arguments.
#[derive(Clone, Debug)]
pub struct Join {
    /// The path before the sign: one or two parts.
    pub left: Vec<JoinPart>,
    /// The path after it.
    pub right: Vec<JoinPart>,
    /// The whole member.
    pub span: Span,
}

/// A part of a path in a join: `left`, `branch[0]`.
#[derive(Clone, Debug)]
pub struct JoinPart {
    /// Its name.
    pub name: String,
    /// Where it stands.
    pub span: Span,
    /// Which member of a family it is.
    pub member: Option<Expr>,
}

/// A fabricate block.
#[derive(Clone, Debug)]
pub struct Fabricate {
    /// The figure.
    pub figure: ItemId,
    /// Where the figure is named.
    pub figure_span: Span,
    /// Panels or planks.
    pub kind: SchemaKind,
    /// Where the kind is named.
    pub kind_span: Span,
    /// Its settings in order.
    pub settings: Vec<SettingValue>,
    /// Its requirements in order.
    pub requirements: Vec<Requirement>,
    /// How many slots its frame has: slot 0 is the material.
    pub slots: u32,
}

/// One setting as given.
#[derive(Clone, Debug)]
pub struct SettingValue {
    /// Its name.
    pub name: &'static str,
    /// Where the name stands.
    pub name_span: Span,
    /// Its value.
    pub value: Expr,
}

/// A requirement.
#[derive(Clone, Debug)]
pub struct Requirement {
    /// What is measured.
    pub measure: Measure,
    /// The whole line.
    pub span: Span,
    /// Where the measure is named.
    pub measure_span: Span,
    /// The limit.
    pub limit: Limit,
}

/// The limit of a requirement.
#[derive(Clone, Debug)]
pub enum Limit {
    /// Compared with a value.
    Compare(Comparison, Expr),
    /// Inside a closed range.
    Within(Expr, Expr),
}

/// An expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// What.
    pub kind: ExprKind,
    /// Its type.
    pub ty: Type,
    /// Where.
    pub span: Span,
}

/// Whether an expression is a number as it stands there, perhaps with its sign, so that another can be written instead.
pub fn is_literal(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Scalar(_) => true,
        ExprKind::Negate(inner) | ExprKind::Convert(inner) => is_literal(inner),
        _ => false,
    }
}

/// What an expression is.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A number.
    Scalar(Scalar),
    /// A truth.
    Bool(bool),
    /// A text.
    Text(String),
    /// A mesh that was read.
    Imported(Arc<Germ>),
    /// A slot of the frame.
    Local(LocalId),
    /// The value of a param, let or figure.
    Global(ItemId),
    /// An ifs with its arguments, in order.
    Ifs(ItemId, Vec<Expr>),
    /// The ifs around, with its own arguments.
    SelfIfs(ItemId),
    /// `limit` or `control`, inside of an ifs.
    OwnGerm(OwnGerm),
    /// A function of the language, arguments in order.
    Call(ItemId, Vec<Expr>),
    /// A function of the program, arguments in order.
    Native(Native, Vec<Expr>),
    /// A record, its fields in order.
    Record(ItemId, Vec<Expr>),
    /// The default of a parameter or field of an item, by its place.
    Default(ItemId, usize),
    /// Settings by name.
    Settings(SchemaKind, Vec<SettingValue>),
    /// A word of a choice, by its place.
    Choice(ChoiceKind, usize),
    /// Coordinates of a point.
    Point(Vec<Expr>),
    /// Coordinates of a vector.
    Vector(Vec<Expr>),
    /// A list.
    List(Vec<Expr>),
    /// A comprehension.
    Comprehension(Box<Expr>, Vec<Clause>),
    /// `a .. b`
    Range(Box<Expr>, Box<Expr>),
    /// `a by b`
    Size(Box<Expr>, Box<Expr>),
    /// A field of a record, by its place.
    Field(Box<Expr>, usize),
    /// A coordinate of a point or vector, by its place.
    Coordinate(Box<Expr>, usize),
    /// What is made of a figure; only in tests.
    Made(ItemId, Made),
    /// A field of every record of a list.
    EachField(Box<Expr>, usize),
    /// One element of a list.
    Index(Box<Expr>, Box<Expr>),
    /// `list[a..b]`, and `grid[a..b, c..d]`.
    Slice(Box<Expr>, Vec<Expr>),
    /// `-x`
    Negate(Box<Expr>),
    /// `not x`
    Not(Box<Expr>),
    /// `a + b` and the like.
    Arithmetic(Arithmetic, Span, Box<Expr>, Box<Expr>),
    /// `a < b` and the like.
    Compare(Comparison, Box<Expr>, Box<Expr>),
    /// `a and b`: the second only where the first is true.
    And(Box<Expr>, Box<Expr>),
    /// `a or b`: the second only where the first is false.
    Or(Box<Expr>, Box<Expr>),
    /// `if c then a else b`
    If(Box<Expr>, Box<Expr>, Box<Expr>),
    /// An ifs placed on control points: a list, or a grid.
    On(Box<Expr>, Box<Expr>, Span),
    /// A figure at a level, in one or two directions.
    At(Box<Expr>, Box<Expr>, Option<Box<Expr>>),
    /// A figure whose level is found by the size of its elements.
    Until(Box<Expr>, Box<UntilExpr>),
    /// The same, checked to be of the type of this node.
    Convert(Box<Expr>),
    /// Not understood.
    Error,
}

/// A clause of a comprehension.
#[derive(Clone, Debug)]
pub enum Clause {
    /// `for i in …`: a range of whole numbers or a list.
    For(LocalId, Expr),
    /// `if …`
    If(Expr),
}

/// An operator on numbers, points and vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arithmetic {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
}

impl Arithmetic {
    /// As written.
    pub fn symbol(self) -> &'static str {
        match self {
            Arithmetic::Add => "+",
            Arithmetic::Subtract => "-",
            Arithmetic::Multiply => "*",
            Arithmetic::Divide => "/",
        }
    }
}
