//! Meshes as writers lay them out, files with faults, and files with any bytes wrong or missing.

use super::{Fault, FaultKind, MOST_TRIANGLES, TriangleMesh, read_glb};
use proptest::prelude::*;
use serde_json::{Value, json};

/// What trimesh wrote: three nodes, one of them mirrored.
const JOINT: &[u8] = include_bytes!("../../../tests/suite/meshes/joint.glb");

fn glb(document: &Value, data: &[u8]) -> Vec<u8> {
    let mut chunks = Vec::new();
    for (kind, content) in [(b"JSON", document.to_string().as_bytes()), (b"BIN\0", data)] {
        chunks.extend((content.len() as u32).to_le_bytes());
        chunks.extend(kind);
        chunks.extend(content);
    }
    let mut bytes = b"glTF".to_vec();
    bytes.extend(2_u32.to_le_bytes());
    bytes.extend((chunks.len() as u32 + 12).to_le_bytes());
    bytes.extend(chunks);
    bytes
}

/// A square of one metre, its corners 20 bytes apart, and 4 × 6 bytes of indices of each kind behind them.
fn square() -> (Value, Vec<u8>) {
    let mut data = Vec::new();
    for corner in [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]] {
        corner.iter().for_each(|coordinate| data.extend(coordinate.to_le_bytes()));
        data.extend([7; 8]);
    }
    let places = [0_u32, 1, 2, 0, 2, 3];
    places.iter().for_each(|place| data.push(*place as u8));
    places.iter().for_each(|place| data.extend((*place as u16).to_le_bytes()));
    places.iter().for_each(|place| data.extend(place.to_le_bytes()));
    let indices = |offset: usize, kind: u32| json!({"bufferView": 1, "byteOffset": offset, "componentType": kind, "count": 6, "type": "SCALAR"});
    let document = json!({
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
            indices(0, 5121),
            indices(6, 5123),
            indices(18, 5125),
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 80, "byteStride": 20},
            {"buffer": 0, "byteOffset": 80, "byteLength": 42},
        ],
        "buffers": [{"byteLength": data.len()}],
    });
    (document, data)
}

/// The square with something in its description changed.
fn changed(path: &str, value: Value) -> Result<TriangleMesh, Fault> {
    let (mut document, data) = square();
    match document.pointer_mut(path) {
        Some(place) => *place = value,
        None => {
            let (outer, name) = path.rsplit_once('/').unwrap();
            document.pointer_mut(outer).unwrap()[name] = value;
        }
    }
    read_glb(&glb(&document, &data))
}

fn fault(path: &str, value: Value) -> Fault {
    changed(path, value).unwrap_err()
}

const SQUARE: [[f64; 3]; 4] =
    [[0.0, 0.0, 0.0], [1000.0, 0.0, 0.0], [1000.0, 0.0, 1000.0], [0.0, 0.0, 1000.0]];

/// Six times the volume between a surface and the origin, and the sum of its normals times twice its area.
fn measures(mesh: &TriangleMesh) -> (f64, glam::DVec3) {
    let mut volume = 0.0;
    let mut normal = glam::DVec3::ZERO;
    for corners in &mesh.triangles {
        let [a, b, c] = corners.map(|corner| glam::DVec3::from_array(mesh.vertices[corner as usize]));
        volume += a.dot(b.cross(c));
        normal += (b - a).cross(c - a);
    }
    (volume, normal)
}

#[test]
fn indices_of_all_kinds_and_none() {
    for accessor in [1, 2, 3] {
        let mesh = changed("/meshes/0/primitives/0/indices", json!(accessor)).unwrap();
        assert_eq!(mesh.vertices, SQUARE, "metres, y upwards, are millimetres, z upwards");
        assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
    }
    // Three corners in order.
    let (mut document, data) = square();
    document["meshes"][0]["primitives"][0] = json!({"attributes": {"POSITION": 0}});
    document["accessors"][0]["count"] = json!(3);
    let mesh = read_glb(&glb(&document, &data)).unwrap();
    assert_eq!((mesh.vertices.len(), mesh.triangles.as_slice()), (3, &[[0, 1, 2]][..]));
}

