//! The parts of a sheet brought to their places, and whether they have room there.

use super::lead::Lead;
use super::polygon::{Polygon, segment_distance};
use super::{MAX_LENGTH, PartRefusal, Refusal};
use crate::fabricate::cut_job::{MAX_PARTS, Placed, Sheet};
use crate::fabricate::machine::Machine;
use glam::DVec2;

/// Distances may be smaller than needed by this, mm: the rounding of sums.
const SLACK: f64 = 1e-6;

/// The outlines in program coordinates.
///
/// # Errors
/// An outline that is no polygon, parts outside of the sheet or the machine's travel, parts nearer to each other than
/// the cutter needs.
pub(super) fn outlines(sheet: &Sheet, machine: &Machine) -> Result<Vec<Polygon>, PartRefusal> {
    let count = sheet.parts.len();
    if !(1..=MAX_PARTS).contains(&count) {
        return Err(PartRefusal { part: 0, refusal: Refusal::PartCount { count } });
    }
    let mut out: Vec<Polygon> = Vec::with_capacity(count);
    for (part, placed) in sheet.parts.iter().enumerate() {
        let outline = outline(placed, sheet, machine).map_err(|refusal| PartRefusal { part, refusal })?;
        out.push(outline);
    }
    let needed = machine.cutter().diameter + machine.spec().allowance;
    for (part, outline) in out.iter().enumerate() {
        for (other, earlier) in out[..part].iter().enumerate() {
            let gap = gap(outline, earlier, needed);
            if gap < needed - SLACK {
                let refusal = Refusal::PartsTooClose { other, gap, needed };
                return Err(PartRefusal { part, refusal });
            }
        }
    }
    Ok(out)
}

fn outline(placed: &Placed, sheet: &Sheet, machine: &Machine) -> Result<Polygon, Refusal> {
    let turned: Vec<DVec2> = placed.job.outline.iter().map(|&p| placed.rotation.turn(p)).collect();
    let turned = Polygon::try_new(&turned)?;
    let outline = turned.shifted(placed.low - turned.bounds().0);
    let (low, high) = outline.bounds();
    check_envelope(high, sheet.thickness(), machine)?;
    let (least, greatest) = (low.min_element(), (sheet.stock - high).min_element());
    // The cutter's centre stays over the stock: it may cut into its edge, not beside it.
    let needed = machine.cutter().diameter / 2.0 + machine.spec().allowance;
    let room = least.min(greatest);
    if room.is_nan() || room < needed - SLACK {
        return Err(Refusal::OutsideStock { room, needed });
    }
    Ok(outline)
}

/// `high`: the greatest X and Y of the part.
fn check_envelope(high: DVec2, thickness: f64, machine: &Machine) -> Result<(), Refusal> {
    let spec = machine.spec();
    let reach = high + machine.cutter().diameter / 2.0 + Lead::sideways(machine).max(spec.allowance);
    let z = machine.safe_z(thickness) - machine.bottom(thickness);
    for (axis, needed, travel) in
        [('x', reach.x, spec.envelope.x), ('y', reach.y, spec.envelope.y), ('z', z, spec.envelope.z)]
    {
        if !(needed <= travel && needed <= MAX_LENGTH) {
            return Err(Refusal::Envelope { axis, needed, travel });
        }
    }
    Ok(())
}

/// Distance between two parts if it is less than `enough`, else something not less; 0 if they overlap.
fn gap(a: &Polygon, b: &Polygon, enough: f64) -> f64 {
    let ((a_low, a_high), (b_low, b_high)) = (a.bounds(), b.bounds());
    let apart = (a_low - b_high).max(b_low - a_high).max_element();
    if apart >= enough {
        return apart;
    }
    if a.contains(b.corners()[0]) || b.contains(a.corners()[0]) {
        return 0.0;
    }
    let edges = |p: &Polygon| (0..p.len()).map(|i| p.edge(i)).collect::<Vec<_>>();
    let (a, b) = (edges(a), edges(b));
    let distances = a.iter().flat_map(|&s| b.iter().map(move |&t| segment_distance(s, t)));
    distances.fold(f64::INFINITY, f64::min)
}
