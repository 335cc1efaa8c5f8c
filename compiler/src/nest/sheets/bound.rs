//! How many sheets no packing can do without, by area.

use super::{Part, Sheet, area};
use glam::DVec2;
use std::f64::consts::PI;

/// A proven least number of sheets for `parts` that can all be placed.
///
/// Parts a gap apart, grown by half the gap, do not overlap, and lie within the sheet less its margins grown by as much.
/// A convex part of area A and girth U grows to A + U·r + π·r² (Steiner 1840); any other to (√A + r·√π)² at least
/// (Brunn and Minkowski).
#[must_use]
pub fn least_sheets<'a>(parts: impl IntoIterator<Item = &'a Part>, sheet: &Sheet) -> usize {
    let room = sheet.room() + sheet.gap;
    let radius = sheet.gap / 2.0;
    let sum: f64 = parts.into_iter().map(|part| grown(&part.outline, radius)).sum();
    let sheets = sum / (room.x * room.y);
    // Rounding of the sum must not ask for one sheet more.
    if sheets.is_finite() && sheets > 0.0 { libm::ceil(sheets * (1.0 - 1e-9)) as usize } else { 0 }
}

fn grown(outline: &[DVec2], radius: f64) -> f64 {
    let area = area(outline);
    let sides = (0..outline.len()).map(|side| outline[(side + 1) % outline.len()] - outline[side]);
    let sides: Vec<DVec2> = sides.collect();
    let convex = (0..sides.len()).all(|side| sides[side].perp_dot(sides[(side + 1) % sides.len()]) >= 0.0);
    if convex {
        area + sides.iter().map(|side| side.length()).sum::<f64>() * radius + PI * radius * radius
    } else {
        let root = area.max(0.0).sqrt() + radius * PI.sqrt();
        root * root
    }
}
