//! How large an element is: what `until` compares (LANGUAGE 6). Not the requirements of boards, which measure what is
//! made.

pub use crate::hir::size::{SizeBound, SizeMeasure};
use crate::ifs::GermShape;

/// Vertices up to which a diameter is measured pair by pair; beyond, the diagonal of the bounding box stands for it,
/// which is never smaller.
const PAIRED_VERTICES: usize = 32;

impl SizeMeasure {
    /// Whether an element of this shape has it.
    pub fn applies_to(self, shape: &GermShape) -> bool {
        match (self, shape) {
            (SizeMeasure::Edge | SizeMeasure::Size, shape) => *shape != GermShape::Point,
            (SizeMeasure::Length, shape) => matches!(shape, GermShape::Segment | GermShape::Strut { .. }),
        }
    }

    /// The measure of one element; `None` where it has none.
    pub fn of(self, shape: &GermShape, vertices: &[[f64; 3]]) -> Option<SizeRange> {
        match (self, shape) {
            (_, GermShape::Segment | GermShape::Strut { .. }) => match vertices {
                [start, end, ..] => Some(SizeRange::one(distance(*start, *end))),
                _ => None,
            },
            (_, GermShape::Point) => None,
            (SizeMeasure::Size, _) => Some(SizeRange::one(diameter(vertices))),
            (SizeMeasure::Edge, GermShape::Polygon) => sides(vertices.iter().copied()),
            (SizeMeasure::Edge, GermShape::Mesh { faces }) => {
                let face =
                    |face: &Vec<u32>| sides(face.iter().filter_map(|at| vertices.get(*at as usize).copied()));
                faces.iter().filter_map(face).reduce(SizeRange::with)
            }
            (SizeMeasure::Length, _) => None,
        }
    }
}

/// The smallest and the largest of something, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizeRange {
    /// The smallest.
    pub least: f64,
    /// The largest.
    pub most: f64,
}

impl SizeRange {
    /// Of one thing.
    pub fn one(size: f64) -> SizeRange {
        SizeRange { least: size, most: size }
    }

    /// Of these and those.
    #[must_use]
    pub fn with(self, other: SizeRange) -> SizeRange {
        SizeRange { least: self.least.min(other.least), most: self.most.max(other.most) }
    }
}

/// The distance of two points.
pub fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let [x, y, z] = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    (x * x + y * y + z * z).sqrt()
}

fn sides(corners: impl Iterator<Item = [f64; 3]> + Clone) -> Option<SizeRange> {
    let next = corners.clone().skip(1).chain(corners.clone().take(1));
    corners.zip(next).map(|(a, b)| SizeRange::one(distance(a, b))).reduce(SizeRange::with)
}

fn diameter(vertices: &[[f64; 3]]) -> f64 {
    if vertices.len() > PAIRED_VERTICES {
        let corner = |pick: fn(f64, f64) -> f64, start: f64| {
            vertices
                .iter()
                .fold([start; 3], |all, vertex| [0, 1, 2].map(|axis| pick(all[axis], vertex[axis])))
        };
        return distance(corner(f64::min, f64::INFINITY), corner(f64::max, f64::NEG_INFINITY));
    }
    let pairs =
        vertices.iter().enumerate().flat_map(|(place, a)| vertices[..place].iter().map(move |b| (a, b)));
    pairs.map(|(a, b)| distance(*a, *b)).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measures_of_shapes() {
        let square = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [3.0, 4.0, 0.0], [0.0, 4.0, 0.0]];
        let of = |measure: SizeMeasure, shape: &GermShape, count: usize| measure.of(shape, &square[..count]);
        assert_eq!(of(SizeMeasure::Edge, &GermShape::Polygon, 4), Some(SizeRange { least: 3.0, most: 4.0 }));
        assert_eq!(of(SizeMeasure::Size, &GermShape::Polygon, 4), Some(SizeRange::one(5.0)));
        assert_eq!(of(SizeMeasure::Length, &GermShape::Polygon, 4), None);
        assert_eq!(of(SizeMeasure::Length, &GermShape::Segment, 2), Some(SizeRange::one(3.0)));
        assert_eq!(of(SizeMeasure::Size, &GermShape::Point, 1), None);
        let faces = GermShape::Mesh { faces: std::sync::Arc::new(vec![vec![0, 1, 2]]) };
        assert_eq!(of(SizeMeasure::Edge, &faces, 4), Some(SizeRange { least: 3.0, most: 5.0 }));
        for measure in SizeMeasure::ALL {
            let shapes =
                [(GermShape::Point, 1), (GermShape::Segment, 2), (GermShape::Polygon, 4), (faces.clone(), 4)];
            for (shape, count) in shapes {
                assert_eq!(
                    of(measure, &shape, count).is_some(),
                    measure.applies_to(&shape),
                    "{measure:?} {shape:?}"
                );
            }
        }
    }

    #[test]
    fn many_vertices_are_measured_by_their_box() {
        let many: Vec<[f64; 3]> =
            (0..40).map(|i| [f64::from(i % 2) * 3.0, f64::from(i / 20) * 4.0, 0.0]).collect();
        assert_eq!(SizeMeasure::Size.of(&GermShape::Polygon, &many), Some(SizeRange::one(5.0)));
    }
}
