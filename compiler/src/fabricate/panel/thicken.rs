//! From a board that lies flat to the board in space: split along the fold and bent there.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};

use crate::fabricate::solid::Solid;
use crate::geometry::Diagonal;

/// What lies this close to the fold lies on it, mm.
const ON_FOLD: f64 = 0.01;

/// Where the two triangles of a quad lie in space and on the flat board.
pub(super) struct Bending {
    /// The start of the diagonal on the flat board, and the unit vector along it.
    flat: (DVec2, DVec2),
    /// The same in space.
    space: (DVec3, DVec3),
    /// Unit normals of the triangle on the left of the diagonal and of that on its right.
    normals: [DVec3; 2],
    /// Their heights over the diagonal, mm.
    heights: [f64; 2],
}

impl Bending {
    /// Of the quad A, B, C, D in space (mm, convex, folded by less than a right angle over `split`) and its design
    /// outline.
    pub(super) fn of(corners: &[DVec3; 4], outline: &[DVec2; 4], split: Diagonal) -> Self {
        let [from, to] = split.ends();
        let along = (outline[to] - outline[from]).normalize_or(DVec2::X);
        let [right, left] = split.triangles().map(|[a, b, c]| {
            let normal = (corners[b] - corners[a]).cross(corners[c] - corners[a]).normalize_or_zero();
            (normal, along.perp_dot(outline[b] - outline[from]).abs())
        });
        // The first triangle holds side 0 or side 3, in the direction around the quad: where its apex lies says which
        // is left of the diagonal.
        let first_apex = split.triangles()[0][1];
        let first_left = along.perp_dot(outline[first_apex] - outline[from]) > 0.0;
        let [left, right] = if first_left { [right, left] } else { [left, right] };
        Self {
            flat: (outline[from], along),
            space: (corners[from], (corners[to] - corners[from]).normalize_or(DVec3::X)),
            normals: [left.0, right.0],
            heights: [left.1, right.1],
        }
    }

    /// The distance to the left of the fold, 0 on it.
    fn beside(&self, point: DVec3) -> f64 {
        let distance = self.flat.1.perp_dot(point.truncate() - self.flat.0);
        if distance.abs() < ON_FOLD { 0.0 } else { distance }
    }

    /// A point of the flat board in space.
    ///
    /// At the apex of its triangle a point moves along the normal with its height over the surface; on the fold along
    /// the mitre (n + n′)/(1 + n·n′) of both normals, so that the two halves stay together and parallel to their
    /// triangles; in between, in proportion.
    fn place(&self, point: DVec3) -> DVec3 {
        let beside = self.flat.1.perp_dot(point.truncate() - self.flat.0);
        let along = self.flat.1.dot(point.truncate() - self.flat.0);
        let half = usize::from(beside < 0.0);
        let [normal, other] = [self.normals[half], self.normals[1 - half]];
        let mitre = (normal + other) / (1.0 + normal.dot(other));
        let share = (1.0 - beside.abs() / self.heights[half]).clamp(0.0, 1.0);
        let left = normal.cross(self.space.1);
        self.space.0
            + self.space.1 * along
            + left * beside
            + normal * point.z
            + (mitre - normal) * (share * point.z)
    }

    /// The board in space.
    pub(super) fn bend(&self, flat: Solid) -> Solid {
        let mut solid = self.split(flat);
        for vertex in &mut solid.vertices {
            *vertex = self.place(*vertex);
        }
        solid
    }

    /// The triangles which cross the fold cut in two there.
    fn split(&self, mut solid: Solid) -> Solid {
        let mut beside: Vec<f64> = solid.vertices.iter().map(|vertex| self.beside(*vertex)).collect();
        let mut crossings: BTreeMap<(u32, u32), u32> = BTreeMap::new();
        for triangle in std::mem::take(&mut solid.triangles) {
            let mut halves = [Vec::with_capacity(4), Vec::with_capacity(4)];
            for (place, &from) in triangle.iter().enumerate() {
                let to = triangle[(place + 1) % 3];
                let (u, v) = (beside[from as usize], beside[to as usize]);
                if u >= 0.0 {
                    halves[0].push(from);
                }
                if u <= 0.0 {
                    halves[1].push(from);
                }
                if u * v < 0.0 {
                    let crossing = *crossings.entry((from.min(to), from.max(to))).or_insert_with(|| {
                        let [p, q] = [from.min(to), from.max(to)];
                        let share = beside[p as usize] / (beside[p as usize] - beside[q as usize]);
                        solid
                            .vertices
                            .push(solid.vertices[p as usize].lerp(solid.vertices[q as usize], share));
                        beside.push(0.0);
                        solid.vertices.len() as u32 - 1
                    });
                    halves.iter_mut().for_each(|half| half.push(crossing));
                }
            }
            if triangle.iter().all(|corner| beside[*corner as usize] == 0.0) {
                halves[1].clear();
            }
            for half in halves.iter().filter(|half| half.len() > 2) {
                solid.triangles.extend(half[1..].windows(2).map(|pair| [half[0], pair[0], pair[1]]));
            }
        }
        solid
    }
}
