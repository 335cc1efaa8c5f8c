//! How large a germ can be at a level, from the certificate of contraction alone (GEOMETRY 2): before anything is evaluated.
//!
//! Two vertices of a germ differ by e·Δ, where Δ are the differences of the control points it stands on. After a word of k
//! steps these are L·Δ₀, and the certificate bounds the norms of all such L.

use crate::exact::Rational;

use super::automaton::{Automaton, StateId};
use super::contraction::{Contraction, Norm, contraction};
use super::difference::{edges, forward_difference_operator};

/// A bound of the sizes of germs: how far apart two vertices of one germ can be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizeBound {
    /// Letters in a word of the certificate.
    length: u32,
    /// The largest norm of such a word.
    bound: f64,
    /// The largest norm of a single letter.
    step: f64,
    /// The size of a germ on control points of spread 1.
    germ: f64,
    norm: Norm,
}

impl SizeBound {
    /// The measure of control points that the bound is relative to: the largest distance between neighbours in the list
    /// for the ∞-norm, the root of the summed squares of distances from the first point for the 2-norm. In the unit of
    /// the points.
    pub fn spread(&self, points: &[[f64; 3]]) -> f64 {
        let square =
            |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).fold(0.0, |total, (a, b)| total + (a - b) * (a - b));
        let pairs = points.windows(2).map(|pair| square(&pair[0], &pair[1]));
        let from_first = points.iter().skip(1).map(|point| square(point, &points[0]));
        let squared = match self.norm {
            Norm::Infinity => pairs.fold(0.0, f64::max),
            Norm::Euclidean => from_first.sum(),
        };
        libm::sqrt(squared)
    }

    /// At most how many times the spread of the control points a germ at `level` is large.
    pub fn factor(&self, level: u32) -> f64 {
        let whole = (0..level / self.length).fold(1.0, |total, _| total * self.bound);
        let rest = (0..level % self.length).fold(1.0, |total, _| total * self.step);
        // Each product is rounded once, by at most half an ε.
        let slack = 1.0 + f64::from(level.saturating_add(8)) * f64::EPSILON;
        self.germ * whole * rest * slack
    }

    /// The largest distance between two vertices of a germ at `level` on these control points, in their unit.
    pub fn size(&self, level: u32, points: &[[f64; 3]]) -> f64 {
        self.factor(level) * self.spread(points) * (1.0 + 1e-12)
    }
}

/// A bound of the sizes of germs of `state` and of every state it leads to, at every level; `None` where contraction is
/// not proved.
///
/// # Panics
/// When the state is not of this automaton.
pub fn size_bound(automaton: &Automaton, state: StateId) -> Option<SizeBound> {
    let Contraction::Proved { length, bound, norm } = contraction(automaton, state) else { return None };
    let step = match norm {
        // Words of one letter.
        Norm::Euclidean => bound,
        Norm::Infinity => {
            let edges = edges(automaton, state, forward_difference_operator);
            let largest = edges.iter().map(|edge| edge.operator.infinity_norm()).max();
            largest.unwrap_or(Rational::ZERO).to_f64().next_up()
        }
    };
    let mut germ = 0.0_f64;
    for id in automaton.reachable(state) {
        let vertices = &automaton.state(id).germ.vertices;
        for (place, one) in vertices.iter().enumerate() {
            let others = vertices[place + 1..].iter().map(|other| apart(one, other, norm));
            germ = others.fold(germ, f64::max);
        }
    }
    Some(SizeBound { length, bound, step, germ, norm })
}

/// The norm of e, which takes the differences of the control points to the difference of two vertices.
fn apart(one: &[Rational], other: &[Rational], norm: Norm) -> f64 {
    let difference = one.iter().zip(other).map(|(one, other)| other - one);
    match norm {
        Norm::Infinity => {
            // Σ w_c·p_c = Σ_j (Σ_{c>j} w_c)·(p_{j+1} − p_j), as the w_c sum to 0.
            let mut suffix = Rational::ZERO;
            let mut total = Rational::ZERO;
            for weight in difference.collect::<Vec<_>>().iter().skip(1).rev() {
                suffix += weight;
                total += &suffix.abs();
            }
            total.to_f64().next_up()
        }
        Norm::Euclidean => {
            let square: Rational = difference.skip(1).map(|weight| &weight * &weight).sum();
            libm::sqrt(square.to_f64()).next_up().next_up()
        }
    }
}
