//! Flat, single, pinned, degenerate, inverted, huge and tiny input: never worse, never a panic, never NaN.

use super::*;
use crate::planarize::{MAX_ITERATIONS, StopReason};
use proptest::prelude::*;

#[test]
fn flat_grids_stay_as_they_are() {
    let flat = samples::flat_grid(6, 6, 250.0);
    let outcome = run(&flat, &Perturbation { pin: Pin::None, ..shell_options() });
    assert_eq!((outcome.stop, outcome.mesh), (StopReason::NothingSelected, flat.clone()));
    let outcome =
        run(&flat, &Perturbation { pin: Pin::None, select: 1.0, threshold: 1.0, ..shell_options() });
    assert_eq!(outcome.mesh, flat);
}

#[test]
fn nothing_at_all() {
    let outcome = run(&QuadMesh::try_new(Vec::new(), Vec::new()).unwrap(), &shell_options());
    assert_eq!((outcome.stop, outcome.iterations), (StopReason::NothingSelected, 0));
    assert_eq!((outcome.moved.max, outcome.moved.mean), (0.0, 0.0));
}

fn single(height: f64) -> QuadMesh {
    let mut mesh = samples::flat_grid(2, 2, 250.0);
    mesh.vertices[3].z = height;
    mesh
}

#[test]
fn a_single_quad() {
    let free = Perturbation { pin: Pin::None, threshold: 0.999_999, ..shell_options() };
    let outcome = run(&single(100.0), &free);
    check_promises(&single(100.0), &free, &outcome);
    assert_eq!(outcome.stop, StopReason::Reached);
    assert!(outcome.moved.max < 100.0, "{}", outcome.moved.max);
}

#[test]
fn everything_pinned() {
    for pin in [Pin::Boundary, Pin::Corners] {
        let outcome = run(&single(100.0), &Perturbation { pin, ..shell_options() });
        assert_eq!((outcome.stop, outcome.iterations), (StopReason::OnlyPinnedLeft, 0));
        assert_eq!(outcome.mesh, single(100.0));
    }
}

#[test]
fn degenerate_and_collinear_quads_are_left_alone() {
    let mut mesh = shell(7, 2, dome(800.0));
    let corners = mesh.quads[100];
    mesh.vertices[corners[1] as usize] = mesh.vertices[corners[0] as usize];
    let corners = mesh.quads[40];
    mesh.vertices[corners[1] as usize] =
        (mesh.vertices[corners[0] as usize] + mesh.vertices[corners[2] as usize]) / 2.0;
    let outcome = run(&mesh, &shell_options());
    check_promises(&mesh, &shell_options(), &outcome);
    // Each of the two spoils the quad beside it as well.
    assert_eq!((outcome.before.degenerate, outcome.before.collinear), (2, 1));
    assert!(outcome.after.worst.unwrap().value > outcome.before.worst.unwrap().value);
}

#[test]
fn a_mesh_of_one_point() {
    let mesh = samples::mesh(5, 5, |_, _| DVec3::ONE);
    let outcome = run(&mesh, &Perturbation { pin: Pin::None, ..shell_options() });
    assert_eq!((outcome.stop, outcome.mesh), (StopReason::NothingSelected, mesh));
}

#[test]
fn a_folded_quad_is_no_obstacle() {
    let mut mesh = samples::flat_grid(6, 6, 250.0);
    mesh.vertices[14] += DVec3::new(400.0, 30.0, 150.0);
    let options = Perturbation { pin: Pin::None, ..shell_options() };
    let outcome = run(&mesh, &options);
    check_promises(&mesh, &options, &outcome);
    assert!(outcome.before.not_convex() > 0);
    assert!(outcome.after.not_convex() <= outcome.before.not_convex());
}

/// A grid with each vertex shifted by up to `reach` edge lengths.
pub(in crate::planarize) fn shaken() -> impl Strategy<Value = QuadMesh> {
    let size = (2usize..6, 2usize..6);
    (size, 0.0f64..1.2, 0u32..3, -1i32..1).prop_flat_map(|((rows, columns), reach, snapped, exponent)| {
        let shifts = proptest::collection::vec(proptest::array::uniform3(-1.0f64..1.0), rows * columns);
        shifts.prop_map(move |shifts| {
            let scale = libm::pow(10.0, f64::from(exponent) * 30.0);
            samples::mesh(rows, columns, |i, j| {
                let shift = DVec3::from(shifts[i as usize * columns + j as usize]) * reach;
                let place = DVec3::new(i, j, 0.0) + shift;
                // On a coarse lattice corners coincide and lie on lines.
                let place = if snapped == 0 { (place * 2.0).round() / 2.0 } else { place };
                place * 250.0 * scale
            })
        })
    })
}

fn any_options() -> impl Strategy<Value = Perturbation> {
    let weights = (0.0f64..3.0, 0.001f64..3.0);
    let levels = (prop_oneof![Just(1.0), Just(0.9999), -1.0f64..1.0], prop_oneof![Just(1.0), 0.9f64..1.0]);
    let length = || prop_oneof![Just(1e-300), Just(1e300), 1e-6f64..100.0];
    let pin = prop_oneof![Just(Pin::Boundary), Just(Pin::Corners), Just(Pin::None)];
    (weights, levels, length(), length(), 0u32..40, pin).prop_map(
        |((worst, average), (select, threshold), step, move_length, iterations, pin)| {
            let given =
                Perturbation { worst, average, select, threshold, step, move_length, iterations, pin };
            Perturbation::try_new(given).unwrap()
        },
    )
}

proptest! {
    #[test]
    fn never_worse_whatever_is_given(mesh in shaken(), options in any_options()) {
        let outcome = run(&mesh, &options);
        check_promises(&mesh, &options, &outcome);
        prop_assert!(outcome.moved.mean.is_finite() && outcome.moved.max.is_finite());
        for record in &outcome.history {
            prop_assert!([record.worst, record.mean].into_iter().flatten().all(f64::is_finite));
        }
    }

    #[test]
    fn it_ends_by_itself(mesh in shaken()) {
        let options = Perturbation { iterations: MAX_ITERATIONS, threshold: 1.0, pin: Pin::Corners, ..shell_options() };
        let mut asked = 0u32;
        let outcome = perturb(&mesh, &options, &mut |_| {
            asked += 1;
            if asked < 3000 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        });
        check_promises(&mesh, &options, &outcome);
    }
}
