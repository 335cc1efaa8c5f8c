//! [`Germ`]: what a state draws, as rows of weights on its control points. How it looks in space is not said here.

use std::sync::Arc;

use crate::exact::Rational;

/// How the vertices of a germ are drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum GermShape {
    /// One vertex.
    Point,
    /// A straight segment from the first vertex to the second.
    Segment,
    /// A closed polygon of at least three vertices; a quad has four.
    Polygon,
    /// A bar from the first vertex to the second. Further vertices, where there are any, say how its section lies: they
    /// are the first vertex moved by half the width along each of the section's axes, so that the bar is mapped as a whole.
    Strut {
        /// Side of its square section at level 0, mm; above 0.
        width: Rational,
    },
    /// Faces over the vertices.
    Mesh {
        /// Each face as places of vertices, at least three.
        faces: Arc<Vec<Vec<u32>>>,
    },
}

/// What is drawn of a state: vertices in weights on its control points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Germ {
    /// How they are drawn.
    pub shape: GermShape,
    /// One row of weights a vertex.
    pub vertices: Vec<Vec<Rational>>,
}

impl Germ {
    /// A straight segment.
    pub fn segment(start: Vec<Rational>, end: Vec<Rational>) -> Germ {
        Germ { shape: GermShape::Segment, vertices: vec![start, end] }
    }

    /// The ends of a segment; `None` for any other germ.
    pub fn ends(&self) -> Option<(&[Rational], &[Rational])> {
        match (&self.shape, self.vertices.as_slice()) {
            (GermShape::Segment, [start, end]) => Some((start, end)),
            _ => None,
        }
    }

    /// An edge of a polygon, from vertex `edge` to the next one around; `None` for any other germ and beyond the last.
    pub fn edge(&self, edge: usize) -> Option<(&[Rational], &[Rational])> {
        let start = self.vertices.get(edge).filter(|_| self.shape == GermShape::Polygon)?;
        Some((start, &self.vertices[(edge + 1) % self.vertices.len()]))
    }

    /// Whether it has as many vertices as its shape needs, and faces of vertices that are there.
    pub fn is_complete(&self) -> bool {
        let count = self.vertices.len();
        match &self.shape {
            GermShape::Point => count == 1,
            GermShape::Segment => count == 2,
            GermShape::Polygon => count >= 3,
            GermShape::Strut { .. } => (2..=4).contains(&count),
            GermShape::Mesh { faces } => {
                let whole =
                    |face: &Vec<u32>| face.len() >= 3 && face.iter().all(|place| (*place as usize) < count);
                faces.iter().all(whole)
            }
        }
    }
}
