//! Boards to be nested: of a shell whose quads are nearly alike, of one that is rough, of quads of all sizes, and of
//! a rough shell at finer and finer levels, whose boards are smaller the more they are.

use glam::DVec2;
use ifs_compiler::nest::sheets::Part;

/// Numbers from 0 to 1 that are the same in every run (a linear congruential generator).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as f64 / (1_u64 << 24) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// Sets of that many boards, each with its name.
pub fn all(count: usize) -> Vec<(&'static str, Vec<Part>)> {
    vec![
        ("smooth", quads(count, (280.0, 320.0), (230.0, 260.0), 10.0, false)),
        ("rough", quads(count, (180.0, 420.0), (150.0, 330.0), 40.0, false)),
        ("grain free", quads(count, (180.0, 420.0), (150.0, 330.0), 40.0, true)),
        ("all sizes", quads(count, (60.0, 800.0), (50.0, 500.0), 30.0, true)),
        ("one shell", finer(quads(count, (180.0, 420.0), (150.0, 330.0), 40.0, true))),
    ]
}

/// The boards made so small that all together keep the area of 256.
fn finer(mut boards: Vec<Part>) -> Vec<Part> {
    let scale = (256.0 / boards.len() as f64).sqrt();
    boards.iter_mut().flat_map(|board| &mut board.outline).for_each(|corner| *corner *= scale);
    boards
}

/// Quads of lengths and widths in a range, their corners moved by up to `skew`.
fn quads(count: usize, length: (f64, f64), width: (f64, f64), skew: f64, any_quarter: bool) -> Vec<Part> {
    let mut numbers = Numbers(7);
    let mut quad = || {
        let (length, width) = (numbers.between(length.0, length.1), numbers.between(width.0, width.1));
        let skew = skew.min(width / 3.0);
        let corners = [(0.0, 0.0), (length, 0.0), (length, width), (0.0, width)];
        let mut outline = corners
            .map(|(x, y)| DVec2::new(x + numbers.between(-skew, skew), y + numbers.between(-skew, skew)));
        outline[0].y = 0.0;
        outline[1].y = 0.0;
        Part { outline: outline.to_vec(), any_quarter }
    };
    (0..count).map(|_| quad()).collect()
}
