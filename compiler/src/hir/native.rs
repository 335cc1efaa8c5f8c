//! The functions that the program itself gives the language: the one table of them. Their evaluation is in
//! `evaluate/native.rs`, their result types in `check/native.rs`.

mod figures;
mod values;

pub use figures::FIGURES;
pub use values::VALUES;

use super::schema::ChoiceKind;
use super::types::{PointSpace, Type};

/// A function of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[allow(missing_docs, reason = "the table below says what each is")]
pub enum Native {
    Sin,
    Cos,
    Tan,
    Sqrt,
    Abs,
    Floor,
    Round,
    Min,
    Max,
    Sum,
    Len,
    Mean,
    All,
    Any,
    Close,
    Lerp,
    Interpolate,
    Segment,
    Tensor,
    Sheet,
    Asin,
    Acos,
    Atan,
    Atan2,
    Exp,
    Ln,
    Pow,
    Ceil,
    Mod,
    Concat,
    Reverse,
    Transpose,
    Norm,
    Distance,
    Dot,
    Toward,
    WithLength,
    Perpendicular,
    Text,
    Translate,
    Rotate,
    Turn,
    Scale,
    Mirror,
    Affine,
    Point,
    Polygon,
    Quad,
    Strut,
    Mesh,
    Import,
    Chain,
    Weighted,
    Translation,
    ScaleTranslation,
    ProjectiveSum,
    Revolution,
    Extrusion,
    Plane,
    Cut,
}

/// What a parameter takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Takes {
    /// A number of any dimension.
    Quantity,
    /// A number of any dimension, or a list of them.
    QuantityOrList,
    /// A list of numbers of one dimension.
    Quantities,
    /// A list of numbers of one dimension, or of points or vectors.
    Summands,
    /// A list of lists.
    Lists,
    /// A vector.
    Vector,
    /// A length.
    Length,
    /// A number, a truth or a text.
    Plain,
    /// A plain number.
    Number,
    /// An angle.
    Angle,
    /// A list of truths.
    Truths,
    /// A list of anything.
    List,
    /// A point.
    Point,
    /// A list of points.
    Points,
    /// An ifs.
    Ifs,
    /// A list of control points, weighted or not.
    ControlPoints,
    /// A grid of control points, weighted or not.
    Net,
    /// A length; a vector where it is the only argument.
    LengthOrVector,
    /// Points one by one, or one list of them.
    Vertices,
    /// `u`, `v` or `uv`.
    Closed,
    /// True or false.
    Truth,
    /// A curve.
    Curve,
    /// A vector of space.
    SpaceVector,
    /// A point of space.
    SpacePoint,
    /// A plane.
    Plane,
    /// A whole number.
    Whole,
    /// A list of plain numbers.
    Numbers,
    /// A list of lists of whole numbers.
    Faces,
    /// The path of a file, written out.
    Path,
}

impl Takes {
    /// The type to check an argument against, where there is just one.
    pub fn expected(self) -> Option<Type> {
        let list = |ty: Type| Type::List(Box::new(ty));
        match self {
            Takes::Number => Some(Type::NUMBER),
            Takes::Angle => Some(Type::ANGLE),
            Takes::Length | Takes::LengthOrVector => Some(Type::LENGTH),
            Takes::Point => Some(Type::Point(PointSpace::Any)),
            Takes::Vector => Some(Type::Vector(PointSpace::Any)),
            Takes::Points => Some(list(Type::Point(PointSpace::Any))),
            Takes::Vertices => Some(list(Type::Point(PointSpace::Any))),
            Takes::Truths => Some(list(Type::Bool)),
            Takes::Ifs => Some(Type::Ifs),
            Takes::ControlPoints => Some(list(Type::Weighted(PointSpace::Any))),
            Takes::Net => Some(list(list(Type::Weighted(PointSpace::Space)))),
            Takes::Truth => Some(Type::Bool),
            Takes::Curve => Some(Type::Curve),
            Takes::SpacePoint => Some(Type::Point(PointSpace::Space)),
            Takes::Plane => Some(Type::Plane),
            Takes::SpaceVector => Some(Type::Vector(PointSpace::Space)),
            Takes::Whole => Some(Type::Int),
            Takes::Numbers => Some(list(Type::NUMBER)),
            Takes::Faces => Some(list(list(Type::Int))),
            Takes::Path => Some(Type::Text),
            Takes::Closed => Some(Type::Choice(ChoiceKind::Closed)),
            Takes::Quantity
            | Takes::QuantityOrList
            | Takes::Quantities
            | Takes::Summands
            | Takes::List
            | Takes::Lists
            | Takes::Plain => None,
        }
    }
}