#[test]
fn strips_and_fans_go_around_as_lists_do() {
    let (document, data) = square();
    let (_, normal) = measures(&read_glb(&glb(&document, &data)).unwrap());
    for (mode, order) in [(5, [0_u8, 1, 3, 2]), (6, [0, 1, 2, 3])] {
        let (mut document, mut data) = square();
        document["meshes"][0]["primitives"][0]["mode"] = json!(mode);
        document["accessors"][1]["count"] = json!(4);
        data[80..84].copy_from_slice(&order);
        let mesh = read_glb(&glb(&document, &data)).unwrap();
        assert_eq!((mesh.triangles.len(), measures(&mesh).1), (2, normal), "mode {mode}");
    }
    // Points and lines are passed over.
    for mode in 0..4 {
        let fault = fault("/meshes/0/primitives/0/mode", json!(mode));
        assert_eq!((fault.kind, fault.what.contains("no surface")), (FaultKind::Empty, true));
    }
}

#[test]
fn nodes_move_turn_scale_and_mirror() {
    let half = 0.5_f64.sqrt();
    let place =
        json!({"mesh": 0, "translation": [1, 2, 3], "rotation": [0, 0, half, half], "scale": [2, 2, 2]});
    let mesh = changed("/nodes/0", place).unwrap();
    // Turned by 90° about z of the file: its x is y, its y is -x.
    let expected = [[1.0, 2.0], [1.0, 4.0], [-1.0, 4.0], [-1.0, 2.0]];
    let expected = expected.map(|[x, y]| [x * 1000.0, -3000.0, y * 1000.0]);
    assert_eq!(mesh.vertices, expected);
    let matrix = [0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 1, 2, 3, 1];
    assert_eq!(changed("/nodes/0", json!({"mesh": 0, "matrix": matrix})).unwrap(), mesh);
    let nested = json!([{"children": [1], "translation": [1, 2, 3]}, {"children": [2], "scale": [2, 2, 2]},
        {"mesh": 0, "rotation": [0, 0, half, half]}]);
    assert_eq!(changed("/nodes", nested).unwrap(), mesh);
    // A mirrored square still shows the side it showed.
    let (_, normal) = measures(&changed("/nodes/0/scale", json!([-1, 1, 1])).unwrap());
    assert_eq!(normal.to_array(), [0.0, -2e6, 0.0]);
}

#[test]
fn a_file_without_a_scene_shows_all_of_it() {
    let (mut document, data) = square();
    document["scenes"] = json!([]);
    document.as_object_mut().unwrap().remove("scene");
    document["nodes"] = json!([{"mesh": 0}, {"children": [0], "translation": [5, 0, 0]}, {"mesh": 0}]);
    let mesh = read_glb(&glb(&document, &data)).unwrap();
    assert_eq!((mesh.vertices.len(), mesh.vertices[0]), (8, [5000.0, 0.0, 0.0]));
    document["nodes"] = json!([]);
    assert_eq!(read_glb(&glb(&document, &data)).unwrap().vertices, SQUARE);
}

#[test]
fn vertices_at_one_place_are_one() {
    let mesh = read_glb(JOINT).unwrap();
    // A box and two cylinders of twelve sides.
    assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (8 + 26 + 26, 12 + 48 + 48));
    let sides = |from: usize, to: usize| {
        mesh.triangles
            .iter()
            .filter(move |corners| corners.contains(&(from as u32)) && corners.contains(&(to as u32)))
    };
    for corners in &mesh.triangles {
        for at in 0..3 {
            let (from, to) = (corners[at] as usize, corners[(at + 1) % 3] as usize);
            assert_eq!(sides(from, to).count(), 2, "the solids are closed");
        }
    }
    let cylinder = 12.0 / 2.0 * (std::f64::consts::TAU / 12.0).sin() * 15.625_f64.powi(2) * 250.0;
    let volume = measures(&mesh).0 / 6.0;
    assert!((volume / (400.0 * 20.0 * 125.0 + 2.0 * cylinder) - 1.0).abs() < 1e-6, "{volume}");
    // A triangle of which two corners are at one place is none.
    let (document, mut data) = square();
    data[80..86].copy_from_slice(&[0, 1, 1, 0, 2, 3]);
    assert_eq!(read_glb(&glb(&document, &data)).unwrap().triangles.len(), 1);
    data[80..86].copy_from_slice(&[0, 1, 1, 2, 2, 3]);
    assert_eq!(read_glb(&glb(&document, &data)).unwrap_err().kind, FaultKind::Empty);
}

