//! Programs: each is read back against its board in `report.json` (its drawing where there is one, for the decimals).
//! What the machine is like is not in the folder: its figures are those that most of its programs agree on.

use std::collections::{BTreeMap, BTreeSet};

use glam::{DVec2, DVec3};

use super::Listed;
use super::dxf::Drawing;
use super::finding::Findings;
use super::report::{Part, Report};
use super::vote::{most, most_number};
use crate::fabricate::cut_job::{CutJob, Engraving, MAX_CORNERS};
use crate::fabricate::machine::{
    CutDirection, Dialect, Fixing, Machine, MachineSpec, Tool, WorkOffset, ZZero,
};
use crate::readback::{Expected, Fault, Motion, Readback, read_back};

/// How far places in a program may be from those in a drawing, mm.
const NEAR: f64 = 0.0016;

/// Room between the deepest bevel and the engraving, mm.
const CLEAR_OF_BEVELS: f64 = 1.0;

/// A program, and what of it tells of its machine.
pub(super) struct Program {
    pub(super) path: String,
    address: String,
    pub(super) text: String,
    pub(super) header: BTreeMap<String, Vec<String>>,
    /// Figures by their letter and the tool that was loaded, in thousandths.
    words: BTreeMap<(u8, u32), BTreeSet<i64>>,
    tools: Vec<u32>,
    /// What every program of the machine repeats: lines without places.
    steady: Vec<String>,
}

/// Reads what a program says of itself.
pub(super) fn read(file: &Listed, text: &str, _findings: &mut Findings) -> Option<Program> {
    let mut program = Program {
        path: file.path.clone(),
        address: file.address.clone().unwrap_or_default(),
        text: text.to_owned(),
        header: header(text),
        words: BTreeMap::new(),
        tools: Vec::new(),
        steady: Vec::new(),
    };
    let (mut in_header, mut feed) = (true, None);
    for line in text.lines() {
        let comment = line.starts_with('(');
        in_header &= comment;
        if in_header {
            continue;
        }
        if comment {
            program.steady.push(line.to_owned());
            continue;
        }
        let words: Vec<(u8, f64)> = line.split(' ').filter_map(word).collect();
        if let Some((_, tool)) = words.iter().find(|(letter, _)| *letter == b'T') {
            program.tools.push(*tool as u32);
        }
        let tool = program.tools.last().copied().unwrap_or(0);
        // A feed holds until another is said, through changes of tools too.
        feed = words.iter().find(|(letter, _)| *letter == b'F').map(|word| word.1).or(feed);
        if let Some(feed) = feed.filter(|_| ["G1 ", "G2 ", "G3 "].iter().any(|code| line.starts_with(code))) {
            program.words.entry((b'F', tool)).or_default().insert((feed * 1000.0).round() as i64);
        }
        for &(letter, value) in words.iter().filter(|(letter, _)| b"FSPZ".contains(letter)) {
            program.words.entry((letter, tool)).or_default().insert((value * 1000.0).round() as i64);
        }
        if !words.iter().any(|(letter, _)| b"XYZ".contains(letter)) {
            program.steady.push(line.to_owned());
        }
    }
    Some(program)
}

fn word(text: &str) -> Option<(u8, f64)> {
    let letter = *text.as_bytes().first()?;
    Some((letter, text.get(1..)?.parse().ok().filter(|value: &f64| value.is_finite())?))
}

/// `key: value` of the comments at the top; long ones joined, escapes as they are.
fn header(text: &str) -> BTreeMap<String, Vec<String>> {
    let mut joined: Vec<String> = Vec::new();
    for line in text.lines() {
        let Some(comment) = line.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')) else { break };
        match (comment.strip_prefix("+ "), joined.last_mut()) {
            (Some(more), Some(last)) => last.push_str(more),
            _ => joined.push(comment.to_owned()),
        }
    }
    let mut header: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (key, value) in joined.iter().filter_map(|line| line.split_once(": ")) {
        header.entry(key.to_owned()).or_default().push(value.to_owned());
    }
    header
}

impl Program {
    /// Whether it is of the base dialect, for a part that is held by the table: others are known by their hash alone.
    pub(super) fn is_read(&self) -> bool {
        (self.text.starts_with("(design: ") || self.text.starts_with("(sheet: "))
            && self.said("fixing") == "held by the table"
            && !self.tools.is_empty()
    }

    /// The tool that is loaded last.
    pub(super) fn cutter(&self) -> Option<u32> {
        self.tools.last().copied()
    }

    fn said(&self, key: &str) -> &str {
        self.header.get(key).and_then(|all| all.first()).map_or("", String::as_str)
    }

