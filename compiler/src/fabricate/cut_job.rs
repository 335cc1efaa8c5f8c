//! What is to be cut: a flat part and what its program has to say about it, or several placed on a sheet. Plain data;
//! `toolpath` checks it, and `readback` holds programs against it.

mod sheet;

pub use sheet::{MAX_PARTS, Placed, Rotation, Sheet};

use glam::DVec2;

/// Most corners an outline may have: keeps the exact checks, which compare all pairs of edges, quick.
pub const MAX_CORNERS: usize = 1000;

/// One panel or plank to be cut out of stock.
#[derive(Clone, Debug, PartialEq)]
pub struct CutJob {
    /// Its full address, such as `shell.7-12`.
    pub address: String,
    /// Its short name, which is engraved.
    pub alias: String,
    /// Name of the design it belongs to.
    pub design: String,
    /// Hash of the design's sources and parameters, as text.
    pub design_hash: String,
    /// Cut outline in mm: a simple polygon, anticlockwise seen from the face that lies up, at most [`MAX_CORNERS`]
    /// corners. Edge i runs from corner i to corner i + 1.
    pub outline: Vec<DVec2>,
    /// Thickness of part and stock, mm.
    pub thickness: f64,
    /// How the alias is engraved.
    pub engraving: Engraving,
    /// Which face lies up, for the header: `top`, `outer`.
    pub face_up: String,
    /// Lines for the header: bevels "not cut by this file", neighbours per edge.
    pub notes: Vec<String>,
}

/// How the alias is engraved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Engraving {
    /// Height of capitals wanted, mm.
    pub height: f64,
    /// Least height it may shrink to, mm.
    pub least_height: f64,
    /// Least distance between the engraved groove and the part's edge, mm. At least the width of the widest bevel.
    pub clearance: f64,
    /// Whether a tick is engraved at right angles to edge 0.
    pub mark_edge_0: bool,
}
