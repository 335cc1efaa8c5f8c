//! From the points of a plane curve to its planks.

use glam::{DVec2, DVec3};

use super::end::{EndCut, Frame};
use super::{
    CutPlane, Ends, LEAST_LENGTH, PLANE_TOLERANCE, Plank, PlankError, PlankRefusal, PlankSettings, Planks,
    RefusedPlank,
};
use crate::fabricate::assembly::{Element, order};
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
/// As [`planks`], and where an end is to be cut to a plane.
pub fn closed_planks(
    points: &[DVec3],
    labels: &[Label],
    settings: &PlankSettings,
) -> Result<Planks, PlankError> {
    check(points, labels, settings)?;
    if settings.first.is_some() || settings.last.is_some() {
        return Err(PlankError::NoEnds);
    }
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
    let count = labels.len();
    let beside = |index: usize| {
        let last = if closed { count.checked_sub(1) } else { None };
        let after = if closed && index + 1 == count { 0 } else { index + 1 };
        [index.checked_sub(1).or(last), Some(after).filter(|after| *after < count)]
    };
    let elements: Vec<Element> = (0..count)
        .map(|index| {
            let ends = [points[index], points[index + 1]];
            let free = ends.iter().zip(beside(index)).filter(|(_, neighbour)| neighbour.is_none());
            Element {
                height: ends[0].midpoint(ends[1]).z,
                free_corners: free.map(|(end, _)| end.z).collect(),
                neighbours: beside(index).into_iter().flatten().collect(),
            }
        })
        .collect();
    let mut places = Vec::new();
    for ((index, label), place) in labels.iter().enumerate().zip(order(&elements)) {
        let turns = [beside(index)[0].and_then(|joint| turning.get(joint)), turning.get(index)];
        let axis = [points[index], points[index + 1]];
        match plank(axis, turns.map(|turn| turn.copied()), plane_normal, settings) {
            Ok(plank) => {
                let neighbours = beside(index).map(|other| Some(labels.get(other?)?.address.clone()));
                made.planks.push(Plank { label: label.clone(), neighbours, ring: place.ring, ..plank });
                places.push(place.order);
            }
            Err(reason) => made.refused.push(RefusedPlank { label: label.clone(), reason }),
        }
    }
    let mut standing: Vec<usize> = (0..places.len()).collect();
    standing.sort_by_key(|plank| places[*plank]);
    for (place, plank) in (1u32..).zip(standing) {
        made.planks[plank].order = place;
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
    let axis_length = segment.length();
    let Some(along) = segment.try_normalize().filter(|_| axis_length >= LEAST_LENGTH) else {
        return Err(PlankRefusal::TooShort { length: axis_length });
    };
    let frame = Frame { along, left: plane_normal.cross(along).normalize_or_zero(), up: plane_normal };
    let cut = |turn: Option<f64>, plane: &Option<CutPlane>, position: f64, outwards: f64| match (turn, plane)
    {
        (Some(turn), _) => at_joint(position, outwards, turn, settings),
        (None, Some(plane)) => EndCut::along_plane(plane, axis[0], &frame),
        (None, None) => EndCut::at_joint(position, 0.0),
    };
    let start = cut(turns[0], &settings.first, 0.0, -1.0)?;
    let end = cut(turns[1], &settings.last, axis_length, 1.0)?;
    let cuts = [start, end];
    let length = end.position - start.position;
    if length < LEAST_LENGTH {
        return Err(PlankRefusal::NothingLeft { length });
    }
    let (half_depth, half_width) = (settings.depth / 2.0, settings.width / 2.0);
    let length_at = |y: f64, z: f64| end.at(y, z) - start.at(y, z);
    let sides = [-half_depth, half_depth];
    let edges = sides.map(|y| [-half_width, half_width].map(|z| length_at(y, z)));
    let shortest = edges.iter().flatten().copied().fold(length, f64::min);
    if shortest <= 0.0 {
        return Err(PlankRefusal::CutsCross { inner_length: shortest });
    }
    let flat = around(&start, &end, half_depth, half_width);
    let (low, high) = fit::bounds(&flat);
    let needed = high.x - low.x;
    if needed > settings.stock {
        return Err(PlankRefusal::TooLong { needed, stock: settings.stock });
    }
    let [right_length, left_length] = sides.map(|y| length_at(y, 0.0));
    let solid = solid(axis[0], &cuts, &frame, half_depth, half_width);
    Ok(Plank {
        label: Label::default(),
        axis: cuts.map(|cut| axis[0] + along * cut.position),
        plane_normal,
        length,
        inner_length: left_length.min(right_length),
        outer_length: left_length.max(right_length),
        mitres: cuts.map(|cut| cut.mitre),
        bevels: cuts.map(|cut| cut.bevel),
        outline: flat.iter().map(|&corner| corner - low).collect(),
        depth: settings.depth,
        width: settings.width,
        mass: settings.material.density.map(|density| density * length * settings.depth * settings.width),
        neighbours: [None, None],
        ring: 0,
        order: 0,
        centre: solid.centre(),
        solid,
    })
}

/// The cut at a joint that turns by `turn`: `outwards` is 1 at the end of the segment and −1 at its start.
fn at_joint(
    position: f64,
    outwards: f64,
    turn: f64,
    settings: &PlankSettings,
) -> Result<EndCut, PlankRefusal> {
    let mitre = match settings.ends {
        Ends::Square => 0.0,
        Ends::Mitred => outwards * turn / 2.0,
    };
    let back = settings.gap / 2.0 / libm::cos(mitre);
    EndCut::at_joint(position - outwards * back, mitre)
}

/// The outline in the plane of the curve, around all of the plank: x along the axis from the start of the segment.
fn around(start: &EndCut, end: &EndCut, half_depth: f64, half_width: f64) -> [DVec2; 4] {
    let least = |y: f64| start.at(y, -half_width).min(start.at(y, half_width));
    let most = |y: f64| end.at(y, -half_width).max(end.at(y, half_width));
    [
        DVec2::new(least(-half_depth), -half_depth),
        DVec2::new(most(-half_depth), -half_depth),
        DVec2::new(most(half_depth), half_depth),
        DVec2::new(least(half_depth), half_depth),
    ]
}

fn solid(origin: DVec3, cuts: &[EndCut; 2], frame: &Frame, half_depth: f64, half_width: f64) -> Solid {
    let corner =
        |cut: &EndCut, y: f64, z: f64| origin + frame.along * cut.at(y, z) + frame.left * y + frame.up * z;
    let [start, end] = cuts;
    let face = |z: f64| {
        [
            corner(start, -half_depth, z),
            corner(end, -half_depth, z),
            corner(end, half_depth, z),
            corner(start, half_depth, z),
        ]
    };
    Solid::between(face(-half_width), face(half_width), Diagonal::Ac.triangles())
}
