//! Programs and drawings of nested sheets: LinuxCNC and shapely cut every board of a sheet out where it lies, ezdxf reads it
//! there.
#![allow(clippy::disallowed_methods, reason = "the tests write what the referees read")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail anywhere")]

use std::fs;
use std::path::{Path, PathBuf};

use glam::DVec2;
use ifs_compiler::export::nc;
use ifs_compiler::fabricate::cut_job::{CutJob, Placed, Rotation, Sheet};
use ifs_compiler::fabricate::machine::{CutDirection, Dialect, Machine, ZZero};
use ifs_compiler::fabricate::toolpath::{PartRefusal, Refusal, sheet};
use ifs_compiler::nest::sheets::{Part, Sheet as RawSheet, nest};
use ifs_compiler::outputs::{Format, Outputs, Selection, outputs};
use ifs_compiler::readback::{Expected, NcText, read_back_set};
use ifs_tests::designs::{analysis_of, example_path, example_text};
use ifs_tests::{program, scratch};
use serde_json::{Value, json};

use crate::nc::{Random, job, judged, router};

const ROTATIONS: [Rotation; 4] = [Rotation::None, Rotation::Quarter, Rotation::Half, Rotation::ThreeQuarters];

/// The outlines that a picture of a sheet shows, from its lower left corner; pictures have their own writer.
fn pictured(path: &Path) -> Vec<Vec<[f64; 2]>> {
    let text = fs::read_to_string(path).unwrap();
    let board = text.split("class=\"board\"").nth(1).unwrap();
    let of = |name: &str| -> f64 {
        let (_, rest) = board.split_once(&format!(" {name}=\"")).unwrap();
        rest.split('"').next().unwrap().parse().unwrap()
    };
    let (left, bottom) = (of("x"), of("y") + of("height"));
    let point = |pair: &str| {
        let (x, y) = pair.split_once(',').unwrap();
        [x.parse::<f64>().unwrap() - left, bottom - y.parse::<f64>().unwrap()]
    };
    let parts = text.split("class=\"part\" points=\"").skip(1);
    parts.map(|part| part.split('"').next().unwrap().split(' ').map(point).collect()).collect()
}

/// The shell with its sheets, its boards cut in sheets alone, in a dialect.
fn built(dialect: &str) -> PathBuf {
    let folder = scratch(&format!("sheet-programs-{dialect}"));
    let text = fs::read_to_string(example_path("shell")).unwrap();
    let cut = text.replace("margin: 16mm }", "margin: 16mm, programs: sheets }");
    let cut = cut.replace("router3(tool: 6mm,", &format!("router3(dialect: {dialect}, tool: 6mm,"));
    assert!(cut.contains("programs: sheets") && cut.contains(dialect));
    fs::write(folder.join("shell.ifs"), cut).unwrap();
    let out = folder.join("out");
    let build = program()
        .arg("build")
        .arg(folder.join("shell.ifs"))
        .args(["--emit", "nc,svg,json", "-o"])
        .arg(&out)
        .output();
    let build = build.unwrap();
    assert!(build.status.success(), "{}", String::from_utf8_lossy(&build.stderr));
    assert!(!out.join("boards").exists(), "boards have programs of their own");
    out
}

#[test]
fn linuxcnc_cuts_every_board_of_the_shell_out_of_its_sheets() {
    for dialect in ["linuxcnc", "grbl"] {
        let out = built(dialect);
        let report: Value = serde_json::from_slice(&fs::read(out.join("report.json")).unwrap()).unwrap();
        let sheets = report["sheets"][0]["sheets"].as_array().unwrap();
        let mut boards = 0;
        let mut entries = Vec::new();
        for sheet in sheets {
            let name = sheet["name"].as_str().unwrap();
            let outlines = pictured(&out.join(format!("sheets/{name}.svg")));
            boards += outlines.len();
            let files = sheet["files"].as_array().unwrap().iter().map(|file| file.as_str().unwrap());
            let programs = files.filter(|file| file.ends_with(".nc")).map(|file| {
                let file = file.strip_prefix("sheets/").unwrap();
                let tool = file.split('.').find_map(|part| part.strip_prefix('t')?.parse::<u32>().ok());
                json!({ "file": file, "tool": tool })
            });
            entries.push(json!({
                "files": programs.collect::<Vec<_>>(), "outlines": outlines, "tool_diameter": 6.0, "thickness": 12.0,
                "floor": -12.5, "dialect": dialect,
            }));
        }
        assert_eq!(boards, 256);
        let verdict = judged(&out.join("sheets"), &Value::Array(entries));
        assert!(verdict.good, "{dialect}: {}", verdict.faults);
        assert!(verdict.counts["worst"].as_f64().unwrap() < 0.02, "{}", verdict.counts);
    }
}

