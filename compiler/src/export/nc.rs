//! NC programs as text. One dialect so far: LinuxCNC's RS274/NGC. Moves come from `fabricate::toolpath`; the text is
//! judged by `readback`, which shares no code with this room.
//!
//! Lines stay under 70 characters of ASCII and end in LF. Coordinates have three decimals; everything that depends on
//! coordinates (arc centres, extents) is computed from the rounded ones.

mod extents;
mod header;
mod motion;
mod number;
#[cfg(test)]
mod tests;

use crate::fabricate::machine::{Dialect, Machine};
use crate::fabricate::toolpath::{Program, Step};
use motion::Pen;
use number::{number, per_minute};

/// The program as text in the machine's dialect.
#[must_use]
pub fn write(program: &Program, machine: &Machine) -> String {
    match machine.spec().dialect {
        Dialect::LinuxCnc => linuxcnc(program, machine),
    }
}

fn linuxcnc(program: &Program, machine: &Machine) -> String {
    let top = machine.top(program.header.stock.z);
    let mut pen = Pen::new(top);
    let mut body = format!("G21 G17 G90 G94 G40 G49 G80 G{}\n", machine.spec().work_offset.code());
    for step in &program.steps {
        match step {
            Step::LoadTool { number } => {
                let radius = machine
                    .spec()
                    .tools
                    .iter()
                    .find(|t| t.number == *number)
                    .map_or(0.0, |t| t.diameter / 2.0);
                pen.change_tool(radius);
                body += &format!("T{number} M6\nG43 H{number}\n");
            }
            Step::SpindleOn { speed } => body += &format!("S{} M3\n", per_minute(*speed)),
            Step::Dwell { seconds } => body += &format!("G4 P{}\n", number(number::thousandths(*seconds))),
            Step::SpindleOff => body += "M5\n",
            Step::Note { text } => body += &header::comment(text),
            Step::RapidZ { z } => body += &pen.rapid_z(*z),
            Step::RapidXY { to } => body += &pen.rapid_xy(*to),
            Step::Line { to, feed } => body += &pen.line(*to, *feed),
            Step::Arc { to, radius, turn, feed } => body += &pen.arc(*to, *radius, *turn, *feed),
        }
    }
    body += "M2\n";
    header::header(program, machine, &pen.extents) + &body
}
