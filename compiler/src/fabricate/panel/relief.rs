//! Corners where four or more boards meet: there the planes of their faces need not share a point, so that bevelled
//! boards reach past each other or leave a hole.
//!
//! Two neighbours meet along a line on each face, parallel to their common edge, and each has its corner somewhere on
//! it. Where three boards meet the corners coincide. Where four or more do, the one whose corner lies further out
//! along that line reaches past its neighbour, into the board opposite: that much is to be cut back. Both faces are
//! looked at, with edges bevelled; the larger figure counts.

use glam::DVec2;

use super::edges::{Edges, moved_out};
use crate::geometry::{QuadMesh, Topology};

/// Corners that reach past their neighbours by no more than this need no relief, mm.
pub const RELIEF_TOLERANCE: f64 = 0.1;

/// So many boards have to meet for their planes to miss a common point.
const FEWEST_BOARDS: usize = 4;

/// A corner that needs relief.
#[derive(Debug, Clone, PartialEq)]
pub struct Corner {
    /// The addresses of the boards that meet there, in the order of the quads.
    pub boards: Vec<String>,
    /// The most that one of them has to be cut back, mm.
    pub relief: f64,
}

/// For one board: at each corner how far it reaches along the side that starts there and along the one that ends
/// there, measured from the corner of the design outline into the board, on both faces. mm.
pub(super) type Reaches = [[[f64; 2]; 2]; 4];

/// The reaches of a board on its two faces; none where a face vanishes.
pub(super) fn reaches(design: &[DVec2; 4], bevels: [Option<f64>; 4], faces: (f64, f64)) -> Option<Reaches> {
    let offsets = bevels.map(|bevel| Edges::Bevelled.offsets(bevel, faces));
    let top = moved_out(design, offsets.map(|offset| offset.top)).ok()?;
    let bottom = moved_out(design, offsets.map(|offset| offset.bottom)).ok()?;
    let along = [0, 1, 2, 3].map(|side| (design[(side + 1) % 4] - design[side]).normalize_or_zero());
    Some([0, 1, 2, 3].map(|corner| {
        let (starts, ends) = (along[corner], -along[(corner + 3) % 4]);
        [&top, &bottom].map(|face| {
            let moved = face[corner] - design[corner];
            [moved.dot(starts), moved.dot(ends)]
        })
    }))
}

/// For each board, at each corner: how far it reaches past its neighbours, and how far it stops short of them, mm.
pub(super) fn compared(
    mesh: &QuadMesh,
    topology: &Topology,
    reaches: &[Option<Reaches>],
) -> Vec<([f64; 4], [f64; 4])> {
    let mut meeting = vec![0usize; mesh.vertices.len()];
    mesh.quads.iter().flatten().for_each(|vertex| meeting[*vertex as usize] += 1);
    let compare = |quad: usize, corner: usize| -> (f64, f64) {
        let Some(own) = reaches[quad].as_ref() else { return (0.0, 0.0) };
        let vertex = mesh.quads[quad][corner];
        if meeting[vertex as usize] < FEWEST_BOARDS {
            return (0.0, 0.0);
        }
        let (mut past, mut short) = (0.0f64, 0.0f64);
        for (place, side) in [corner, (corner + 3) % 4].into_iter().enumerate() {
            let Some(across) = topology.neighbour(quad, side) else { continue };
            let other = across.quad as usize;
            let Some(theirs) = reaches[other].as_ref() else { continue };
            let begin = usize::from(across.side);
            // Consistent quads run along their edge in opposite directions.
            let (at, end) = ((begin + 1) % 4, 1 - place);
            let (their_corner, their_end) = if place == 0 { (at, end) } else { (begin, end) };
            if mesh.quads[other][their_corner] != vertex {
                continue;
            }
            for face in 0..2 {
                let beyond = theirs[their_corner][face][their_end] - own[corner][face][place];
                past = past.max(beyond);
                short = short.max(-beyond);
            }
        }
        (past, short)
    };
    (0..mesh.quads.len())
        .map(|quad| {
            let found = [0, 1, 2, 3].map(|corner| compare(quad, corner));
            (found.map(|(past, _)| past), found.map(|(_, short)| short))
        })
        .collect()
}

/// The corners that need relief, in the order of the vertices. `address` names the board of a quad, if it is made.
pub(super) fn corners(
    mesh: &QuadMesh,
    found: &[([f64; 4], [f64; 4])],
    address: impl Fn(usize) -> Option<String>,
) -> Vec<Corner> {
    let mut corners: Vec<Corner> = vec![Corner { boards: Vec::new(), relief: 0.0 }; mesh.vertices.len()];
    for (quad, (vertices, (relief, _))) in mesh.quads.iter().zip(found).enumerate() {
        let Some(address) = address(quad) else { continue };
        for (vertex, relief) in vertices.iter().zip(relief) {
            let corner = &mut corners[*vertex as usize];
            corner.boards.push(address.clone());
            corner.relief = corner.relief.max(*relief);
        }
    }
    corners.retain(|corner| corner.relief > RELIEF_TOLERANCE);
    corners
}
