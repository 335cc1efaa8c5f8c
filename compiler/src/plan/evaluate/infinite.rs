//! Vertices of rational figures whose weights do not come out above 0: they lie at infinity, or beyond it.
//!
//! Weights above 0 at the control points are above 0 at every vertex of a Bézier curve or a B-spline; rules with
//! negative weights, such as interpolating ones, can bring them to 0.

use crate::ifs::Automaton;

use super::super::chain::ChainPlan;
use super::super::figure::Shape;
use super::super::net::NetPlan;
use super::basis::basis;
use super::chain::chain_rows;
use super::net::net_weights;

/// The first vertex at infinity of a figure, by its place (on a net, row after row), with its weight.
pub fn vertex_at_infinity(automaton: &Automaton, shape: &Shape) -> Option<(usize, f64)> {
    match shape {
        Shape::Curve { .. } | Shape::Sheet(_) | Shape::Pieces(_) | Shape::Patchwork(_) => None,
        Shape::Chain(chain) => of_chain(automaton, chain),
        Shape::Net(net) => of_net(automaton, net),
        Shape::Swept(swept) => swept.curves().find_map(|curve| of_chain(automaton, curve)),
    }
}

fn of_chain(automaton: &Automaton, chain: &ChainPlan) -> Option<(usize, f64)> {
    chain.weights.as_ref()?;
    let rows = chain_rows(automaton, chain);
    first_below(rows.into_iter().map(|[_, _, _, weight]| weight))
}

fn of_net(automaton: &Automaton, net: &NetPlan) -> Option<(usize, f64)> {
    let weights = net.weights.as_ref()?;
    let sheet = &net.sheet;
    let mut factors = [(sheet.u, sheet.levels.0), (sheet.v, sheet.levels.1)].into_iter();
    let convex =
        factors.all(|(state, level)| basis(automaton, state, level).weights.iter().all(|w| *w >= 0.0));
    if convex { None } else { first_below(net_weights(automaton, net, weights).into_iter()) }
}

fn first_below(mut weights: impl Iterator<Item = f64>) -> Option<(usize, f64)> {
    let mut place = 0;
    weights.find_map(|weight| {
        place += 1;
        (weight <= 0.0 || !weight.is_finite()).then_some((place - 1, weight))
    })
}
