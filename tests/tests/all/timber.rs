//! compas_timber as referee of `model.btlx`: the same parts with the same bevels, where they lie in the building.
#![allow(clippy::disallowed_methods, reason = "the tests write what the referee reads")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fs;
use std::path::Path;

use glam::DVec3;
use ifs_compiler::analysis::{Analysis, Elements, PanelsMade, PlanksMade};
use ifs_compiler::fabricate::panel::{Panel, Side};
use ifs_compiler::fabricate::plank::Plank;
use ifs_compiler::outputs::{Format, Selection, outputs};
use ifs_tests::designs::{analysis_of, example_text, examples};
use ifs_tests::referees::{Verdict, python_referee};
use ifs_tests::scratch;
use serde_json::{Value, json};

/// Planes of the end cuts in space, each by a point and its unit normal away from the plank: from the solid alone.
fn end_planes(plank: &Plank) -> Value {
    let corners = &plank.solid.vertices;
    let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
    let plane = |[a, b, c]: [usize; 3]| {
        let normal = (corners[b] - corners[a]).cross(corners[c] - corners[a]).normalize();
        let outwards = if normal.dot(corners[a] - middle) < 0.0 { -normal } else { normal };
        json!([corners[a].to_array(), outwards.to_array()])
    };
    // Four corners below and four above: start right, end right, end left, start left.
    json!([plane([0, 3, 4]), plane([1, 2, 5])])
}

fn plank_part(plank: &Plank) -> Value {
    let along = (plank.axis[1] - plank.axis[0]).normalize();
    let left = plank.plane_normal.cross(along);
    // The blank is around all of the solid; its corner on the right of the start, on the upper face.
    let ahead: Vec<f64> =
        plank.solid.vertices.iter().map(|&corner| (corner - plank.axis[0]).dot(along)).collect();
    let first = ahead.iter().copied().fold(f64::INFINITY, f64::min);
    let length = ahead.iter().copied().fold(f64::NEG_INFINITY, f64::max) - first;
    let origin =
        plank.axis[0] + along * first - left * (plank.depth / 2.0) + plank.plane_normal * (plank.width / 2.0);
    json!({
        "address": plank.label.address, "alias": plank.label.alias,
        "size": [length, plank.depth, plank.width], "origin": origin.to_array(), "planes": end_planes(plank),
    })
}

/// The box is measured on the board laid flat by hand: corners of both faces, by the planes of the bevels.
fn panel_part(panel: &Panel, made: &PanelsMade) -> Value {
    let (inside, outside) = match made.settings.side {
        Side::Inner => (0.0, panel.thickness),
        Side::Centred => (-panel.thickness / 2.0, panel.thickness / 2.0),
        Side::Outer => (-panel.thickness, 0.0),
    };
    let [a, b, c, d] = panel.corners;
    let normal = (c - a).cross(d - b).normalize();
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for height in [inside, outside] {
        for corner in 0..4 {
            // Where the planes of the two bevels meet at this height, by Cramer's rule on x and y.
            let line = |side: usize| {
                let (p, q) = (panel.design_outline[side], panel.design_outline[(side + 1) % 4]);
                let out = -(q - p).normalize().perp();
                (out, out.dot(p) + height * panel.bevels[side].unwrap_or(0.0).tan())
            };
            let ((m, s), (n, t)) = (line((corner + 3) % 4), line(corner));
            let determinant = m.x * n.y - m.y * n.x;
            let at = DVec3::new((s * n.y - m.y * t) / determinant, (m.x * t - s * n.x) / determinant, height);
            (low, high) = (low.min(at), high.max(at));
        }
    }
    // Side AB as it lies in the outline and in space gives the x axis.
    let side = (panel.design_outline[1] - panel.design_outline[0]).normalize();
    let along = (b - a).reject_from_normalized(normal).normalize();
    let x = along * side.x - normal.cross(along) * side.y;
    let y = normal.cross(x);
    let middle = panel.design_outline.iter().sum::<glam::DVec2>() / 4.0;
    let origin = (a + b + c + d) / 4.0 + x * (low.x - middle.x) + y * (low.y - middle.y) + normal * outside;
    let bevels = panel.bevels.map(|bevel| bevel.unwrap_or(0.0).to_degrees());
    json!({
        "address": panel.label.address, "alias": panel.label.alias, "normal": normal.to_array(),
        "size": [high.x - low.x, high.y - low.y, panel.thickness], "origin": origin.to_array(), "bevels": bevels,
    })
}

fn parts(analysis: &Analysis) -> Vec<Value> {
    let mut parts = Vec::new();
    for made in &analysis.fabrications {
        match &made.elements {
            Elements::Panels(made) => {
                parts.extend(made.panels.iter().map(|panel: &Panel| panel_part(panel, made)));
            }
            Elements::Planks(PlanksMade { planks, .. }) => parts.extend(planks.iter().map(plank_part)),
        }
    }
    parts
}

fn judged(folder: &Path, expected: &[Value]) -> Verdict {
    let listing = folder.join("expected.json");
    fs::write(&listing, Value::from(expected).to_string()).unwrap();
    python_referee("btlx.py", &[folder, &listing])
}

#[test]
fn compas_timber_reads_the_parts_of_the_examples() {
    let folder = scratch("timber");
    let mut expected = Vec::new();
    for name in examples() {
        let analysis = analysis_of(&example_text(&name));
        let made = outputs(&analysis, &Selection::of(&[Format::Btlx]));
        let parts = parts(&analysis);
        if parts.is_empty() {
            assert!(made.files.iter().all(|file| file.path != "model.btlx"), "{name}: nothing is made of it");
            continue;
        }
        let file = format!("{name}.btlx");
        let mut bytes = Vec::new();
        made.files[0].write(&mut bytes).unwrap();
        fs::write(folder.join(&file), bytes).unwrap();
        expected.push(json!({ "file": file, "parts": parts }));
    }
    let verdict = judged(&folder, &expected);
    assert!(verdict.good, "{}", verdict.faults);
    assert!(verdict.counts["parts"].as_u64().unwrap() > 100, "{}", verdict.counts);

    // And a bevel that is off by a hundredth of a degree is missed.
    let board = |entry: &&mut Value| entry["parts"][0]["bevels"].is_array();
    let entry = expected.iter_mut().find(board).unwrap();
    let bevel = entry["parts"][0]["bevels"][1].as_f64().unwrap();
    entry["parts"][0]["bevels"][1] = json!(bevel + 0.01);
    let other = judged(&folder, std::slice::from_ref(entry));
    assert!(!other.good && other.faults.contains("inclinations"), "{}", other.faults);
}
