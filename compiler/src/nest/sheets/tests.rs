//! Packing: whatever comes in lies well or is listed, and the same comes out each time.

use proptest::prelude::*;

use super::*;
use crate::nest::check::faults;

const SHEET: Sheet = Sheet { length: 2500.0, width: 1250.0, margin: 10.0, gap: 8.0 };

fn rectangle(length: f64, width: f64) -> Part {
    let corners = [(0.0, 0.0), (length, 0.0), (length, width), (0.0, width)];
    Part { outline: corners.map(|(x, y)| DVec2::new(x, y)).to_vec(), any_quarter: false }
}

/// Any simple quad, convex or not, around the origin, now and then too large or a sliver.
fn quad() -> impl Strategy<Value = Part> {
    let reach = prop_oneof![4 => 0.2f64..1.0, 1 => 0.02f64..0.2];
    let size = prop_oneof![8 => 60.0f64..400.0, 1 => 400.0f64..1600.0];
    ((reach.clone(), reach.clone(), reach.clone(), reach), size, 0.0f64..6.2, any::<bool>()).prop_map(
        |((a, b, c, d), size, turn, any_quarter)| {
            let corners = [a, b, c, d].into_iter().enumerate().map(|(index, reach)| {
                let angle = turn + index as f64 * std::f64::consts::FRAC_PI_2;
                DVec2::new(libm::cos(angle), libm::sin(angle)) * (size * reach)
            });
            Part { outline: corners.collect(), any_quarter }
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn all_parts_lie_well_or_are_listed(
        parts in proptest::collection::vec(quad(), 1..60),
        gap in 0.0f64..30.0,
        margin in 0.0f64..60.0,
    ) {
        let sheet = Sheet { gap, margin, ..SHEET };
        let nested = nest(&parts, &sheet);
        prop_assert_eq!(faults(&parts, &sheet, &nested), []);
        prop_assert_eq!(&nest(&parts, &sheet), &nested);
        let placed = nested.placements.iter().map(|placement| &parts[placement.part]);
        prop_assert!(least_sheets(placed, &sheet) <= nested.sheets);
        for unplaced in &nested.unplaced {
            let Reason::TooLarge { size, room } = unplaced.reason else { panic!("they all have an area") };
            prop_assert!(!size.cmple(room).all());
        }
    }
}

#[test]
fn rectangles_fill_a_sheet_to_the_last_one() {
    // 2480 by 1230 between the margins: 8 by 5 of 303 by 239.6 with gaps of 8.
    let parts = vec![rectangle(303.0, 239.5); 40];
    let nested = nest(&parts, &SHEET);
    assert_eq!((nested.sheets, nested.placements.len()), (1, 40));
    let parts = vec![rectangle(303.0, 239.5); 41];
    assert_eq!(nest(&parts, &SHEET).sheets, 2);
}

#[test]
fn trapezoids_lie_head_to_tail() {
    // Side by side as they come they take 400 each, turned in turn 300.
    let outline = [(0.0, 0.0), (390.0, 0.0), (290.0, 1200.0), (100.0, 1200.0)];
    let part = Part { outline: outline.map(|(x, y)| DVec2::new(x, y)).to_vec(), any_quarter: false };
    let nested = nest(&vec![part; 7], &SHEET);
    assert_eq!(nested.sheets, 1);
    assert!(nested.placements.iter().any(|placement| placement.quarter_turns == 2));
}

#[test]
fn the_grain_keeps_boards_from_being_turned() {
    let long = rectangle(1000.0, 2000.0);
    let room = SHEET.room();
    let nested = nest(std::slice::from_ref(&long), &SHEET);
    let reason = Reason::TooLarge { size: DVec2::new(1000.0, 2000.0), room };
    assert_eq!(nested.unplaced, [Unplaced { part: 0, reason }]);
    assert_eq!(
        reason.to_string(),
        "it measures 1000.0mm by 2000.0mm, and between the margins there are 2480.0mm by 1230.0mm"
    );
    let free = Part { any_quarter: true, ..long };
    assert_eq!(nest(&[free], &SHEET).placements[0].quarter_turns % 2, 1);
}

#[test]
fn nothing_comes_of_nothing() {
    assert_eq!(nest(&[], &SHEET), Nested::default());
    let flat = Part { outline: vec![DVec2::ZERO, DVec2::X, DVec2::X * 2.0], any_quarter: true };
    let wild = Part { outline: vec![DVec2::ZERO, DVec2::X, DVec2::NAN], any_quarter: true };
    let nested = nest(&[flat, wild], &SHEET);
    assert!(nested.unplaced.iter().all(|unplaced| unplaced.reason == Reason::NoArea));
    assert_eq!((nested.sheets, nested.unplaced.len()), (0, 2));
}

#[test]
fn a_bound_of_the_area_counts_the_gaps() {
    // A square of 92 takes 92² = 8464 and with its gap 92² + 4·92·4 + 16π = 9986; a sheet has 2488 by 1238.
    let parts = vec![rectangle(92.0, 92.0); 330];
    assert!(330.0 * 8464.0 < 2480.0 * 1230.0);
    assert_eq!(least_sheets(&parts, &SHEET), 2);
    assert_eq!(least_sheets(&parts[..308], &SHEET), 1);
}
