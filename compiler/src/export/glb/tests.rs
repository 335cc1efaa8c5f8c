//! Models read back: the container, the JSON part by gltf-json and its own checks, the positions.

mod pieces;

use glam::DVec3;
use gltf_json as json;
use json::validation::Validate;
use proptest::prelude::*;

use super::*;
use crate::fabricate::material::Material;
use crate::fabricate::panel::{Edges, Grain, Panel, PanelSettings, Side, panels};
use crate::fabricate::plank::{Ends, Plank, PlankSettings, planks};
use crate::geometry::samples;

fn labels(figure: &str, count: usize) -> Vec<Label> {
    (0..count)
        .map(|k| Label {
            address: format!("{figure}.{k}"),
            alias: format!("{figure}-{k}"),
            ..Label::default()
        })
        .collect()
}

fn material(thickness: Option<f64>) -> Material {
    Material { name: "m".into(), thickness, density: None, least_bend_radius: None }
}

fn shell(size: usize) -> QuadMesh {
    samples::mesh(size, size, |i, j| {
        DVec3::new(i * 250.0, j * 250.0, 300.0 * libm::sin(0.5 * i) * libm::sin(0.5 * j))
    })
}

fn boards(mesh: &QuadMesh) -> Vec<Panel> {
    let settings = PanelSettings {
        material: material(Some(12.0)),
        board: (2500.0, 1250.0),
        side: Side::Centred,
        grain: Grain::Free,
        edges: Edges::Square,
    };
    panels(mesh, mesh, &labels("shell", mesh.quads.len()), &settings).unwrap().panels
}

fn rib() -> (Vec<DVec3>, Vec<Plank>) {
    let points: Vec<DVec3> = (0..=8)
        .map(|k| std::f64::consts::PI * f64::from(k) / 8.0)
        .map(|angle| DVec3::new(-2000.0 * libm::cos(angle), 4000.0, 2000.0 * libm::sin(angle)))
        .collect();
    let settings = PlankSettings {
        material: material(None),
        depth: 120.0,
        width: 27.0,
        ends: Ends::Mitred,
        gap: 0.0,
        stock: 4000.0,
        first: None,
        last: None,
    };
    let made = planks(&points, &labels("rib", 8), &settings).unwrap();
    (points, made.planks)
}

/// A GLB taken apart, its lengths checked against each other.
fn take_apart(bytes: &[u8]) -> (json::Root, &[u8]) {
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!((&bytes[..4], word(4), word(8)), (b"glTF".as_slice(), 2, bytes.len()));
    assert_eq!(&bytes[16..20], b"JSON");
    let text = &bytes[20..20 + word(12)];
    assert_eq!(text.len() % 4, 0);
    let root = json::Root::from_slice(text).unwrap();
    let mut errors = Vec::new();
    root.validate(&root, json::Path::new, &mut |path, error| errors.push((path(), error)));
    assert!(errors.is_empty(), "{errors:?}");
    let rest = &bytes[20 + text.len()..];
    let Some(buffer) = root.buffers.first() else {
        assert!(rest.is_empty());
        return (root, rest);
    };
    let start = 20 + text.len();
    assert_eq!((word(start), &bytes[start + 4..start + 8]), (rest.len() - 8, b"BIN\0".as_slice()));
    assert_eq!(buffer.byte_length.0 as usize, rest.len() - 8);
    check_views(&root, rest.len() - 8);
    (root, &rest[8..])
}

/// Views follow each other without a gap, aligned, and accessors stay within them.
fn check_views(root: &json::Root, length: usize) {
    let mut at = 0;
    for view in &root.buffer_views {
        let offset = view.byte_offset.unwrap().0 as usize;
        assert_eq!((offset, offset % 4), (at, 0));
        at += view.byte_length.0 as usize;
    }
    assert_eq!(at, length);
    for accessor in &root.accessors {
        let json::validation::Checked::Valid(component) = accessor.component_type else {
            panic!("component")
        };
        let json::validation::Checked::Valid(kind) = accessor.type_ else { panic!("type") };
        let size = component.0.size() * kind.multiplicity();
        let view = &root.buffer_views[accessor.buffer_view.unwrap().value()];
        assert!(accessor.count.0 > 0);
        let end = accessor.byte_offset.unwrap().0 + accessor.count.0 * size as u64;
        assert!(end <= view.byte_length.0);
    }
}

