//! Maps of the plane and of space: textbook ifs against their numbers, and random products of maps against a second
//! opinion in doubles, written here, on what they do to the frame of an ifs and to a point.
#![allow(clippy::disallowed_methods, reason = "the second opinion has sines of its own")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail anywhere")]

use ifs_compiler::analysis::{Analysis, FigureGeometry, analyse};
use ifs_compiler::exact::Rational;
use ifs_compiler::hir::evaluate::{Evaluator, InstanceBody, Overrides};
use ifs_compiler::hir::value::{GermShape, Instance, Terms, Value};
use ifs_compiler::source::MemoryFiles;
use ifs_tests::designs::geometries;
use proptest::prelude::*;

fn analysed(text: &str) -> Analysis {
    let analysis = analyse(&MemoryFiles::single("a.ifs", text), "a.ifs", &Overrides::default());
    let found: Vec<String> = analysis.diagnostics.iter().map(|found| found.message.clone()).collect();
    assert!(found.is_empty(), "{text}\n{found:?}");
    analysis
}

/// An ifs without parameters, worked out.
fn body(analysis: &Analysis, name: &str) -> InstanceBody {
    let (ifs, _) = analysis.hir.own_items().find(|(_, item)| item.name == name).unwrap();
    let overrides = Overrides::default();
    Evaluator::new(&analysis.hir, &overrides).instantiate(&Instance { ifs, arguments: Vec::new() }).unwrap()
}

/// A named point or vector.
fn coordinates(analysis: &Analysis, name: &str) -> Vec<f64> {
    let (item, _) = analysis.hir.own_items().find(|(_, item)| item.name == name).unwrap();
    let overrides = Overrides::default();
    let value = Evaluator::new(&analysis.hir, &overrides).global(item).unwrap();
    let Value::Combination(value) = value else { panic!("{name} is no point") };
    let Terms::Coordinates(numbers) = &value.terms else { panic!("{name} has no coordinates") };
    numbers.iter().map(|number| number.to_f64().unwrap()).collect()
}

/// The images of the frame's points in coordinates: what stands behind the first weight. The weights sum to 1.
fn images(rows: &[Vec<Rational>]) -> Vec<Vec<f64>> {
    for row in rows {
        assert_eq!(row.iter().sum::<Rational>(), Rational::from(1));
    }
    rows.iter().map(|row| row[1..].iter().map(Rational::to_f64).collect()).collect()
}

fn fraction(n: i64, d: i64) -> Rational {
    Rational::new(n, d).unwrap()
}

const FERN: &str = "
ifs fern in plane {
    transform stem  = scale(0, 0.16) * self
    transform frond = translate(0m, 1.6m) * rotate(-2.66deg) * scale(0.85) * self
    transform left  = translate(0m, 1.6m) * affine(0.20, -0.26, 0.23, 0.22) * self
    transform right = translate(0m, 0.44m) * affine(-0.15, 0.28, 0.26, 0.24) * self
    germ segment((0m, 0m), (0m, 10m))
}";

#[test]
fn the_fern_has_the_matrices_of_the_book() {
    let fern = body(&analysed(FERN), "fern");
    assert_eq!(fern.points, ["origin", "x", "y"]);
    // Barnsley's table: a, b, c, d, e, f of x' = a x + b y + e, y' = c x + d y + f, e and f in metres.
    let book = [
        [0.0, 0.0, 0.0, 0.16, 0.0, 0.0],
        [0.849_084, 0.039_447, -0.039_447, 0.849_084, 0.0, 1.6],
        [0.20, -0.26, 0.23, 0.22, 0.0, 1.6],
        [-0.15, 0.28, 0.26, 0.24, 0.0, 0.44],
    ];
    for (transform, [a, b, c, d, e, f]) in fern.transforms.iter().zip(book) {
        let found = images(&transform.rows);
        let (e, f) = (e * 1000.0, f * 1000.0);
        let expected = [[e, f], [e + a, f + c], [e + b, f + d]];
        for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
            assert!((found - expected).abs() < 1e-6, "{}: {found} {expected}", transform.name);
        }
    }
    let [stem, _, left, _] = fern.transforms.as_slice() else { panic!("four transforms") };
    let origin = vec![fraction(1, 1), fraction(0, 1), fraction(0, 1)];
    assert_eq!(
        stem.rows,
        [origin.clone(), origin, vec![fraction(84, 100), fraction(0, 1), fraction(16, 100)]]
    );
    // Exactly as written: (1 - x - y, x, y) of the origin at (0, 1600).
    assert_eq!(left.rows[0], [fraction(-1599, 1), fraction(0, 1), fraction(1600, 1)]);
    assert_eq!(left.rows[1][1..], [fraction(1, 5), fraction(160_023, 100)]);
    assert_eq!(fern.germ.vertices[1], [fraction(-9999, 1), fraction(0, 1), fraction(10_000, 1)]);
    assert!(fern.rounded, "the cosine of 2.66 degrees is no fraction");
}

