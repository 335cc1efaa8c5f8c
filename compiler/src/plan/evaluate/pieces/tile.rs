//! [`Tile`]: a few elements with their vertices, as evaluation hands them on.

use super::block::{Block, BlockElement};
use super::walk::Walk;
use super::{DrawnGerm, PiecesEvaluator, combine};

/// Elements that follow each other. Its memory is used again for the next tile.
#[derive(Clone, Copy, Debug)]
pub struct Tile<'t> {
    germs: &'t [DrawnGerm],
    block: &'t Block,
    /// The letters that all words of the tile start with.
    letters: &'t [u32],
    axes: [&'t [f64]; 3],
}

/// One element of a tile.
#[derive(Clone, Copy, Debug)]
pub struct PieceElement<'t> {
    /// Its place among [`PiecesEvaluator::germs`].
    pub germ: usize,
    /// What is drawn.
    pub drawn: &'t DrawnGerm,
    /// The place of its first vertex in the tile.
    pub first: usize,
    prefix: &'t [u32],
    suffix: &'t [u32],
}

impl<'t> PieceElement<'t> {
    /// The letters of its word, each the place of a transform in its state.
    pub fn letters(&self) -> impl Iterator<Item = usize> + use<'t> {
        self.prefix.iter().chain(self.suffix).map(|letter| *letter as usize)
    }

    /// How many vertices it has.
    pub fn vertices(&self) -> usize {
        self.drawn.vertices as usize
    }
}

impl<'t> Tile<'t> {
    /// The elements, in order.
    pub fn elements(&self) -> impl ExactSizeIterator<Item = PieceElement<'t>> + use<'t> {
        let Tile { germs, block, letters: prefix, .. } = *self;
        block.elements.iter().map(move |element: &BlockElement| PieceElement {
            germ: element.germ as usize,
            drawn: &germs[element.germ as usize],
            first: element.first as usize,
            prefix,
            suffix: &block.letters[element.letters.0 as usize..element.letters.1 as usize],
        })
    }

    /// How many vertices all elements have.
    pub fn vertices(&self) -> usize {
        self.axes[0].len()
    }

    /// One coordinate of all vertices, mm.
    pub fn axis(&self, axis: usize) -> &'t [f64] {
        self.axes[axis]
    }

    /// One vertex, mm.
    ///
    /// # Panics
    /// When there is none at this place.
    pub fn point(&self, place: usize) -> [f64; 3] {
        let [x, y, z] = self.axes;
        [x[place], y[place], z[place]]
    }

    /// Writes the vertices of one element over `out`.
    pub fn copy_vertices(&self, element: &PieceElement<'_>, out: &mut Vec<[f64; 3]>) {
        out.clear();
        out.extend((element.first..element.first + element.vertices()).map(|place| self.point(place)));
    }
}

/// The memory of a tile.
pub(super) struct Coordinates {
    axes: [Vec<f64>; 3],
    /// Whether every vertex lies in the plane z = 0, so that it need not be worked out.
    flat: bool,
    arch: pulp::Arch,
}

impl Coordinates {
    pub(super) fn new(rows: usize, flat: bool) -> Coordinates {
        let axes = [vec![0.0; rows], vec![0.0; rows], vec![0.0; rows]];
        Coordinates { axes, flat, arch: pulp::Arch::new() }
    }

    /// The vertices of a block on the control points where the walk stands.
    pub(super) fn filled<'t>(
        &'t mut self,
        block: &'t Block,
        walk: &'t Walk,
        evaluator: &'t PiecesEvaluator,
    ) -> Tile<'t> {
        let worked_out = if self.flat { 2 } else { 3 };
        for (axis, out) in self.axes.iter_mut().enumerate().take(worked_out) {
            combine(self.arch, &mut out[..block.rows], walk.axis(axis), |column| block.column(column));
        }
        let axes = self.axes.each_ref().map(|axis| &axis[..block.rows]);
        Tile { germs: &evaluator.germs, block, letters: &walk.letters, axes }
    }
}
