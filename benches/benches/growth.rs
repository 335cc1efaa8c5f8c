//! How the whole build grows: `ifs build` as it is released makes shells of 1,024, 10,000 and 99,856 boards with all
//! their files, planarized by projection, into a scratch folder. For each the time of the processor, the time by the
//! clock and the greatest memory, all also by board, and what they are by board against the smallest shell; 1 is growth
//! that is linear. Nothing is asserted: machines differ. `GROWTH_BOARDS` limits the largest. Linux alone.

#![allow(
    clippy::expect_used,
    clippy::disallowed_methods,
    reason = "a benchmark that cannot be run says why and ends; it reads clocks and programs"
)]

use std::fs;
use std::path::Path;
use std::process::Command;

use ifs_benches::processes::{build_release, root};

/// Quads along a side.
const SIDES: [u32; 3] = [32, 100, 316];

/// What one build took.
struct Cost {
    boards: f64,
    /// Seconds of the processor, seconds by the clock, and bytes.
    costs: [f64; 3],
}

fn main() {
    let most = std::env::var("GROWTH_BOARDS").ok().and_then(|text| text.parse().ok()).unwrap_or(100_000);
    let ifs = build_release();
    let folder = root().join("target/growth");
    fs::create_dir_all(&folder).expect("the target folder is there");
    println!(
        "{:>7} {:>9} {:>9} {:>9} {:>11} {:>11} {:>11}   against the first, by board",
        "boards", "cpu s", "clock s", "MB", "cpu µs each", "clock µs", "kB each"
    );
    let mut first: Option<Cost> = None;
    for side in SIDES.into_iter().filter(|side| side * side <= most) {
        let cost = build(&ifs, &folder, side);
        let [cpu, clock, memory] = cost.costs;
        let [cpu_each, clock_each, memory_each] = cost.costs.map(|whole| whole / cost.boards);
        let against = first.as_ref().map_or(String::new(), |first| {
            let ratio = |place: usize| cost.costs[place] / cost.boards / (first.costs[place] / first.boards);
            format!("cpu {:.2}  clock {:.2}  memory {:.2}", ratio(0), ratio(1), ratio(2))
        });
        println!(
            "{:>7} {cpu:>9.2} {clock:>9.2} {:>9.1} {:>11.1} {:>11.1} {:>11.2}   {against}",
            cost.boards,
            memory / 1e6,
            cpu_each * 1e6,
            clock_each * 1e6,
            memory_each / 1e3
        );
        first.get_or_insert(cost);
    }
    let _ = fs::remove_dir_all(&folder);
}

/// Boards of about 500 mm of a shell that is curved alike at every size, so that each board takes the same work.
fn design(side: u32) -> String {
    let wave = "120mm * sin(12deg * i) * cos(9deg * j)";
    format!(
        "use std.curves (bspline1)\nuse std.surfaces (sheet)\nuse std.materials (birch_plywood)\n\
         use std.machines (router3)\n\
         let net = [[(i * 500mm, j * 500mm, {wave}) for j in 0..{last}] for i in 0..{last}]\n\
         figure shell = sheet(bspline1, bspline1, net) at level 0\n\
         fabricate shell as panels {{\n    material: birch_plywood(12mm)\n    board: 2500mm by 1250mm\n    \
         grain: u\n    planarize: {{ method: projection, threshold: 0.99999 }}\n    address: engraved(height: 18mm)\n    \
         machine: router3(tool: 6mm, feed: 4m/min, plunge: 1.2m/min, spindle: 18000rpm)\n    \
         nest: {{ gap: 8mm, margin: 16mm }}\n}}\n",
        last = side + 1
    )
}

fn build(ifs: &Path, folder: &Path, side: u32) -> Cost {
    let path = folder.join(format!("shell{side}.ifs"));
    fs::write(&path, design(side)).expect("the design can be written");
    let out = folder.join("out");
    let _ = fs::remove_dir_all(&out);
    // The shell's own clock of its children, and the kernel's record of their greatest memory.
    let mut command = Command::new("/usr/bin/time");
    command.args(["-f", "%U %S %e %M"]).arg(ifs).arg("build").arg(&path).arg("-o").arg(&out);
    let done = command.output().expect("GNU time is installed (Debian: time)");
    let said = String::from_utf8_lossy(&done.stderr);
    assert!(done.status.success(), "{said}");
    let last = said.lines().last().unwrap_or_default();
    let numbers: Vec<f64> = last.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    let [user, system, clock, kilobytes] = numbers[..] else { panic!("GNU time said {last:?}") };
    let boards = f64::from(side * side);
    let programs = fs::read_dir(out.join("boards")).expect("boards were made").count();
    assert!(programs >= 2 * (side * side) as usize, "{programs} files of {boards} boards");
    Cost { boards, costs: [user + system, clock, kilobytes * 1024.0] }
}
