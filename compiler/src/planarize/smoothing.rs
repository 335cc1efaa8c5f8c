//! Smoothing of displacements over the mesh, so that neighbours move alike and the design keeps its look.

use glam::DVec3;

use crate::geometry::QuadMesh;

/// After how many averagings a displacement is taken up into the result: a narrow, a middle and a wide one, so that
/// rough surfaces find their short way and large smooth ones do not take hundreds of iterations.
const SCALES: [usize; 3] = [2, 6, 20];

/// A symmetric positive definite operator on displacements: the sum, over the `SCALES`, of that many applications of
/// I − w·L, with L the graph Laplacian of the mesh's edges. Vertices that may not move count as zero and stay so.
pub(super) struct Smoothing {
    /// Ends of the edges with at least one free end.
    edges: Vec<[u32; 2]>,
    free: Vec<bool>,
    weight: f64,
}

impl Smoothing {
    /// The operator for the vertices of `mesh` that are `free`.
    pub(super) fn new(mesh: &QuadMesh, free: &[bool]) -> Self {
        let mut edges: Vec<[u32; 2]> = mesh
            .quads
            .iter()
            .flat_map(|&[a, b, c, d]| [[a, b], [b, c], [c, d], [d, a]])
            .filter(|[p, q]| p != q && (free[*p as usize] || free[*q as usize]))
            .map(|[p, q]| [p.min(q), p.max(q)])
            .collect();
        edges.sort_unstable();
        edges.dedup();
        let mut degree = vec![0u32; mesh.vertices.len()];
        edges.iter().flatten().for_each(|&vertex| degree[vertex as usize] += 1);
        let largest = degree.into_iter().max().unwrap_or(0).max(1);
        // The eigenvalues of L lie in 0 ..= 2·largest, so those of I − w·L in 0.1 ..= 1.
        Self { edges, free: free.to_vec(), weight: 0.9 / (2.0 * f64::from(largest)) }
    }

    /// Applies the operator to a displacement which is zero at all vertices that are not free.
    pub(super) fn apply(&self, displacement: &[DVec3]) -> Vec<DVec3> {
        let mut present = displacement.to_vec();
        let mut change = vec![DVec3::ZERO; present.len()];
        let mut sum = change.clone();
        let mut pass = 0;
        for scale in SCALES {
            while pass < scale {
                self.average(&mut present, &mut change);
                pass += 1;
            }
            sum.iter_mut().zip(&present).for_each(|(sum, part)| *sum += *part);
        }
        sum
    }

    /// One application of I − w·L.
    fn average(&self, present: &mut [DVec3], change: &mut [DVec3]) {
        change.fill(DVec3::ZERO);
        for &[p, q] in &self.edges {
            let difference = present[q as usize] - present[p as usize];
            change[p as usize] += difference;
            change[q as usize] -= difference;
        }
        for ((present, change), free) in present.iter_mut().zip(change).zip(&self.free) {
            if *free {
                *present += *change * self.weight;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::samples;
    use crate::planarize::lbfgs::dot;

    /// Displacements of the inner vertices of a 5 by 5 grid, different for each `seed`.
    fn displacement(free: &[bool], seed: f64) -> Vec<DVec3> {
        let at = |k: f64| DVec3::new(libm::sin(seed * k), libm::cos(seed + k), libm::sin(k * k + seed));
        free.iter().zip(0u8..).map(|(free, k)| if *free { at(k.into()) } else { DVec3::ZERO }).collect()
    }

    #[test]
    fn symmetric_positive_and_still_where_held() {
        let mesh = samples::flat_grid(5, 5, 100.0);
        let rim = mesh.boundary_vertices().unwrap();
        let free: Vec<bool> = (0..25).map(|vertex| !rim.contains(&vertex)).collect();
        let smoothing = Smoothing::new(&mesh, &free);
        let (one, two) = (displacement(&free, 1.3), displacement(&free, 4.7));
        let (first, second) = (smoothing.apply(&one), smoothing.apply(&two));
        assert!((dot(&one, &second) - dot(&two, &first)).abs() < 1e-12);
        assert!(dot(&one, &first) > 0.0);
        assert!(rim.iter().all(|&vertex| first[vertex as usize] == DVec3::ZERO));
    }

    #[test]
    fn what_all_share_is_kept_and_what_alternates_is_damped() {
        let mesh = samples::flat_grid(6, 6, 100.0);
        let smoothing = Smoothing::new(&mesh, &[true; 36]);
        let same = smoothing.apply(&[DVec3::X; 36]);
        assert!(same.iter().all(|part| (*part - DVec3::X * 3.0).length() < 1e-12));
        let checkers: Vec<DVec3> =
            (0..36).map(|k| if (k / 6 + k % 6) % 2 == 0 { DVec3::X } else { -DVec3::X }).collect();
        assert!(smoothing.apply(&checkers).iter().all(|part| part.length() < 0.7));
    }
}
