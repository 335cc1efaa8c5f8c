//! One seeded fault for every kind: a good program is changed in one place, and that kind is reported.

use super::*;
use crate::fabricate::machine::{Clamp, Dialect, Fixing};

/// How a good program is spoilt, and what is broken then.
struct Seed {
    kind: FaultKind,
    spoil: fn(&str) -> String,
}

/// Replaces the first `from`; it must be there.
fn swap(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "the program has no {from:?}");
    text.replacen(from, to, 1)
}

/// The place after which the contour begins.
fn in_contour(text: &str, change: impl Fn(&str) -> String) -> String {
    let at = text.find("(outer contour").unwrap();
    format!("{}{}", &text[..at], change(&text[at..]))
}

/// Rewrites the first line that begins so.
fn line(text: &str, begins: &str, change: impl Fn(&str) -> String) -> String {
    let mut done = false;
    let rewrite = |l: &str| {
        if done || !l.starts_with(begins) {
            return format!("{l}\n");
        }
        done = true;
        change(l)
    };
    let out: String = text.lines().map(rewrite).collect();
    assert!(done, "the program has no line {begins:?}");
    out
}

#[rustfmt::skip]
const SEEDS: &[Seed] = &[
    Seed { kind: FaultKind::NotAscii, spoil: |t| swap(t, "alias: shell", "alias: sh\u{e9}ll") },
    Seed { kind: FaultKind::NotAscii, spoil: |t| t.replace('\n', "\r\n") },
    Seed { kind: FaultKind::NotAscii, spoil: |t| t.trim_end().to_owned() },
    Seed { kind: FaultKind::LineLength, spoil: |t| format!("(address: {})\n{t}", "x".repeat(70)) },
    Seed { kind: FaultKind::Syntax, spoil: |t| swap(t, "Z20.000", "Z2e1") },
    Seed { kind: FaultKind::Syntax, spoil: |t| swap(t, "Z0.000", "Z-0.000") },
    Seed { kind: FaultKind::Syntax, spoil: |t| swap(t, "(engraving", "((engraving") },
    Seed { kind: FaultKind::Word, spoil: |t| swap(t, "M5", "M8") },
    Seed { kind: FaultKind::Word, spoil: |t| swap(t, "G40", "G41") },
    Seed { kind: FaultKind::Word, spoil: |t| swap(t, "Z20.000", "Z20.000 Z25.000") },
    Seed { kind: FaultKind::Modes, spoil: |t| swap(t, " G90", "") },
    Seed { kind: FaultKind::Modes, spoil: |t| swap(t, " G54", " G55") },
    Seed { kind: FaultKind::Modes, spoil: |t| swap(t, "(outer", "G55\n(outer") },
    Seed { kind: FaultKind::FirstMotion, spoil: |t| swap(t, "G0 Z20.000\n", "") },
    Seed { kind: FaultKind::FirstMotion, spoil: |t| swap(t, "G0 Z20.000\n", "G0 X1.000 Y1.000\nG0 Z20.000\n") },
    Seed { kind: FaultKind::UnknownPosition, spoil: |t| line(t, "G0 X", |_| String::new()) },
    Seed { kind: FaultKind::RapidBelowSafe, spoil: |t| swap(t, "G1 Z1.000", "G0 Z1.000") },
    Seed { kind: FaultKind::RapidBelowSafe, spoil: |t| swap(t, "G1 Z2.000\nG1 X", "G1 Z2.000\nG0 X") },
    Seed { kind: FaultKind::RapidMixesAxes, spoil: |t| line(t, "G0 X", |l| format!("{l} Z25.000\n")) },
    Seed { kind: FaultKind::FeedMissing, spoil: |t| swap(t, "Z1.000 F3000.000", "Z1.000") },
    Seed { kind: FaultKind::FeedRange, spoil: |t| in_contour(t, |t| swap(t, "F4000.000", "F4001.000")) },
    Seed { kind: FaultKind::PlungeRange, spoil: |t| swap(t, "Z-0.400 F600.000", "Z-0.400 F3000.000") },
    Seed { kind: FaultKind::SpindleOff, spoil: |t| swap(t, "S18000.000 M3", "S18000.000") },
    Seed { kind: FaultKind::SpindleOff, spoil: |t| in_contour(t, |t| format!("M5\n{t}")) },
    Seed { kind: FaultKind::SpindleRange, spoil: |t| swap(t, "S18000.000", "S60000.000") },
    Seed { kind: FaultKind::SpindleRange, spoil: |t| swap(t, "S18000.000", "S100.000") },
    Seed { kind: FaultKind::SpindleSpinUp, spoil: |t| swap(t, "G4 P3.000", "G4 P0.003") },
    Seed { kind: FaultKind::SpindleSpinUp, spoil: |t| in_contour(t, |t| format!("M5\nS18000.000 M3\n{t}")) },
    Seed { kind: FaultKind::ToolNotLoaded, spoil: |t| swap(t, "T2 M6\nG43 H2\n", "") },
    Seed { kind: FaultKind::ToolNotLoaded, spoil: |t| swap(t, "T1 M6\nG43 H1\n", "T9 M6\nG43 H9\n") },
    Seed { kind: FaultKind::ToolChange, spoil: |t| swap(t, "M5\nT1", "T1") },
    Seed { kind: FaultKind::ToolChange, spoil: |t| swap(t, "G0 Z20.000\nM5\nT1", "M5\nT1") },
    Seed { kind: FaultKind::ToolLength, spoil: |t| swap(t, "G43 H1", "G43 H2") },
    Seed { kind: FaultKind::ToolLength, spoil: |t| swap(t, "G43 H1\n", "") },
    Seed { kind: FaultKind::Envelope, spoil: |t| in_contour(t, |t| line(t, "G1 X", |_| "G1 X-1.000 Y20.000\n".to_owned())) },
    Seed { kind: FaultKind::Envelope, spoil: |t| swap(t, "M2", "G0 Z500.000\nM2") },
    Seed { kind: FaultKind::TooDeep, spoil: |t| t.replace("Z-12.500", "Z-12.600") },
    Seed { kind: FaultKind::StepDown, spoil: |t| t.replace("Z-4.167", "Z-6.000") },
    Seed { kind: FaultKind::StepDown, spoil: |t| in_contour(t, |t| t.replace("Z-4.167", "Z-12.500")) },
    Seed { kind: FaultKind::ArcRadii, spoil: |t| line(t, "G2 ", |l| format!("{} I1.000 J5.000\n", l.split(" I").next().unwrap())) },
    Seed { kind: FaultKind::Gouge, spoil: |t| in_contour(t, |t| line(t, "G1 X", |_| "G1 X150.000 Y200.000 Z-4.167\n".to_owned())) },
    Seed { kind: FaultKind::Uncut, spoil: |t| t.replace("X13.004", "X12.904") },
    Seed { kind: FaultKind::Uncut, spoil: |t| t.replace("Z-12.500", "Z-12.000") },
    Seed { kind: FaultKind::OutlineOpen, spoil: |t| t.replace("Z-12.500", "Z-12.000") },
    Seed { kind: FaultKind::EngravingOutside, spoil: |t| line(t, "G1 X", |_| "G1 X17.000 Y100.000 Z-0.400\n".to_owned()) },
    Seed { kind: FaultKind::EngravingDepth, spoil: |t| swap(t, "Z-0.400", "Z-0.900") },
    Seed { kind: FaultKind::EngravingText, spoil: |t| swap(t, "Z-0.400", "Z0.400") },
    Seed { kind: FaultKind::EngravingMark, spoil: |t| before(t, "G0 Z20.000\nM5\nT1", drop_last_stroke) },
    Seed { kind: FaultKind::EngravingOrder, spoil: |t| swapped_operations(t) },
    Seed { kind: FaultKind::EndHeight, spoil: |t| swap(t, "G0 Z20.000\nM5\nM2", "M5\nM2") },
    Seed { kind: FaultKind::SpindleOnAtEnd, spoil: |t| swap(t, "M5\nM2", "M2") },
    Seed { kind: FaultKind::ProgramEnd, spoil: |t| swap(t, "M2\n", "") },
    Seed { kind: FaultKind::ProgramEnd, spoil: |t| swap(t, "M2\n", "M2\nM2\n") },
    Seed { kind: FaultKind::ProgramEnd, spoil: |t| swap(t, "M2\n", "M2\nM5\n") },
    Seed { kind: FaultKind::Header, spoil: |t| swap(t, "(address: shell.7-12)", "(address: shell.7-13)") },
    Seed { kind: FaultKind::Header, spoil: |t| swap(t, "top of stock", "table") },
    Seed { kind: FaultKind::Header, spoil: |t| swap(t, "(stock: 294", "(stock: 300") },
    Seed { kind: FaultKind::Header, spoil: |t| swap(t, "3.250 deg", "3.350 deg") },
    Seed { kind: FaultKind::Extents, spoil: |t| swap(t, "(swept x: 10.00", "(swept x: 10.01") },
    Seed { kind: FaultKind::Extents, spoil: |t| swap(t, "(swept z:", "(swept w:") },
];

