//! Bodies painted in a view: solids with their visible faces and edges, quads of surfaces, polygons.

use std::collections::BTreeMap;

use glam::DVec3;

use super::colour::{Srgb, hex, lit};
use super::depth_order::{Hull, back_to_front};
use super::paper::{Path, group};
use super::view::Frame;
use crate::export::html::markup::Markup;
use crate::fabricate::solid::Solid;

/// Faces whose normals have a larger cosine are one face to the eye.
const ONE_FACE: f64 = 0.985;

/// Something to paint.
#[derive(Debug, Clone)]
pub(in crate::export::html) struct Body {
    vertices: Vec<DVec3>,
    /// Corners of each face, with its unit normal.
    faces: Vec<(Vec<u32>, DVec3)>,
    /// Whether it encloses space, so that faces turned away are hidden.
    closed: bool,
    colour: Srgb,
    /// What a pointer over it is told.
    title: Option<String>,
}

impl Body {
    /// A solid.
    pub(in crate::export::html) fn of_solid(solid: &Solid, colour: Srgb, title: &str) -> Self {
        let at = |corner: u32| solid.vertices[corner as usize];
        let faces = solid.triangles.iter().filter_map(|&[a, b, c]| {
            let normal = (at(b) - at(a)).cross(at(c) - at(a)).try_normalize()?;
            Some((vec![a, b, c], normal))
        });
        let vertices = solid.vertices.clone();
        Self { faces: faces.collect(), vertices, closed: true, colour, title: Some(title.to_owned()) }
    }

    /// A polygon, plane or nearly so, seen from both sides.
    pub(in crate::export::html) fn of_polygon(corners: &[DVec3], colour: Srgb, title: Option<&str>) -> Self {
        // The area vector, worked out from a corner: far from the origin its digits would cancel.
        let from = corners.first().copied().unwrap_or_default();
        let area = corners.windows(2).map(|pair| (pair[0] - from).cross(pair[1] - from)).sum::<DVec3>();
        let normal = area.try_normalize().unwrap_or(DVec3::Z);
        Self {
            vertices: corners.to_vec(),
            faces: vec![((0..corners.len() as u32).collect(), normal)],
            closed: false,
            colour,
            title: title.map(str::to_owned),
        }
    }

    /// Its corners.
    pub(in crate::export::html) fn corners(&self) -> impl Iterator<Item = DVec3> + '_ {
        self.vertices.iter().copied()
    }

    fn hull(&self) -> Hull {
        let middle = |corners: &[u32]| {
            corners.iter().map(|corner| self.vertices[*corner as usize]).sum::<DVec3>() / corners.len() as f64
        };
        let planes = self.faces.iter().map(|(corners, normal)| (*normal, normal.dot(middle(corners))));
        Hull { corners: self.vertices.clone(), planes: planes.collect() }
    }

    fn paint(&self, page: &mut Markup, frame: &Frame) {
        let toward = frame.view.toward;
        let visible: Vec<usize> = (0..self.faces.len())
            .filter(|&face| !self.closed || self.faces[face].1.dot(toward) > 1e-9)
            .collect();
        for (normal, faces) in self.joined(&visible) {
            let facing = if normal.dot(toward) < 0.0 { -normal } else { normal };
            let fill = hex(lit(self.colour, frame.view.brightness(facing)));
            let mut path = Path::default();
            for face in faces {
                let corners = self.faces[face].0.iter().map(|corner| self.vertices[*corner as usize]);
                path.chain(&corners.map(|corner| frame.paper(corner)).collect::<Vec<_>>(), true);
            }
            // The seams between triangles of one face are covered in its own colour.
            let own = [("fill", fill.as_str()), ("stroke", fill.as_str())];
            path.write(page, if self.closed { &own } else { &own[..1] });
        }
        let edges = if self.closed { self.edges(&visible, frame) } else { Path::default() };
        if !edges.is_empty() {
            edges.write(page, &[]);
        }
    }

    /// Visible faces by what looks like one face.
    fn joined(&self, visible: &[usize]) -> Vec<(DVec3, Vec<usize>)> {
        let mut groups: Vec<(DVec3, Vec<usize>)> = Vec::new();
        for &face in visible {
            let normal = self.faces[face].1;
            match groups.iter_mut().find(|(found, _)| found.dot(normal) > ONE_FACE) {
                Some((_, faces)) => faces.push(face),
                None => groups.push((normal, vec![face])),
            }
        }
        groups
    }

    /// The edges of visible faces, without those within one face.
    fn edges(&self, visible: &[usize], frame: &Frame) -> Path {
        let mut sides: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
        for &face in visible {
            let corners = &self.faces[face].0;
            for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
                sides.entry([*a.min(b), *a.max(b)]).or_default().push(face);
            }
        }
        let mut path = Path::default();
        for (ends, faces) in sides {
            let within = matches!(faces[..], [a, b] if self.faces[a].1.dot(self.faces[b].1) > ONE_FACE);
            if !within {
                path.chain(&ends.map(|end| frame.paper(self.vertices[end as usize])), false);
            }
        }
        path
    }
}

/// Paints bodies, the hidden ones first.
pub(in crate::export::html) fn paint(page: &mut Markup, frame: &Frame, bodies: &[Body]) {
    let hulls: Vec<Hull> = bodies.iter().map(Body::hull).collect();
    group(page, "bodies", |page| {
        for place in back_to_front(frame.view, &hulls) {
            let body = &bodies[place];
            match &body.title {
                Some(title) => page.element("g", &[], |page| {
                    page.texts("title", &[], title);
                    body.paint(page, frame);
                }),
                None => body.paint(page, frame),
            }
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::html::draw::view::View;
    use glam::DVec2;

    #[test]
    fn a_cube_shows_three_faces_and_nine_edges() {
        let square = crate::geometry::samples::square(100.0);
        let cube =
            Solid::between(square, square.map(|corner| corner + DVec3::Z * 100.0), [[0, 1, 2], [2, 3, 0]]);
        let body = Body::of_solid(&cube, [1.0; 3], "<cube>");
        let frame = Frame::fitted(View::axonometric(), body.corners(), DVec2::splat(50.0)).unwrap();
        let mut page = Markup::default();
        paint(&mut page, &frame, &[body]);
        let text = page.finish();
        assert_eq!(text.matches("fill=").count(), 3, "{text}");
        let edges = text.rsplit("<path d=\"").next().unwrap();
        assert_eq!(edges.matches('M').count(), 9, "{edges}");
        assert!(text.contains("<title>&lt;cube&gt;</title>"));
    }
}
