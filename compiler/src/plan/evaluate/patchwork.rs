//! Patchworks: polygons that share vertices where their edges are proved to be one, never by distance (GEOMETRY 3).
//!
//! First the mesh without places: that of a state at level k is those of its pieces at level k−1, with the vertices along
//! glued edges made one. Then the places, word by word.

use std::collections::BTreeMap;

use super::super::figure::PatchworkPlan;
use super::basis::needed_states;
use crate::ifs::{Adjacency, Automaton, Matrix, Patch, PieceEdge, StateId};

/// A mesh of polygons in the order of their words.
#[derive(Clone, Debug, PartialEq)]
pub struct Patchwork {
    /// Places in millimetres, in the order in which polygons meet them.
    pub vertices: Vec<[f64; 3]>,
    /// Corners of all polygons, one after the other.
    corners: Vec<u32>,
    /// Corners of each polygon.
    sizes: Vec<u32>,
}

impl Patchwork {
    /// The corners of each polygon, as places of vertices.
    pub fn polygons(&self) -> impl Iterator<Item = &[u32]> {
        let mut rest = self.corners.as_slice();
        self.sizes.iter().map(move |size| {
            let (polygon, after) = rest.split_at(*size as usize);
            rest = after;
            polygon
        })
    }
}

/// The mesh of a patchwork of a [`crate::plan::Plan`] on this automaton, within a budget; `None` for more than 2^32
/// vertices, or where the adjacency is not that of the automaton.
///
/// # Panics
/// When the states are not of this automaton.
pub fn patchwork(automaton: &Automaton, adjacency: &Adjacency, plan: &PatchworkPlan) -> Option<Patchwork> {
    let net = net(automaton, adjacency, plan.state, plan.level)?;
    let mut places = Places {
        automaton,
        matrices: BTreeMap::new(),
        corners: &net.corners,
        next_corner: 0,
        vertices: Vec::with_capacity(net.vertices as usize),
    };
    places.fill(plan.state, plan.level, &plan.points)?;
    Some(Patchwork { vertices: places.vertices, corners: net.corners, sizes: net.sizes })
}

/// A mesh without places.
#[derive(Clone, Debug, Default)]
struct Net {
    vertices: u32,
    corners: Vec<u32>,
    sizes: Vec<u32>,
    /// For each edge of the state's polygon, the vertices along it, both ends included.
    edges: Vec<Vec<u32>>,
}

fn net(automaton: &Automaton, adjacency: &Adjacency, state: StateId, level: u32) -> Option<Net> {
    let needed = needed_states(automaton, state, level);
    let mut nets: BTreeMap<StateId, Net> = BTreeMap::new();
    for (height, states) in needed.iter().rev().enumerate() {
        let next = |id: &StateId| match height {
            0 => Some((*id, single(u32::try_from(automaton.state(*id).germ.vertices.len()).ok()?))),
            _ => Some((*id, composed(automaton, adjacency.patches.get(id)?, *id, &nets)?)),
        };
        nets = states.iter().map(next).collect::<Option<BTreeMap<StateId, Net>>>()?;
    }
    nets.remove(&state)
}

fn single(size: u32) -> Net {
    let edges = (0..size).map(|corner| vec![corner, (corner + 1) % size]).collect();
    Net { vertices: size, corners: (0..size).collect(), sizes: vec![size], edges }
}

