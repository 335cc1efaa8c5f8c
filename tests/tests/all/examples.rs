//! The examples, built through the program: every file is what foreign programs take it for, the figures of all files
//! agree, and what the boards promise holds to the digits that are promised.
//!
//! [`REFEREES`] is the list of what each built folder is shown to; another referee is one more line. [`CUT`] are those whose
//! programs are run.
#![allow(clippy::disallowed_methods, reason = "the tests read what the program writes")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail anywhere")]

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use ifs_compiler::analysis::{Elements, PanelsMade, PlanksMade};
use ifs_compiler::geometry::Diagonal;
use ifs_tests::designs::{analysis_of, example_path, example_text, examples};
use ifs_tests::outcome::run;
use ifs_tests::programs::expected_program;
use ifs_tests::referees::{Verdict, gltf_validator, python_referee};
use ifs_tests::{program, scratch};
use serde_json::Value;

/// An example as it was built.
struct Built {
    name: String,
    folder: PathBuf,
    /// What the program printed: the table.
    table: String,
    report: Value,
}

/// A referee of a built folder; none where the folder has nothing for it.
type Referee = fn(&Built) -> Option<Verdict>;

/// The examples whose programs LinuxCNC's interpreter runs, each board by itself: boards and planks, open and closed, a
/// model. The program reads back all others before it writes them, too.
const CUT: &[&str] = &["model", "ring", "saddle", "shell", "vault"];

/// What every built folder is shown to.
const REFEREES: &[(&str, Referee)] = &[
    ("Khronos' glTF validator", |built| Some(gltf_validator(&[&built.folder.join("model.glb")]))),
    ("trimesh", |built| {
        let least = parts(&built.report).len().to_string();
        let arguments = ["--least", &least].map(Path::new);
        Some(python_referee("glb_trimesh.py", &[&built.folder.join("model.glb"), arguments[0], arguments[1]]))
    }),
    ("csv, json and hashlib", |built| Some(python_referee("outputs.py", &[&built.folder]))),
    ("numpy and shapely", |built| {
        (!parts(&built.report).is_empty()).then(|| python_referee("figures.py", &[&built.folder]))
    }),
    ("trimesh and scipy", |built| {
        (!parts(&built.report).is_empty()).then(|| python_referee("boards.py", &[&built.folder]))
    }),
    ("Python's XML parser", |built| Some(python_referee("report_page.py", &[&built.folder]))),
    ("LinuxCNC's rs274 and shapely", |built| {
        if !CUT.contains(&built.name.as_str()) {
            return None;
        }
        let listing = built.folder.with_extension("programs.json");
        fs::write(&listing, Value::from(expected_programs(built)).to_string()).unwrap();
        Some(python_referee("nc.py", &[&built.folder.join("boards"), &listing]))
    }),
];

/// What each program must cut, out of the analysis.
fn expected_programs(built: &Built) -> Vec<Value> {
    let analysis = analysis_of(&example_text(&built.name));
    let parts = analysis.fabrications.iter().flat_map(|made| match &made.elements {
        Elements::Panels(made) => made
            .panels
            .iter()
            .map(|panel| (&panel.label.address, &panel.outline, panel.thickness))
            .collect::<Vec<_>>(),
        Elements::Planks(made) => {
            made.planks.iter().map(|plank| (&plank.label.address, &plank.outline, plank.width)).collect()
        }
    });
    let listed: Vec<Value> = parts
        .map(|(address, outline, thickness)| {
            expected_program(&built.folder.join("boards"), address, outline, thickness)
        })
        .collect();
    assert!(!listed.is_empty(), "{}: no boards", built.name);
    listed
}

/// All examples, built once for all tests here.
fn built() -> &'static [Built] {
    static BUILT: OnceLock<Vec<Built>> = OnceLock::new();
    BUILT.get_or_init(|| {
        let out = scratch("examples");
        examples().into_iter().map(|name| build(name, &out)).collect()
    })
}

fn build(name: String, out: &Path) -> Built {
    let folder = out.join(&name);
    let table = run(program().arg("build").arg(example_path(&name)).arg("-o").arg(&folder)).good();
    let report = serde_json::from_str(&fs::read_to_string(folder.join("report.json")).unwrap()).unwrap();
    Built { name, folder, table, report }
}

fn example(name: &str) -> &'static Built {
    built().iter().find(|built| built.name == name).unwrap()
}

/// The parts of all fabrications.
fn parts(report: &Value) -> Vec<&Value> {
    let made = report["fabrications"].as_array().unwrap();
    made.iter().flat_map(|made| made["parts"].as_array().unwrap()).collect()
}

