//! The header: comments that say what a program cuts, where it lies and which tools it needs.
//!
//! Names are data: what is not plain printable ASCII, and what could end or steer a comment, is written as its code
//! point in braces. Long lines go on in comments that begin with a plus.

use super::extents::Extents;
use super::number::{number, thousandths};
use crate::fabricate::machine::{CommentRule, Fixing, Machine, Profile, Tool, ZZero};
use crate::fabricate::toolpath::{PartHeader, Program};

/// Most characters between the parentheses.
const WIDTH: usize = 66;

/// The text as one comment line, or several if it is long.
pub(super) fn comment(text: &str, profile: &Profile) -> String {
    let mut rest = escaped(text, &profile.comment).into_bytes();
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

fn escaped(text: &str, rule: &CommentRule) -> String {
    let plain = |c: char| (c == ' ' || c.is_ascii_graphic()) && !rule.forbidden.contains(c);
    let (open, close) = rule.escape;
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if plain(c) {
            out.push(c);
        } else {
            out += &format!("{open}{:x}{close}", u32::from(c));
        }
    }
    if rule.capitals { out.to_ascii_uppercase() } else { out }
}

/// The whole header of a file that uses these tools; `place` among the files of its program, where there are several.
pub(super) fn header(
    program: &Program,
    machine: &Machine,
    profile: &Profile,
    swept: &Extents,
    tools: &[&Tool],
    place: Option<&str>,
) -> String {
    let mut lines = whole(program, machine);
    for part in &program.parts {
        lines.extend(of_part(&part.header));
    }
    for (axis, low, high) in swept.axes() {
        lines.push(format!("swept {axis}: {} to {}", number(low), number(high)));
    }
    for tool in tools {
        let diameter = number(thousandths(tool.diameter));
        lines.push(format!("tool: {} diameter {diameter} name {}", tool.number, tool.name));
    }
    if let Some(place) = place {
        lines.push(format!("file: {place}, put the tool in and set its Z zero first"));
    }
    lines.iter().map(|line| comment(line, profile)).collect()
}

/// What is said of the stock and the machine.
fn whole(program: &Program, machine: &Machine) -> Vec<String> {
    let (said, spec) = (&program.header, machine.spec());
    let mm = |value: f64| number(thousandths(value));
    let zero = match spec.z_zero {
        ZZero::TopOfStock => "top of stock",
        ZZero::Table => "table",
    };
    let fixing = match spec.fixing {
        Fixing::Held => "held by the table".to_owned(),
        Fixing::Tabs { count, width, height } => {
            format!("tabs {count} width {} height {}", mm(width), mm(height))
        }
        Fixing::OnionSkin { thickness } => format!("onion skin {}", mm(thickness)),
    };
    let sheet = (!said.sheet.is_empty()).then(|| format!("sheet: {}", said.sheet));
    let lines = [
        format!("design: {}", said.design),
        format!("design hash: {}", said.design_hash),
        format!("machine: {}", spec.name),
        format!("stock: {} x {} x {}", mm(said.stock.x), mm(said.stock.y), mm(said.stock.z)),
        "origin: lower left of stock".to_owned(),
        format!("z zero: {zero}"),
        format!("fixing: {fixing}"),
        "units: mm, feeds mm/min".to_owned(),
    ];
    sheet.into_iter().chain(lines).collect()
}

fn of_part(part: &PartHeader) -> Vec<String> {
    let mm = |value: f64| number(thousandths(value));
    let mut lines = vec![
        format!("address: {}", part.address),
        format!("alias: {}", part.alias),
        format!("at: {} x {} turned {}", mm(part.low.x), mm(part.low.y), part.turned),
        format!("face up: {}", part.face_up),
    ];
    lines.extend(part.notes.iter().map(|note| format!("note: {note}")));
    lines
}
