//! The foreign referees themselves: each takes what is right and refuses what is wrong, so that its word counts.
#![allow(clippy::disallowed_methods, reason = "the tests write what the referees read")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use ifs_cli::folder::{OutputFolder, Provenance, SourceRecord};
use ifs_tests::referees::{gltf_validator, python_referee};
use ifs_tests::scratch;
use serde_json::{Value, json};

/// The corners of a cube of one metre: bit 0 is x, bit 1 y, bit 2 z.
fn cube() -> Vec<[f32; 3]> {
    (0..8).map(|n| [0, 1, 2].map(|bit| if n >> bit & 1 == 1 { 1.0 } else { 0.0 })).collect()
}

/// Its twelve triangles, seen from outside counter-clockwise.
const FACES: [[u16; 3]; 12] = [
    [0, 2, 3],
    [0, 3, 1],
    [4, 5, 7],
    [4, 7, 6],
    [0, 1, 5],
    [0, 5, 4],
    [2, 6, 7],
    [2, 7, 3],
    [0, 4, 6],
    [0, 6, 2],
    [1, 3, 7],
    [1, 7, 5],
];

/// A GLB with one board of these triangles.
fn glb(path: &Path, faces: &[[u16; 3]]) -> PathBuf {
    let mut data: Vec<u8> = cube().iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    data.extend(faces.iter().flatten().flat_map(|n| n.to_le_bytes()));
    let (length, count) = (data.len(), faces.len() * 3);
    let document = json!({
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "vault.0.left", "mesh": 0, "extras": {"kind": "panel"}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
            {"bufferView": 1, "componentType": 5123, "count": count, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 96, "target": 34962},
            {"buffer": 0, "byteOffset": 96, "byteLength": count * 2, "target": 34963},
        ],
        "buffers": [{"byteLength": length}],
    });
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    data.resize(data.len().next_multiple_of(4), 0);
    let mut file = b"glTF".to_vec();
    let number = |n: usize| u32::try_from(n).unwrap().to_le_bytes();
    for (part, kind) in [(&text, b"JSON"), (&data, b"BIN\0")] {
        file.extend(number(part.len()));
        file.extend(kind);
        file.extend(part);
    }
    let total = number(file.len() + 8);
    file.splice(4..4, [2, 0, 0, 0].into_iter().chain(total));
    fs::write(path, file).unwrap();
    path.to_path_buf()
}

#[test]
fn the_gltf_validator_takes_a_cube_and_refuses_a_broken_one() {
    let folder = scratch("glb");
    let good = gltf_validator(&[&glb(&folder.join("cube.glb"), &FACES)]);
    assert!(good.good, "{}", good.faults);
    assert_eq!(good.counts["totalTriangleCount"], 12);
    let mut faces = FACES;
    faces[11][2] = 8;
    let bad = gltf_validator(&[&folder.join("cube.glb"), &glb(&folder.join("bad.glb"), &faces)]);
    assert!(!bad.good && bad.faults.contains("ACCESSOR_INDEX_OOB"), "{}", bad.faults);
}

#[test]
fn trimesh_takes_a_closed_board_and_refuses_an_open_or_turned_one() {
    let folder = scratch("trimesh");
    let good = python_referee("glb_trimesh.py", &[&glb(&folder.join("cube.glb"), &FACES)]);
    assert!(good.good, "{}", good.faults);
    assert_eq!((&good.counts["panel"], &good.counts["volume"]), (&json!(1), &json!(1.0)));
    let open = python_referee("glb_trimesh.py", &[&glb(&folder.join("open.glb"), &FACES[1..])]);
    assert!(!open.good && open.faults.contains("vault.0.left: not watertight"), "{}", open.faults);
    let inside_out = FACES.map(|[a, b, c]| [a, c, b]);
    let turned = python_referee("glb_trimesh.py", &[&glb(&folder.join("turned.glb"), &inside_out)]);
    assert!(!turned.good && turned.faults.contains("volume -1"), "{}", turned.faults);
    let more = ["--least", "2"].map(Path::new);
    let few = python_referee("glb_trimesh.py", &[&folder.join("cube.glb"), more[0], more[1]]);
    assert!(!few.good && few.faults.contains("1 solids, not 2"), "{}", few.faults);
}

/// One step of De Casteljau at `t`: the control points of both halves.
fn split(p: &[[f64; 2]; 4], t: f64) -> [[[f64; 2]; 4]; 2] {
    let lerp = |a: [f64; 2], b: [f64; 2]| [0, 1].map(|k| a[k] + t * (b[k] - a[k]));
    let (a, h, d) = (lerp(p[0], p[1]), lerp(p[1], p[2]), lerp(p[2], p[3]));
    let (b, c) = (lerp(a, h), lerp(h, d));
    let m = lerp(b, c);
    [[p[0], a, b, m], [m, c, d, p[3]]]
}

/// The control points of an arch, in millimetres.
const ARCH: [[f64; 2]; 4] = [[0.0, 0.0], [600.0, 3733.0], [5400.0, 3733.0], [6000.0, 0.0]];

/// The vertices of the arch split at `t`.
fn arch(t: f64, level: u32) -> Vec<[f64; 2]> {
    let mut pieces = vec![ARCH];
    for _ in 0..level {
        pieces = pieces.iter().flat_map(|piece| split(piece, t)).collect();
    }
    pieces.iter().map(|piece| piece[0]).chain(pieces.last().map(|piece| piece[3])).collect()
}

