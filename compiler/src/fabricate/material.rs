//! What a board or plank is made of, and how tightly it may be bent. Tables of real materials are in the standard
//! library of the language.

/// A material. mm and kg.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// Its name in lists and reports.
    pub name: String,
    /// Thickness of a sheet, mm; none for what has no thickness of its own, such as sawn timber.
    pub thickness: Option<f64>,
    /// kg/mm³; none where unknown, and then no mass is given.
    pub density: Option<f64>,
    /// The tightest bend it takes; none where unknown.
    pub least_bend_radius: Option<LeastBendRadius>,
}

/// The least radii to which a sheet may be bent, mm.
///
/// Sources name either the axis or the direction of the bend; here it is always the direction in which the sheet
/// curves, as in APA's tables for plywood:
///
/// ```text
///   across: the sheet curves across the grain     along: the sheet curves along the grain
///   (the axis runs with the grain; the            (the axis runs square to the grain; the
///   fibres stay straight: bends easily)           fibres bend: bends hard)
///
///        _.-----._                                     _.-----._
///      .'  o o o  '.   ends of the fibres            .' ======= '.   fibres
///     /  o       o  \                               / ==       == \
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeastBendRadius {
    /// When it curves across the grain (bend axis along the grain), mm.
    pub across: f64,
    /// When it curves along the grain (bend axis square to the grain), mm.
    pub along: f64,
}

impl LeastBendRadius {
    /// The least radius, mm, for a bend axis at the angle `axis_to_grain` (rad, 0 ..= π/2) to the grain: with
    /// φ = π/2 − `axis_to_grain`, the angle between the grain and the direction in which the sheet curves,
    /// across·sin²φ + along·cos²φ.
    ///
    /// A model, on the cautious side. A cylinder of radius R has the curvatures cos²φ/R along the grain and sin²φ/R
    /// across it; where each alone may use up the whole of its limit (the larger of across·sin²φ and along·cos²φ,
    /// GEOMETRY section 7) a sheet that is the same in all directions could be bent to half its radius at 45°. Here
    /// the two share what the sheet takes, so that a radius is never below the smaller of the two limits.
    #[must_use]
    pub fn at(&self, axis_to_grain: f64) -> f64 {
        let (along, across) = (libm::sin(axis_to_grain), libm::cos(axis_to_grain));
        self.along * along * along + self.across * across * across
    }

    /// The larger of the two, mm: for a board whose grain may lie in any direction.
    #[must_use]
    pub fn any_direction(&self) -> f64 {
        self.across.max(self.along)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

    /// 12.7 mm plywood, dry (APA).
    const PLYWOOD: LeastBendRadius = LeastBendRadius { across: 1829.0, along: 3658.0 };

    #[test]
    fn fibres_that_bend_need_the_larger_radius() {
        assert_eq!(PLYWOOD.at(0.0), 1829.0, "the axis runs with the grain");
        assert!((PLYWOOD.at(FRAC_PI_2) - 3658.0).abs() < 1e-9, "the axis runs square to it");
        assert!((PLYWOOD.at(FRAC_PI_4) - 2743.5).abs() < 1e-9, "half of each");
        assert_eq!(PLYWOOD.any_direction(), 3658.0);
    }

    #[test]
    fn between_the_two_and_never_below_what_each_direction_needs() {
        let even = LeastBendRadius { across: 2750.0, along: 2750.0 };
        let mut last = 0.0;
        for step in 0..=90 {
            let angle = f64::from(step).to_radians();
            let needed = PLYWOOD.at(angle);
            assert!((1829.0 - 1e-9..=PLYWOOD.any_direction() + 1e-9).contains(&needed));
            assert!(needed > last, "more, the farther the axis turns from the grain");
            let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
            let (along, across) = (3658.0 * sine * sine, 1829.0 * cosine * cosine);
            assert!(needed >= along.max(across) - 1e-9);
            assert!((even.at(angle) - 2750.0).abs() < 1e-9, "the same in all directions");
            last = needed;
        }
    }
}
