//! Passes around the outer contour: down a ramp along the path, around, and once more over the ramp at full depth; then,
//! where stock was left for it, a last pass along the finished edge. The tool never comes down on the part's side of
//! the path, and leaves it by a tangential arc.

use super::lead::Lead;
use super::offset;
use super::passes::{Opening, Piece, along, around, opening, ramp_and_rest};
use super::polygon::Polygon;
use super::program::{Step, Turn};
use super::tabs::{self, Zone};
use super::{Refusal, Steps};
use crate::fabricate::machine::CutDirection;
use glam::DVec2;

/// Slopes of the ramp that are tried in turn: a gentle one as long as the path has room, steeper ones where tabs need
/// it.
const SLOPES: [f64; 3] = [0.1, 0.16, 0.25];
/// Steepest ramp; shorter paths take more passes instead.
const STEEPEST_SLOPE: f64 = 0.25;
/// Part of the path a ramp may take.
const RAMP_SHARE: f64 = 0.5;
/// Most passes a contour may take.
const MOST_PASSES: f64 = 200.0;
/// Most sides over all passes: keeps programs readable by machines and by read-back.
const MOST_SIDES: f64 = 10_000.0;
/// Height above the stock where the descent slows from feed to plunge, mm.
pub(super) const APPROACH: f64 = 1.0;

/// How the passes go around.
struct Plan {
    /// Down to the next pass.
    ramp: Vec<Piece>,
    /// Level, from the opening to the ramp.
    rest: Vec<Piece>,
    opening: Opening,
    zones: Vec<Zone>,
    passes: u32,
}

/// Cuts the contour of one of the parts in equal passes.
///
/// # Errors
/// `TooManyPasses` if more than 200 passes, or 10,000 sides in all, were needed; what `offset` and `tabs` refuse.
pub(super) fn cut(steps: &mut Steps, outlines: &[Polygon], part: usize, stock: DVec2) -> Result<(), Refusal> {
    let (machine, outline) = (steps.machine, &outlines[part]);
    let (tool, spec) = (machine.cutter(), machine.spec());
    let radius = tool.diameter / 2.0;
    let finished = offset::outward(outline, radius)?;
    let rough = match spec.allowance {
        0.0 => finished.clone(),
        allowance => offset::outward_with(outline, radius + allowance, f64::INFINITY)?,
    };
    let plan = plan(steps, outline, &rough)?;
    let mut cutting = Cutting::new(steps, outline, &plan.zones, rough.radius);
    cutting.passes(&plan);
    let around = match spec.allowance {
        0.0 => plan.rest,
        _ => cutting.finish(&around(outline, &finished, plan.opening, spec.direction), outlines, part, stock),
    };
    if let Some(first) = around.first().filter(|piece| !piece.arc) {
        let lead = Lead::out(machine, first.from, (first.to - first.from) / first.length);
        if lead.is_free(machine, outlines, part, stock) {
            let z = machine.bottom(steps.thickness);
            steps.out.push(lead.step(lead.off, z, tool.feed));
        }
    }
    steps.retract();
    Ok(())
}

/// The number of passes, and where ramp and tabs go.
fn plan(steps: &Steps, outline: &Polygon, path: &offset::CentrePath) -> Result<Plan, Refusal> {
    let (machine, direction) = (steps.machine, steps.machine.spec().direction);
    let depth = steps.top() - machine.bottom(steps.thickness);
    let length: f64 = around(outline, path, opening(outline, path, 0.0, direction), direction)
        .iter()
        .map(|p| p.length)
        .sum();
    let room = RAMP_SHARE * length;
    let passes = (depth / machine.cutter().max_step_down - 1e-9)
        .ceil()
        .max((depth / (room * STEEPEST_SLOPE) - 1e-9).ceil());
    if passes > MOST_PASSES || passes * path.sides.len() as f64 > MOST_SIDES {
        return Err(Refusal::TooManyPasses { passes, sides: path.sides.len() });
    }
    // Room for leading in and out, and for the tool beside them.
    let reserved = 2.0 * Lead::along(machine) + machine.cutter().diameter;
    let mut refusal = None;
    for slope in SLOPES {
        let ramp = room.min(depth / passes / slope);
        let opening = opening(outline, path, ramp, direction);
        let (ramp, rest) = ramp_and_rest(around(outline, path, opening, direction), ramp);
        match tabs::place(machine, outline, &rest, reserved) {
            Ok(zones) => return Ok(Plan { ramp, rest, opening, zones, passes: passes as u32 }),
            Err(error) => refusal = Some(error),
        }
    }
    Err(refusal.unwrap_or(Refusal::TooManyPasses { passes, sides: path.sides.len() }))
}

/// Steps along pieces of one path, raised over tabs.
struct Cutting<'s, 'a> {
    steps: &'s mut Steps<'a>,
    outline: &'s Polygon,
    zones: &'s [Zone],
    radius: f64,
    bottom: f64,
    feed: f64,
    plunge: f64,
}