#[test]
fn what_is_not_read_is_named() {
    use FaultKind::{Malformed, TooLarge, Unsupported};
    let primitive = "/meshes/0/primitives/0";
    for (path, value, kind, place, word) in [
        (
            "/extensionsRequired",
            json!(["KHR_materials_unlit", "KHR_draco_mesh_compression"]),
            Unsupported,
            "extensionsRequired[1]",
            "draco",
        ),
        (
            "/extensionsRequired",
            json!(["EXT_meshopt_compression"]),
            Unsupported,
            "extensionsRequired[0]",
            "meshopt",
        ),
        ("/accessors/0/componentType", json!(5123), Unsupported, "accessors[0]", "whole numbers"),
        ("/accessors/0/sparse", json!({}), Unsupported, "accessors[0]", "sparse"),
        ("/buffers/0/uri", json!("joint.bin"), Unsupported, "buffers[0]", "not in the file"),
        ("/nodes/0/skin", json!(0), Unsupported, "nodes[0]", "skeleton"),
        ("/nodes/0/extensions", json!({"EXT_mesh_gpu_instancing": {}}), Unsupported, "nodes[0]", "repeats"),
        (
            "/meshes/0",
            json!({"primitives": [{"attributes": {"POSITION": 0}, "targets": [{}]}], "weights": [0.5]}),
            Unsupported,
            "nodes[0]",
            "shape keys",
        ),
        ("/nodes/0/mesh", json!(4), Malformed, "meshes[4]", "only number 0"),
        ("/nodes/0/mesh", json!(-1), Malformed, "byte", "cannot be read"),
        (
            "/nodes/0/matrix",
            json!([1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]),
            Malformed,
            "nodes[0]",
            "affine",
        ),
        ("/nodes/0/rotation", json!([0, 0, 0, 0]), Malformed, "nodes[0]", "quaternion"),
        ("/nodes/0/children", json!([0]), Malformed, "nodes[0]", "twice"),
        ("/nodes/0/children", json!([3]), Malformed, "nodes[3]", "only number 0"),
        ("/scene", json!(7), Malformed, "scenes[7]", "only number 0"),
        ("/accessors/0/count", json!(5), Malformed, "accessors[0]", "beyond the 80 bytes"),
        ("/accessors/0/count", json!(u64::MAX), Malformed, "accessors[0]", "beyond"),
        ("/accessors/0/byteOffset", json!(u64::MAX), Malformed, "accessors[0]", "beyond"),
        ("/accessors/0/type", json!("VEC2"), Malformed, "accessors[0]", "`VEC2`"),
        ("/accessors/0/count", json!(2), Malformed, "accessors[1]", "corner 2 is vertex 2"),
        ("/accessors/1/componentType", json!(5126), Malformed, "accessors[1]", "5126"),
        ("/accessors/1/count", json!(5), Malformed, "meshes[0].primitives[0]", "multiple of 3"),
        ("/accessors/1/bufferView", json!(2), Malformed, "bufferViews[2]", "numbered 0 to 1"),
        ("/bufferViews/1/byteLength", json!(43), Malformed, "bufferViews[1]", "which have 122"),
        ("/bufferViews/0/byteStride", json!(8), Malformed, "bufferViews[0]", "overlap"),
        (&format!("{primitive}/mode"), json!(7), Malformed, "meshes[0].primitives[0]", "mode 7"),
        (&format!("{primitive}/attributes"), json!({}), Malformed, "meshes[0].primitives[0]", "no positions"),
        ("/nodes/0/scale", json!([2e6, 1, 1]), Malformed, "accessors[0]", "1000 km"),
        ("/nodes/0/scale", json!([1e200, 1e200, 1e200]), Malformed, "accessors[0]", "1000 km"),
        ("/asset/extras", json!("x".repeat(3 << 20)), TooLarge, "byte 12", "MiB"),
    ] {
        let fault = fault(path, value);
        assert!(
            fault.kind == kind && fault.place.contains(place) && fault.what.contains(word),
            "{path}: {fault:?}"
        );
    }
    let (_, mut data) = square();
    data[4..8].copy_from_slice(&f32::NAN.to_le_bytes());
    let fault = read_glb(&glb(&square().0, &data)).unwrap_err();
    assert!(fault.what.contains("vertex 0 has a coordinate that is no finite number"), "{fault:?}");
}

