//! Parallel views of space on paper: axonometric, plan and elevations.

use glam::{DVec2, DVec3};

/// The direction somebody looks in. The three are unit vectors, square to each other; designs are Z up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::export::html) struct View {
    right: DVec3,
    up: DVec3,
    /// Towards who looks.
    pub(in crate::export::html) toward: DVec3,
}

impl View {
    /// From above, x to the right and y up.
    pub(in crate::export::html) const PLAN: View = View { right: DVec3::X, up: DVec3::Y, toward: DVec3::Z };
    /// Along y, x to the right.
    pub(in crate::export::html) const FRONT: View =
        View { right: DVec3::X, up: DVec3::Z, toward: DVec3::NEG_Y };
    /// Along x, y to the left: it stands at the right of the front, as in first-angle projection.
    pub(in crate::export::html) const SIDE: View =
        View { right: DVec3::NEG_Y, up: DVec3::Z, toward: DVec3::NEG_X };

    /// From the front, the right and above: 32 degrees round and 28 degrees up.
    pub(in crate::export::html) fn axonometric() -> View {
        let (around, above) = (32_f64.to_radians(), 28_f64.to_radians());
        let ground = DVec3::new(libm::sin(around), -libm::cos(around), 0.0);
        let toward = ground * libm::cos(above) + DVec3::Z * libm::sin(above);
        let right = DVec3::new(libm::cos(around), libm::sin(around), 0.0);
        View { right, up: toward.cross(right), toward }
    }

    /// A point in the plane of the view, y up.
    pub(in crate::export::html) fn flat(&self, point: DVec3) -> DVec2 {
        DVec2::new(point.dot(self.right), point.dot(self.up))
    }

    /// How near a point is to who looks.
    pub(in crate::export::html) fn nearness(&self, point: DVec3) -> f64 {
        point.dot(self.toward)
    }

    /// How bright a face with this unit normal is, from 0 to 1: light comes over the left shoulder.
    pub(in crate::export::html) fn brightness(&self, normal: DVec3) -> f64 {
        let light = (self.toward * 0.75 + self.up * 0.7 - self.right * 0.45).normalize();
        0.62 + 0.38 * normal.dot(light).clamp(0.0, 1.0)
    }
}

/// A view on paper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::export::html) struct Frame {
    /// The view.
    pub(in crate::export::html) view: View,
    /// mm on paper for a mm of the design.
    pub(in crate::export::html) scale: f64,
    /// The upper left corner of what is shown, in the plane of the view.
    corner: DVec2,
    /// Where that corner lies on paper.
    origin: DVec2,
    /// The size of what is shown on paper, mm.
    pub(in crate::export::html) size: DVec2,
}

impl Frame {
    /// All points in a box of paper, as large as they go. None where there are no two points apart.
    pub(in crate::export::html) fn fitted(
        view: View,
        points: impl Iterator<Item = DVec3>,
        most: DVec2,
    ) -> Option<Frame> {
        let (low, high) = bounds(view, points)?;
        let size = high - low;
        let scale = [most.x / size.x, most.y / size.y].into_iter().filter(|scale| scale.is_finite());
        Some(Self::between(view, (low, high), scale.reduce(f64::min)?))
    }

    /// All points at a scale.
    pub(in crate::export::html) fn scaled(
        view: View,
        points: impl Iterator<Item = DVec3>,
        scale: f64,
    ) -> Option<Frame> {
        Some(Self::between(view, bounds(view, points)?, scale))
    }

    fn between(view: View, (low, high): (DVec2, DVec2), scale: f64) -> Frame {
        let corner = DVec2::new(low.x, high.y);
        Frame { view, scale, corner, origin: DVec2::ZERO, size: (high - low) * scale }
    }

    /// The same with its upper left corner elsewhere on paper.
    pub(in crate::export::html) fn moved_to(self, origin: DVec2) -> Frame {
        Frame { origin, ..self }
    }

    /// Where a point lies on paper, y down.
    pub(in crate::export::html) fn paper(&self, point: DVec3) -> DVec2 {
        let from = self.view.flat(point) - self.corner;
        self.origin + DVec2::new(from.x, -from.y) * self.scale
    }
}

/// The box around points in the plane of a view. None for no points.
pub(in crate::export::html) fn bounds(
    view: View,
    points: impl Iterator<Item = DVec3>,
) -> Option<(DVec2, DVec2)> {
    let flat = points.map(|point| view.flat(point)).filter(|point| point.is_finite());
    flat.fold(None, |found: Option<(DVec2, DVec2)>, point| {
        let (low, high) = found.unwrap_or((point, point));
        Some((low.min(point), high.max(point)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn views_are_square_and_right_handed() {
        for view in [View::PLAN, View::FRONT, View::SIDE, View::axonometric()] {
            assert!((view.right.cross(view.up) - view.toward).length() < 1e-12);
            assert!((view.toward.length() - 1.0).abs() < 1e-12);
        }
        let view = View::axonometric();
        assert!(view.flat(DVec3::Z).y > 0.8 && view.flat(DVec3::X).x > 0.8 && view.flat(DVec3::Y).y > 0.3);
    }

    #[test]
    fn frames_fit_and_keep_proportions() {
        let points = [DVec3::ZERO, DVec3::new(4000.0, 1000.0, 0.0)];
        let frame = Frame::fitted(View::PLAN, points.into_iter(), DVec2::new(100.0, 100.0)).unwrap();
        assert_eq!((frame.scale, frame.size), (0.025, DVec2::new(100.0, 25.0)));
        let frame = frame.moved_to(DVec2::new(10.0, 20.0));
        assert_eq!(frame.paper(points[0]), DVec2::new(10.0, 45.0));
        assert_eq!(frame.paper(points[1]), DVec2::new(110.0, 20.0));
        assert_eq!(Frame::fitted(View::PLAN, points[..1].iter().copied(), DVec2::ONE), None);
        assert_eq!(Frame::scaled(View::PLAN, std::iter::empty(), 1.0), None);
    }
}
