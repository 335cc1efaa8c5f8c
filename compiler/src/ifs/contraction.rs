//! Contraction: whether a limit figure exists for all control points (GEOMETRY 2), in three honest answers.
//!
//! Words of transforms follow the automaton's edges. Norms of length 1 are exact; those of longer words are doubles
//! rounded up, with the argument at [`Product::then`].

use crate::exact::Rational;

use super::automaton::{Automaton, StateId, StateSpace};
use super::difference::{Edge, edges, forward_difference_operator, frame_operator};
use super::matrix::Matrix;
use super::spectrum::{euclidean_norm_below, spectral_radius_at_least_one};
use super::words::Word;

/// Most words whose norms are looked at.
pub const WORD_BUDGET: usize = 100_000;

/// Most multiplications of doubles spent on words.
const MULTIPLICATION_BUDGET: usize = 200_000_000;

/// Most multiplications of exact numbers spent on spectral radii, and on 2-norms.
const EXACT_BUDGET: usize = 100_000;

/// Longest words whose spectral radius is looked at.
const LONGEST_REFUTATION: u32 = 64;

/// How finely bounds in the 2-norm are told.
const BOUND_PARTS: u32 = 1 << 16;

/// The norm a proof is stated in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Norm {
    /// The largest row sum of absolute values, on forward differences of control points.
    Infinity,
    /// The 2-norm, on the differences of control points from the first.
    Euclidean,
}

/// Whether the joint spectral radius of the difference operators is below 1.
#[derive(Clone, Debug, PartialEq)]
pub enum Contraction {
    /// Every word of `length` letters has a norm of at most `bound`, which is below 1: the limit exists for all points.
    Proved {
        /// Letters in a word, the k of GEOMETRY 2.
        length: u32,
        /// An upper bound of all norms; the factor per step is its k-th root.
        bound: f64,
        /// The norm.
        norm: Norm,
    },
    /// This word leads back to its state with a spectral radius of at least 1 (decided exactly): for some points there
    /// is no limit.
    Refuted {
        /// The word.
        word: Word,
    },
    /// Neither was found within the budget.
    Open {
        /// The longest words that were looked at, all of them.
        length: u32,
        /// The largest norm among those, at least 1.
        bound: f64,
    },
}

/// Whether every figure of `state` contracts.
///
/// # Panics
/// When the state is not of this automaton.
pub fn contraction(automaton: &Automaton, state: StateId) -> Contraction {
    // Of frames of the plane and of space the linear parts decide, in their own coordinates.
    let framed = |id: &StateId| automaton.state(*id).space != StateSpace::Control;
    if automaton.reachable(state).iter().all(framed)
        && let Some(proof) = euclidean_proof(automaton, state)
    {
        return proof;
    }
    let edges = edges(automaton, state, forward_difference_operator);
    let exact = edges.iter().map(|edge| edge.operator.infinity_norm()).max().unwrap_or(Rational::ZERO);
    if exact < Rational::ONE {
        return Contraction::Proved { length: 1, bound: rounded_up(&exact), norm: Norm::Infinity };
    }
    euclidean_proof(automaton, state).unwrap_or_else(|| Search::new(&edges).run())
}

/// The least double not below an exact number.
fn rounded_up(value: &Rational) -> f64 {
    let nearest = value.to_f64();
    match Rational::from_f64(nearest) {
        Some(exact) if exact < *value => nearest.next_up(),
        _ => nearest,
    }
}

/// A proof with words of one letter in the 2-norm, in which scaled rotations contract at once; its bound is the least
/// multiple of 1/[`BOUND_PARTS`] that can be proved.
fn euclidean_proof(automaton: &Automaton, state: StateId) -> Option<Contraction> {
    let edges = edges(automaton, state, frame_operator);
    let work = |edge: &Edge| {
        16 * edge.operator.columns().saturating_pow(2) * (edge.operator.rows() + edge.operator.columns())
    };
    if edges.iter().map(work).fold(0, usize::saturating_add) > EXACT_BUDGET {
        return None;
    }
    let holds = |parts: u32| {
        let bound = Rational::new(i64::from(parts), i64::from(BOUND_PARTS))?;
        edges.iter().all(|edge| euclidean_norm_below(&edge.operator, &bound)).then_some(())
    };
    let (mut fails, mut proved) = (0, BOUND_PARTS - 1);
    holds(proved)?;
    while proved - fails > 1 {
        let middle = (fails + proved) / 2;
        if holds(middle).is_some() { proved = middle } else { fails = middle }
    }
    Some(Contraction::Proved {
        length: 1,
        bound: f64::from(proved) / f64::from(BOUND_PARTS),
        norm: Norm::Euclidean,
    })
}

/// A product of difference operators in doubles, with a bound of its distance from the exact product.
struct Product {
    rows: usize,
    columns: usize,
    entries: Vec<f64>,
    /// At least the ∞-norm of (exact product − entries).
    error: f64,
}

/// Covers the rounding of a handful of sums and products of non-negative doubles.
const SLACK: f64 = 1.0 + 1.0 / (1_u64 << 40) as f64;

impl Product {
    fn of(operator: &Matrix) -> Product {
        let (rows, columns) = (operator.rows(), operator.columns());
        let entries = operator.to_f64();
        let mut product = Product { rows, columns, entries, error: 0.0 };
        product.error = (product.norm() * f64::EPSILON + 1e-300) * SLACK;
        product
    }

    /// The largest row sum of absolute values, rounded up.
    fn norm(&self) -> f64 {
        if self.columns == 0 {
            return 0.0;
        }
        let sum = |row: &[f64]| row.iter().fold(0.0, |total, entry| total + entry.abs());
        // f64::max drops NaN, so look for it: an overflowed product is no proof.
        let largest = self
            .entries
            .chunks_exact(self.columns)
            .map(sum)
            .fold(0.0, |a: f64, b: f64| if a.is_nan() || b.is_nan() { f64::INFINITY } else { a.max(b) });
        largest * (1.0 + self.columns as f64 * f64::EPSILON) * SLACK
    }

