//! Figures of separate pieces, and the plain recursion they are measured against.

use ifs_compiler::exact::Rational;
use ifs_compiler::ifs::{Automaton, Germ, Matrix, State, StateId, StateSpace, Transform};
use ifs_compiler::plan::{Depth, Dimension, PiecesPlan};

/// Barnsley's fern on an affine frame of the plane: four transforms, segments of 10 m. 262,144 leaves at level 9.
pub fn fern() -> (Automaton, Vec<[f64; 3]>) {
    let maps = [
        ("stem", [0, 0, 0, 160], [0, 0]),
        ("frond", [849, 39, -39, 849], [0, 1600]),
        ("left", [200, -260, 230, 220], [0, 1600]),
        ("right", [-150, 280, 260, 240], [0, 440]),
    ];
    let transforms = maps.map(|(name, linear, shift)| transform(name, 0, plane_map(linear, shift)));
    let germ = Germ::segment(row(1, &[1, 0, 0]), row(1, &[-9999, 0, 10000]));
    let state =
        State { space: StateSpace::Plane, ..State::new("fern".to_owned(), 3, transforms.to_vec(), germ) };
    let frame = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    (Automaton::try_new(vec![state]).expect("rows that sum to 1"), frame)
}

/// Two ifs that lead to each other, on three points in space, whose pieces do not meet. As many leaves at level 18.
pub fn pair() -> (Automaton, Vec<[f64; 3]>) {
    let state = |name: &str, own: u32, other: u32, rows: [[[i64; 3]; 3]; 2]| {
        let [left, right] = rows.map(|rows| rows.map(|entries| row(12, &entries)).to_vec());
        let transforms = vec![transform("left", own, left), transform("right", other, right)];
        State::new(name.to_owned(), 3, transforms, Germ::segment(row(1, &[1, 0, 0]), row(1, &[0, 0, 1])))
    };
    let smooth = [[[12, 0, 0], [6, 6, 0], [3, 5, 4]], [[3, 7, 2], [0, 6, 6], [0, 0, 12]]];
    let rough = [[[12, 0, 0], [4, 6, 2], [1, 10, 1]], [[2, 8, 2], [3, 3, 6], [0, 1, 11]]];
    let states = vec![state("smooth", 0, 1, smooth), state("rough", 1, 0, rough)];
    let points = vec![[0.0, 0.0, 0.0], [2000.0, 3000.0, 500.0], [4000.0, 0.0, 1000.0]];
    (Automaton::try_new(states).expect("rows that sum to 1"), points)
}

/// A figure of the first state at a level.
pub fn plan(points: &[[f64; 3]], level: u32) -> PiecesPlan {
    let depth = Depth::Level(level);
    PiecesPlan { state: StateId(0), points: points.to_vec(), dimension: Dimension::Space, depth }
}

/// Plain recursion over words (GEOMETRY 4, form 3) in doubles: every piece maps its control points, every leaf its
/// germ. Nothing is allocated on the way.
pub struct PlainRecursion {
    states: Vec<PlainState>,
}

/// A state on three points that draws segments.
struct PlainState {
    transforms: Vec<(usize, [[f64; 3]; 3])>,
    germ: [[f64; 3]; 2],
}

impl PlainRecursion {
    /// The automaton in doubles; its states stand on three points and draw segments.
    pub fn new(automaton: &Automaton) -> PlainRecursion {
        let state = |state: &State| {
            let transforms = state.transforms.iter();
            let germ: Vec<f64> = state.germ.vertices.iter().flatten().map(Rational::to_f64).collect();
            PlainState {
                transforms: transforms.map(|one| (one.target.index(), rows(&one.matrix.to_f64()))).collect(),
                germ: rows(&germ),
            }
        };
        PlainRecursion { states: automaton.states().iter().map(state).collect() }
    }

    /// Calls `found` with the ends of every leaf.
    pub fn run(&self, points: &[[f64; 3]], level: u32, found: &mut impl FnMut([[f64; 3]; 2])) {
        if let [a, b, c] = *points {
            self.below(0, &[a, b, c], level, found);
        }
    }

    fn below(&self, state: usize, points: &[[f64; 3]; 3], level: u32, found: &mut impl FnMut([[f64; 3]; 2])) {
        let PlainState { transforms, germ } = &self.states[state];
        if level == 0 {
            found(images(germ, points));
            return;
        }
        for (target, matrix) in transforms {
            self.below(*target, &images(matrix, points), level - 1, found);
        }
    }
}

fn rows<const N: usize>(entries: &[f64]) -> [[f64; 3]; N] {
    std::array::from_fn(|row| std::array::from_fn(|column| entries[3 * row + column]))
}

/// Sums written out: mapping over arrays is not always inlined, which would measure the calls.
#[inline(always)]
fn images<const N: usize>(rows: &[[f64; 3]; N], points: &[[f64; 3]; 3]) -> [[f64; 3]; N] {
    let [p, q, r] = points;
    let mut out = [[0.0; 3]; N];
    for (image, [a, b, c]) in out.iter_mut().zip(rows) {
        for (axis, value) in image.iter_mut().enumerate() {
            *value = a * p[axis] + b * q[axis] + c * r[axis];
        }
    }
    out
}

fn transform(name: &str, target: u32, rows: Vec<Vec<Rational>>) -> Transform {
    let matrix = Matrix::from_rows(rows).expect("rows of one length");
    Transform { name: name.to_owned(), target: StateId(target), matrix }
}

/// A linear part in thousandths and a shift in mm, on the frame's three points.
fn plane_map([a, b, c, d]: [i64; 4], [e, f]: [i64; 2]) -> Vec<Vec<Rational>> {
    let image = |x: i64, y: i64| {
        let (u, v) = (e * 1000 + a * x + b * y, f * 1000 + c * x + d * y);
        row(1000, &[1000 - u - v, u, v])
    };
    vec![image(0, 0), image(1, 0), image(0, 1)]
}

fn row(denominator: i64, entries: &[i64]) -> Vec<Rational> {
    let entry = |entry: &i64| Rational::new(*entry, denominator).expect("a denominator above 0");
    entries.iter().map(entry).collect()
}
