//! No tool comes into a clamp: below its top, tools stay clear of it by their radius.

use super::polygon::segment_distance;
use super::program::Step;
use super::{Refusal, Steps};
use crate::fabricate::machine::Clamp;
use glam::DVec2;

/// Checks all steps against all clamps of the machine.
///
/// # Errors
/// The first clamp that is touched, and where.
pub(super) fn check(steps: &Steps) -> Result<(), Refusal> {
    let spec = steps.machine.spec();
    if spec.clamps.is_empty() {
        return Ok(());
    }
    // Where the machine stands before its first moves is not known.
    let (mut plane, mut height, mut radius): (Option<DVec2>, Option<f64>, f64) = (None, None, 0.0);
    for step in &steps.out {
        let (to, z) = match step {
            Step::LoadTool { number } => {
                let tool = spec.tools.iter().find(|tool| tool.number == *number);
                radius = tool.map_or(0.0, |tool| tool.diameter / 2.0);
                continue;
            }
            Step::RapidZ { z } => (plane, Some(*z)),
            Step::RapidXY { to } => (Some(*to), height),
            Step::Line { to, .. } | Step::Arc { to, .. } => (Some(to.truncate()), Some(to.z)),
            _ => continue,
        };
        let before = (plane.or(to), height.or(z));
        (plane, height) = (to, z);
        let ((Some(from), Some(above)), (Some(to), Some(z))) = (before, (to, z)) else { continue };
        let bulge = if let Step::Arc { radius, .. } = step { arc_bulge(from, to, *radius) } else { 0.0 };
        let low = above.min(z) - steps.top();
        for (index, clamp) in spec.clamps.iter().enumerate() {
            if low < clamp.height && distance(clamp, from, to) < radius + bulge {
                return Err(Refusal::Clamped { clamp: index, x: to.x, y: to.y });
            }
        }
    }
    Ok(())
}

/// How far an arc of at most a half turn leaves its chord.
fn arc_bulge(from: DVec2, to: DVec2, radius: f64) -> f64 {
    let half = from.distance(to) / 2.0;
    radius - (radius * radius - half * half).max(0.0).sqrt()
}

/// Distance from a segment to the clamp's rectangle; 0 inside.
fn distance(clamp: &Clamp, a: DVec2, b: DVec2) -> f64 {
    let (low, high) = (clamp.low, clamp.high);
    if a.cmpge(low).all() && a.cmple(high).all() {
        return 0.0;
    }
    let c = [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)];
    let sides = (0..4).map(|i| segment_distance((c[i], c[(i + 1) % 4]), (a, b)));
    sides.fold(f64::INFINITY, f64::min)
}