impl<'s, 'a> Cutting<'s, 'a> {
    fn new(steps: &'s mut Steps<'a>, outline: &'s Polygon, zones: &'s [Zone], radius: f64) -> Self {
        let tool = steps.machine.cutter();
        let (bottom, feed) = (steps.machine.bottom(steps.thickness), tool.feed);
        let plunge = tool.plunge.min(tool.feed);
        Cutting { steps, outline, zones, radius, bottom, feed, plunge }
    }

    /// All passes of the plan, and the last ramp once more at full depth.
    fn passes(&mut self, plan: &Plan) {
        let top = self.steps.top();
        let step = (top - self.bottom) / f64::from(plan.passes);
        let ramp_length: f64 = plan.ramp.iter().map(|p| p.length).sum();
        // Downwards no faster than the plunge feed.
        let slant = (ramp_length * ramp_length + step * step).sqrt();
        let ramp_feed = self.feed.min(self.plunge * slant / step);
        let start = plan.ramp.first().map_or(DVec2::ZERO, |piece| piece.from);
        self.steps.note(format!("outer contour, passes: {}", plan.passes));
        self.steps.rapid(start);
        self.steps.line(start.extend(top + APPROACH), self.feed);
        self.steps.line(start.extend(top), self.plunge);
        for pass in 1..=plan.passes {
            let above = top - step * f64::from(pass - 1);
            let z = if pass == plan.passes { self.bottom } else { top - step * f64::from(pass) };
            let mut gone = 0.0;
            for (i, piece) in plan.ramp.iter().enumerate() {
                gone += piece.length;
                let last = i + 1 == plan.ramp.len();
                let to = if last { z } else { above + (z - above) * (gone / ramp_length) };
                self.go(piece, to, ramp_feed);
            }
            plan.rest.iter().for_each(|piece| self.level(piece, z));
        }
        plan.ramp.iter().for_each(|piece| self.go(piece, self.bottom, self.feed));
    }

    /// From the passes' end on to the finished edge and around it. Gives the way around.
    fn finish(&mut self, around: &[Piece], outlines: &[Polygon], part: usize, stock: DVec2) -> Vec<Piece> {
        let machine = self.steps.machine;
        let Some(&first) = around.first() else { return Vec::new() };
        self.radius = machine.cutter().diameter / 2.0;
        self.steps.note("finishing pass".to_owned());
        let ahead = Lead::along(machine);
        let mut pieces = around.to_vec();
        // The lead comes onto the path a little ahead of the opening; the way around then ends there.
        if !first.arc && first.length > ahead {
            let u = (first.to - first.from) / first.length;
            let on = first.from + u * ahead;
            let lead = Lead::into(machine, on, u);
            if lead.is_free(machine, outlines, part, stock) {
                self.steps.line(lead.off.extend(self.bottom), self.feed);
                self.steps.out.push(lead.step(on, self.bottom, self.feed));
                pieces[0] = Piece { from: on, length: first.length - ahead, ..first };
                pieces.push(Piece { to: on, length: ahead, ..first });
            }
        }
        // Without room for a lead, straight over the allowance: nothing where the tool stands there already.
        self.steps.line(pieces[0].from.extend(self.bottom), self.feed);
        pieces.iter().for_each(|piece| self.level(piece, self.bottom));
        pieces
    }

    fn go(&mut self, piece: &Piece, z: f64, feed: f64) {
        let (to, radius) = (piece.to.extend(z), self.radius);
        let turn = match self.steps.machine.spec().direction {
            CutDirection::Climb => Turn::Clockwise,
            CutDirection::Conventional => Turn::Anticlockwise,
        };
        self.steps.out.push(if piece.arc {
            Step::Arc { to, radius, turn, feed }
        } else {
            Step::Line { to, feed }
        });
    }

    /// Along the piece at one height, up and down again at tabs that are higher.
    fn level(&mut self, piece: &Piece, z: f64) {
        let raised = self.steps.machine.tab_top(self.steps.thickness).filter(|&top| z < top);
        if let Some(top) = raised.filter(|_| !piece.arc) {
            for (from, to) in self.over(piece) {
                self.steps.line(from.extend(z), self.feed);
                self.steps.line(from.extend(top), self.feed);
                self.steps.line(to.extend(top), self.feed);
                self.steps.line(to.extend(z), self.plunge);
            }
        }
        self.go(piece, z, self.feed);
    }

    /// Where the path is raised along this piece, in the direction of cutting.
    fn over(&self, piece: &Piece) -> Vec<(DVec2, DVec2)> {
        let edge = piece.edge;
        let (start, end) = (along(self.outline, edge, piece.from), along(self.outline, edge, piece.to));
        let (low, high) = (start.min(end), start.max(end));
        let at = |u: f64| piece.from + (piece.to - piece.from) * ((u - start) / (end - start));
        let on = self.zones.iter().filter(|z| z.edge == edge && z.from >= low && z.to <= high);
        let mut zones: Vec<(f64, f64)> = on.map(|z| (z.from, z.to)).collect();
        zones.sort_by(|a, b| a.0.total_cmp(&b.0));
        if start > end {
            zones = zones.iter().rev().map(|&(from, to)| (to, from)).collect();
        }
        zones.into_iter().map(|(from, to)| (at(from), at(to))).collect()
    }
}
