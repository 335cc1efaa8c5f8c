//! Whether two linear automata draw the same at every level (Schützenberger 1961; Tzeng 1992), by exact arithmetic.
//!
//! That node x on the points M·P draws what y draws on N·P, for all P and at every level, is linear in the columns
//! (c, d) of (M, N): g_x·c = g_y·d for the vertices g, and the same of (T_i·c, S_i·d) for the steps T_i of x and S_i of
//! y. Columns in the span of those already asked about x and y follow from them. Each span has at most as many
//! dimensions as x and y have points, so the questions end.

use std::collections::{BTreeMap, VecDeque};

use crate::exact::{MAX_BITS, Rational};

use super::matrix::{Matrix, row_times};
use super::parts::Node;

/// Most multiplications of exact numbers spent on one proof, each counted once more for every 64 bits.
const WORK_BUDGET: usize = 2_000_000;

/// A node on points of some state.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    pub(super) node: usize,
    /// Rows: points of the node; columns: points of the state.
    pub(super) matrix: Matrix,
}

/// That two placed nodes draw the same; `reversed` when the one runs against the other.
pub(super) struct Claim {
    pub(super) left: Placed,
    pub(super) right: Placed,
    pub(super) reversed: bool,
}

/// The answer for claims that must all hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Equivalence {
    /// All do, at every level.
    Same,
    /// One does not: a vertex that the two draw at different places.
    Apart {
        claim: usize,
        /// Steps after which they part.
        level: u32,
        left: Vec<Rational>,
        right: Vec<Rational>,
    },
    /// One does not: the two draw different kinds or numbers of things.
    Unlike { claim: usize, level: u32 },
    /// The proof needs more than is allowed.
    Unproved { level: u32 },
}

/// A question that is still to be asked: some columns of a claim after some steps.
struct Question {
    claim: usize,
    /// Places of the steps, of the left node; those of the right one follow.
    word: Vec<usize>,
    nodes: (usize, usize),
    columns: Vec<(Vec<Rational>, Vec<Rational>)>,
}

/// Whether all claims hold; what parts first is found first.
pub(super) fn prove(nodes: &[Node], claims: &[Claim]) -> Equivalence {
    let mut prover =
        Prover { nodes, claims, spans: BTreeMap::new(), open: VecDeque::new(), work: WORK_BUDGET };
    for (place, claim) in claims.iter().enumerate() {
        let (left, right) = (&claim.left, &claim.right);
        let column = |matrix: &Matrix, column: usize| -> Vec<Rational> {
            (0..matrix.rows()).map(|row| matrix.row(row)[column].clone()).collect()
        };
        let columns = (0..left.matrix.columns().min(right.matrix.columns()))
            .map(|place| (column(&left.matrix, place), column(&right.matrix, place)))
            .collect();
        let nodes = (left.node, right.node);
        prover.open.push_back(Question { claim: place, word: Vec::new(), nodes, columns });
    }
    prover.run()
}

struct Prover<'a> {
    nodes: &'a [Node],
    claims: &'a [Claim],
    /// Of every pair of nodes and direction: the columns asked about, in echelon form.
    spans: BTreeMap<(usize, usize, bool), Vec<Vec<Rational>>>,
    open: VecDeque<Question>,
    work: usize,
}

