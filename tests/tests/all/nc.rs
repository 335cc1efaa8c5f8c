//! LinuxCNC's interpreter as referee of NC programs: it takes ours, and refuses what is wrong.
#![allow(clippy::disallowed_methods, reason = "the tests write what the referee reads")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail anywhere")]

use std::fs;
use std::path::Path;

use glam::{DVec2, DVec3};
use ifs_compiler::export::nc;
use ifs_compiler::fabricate::cut_job::{CutJob, Engraving};
use ifs_compiler::fabricate::machine::{
    CutDirection, Dialect, Fixing, Machine, MachineSpec, Tool, WorkOffset, ZZero,
};
use ifs_compiler::fabricate::toolpath::{Program, Refusal, program};
use ifs_compiler::readback::{Expected, NcText, read_back_set};
use ifs_tests::referees::{Verdict, python_referee};
use ifs_tests::scratch;
use serde_json::{Value, json};

const THICKNESS: f64 = 12.0;

fn tool(number: u32, diameter: f64) -> Tool {
    let (feed, plunge, spindle, max_step_down) = (60.0, 15.0, 300.0, 5.0);
    let name = format!("{diameter} mm");
    Tool { number, name, diameter, flute_length: 40.0, feed, plunge, spindle, max_step_down }
}

fn machine(z_zero: ZZero, direction: CutDirection) -> Machine {
    Machine::try_new(router(z_zero, direction)).unwrap()
}

pub(crate) fn router(z_zero: ZZero, direction: CutDirection) -> MachineSpec {
    MachineSpec {
        name: "router".to_owned(),
        envelope: DVec3::new(2500.0, 1250.0, 150.0),
        safe_height: 15.0,
        z_zero,
        work_offset: WorkOffset::G54,
        stock_margin: 8.0,
        cut_through: 0.4,
        engrave_depth: 0.4,
        spindle_range: (100.0, 400.0),
        spin_up: 2.0,
        direction,
        allowance: 0.0,
        fixing: Fixing::Held,
        clamps: Vec::new(),
        dialect: Dialect::LinuxCnc,
        tools: vec![tool(1, 6.0), tool(2, 1.0)],
        cutter: 1,
        engraver: 2,
    }
}

/// A panel, a plank, a small board and a board with a gently curved side, bulging in and out.
fn outlines() -> Vec<Vec<DVec2>> {
    let wave = |i: i32| {
        let x = f64::from(i) * 12.0;
        DVec2::new(x, 150.0 + 10.0 * (x / 480.0) * (1.0 - x / 480.0) * (x / 240.0 - 1.0))
    };
    let mut bent = vec![DVec2::ZERO, DVec2::new(480.0, 0.0)];
    bent.extend((0..=40).rev().map(wave));
    let straight = |corners: [(f64, f64); 4]| corners.map(DVec2::from).to_vec();
    vec![
        straight([(0.0, 0.0), (250.0, 10.0), (240.0, 235.0), (-12.0, 228.0)]),
        straight([(0.0, 0.0), (1200.0, 0.0), (1150.0, 120.0), (80.0, 120.0)]),
        straight([(0.0, 0.0), (60.0, 0.0), (62.0, 55.0), (3.0, 58.0)]),
        bent,
    ]
}

pub(crate) fn job(outline: Vec<DVec2>, alias: String) -> CutJob {
    CutJob {
        address: format!("shell.{alias}"),
        alias,
        design: "shell (of a \u{1f332})".to_owned(),
        design_hash: "0123456789abcdef".repeat(4),
        outline,
        thickness: THICKNESS,
        engraving: Engraving { height: 18.0, least_height: 3.0, clearance: 3.0, mark_edge_0: true },
        face_up: "top".to_owned(),
        notes: vec!["edge 0 bevel 3.250 deg, not cut by this file".to_owned()],
    }
}

