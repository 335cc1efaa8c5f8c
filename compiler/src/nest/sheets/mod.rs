//! Flat parts on raw sheets: what is asked for and what comes out. How parts are put into strips and strips on sheets
//! is in `strips` and `stack`, what is tried and chosen in `choose`.
//!
//! Parts are packed by their convex hulls, so that one never lies in a dent of another. They are turned by half turns,
//! or by quarters where the grain leaves that free.

mod bound;
mod choose;
mod convex;
mod layout;
mod rows;
mod stack;
mod strips;

use std::fmt;

use glam::DVec2;

pub use bound::least_sheets;

/// A raw sheet and the room parts keep on it, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sheet {
    /// Along x, and along the grain.
    pub length: f64,
    /// Along y.
    pub width: f64,
    /// Least distance of parts from the edge of the sheet.
    pub margin: f64,
    /// Least distance between parts.
    pub gap: f64,
}

impl Sheet {
    /// Length and width between the margins, mm.
    #[must_use]
    pub fn room(&self) -> DVec2 {
        DVec2::new(self.length, self.width) - 2.0 * self.margin
    }

    /// mm².
    #[must_use]
    pub fn area(&self) -> f64 {
        self.length * self.width
    }
}

/// A flat part.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// A simple polygon anticlockwise, mm, the grain along x.
    pub outline: Vec<DVec2>,
    /// Whether it may be turned by quarter turns; else only by half turns.
    pub any_quarter: bool,
}

/// Where a part lies: turned anticlockwise about the origin of its outline, then moved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// Which part.
    pub part: usize,
    /// On which sheet.
    pub sheet: usize,
    /// By how many quarters it is turned, 0 to 3.
    pub quarter_turns: u8,
    /// By how much it is moved, mm; the lower left of the sheet is the origin.
    pub at: DVec2,
}

impl Placement {
    /// A point of the part on the sheet.
    #[must_use]
    pub fn put(&self, point: DVec2) -> DVec2 {
        convex::turn(point, self.quarter_turns) + self.at
    }
}

/// A part that lies on no sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unplaced {
    /// Which part.
    pub part: usize,
    /// Why.
    pub reason: Reason,
}

/// Why a part lies on no sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reason {
    /// It is larger than the room between the margins, however it may be turned. mm.
    TooLarge {
        /// Of the box around it as it comes.
        size: DVec2,
        /// Between the margins.
        room: DVec2,
    },
    /// Its outline has no area, or a coordinate that is not finite.
    NoArea,
}

impl fmt::Display for Reason {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Reason::TooLarge { size, room } => write!(
                out,
                "it measures {:.1}mm by {:.1}mm, and between the margins there are {:.1}mm by {:.1}mm",
                size.x, size.y, room.x, room.y
            ),
            Reason::NoArea => out.write_str("its outline has no area"),
        }
    }
}

/// Parts on sheets.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Nested {
    /// How many sheets it takes.
    pub sheets: usize,
    /// Where the parts lie, by sheet, and on a sheet by part.
    pub placements: Vec<Placement>,
    /// Those that lie on none.
    pub unplaced: Vec<Unplaced>,
}

/// Puts parts on as few sheets as it finds. Ties go to the part that comes first.
#[must_use]
pub fn nest(parts: &[Part], sheet: &Sheet) -> Nested {
    choose::nest(parts, sheet)
}

/// Why a part cannot lie on a sheet, however it may be turned; none where it can.
#[must_use]
pub fn too_large(part: &Part, sheet: &Sheet) -> Option<Reason> {
    choose::orientations(part, sheet).err()
}

/// Signed area of a polygon, mm²: positive anticlockwise.
#[must_use]
pub fn area(outline: &[DVec2]) -> f64 {
    let Some(&first) = outline.first() else { return 0.0 };
    let corners = outline.windows(2);
    corners.map(|pair| (pair[0] - first).perp_dot(pair[1] - first)).sum::<f64>() / 2.0
}

#[cfg(test)]
mod tests;