#[test]
fn right_angles_and_fractions_are_exact() {
    let text = "
        ifs plane in plane {
            transform a = translate(1m, 0m) * rotate(90deg) * scale(1/3) * self
            transform b = mirror(x) * self
            transform c = rotate(180deg, about: (1m, 1m)) * self
            germ segment((0m, 0m), (1m, 0m))
        }
        ifs space in space {
            transform a = turn(z, 90deg) * self
            transform b = turn((1m, 1m, 1m), 120deg, about: (1m, 0m, 0m)) * scale(1, 2, 3) * self
            transform c = mirror((1m, 1m, 0m)) * self
            germ segment((0m, 0m, 0m), (1m, 0m, 0m))
        }
        ifs root in plane { transform a = scale(sqrt(2)) * self  germ point((0m, 0m)) }";
    let analysis = analysed(text);
    let plane = body(&analysis, "plane");
    assert!(!plane.rounded && body(&analysis, "root").rounded);
    let third = 1.0 / 3.0;
    assert_eq!(images(&plane.transforms[0].rows), [[1000.0, 0.0], [1000.0, third], [1000.0 - third, 0.0]]);
    assert_eq!(images(&plane.transforms[1].rows), [[0.0, 0.0], [-1.0, 0.0], [0.0, 1.0]]);
    assert_eq!(images(&plane.transforms[2].rows), [[2000.0, 2000.0], [1999.0, 2000.0], [2000.0, 1999.0]]);
    let space = body(&analysis, "space");
    let turned = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    assert_eq!(images(&space.transforms[0].rows), turned);
    // A third of a turn about the diagonal takes x to y, y to z, z to x; about (1 m, 0, 0) the origin goes to (1, -1, 0).
    let diagonal =
        [[1000.0, -1000.0, 0.0], [1000.0, -999.0, 0.0], [1000.0, -1000.0, 2.0], [1003.0, -1000.0, 0.0]];
    for (found, expected) in images(&space.transforms[1].rows).iter().flatten().zip(diagonal.iter().flatten())
    {
        assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    }
    let mirrored = [[0.0, 0.0, 0.0], [0.0, -1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    assert_eq!(images(&space.transforms[2].rows), mirrored);
}

#[test]
fn a_family_has_a_letter_for_each_member() {
    let text = "
        ifs column(n: Int = 3) in space {
            keep strut((0m, 0m, 0m), (0m, 0m, 2m), width: 160mm)
            transform branch[i in 0..n] =
                translate(0m, 0m, 2m) * turn(z, i * 120deg) * turn(y, 35deg) * scale(0.6) * self
            transform twig[angle in [10deg, 20deg]] = turn(x, angle) * scale(0.1) * self
            germ quad((0m, 0m, 0m), (1m, 0m, 0m), (1m, 1m, 0m), (0m, 1m, 0m))
        }
        ifs three in space {
            transform only = column(n: 2)
            germ point((0m, 0m, 0m))
        }";
    let analysis = analysed(text);
    let three = body(&analysis, "three");
    let overrides = Overrides::default();
    let column = Evaluator::new(&analysis.hir, &overrides).instantiate(&three.transforms[0].target).unwrap();
    let letters: Vec<&str> = column.transforms.iter().map(|transform| transform.name.as_str()).collect();
    assert_eq!(letters, ["branch.0", "branch.1", "twig.0", "twig.1"]);
    // The second branch: up 2 m, leaning by 35 degrees, turned by 120 degrees, 0.6 times as long.
    let (lean, around) = (35_f64.to_radians(), 120_f64.to_radians());
    let top = &images(&column.transforms[1].rows)[3];
    let expected =
        [0.6 * lean.sin() * around.cos(), 0.6 * lean.sin() * around.sin(), 2000.0 + 0.6 * lean.cos()];
    for (found, expected) in top.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-12, "{top:?}");
    }
}