/// Writes the files of a program that has been read back; what the referee is to expect of them.
fn write(folder: &Path, job: &CutJob, machine: &Machine, made: &Program) -> Value {
    let files = nc::write(made, machine);
    let texts: Vec<NcText> = files.iter().map(|f| NcText { tool: f.tool, text: &f.text }).collect();
    read_back_set(&texts, &Expected::new(job, machine)).unwrap();
    let mut written = Vec::new();
    for file in &files {
        let name = match file.tool {
            Some(tool) => format!("{}.t{tool}.nc", job.alias),
            None => format!("{}.nc", job.alias),
        };
        fs::write(folder.join(&name), &file.text).unwrap();
        written.push(json!({ "file": name, "tool": file.tool }));
    }
    let corners: Vec<[f64; 2]> = made.parts[0].outline.iter().map(|p| [p.x, p.y]).collect();
    let thickness = job.thickness;
    let mut entry = json!({
        "files": written, "outline": corners, "tool_diameter": machine.cutter().diameter,
        "dialect": machine.spec().dialect.profile().name,
        "thickness": thickness, "top": machine.top(thickness), "floor": machine.bottom(thickness),
    });
    if let Some(top) = machine.tab_top(thickness) {
        entry["tab_top"] = json!(top);
    }
    entry
}

/// Writes every outline for both zeros and directions; what the referee is to expect of each.
fn written(folder: &Path) -> Value {
    let mut entries = Vec::new();
    for (z_zero, direction) in
        [(ZZero::TopOfStock, CutDirection::Climb), (ZZero::Table, CutDirection::Conventional)]
    {
        let machine = machine(z_zero, direction);
        for outline in outlines() {
            let job = job(outline, format!("b-{}", entries.len()));
            let made = program(&job, &machine).unwrap();
            entries.push(write(folder, &job, &machine, &made));
        }
    }
    Value::Array(entries)
}

/// Numbers that look random and are the same everywhere.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// From `low` to `high`.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        // Knuth's multiplier for 64 bits; the upper bits are the good ones.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }

    pub(crate) fn below(&mut self, count: usize) -> usize {
        (self.between(0.0, count as f64) as usize).min(count - 1)
    }

    /// A convex quad or a plank, turned.
    pub(crate) fn board(&mut self) -> Vec<DVec2> {
        let (w, h) = (self.between(90.0, 400.0), self.between(90.0, 400.0));
        let corners = if self.below(2) == 0 {
            let mut side = || self.between(0.25, 0.75);
            let t = [side(), side(), side(), side()];
            [(t[0] * w, 0.0), (w, t[1] * h), (t[2] * w, h), (0.0, t[3] * h)]
        } else {
            let (a, b, depth) = (self.between(-40.0, 40.0), self.between(-40.0, 40.0), 0.25 * h + 40.0);
            [(0.0, 0.0), (2.0 * w, 0.0), (2.0 * w + a, depth), (b, depth)]
        };
        let turn = DVec2::from_angle(self.between(0.0, 6.2));
        corners.map(|corner| turn.rotate(DVec2::from(corner))).to_vec()
    }

    pub(crate) fn machine(&mut self, dialect: Dialect) -> MachineSpec {
        let z_zero = [ZZero::TopOfStock, ZZero::Table][self.below(2)];
        let direction = [CutDirection::Climb, CutDirection::Conventional][self.below(2)];
        let mut spec = router(z_zero, direction);
        spec.dialect = dialect;
        spec.tools[0].diameter = [3.0, 6.0, 8.0, 10.0][self.below(4)];
        spec.tools[0].max_step_down = self.between(2.0, 8.0);
        spec.allowance = [0.0, 0.0, 0.3, 1.0][self.below(4)];
        spec.fixing = match self.below(3) {
            0 => Fixing::Held,
            1 => Fixing::OnionSkin { thickness: self.between(0.2, 1.0) },
            _ => Fixing::Tabs { count: 1 + self.below(5) as u32, width: self.between(3.0, 9.0), height: 2.0 },
        };
        spec
    }
}

/// How many boards in each dialect; tests/acceptance.sh asks for more.
fn count() -> usize {
    std::env::var("NC_BOARDS").map_or(300, |count| count.parse().unwrap())
}

