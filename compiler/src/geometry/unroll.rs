//! Unrolling a quad into the plane, and the bend a flat board needs to follow it.

use std::fmt;

use glam::{DVec2, DVec3};

use super::planarity::{COLLINEAR_SINE, DEGENERATE_RATIO, Diagonal, angle_between};

/// A fold (rad) up to this counts as flat: no bend radius.
pub const FLAT_FOLD: f64 = 1e-9;

/// Why a quad cannot be unrolled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnrollError {
    /// A side, or the diagonal it is split along, has no length.
    NoLength,
    /// Neither of the two triangles has an area.
    NoArea,
    /// The outline would run back over itself, so no saw can cut it.
    SelfOverlapping,
}

impl fmt::Display for UnrollError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::NoLength => "a side or the diagonal of the quad has no length",
            Self::NoArea => "the quad has no area",
            Self::SelfOverlapping => "its unrolled outline overlaps itself",
        })
    }
}

impl std::error::Error for UnrollError {}

/// A quad laid flat. Its four sides and the diagonal it was split along have the lengths they had in space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnrolledQuad {
    /// A, B, C, D counter-clockwise, mm: A at the origin and B on the positive x axis.
    pub corners: [DVec2; 4],
    /// The diagonal it was split along.
    pub split: Diagonal,
    /// How the flat board bends to follow the quad.
    pub bend: Bend,
}

/// The bend of a board over its split diagonal: a model, in which the fold is spread evenly over the middle of the
/// two triangles (GEOMETRY section 7).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bend {
    /// The angle between the two triangles, rad; 0 is flat.
    pub fold: f64,
    /// Heights of the two triangles over the diagonal, mm.
    pub heights: [f64; 2],
    /// Unit vector along the bend axis, in the frame of the unrolled corners: along the diagonal, from A to C or
    /// from B to D.
    pub axis: DVec2,
}

impl Bend {
    /// R = (h1 + h2) / (2 · fold), mm; none for a flat board (fold up to [`FLAT_FOLD`]).
    #[must_use]
    pub fn radius(&self) -> Option<f64> {
        (self.fold > FLAT_FOLD).then(|| (self.heights[0] + self.heights[1]) / (2.0 * self.fold))
    }

    /// The angle between the bend axis and `direction` (say, the grain) in the unrolled frame, 0 ..= π/2.
    #[must_use]
    pub fn angle_to(&self, direction: DVec2) -> f64 {
        libm::atan2(self.axis.perp_dot(direction).abs(), self.axis.dot(direction).abs())
    }
}

/// Unrolls the quad A, B, C, D (mm) by turning the far triangle about the diagonal `split` into the plane of the
/// other. Never a projection: sides and that diagonal keep their lengths.
///
/// Placement: A at the origin, B on the positive x axis, counter-clockwise. Moving it onto a sheet is fabrication's.
///
/// # Errors
/// A side or the diagonal without length, no area, or an outline that runs back over itself.
pub fn unroll(corners: [DVec3; 4], split: Diagonal) -> Result<UnrolledQuad, UnrollError> {
    let [a, b, c, d] = corners;
    let [from, to] = split.ends();
    let lengths =
        [a.distance(b), b.distance(c), c.distance(d), d.distance(a), corners[from].distance(corners[to])];
    let size = lengths.into_iter().fold(0.0, f64::max);
    if lengths.into_iter().any(|length| length <= DEGENERATE_RATIO * size) {
        return Err(UnrollError::NoLength);
    }
    let flat_a = DVec2::ZERO;
    let flat_b = DVec2::new(lengths[0], 0.0);
    let flat = match split {
        Diagonal::Ac => {
            let flat_c = beside(flat_a, flat_b, 1.0, [a, b, c]);
            [flat_a, flat_b, flat_c, beside(flat_a, flat_c, 1.0, [a, c, d])]
        }
        Diagonal::Bd => {
            let flat_d = beside(flat_a, flat_b, 1.0, [a, b, d]);
            [flat_a, flat_b, beside(flat_b, flat_d, -1.0, [b, d, c]), flat_d]
        }
    };
    check_outline(flat, size)?;
    let bend = bend(corners, flat, split);
    Ok(UnrolledQuad { corners: flat, split, bend })
}

/// Where the apex of the triangle (p, q, apex) in space lies, when p and q lie at `flat_p` and `flat_q` in the
/// plane: on their left (`side` 1) or on their right (−1).
fn beside(flat_p: DVec2, flat_q: DVec2, side: f64, [p, q, apex]: [DVec3; 3]) -> DVec2 {
    let direction = (q - p).normalize_or_zero();
    let along = (apex - p).dot(direction);
    let height = (apex - p).cross(direction).length();
    let flat_direction = (flat_q - flat_p).normalize_or_zero();
    flat_p + flat_direction * along + flat_direction.perp() * (side * height)
}

fn bend(corners: [DVec3; 4], flat: [DVec2; 4], split: Diagonal) -> Bend {
    let [from, to] = split.ends();
    let direction = (corners[to] - corners[from]).normalize_or_zero();
    let [first, second] =
        split.triangles().map(|[_, apex, _]| (corners[apex] - corners[from]).cross(direction));
    Bend {
        fold: angle_between(first, -second),
        heights: [first.length(), second.length()],
        axis: (flat[to] - flat[from]).normalize_or_zero(),
    }
}

/// Refuses outlines without area, with a side that runs back over its neighbour, and with sides that cross.
fn check_outline(flat: [DVec2; 4], size: f64) -> Result<(), UnrollError> {
    let [a, b, c, d] = flat;
    if (c - a).perp_dot(d - b) <= COLLINEAR_SINE * size * size {
        return Err(UnrollError::NoArea);
    }
    for corner in 0..4 {
        let out = flat[(corner + 1) % 4] - flat[corner];
        let back = flat[(corner + 3) % 4] - flat[corner];
        let flat_angle = out.perp_dot(back).abs() <= COLLINEAR_SINE * out.length() * back.length();
        if flat_angle && out.dot(back) > 0.0 {
            return Err(UnrollError::SelfOverlapping);
        }
    }
    if cross(a, b, c, d) || cross(b, c, d, a) {
        return Err(UnrollError::SelfOverlapping);
    }
    Ok(())
}

/// Whether the segments pq and rs cross.
fn cross(p: DVec2, q: DVec2, r: DVec2, s: DVec2) -> bool {
    let side = |from: DVec2, to: DVec2, point: DVec2| (to - from).perp_dot(point - from);
    side(p, q, r) * side(p, q, s) < 0.0 && side(r, s, p) * side(r, s, q) < 0.0
}

#[cfg(test)]
mod tests;
