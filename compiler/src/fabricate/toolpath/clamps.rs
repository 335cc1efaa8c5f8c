//! No tool comes into a clamp: below its top, tools stay clear of it by their radius.

use super::polygon::segment_distance;
use super::program::Step;
use super::{Refusal, Steps};
use crate::fabricate::machine::Clamp;
use glam::{DVec2, DVec3};

/// Checks all steps against all clamps of the machine.
///
/// # Errors
/// The first clamp that is touched, and where.
pub(super) fn check(steps: &Steps) -> Result<(), Refusal> {
    let spec = steps.machine.spec();
    if spec.clamps.is_empty() {
        return Ok(());
    }
    let (mut at, mut radius) = (DVec3::ZERO, 0.0);
    for step in &steps.out {
        let to = match step {
            Step::LoadTool { number } => {
                let tool = spec.tools.iter().find(|tool| tool.number == *number);
                radius = tool.map_or(0.0, |tool| tool.diameter / 2.0);
                continue;
            }
            Step::RapidZ { z } => at.truncate().extend(*z),
            Step::RapidXY { to } => to.extend(at.z),
            Step::Line { to, .. } | Step::Arc { to, .. } => *to,
            _ => continue,
        };
        let bulge = if let Step::Arc { radius, .. } = step { arc_bulge(at, to, *radius) } else { 0.0 };
        let low = at.z.min(to.z) - steps.top();
        for (index, clamp) in spec.clamps.iter().enumerate() {
            if low < clamp.height && distance(clamp, at.truncate(), to.truncate()) < radius + bulge {
                return Err(Refusal::Clamped { clamp: index, x: to.x, y: to.y });
            }
        }
        at = to;
    }
    Ok(())
}

/// How far an arc of at most a half turn leaves its chord.
fn arc_bulge(from: DVec3, to: DVec3, radius: f64) -> f64 {
    let half = from.truncate().distance(to.truncate()) / 2.0;
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
