//! Figures of separate pieces from their text to the model, and the referee's word on it.
#![allow(clippy::disallowed_methods, reason = "the tests write what the referee reads")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fs;
use std::sync::Arc;

use ifs_compiler::exact::Rational;
use ifs_compiler::export::glb::{Figure, Model, Pieces, glb};
use ifs_compiler::ifs::{Automaton, Germ, GermShape, Matrix, State, StateId, Transform};
use ifs_compiler::plan::evaluate::PiecesEvaluator;
use ifs_compiler::plan::{Depth, Dimension, PiecesPlan};
use ifs_tests::outcome::run;
use ifs_tests::referees::gltf_validator;
use ifs_tests::{program, scratch};
use serde_json::json;

type Row = [i64; 4];

/// Weights on a frame of space of a point in mm.
fn at([x, y, z]: [i64; 3]) -> Vec<Rational> {
    [1 - x - y - z, x, y, z].into_iter().map(Rational::from).collect()
}

/// A map of space: the images of the origin and of the three axes' ends, over a denominator.
fn map(name: &str, denominator: i64, rows: [Row; 4]) -> Transform {
    let entry = |entry: i64| Rational::new(entry, denominator).unwrap();
    let rows = rows.map(|row| row.map(entry).to_vec()).to_vec();
    Transform { name: name.to_owned(), target: StateId(0), matrix: Matrix::from_rows(rows).unwrap() }
}

/// The map x ↦ A·x/1000 + (0, 0, 2000): A row by row.
fn branch(name: &str, a: [[i64; 3]; 3]) -> Transform {
    let row = |x: usize| {
        let image = [0, 1, 2]
            .map(|axis| if x == 0 { 0 } else { a[axis][x - 1] } + if axis == 2 { 2_000_000 } else { 0 });
        [1000 - image.iter().sum::<i64>(), image[0], image[1], image[2]]
    };
    map(name, 1000, [row(0), row(1), row(2), row(3)])
}

/// A column of LANGUAGE 4: branches in three by 0.6, each turned by 35° and a third of a full turn, and keeps its
/// trunk, a bar of 160 mm.
fn column(germ: Germ) -> Automaton {
    let (cos, sin) = (0.6 * 35_f64.to_radians().cos(), 0.6 * 35_f64.to_radians().sin());
    let branches = (0..3).map(|i| {
        let turn = f64::from(i) * std::f64::consts::TAU / 3.0;
        let (c, s) = (turn.cos(), turn.sin());
        let thousandths = |value: f64| (value * 1000.0).round() as i64;
        let rows = [[c * cos, -s * 0.6, c * sin], [s * cos, c * 0.6, s * sin], [-sin, 0.0, cos]];
        branch(&format!("branch.{i}"), rows.map(|row| row.map(thousandths)))
    });
    let width = GermShape::Strut { width: Rational::from(160) };
    let trunk = Germ {
        shape: width,
        vertices: vec![at([0, 0, 0]), at([0, 0, 2000]), at([80, 0, 0]), at([0, 80, 0])],
    };
    let state = State::new("column".to_owned(), 4, branches.collect(), germ);
    Automaton::try_new(vec![State { keep: vec![trunk], ..state }]).unwrap()
}

fn evaluator(automaton: &Automaton, level: u32) -> PiecesEvaluator {
    let points = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let (dimension, depth) = (Dimension::Space, Depth::Level(level));
    PiecesEvaluator::new(automaton, &PiecesPlan { state: StateId(0), points, dimension, depth })
}

