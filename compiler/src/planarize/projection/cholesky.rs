//! A sparse Cholesky factor (up-looking; Davis 2006, chapter 4) of a symmetric positive definite matrix with one number
//! for each edge of a graph, and solving with it for three right-hand sides at once.

use glam::DVec3;

use super::dissection::elimination_order;

/// The most numbers a factor may have: about a gigabyte.
const MOST_ENTRIES: usize = 90_000_000;

const NONE: u32 = u32::MAX;

/// Who neighbours whom, without loops.
pub(super) struct Graph {
    /// Where the neighbours of each vertex begin in `neighbours`; one more at the end.
    starts: Vec<usize>,
    pub(super) neighbours: Vec<u32>,
}

impl Graph {
    /// The graph of `count` vertices with these edges, each given once.
    pub(super) fn new(count: usize, edges: &[[u32; 2]]) -> Self {
        let mut starts = vec![0usize; count + 1];
        edges.iter().flatten().for_each(|&vertex| starts[vertex as usize + 1] += 1);
        for vertex in 0..count {
            starts[vertex + 1] += starts[vertex];
        }
        let (mut free, mut neighbours) = (starts.clone(), vec![0u32; edges.len() * 2]);
        for &[one, two] in edges {
            for (vertex, other) in [(one, two), (two, one)] {
                neighbours[free[vertex as usize]] = other;
                free[vertex as usize] += 1;
            }
        }
        Self { starts, neighbours }
    }

    /// How many vertices.
    pub(super) fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// The neighbours of a vertex.
    pub(super) fn of(&self, vertex: u32) -> &[u32] {
        &self.neighbours[self.starts[vertex as usize]..self.starts[vertex as usize + 1]]
    }
}

/// L with L·Lᵀ = the matrix whose entry is −1 for each edge of the graph and a given number on the diagonal, its rows
/// and columns in the order of elimination.
pub(super) struct Cholesky {
    /// The place of each vertex in that order.
    pub(super) place: Vec<u32>,
    diagonal: Vec<f64>,
    /// Where the entries of each column below the diagonal begin; one more at the end.
    starts: Vec<usize>,
    rows: Vec<u32>,
    values: Vec<f64>,
}

impl Cholesky {
    /// Factors the matrix; `None` where the factor would have too many entries, or the matrix is not positive
    /// definite. `diagonal` is by vertex.
    pub(super) fn new(graph: &Graph, diagonal: &[f64]) -> Option<Self> {
        let order = elimination_order(graph);
        let count = graph.len();
        let mut place = vec![0u32; count];
        for (position, &vertex) in (0u32..).zip(&order) {
            place[vertex as usize] = position;
        }
        let pattern = Pattern::new(graph, &order, &place)?;
        let mut factor = Self {
            place,
            diagonal: vec![0.0; count],
            rows: vec![0; pattern.starts[count]],
            values: vec![0.0; pattern.starts[count]],
            starts: pattern.starts.clone(),
        };
        factor.fill(graph, diagonal, &order, pattern)?;
        Some(factor)
    }

    fn fill(&mut self, graph: &Graph, diagonal: &[f64], order: &[u32], mut pattern: Pattern) -> Option<()> {
        let mut filled = self.starts.clone();
        let mut row = vec![0.0f64; order.len()];
        for (k, &vertex) in order.iter().enumerate() {
            for &other in graph.of(vertex) {
                row[self.place[other as usize] as usize] = -1.0;
            }
            let mut pivot = diagonal[vertex as usize];
            for &column in pattern.row(graph, order, &self.place, k) {
                let column = column as usize;
                let entry = row[column] / self.diagonal[column];
                row[column] = 0.0;
                let (start, end) = (self.starts[column], filled[column]);
                for (&below, value) in self.rows[start..end].iter().zip(&self.values[start..end]) {
                    row[below as usize] -= value * entry;
                }
                pivot -= entry * entry;
                self.rows[end] = k as u32;
                self.values[end] = entry;
                filled[column] = end + 1;
            }
            for &other in graph.of(vertex) {
                row[self.place[other as usize] as usize] = 0.0;
            }
            if !(pivot > 0.0 && pivot.is_finite()) {
                return None;
            }
            self.diagonal[k] = pivot.sqrt();
        }
        Some(())
    }

    /// Solves in place; the vector is in the order of elimination.
    pub(super) fn solve(&self, vector: &mut [DVec3]) {
        for column in 0..vector.len() {
            let value = vector[column] / self.diagonal[column];
            vector[column] = value;
            for place in self.starts[column]..self.starts[column + 1] {
                vector[self.rows[place] as usize] -= value * self.values[place];
            }
        }
        for column in (0..vector.len()).rev() {
            let mut value = vector[column];
            for place in self.starts[column]..self.starts[column + 1] {
                value -= vector[self.rows[place] as usize] * self.values[place];
            }
            vector[column] = value / self.diagonal[column];
        }
    }
}

/// Which entries of L are not zero, found by the elimination tree.
struct Pattern {
    parent: Vec<u32>,
    starts: Vec<usize>,
    /// The row that last visited each column.
    visited: Vec<u32>,
    found: Vec<u32>,
}

