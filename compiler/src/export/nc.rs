//! NC programs as text, in the dialect of the machine. Moves come from `fabricate::toolpath`, the words a dialect has
//! from its profile; the text is judged by `readback`, which shares no code with this room.
//!
//! Lines stay under 70 characters of ASCII and end in LF. Coordinates have three decimals; everything that depends on
//! coordinates (arc centres, extents) is computed from the rounded ones.

mod extents;
mod header;
mod motion;
mod number;
#[cfg(test)]
mod tests;

use crate::fabricate::machine::{
    Dialect, DwellUnit, LAST_PROGRAM_NUMBER, LengthOffset, Machine, Profile, Tool,
};
use crate::fabricate::toolpath::{Program, Step};
use motion::Pen;
use number::{number, per_minute, thousandths, whole_per_minute};

/// One file of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NcFile {
    /// The tool that the operator has put in before the file is run; `None` where the program changes tools itself, and
    /// is one file.
    pub tool: Option<u32>,
    /// What it says.
    pub text: String,
}

/// The program in the machine's dialect: one file, or one for each tool in the order they are run.
#[must_use]
pub fn write(program: &Program, machine: &Machine) -> Vec<NcFile> {
    let dialect = machine.spec().dialect;
    if dialect.profile().changes_tools {
        let tools: Vec<&Tool> = tools(&program.steps, machine).collect();
        let text = file(program, machine, dialect, &program.steps, &tools, None);
        return vec![NcFile { tool: None, text }];
    }
    let starts: Vec<usize> = program
        .steps
        .iter()
        .enumerate()
        .filter_map(|(i, step)| matches!(step, Step::LoadTool { .. }).then_some(i))
        .collect();
    let ends = starts.iter().skip(1).copied().chain([program.steps.len()]);
    let parts: Vec<&[Step]> = starts.iter().zip(ends).map(|(&from, to)| &program.steps[from..to]).collect();
    let count = parts.len();
    let one = |(i, steps): (usize, &&[Step])| {
        let tools: Vec<&Tool> = tools(steps, machine).collect();
        let place = format!("{} of {count}", i + 1);
        let text = file(program, machine, dialect, steps, &tools, Some(&place));
        NcFile { tool: tools.first().map(|tool| tool.number), text }
    };
    parts.iter().enumerate().map(one).collect()
}

/// The tools that the steps load, in order.
fn tools<'a>(steps: &'a [Step], machine: &'a Machine) -> impl Iterator<Item = &'a Tool> {
    steps.iter().filter_map(|step| match step {
        Step::LoadTool { number } => machine.spec().tools.iter().find(|tool| tool.number == *number),
        _ => None,
    })
}

fn file(
    program: &Program,
    machine: &Machine,
    dialect: Dialect,
    steps: &[Step],
    tools: &[&Tool],
    place: Option<&str>,
) -> String {
    let profile = dialect.profile();
    let top = machine.top(program.header.stock.z);
    let mut pen = Pen::new(top);
    let modes: Vec<String> = profile.modes.iter().map(|code| format!("G{code} ")).collect();
    let mut body = format!("{}G{}\n", modes.concat(), machine.spec().work_offset.code());
    for step in steps {
        body += &words(step, profile, tools, &mut pen);
    }
    body += &format!("M{}\n", profile.end);
    let head = header::header(program, machine, profile, &pen.extents, tools, place);
    if !profile.numbered {
        return head + &body;
    }
    let number = (program.header.number.max(1) - 1) % LAST_PROGRAM_NUMBER + 1;
    format!("%\nO{number:04}\n{head}{body}%\n")
}

/// What a step says; some steps say nothing.
fn words(step: &Step, profile: &Profile, tools: &[&Tool], pen: &mut Pen) -> String {
    match step {
        Step::LoadTool { number } => {
            let radius = tools.iter().find(|t| t.number == *number).map_or(0.0, |t| t.diameter / 2.0);
            pen.change_tool(radius);
            let change = if profile.changes_tools { format!("T{number} M6\n") } else { String::new() };
            match profile.length_offset {
                LengthOffset::ByHand => change,
                LengthOffset::OwnLine => format!("{change}G43 H{number}\n"),
                LengthOffset::WithMotion => {
                    pen.offset_with_next(*number);
                    change
                }
            }
        }
        Step::SpindleOn { speed } if profile.whole_spindle_speed => {
            format!("S{} M3\n", whole_per_minute(*speed))
        }
        Step::SpindleOn { speed } => format!("S{} M3\n", per_minute(*speed)),
        Step::Dwell { seconds } => match profile.dwell {
            DwellUnit::Seconds => format!("G4 P{}\n", number(thousandths(*seconds))),
            DwellUnit::Milliseconds => format!("G4 P{}\n", thousandths(*seconds)),
        },
        Step::SpindleOff => "M5\n".to_owned(),
        Step::Note { text } => header::comment(text, profile),
        Step::RapidZ { z } => pen.rapid_z(*z),
        Step::RapidXY { to } => pen.rapid_xy(*to),
        Step::Line { to, feed } => pen.line(*to, *feed),
        Step::Arc { to, radius, turn, feed } => pen.arc(*to, *radius, *turn, *feed),
    }
}
