//! A reader of `model.glb` as far as it is held against the rest: its container, its arrays, its nodes; the solids of
//! boards, each by its address, its volume and where it stands.

use std::collections::{BTreeMap, BTreeSet};

use glam::{DVec2, DVec3};
use serde_json::Value;

use super::Set;
use super::csv;
use super::finding::Findings;
use super::lists::frame;
use super::report::{Part, Report, area, list};

const PATH: &str = "model.glb";

/// A file that was taken apart.
struct Model<'a> {
    json: Value,
    data: &'a [u8],
}

/// An array of numbers in rows.
struct Rows {
    width: usize,
    numbers: Vec<f64>,
}

pub(super) fn check(path: &str, bytes: &[u8], report: Option<&Report>, findings: &mut Findings) {
    let model = match open(bytes) {
        Ok(model) => model,
        Err(what) => return findings.add(path, "the container", "binary glTF 2.0", what),
    };
    let mut arrays = Vec::new();
    for (place, accessor) in list(&model.json, "accessors").iter().enumerate() {
        let rows = model.rows(accessor);
        if rows.is_none() {
            findings.add(path, format!("accessors[{place}]"), "numbers within the data", "others");
        }
        if let Some(rows) = &rows {
            bounds(path, place, accessor, rows, findings);
        }
        arrays.push(rows);
    }
    for (place, mesh) in list(&model.json, "meshes").iter().enumerate() {
        for primitive in list(mesh, "primitives") {
            indices(path, place, primitive, &arrays, findings);
        }
    }
    tree(path, &model, findings);
    let Some(report) = report else { return };
    solids(path, &model, &arrays, report, findings);
}

fn open(bytes: &[u8]) -> Result<Model<'_>, String> {
    let word = |at: usize| {
        let bytes = bytes.get(at..at.checked_add(4)?)?;
        Some(u32::from_le_bytes(bytes.try_into().ok()?) as usize)
    };
    if bytes.get(..4) != Some(b"glTF") || word(4) != Some(2) || word(8) != Some(bytes.len()) {
        return Err("another beginning or length".to_owned());
    }
    let length = word(12).ok_or("no first chunk")?;
    let end = length.checked_add(20).ok_or("a chunk that is too long")?;
    let json = bytes.get(20..end).ok_or("a first chunk that is cut off")?;
    if bytes.get(16..20) != Some(b"JSON") || bytes.get(end + 4..end + 8) != Some(b"BIN\0") {
        return Err("other chunks than JSON and BIN".to_owned());
    }
    let data = bytes.get(end + 8..).unwrap_or_default();
    if word(end) != Some(data.len()) {
        return Err("a second chunk of another length".to_owned());
    }
    let text = std::str::from_utf8(json).map_err(|error| error.to_string())?;
    let json: Value = serde_json::from_str(text).map_err(|error| error.to_string())?;
    if json.pointer("/asset/version").and_then(Value::as_str) != Some("2.0") {
        return Err("another version".to_owned());
    }
    Ok(Model { json, data })
}

fn whole(value: &Value, name: &str) -> Option<usize> {
    usize::try_from(value.get(name)?.as_u64()?).ok()
}