    fn thickness(&self) -> f64 {
        self.said("stock").rsplit(" x ").next().and_then(|text| text.parse().ok()).unwrap_or(f64::NAN)
    }

    fn extreme(&self, letter: u8, tool: u32, greatest: bool) -> Option<f64> {
        let values = self.words.get(&(letter, tool))?;
        let value = if greatest { values.last() } else { values.first() };
        value.map(|value| *value as f64 / 1000.0)
    }
}

/// Reads every program back, and compares it with its drawing; the machines of the fabrications go to `machines`.
pub(super) fn check_together(
    programs: &[Program],
    drawings: &[Drawing],
    report: Option<&Report>,
    machines: &mut BTreeMap<usize, Machine>,
    findings: &mut Findings,
) -> Vec<String> {
    let Some(report) = report else { return by_hash(programs) };
    let usual = programs.iter().filter(|program| program.is_read()).count() * 2 > programs.len();
    if !usual {
        return by_hash(programs);
    }
    for program in programs.iter().filter(|program| !program.is_read()) {
        findings.add(&program.path, "the program", "the dialect and fixing of the others", "another");
    }
    let drawings: BTreeMap<&str, &Drawing> =
        drawings.iter().map(|drawing| (drawing.address.as_str(), drawing)).collect();
    // Boards of one fabrication and thickness are cut alike; so a damaged header misleads only itself.
    let mut groups: BTreeMap<(usize, i64), Vec<(&Program, &Part)>> = BTreeMap::new();
    for program in programs.iter().filter(|program| program.is_read()) {
        let Some(part) = report.part(&program.address) else { continue };
        let thickness = (thickness_of(part) * 1000.0).round() as i64;
        groups.entry((part.block, thickness)).or_default().push((program, part));
    }
    for group in groups.values() {
        let all: Vec<&Program> = group.iter().map(|(program, _)| *program).collect();
        let Some(machine) = machine(&all, group) else {
            let path = &all[0].path;
            findings.add(
                path,
                "figures of the machine",
                "that most programs agree on them",
                "no such figures",
            );
            continue;
        };
        steady(&all, findings);
        machines.extend(group.first().map(|(_, part)| (part.block, machine.clone())));
        for (program, part) in group {
            one(program, part, drawings.get(part.address.as_str()).copied(), &machine, report, findings);
        }
    }
    Vec::new()
}

/// Programs that are known by their hash alone.
fn by_hash(programs: &[Program]) -> Vec<String> {
    programs.iter().map(|program| program.path.clone()).collect()
}

/// How thick a part is where it is cut.
fn thickness_of(part: &Part) -> f64 {
    part.number("thickness_mm").unwrap_or(f64::NAN)
}

/// Lines that say no place are the same in all programs: modes, tools, feeds, speeds, the end.
fn steady(programs: &[&Program], findings: &mut Findings) {
    if programs.len() < 3 {
        return;
    }
    let numbered = |line: &String| line.starts_with("(engraving");
    let usual =
        most(programs.iter().map(|p| p.steady.iter().filter(|line| !numbered(line)).collect::<Vec<_>>()));
    let tools = most(programs.iter().map(|program| program.header.get("tool")));
    for program in programs {
        let own: Vec<&String> = program.steady.iter().filter(|line| !numbered(line)).collect();
        if let Some(usual) = &usual
            && own != *usual
        {
            let differs = own.iter().zip(usual).find(|(found, usual)| found != usual);
            let (found, expected) = differs.map_or(("fewer or more", "those of the others"), |(a, b)| (a, b));
            findings.add(&program.path, "lines without places", expected, found);
        }
        for key in ["machine", "units", "origin", "z zero"] {
            if let Some(usual) = most(programs.iter().map(|program| program.said(key))) {
                findings.same(&program.path, &format!("{key} in the header"), usual, program.said(key));
            }
        }
        if Some(program.header.get("tool")) != tools {
            findings.add(&program.path, "tools in the header", "those of the others", "others");
        }
    }
    for letter in [b'F', b'S', b'P'] {
        let of = |program: &Program| -> BTreeMap<u32, BTreeSet<i64>> {
            let own = program.words.iter().filter(|((found, _), _)| *found == letter);
            own.map(|((_, tool), values)| (*tool, values.clone())).collect()
        };
        let Some(usual) = most(programs.iter().map(|program| of(program))) else { continue };
        for program in programs.iter().filter(|program| of(program) != usual) {
            let what = format!("the values of {}", char::from(letter));
            findings.add(&program.path, what, "those of the other programs", "others");
        }
    }
}

