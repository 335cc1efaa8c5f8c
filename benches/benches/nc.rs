//! Programs of 1,000 boards, made, written and read back on one thread, against LinuxCNC's `rs274` reading 50 of them,
//! one process each: both in one run. The aim is a ratio below 1; nothing is asserted, since machines differ.

#![allow(
    clippy::expect_used,
    clippy::disallowed_methods,
    reason = "a race that cannot be run says why and ends; it reads clocks and programs"
)]

use std::fs;
use std::process::Command;

use glam::{DVec2, DVec3};
use ifs_benches::processes::{median, millis, root, run};
use ifs_compiler::export::nc;
use ifs_compiler::fabricate::cut_job::{CutJob, Engraving};
use ifs_compiler::fabricate::machine::{
    CutDirection, Dialect, Fixing, Machine, MachineSpec, Tool, WorkOffset, ZZero,
};
use ifs_compiler::fabricate::toolpath::program;
use ifs_compiler::readback::{Expected, NcText, read_back_set};

const BOARDS: usize = 1000;
const READ: usize = 50;

fn main() {
    let machine = machine();
    let jobs: Vec<CutJob> = (0..BOARDS).map(job).collect();
    let ours = median(5, || jobs.iter().for_each(|job| drop(made(job, &machine))));
    println!("{BOARDS} boards made, written and read back: {:.1} ms", millis(ours));
    let folder = root().join("target/nc-race");
    fs::create_dir_all(&folder).expect("a folder for the programs");
    let tools = folder.join("tools.tbl");
    fs::write(&tools, "T1 P1 Z0.0 D6.000\nT2 P2 Z0.0 D1.000\n").expect("a table of tools");
    let programs: Vec<_> = jobs.iter().take(READ).enumerate().collect();
    for (i, job) in &programs {
        fs::write(folder.join(format!("{i}.nc")), made(job, &machine)).expect("a program");
    }
    if Command::new("rs274").arg("-h").output().is_err() {
        println!("rs274 is not there: install LinuxCNC (Debian: linuxcnc-uspace) for the race");
        return;
    }
    let theirs = median(5, || {
        for (i, _) in &programs {
            let mut rs274 = Command::new("rs274");
            rs274.env("HOME", &folder).current_dir(&folder).arg("-t").arg(&tools).arg("-g");
            run(rs274.arg(folder.join(format!("{i}.nc"))));
        }
    });
    println!("rs274 reads {READ} of them: {:.1} ms", millis(theirs));
    println!("ratio: {:.2}", ours.as_secs_f64() / theirs.as_secs_f64());
}

fn made(job: &CutJob, machine: &Machine) -> String {
    let program = program(job, machine).expect("a board that can be cut");
    let files = nc::write(&program, machine);
    let texts: Vec<NcText<'_>> = files.iter().map(|f| NcText { tool: f.tool, text: &f.text }).collect();
    read_back_set(&texts, &Expected::new(job, machine)).expect("a good program");
    files.into_iter().map(|file| file.text).collect()
}

/// Quads of some 400 mm, no two the same.
fn job(i: usize) -> CutJob {
    let (a, b) = ((i % 37) as f64, (i % 23) as f64);
    let outline = [(0.0, 0.0), (400.0 + a, b), (390.0 - b, 360.0 + a), (-a, 350.0 + b)];
    CutJob {
        address: format!("shell.{i}"),
        alias: format!("shell-{:02}-{:02}", i / 32, i % 32),
        design: "shell".to_owned(),
        design_hash: "0123456789abcdef".to_owned(),
        outline: outline.map(DVec2::from).to_vec(),
        thickness: 12.0,
        engraving: Engraving { height: 12.0, least_height: 5.0, clearance: 4.0, mark_edge_0: true },
        face_up: "outer".to_owned(),
        notes: (0..4).map(|edge| format!("edge {edge}: bevel 3.25 deg not cut by this file")).collect(),
    }
}

fn machine() -> Machine {
    let tool = |number: u32, diameter: f64| Tool {
        number,
        name: format!("{diameter} mm"),
        diameter,
        flute_length: 40.0,
        feed: 60.0,
        plunge: 15.0,
        spindle: 300.0,
        max_step_down: 5.0,
    };
    Machine::try_new(MachineSpec {
        name: "router".to_owned(),
        envelope: DVec3::new(2500.0, 1250.0, 150.0),
        safe_height: 15.0,
        z_zero: ZZero::TopOfStock,
        work_offset: WorkOffset::G54,
        stock_margin: 8.0,
        cut_through: 0.4,
        engrave_depth: 0.4,
        spindle_range: (100.0, 400.0),
        spin_up: 2.0,
        direction: CutDirection::Climb,
        allowance: 0.0,
        fixing: Fixing::Held,
        clamps: Vec::new(),
        dialect: Dialect::LinuxCnc,
        tools: vec![tool(1, 6.0), tool(2, 1.0)],
        cutter: 1,
        engraver: 2,
    })
    .expect("a sound machine")
}
