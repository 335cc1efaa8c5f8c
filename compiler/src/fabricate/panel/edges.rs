//! How the edges of boards are cut: where the outlines of the two faces lie beside the design outline. What a bevel is
//! measured from is in `geometry::dihedral`; nothing here knows of space.

use glam::DVec2;

/// A side of an outline shorter than this has vanished, mm.
const LEAST_SIDE: f64 = 1e-3;

/// A step narrower than this is none, mm.
const LEAST_STEP: f64 = 1e-3;

/// Sides that turn by less than this (sine) run on straight: they have no corner of their own.
const STRAIGHT_SINE: f64 = 1e-9;

/// How the edges of panels are cut.
///
/// ```text
///            square             bevelled             stepped
///  outer ┌──────────┐       ┌────────────╱        ┌───────────┐      upper half
///        │          │       │           ╱         │           ┆
///        │          │       │          ╱          │        ┌──┘      a step of t/2 deep,
///  inner └──────────┘       └─────────╱           └────────┘         t/2 · tan β wide
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edges {
    /// Square to the faces, on the design outline: the bevel is reported for the saw.
    Square,
    /// Along the plane that halves the dihedral angle, so that neighbours lie flat against each other.
    Bevelled,
    /// One step halfway through the thickness, both halves square to the faces and as large as they can be without
    /// crossing that plane, so that neighbours touch along two lines.
    Stepped,
}

/// How far one edge of a board is moved out of the design outline, mm: negative is inwards.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct EdgeOffsets {
    /// On the outer face; of a stepped edge, of the outer half.
    pub top: f64,
    /// On the inner face; of a stepped edge, of the inner half.
    pub bottom: f64,
}

impl EdgeOffsets {
    /// What the machine has to leave: the larger of the two.
    #[must_use]
    pub fn cut(self) -> f64 {
        self.top.max(self.bottom)
    }
}

impl Edges {
    /// Where an edge with this bevel (rad, GEOMETRY section 8) lies on a board whose faces are `low` and `high`
    /// (mm along the normal) of the design surface. On the border, where there is no bevel, it is square.
    #[must_use]
    pub fn offsets(self, bevel: Option<f64>, (low, high): (f64, f64)) -> EdgeOffsets {
        let slope = libm::tan(bevel.unwrap_or(0.0));
        let middle = (low + high) / 2.0;
        match self {
            Self::Square => EdgeOffsets::default(),
            Self::Bevelled => EdgeOffsets { top: high * slope, bottom: low * slope },
            Self::Stepped if ((high - low) / 2.0 * slope).abs() < LEAST_STEP => {
                let both = (low * slope).min(high * slope);
                EdgeOffsets { top: both, bottom: both }
            }
            Self::Stepped => EdgeOffsets {
                top: (middle * slope).min(high * slope),
                bottom: (low * slope).min(middle * slope),
            },
        }
    }
}

/// Why the sides of an outline cannot be moved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Vanished {
    /// This side would be as long as that, mm: 0 or less where it is turned round.
    Side(usize, f64),
    /// The two sides at this corner run on straight and are moved by different amounts.
    Corner(usize),
}

/// The outline (counter-clockwise, mm) with each side moved out, parallel to itself, and its corners where neighbouring
/// sides meet then.
pub(super) fn moved_out(outline: &[DVec2; 4], offsets: [f64; 4]) -> Result<[DVec2; 4], Vanished> {
    let along = [0, 1, 2, 3].map(|side| (outline[(side + 1) % 4] - outline[side]).normalize_or_zero());
    let mut moved = *outline;
    for corner in 0..4 {
        let before = (corner + 3) % 4;
        let (p, q) = (along[before], along[corner]);
        let sine = p.perp_dot(q);
        moved[corner] += if offsets[before] == offsets[corner] && offsets[corner] == 0.0 {
            DVec2::ZERO
        } else if sine.abs() > STRAIGHT_SINE {
            (p * offsets[corner] - q * offsets[before]) / sine
        } else if offsets[before] == offsets[corner] {
            -q.perp() * offsets[corner]
        } else {
            return Err(Vanished::Corner(corner));
        };
    }
    for side in 0..4 {
        let length = (moved[(side + 1) % 4] - moved[side]).dot(along[side]);
        // Not a number where the bevel is a right angle.
        if length.is_nan() || length < LEAST_SIDE {
            return Err(Vanished::Side(side, length));
        }
    }
    Ok(moved)
}

/// The area of an outline, mm²: positive where it runs counter-clockwise.
pub(super) fn area(outline: &[DVec2; 4]) -> f64 {
    (outline[2] - outline[0]).perp_dot(outline[3] - outline[1]) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_8;

    const SQUARE: [DVec2; 4] =
        [DVec2::ZERO, DVec2::new(100.0, 0.0), DVec2::new(100.0, 100.0), DVec2::new(0.0, 100.0)];

    #[test]
    fn offsets_differ_by_the_thickness_times_the_tangent() {
        let tangent = libm::tan(FRAC_PI_8);
        for faces in [(0.0, 12.0), (-6.0, 6.0), (-12.0, 0.0)] {
            for bevel in [FRAC_PI_8, -FRAC_PI_8] {
                let offsets = Edges::Bevelled.offsets(Some(bevel), faces);
                assert!((offsets.top - offsets.bottom - 12.0 * libm::tan(bevel)).abs() < 1e-12);
                let stepped = Edges::Stepped.offsets(Some(bevel), faces);
                assert!(((stepped.top - stepped.bottom).abs() - 6.0 * tangent).abs() < 1e-12);
                assert!(stepped.cut() < offsets.cut() + 1e-12, "a step never crosses the plane");
            }
        }
        let centred = Edges::Bevelled.offsets(Some(FRAC_PI_8), (-6.0, 6.0));
        assert_eq!((centred.top, centred.bottom), (6.0 * tangent, -6.0 * tangent));
        assert_eq!(Edges::Bevelled.offsets(None, (0.0, 12.0)), EdgeOffsets::default());
        assert_eq!(Edges::Square.offsets(Some(FRAC_PI_8), (0.0, 12.0)), EdgeOffsets::default());
    }

    #[test]
    fn sides_move_parallel_to_themselves() {
        let moved = moved_out(&SQUARE, [1.0, 2.0, 3.0, -4.0]).unwrap();
        assert_eq!(moved, [(4.0, -1.0), (102.0, -1.0), (102.0, 103.0), (4.0, 103.0)].map(DVec2::from));
        assert_eq!(area(&moved), 98.0 * 104.0);
        assert_eq!(moved_out(&SQUARE, [0.0; 4]), Ok(SQUARE));
    }

    #[test]
    fn what_vanishes_is_named() {
        assert_eq!(moved_out(&SQUARE, [0.0, -60.0, 0.0, -60.0]), Err(Vanished::Side(0, -20.0)));
        assert!(matches!(moved_out(&SQUARE, [0.0, f64::NAN, 0.0, 0.0]), Err(Vanished::Side(..))));
        let straight = [DVec2::ZERO, DVec2::X * 50.0, DVec2::X * 100.0, DVec2::Y * 100.0];
        assert_eq!(moved_out(&straight, [1.0, 2.0, 0.0, 0.0]), Err(Vanished::Corner(1)));
        assert_eq!(moved_out(&straight, [1.0, 1.0, 0.0, 0.0]).unwrap()[1], DVec2::new(50.0, -1.0));
    }
}
