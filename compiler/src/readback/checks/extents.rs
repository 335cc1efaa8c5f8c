//! The header's extents are those of what the tools cut in X and Y and of all heights in Z.

use crate::readback::cuts::Cut;
use crate::readback::header::Entry;
use crate::readback::interpret::Trace;
use crate::readback::{Expected, Fault, FaultKind};

/// Extents may differ by this, mm: what rounding and flattening arcs make.
const TOLERANCE: f64 = 0.003;

pub(super) fn check(
    entries: &[Entry],
    trace: &Trace,
    cuts: &[&Cut],
    first_line: usize,
    expected: &Expected,
    faults: &mut Vec<Fault>,
) {
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let key = format!("swept {name}");
        let Some(entry) = entries.iter().find(|entry| entry.key == key) else {
            faults.push(Fault::new(FaultKind::Extents, first_line, format!("the header does not say {key}")));
            continue;
        };
        // In capitals in some dialects.
        let value = entry.value.to_ascii_lowercase();
        let said = value.split_once(" to ").and_then(|(a, b)| Some((a.parse().ok()?, b.parse().ok()?)));
        let swept = if axis == 2 { heights(trace) } else { swept(cuts, expected, axis) };
        let off = said.map_or(f64::INFINITY, |(low, high): (f64, f64)| {
            (low - swept.0).abs().max((high - swept.1).abs())
        });
        // A value that is no number is a fault too.
        if off.is_nan() || off > TOLERANCE {
            let message =
                format!("the header says {key} {}, swept is {:.3} to {:.3}", entry.value, swept.0, swept.1);
            faults.push(Fault::measured(FaultKind::Extents, entry.line, off, message));
        }
    }
}

fn heights(trace: &Trace) -> (f64, f64) {
    let heights = trace.moves().filter_map(|m| m.to[2]);
    heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (low.min(z), high.max(z)))
}

fn swept(cuts: &[&Cut], expected: &Expected, axis: usize) -> (f64, f64) {
    let mut range = (f64::INFINITY, f64::NEG_INFINITY);
    for cut in cuts {
        let tool = expected.machine.spec().tools.iter().find(|t| Some(t.number) == cut.made.tool);
        let radius = tool.map_or(0.0, |tool| tool.diameter / 2.0);
        let (low, high) = cut.piece.bounds();
        range = (range.0.min(low[axis] - radius), range.1.max(high[axis] + radius));
    }
    range
}
