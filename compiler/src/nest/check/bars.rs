//! The same for planks on bars.

use glam::DVec2;

use super::distance::distance;
use super::{Fault, TOLERANCE};
use crate::nest::bars::{Bar, Placed, Plank, Sawn, Stock};

/// What is wrong with how `planks` are sawn; nothing where all is well.
///
/// Every plank is one that was asked for, the right length and leaning as it should for the way it lies; it stays within
/// the trimmed bar; no two are nearer than the kerf; and each face of each plank is a raw end or made by a cut.
#[must_use]
pub fn bar_faults(planks: &[Plank], stock: &Stock, sawn: &Sawn) -> Vec<Fault> {
    let mut times = vec![0; planks.len()];
    let known = sawn.bars.iter().flat_map(|bar| &bar.planks).map(|placed| placed.plank);
    for plank in known.chain(sawn.too_long.iter().map(|long| long.plank)) {
        if let Some(count) = times.get_mut(plank) {
            *count += 1;
        }
    }
    let lost = times.iter().enumerate().filter(|(_, times)| **times != 1);
    let mut faults: Vec<Fault> = lost.map(|(part, &times)| Fault::NotOnce { part, times }).collect();
    for bar in &sawn.bars {
        let wrong = bar.planks.iter().filter(|placed| !as_asked(placed, planks) || !cut_free(placed, bar));
        faults.extend(wrong.map(|placed| Fault::NotAllowed { part: placed.plank }));
        faults.extend(outside_or_near(bar, stock));
    }
    faults
}

/// Whether a plank has its length and its mitres. Turning it end for end keeps how its cuts lean and swaps them; turning
/// it over makes them lean the other way.
fn as_asked(placed: &Placed, planks: &[Plank]) -> bool {
    let Some(plank) = planks.get(placed.plank) else { return false };
    let [first, second] = placed.leans;
    let [start, end] = if placed.end_first { [second, first] } else { [first, second] };
    let sign = if placed.turned_over { -1.0 } else { 1.0 };
    let length = placed.at[1] - placed.at[0];
    (length - plank.length).abs() < TOLERANCE
        && (sign * start - plank.mitres[0]).abs() < 1e-9
        && (sign * end - plank.mitres[1]).abs() < 1e-9
}

/// Whether each of its faces is a raw end of the bar or made by a cut at that place.
fn cut_free(placed: &Placed, bar: &Bar) -> bool {
    let starts = bar
        .cuts
        .iter()
        .any(|cut| cut.after == Some(placed.plank) && (cut.lean - placed.leans[0]).abs() < 1e-6);
    let ends = bar.cuts.iter().any(|cut| {
        cut.before == Some(placed.plank)
            && cut.at == placed.at[1]
            && (cut.lean - placed.leans[1]).abs() < 1e-6
    });
    let raw_start = placed.at[0] == 0.0 && placed.leans[0] == 0.0;
    let raw_end = placed.leans[1] == 0.0 && bar.planks.last().is_some_and(|last| last.plank == placed.plank);
    (starts || raw_start) && (ends || raw_end)
}

fn outside_or_near(bar: &Bar, stock: &Stock) -> Vec<Fault> {
    let faces: Vec<[DVec2; 4]> = bar.planks.iter().map(|placed| face(placed, stock.depth)).collect();
    let mut faults = Vec::new();
    for (index, (placed, corners)) in bar.planks.iter().zip(&faces).enumerate() {
        let low = corners.iter().map(|corner| corner.x).fold(f64::INFINITY, f64::min);
        let high = corners.iter().map(|corner| corner.x).fold(f64::NEG_INFINITY, f64::max);
        let within = low.min(stock.length - high);
        if within.is_nan() || within < stock.trim - TOLERANCE {
            faults.push(Fault::OutsideMargin { part: placed.plank, distance: within });
        }
        for (other, corners_of_other) in bar.planks.iter().zip(&faces).skip(index + 1).take(3) {
            let distance = distance(corners, corners_of_other);
            if distance.is_nan() || distance < stock.kerf - TOLERANCE {
                faults.push(Fault::TooNear { parts: [placed.plank, other.plank], distance });
            }
        }
    }
    faults
}

/// The face of a plank in the plane of its mitres. A cut that leans anticlockwise runs ahead below the axis.
fn face(placed: &Placed, depth: f64) -> [DVec2; 4] {
    let corner = |end: usize, side: f64| {
        let y = side * depth / 2.0;
        DVec2::new(placed.at[end] - libm::tan(placed.leans[end]) * y, y)
    };
    [corner(0, -1.0), corner(1, -1.0), corner(1, 1.0), corner(0, 1.0)]
}