#[test]
fn a_bar_brings_its_section() {
    let text = "
        ifs flat in plane {
            transform a = scale(1/2) * self
            germ strut((0m, 0m), (3m, 4m), width: 100mm)
        }
        ifs tall in space {
            transform a = scale(1/2) * self
            germ strut((1m, 0m, 0m), (1m, 0m, 2m), width: 160mm)
            keep strut((0m, 0m, 0m), (0m, 3m, 4m), width: 10mm)
        }
        ifs free on (p, q) {
            transform a = self on (p, (p + q) / 2)
            germ strut(p, q, width: 16mm)
        }";
    let analysis = analysed(text);
    let flat = body(&analysis, "flat");
    assert_eq!(images(&flat.germ.vertices), [[0.0, 0.0], [3000.0, 4000.0], [-40.0, 30.0]]);
    assert!(matches!(&flat.germ.shape, GermShape::Strut { width } if width.to_f64() == Some(100.0)));
    let tall = body(&analysis, "tall");
    let upright = [[1000.0, 0.0, 0.0], [1000.0, 0.0, 2000.0], [1080.0, 0.0, 0.0], [1000.0, 80.0, 0.0]];
    assert_eq!(images(&tall.germ.vertices), upright);
    let leaning = [[0.0, 0.0, 0.0], [0.0, 3000.0, 4000.0], [-5.0, 0.0, 0.0], [0.0, -4.0, 3.0]];
    assert_eq!(images(&tall.keep[0].vertices), leaning);
    assert!(!flat.rounded && !tall.rounded);
    assert_eq!(body(&analysis, "free").germ.vertices.len(), 2);
}

#[test]
fn germs_an_ifs_finds_itself() {
    let rules = "
            transform a = self on ((p + q) / 2, (p + 6 * q + r) / 8, (q + r) / 2, (q + 6 * r + s) / 8)
            transform b = self on ((p + 6 * q + r) / 8, (q + r) / 2, (q + 6 * r + s) / 8, (r + s) / 2)";
    let text = format!(
        "ifs ends on (p, q, r, s) {{ let drawn = limit {rules} germ drawn }}
         ifs net(fine: Bool = false) on (p, q, r, s) {{ {rules} germ if fine then limit else control }}
         ifs coarse in plane {{
             transform a = scale(1/2) * self
             transform b = translate(1m, 0m) * rotate(90deg) * scale(1/2) * self
             germ limit
         }}
         figure one = ends on ((0m, 0m), (1m, 1m), (2m, 0m), (3m, 2m)) at level 3
         figure two = net on ((0m, 0m), (1m, 1m), (2m, 0m), (3m, 2m)) at level 3"
    );
    let analysis = analysed(&text);
    let sixths = |row: [i64; 4]| row.map(|weight| fraction(weight, 6)).to_vec();
    assert_eq!(body(&analysis, "ends").germ.vertices, [sixths([1, 4, 1, 0]), sixths([0, 1, 4, 1])]);
    // The point that stays: p = (1000, 0) + (-y, x) / 2.
    assert_eq!(images(&body(&analysis, "coarse").germ.vertices), [[0.0, 0.0], [800.0, 400.0]]);
    let names: Vec<usize> = geometries(&analysis)
        .iter()
        .map(|(_, geometry)| match geometry {
            FigureGeometry::Curve(points) => points.len(),
            FigureGeometry::Surface(_) | FigureGeometry::Pieces(_) => panic!("no curve"),
        })
        .collect();
    assert_eq!(names, [9, 9]);
}

#[test]
fn a_curve_in_the_plane_is_where_its_maps_put_it() {
    let text = "
        ifs levy in plane {
            transform left = affine(1/2, -1/2, 1/2, 1/2) * self
            transform right = translate(0.5m, 0.5m) * affine(1/2, 1/2, -1/2, 1/2) * self
            germ segment((0m, 0m), (1m, 0m))
        }
        figure here = levy at level 6
        figure there = translate(3m, -1m) * rotate(30deg) * scale(2) * levy at level 6
        figure twice = rotate(30deg) * (translate(3m, -1m) * levy at level 6)";
    let analysis = analysed(text);
    let mut expected = vec![[0.0, 0.0], [1000.0, 0.0]];
    for _ in 0..6 {
        let left = expected.iter().map(|[x, y]| [(x - y) / 2.0, (x + y) / 2.0]);
        let right = expected.iter().map(|[x, y]| [500.0 + (x + y) / 2.0, 500.0 + (y - x) / 2.0]);
        expected = left.chain(right.skip(1)).collect();
    }
    let (sine, cosine) = 30_f64.to_radians().sin_cos();
    let turn = |[x, y]: [f64; 2]| [cosine * x - sine * y, sine * x + cosine * y];
    for (name, geometry) in geometries(&analysis) {
        let FigureGeometry::Curve(points) = geometry else { panic!("{name} is no curve") };
        assert_eq!(points.len(), 65);
        for (point, [x, y]) in points.iter().zip(&expected) {
            let [x, y] = match name.as_str() {
                "here" => [*x, *y],
                "there" => {
                    let [x, y] = turn([2.0 * x, 2.0 * y]);
                    [x + 3000.0, y - 1000.0]
                }
                _ => turn([x + 3000.0, y - 1000.0]),
            };
            assert!((point.x - x).abs() < 1e-9 && (point.y - y).abs() < 1e-9 && point.z == 0.0, "{name}");
        }
    }
}