/// The nets of the pieces of a state, with the vertices along glued edges made one.
fn composed(
    automaton: &Automaton,
    patch: &Patch,
    state: StateId,
    nets: &BTreeMap<StateId, Net>,
) -> Option<Net> {
    let transforms = &automaton.state(state).transforms;
    let pieces = transforms.iter().map(|transform| nets.get(&transform.target));
    let pieces: Vec<&Net> = pieces.collect::<Option<Vec<_>>>()?;
    let mut firsts = Vec::with_capacity(pieces.len());
    let mut total = 0_u32;
    for piece in &pieces {
        firsts.push(total);
        total = total.checked_add(piece.vertices)?;
    }
    let along = |at: &PieceEdge| -> Option<Vec<u32>> {
        let edge = pieces.get(at.transform)?.edges.get(at.edge)?;
        Some(edge.iter().map(|vertex| vertex + firsts[at.transform]).collect())
    };
    let mut welds = Welds { parents: (0..total).collect() };
    for (left, right) in &patch.glued {
        let (left, right) = (along(left)?, along(right)?);
        if left.len() != right.len() {
            return None;
        }
        left.iter().zip(right.iter().rev()).for_each(|(a, b)| welds.weld(*a, *b));
    }
    let (names, vertices) = welds.names();
    let mut out = Net { vertices, ..Net::default() };
    for (piece, first) in pieces.iter().zip(&firsts) {
        out.corners.extend(piece.corners.iter().map(|corner| names[(corner + first) as usize]));
        out.sizes.extend(&piece.sizes);
    }
    for chain in &patch.edges {
        let mut edge: Vec<u32> = Vec::new();
        for at in chain {
            let vertices = along(at)?;
            let shared = usize::from(!edge.is_empty());
            edge.extend(vertices[shared..].iter().map(|vertex| names[*vertex as usize]));
        }
        out.edges.push(edge);
    }
    Some(out)
}

/// Vertices made one; the first stands for all.
struct Welds {
    parents: Vec<u32>,
}

impl Welds {
    fn first(&self, mut vertex: u32) -> u32 {
        while self.parents[vertex as usize] != vertex {
            vertex = self.parents[vertex as usize];
        }
        vertex
    }

    fn weld(&mut self, a: u32, b: u32) {
        let (a, b) = (self.first(a), self.first(b));
        self.parents[a.max(b) as usize] = a.min(b);
    }

    /// New names without gaps, in the order of the first of each, and how many there are.
    fn names(&self) -> (Vec<u32>, u32) {
        let mut names = Vec::with_capacity(self.parents.len());
        let mut count = 0;
        for vertex in 0..self.parents.len() as u32 {
            let first = self.first(vertex);
            if first == vertex {
                names.push(count);
                count += 1;
            } else {
                names.push(names[first as usize]);
            }
        }
        (names, count)
    }
}

/// Places of vertices, found word by word.
struct Places<'a> {
    automaton: &'a Automaton,
    /// Matrices of each state's transforms in doubles.
    matrices: BTreeMap<StateId, Vec<Vec<f64>>>,
    corners: &'a [u32],
    next_corner: usize,
    vertices: Vec<[f64; 3]>,
}

impl Places<'_> {
    /// The polygons of a state on these points; an open list of pieces stands for a recursion.
    fn fill(&mut self, state: StateId, level: u32, points: &[[f64; 3]]) -> Option<()> {
        let mut open = vec![(state, level, points.to_vec())];
        while let Some((state, level, points)) = open.pop() {
            if level == 0 {
                self.polygon(state, &points)?;
                continue;
            }
            let transforms = &self.automaton.state(state).transforms;
            let all = || transforms.iter().map(|transform| Matrix::to_f64(&transform.matrix)).collect();
            let matrices = self.matrices.entry(state).or_insert_with(all);
            for (transform, matrix) in transforms.iter().zip(matrices).rev() {
                let rows = matrix.chunks_exact(points.len());
                let image: Vec<[f64; 3]> = rows.map(|row| weighted(row, &points)).collect();
                open.push((transform.target, level - 1, image));
            }
        }
        Some(())
    }

    fn polygon(&mut self, state: StateId, points: &[[f64; 3]]) -> Option<()> {
        for row in &self.automaton.state(state).germ.vertices {
            let corner = *self.corners.get(self.next_corner)?;
            self.next_corner += 1;
            if corner as usize == self.vertices.len() {
                let row: Vec<f64> = row.iter().map(crate::exact::Rational::to_f64).collect();
                self.vertices.push(weighted(&row, points));
            }
        }
        Some(())
    }
}

fn weighted(row: &[f64], points: &[[f64; 3]]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (weight, point) in row.iter().zip(points) {
        for (total, coordinate) in sum.iter_mut().zip(point) {
            *total += weight * coordinate;
        }
    }
    sum
}
