//! What is no plan, and what is too much of one.

use super::*;
use crate::ifs::{Joins, OpenJoin};
use crate::plan::PlanError;
use crate::plan::budget::{BudgetError, FigureCount, MAX_LEVEL, check};

fn refused(automaton: Automaton, shape: Shape) -> PlanError {
    Plan::try_new(automaton, vec![figure("f", Some(3), shape)]).unwrap_err()
}

#[test]
fn wrong_plans_are_refused() {
    let curve =
        |state, points: Vec<[f64; 3]>| Shape::Curve { state, points, level: 1, dimension: Dimension::Space };
    let bezier = || bezier(3, &r(1, 2));
    let name = "f[3]".to_owned();
    assert_eq!(
        refused(bezier(), curve(FIRST, ARC[..3].to_vec())),
        PlanError::PointCount { figure: name.clone(), expected: 4, found: 3 }
    );
    assert_eq!(
        refused(bezier(), curve(StateId(1), ARC.to_vec())),
        PlanError::UnknownState { figure: name.clone(), state: StateId(1) }
    );
    let mut infinite = ARC;
    infinite[2][1] = f64::INFINITY;
    assert_eq!(
        refused(bezier(), curve(FIRST, infinite.to_vec())),
        PlanError::NotFinite { figure: name.clone(), point: 2 }
    );
    let tensor = refused(bezier(), Shape::Sheet(sheet(5, 4, (1, 1), false)));
    assert_eq!(tensor, PlanError::NetSize { figure: name.clone(), window: (4, 4), net: (5, 4), points: 20 });
    let small = refused(bspline3_limit(), Shape::Sheet(sheet(3, 9, (1, 1), true)));
    assert!(matches!(small, PlanError::NetSize { net: (3, 9), .. }));
    let mut short = sheet(4, 4, (1, 1), true);
    short.net.pop();
    assert!(matches!(refused(bspline3_limit(), Shape::Sheet(short)), PlanError::NetSize { points: 15, .. }));
}

#[test]
fn pieces_and_windows_must_be_proved_to_meet() {
    let parting = refused(bezier(3, &r(1, 2)), Shape::Sheet(sheet(5, 5, (1, 1), true)));
    assert!(matches!(
        parting,
        PlanError::NotJoined { windows: true, joins: Joins::Open(OpenJoin { level: 0, .. }), .. }
    ));
    let apart = automaton(curve("apart", bspline_matrices(3), unit(4, 0), unit(4, 3)));
    let parting = refused(apart, arc(2));
    assert!(matches!(parting, PlanError::NotJoined { windows: false, joins: Joins::Open(_), .. }));
    // One window needs no neighbour.
    plan(bezier(3, &r(1, 2)), vec![figure("one", None, Shape::Sheet(sheet(4, 4, (1, 1), true)))]);
}

#[test]
fn counts_are_known_beforehand() {
    let shell = figure("shell", None, Shape::Sheet(sheet(7, 7, (2, 2), true)));
    let shell = plan(bspline3_limit(), vec![shell, figure("arc", None, arc(4))]);
    let expected = [
        FigureCount { elements: 256, vertices: 289, grid: (16, 16) },
        FigureCount { elements: 16, vertices: 17, grid: (16, 1) },
    ];
    assert_eq!(check(&shell, 272).unwrap(), expected);
    assert_eq!(
        check(&shell, 271),
        Err(BudgetError::TooMany { figure: "arc".into(), elements: Some(272), limit: 271, fits: Some(3) })
    );
}

#[test]
fn too_much_is_refused_with_what_fits() {
    let at = |level| {
        plan(
            bezier(3, &r(1, 2)),
            vec![figure("arc", Some(0), arc(level)), figure("arc", Some(1), arc(level))],
        )
    };
    let limit = 1_000_000;
    assert_eq!(check(&at(18), limit).unwrap()[1].elements, 1 << 18);
    let error = check(&at(40), limit).unwrap_err();
    assert_eq!(
        error.to_string(),
        "2199023255552 elements with `arc[0]`; the limit is 1000000, and the largest level that fits is 18"
    );
    let error = check(&at(1_000_000_000), limit).unwrap_err();
    assert_eq!(
        error,
        BudgetError::TooMany { figure: "arc[0]".into(), elements: None, limit, fits: Some(18) }
    );
    assert!(matches!(check(&at(3), 1), Err(BudgetError::TooMany { fits: None, .. })));
    let wide = plan(bspline3_limit(), vec![figure("shell", None, Shape::Sheet(sheet(4, 4, (40, 40), true)))]);
    assert!(matches!(check(&wide, limit), Err(BudgetError::TooMany { elements: None, fits: Some(9), .. })));
}

#[test]
fn a_level_too_deep_is_refused_even_for_one_element() {
    let still =
        automaton(curve("still", vec![bezier_matrices(3, &r(1, 2))[0].clone()], unit(4, 0), unit(4, 3)));
    let at = |level| plan(still.clone(), vec![figure("still", None, arc(level))]);
    assert!(check(&at(MAX_LEVEL), 10).is_ok());
    let deep = BudgetError::TooDeep { figure: "still".into(), level: u32::MAX };
    assert_eq!(check(&at(u32::MAX), 10), Err(deep));
}
