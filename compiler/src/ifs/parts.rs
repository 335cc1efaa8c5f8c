//! Parts of what a state draws, each as a linear automaton of its own: the whole, the ends of its chain, the edges of its
//! polygon.
//!
//! A part draws some vertices at level 0, and at level k+1 what its steps draw at level k, one after the other.

use std::collections::BTreeMap;

use crate::exact::Rational;

use super::automaton::{Automaton, End, State, StateId, Transform};
use super::germ::{Germ, GermShape};
use super::matrix::Matrix;
use super::patch::{Adjacency, PieceEdge};

/// What of a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Part {
    /// Everything it draws.
    Whole,
    /// The first vertex of its chain of segments.
    First,
    /// The last vertex of its chain of segments.
    Last,
    /// An edge of its polygon, by its place, as a chain of segments.
    Edge(usize),
}

impl Part {
    pub(super) fn of(end: End) -> Part {
        match end {
            End::Start => Part::First,
            End::Finish => Part::Last,
        }
    }
}

/// A part of a state, on the state's control points.
pub(super) struct Node {
    /// What the vertices belong to, in order.
    pub(super) shapes: Vec<GermShape>,
    /// Rows of weights, drawn at level 0.
    pub(super) vertices: Vec<Vec<Rational>>,
    /// What it is made of at the next level: nodes, each on points of this one.
    pub(super) steps: Vec<(usize, Matrix)>,
}

/// All parts that some parts lead to; a node is named by its place.
#[derive(Default)]
pub(super) struct Parts {
    pub(super) nodes: Vec<Node>,
    /// How the edges of polygons go on.
    pub(super) adjacency: Adjacency,
    places: BTreeMap<(StateId, Part), usize>,
    /// How many nodes have their steps.
    complete: usize,
}

impl Parts {
    /// No parts yet, of polygons whose edges go on in this way.
    pub(super) fn with(adjacency: Adjacency) -> Parts {
        Parts { adjacency, ..Parts::default() }
    }

    /// The node of a part, with all that it leads to; `None` when there is no such part: no chain of segments.
    pub(super) fn enter(&mut self, automaton: &Automaton, state: StateId, part: Part) -> Option<usize> {
        let place = self.place(automaton, state, part)?;
        while self.complete < self.nodes.len() {
            self.add_steps(automaton, self.complete)?;
            self.complete += 1;
        }
        Some(place)
    }

    fn add_steps<'a>(&mut self, automaton: &'a Automaton, node: usize) -> Option<()> {
        let key = self.places.iter().find(|(_, place)| **place == node).map(|(key, _)| *key);
        let (state, part) = key?;
        let transforms = automaton.state(state).transforms.as_slice();
        let all =
            |transforms: &'a [Transform]| transforms.iter().map(|transform| (transform, part)).collect();
        let chosen: Vec<(&Transform, Part)> = match part {
            Part::Whole => all(transforms),
            Part::First => all(transforms.get(..1)?),
            Part::Last => all(transforms.get(transforms.len() - 1..)?),
            Part::Edge(edge) => {
                let chain = self.adjacency.patches.get(&state)?.edges.get(edge)?;
                let step =
                    |along: &PieceEdge| Some((transforms.get(along.transform)?, Part::Edge(along.edge)));
                chain.iter().map(step).collect::<Option<Vec<_>>>()?
            }
        };
        for (transform, part) in chosen {
            let target = self.place(automaton, transform.target, part)?;
            self.nodes[node].steps.push((target, transform.matrix.clone()));
        }
        Some(())
    }

    fn place(&mut self, automaton: &Automaton, state: StateId, part: Part) -> Option<usize> {
        if let Some(place) = self.places.get(&(state, part)) {
            return Some(*place);
        }
        let (shapes, vertices) = drawn(automaton.state(state), part)?;
        self.nodes.push(Node { shapes, vertices, steps: Vec::new() });
        self.places.insert((state, part), self.nodes.len() - 1);
        Some(self.nodes.len() - 1)
    }
}

/// What a part draws at level 0; what is kept on the way counts as drawn.
#[allow(clippy::type_complexity, reason = "shapes and rows of weights")]
fn drawn(state: &State, part: Part) -> Option<(Vec<GermShape>, Vec<Vec<Rational>>)> {
    let end = |row: &[Rational]| (vec![GermShape::Point], vec![row.to_vec()]);
    match part {
        Part::Whole => {
            let germs: Vec<&Germ> = std::iter::once(&state.germ).chain(&state.keep).collect();
            let shapes = germs.iter().map(|germ| germ.shape.clone()).collect();
            Some((shapes, germs.iter().flat_map(|germ| germ.vertices.iter().cloned()).collect()))
        }
        Part::First => Some(end(state.germ.ends()?.0)),
        Part::Last => Some(end(state.germ.ends()?.1)),
        Part::Edge(edge) => {
            let (start, end) = state.germ.edge(edge)?;
            Some((vec![GermShape::Segment], vec![start.to_vec(), end.to_vec()]))
        }
    }
}
