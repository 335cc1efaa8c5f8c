//! Where tabs go: spread evenly around the part, each on one straight stretch of its edge, away from corners, from the
//! ramp and from leads.

use super::Refusal;
use super::passes::{Piece, along};
use super::polygon::Polygon;
use crate::fabricate::machine::{Fixing, Machine};

/// Least distance between the raised path of a tab and a corner, the ramp, a lead or the next tab, mm.
const CLEAR: f64 = 1.0;

/// The stretch of an edge over which the path is raised for a tab: from and to, mm from the edge's first corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Zone {
    pub(super) edge: usize,
    pub(super) from: f64,
    pub(super) to: f64,
}

/// A straight stretch where the middle of a tab may be: counted in mm along the level way around.
#[derive(Clone, Copy)]
struct Room {
    from: f64,
    to: f64,
    piece: usize,
}

/// The zones of all tabs, none where there are to be none. `level` is the way around without its ramp; its first
/// `reserved` mm are kept for leads.
///
/// # Errors
/// `TabsDoNotFit` with how many would.
pub(super) fn place(
    machine: &Machine,
    outline: &Polygon,
    level: &[Piece],
    reserved: f64,
) -> Result<Vec<Zone>, Refusal> {
    let Fixing::Tabs { count, width, .. } = machine.spec().fixing else { return Ok(Vec::new()) };
    let raised = width + machine.cutter().diameter;
    let (rooms, length) = rooms(level, raised, reserved);
    let slots = slots(&rooms, raised + CLEAR);
    if slots.len() < count as usize {
        return Err(Refusal::TabsDoNotFit { asked: count, fitting: slots.len() as u32, width, raised });
    }
    let even = |k: u32| reserved + (length - reserved) * (f64::from(k) + 0.5) / f64::from(count);
    let mut middles: Vec<(f64, usize)> = Vec::new();
    for k in 0..count {
        let least = middles.last().map_or(f64::NEG_INFINITY, |last| last.0 + raised + CLEAR);
        match nearest(&rooms, even(k), least) {
            Some(middle) => middles.push(middle),
            None => break,
        }
    }
    if middles.len() < count as usize {
        // Evenly among the places where tabs go when they stand as densely as they can.
        let slot = |k: u32| slots[(k as usize * slots.len() + slots.len() / 2) / count as usize];
        middles = (0..count).map(slot).collect();
    }
    let starts: Vec<f64> = level
        .iter()
        .scan(0.0, |gone, piece| {
            let start = *gone;
            *gone += piece.length;
            Some(start)
        })
        .collect();
    let zone = |&(middle, piece): &(f64, usize)| {
        let (stretch, start) = (&level[piece], starts[piece]);
        let at = stretch.from + (stretch.to - stretch.from) * ((middle - start) / stretch.length);
        let at = along(outline, stretch.edge, at);
        Zone { edge: stretch.edge, from: at - raised / 2.0, to: at + raised / 2.0 }
    };
    Ok(middles.iter().map(zone).collect())
}

/// Where middles may be, and the length of the whole level way.
fn rooms(level: &[Piece], raised: f64, reserved: f64) -> (Vec<Room>, f64) {
    let mut rooms = Vec::new();
    let mut start = 0.0;
    for (i, piece) in level.iter().enumerate() {
        let end = start + piece.length;
        let from = f64::max(start, reserved) + raised / 2.0 + CLEAR;
        let to = end - raised / 2.0 - CLEAR;
        if !piece.arc && from <= to {
            rooms.push(Room { from, to, piece: i });
        }
        start = end;
    }
    (rooms, start)
}

/// As many middles as there is room for, `apart` from each other.
fn slots(rooms: &[Room], apart: f64) -> Vec<(f64, usize)> {
    let mut out: Vec<(f64, usize)> = Vec::new();
    for room in rooms {
        let mut at = room.from;
        while at <= room.to {
            out.push((at, room.piece));
            at += apart;
        }
    }
    out
}

/// The admissible middle nearest to `wanted`, not before `least`.
fn nearest(rooms: &[Room], wanted: f64, least: f64) -> Option<(f64, usize)> {
    let candidates = rooms.iter().filter(|room| room.to >= least);
    let places = candidates.map(|room| (wanted.clamp(room.from.max(least), room.to), room.piece));
    places.min_by(|a, b| (a.0 - wanted).abs().total_cmp(&(b.0 - wanted).abs()))
}
