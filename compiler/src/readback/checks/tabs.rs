//! Tabs are as many as asked, each on one straight edge clear of its corners, as wide and as high as asked; no cut goes
//! into one.

use crate::fabricate::machine::Fixing;
use crate::readback::cuts::{Cut, HEIGHT};
use crate::readback::geometry::{Segment, between, edges};
use crate::readback::{Expected, Fault, FaultKind, OUTLINE_TOLERANCE};
use glam::DVec2;

/// The way over one tab.
struct Bridge {
    line: usize,
    from: DVec2,
    to: DVec2,
    straight: bool,
}

/// `way`: the last closed way around the part. `contour`: all cuts of its contour.
pub(in crate::readback) fn check(
    way: &[Cut],
    contour: &[Cut],
    expected: &Expected,
    part: usize,
    faults: &mut Vec<Fault>,
) {
    let (Fixing::Tabs { count, width, .. }, Some(top)) = (expected.machine.spec().fixing, expected.tab_top())
    else {
        return;
    };
    let line = way.first().map_or(0, |cut| cut.made.line);
    let bridges = bridges(way, top);
    if bridges.len() != count as usize {
        let message = format!("leaves {} tabs, {count} were asked for", bridges.len());
        faults.push(Fault::measured(FaultKind::Tabs, line, bridges.len() as f64, message));
    }
    let radius = expected.cutter_radius();
    for bridge in &bridges {
        let left = bridge.from.distance(bridge.to) - 2.0 * radius;
        if (left - width).abs() > OUTLINE_TOLERANCE {
            let message = format!("leaves a tab {left:.3} mm wide, {width:.3} mm was asked for");
            faults.push(Fault::measured(FaultKind::Tabs, bridge.line, left, message));
            continue;
        }
        if !bridge.straight || !beside_one_edge(bridge, &expected.parts[part].outline, radius) {
            faults.push(Fault::new(FaultKind::Tabs, bridge.line, "has a tab at a corner"));
        }
        let u = (bridge.to - bridge.from) / bridge.from.distance(bridge.to);
        let middle = (bridge.from + u * radius, bridge.to - u * radius);
        let into =
            |cut: &&Cut| cut.lowest() < top - HEIGHT && reach(cut, middle) < radius - OUTLINE_TOLERANCE;
        if let Some(cut) = contour.iter().find(into) {
            faults.push(Fault::new(FaultKind::Tabs, cut.made.line, "cuts into a tab"));
        }
    }
}

fn reach(cut: &Cut, tab: Segment) -> f64 {
    let points = cut.piece.flat();
    points.windows(2).map(|pair| between((pair[0], pair[1]), tab)).fold(f64::INFINITY, f64::min)
}

/// Stretches at the tabs' height, those that follow each other as one.
fn bridges(way: &[Cut], top: f64) -> Vec<Bridge> {
    let mut out: Vec<Bridge> = Vec::new();
    for cut in way.iter().filter(|cut| (cut.highest() - top).abs() < HEIGHT) {
        let (from, to) = (cut.piece.from.truncate(), cut.piece.to.truncate());
        let straight = cut.piece.circle().is_none();
        match out.last_mut().filter(|last| last.to.distance(from) < HEIGHT) {
            Some(last) => {
                // Two stretches over one tab: it lies on a corner.
                (last.to, last.straight) = (to, false);
            }
            None => out.push(Bridge { line: cut.made.line, from, to, straight }),
        }
    }
    out
}

/// Whether both ends lie beside the same edge, at the radius from it.
fn beside_one_edge(bridge: &Bridge, outline: &[DVec2], radius: f64) -> bool {
    edges(outline).any(|(a, b)| {
        let (length, u) = (a.distance(b), (b - a) / a.distance(b));
        [bridge.from, bridge.to].into_iter().all(|p| {
            let at = u.dot(p - a);
            (0.0..=length).contains(&at) && (-u.perp_dot(p - a) - radius).abs() < OUTLINE_TOLERANCE
        })
    })
}
