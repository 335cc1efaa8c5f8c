//! One element of separate pieces as vertices, lines and triangles.

use std::collections::BTreeSet;

use glam::DVec3;

use super::split::split;
use crate::plan::evaluate::{DrawnGerm, GermShape};

/// Corners of a strut: four around its first end, then four around its second.
const STRUT_CORNERS: usize = 8;

const STRUT_TRIANGLES: [[u32; 3]; 12] = [
    [0, 2, 1],
    [0, 3, 2],
    [4, 5, 6],
    [4, 6, 7],
    [0, 1, 5],
    [0, 5, 4],
    [1, 2, 6],
    [1, 6, 5],
    [2, 3, 7],
    [2, 7, 6],
    [3, 0, 4],
    [3, 4, 7],
];

/// How a germ is drawn: what does not depend on where an element lies.
#[derive(Debug)]
pub(super) struct Drawing {
    shape: GermShape,
    /// Vertices in the model.
    pub(super) vertices: usize,
    /// Lines, as places of vertices.
    pub(super) lines: Vec<[u32; 2]>,
    /// How many triangles.
    pub(super) triangles: usize,
}

impl Drawing {
    pub(super) fn of(germ: &DrawnGerm) -> Drawing {
        let count = germ.vertices;
        let ring = |places: &[u32]| -> Vec<[u32; 2]> {
            let next = places.iter().cycle().skip(1);
            places.iter().zip(next).map(|(a, b)| [*a.min(b), *a.max(b)]).filter(|[a, b]| a != b).collect()
        };
        let all: Vec<u32> = (0..count).collect();
        let (vertices, lines, triangles) = match &germ.shape {
            GermShape::Point => (1, Vec::new(), 0),
            GermShape::Segment => (2, vec![[0, 1]], 0),
            GermShape::Polygon => (count as usize, ring(&all), all.len() - 2),
            GermShape::Strut { .. } => {
                let along = (0..4).map(|corner| [corner, corner + 4]);
                let lines = ring(&[0, 1, 2, 3]).into_iter().chain(ring(&[4, 5, 6, 7])).chain(along);
                (STRUT_CORNERS, lines.collect(), STRUT_TRIANGLES.len())
            }
            GermShape::Mesh { faces } => {
                let sides: BTreeSet<[u32; 2]> = faces.iter().flat_map(|face| ring(face)).collect();
                let triangles = faces.iter().map(|face| face.len() - 2).sum();
                (count as usize, sides.into_iter().collect(), triangles)
            }
        };
        Drawing { shape: germ.shape.clone(), vertices, lines, triangles }
    }

    /// The word for its kind.
    pub(super) fn kind(&self) -> &'static str {
        match self.shape {
            GermShape::Point => "point",
            GermShape::Segment => "segment",
            GermShape::Polygon => "polygon",
            GermShape::Strut { .. } => "strut",
            GermShape::Mesh { .. } => "mesh",
        }
    }

    /// Whether it is a point.
    pub(super) fn is_point(&self) -> bool {
        self.shape == GermShape::Point
    }

    /// Turns the vertices of an element into those of the model.
    pub(super) fn place(&self, vertices: &mut Vec<DVec3>) {
        if let GermShape::Strut { width } = &self.shape
            && let Some(corners) = strut(vertices, width.to_f64())
        {
            vertices.clear();
            vertices.extend(corners);
        }
    }

    /// Gives the triangles of an element with these vertices of the model.
    pub(super) fn triangulate(&self, vertices: &[DVec3], mut found: impl FnMut([u32; 3])) {
        match &self.shape {
            GermShape::Point | GermShape::Segment => {}
            GermShape::Strut { .. } => STRUT_TRIANGLES.into_iter().for_each(found),
            GermShape::Polygon => {
                let all: Vec<u32> = (0..vertices.len() as u32).collect();
                polygon(vertices, &all, &mut found);
            }
            GermShape::Mesh { faces } => {
                faces.iter().for_each(|face| polygon(vertices, face, &mut found));
            }
        }
    }
}

/// The corners of a bar with a square section. The third and fourth vertex, where it has them, are its first end moved
/// by half the width along the axes of the section; an axis that is missing is laid level, or square to the other.
fn strut(vertices: &[DVec3], width: f64) -> Option<[DVec3; STRUT_CORNERS]> {
    let [start, end, axes @ ..] = vertices else { return None };
    let along = (*end - *start).try_normalize().unwrap_or(DVec3::Z);
    let level = along.cross(DVec3::Z).try_normalize().unwrap_or(DVec3::X);
    let first = axes.first().map_or(level * (width / 2.0), |corner| *corner - *start);
    let square = along.cross(first).try_normalize().unwrap_or(DVec3::Y);
    let second = axes.get(1).map_or(square * first.length(), |corner| *corner - *start);
    // Seen along the bar the corners go around to the left, so that its faces look outwards; a mirrored bar is turned.
    let second = if first.cross(second).dot(along) < 0.0 { -second } else { second };
    let around = [first + second, second - first, -first - second, first - second];
    let corner = |place: usize| [*start, *end][place / 4] + around[place % 4];
    Some(std::array::from_fn(corner))
}

