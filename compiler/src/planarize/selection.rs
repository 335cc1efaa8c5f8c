//! Which quads are worked on, which vertices may move, and which quads change with them.

use crate::geometry::{QuadMeasure, QuadMesh, Verdict};

use super::options::Pin;

/// The part of the mesh that is worked on.
#[derive(Debug, Clone)]
pub(super) struct Selection {
    /// For each quad whether it was ever found to fall short of `select`.
    pub(super) selected: Vec<bool>,
    /// For each vertex whether it may move: part of the patch of a selected quad, and not held.
    pub(super) free: Vec<bool>,
    /// The quads with a corner that may move, ascending.
    pub(super) touched: Vec<u32>,
    /// For each vertex whether it may never move.
    held: Vec<bool>,
}

impl Selection {
    /// Selects the quads that fall short of `select`. Pinned vertices are held, and so are the corners of quads
    /// that are degenerate or have a collinear corner: any move would make of them another kind of quad.
    pub(super) fn new(mesh: &QuadMesh, measures: &[QuadMeasure], select: f64, pin: Pin) -> Self {
        let mut selection = Self {
            selected: vec![false; mesh.quads.len()],
            free: vec![false; mesh.vertices.len()],
            touched: Vec::new(),
            held: held(mesh, measures, pin),
        };
        selection.grow(mesh, select, measures.iter().map(|measure| measure.planarity).enumerate());
        selection
    }

    /// Selects those of the given quads that fall short of `select`; returns whether any was new.
    pub(super) fn grow(
        &mut self,
        mesh: &QuadMesh,
        select: f64,
        planarities: impl Iterator<Item = (usize, Option<f64>)>,
    ) -> bool {
        let mut grown = false;
        for (quad, planarity) in planarities {
            if !self.selected[quad] && planarity.is_some_and(|planarity| planarity < select) {
                self.selected[quad] = true;
                grown = true;
            }
        }
        if grown {
            self.free = self.patches(mesh);
            self.touched = (0u32..)
                .zip(&mesh.quads)
                .filter(|(_, corners)| corners.iter().any(|&corner| self.free[corner as usize]))
                .map(|(quad, _)| quad)
                .collect();
        }
        grown
    }

    /// For each vertex whether it may move: it is not held, and belongs to the patch of a selected quad, which is
    /// that quad and all that share a vertex with it.
    fn patches(&self, mesh: &QuadMesh) -> Vec<bool> {
        let mut core = vec![false; mesh.vertices.len()];
        for (corners, _) in mesh.quads.iter().zip(&self.selected).filter(|(_, selected)| **selected) {
            corners.iter().for_each(|&corner| core[corner as usize] = true);
        }
        let mut free = core.clone();
        for corners in &mesh.quads {
            if corners.iter().any(|&corner| core[corner as usize]) {
                corners.iter().for_each(|&corner| free[corner as usize] = true);
            }
        }
        free.iter().zip(&self.held).map(|(free, held)| *free && !held).collect()
    }
}

/// For each vertex whether it may never move: the pinned ones, and the corners of quads that are degenerate or have a
/// collinear corner.
pub(super) fn held(mesh: &QuadMesh, measures: &[QuadMeasure], pin: Pin) -> Vec<bool> {
    let mut held = vec![false; mesh.vertices.len()];
    let pinned = match pin {
        // Only a mesh with more than two quads at an edge has no boundary; it is then pinned as a whole.
        Pin::Boundary => mesh.boundary_vertices().unwrap_or_else(|_| mesh.quads.concat()),
        Pin::Corners => mesh.corners(),
        Pin::None => Vec::new(),
    };
    for vertex in pinned {
        held[vertex as usize] = true;
    }
    for (corners, measure) in mesh.quads.iter().zip(measures) {
        if matches!(measure.verdict, Verdict::Degenerate | Verdict::CollinearCorner) {
            corners.iter().for_each(|&corner| held[corner as usize] = true);
        }
    }
    held
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::samples;

    fn selection(mesh: &QuadMesh, select: f64, pin: Pin) -> Selection {
        let measures: Vec<QuadMeasure> =
            (0..mesh.quads.len()).map(|quad| QuadMeasure::of(mesh.corners_of(quad))).collect();
        Selection::new(mesh, &measures, select, pin)
    }

    fn free(selection: &Selection) -> Vec<usize> {
        (0..selection.free.len()).filter(|&vertex| selection.free[vertex]).collect()
    }

    /// A flat 8 by 8 grid but for its corner vertex 0, which spoils quad 0 alone.
    fn bent_corner() -> QuadMesh {
        let mut mesh = samples::flat_grid(8, 8, 100.0);
        mesh.vertices[0].z = 20.0;
        mesh
    }

    #[test]
    fn a_patch_is_the_quad_and_those_around_it() {
        let open = selection(&bent_corner(), 0.9999, Pin::None);
        assert_eq!(open.selected.iter().filter(|selected| **selected).count(), 1);
        assert_eq!(free(&open), vec![0, 1, 2, 8, 9, 10, 16, 17, 18]);
        assert_eq!(open.touched, vec![0, 1, 2, 7, 8, 9, 14, 15, 16]);
        assert_eq!(free(&selection(&bent_corner(), 0.9999, Pin::Boundary)), vec![9, 10, 17, 18]);
        assert_eq!(free(&selection(&bent_corner(), 0.9999, Pin::Corners)), vec![1, 2, 8, 9, 10, 16, 17, 18]);
    }

    #[test]
    fn select_decides_what_is_picked() {
        let none = selection(&bent_corner(), 0.5, Pin::None);
        assert!(!none.selected.contains(&true) && none.touched.is_empty());
    }

    #[test]
    fn quads_of_no_shape_hold_their_corners() {
        let mut mesh = bent_corner();
        mesh.vertices[9] = mesh.vertices[10];
        let held = selection(&mesh, 0.9999, Pin::None);
        assert!([1, 2, 9, 10, 17, 18].iter().all(|&vertex: &usize| !held.free[vertex]), "{:?}", free(&held));
    }
}