fn random_boards(dialect: Dialect) {
    let name = dialect.profile().name;
    let folder = scratch(&format!("nc-random-{name}"));
    let mut random = Random(name.len() as u64);
    let (mut entries, mut refused) = (Vec::new(), 0);
    while entries.len() < count() {
        let machine = Machine::try_new(random.machine(dialect)).unwrap();
        let mut job = job(random.board(), format!("b-{:05}", entries.len()));
        job.thickness = random.between(4.0, 30.0);
        match program(&job, &machine) {
            Ok(made) => entries.push(write(&folder, &job, &machine, &made)),
            // Narrow boards may have no room for the alias, or for so many tabs: nothing else is refused.
            Err(Refusal::TextDoesNotFit { .. } | Refusal::TabsDoNotFit { .. }) => refused += 1,
            Err(other) => panic!("{other}"),
        }
    }
    assert!(refused < entries.len() / 5, "{refused} refused");
    let verdict = judged(&folder, &Value::Array(entries));
    assert!(verdict.good, "{}", verdict.faults);
    assert_eq!(verdict.counts["programs"], count());
    assert!(verdict.counts["worst"].as_f64().unwrap() < 0.02, "{}", verdict.counts);
}

#[test]
fn random_boards_in_linuxcnc() {
    random_boards(Dialect::LinuxCnc);
}

#[test]
fn random_boards_in_grbl() {
    random_boards(Dialect::Grbl);
}

#[test]
fn random_boards_in_fanuc() {
    random_boards(Dialect::Fanuc);
}

pub(crate) fn judged(folder: &Path, entries: &Value) -> Verdict {
    let listing = folder.join("expected.json");
    fs::write(&listing, entries.to_string()).unwrap();
    python_referee("nc.py", &[folder, &listing])
}

#[test]
fn linuxcnc_cuts_the_outlines_out_of_our_programs() {
    let folder = scratch("nc");
    let verdict = judged(&folder, &written(&folder));
    assert!(verdict.good, "{}", verdict.faults);
    assert_eq!(verdict.counts["programs"], 8);
    assert!(verdict.counts["worst"].as_f64().unwrap() < 0.01, "{}", verdict.counts);
}

#[test]
fn the_referee_refuses_what_is_wrong() {
    let folder = scratch("nc-wrong");
    let good = written(&folder);
    let text = fs::read_to_string(folder.join("b-0.nc")).unwrap();
    let end = "G0 Z15.000\nM5\nM2";
    let spoilt: [(&str, String, &str); 6] = [
        ("arc", text.replace(" J-", " J-1"), "b-0.nc: rs274 ends with 1"),
        (
            "gouge",
            text.replace(end, &format!("G1 X150.000 Y125.000 Z-5.000\n{end}")),
            "mm into the part above full depth",
        ),
        ("shallow", text.replace("Z-12.400", "Z-11.900"), "b-0.nc: cuts to Z -11.9, not -12.4"),
        ("tool", text.replace("diameter 6.000", "diameter 8.000"), "b-0.nc: nothing is cut with a tool of 6"),
        ("alien", text.replace("G40", "G41"), "b-0.nc: is no linuxcnc: "),
        ("end", text.replace("M2\n", ""), "b-0.nc: rs274 "),
    ];
    for (what, wrong, fault) in spoilt {
        assert_ne!(wrong, text, "{what}");
        fs::write(folder.join("b-0.nc"), wrong).unwrap();
        let verdict = judged(&folder, &good);
        assert!(!verdict.good && verdict.faults.contains(fault), "{what}: {}", verdict.faults);
    }
    fs::write(folder.join("b-0.nc"), &text).unwrap();
    let mut other = good.clone();
    other[0]["outline"][2][0] = json!(good[0]["outline"][2][0].as_f64().unwrap() + 0.1);
    assert!(judged(&folder, &other).faults.contains("b-0.nc: the part is "));
    other = good.clone();
    other[0]["files"][0]["file"] = json!("b-9.nc");
    let unlisted = judged(&folder, &other);
    assert!(unlisted.faults.contains("b-0.nc: there and not listed"), "{}", unlisted.faults);
    assert!(unlisted.faults.contains("b-9.nc: listed and not there"), "{}", unlisted.faults);
    assert!(!judged(&folder, &json!([])).good);
}

