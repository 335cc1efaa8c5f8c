//! What the method promises, on whole meshes: shells, rough grids, odd input, and what each parameter does.

pub(super) mod odd_input;
pub(super) use odd_input as odd;
mod parameters;
mod surfaces;

use super::{Outcome, Perturbation, Pin, perturb};
use crate::geometry::{QuadMeasure, QuadMesh, Verdict, samples};
use glam::DVec3;
use std::ops::ControlFlow;

/// The parameters of the shell in LANGUAGE section 7, with its required planarity as the threshold.
fn shell_options() -> Perturbation {
    let options = Perturbation { threshold: 0.9998, ..Perturbation::default() };
    Perturbation::try_new(options).unwrap()
}

fn run(mesh: &QuadMesh, options: &Perturbation) -> Outcome {
    perturb(mesh, options, &mut |_| ControlFlow::Continue(()))
}

fn worst(outcome: &Outcome) -> f64 {
    outcome.after.worst.unwrap().value
}

/// The weights of four neighbouring control points at the parameter t of a uniform cubic B-spline's segment. At
/// t = 0 and t = 1 they are the limit rows (1, 4, 1, 0)/6 and (0, 1, 4, 1)/6 (GEOMETRY section 1).
fn cubic_weights(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    let inner = |t: f64| (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0;
    [s * s * s / 6.0, inner(t), inner(s), t * t * t / 6.0]
}

/// A uniform bicubic B-spline sheet over `size` by `size` control points (i·1 m, j·1 m, height(i, j) mm): every 4 by 4
/// window at the level, joined, with its vertices on the limit surface.
pub(super) fn shell(size: usize, level: u32, height: impl Fn(f64, f64) -> f64) -> QuadMesh {
    let pieces = 1usize << level;
    let last = size - 4;
    let place = |k: f64| {
        let window = (k as usize / pieces).min(last);
        (window, cubic_weights(k / pieces as f64 - window as f64))
    };
    let count = (size - 3) * pieces + 1;
    samples::mesh(count, count, |i, j| {
        let ((row, across), (column, along)) = (place(i), place(j));
        let mut point = DVec3::ZERO;
        for (a, first) in across.iter().enumerate() {
            for (b, second) in along.iter().enumerate() {
                let (x, y) = ((row + a) as f64, (column + b) as f64);
                point += DVec3::new(1000.0 * x, 1000.0 * y, height(x, y)) * (first * second);
            }
        }
        point
    })
}

/// The net of the shell in LANGUAGE section 5, with another amplitude (mm).
pub(super) fn dome(amplitude: f64) -> impl Fn(f64, f64) -> f64 {
    let sine = |k: f64| libm::sin((30.0 * k).to_radians());
    move |i, j| amplitude * sine(i) * sine(j)
}

/// The longest difference between the displacements of neighbouring vertices, mm.
fn unevenness(before: &QuadMesh, after: &QuadMesh) -> f64 {
    let moved = |vertex: u32| after.vertices[vertex as usize] - before.vertices[vertex as usize];
    let edges = before.topology().unwrap().edges;
    edges.iter().map(|edge| moved(edge.vertices[0]).distance(moved(edge.vertices[1]))).fold(0.0, f64::max)
}

/// What holds for every run of the perturbation, whatever it was given.
fn check_promises(mesh: &QuadMesh, options: &Perturbation, outcome: &Outcome) {
    check_kept(mesh, options.pin, outcome);
    assert!(outcome.iterations <= options.iterations);
}

/// What holds for every run of either method.
pub(super) fn check_kept(mesh: &QuadMesh, pin: Pin, outcome: &Outcome) {
    assert_eq!(outcome.inverted, 0);
    assert_eq!(outcome.mesh.quads, mesh.quads);
    assert!(outcome.mesh.vertices.iter().all(|vertex| vertex.is_finite()));
    assert_eq!(outcome.history.len(), outcome.iterations as usize + 1);
    assert!(outcome.best_iteration <= outcome.iterations);
    if let Some(before) = outcome.before.worst {
        let after = outcome.after.worst.unwrap();
        assert!(after.value >= before.value, "worst {} became {}", before.value, after.value);
    }
    let pinned = match pin {
        Pin::Boundary => mesh.boundary_vertices().unwrap(),
        Pin::Corners => mesh.corners(),
        Pin::None => Vec::new(),
    };
    for vertex in pinned {
        assert_eq!(outcome.mesh.vertices[vertex as usize], mesh.vertices[vertex as usize]);
    }
    for quad in 0..mesh.quads.len() {
        let [before, after] =
            [mesh, &outcome.mesh].map(|mesh| QuadMeasure::of(mesh.corners_of(quad)).verdict);
        match before {
            Verdict::Convex => assert_eq!(after, Verdict::Convex, "quad {quad}"),
            Verdict::Dart => {
                assert!(matches!(after, Verdict::Dart | Verdict::Convex), "quad {quad} {after:?}")
            }
            Verdict::CollinearCorner | Verdict::Degenerate => assert_eq!(before, after, "quad {quad}"),
            Verdict::FoldedOver => {}
        }
    }
    for (vertex, distance) in outcome.moved.distances.iter().enumerate() {
        assert_eq!(*distance, mesh.vertices[vertex].distance(outcome.mesh.vertices[vertex]));
    }
}