/// Random boards nested on raw boards, the sheets written and read back; what the referee is to expect.
fn nested(folder: &Path, dialect: Dialect, random: &mut Random, entries: &mut Vec<Value>) {
    let machine = Machine::try_new(random.machine(dialect)).unwrap();
    let jobs: Vec<CutJob> = (0..7).map(|i| job(random.board(), format!("b-{i}"))).collect();
    let parts: Vec<Part> =
        jobs.iter().map(|job| Part { outline: job.outline.clone(), any_quarter: true }).collect();
    let gap = machine.cutter().diameter + machine.spec().allowance + random.between(0.0, 8.0);
    let raw = RawSheet { length: 2400.0, width: 1200.0, margin: gap + machine.spec().stock_margin, gap };
    let nested = nest(&parts, &raw);
    for place in 0..nested.sheets {
        let here = nested.placements.iter().filter(|placement| placement.sheet == place);
        let lying = here.map(|placed| {
            let corners: Vec<DVec2> = jobs[placed.part].outline.iter().map(|&p| placed.put(p)).collect();
            let low = corners.iter().copied().fold(DVec2::INFINITY, DVec2::min);
            let rotation = ROTATIONS[usize::from(placed.quarter_turns)];
            (Placed { job: &jobs[placed.part], rotation, low }, corners)
        });
        let (parts, outlines): (Vec<Placed>, Vec<Vec<DVec2>>) = lying.unzip();
        let name = format!("{}-{}", machine.spec().dialect.profile().name, entries.len());
        let stock = DVec2::new(raw.length, raw.width);
        let asked = Sheet { name: name.clone(), number: 1, stock, parts };
        let made = match sheet(&asked, &machine) {
            Ok(made) => made,
            Err(PartRefusal {
                refusal: Refusal::TextDoesNotFit { .. } | Refusal::TabsDoNotFit { .. },
                ..
            }) => continue,
            Err(other) => panic!("{name}: {other}"),
        };
        let files = nc::write(&made, &machine);
        let texts: Vec<NcText> = files.iter().map(|f| NcText { tool: f.tool, text: &f.text }).collect();
        read_back_set(&texts, &Expected::of_sheet(&asked, &machine)).unwrap();
        let mut written = Vec::new();
        for file in &files {
            let path = format!("{name}.t{}.nc", file.tool.unwrap_or(0));
            fs::write(folder.join(&path), &file.text).unwrap();
            written.push(json!({ "file": path, "tool": file.tool }));
        }
        let thickness = jobs[0].thickness;
        let outlines: Vec<Vec<[f64; 2]>> =
            outlines.iter().map(|corners| corners.iter().map(|p| [p.x, p.y]).collect()).collect();
        let mut entry = json!({
            "files": written, "outlines": outlines, "tool_diameter": machine.cutter().diameter,
            "dialect": machine.spec().dialect.profile().name, "thickness": thickness,
            "top": machine.top(thickness), "floor": machine.bottom(thickness),
        });
        if let Some(top) = machine.tab_top(thickness) {
            entry["tab_top"] = json!(top);
        }
        entries.push(entry);
    }
}

#[test]
fn linuxcnc_cuts_random_nests_in_every_dialect() {
    let folder = scratch("sheet-programs-random");
    let mut random = Random(7);
    let mut entries = Vec::new();
    for dialect in Dialect::ALL {
        for _ in 0..6 {
            nested(&folder, dialect, &mut random, &mut entries);
        }
    }
    assert!(entries.len() >= 12, "{} sheets", entries.len());
    let verdict = judged(&folder, &Value::Array(entries));
    assert!(verdict.good, "{}", verdict.faults);
    assert!(verdict.counts["worst"].as_f64().unwrap() < 0.02, "{}", verdict.counts);
}

