//! A small report, read back.

use super::*;
use crate::fabricate::checks::{CheckResult, Limit, Measured, planarity::planarity};
use crate::fabricate::label::Label;
use crate::fabricate::material::Material;
use crate::fabricate::panel::{Edges, Grain, PanelSettings, Side, panels};
use crate::geometry::samples;
use glam::DVec3;

/// Two boards, the second twisted; the first moved by planarizing.
pub(in crate::export) fn report() -> Report {
    let mesh = samples::mesh(3, 2, |i, j| {
        DVec3::new(i * 300.0, j * 200.0, if (i, j) == (2.0, 1.0) { 20.0 } else { 0.0 })
    });
    let mut designed = mesh.clone();
    designed.vertices[0].z = 4.0;
    let material =
        Material { name: "plywood".into(), thickness: Some(12.0), density: None, least_bend_radius: None };
    let settings = PanelSettings {
        material,
        board: (2500.0, 1250.0),
        side: Side::Centred,
        grain: Grain::U,
        edges: Edges::Square,
    };
    let labels: Vec<Label> =
        (0..2).map(|k| Label { address: format!("shell.{k}"), ..Label::default() }).collect();
    let made = panels(&designed, &mesh, &labels, &settings).unwrap();
    let address = |quad: u32| labels[quad as usize].address.clone();
    let checked = planarity(&made.panels, Limit::AtLeast(0.9998));
    let mut report = Report::new("small");
    report.parameters.push(Parameter { name: "span".into(), value: "6m".into(), set: false });
    report.fabrications.push(Fabrication {
        figure: "shell".into(),
        kind: "panels",
        scale: Fixed::ratio(1.0),
        material: MaterialReport {
            name: "plywood".into(),
            thickness_mm: Some(Fixed::mm(12.0)),
            mass_kg: None,
            area_m2: Fixed::square_metres(120_000.0),
            length_mm: None,
            board_mm: Some([2500.0, 1250.0].map(Fixed::mm)),
            bar_mm: None,
            raw_at_least: 1,
        },
        machine: None,
        counts: Counts { elements: 2, made: made.panels.len(), refused: made.refused.len() },
        relief: None,
        planarity: Some(PlanarityReport {
            before: SurfaceSummary::of(&MeshSummary::of(&designed), address),
            after: SurfaceSummary::of(&MeshSummary::of(&mesh), address),
            folds_deg: None,
            planarize: None,
            moved: MovedReport::between(&designed, &mesh),
        }),
        requirements: vec![Requirement::of(
            "planarity >= 0.9998",
            "planarity",
            Quantity::Planarity,
            &[("at least", 0.9998)],
            &checked,
        )],
        parts: made.panels.iter().map(|panel| Part::of_panel(panel, "shell", "plywood", Grain::U)).collect(),
    });
    report
}

#[test]
fn reads_back_with_the_figures_it_was_given() {
    let report = report();
    let text = report.to_json().unwrap();
    assert!(text.ends_with("}\n") && text == self::report().to_json().unwrap());
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["schema_version"], 1);
    let made = &json["fabrications"][0];
    assert_eq!(made["counts"], serde_json::json!({"elements": 2, "made": 2, "refused": 0}));
    assert_eq!(made["planarity"]["after"]["worst_planarity"]["address"], "shell.1");
    assert_eq!(made["planarity"]["moved"]["max_mm"], 4.0);
    assert_eq!(made["planarity"]["moved"]["count"], 1);
    let requirement = &made["requirements"][0];
    assert_eq!((&requirement["holds"], &requirement["failing"]), (&false.into(), &1.into()));
    assert_eq!(requirement["worst"][0]["address"], "shell.1");
    assert_eq!(requirement["least"], made["planarity"]["after"]["worst_planarity"]["value"]);
    assert_eq!(requirement["limits"], serde_json::json!([{"words": "at least", "value": 0.9998}]));
    let counts = requirement["distribution"]["counts"].as_array().unwrap();
    assert_eq!((counts.len(), &counts[0], &counts[BINS - 1]), (BINS, &1.into(), &1.into()));
    assert_eq!(made["parts"].as_array().unwrap().len(), 2);
    assert!(!report.fabrications[0].holds());
}

#[test]
fn angles_are_written_in_degrees() {
    let mut result =
        CheckResult { failing: 0, total: 1, extremes: Some((0.5, 1.0)), ..CheckResult::default() };
    result.measured.push(Measured {
        address: "rib.l".into(),
        alias: "rib-0".into(),
        place: "end".into(),
        value: std::f64::consts::FRAC_PI_4,
    });
    let written = Requirement::of("mitre <= 45deg", "mitre", Quantity::Angle, &[("at most", 0.75)], &result);
    assert_eq!(serde_json::to_value(written.worst[0].value).unwrap(), 45.0);
    assert_eq!(serde_json::to_value(written.limits[0].value).unwrap(), 42.9718);
    assert_eq!((written.unit, written.holds), (Some("deg"), true));
}

#[test]
fn each_quantity_has_its_unit() {
    let result = CheckResult { total: 1, extremes: Some((0.5, 2_500_000.0)), ..CheckResult::default() };
    let written = |quantity| {
        let written = Requirement::of("…", "…", quantity, &[], &result);
        (written.unit, serde_json::to_string(&written.most).unwrap())
    };
    assert_eq!(written(Quantity::Length), (Some("mm"), "2500000.000".to_owned()));
    assert_eq!(written(Quantity::Area), (Some("m2"), "2.500000".to_owned()));
    assert_eq!(written(Quantity::Mass), (Some("kg"), "2500000.000".to_owned()));
    assert_eq!(written(Quantity::Ratio), (None, "2500000.000000".to_owned()));
    assert_eq!(written(Quantity::Count), (None, "2500000".to_owned()));
}
