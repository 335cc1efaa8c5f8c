//! [`Block`]: everything that is drawn below a state, so many levels deep, as rows of weights on its first control point
//! and on the differences of the others from it.

/// One element of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct BlockElement {
    /// Which of the evaluator's germs it is.
    pub(super) germ: u32,
    /// The first of its vertices in the block.
    pub(super) first: u32,
    /// Where its letters start and end.
    pub(super) letters: (u32, u32),
}

/// Elements with their vertices in weights. In the order of words, what is kept before what follows below it.
#[derive(Clone, Debug, Default)]
pub(super) struct Block {
    pub(super) elements: Vec<BlockElement>,
    pub(super) letters: Vec<u32>,
    /// Vertices.
    pub(super) rows: usize,
    /// Control points.
    pub(super) columns: usize,
    /// Column after column, so that a coordinate of all vertices is a weighted sum of whole columns.
    weights: Vec<f64>,
}

/// A piece below a block's state: the letter that leads to it, its images of control points, and its own block.
pub(super) struct Below<'a> {
    pub(super) letter: u32,
    pub(super) matrix: &'a [f64],
    pub(super) block: &'a Block,
}

impl Block {
    /// A block of nothing on so many control points.
    pub(super) fn new(columns: usize) -> Block {
        Block { columns, ..Block::default() }
    }

    /// Adds a germ with the weights of its vertices, row after row.
    pub(super) fn with_germ(mut self, germ: u32, vertices: &[f64]) -> Block {
        let first = self.rows as u32;
        self.elements.push(BlockElement { germ, first, letters: (0, 0) });
        let rows: Vec<&[f64]> = vertices.chunks_exact(self.columns).collect();
        self.weights = self.columns_with(&rows);
        self.rows += rows.len();
        self
    }

    /// What is kept of a state, then its pieces.
    pub(super) fn stacked(kept: &Block, pieces: &[Below<'_>]) -> Block {
        let mut out = kept.clone();
        let mut rows: Vec<Vec<f64>> = Vec::new();
        for piece in pieces {
            let offset = (out.rows + rows.len()) as u32;
            for element in &piece.block.elements {
                let start = out.letters.len() as u32;
                let (from, to) = element.letters;
                out.letters.push(piece.letter);
                out.letters.extend_from_slice(&piece.block.letters[from as usize..to as usize]);
                let letters = (start, out.letters.len() as u32);
                out.elements.push(BlockElement {
                    germ: element.germ,
                    first: offset + element.first,
                    letters,
                });
            }
            rows.extend((0..piece.block.rows).map(|row| product(piece, row, out.columns)));
        }
        let rows: Vec<&[f64]> = rows.iter().map(Vec::as_slice).collect();
        out.weights = out.columns_with(&rows);
        out.rows += rows.len();
        out
    }

    /// The weights of one control point for every vertex.
    pub(super) fn column(&self, column: usize) -> &[f64] {
        &self.weights[column * self.rows..(column + 1) * self.rows]
    }

    /// The columns with more rows below.
    fn columns_with(&self, rows: &[&[f64]]) -> Vec<f64> {
        let mut weights = Vec::with_capacity((self.rows + rows.len()) * self.columns);
        for column in 0..self.columns {
            weights.extend_from_slice(self.column(column));
            weights.extend(rows.iter().map(|row| row[column]));
        }
        weights
    }
}

/// One row of a piece's block times its matrix.
fn product(piece: &Below<'_>, row: usize, columns: usize) -> Vec<f64> {
    let mut out = vec![0.0; columns];
    for inner in 0..piece.block.columns {
        let weight = piece.block.column(inner)[row];
        for (total, entry) in out.iter_mut().zip(&piece.matrix[inner * columns..]) {
            *total += weight * entry;
        }
    }
    out
}
