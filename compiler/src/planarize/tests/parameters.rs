//! Each parameter does what it says.

use super::*;
use crate::planarize::{Progress, StopReason};

fn mesh() -> QuadMesh {
    shell(7, 2, dome(800.0))
}

#[test]
fn the_first_step_is_as_long_as_move() {
    let first =
        |move_length: f64| run(&mesh(), &Perturbation { move_length, iterations: 1, ..shell_options() });
    // One that goes too far for the objective is halved.
    let halved = 30.0 / first(30.0).moved.max;
    assert!(halved > 1.5 && (libm::log2(halved) - libm::log2(halved).round()).abs() < 1e-9);
    for move_length in [0.01, 0.5, 1.0] {
        let outcome = first(move_length);
        assert_eq!((outcome.iterations, outcome.stop), (1, StopReason::IterationsUsed));
        assert!((outcome.moved.max - move_length).abs() < 1e-9, "{} {move_length}", outcome.moved.max);
    }
}

#[test]
fn step_is_the_step_of_the_differences() {
    let at = |step: f64| run(&mesh(), &Perturbation { step, iterations: 1, ..shell_options() });
    let difference = |step: f64| {
        let (fine, coarse) = (at(1e-3), at(step));
        let pairs = fine.mesh.vertices.iter().zip(&coarse.mesh.vertices);
        pairs.map(|(fine, coarse)| fine.distance(*coarse)).fold(0.0, f64::max)
    };
    // Central differences: ten times the step, a hundred times the error.
    let (small, large) = (difference(0.5), difference(5.0));
    assert!(small > 0.0 && (50.0..200.0).contains(&(large / small)), "{small} {large}");
    let coarse = run(&mesh(), &Perturbation { step: 60.0, ..shell_options() });
    check_promises(&mesh(), &shell_options(), &coarse);
}

#[test]
fn select_picks_what_is_worked_on() {
    let moved =
        |select: f64| run(&mesh(), &Perturbation { select, iterations: 3, ..shell_options() }).moved.count;
    let (few, many, all) = (moved(0.9991), moved(0.9995), moved(1.0));
    assert!(0 < few && few < many && many < all, "{few} {many} {all}");
    assert_eq!(all, 15 * 15);
    let none = run(&mesh(), &Perturbation { select: 0.99, ..shell_options() });
    assert_eq!((none.stop, none.iterations, none.moved.count), (StopReason::NothingSelected, 0, 0));
    assert_eq!(none.mesh, mesh());
}

#[test]
fn selected_quads_alone_decide_when_it_ends() {
    let options = Perturbation { select: 0.999, threshold: 0.9993, ..shell_options() };
    let outcome = run(&mesh(), &options);
    check_promises(&mesh(), &options, &outcome);
    assert_eq!(outcome.stop, StopReason::Reached);
    assert!(worst(&outcome) >= 0.999);
}

#[test]
fn weights_say_which_of_worst_and_mean_matters() {
    let after = |worst: f64, average: f64| {
        let options = Perturbation { worst, average, threshold: 1.0, iterations: 30, ..shell_options() };
        let outcome = run(&mesh(), &options);
        check_promises(&mesh(), &options, &outcome);
        outcome.after
    };
    let (for_worst, for_mean) = (after(1.0, 0.0), after(0.0, 1.0));
    assert!(for_worst.worst.unwrap().value > for_mean.worst.unwrap().value);
    assert!(for_mean.mean > for_worst.mean);
    let (little, much) = (after(1.0, 0.1), after(1.0, 100.0));
    assert!(much.mean > little.mean);
}

#[test]
fn threshold_ends_the_search() {
    let used = |threshold: f64| {
        let outcome = run(&mesh(), &Perturbation { threshold, select: 1.0, ..shell_options() });
        assert_eq!(outcome.stop, StopReason::Reached);
        assert!(worst(&outcome) >= threshold);
        outcome.iterations
    };
    let (early, late) = (used(0.9993), used(0.99999));
    assert!(early < late, "{early} {late}");
}

#[test]
fn iterations_are_the_budget() {
    let none = run(&mesh(), &Perturbation { iterations: 0, ..shell_options() });
    assert_eq!((none.stop, none.mesh), (StopReason::IterationsUsed, mesh()));
    let ten = run(&mesh(), &Perturbation { iterations: 10, ..shell_options() });
    assert_eq!((ten.iterations, ten.history.len(), ten.stop), (10, 11, StopReason::IterationsUsed));
    assert!(worst(&ten) > ten.before.worst.unwrap().value);
}

#[test]
fn progress_is_told_and_can_stop() {
    let mut told: Vec<Progress> = Vec::new();
    let outcome = perturb(&mesh(), &shell_options(), &mut |progress| {
        told.push(progress);
        if progress.iteration == 5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    assert_eq!((outcome.stop, outcome.iterations), (StopReason::Cancelled, 5));
    assert_eq!(told.iter().map(|progress| progress.iteration).collect::<Vec<_>>(), vec![0, 1, 2, 3, 4, 5]);
    for (progress, record) in told.iter().zip(&outcome.history) {
        assert_eq!((progress.worst, progress.mean, progress.iterations), (record.worst, record.mean, 400));
    }
    check_promises(&mesh(), &shell_options(), &outcome);
}

#[test]
fn the_same_input_gives_the_same_bits() {
    let bits = |outcome: &Outcome| -> Vec<u64> {
        outcome.mesh.vertices.iter().flat_map(|vertex| vertex.to_array().map(f64::to_bits)).collect()
    };
    assert_eq!(bits(&run(&mesh(), &shell_options())), bits(&run(&mesh(), &shell_options())));
}
