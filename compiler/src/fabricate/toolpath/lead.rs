//! Leads: tangential arcs by which the tool comes to a contour from the waste side and leaves it to there. The tool
//! never goes up or down on the contour's finished edge.

use super::polygon::Polygon;
use super::program::{Step, Turn};
use crate::fabricate::machine::{CutDirection, Machine};
use glam::DVec2;

/// How far a lead goes sideways, in tool diameters: a sliver, no slot. Less where the finishing allowance is less.
const SIDEWAYS: f64 = 0.08;
/// How far from the contour's path a lead may end where the contour bends away from it, in tool diameters.
const FARTHEST: f64 = 0.1;

/// A tangential arc of one tool diameter's radius between a contour and the waste beside it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lead {
    /// On the contour's centre path.
    pub(super) on: DVec2,
    /// In the waste.
    pub(super) off: DVec2,
    centre: DVec2,
    turn: Turn,
}

impl Lead {
    /// How far leads go sideways, mm.
    pub(super) fn sideways(machine: &Machine) -> f64 {
        let sliver = SIDEWAYS * machine.cutter().diameter;
        match machine.spec().allowance {
            0.0 => sliver,
            allowance => sliver.min(allowance),
        }
    }

    /// How far a lead runs along the contour, mm.
    pub(super) fn along(machine: &Machine) -> f64 {
        let aside = Lead::sideways(machine);
        (aside * (2.0 * machine.cutter().diameter - aside)).sqrt()
    }

    /// From the contour at `on`, where it runs in direction `u`, out to the waste.
    pub(super) fn out(machine: &Machine, on: DVec2, u: DVec2) -> Lead {
        Lead::new(machine, on, u, Lead::along(machine))
    }

    /// From the waste onto the contour at `on`, where it runs in direction `u`.
    pub(super) fn into(machine: &Machine, on: DVec2, u: DVec2) -> Lead {
        Lead::new(machine, on, u, -Lead::along(machine))
    }

    fn new(machine: &Machine, on: DVec2, u: DVec2, along: f64) -> Lead {
        let (waste, turn) = match machine.spec().direction {
            CutDirection::Climb => (u.perp(), Turn::Anticlockwise),
            CutDirection::Conventional => (-u.perp(), Turn::Clockwise),
        };
        let off = on + u * along + waste * Lead::sideways(machine);
        Lead { on, off, centre: on + waste * machine.cutter().diameter, turn }
    }

    /// The arc to one of its ends.
    pub(super) fn step(&self, to: DVec2, z: f64, feed: f64) -> Step {
        Step::Arc { to: to.extend(z), radius: self.centre.distance(self.on), turn: self.turn, feed }
    }

    /// Whether the tool stays clear of all parts on the arc, its centre over the stock, and takes but a sliver beside the
    /// contour of `part`.
    pub(super) fn is_free(&self, machine: &Machine, outlines: &[Polygon], part: usize, stock: DVec2) -> bool {
        let radius = machine.cutter().diameter / 2.0;
        let farthest = (FARTHEST * machine.cutter().diameter).max(machine.spec().allowance);
        if outlines[part].distance_to_boundary(self.off, self.off) > radius + farthest {
            return false;
        }
        let over = |p: DVec2| p.cmpge(DVec2::ZERO).all() && p.cmple(stock).all();
        let clear = |outline: &Polygon, (a, b): (DVec2, DVec2)| {
            let (low, high) = outline.bounds();
            let far = (low - a.max(b)).max(a.min(b) - high).max_element() > radius;
            far || (!outline.contains(b) && outline.distance_to_boundary(a, b) >= radius - 1e-6)
        };
        let points = self.points();
        let chords: Vec<_> = points.windows(2).map(|pair| (pair[0], pair[1])).collect();
        over(self.off) && outlines.iter().all(|outline| chords.iter().all(|&chord| clear(outline, chord)))
    }

    /// Points of the arc, so near to each other that chords are within a hundredth of a mm of it.
    fn points(&self) -> Vec<DVec2> {
        let (a, b) = (self.on - self.centre, self.off - self.centre);
        let radius = a.length();
        let out = |t: f64| self.centre + (a * (1.0 - t) + b * t).normalize_or_zero() * radius;
        (0..=8).map(|i| out(f64::from(i) / 8.0)).collect()
    }
}
