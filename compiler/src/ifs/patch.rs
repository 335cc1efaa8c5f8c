//! [`Patch`]: how the polygons of one state's pieces lie at level 1: which edges coincide, and how the rim follows the
//! state's own polygon. Whether it stays so at every level is not said here.

use std::collections::{BTreeMap, BTreeSet};

use crate::exact::Rational;

use super::automaton::{Automaton, StateId};
use super::matrix::row_times;

/// An edge of a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct PieceEdge {
    /// Place of the piece's transform in the state.
    pub transform: usize,
    /// Place of the edge in the polygon of the transform's target: from vertex `edge` to the next.
    pub edge: usize,
}

/// How the pieces of a state make up its polygon.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Patch {
    /// Pairs of edges that are one, run through in opposite directions.
    pub glued: Vec<(PieceEdge, PieceEdge)>,
    /// For each edge of the state's polygon, the edges of pieces along it, in order.
    pub edges: Vec<Vec<PieceEdge>>,
}

/// The patches of all states of a figure.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Adjacency {
    /// By state.
    pub patches: BTreeMap<StateId, Patch>,
}

/// An edge of a piece at level 1, with the weights of its ends on the state's control points.
pub(super) struct Segment {
    pub(super) at: PieceEdge,
    pub(super) start: Vec<Rational>,
    pub(super) end: Vec<Rational>,
}

/// The edges of all pieces at level 1; `None` where a piece is no polygon.
pub(super) fn segments(automaton: &Automaton, state: StateId) -> Option<Vec<Segment>> {
    let mut segments = Vec::new();
    for (place, transform) in automaton.state(state).transforms.iter().enumerate() {
        let germ = &automaton.state(transform.target).germ;
        germ.edge(0)?;
        for edge in 0..germ.vertices.len() {
            let (start, end) = germ.edge(edge)?;
            let at = PieceEdge { transform: place, edge };
            let rows = [start, end].map(|row| row_times(row, &transform.matrix));
            let [start, end] = rows;
            segments.push(Segment { at, start, end });
        }
    }
    Some(segments)
}

/// The pairs of segments (by place) that coincide in opposite directions, where there are just two of them.
pub(super) fn coincident(segments: &[Segment]) -> Vec<(usize, usize)> {
    let mut ends: BTreeMap<(&[Rational], &[Rational]), Vec<usize>> = BTreeMap::new();
    for (place, segment) in segments.iter().enumerate() {
        ends.entry((&segment.start, &segment.end)).or_default().push(place);
    }
    let mut pairs = Vec::new();
    for (place, segment) in segments.iter().enumerate() {
        let there = ends.get(&(segment.start.as_slice(), segment.end.as_slice()));
        let back = ends.get(&(segment.end.as_slice(), segment.start.as_slice()));
        if let (Some(&[_]), Some(&[other])) = (there.map(Vec::as_slice), back.map(Vec::as_slice))
            && place < other
            && segment.at.transform != segments[other].at.transform
        {
            pairs.push((place, other));
        }
    }
    pairs
}

/// The patch of a state; `None` where its pieces do not hang together by edges, or their rim does not pass the corners of
/// the state's own polygon.
pub(super) fn patch(automaton: &Automaton, state: StateId, segments: &[Segment]) -> Option<Patch> {
    let pairs = coincident(segments);
    let pieces = automaton.state(state).transforms.len();
    let mut together = Classes::new(pieces);
    pairs.iter().for_each(|(a, b)| together.join(segments[*a].at.transform, segments[*b].at.transform));
    if (1..pieces).any(|piece| together.of(piece) != together.of(0)) {
        return None;
    }
    let corners = &automaton.state(state).germ.vertices;
    let classes = corner_classes(segments, &pairs);
    let rims = rims(segments, &pairs, &classes)?;
    let edges = rims.iter().find_map(|rim| cut_at_corners(segments, rim, corners)).or_else(|| {
        let longest = rims.iter().max_by_key(|rim| rim.len())?;
        cut_at_single_pieces(segments, longest, corners)
    })?;
    let glued = pairs.iter().map(|(a, b)| (segments[*a].at, segments[*b].at)).collect();
    Some(Patch { glued, edges })
}

/// The segment that follows one around its piece.
fn next_around(segments: &[Segment], place: usize) -> usize {
    let transform = segments[place].at.transform;
    match segments.get(place + 1) {
        Some(next) if next.at.transform == transform => place + 1,
        _ => place - segments[place].at.edge,
    }
}

