//! Nesting a hundred boards, a thousand and four thousand, the first two side by side with spyrrow (PyPI), which is
//! given a minute: our time of the processor, numbers of raw boards, and the bound that nobody gets below. Spyrrow packs
//! one endless strip as wide as a raw board; its boards are counted by the length of that strip, which flatters it:
//! pieces may lie across the ends of boards.
//!
//! Spyrrow is looked for in the Python that `SPYRROW_PYTHON` names; without it only our own figures are given.

#![allow(
    clippy::expect_used,
    clippy::disallowed_methods,
    reason = "a benchmark that cannot be run says why and ends; it reads clocks and programs"
)]

use std::hint::black_box;
use std::io::Write as _;
use std::process::{Command, Stdio};

use ifs_benches::boards::all;
use ifs_benches::processes::{cpu_time, median, middle, millis};
use ifs_compiler::nest::check::faults;
use ifs_compiler::nest::sheets::{Part, Sheet, area, least_sheets, nest};

const SHEET: Sheet = Sheet { length: 2500.0, width: 1250.0, margin: 10.0, gap: 8.0 };

/// Reads parts, one a line, and prints how long a strip they take.
const SPYRROW: &str = "
import sys, spyrrow
items = []
for number, line in enumerate(sys.stdin):
    turns, *corners = line.split()
    corners = [tuple(map(float, corner.split(','))) for corner in corners]
    turns = [0, 90, 180, 270] if turns == '4' else [0, 180]
    items.append(spyrrow.Item(str(number), corners + corners[:1], demand=1, allowed_orientations=turns))
width, gap = map(float, sys.argv[1:])
instance = spyrrow.StripPackingInstance('boards', strip_height=width, items=items)
config = spyrrow.StripPackingConfig(early_termination=False, total_computation_time=60, num_workers=2, seed=0, min_items_separation=gap)
print(instance.solve(config).width)
";

fn main() {
    let python = std::env::var_os("SPYRROW_PYTHON");
    println!("boards of {} mm by {} mm, gap {} mm", SHEET.length, SHEET.width, SHEET.gap);
    println!(
        "  {:12} {:>6} {:>8} {:>8} {:>7} {:>7} {:>7} {:>8}",
        "set", "parts", "cpu ms", "check", "sheets", "bound", "yield", "spyrrow"
    );
    for count in [100, 1000, 4000] {
        for (name, parts) in all(count) {
            let nested = nest(&parts, &SHEET);
            assert_eq!(faults(&parts, &SHEET, &nested), [], "{name}");
            assert!(nested.unplaced.is_empty(), "{name}");
            let runs = (0..5).map(|_| cpu_time(|| drop(black_box(nest(&parts, &SHEET)))));
            let time = middle(runs.collect());
            let check = median(5, || drop(black_box(faults(&parts, &SHEET, &nested))));
            let sum: f64 = parts.iter().map(|part| area(&part.outline)).sum();
            let strip = python.as_ref().filter(|_| count <= 1000).map_or("-".to_owned(), |python| {
                let room = SHEET.room();
                format!("{:.1}", (spyrrow(python, &parts, room.y) + SHEET.gap) / (room.x + SHEET.gap))
            });
            println!(
                "  {name:12} {count:>6} {:>8.1} {:>8.1} {:>7} {:>7} {:>7.3} {strip:>8}",
                millis(time),
                millis(check),
                nested.sheets,
                least_sheets(&parts, &SHEET),
                sum / (nested.sheets as f64 * SHEET.area())
            );
        }
    }
}

/// The length of the strip that spyrrow finds in a minute, mm.
fn spyrrow(python: &std::ffi::OsStr, parts: &[Part], width: f64) -> f64 {
    let mut command = Command::new(python);
    command.args(["-c", SPYRROW]).args([width.to_string(), SHEET.gap.to_string()]);
    let mut child = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the Python of SPYRROW_PYTHON can be started");
    let mut input = child.stdin.take().expect("its input is piped");
    for part in parts {
        let corners: Vec<String> =
            part.outline.iter().map(|corner| format!("{},{}", corner.x, corner.y)).collect();
        let turns = if part.any_quarter { 4 } else { 2 };
        writeln!(input, "{turns} {}", corners.join(" ")).expect("it reads its input");
    }
    drop(input);
    let output = child.wait_with_output().expect("it ends");
    let text = String::from_utf8_lossy(&output.stdout);
    text.trim().parse().expect("spyrrow is installed there and says a length")
}