/// A leaf of each kind at the tips.
fn leaves() -> [(&'static str, Germ); 4] {
    let corners = vec![at([-300, -300, 0]), at([300, -300, 0]), at([300, 300, 0]), at([-300, 300, 0])];
    let mut roof = corners.clone();
    roof.push(at([0, 0, 500]));
    let faces = Arc::new(vec![vec![0, 3, 2, 1], vec![0, 1, 4], vec![1, 2, 4], vec![2, 3, 4], vec![3, 0, 4]]);
    [
        ("points", Germ { shape: GermShape::Point, vertices: vec![at([0, 0, 0])] }),
        ("segments", Germ::segment(at([0, 0, 0]), at([0, 0, 2000]))),
        ("polygons", Germ { shape: GermShape::Polygon, vertices: corners }),
        ("meshes", Germ { shape: GermShape::Mesh { faces }, vertices: roof }),
    ]
}

#[test]
fn columns_with_leaves_of_all_kinds_pass_the_validator() {
    let folder = scratch("pieces");
    for (name, germ) in leaves() {
        let automaton = column(germ);
        let evaluator = evaluator(&automaton, 5);
        let pieces = vec![Pieces { address: "column", evaluator: &evaluator, labels: &[] }];
        let figures = vec![Figure { name: "column", pieces, ..Figure::default() }];
        let path = folder.join(format!("{name}.glb"));
        fs::write(&path, glb(&Model { design: name, figures }).unwrap()).unwrap();
        let verdict = gltf_validator(&[&path]);
        assert!(verdict.good, "{name}: {}", verdict.faults);
        let leaf = match name {
            "polygons" => 2,
            "meshes" => 6,
            _ => 0,
        };
        // 1 + 3 + 9 + 27 + 81 trunks of twelve triangles, and 243 leaves.
        assert_eq!(verdict.counts["totalTriangleCount"], 121 * 12 + 243 * leaf, "{name}");
    }
}

const TWIGS: &str = "//! Twigs that stop on their own, and a carpet of a fixed level.
ifs twigs on (a, b, c) {
    keep segment(a, b)
    transform left  = self on (b, lerp(b, c, 3/4), lerp(a, c, 3/4))
    transform right = self on (lerp(a, b, 1/2), lerp(b, c, 1/3), c)
    germ segment(a, b)
}
ifs triangle on (a, b, c) {
    transform first  = self on (a, lerp(a, b, 1/2), lerp(a, c, 1/2))
    transform second = self on (lerp(a, b, 1/2), b, lerp(b, c, 1/2))
    transform third  = self on (lerp(a, c, 1/2), lerp(b, c, 1/2), c)
    germ segment(a, b)
}
figure bush = twigs on ((0m, 0m, 0m), (0m, 0m, 1m), (1m, 1m, 2m)) each until size <= 20mm
figure lines = [triangle on ((i * 5m, 0m), (i * 5m + 4m, 0m), (i * 5m + 2m, 3m)) at level i + 3 for i in 0..3]
";

#[test]
fn a_design_of_separate_pieces_is_built_whole() {
    let folder = scratch("pieces_design");
    let path = folder.join("twigs.ifs");
    fs::write(&path, TWIGS).unwrap();
    run(program().arg("build").arg(&path).arg("-o").arg(folder.join("out"))).good();
    let model = folder.join("out/model.glb");
    let verdict = gltf_validator(&[&model]);
    assert!(verdict.good, "{}", verdict.faults);
    let report: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(folder.join("out/report.json")).unwrap()).unwrap();
    let figures = report["figures"].as_array().unwrap();
    assert_eq!(figures.len(), 4);
    assert_eq!(
        (&figures[0]["kind"], &figures[0]["level"]),
        (&json!("figure"), &json!("each until size <= 20mm"))
    );
    assert_eq!((&figures[3]["elements"], &figures[3]["level"]), (&json!(243), &json!("5")));
    assert_eq!(figures[3]["extent"]["low_mm"], json!([10000.0, 0.0, 0.0]));
    assert_eq!(figures[3]["extent"]["high_mm"], json!([14000.0, 3000.0 * 31.0 / 32.0, 0.0]));
    assert_eq!(figures[3]["extent"]["largest_mm"], json!(125.0));
}