fn node_names(root: &json::Root) -> Vec<&str> {
    root.nodes.iter().map(|node| node.name.as_deref().unwrap()).collect()
}

#[test]
fn boards_and_surfaces_have_their_nodes() {
    let mesh = shell(4);
    let panels = boards(&mesh);
    let surface = Surface {
        address: "shell",
        designed: &mesh,
        panelled: Some(Panelled { planarized: &mesh, required: 0.9998 }),
    };
    let figure = Figure {
        name: "shell",
        source: Some("shell.ifs:3"),
        surfaces: vec![surface],
        parts: panels.iter().map(Part::from).collect(),
        ..Figure::default()
    };
    let bytes = glb(&Model { design: "roof", figures: vec![figure] }).unwrap();
    let (root, _) = take_apart(&bytes);
    let names = node_names(&root);
    assert_eq!(names[..5], ["shell", "shell/planarized", "shell/designed", "shell/boards", "shell.0"]);
    assert_eq!(names.len(), 4 + 9);
    let extras = root.nodes[4].extras.as_ref().unwrap().get();
    assert_eq!(extras, r#"{"kind":"panel","address":"shell.0","alias":"shell-0"}"#);
    let shift = root.nodes[1].translation.unwrap()[0];
    assert!(shift > 0.75 && root.nodes[2].translation.unwrap()[0] == 2.0 * shift);
    assert!(root.nodes[3].translation.is_none() && root.nodes[4].translation.is_none());
}

#[test]
fn positions_are_metres_and_y_up() {
    let points = [DVec3::new(1000.0, 2000.0, 3000.0), DVec3::new(0.0, 0.0, 500.0)];
    let curve = Curve { address: "rib", points: &points };
    let figure = Figure { name: "rib", curves: vec![curve], ..Figure::default() };
    let bytes = glb(&Model { design: "", figures: vec![figure] }).unwrap();
    let (root, binary) = take_apart(&bytes);
    let values: Vec<f32> =
        binary.chunks_exact(4).map(|word| f32::from_le_bytes(word.try_into().unwrap())).collect();
    assert_eq!(values, [1.0, 3.0, -2.0, 0.0, 0.5, 0.0]);
    assert!(values[5].is_sign_positive());
    assert_eq!(root.accessors[0].min, Some(serde_json::json!([0.0, 0.5, -2.0])));
    assert_eq!(root.accessors[0].max, Some(serde_json::json!([1.0, 3.0, 0.0])));
}

#[test]
fn planks_share_the_indices_of_their_shape() {
    let (points, planks) = rib();
    let figure = Figure {
        name: "rib",
        curves: vec![Curve { address: "rib", points: &points }],
        parts: planks.iter().map(Part::from).collect(),
        ..Figure::default()
    };
    let bytes = glb(&Model { design: "rib", figures: vec![figure] }).unwrap();
    let (root, _) = take_apart(&bytes);
    assert_eq!(node_names(&root)[..4], ["rib", "rib/curve", "rib/boards", "rib.0"]);
    assert_eq!(root.buffer_views.len(), 3, "the curve, the corners of all planks, one list of indices");
}

#[test]
fn nothing_is_an_empty_model() {
    let empty = Figure { name: "empty", ..Figure::default() };
    let dot = Figure {
        name: "dot",
        curves: vec![Curve { address: "dot", points: &[DVec3::ZERO] }],
        ..Figure::default()
    };
    let bytes = glb(&Model { design: "none", figures: vec![empty, dot] }).unwrap();
    let (root, _) = take_apart(&bytes);
    assert!(root.nodes.is_empty() && root.scenes.is_empty() && root.buffers.is_empty());
}

#[test]
fn names_are_unique_and_quads_without_area_are_left_out() {
    let vertices = vec![DVec3::ZERO, DVec3::X * 100.0, DVec3::Y * 100.0, DVec3::ONE * 50.0];
    let mesh = QuadMesh::try_new(vertices, vec![[0, 1, 2, 2], [1, 1, 3, 3]]).unwrap();
    let surface = Surface { address: "pole", designed: &mesh, panelled: None };
    let figure = Figure { name: "pole", surfaces: vec![surface, surface], ..Figure::default() };
    let bytes = glb(&Model { design: "pole", figures: vec![figure] }).unwrap();
    let (root, _) = take_apart(&bytes);
    assert_eq!(node_names(&root), ["pole", "pole/surface", "pole/surface~2"]);
    let indices = root.meshes[0].primitives[0].indices.unwrap();
    assert_eq!(root.accessors[indices.value()].count.0, 3, "one triangle of three corners");
}

#[test]
fn many_boards_are_one_mesh_with_a_table() {
    let mesh = samples::flat_grid(151, 141, 300.0);
    let panels = boards(&mesh);
    assert!(panels.len() > MAX_PART_NODES);
    let figure =
        Figure { name: "floor", parts: panels.iter().map(Part::from).collect(), ..Figure::default() };
    let bytes = glb(&Model { design: "floor", figures: vec![figure] }).unwrap();
    let (root, _) = take_apart(&bytes);
    assert_eq!(node_names(&root), ["floor", "floor/boards"]);
    let table: serde_json::Value =
        serde_json::from_str(root.nodes[1].extras.as_ref().unwrap().get()).unwrap();
    assert_eq!(table["parts"].as_array().unwrap().len(), panels.len());
    let expected = serde_json::json!(
        {"kind": "panel", "address": "shell.2", "alias": "shell-2", "first_index": 72, "indices": 36}
    );
    assert_eq!(table["parts"][2], expected);
}

#[test]
fn what_floats_cannot_hold_is_refused() {
    let points = [DVec3::ZERO, DVec3::X * 1e300];
    let figure =
        Figure { name: "far", curves: vec![Curve { address: "far", points: &points }], ..Figure::default() };
    let model = Model { design: "far", figures: vec![figure] };
    assert!(matches!(glb(&model), Err(GlbError::OutOfRange)));
}

proptest! {
    #[test]
    fn every_model_is_well_formed(
        rows in 2usize..6,
        columns in 2usize..6,
        heights in proptest::collection::vec(-400.0f64..400.0, 36),
        required in 0.5f64..1.1,
    ) {
        let mesh = samples::mesh(rows, columns, |i, j| {
            DVec3::new(i * 250.0, j * 250.0, heights[(i * 6.0 + j) as usize])
        });
        let panels = boards(&mesh);
        let panelled = Some(Panelled { planarized: &mesh, required });
        let surfaces = vec![
            Surface { address: "a", designed: &mesh, panelled },
            Surface { address: "b", designed: &mesh, panelled: None },
        ];
        let figure = Figure { name: "a", surfaces, parts: panels.iter().map(Part::from).collect(), ..Figure::default() };
        let model = Model { design: "a", figures: vec![figure] };
        let bytes = glb(&model).unwrap();
        let (root, binary) = take_apart(&bytes);
        let mut written = Vec::new();
        write_glb(&model, &mut written).unwrap();
        prop_assert_eq!(&written, &bytes);
        for mesh in &root.meshes {
            for primitive in &mesh.primitives {
                let positions = &root.accessors[primitive.attributes.values().map(|index| index.value()).min().unwrap()];
                let indices = &root.accessors[primitive.indices.unwrap().value()];
                let start = root.buffer_views[indices.buffer_view.unwrap().value()].byte_offset.unwrap().0 as usize;
                for word in binary[start..].chunks_exact(4).take(indices.count.0 as usize) {
                    prop_assert!(u64::from(u32::from_le_bytes(word.try_into().unwrap())) < positions.count.0);
                }
            }
        }
    }
}
