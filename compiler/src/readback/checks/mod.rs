//! One file per property of a good program. Each looks at the whole trace and says what is wrong with it; none
//! depends on another having passed.

mod arcs;
mod depth;
mod ending;
mod engraving;
mod envelope;
mod extents;
mod feed;
mod first_motion;
mod gouge;
mod header;
mod modes;
mod rapids;
mod spindle;
mod step_down;
mod tool;
mod uncut;

use super::cuts::cuts;
use super::interpret::Trace;
use super::lines::Line;
use super::{Expected, Fault};

/// Every check.
pub(super) fn all(trace: &Trace, lines: &[Line], expected: &Expected, faults: &mut Vec<Fault>) {
    modes::check(trace, expected, faults);
    first_motion::check(trace, expected, faults);
    rapids::check(trace, expected, faults);
    feed::check(trace, expected, faults);
    spindle::check(trace, expected, faults);
    tool::check(trace, expected, faults);
    envelope::check(trace, expected, faults);
    arcs::check(trace, faults);
    ending::check(trace, lines, expected, faults);
    let cuts = cuts(trace, expected);
    depth::check(&cuts, expected, faults);
    step_down::check(&cuts, expected, faults);
    gouge::check(&cuts, expected, faults);
    uncut::check(&cuts, expected, faults);
    engraving::check(&cuts, expected, faults);
    let entries = super::header::entries(lines);
    header::check(&entries, expected, faults);
    extents::check(&entries, trace, &cuts, expected, faults);
}
