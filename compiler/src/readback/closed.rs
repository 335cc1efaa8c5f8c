//! The last closed way around a part: what is left is what it leaves.

use super::Expected;
use super::cuts::{Cut, HEIGHT};
use glam::DVec2;

/// Ends of the path that are this near meet, mm.
const MEETS: f64 = 0.0015;
/// A way around encloses more than this, mm².
const LEAST_AREA: f64 = 0.01;

/// The last closed way around at full depth, raised at most over tabs; else the greatest gap in what there is, mm,
/// infinite if there is nothing. `cuts` are those of the part's contour, in order.
pub(super) fn last_way<'a>(cuts: &[Cut<'a>], expected: &Expected) -> Result<Vec<Cut<'a>>, f64> {
    let at = |cut: &Cut, z: f64| (cut.lowest() - z).abs() < HEIGHT && (cut.highest() - z).abs() < HEIGHT;
    let deep = |cut: &Cut| cut.highest() <= expected.bottom() + HEIGHT;
    let level = |cut: &&Cut| deep(cut) || expected.tab_top().is_some_and(|z| at(cut, z));
    let moved = |cut: &&Cut| cut.piece.from.truncate() != cut.piece.to.truncate();
    let path: Vec<Cut> = cuts.iter().copied().filter(|cut| level(&cut) && moved(&cut)).collect();
    let (from, to) = (|i: usize| path[i].piece.from.truncate(), |i: usize| path[i].piece.to.truncate());
    for last in (0..path.len()).rev() {
        for first in (0..=last).rev() {
            if first < last && to(first).distance(from(first + 1)) > MEETS {
                break;
            }
            if from(first).distance(to(last)) <= MEETS && area(&path[first..=last]).abs() > LEAST_AREA {
                return Ok(path[first..=last].to_vec());
            }
        }
    }
    let ends = (0..path.len()).map(|i| to(i).distance(from((i + 1) % path.len())));
    Err(ends.fold(f64::NEG_INFINITY, f64::max).abs())
}

/// Area enclosed by the stretches' ends, mm², anticlockwise positive.
fn area(path: &[Cut]) -> f64 {
    let points: Vec<DVec2> = path.iter().map(|cut| cut.piece.from.truncate()).collect();
    let Some(&o) = points.first() else { return 0.0 };
    let middle = |cut: &Cut| cut.piece.at(0.5).truncate();
    // Arcs count with their middles, so that a circle of two arcs has an area.
    let with_middles: Vec<DVec2> = points.iter().zip(path).flat_map(|(&p, cut)| [p, middle(cut)]).collect();
    let next = with_middles.iter().cycle().skip(1);
    with_middles.iter().zip(next).map(|(&a, &b)| (a - o).perp_dot(b - o)).sum::<f64>() / 2.0
}
