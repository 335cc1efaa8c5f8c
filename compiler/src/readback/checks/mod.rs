//! One file per property of a good program. Each looks at the whole trace and says what is wrong with it; none
//! depends on another having passed.

mod arcs;
mod clamps;
mod depth;
mod ending;
mod engraving;
mod envelope;
mod extents;
mod feed;
pub(super) mod files;
mod first_motion;
mod frame;
mod gouge;
mod header;
mod modes;
mod rapids;
mod spindle;
pub(super) mod step_down;
pub(super) mod tabs;
mod tool;
pub(super) mod uncut;

use super::cuts::Cut;
use super::{Expected, Fault, File};
use crate::fabricate::machine::Tool;

/// Every check of one file for itself; `cuts` are those of all files.
pub(super) fn of_file(file: &File, cuts: &[Cut], expected: &Expected, faults: &mut Vec<Fault>) {
    let File { trace, lines, .. } = file;
    frame::check(lines, expected, faults);
    modes::check(trace, expected, faults);
    first_motion::check(trace, expected, faults);
    rapids::check(trace, expected, faults);
    feed::check(trace, expected, faults);
    spindle::check(trace, expected, faults);
    tool::check(trace, expected, faults);
    envelope::check(trace, expected, faults);
    clamps::check(trace, expected, faults);
    arcs::check(trace, faults);
    ending::check(trace, lines, expected, faults);
    let first_line = lines.first().map_or(0, |line| line.number);
    let last_line = lines.last().map_or(0, |line| line.number);
    let own: Vec<&Cut> =
        cuts.iter().filter(|cut| (first_line..=last_line).contains(&cut.made.line)).collect();
    let entries = super::header::entries(lines, expected.machine.spec().dialect.profile());
    header::check(&entries, &used(file, expected), first_line, expected, faults);
    extents::check(&entries, trace, &own, first_line, expected, faults);
}

/// Every check of cutting, through all files.
pub(super) fn of_cuts(cuts: &[Cut], expected: &Expected, faults: &mut Vec<Fault>) {
    depth::check(cuts, expected, faults);
    gouge::check(cuts, expected, faults);
    engraving::check(cuts, expected, faults);
}

/// The tools that a file must use: all of the program, or the one that was put in for it.
fn used<'a>(file: &File, expected: &'a Expected) -> Vec<&'a Tool> {
    let (engraver, cutter) = (expected.machine.engraver(), expected.machine.cutter());
    let mut tools = vec![engraver];
    if cutter.number != engraver.number {
        tools.push(cutter);
    }
    tools.retain(|tool| file.tool.is_none_or(|number| number == tool.number));
    tools
}
