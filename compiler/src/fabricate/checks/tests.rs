//! Each requirement on boards and planks of known size.

use glam::DVec3;

use super::bend_radius::{BendLimit, bend_radius};
use super::{Limit, Tally, WORST_KEPT};
use crate::fabricate::label::Label;
use crate::fabricate::material::{LeastBendRadius, Material};
use crate::fabricate::panel::{Edges, Grain, Panel, PanelSettings, Side, panels};
use crate::fabricate::plank::{Ends, Plank, PlankSettings, planks};
use crate::geometry::samples;

const LEAST: LeastBendRadius = LeastBendRadius { across: 1829.0, along: 3658.0 };

fn material() -> Material {
    Material { name: "m".into(), thickness: Some(12.0), density: None, least_bend_radius: Some(LEAST) }
}

fn labels(count: usize) -> Vec<Label> {
    (0..count)
        .map(|k| Label { address: format!("a.{k}"), alias: format!("a-{k}"), ..Label::default() })
        .collect()
}

/// Three boards in a row, 300 by 200; the free end of the last is twisted by `twist` mm.
fn boards(grain: Grain, twist: f64) -> Vec<Panel> {
    let mesh = samples::mesh(4, 2, |i, j| {
        DVec3::new(i * 300.0, j * 200.0, if (i, j) == (3.0, 1.0) { twist } else { 0.0 })
    });
    let settings = PanelSettings {
        material: material(),
        board: (2500.0, 1250.0),
        side: Side::Centred,
        grain,
        edges: Edges::Square,
    };
    panels(&mesh, &mesh, &labels(3), &settings).unwrap().panels
}

/// Two planks of 500 and 700 that meet at 60 degrees.
fn knee() -> Vec<Plank> {
    let turn = DVec3::new(0.5, 0.0, 0.75f64.sqrt());
    let points = [DVec3::ZERO, DVec3::X * 500.0, DVec3::X * 500.0 + turn * 700.0];
    let settings = PlankSettings {
        material: material(),
        depth: 120.0,
        width: 27.0,
        ends: Ends::Mitred,
        gap: 0.0,
        stock: 4000.0,
        first: None,
        last: None,
    };
    planks(&points, &labels(2), &settings).unwrap().planks
}

#[test]
fn planarity_and_edges() {
    let found = super::planarity::planarity(&boards(Grain::U, 20.0), Limit::AtLeast(0.9998));
    assert_eq!((found.total, found.failing, found.holds()), (3, 1, false));
    assert_eq!((found.measured[0].address.as_str(), found.measured[0].alias.as_str()), ("a.2", "a-2"));
    assert_eq!(found.extremes.unwrap().1, 1.0);
    let found = super::edge::edge(&boards(Grain::U, 0.0), Limit::Within(250.0, 1200.0));
    assert_eq!((found.total, found.failing, found.extremes), (12, 6, Some((200.0, 300.0))));
    assert_eq!((found.measured[0].place.as_str(), found.measured[0].value), ("edge 1", 200.0));
    assert!(super::edge::edge(&boards(Grain::U, 0.0), Limit::Within(200.0, 300.0)).holds());
}

#[test]
fn lengths_and_mitres() {
    let found = super::length::length(&knee(), Limit::AtMost(600.0));
    assert_eq!((found.total, found.failing), (2, 1));
    assert!((found.measured[0].value - 700.0).abs() < 1e-9);
    let found = super::mitre::mitre(&knee(), Limit::AtMost(25f64.to_radians()));
    assert_eq!((found.total, found.failing), (2, 2), "the outer ends do not count");
    assert!((found.measured[0].value - 30f64.to_radians()).abs() < 1e-12);
    let places: Vec<&str> = found.measured.iter().map(|measured| measured.place.as_str()).collect();
    assert_eq!(places, ["end", "start"]);
}

#[test]
fn bends_against_the_grain() {
    let found = bend_radius(&boards(Grain::U, 0.0), BendLimit::Grain(LEAST));
    assert_eq!((found.total, found.failing, found.extremes), (3, 0, None), "flat boards always pass");
    let found = bend_radius(&boards(Grain::U, 40.0), BendLimit::Grain(LEAST));
    assert_eq!((found.total, found.failing), (3, 1));
    // The diagonal of 300 by 200 lies at 33.7 degrees to the grain of u and at 56.3 to that of v.
    assert!(found.measured[0].place.starts_with("bend axis at 33."), "{}", found.measured[0].place);
    for (grain, degrees) in [(Grain::U, 33.69), (Grain::V, 56.31)] {
        let angle = boards(grain, 40.0)[2].bend_axis_to_grain.unwrap().to_degrees();
        assert!((angle - degrees).abs() < 1.0, "{angle}");
    }
    let radius = found.measured[0].value;
    let free = bend_radius(&boards(Grain::Free, 40.0), BendLimit::Grain(LEAST));
    assert_eq!(free.measured[0].place, "grain free, needs 3658mm");
    let plain =
        |limit: f64| bend_radius(&boards(Grain::Free, 40.0), BendLimit::Radius(Limit::AtLeast(limit)));
    assert!(plain(radius - 1.0).holds() && !plain(radius + 1.0).holds());
}

#[test]
fn the_worst_come_first_and_few_are_kept() {
    let mut tally = Tally::default();
    for (step, label) in labels(100).iter().enumerate() {
        tally.judge(((step * 37) % 100) as f64, Limit::AtMost(89.5), label, String::new);
    }
    let values: Vec<f64> = tally.result.measured.iter().map(|measured| measured.value).collect();
    assert_eq!(values, (0..WORST_KEPT).map(|rank| 99.0 - rank as f64).collect::<Vec<f64>>());
    assert_eq!(
        (tally.result.failing, tally.result.total, tally.result.extremes),
        (10, 100, Some((0.0, 99.0)))
    );
}
