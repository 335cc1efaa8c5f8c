//! The types of the language and when one serves where another is needed.

use super::dimension::Dimension;
use super::schema::{ChoiceKind, SchemaKind};
use super::tree::ItemId;

/// The space points and vectors live in, as far as it is known before evaluation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum PointSpace {
    /// Two coordinates.
    Plane,
    /// Three coordinates.
    Space,
    /// The control points of the ifs around.
    Control,
    /// Known only when evaluated.
    Any,
}

/// A type.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Type {
    /// A whole number; serves as a `Number`.
    Int,
    /// A number with a dimension; `Number` has none.
    Quantity(Dimension),
    /// True or false.
    Bool,
    /// A text.
    Text,
    /// A point: weights sum to 1.
    Point(PointSpace),
    /// A vector: weights sum to 0.
    Vector(PointSpace),
    /// A weighted sum of points whose sum is known only when evaluated.
    WeightedSum(PointSpace),
    /// A point with a weight, or a point: a control point of a rational figure.
    Weighted(PointSpace),
    /// A list.
    List(Box<Type>),
    /// `a .. b` of whole numbers.
    IntRange,
    /// `2500mm by 1250mm`
    Size,
    /// An affine map.
    Map(PointSpace),
    /// An iterated function system, not placed yet.
    Ifs,
    /// What an ifs draws at its last level.
    Germ,
    /// A figure whose pieces join along a line.
    Curve,
    /// A figure whose pieces join along their edges.
    Surface,
    /// Any figure.
    Figure,
    /// A record declared in the language.
    Record(ItemId),
    /// One of a closed set of words.
    Choice(ChoiceKind),
    /// `{ name: value }` with fields the program knows.
    Settings(SchemaKind),
    /// A plane of space.
    Plane,
    /// How an end of a curve of planks is cut.
    Cut,
    /// Any record that says what a board is made of.
    Material,
    /// Not understood; a diagnostic has been given. Serves everywhere.
    Error,
}

impl Type {
    /// A plain number.
    pub const NUMBER: Type = Type::Quantity(Dimension::NUMBER);
    /// A length.
    pub const LENGTH: Type = Type::Quantity(Dimension::LENGTH);
    /// An angle.
    pub const ANGLE: Type = Type::Quantity(Dimension::ANGLE);

    /// Its dimension, where it is a number.
    pub fn dimension(&self) -> Option<Dimension> {
        match self {
            Type::Int => Some(Dimension::NUMBER),
            Type::Quantity(dimension) => Some(*dimension),
            _ => None,
        }
    }

    /// The space of a point, vector or weighted sum.
    pub fn point_space(&self) -> Option<PointSpace> {
        match self {
            Type::Point(space) | Type::Vector(space) | Type::WeightedSum(space) => Some(*space),
            _ => None,
        }
    }

    /// The smallest type that serves for both, for the elements of a list and the branches of a condition.
    pub fn join(&self, other: &Type) -> Option<Type> {
        match (self, other) {
            (Type::Error, any) | (any, Type::Error) => Some(any.clone()),
            (a, b) if a == b => Some(a.clone()),
            (Type::Int, Type::Quantity(d)) | (Type::Quantity(d), Type::Int) if *d == Dimension::NUMBER => {
                Some(Type::NUMBER)
            }
            (Type::List(a), Type::List(b)) => Some(Type::List(Box::new(a.join(b)?))),
            (Type::Point(a), Type::Point(b)) => Some(Type::Point(a.join(*b)?)),
            (Type::Vector(a), Type::Vector(b)) => Some(Type::Vector(a.join(*b)?)),
            (Type::Map(a), Type::Map(b)) => Some(Type::Map(a.join(*b)?)),
            (Type::Weighted(a), Type::Weighted(b) | Type::Point(b) | Type::WeightedSum(b))
            | (Type::Point(a) | Type::WeightedSum(a), Type::Weighted(b)) => Some(Type::Weighted(a.join(*b)?)),
            (a, b) if a.is_figure() && b.is_figure() => Some(Type::Figure),
            (a, b) => {
                let space = a.point_space()?.join(b.point_space()?)?;
                Some(Type::WeightedSum(space))
            }
        }
    }

    /// Whether values of the two can be the same: numbers of one dimension, truths, texts, points and vectors, records
    /// of one type, words of one choice, and lists of these.
    pub fn equals(&self, other: &Type) -> bool {
        match (self, other) {
            (Type::Error, _) | (_, Type::Error) => true,
            (Type::Bool, Type::Bool) | (Type::Text, Type::Text) | (Type::Size, Type::Size) => true,
            (Type::List(a), Type::List(b)) => a.equals(b),
            (Type::Point(a), Type::Point(b)) | (Type::Vector(a), Type::Vector(b)) => {
                *a != PointSpace::Control && *b != PointSpace::Control && a.join(*b).is_some()
            }
            (Type::Record(a), Type::Record(b)) => a == b,
            (Type::Choice(a), Type::Choice(b)) => a == b,
            (a, b) => a.dimension().is_some() && a.dimension() == b.dimension(),
        }
    }

    /// The same with points for weighted points.
    pub fn unweighted(&self) -> Type {
        match self {
            Type::Weighted(space) => Type::Point(*space),
            Type::List(element) => Type::List(Box::new(element.unweighted())),
            other => other.clone(),
        }
    }

    /// Whether it is a figure of any kind.
    pub fn is_figure(&self) -> bool {
        matches!(self, Type::Curve | Type::Surface | Type::Figure)
    }
}

impl PointSpace {
    /// How many coordinates a point has, where that is known.
    pub fn coordinates(self) -> Option<usize> {
        match self {
            PointSpace::Plane => Some(2),
            PointSpace::Space => Some(3),
            PointSpace::Control | PointSpace::Any => None,
        }
    }

    /// A thing of this space in words: `a map of the plane`.
    pub fn thing(self, what: &str) -> String {
        match self {
            PointSpace::Plane => format!("a {what} of the plane"),
            PointSpace::Space => format!("a {what} in space"),
            PointSpace::Control if what == "point" => "a combination of control points".to_owned(),
            PointSpace::Control => format!("a {what} between control points"),
            PointSpace::Any => format!("a {what}"),
        }
    }

    /// Many things of this space in words, `points in space`; none where the space is not known.
    pub fn things(self, what: &str) -> Option<String> {
        match self {
            PointSpace::Plane => Some(format!("{what}s of the plane")),
            PointSpace::Space => Some(format!("{what}s in space")),
            PointSpace::Control if what == "point" => Some("combinations of control points".to_owned()),
            PointSpace::Control => Some(format!("{what}s between control points")),
            PointSpace::Any => None,
        }
    }

    /// Where an ifs of this space lives, in words.
    pub fn words(self) -> &'static str {
        match self {
            PointSpace::Plane => "in the plane",
            PointSpace::Space => "in space",
            PointSpace::Control => "on control points",
            PointSpace::Any => "in the plane or in space",
        }
    }

    /// The space of both, `None` where they differ.
    pub fn join(self, other: PointSpace) -> Option<PointSpace> {
        match (self, other) {
            (PointSpace::Any, space) | (space, PointSpace::Any) => Some(space),
            (a, b) => (a == b).then_some(a),
        }
    }
}
