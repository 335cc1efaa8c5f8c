//! The three races of the compiler, each against a reference measured in the same run, as medians:
//! a bicubic shell of 1025 × 1025 vertices against numpy and scipy; `ifs check` of a design of two hundred lines as a
//! whole process against a process that does nothing; `ifs build --emit glb` of a million quads against copying the
//! file it wrote. Nothing is asserted: machines differ.

#![allow(
    clippy::expect_used,
    clippy::disallowed_methods,
    reason = "a race that cannot be run says why and ends; it reads files, clocks and programs"
)]

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

use ifs_benches::processes::{build_release, median, middle, millis, root, run, time};
use ifs_benches::{bezier3, net};
use ifs_compiler::ifs::StateId;
use ifs_compiler::plan::SheetPlan;
use ifs_compiler::plan::evaluate::SheetEvaluator;

fn main() {
    let ifs = build_release();
    evaluation();
    check(&ifs);
    million(&ifs);
}

fn evaluation() {
    let (automaton, state) = (bezier3(), StateId(0));
    let sheet = SheetPlan {
        u: state,
        v: state,
        net_rows: 4,
        net_columns: 4,
        net: net(4, 4),
        levels: (10, 10),
        windows: false,
    };
    let mut grid = Vec::new();
    let reused = median(50, || SheetEvaluator::new(&automaton, &sheet).fill(&mut grid));
    let vertices = grid.len() as f64;
    let fresh = median(50, || {
        let mut grid = Vec::new();
        SheetEvaluator::new(&automaton, &sheet).fill(&mut grid);
        assert!(!grid.is_empty());
    });
    let rate = |time: Duration| vertices / time.as_secs_f64() / 1e6;
    println!("bicubic shell, 1025 x 1025 vertices, one thread, Mvertices/s");
    println!("  ifs, reused buffer                     {:8.1}", rate(reused));
    println!("  ifs, fresh buffer                      {:8.1}", rate(fresh));
    let peers = Command::new(python())
        .arg(root().join("benches/peers.py"))
        .output()
        .expect("run tests/setup.sh first");
    assert!(peers.status.success(), "{}", String::from_utf8_lossy(&peers.stderr));
    for line in String::from_utf8_lossy(&peers.stdout).lines() {
        let Some(value) =
            line.strip_suffix(" Mvertices/s").and_then(|line| line.rsplit(' ').next()?.parse::<f64>().ok())
        else {
            println!("  {line}");
            continue;
        };
        let ours = if line.contains("reused") { rate(reused) } else { rate(fresh) };
        println!("  {}   ifs is {:.2} times as fast", line.trim_end_matches(" Mvertices/s"), ours / value);
    }
}

fn check(ifs: &Path) {
    let design = root().join("benches/designs/hall.ifs");
    let lines = fs::read_to_string(&design).expect("the design is there").lines().count();
    let nothing = median(50, || run(&mut Command::new("true")));
    let whole = median(50, || run(Command::new(ifs).arg("check").arg(&design)));
    println!("ifs check of a design of {lines} lines, whole process");
    println!("  ifs check                              {:8.2} ms", millis(whole));
    println!(
        "  a process that does nothing            {:8.2} ms   ratio {:.1}",
        millis(nothing),
        ratio(whole, nothing)
    );
}

fn million(ifs: &Path) {
    let design = root().join("benches/designs/million.ifs");
    let out = root().join("target/race");
    let model = out.join("model.glb");
    let copy = root().join("target/race-copy.glb");
    let mut build = Command::new(ifs);
    build.arg("build").arg(&design).args(["--emit", "glb", "-o"]).arg(&out).stdout(Stdio::null());
    run(&mut build);
    let size = fs::metadata(&model).expect("the model is there").len() as f64 / 1e6;
    let mut copied = Vec::new();
    let mut built = Vec::new();
    // In turn, so that a machine that slows down slows both.
    for _ in 0..15 {
        built.push(time(|| run(&mut build)));
        copied.push(time(|| {
            fs::copy(&model, &copy).expect("room for a copy");
            File::open(&copy).and_then(|file| file.sync_all()).expect("the copy is flushed");
        }));
    }
    let (built, copied) = (middle(built), middle(copied));
    println!("ifs build --emit glb of 1,048,576 quads, whole process, {size:.0} MB flushed to disk");
    println!("  ifs build                              {:8.1} ms", millis(built));
    println!(
        "  copying the file it wrote              {:8.1} ms   ratio {:.2}",
        millis(copied),
        ratio(built, copied)
    );
    let _ = fs::remove_file(copy);
}

fn python() -> PathBuf {
    root().join("target/referees/bin/python")
}

fn ratio(a: Duration, b: Duration) -> f64 {
    a.as_secs_f64() / b.as_secs_f64()
}