#[test]
fn foreign_programs_take_every_file() {
    std::thread::scope(|scope| {
        for (referee, judge) in REFEREES {
            scope.spawn(move || judge_all(referee, *judge));
        }
    });
}

fn judge_all(referee: &str, judge: Referee) {
    let mut judged = 0;
    for built in built() {
        let Some(verdict) = judge(built) else { continue };
        println!("{}, {referee}: {}", built.name, verdict.counts);
        assert!(verdict.good, "{}, {referee}:\n{}", built.name, verdict.faults);
        judged += 1;
    }
    assert!(judged >= CUT.len(), "{referee} has seen {judged} examples only");
}

#[test]
fn the_model_says_its_scale_and_is_that_much_smaller() {
    let model = example("model");
    assert!(model.table.contains("1:20"), "{}", model.table);
    let made = &model.report["fabrications"][0];
    assert_eq!(made["scale"].as_f64(), Some(0.05));
    let list = fs::read_to_string(model.folder.join("cutlist.csv")).unwrap();
    assert!(list.lines().next().unwrap().ends_with(",status,scale"), "{list}");
    assert!(list.lines().skip(1).all(|row| row.ends_with(",made,0.050000")), "{list}");
    // What is worked out for the building, with the same text but for the scale, is twenty times as large.
    let text = example_text("model");
    let building = text.replace("    scale:    scale\n", "").replace("in 20mm .. 30mm", "in 400mm .. 600mm");
    let building = building.replace("300mm by 200mm", "3000mm by 2000mm");
    assert_eq!(text.lines().count(), building.lines().count() + 1);
    let Elements::Panels(building) = &analysis_of(&building).fabrications[0].elements else {
        panic!("panels");
    };
    let small = panels("model").panels;
    assert_eq!(small.len(), building.panels.len());
    for (small, large) in small.iter().zip(&building.panels) {
        for side in 0..4 {
            assert!((20.0 * small.edges[side] - large.edges[side]).abs() <= 1e-6, "{}", small.label.address);
        }
        assert!((small.planarity - large.planarity).abs() <= 1e-9);
        assert_eq!(small.thickness, large.thickness);
    }
}

#[test]
fn the_figures_referee_refuses_other_figures() {
    let folder = scratch("examples-changed");
    let change = |name: &str, file: &str, from: &str, to: &str| {
        let copy = folder.join(name);
        fs::create_dir_all(&copy).unwrap();
        for entry in fs::read_dir(&example(name).folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_file() {
                fs::copy(&path, copy.join(path.file_name().unwrap())).unwrap();
            }
        }
        let text = fs::read_to_string(copy.join(file)).unwrap();
        assert!(text.contains(from), "{from:?} is not in {name}/{file}");
        fs::write(copy.join(file), text.replacen(from, to, 1)).unwrap();
        let verdict = python_referee("figures.py", &[&copy]);
        assert!(!verdict.good, "{name}/{file} with {to:?} for {from:?} was taken");
        verdict.faults
    };
    let shell = parts(&example("shell").report)[40];
    let edge = shell["edges_mm"][1].to_string();
    let moved = format!("{:.3}", edge.parse::<f64>().unwrap() + 0.01);
    let faults = change("shell", "cutlist.csv", &format!(",{edge},"), &format!(",{moved},"));
    assert!(faults.contains("edge"), "{faults}");
    let worst = example("shell").report["fabrications"][0]["planarity"]["after"]["worst_planarity"].clone();
    let stated = format!("\"value\": {},", worst["value"]);
    let faults = change("shell", "report.json", &stated, "\"value\": 0.999999999,");
    assert!(faults.contains("worst_planarity"), "{faults}");
    let mitre = parts(&example("vault").report)[5]["mitres_deg"][1].to_string();
    let other = format!("{:.4}", mitre.parse::<f64>().unwrap() + 0.01);
    let faults = change("vault", "cutlist.csv", &format!(",{mitre},"), &format!(",{other},"));
    assert!(faults.contains("mitre"), "{faults}");
}

#[test]
fn the_table_names_elements_sizes_and_planarity() {
    let shell = example("shell");
    let planarity = &shell.report["fabrications"][0]["planarity"];
    let words = |when: &str| {
        let (worst, mean) =
            (&planarity[when]["worst_planarity"]["value"], &planarity[when]["mean_planarity"]);
        format!("worst {:.6}, mean {:.6}", worst.as_f64().unwrap(), mean.as_f64().unwrap())
    };
    for part in [
        "256 boards of birch plywood, 12 mm".to_owned(),
        format!("as designed: {}", words("before")),
        format!("planarized:  {}", words("after")),
        "planarity at least 0.9998: holds for 256".to_owned(),
        shell.folder.display().to_string(),
    ] {
        assert!(shell.table.contains(&part), "no {part:?} in:\n{}", shell.table);
    }
    let vault = example("vault");
    let lengths = parts(&vault.report).into_iter().map(|part| part["length_mm"].as_f64().unwrap());
    let (least, most) = lengths.fold((f64::MAX, 0.0_f64), |(least, most), x| (least.min(x), most.max(x)));
    for part in
        ["80 planks of sawn spruce, 120 mm by 27 mm", &format!("{least:.1} to {most:.1} mm"), "mitres"]
    {
        assert!(vault.table.contains(part), "no {part:?} in:\n{}", vault.table);
    }
    for built in built() {
        let files = ifs_tests::designs::contents(&built.folder).len();
        assert!(built.table.contains(&format!("{files} in ")), "{files} files, but:\n{}", built.table);
    }
}

