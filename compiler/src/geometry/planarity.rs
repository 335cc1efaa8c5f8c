//! The measures of one quad: planarity, folds, diagonal ratio, sizes, and a verdict on its shape.
//! Figures over a whole mesh are in `summary`.

use glam::DVec3;

/// A corner counts as collinear when the sine of its angle is at most this.
pub const COLLINEAR_SINE: f64 = 1e-9;

/// Two folds (radians) closer than this are a tie, so that rounding does not choose the diagonal.
pub const FOLD_TIE: f64 = 1e-9;

/// A side or diagonal shorter than this fraction of the longest of them has no length.
pub const DEGENERATE_RATIO: f64 = 1e-12;

/// A diagonal of the quad ABCD.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Diagonal {
    /// From A to C: triangles ABC and CDA.
    Ac,
    /// From B to D: triangles DAB and BCD.
    Bd,
}

impl Diagonal {
    /// The corners (0 for A … 3 for D) at the ends of the diagonal.
    #[must_use]
    pub const fn ends(self) -> [usize; 2] {
        match self {
            Self::Ac => [0, 2],
            Self::Bd => [1, 3],
        }
    }

    /// The two triangles the quad falls into, as corners in the quad's own direction around.
    #[must_use]
    pub const fn triangles(self) -> [[usize; 3]; 2] {
        match self {
            Self::Ac => [[0, 1, 2], [2, 3, 0]],
            Self::Bd => [[3, 0, 1], [1, 2, 3]],
        }
    }

    /// The corner opposite to `side` (0 for AB … 3 for DA) in the triangle at that side.
    #[must_use]
    pub const fn apex_of_side(self, side: usize) -> usize {
        match (self, side % 4) {
            (Self::Ac, 0) => 2,
            (Self::Ac, 1) => 0,
            (Self::Ac, 2) => 0,
            (Self::Ac, _) => 2,
            (Self::Bd, 0 | 1) => 3,
            (Self::Bd, _) => 1,
        }
    }
}

/// What kind of quad it is, and with it whether planarity says anything about it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// All corners turn the same way, and neither diagonal folds by a right angle or more.
    Convex,
    /// One corner is reflex (concave). Flat or not, its planarity by the cosine would read about −1.
    Dart,
    /// Three neighbouring corners lie on a line, so one corner normal does not exist.
    CollinearCorner,
    /// Folded over a diagonal by a right angle or more, or crossing itself.
    FoldedOver,
    /// A side or a diagonal of no length, or no area.
    Degenerate,
}

/// Everything measured on one quad ABCD (GEOMETRY section 5).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QuadMeasure {
    /// The smaller of n_B·n_D and n_A·n_C, the unit normals at the corners: 1 is flat, −1 folded over (the
    /// paper's section 7.2). None where it says nothing: darts, collinear corners, degenerate quads.
    pub planarity: Option<f64>,
    /// The angle between the triangles ABC and CDA, 0 for flat; none where one of them has no area. rad.
    pub fold_ac: Option<f64>,
    /// The angle between the triangles DAB and BCD, 0 for flat; none where one of them has no area. rad.
    pub fold_bd: Option<f64>,
    /// The diagonal to split along: the one with the smaller fold, AC on a tie.
    pub split: Diagonal,
    /// Distance of the two diagonals by their mean length, never negative (libigl's `quad_planarity` is the same
    /// with a sign). None where they are parallel.
    pub diagonal_ratio: Option<f64>,
    /// Area of the two triangles after splitting, mm².
    pub area: f64,
    /// Lengths of AB, BC, CD, DA, mm.
    pub edges: [f64; 4],
    /// Lengths of AC and BD, mm.
    pub diagonals: [f64; 2],
    /// What kind of quad it is.
    pub verdict: Verdict,
}

