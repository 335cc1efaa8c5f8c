//! What projection promises, on smooth, rough, closed, apart, pinned, flat and odd meshes.

use super::super::tests::{check_kept, dome, odd, shell};
use super::*;
use crate::geometry::{Closed, QuadMesh, samples};
use crate::planarize::{Outcome, Pin, Projection, StopReason};
use glam::DVec3;
use std::ops::ControlFlow;

/// As the reference benchmark: GEOMETRY section 6.
fn wavy(quads: usize) -> QuadMesh {
    samples::mesh(quads + 1, quads + 1, |i, j| {
        let (u, v) = (i / quads as f64, j / quads as f64);
        let pi = std::f64::consts::PI;
        DVec3::new(u, v, 0.1 * libm::sin(3.0 * pi * u + v) * libm::cos(2.4 * pi * v)) * 8000.0
    })
}

/// A product of a Takagi curve, which has a corner at every scale, and a sine: quads twisted at every scale.
fn rough(quads: usize, roughness: f64) -> QuadMesh {
    let takagi = |t: f64| -> f64 {
        let octave = |k: i32| {
            let x = t * f64::from(1 << k);
            libm::pow(roughness, f64::from(k)) * (x - x.round()).abs()
        };
        (0..12).map(octave).sum()
    };
    samples::mesh(quads + 1, quads + 1, |i, j| {
        let (u, v) = (i / quads as f64, j / quads as f64);
        DVec3::new(u, v, 0.15 * takagi(u) * libm::sin(std::f64::consts::PI * v)) * 8000.0
    })
}

fn free(threshold: f64) -> Projection {
    Projection { threshold, pin: Pin::None, ..Projection::default() }
}

fn run(mesh: &QuadMesh, options: &Projection) -> Outcome {
    let outcome = project(mesh, options, &mut |_| ControlFlow::Continue(()));
    check(mesh, options, &outcome);
    outcome
}

fn check(mesh: &QuadMesh, options: &Projection, outcome: &Outcome) {
    check_kept(mesh, options.pin, outcome);
    assert!(outcome.iterations <= options.iterations);
    if outcome.stop == StopReason::Reached {
        assert!(outcome.after.worst.unwrap().value >= options.threshold);
    }
}

fn reaches(name: &str, mesh: &QuadMesh, options: &Projection) -> Outcome {
    let outcome = run(mesh, options);
    assert_eq!(outcome.stop, StopReason::Reached, "{name}: {:?}", outcome.history);
    outcome
}

#[test]
fn the_wavy_square_in_a_few_steps_whatever_its_size() {
    for quads in [16, 32, 64] {
        let options = Projection { diagonal_ratio: Some(0.005), ..free(-1.0) };
        let outcome = reaches("wavy", &wavy(quads), &options);
        assert!(outcome.after.largest_diagonal_ratio.unwrap().value <= 0.005);
        assert!(outcome.iterations <= 6, "{quads}: {}", outcome.iterations);
        assert!(outcome.moved.max < 1500.0, "{quads}: {}", outcome.moved.max);
        assert_eq!(outcome.after.convex, quads * quads);
    }
}

#[test]
fn shells_of_all_heights_and_pins() {
    for amplitude in [500.0, 800.0, 1500.0] {
        for pin in [Pin::Boundary, Pin::Corners, Pin::None] {
            let mesh = shell(7, 2, dome(amplitude));
            let options = Projection { threshold: 0.9998, pin, ..Projection::default() };
            let outcome = reaches(&format!("{amplitude} {pin:?}"), &mesh, &options);
            assert!(outcome.after.shortest_edge.unwrap().value >= 150.0);
        }
    }
}

#[test]
fn rough_surfaces_reach_their_threshold_and_stay_rough() {
    for roughness in [0.5, 0.6, 0.7] {
        let mesh = rough(32, roughness);
        let outcome = reaches("rough", &mesh, &free(0.9998));
        assert!(outcome.before.worst.unwrap().value < 0.995);
        // The corners of the fractal remain: the mean fold between neighbouring quads hardly changes.
        let bend = |mesh: &QuadMesh| -> f64 {
            let normal = |quad: usize| {
                let [a, b, c, d] = mesh.corners_of(quad);
                (c - a).cross(d - b).normalize()
            };
            let next = (0..31 * 32).map(|quad| normal(quad).angle_between(normal(quad + 32)));
            next.sum::<f64>() / (31.0 * 32.0)
        };
        let (before, after) = (bend(&mesh), bend(&outcome.mesh));
        assert!(after > 0.8 * before, "{roughness}: {before} {after}");
    }
}

