//! The parameters of the two methods, and what may not be asked of it.

use std::fmt;

/// The most iterations that may be asked for.
pub const MAX_ITERATIONS: u32 = 1_000_000;

/// Which vertices do not move.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Pin {
    /// Those on the boundary of the mesh.
    #[default]
    Boundary,
    /// None.
    None,
    /// Those that only one quad uses: the four corners of a grid.
    Corners,
}

/// The parameters of the perturbation method (the paper's section 7.2, GEOMETRY section 6a).
///
/// The objective is `worst` · (1 − worst planarity) + `average` · (1 − mean planarity).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Perturbation {
    /// α, the weight of the worst planarity; 0 or more.
    pub worst: f64,
    /// β, the weight of the mean planarity; 0 or more, and not both weights 0.
    pub average: f64,
    /// Quads whose planarity falls short of this are worked on: their vertices may move. −1 ..= 1.
    pub select: f64,
    /// The planarity which ends the search, once every selected quad has it. −1 ..= 1.
    pub threshold: f64,
    /// The step of the central differences that make the gradient, mm; above 0.
    pub step: f64,
    /// How far the vertex that moves most goes in the first trial step, and again each time the search forgets
    /// its direction; mm, above 0. The steps after it find their own length.
    pub move_length: f64,
    /// The most steps to make.
    pub iterations: u32,
    /// Which vertices do not move.
    pub pin: Pin,
}

/// The parameters of projection (GEOMETRY section 6b).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Projection {
    /// The planarity which ends it, once every quad has it. −1 ..= 1.
    pub threshold: f64,
    /// The diagonal ratio which every quad must come down to as well, where one is asked for; above 0.
    pub diagonal_ratio: Option<f64>,
    /// The most steps to make.
    pub iterations: u32,
    /// Which vertices do not move.
    pub pin: Pin,
}

/// Why a set of parameters is refused.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OptionsError {
    /// A weight is negative or not finite.
    Weight {
        /// `worst` or `average`.
        name: &'static str,
        /// What was given.
        value: f64,
    },
    /// Both weights are 0: nothing is asked for.
    NoWeight,
    /// A planarity outside −1 ..= 1.
    Planarity {
        /// `select` or `threshold`.
        name: &'static str,
        /// What was given.
        value: f64,
    },
    /// A length which is not above 0, or not finite.
    Length {
        /// `step` or `move`.
        name: &'static str,
        /// What was given, mm.
        value: f64,
    },
    /// A diagonal ratio which is not above 0.
    DiagonalRatio {
        /// What was given.
        value: f64,
    },
    /// More iterations than [`MAX_ITERATIONS`].
    Iterations {
        /// What was given.
        value: u32,
    },
}

impl fmt::Display for OptionsError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Weight { name, value } => write!(out, "`{name}` is a weight, 0 or more, but is {value}"),
            Self::NoWeight => {
                out.write_str("`worst` and `average` are both 0, so there is nothing to improve")
            }
            Self::Planarity { name, value } => {
                write!(out, "`{name}` is a planarity, from -1 to 1, but is {value}")
            }
            Self::Length { name, value } => write!(out, "`{name}` is a length above 0mm, but is {value}mm"),
            Self::DiagonalRatio { value } => write!(out, "a diagonal ratio of {value} cannot be aimed at"),
            Self::Iterations { value } => {
                write!(out, "`iterations` is {value}, but may be at most {MAX_ITERATIONS}")
            }
        }
    }
}

impl std::error::Error for OptionsError {}

impl Default for Perturbation {
    /// α 1, β 2, select 0.9999, threshold 0.9999, step 0.01 mm, move 0.5 mm, 400 iterations, boundary pinned.
    fn default() -> Self {
        Self {
            worst: 1.0,
            average: 2.0,
            select: 0.9999,
            threshold: 0.9999,
            step: 0.01,
            move_length: 0.5,
            iterations: 400,
            pin: Pin::Boundary,
        }
    }
}

impl Perturbation {
    /// The parameters after their checks.
    ///
    /// # Errors
    /// Negative weights or none, a planarity outside −1 ..= 1, lengths not above 0, too many iterations, and
    /// numbers that are not finite.
    pub fn try_new(given: Self) -> Result<Self, OptionsError> {
        for (name, value) in [("worst", given.worst), ("average", given.average)] {
            if !(value.is_finite() && value >= 0.0) {
                return Err(OptionsError::Weight { name, value });
            }
        }
        if given.worst == 0.0 && given.average == 0.0 {
            return Err(OptionsError::NoWeight);
        }
        for (name, value) in [("select", given.select), ("threshold", given.threshold)] {
            if !(-1.0..=1.0).contains(&value) {
                return Err(OptionsError::Planarity { name, value });
            }
        }
        for (name, value) in [("step", given.step), ("move", given.move_length)] {
            if !(value.is_finite() && value > 0.0) {
                return Err(OptionsError::Length { name, value });
            }
        }
        if given.iterations > MAX_ITERATIONS {
            return Err(OptionsError::Iterations { value: given.iterations });
        }
        Ok(given)
    }
}

impl Default for Projection {
    /// Threshold 0.9999, no diagonal ratio, 60 steps, boundary pinned.
    fn default() -> Self {
        Self { threshold: 0.9999, diagonal_ratio: None, iterations: 60, pin: Pin::Boundary }
    }
}

impl Projection {
    /// The parameters after their checks.
    ///
    /// # Errors
    /// A planarity outside −1 ..= 1, a diagonal ratio not above 0, too many iterations.
    pub fn try_new(given: Self) -> Result<Self, OptionsError> {
        if !(-1.0..=1.0).contains(&given.threshold) {
            return Err(OptionsError::Planarity { name: "threshold", value: given.threshold });
        }
        if let Some(value) = given.diagonal_ratio
            && !(value.is_finite() && value > 0.0)
        {
            return Err(OptionsError::DiagonalRatio { value });
        }
        if given.iterations > MAX_ITERATIONS {
            return Err(OptionsError::Iterations { value: given.iterations });
        }
        Ok(given)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defaults_are_sound() {
        assert!(Perturbation::try_new(Perturbation::default()).is_ok());
    }

    #[test]
    fn refuses_with_the_name_of_the_field() {
        let base = Perturbation::default();
        let cases = [
            (Perturbation { worst: -1.0, ..base }, "`worst`"),
            (Perturbation { average: f64::NAN, ..base }, "`average`"),
            (Perturbation { worst: 0.0, average: 0.0, ..base }, "both 0"),
            (Perturbation { select: 1.5, ..base }, "`select`"),
            (Perturbation { threshold: f64::NAN, ..base }, "`threshold`"),
            (Perturbation { step: 0.0, ..base }, "`step`"),
            (Perturbation { move_length: f64::INFINITY, ..base }, "`move`"),
            (Perturbation { iterations: MAX_ITERATIONS + 1, ..base }, "`iterations`"),
        ];
        for (options, word) in cases {
            let message = Perturbation::try_new(options).unwrap_err().to_string();
            assert!(message.contains(word), "{message}");
        }
    }
}