/// The machine as most of its programs tell of it; limits that no program shows are wide.
fn machine(programs: &[&Program], group: &[(&Program, &Part)]) -> Option<Machine> {
    let order = most(programs.iter().map(|program| program.tools.clone()))?;
    let (engraver, cutter) = (*order.first()?, *order.last()?);
    let said = most(programs.iter().filter_map(|program| program.header.get("tool")))?;
    let usual = |letter: u8, tool: u32, greatest: bool| {
        most_number(programs.iter().filter_map(|program| program.extreme(letter, tool, greatest)))
    };
    let thickness = most_number(group.iter().map(|(_, part)| thickness_of(part)))?;
    let table = most(programs.iter().map(|program| program.said("z zero"))) == Some("table");
    let top = if table { thickness } else { 0.0 };
    let passes = |program: &&Program| {
        let line = program.steady.iter().find_map(|line| line.strip_prefix("(outer contour, passes: "))?;
        line.strip_suffix(')')?.parse::<f64>().ok().filter(|passes| *passes >= 1.0)
    };
    let depth = top - usual(b'Z', cutter, false)?;
    let passes = most_number(programs.iter().filter_map(passes)).unwrap_or(1.0);
    let tool = |number: u32, step_down: f64| -> Option<Tool> {
        let line = said.iter().find_map(|line| line.strip_prefix(&format!("{number} diameter ")))?;
        let (diameter, name) = line.split_once(" name ")?;
        Some(Tool {
            number,
            name: name.to_owned(),
            diameter: diameter.parse().ok()?,
            flute_length: 1000.0,
            feed: usual(b'F', number, true)? / 60.0,
            plunge: usual(b'F', number, false)? / 60.0,
            spindle: usual(b'S', number, true)? / 60.0,
            max_step_down: step_down,
        })
    };
    let engrave_depth = if engraver == cutter { 0.4 } else { top - usual(b'Z', engraver, false)? };
    let mut tools = vec![tool(cutter, depth / passes + 0.001)?];
    if engraver != cutter {
        tools.push(tool(engraver, engrave_depth)?);
    }
    let across = |(program, part): &(&Program, &Part)| {
        let stock = program.said("stock").split(" x ").next()?.parse::<f64>().ok()?;
        let (low, high) =
            part.outline.iter().fold((f64::MAX, f64::MIN), |r, at| (r.0.min(at.x), r.1.max(at.x)));
        Some(((stock - (high - low)) / 2.0 * 100.0).round() / 100.0)
    };
    let border = most_number(group.iter().filter_map(across))?;
    let speeds: Vec<f64> = tools.iter().map(|tool| tool.spindle).collect();
    let diameter = tools[0].diameter;
    let spec = MachineSpec {
        name: most(programs.iter().map(|program| program.said("machine")))?.to_owned(),
        envelope: DVec3::splat(99_999.0),
        safe_height: usual(b'Z', cutter, true)? - top,
        z_zero: if table { ZZero::Table } else { ZZero::TopOfStock },
        work_offset: WorkOffset::G54,
        stock_margin: (border - diameter).max(0.0),
        cut_through: (depth - thickness).max(0.0),
        engrave_depth,
        spindle_range: (
            speeds.iter().copied().fold(f64::INFINITY, f64::min),
            speeds.iter().copied().fold(0.0, f64::max),
        ),
        spin_up: usual(b'P', cutter, false).unwrap_or(0.0),
        direction: CutDirection::Climb,
        dialect: Dialect::LinuxCnc,
        allowance: 0.0,
        fixing: Fixing::Held,
        clamps: Vec::new(),
        cutter,
        engraver,
        tools,
    };
    Machine::try_new(spec).ok()
}

fn one(
    program: &Program,
    part: &Part,
    drawing: Option<&Drawing>,
    machine: &Machine,
    report: &Report,
    findings: &mut Findings,
) {
    let path = program.path.as_str();
    let job = job(part, drawing, program, report);
    if !can_be_cut(&job) || (program.thickness() - job.thickness).abs() > 0.001 {
        findings.add(path, "the stock", "that of a board of report.json", program.said("stock"));
        return;
    }
    let expected = Expected::new(&job, machine);
    match read_back(&program.text, &expected) {
        Err(faults) => tell(path, &faults, findings),
        Ok(readback) => {
            if let Some(drawing) = drawing {
                same_strokes(path, drawing, &readback, &expected, findings);
            }
            passes(path, &readback, &expected, findings);
        }
    }
}

/// The first faults of a program.
pub(super) fn tell(path: &str, faults: &[Fault], findings: &mut Findings) {
    for fault in faults.iter().take(3) {
        findings.add(path, format!("line {}", fault.line), fault.kind.property(), &fault.message);
    }
}

