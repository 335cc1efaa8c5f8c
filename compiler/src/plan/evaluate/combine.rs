//! The inner loop: weighted sums of long rows, written so that the compiler turns it into vector instructions.

/// `out = Σ_i weights[i] · rows(i)`, summed in the order of i. Every row must be at least as long as `out`.
pub(super) fn combine<'a>(out: &mut [f64], weights: &[f64], rows: impl Fn(usize) -> &'a [f64]) {
    let mut done = 0;
    while done < weights.len() {
        let part = &weights[done..];
        let row = |i: usize| rows(done + i);
        done += match *part {
            [a, b, c, d, ..] => add([a, b, c, d], [row(0), row(1), row(2), row(3)], out, done == 0),
            [a, b, c] => add([a, b, c], [row(0), row(1), row(2)], out, done == 0),
            [a, b] => add([a, b], [row(0), row(1)], out, done == 0),
            [a] => add([a], [row(0)], out, done == 0),
            [] => break,
        };
    }
}

/// Adds N weighted rows to `out`, or sets `out` to their sum; returns N.
fn add<const N: usize>(weights: [f64; N], rows: [&[f64]; N], out: &mut [f64], set: bool) -> usize {
    // Slices of one length, known before the loop: no bounds checks inside it.
    let length = out.len();
    let rows = rows.map(|row| &row[..length]);
    if set {
        for (x, value) in out.iter_mut().enumerate() {
            let mut sum = weights[0] * rows[0][x];
            for i in 1..N {
                sum += weights[i] * rows[i][x];
            }
            *value = sum;
        }
    } else {
        for (x, value) in out.iter_mut().enumerate() {
            let mut sum = *value;
            for i in 0..N {
                sum += weights[i] * rows[i][x];
            }
            *value = sum;
        }
    }
    N
}
