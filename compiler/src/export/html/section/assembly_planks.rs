//! The assembly map of planks: each curve in its own plane, every plank with the end of its alias.

use glam::{DVec2, DVec3};

use super::assembly_boards::common_start;
use crate::export::html::document::{CurveShape, PlankShapes};
use crate::export::html::draw::paper::{Anchor, Path, letters, line, svg};
use crate::export::html::draw::scale_bar::scale_bar;
use crate::export::html::markup::Markup;
use crate::export::html::number::{count, counted};
use crate::fabricate::plank::Plank;

/// Planks drawn one by one, at most.
const MOST_NAMED: usize = 2000;

const ROOM: DVec2 = DVec2::new(164.0, 58.0);
const MARGIN: f64 = 7.0;
const LETTERS: f64 = 2.6;

/// Writes the elevations of all curves.
pub(in crate::export::html) fn assembly(page: &mut Markup, planks: &PlankShapes<'_>) {
    let by_address: std::collections::BTreeMap<&str, &Plank> =
        planks.planks.iter().map(|plank| (plank.label.address.as_str(), plank)).collect();
    let mut left = MOST_NAMED;
    let mut left_out = 0;
    for curve in &planks.curves {
        let Some(rest) = left.checked_sub(curve.labels.len()) else {
            left_out += 1;
            continue;
        };
        left = rest;
        let own: Vec<&Plank> =
            curve.labels.iter().filter_map(|label| by_address.get(label.address.as_str()).copied()).collect();
        elevation(page, curve, &own);
    }
    if left_out > 0 {
        let text = format!(
            "{} more are not drawn here, which shows {} planks at most; cutlist.csv lists the neighbours of each plank.",
            counted(left_out, "curve"),
            count(MOST_NAMED)
        );
        page.texts("p", &[], &text);
    }
}

/// The plane of a curve: right and up. Up is as steep as the plane goes; in a level plane it is y.
fn plane(normal: DVec3) -> (DVec3, DVec3) {
    let up = (DVec3::Z - normal * normal.z).try_normalize();
    match up.filter(|_| normal.z.abs() < 0.99) {
        Some(up) => {
            let right = up.cross(normal);
            // The same way round as the front elevation: x, or else y, to the right.
            let forward = if right.x.abs() > 1e-6 { right.x } else { right.y };
            (if forward < 0.0 { -right } else { right }, up)
        }
        None => (DVec3::X, DVec3::Y),
    }
}

fn elevation(page: &mut Markup, curve: &CurveShape<'_>, planks: &[&Plank]) {
    let Some(first) = planks.first() else { return };
    let (right, up) = plane(first.plane_normal);
    let flat = |point: DVec3| DVec2::new(point.dot(right), point.dot(up));
    let outlines: Vec<[DVec2; 4]> = planks.iter().map(|plank| outline(plank, &flat)).collect();
    let points = || outlines.iter().flatten().copied();
    let low = points().fold(DVec2::INFINITY, DVec2::min);
    let high = points().fold(DVec2::NEG_INFINITY, DVec2::max);
    let size = high - low;
    let scale = (ROOM.x / size.x).min(ROOM.y / size.y);
    if !(scale.is_finite() && scale > 0.0) {
        return;
    }
    let paper =
        |point: DVec2| DVec2::new(MARGIN + (point.x - low.x) * scale, MARGIN + (high.y - point.y) * scale);
    let start = common_start(curve.labels);
    let (width, height) = (size.x * scale + 2.0 * MARGIN, size.y * scale + 2.0 * MARGIN + 9.0);
    let middle = paper(points().sum::<DVec2>() / points().count().max(1) as f64);
    page.element("figure", &[("class", "sheet")], |page| {
        svg(page, (width.max(60.0), height), "Assembly map of a curve", |page| {
            for corners in &outlines {
                let mut path = Path::default();
                path.chain(&corners.map(paper), true);
                path.write(page, &[("class", "plank")]);
            }
            for (plank, corners) in planks.iter().zip(&outlines) {
                name(
                    page,
                    &plank.label.alias[start.len().min(plank.label.alias.len())..],
                    &corners.map(paper),
                    middle,
                );
            }
            scale_bar(page, DVec2::new(MARGIN, height - 6.0), scale);
        });
        let caption = format!(
            "{}: {} in the plane of the curve, in order. Every alias starts with “{start}”.",
            curve.name,
            counted(planks.len(), "plank"),
        );
        page.texts("figcaption", &[], &caption);
    });
}

/// The outline of a plank in the plane of its curve: the two faces square to it, between the end cuts.
fn outline(plank: &Plank, flat: &impl Fn(DVec3) -> DVec2) -> [DVec2; 4] {
    let [start, end] = plank.axis.map(flat);
    let along = (end - start).normalize_or_zero();
    let side = DVec2::new(-along.y, along.x) * plank.depth / 2.0;
    // The outline of the plank says where its corners lie along the axis: start right, end right, end left, start left.
    let [a, b, c, d] = [0, 1, 2, 3].map(|corner| plank.outline.get(corner).map_or(0.0, |point| point.x));
    let (from, to) = ((a + d) / 2.0, (b + c) / 2.0);
    // Seen from behind, left and right change places.
    let turned = flat(plank.plane_normal.cross(plank.axis[1] - plank.axis[0])).perp_dot(along) > 0.0;
    let side = if turned { -side } else { side };
    [
        start - side + along * (a - from),
        end - side + along * (b - to),
        end + side + along * (c - to),
        start + side + along * (d - from),
    ]
}

/// The name of a plank, off its middle on the side away from the middle of the curve.
fn name(page: &mut Markup, text: &str, corners: &[DVec2; 4], middle: DVec2) {
    let at = corners.iter().sum::<DVec2>() / 4.0;
    let along = (corners[1] - corners[0]).normalize_or_zero();
    let across = DVec2::new(-along.y, along.x);
    let outward = if across.dot(at - middle) < 0.0 { -across } else { across };
    let half = (corners[3] - corners[0]).dot(across).abs() / 2.0;
    let foot = at + outward * (half + 0.3);
    let place = at + outward * (half + 3.2);
    line(page, foot, at + outward * (half + 1.2), "leader");
    letters(page, place + DVec2::Y * LETTERS * 0.35, LETTERS, Anchor::Middle, "cell-text", text);
}