#[test]
fn the_referee_sees_a_board_of_a_sheet_that_is_elsewhere() {
    let folder = scratch("sheet-programs-wrong");
    let machine = Machine::try_new(router(ZZero::TopOfStock, CutDirection::Climb)).unwrap();
    let corners = |x: f64, y: f64| [(0.0, 0.0), (x, 0.0), (x, y), (0.0, y)].map(DVec2::from).to_vec();
    let jobs = [job(corners(200.0, 150.0), "b-0".to_owned()), job(corners(180.0, 160.0), "b-1".to_owned())];
    let at = |job, x| Placed { job, rotation: Rotation::None, low: DVec2::new(x, 20.0) };
    let parts = vec![at(&jobs[0], 20.0), at(&jobs[1], 240.0)];
    let asked = Sheet { name: "1".to_owned(), number: 1, stock: DVec2::new(500.0, 220.0), parts };
    let text = nc::write(&sheet(&asked, &machine).unwrap(), &machine).remove(0).text;
    fs::write(folder.join("1.nc"), text).unwrap();
    let entry = |x: f64| {
        let lying = |x: f64, corners: Vec<DVec2>| -> Vec<[f64; 2]> {
            corners.iter().map(|p| [p.x + x, p.y + 20.0]).collect()
        };
        let outlines = [lying(20.0, corners(200.0, 150.0)), lying(x, corners(180.0, 160.0))];
        json!([{ "file": "1.nc", "outlines": outlines, "tool_diameter": 6.0, "thickness": 12.0, "floor": -12.4 }])
    };
    assert!(judged(&folder, &entry(240.0)).good);
    let moved = judged(&folder, &entry(240.2));
    assert!(!moved.good && moved.faults.contains("off its outline"), "{}", moved.faults);
}

fn bytes_of(made: &Outputs, path: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    made.files.iter().find(|file| file.path == path).unwrap().write(&mut bytes).unwrap();
    bytes
}

#[test]
fn ezdxf_reads_every_board_where_it_lies() {
    use crate::drawings::{closed, judged, polylines_on};
    let folder = scratch("sheet-drawings");
    let made = outputs(&analysis_of(&example_text("shell")), &Selection::of(&[Format::Dxf]));
    assert!(made.diagnostics.is_empty(), "{:?}", made.diagnostics);
    let nest = &made.nests.sheets[0];
    let mut expected = Vec::new();
    for (place, name) in nest.names.iter().enumerate() {
        let bytes = bytes_of(&made, &format!("sheets/{name}.dxf"));
        fs::write(folder.join(format!("{name}.dxf")), &bytes).unwrap();
        let text = String::from_utf8(bytes).unwrap();
        let here: Vec<_> = nest.nested.placements.iter().filter(|placed| placed.sheet == place).collect();
        let cut: Vec<Value> = here
            .iter()
            .map(|placed| {
                let corners: Vec<DVec2> =
                    nest.parts[placed.part].outline.iter().map(|&p| placed.put(p)).collect();
                closed(&corners)[0].clone()
            })
            .collect();
        let board = [(0.0, 0.0), (2500.0, 0.0), (2500.0, 1250.0), (0.0, 1250.0)].map(DVec2::from);
        let engraved = polylines_on(&text, "ENGRAVE T2 engraver 0.4mm");
        assert!(engraved.as_array().unwrap().len() > 5 * here.len(), "{name}: not all is engraved");
        let design = polylines_on(&text, "DESIGN");
        assert_eq!(design.as_array().unwrap().len(), here.len());
        let design: Vec<Value> = design
            .as_array()
            .unwrap()
            .iter()
            .map(|line| json!({ "points": line["points"], "closed": true }))
            .collect();
        let addresses: Vec<&str> =
            here.iter().map(|placed| nest.named[placed.part].address.as_str()).collect();
        expected.push(json!({
            "file": format!("{name}.dxf"), "texts": addresses,
            "polylines": {
                "SHEET": closed(&board), "DESIGN": design, "CUT T1 straight cutter 12.5mm": cut,
                "ENGRAVE T2 engraver 0.4mm": engraved,
            },
        }));
    }
    let verdict = judged(&folder, &expected);
    assert!(verdict.good, "{}", verdict.faults);
    assert_eq!(verdict.counts["drawings"], 8);
}
