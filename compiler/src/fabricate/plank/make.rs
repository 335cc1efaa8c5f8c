//! From the points of a plane curve to its planks.

use glam::{DVec2, DVec3};

use super::{Ends, PLANE_TOLERANCE, Plank, PlankError, PlankRefusal, PlankSettings, Planks, RefusedPlank};
use crate::fabricate::fit;
use crate::fabricate::label::Label;
use crate::fabricate::solid::Solid;
use crate::geometry::Diagonal;
use crate::geometry::PolylineShape;
use crate::geometry::polyline::{shape, signed_turning_angles};

/// Makes a plank of each segment of the curve through `points` (mm), open, its joints at the inner points. `labels`
/// has one entry for each segment.
///
/// The plane of a straight curve is the upright one; that of an upright line is square to y.
///
/// # Errors
/// A curve which is not plane, points that are not finite, fewer than two, a section or stock without size, a wrong
/// number of labels. A segment which cannot be made is in [`Planks::refused`], with its reason.
pub fn planks(points: &[DVec3], labels: &[Label], settings: &PlankSettings) -> Result<Planks, PlankError> {
    check(points, labels, settings)?;
    let plane_normal = plane_normal(points)?;
    let turning = signed_turning_angles(points, plane_normal);
    joined(points, labels, settings, plane_normal, &turning, false)
}

/// As [`planks`], of a curve that goes round: its last point is its first one, and a joint like the others.
///
/// # Errors
/// As [`planks`].
pub fn closed_planks(
    points: &[DVec3],
    labels: &[Label],
    settings: &PlankSettings,
) -> Result<Planks, PlankError> {
    check(points, labels, settings)?;
    let plane_normal = plane_normal(points)?;
    let round: Vec<DVec3> = points.iter().chain(points.get(1)).copied().collect();
    let turning = signed_turning_angles(&round, plane_normal);
    joined(points, labels, settings, plane_normal, &turning, true)
}

/// The planks between joints, joint i at the end of segment i turning by `turning[i]`.
fn joined(
    points: &[DVec3],
    labels: &[Label],
    settings: &PlankSettings,
    plane_normal: DVec3,
    turning: &[f64],
    closed: bool,
) -> Result<Planks, PlankError> {
    let mut made = Planks::default();
    for (index, label) in labels.iter().enumerate() {
        let last = if closed { labels.len().checked_sub(1) } else { None };
        let before = index.checked_sub(1).or(last);
        let after = if closed && index + 1 == labels.len() { 0 } else { index + 1 };
        let turns = [before.and_then(|joint| turning.get(joint)), turning.get(index)];
        let axis = [points[index], points[index + 1]];
        match plank(axis, turns.map(|turn| turn.copied()), plane_normal, settings) {
            Ok(plank) => {
                let before = before.and_then(|before| labels.get(before));
                let neighbours = [before, labels.get(after)].map(|label| Some(label?.address.clone()));
                made.planks.push(Plank { label: label.clone(), neighbours, ..plank });
            }
            Err(reason) => made.refused.push(RefusedPlank { label: label.clone(), reason }),
        }
    }
    Ok(made)
}

/// What can be said before any segment is looked at.
fn check(points: &[DVec3], labels: &[Label], settings: &PlankSettings) -> Result<(), PlankError> {
    let above_zero = |value: f64| value > 0.0 && value.is_finite();
    for (what, value, good) in [
        ("depth of the section", settings.depth, above_zero(settings.depth)),
        ("width of the section", settings.width, above_zero(settings.width)),
        ("length of the stock", settings.stock, above_zero(settings.stock)),
        ("gap at a joint", settings.gap, settings.gap >= 0.0 && settings.gap.is_finite()),
    ] {
        if !good {
            return Err(PlankError::NoSection { what, value });
        }
    }
    if points.len() < 2 {
        return Err(PlankError::TooFewPoints);
    }
    if let Some(point) = points.iter().position(|point| !point.is_finite()) {
        return Err(PlankError::NotFinite { point });
    }
    if labels.len() != points.len() - 1 {
        return Err(PlankError::WrongLabelCount { segments: points.len() - 1, labels: labels.len() });
    }
    Ok(())
}

fn plane_normal(points: &[DVec3]) -> Result<DVec3, PlankError> {
    match shape(points, PLANE_TOLERANCE) {
        PolylineShape::Planar(plane) => Ok(plane.normal),
        PolylineShape::Straight { direction } => {
            Ok(direction.cross(DVec3::Z).try_normalize().unwrap_or(DVec3::Y))
        }
        PolylineShape::Point => Ok(DVec3::Y),
        PolylineShape::Spatial { deviation } => Err(PlankError::NotPlanar { deviation }),
    }
}

/// The plank along `axis`, between joints that turn by `turns` (rad; none at an outer end), without its names.
fn plank(
    axis: [DVec3; 2],
    turns: [Option<f64>; 2],
    plane_normal: DVec3,
    settings: &PlankSettings,
) -> Result<Plank, PlankRefusal> {
    let segment = axis[1] - axis[0];
    let Some(along) = segment.try_normalize() else { return Err(PlankRefusal::NoLength) };
    let mitres = match settings.ends {
        Ends::Square => [0.0, 0.0],
        Ends::Mitred => [-turns[0].unwrap_or(0.0) / 2.0, turns[1].unwrap_or(0.0) / 2.0],
    };
    let back = [0, 1].map(|end| match turns[end] {
        Some(_) => settings.gap / 2.0 / libm::cos(mitres[end]),
        None => 0.0,
    });
    let axis = [axis[0] + along * back[0], axis[1] - along * back[1]];
    let length = segment.length() - back[0] - back[1];
    // How far a cut runs ahead on the left of the axis, and back on its right: y on the left is half the depth.
    let ahead = mitres.map(|mitre| -libm::tan(mitre) * settings.depth / 2.0);
    let left_length = length + ahead[1] - ahead[0];
    let right_length = length - ahead[1] + ahead[0];
    let inner_length = left_length.min(right_length);
    if inner_length <= 0.0 {
        return Err(PlankRefusal::CutsCross { inner_length });
    }
    let half = settings.depth / 2.0;
    let flat = [
        DVec2::new(-ahead[0], -half),
        DVec2::new(length - ahead[1], -half),
        DVec2::new(length + ahead[1], half),
        DVec2::new(ahead[0], half),
    ];
    let (low, high) = fit::bounds(&flat);
    let needed = high.x - low.x;
    if needed > settings.stock {
        return Err(PlankRefusal::TooLong { needed, stock: settings.stock });
    }
    Ok(Plank {
        label: Label::default(),
        axis,
        plane_normal,
        length,
        inner_length,
        outer_length: left_length.max(right_length),
        mitres,
        outline: flat.iter().map(|&corner| corner - low).collect(),
        depth: settings.depth,
        width: settings.width,
        mass: settings.material.density.map(|density| density * length * settings.depth * settings.width),
        neighbours: [None, None],
        solid: solid(&flat, axis[0], along, plane_normal, settings.width),
    })
}

/// The outline `flat` (x along the axis from `start`, y to its left) in space, half the width to each side.
fn solid(flat: &[DVec2; 4], start: DVec3, along: DVec3, plane_normal: DVec3, width: f64) -> Solid {
    let left = plane_normal.cross(along).normalize_or_zero();
    let face =
        |offset: f64| flat.map(|corner| start + along * corner.x + left * corner.y + plane_normal * offset);
    Solid::between(face(-width / 2.0), face(width / 2.0), Diagonal::Ac.triangles())
}
