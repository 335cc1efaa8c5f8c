//! One linear step: the fairest displacement that takes the excess of all constraints away, by conjugate gradients on
//! the normal equations (CGLS; Hestenes and Stiefel 1952, Björck 1996) in the metric of fairness.
//!
//! The constraints are mixed second differences and the metric is that of fourth differences, so their product is of
//! order zero: the number of iterations hardly grows with the mesh. Where the excess cannot be taken away, stopping
//! early keeps the displacement small.

use glam::DVec3;

use crate::planarize::lbfgs::{add, dot};

use super::constraints::Row;
use super::displacement::{Displacement, HELD};

/// The part of the excess that may be left.
const LEFT: f64 = 0.05;

/// The most iterations.
const ITERATIONS: usize = 60;

/// The displacement that takes the excess of `rows` away, in places of `fairness`. Zero where none does.
pub(super) fn step(rows: &[Row], fairness: &Displacement) -> Vec<DVec3> {
    let mut left: Vec<f64> = rows.iter().map(|row| -row.excess).collect();
    let goal = LEFT * LEFT * squared(&left);
    let mut sum = vec![DVec3::ZERO; fairness.len()];
    let mut slope = slopes(rows, &left, fairness);
    let mut direction = slope.clone();
    let mut size = dot(&slope, &slope);
    for _ in 0..ITERATIONS {
        let mut smooth = direction.clone();
        fairness.smooth(&mut smooth);
        let change = changes(rows, &smooth);
        let length = size / squared(&change);
        if !(length.is_finite() && length > 0.0) {
            break;
        }
        add(&mut sum, length, &direction);
        left.iter_mut().zip(&change).for_each(|(left, change)| *left -= length * change);
        if squared(&left) <= goal {
            break;
        }
        slope = slopes(rows, &left, fairness);
        let next = dot(&slope, &slope);
        let factor = next / size;
        direction
            .iter_mut()
            .zip(&slope)
            .for_each(|(direction, slope)| *direction = *slope + *direction * factor);
        size = next;
    }
    fairness.smooth(&mut sum);
    sum
}

fn squared(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum()
}

/// How a displacement changes each constraint.
fn changes(rows: &[Row], displacement: &[DVec3]) -> Vec<f64> {
    let change = |row: &Row| {
        let corners = row.corners.iter().zip(&row.slopes).filter(|(corner, _)| **corner != HELD);
        corners.map(|(&corner, slope)| slope.dot(displacement[corner as usize])).sum()
    };
    rows.iter().map(change).collect()
}

/// The transpose of [`changes`], smoothed.
fn slopes(rows: &[Row], values: &[f64], fairness: &Displacement) -> Vec<DVec3> {
    let mut sum = vec![DVec3::ZERO; fairness.len()];
    for (row, value) in rows.iter().zip(values) {
        for (&corner, slope) in row.corners.iter().zip(&row.slopes) {
            if corner != HELD {
                sum[corner as usize] += *slope * *value;
            }
        }
    }
    fairness.smooth(&mut sum);
    sum
}
