//! Evaluating 262,144 separate pieces on one thread: blocks of leaves against plain recursion, in millions of leaves
//! a second.

use std::convert::Infallible;

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use ifs_benches::pieces::{PlainRecursion, fern, pair, plan};
use ifs_compiler::ifs::Automaton;
use ifs_compiler::plan::PiecesPlan;
use ifs_compiler::plan::evaluate::PiecesEvaluator;

fn main() {
    divan::main();
}

const LEAVES: usize = 1 << 18;

fn design(name: &str) -> (Automaton, PiecesPlan, u32) {
    let ((automaton, points), level) = if name == "fern" { (fern(), 9) } else { (pair(), 18) };
    (automaton, plan(&points, level), level)
}

#[divan::bench(args = ["fern", "pair"])]
fn blocks_of_leaves(bencher: Bencher<'_, '_>, name: &str) {
    let (automaton, plan, _) = design(name);
    bencher.counter(ItemsCount::new(LEAVES)).bench_local(|| {
        let mut leaves = 0;
        let Ok(()) = PiecesEvaluator::new(&automaton, black_box(&plan)).stream(|tile| {
            leaves += black_box(tile).elements().len();
            Ok::<(), Infallible>(())
        });
        assert_eq!(leaves, LEAVES);
    });
}

#[divan::bench(args = ["fern", "pair"])]
fn plain_recursion(bencher: Bencher<'_, '_>, name: &str) {
    let (automaton, plan, level) = design(name);
    let reference = PlainRecursion::new(&automaton);
    bencher.counter(ItemsCount::new(LEAVES)).bench_local(|| {
        let mut leaves = 0;
        reference.run(black_box(&plan.points), level, &mut |ends| {
            black_box(&ends);
            leaves += 1;
        });
        assert_eq!(leaves, LEAVES);
    });
}

/// Both give the same leaves, and here it is checked: what is measured is the same work. The recursion works in plain
/// weights, which on a frame of 1 mm cost it five digits.
#[divan::bench(sample_count = 1, sample_size = 1)]
fn agreement() {
    for name in ["fern", "pair"] {
        let (automaton, plan, level) = design(name);
        let mut expected = Vec::new();
        PlainRecursion::new(&automaton).run(&plan.points, level, &mut |ends| expected.extend(ends));
        let mut place = 0;
        let Ok(()) = PiecesEvaluator::new(&automaton, &plan).stream(|tile| {
            for vertex in 0..tile.vertices() {
                let (found, expected) = (tile.point(vertex), expected[place]);
                let near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-3);
                assert!(near, "{name}: {found:?} {expected:?}");
                place += 1;
            }
            Ok::<(), Infallible>(())
        });
        assert_eq!(place, 2 * LEAVES);
    }
}