#[test]
fn files_of_other_kinds_are_named() {
    for (bytes, word) in [
        (&b""[..], "empty"),
        (b"  {\"asset\": {}}", ".gltf"),
        (b"solid joint\nfacet", "STL"),
        (b"\x7fELF", "no binary glTF"),
        (b"glTF\x01\0\0\0", "glTF 1"),
        (b"glTF\x02\0\0\0\x0c\0\0\0", "cut off"),
    ] {
        let fault = read_glb(bytes).unwrap_err();
        assert!(fault.what.contains(word), "{fault:?}");
    }
}

#[test]
fn there_is_a_limit_to_triangles() {
    // A fan over the same data again and again.
    let (mut document, _) = square();
    let corners = MOST_TRIANGLES / 4;
    let data = vec![0; corners.max(80 + 42)];
    document["accessors"][1]["count"] = json!(corners);
    document["bufferViews"][1] = json!({"buffer": 0, "byteLength": corners});
    document["buffers"][0]["byteLength"] = json!(corners);
    let primitive = json!({"attributes": {"POSITION": 0}, "indices": 1, "mode": 6});
    document["meshes"][0]["primitives"] = json!(vec![primitive; 5]);
    let fault = read_glb(&glb(&document, &data)).unwrap_err();
    assert_eq!((fault.kind, fault.place.as_str()), (FaultKind::TooLarge, "meshes[0].primitives[4]"));
}

#[test]
fn a_file_cut_off_anywhere_has_a_fault() {
    for length in 0..JOINT.len() {
        assert!(read_glb(&JOINT[..length]).is_err(), "{length} bytes");
        // The header of a whole file that says so.
        let mut bytes = JOINT[..length].to_vec();
        if let Some(said) = bytes.get_mut(8..12) {
            said.copy_from_slice(&(length as u32).to_le_bytes());
        }
        assert!(read_glb(&bytes).is_err(), "{length} bytes as said");
    }
}

/// Whether a mesh holds to what is promised of it.
fn is_sound(mesh: &TriangleMesh) -> bool {
    let count = mesh.vertices.len();
    let places = mesh.vertices.iter().flatten().all(|coordinate| coordinate.abs() <= super::FARTHEST + 1.0);
    let whole = |[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
    places
        && mesh
            .triangles
            .iter()
            .all(|corners| whole(corners) && corners.iter().all(|corner| (*corner as usize) < count))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4096))]

    #[test]
    fn any_bytes_wrong_are_a_fault_or_another_mesh(
        wrong in prop::collection::vec((0..JOINT.len(), any::<u8>()), 1..6),
    ) {
        let mut bytes = JOINT.to_vec();
        for (at, byte) in wrong {
            bytes[at] = byte;
        }
        prop_assert!(read_glb(&bytes).is_ok_and(|mesh| is_sound(&mesh)) || read_glb(&bytes).is_err());
    }

    /// Numbers of the description exchanged for others: what is in bounds one by one need not be together.
    #[test]
    fn any_numbers_wrong_are_a_fault_or_another_mesh(
        wrong in prop::collection::vec((any::<prop::sample::Index>(), prop::sample::select(vec![
            "0", "1", "2", "3", "7", "255", "-1", "1e300", "4294967295", "18446744073709551615", "0.5", "null",
        ])), 1..4),
    ) {
        let length = u32::from_le_bytes([JOINT[12], JOINT[13], JOINT[14], JOINT[15]]) as usize;
        let mut text = String::from_utf8(JOINT[20..20 + length].to_vec()).unwrap();
        for (index, number) in wrong {
            let digits: Vec<usize> = text.match_indices(|c: char| c.is_ascii_digit()).map(|(at, _)| at).collect();
            let at = digits[index.index(digits.len())];
            text.replace_range(at..=at, number);
        }
        let outcome = match serde_json::from_str::<Value>(&text) {
            Ok(document) => read_glb(&glb(&document, &JOINT[28 + length..])),
            Err(_) => return Ok(()),
        };
        prop_assert!(outcome.is_err() || outcome.is_ok_and(|mesh| is_sound(&mesh)));
    }
}
