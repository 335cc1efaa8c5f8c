//! Motion lines: where the tool is after rounding, which words a move needs, and what it sweeps.

use super::extents::Extents;
use super::number::{number, per_minute, thousandths};
use crate::fabricate::toolpath::Turn;
use glam::{DVec2, DVec3};

/// An arc flatter than this (its sagitta, mm) is written as a straight line: its centre could not be told from the
/// rounded points.
const LEAST_SAGITTA: f64 = 0.0005;

/// The tool's rounded place, in thousandths of a mm; an axis is unknown until it has moved.
pub(super) struct Pen {
    at: [Option<i64>; 3],
    radius: i64,
    feed: String,
    top: i64,
    /// The tool whose length offset the next motion brings in.
    offset: Option<u32>,
    pub(super) extents: Extents,
}

impl Pen {
    /// `top`: height of the stock's upper face, mm.
    pub(super) fn new(top: f64) -> Pen {
        let extents = Extents::default();
        Pen { at: [None; 3], radius: 0, feed: String::new(), top: thousandths(top), offset: None, extents }
    }

    /// After a tool change the machine may stand anywhere.
    pub(super) fn change_tool(&mut self, radius: f64) {
        self.at = [None; 3];
        self.radius = thousandths(radius);
    }

    /// The next motion, which is Z alone, takes this tool's length into account.
    pub(super) fn offset_with_next(&mut self, tool: u32) {
        self.offset = Some(tool);
    }

    pub(super) fn rapid_z(&mut self, z: f64) -> String {
        let words = self.words(None, thousandths(z));
        let offset = self.offset.take().map_or_else(String::new, |tool| format!(" G43 H{tool}"));
        if words.is_empty() { words } else { format!("G0{offset}{words}\n") }
    }

    pub(super) fn rapid_xy(&mut self, to: DVec2) -> String {
        let z = self.at[2].unwrap_or(self.top);
        let words = self.words(Some([thousandths(to.x), thousandths(to.y)]), z);
        if words.is_empty() { words } else { format!("G0{words}\n") }
    }

    pub(super) fn line(&mut self, to: DVec3, feed: f64) -> String {
        self.sweep();
        let words = self.words(Some([thousandths(to.x), thousandths(to.y)]), thousandths(to.z));
        self.sweep();
        if words.is_empty() { words } else { format!("G1{words}{}\n", self.feed_word(feed)) }
    }

    pub(super) fn arc(&mut self, to: DVec3, radius: f64, turn: Turn, feed: f64) -> String {
        let target = [thousandths(to.x), thousandths(to.y)];
        let [Some(x), Some(y), _] = self.at else { return self.line(to, feed) };
        let Some(offset) = centre_offset([x, y], target, radius, turn) else { return self.line(to, feed) };
        self.sweep();
        self.sweep_quadrants([x, y], target, offset, turn);
        // Not through `words`: both ends differ, and X and Y are said even if only one changed.
        let words = self.words(Some(target), thousandths(to.z));
        self.sweep();
        let code = if turn == Turn::Clockwise { "G2" } else { "G3" };
        let (i, j) = (number(offset[0]), number(offset[1]));
        format!("{code}{words} I{i} J{j}{}\n", self.feed_word(feed))
    }

    /// Moves the pen; X and Y are said together if either changes, Z if it changes.
    fn words(&mut self, xy: Option<[i64; 2]>, z: i64) -> String {
        let mut out = String::new();
        if let Some([x, y]) = xy
            && (self.at[0], self.at[1]) != (Some(x), Some(y))
        {
            out += &format!(" X{} Y{}", number(x), number(y));
            (self.at[0], self.at[1]) = (Some(x), Some(y));
        }
        if self.at[2] != Some(z) {
            out += &format!(" Z{}", number(z));
        }
        self.at[2] = Some(z);
        if let Some(z) = self.at[2] {
            self.extents.take(2, z, 0);
        }
        out
    }

    fn feed_word(&mut self, feed: f64) -> String {
        let text = per_minute(feed);
        if text == self.feed {
            return String::new();
        }
        self.feed = text;
        format!(" F{}", self.feed)
    }

    /// Takes in the tool where it stands, if it stands in the stock.
    fn sweep(&mut self) {
        if let [Some(x), Some(y), Some(z)] = self.at
            && z < self.top
        {
            self.extents.take(0, x, self.radius);
            self.extents.take(1, y, self.radius);
        }
    }

    /// Takes in the points of an arc that are farthest along an axis.
    fn sweep_quadrants(&mut self, from: [i64; 2], to: [i64; 2], offset: [i64; 2], turn: Turn) {
        if self.at[2].is_none_or(|z| z >= self.top) {
            return;
        }
        let centre = [from[0] + offset[0], from[1] + offset[1]];
        let out = |p: [i64; 2]| DVec2::new((p[0] - centre[0]) as f64, (p[1] - centre[1]) as f64);
        let (a, b) = (out(from), out(to));
        let (a, b) = if turn == Turn::Clockwise { (b, a) } else { (a, b) };
        let radius = a.length();
        for (axis, direction) in [(0, DVec2::X), (0, -DVec2::X), (1, DVec2::Y), (1, -DVec2::Y)] {
            // At most a half turn anticlockwise from a to b.
            if a.perp_dot(direction) > 0.0 && direction.perp_dot(b) > 0.0 {
                let reach = (radius * direction[axis]).round() as i64;
                self.extents.take(axis, centre[axis] + reach, self.radius);
            }
        }
    }
}

/// From the rounded start to the rounded centre of the arc of this radius (at most a half turn), in thousandths. The
/// centre lies on the rounded points' bisector, so only its own rounding parts the two radii: by under 0.0015 mm.
/// `None` if the arc is too flat to be told from a line.
fn centre_offset(from: [i64; 2], to: [i64; 2], radius: f64, turn: Turn) -> Option<[i64; 2]> {
    let chord = DVec2::new((to[0] - from[0]) as f64, (to[1] - from[1]) as f64) / 1000.0;
    let half = chord.length() / 2.0;
    let height = (radius * radius - half * half).max(0.0).sqrt();
    if half == 0.0 || radius - height < LEAST_SAGITTA {
        return None;
    }
    let left = chord.perp() / (2.0 * half);
    let side = if turn == Turn::Clockwise { -left } else { left };
    let centre = chord / 2.0 + side * height;
    Some([thousandths(centre.x), thousandths(centre.y)])
}
