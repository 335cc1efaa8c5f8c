//! Good programs pass, also of random parts on random machines; every kind of fault is found when it is seeded.

mod random;
mod seeded;
mod sheets;

use super::*;
use crate::export::nc;
use crate::fabricate::cut_job::CutJob;
use crate::fabricate::machine::tests::router;
use crate::fabricate::machine::{CutDirection, Dialect, Fixing, Machine, MachineSpec, ZZero};
use crate::fabricate::toolpath::program;
use crate::fabricate::toolpath::tests::{panel, shaped};

/// The program of a job, its files one after the other, and what reading it back says.
fn made(job: &CutJob, spec: MachineSpec) -> (String, Result<Readback, Vec<Fault>>) {
    let machine = Machine::try_new(spec).unwrap();
    let program = program(job, &machine).unwrap();
    let files = nc::write(&program, &machine);
    let expected = Expected::new(job, &machine);
    let apart = |(a, b): (&DVec2, &DVec2)| a.distance(*b);
    let placed = expected.parts[0].outline.iter().zip(&program.parts[0].outline);
    assert!(placed.map(apart).all(|d| d < 1e-9));
    let result = read_back_set(&texts(&files), &expected);
    (files.into_iter().map(|file| file.text).collect(), result)
}

fn texts(files: &[nc::NcFile]) -> Vec<NcText<'_>> {
    files.iter().map(|file| NcText { tool: file.tool, text: &file.text }).collect()
}

fn good(job: &CutJob, spec: MachineSpec) -> Readback {
    let (text, result) = made(job, spec);
    result.unwrap_or_else(|faults| {
        panic!("{text}\n{}", faults.iter().map(|f| format!("{f}\n")).collect::<String>())
    })
}

#[test]
fn a_panel_reads_back_as_itself() {
    let read = good(&panel(), router());
    assert_eq!(read.parts[0].engraved, "shell-07-12");
    assert_eq!(read.parts[0].outline.len(), 4);
    assert!(read.parts[0].deviation < 0.002, "{}", read.parts[0].deviation);
}

#[test]
fn slender_planks_and_small_boards_pass() {
    good(&shaped(&[(0.0, 0.0), (400.0, 0.0), (380.0, 120.0), (15.0, 120.0)]), router());
    good(&shaped(&[(0.0, 0.0), (1200.0, 0.0), (1150.0, 120.0), (80.0, 120.0)]), router());
    let mut small = shaped(&[(0.0, 0.0), (60.0, 0.0), (62.0, 55.0), (3.0, 58.0)]);
    small.engraving.least_height = 3.0;
    good(&small, router());
}

#[test]
fn both_zeros_directions_and_one_tool_pass() {
    let vary: [fn(&mut MachineSpec); 12] = [
        |m| m.fixing = Fixing::Tabs { count: 4, width: 8.0, height: 3.0 },
        |m| m.fixing = Fixing::Tabs { count: 12, width: 5.0, height: 9.0 },
        |m| m.fixing = Fixing::OnionSkin { thickness: 0.4 },
        |m| m.allowance = 0.5,
        |m| (m.allowance, m.direction) = (2.0, CutDirection::Conventional),
        |m| (m.allowance, m.fixing) = (0.3, Fixing::Tabs { count: 3, width: 8.0, height: 4.0 }),
        |m| m.dialect = Dialect::Fanuc,
        |m| (m.dialect, m.engraver, m.tools[0].diameter) = (Dialect::Grbl, 1, 2.0),
        |m| m.z_zero = ZZero::Table,
        |m| m.direction = CutDirection::Conventional,
        |m| (m.engraver, m.tools[0].diameter) = (1, 2.0),
        |m| (m.stock_margin, m.cut_through) = (0.0, 0.0),
    ];
    for change in vary {
        let mut spec = router();
        change(&mut spec);
        good(&panel(), spec);
    }
}

#[test]
fn climb_keeps_the_part_on_the_right() {
    // All arcs but the one that leads away.
    let turns = |spec: MachineSpec| {
        let read = good(&panel(), spec);
        let arcs = read.moves.iter().filter_map(|m| match m.motion {
            Motion::Arc { clockwise, .. } => Some(clockwise),
            _ => None,
        });
        arcs.collect::<Vec<bool>>()
    };
    assert_eq!(turns(router()), [[true; 12].as_slice(), &[false]].concat());
    let other = MachineSpec { direction: CutDirection::Conventional, ..router() };
    assert_eq!(turns(other), [[false; 12].as_slice(), &[true]].concat());
}

#[test]
fn gently_curved_outlines_pass() {
    // A plank bent inwards on one side: 30 inner corners of half a degree, and as many nearly straight outer ones.
    let bow =
        |i: i32, sag: f64| (f64::from(i) * 20.0, sag * libm::sin(f64::from(i) / 30.0 * std::f64::consts::PI));
    let lower = (0..=30).map(|i| bow(i, 25.0));
    let upper = (0..=30).rev().map(|i| bow(i, 40.0)).map(|(x, y)| (x, y + 120.0));
    let read = good(&shaped(&lower.chain(upper).collect::<Vec<_>>()), router());
    assert!(read.parts[0].deviation < 0.01, "{}", read.parts[0].deviation);
    // A circle of 400 corners, each turning by 0.9 degrees.
    let circle = (0..400).map(|i| f64::from(i) * std::f64::consts::TAU / 400.0);
    good(
        &shaped(&circle.map(|a| (150.0 * libm::cos(a), 150.0 * libm::sin(a))).collect::<Vec<_>>()),
        router(),
    );
}

#[test]
fn every_pair_of_characters_decodes() {
    let all: Vec<char> = crate::fabricate::engrave::characters().collect();
    let mut job = shaped(&[(0.0, 0.0), (2000.0, 0.0), (2000.0, 200.0), (0.0, 200.0)]);
    for &first in &all {
        job.alias = all.iter().flat_map(|&second| [first, second]).collect();
        assert_eq!(good(&job, router()).parts[0].engraved, job.alias);
    }
    job.alias = "a b  c/0-O 1Il".to_owned();
    assert_eq!(good(&job, router()).parts[0].engraved, job.alias);
}

#[test]
fn hostile_names_stay_in_comments() {
    let mut job = panel();
    job.design = "a) G0 Z-50\nM30 (\u{1f332} {29}".to_owned();
    job.address = "x".repeat(300);
    job.notes = vec!["MSG, (hello) ; % { ! ? ~ $H [5d] a_B".to_owned(), String::new()];
    for dialect in Dialect::ALL {
        good(&job, MachineSpec { dialect, ..router() });
    }
}

#[test]
fn codes_are_unique_and_every_kind_has_one() {
    let mut codes: Vec<&str> = FAULTS.iter().map(|row| row.1).collect();
    codes.sort_unstable();
    codes.dedup();
    assert_eq!(codes.len(), FAULTS.len());
    for (kind, code, property) in FAULTS {
        assert_eq!((kind.code(), kind.property()), (code, property));
    }
}

#[test]
fn any_text_is_answered() {
    let (job, machine) = (panel(), Machine::try_new(router()).unwrap());
    let expected = Expected::new(&job, &machine);
    let deep = format!("G1 X{}\n", "9".repeat(400));
    for text in [
        "",
        "\n",
        "(",
        "G",
        "G1 X1.000 Y1.000",
        "M2\n",
        "G2 X1.000\nG1 Z1.000\n",
        "\u{0}\u{fffd}\n",
        deep.as_str(),
    ] {
        assert!(!read_back(text, &expected).unwrap_err().is_empty());
    }
}
