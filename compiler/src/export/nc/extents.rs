//! The box a program's tools sweep: in X and Y what they cut, in Z all heights they go to. In thousandths of a mm.

/// Least and greatest per axis.
#[derive(Clone, Debug, Default)]
pub(super) struct Extents {
    ranges: [Option<(i64, i64)>; 3],
}

impl Extents {
    /// Takes in the tool of this radius with its centre at `value` on axis 0, 1 or 2.
    pub(super) fn take(&mut self, axis: usize, value: i64, radius: i64) {
        let (low, high) = self.ranges[axis].unwrap_or((value - radius, value + radius));
        self.ranges[axis] = Some((low.min(value - radius), high.max(value + radius)));
    }

    /// Axis letter, least, greatest. An axis nothing was taken in on is absent.
    pub(super) fn axes(&self) -> impl Iterator<Item = (char, i64, i64)> {
        ['x', 'y', 'z']
            .into_iter()
            .zip(self.ranges)
            .filter_map(|(axis, range)| range.map(|(l, h)| (axis, l, h)))
    }
}
