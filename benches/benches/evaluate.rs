//! Evaluating bicubic shells to grids of 1025 × 1025 vertices on one thread, against `benches/peers.py` on the same task.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use ifs_benches::{bezier3, bspline3, net};
use ifs_compiler::ifs::{Automaton, StateId};
use ifs_compiler::plan::SheetPlan;
use ifs_compiler::plan::evaluate::{SheetEvaluator, TILE_ROWS};

fn main() {
    divan::main();
}

const VERTICES: usize = 1025 * 1025;

/// One bicubic Bézier patch, level 10 both ways.
fn patch() -> (Automaton, SheetPlan) {
    let net = net(4, 4);
    let state = StateId(0);
    let sheet =
        SheetPlan { u: state, v: state, net_rows: 4, net_columns: 4, net, levels: (10, 10), windows: false };
    (bezier3(), sheet)
}

/// A B-spline sheet of 16 by 16 windows, level 6 both ways: as many vertices.
fn shell() -> (Automaton, SheetPlan) {
    let net = net(19, 19);
    let state = StateId(0);
    let sheet =
        SheetPlan { u: state, v: state, net_rows: 19, net_columns: 19, net, levels: (6, 6), windows: true };
    (bspline3(), sheet)
}

#[divan::bench(args = ["patch", "shell"])]
fn reused_buffer(bencher: Bencher<'_, '_>, design: &str) {
    let (automaton, sheet) = if design == "patch" { patch() } else { shell() };
    let mut grid = Vec::new();
    bencher.counter(ItemsCount::new(VERTICES)).bench_local(|| {
        SheetEvaluator::new(&automaton, black_box(&sheet)).fill(&mut grid);
        assert_eq!(black_box(&grid).len(), VERTICES);
    });
}

#[divan::bench]
fn fresh_buffer(bencher: Bencher<'_, '_>) {
    let (automaton, sheet) = patch();
    bencher.counter(ItemsCount::new(VERTICES)).bench_local(|| {
        let mut grid = Vec::new();
        SheetEvaluator::new(&automaton, black_box(&sheet)).fill(&mut grid);
        grid
    });
}

#[divan::bench]
fn streamed_tiles(bencher: Bencher<'_, '_>) {
    let (automaton, sheet) = patch();
    bencher.counter(ItemsCount::new(VERTICES)).bench_local(|| {
        let mut vertices = 0;
        let end = SheetEvaluator::new(&automaton, black_box(&sheet)).stream(TILE_ROWS, |_, tile| {
            vertices += black_box(tile).len();
            Ok::<(), ()>(())
        });
        assert_eq!((end, vertices), (Ok(()), VERTICES));
    });
}
