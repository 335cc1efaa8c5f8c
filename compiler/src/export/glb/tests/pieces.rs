//! Separate pieces in a model: what is drawn, where, and whose it is.

use std::sync::Arc;

use super::*;
use crate::exact::Rational;
use crate::ifs::{Automaton, Germ, GermShape, Matrix, State, StateId, Transform};
use crate::plan::evaluate::PiecesEvaluator;
use crate::plan::{Depth, Dimension, PiecesPlan};

fn unit(place: usize) -> Vec<Rational> {
    (0..3).map(|index| Rational::from(i64::from(index == place))).collect()
}

/// Three halves of a triangle towards its corners, which draws and keeps these.
fn triangle(germ: Germ, keep: Vec<Germ>, level: u32) -> PiecesEvaluator {
    let half = |corner: usize| Transform {
        name: format!("corner.{corner}"),
        target: StateId(0),
        matrix: Matrix::from_rows((0..3).map(|place| between(unit(corner), unit(place))).collect()).unwrap(),
    };
    let state = State { keep, ..State::new("t".to_owned(), 3, (0..3).map(half).collect(), germ) };
    let automaton = Automaton::try_new(vec![state]).unwrap();
    let points = vec![[0.0, 0.0, 0.0], [4000.0, 0.0, 0.0], [0.0, 0.0, 4000.0]];
    let plan =
        PiecesPlan { state: StateId(0), points, dimension: Dimension::Space, depth: Depth::Level(level) };
    PiecesEvaluator::new(&automaton, &plan)
}

fn between(a: Vec<Rational>, b: Vec<Rational>) -> Vec<Rational> {
    a.iter().zip(&b).map(|(a, b)| (a + b) / Rational::from(2)).collect()
}

fn germ(shape: GermShape, places: &[usize]) -> Germ {
    Germ { shape, vertices: places.iter().map(|place| unit(*place)).collect() }
}

fn model(evaluator: &PiecesEvaluator, labels: &[Label]) -> Vec<u8> {
    let pieces = vec![Pieces { address: "t", evaluator, labels }];
    let figure = Figure { name: "t", pieces, ..Figure::default() };
    let model = Model { design: "t", figures: vec![figure] };
    let bytes = glb(&model).unwrap();
    let mut written = Vec::new();
    write_glb(&model, &mut written).unwrap();
    assert_eq!(written, bytes);
    bytes
}

/// Mode, and how many vertices or indices, of each primitive; indices are within the positions.
fn primitives(bytes: &[u8]) -> Vec<(String, u64, bool)> {
    let (root, binary) = take_apart(bytes);
    let primitive = |primitive: &json::mesh::Primitive| {
        let positions = &root.accessors[primitive.attributes.values().next().unwrap().value()];
        let json::validation::Checked::Valid(mode) = primitive.mode else { panic!("mode") };
        let counted = primitive.indices.map(|indices| {
            let indices = &root.accessors[indices.value()];
            let view = &root.buffer_views[indices.buffer_view.unwrap().value()];
            let start = view.byte_offset.unwrap().0 as usize;
            for word in binary[start..].chunks_exact(4).take(indices.count.0 as usize) {
                assert!(u64::from(u32::from_le_bytes(word.try_into().unwrap())) < positions.count.0);
            }
            indices.count.0
        });
        (format!("{mode:?}"), counted.unwrap_or(positions.count.0), counted.is_some())
    };
    root.meshes.iter().flat_map(|mesh| &mesh.primitives).map(primitive).collect()
}

#[test]
fn each_kind_of_germ_is_drawn_in_its_way() {
    let of = |germ: Germ, keep: Vec<Germ>| primitives(&model(&triangle(germ, keep, 3), &[]));
    let drawn = |mode: &str, count: u64, indexed: bool| (mode.to_owned(), count, indexed);
    assert_eq!(of(germ(GermShape::Point, &[0]), vec![]), [drawn("Points", 27, false)]);
    assert_eq!(of(germ(GermShape::Segment, &[0, 1]), vec![]), [drawn("Lines", 54, false)]);
    let polygon = of(germ(GermShape::Polygon, &[0, 1, 2]), vec![]);
    assert_eq!(polygon, [drawn("Triangles", 81, true), drawn("Lines", 162, true)]);
    let mesh = GermShape::Mesh { faces: Arc::new(vec![vec![0, 1, 2]]) };
    assert_eq!(of(germ(mesh, &[0, 1, 2]), vec![]), polygon);
    let strut = germ(GermShape::Strut { width: Rational::from(16) }, &[0, 1]);
    let all = of(germ(GermShape::Point, &[0]), vec![strut, germ(GermShape::Segment, &[0, 2])]);
    // Thirteen words are kept at: twelve triangles and twelve lines a bar, one line a segment.
    let expected = [
        drawn("Triangles", 13 * 36, true),
        drawn("Lines", 13 * 24 + 13 * 2, true),
        drawn("Points", 27, true),
    ];
    assert_eq!(all, expected);
}

#[test]
fn positions_stand_in_the_order_of_words_and_the_table_says_whose_they_are() {
    let evaluator = triangle(germ(GermShape::Segment, &[0, 1]), vec![germ(GermShape::Point, &[2])], 1);
    let bytes = model(&evaluator, &labels("t", 4));
    let (root, binary) = take_apart(&bytes);
    let value = |word: &[u8]| f32::from_le_bytes(word.try_into().unwrap());
    let values: Vec<f32> = binary.chunks_exact(4).take(21).map(value).collect();
    let expected: [[f32; 3]; 7] = [
        [0.0, 4.0, 0.0],
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [4.0, 0.0, 0.0],
        [0.0, 2.0, 0.0],
        [2.0, 2.0, 0.0],
    ];
    assert_eq!(values, expected.as_flattened());
    assert_eq!(root.accessors[0].max, Some(serde_json::json!([4.0, 4.0, 0.0])));
    assert_eq!(node_names(&root), ["t", "t/pieces"]);
    let table: serde_json::Value =
        serde_json::from_str(root.nodes[1].extras.as_ref().unwrap().get()).unwrap();
    assert_eq!((&table["kind"], &table["elements"]), (&"pieces".into(), &4.into()));
    let last = serde_json::json!(
        {"kind": "segment", "address": "t.3", "alias": "t-3", "first_vertex": 5, "vertices": 2}
    );
    assert_eq!(table["parts"][3], last);
}
