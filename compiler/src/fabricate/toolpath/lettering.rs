//! Where the alias and its marks go on a part, and how they are cut. What letters look like is `engrave`'s business.
//!
//! The text stands on one line beside or along an edge, as large as asked if there is room, else smaller; the up mark
//! stands before it; the tick of edge 0 stands at right angles to that edge, at the clearance from it.

use super::polygon::{Polygon, segment_distance};
use super::{CutJob, Refusal, Steps};
use crate::fabricate::engrave::{self, Stroke};
use crate::fabricate::machine::Machine;
use glam::DVec2;

/// Text lower than this many widths of the engraver runs together.
pub(super) const LEGIBLE: f64 = 3.0;
/// Each attempt is this much smaller than the one before.
const SHRINK: f64 = 0.95;
/// Candidate positions per direction of the part's bounding box.
const GRID: usize = 12;
/// Height above the stock for travel between strokes at a feed, mm.
const HOP: f64 = 2.0;

/// Strokes in program coordinates, in cutting order: up mark, text, edge-0 tick.
#[derive(Clone, Debug)]
pub(super) struct Pattern {
    /// Height of capitals, mm.
    pub(super) height: f64,
    strokes: Vec<Stroke>,
}

impl Pattern {
    pub(super) fn into_strokes(self) -> Vec<Stroke> {
        self.strokes
    }
}

/// The text as a block about its middle, in units of its height.
struct Block {
    strokes: Vec<Stroke>,
    half: DVec2,
}

/// Finds the first place, at the greatest height, where text and marks lie inside `outline`.
///
/// # Errors
/// No text, an unknown character, senseless or illegible heights, or no room even at the least height.
pub(super) fn place(job: &CutJob, machine: &Machine, outline: &Polygon) -> Result<Pattern, Refusal> {
    place_strokes(job, machine.engraver().diameter, outline)
}

/// As [`place`], for strokes of this width, mm.
///
/// # Errors
/// As [`place`].
pub(super) fn place_strokes(job: &CutJob, width: f64, outline: &Polygon) -> Result<Pattern, Refusal> {
    let asked = job.engraving;
    let sensible = asked.least_height > 0.0
        && asked.height >= asked.least_height
        && asked.height <= 1000.0
        && (0.0..=1000.0).contains(&asked.clearance);
    if !sensible {
        let (height, least, clearance) = (asked.height, asked.least_height, asked.clearance);
        return Err(Refusal::EngravingFigures { height, least, clearance });
    }
    let legible = LEGIBLE * width;
    if asked.height < legible {
        return Err(Refusal::TextTooFine { asked: asked.height, legible, diameter: width });
    }
    let least = asked.least_height.max(legible);
    let block = block(&job.alias)?;
    let site = Site {
        outline,
        block: &block,
        margin: asked.clearance + width / 2.0,
        width,
        directions: directions(outline),
        middles: middles(outline),
    };
    let mut height = asked.height;
    loop {
        if let Some(strokes) = site.strokes(height, asked.mark_edge_0) {
            return Ok(Pattern { height, strokes });
        }
        if height <= least {
            return Err(Refusal::TextDoesNotFit { text: job.alias.clone(), asked: asked.height, least });
        }
        height = (height * SHRINK).max(least);
    }
}

fn block(text: &str) -> Result<Block, Refusal> {
    if text.is_empty() || text.starts_with(' ') || text.ends_with(' ') {
        return Err(Refusal::NothingToEngrave);
    }
    let letters = engrave::letter(text).map_err(|e| Refusal::UnknownCharacter { character: e.0 })?;
    let mark = engrave::up_mark();
    let shift = DVec2::new(mark.advance, 0.0);
    let mut strokes = mark.strokes;
    strokes.extend(letters.strokes.iter().map(|s| s.iter().map(|&p| p + shift).collect::<Stroke>()));
    let first = strokes[0][0];
    let all = || strokes.iter().flatten();
    let (low, high) = all().fold((first, first), |(low, high), &p| (low.min(p), high.max(p)));
    let middle = (low + high) / 2.0;
    let strokes = strokes.iter().map(|s| s.iter().map(|&p| p - middle).collect()).collect();
    Ok(Block { strokes, half: (high - low) / 2.0 })
}

/// A part that text is to be placed on.
struct Site<'a> {
    outline: &'a Polygon,
    block: &'a Block,
    /// Least distance between a stroke's middle and the edge.
    margin: f64,
    /// Width of a stroke.
    width: f64,
    /// Reading directions to try.
    directions: Vec<DVec2>,
    /// Middles to try, inside the part, each with its distance to the edge.
    middles: Vec<(DVec2, f64)>,
}