/// A parameter of a native.
#[derive(Clone, Copy, Debug)]
pub struct NativeParameter {
    /// Its name.
    pub name: &'static str,
    /// What it takes.
    pub takes: Takes,
    /// Whether it must be given.
    pub required: bool,
}

/// The declaration of a native.
#[derive(Clone, Copy, Debug)]
pub struct NativeDeclaration {
    /// Which.
    pub native: Native,
    /// The module of the library it belongs to; `prelude` needs no `use`.
    pub module: &'static str,
    /// Its name.
    pub name: &'static str,
    /// What it takes.
    pub parameters: &'static [NativeParameter],
    /// One line for people.
    pub doc: &'static str,
}

const fn needs(name: &'static str, takes: Takes) -> NativeParameter {
    NativeParameter { name, takes, required: true }
}

const fn may(name: &'static str, takes: Takes) -> NativeParameter {
    NativeParameter { name, takes, required: false }
}

const fn native(
    native: Native,
    module: &'static str,
    name: &'static str,
    parameters: &'static [NativeParameter],
    doc: &'static str,
) -> NativeDeclaration {
    NativeDeclaration { native, module, name, parameters, doc }
}

/// Every native.
pub fn natives() -> impl Iterator<Item = &'static NativeDeclaration> {
    NATIVES.iter().chain(FIGURES).chain(VALUES)
}

/// The natives that make ifs, germs and figures, and the first ones of all.
const NATIVES: &[NativeDeclaration] = &[
    native(Native::Sin, "prelude", "sin", &[needs("angle", Takes::Angle)], "the sine of an angle"),
    native(Native::Cos, "prelude", "cos", &[needs("angle", Takes::Angle)], "the cosine of an angle"),
    native(Native::Tan, "prelude", "tan", &[needs("angle", Takes::Angle)], "the tangent of an angle"),
    native(
        Native::Sqrt,
        "prelude",
        "sqrt",
        &[needs("x", Takes::Quantity)],
        "the square root; of an area, a length",
    ),
    native(Native::Abs, "prelude", "abs", &[needs("x", Takes::Quantity)], "the number without its sign"),
    native(Native::Floor, "prelude", "floor", &[needs("x", Takes::Number)], "the whole number at or below"),
    native(
        Native::Round,
        "prelude",
        "round",
        &[needs("x", Takes::Number)],
        "the nearest whole number, halves up",
    ),
    native(
        Native::Min,
        "prelude",
        "min",
        &[needs("a", Takes::QuantityOrList), may("b", Takes::Quantity)],
        "the smaller of two numbers, or the smallest of a list",
    ),
    native(
        Native::Max,
        "prelude",
        "max",
        &[needs("a", Takes::QuantityOrList), may("b", Takes::Quantity)],
        "the larger of two numbers, or the largest of a list",
    ),
    native(
        Native::Sum,
        "prelude",
        "sum",
        &[needs("list", Takes::Summands)],
        "the sum of a list of numbers, of vectors, or of weighted points",
    ),
    native(Native::Len, "prelude", "len", &[needs("list", Takes::List)], "how many elements a list has"),
    native(
        Native::Mean,
        "prelude",
        "mean",
        &[needs("list", Takes::Quantities)],
        "the mean of a list of numbers",
    ),
    native(
        Native::All,
        "prelude",
        "all",
        &[needs("list", Takes::Truths)],
        "whether all of a list are true; an empty list is",
    ),
    native(
        Native::Any,
        "prelude",
        "any",
        &[needs("list", Takes::Truths)],
        "whether at least one of a list is true",
    ),
    native(
        Native::Close,
        "prelude",
        "close",
        &[needs("a", Takes::Quantity), needs("b", Takes::Quantity), needs("within", Takes::Quantity)],
        "whether two numbers differ by `within` at most",
    ),
    native(
        Native::Lerp,
        "prelude",
        "lerp",
        &[needs("a", Takes::Point), needs("b", Takes::Point), needs("t", Takes::Number)],
        "the point (1 - t) a + t b",
    ),
    native(
        Native::Interpolate,
        "prelude",
        "interpolate",
        &[needs("x", Takes::Quantity), needs("table", Takes::Points)],
        "the second coordinate at x, straight between the points of the table; an error beyond its ends",
    ),
];

impl Native {
    /// Its declaration.
    pub fn declaration(self) -> &'static NativeDeclaration {
        natives().find(|declaration| declaration.native == self).unwrap_or(&NATIVES[0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_native_is_declared_once() {
        for declaration in natives() {
            assert_eq!(declaration.native.declaration().name, declaration.name);
            assert_eq!(natives().filter(|other| other.name == declaration.name).count(), 1);
        }
    }
}
