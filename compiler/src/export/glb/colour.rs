//! The colours of the planarity map, in the model and in the report: blue is flatter than required, light grey just as required, red twice as far off.

use crate::geometry::QuadMeasure;

/// How many steps the scale has.
const STEPS: usize = 256;

/// sRGB of the two ends and the middle, after Moreland 2009 ("Diverging Color Maps for Scientific Visualization").
const ENDS: [[f64; 3]; 3] = [[0.230, 0.299, 0.754], [0.865, 0.865, 0.865], [0.706, 0.016, 0.150]];

/// sRGB of a quad whose planarity says nothing: darts and their like.
const NONE: [f64; 3] = [0.15, 0.0, 0.15];

/// A scale of planarity with the required one in its middle.
#[derive(Debug, Clone)]
pub(in crate::export) struct Scale {
    /// Linear RGBA for the angles from 0 to twice the allowed fold.
    steps: Vec<[u16; 4]>,
    /// The fold that is still allowed, rad.
    allowed: f64,
}

impl Scale {
    /// The scale around the planarity `required`.
    pub(in crate::export) fn around(required: f64) -> Self {
        let steps = (0..STEPS).map(|step| colour(step as f64 / (STEPS - 1) as f64)).collect();
        Self { steps, allowed: libm::acos(required.clamp(-1.0, 1.0)).max(1e-6) }
    }

    /// The sRGB colour of a larger fold, rad; none for a quad that has none.
    pub(in crate::export) fn srgb(&self, fold: Option<f64>) -> [f64; 3] {
        fold.map_or(NONE, |fold| mixed((fold / (2.0 * self.allowed)).clamp(0.0, 1.0)).map(from_linear))
    }

    /// The colour of a quad, linear RGBA as glTF has it in 16 bits.
    pub(super) fn of(&self, measure: &QuadMeasure) -> [u16; 4] {
        let Some(fold) = measure.larger_fold() else {
            return linear(NONE);
        };
        let place = (fold / (2.0 * self.allowed)).min(1.0);
        self.steps[(place * (STEPS - 1) as f64).round() as usize]
    }
}

/// The colour at `place` in 0 ..= 1, mixed in OKLab (Ottosson 2020), so that equal steps look equal.
fn colour(place: f64) -> [u16; 4] {
    rgba(mixed(place))
}

/// The same, linear red, green and blue.
fn mixed(place: f64) -> [f64; 3] {
    let (from, to, part) =
        if place < 0.5 { (ENDS[0], ENDS[1], place * 2.0) } else { (ENDS[1], ENDS[2], place * 2.0 - 1.0) };
    let (from, to) = (oklab(from), oklab(to));
    from_oklab([0, 1, 2].map(|axis| from[axis] + (to[axis] - from[axis]) * part))
}

fn linear(srgb: [f64; 3]) -> [u16; 4] {
    rgba(srgb.map(to_linear))
}

fn rgba(linear: [f64; 3]) -> [u16; 4] {
    let [red, green, blue] = linear.map(|part| (part.clamp(0.0, 1.0) * 65535.0).round() as u16);
    [red, green, blue, u16::MAX]
}

fn to_linear(part: f64) -> f64 {
    if part <= 0.04045 { part / 12.92 } else { libm::pow((part + 0.055) / 1.055, 2.4) }
}

fn from_linear(part: f64) -> f64 {
    let part = part.clamp(0.0, 1.0);
    if part <= 0.003_130_8 { part * 12.92 } else { 1.055 * libm::pow(part, 1.0 / 2.4) - 0.055 }
}

fn times(matrix: [[f64; 3]; 3], vector: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2])
}

fn oklab(srgb: [f64; 3]) -> [f64; 3] {
    let cones = times(
        [
            [0.4122214708, 0.5363325363, 0.0514459929],
            [0.2119034982, 0.6806995451, 0.1073969566],
            [0.0883024619, 0.2817188376, 0.6299787005],
        ],
        srgb.map(to_linear),
    );
    times(
        [
            [0.2104542553, 0.7936177850, -0.0040720468],
            [1.9779984951, -2.4285922050, 0.4505937099],
            [0.0259040371, 0.7827717662, -0.8086757660],
        ],
        cones.map(libm::cbrt),
    )
}

fn from_oklab(lab: [f64; 3]) -> [f64; 3] {
    let cones = times(
        [
            [1.0, 0.3963377774, 0.2158037573],
            [1.0, -0.1055613458, -0.0638541728],
            [1.0, -0.0894841775, -1.2914855480],
        ],
        lab,
    );
    times(
        [
            [4.0767416621, -3.3077115913, 0.2309699292],
            [-1.2684380046, 2.6097574011, -0.3413193965],
            [-0.0041960863, -0.7034186147, 1.7076147010],
        ],
        cones.map(|root| root * root * root),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::samples;

    #[test]
    fn ends_and_middle() {
        for (place, srgb) in [(0.0, ENDS[0]), (0.5, ENDS[1]), (1.0, ENDS[2])] {
            let (found, wanted) = (colour(place), linear(srgb));
            assert!((0..4).all(|part| found[part].abs_diff(wanted[part]) <= 2), "{found:?} {wanted:?}");
        }
    }

    #[test]
    fn flat_is_blue_and_folded_is_red() {
        let scale = Scale::around(0.9998);
        let mut corners = samples::square(250.0);
        let [red, _, blue, _] = scale.of(&QuadMeasure::of(corners));
        assert!(blue > 3 * red);
        corners[0].z = 40.0;
        let [red, _, blue, _] = scale.of(&QuadMeasure::of(corners));
        assert!(red > 3 * blue);
        assert_eq!(scale.of(&QuadMeasure::of([corners[0]; 4])), linear(NONE));
    }
}