impl QuadMeasure {
    /// Measures the quad with corners A, B, C, D (finite, mm).
    #[must_use]
    pub fn of(corners: [DVec3; 4]) -> Self {
        let [a, b, c, d] = corners;
        let edges = [a.distance(b), b.distance(c), c.distance(d), d.distance(a)];
        let diagonals = [a.distance(c), b.distance(d)];
        let normals = corner_normals(corners);
        let sound = [0, 1, 2, 3].map(|corner| {
            normals[corner].length() > COLLINEAR_SINE * edges[corner] * edges[(corner + 3) % 4]
        });
        let fold_ac = (sound[1] && sound[3]).then(|| angle_between(normals[1], normals[3]));
        let fold_bd = (sound[0] && sound[2]).then(|| angle_between(normals[0], normals[2]));
        let split = smaller_fold(fold_ac, fold_bd);
        let verdict = verdict(&edges, &diagonals, &normals, sound, fold_ac, fold_bd);
        let planarity = matches!(verdict, Verdict::Convex | Verdict::FoldedOver)
            .then(|| cosine(normals[1], normals[3]).min(cosine(normals[0], normals[2])));
        let halves = match split {
            Diagonal::Ac => normals[1].length() + normals[3].length(),
            Diagonal::Bd => normals[0].length() + normals[2].length(),
        };
        Self {
            planarity,
            fold_ac,
            fold_bd,
            split,
            diagonal_ratio: diagonal_ratio(corners, diagonals),
            area: halves / 2.0,
            edges,
            diagonals,
            verdict,
        }
    }

    /// The larger of the folds over the two diagonals, rad: the angle whose cosine is the planarity, exact for small
    /// angles. None where there is no planarity.
    #[must_use]
    pub fn larger_fold(&self) -> Option<f64> {
        let (ac, bd) = self.fold_ac.zip(self.fold_bd).filter(|_| self.planarity.is_some())?;
        Some(ac.max(bd))
    }

    /// The fold over the diagonal to split along, rad; none for a quad without two triangles of some area.
    #[must_use]
    pub fn fold(&self) -> Option<f64> {
        match self.split {
            Diagonal::Ac => self.fold_ac,
            Diagonal::Bd => self.fold_bd,
        }
    }
}

/// At each corner the normal of the triangle it makes with its two neighbours, as long as twice its area.
#[must_use]
pub fn corner_normals([a, b, c, d]: [DVec3; 4]) -> [DVec3; 4] {
    [(b - a).cross(d - a), (c - b).cross(a - b), (d - c).cross(b - c), (a - d).cross(c - d)]
}

/// The angle between two vectors in 0 ..= π, by atan2, exact for small angles; 0 when one of them is zero.
#[must_use]
pub fn angle_between(first: DVec3, second: DVec3) -> f64 {
    libm::atan2(first.cross(second).length(), first.dot(second))
}

/// The cosine of the angle between two vectors, within −1 ..= 1.
fn cosine(first: DVec3, second: DVec3) -> f64 {
    (first.dot(second) / (first.length() * second.length())).clamp(-1.0, 1.0)
}

fn smaller_fold(fold_ac: Option<f64>, fold_bd: Option<f64>) -> Diagonal {
    match (fold_ac, fold_bd) {
        (Some(ac), Some(bd)) if bd < ac - FOLD_TIE => Diagonal::Bd,
        (None, Some(_)) => Diagonal::Bd,
        _ => Diagonal::Ac,
    }
}

fn verdict(
    edges: &[f64; 4],
    diagonals: &[f64; 2],
    normals: &[DVec3; 4],
    sound: [bool; 4],
    fold_ac: Option<f64>,
    fold_bd: Option<f64>,
) -> Verdict {
    let size = edges.iter().chain(diagonals).fold(0.0f64, |size, &length| size.max(length));
    let no_length = edges.iter().chain(diagonals).any(|&length| length <= DEGENERATE_RATIO * size);
    if no_length || (fold_ac.is_none() && fold_bd.is_none()) {
        return Verdict::Degenerate;
    }
    if sound.contains(&false) {
        return Verdict::CollinearCorner;
    }
    let twice_area = normals[0] + normals[2];
    let reflex = normals.iter().filter(|normal| normal.dot(twice_area) < 0.0).count();
    let right = std::f64::consts::FRAC_PI_2;
    let [ac, bd] = [fold_ac, fold_bd].map(|fold| fold.is_some_and(|fold| fold < right));
    match reflex {
        0 if ac && bd => Verdict::Convex,
        1 if ac || bd => Verdict::Dart,
        _ => Verdict::FoldedOver,
    }
}

fn diagonal_ratio([a, b, c, d]: [DVec3; 4], diagonals: [f64; 2]) -> Option<f64> {
    let normal = (c - a).cross(d - b);
    let length = normal.length();
    if length <= COLLINEAR_SINE * diagonals[0] * diagonals[1] {
        return None;
    }
    let distance = (b - a).dot(normal).abs() / length;
    Some(distance / ((diagonals[0] + diagonals[1]) / 2.0))
}

#[cfg(test)]
mod tests;