fn before(text: &str, mark: &str, change: impl Fn(&str) -> String) -> String {
    let at = text.find(mark).unwrap();
    format!("{}{}", change(&text[..at]), &text[at..])
}

fn drop_last_stroke(text: &str) -> String {
    text[..text.rfind("G1 Z2.000").unwrap()].to_owned()
}

/// Contour first, engraving second.
fn swapped_operations(text: &str) -> String {
    let (first, second) = (text.find("T2 M6").unwrap(), text.find("T1 M6").unwrap());
    let end = text.find("M2\n").unwrap();
    format!("{}{}{}{}", &text[..first], &text[second..end], &text[first..second], &text[end..])
}

/// A machine and the seeds for its program.
type Group = (fn() -> MachineSpec, &'static [Seed]);

/// Seeds for programs of other machines.
#[rustfmt::skip]
const OTHERS: &[Group] = &[
    (router, &[
        Seed { kind: FaultKind::Comment, spoil: |t| swap(t, "(engraving", "(engr%ving") },
        Seed { kind: FaultKind::Header, spoil: |t| swap(t, "diameter 6.000", "diameter 8.000") },
        Seed { kind: FaultKind::Header, spoil: |t| swap(t, "(at: 16.000", "(at: 17.000") },
        Seed { kind: FaultKind::Header, spoil: |t| swap(t, "held by the table", "tabs") },
        Seed { kind: FaultKind::Word, spoil: |t| swap(t, "Z20.000", "Z20") },
        Seed { kind: FaultKind::Word, spoil: |t| swap(t, "T2 M6", "T2.000 M6") },
        // The lead away from the contour the other way around its circle: into full stock.
        Seed { kind: FaultKind::StepDown, spoil: |t| line(t, "G3", |l| l.replacen("G3", "G2", 1) + "\n") },
    ]),
    (with_tabs, &[
        Seed { kind: FaultKind::Tabs, spoil: |t| t.replace("Z-9.000", "Z-12.500") },
        Seed { kind: FaultKind::OutlineOpen, spoil: |t| t.replace("Z-9.000", "Z-8.500") },
        Seed { kind: FaultKind::Tabs, spoil: |t| first_tab(t, |_| String::new()) },
        Seed { kind: FaultKind::Tabs, spoil: |t| first_tab(t, |lines| format!("G1 Z-9.000\n{}", narrower(lines[1])) + "\nG1 Z-12.500 F1200.000\n") },
        Seed { kind: FaultKind::Tabs, spoil: |t| swap(t, "G0 Z20.000\nM5\nM2", &through_a_tab(t)) },
        // All around at the tabs' height.
        Seed { kind: FaultKind::Tabs, spoil: |t| t.replace("Z-12.500", "Z-9.000") },
        Seed { kind: FaultKind::Header, spoil: |t| swap(t, "width 8.000", "width 9.000") },
    ]),
    (with_skin, &[
        Seed { kind: FaultKind::TooDeep, spoil: |t| t.replace("Z-11.600", "Z-12.000") },
        Seed { kind: FaultKind::OutlineOpen, spoil: |t| t.replace("Z-11.600", "Z-11.500") },
    ]),
    (finished, &[
        Seed { kind: FaultKind::Uncut, spoil: without_finishing },
        Seed { kind: FaultKind::StepDown, spoil: |t| in_contour(t, |t| t.replace("Z-4.167", "Z-12.500")) },
    ]),
    (clamped, &[
        Seed { kind: FaultKind::Clamp, spoil: |t| in_contour(t, |t| line(t, "G1 X", |_| "G1 X5.000 Y120.000 Z5.000\n".to_owned())) },
        Seed { kind: FaultKind::Clamp, spoil: |t| swap(t, "G0 Z20.000\nM5\nM2", "G1 X7.000 Y120.000\nG0 Z20.000\nM5\nM2") },
    ]),
    (fanuc, &[
        Seed { kind: FaultKind::ProgramFrame, spoil: |t| swap(t, "%\n", "") },
        Seed { kind: FaultKind::ProgramFrame, spoil: |t| swap(t, "M30\n%\n", "M30\n") },
        Seed { kind: FaultKind::ProgramFrame, spoil: |t| swap(t, "O0001", "O0002") },
        Seed { kind: FaultKind::ProgramFrame, spoil: |t| swap(t, "M5\n", "M5\nO0001\n") },
        Seed { kind: FaultKind::ProgramEnd, spoil: |t| swap(t, "M30\n", "") },
        Seed { kind: FaultKind::ProgramEnd, spoil: |t| swap(t, "M30\n", "M30\nM5\n") },
        Seed { kind: FaultKind::Word, spoil: |t| swap(t, "M30", "M2") },
        Seed { kind: FaultKind::Word, spoil: |t| swap(t, "G4 P3000", "G4 P3.000") },
        Seed { kind: FaultKind::Word, spoil: |t| swap(t, "S18000 M3", "S18000.000 M3") },
        Seed { kind: FaultKind::SpindleSpinUp, spoil: |t| swap(t, "G4 P3000", "G4 P3") },
        Seed { kind: FaultKind::ToolLength, spoil: |t| swap(t, " G43 H1", "") },
        Seed { kind: FaultKind::Comment, spoil: |t| swap(t, "(ADDRESS: SHELL.7-12)", "(ADDRESS: shell.7-12)") },
        Seed { kind: FaultKind::Header, spoil: |t| swap(t, "(ADDRESS: SHELL.7-12)", "(ADDRESS: SHELL.7-13)") },
    ]),
];

fn with_tabs() -> MachineSpec {
    MachineSpec { fixing: Fixing::Tabs { count: 4, width: 8.0, height: 3.0 }, ..router() }
}

fn with_skin() -> MachineSpec {
    MachineSpec { fixing: Fixing::OnionSkin { thickness: 0.4 }, ..router() }
}

fn finished() -> MachineSpec {
    MachineSpec { allowance: 0.5, ..router() }
}

fn clamped() -> MachineSpec {
    let clamp = Clamp { low: DVec2::new(0.0, 100.0), high: DVec2::new(6.0, 140.0), height: 10.0 };
    MachineSpec { clamps: vec![clamp], ..router() }
}

fn fanuc() -> MachineSpec {
    MachineSpec { dialect: Dialect::Fanuc, ..router() }
}

fn grbl() -> MachineSpec {
    MachineSpec { dialect: Dialect::Grbl, ..router() }
}

/// The three lines over the first tab, up, over, down, replaced; what follows goes on from there.
fn first_tab(text: &str, change: impl Fn(&[&str]) -> String) -> String {
    let at = text.find("G1 Z-9.000\n").unwrap();
    let end = at + text[at..].match_indices('\n').nth(2).unwrap().0 + 1;
    let lines: Vec<&str> = text[at..end].lines().collect();
    let out = format!("{}{}{}", &text[..at], change(&lines), &text[end..]);
    assert_ne!(out, text);
    out
}

/// The line `G1 X… Y…` with its X 2 mm on; the first tab of the panel lies on a side along X.
fn narrower(over: &str) -> String {
    let x = over.split(['X', ' ']).nth(2).unwrap();
    let moved: f64 = x.parse::<f64>().unwrap() + 2.0;
    over.replacen(x, &format!("{moved:.3}"), 1)
}

/// At the end, once more over the first tab, at full depth.
fn through_a_tab(text: &str) -> String {
    let at = text.find("G1 Z-9.000\n").unwrap();
    let before = text[..at].trim_end().rsplit('\n').next().unwrap();
    let over = text[at..].lines().nth(1).unwrap();
    let xy = |line: &str| line.split(" F").next().unwrap().replacen("G1 ", "", 1);
    format!("G0 Z20.000\nG0 {}\nG1 Z-12.500 F1200.000\nG1 {}\nG0 Z20.000\nM5\nM2", xy(before), xy(over))
}

fn without_finishing(text: &str) -> String {
    let (from, to) = (text.find("(finishing pass)").unwrap(), text.rfind("G0 Z20.000").unwrap());
    format!("{}{}", &text[..from], &text[to..])
}

fn find(seeds: &[Seed], spec: MachineSpec) {
    let job = panel();
    let machine = Machine::try_new(spec).unwrap();
    let text = nc::write(&program(&job, &machine).unwrap(), &machine).remove(0).text;
    let expected = Expected::new(&job, &machine);
    read_back(&text, &expected).unwrap();
    for (i, seed) in seeds.iter().enumerate() {
        let spoilt = (seed.spoil)(&text);
        let faults = read_back(&spoilt, &expected).err().unwrap_or_else(|| panic!("seed {i} does not spoil"));
        let kinds: Vec<FaultKind> = faults.iter().map(|f| f.kind).collect();
        assert!(kinds.contains(&seed.kind), "seed {i}: no {:?} in {faults:?}", seed.kind);
    }
}

#[test]
fn every_kind_is_found_when_seeded() {
    find(SEEDS, router());
    OTHERS.iter().for_each(|(spec, seeds)| find(seeds, spec()));
}

#[test]
fn sets_of_files_are_judged_as_one() {
    let (job, machine) = (panel(), Machine::try_new(grbl()).unwrap());
    let files = nc::write(&program(&job, &machine).unwrap(), &machine);
    assert_eq!(files.iter().map(|file| file.tool).collect::<Vec<_>>(), [Some(2), Some(1)]);
    let expected = Expected::new(&job, &machine);
    let read = read_back_set(&texts(&files), &expected).unwrap();
    assert_eq!(read.parts[0].engraved, "shell-07-12");
    type Spoil = fn(&mut Vec<nc::NcFile>);
    let seeds: [(FaultKind, Spoil); 9] = [
        (FaultKind::FileSet, |f| drop(f.pop())),
        (FaultKind::Uncut, |f| drop(f.pop())),
        (FaultKind::FileSet, |f| f.reverse()),
        (FaultKind::EngravingOrder, |f| f.reverse()),
        (FaultKind::FileSet, |f| f[1].tool = Some(9)),
        (FaultKind::ToolNotLoaded, |f| f[1].tool = Some(9)),
        (FaultKind::Word, |f| f[1].text = swap(&f[1].text, "G0 Z20.000", "T1 M6\nG0 Z20.000")),
        (FaultKind::Comment, |f| f[1].text = swap(&f[1].text, "(outer", "(outer!")),
        (FaultKind::SpindleOff, |f| f[1].text = swap(&f[1].text, "S18000.000 M3\n", "")),
    ];
    for (kind, spoil) in seeds {
        let mut spoilt = files.clone();
        spoil(&mut spoilt);
        let faults = read_back_set(&texts(&spoilt), &expected).unwrap_err();
        assert!(faults.iter().any(|fault| fault.kind == kind), "no {kind:?} in {faults:?}");
    }
    let mut spoilt = files.clone();
    spoilt[1].text = swap(&files[1].text, "S18000.000", "S60000.000");
    let fault = read_back_set(&texts(&spoilt), &expected).unwrap_err().remove(0);
    let line = spoilt[1].text.lines().position(|l| l.starts_with("G1")).unwrap() + 1;
    assert_eq!((fault.tool, fault.line), (Some(1), line));
    assert!(
        fault.to_string().starts_with(&format!("file of tool 1, line {line}: spindle at 60000")),
        "{fault}"
    );
}

#[test]
fn every_kind_has_a_seed() {
    // Flutes and sets of files are checked by tests of their own, below and above.
    let own = [FaultKind::FluteLength, FaultKind::FileSet];
    let all = || SEEDS.iter().chain(OTHERS.iter().flat_map(|(_, seeds)| *seeds));
    for (kind, ..) in FAULTS {
        assert!(own.contains(&kind) || all().any(|seed| seed.kind == kind), "{kind:?}");
    }
}

#[test]
fn a_cut_deeper_than_the_flutes_is_found() {
    let (text, _) = made(&panel(), router());
    let mut spec = router();
    spec.tools[0].flute_length = 12.0;
    let (job, machine) = (panel(), Machine::try_new(spec).unwrap());
    let faults = read_back(&text, &Expected::new(&job, &machine)).unwrap_err();
    assert!(
        faults.iter().all(|f| f.kind == FaultKind::FluteLength && f.measured == Some(12.5)),
        "{faults:?}"
    );
}

#[test]
fn the_outline_is_judged_to_a_hundredth() {
    let (text, _) = made(&panel(), router());
    let machine = Machine::try_new(router()).unwrap();
    let verdict = |by: f64| {
        let mut job = panel();
        // The lower left of the box stays: only corner 2 moves.
        job.outline[2].y += by;
        let mut expected = Expected::new(&job, &machine);
        expected.stock = Expected::new(&panel(), &machine).stock;
        read_back(&text, &expected).map(|_| ()).map_err(|faults| faults[0].kind)
    };
    assert_eq!(verdict(0.007), Ok(()));
    assert_eq!(verdict(-0.007), Ok(()));
    assert_eq!(verdict(0.013), Err(FaultKind::Gouge));
    assert_eq!(verdict(-0.013), Err(FaultKind::Uncut));
}

#[test]
fn a_fault_says_where_and_how_much() {
    let (text, _) = made(&panel(), router());
    let (job, machine) = (panel(), Machine::try_new(router()).unwrap());
    let spoilt = swap(&text, "S18000.000", "S60000.000");
    let faults = read_back(&spoilt, &Expected::new(&job, &machine)).unwrap_err();
    let first_feed = text.lines().position(|l| l.starts_with("G1")).unwrap() + 1;
    assert_eq!((faults[0].line, faults[0].measured), (first_feed, Some(60000.0)));
    let said = faults[0].to_string();
    assert!(said.contains("spindle at 60000.000 rpm") && said.contains("[nc-spindle-range]"), "{said}");
}
