//! The fairness of displacements: d = (L + κ)⁻¹ y, with L the graph Laplacian of the mesh over the vertices that may
//! move. The shortest y makes Σ|(L + κ)d|² least, the discrete thin-plate energy of the displacement with some
//! closeness to the design; the surface itself may be as rough as it likes.

use glam::DVec3;

use crate::geometry::QuadMesh;

use super::cholesky::{Cholesky, Graph};
use super::constraints::Row;

/// A vertex that may not move.
pub(super) const HELD: u32 = u32::MAX;

/// The operator (L + κ)⁻¹.
pub(super) struct Displacement {
    factor: Cholesky,
    /// For each vertex of the mesh its place in vectors, or [`HELD`].
    place: Vec<u32>,
    count: usize,
}

impl Displacement {
    /// The operator for the vertices that are not `held`; `None` if the mesh is too large for it. κ is `closeness` by
    /// the number of vertices of the connected part: a displacement is smooth over about 1/√closeness of the part.
    pub(super) fn new(mesh: &QuadMesh, held: &[bool], closeness: f64) -> Option<Self> {
        let edges = edges(mesh);
        let mut free = vec![HELD; held.len()];
        let mut count = 0;
        for (place, _) in free.iter_mut().zip(held).filter(|(_, held)| !**held) {
            *place = count;
            count += 1;
        }
        let mut diagonal = vec![0.0; count as usize];
        let mut inner = Vec::with_capacity(edges.len());
        for edge in &edges {
            let places = edge.map(|vertex| free[vertex as usize]);
            for place in places.into_iter().filter(|&place| place != HELD) {
                diagonal[place as usize] += 1.0;
            }
            if !places.contains(&HELD) {
                inner.push(places);
            }
        }
        let graph = Graph::new(count as usize, &inner);
        for (diagonal, size) in diagonal.iter_mut().zip(part_sizes(&graph)) {
            *diagonal += closeness / f64::from(size);
        }
        let factor = Cholesky::new(&graph, &diagonal)?;
        let place = free.iter().map(|&free| if free == HELD { HELD } else { factor.place[free as usize] });
        Some(Self { place: place.collect(), factor, count: count as usize })
    }

    /// How many vertices may move.
    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// Applies (L + κ)⁻¹ in place.
    pub(super) fn smooth(&self, vector: &mut [DVec3]) {
        self.factor.solve(vector);
    }

    /// The rows with their corners as places of vectors.
    pub(super) fn placed(&self, mut rows: Vec<Row>) -> Vec<Row> {
        for row in &mut rows {
            row.corners = row.corners.map(|corner| self.place[corner as usize]);
        }
        rows
    }

    /// The vertices moved by `length` times the displacement.
    pub(super) fn moved(&self, vertices: &[DVec3], length: f64, displacement: &[DVec3]) -> Vec<DVec3> {
        let places = self.place.iter().map(|&place| place as usize);
        let moves = places.map(|place| displacement.get(place).copied().unwrap_or_default());
        vertices.iter().zip(moves).map(|(vertex, by)| *vertex + by * length).collect()
    }
}

/// The sides of all quads, each once.
fn edges(mesh: &QuadMesh) -> Vec<[u32; 2]> {
    let sides = mesh.quads.iter().flat_map(|&[a, b, c, d]| [[a, b], [b, c], [c, d], [d, a]]);
    let mut edges: Vec<[u32; 2]> = sides.filter(|[p, q]| p != q).map(|[p, q]| [p.min(q), p.max(q)]).collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}

/// For each vertex how many vertices its connected part has.
fn part_sizes(graph: &Graph) -> Vec<u32> {
    let mut sizes = vec![0u32; graph.len()];
    let mut part = Vec::new();
    for start in 0..graph.len() as u32 {
        if sizes[start as usize] != 0 {
            continue;
        }
        part.clear();
        part.push(start);
        sizes[start as usize] = 1;
        let mut next = 0;
        while next < part.len() {
            for &other in graph.of(part[next]) {
                if sizes[other as usize] == 0 {
                    sizes[other as usize] = 1;
                    part.push(other);
                }
            }
            next += 1;
        }
        part.iter().for_each(|&vertex| sizes[vertex as usize] = part.len() as u32);
    }
    sizes
}
