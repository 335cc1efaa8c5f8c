//! Which motion cuts, what for, and on which part.

use super::expected::{Expected, ExpectedPart};
use super::geometry::{Piece, inside, to_boundary};
use super::interpret::{Event, Motion, Move, Trace};
use glam::DVec2;

/// Heights that differ by less are the same, mm: two roundings to the third decimal, and a hair.
pub(super) const HEIGHT: f64 = 0.0015;

/// Feed motion below the stock's upper face.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut<'a> {
    pub(super) made: &'a Move,
    pub(super) piece: Piece,
    pub(super) engraves: bool,
    /// The part it works on, from 0.
    pub(super) part: usize,
}

impl Cut<'_> {
    /// Its lowest Z.
    pub(super) fn lowest(&self) -> f64 {
        self.piece.from.z.min(self.piece.to.z)
    }

    /// Its highest Z.
    pub(super) fn highest(&self) -> f64 {
        self.piece.from.z.max(self.piece.to.z)
    }
}

/// All cuts in order. With one tool for both, shallow motion inside a part is engraving.
///
/// An engraved stroke belongs to the part it lies in. Motion without a rapid in it works on one contour: the one whose
/// bounding box is most like its own.
pub(super) fn cuts<'a>(traces: &[&'a Trace], expected: &Expected) -> Vec<Cut<'a>> {
    let boxes: Vec<(DVec2, DVec2)> = expected.parts.iter().map(ExpectedPart::bounds).collect();
    let mut out = Vec::new();
    for trace in traces {
        let mut run: Vec<Cut> = Vec::new();
        for event in &trace.events {
            match event {
                Event::Move(made) if made.motion != Motion::Rapid => {
                    run.extend(cut(made, expected, &boxes));
                }
                _ => finish(&mut run, &mut out, expected, &boxes),
            }
        }
        finish(&mut run, &mut out, expected, &boxes);
    }
    out
}

fn cut<'a>(made: &'a Move, expected: &Expected, boxes: &[(DVec2, DVec2)]) -> Option<Cut<'a>> {
    let piece = made.piece()?;
    let lowest = piece.from.z.min(piece.to.z);
    if lowest >= expected.top() - HEIGHT {
        return None;
    }
    let (cutter, engraver) = (expected.machine.cutter().number, expected.machine.engraver().number);
    let shallow = expected.top() - expected.machine.spec().engrave_depth - HEIGHT;
    let over = || part_under(piece.at(0.5).truncate(), expected, boxes);
    let engraves = match made.tool {
        tool if tool != Some(engraver) => false,
        _ if cutter == engraver => lowest >= shallow && over().1,
        _ => true,
    };
    let part = if engraves { over().0 } else { 0 };
    Some(Cut { made, piece, engraves, part })
}

/// The part that `p` lies in, and true; else the nearest, and false.
fn part_under(p: DVec2, expected: &Expected, boxes: &[(DVec2, DVec2)]) -> (usize, bool) {
    if let [part] = expected.parts.as_slice() {
        return (0, inside(p, &part.outline));
    }
    let within = |(low, high): &(DVec2, DVec2)| p.cmpge(*low).all() && p.cmple(*high).all();
    let holds = |&i: &usize| within(&boxes[i]) && inside(p, &expected.parts[i].outline);
    if let Some(part) = (0..boxes.len()).find(holds) {
        return (part, true);
    }
    let distance = |i: usize| to_boundary((p, p), &expected.parts[i].outline);
    let nearest = (0..boxes.len()).map(|i| (i, distance(i))).min_by(|a, b| a.1.total_cmp(&b.1));
    (nearest.map_or(0, |found| found.0), false)
}

/// Says of which part the contour cuts of a run are.
fn finish<'a>(run: &mut Vec<Cut<'a>>, out: &mut Vec<Cut<'a>>, expected: &Expected, boxes: &[(DVec2, DVec2)]) {
    if boxes.len() > 1 {
        let ends = run.iter().filter(|cut| !cut.engraves).map(|cut| cut.piece.bounds());
        if let Some((low, high)) = ends.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1))) {
            let radius = expected.cutter_radius();
            let unlike = |(a, b): &(DVec2, DVec2)| (low - *a + radius).abs() + (high - *b - radius).abs();
            let unlike: Vec<f64> = boxes.iter().map(|b| unlike(b).element_sum()).collect();
            let part = (1..boxes.len()).fold(0, |best, i| if unlike[i] < unlike[best] { i } else { best });
            run.iter_mut().filter(|cut| !cut.engraves).for_each(|cut| cut.part = part);
        }
    }
    out.append(run);
}
