//! The header: comments that say what a program cuts, where it lies and which tools it needs.
//!
//! Names are data: what is not plain printable ASCII, and what could end or steer a comment, is written as its code
//! point in braces. Long lines go on in comments that begin with a plus.

use super::extents::Extents;
use super::number::{number, thousandths};
use crate::fabricate::machine::{Machine, ZZero};
use crate::fabricate::toolpath::Program;

/// Most characters between the parentheses.
const WIDTH: usize = 66;

/// The text as one comment line, or several if it is long.
pub(super) fn comment(text: &str) -> String {
    let mut rest = escaped(text).into_bytes();
    let mut out = String::new();
    let mut lead = "";
    loop {
        let room = WIDTH - lead.len();
        let cut = if rest.len() <= room {
            rest.len()
        } else {
            // After the last space that leaves at least half a line, else in mid-word.
            (room / 2..room).rev().find(|&i| rest[i] == b' ').map_or(room, |i| i + 1)
        };
        let tail = rest.split_off(cut);
        out += &format!("({lead}{})\n", String::from_utf8_lossy(&rest));
        if tail.is_empty() {
            return out;
        }
        rest = tail;
        lead = "+ ";
    }
}

fn escaped(text: &str) -> String {
    let plain = |c: char| (c == ' ' || c.is_ascii_graphic()) && !"(){}%;\\".contains(c);
    text.chars().map(|c| if plain(c) { c.to_string() } else { format!("{{{:x}}}", u32::from(c)) }).collect()
}

/// The whole header.
pub(super) fn header(program: &Program, machine: &Machine, swept: &Extents) -> String {
    let (said, spec) = (&program.header, machine.spec());
    let mm = |value: f64| number(thousandths(value));
    let zero = match spec.z_zero {
        ZZero::TopOfStock => "top of stock",
        ZZero::Table => "table",
    };
    let mut lines = vec![
        format!("address: {}", said.address),
        format!("alias: {}", said.alias),
        format!("design: {}", said.design),
        format!("design hash: {}", said.design_hash),
        format!("machine: {}", spec.name),
        format!("stock: {} x {} x {}", mm(said.stock.x), mm(said.stock.y), mm(said.stock.z)),
        "origin: lower left of stock".to_owned(),
        format!("z zero: {zero}"),
        format!("face up: {}", said.face_up),
        "units: mm, feeds mm/min".to_owned(),
    ];
    for (axis, low, high) in swept.axes() {
        lines.push(format!("swept {axis}: {} to {}", number(low), number(high)));
    }
    for tool in spec.tools.iter().filter(|t| t.number == spec.cutter || t.number == spec.engraver) {
        lines.push(format!("tool: {} diameter {} name {}", tool.number, mm(tool.diameter), tool.name));
    }
    lines.extend(said.notes.iter().map(|note| format!("note: {note}")));
    lines.iter().map(|line| comment(line)).collect()
}