#[test]
fn plane_ifs_continue_with_ifs_on_control_points() {
    let text = "
        ifs arc on (p, q, r) {
            let m = (p + 2 * q + r) / 4
            transform left = self on (p, (p + q) / 2, m)
            transform right = self on (m, (q + r) / 2, r)
            germ segment(p, r)
        }
        ifs flag in plane {
            transform top = translate(0m, 1m) * scale(1/2) * self
            transform cloth = arc on ((0m, 0m), rotate(90deg) * (1m, 0m), (2m, 0m))
            germ segment((0m, 0m), (0m, 1m))
        }";
    let flag = body(&analysed(text), "flag");
    assert_eq!(images(&flag.transforms[1].rows), [[0.0, 0.0], [0.0, 1000.0], [2000.0, 0.0]]);
}

/// An affine map in doubles: three rows of four.
type Matrix = [[f64; 4]; 3];

fn linear(rows: [[f64; 3]; 3]) -> Matrix {
    rows.map(|[a, b, c]| [a, b, c, 0.0])
}

fn applied(map: &Matrix, [x, y, z]: [f64; 3]) -> [f64; 3] {
    map.map(|[a, b, c, d]| a * x + b * y + c * z + d)
}

fn about(map: Matrix, point: [f64; 3]) -> Matrix {
    let moved = applied(&map, point);
    let mut map = map;
    for ((row, still), moved) in map.iter_mut().zip(point).zip(moved) {
        row[3] += still - moved;
    }
    map
}

fn after(second: &Matrix, first: &Matrix) -> Matrix {
    let origin = applied(second, applied(first, [0.0; 3]));
    let mut out = [[0.0; 4]; 3];
    for (axis, unit) in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].into_iter().enumerate() {
        let image = applied(second, applied(first, unit));
        for (row, (image, origin)) in out.iter_mut().zip(image.into_iter().zip(origin)) {
            row[axis] = image - origin;
            row[3] = origin;
        }
    }
    out
}

/// A turn about an axis through the origin, by quaternions.
fn turned([x, y, z]: [f64; 3], degrees: f64) -> Matrix {
    let half = degrees.to_radians() / 2.0;
    let length = (x * x + y * y + z * z).sqrt();
    let w = half.cos();
    let [x, y, z] = [x, y, z].map(|part| part / length * half.sin());
    linear([
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)],
        [2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)],
        [2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)],
    ])
}

/// Householder's reflection.
fn mirrored(v: [f64; 3]) -> Matrix {
    let square: f64 = v.iter().map(|part| part * part).sum();
    let entry = |i: usize, j: usize| f64::from(u8::from(i == j)) - 2.0 * v[i] * v[j] / square;
    linear([0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j))))
}

fn place(point: [f64; 3], plane: bool) -> String {
    let [x, y, z] = point;
    if plane { format!("({x}mm, {y}mm)") } else { format!("({x}mm, {y}mm, {z}mm)") }
}

/// A map as it is written, and as it is.
type Written = (String, Matrix);

fn factor() -> impl Strategy<Value = f64> + Clone {
    (-150_i32..=150).prop_map(|value| f64::from(value) / 100.0)
}