#[test]
fn the_shell_is_planarized_and_the_report_shows_before_and_after() {
    let made = &example("shell").report["fabrications"][0];
    let worst = |when: &str| made["planarity"][when]["worst_planarity"]["value"].as_f64().unwrap();
    let mean = |when: &str| made["planarity"][when]["mean_planarity"].as_f64().unwrap();
    println!("worst {} to {}, mean {} to {}", worst("before"), worst("after"), mean("before"), mean("after"));
    assert!(worst("before") < 0.9998, "nothing to planarize: the example shows nothing");
    assert!(worst("after") >= 0.9998);
    assert!(mean("after") > mean("before"));
    assert_eq!((&made["counts"]["made"], &made["counts"]["refused"]), (&256.into(), &0.into()));
    let history = made["planarity"]["planarize"]["history"].as_array().unwrap();
    assert_eq!(history[0]["worst"].as_f64(), Some(worst("before")));
    assert!(history.iter().any(|point| point["worst"].as_f64() == Some(worst("after"))));
    assert!(made["requirements"].as_array().unwrap().iter().all(|requirement| requirement["holds"] == true));
}

fn panels(name: &str) -> PanelsMade {
    match &analysis_of(&example_text(name)).fabrications[0].elements {
        Elements::Panels(panels) => panels.clone(),
        Elements::Planks(_) => panic!("{name} is made of planks"),
    }
}

fn planks(name: &str) -> PlanksMade {
    match &analysis_of(&example_text(name)).fabrications[0].elements {
        Elements::Planks(planks) => planks.clone(),
        Elements::Panels(_) => panic!("{name} is made of panels"),
    }
}

#[test]
fn unrolled_boards_keep_their_sides_and_their_diagonal() {
    let made = panels("shell");
    let mut worst = 0.0_f64;
    for panel in &made.panels {
        let [a, b, c, d] = panel.corners;
        let flat = &panel.outline;
        assert_eq!(flat.len(), 4);
        let mut keeps = |from: usize, to: usize, length: f64| {
            worst = worst.max((flat[from].distance(flat[to]) - length).abs());
        };
        for (side, length) in
            [a.distance(b), b.distance(c), c.distance(d), d.distance(a)].into_iter().enumerate()
        {
            keeps(side, (side + 1) % 4, length);
            assert_eq!(panel.edges[side], length, "{}", panel.label.address);
        }
        match panel.split {
            Diagonal::Ac => keeps(0, 2, a.distance(c)),
            Diagonal::Bd => keeps(1, 3, b.distance(d)),
        }
        let area: f64 = (0..4).map(|i| flat[i].perp_dot(flat[(i + 1) % 4]) / 2.0).sum();
        assert!(
            (area - panel.area).abs() <= 1e-9 * panel.area,
            "counter-clockwise, and of the two triangles' area"
        );
    }
    println!("greatest difference of a side or diagonal: {worst:e} mm over {} boards", made.panels.len());
    assert!(worst <= 1e-9);
}

#[test]
fn joints_of_neighbouring_planks_have_equal_and_opposite_mitres() {
    let made = planks("vault");
    let mut joints = 0;
    for (first, second) in made.planks.iter().zip(made.planks.iter().skip(1)) {
        let joined = first.neighbours[1].as_deref() == Some(second.label.address.as_str());
        assert_eq!(joined, second.neighbours[0].as_deref() == Some(first.label.address.as_str()));
        if !joined {
            // The ends of an arch are square.
            assert_eq!((first.mitres[1], second.mitres[0]), (0.0, 0.0));
            continue;
        }
        joints += 1;
        assert_eq!(
            first.mitres[1], -second.mitres[0],
            "{} and {}",
            first.label.address, second.label.address
        );
        assert!(first.mitres[1].abs() > 1e-3, "an arch turns at every joint");
        assert!(first.axis[1].distance(second.axis[0]) <= 1e-9);
    }
    assert_eq!(joints, 5 * 15);
}
