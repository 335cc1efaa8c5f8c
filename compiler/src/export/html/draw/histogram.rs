//! A distribution as bars over an axis, with the limits it is held against.

use glam::DVec2;

use super::axis::Axis;
use super::paper::{Anchor, group, letters, line, svg, text_width};
use crate::export::html::markup::Markup;
use crate::export::html::number::{coordinate, count, counted};
use crate::export::report::Distribution;

/// Limits further from the figures than this many times their spread are not drawn to scale: an arrow points at them.
const FAR: f64 = 4.0;

/// What a histogram shows.
#[derive(Debug, Clone)]
pub(in crate::export::html) struct Histogram<'a> {
    /// What it shows, for those who cannot see it.
    pub(in crate::export::html) title: &'a str,
    /// The counts, and their place in report.json.
    pub(in crate::export::html) distribution: &'a Distribution,
    /// Their place in report.json.
    pub(in crate::export::html) at: &'a str,
    /// What is under the axis: `edge, mm`.
    pub(in crate::export::html) axis_title: &'a str,
    /// What is counted: `board`.
    pub(in crate::export::html) noun: &'a str,
    /// The limits.
    pub(in crate::export::html) limits: &'a [LimitLine],
    /// The count at the top; none for the largest of these.
    pub(in crate::export::html) most: Option<usize>,
    /// Its size on paper, mm.
    pub(in crate::export::html) size: (f64, f64),
}

/// A limit on an axis.
#[derive(Debug, Clone)]
pub(in crate::export::html) struct LimitLine {
    /// Where.
    pub(in crate::export::html) value: f64,
    /// What is written at it: `at least 150 mm`.
    pub(in crate::export::html) text: String,
    /// Whether values below fail.
    pub(in crate::export::html) fails_below: bool,
    /// Whether values above fail.
    pub(in crate::export::html) fails_above: bool,
}

const LEFT: f64 = 12.0;
const RIGHT: f64 = 3.0;
const FOOT: f64 = 10.5;

/// Draws it.
pub(in crate::export::html) fn histogram(page: &mut Markup, shown: &Histogram<'_>) {
    let (width, height) = shown.size;
    let axis = axis_of(shown, [LEFT, width - RIGHT]);
    let head = 2.5 + 4.0 * shown.limits.len() as f64;
    let ground = height - FOOT;
    let most = shown.most.unwrap_or_else(|| shown.distribution.counts.iter().copied().max().unwrap_or(0));
    svg(page, shown.size, shown.title, |page| {
        bars(page, shown, &axis, (head, ground), most);
        line(page, DVec2::new(LEFT, ground), DVec2::new(width - RIGHT, ground), "axis");
        for (value, text) in axis.ticks(((width - LEFT) / 24.0) as usize) {
            let x = axis.place(value);
            line(page, DVec2::new(x, ground), DVec2::new(x, ground + 1.0), "axis");
            letters(page, DVec2::new(x, ground + 4.2), 2.8, Anchor::Middle, "number", &text);
        }
        letters(page, DVec2::new(width - RIGHT, height - 1.4), 2.8, Anchor::End, "note", shown.axis_title);
        letters(page, DVec2::new(LEFT - 1.5, head + 2.2), 2.8, Anchor::End, "number", &count(most));
        letters(page, DVec2::new(LEFT - 1.5, ground), 2.8, Anchor::End, "number", "0");
        for (place, limit) in shown.limits.iter().enumerate() {
            limit_line(page, &axis, limit, (3.2 + 4.0 * place as f64, ground), (LEFT, width - RIGHT));
        }
    });
}

/// The axis around the counts, and around the limits that are near enough.
fn axis_of(shown: &Histogram<'_>, paper: [f64; 2]) -> Axis {
    let (low, high) = (shown.distribution.low.value, shown.distribution.high.value);
    let spread = (high - low).max(high.abs() * 1e-3).max(f64::MIN_POSITIVE);
    let near = |value: &f64| match shown.distribution.logarithmic {
        true => *value > 0.0 && *value > low / 1e3 && *value < high * 1e3,
        false => *value >= low - FAR * spread && *value <= high + FAR * spread,
    };
    let limits = || shown.limits.iter().map(|limit| limit.value).filter(near);
    let from = limits().fold(low, f64::min);
    let to = limits().fold(high, f64::max);
    if shown.distribution.logarithmic {
        Axis::logarithmic([from / 1.15, to * 1.15], paper)
    } else {
        let one = shown.distribution.counts.len() == 1 && from == low && to == high;
        let margin = if one { 0.05 * to.abs().max(1.0) } else { 0.03 * (to - from) };
        // Lengths and angles have no values below 0 to leave room for.
        let from = if from >= 0.0 { (from - margin).max(0.0) } else { from - margin };
        Axis::linear([from, to + margin], paper)
    }
}

fn bars(page: &mut Markup, shown: &Histogram<'_>, axis: &Axis, (head, ground): (f64, f64), most: usize) {
    let counts = &shown.distribution.counts;
    page.element("g", &[("class", "bars"), ("data-at", shown.at)], |page| {
        for (bin, &number) in counts.iter().enumerate().filter(|(_, number)| **number > 0) {
            let [from, to] = shown.distribution.borders(bin);
            let (x, end) = (axis.place(from), axis.place(to));
            // A single value, or a bin that is a hair on this axis, is a bar that can be seen.
            let wide = (end - x).max(0.5);
            let x = if end - x < 0.5 { (x + end) / 2.0 - 0.25 } else { x };
            let high = (ground - head) * number as f64 / most.max(1) as f64;
            let middle = (from + to) / 2.0;
            let out = |limit: &LimitLine| {
                (limit.fails_below && middle < limit.value) || (limit.fails_above && middle > limit.value)
            };
            let class = if counts.len() > 1 && shown.limits.iter().any(out) { "bar out" } else { "bar" };
            let [x, y, wide, high] = [x, ground - high, wide, high.max(0.25)].map(coordinate);
            let attributes = [
                ("class", class),
                ("x", x.as_str()),
                ("y", &y),
                ("width", &wide),
                ("height", &high),
                ("data-bin", &bin.to_string()),
            ];
            page.element("rect", &attributes, |page| {
                page.texts("title", &[], &counted(number, shown.noun));
            });
        }
    });
}

fn limit_line(
    page: &mut Markup,
    axis: &Axis,
    limit: &LimitLine,
    (top, ground): (f64, f64),
    (left, right): (f64, f64),
) {
    let x = axis.place(limit.value);
    let width = text_width(&limit.text, 2.8);
    if !axis.holds(limit.value) {
        // Beyond the axis: an arrow at its end.
        let beyond = x <= left + 1e-6;
        let (text, anchor) = match beyond {
            true => (format!("\u{2190} {}", limit.text), Anchor::Start),
            false => (format!("{} \u{2192}", limit.text), Anchor::End),
        };
        letters(page, DVec2::new(x, top), 2.8, anchor, "limit-text", &text);
        return;
    }
    group(page, "limit", |page| {
        line(page, DVec2::new(x, top - 2.2), DVec2::new(x, ground), "limit-line");
    });
    let before = x + width + 1.0 > right || (limit.fails_above && x - width - 1.0 > left);
    let (at, anchor) = if before { (x - 1.0, Anchor::End) } else { (x + 1.0, Anchor::Start) };
    letters(page, DVec2::new(at, top), 2.8, anchor, "limit-text", &limit.text);
}
