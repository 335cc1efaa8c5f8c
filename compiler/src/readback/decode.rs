//! From engraved strokes back to the text they spell, and the tick of edge 0. The up mark, cut first, says where the
//! text stands, which way it runs and how high it is; glyphs are then matched stroke by stroke.

use super::cuts::Cut;
use super::{Expected, Fault, FaultKind};
use crate::fabricate::engrave::{self, Lettering, Stroke};
use glam::DVec2;

/// How far a point may be from its glyph's, in heights: a quarter of the font's grid.
const NEAR: f64 = 0.02;
/// Most spaces in a row that are looked for.
const SPACES: usize = 32;

/// Reads the text engraved on a part and says whether it is the alias and whether edge 0 is marked as asked.
pub(super) fn engraving(cuts: &[Cut], expected: &Expected, part: usize, faults: &mut Vec<Fault>) -> String {
    let job = expected.parts[part].job;
    let (strokes, line) = strokes(cuts);
    let wrong = |message: String| Fault::new(FaultKind::EngravingText, line, message);
    let mut letters = strokes.as_slice();
    if job.engraving.mark_edge_0 {
        let Some((tick, rest)) = strokes.split_last() else {
            faults.push(wrong("nothing is engraved".to_owned()));
            return String::new();
        };
        letters = rest;
        if !marks_edge_0(tick, expected, part) {
            let message = "the last stroke is no tick at right angles to edge 0";
            faults.push(Fault::new(FaultKind::EngravingMark, line, message));
        }
    }
    match read(letters) {
        Ok(text) if text == job.alias => text,
        Ok(text) => {
            faults.push(wrong(format!("the strokes spell {text:?}, not {:?}", job.alias)));
            text
        }
        Err(message) => {
            faults.push(wrong(message));
            String::new()
        }
    }
}

/// Chains of engraving cuts between plunges, and the line of the last.
fn strokes(cuts: &[Cut]) -> (Vec<Stroke>, usize) {
    let mut out: Vec<Stroke> = Vec::new();
    let mut line = 0;
    for cut in cuts.iter().filter(|cut| cut.engraves) {
        let (from, to) = (cut.piece.from.truncate(), cut.piece.to.truncate());
        line = cut.made.line;
        if from == to {
            // Down begins a stroke; up ends it.
            if cut.piece.to.z < cut.piece.from.z {
                out.push(vec![from]);
            }
        } else if let Some(stroke) = out.last_mut() {
            stroke.push(to);
        }
    }
    (out, line)
}

fn read(strokes: &[Stroke]) -> Result<String, String> {
    let mark = engrave::up_mark();
    let none = || "the up mark is missing".to_owned();
    let shaft = strokes.first().filter(|shaft| shaft.len() == 2).ok_or_else(none)?;
    // The similarity that takes the mark's shaft to the engraved one, undone.
    let (a, b) = (mark.strokes[0][0], mark.strokes[0][1]);
    let scale = (b - a).length_squared() / (shaft[1] - shaft[0]).length_squared();
    let up = shaft[1] - shaft[0];
    let home = |p: &DVec2| {
        let q = *p - shaft[0];
        a + DVec2::new(-up.perp().dot(q), up.dot(q)) * scale * (b - a).length().recip()
    };
    let upright: Vec<Stroke> = strokes.iter().map(|s| s.iter().map(home).collect()).collect();
    if !matches(&mark, &upright, 0.0) {
        return Err(none());
    }
    spell(&upright[mark.strokes.len()..], mark.advance)
}

/// Reads glyph by glyph from the pen's place. Of glyphs that match, the one with most strokes is meant.
fn spell(mut strokes: &[Stroke], mut pen: f64) -> Result<String, String> {
    let font: Vec<(char, Lettering)> =
        engrave::characters().filter_map(|c| engrave::glyph(c).map(|glyph| (c, glyph))).collect();
    let space = engrave::glyph(' ').map_or(0.0, |glyph| glyph.advance);
    let (mut text, mut spaces) = (String::new(), 0);
    while !strokes.is_empty() {
        let fitting = font.iter().filter(|(_, glyph)| matches(glyph, strokes, pen));
        if let Some((c, glyph)) = fitting.max_by_key(|(_, glyph)| glyph.strokes.len()) {
            text.extend(std::iter::repeat_n(' ', spaces));
            text.push(*c);
            (spaces, pen, strokes) = (0, pen + glyph.advance, &strokes[glyph.strokes.len()..]);
        } else if spaces < SPACES {
            (spaces, pen) = (spaces + 1, pen + space);
        } else {
            return Err(format!("what is engraved after {text:?} is no letter of the font"));
        }
    }
    Ok(text)
}

/// Whether the glyph, moved to `pen`, is what the first strokes are.
fn matches(glyph: &Lettering, strokes: &[Stroke], pen: f64) -> bool {
    let same = |wanted: &Stroke, found: &Stroke| {
        let near = |(p, q): (&DVec2, &DVec2)| (*p + DVec2::new(pen, 0.0)).distance(*q) < NEAR;
        wanted.len() == found.len() && wanted.iter().zip(found).all(near)
    };
    glyph.strokes.len() <= strokes.len() && glyph.strokes.iter().zip(strokes).all(|(w, f)| same(w, f))
}

/// A straight stroke that points away from edge 0 and begins beside it, at the clearance.
fn marks_edge_0(tick: &Stroke, expected: &Expected, part: usize) -> bool {
    let part = &expected.parts[part];
    let (Some(&a), Some(&b), &[from, to]) = (part.outline.first(), part.outline.get(1), tick.as_slice())
    else {
        return false;
    };
    let along = (b - a) / a.distance(b);
    let margin = part.job.engraving.clearance + expected.machine.engraver().diameter / 2.0;
    let (rise, drift) = (along.perp_dot(to - from), along.dot(to - from));
    let (height, place) = (along.perp_dot(from - a), along.dot(from - a) / a.distance(b));
    rise > 0.0
        && drift.abs() < 0.01 * rise.max(0.2)
        && (height - margin).abs() < 0.05
        && (0.0..=1.0).contains(&place)
}
