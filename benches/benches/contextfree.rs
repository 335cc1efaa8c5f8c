//! The fern of 1,048,576 leaves against Context Free (`cfdg`), as whole processes and as medians of the same run, in
//! millions of shapes a second: `ifs build --emit glb`, which writes every leaf with both ends, against `cfdg` as an
//! image of 500 by 500 pixels and as SVG, both thrown away. Then the leaves alone, worked out in the library and by
//! plain recursion. Both draw the same number of shapes, which is checked. Nothing else is asserted: machines differ.

#![allow(
    clippy::expect_used,
    clippy::disallowed_methods,
    reason = "a race that cannot be run says why and ends; it reads clocks and programs"
)]

use std::convert::Infallible;
use std::hint::black_box;
use std::process::{Command, Stdio};
use std::time::Duration;

use ifs_benches::pieces::{PlainRecursion, fern, plan};
use ifs_benches::processes::{build_release, median, root, run};
use ifs_compiler::plan::evaluate::PiecesEvaluator;

const LEVEL: u32 = 10;
const SHAPES: usize = 1 << (2 * LEVEL);
/// The smallest shape that is drawn, in pixels: so small that none is left out.
const SMALLEST: &str = "1e-10";

fn main() {
    let ifs = build_release();
    println!("the fern, {SHAPES} shapes, one thread, Mshapes/s");
    let out = root().join("target/contextfree");
    let mut build = Command::new(ifs);
    build.arg("build").arg(root().join("benches/designs/fern.ifs")).args(["--emit", "glb", "-o"]).arg(&out);
    run(&mut build);
    tell("ifs build --emit glb, whole process", median(7, || run(&mut build)));
    match shapes_of_cfdg() {
        Some(SHAPES) => {
            tell("cfdg to an image, whole process", median(5, || run(&mut cfdg(&[]))));
            tell("cfdg to SVG, whole process", median(5, || run(&mut cfdg(&["-V"]))));
        }
        Some(other) => println!("  cfdg draws {other} shapes: no race"),
        None => println!("  cfdg is not there: install Context Free (Debian: contextfree) for the race"),
    }
    let (automaton, points) = fern();
    let pieces = plan(&points, LEVEL);
    let blocks = median(15, || {
        let mut leaves = 0;
        let Ok(()) = PiecesEvaluator::new(&automaton, black_box(&pieces)).stream(|tile| {
            leaves += black_box(tile).elements().len();
            Ok::<(), Infallible>(())
        });
        assert_eq!(leaves, SHAPES);
    });
    tell("ifs, leaves in the library", blocks);
    let plain = PlainRecursion::new(&automaton);
    let recursion = median(15, || {
        let mut leaves = 0;
        plain.run(black_box(&points), LEVEL, &mut |ends| {
            black_box(&ends);
            leaves += 1;
        });
        assert_eq!(leaves, SHAPES);
    });
    tell("plain recursion, leaves alone", recursion);
}

/// How many shapes `cfdg` says it has drawn; none where the program is not there.
fn shapes_of_cfdg() -> Option<usize> {
    let mut cfdg = cfdg(&[]);
    cfdg.env("TERM", "dumb").stdout(Stdio::piped()).stderr(Stdio::piped());
    let output = cfdg.output().ok()?;
    let text = [output.stdout, output.stderr].concat();
    let text = String::from_utf8_lossy(&text).into_owned();
    let counted = text.split(['\r', '\n']).filter_map(|line| line.trim().split_once(" shapes"));
    let mut counts = counted.filter_map(|(count, _)| count.replace(',', "").parse().ok());
    Some(counts.next_back().unwrap_or(0))
}

/// Context Free on the fern, always of the same variation.
fn cfdg(options: &[&str]) -> Command {
    let mut command = Command::new("cfdg");
    command.args(["-v", "A", "-x", SMALLEST, "-s", "500"]).args(options);
    command.arg(root().join("benches/designs/fern.cfdg")).arg("/dev/null");
    command
}

fn tell(what: &str, time: Duration) {
    println!(
        "  {what:40} {:8.2}   {:8.1} ms",
        SHAPES as f64 / time.as_secs_f64() / 1e6,
        time.as_secs_f64() * 1e3
    );
}