    /// An upper bound of the exact product's ∞-norm.
    fn bound(&self) -> f64 {
        let bound = (self.norm() + self.error) * SLACK;
        if bound.is_nan() { f64::INFINITY } else { bound }
    }

    /// `step · self`. With exact L, M, doubles L̂, M̂, u = ε/2 and n inner terms,
    /// |fl(L̂M̂) − LM| ≤ |L|·|M−M̂| + |L−L̂|·|M̂| + γ_n·|L̂|·|M̂|, so the error is at most
    /// ‖L‖·error + (u + γ_n·(1+u))·‖L‖·‖M̂‖ with γ_n = n·u/(1−n·u) (Higham 2002, 3.5), here (n+2)·ε in place of the
    /// bracket, and 1e-300 for underflow.
    fn then(&self, step: &Product) -> Product {
        let (rows, inner, columns) = (step.rows, step.columns, self.columns);
        let mut entries = vec![0.0; rows * columns];
        for row in 0..rows {
            let result = &mut entries[row * columns..(row + 1) * columns];
            for (k, weight) in step.entries[row * inner..(row + 1) * inner].iter().enumerate() {
                for (total, entry) in result.iter_mut().zip(&self.entries[k * columns..(k + 1) * columns]) {
                    *total += weight * entry;
                }
            }
        }
        let growth = step.bound();
        let rounding = (inner as f64 + 2.0) * f64::EPSILON * growth * self.norm();
        let error = (growth * self.error + rounding + 1e-300) * SLACK;
        Product { rows, columns, entries, error }
    }
}

/// Words of one length after another.
struct Search<'a> {
    edges: &'a [Edge],
    steps: Vec<Product>,
    /// All words so far: the edge that was added, and the word it was added to.
    words: Vec<(usize, Option<usize>)>,
    exact_left: usize,
}

impl<'a> Search<'a> {
    fn new(edges: &'a [Edge]) -> Search<'a> {
        let steps = edges.iter().map(|edge| Product::of(&edge.operator)).collect();
        Search { edges, steps, words: Vec::new(), exact_left: EXACT_BUDGET }
    }

    fn run(mut self) -> Contraction {
        let mut frontier: Vec<(usize, Product)> = Vec::new();
        for (edge, step) in self.edges.iter().enumerate() {
            self.words.push((edge, None));
            frontier.push((edge, Product::of(&step.operator)));
        }
        let mut multiplications = MULTIPLICATION_BUDGET;
        let mut length = 1;
        loop {
            if length <= LONGEST_REFUTATION
                && let Some(word) = frontier.iter().find_map(|(word, product)| self.refutes(*word, product))
            {
                return Contraction::Refuted { word };
            }
            let bound = frontier.iter().map(|(_, product)| product.bound()).fold(0.0, f64::max);
            if bound < 1.0 {
                return Contraction::Proved { length, bound, norm: Norm::Infinity };
            }
            match self.lengthen(&frontier, &mut multiplications) {
                Some(longer) => frontier = longer,
                None => return Contraction::Open { length, bound },
            }
            length += 1;
        }
    }

    /// All words one letter longer; `None` when they exceed a budget.
    fn lengthen(&mut self, frontier: &[(usize, Product)], left: &mut usize) -> Option<Vec<(usize, Product)>> {
        let mut longer = Vec::new();
        for (word, product) in frontier {
            let end = self.edges[self.words[*word].0].target;
            let first = self.edges.partition_point(|edge| edge.source < end);
            for edge in (first..self.edges.len()).take_while(|edge| self.edges[*edge].source == end) {
                let step = &self.steps[edge];
                *left = left.checked_sub(step.rows * step.columns * product.columns + 1)?;
                if self.words.len() >= WORD_BUDGET {
                    return None;
                }
                longer.push((self.words.len(), product.then(step)));
                self.words.push((edge, Some(*word)));
            }
        }
        Some(longer)
    }

    /// The word when it leads back to its state and its spectral radius is certainly at least 1.
    fn refutes(&mut self, last: usize, product: &Product) -> Option<Word> {
        if product.bound() < 1.0 || product.rows != product.columns {
            return None;
        }
        let path = self.path(last);
        let (first, end) = (&self.edges[*path.first()?], &self.edges[*path.last()?]);
        if first.source != end.target || powers_vanish(product) {
            return None;
        }
        let size = product.rows;
        self.exact_left = self.exact_left.checked_sub(size.pow(3).saturating_mul(size + path.len()))?;
        let mut exact = first.operator.clone();
        for edge in &path[1..] {
            exact = self.edges[*edge].operator.product(&exact).ok()?;
        }
        let letters = path.iter().map(|edge| self.edges[*edge].letter).collect();
        spectral_radius_at_least_one(&exact)?.then_some(Word { start: first.source, letters })
    }

    /// The edges of a word, first to last.
    fn path(&self, last: usize) -> Vec<usize> {
        let mut path = Vec::new();
        let mut word = Some(last);
        while let Some((edge, before)) = word.map(|word| self.words[word]) {
            path.push(edge);
            word = before;
        }
        path.reverse();
        path
    }
}

/// Whether the 64th power of a product is small: then its spectral radius is below 1 and no exact test is needed.
fn powers_vanish(product: &Product) -> bool {
    let twin = |product: &Product| Product { entries: product.entries.clone(), ..*product };
    let mut power = twin(product);
    for _ in 0..6 {
        power = power.then(&twin(&power));
    }
    power.bound() < 1.0
}