/// Whether the figures of a job are such that a program can be held against it.
pub(super) fn can_be_cut(job: &CutJob) -> bool {
    let bounded = |at: &DVec2| at.is_finite() && at.abs().max_element() < 1e6;
    (3..=MAX_CORNERS).contains(&job.outline.len()) && job.outline.iter().all(bounded)
}

/// What is to be cut of a part: its drawing has more decimals than the report, and the words of the header.
pub(super) fn job(part: &Part, drawing: Option<&Drawing>, program: &Program, report: &Report) -> CutJob {
    let bevels = (0..4).filter_map(|edge| part.item("bevels_deg", edge));
    let thickness = thickness_of(part);
    let widest = bevels.map(|bevel| thickness * libm::tan(bevel.abs().to_radians())).fold(0.0, f64::max);
    let exact =
        drawing.map(|drawing| drawing.outline.clone()).filter(|outline| outline.len() == part.outline.len());
    CutJob {
        address: part.address.clone(),
        alias: part.alias.clone(),
        design: report.design.clone(),
        design_hash: report.design_hash.clone(),
        outline: exact.unwrap_or_else(|| part.outline.clone()),
        thickness,
        engraving: Engraving {
            height: 12.0,
            least_height: 1.0,
            // The bevels of the report are rounded.
            clearance: CLEAR_OF_BEVELS + widest - 0.001,
            mark_edge_0: true,
        },
        face_up: match drawing.and_then(|drawing| drawing.face_up.clone()) {
            Some(face_up) => face_up,
            None => program.said("face up").to_owned(),
        },
        notes: match drawing {
            Some(drawing) => drawing.notes.clone(),
            None => program.header.get("note").cloned().unwrap_or_default(),
        },
    }
}

/// The engraving is that of the drawing, stroke by stroke.
fn same_strokes(
    path: &str,
    drawing: &Drawing,
    readback: &Readback,
    expected: &Expected<'_>,
    findings: &mut Findings,
) {
    let (Some(there), Some(here)) =
        (drawing.outline.first(), expected.parts.first().and_then(|part| part.outline.first()))
    else {
        return;
    };
    let moved = *here - *there;
    let wanted: Vec<(DVec2, DVec2)> = drawing
        .strokes
        .iter()
        .flat_map(|stroke| {
            stroke.windows(2).map(|pair| (pair[0] + moved, pair[1] + moved)).collect::<Vec<_>>()
        })
        .collect();
    let cutter = expected.machine.spec().cutter;
    let mut made = Vec::new();
    for m in readback.moves.iter().filter(|m| m.tool != Some(cutter) && m.motion == Motion::Straight) {
        if let ([Some(x0), Some(y0), Some(z0)], [Some(x1), Some(y1), Some(z1)]) = (m.from, m.to)
            && z0 < expected.machine.top(expected.thickness)
            && (z0 - z1).abs() < 1e-9
        {
            made.push((DVec2::new(x0, y0), DVec2::new(x1, y1)));
        }
    }
    if made.len() != wanted.len() {
        findings.add(path, "strokes of the engraving", format!("{} as drawn", wanted.len()), made.len());
    }
    for ((a, b), (c, d)) in wanted.iter().zip(&made) {
        findings.near(path, "a stroke off the drawing, mm", 0.0, a.distance(*c).max(b.distance(*d)), NEAR);
    }
}

/// Above full depth the cutter runs where it runs at full depth.
fn passes(path: &str, readback: &Readback, expected: &Expected<'_>, findings: &mut Findings) {
    let cutter = expected.machine.spec().cutter;
    let mut ends: BTreeSet<(i64, i64)> = BTreeSet::new();
    let thousandths = |value: f64| (value * 1000.0).round() as i64;
    let cuts: Vec<_> =
        readback.moves.iter().filter(|m| m.tool == Some(cutter) && m.motion != Motion::Rapid).collect();
    let bottom = expected.machine.bottom(expected.thickness);
    for m in &cuts {
        if let [Some(x), Some(y), Some(z)] = m.to
            && (z - bottom).abs() < 0.002
        {
            ends.insert((thousandths(x), thousandths(y)));
        }
    }
    let mut beside = Vec::new();
    for m in cuts {
        if let [Some(x), Some(y), Some(z)] = m.to
            && z < expected.machine.top(expected.thickness) + 1e-9
            && !ends.contains(&(thousandths(x), thousandths(y)))
        {
            beside.push((m.line, x, y));
        }
    }
    // Where a finishing allowance is left, all of the earlier passes run beside it.
    if beside.len() < 3 {
        for (line, x, y) in beside {
            let found = format!("X{x:.3} Y{y:.3}");
            findings.add(path, format!("line {line}"), "a place of the path at full depth", found);
        }
    }
}