impl Model<'_> {
    /// The numbers of an accessor; none where they are not all in the data.
    fn rows(&self, accessor: &Value) -> Option<Rows> {
        let view = self.json.get("bufferViews")?.get(whole(accessor, "bufferView")?)?;
        let start = whole(view, "byteOffset").unwrap_or(0);
        let data = self.data.get(start..start.checked_add(whole(view, "byteLength")?)?)?;
        let width = match accessor.get("type")?.as_str()? {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "VEC4" => 4,
            _ => return None,
        };
        let size = match accessor.get("componentType")?.as_u64()? {
            5121 => 1,
            5123 => 2,
            5125 | 5126 => 4,
            _ => return None,
        };
        let is_float = accessor.get("componentType")?.as_u64()? == 5126;
        let count = whole(accessor, "count")?;
        let stride = whole(view, "byteStride").unwrap_or(width * size);
        let first = whole(accessor, "byteOffset").unwrap_or(0);
        let last =
            count.checked_sub(1)?.checked_mul(stride)?.checked_add(first)?.checked_add(width * size)?;
        if last > data.len() || stride < width * size {
            return None;
        }
        let number = |bytes: &[u8]| match *bytes {
            [a] => f64::from(a),
            [a, b] => f64::from(u16::from_le_bytes([a, b])),
            [a, b, c, d] if is_float => f64::from(f32::from_le_bytes([a, b, c, d])),
            [a, b, c, d] => f64::from(u32::from_le_bytes([a, b, c, d])),
            _ => f64::NAN,
        };
        let row = |at: usize| data[first + at * stride..][..width * size].chunks(size).map(number);
        let numbers: Vec<f64> = (0..count).flat_map(row).collect();
        numbers.iter().all(|number| number.is_finite()).then_some(Rows { width, numbers })
    }
}

/// Where an array says its bounds, they are its own.
fn bounds(path: &str, place: usize, accessor: &Value, rows: &Rows, findings: &mut Findings) {
    for (name, start, pick) in
        [("min", f64::INFINITY, f64::min as fn(f64, f64) -> f64), ("max", f64::NEG_INFINITY, f64::max)]
    {
        for (column, said) in list(accessor, name).iter().enumerate() {
            let found = rows.numbers.iter().skip(column).step_by(rows.width).copied().fold(start, pick);
            findings.near(
                path,
                &format!("{name} of accessors[{place}]"),
                found,
                said.as_f64().unwrap_or(f64::NAN),
                1e-9,
            );
        }
    }
}

/// Attributes have the same number of rows, and indices point into them.
fn indices(path: &str, mesh: usize, primitive: &Value, arrays: &[Option<Rows>], findings: &mut Findings) {
    let array = |value: Option<&Value>| arrays.get(usize::try_from(value?.as_u64()?).ok()?)?.as_ref();
    let count = |rows: &Rows| rows.numbers.len() / rows.width;
    let attributes = primitive.get("attributes").and_then(Value::as_object);
    let counts: BTreeSet<usize> = attributes
        .into_iter()
        .flat_map(|all| all.values())
        .filter_map(|v| array(Some(v)).map(count))
        .collect();
    if counts.len() != 1 {
        findings.add(path, format!("attributes of meshes[{mesh}]"), "one length", format!("{counts:?}"));
    }
    let vertices = counts.first().copied().unwrap_or(0) as f64;
    if let Some(rows) = array(primitive.get("indices")) {
        if rows.numbers.iter().any(|index| *index >= vertices) {
            findings.add(path, format!("indices of meshes[{mesh}]"), format!("below {vertices}"), "others");
        }
        let triangles = primitive.get("mode").is_none_or(|mode| mode.as_u64() == Some(4));
        let degenerate = |t: &[f64]| t.len() < 3 || t[0] == t[1] || t[1] == t[2] || t[0] == t[2];
        if triangles && rows.numbers.chunks(3).any(degenerate) {
            findings.add(path, format!("triangles of meshes[{mesh}]"), "three corners", "others");
        }
    }
    if let Some(colours) = array(primitive.pointer("/attributes/COLOR_0")) {
        let opaque =
            colours.width < 4 || colours.numbers.iter().skip(3).step_by(4).all(|alpha| *alpha == 65535.0);
        if !opaque {
            findings.add(path, format!("colours of meshes[{mesh}]"), "opaque ones", "others");
        }
    }
}

/// Each node but those of the scene is the child of one other.
fn tree(path: &str, model: &Model<'_>, findings: &mut Findings) {
    let nodes = list(&model.json, "nodes");
    let mut met: BTreeMap<u64, usize> = BTreeMap::new();
    let scenes = list(&model.json, "scenes").iter().flat_map(|scene| list(scene, "nodes"));
    for child in nodes.iter().flat_map(|node| list(node, "children")).chain(scenes).filter_map(Value::as_u64)
    {
        *met.entry(child).or_default() += 1;
    }
    if (0..nodes.len() as u64).any(|node| met.get(&node) != Some(&1)) || met.len() != nodes.len() {
        findings.add(path, "nodes", "one tree", "another");
    }
}

