//! [`Walk`]: the words of a figure one after the other, each with the control points its piece stands on.

use super::Prepared;

/// A place in the tree of words, with the way back. Its memory grows with the depth only.
pub(super) struct Walk {
    /// The letters so far.
    pub(super) letters: Vec<u32>,
    frames: Vec<Frame>,
    /// The control points of every frame: first all x, then all y, then all z.
    coordinates: Vec<f64>,
}

struct Frame {
    state: usize,
    /// The transform that is entered next.
    next: usize,
    start: usize,
}

impl Walk {
    /// Before the first letter.
    pub(super) fn new(state: usize, points: &[[f64; 3]]) -> Walk {
        let coordinates = (0..3).flat_map(|axis| points.iter().map(move |point| point[axis])).collect();
        Walk { letters: Vec::new(), frames: vec![Frame { state, next: 0, start: 0 }], coordinates }
    }

    /// The state at this word; `None` when all words were walked.
    pub(super) fn state(&self) -> Option<usize> {
        self.frames.last().map(|frame| frame.state)
    }

    /// Whether no piece below was entered yet.
    pub(super) fn is_fresh(&self) -> bool {
        self.frames.last().is_some_and(|frame| frame.next == 0)
    }

    /// One coordinate of the control points of this word's piece.
    pub(super) fn axis(&self, axis: usize) -> &[f64] {
        let start = self.frames.last().map_or(0, |frame| frame.start);
        let points = (self.coordinates.len() - start) / 3;
        &self.coordinates[start + axis * points..start + (axis + 1) * points]
    }

    /// Enters the next piece below; says whether there was one.
    pub(super) fn enter(&mut self, states: &[Prepared]) -> bool {
        let Some(frame) = self.frames.last_mut() else { return false };
        let Some(transform) = states[frame.state].transforms.get(frame.next) else { return false };
        let letter = frame.next as u32;
        frame.next += 1;
        let (from, to) = (frame.start, self.coordinates.len());
        let columns = (to - from) / 3;
        for axis in 0..3 {
            let first = from + axis * columns;
            for row in transform.matrix.chunks_exact(columns) {
                let source = &self.coordinates[first..first + columns];
                let image = row.iter().zip(source).map(|(weight, point)| weight * point).sum();
                self.coordinates.push(image);
            }
        }
        self.frames.push(Frame { state: transform.target, next: 0, start: to });
        self.letters.push(letter);
        true
    }

    /// Goes back by one letter.
    pub(super) fn leave(&mut self) {
        if let Some(frame) = self.frames.pop() {
            self.coordinates.truncate(frame.start);
            self.letters.pop();
        }
    }
}
