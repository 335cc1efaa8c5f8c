//! Closed solids of triangles: what a board or plank looks like in the model.

use std::collections::BTreeMap;

use glam::DVec3;

/// A closed solid: triangles counter-clockwise seen from outside, vertices shared by index. mm.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Solid {
    /// Positions, mm.
    pub vertices: Vec<DVec3>,
    /// Indices into `vertices`.
    pub triangles: Vec<[u32; 3]>,
}

impl Solid {
    /// The solid between two outlines of four corners each, both in the same order, counter-clockwise seen from the
    /// side of `top`. `faces` are the two triangles into which top and bottom are split, counter-clockwise.
    #[must_use]
    pub fn between(bottom: [DVec3; 4], top: [DVec3; 4], faces: [[usize; 3]; 2]) -> Self {
        let vertices = bottom.into_iter().chain(top).collect();
        let mut triangles = Vec::with_capacity(12);
        for [a, b, c] in faces.map(|face| face.map(|corner| corner as u32)) {
            triangles.push([a + 4, b + 4, c + 4]);
            triangles.push([a, c, b]);
        }
        for corner in 0..4 {
            let next = (corner + 1) % 4;
            triangles.push([corner, next, next + 4]);
            triangles.push([corner, next + 4, corner + 4]);
        }
        Self { vertices, triangles }
    }

    /// The volume, mm³: positive when the triangles face outwards (divergence theorem).
    #[must_use]
    pub fn volume(&self) -> f64 {
        let Some(&origin) = self.vertices.first() else { return 0.0 };
        let corner = |index: u32| self.vertices[index as usize] - origin;
        self.triangles.iter().map(|&[a, b, c]| corner(a).dot(corner(b).cross(corner(c)))).sum::<f64>() / 6.0
    }

    /// The centre of gravity, mm; the first vertex where there is no volume (divergence theorem).
    #[must_use]
    pub fn centre(&self) -> DVec3 {
        let Some(&origin) = self.vertices.first() else { return DVec3::ZERO };
        let corner = |index: u32| self.vertices[index as usize] - origin;
        let (mut moment, mut volume) = (DVec3::ZERO, 0.0);
        for &[a, b, c] in &self.triangles {
            let [a, b, c] = [corner(a), corner(b), corner(c)];
            let share = a.dot(b.cross(c));
            moment += (a + b + c) * share / 4.0;
            volume += share;
        }
        if volume == 0.0 { origin } else { origin + moment / volume }
    }

    /// Takes out the vertices that no triangle has.
    pub(super) fn drop_unused(&mut self) {
        let mut used = vec![false; self.vertices.len()];
        self.triangles.iter().flatten().for_each(|corner| used[*corner as usize] = true);
        let mut kept = 0;
        let places: Vec<u32> = used
            .iter()
            .map(|used| {
                kept += u32::from(*used);
                kept.wrapping_sub(1)
            })
            .collect();
        let mut place = 0;
        self.vertices.retain(|_| {
            place += 1;
            used[place - 1]
        });
        self.triangles.iter_mut().flatten().for_each(|corner| *corner = places[*corner as usize]);
    }

    /// Whether every directed edge of a triangle has its opposite exactly once.
    #[must_use]
    pub fn is_watertight(&self) -> bool {
        let mut uses: BTreeMap<(u32, u32), u32> = BTreeMap::new();
        for &[a, b, c] in &self.triangles {
            for edge in [(a, b), (b, c), (c, a)] {
                *uses.entry(edge).or_default() += 1;
            }
        }
        !uses.is_empty() && uses.iter().all(|(&(a, b), &count)| count == 1 && uses.get(&(b, a)) == Some(&1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Diagonal, samples};

    #[test]
    fn a_cube() {
        let bottom = samples::square(2.0);
        for split in [Diagonal::Ac, Diagonal::Bd] {
            let cube =
                Solid::between(bottom, bottom.map(|corner| corner + DVec3::Z * 2.0), split.triangles());
            assert!(cube.is_watertight());
            assert_eq!(cube.volume(), 8.0);
            assert!(cube.centre().distance(bottom[0].midpoint(bottom[2]) + DVec3::Z) < 1e-12);
        }
    }

    #[test]
    fn inside_out_and_open_are_seen() {
        let bottom = samples::square(2.0);
        let mut solid =
            Solid::between(bottom, bottom.map(|corner| corner - DVec3::Z), Diagonal::Ac.triangles());
        assert!(solid.is_watertight() && solid.volume() < 0.0);
        solid.triangles.pop();
        assert!(!solid.is_watertight());
        assert!(!Solid::default().is_watertight());
    }
}
