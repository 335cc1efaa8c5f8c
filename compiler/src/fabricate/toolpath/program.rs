//! A program as typed moves: what every dialect of NC text says in its own words. Coordinates are program
//! coordinates in mm, not rounded.

use crate::fabricate::cut_job::Placed;
use glam::{DVec2, DVec3};

/// What the program's header says of the whole.
#[derive(Clone, Debug, PartialEq)]
pub struct Header {
    /// What the sheet is called; empty for a part alone.
    pub sheet: String,
    /// The program's number, from 1, for dialects that number programs.
    pub number: u32,
    /// Name of the design.
    pub design: String,
    /// Hash of the design.
    pub design_hash: String,
    /// Stock in X, Y and thickness, mm.
    pub stock: DVec3,
}

/// What the program's header says of a part.
#[derive(Clone, Debug, PartialEq)]
pub struct PartHeader {
    /// Full address of the part.
    pub address: String,
    /// Short name, as engraved.
    pub alias: String,
    /// Which face lies up.
    pub face_up: String,
    /// Where the least X and Y of the part lie, mm.
    pub low: DVec2,
    /// By how many degrees it is turned, anticlockwise.
    pub turned: u32,
    /// Further lines, as in the job.
    pub notes: Vec<String>,
}

impl PartHeader {
    pub(super) fn of(part: &Placed) -> PartHeader {
        PartHeader {
            address: part.job.address.clone(),
            alias: part.job.alias.clone(),
            face_up: part.job.face_up.clone(),
            low: part.low,
            turned: part.rotation.degrees(),
            notes: part.job.notes.clone(),
        }
    }
}

/// A part of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedPart {
    /// What the header says of it.
    pub header: PartHeader,
    /// The cut outline in program coordinates, mm: where the part lies in the stock.
    pub outline: Vec<DVec2>,
    /// Height of capitals of the engraved alias, mm.
    pub engraved_height: f64,
}

/// Sense of an arc seen from above.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// Clockwise, G2.
    Clockwise,
    /// Anticlockwise, G3.
    Anticlockwise,
}

/// One step of a program. Rapids that mix Z with X and Y cannot be said.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// Change to this tool and take its length into account.
    LoadTool {
        /// Its number.
        number: u32,
    },
    /// Spindle on, clockwise.
    SpindleOn {
        /// Speed, rev/s.
        speed: f64,
    },
    /// Wait.
    Dwell {
        /// How long, s.
        seconds: f64,
    },
    /// Spindle off.
    SpindleOff,
    /// Rapid motion of Z alone.
    RapidZ {
        /// Target height, mm.
        z: f64,
    },
    /// Rapid motion at constant Z.
    RapidXY {
        /// Target, mm.
        to: DVec2,
    },
    /// Straight motion at a feed.
    Line {
        /// Target, mm.
        to: DVec3,
        /// Feed along the path, mm/s.
        feed: f64,
    },
    /// Arc about a vertical axis, at most a half turn.
    Arc {
        /// Target, mm.
        to: DVec3,
        /// Radius, mm.
        radius: f64,
        /// Sense.
        turn: Turn,
        /// Feed along the path, mm/s.
        feed: f64,
    },
    /// A comment for people.
    Note {
        /// The text.
        text: String,
    },
}

/// The toolpath of the parts of a stock. It ends at the safe height with the spindle off.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// What the header says.
    pub header: Header,
    /// The parts in order; at least one.
    pub parts: Vec<PlacedPart>,
    /// The steps in order.
    pub steps: Vec<Step>,
}
