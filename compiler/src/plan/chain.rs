//! [`ChainPlan`]: a curve of every window of a list of control points, or of one window with weights; open or closed.
//!
//! A plain open curve on one window is [`super::Shape::Curve`].

use crate::ifs::StateId;

use super::figure::Dimension;

/// A curve on a list of control points, some of which may be heavier than others.
#[derive(Clone, Debug, PartialEq)]
pub struct ChainPlan {
    /// The ifs it runs.
    pub state: StateId,
    /// Its control points, in millimetres.
    pub points: Vec<[f64; 3]>,
    /// Their weights, above 0, where it is rational.
    pub weights: Option<Vec<f64>>,
    /// The iteration level.
    pub level: u32,
    /// Of the plane or of space.
    pub dimension: Dimension,
    /// Whether every window of the list is a piece, or the list is one window.
    pub windows: bool,
    /// Whether the windows go round, from the last points on to the first.
    pub closed: bool,
}

/// How many windows of `size` points a list has: those of consecutive points, going round where it is closed.
/// 0 where it has fewer points than a window.
pub(super) fn window_count(points: usize, size: usize, closed: bool) -> usize {
    match closed {
        _ if points < size => 0,
        true => points,
        false => points - size + 1,
    }
}

/// The rows (wx, wy, wz, w) of points with weights (GEOMETRY 1).
pub(super) fn homogeneous(points: &[[f64; 3]], weights: &[f64]) -> Vec<[f64; 4]> {
    let row = |(point, weight): (&[f64; 3], &f64)| {
        [point[0] * weight, point[1] * weight, point[2] * weight, *weight]
    };
    points.iter().zip(weights).map(row).collect()
}