/// A flat roof of 25 cm boards on a machine with these arguments and this line more in the block, built.
fn built(name: &str, machine: &str, line: &str) -> (Vec<String>, String) {
    let folder = scratch(name);
    let design = format!(
        "use std.curves (bspline3)\nuse std.surfaces (sheet)\nuse std.materials (birch_plywood)\n\
         use std.machines (Machine, Tool, Clamp, router3, tabs, onion_skin)\n\
         figure roof = sheet(bspline3, bspline3, [[(i * 500mm, j * 500mm, 0mm) for j in 0..5] for i in 0..5]) at level 1\n\
         fabricate roof as panels {{\n    material: birch_plywood(12mm)\n    board: 2500mm by 1250mm\n    \
         machine: {machine}\n    {line}\n}}\n"
    );
    fs::write(folder.join("roof.ifs"), design).unwrap();
    let run = ifs_tests::program()
        .current_dir(&folder)
        .args(["build", "roof.ifs", "-o", "out", "--emit", "nc,csv,dxf"])
        .output()
        .unwrap();
    let mut files: Vec<String> = fs::read_dir(folder.join("out/boards"))
        .map(|entries| entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect())
        .unwrap_or_default();
    files.retain(|file| file.ends_with(".nc"));
    files.sort();
    (files, String::from_utf8(run.stderr).unwrap())
}

#[test]
fn a_design_says_how_its_boards_are_held_and_in_which_dialect() {
    let (files, said) = built("nc-grbl", "router3(dialect: grbl)", "fixing: tabs(count: 3)");
    assert_eq!(files.len(), 32, "{said}");
    assert!(files.iter().all(|file| file.ends_with(".t1.nc") || file.ends_with(".t2.nc")), "{files:?}");
    let (files, said) =
        built("nc-fanuc", "router3(dialect: fanuc, allowance: 0.3mm)", "fixing: onion_skin(0.5mm)");
    assert_eq!(files.len(), 16, "{said}");
}

#[test]
fn a_board_that_cannot_be_held_or_reached_is_refused_with_what_would_mend_it() {
    let cases = [
        ("tabs", "router3()", "fixing: tabs(count: 70)", "70 tabs do not fit", "tabs or fewer"),
        ("flute", "router3(flute: 8mm)", "", "its flutes are 8.000 mm long", "flutes of at least 12.5 mm"),
        ("held", "router3()", "fixing: tabs(count: 4, width: 0mm)", "width of tabs is 0", "`vacuum()`"),
    ];
    for (name, machine, line, why, remedy) in cases {
        let (files, said) = built(&format!("nc-refused-{name}"), machine, line);
        assert!(files.is_empty() && said.contains(why) && said.contains(remedy), "{name}: {said}");
    }
}

#[test]
fn a_spare_cutter_takes_the_place_of_one_that_does_not_reach() {
    let tool = |number: u32, flute: &str| {
        format!(
            "Tool(number: {number}, name: \"cutter {number}\", diameter: 6mm, flute: {flute}, feed: 3m/min, \
             plunge: 1m/min, spindle: 16000rpm, step_down: 0.5mm)"
        )
    };
    let machine = format!(
        "Machine(name: \"own\", length: 3m, width: 2m, height: 100mm, cutter: {}, spare_cutters: [{}, {}], engraver: {})",
        tool(1, "9mm"),
        tool(3, "11mm"),
        tool(4, "30mm"),
        tool(2, "5mm").replace("diameter: 6mm", "diameter: 1mm"),
    );
    let (files, said) = built("nc-spare", &machine, "nest: { programs: both }");
    assert_eq!(files.len(), 16, "{said}");
    // The drawings name the one that cuts.
    let out = ifs_tests::root().join("target/tmp/ifs-tests/nc-spare/out");
    for drawing in [out.join("boards").join(files[0].replace(".nc", ".dxf")), out.join("sheets/1.dxf")] {
        let text = fs::read_to_string(drawing).unwrap();
        assert!(text.contains("CUT T4 cutter 4 12.5mm") && !text.contains("CUT T1"), "{text}");
    }
}
