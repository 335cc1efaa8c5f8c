//! Basis tables, curves and sheets against formulas and against plain sums.

use proptest::prelude::*;

use super::*;
use crate::plan::evaluate::{Basis, SheetEvaluator, basis, curve_points};

fn near(a: &[f64], b: &[f64], tolerance: f64) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance)
}

/// Bernstein's polynomials at t = i / 2^level.
fn bernstein(i: usize, level: u32) -> [f64; 4] {
    let t = i as f64 / f64::from(1_u32 << level);
    let s = 1.0 - t;
    [s * s * s, 3.0 * t * s * s, 3.0 * t * t * s, t * t * t]
}

/// The uniform cubic B-spline's weights at t = i / 2^level.
fn uniform(i: usize, level: u32) -> [f64; 4] {
    let t = i as f64 / f64::from(1_u32 << level);
    let s = 1.0 - t;
    let middle = |t: f64| (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0;
    [s * s * s / 6.0, middle(t), middle(s), t * t * t / 6.0]
}

#[test]
fn halved_bezier_tables_are_bernstein_polynomials() {
    let table = basis(&bezier(3, &r(1, 2)), FIRST, 6);
    assert_eq!((table.rows, table.columns), (65, 4));
    assert!((0..65).all(|i| near(table.row(i), &bernstein(i, 6), 1e-15)));
    assert_eq!(table.row(0), [1.0, 0.0, 0.0, 0.0]);
    assert_eq!(table.row(64), [0.0, 0.0, 0.0, 1.0]);
    assert_eq!(table.row(32), [0.125, 0.375, 0.375, 0.125]);
}

#[test]
fn bspline_tables_are_the_uniform_basis() {
    let table = basis(&bspline3_limit(), FIRST, 7);
    assert_eq!(table.rows, 129);
    assert!((0..129).all(|i| near(table.row(i), &uniform(i, 7), 1e-15)));
}

#[test]
fn states_may_differ_in_points() {
    // A cubic and a quadratic that draw the same parabola halve each other: both are Bernstein tables.
    let table = basis(&alternating(), StateId(1), 5);
    assert_eq!((table.rows, table.columns), (33, 3));
    for i in 0..33 {
        let t = i as f64 / 32.0;
        let parabola = [(1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t];
        assert!(near(table.row(i), &parabola, 1e-15), "{i}");
    }
}

#[test]
fn curve_points_are_on_the_curve() {
    let points = curve_points(&basis(&bezier(3, &r(1, 2)), FIRST, 4), &ARC);
    assert_eq!(points.len(), 17);
    assert_eq!((points[0], points[16]), (ARC[0], ARC[3]));
    assert_eq!(points[8], [2000.0, 1500.0, 0.0]);
    let level_zero = curve_points(&basis(&bezier(3, &r(1, 2)), FIRST, 0), &ARC);
    assert_eq!(level_zero, [ARC[0], ARC[3]]);
}

/// The definition, vertex by vertex: Σ_ij A[r][i]·B[c][j]·C[i][j] over the vertex' window.
fn by_definition(sheet: &SheetPlan, u: &Basis, v: &Basis) -> Vec<[f64; 3]> {
    let windows = (sheet.net_rows - u.columns + 1, sheet.net_columns - v.columns + 1);
    let place = |index: usize, basis: &Basis, windows: usize| {
        let window = (index / (basis.rows - 1)).min(windows - 1);
        (window, index - window * (basis.rows - 1))
    };
    let mut grid = Vec::new();
    for row in 0..windows.0 * (u.rows - 1) + 1 {
        for column in 0..windows.1 * (v.rows - 1) + 1 {
            let ((wr, r), (wc, c)) = (place(row, u, windows.0), place(column, v, windows.1));
            let mut sum = [0.0; 3];
            for i in 0..u.columns {
                for j in 0..v.columns {
                    let point = sheet.net[(wr + i) * sheet.net_columns + wc + j];
                    for d in 0..3 {
                        sum[d] += u.row(r)[i] * v.row(c)[j] * point[d];
                    }
                }
            }
            grid.push(sum);
        }
    }
    grid
}

fn agrees(automaton: &Automaton, sheet: &SheetPlan) {
    let evaluator = SheetEvaluator::new(automaton, sheet);
    let expected = by_definition(
        sheet,
        &basis(automaton, sheet.u, sheet.levels.0),
        &basis(automaton, sheet.v, sheet.levels.1),
    );
    let mut grid = Vec::new();
    evaluator.fill(&mut grid);
    assert_eq!(grid.len(), evaluator.rows() * evaluator.columns());
    assert!(near(grid.as_flattened(), expected.as_flattened(), 1e-9));
    for tile_rows in [1, 5, 1000] {
        let mut streamed = Vec::new();
        let end = evaluator.stream(tile_rows, |first, tile| {
            assert_eq!(first * evaluator.columns(), streamed.len());
            streamed.extend_from_slice(tile);
            Ok::<(), ()>(())
        });
        assert_eq!((end, &streamed), (Ok(()), &grid), "the same bits in tiles of {tile_rows} rows");
    }
}

#[test]
fn sheets_agree_with_their_definition() {
    for levels in [(0, 0), (2, 2), (4, 1), (0, 3)] {
        agrees(&bezier(3, &r(23, 50)), &sheet(4, 4, levels, false));
        agrees(&bspline3_limit(), &sheet(4, 4, levels, true));
        agrees(&bspline3_limit(), &sheet(7, 5, levels, true));
        agrees(&four_point(&r(1, 16)), &sheet(7, 8, levels, true));
        agrees(&chaikin(weights(2, &[1, 1, 0]), weights(2, &[0, 1, 1])), &sheet(3, 6, levels, true));
    }
    // Wider than a tile of columns, taller than a tile of rows.
    agrees(&bspline3_limit(), &sheet(9, 9, (3, 8), true));
    let mut mixed = sheet(4, 3, (3, 4), false);
    mixed.v = StateId(1);
    agrees(&alternating(), &mixed);
}

#[test]
fn a_used_buffer_keeps_its_memory_and_nothing_of_its_past() {
    let (automaton, first) = (bspline3_limit(), sheet(7, 7, (2, 2), true));
    let mut second = first.clone();
    second.net.iter_mut().for_each(|point| point[2] += 1.0);
    let mut grid = Vec::new();
    SheetEvaluator::new(&automaton, &first).fill(&mut grid);
    let memory = grid.as_ptr();
    SheetEvaluator::new(&automaton, &second).fill(&mut grid);
    assert_eq!(grid.as_ptr(), memory);
    let mut fresh = Vec::new();
    SheetEvaluator::new(&automaton, &second).fill(&mut fresh);
    assert_eq!(grid, fresh);
}

#[test]
fn an_error_of_the_writer_ends_the_stream() {
    let (automaton, sheet) = (bspline3_limit(), sheet(7, 7, (2, 2), true));
    let mut tiles = 0;
    let end = SheetEvaluator::new(&automaton, &sheet).stream(4, |first, _| {
        tiles += 1;
        if first == 8 { Err("full") } else { Ok(()) }
    });
    assert_eq!((end, tiles), (Err("full"), 3));
}

proptest! {
    #[test]
    fn rows_sum_to_one(degree in 1_usize..6, split in 1_i64..100, level in 0_u32..9) {
        for automaton in [bezier(degree, &r(split, 100)), bspline3_limit(), four_point(&r(1, 16))] {
            let table = basis(&automaton, FIRST, level);
            for i in 0..table.rows {
                prop_assert!((table.row(i).iter().sum::<f64>() - 1.0).abs() <= 1e-14);
            }
        }
    }

    /// Every vertex is the exact product of its word, rounded: doubles lose at most 1e-15 a level.
    #[test]
    fn vertices_are_their_exact_words(split in 1_i64..100, level in 1_u32..7, place in 0_u32..64) {
        let automaton = bezier(3, &r(split, 100));
        let element = u64::from(place % (1 << level));
        let word = crate::plan::address::ChainWords::new(&automaton, FIRST, level).word(element).unwrap();
        let transforms = &automaton.states()[0].transforms;
        let product = word.letters.iter().fold(crate::ifs::Matrix::identity(4), |product, letter| {
            transforms[*letter].matrix.product(&product).unwrap()
        });
        let table = basis(&automaton, FIRST, level);
        let exact = product.to_f64();
        prop_assert!(near(table.row(element as usize), &exact[..4], 1e-14));
        prop_assert!(near(table.row(element as usize + 1), &exact[12..], 1e-14));
    }
}
