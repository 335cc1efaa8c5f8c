//! Planks one after the other on a bar: in which order and which way round, so that neighbours share their cuts.

use super::{Bar, Cut, Placed, Plank, Stock};

/// Cuts whose slopes differ by less than this are one, mm over the depth of a bar.
const SAME: f64 = 1e-6;

/// A plank the way round it lies: the slopes dx/dy of its two cuts.
#[derive(Debug, Clone, Copy)]
struct Lying {
    plank: usize,
    end_first: bool,
    turned_over: bool,
    leans: [f64; 2],
}

/// A plank in each way it can lie; square and even ones only once.
fn ways(planks: &[Plank], plank: usize) -> Vec<Lying> {
    let [start, end] = planks[plank].mitres;
    let mut ways: Vec<Lying> = Vec::new();
    for (end_first, turned_over) in [(false, false), (false, true), (true, false), (true, true)] {
        let leans = if end_first { [end, start] } else { [start, end] };
        let leans = if turned_over { leans.map(|lean| 0.0 - lean) } else { leans };
        if ways.iter().all(|way| way.leans != leans) {
            ways.push(Lying { plank, end_first, turned_over, leans });
        }
    }
    ways
}

/// How far a leaning cut reaches to each side of the axis, mm.
fn reach(lean: f64, stock: &Stock) -> f64 {
    libm::tan(lean).abs() * stock.depth / 2.0
}

/// What the blade takes along the axis, mm.
fn along_axis(lean: f64, stock: &Stock) -> f64 {
    stock.kerf / libm::cos(lean)
}

/// Whether one stroke makes both faces.
fn shared(before: f64, after: f64, stock: &Stock) -> bool {
    (libm::tan(before) - libm::tan(after)).abs() * stock.depth < SAME
}

/// From the end of one plank to the start of the next, on the axis, mm.
fn between(before: f64, after: f64, stock: &Stock) -> f64 {
    let wedge = match shared(before, after, stock) {
        true => 0.0,
        false => (libm::tan(before) - libm::tan(after)).abs() * stock.depth / 2.0,
    };
    wedge + along_axis(before, stock).max(along_axis(after, stock))
}

/// The length of bar that a plank takes on its own, without trims, mm.
pub(super) fn alone(plank: &Plank, stock: &Stock) -> f64 {
    plank.length + reach(plank.mitres[0], stock) + reach(plank.mitres[1], stock)
}

/// These planks on one bar; none where they are too long together.
pub(super) fn row(planks: &[Plank], chosen: &[usize], stock: &Stock) -> Option<Bar> {
    let lying: Vec<Vec<Lying>> = chosen.iter().map(|&plank| ways(planks, plank)).collect();
    let mut best: Option<(f64, Vec<Lying>)> = None;
    // From every plank first where that is quick, each time going on with the one that follows nearest.
    let starts = if chosen.len() <= 12 { chosen.len() } else { 1 };
    for start in 0..starts {
        for &first in &lying[start] {
            let (needed, order) = from(first, start, &lying, planks, stock);
            if best.as_ref().is_none_or(|(least, _)| needed < *least - 1e-9) {
                best = Some((needed, order));
            }
        }
    }
    let (needed, order) = best?;
    (needed <= stock.length - 2.0 * stock.trim).then(|| bar(&order, planks, stock))
}

/// The row that starts with a plank and goes on with the nearest one, and its length.
fn from(
    first: Lying,
    start: usize,
    lying: &[Vec<Lying>],
    planks: &[Plank],
    stock: &Stock,
) -> (f64, Vec<Lying>) {
    let mut order = vec![first];
    let mut left: Vec<usize> = (0..lying.len()).filter(|&place| place != start).collect();
    let mut needed = reach(first.leans[0], stock) + planks[first.plank].length;
    let mut last = first.leans[1];
    while !left.is_empty() {
        let mut best: Option<(f64, usize, Lying)> = None;
        for (index, &place) in left.iter().enumerate() {
            for &way in &lying[place] {
                let space = between(last, way.leans[0], stock);
                if best.as_ref().is_none_or(|(least, ..)| space < *least - 1e-9) {
                    best = Some((space, index, way));
                }
            }
        }
        let Some((space, index, way)) = best else { break };
        left.remove(index);
        needed += space + planks[way.plank].length;
        last = way.leans[1];
        order.push(way);
    }
    (needed + reach(last, stock), order)
}

fn bar(order: &[Lying], planks: &[Plank], stock: &Stock) -> Bar {
    let mut bar = Bar::default();
    let mut last: Option<(f64, Lying)> = None;
    for way in order {
        let start = match last {
            None => stock.trim + reach(way.leans[0], stock),
            Some((end, before)) => end + between(before.leans[1], way.leans[0], stock),
        };
        let own = |at| Cut { at, lean: way.leans[0], before: None, after: Some(way.plank) };
        match last {
            None if start > 0.0 => bar.cuts.push(own(start)),
            None => {}
            Some((end, before)) => {
                let one = shared(before.leans[1], way.leans[0], stock);
                let after = one.then_some(way.plank);
                bar.cuts.push(Cut { at: end, lean: before.leans[1], before: Some(before.plank), after });
                if !one {
                    bar.cuts.push(own(start));
                }
            }
        }
        let end = start + planks[way.plank].length;
        bar.planks.push(Placed {
            plank: way.plank,
            end_first: way.end_first,
            turned_over: way.turned_over,
            at: [start, end],
            leans: way.leans,
        });
        last = Some((end, *way));
    }
    if let Some((end, way)) = last {
        let reached = end + reach(way.leans[1], stock);
        if stock.length - reached > SAME || way.leans[1] != 0.0 {
            bar.cuts.push(Cut { at: end, lean: way.leans[1], before: Some(way.plank), after: None });
        }
        bar.offcut = (stock.length - reached - along_axis(way.leans[1], stock)).max(0.0);
    }
    bar
}
