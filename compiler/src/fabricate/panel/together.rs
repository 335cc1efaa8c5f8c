//! What the boards of one surface have to do with each other once each is made: relief at common corners, and the order
//! in which they are put up.

use super::relief::{self, Reaches};
use super::{Panel, Panels};
use crate::fabricate::assembly::{Element, order};
use crate::geometry::{QuadMesh, Topology};

/// The boards of one surface.
pub(super) struct Together<'a> {
    /// The surface as it is built.
    pub mesh: &'a QuadMesh,
    /// Its edges.
    pub topology: &'a Topology,
    /// The quad of each board, ascending.
    pub quads: &'a [usize],
}

impl Together<'_> {
    /// Says of each board where its corners have to be cut back, and of the surface where that is much. `faces` are the
    /// heights of the inner and of the outer face over the surface, mm.
    pub(super) fn compare_corners(&self, made: &mut Panels, faces: (f64, f64)) {
        let mut reaches: Vec<Option<Reaches>> = vec![None; self.mesh.quads.len()];
        let mut addresses: Vec<Option<&str>> = vec![None; self.mesh.quads.len()];
        for (&quad, panel) in self.quads.iter().zip(&made.panels) {
            reaches[quad] = relief::reaches(&panel.design_outline, panel.bevels, faces);
            addresses[quad] = Some(&panel.label.address);
        }
        let found = relief::compared(self.mesh, self.topology, &reaches);
        let address = |quad: usize| addresses[quad].map(str::to_owned);
        made.corners = relief::corners(self.mesh, &found, address);
        for (&quad, panel) in self.quads.iter().zip(&mut made.panels) {
            (panel.relief, panel.corner_gaps) = found[quad];
        }
    }

    /// Says of each board when it is put up. A quad that cannot be made keeps its neighbours together all the same.
    pub(super) fn put_in_order(&self, panels: &mut [Panel]) {
        let elements: Vec<Element> = (0..self.mesh.quads.len()).map(|quad| self.element(quad)).collect();
        let places = order(&elements);
        let mut standing: Vec<usize> = (0..panels.len()).collect();
        standing.sort_by_key(|&board| places[self.quads[board]].order);
        for (place, board) in (1u32..).zip(standing) {
            panels[board].ring = places[self.quads[board]].ring;
            panels[board].order = place;
        }
    }

    fn element(&self, quad: usize) -> Element {
        let corners = self.mesh.corners_of(quad);
        let across = self.topology.neighbours(quad);
        let free = (0..4).filter(|side| across[*side].is_none());
        Element {
            height: corners.iter().map(|corner| corner.z).sum::<f64>() / 4.0,
            free_corners: free.flat_map(|side| [corners[side].z, corners[(side + 1) % 4].z]).collect(),
            neighbours: across.iter().flatten().map(|across| across.quad as usize).collect(),
        }
    }
}
