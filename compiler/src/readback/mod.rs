//! Reads NC text as a machine would and judges it: what moves, what it sweeps, whether that is the part and nothing
//! else. Shares no code with `export` or with the making of toolpaths: of `fabricate` it knows the figures of a
//! machine, the words of its dialect, the job, and the letters of the engraving font. Faults are plain data; nobody is
//! told here.

mod checks;
mod closed;
mod cuts;
mod decode;
mod expected;
mod fault;
mod geometry;
mod header;
mod interpret;
mod lines;
mod rebuild;
#[cfg(test)]
mod tests;

pub use expected::{Expected, ExpectedPart};
pub use fault::{Fault, FaultKind, TABLE as FAULTS};
pub use interpret::{Event, Motion, Move};

use cuts::Cut;
use glam::DVec2;
use interpret::Trace;
use lines::Line;

/// How far the swept outline may be from the cut outline, mm.
pub const OUTLINE_TOLERANCE: f64 = 0.01;

/// One file of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NcText<'a> {
    /// The tool that is in before it is run, in dialects without tool change.
    pub tool: Option<u32>,
    /// What it says.
    pub text: &'a str,
}

/// A program that was found good.
#[derive(Clone, Debug, PartialEq)]
pub struct Readback {
    /// What it makes, in the order of what was asked for.
    pub parts: Vec<ReadPart>,
    /// Every motion in order.
    pub moves: Vec<Move>,
}

/// A part as a program makes it.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadPart {
    /// Its outline in program coordinates as the cutter leaves it: the last full-depth path around it taken back by the
    /// cutter's radius, in mm, anticlockwise. Nearly straight corners may be one point or two.
    pub outline: Vec<DVec2>,
    /// Greatest distance from a corner of either outline, rebuilt or expected, to the other, mm.
    pub deviation: f64,
    /// The text that the engraved strokes spell.
    pub engraved: String,
}

/// Reads the text of a program in one file and compares it with what was asked for.
///
/// # Errors
/// All faults found, in order of their lines; never empty.
pub fn read_back(text: &str, expected: &Expected) -> Result<Readback, Vec<Fault>> {
    read_back_set(&[NcText { tool: None, text }], expected)
}

/// A file as it was understood.
struct File {
    tool: Option<u32>,
    lines: Vec<Line>,
    trace: Trace,
}

/// Reads the files of a program, in the order they are run, and compares them with what was asked for.
///
/// # Errors
/// All faults found, in order of files and lines; never empty.
pub fn read_back_set(texts: &[NcText], expected: &Expected) -> Result<Readback, Vec<Fault>> {
    let profile = expected.machine.spec().dialect.profile();
    let mut faults = Vec::new();
    let mut files: Vec<File> = Vec::new();
    // Lines are counted on through the files, and told apart at the end.
    let mut read = 0;
    for text in texts {
        let lines = lines::read(text.text, read, profile, &mut faults);
        read += lines.len();
        let trace = interpret::interpret(&lines, profile, text.tool, &mut faults);
        files.push(File { tool: text.tool, lines, trace });
    }
    let traces: Vec<&Trace> = files.iter().map(|file| &file.trace).collect();
    let cuts = cuts::cuts(&traces, expected);
    for file in &files {
        checks::of_file(file, &cuts, expected, &mut faults);
    }
    checks::files::check(&files, expected, &mut faults);
    checks::of_cuts(&cuts, expected, &mut faults);
    let of_part = |part: usize| cuts.iter().copied().filter(|cut| cut.part == part).collect::<Vec<Cut>>();
    let parts: Vec<Option<ReadPart>> = (0..expected.parts.len())
        .map(|part| read_part(&of_part(part), expected, part, &mut faults))
        .collect();
    faults.sort_by_key(|fault| fault.line);
    locate(&files, &mut faults);
    match parts.into_iter().collect::<Option<Vec<ReadPart>>>() {
        Some(parts) if faults.is_empty() => {
            let moves = traces.iter().flat_map(|trace| trace.moves()).copied().collect();
            Ok(Readback { parts, moves })
        }
        _ => Err(faults),
    }
}

/// What is made of one part by the cuts on it.
fn read_part(cuts: &[Cut], expected: &Expected, part: usize, faults: &mut Vec<Fault>) -> Option<ReadPart> {
    checks::step_down::check(cuts, expected, faults);
    let engraved = decode::engraving(cuts, expected, part, faults);
    let contour: Vec<Cut> = cuts.iter().copied().filter(|cut| !cut.engraves).collect();
    let way = match closed::last_way(&contour, expected) {
        Ok(way) => way,
        Err(gap) => {
            let line = contour.last().map_or(0, |cut| cut.made.line);
            let message = format!("the full-depth path has a gap of {gap:.3} mm");
            faults.push(Fault::measured(FaultKind::OutlineOpen, line, gap, message));
            checks::uncut::check(&[], expected, part, faults);
            return None;
        }
    };
    checks::uncut::check(&way, expected, part, faults);
    checks::tabs::check(&way, &contour, expected, part, faults);
    let rebuilt = rebuild::outline(&way, expected, part);
    Some(ReadPart { outline: rebuilt.outline, deviation: rebuilt.deviation, engraved })
}

/// From lines counted through all files to lines of each.
fn locate(files: &[File], faults: &mut [Fault]) {
    for fault in faults {
        let mut before = 0;
        for file in files {
            let last = before + file.lines.len();
            if fault.line > before && fault.line <= last {
                fault.line -= before;
                fault.tool = file.tool;
                break;
            }
            before = last;
        }
    }
}
