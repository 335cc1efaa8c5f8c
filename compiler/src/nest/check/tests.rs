//! Every kind of fault is found, and what is just right is none.

use super::*;
use crate::nest::sheets::Unplaced;

const SHEET: Sheet = Sheet { length: 1000.0, width: 500.0, margin: 10.0, gap: 8.0 };

fn square(side: f64) -> Part {
    let corners = [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)];
    Part { outline: corners.map(|(x, y)| DVec2::new(x, y)).to_vec(), any_quarter: false }
}

fn at(part: usize, x: f64, y: f64) -> Placement {
    Placement { part, sheet: 0, quarter_turns: 0, at: DVec2::new(x, y) }
}

fn nested(placements: Vec<Placement>) -> Nested {
    Nested { sheets: 1, placements, unplaced: Vec::new() }
}

#[test]
fn just_a_gap_and_a_margin_are_enough() {
    let parts = [square(100.0), square(100.0)];
    assert!(faults(&parts, &SHEET, &nested(vec![at(0, 10.0, 10.0), at(1, 118.0, 10.0)])).is_empty());
    let near = faults(&parts, &SHEET, &nested(vec![at(0, 10.0, 10.0), at(1, 117.9, 10.0)]));
    assert!(matches!(near[..], [Fault::TooNear { parts: [0, 1], .. }]), "{near:?}");
    let out = faults(&parts, &SHEET, &nested(vec![at(0, 9.9, 10.0), at(1, 890.1, 200.0)]));
    assert!(matches!(out[..], [Fault::OutsideMargin { part: 0, .. }, Fault::OutsideMargin { part: 1, .. }]));
}

#[test]
fn one_inside_the_other_and_a_cross_overlap() {
    let parts = [square(300.0), square(50.0)];
    let inside = faults(&parts, &SHEET, &nested(vec![at(0, 10.0, 10.0), at(1, 100.0, 100.0)]));
    assert_eq!(inside, [Fault::TooNear { parts: [0, 1], distance: 0.0 }]);
    let bar = |length: f64, width: f64| {
        let corners = [(0.0, 0.0), (length, 0.0), (length, width), (0.0, width)];
        Part { outline: corners.map(|(x, y)| DVec2::new(x, y)).to_vec(), any_quarter: false }
    };
    let cross = [bar(300.0, 20.0), bar(20.0, 300.0)];
    let found = faults(&cross, &SHEET, &nested(vec![at(0, 10.0, 150.0), at(1, 150.0, 10.0)]));
    assert_eq!(found, [Fault::TooNear { parts: [0, 1], distance: 0.0 }]);
}

#[test]
fn lost_doubled_and_turned_parts() {
    let parts = [square(100.0), square(100.0)];
    let lost = faults(&parts, &SHEET, &nested(vec![at(0, 10.0, 10.0)]));
    assert_eq!(lost, [Fault::NotOnce { part: 1, times: 0 }]);
    let mut both = nested(vec![at(0, 10.0, 10.0), at(1, 200.0, 10.0)]);
    both.unplaced.push(Unplaced { part: 1, reason: crate::nest::sheets::Reason::NoArea });
    assert_eq!(faults(&parts, &SHEET, &both), [Fault::NotOnce { part: 1, times: 2 }]);
    let turned = Placement { quarter_turns: 1, at: DVec2::new(300.0, 10.0), ..at(1, 0.0, 0.0) };
    let found = faults(&parts, &SHEET, &nested(vec![at(0, 10.0, 10.0), turned]));
    assert_eq!(found, [Fault::NotAllowed { part: 1 }]);
    let elsewhere = Placement { sheet: 3, ..at(1, 300.0, 10.0) };
    let found = faults(&parts, &SHEET, &nested(vec![at(0, 10.0, 10.0), elsewhere]));
    assert_eq!(found, [Fault::NotAllowed { part: 1 }]);
}