#[test]
fn a_tube_and_pieces_apart() {
    let tube = samples::grid(24, 9, |i, j| {
        let angle = i / 24.0 * std::f64::consts::TAU;
        let radius = 2000.0 + 150.0 * libm::sin(2.0 * angle + 0.5 * j) + 40.0 * j;
        DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), 500.0 * j)
    });
    let tube = tube.to_mesh(Closed { rows: true, columns: false }).unwrap();
    reaches("tube", &tube, &free(0.9998));

    // Two sheets and a quad of its own.
    let one = shell(7, 1, dome(800.0));
    let mut pieces = one.clone();
    pieces.vertices.extend(one.vertices.iter().map(|vertex| *vertex + DVec3::X * 1e5));
    let count = one.vertices.len() as u32;
    pieces.quads.extend(one.quads.iter().map(|quad| quad.map(|corner| corner + count)));
    let last = 2 * count;
    pieces.vertices.extend(samples::square(400.0).map(|corner| corner - DVec3::Y * 1e4));
    pieces.vertices[last as usize].z = 90.0;
    pieces.quads.push([last, last + 1, last + 2, last + 3]);
    let outcome = reaches("apart", &pieces, &free(0.9998));
    // What is apart does not feel the other: both sheets move alike.
    for vertex in 0..one.vertices.len() {
        let moved = |vertex: usize| outcome.mesh.vertices[vertex] - pieces.vertices[vertex];
        assert!(moved(vertex).distance(moved(vertex + one.vertices.len())) < 1e-3);
    }
}

#[test]
fn nothing_drifts_where_nothing_is_pinned() {
    let mesh = wavy(24);
    let outcome = reaches("free", &mesh, &free(0.9998));
    let centre = |mesh: &QuadMesh| mesh.vertices.iter().copied().sum::<DVec3>() / mesh.vertices.len() as f64;
    assert!(centre(&mesh).distance(centre(&outcome.mesh)) < 1e-6);
}

#[test]
fn where_the_goal_is_out_of_reach_it_gets_closer_and_ends() {
    // Four quads around one vertex, whose rims are held: four conditions on three coordinates.
    let mesh =
        samples::mesh(3, 3, |i, j| DVec3::new(500.0 * i, 500.0 * j, 120.0 * ((3.0 * i + 5.0 * j) % 4.0)));
    let options = Projection { pin: Pin::Boundary, ..Projection::default() };
    let outcome = run(&mesh, &options);
    assert!(matches!(outcome.stop, StopReason::Stalled | StopReason::IterationsUsed), "{:?}", outcome.stop);
    assert!(outcome.after.worst.unwrap().value > outcome.before.worst.unwrap().value);
}

#[test]
fn flat_pinned_and_empty_meshes_stay_as_they_are() {
    let flat = samples::flat_grid(6, 6, 250.0);
    let outcome = run(&flat, &free(1.0));
    assert_eq!((outcome.stop, &outcome.mesh), (StopReason::NothingSelected, &flat));
    let none = QuadMesh::try_new(Vec::new(), Vec::new()).unwrap();
    assert_eq!(run(&none, &free(0.9999)).stop, StopReason::NothingSelected);
    let mut single = samples::flat_grid(2, 2, 250.0);
    single.vertices[3].z = 100.0;
    for pin in [Pin::Boundary, Pin::Corners] {
        let outcome = run(&single, &Projection { pin, ..Projection::default() });
        assert_eq!((outcome.stop, &outcome.mesh), (StopReason::OnlyPinnedLeft, &single));
    }
    assert_eq!(run(&single, &free(0.9999)).stop, StopReason::Reached);
}

#[test]
fn a_folded_quad_stays_and_the_others_become_flat() {
    let mut mesh = shell(7, 1, dome(800.0));
    mesh.vertices[40] += DVec3::new(900.0, 30.0, 150.0);
    let outcome = run(&mesh, &free(0.999));
    assert!(outcome.before.not_convex() > 0);
    assert!(outcome.after.not_convex() <= outcome.before.not_convex());
}

#[test]
fn steps_are_told_and_can_be_stopped() {
    let mut told = Vec::new();
    let outcome = project(&wavy(16), &free(0.9999), &mut |progress| {
        told.push(progress.iteration);
        if progress.iteration == 1 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    check(&wavy(16), &free(0.9999), &outcome);
    assert_eq!((outcome.stop, outcome.iterations, told), (StopReason::Cancelled, 1, vec![0, 1]));
    let used = run(&wavy(16), &Projection { iterations: 1, ..free(0.9999) });
    assert_eq!((used.stop, used.iterations), (StopReason::IterationsUsed, 1));
}

proptest::proptest! {
    #[test]
    fn never_worse_whatever_is_given(mesh in odd::shaken(), threshold in -1.0f64..1.0, tight in proptest::bool::ANY, pin in 0..3, ratio in proptest::option::of(1e-6f64..0.5)) {
        let pin = [Pin::Boundary, Pin::None, Pin::Corners][pin as usize];
        let threshold = if tight { 1.0 - (1.0 - threshold) * 1e-4 } else { threshold };
        let options = Projection { threshold, diagonal_ratio: ratio, iterations: 40, pin };
        let outcome = run(&mesh, &options);
        proptest::prop_assert!(outcome.moved.mean.is_finite() && outcome.moved.max.is_finite());
        let again = run(&mesh, &options);
        proptest::prop_assert!(outcome == again);
    }
}
