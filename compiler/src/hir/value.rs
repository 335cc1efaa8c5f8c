//! Values: what expressions become. Immutable and cheap to copy.

use super::map::Map;
use super::placed::{Chain, Net, Swept};
use super::scalar::Scalar;
use super::schema::ChoiceKind;
use super::size::Until;
use super::tree::ItemId;
use crate::source::Span;
use std::sync::Arc;

/// A value.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Scalar(Scalar),
    /// A truth.
    Bool(bool),
    /// A text.
    Text(Arc<str>),
    /// A point, a vector, or a weighted sum on the way.
    Combination(Arc<Combination>),
    /// A point with its weight, above 0.
    Weighted(Arc<Combination>, f64),
    /// A list.
    List(Arc<Vec<Value>>),
    /// The whole numbers from the first up to below the second.
    Range(i64, i64),
    /// A length by a width, mm.
    Size(Scalar, Scalar),
    /// An affine map.
    Map(Arc<Map>),
    /// A plane of space.
    Plane(Arc<Plane>),
    /// A cut along a plane.
    Cut(Arc<Plane>),
    /// An ifs, not placed yet.
    Ifs(Arc<IfsValue>),
    /// What an ifs draws.
    Germ(Arc<Germ>),
    /// A germ that the ifs around finds itself, from its transforms or its control points.
    OwnGerm(OwnGerm),
    /// A figure.
    Figure(Arc<Figure>),
    /// A record, its fields in order.
    Record(ItemId, Arc<Vec<Value>>),
    /// Settings by name, with the place of each value.
    Settings(Arc<Vec<(&'static str, Value, Span)>>),
    /// A word of a choice, by its place.
    Choice(ChoiceKind, usize),
}

/// A plane of space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point of it, mm.
    pub point: [f64; 3],
    /// Square to it, longer than 0.
    pub normal: [f64; 3],
}

/// A weighted sum of points, in coordinates or in weights of control points.
#[derive(Clone, Debug, PartialEq)]
pub struct Combination {
    /// The sum.
    pub terms: Terms,
    /// The sum of the weights: 1 for a point, 0 for a vector.
    pub weight: Scalar,
    /// Where it was made, when by arithmetic.
    pub made: Option<Span>,
}

/// What a combination holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Terms {
    /// Two or three coordinates, mm.
    Coordinates(Vec<Scalar>),
    /// One weight a control point of the ifs around.
    Weights(Vec<Scalar>),
}

impl Terms {
    /// The numbers.
    pub fn scalars(&self) -> &[Scalar] {
        match self {
            Terms::Coordinates(scalars) | Terms::Weights(scalars) => scalars,
        }
    }
}

/// An ifs as a value.
#[derive(Clone, Debug, PartialEq)]
pub enum IfsValue {
    /// A declared ifs with its arguments.
    Instance(Instance),
    /// The product of two.
    Tensor(Instance, Instance),
    /// The image of an ifs of the plane or of space under a map.
    Mapped(Arc<Map>, Instance),
}

/// A declared ifs with its arguments: a state of the automaton.
#[derive(Clone, Debug, PartialEq)]
pub struct Instance {
    /// The ifs.
    pub ifs: ItemId,
    /// Its arguments in order.
    pub arguments: Vec<Value>,
}

/// A germ that an ifs finds itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OwnGerm {
    /// `limit`: the segment between the points that the first and the last transform keep.
    Limit,
    /// `control`: the segment between the two control points in the middle.
    Control,
}

/// What an ifs draws.
#[derive(Clone, Debug, PartialEq)]
pub struct Germ {
    /// How its vertices are drawn.
    pub shape: GermShape,
    /// Its vertices: combinations of control points, or points of the plane or of space.
    pub vertices: Vec<Arc<Combination>>,
}

/// How the vertices of a germ are drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum GermShape {
    /// One vertex.
    Point,
    /// A straight line between two vertices.
    Segment,
    /// A closed polygon.
    Polygon,
    /// A bar between two vertices.
    Strut {
        /// Side of its section, mm.
        width: Scalar,
    },
    /// Faces over the vertices.
    Mesh {
        /// Each face as places of vertices.
        faces: Arc<Vec<Vec<u32>>>,
    },
}

/// An ifs on control points, at a level or not yet.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// What is placed where.
    pub shape: Shape,
    /// The level, in one or two directions.
    pub level: Option<Level>,
    /// The expression that placed it.
    pub span: Span,
}

/// A level and where it is said.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// In the first direction.
    pub u: u32,
    /// In the second direction, where it differs.
    pub v: Option<u32>,
    /// The size by which the level is to be found, where it is not given; it is 0 until then.
    pub until: Option<Until>,
    /// Where.
    pub span: Span,
}

/// What is placed where.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// One ifs on a list of control points.
    Curve {
        /// The ifs.
        ifs: Instance,
        /// Coordinates in mm; all points have the same number of them.
        points: Vec<[f64; 3]>,
        /// 2 or 3.
        dimension: u8,
    },
    /// The product of two ifs on a grid of control points.
    Sheet {
        /// The ifs along the rows' order.
        u: Instance,
        /// The ifs along a row.
        v: Instance,
        /// Row by row, coordinates in mm.
        net: Vec<[f64; 3]>,
        /// How many rows.
        rows: usize,
        /// How many columns.
        columns: usize,
        /// Whether every window of the net is used, or the net is just one window.
        windows: bool,
    },
    /// One ifs on windows of a list, closed, or on points with weights.
    Chain(Box<Chain>),
    /// The product of two ifs on a net that is closed or has weights.
    Net(Box<Net>),
    /// A surface made of curves.
    Swept(Box<Swept>),
}

impl Value {
    /// The number.
    pub fn scalar(&self) -> Option<&Scalar> {
        match self {
            Value::Scalar(scalar) => Some(scalar),
            _ => None,
        }
    }

    /// The number as a double.
    pub fn number(&self) -> Option<f64> {
        self.scalar()?.to_f64()
    }

    /// The elements of a list.
    pub fn list(&self) -> Option<&[Value]> {
        match self {
            Value::List(list) => Some(list),
            _ => None,
        }
    }
}
