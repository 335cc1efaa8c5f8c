//! `cutlist.csv`, `assembly.csv` and `planarity.csv` against `report.json` and against themselves.

use std::collections::BTreeMap;

use glam::DVec3;
use serde_json::Value;

use super::Manifest;
use super::csv::{self, Table};
use super::finding::Findings;
use super::report::{Part, Report, list};

/// What the columns must begin with.
const COLUMNS: [(&str, &[&str]); 3] = [
    ("cutlist.csv", &["address", "alias", "figure", "material"]),
    ("assembly.csv", &["address", "alias", "figure"]),
    ("planarity.csv", &["address", "alias", "planarity_before", "planarity_after"]),
];

/// Checks one of the lists.
pub(super) fn check(
    path: &str,
    text: &str,
    report: Option<&Report>,
    manifest: &Manifest,
    findings: &mut Findings,
) {
    let table = csv::read(path, text, findings);
    let first = COLUMNS.iter().find(|(name, _)| *name == path).map_or(&[][..], |(_, columns)| columns);
    if !table.headers.iter().map(String::as_str).take(first.len()).eq(first.iter().copied()) {
        findings.add(path, "columns", first.join(","), table.headers.join(","));
        return;
    }
    let Some(report) = report else { return };
    let wanted: Vec<&Part> = match path {
        "cutlist.csv" => report.parts.iter().collect(),
        "planarity.csv" => report.parts.iter().filter(|part| !part.is_plank && part.is_made()).collect(),
        _ => report.parts.iter().filter(|part| part.is_made()).collect(),
    };
    let mut last = None;
    for row in &table.rows {
        let address = row[0].as_str();
        let Some(part) = report.part(address) else {
            findings.add(path, "address", "one of report.json", address);
            continue;
        };
        if path != "planarity.csv" {
            in_order(path, address, &mut last, report, findings);
        }
        for (header, cell) in table.headers.iter().zip(row) {
            compare(path, part, header, cell, findings);
        }
    }
    if !manifest.is_partial()
        && table.rows.len() != wanted.len()
        && !(path == "planarity.csv" && table.rows.len() > wanted.len())
    {
        findings.add(path, "rows", wanted.len(), table.rows.len());
    }
    if path == "assembly.csv" {
        assembly(path, &table, report, findings);
    }
    if path == "planarity.csv" {
        planarity(path, &table, findings);
    }
}

/// Rows stand in the order of the report.
fn in_order(path: &str, address: &str, last: &mut Option<usize>, report: &Report, findings: &mut Findings) {
    let place = report.by_address.get(address).copied();
    if last.is_some() && place <= *last {
        findings.add(path, "order of the rows", "that of report.json", address);
    }
    *last = place;
}

/// Compares a cell with what the report has under the name that its header leads to.
fn compare(path: &str, part: &Part, header: &str, cell: &str, findings: &mut Findings) {
    let Some(expected) = said(part, header) else { return };
    let what = || format!("{header} of {}", part.address);
    match expected {
        Value::Null if cell.is_empty() || (header == "bend_radius_mm" && cell == "flat") => {}
        Value::Null => findings.add(path, what(), "an empty cell", cell),
        Value::Number(number) => {
            let number = number.as_f64().unwrap_or(f64::NAN);
            findings.near(
                path,
                &what(),
                number,
                cell.parse().unwrap_or(f64::NAN),
                1e-9 * (1.0 + number.abs()),
            );
        }
        Value::String(text) => {
            findings.same(path, &what(), &text, cell.strip_prefix('\'').unwrap_or(cell));
        }
        _ => {}
    }
}

/// What the report says under a header; none where it has nothing of the kind.
fn said(part: &Part, header: &str) -> Option<Value> {
    let value = &part.value;
    if header == "files" {
        let files: Vec<&str> = list(value, "files").iter().filter_map(Value::as_str).collect();
        return Some(Value::String(files.join("; ")));
    }
    if let Some(own) = value.get(header) {
        return Some(own.clone());
    }
    match header {
        "planarity_after" => return value.get("planarity").cloned(),
        "fold_after_deg" => return value.get("fold_deg").cloned(),
        "area_after_m2" => return value.get("area_m2").cloned(),
        _ => {}
    }
    let ends = |field: &str, header: &str, before: &str| {
        let place = ["start", "end"].iter().position(|end| header == format!("{before}_{end}_deg"))?;
        Some(value.get(field)?.get(place).cloned().unwrap_or(Value::Null))
    };
    if let Some(found) =
        ends("mitres_deg", header, "mitre").or_else(|| ends("end_bevels_deg", header, "bevel"))
    {
        return Some(found);
    }
    for (field, before, after) in [
        ("edges_mm", "edge_", "_mm"),
        ("bevels_deg", "bevel_", "_deg"),
        ("relief_mm", "relief_", "_mm"),
        ("neighbours", "neighbour_", ""),
        ("neighbour_edges", "neighbour_edge_", ""),
    ] {
        let place = header.strip_prefix(before).and_then(|rest| rest.strip_suffix(after));
        let place = place.and_then(|place| place.parse::<usize>().ok());
        if let (Some(place), Some(Value::Array(all))) = (place, value.get(field)) {
            // Of planks the report has no neighbours' edges.
            let missing = (field != "neighbour_edges" || !part.is_plank).then_some(Value::Null);
            return all.get(place).cloned().or(missing);
        }
    }
    None
}

