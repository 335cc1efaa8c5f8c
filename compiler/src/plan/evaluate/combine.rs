//! The inner loop: weighted sums of long rows in the vector instructions of the processor at hand.
//!
//! Products and sums are rounded one by one and never fused, and lanes do not mix: the bits are the same on every
//! processor.

use pulp::{Arch, Simd, WithSimd};

/// `out = Σ_i weights[i] · rows(i)`, summed in the order of i. Every row must be at least as long as `out`.
pub(super) fn combine<'a>(arch: Arch, out: &mut [f64], weights: &[f64], rows: impl Fn(usize) -> &'a [f64]) {
    let mut done = 0;
    while done < weights.len() {
        let part = &weights[done..];
        let row = |i: usize| rows(done + i);
        let set = done == 0;
        done += match *part {
            [a, b, c, d, ..] => add(arch, [a, b, c, d], [row(0), row(1), row(2), row(3)], out, set),
            [a, b, c] => add(arch, [a, b, c], [row(0), row(1), row(2)], out, set),
            [a, b] => add(arch, [a, b], [row(0), row(1)], out, set),
            [a] => add(arch, [a], [row(0)], out, set),
            [] => break,
        };
    }
}

/// Adds N weighted rows to `out`, or sets `out` to their sum; returns N.
fn add<const N: usize>(
    arch: Arch,
    weights: [f64; N],
    rows: [&[f64]; N],
    out: &mut [f64],
    set: bool,
) -> usize {
    let length = out.len();
    let rows = rows.map(|row| &row[..length]);
    if set {
        arch.dispatch(Add::<N, true> { weights, rows, out });
    } else {
        arch.dispatch(Add::<N, false> { weights, rows, out });
    }
    N
}

/// The loop of [`add`], for one kind of vector instructions at a time.
struct Add<'a, const N: usize, const SET: bool> {
    weights: [f64; N],
    rows: [&'a [f64]; N],
    out: &'a mut [f64],
}

impl<const N: usize, const SET: bool> WithSimd for Add<'_, N, SET> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let splats = self.weights.map(|weight| simd.splat_f64s(weight));
        let split = self.rows.map(S::as_simd_f64s);
        let (out, out_rest) = S::as_mut_simd_f64s(self.out);
        let (length, rest) = (out.len(), out_rest.len());
        let rows = split.map(|(vectors, _)| &vectors[..length]);
        for x in 0..length {
            let first = simd.mul_f64s(splats[0], rows[0][x]);
            let mut sum = if SET { first } else { simd.add_f64s(out[x], first) };
            for i in 1..N {
                sum = simd.add_f64s(sum, simd.mul_f64s(splats[i], rows[i][x]));
            }
            out[x] = sum;
        }
        let rows = split.map(|(_, scalars)| &scalars[..rest]);
        for (x, value) in out_rest.iter_mut().enumerate() {
            let first = self.weights[0] * rows[0][x];
            let start = if SET { first } else { *value + first };
            let others = self.weights.iter().zip(&rows).skip(1);
            *value = others.fold(start, |sum, (weight, row)| sum + weight * row[x]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whatever the processor: the same bits as sums of products rounded one by one.
    #[test]
    fn bits_are_those_of_plain_sums() {
        let value = |i: usize, x: usize| 1.0 / (1 + (i * 37 + x * 11) % 97) as f64 - 0.3;
        for length in [0, 1, 2, 3, 7, 8, 31, 100] {
            for count in 1..11 {
                let rows: Vec<Vec<f64>> =
                    (0..count).map(|i| (0..length + 1).map(|x| value(i, x)).collect()).collect();
                let weights: Vec<f64> = (0..count).map(|i| value(i, 5) / 3.0).collect();
                let plain = |x: usize| {
                    (1..count).fold(weights[0] * rows[0][x], |sum, i| sum + weights[i] * rows[i][x]).to_bits()
                };
                let mut out = vec![f64::NAN; length];
                combine(Arch::new(), &mut out, &weights, |i| &rows[i]);
                let bits: Vec<u64> = out.iter().map(|value| value.to_bits()).collect();
                assert_eq!(bits, (0..length).map(plain).collect::<Vec<_>>());
            }
        }
    }
}
