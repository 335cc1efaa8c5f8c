//! The limited-memory BFGS direction (Nocedal 1980), over displacements of vertices.

use std::collections::VecDeque;

use glam::DVec3;

use super::smoothing::Smoothing;

/// How many steps are remembered.
const MEMORY: usize = 20;

/// The last steps and the changes of the gradient along them.
#[derive(Default)]
pub(super) struct Memory {
    pairs: VecDeque<Pair>,
}

struct Pair {
    step: Vec<DVec3>,
    change: Vec<DVec3>,
    /// 1 / (step · change).
    rho: f64,
}

impl Memory {
    /// Whether nothing is remembered, so that the direction has no length of its own yet.
    pub(super) fn is_empty(&self) -> bool {
        self.pairs.is_empty()
    }

    /// Forgets everything.
    pub(super) fn clear(&mut self) {
        self.pairs.clear();
    }

    /// Remembers a step and the change of the gradient along it, unless the objective did not curve upwards.
    pub(super) fn remember(&mut self, step: Vec<DVec3>, change: Vec<DVec3>) {
        let curvature = dot(&step, &change);
        let size = (dot(&step, &step) * dot(&change, &change)).sqrt();
        if !(curvature > 1e-10 * size && (1.0 / curvature).is_finite()) {
            return;
        }
        if self.pairs.len() == MEMORY {
            self.pairs.pop_front();
        }
        self.pairs.push_back(Pair { step, change, rho: 1.0 / curvature });
    }

    /// The descent direction for `gradient`, by the two-loop recursion, starting from `smoothing` as the first guess of
    /// the inverse Hessian.
    pub(super) fn direction(&self, gradient: &[DVec3], smoothing: &Smoothing) -> Vec<DVec3> {
        let mut direction: Vec<DVec3> = gradient.iter().map(|part| -*part).collect();
        let mut factors = Vec::with_capacity(self.pairs.len());
        for pair in self.pairs.iter().rev() {
            let factor = pair.rho * dot(&pair.step, &direction);
            add(&mut direction, -factor, &pair.change);
            factors.push(factor);
        }
        direction = smoothing.apply(&direction);
        if let Some(pair) = self.pairs.back() {
            let scale = 1.0 / (pair.rho * dot(&pair.change, &smoothing.apply(&pair.change)));
            direction.iter_mut().for_each(|part| *part *= scale);
        }
        for (pair, factor) in self.pairs.iter().zip(factors.iter().rev()) {
            let back = pair.rho * dot(&pair.change, &direction);
            add(&mut direction, factor - back, &pair.step);
        }
        direction
    }
}

/// The sum of the products of all coordinates, in their order.
pub(super) fn dot(left: &[DVec3], right: &[DVec3]) -> f64 {
    left.iter().zip(right).map(|(left, right)| left.dot(*right)).sum()
}

/// Adds `factor` times `other`.
pub(super) fn add(to: &mut [DVec3], factor: f64, other: &[DVec3]) {
    to.iter_mut().zip(other).for_each(|(to, other)| *to += *other * factor);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::samples;

    #[test]
    fn finds_the_bottom_of_a_narrow_bowl() {
        // f(x) = Σ k² |x_k − X|² / 2 over 16 vertices: curvatures from 1 to 256.
        let mesh = samples::flat_grid(4, 4, 100.0);
        let smoothing = Smoothing::new(&mesh, &[true; 16]);
        let gradient = |at: &[DVec3]| -> Vec<DVec3> {
            at.iter().zip(1u8..).map(|(point, k)| (*point - DVec3::X) * f64::from(k) * f64::from(k)).collect()
        };
        let value = |at: &[DVec3]| -> f64 {
            let offset: Vec<DVec3> = at.iter().map(|point| *point - DVec3::X).collect();
            dot(&offset, &gradient(at)) / 2.0
        };
        let mut memory = Memory::default();
        let mut present = vec![DVec3::new(3.0, -2.0, 1.0); 16];
        for _ in 0..200 {
            let slope = gradient(&present);
            let direction = memory.direction(&slope, &smoothing);
            assert!(dot(&slope, &direction) <= 0.0);
            let (mut length, mut next) = (1.0, present.clone());
            add(&mut next, length, &direction);
            while value(&next) > value(&present) && length > 1e-9 {
                length /= 2.0;
                next.clone_from(&present);
                add(&mut next, length, &direction);
            }
            let (mut step, mut change) = (next.clone(), gradient(&next));
            add(&mut step, -1.0, &present);
            add(&mut change, -1.0, &slope);
            memory.remember(step, change);
            present = next;
        }
        assert!(present.iter().all(|point| (*point - DVec3::X).length() < 1e-6), "{}", value(&present));
        memory.clear();
        assert!(memory.is_empty());
    }

    #[test]
    fn steps_along_which_nothing_curves_are_not_remembered() {
        let mut memory = Memory::default();
        memory.remember(vec![DVec3::X], vec![-DVec3::X]);
        memory.remember(vec![DVec3::X], vec![DVec3::Y]);
        memory.remember(vec![DVec3::ZERO], vec![DVec3::ZERO]);
        memory.remember(vec![DVec3::X], vec![DVec3::NAN]);
        assert!(memory.is_empty());
    }
}