/// The corners of all pieces, each named by the segment that starts there, joined where segments are glued.
fn corner_classes(segments: &[Segment], pairs: &[(usize, usize)]) -> Classes {
    let mut corners = Classes::new(segments.len());
    for (a, b) in pairs {
        corners.join(*a, next_around(segments, *b));
        corners.join(*b, next_around(segments, *a));
    }
    corners
}

/// The loops of segments that are glued to nothing, each in order. Two follow one another where their ends are one corner
/// by gluing, not merely by lying at the same place.
fn rims(segments: &[Segment], pairs: &[(usize, usize)], corners: &Classes) -> Option<Vec<Vec<usize>>> {
    let glued: BTreeSet<usize> = pairs.iter().flat_map(|(a, b)| [*a, *b]).collect();
    let mut starting: BTreeMap<usize, usize> = BTreeMap::new();
    for place in (0..segments.len()).filter(|place| !glued.contains(place)) {
        if starting.insert(corners.of(place), place).is_some() {
            return None;
        }
    }
    let mut rims = Vec::new();
    while let Some((_, first)) = starting.pop_first() {
        let mut rim = vec![first];
        let mut corner = corners.of(next_around(segments, first));
        while corner != corners.of(first) {
            let place = starting.remove(&corner)?;
            rim.push(place);
            corner = corners.of(next_around(segments, place));
        }
        rims.push(rim);
    }
    Some(rims)
}

/// Cuts a rim into the edges of the state's polygon where it passes its corners.
fn cut_at_corners(
    segments: &[Segment],
    rim: &[usize],
    corners: &[Vec<Rational>],
) -> Option<Vec<Vec<PieceEdge>>> {
    let place_of = |corner: &Vec<Rational>| rim.iter().position(|place| segments[*place].start == *corner);
    let cuts = corners.iter().map(place_of).collect::<Option<Vec<usize>>>()?;
    cut(segments, rim, &cuts)
}

/// Cuts a rim where only one piece has a corner, when there are as many such places as corners; the turn is that which
/// lies nearest. For schemes whose corners move from level to level.
fn cut_at_single_pieces(
    segments: &[Segment],
    rim: &[usize],
    corners: &[Vec<Rational>],
) -> Option<Vec<Vec<PieceEdge>>> {
    let before = |place: usize| rim[(place + rim.len() - 1) % rim.len()];
    let single = |place: &usize| segments[before(*place)].at.transform == segments[rim[*place]].at.transform;
    let cuts: Vec<usize> = (0..rim.len()).filter(single).collect();
    if cuts.len() != corners.len() {
        return None;
    }
    let away = |turn: &usize| -> Rational {
        let pairs = corners.iter().enumerate().map(|(place, corner)| {
            let found = &segments[rim[cuts[(place + turn) % cuts.len()]]].start;
            corner.iter().zip(found).map(|(a, b)| (a - b).abs()).sum::<Rational>()
        });
        pairs.sum()
    };
    let turn = (0..cuts.len()).min_by_key(away)?;
    let turned: Vec<usize> = (0..cuts.len()).map(|place| cuts[(place + turn) % cuts.len()]).collect();
    cut(segments, rim, &turned)
}

/// The stretches of a rim between one cut and the next; `None` when the cuts do not follow one another once around.
fn cut(segments: &[Segment], rim: &[usize], cuts: &[usize]) -> Option<Vec<Vec<PieceEdge>>> {
    let count = rim.len();
    let stretch = |place: usize| {
        let (from, to) = (cuts[place], cuts[(place + 1) % cuts.len()]);
        (from, (to + count - from) % count)
    };
    let lengths: usize = (0..cuts.len()).map(|place| stretch(place).1).sum();
    let empty = (0..cuts.len()).any(|place| stretch(place).1 == 0);
    if empty || lengths != count {
        return None;
    }
    let edge = |place: usize| {
        let (from, length) = stretch(place);
        (from..from + length).map(|along| segments[rim[along % count]].at).collect()
    };
    Some((0..cuts.len()).map(edge).collect())
}

/// Sets that are joined one by one; the least member stands for its set.
struct Classes {
    parents: Vec<usize>,
}

impl Classes {
    fn new(count: usize) -> Classes {
        Classes { parents: (0..count).collect() }
    }

    fn of(&self, mut member: usize) -> usize {
        while self.parents[member] != member {
            member = self.parents[member];
        }
        member
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.of(a), self.of(b));
        self.parents[a.max(b)] = a.min(b);
    }
}