/// A uniform bicubic patch on `x = i, y = j, z = i²` and its own points: a B-spline of a square adds a third.
fn patch(level: u32) -> (Value, Vec<Vec<[f64; 3]>>) {
    let net =
        json!((0..5).map(|i| (0..4).map(|j| json!([i, j, i * i])).collect::<Vec<_>>()).collect::<Vec<_>>());
    let steps = 1 << level;
    let at = |n: u32| 1.0 + f64::from(n) / f64::from(steps);
    let row = |n: u32| (0..=steps).map(|m| [at(n), at(m), at(n) * at(n) + 1.0 / 3.0]).collect();
    (net, (0..=2 * steps).map(row).collect())
}

fn curves(folder: &Path, document: &Value) -> ifs_tests::referees::Verdict {
    let path = folder.join("points.json");
    fs::write(&path, document.to_string()).unwrap();
    python_referee("curves.py", &[&path])
}

#[test]
fn scipy_and_geomdl_take_our_points_and_refuse_others() {
    let folder = scratch("curves");
    let (net, grid) = patch(2);
    let arches = [0.46, 0.5].map(|t| {
        json!({
            "kind": "bezier", "degree": 3, "split": t, "level": 4, "points": ARCH, "vertices": arch(t, 4),
        })
    });
    let mut document = json!({
        "curves": arches,
        "surfaces": [{
            "kind": "bspline", "degree": 3, "split": null, "levels": [2, 2], "net": net, "vertices": grid,
        }],
    });
    let good = curves(&folder, &document);
    assert!(good.good, "{}", good.faults);
    assert_eq!((&good.counts["compared"], &good.counts["vertices"]), (&json!(3), &json!(17 + 17 + 9 * 5)));

    let x = document["curves"][0]["vertices"][7][0].as_f64().unwrap();
    document["curves"][0]["vertices"][7][0] = json!(x + 1e-8);
    let moved = curves(&folder, &document);
    assert!(
        !moved.good && moved.faults.contains("curve 0: ") && moved.faults.contains("from geomdl"),
        "{moved:?}"
    );
    document["curves"][0]["vertices"][7][0] = json!(x);
    document["curves"][0]["split"] = Value::Null;
    assert!(!curves(&folder, &document).good, "another split has other points");
    document["curves"] = json!([]);
    document["surfaces"][0]["vertices"][1][1][2] = json!(1.0);
    assert!(!curves(&folder, &document).good);
    document["surfaces"][0]["levels"] = json!([1, 2]);
    assert!(curves(&folder, &document).faults.contains("surface 0: vertices (9, 5, 3), scipy (5, 5, 3)"));
}

fn output_folder(test: &str, cutlist: &str) -> PathBuf {
    let target = scratch(test).join("vault");
    let mut staging = OutputFolder::stage(&target).unwrap();
    staging.write("cutlist.csv", "csv", None, cutlist.as_bytes()).unwrap();
    staging.write("report.json", "json", None, b"{}\n").unwrap();
    staging.write("boards/vault.0.left.nc", "nc", Some("vault.0.left"), b"%\n").unwrap();
    let sources = vec![SourceRecord::of("vault.ifs", b""), SourceRecord::of("std/curves.ifs", b"")];
    let parameters =
        BTreeMap::from([("span".to_owned(), "6m".to_owned()), ("rise".to_owned(), "2m".to_owned())]);
    staging.commit(&Provenance { sources, parameters, ..Provenance::default() }).unwrap();
    target
}

#[test]
fn an_output_folder_is_taken_and_a_changed_one_is_not() {
    let target = output_folder("outputs", "address,length\nvault.0.left,-12.5\n");
    let good = python_referee("outputs.py", &[&target]);
    assert!(good.good, "{}", good.faults);
    assert_eq!(good.counts["files"], 3);

    fs::write(target.join("notes.txt"), "mine").unwrap();
    let more = python_referee("outputs.py", &[&target]);
    assert!(!more.good && more.faults.contains("notes.txt: there and not listed"), "{}", more.faults);
    let foreign = ["--foreign", "notes.txt"].map(Path::new);
    assert!(python_referee("outputs.py", &[&target, foreign[0], foreign[1]]).good);

    fs::write(target.join("boards/vault.0.left.nc"), "$\n").unwrap();
    fs::remove_file(target.join("report.json")).unwrap();
    let changed = python_referee("outputs.py", &[&target, foreign[0], foreign[1]]);
    assert!(changed.faults.contains("boards/vault.0.left.nc: other bytes than listed"), "{}", changed.faults);
    assert!(changed.faults.contains("report.json: listed and not there"), "{}", changed.faults);
}

#[test]
fn faulty_tables_are_refused() {
    for (index, (cutlist, fault)) in [
        ("address,length\na\n", "row 2 has 1 cells, not 2"),
        ("address,address\na,b\n", "no header of distinct names"),
        ("address\n=1+1\n", "a formula to a spreadsheet"),
        ("address\n-x\n", "a formula to a spreadsheet"),
        ("address\r\na\r\n", "a carriage return"),
        ("address\na", "no line end"),
        ("address\n\"a\n", "cutlist.csv: "),
    ]
    .into_iter()
    .enumerate()
    {
        let verdict = python_referee("outputs.py", &[&output_folder(&format!("tables-{index}"), cutlist)]);
        assert!(!verdict.good && verdict.faults.contains(fault), "{cutlist:?}: {}", verdict.faults);
    }
}