/// Places of the corners of a mesh in mm, z upwards, and its triangles.
fn surface(
    model: &Model<'_>,
    arrays: &[Option<Rows>],
    node: &Value,
) -> Option<(Vec<DVec3>, Vec<[usize; 3]>)> {
    let mesh = model.json.get("meshes")?.get(whole(node, "mesh")?)?;
    let primitive = list(mesh, "primitives").first()?;
    let place = usize::try_from(primitive.pointer("/attributes/POSITION")?.as_u64()?).ok()?;
    let positions = arrays.get(place)?.as_ref().filter(|rows| rows.width == 3)?;
    let rows = arrays.get(whole(primitive, "indices")?)?.as_ref()?;
    let moved: Vec<f64> = list(node, "translation").iter().filter_map(Value::as_f64).collect();
    let moved = if let [x, y, z] = moved[..] { DVec3::new(x, y, z) } else { DVec3::ZERO };
    let points = positions.numbers.chunks_exact(3).map(|p| {
        let p = DVec3::new(p[0], p[1], p[2]) + moved;
        DVec3::new(p.x, -p.z, p.y) * 1000.0
    });
    let triangle = |t: &[f64]| [t[0] as usize, t[1] as usize, t[2] as usize];
    let points: Vec<DVec3> = points.collect();
    let triangles: Vec<[usize; 3]> = rows.numbers.chunks_exact(3).map(triangle).collect();
    let inside = triangles.iter().flatten().all(|corner| *corner < points.len());
    inside.then_some((points, triangles))
}

fn solids(path: &str, model: &Model<'_>, arrays: &[Option<Rows>], report: &Report, findings: &mut Findings) {
    let mut met = BTreeSet::new();
    for node in list(&model.json, "nodes") {
        let extra = |name: &str| node.pointer(&format!("/extras/{name}")).and_then(Value::as_str);
        if !matches!(extra("kind"), Some("panel" | "plank")) {
            continue;
        }
        let address = extra("address").unwrap_or_default();
        let name = node.get("name").and_then(Value::as_str).unwrap_or_default();
        let Some(part) = report.part(address).filter(|_| met.insert(address.to_owned())) else {
            findings.add(path, "a solid", "one for each address of report.json", address);
            continue;
        };
        // A number follows where a figure has the name already.
        if name != address && !name.starts_with(&format!("{address}~")) {
            findings.add(path, "name of a solid", address, name);
        }
        findings.same(path, &format!("alias of {address}"), &part.alias, extra("alias").unwrap_or_default());
        match surface(model, arrays, node) {
            None => findings.add(path, format!("the solid {address}"), "triangles", "others"),
            Some((points, triangles)) => volume(path, part, &points, &triangles, findings),
        }
    }
    let made: Vec<&Part> = report.parts.iter().filter(|part| part.is_made()).collect();
    // Very many boards are one mesh with a table of addresses.
    if !met.is_empty() && met.len() != made.len() {
        findings.add(path, "solids", made.len(), met.len());
    }
}

/// The volume that triangles enclose (each with the origin a tetrahedron), against outline and thickness.
fn volume(path: &str, part: &Part, points: &[DVec3], triangles: &[[usize; 3]], findings: &mut Findings) {
    let Some(&origin) = points.first() else { return };
    let corner = |index: usize| points[index] - origin;
    let six: f64 = triangles.iter().map(|&[a, b, c]| corner(a).dot(corner(b).cross(corner(c)))).sum();
    let thickness = part.number("thickness_mm").unwrap_or(f64::NAN);
    let Some(flat) = flat_area(part) else { return };
    let expected = flat * thickness;
    findings.near(
        path,
        &format!("volume of {}, mm3", part.address),
        expected,
        six / 6.0,
        1.0 + 0.002 * expected.abs(),
    );
}