impl Prover<'_> {
    fn run(mut self) -> Equivalence {
        while let Some(question) = self.open.pop_front() {
            let level = u32::try_from(question.word.len()).unwrap_or(u32::MAX);
            match self.ask(question) {
                Some(Equivalence::Same) => {}
                Some(answer) => return answer,
                None => return Equivalence::Unproved { level },
            }
        }
        Equivalence::Same
    }

    /// Answers one question for this level, and asks on; `None` when the budget is spent.
    fn ask(&mut self, question: Question) -> Option<Equivalence> {
        let claim = &self.claims[question.claim];
        let (x, y) = (&self.nodes[question.nodes.0], &self.nodes[question.nodes.1]);
        let level = u32::try_from(question.word.len()).ok()?;
        let alike =
            x.shapes == y.shapes && x.vertices.len() == y.vertices.len() && x.steps.len() == y.steps.len();
        if !alike {
            return Some(Equivalence::Unlike { claim: question.claim, level });
        }
        let columns = self.unknown(&question, claim.reversed)?;
        let count = x.vertices.len();
        for vertex in 0..count {
            let other = if claim.reversed { count - 1 - vertex } else { vertex };
            let (left, right) = (&x.vertices[vertex], &y.vertices[other]);
            self.spend(columns.len() * (left.len() + right.len()), &columns)?;
            if columns.iter().any(|(c, d)| product(left, c) != product(right, d)) {
                return Some(self.apart(&question, level, left, right));
            }
        }
        if !columns.is_empty() {
            self.ask_on(&question, &columns)?;
        }
        Some(Equivalence::Same)
    }

    fn ask_on(&mut self, question: &Question, columns: &[(Vec<Rational>, Vec<Rational>)]) -> Option<()> {
        let nodes = self.nodes;
        let (x, y) = (&nodes[question.nodes.0], &nodes[question.nodes.1]);
        let count = x.steps.len();
        for step in 0..count {
            let (left, matrix) = &x.steps[step];
            let (right, other) = &y.steps[self.other_step(question.claim, count, step)];
            let entries = matrix.entries().len() + other.entries().len();
            self.spend(columns.len() * entries, columns)?;
            let mut word = question.word.clone();
            word.push(step);
            let columns = columns.iter().map(|(c, d)| (times(matrix, c), times(other, d))).collect();
            self.open.push_back(Question { claim: question.claim, word, nodes: (*left, *right), columns });
        }
        Some(())
    }

    fn other_step(&self, claim: usize, count: usize, step: usize) -> usize {
        if self.claims[claim].reversed { count - 1 - step } else { step }
    }

    /// The columns that do not follow from those already asked about, which they join.
    #[allow(clippy::type_complexity, reason = "pairs of columns")]
    fn unknown(
        &mut self,
        question: &Question,
        reversed: bool,
    ) -> Option<Vec<(Vec<Rational>, Vec<Rational>)>> {
        let mut new = Vec::new();
        for (c, d) in &question.columns {
            let key = (question.nodes.0, question.nodes.1, reversed);
            let dimension = self.spans.get(&key).map_or(0, Vec::len);
            let mut rest: Vec<Rational> = c.iter().chain(d).cloned().collect();
            self.spend(rest.len() * (dimension + 1), &question.columns)?;
            let span = self.spans.entry(key).or_default();
            for known in span.iter() {
                reduce(&mut rest, known);
            }
            let Some(pivot) = rest.iter().position(|entry| !entry.is_zero()) else { continue };
            let scale = rest[pivot].reciprocal().ok()?;
            rest.iter_mut().for_each(|entry| *entry = &*entry * &scale);
            span.push(rest);
            new.push((c.clone(), d.clone()));
        }
        Some(new)
    }

    fn spend(&mut self, multiplications: usize, columns: &[(Vec<Rational>, Vec<Rational>)]) -> Option<()> {
        let entries = columns.iter().flat_map(|(c, d)| c.iter().chain(d));
        let bits = entries.map(Rational::bits).max().unwrap_or(0);
        if bits > MAX_BITS {
            return None;
        }
        self.work = self.work.checked_sub(multiplications.saturating_mul(1 + bits as usize / 64))?;
        Some(())
    }

    /// Both rows in full, on the points of the claim's state.
    fn apart(&self, question: &Question, level: u32, left: &[Rational], right: &[Rational]) -> Equivalence {
        let claim = &self.claims[question.claim];
        let (mut matrices, mut others) = (vec![&claim.left.matrix], vec![&claim.right.matrix]);
        let (mut x, mut y) = (claim.left.node, claim.right.node);
        for step in &question.word {
            let count = self.nodes[x].steps.len();
            let (next, matrix) = &self.nodes[x].steps[*step];
            let (after, other) = &self.nodes[y].steps[self.other_step(question.claim, count, *step)];
            matrices.push(matrix);
            others.push(other);
            (x, y) = (*next, *after);
        }
        let full = |row: &[Rational], matrices: &[&Matrix]| {
            matrices.iter().rev().fold(row.to_vec(), |row, matrix| row_times(&row, matrix))
        };
        let (left, right) = (full(left, &matrices), full(right, &others));
        Equivalence::Apart { claim: question.claim, level, left, right }
    }
}

/// Takes from `rest` the multiple of `known`, whose first entry that is not 0 is 1, that clears the same entry.
fn reduce(rest: &mut [Rational], known: &[Rational]) {
    let Some(pivot) = known.iter().position(|entry| !entry.is_zero()) else { return };
    let factor = rest[pivot].clone();
    if factor.is_zero() {
        return;
    }
    for (entry, other) in rest.iter_mut().zip(known).skip(pivot) {
        if !other.is_zero() {
            *entry -= &(&factor * other);
        }
    }
}

fn product(row: &[Rational], column: &[Rational]) -> Rational {
    let pairs = row.iter().zip(column).filter(|(weight, entry)| !weight.is_zero() && !entry.is_zero());
    pairs.map(|(weight, entry)| weight * entry).sum()
}

fn times(matrix: &Matrix, column: &[Rational]) -> Vec<Rational> {
    (0..matrix.rows()).map(|row| product(matrix.row(row), column)).collect()
}
