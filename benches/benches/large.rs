//! Long designs, doubled again and again: lexing with parsing, checking and formatting as microseconds a line, with the
//! ratio to the design half as long; the reference in the same run is the least that reading a text takes, the count of
//! its lines. Then designs of ten thousand lines, in the library and as a whole process, against a process that does
//! nothing. Nothing is asserted: machines differ.

#![allow(
    clippy::expect_used,
    clippy::disallowed_methods,
    reason = "a benchmark that cannot be run says why and ends; it reads files, clocks and programs"
)]

use std::fs;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use ifs_benches::large::{MIXES, design};
use ifs_benches::processes::{build_release, median, millis, root, run};
use ifs_compiler::analysis::analyse;
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::{FileId, MemoryFiles, Source};
use ifs_compiler::syntax::format::format;
use ifs_compiler::syntax::parse;

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let [_, word, folder, lines] = arguments.as_slice()
        && word == "--write"
    {
        return write(Path::new(folder), lines.parse().expect("a number of lines"));
    }
    for mix in MIXES {
        doubled(mix);
    }
    ten_thousand();
}

/// Writes the designs, to be looked at or measured by other programs.
fn write(folder: &Path, lines: usize) {
    for mix in MIXES {
        fs::write(folder.join(format!("{mix}.ifs")), design(mix, lines)).expect("the folder is there");
    }
}

fn doubled(mix: &str) {
    println!("{mix}: µs a line (times the one before)");
    println!("  {:>6} {:>16} {:>16} {:>16} {:>16}", "lines", "parse", "check", "format", "count lines");
    let mut before: Option<[f64; 4]> = None;
    for lines in [1000, 2000, 4000, 8000, 16000] {
        let text = design(mix, lines);
        let source = Source::new(FileId(0), "large.ifs", &*text);
        let parsed = parse(&source);
        assert!(parsed.diagnostics.is_empty(), "{mix}: {:?}", parsed.diagnostics[0]);
        let files = MemoryFiles::single("large.ifs", &text);
        let overrides = Overrides::default();
        let times = [
            median(5, || drop(black_box(parse(&source)))),
            median(5, || drop(black_box(analyse(&files, "large.ifs", &overrides)))),
            median(5, || drop(black_box(format(&parsed, &source)))),
            median(5, || assert!(black_box(text.lines().count()) > 0)),
        ]
        .map(|time| time.as_secs_f64() * 1e6);
        let lines = text.lines().count();
        let cell = |place: usize| {
            let ratio =
                before.map_or(String::new(), |before| format!("(x{:.2})", times[place] / before[place]));
            format!("{:.3} {ratio:>7}", times[place] / lines as f64)
        };
        println!("  {lines:>6} {:>16} {:>16} {:>16} {:>16}", cell(0), cell(1), cell(2), cell(3));
        before = Some(times);
    }
}

fn ten_thousand() {
    let ifs = build_release();
    let folder = root().join("target/large");
    fs::create_dir_all(&folder).expect("the target folder is there");
    write(&folder, 10_000);
    let nothing = median(20, || run(&mut Command::new("true")));
    println!("ifs check of ten thousand lines, ms (a process that does nothing: {:.2} ms)", millis(nothing));
    println!("  {:10} {:>6} {:>10} {:>10}", "design", "lines", "library", "process");
    for mix in MIXES {
        let path = folder.join(format!("{mix}.ifs"));
        let text = fs::read_to_string(&path).expect("it was just written");
        let files = MemoryFiles::single("large.ifs", &text);
        let overrides = Overrides::default();
        let analysis = analyse(&files, "large.ifs", &overrides);
        assert!(!analysis.has_errors(), "{mix}: {:?}", analysis.diagnostics[0]);
        let library = median(7, || drop(black_box(analyse(&files, "large.ifs", &overrides))));
        let process = median(7, || run(Command::new(&ifs).arg("check").arg(&path).stderr(Stdio::null())));
        let lines = text.lines().count();
        println!("  {mix:10} {lines:>6} {:>10.1} {:>10.1}", millis(library), millis(process));
    }
    let designs = fs::read_dir(root().join("examples")).expect("the examples are there");
    let mut designs: Vec<PathBuf> = designs.filter_map(|entry| Some(entry.ok()?.path())).collect();
    designs.retain(|path| path.extension().is_some_and(|ending| ending == "ifs"));
    designs.sort();
    println!("ifs check of the examples, whole process, ms");
    for path in designs {
        let whole = median(15, || run(Command::new(&ifs).arg("check").arg(&path)));
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        println!(
            "  {name:20} {:>8.1}   ratio {:.1}",
            millis(whole),
            whole.as_secs_f64() / nothing.as_secs_f64()
        );
    }
}
