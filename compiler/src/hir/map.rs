//! [`Map`]: an affine map of the plane or of space as a value, its composition and what it does to points and vectors.
//! What makes maps (turns, scales, …) is in `evaluate/map.rs`.

use super::scalar::{Scalar, ScalarError};
use super::types::PointSpace;

/// Three numbers: coordinates in mm, or a row of a matrix.
pub type Triple = [Scalar; 3];

/// `p ↦ linear · p + offset`.
///
/// A map of the plane is kept as the map of space that leaves the third coordinate as it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// The plane, space, or any of the two where it serves in both, as `scale(2)` does.
    pub space: PointSpace,
    /// The linear part, row by row.
    pub linear: [Triple; 3],
    /// What the origin goes to, mm.
    pub offset: Triple,
}

/// Three zeros.
pub fn zeros() -> Triple {
    [Scalar::zero(), Scalar::zero(), Scalar::zero()]
}

/// A matrix with these numbers on its diagonal and zeros beside it.
pub fn diagonal([a, b, c]: Triple) -> [Triple; 3] {
    let zero = Scalar::zero;
    [[a, zero(), zero()], [zero(), b, zero()], [zero(), zero(), c]]
}

impl Map {
    /// The map that leaves everything where it is.
    pub fn identity() -> Map {
        let linear = diagonal([Scalar::one(), Scalar::one(), Scalar::one()]);
        Map { space: PointSpace::Any, linear, offset: zeros() }
    }

    /// The map that moves everything by a vector, mm.
    pub fn translation(space: PointSpace, by: Triple) -> Map {
        Map { space, offset: by, ..Map::identity() }
    }

    /// The linear map of the plane with this matrix, row by row.
    pub fn plane(a: Scalar, b: Scalar, c: Scalar, d: Scalar) -> Map {
        let zero = Scalar::zero;
        let linear = [[a, b, zero()], [c, d, zero()], [zero(), zero(), Scalar::one()]];
        Map { space: PointSpace::Plane, linear, offset: zeros() }
    }

    /// The linear map with this matrix, row by row.
    pub fn linear(space: PointSpace, linear: [Triple; 3]) -> Map {
        Map { space, linear, offset: zeros() }
    }

    /// The same map, known to be of this space.
    pub fn of(mut self, space: PointSpace) -> Map {
        if space == PointSpace::Plane {
            let (zero, one) = (Scalar::zero, Scalar::one());
            self.linear[0][2] = zero();
            self.linear[1][2] = zero();
            self.linear[2] = [zero(), zero(), one];
            self.offset[2] = zero();
        }
        self.space = space;
        self
    }

    /// The same linear part around a point that stays where it is.
    ///
    /// # Errors
    /// When a number is not finite or not to be determined.
    pub fn about(mut self, point: &Triple) -> Result<Map, ScalarError> {
        let moved = self.turned(point)?;
        for ((offset, still), moved) in self.offset.iter_mut().zip(point).zip(moved) {
            *offset = still.minus(&moved)?;
        }
        Ok(self)
    }

    /// This map after another, as a map of `space`.
    ///
    /// # Errors
    /// As for [`Map::about`].
    pub fn after(&self, first: &Map, space: PointSpace) -> Result<Map, ScalarError> {
        let column = |place: usize| first.linear.each_ref().map(|row| row[place].clone());
        let columns = [self.turned(&column(0))?, self.turned(&column(1))?, self.turned(&column(2))?];
        let row = |place: usize| columns.each_ref().map(|column| column[place].clone());
        let linear = [row(0), row(1), row(2)];
        Ok(Map { space, linear, offset: self.moved(&first.offset)? }.of(space))
    }

    /// What a vector becomes.
    ///
    /// # Errors
    /// As for [`Map::about`].
    pub fn turned(&self, vector: &Triple) -> Result<Triple, ScalarError> {
        let [a, b, c] = &self.linear;
        Ok([dot(a, vector)?, dot(b, vector)?, dot(c, vector)?])
    }

    /// What a point becomes.
    ///
    /// # Errors
    /// As for [`Map::about`].
    pub fn moved(&self, point: &Triple) -> Result<Triple, ScalarError> {
        let [x, y, z] = self.turned(point)?;
        let [a, b, c] = &self.offset;
        Ok([x.plus(a)?, y.plus(b)?, z.plus(c)?])
    }

    /// Its numbers, for counting work.
    pub fn scalars(&self) -> Vec<Scalar> {
        self.linear.iter().flatten().chain(&self.offset).cloned().collect()
    }
}

/// The inner product. What is exactly zero adds nothing, so that no rounding enters through it.
///
/// # Errors
/// When a number is not finite or not to be determined.
pub fn dot(a: &Triple, b: &Triple) -> Result<Scalar, ScalarError> {
    let mut total = Scalar::zero();
    for (a, b) in a.iter().zip(b) {
        total = total.plus(&product(a, b)?)?;
    }
    Ok(total)
}

/// The vector square to two others by the right-hand rule.
///
/// # Errors
/// As for [`dot`].
pub fn cross(a: &Triple, b: &Triple) -> Result<Triple, ScalarError> {
    let part = |i: usize, j: usize| product(&a[i], &b[j])?.minus(&product(&a[j], &b[i])?);
    Ok([part(1, 2)?, part(2, 0)?, part(0, 1)?])
}

/// The product, exact where a factor is exactly 0 or 1.
///
/// # Errors
/// As for [`dot`].
pub fn product(a: &Scalar, b: &Scalar) -> Result<Scalar, ScalarError> {
    let (zero, one) = (Scalar::zero(), Scalar::one());
    if *a == zero || *b == zero {
        return Ok(zero);
    }
    if *a == one {
        return Ok(b.clone());
    }
    if *b == one { Ok(a.clone()) } else { a.times(b) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;

    fn number(n: i64, d: i64) -> Scalar {
        Scalar::Exact(Rational::new(n, d).unwrap())
    }

    fn whole(values: [i64; 3]) -> Triple {
        values.map(Scalar::integer)
    }

    #[test]
    fn a_composition_does_the_right_one_first() {
        let quarter = Map::plane(whole([0; 3])[0].clone(), number(-1, 1), number(1, 1), number(0, 1));
        let shift = Map::translation(PointSpace::Plane, whole([10, 0, 0]));
        let both = shift.after(&quarter, PointSpace::Plane).unwrap();
        assert_eq!(both.moved(&whole([1, 2, 0])), Ok(whole([8, 1, 0])));
        let other = quarter.after(&shift, PointSpace::Plane).unwrap();
        assert_eq!(other.moved(&whole([1, 2, 0])), Ok(whole([-2, 11, 0])));
        assert_eq!(other.turned(&whole([1, 2, 0])), Ok(whole([-2, 1, 0])));
    }

    #[test]
    fn a_map_about_a_point_keeps_it() {
        let half = Map::linear(PointSpace::Any, diagonal([number(1, 2), number(1, 2), number(1, 2)]));
        let map = half.about(&whole([4, -6, 1])).unwrap();
        assert_eq!(map.moved(&whole([4, -6, 1])), Ok(whole([4, -6, 1])));
        assert_eq!(map.of(PointSpace::Plane).moved(&whole([0, 0, 7])), Ok(whole([2, -3, 7])));
    }

    #[test]
    fn rounded_numbers_do_not_spread_through_zeros() {
        let rounded = Scalar::Real(0.7);
        assert_eq!(product(&rounded, &Scalar::zero()), Ok(Scalar::zero()));
        assert_eq!(cross(&whole([1, 0, 0]), &whole([0, 1, 0])), Ok(whole([0, 0, 1])));
    }
}
