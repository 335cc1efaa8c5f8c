//! Welding: vertices at one place are one vertex, and what is left of triangles then.
//!
//! Files part a vertex where normals or textures differ on its sides, so that even a cube is open. Here only places count,
//! on a grid of 2⁻²⁰ mm, a millionth: finer than single precision is at the size of a hand.

use super::Fault;
use glam::DVec3;
use std::collections::BTreeMap;

/// Steps of the grid in a millimetre.
const STEPS: f64 = (1_u32 << 20) as f64;

/// A surface of triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriangleMesh {
    /// Its vertices, mm, z upwards: multiples of 2⁻²⁰ mm, no two the same, each a corner of a triangle.
    pub vertices: Vec<[f64; 3]>,
    /// Its triangles as places of three different vertices, anticlockwise seen from outside, in the order of the file.
    pub triangles: Vec<[u32; 3]>,
}

/// Collects triangles.
#[derive(Debug, Default)]
pub(super) struct Welder {
    mesh: TriangleMesh,
    places: BTreeMap<[i64; 3], u32>,
    /// How many triangles of the file were looked at.
    pub(super) triangles_read: usize,
}

impl Welder {
    /// The step of the grid that is nearest to a vertex.
    pub(super) fn place_of(&mut self, vertex: DVec3) -> [i64; 3] {
        vertex.to_array().map(|coordinate| libm::rint(coordinate * STEPS) as i64)
    }

    /// Adds a triangle, unless two of its corners are at one place: then it has no surface.
    pub(super) fn add(&mut self, [a, b, c]: [[i64; 3]; 3]) {
        if a != b && b != c && c != a {
            let corners = [a, b, c].map(|corner| self.number_of(corner));
            self.mesh.triangles.push(corners);
        }
    }

    fn number_of(&mut self, place: [i64; 3]) -> u32 {
        let vertices = &mut self.mesh.vertices;
        *self.places.entry(place).or_insert_with(|| {
            vertices.push(place.map(|step| step as f64 / STEPS));
            (vertices.len() - 1) as u32
        })
    }

    pub(super) fn finish(self) -> Result<TriangleMesh, Fault> {
        match (self.mesh.triangles.is_empty(), self.triangles_read) {
            (false, _) => Ok(self.mesh),
            (true, 0) => Err(Fault::empty("its scene", "there is no surface in it: no triangles")),
            (true, read) => {
                let what = format!("of its {read} triangles none has three different corners");
                Err(Fault::empty("its scene", what))
            }
        }
    }
}