fn leaf(plane: bool) -> BoxedStrategy<Written> {
    let length = (-2000_i32..=2000).prop_map(f64::from);
    let point = (length.clone(), length.clone(), length)
        .prop_map(move |(x, y, z)| if plane { [x, y, 0.0] } else { [x, y, z] });
    let direction = point.clone().prop_filter("some length", |point| point.iter().any(|part| *part != 0.0));
    let angle = (-3600_i32..=3600).prop_map(|value| f64::from(value) / 10.0);
    let around = prop_oneof![Just(None), point.clone().prop_map(Some)];
    let with = move |(text, map): Written, around: Option<[f64; 3]>| match around {
        Some(point) => (format!("{text}, about: {})", place(point, plane)), about(map, point)),
        None => (format!("{text})"), map),
    };
    let shift = point.prop_map(move |[x, y, z]| {
        let text = if plane {
            format!("translate({x}mm, {y}mm)")
        } else {
            format!("translate({x}mm, {y}mm, {z}mm)")
        };
        (text, [[1.0, 0.0, 0.0, x], [0.0, 1.0, 0.0, y], [0.0, 0.0, 1.0, z]])
    });
    let turn = (direction.clone(), angle, around.clone()).prop_map(move |(axis, angle, around)| {
        let (text, axis) = match plane {
            true => (format!("rotate({angle}deg"), [0.0, 0.0, 1.0]),
            false => (format!("turn({}, {angle}deg", place(axis, false)), axis),
        };
        with((text, turned(axis, angle)), around)
    });
    let uniform = (factor(), around.clone()).prop_map(move |(k, around)| {
        // In the plane the third coordinate is nobody's.
        let up = if plane { 1.0 } else { k };
        with((format!("scale({k}"), linear([[k, 0.0, 0.0], [0.0, k, 0.0], [0.0, 0.0, up]])), around)
    });
    let each = (factor(), factor(), factor(), around.clone()).prop_map(move |(a, b, c, around)| {
        let (text, c) =
            if plane { (format!("scale({a}, {b}"), 1.0) } else { (format!("scale({a}, {b}, {c}"), c) };
        with((text, linear([[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]])), around)
    });
    let mirror = (direction, around).prop_map(move |(along, around)| {
        with((format!("mirror({}", place(along, plane)), mirrored(along)), around)
    });
    let matrix = prop::array::uniform9(factor()).prop_map(move |[a, b, c, d, e, f, g, h, i]| match plane {
        true => (format!("affine({a}, {b}, {c}, {d})"), linear([[a, b, 0.0], [c, d, 0.0], [0.0, 0.0, 1.0]])),
        false => (
            format!("affine({a}, {b}, {c}, {d}, {e}, {f}, {g}, {h}, {i})"),
            linear([[a, b, c], [d, e, f], [g, h, i]]),
        ),
    });
    prop_oneof![shift, turn, uniform, each, mirror, matrix].boxed()
}

/// Products of maps with brackets anywhere.
fn product(plane: bool) -> impl Strategy<Value = Written> {
    leaf(plane).prop_recursive(3, 5, 2, |inner| {
        (inner.clone(), inner, any::<bool>()).prop_map(|((a, first), (b, second), bracket)| {
            let text = if bracket { format!("({a} * {b})") } else { format!("{a} * {b}") };
            (text, after(&first, &second))
        })
    })
}

fn agrees(plane: bool, (text, map): &Written) -> Result<(), TestCaseError> {
    let (space, start, end, point) = match plane {
        true => ("plane", "(0m, 0m)", "(1m, 0m)", [300.0, -700.0, 0.0]),
        false => ("space", "(0m, 0m, 0m)", "(1m, 0m, 0m)", [300.0, -700.0, 150.0]),
    };
    let design = format!(
        "ifs c in {space} {{\n    transform only = {text} * self\n    germ segment({start}, {end})\n}}
         let moved = {text} * {}",
        place(point, plane)
    );
    let analysis = analysed(&design);
    let count = if plane { 2 } else { 3 };
    let frame = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let found = images(&body(&analysis, "c").transforms[0].rows);
    prop_assert_eq!(found.len(), count + 1);
    let size = map.iter().flatten().fold(1.0_f64, |size, entry| size.max(entry.abs()));
    let close = |found: &[f64], expected: [f64; 3]| {
        found.len() == count
            && found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= 1e-8 * size.max(1000.0))
    };
    for (found, unit) in found.iter().zip(frame) {
        prop_assert!(close(found, applied(map, unit)), "{}\n{:?}\n{:?}", design, found, map);
    }
    let moved = coordinates(&analysis, "moved");
    prop_assert!(close(&moved, applied(map, point)), "{}\n{:?}\n{:?}", design, moved, map);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn products_of_maps_of_the_plane_are_as_in_doubles(written in product(true)) {
        agrees(true, &written)?;
    }

    #[test]
    fn products_of_maps_of_space_are_as_in_doubles(written in product(false)) {
        agrees(false, &written)?;
    }
}
