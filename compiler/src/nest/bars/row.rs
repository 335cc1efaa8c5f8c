//! Planks one after the other on a bar: in which order and which way round, so that neighbours share their cuts.

use super::{Bar, Cut, Placed, Plank, Stock};

/// Cuts that part by less than this at the faces of a bar are one, mm.
const SAME: f64 = 1e-6;

/// A cut: how far it runs ahead of the axis, mm, at the upper end of the depth and at that of the width; and what the
/// blade takes along the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Slant {
    lean: f64,
    tilt: f64,
    ahead: [f64; 2],
    blade: f64,
}

impl Slant {
    /// The plane through the axis whose normal leans by `lean` and is tilted by `tilt`.
    fn of(lean: f64, tilt: f64, stock: &Stock) -> Self {
        let (cosine, square) = (libm::cos(lean), libm::cos(tilt));
        let ahead = [-libm::tan(lean) * stock.depth / 2.0, -libm::tan(tilt) / cosine * stock.width / 2.0];
        Self { lean, tilt, ahead, blade: stock.kerf / (cosine * square) }
    }

    fn turned_over(self) -> Self {
        let [depth, width] = self.ahead;
        // Not plain negatives: 0 stays 0.
        Self { lean: 0.0 - self.lean, tilt: 0.0 - self.tilt, ahead: [0.0 - depth, 0.0 - width], ..self }
    }

    fn end_first(self) -> Self {
        let [depth, width] = self.ahead;
        Self { tilt: 0.0 - self.tilt, ahead: [depth, 0.0 - width], ..self }
    }

    /// How far it reaches to each side of the axis, mm.
    fn reach(self) -> f64 {
        self.ahead[0].abs() + self.ahead[1].abs()
    }

    /// How far two cuts through one point of the axis part at the faces of the bar, mm.
    fn parts_from(self, other: Slant) -> f64 {
        (self.ahead[0] - other.ahead[0]).abs() + (self.ahead[1] - other.ahead[1]).abs()
    }

    fn is_square(self) -> bool {
        self.reach() == 0.0
    }
}

/// A plank the way round it lies.
#[derive(Debug, Clone, Copy)]
struct Lying {
    plank: usize,
    end_first: bool,
    turned_over: bool,
    slants: [Slant; 2],
}

/// A plank in each way it can lie; square and even ones only once.
fn ways(planks: &[Plank], plank: usize, stock: &Stock) -> Vec<Lying> {
    let Plank { mitres, bevels, .. } = planks[plank];
    let [start, end] = [0, 1].map(|end| Slant::of(mitres[end], bevels[end], stock));
    let mut ways: Vec<Lying> = Vec::new();
    for (end_first, turned_over) in [(false, false), (false, true), (true, false), (true, true)] {
        let slants = if end_first { [end.end_first(), start.end_first()] } else { [start, end] };
        let slants = if turned_over { slants.map(Slant::turned_over) } else { slants };
        if ways.iter().all(|way| way.slants != slants) {
            ways.push(Lying { plank, end_first, turned_over, slants });
        }
    }
    ways
}

/// Whether one stroke makes both faces.
fn shared(before: Slant, after: Slant) -> bool {
    before.parts_from(after) < SAME
}

/// From the end of one plank to the start of the next, on the axis, mm.
fn between(before: Slant, after: Slant) -> f64 {
    let wedge = if shared(before, after) { 0.0 } else { before.parts_from(after) };
    wedge + before.blade.max(after.blade)
}

/// The length of bar that a plank takes on its own, without trims, mm.
pub(super) fn alone(plank: &Plank, stock: &Stock) -> f64 {
    let reach = |end: usize| Slant::of(plank.mitres[end], plank.bevels[end], stock).reach();
    plank.length + reach(0) + reach(1)
}

/// These planks on one bar; none where they are too long together.
pub(super) fn row(planks: &[Plank], chosen: &[usize], stock: &Stock) -> Option<Bar> {
    let lying: Vec<Vec<Lying>> = chosen.iter().map(|&plank| ways(planks, plank, stock)).collect();
    let mut best: Option<(f64, Vec<Lying>)> = None;
    // From every plank first where that is quick, each time going on with the one that follows nearest.
    let starts = if chosen.len() <= 12 { chosen.len() } else { 1 };
    for start in 0..starts {
        for &first in &lying[start] {
            let (needed, order) = from(first, start, &lying, planks);
            if best.as_ref().is_none_or(|(least, _)| needed < *least - 1e-9) {
                best = Some((needed, order));
            }
        }
    }
    let (needed, order) = best?;
    (needed <= stock.length - 2.0 * stock.trim).then(|| bar(&order, planks, stock))
}

/// The row that starts with a plank and goes on with the nearest one, and its length.
fn from(first: Lying, start: usize, lying: &[Vec<Lying>], planks: &[Plank]) -> (f64, Vec<Lying>) {
    let mut order = vec![first];
    let mut left: Vec<usize> = (0..lying.len()).filter(|&place| place != start).collect();
    let mut needed = first.slants[0].reach() + planks[first.plank].length;
    let mut last = first.slants[1];
    while !left.is_empty() {
        let mut best: Option<(f64, usize, Lying)> = None;
        for (index, &place) in left.iter().enumerate() {
            for &way in &lying[place] {
                let space = between(last, way.slants[0]);
                if best.as_ref().is_none_or(|(least, ..)| space < *least - 1e-9) {
                    best = Some((space, index, way));
                }
            }
        }
        let Some((space, index, way)) = best else { break };
        left.remove(index);
        needed += space + planks[way.plank].length;
        last = way.slants[1];
        order.push(way);
    }
    (needed + last.reach(), order)
}

fn bar(order: &[Lying], planks: &[Plank], stock: &Stock) -> Bar {
    let mut bar = Bar::default();
    let cut =
        |at: f64, slant: Slant| Cut { at, lean: slant.lean, tilt: slant.tilt, before: None, after: None };
    let mut last: Option<(f64, Lying)> = None;
    for way in order {
        let [first, second] = way.slants;
        let start = match last {
            None => stock.trim + first.reach(),
            Some((end, before)) => end + between(before.slants[1], first),
        };
        let own = Cut { after: Some(way.plank), ..cut(start, first) };
        match last {
            None if start > 0.0 => bar.cuts.push(own),
            None => {}
            Some((end, before)) => {
                let one = shared(before.slants[1], first);
                let after = one.then_some(way.plank);
                bar.cuts.push(Cut { before: Some(before.plank), after, ..cut(end, before.slants[1]) });
                if !one {
                    bar.cuts.push(own);
                }
            }
        }
        let end = start + planks[way.plank].length;
        bar.planks.push(Placed {
            plank: way.plank,
            end_first: way.end_first,
            turned_over: way.turned_over,
            at: [start, end],
            leans: [first.lean, second.lean],
            tilts: [first.tilt, second.tilt],
        });
        last = Some((end, *way));
    }
    if let Some((end, way)) = last {
        let slant = way.slants[1];
        let reached = end + slant.reach();
        if stock.length - reached > SAME || !slant.is_square() {
            bar.cuts.push(Cut { before: Some(way.plank), ..cut(end, slant) });
        }
        bar.offcut = (stock.length - reached - slant.blade).max(0.0);
    }
    bar
}
