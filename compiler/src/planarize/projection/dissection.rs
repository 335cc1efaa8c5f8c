//! Nested dissection (George 1973) of a graph by level structures: the order of elimination that keeps a Cholesky
//! factor thin. It looks at who neighbours whom only, never at positions.

use super::cholesky::Graph;

/// Sets of at most so many vertices are not cut again.
const LEAF: usize = 24;

/// A vertex of more neighbours than this many times the mean is eliminated last.
const HUB: usize = 16;

const NONE: u32 = u32::MAX;

/// The vertices of `graph` in the order in which to eliminate them.
pub(super) fn elimination_order(graph: &Graph) -> Vec<u32> {
    let count = graph.len();
    let mean = (graph.neighbours.len() / count.max(1)).max(1);
    let (hubs, rest): (Vec<u32>, Vec<u32>) =
        (0..count as u32).partition(|&vertex| graph.of(vertex).len() > HUB * mean);
    let mut order = vec![0u32; count];
    order[rest.len()..].copy_from_slice(&hubs);
    let mut dissection = Dissection { graph, set: vec![NONE; count], level: vec![NONE; count], sets: 0 };
    let mut waiting = vec![(rest, 0usize)];
    while let Some((vertices, place)) = waiting.pop() {
        dissection.cut(vertices, place, &mut order, &mut waiting);
    }
    order
}

struct Dissection<'a> {
    graph: &'a Graph,
    /// The set each vertex is in at the moment.
    set: Vec<u32>,
    /// Its distance from where the last search of its set began.
    level: Vec<u32>,
    sets: u32,
}

impl Dissection<'_> {
    /// Puts a set of vertices that goes to `place` into order, or cuts it into smaller sets.
    fn cut(
        &mut self,
        vertices: Vec<u32>,
        place: usize,
        order: &mut [u32],
        waiting: &mut Vec<(Vec<u32>, usize)>,
    ) {
        self.sets += 1;
        for &vertex in &vertices {
            self.set[vertex as usize] = self.sets;
            self.level[vertex as usize] = NONE;
        }
        let parts = self.connected(&vertices);
        let mut place = place;
        for part in parts {
            let length = part.len();
            if length <= LEAF {
                order[place..place + length].copy_from_slice(&part);
            } else {
                self.separate(part, place, order, waiting);
            }
            place += length;
        }
    }

    /// The connected parts of the present set, each in the order of a breadth-first search.
    fn connected(&mut self, vertices: &[u32]) -> Vec<Vec<u32>> {
        let mut parts = Vec::new();
        for &vertex in vertices {
            if self.level[vertex as usize] == NONE {
                parts.push(self.search(vertex));
            }
        }
        parts
    }

    /// The vertices reached from `start` inside its set, nearest first; their levels are set.
    fn search(&mut self, start: u32) -> Vec<u32> {
        let set = self.set[start as usize];
        let mut reached = vec![start];
        self.level[start as usize] = 0;
        let mut next = 0;
        while next < reached.len() {
            let vertex = reached[next];
            next += 1;
            let level = self.level[vertex as usize] + 1;
            for &other in self.graph.of(vertex) {
                if self.set[other as usize] == set && self.level[other as usize] == NONE {
                    self.level[other as usize] = level;
                    reached.push(other);
                }
            }
        }
        reached
    }

    /// Cuts a connected part at the level that has half of its vertices before it, seen from one of its ends.
    fn separate(
        &mut self,
        part: Vec<u32>,
        place: usize,
        order: &mut [u32],
        waiting: &mut Vec<(Vec<u32>, usize)>,
    ) {
        let mut reached = part;
        for _ in 0..2 {
            let end = reached[reached.len() - 1];
            reached.iter().for_each(|&vertex| self.level[vertex as usize] = NONE);
            reached = self.search(end);
        }
        let middle = self.level[reached[reached.len() / 2] as usize];
        let (mut before, mut separator, mut after) = (Vec::new(), Vec::new(), Vec::new());
        for &vertex in &reached {
            match self.level[vertex as usize].cmp(&middle) {
                std::cmp::Ordering::Less => before.push(vertex),
                std::cmp::Ordering::Greater => after.push(vertex),
                // One without a neighbour beyond does not separate anything.
                std::cmp::Ordering::Equal => {
                    let set = self.set[vertex as usize];
                    let beyond = self.graph.of(vertex).iter().any(|&other| {
                        self.set[other as usize] == set && self.level[other as usize] == middle + 1
                    });
                    if beyond { separator.push(vertex) } else { before.push(vertex) }
                }
            }
        }
        let end = place + reached.len();
        order[end - separator.len()..end].copy_from_slice(&separator);
        if separator.is_empty() {
            // All levels end here: nothing to cut.
            order[place..end].copy_from_slice(&reached);
            return;
        }
        let first = before.len();
        waiting.push((after, place + first));
        waiting.push((before, place));
    }
}
