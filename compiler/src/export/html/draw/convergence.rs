//! How planarizing went: the shortfall of planarity after each iteration, worst and mean.

use glam::DVec2;

use super::axis::Axis;
use super::paper::{Anchor, Path, letters, line, svg, text_width};
use crate::export::html::markup::Markup;
use crate::export::report::{HistoryPoint, PlanarizeReport};

/// Shortfalls below this are drawn at this: double precision ends there.
const FLAT: f64 = 1e-12;

/// Points of a line, at most.
const MOST_POINTS: usize = 600;

const LEFT: f64 = 14.0;
const RIGHT: f64 = 18.0;
const TOP: f64 = 3.0;

/// Draws it; `required` is the planarity aimed at.
pub(in crate::export::html) fn convergence(
    page: &mut Markup,
    planarize: &PlanarizeReport,
    required: f64,
    (width, height): (f64, f64),
    at: &str,
) {
    let history = &planarize.history;
    let shortfalls = |of: fn(&HistoryPoint) -> Option<f64>| -> Vec<(usize, f64)> {
        let found = history.iter().enumerate();
        found.filter_map(|(place, point)| Some((place, (1.0 - of(point)?).max(FLAT)))).collect()
    };
    let worst = shortfalls(|point| point.worst.map(|worst| worst.value));
    let mean = shortfalls(|point| point.mean.map(|mean| mean.value));
    let goal = (1.0 - required).max(FLAT);
    let all = || worst.iter().chain(&mean).map(|(_, value)| *value).chain([goal]);
    let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(0.0, f64::max));
    let ground = height - 10.5;
    let y = Axis::logarithmic([low / 1.3, high * 1.3], [ground, TOP]);
    let x = Axis::linear([0.0, history.len().saturating_sub(1) as f64], [LEFT, width - RIGHT]);
    svg(page, (width, height), "Shortfall of planarity after each iteration", |page| {
        for (value, text) in y.ticks(5) {
            let level = y.place(value);
            line(page, DVec2::new(LEFT, level), DVec2::new(width - RIGHT, level), "grid");
            letters(page, DVec2::new(LEFT - 1.5, level + 1.0), 2.8, Anchor::End, "number", &text);
        }
        line(page, DVec2::new(LEFT, ground), DVec2::new(width - RIGHT, ground), "axis");
        for (value, text) in x.ticks(6).into_iter().filter(|(value, _)| value.fract() == 0.0) {
            let place = x.place(value);
            line(page, DVec2::new(place, ground), DVec2::new(place, ground + 1.0), "axis");
            letters(page, DVec2::new(place, ground + 4.2), 2.8, Anchor::Middle, "number", &text);
        }
        let foot = DVec2::new(width - RIGHT, height - 1.4);
        letters(page, foot, 2.8, Anchor::End, "note", "iteration · 1 \u{2212} planarity, logarithmic");
        let level = y.place(goal);
        line(page, DVec2::new(LEFT, level), DVec2::new(width - RIGHT, level), "limit-line");
        let best = x.place(f64::from(planarize.best_iteration));
        line(page, DVec2::new(best, TOP), DVec2::new(best, ground), "chosen");
        let beside = text_width("result", 2.8) + best + 1.0 > width - RIGHT;
        let (place, anchor) = if beside { (best - 1.0, Anchor::End) } else { (best + 1.0, Anchor::Start) };
        letters(page, DVec2::new(place, TOP + 2.2), 2.8, anchor, "note", "result");
        let names = [("mean", &mean), ("worst", &worst)];
        for (name, values) in names {
            curve(page, values, (&x, &y), name, at);
        }
        let mut ends: Vec<(f64, &str, &str)> = names
            .iter()
            .filter_map(|(name, values)| Some((y.place(values.last()?.1), *name, *name)))
            .chain([(level, "asked for", "limit-text")])
            .collect();
        spread(&mut ends);
        for (level, text, class) in ends {
            letters(page, DVec2::new(width - RIGHT + 1.5, level + 1.0), 2.8, Anchor::Start, class, text);
        }
    });
}

fn curve(page: &mut Markup, values: &[(usize, f64)], (x, y): (&Axis, &Axis), class: &str, at: &str) {
    let stride = values.len().div_ceil(MOST_POINTS).max(1);
    let last = values.len().saturating_sub(1);
    let chosen = values.iter().enumerate().filter(|(place, _)| place % stride == 0 || *place == last);
    let points: Vec<DVec2> =
        chosen.map(|(_, &(place, value))| DVec2::new(x.place(place as f64), y.place(value))).collect();
    let mut path = Path::default();
    path.chain(&points, false);
    let points = points.len().to_string();
    path.write(page, &[("class", &format!("curve {class}")), ("data-at", at), ("data-points", &points)]);
}

/// Moves texts apart that would lie on each other: 3.4 mm from base line to base line.
fn spread(ends: &mut [(f64, &str, &str)]) {
    ends.sort_by(|first, second| first.0.total_cmp(&second.0));
    for place in 1..ends.len() {
        let least = ends[place - 1].0 + 3.4;
        ends[place].0 = ends[place].0.max(least);
    }
}
