//! Every edge of a mesh once, in linear time: what a model of a million quads needs, without who neighbours whom.

/// The edges of `quads` on `vertices` vertices: for each vertex, ascending, its higher neighbours, ascending.
pub(super) struct EdgeList {
    /// Where the neighbours of each vertex start; one entry more than there are vertices.
    starts: Vec<u32>,
    /// Neighbours higher than the vertex.
    higher: Vec<u32>,
}

impl EdgeList {
    /// Finds the edges. Every index is below `vertices`.
    pub(super) fn of(quads: &[[u32; 4]], vertices: usize) -> Self {
        let mut ends = vec![0u32; vertices + 1];
        for_sides(quads, |low, _| ends[low as usize + 1] += 1);
        for vertex in 0..vertices {
            ends[vertex + 1] += ends[vertex];
        }
        let mut higher = vec![0u32; ends[vertices] as usize];
        let mut next = ends.clone();
        for_sides(quads, |low, high| {
            let slot = &mut next[low as usize];
            higher[*slot as usize] = high;
            *slot += 1;
        });
        Self::compact(ends, higher)
    }

    /// Sorts the neighbours of each vertex and drops those found from both sides.
    fn compact(mut starts: Vec<u32>, mut higher: Vec<u32>) -> Self {
        let mut kept = 0usize;
        let mut from = 0usize;
        for vertex in 0..starts.len() - 1 {
            let to = starts[vertex + 1] as usize;
            higher[from..to].sort_unstable();
            starts[vertex] = kept as u32;
            let mut last = None;
            for slot in from..to {
                let high = higher[slot];
                if last != Some(high) {
                    higher[kept] = high;
                    kept += 1;
                    last = Some(high);
                }
            }
            from = to;
        }
        if let Some(last) = starts.last_mut() {
            *last = kept as u32;
        }
        higher.truncate(kept);
        Self { starts, higher }
    }

    /// How many edges there are.
    pub(super) fn len(&self) -> usize {
        self.higher.len()
    }

    /// The edges, the lower end first.
    pub(super) fn iter(&self) -> impl Iterator<Item = [u32; 2]> {
        (0u32..).zip(self.starts.windows(2)).flat_map(|(low, range)| {
            self.higher[range[0] as usize..range[1] as usize].iter().map(move |&high| [low, high])
        })
    }
}

/// Calls `found` for each side with two different ends, the lower first.
fn for_sides(quads: &[[u32; 4]], mut found: impl FnMut(u32, u32)) {
    for &[a, b, c, d] in quads {
        for (from, to) in [(a, b), (b, c), (c, d), (d, a)] {
            if from != to {
                found(from.min(to), from.max(to));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Closed, samples};

    #[test]
    fn the_same_edges_as_the_topology() {
        let point = |i: f64, j: f64| glam::DVec3::new(i, j, 0.0);
        let closed = Closed { rows: true, columns: true };
        let meshes = [samples::mesh(6, 4, point), samples::grid(5, 4, point).to_mesh(closed).unwrap()];
        for mesh in meshes {
            let list = EdgeList::of(&mesh.quads, mesh.vertices.len());
            let wanted: Vec<[u32; 2]> = mesh
                .topology()
                .unwrap()
                .edges
                .iter()
                .map(|edge| [edge.vertices[0].min(edge.vertices[1]), edge.vertices[0].max(edge.vertices[1])])
                .collect();
            assert_eq!(list.iter().collect::<Vec<_>>(), wanted);
            assert_eq!(list.len(), wanted.len());
        }
        assert_eq!(EdgeList::of(&[[1, 1, 2, 2]], 4).iter().collect::<Vec<_>>(), [[1, 2]]);
        assert_eq!(EdgeList::of(&[], 0).len(), 0);
    }
}
