//! The closed solid of a board as it lies flat on the machine: x and y of its outlines, z along its normal from the
//! design surface. How it bends to its place in space is in `thicken`.

use glam::{DVec2, DVec3};

use super::edges::{EdgeOffsets, moved_out};
use crate::fabricate::solid::Solid;
use crate::geometry::Diagonal;

/// What a flat board is made of, mm.
pub(super) struct FlatBoard<'a> {
    /// The design outline.
    pub design: &'a [DVec2; 4],
    /// The outline of the outer face or half.
    pub top: &'a [DVec2; 4],
    /// The outline of the inner face or half.
    pub bottom: &'a [DVec2; 4],
    /// From the design outline to these two.
    pub offsets: &'a [EdgeOffsets; 4],
    /// The height of the inner and of the outer face.
    pub faces: (f64, f64),
    /// The diagonal along which the faces are split.
    pub split: Diagonal,
}

impl FlatBoard<'_> {
    /// The board with edges straight from face to face.
    pub(super) fn straight(&self) -> Solid {
        let (low, high) = self.faces;
        Solid::between(at(self.bottom, low), at(self.top, high), self.split.triangles())
    }

    /// The board with a step halfway. Where neighbouring edges step to different sides, both outlines pass through the
    /// corner of what they have in common.
    pub(super) fn stepped(&self) -> Option<Solid> {
        let (low, high) = self.faces;
        let middle = (low + high) / 2.0;
        let least = self.offsets.map(|offset| offset.top.min(offset.bottom));
        let common = moved_out(self.design, least).ok()?;
        let mut solid = Solid::default();
        let mut ring = |outline: &[DVec2; 4], height: f64| {
            at(outline, height).map(|vertex| {
                solid.vertices.push(vertex);
                solid.vertices.len() as u32 - 1
            })
        };
        let (floor, ceiling) = (ring(self.bottom, low), ring(self.top, high));
        let wider = |side: usize, top: bool| match top {
            true => self.offsets[side].top > self.offsets[side].bottom,
            false => self.offsets[side].bottom > self.offsets[side].top,
        };
        // Whether the outline of the inner (outer) half has its corner in common with the other.
        let inmost = |corner: usize, top: bool| !wider(corner, top) && !wider((corner + 3) % 4, top);
        let inner = ring(self.bottom, middle);
        let mut shared = inner;
        let mut outer = inner;
        let (top_ring, common_ring) = (ring(self.top, middle), ring(&common, middle));
        for corner in 0..4 {
            match (inmost(corner, false), inmost(corner, true)) {
                (true, true) => {}
                (true, false) => outer[corner] = top_ring[corner],
                (false, true) => {
                    outer[corner] = top_ring[corner];
                    shared[corner] = top_ring[corner];
                }
                (false, false) => {
                    outer[corner] = top_ring[corner];
                    shared[corner] = common_ring[corner];
                }
            }
        }
        for [a, b, c] in self.split.triangles() {
            solid.triangles.push([ceiling[a], ceiling[b], ceiling[c]]);
            solid.triangles.push([floor[a], floor[c], floor[b]]);
        }
        for side in 0..4 {
            let next = (side + 1) % 4;
            // The wall of a half that is not the wider one there passes through the shared corners.
            let on_way = |ring: &[u32; 4], within: bool| -> Vec<u32> {
                let mut way = vec![ring[side]];
                if within {
                    way.extend([shared[side], shared[next]]);
                }
                way.push(ring[next]);
                way.dedup();
                way
            };
            let mut lower = vec![floor[side], floor[next]];
            lower.extend(on_way(&inner, !wider(side, false)).iter().rev());
            fan(&mut solid, &lower);
            let mut upper = vec![ceiling[next], ceiling[side]];
            upper.extend(on_way(&outer, !wider(side, true)));
            fan(&mut solid, &upper);
            if wider(side, false) {
                fan(&mut solid, &[inner[side], inner[next], shared[next], shared[side]]);
            } else if wider(side, true) {
                fan(&mut solid, &[outer[next], outer[side], shared[side], shared[next]]);
            }
        }
        solid.drop_unused();
        Some(solid)
    }
}

/// A convex face, from its first corner.
fn fan(solid: &mut Solid, corners: &[u32]) {
    for pair in corners.windows(2).skip(1) {
        solid.triangles.push([corners[0], pair[0], pair[1]]);
    }
}

fn at(outline: &[DVec2; 4], height: f64) -> [DVec3; 4] {
    outline.map(|corner| corner.extend(height))
}
