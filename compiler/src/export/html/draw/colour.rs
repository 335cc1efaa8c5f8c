//! Colours as the style of a shape, mixing of them, and the scale of distances.

/// sRGB, each from 0 to 1.
pub(in crate::export::html) type Srgb = [f64; 3];

/// Wood.
pub(in crate::export::html) const WOOD: Srgb = [0.890, 0.765, 0.580];

/// The ends and steps between of the scale of distances: lighter is less, in print and for every eye.
const DISTANCE: [Srgb; 4] =
    [[0.965, 0.957, 0.925], [0.635, 0.812, 0.784], [0.216, 0.529, 0.616], [0.102, 0.216, 0.380]];

/// `#e3c394`
pub(in crate::export::html) fn hex(colour: Srgb) -> String {
    let [red, green, blue] = colour.map(|part| (part.clamp(0.0, 1.0) * 255.0).round() as u8);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// A colour as bright as a part of it.
pub(in crate::export::html) fn lit(colour: Srgb, brightness: f64) -> Srgb {
    colour.map(|part| part * brightness)
}

/// The colour of a distance that is `part` of the largest.
pub(in crate::export::html) fn distance(part: f64) -> Srgb {
    let place = part.clamp(0.0, 1.0) * (DISTANCE.len() - 1) as f64;
    let below = (place as usize).min(DISTANCE.len() - 2);
    let share = place - below as f64;
    [0, 1, 2].map(|part| DISTANCE[below][part] * (1.0 - share) + DISTANCE[below + 1][part] * share)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_is_darker() {
        let sums: Vec<f64> = (0..=30).map(|step| distance(f64::from(step) / 30.0).iter().sum()).collect();
        assert!(sums.windows(2).all(|pair| pair[1] < pair[0]));
        assert_eq!((hex(distance(-1.0)), hex(distance(2.0))), (hex(DISTANCE[0]), hex(DISTANCE[3])));
        assert_eq!(hex(lit([1.0, 0.5, 0.0], 0.5)), "#804000");
    }
}