impl Pattern {
    fn new(graph: &Graph, order: &[u32], place: &[u32]) -> Option<Self> {
        let count = order.len();
        let mut pattern = Self {
            parent: elimination_tree(graph, order, place),
            starts: vec![0; count + 1],
            visited: vec![NONE; count],
            found: Vec::new(),
        };
        let mut entries = 0;
        let mut counts = vec![0usize; count];
        for k in 0..count {
            for &column in pattern.row(graph, order, place, k) {
                counts[column as usize] += 1;
                entries += 1;
            }
            if entries > MOST_ENTRIES {
                return None;
            }
        }
        for (column, entries) in counts.into_iter().enumerate() {
            pattern.starts[column + 1] = pattern.starts[column] + entries;
        }
        pattern.visited.fill(NONE);
        Some(pattern)
    }

    /// The columns before `k` in which row `k` of L has an entry, each after all that it depends on.
    fn row(&mut self, graph: &Graph, order: &[u32], place: &[u32], k: usize) -> &[u32] {
        self.found.clear();
        self.visited[k] = k as u32;
        for &other in graph.of(order[k]) {
            let mut column = place[other as usize];
            if column as usize > k {
                continue;
            }
            while self.visited[column as usize] != k as u32 {
                self.visited[column as usize] = k as u32;
                self.found.push(column);
                column = self.parent[column as usize];
            }
        }
        // A column depends on columns before it alone.
        self.found.sort_unstable();
        &self.found
    }
}

/// For each column of L the next one in which it has an entry (Liu 1990).
fn elimination_tree(graph: &Graph, order: &[u32], place: &[u32]) -> Vec<u32> {
    let count = order.len();
    let (mut parent, mut ancestor) = (vec![NONE; count], vec![NONE; count]);
    for k in 0..count as u32 {
        for &other in graph.of(order[k as usize]) {
            let mut column = place[other as usize];
            while column != NONE && column < k {
                let next = ancestor[column as usize];
                ancestor[column as usize] = k;
                if next == NONE {
                    parent[column as usize] = k;
                }
                column = next;
            }
        }
    }
    parent
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn check(count: usize, edges: &[[u32; 2]]) {
        let graph = Graph::new(count, edges);
        let diagonal: Vec<f64> =
            (0..count as u32).map(|vertex| graph.of(vertex).len() as f64 + 0.5).collect();
        let factor = Cholesky::new(&graph, &diagonal).unwrap();
        let wanted: Vec<DVec3> = (0..count).map(|k| DVec3::new(k as f64, 1.0, -(k as f64) * 0.5)).collect();
        let mut vector = vec![DVec3::ZERO; count];
        for vertex in 0..count {
            let mut sum = wanted[vertex] * diagonal[vertex];
            graph.of(vertex as u32).iter().for_each(|&other| sum -= wanted[other as usize]);
            vector[factor.place[vertex] as usize] = sum;
        }
        factor.solve(&mut vector);
        for vertex in 0..count {
            let found = vector[factor.place[vertex] as usize];
            assert!((found - wanted[vertex]).length() < 1e-8 * (count as f64 + 1.0), "{vertex}: {found}");
        }
    }

    #[test]
    fn solves_on_a_grid_a_star_and_apart() {
        let at = |i: u32, j: u32| i * 40 + j;
        let along = (0..40).flat_map(|i| (0..39).map(move |j| [at(i, j), at(i, j + 1)]));
        let across = (0..39).flat_map(|i| (0..40).map(move |j| [at(i, j), at(i + 1, j)]));
        check(1600, &along.chain(across).collect::<Vec<_>>());
        check(300, &(1..300).map(|vertex| [0, vertex]).collect::<Vec<_>>());
        check(90, &(0..45).map(|pair| [2 * pair, 2 * pair + 1]).collect::<Vec<_>>());
        check(0, &[]);
    }

    #[test]
    fn the_factor_of_a_grid_is_thin() {
        let side = 100u32;
        let at = |i: u32, j: u32| i * side + j;
        let along = (0..side).flat_map(|i| (0..side - 1).map(move |j| [at(i, j), at(i, j + 1)]));
        let across = (0..side - 1).flat_map(|i| (0..side).map(move |j| [at(i, j), at(i + 1, j)]));
        let graph = Graph::new((side * side) as usize, &along.chain(across).collect::<Vec<_>>());
        let factor = Cholesky::new(&graph, &vec![5.0; graph.len()]).unwrap();
        // A band would have side³ = 1,000,000; George's bound is 31/4·n²·log2 n = 515,000.
        assert!(factor.values.len() < 515_000, "{}", factor.values.len());
    }

    proptest! {
        #[test]
        fn solves_on_any_graph(count in 1usize..60, picks in proptest::collection::vec((0u32..60, 0u32..60), 0..150)) {
            let mut edges: Vec<[u32; 2]> = picks
                .into_iter()
                .map(|(one, two)| [one.min(two), one.max(two)])
                .filter(|[one, two]| one != two && (*two as usize) < count)
                .collect();
            edges.sort_unstable();
            edges.dedup();
            check(count, &edges);
        }
    }
}
