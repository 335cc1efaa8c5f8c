//! Holds a packing against what was asked for: every part placed once or listed, inside its sheet's margin, and no two
//! nearer than the gap; the same for planks on bars, in `bars`. Its code is its own: it knows the parts' own outlines and nothing of how they were packed.

mod bars;
mod distance;

use std::fmt;

use glam::DVec2;

pub use bars::bar_faults;
use distance::distance;

use super::sheets::{Nested, Part, Placement, Sheet};

/// What rounding may take from a gap or a margin, mm.
pub const TOLERANCE: f64 = 1e-6;

/// What is wrong with a packing. Parts by their index.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fault {
    /// A part is neither placed nor listed as unplaced, or both, or more than once.
    NotOnce {
        /// The part.
        part: usize,
        /// How often it was found.
        times: usize,
    },
    /// A part lies on a sheet that is not there, or is turned against its grain.
    NotAllowed {
        /// The part.
        part: usize,
    },
    /// A part reaches into the margin or beyond the sheet.
    OutsideMargin {
        /// The part.
        part: usize,
        /// How far it stays from the nearest edge of the sheet, mm; negative beyond it.
        distance: f64,
    },
    /// Two parts are nearer than the gap.
    TooNear {
        /// Them.
        parts: [usize; 2],
        /// How near, mm; 0 where they overlap.
        distance: f64,
    },
}

impl fmt::Display for Fault {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::NotOnce { part, times } => write!(out, "part {part} is listed {times} times"),
            Fault::NotAllowed { part } => write!(out, "part {part} is turned or put where it may not be"),
            Fault::OutsideMargin { part, distance } => {
                write!(out, "part {part} stays {distance:.3}mm from the edge of what it is cut from")
            }
            Fault::TooNear { parts: [first, second], distance } => {
                write!(out, "parts {first} and {second} are {distance:.3}mm apart")
            }
        }
    }
}

/// What is wrong with where `parts` lie; nothing where all is well.
///
/// Distances are exact but for rounding: that of two polygons is the least of their sides', or 0 where one holds a
/// corner of the other. Parts are compared that lie on the same sheet and whose boxes are nearer than the gap.
#[must_use]
pub fn faults(parts: &[Part], sheet: &Sheet, nested: &Nested) -> Vec<Fault> {
    let mut times = vec![0; parts.len()];
    let known = nested.placements.iter().map(|placement| placement.part);
    for part in known.chain(nested.unplaced.iter().map(|unplaced| unplaced.part)) {
        if let Some(count) = times.get_mut(part) {
            *count += 1;
        }
    }
    let lost = times.iter().enumerate().filter(|(_, times)| **times != 1);
    let mut faults: Vec<Fault> = lost.map(|(part, &times)| Fault::NotOnce { part, times }).collect();
    for number in 0..nested.sheets {
        let here = nested.placements.iter().filter(|placement| placement.sheet == number);
        let mut lying: Vec<Lying> = here.filter_map(|placement| Lying::of(parts, placement)).collect();
        lying.sort_by(|a, b| a.low.x.total_cmp(&b.low.x));
        faults.extend(lying.iter().filter_map(|part| part.outside(sheet)));
        faults.extend(too_near(&lying, sheet.gap));
    }
    faults.extend(nested.placements.iter().filter_map(|placement| {
        let part = parts.get(placement.part)?;
        let turned = placement.quarter_turns % 4;
        let allowed = placement.sheet < nested.sheets && (part.any_quarter || turned % 2 == 0);
        (!allowed).then_some(Fault::NotAllowed { part: placement.part })
    }));
    faults
}

fn too_near(lying: &[Lying], gap: f64) -> Vec<Fault> {
    let mut faults = Vec::new();
    for (index, first) in lying.iter().enumerate() {
        for second in &lying[index + 1..] {
            if second.low.x - first.high.x >= gap {
                break;
            }
            if second.low.y - first.high.y >= gap || first.low.y - second.high.y >= gap {
                continue;
            }
            let distance = distance(&first.corners, &second.corners);
            if distance.is_nan() || distance < gap - TOLERANCE {
                faults.push(Fault::TooNear { parts: [first.part, second.part], distance });
            }
        }
    }
    faults
}

/// A part as it lies on a sheet.
struct Lying {
    part: usize,
    corners: Vec<DVec2>,
    low: DVec2,
    high: DVec2,
}

impl Lying {
    fn of(parts: &[Part], placement: &Placement) -> Option<Self> {
        let outline = &parts.get(placement.part)?.outline;
        let (cosine, sine) = match placement.quarter_turns % 4 {
            0 => (1.0, 0.0),
            1 => (0.0, 1.0),
            2 => (-1.0, 0.0),
            _ => (0.0, -1.0),
        };
        let put = |corner: &DVec2| {
            let x = cosine * corner.x - sine * corner.y;
            let y = sine * corner.x + cosine * corner.y;
            DVec2::new(x + placement.at.x, y + placement.at.y)
        };
        let corners: Vec<DVec2> = outline.iter().map(put).collect();
        let first = *corners.first()?;
        let (low, high) =
            corners.iter().fold((first, first), |(low, high), corner| (low.min(*corner), high.max(*corner)));
        Some(Self { part: placement.part, corners, low, high })
    }

    fn outside(&self, sheet: &Sheet) -> Option<Fault> {
        let distances = [self.low.x, self.low.y, sheet.length - self.high.x, sheet.width - self.high.y];
        let distance = distances.into_iter().fold(f64::INFINITY, f64::min);
        let within = distance >= sheet.margin - TOLERANCE;
        (!within).then_some(Fault::OutsideMargin { part: self.part, distance })
    }
}

#[cfg(test)]
mod tests;