impl Site<'_> {
    /// All strokes at this height, or nothing if they have no room.
    fn strokes(&self, height: f64, mark_edge_0: bool) -> Option<Vec<Stroke>> {
        let reach = self.margin + height * self.block.half.min_element();
        for &along in &self.directions {
            for &(middle, _) in self.middles.iter().filter(|m| m.1 >= reach) {
                let sides = self.frame(middle, along, height);
                if !self.holds(&sides) {
                    continue;
                }
                let tick = if mark_edge_0 { Some(self.tick(&sides, height)) } else { None };
                if tick == Some(None) {
                    continue;
                }
                let place = |&p: &DVec2| middle + height * (p.x * along + p.y * along.perp());
                let mut strokes: Vec<Stroke> =
                    self.block.strokes.iter().map(|s| s.iter().map(place).collect()).collect();
                strokes.extend(tick.flatten());
                return Some(strokes);
            }
        }
        None
    }

    /// The four sides of the block about `middle`.
    fn frame(&self, middle: DVec2, along: DVec2, height: f64) -> [(DVec2, DVec2); 4] {
        let (x, y) = (along * self.block.half.x * height, along.perp() * self.block.half.y * height);
        let c = [middle - x - y, middle + x - y, middle + x + y, middle - x + y];
        [(c[0], c[1]), (c[1], c[2]), (c[2], c[3]), (c[3], c[0])]
    }

    /// Whether the framed block lies inside, at the margin from every edge.
    fn holds(&self, sides: &[(DVec2, DVec2); 4]) -> bool {
        self.outline.contains(sides[0].0)
            && sides.iter().all(|&(a, b)| self.outline.distance_to_boundary(a, b) >= self.margin)
    }

    /// A tick half a letter high that points away from edge 0, clear of the text, nearest to the edge's middle.
    fn tick(&self, sides: &[(DVec2, DVec2); 4], height: f64) -> Option<Stroke> {
        let (a, b) = self.outline.edge(0);
        let inwards = self.outline.direction(0).perp();
        let clear = 2.0 * self.width;
        for step in 0..19_i32 {
            let sign = if step % 2 == 0 { 1.0 } else { -1.0 };
            let t = 0.5 + sign * 0.05 * f64::from((step + 1) / 2);
            // A hair more than the margin, so that rounding the written points cannot take from it.
            let from = a + (b - a) * t + inwards * (self.margin + 0.01);
            let tick = (from, from + inwards * (height / 2.0));
            let inside = self.outline.contains(tick.0)
                && self.outline.distance_to_boundary(tick.0, tick.1) >= self.margin;
            if inside && sides.iter().all(|&side| segment_distance(side, tick) >= clear) {
                return Some(vec![tick.0, tick.1]);
            }
        }
        None
    }
}

/// Reading directions: along the edges, the longest first (at most eight), then along X; never upside down.
fn directions(outline: &Polygon) -> Vec<DVec2> {
    let length = |i: &usize| outline.edge(*i).0.distance(outline.edge(*i).1);
    let mut edges: Vec<usize> = (0..outline.len()).collect();
    edges.sort_by(|a, b| length(b).total_cmp(&length(a)));
    let upright = |d: DVec2| if d.x < -1e-9 || (d.x.abs() <= 1e-9 && d.y < 0.0) { -d } else { d };
    let mut out: Vec<DVec2> = Vec::new();
    for d in edges.iter().take(8).map(|&i| upright(outline.direction(i))).chain([DVec2::X]) {
        if out.iter().all(|other| other.distance(d) > 1e-6) {
            out.push(d);
        }
    }
    out
}

/// Candidate middles inside the part with their distances to its edge: the centroid, then a grid over the bounding
/// box, nearest to the centroid first.
fn middles(outline: &Polygon) -> Vec<(DVec2, f64)> {
    let centroid = outline.centroid();
    let (low, high) = outline.bounds();
    let at = |i: usize| (i as f64 + 0.5) / GRID as f64;
    let cell = |k: usize| low + (high - low) * DVec2::new(at(k % GRID), at(k / GRID));
    let mut grid: Vec<DVec2> = (0..GRID * GRID).map(cell).collect();
    grid.sort_by(|a, b| a.distance_squared(centroid).total_cmp(&b.distance_squared(centroid)));
    grid.insert(0, centroid);
    let inside = grid.into_iter().filter(|&p| outline.contains(p));
    inside.map(|p| (p, outline.distance_to_boundary(p, p))).collect()
}

/// Cuts the strokes in order, travelling between them at a feed just above the stock.
pub(super) fn engrave(steps: &mut Steps, pattern: &Pattern) {
    let tool = steps.machine.engraver();
    let (feed, plunge) = (tool.feed, tool.plunge.min(tool.feed));
    let top = steps.top();
    let bottom = top - steps.machine.spec().engrave_depth;
    steps.note(format!("engraving, {:.3} mm high", pattern.height));
    for (i, stroke) in pattern.strokes.iter().enumerate() {
        if i == 0 {
            steps.rapid(stroke[0]);
        } else {
            steps.line(stroke[0].extend(top + HOP), feed);
        }
        steps.line(stroke[0].extend(top + super::contour::APPROACH), feed);
        steps.line(stroke[0].extend(bottom), plunge);
        for p in &stroke[1..] {
            steps.line(p.extend(bottom), feed);
        }
        if i + 1 < pattern.strokes.len() {
            steps.line(stroke[stroke.len() - 1].extend(top + HOP), feed);
        }
    }
    steps.retract();
}
