//! A program as typed moves: what every dialect of NC text says in its own words. Coordinates are program
//! coordinates in mm, not rounded.

use glam::{DVec2, DVec3};

/// What the program's header says.
#[derive(Clone, Debug, PartialEq)]
pub struct Header {
    /// Full address of the part.
    pub address: String,
    /// Short name, as engraved.
    pub alias: String,
    /// Name of the design.
    pub design: String,
    /// Hash of the design.
    pub design_hash: String,
    /// Stock in X, Y and thickness, mm.
    pub stock: DVec3,
    /// Which face lies up.
    pub face_up: String,
    /// Further lines, as in the job.
    pub notes: Vec<String>,
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

/// The toolpath of one part. It ends at the safe height with the spindle off.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// What the header says.
    pub header: Header,
    /// The cut outline in program coordinates, mm: where the part lies in the stock.
    pub placed_outline: Vec<DVec2>,
    /// Height of capitals of the engraved alias, mm.
    pub engraved_height: f64,
    /// The steps in order.
    pub steps: Vec<Step>,
}