/// A simple polygon, plane or nearly so, as two triangles fewer than it has corners. Ears are cut where they turn the
/// way of the whole and hold no other corner; where there is none left, what remains is a fan.
fn polygon(vertices: &[DVec3], face: &[u32], found: &mut impl FnMut([u32; 3])) {
    let at = |place: u32| vertices[place as usize];
    match *face {
        [a, b, c] => return found([a, b, c]),
        [a, b, c, d] => {
            let triangles = split([at(a), at(b), at(c), at(d)]).triangles();
            return triangles
                .into_iter()
                .for_each(|triangle| found(triangle.map(|corner| [a, b, c, d][corner])));
        }
        _ => {}
    }
    let mut left = face.to_vec();
    let sides = face.iter().zip(face.iter().cycle().skip(1));
    let normal: DVec3 = sides.map(|(a, b)| (at(*a) - at(face[0])).cross(at(*b) - at(face[0]))).sum();
    while left.len() > 3 {
        let ear = (0..left.len()).find(|place| is_ear(vertices, &left, *place, normal)).unwrap_or(1);
        let count = left.len();
        found([left[(ear + count - 1) % count], left[ear], left[(ear + 1) % count]]);
        left.remove(ear);
    }
    if let [a, b, c] = *left {
        found([a, b, c]);
    }
}

fn is_ear(vertices: &[DVec3], left: &[u32], place: usize, normal: DVec3) -> bool {
    let count = left.len();
    let corners = [left[(place + count - 1) % count], left[place], left[(place + 1) % count]];
    let [a, b, c] = corners.map(|corner| vertices[corner as usize]);
    let turn = |from: DVec3, over: DVec3, to: DVec3| (over - from).cross(to - from).dot(normal);
    if turn(a, b, c) <= 0.0 {
        return false;
    }
    let inside =
        |point: DVec3| turn(a, b, point) >= 0.0 && turn(b, c, point) >= 0.0 && turn(c, a, point) >= 0.0;
    !left.iter().any(|other| !corners.contains(other) && inside(vertices[*other as usize]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;

    fn germ(shape: GermShape, vertices: u32) -> DrawnGerm {
        DrawnGerm { shape, vertices, kept: None }
    }

    fn area(vertices: &[DVec3], drawing: &Drawing) -> (f64, usize) {
        let (mut area, mut count) = (0.0, 0);
        drawing.triangulate(vertices, |corners| {
            let [a, b, c] = corners.map(|corner| vertices[corner as usize]);
            area += (b - a).cross(c - a).dot(DVec3::Z) / 2.0;
            count += 1;
        });
        (area, count)
    }

    #[test]
    fn polygons_fall_into_triangles_that_do_not_overlap() {
        // An L, a comb and a square, all simple; the sum of signed areas is the area only where none is turned over.
        let l = [(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)];
        let comb =
            [(0, 0), (5, 0), (5, 4), (4, 4), (4, 1), (3, 1), (3, 4), (2, 4), (2, 1), (1, 1), (1, 4), (0, 4)];
        for (outline, expected) in
            [(&l[..], 6.0), (&comb[..], 14.0), (&[(0, 0), (2, 0), (2, 2), (0, 2)][..], 4.0)]
        {
            for turned in 0..outline.len() {
                let mut corners: Vec<DVec3> =
                    outline.iter().map(|(x, y)| DVec3::new(f64::from(*x), f64::from(*y), 7.0)).collect();
                corners.rotate_left(turned);
                let drawing = Drawing::of(&germ(GermShape::Polygon, corners.len() as u32));
                assert_eq!(area(&corners, &drawing), (expected, corners.len() - 2));
                assert_eq!((drawing.triangles, drawing.lines.len()), (corners.len() - 2, corners.len()));
            }
        }
        let flat = vec![DVec3::ZERO; 6];
        let drawing = Drawing::of(&germ(GermShape::Polygon, 6));
        assert_eq!(area(&flat, &drawing), (0.0, 4));
    }

    #[test]
    fn struts_are_closed_bars_of_their_width_that_look_outwards() {
        let width = crate::plan::evaluate::GermShape::Strut { width: 160.into() };
        let (start, end) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, 402.0, 303.0));
        let axis = DVec3::X * 80.0;
        let across = DVec3::new(0.0, 48.0, -64.0);
        let bars = [
            vec![start, end],
            vec![start, end, start + axis],
            vec![start, end, start + axis, start + across],
            vec![start, end, start + axis, start - across],
            vec![start, start + DVec3::Z * 500.0],
        ];
        for mut vertices in bars {
            let drawing = Drawing::of(&germ(width.clone(), vertices.len() as u32));
            drawing.place(&mut vertices);
            assert_eq!((vertices.len(), drawing.lines.len()), (8, 12));
            let mut volume = 0.0;
            drawing.triangulate(&vertices, |corners| {
                let [a, b, c] = corners.map(|corner| vertices[corner as usize] - start);
                volume += a.dot(b.cross(c)) / 6.0;
            });
            assert!((volume / (500.0 * 160.0 * 160.0) - 1.0).abs() < 1e-12, "{volume}");
        }
    }

    #[test]
    fn a_mesh_shows_each_side_once() {
        let faces = Arc::new(vec![vec![0, 1, 2], vec![0, 2, 3, 4]]);
        let drawing = Drawing::of(&germ(GermShape::Mesh { faces }, 5));
        assert_eq!((drawing.vertices, drawing.lines.len(), drawing.triangles), (5, 6, 3));
    }
}