/// Frames are right-angled; an angle between two boards is the same from both.
fn assembly(path: &str, table: &Table, report: &Report, findings: &mut Findings) {
    let mut angles: BTreeMap<(&str, &str), Vec<&str>> = BTreeMap::new();
    for row in &table.rows {
        let Some(frame) = frame(table, row) else {
            findings.add(path, format!("frame of {}", row[0]), "nine numbers", "others");
            continue;
        };
        let [_, x, y] = frame;
        for (what, found, expected) in [
            ("length of the x axis", x.length(), 1.0),
            ("length of the y axis", y.length(), 1.0),
            ("angle of the axes", x.dot(y), 0.0),
        ] {
            findings.near(path, &format!("{what} of {}", row[0]), expected, found, 4e-9);
        }
        stands(path, &row[0], frame, report, findings);
        for place in 0..4 {
            let cell = |name: &str| {
                table.cell(row, &format!("{name}_{place}{}", if name == "angle" { "_deg" } else { "" }))
            };
            if let (Some(neighbour), Some(angle)) = (cell("neighbour"), cell("angle"))
                && !neighbour.is_empty()
            {
                let pair = if *row[0] < *neighbour {
                    (row[0].as_str(), neighbour)
                } else {
                    (neighbour, row[0].as_str())
                };
                angles.entry(pair).or_default().push(angle);
            }
        }
    }
    for ((one, other), mut found) in angles {
        found.sort_unstable();
        let twice = found.len() % 2 == 0 && found.chunks(2).all(|pair| pair[0] == pair[1]);
        if !twice && table.rows.len() == report.parts.len() {
            let what = format!("angle between {one} and {other}");
            findings.add(path, what, "the same from both", found.join(" and "));
        }
    }
}

/// Origin, x axis and y axis of a board.
pub(super) fn frame(table: &Table, row: &[String]) -> Option<[DVec3; 3]> {
    let vector = |names: [&str; 3]| {
        let number =
            |name: &str| table.cell(row, name)?.parse::<f64>().ok().filter(|value| value.is_finite());
        Some(DVec3::new(number(names[0])?, number(names[1])?, number(names[2])?))
    };
    Some([
        vector(["origin_x_mm", "origin_y_mm", "origin_z_mm"])?,
        vector(["x_axis_x", "x_axis_y", "x_axis_z"])?,
        vector(["y_axis_x", "y_axis_y", "y_axis_z"])?,
    ])
}

/// A board's middle is where its frame and outline put it, as far as a fold and bevels let them.
fn stands(path: &str, address: &str, [origin, x, y]: [DVec3; 3], report: &Report, findings: &mut Findings) {
    let Some(part) = report.part(address) else { return };
    let shape = if part.is_plank { &part.outline } else { &part.design_outline };
    let Some(centre) = (0..3).map(|axis| part.item("centre_mm", axis)).collect::<Option<Vec<f64>>>() else {
        return;
    };
    if shape.is_empty() {
        return;
    }
    let middle = shape.iter().fold(glam::DVec2::ZERO, |sum, at| sum + *at) / shape.len() as f64;
    let placed = origin + x * middle.x + y * middle.y;
    let off = placed - DVec3::new(centre[0], centre[1], centre[2]);
    let thickness = part.number("thickness_mm").unwrap_or(0.0);
    // The middle of a design's quad; the board's is beside it by thickness, bevels and a fold.
    let longest = shape.iter().map(|at| at.abs().max_element()).fold(0.0, f64::max);
    let room = 2.0 * thickness + 0.1 * longest + 5.0;
    for (what, found, tolerance) in
        [("along x", off.dot(x), room), ("along y", off.dot(y), room), ("across", off.dot(x.cross(y)), room)]
    {
        let what = format!("middle of {address} off centre_mm of report.json {what}, mm");
        findings.near(path, &what, 0.0, found, tolerance);
    }
}

/// Where a board did not move, it is as before.
fn planarity(path: &str, table: &Table, findings: &mut Findings) {
    for row in &table.rows {
        if table.cell(row, "moved_mm").and_then(|cell| cell.parse::<f64>().ok()) != Some(0.0) {
            continue;
        }
        for (before, after) in [
            ("planarity_before", "planarity_after"),
            ("fold_before_deg", "fold_after_deg"),
            ("diagonal_ratio_before", "diagonal_ratio_after"),
            ("area_before_m2", "area_after_m2"),
        ] {
            if let (Some(a), Some(b)) = (table.cell(row, before), table.cell(row, after)) {
                findings.same(path, &format!("{before} of {}, which did not move", row[0]), b, a);
            }
        }
    }
}