/// The middle section of a flat part, mm²; none of a bent one.
fn flat_area(part: &Part) -> Option<f64> {
    if part.is_plank {
        let straight =
            (0..2).all(|end| part.item("end_bevels_deg", end).is_none_or(|bevel| bevel.abs() < 1e-3));
        return straight.then(|| area(&part.outline));
    }
    if part.number("fold_deg").is_none_or(|fold| fold >= 0.01) {
        return None;
    }
    let outline = |name: &str| -> Vec<DVec2> {
        let number = |point: &Value, axis: usize| point.get(axis).and_then(Value::as_f64).unwrap_or(f64::NAN);
        list(&part.value, name).iter().map(|point| DVec2::new(number(point, 0), number(point, 1))).collect()
    };
    let (top, bottom) = (outline("top_outline_mm"), outline("bottom_outline_mm"));
    if top.len() != bottom.len() || top.len() < 3 {
        return None;
    }
    let middle: Vec<DVec2> = top.iter().zip(&bottom).map(|(a, b)| (*a + *b) / 2.0).collect();
    Some((area(&top) + 4.0 * area(&middle) + area(&bottom)) / 6.0)
}

/// Solids stand where the frames of `assembly.csv` put their boards: every corner lies over a corner of an outline.
pub(super) fn with_frames(set: &Set<'_>, report: &Report, findings: &mut Findings) {
    let (Some(bytes), Some(rows)) = (set.bytes(PATH), set.bytes("assembly.csv")) else { return };
    let (Ok(model), Ok(text)) = (open(&bytes), std::str::from_utf8(&rows)) else { return };
    let table = csv::read("assembly.csv", text, &mut Findings::default());
    let frames: BTreeMap<&str, [DVec3; 3]> =
        table.rows.iter().filter_map(|row| Some((row.first()?.as_str(), frame(&table, row)?))).collect();
    let arrays: Vec<Option<Rows>> =
        list(&model.json, "accessors").iter().map(|accessor| model.rows(accessor)).collect();
    for node in list(&model.json, "nodes") {
        let extra = |name: &str| node.pointer(&format!("/extras/{name}")).and_then(Value::as_str);
        let Some(part) = extra("address").and_then(|address| report.part(address)) else { continue };
        let solid = matches!(extra("kind"), Some("panel" | "plank"));
        let (true, Some(_), Some(frame)) = (solid, flat_area(part), frames.get(part.address.as_str())) else {
            continue;
        };
        if let Some((points, _)) = surface(&model, &arrays, node) {
            over(part, &points, frame, findings);
        }
    }
}

fn over(part: &Part, points: &[DVec3], [origin, x, y]: &[DVec3; 3], findings: &mut Findings) {
    let pairs = |name: &str| -> Vec<DVec2> {
        let number = |point: &Value, axis: usize| point.get(axis).and_then(Value::as_f64).unwrap_or(f64::NAN);
        list(&part.value, name).iter().map(|point| DVec2::new(number(point, 0), number(point, 1))).collect()
    };
    let mut corners = part.outline.clone();
    corners.extend(pairs("top_outline_mm"));
    corners.extend(pairs("bottom_outline_mm"));
    let thickness = part.number("thickness_mm").unwrap_or(f64::NAN);
    // Bevelled sides put the corners of the faces beside those of the outlines.
    if !part.is_plank && part.text("edge_cut") != "square" {
        return;
    }
    for point in points {
        let off = *point - *origin;
        let flat = DVec2::new(off.dot(*x), off.dot(*y));
        let nearest = corners.iter().map(|corner| corner.distance(flat)).fold(f64::INFINITY, f64::min);
        let what = format!("a corner of {} off the frame of assembly.csv, mm", part.address);
        findings.near(PATH, &what, 0.0, nearest, 0.05);
        let height = off.dot(x.cross(*y)).abs();
        if height.partial_cmp(&(thickness + 0.05)).is_none_or(std::cmp::Ordering::is_gt) {
            findings.add(PATH, what, format!("within {thickness}"), height);
        }
    }
}
