//! The whole text of a small cut list.

use glam::DVec3;

use super::*;
use crate::fabricate::label::Label;
use crate::fabricate::material::Material;
use crate::fabricate::panel::{Edges, Grain, PanelSettings, Side, panels};
use crate::fabricate::plank::{Ends, PlankSettings, planks};
use crate::geometry::samples;

fn material(name: &str, thickness: Option<f64>) -> Material {
    Material { name: name.into(), thickness, density: Some(500e-9), least_bend_radius: None }
}

fn label(address: &str, alias: &str) -> Label {
    Label { address: address.into(), alias: alias.into(), ..Label::default() }
}

/// A flat board, a bent one beside it, two planks and a refused board.
fn parts() -> Vec<Part> {
    let mesh = samples::mesh(3, 2, |i, j| {
        DVec3::new(i * 300.0, j * 200.0, if (i, j) == (2.0, 1.0) { 10.0 } else { 0.0 })
    });
    let settings = PanelSettings {
        material: material("plywood", Some(12.0)),
        board: (2500.0, 1250.0),
        side: Side::Centred,
        grain: Grain::U,
        edges: Edges::Square,
    };
    let labels = [label("shell.l-l", "shell-0-0"), label("shell.r-l", "shell-1-0")];
    let boards = panels(&mesh, &mesh, &labels, &settings).unwrap().panels;
    let mut parts: Vec<Part> =
        boards.iter().map(|panel| Part::of_panel(panel, "shell", "plywood", Grain::U)).collect();
    parts[0].files = vec!["boards/shell.l-l.nc".into(), "boards/shell.l-l.dxf".into()];
    let settings = PlankSettings {
        material: material("=spruce", None),
        depth: 120.0,
        width: 27.0,
        ends: Ends::Mitred,
        gap: 0.0,
        stock: 4000.0,
        first: None,
        last: None,
    };
    let points = [DVec3::ZERO, DVec3::X * 400.0, DVec3::new(400.0, 0.0, 400.0)];
    let labels = [label("rib.l", "rib-0"), label("rib.r", "rib-1")];
    let ribs = planks(&points, &labels, &settings).unwrap().planks;
    parts.extend(ribs.iter().map(|plank| Part::of_plank(plank, "rib", "=spruce")));
    parts.push(Part::refused(
        &label("shell.x-x", "shell-2-0"),
        "shell",
        "plywood",
        "it has no area, or worse",
    ));
    parts
}

#[test]
fn the_whole_text() {
    assert_eq!(cut_list(&parts()), include_str!("golden.csv"));
}

#[test]
fn the_same_figures_in_json() {
    let json = serde_json::to_value(parts()).unwrap();
    assert_eq!(json[1]["bevels_deg"][0], serde_json::Value::Null);
    assert_eq!(json[0]["bend_radius_mm"], serde_json::Value::Null);
    assert_eq!(json[0]["edges_mm"], serde_json::json!([300.0, 200.0, 300.0, 200.0]));
    assert_eq!(json[1]["neighbours"], serde_json::json!([null, null, null, "shell.l-l"]));
    assert_eq!(json[2]["mitres_deg"], serde_json::json!([0.0, -45.0]));
    assert_eq!(json[4]["status"], "refused: it has no area, or worse");
}
