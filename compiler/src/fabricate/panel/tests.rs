//! Boards keep the lengths of their quads, lie as the grain says, and are closed solids of the right volume.

use std::f64::consts::FRAC_PI_4;

use proptest::prelude::*;

use super::*;
use crate::fabricate::material::LeastBendRadius;
use crate::geometry::{QuadMesh, samples};

fn plywood(thickness: f64) -> Material {
    Material {
        name: "birch_plywood".into(),
        thickness: Some(thickness),
        density: Some(650e-9),
        least_bend_radius: Some(LeastBendRadius { across: 1829.0, along: 3658.0 }),
    }
}

fn settings(grain: Grain) -> PanelSettings {
    PanelSettings {
        material: plywood(12.0),
        board: (2500.0, 1250.0),
        side: Side::Centred,
        grain,
        edges: Edges::Square,
    }
}

fn labels(count: usize) -> Vec<Label> {
    (0..count)
        .map(|k| Label { address: format!("shell.{k}"), alias: format!("s-{k}"), ..Label::default() })
        .collect()
}

fn make(mesh: &QuadMesh, settings: &PanelSettings) -> Panels {
    panels(mesh, mesh, &labels(mesh.quads.len()), settings).unwrap()
}

fn single(corners: [(f64, f64, f64); 4]) -> QuadMesh {
    let vertices = corners.map(|(x, y, z)| DVec3::new(x, y, z)).to_vec();
    QuadMesh::try_new(vertices, vec![[0, 1, 2, 3]]).unwrap()
}

fn reason(corners: [(f64, f64, f64); 4], settings: &PanelSettings) -> PanelRefusal {
    let made = make(&single(corners), settings);
    assert!(made.panels.is_empty());
    made.refused[0].reason
}

#[test]
fn a_flat_rectangle_in_each_grain() {
    let mesh = single([(0.0, 0.0, 0.0), (400.0, 0.0, 0.0), (400.0, 250.0, 0.0), (0.0, 250.0, 0.0)]);
    for (grain, size) in
        [(Grain::U, (400.0, 250.0)), (Grain::V, (250.0, 400.0)), (Grain::Free, (400.0, 250.0))]
    {
        let made = make(&mesh, &settings(grain));
        let panel = &made.panels[0];
        assert!((panel.size() - DVec2::from(size)).length() < 1e-9);
        assert!(panel.outline.iter().all(|corner| corner.min_element() >= 0.0));
        assert_eq!((panel.edges, panel.bevels), ([400.0, 250.0, 400.0, 250.0], [None; 4]));
        assert_eq!((panel.bend_radius, panel.fold, panel.planarity, panel.moved), (None, 0.0, 1.0, 0.0));
        assert!((panel.mass.unwrap() - 400.0 * 250.0 * 12.0 * 650e-9).abs() < 1e-12);
        assert!((panel.solid.volume() - panel.area * 12.0).abs() < 1e-6);
    }
}

#[test]
fn neighbours_bevels_and_how_far_corners_moved() {
    // A ridge of a right angle along the side between the two quads.
    let ridge = |i: f64, j: f64| DVec3::new(i * 100.0, j * 100.0, if i == 1.0 { 100.0 } else { 0.0 });
    let mesh = samples::mesh(3, 2, ridge);
    let mut designed = mesh.clone();
    designed.vertices[0].z += 3.0;
    let made = panels(&designed, &mesh, &labels(2), &settings(Grain::U)).unwrap();
    let [first, second] = made.panels.as_slice() else { panic!("two boards") };
    assert_eq!(first.neighbours, [None, Some("shell.1".to_owned()), None, None]);
    assert_eq!(second.neighbours[3].as_deref(), Some("shell.0"));
    assert!((first.bevels[1].unwrap() - FRAC_PI_4).abs() < 1e-12);
    assert_eq!(first.bevels[1], second.bevels[3]);
    assert_eq!((first.moved, second.moved), (3.0, 0.0));
}

#[test]
fn the_surface_lies_where_the_side_says() {
    let mesh = samples::flat_grid(2, 2, 100.0);
    for (side, low, high) in [(Side::Inner, 0.0, 12.0), (Side::Centred, -6.0, 6.0), (Side::Outer, -12.0, 0.0)]
    {
        let made = make(&mesh, &PanelSettings { side, ..settings(Grain::Free) });
        let heights = || made.panels[0].solid.vertices.iter().map(|vertex| vertex.z);
        assert_eq!((heights().fold(99.0, f64::min), heights().fold(-99.0, f64::max)), (low, high));
    }
}

#[test]
fn bend_and_its_angle_to_the_grain() {
    // Folded over the diagonal AC, which runs at 45 degrees to both sides.
    let mesh = single([(0.0, 0.0, 0.0), (200.0, 0.0, 0.0), (200.0, 200.0, 0.0), (0.0, 200.0, 5.0)]);
    for grain in [Grain::U, Grain::V] {
        let panel = &make(&mesh, &settings(grain)).panels[0];
        assert!(panel.bend_radius.unwrap() > 1000.0);
        assert!((panel.bend_axis_to_grain.unwrap() - FRAC_PI_4).abs() < 1e-2);
    }
    assert_eq!(make(&mesh, &settings(Grain::Free)).panels[0].bend_axis_to_grain, None);
}

#[test]
fn what_cannot_be_a_board() {
    let any = settings(Grain::Free);
    let dart = [(0.0, 0.0, 0.0), (100.0, 0.0, 0.0), (20.0, 20.0, 0.0), (0.0, 100.0, 0.0)];
    assert_eq!(reason(dart, &any), PanelRefusal::Dart);
    let bow = [(0.0, 0.0, 0.0), (100.0, 0.0, 0.0), (0.0, 100.0, 0.0), (100.0, 100.0, 0.0)];
    assert_eq!(reason(bow, &any), PanelRefusal::FoldedOver);
    let line = [(0.0, 0.0, 0.0), (100.0, 0.0, 0.0), (200.0, 0.0, 0.0), (0.0, 100.0, 0.0)];
    assert_eq!(reason(line, &any), PanelRefusal::CollinearCorner);
    assert_eq!(reason([(1.0, 1.0, 1.0); 4], &any), PanelRefusal::Degenerate);
    let long = [(0.0, 0.0, 0.0), (2000.0, 0.0, 0.0), (2000.0, 400.0, 0.0), (0.0, 400.0, 0.0)];
    let refused = reason(long, &settings(Grain::V));
    assert!(matches!(refused, PanelRefusal::TooLarge { .. }));
    assert_eq!(
        refused.to_string(),
        "it measures 400.0mm by 2000.0mm and does not fit a board of 2500mm by 1250mm"
    );
    assert_eq!(make(&single(long), &any).panels.len(), 1, "a free grain may be turned");
}

#[test]
fn settings_that_make_no_sense() {
    let mesh = samples::flat_grid(3, 3, 100.0);
    let run = |settings: &PanelSettings, count: usize| panels(&mesh, &mesh, &labels(count), settings);
    let mut thin = settings(Grain::U);
    for thickness in [None, Some(0.0), Some(f64::NAN)] {
        thin.material.thickness = thickness;
        assert_eq!(run(&thin, 4), Err(PanelError::NoThickness));
    }
    let good = settings(Grain::U);
    assert_eq!(run(&good, 3), Err(PanelError::WrongLabelCount { quads: 4, labels: 3 }));
    let flat = PanelSettings { board: (0.0, 100.0), ..good.clone() };
    assert_eq!(run(&flat, 4), Err(PanelError::NoBoard { board: (0.0, 100.0) }));
    let other = samples::flat_grid(2, 3, 100.0);
    assert_eq!(panels(&other, &mesh, &labels(4), &good), Err(PanelError::DifferentMeshes));
}

mod bevels;

proptest! {
    #[test]
    fn lengths_volumes_and_outlines(
        heights in proptest::collection::vec(-40.0f64..40.0, 16),
        shifts in proptest::collection::vec(-30.0f64..30.0, 16),
        grain in proptest::sample::select(vec![Grain::U, Grain::V, Grain::Free]),
        side in proptest::sample::select(vec![Side::Inner, Side::Centred, Side::Outer]),
        thickness in 0.5f64..40.0,
    ) {
        let mesh = samples::mesh(4, 4, |i, j| {
            let k = (i * 4.0 + j) as usize;
            DVec3::new(i * 200.0 + shifts[k], j * 150.0 - shifts[15 - k], heights[k])
        });
        let settings = PanelSettings { side, material: plywood(thickness), ..settings(grain) };
        let made = make(&mesh, &settings);
        prop_assert_eq!(made.panels.len() + made.refused.len(), 9);
        for panel in &made.panels {
            prop_assert!(panel.solid.is_watertight());
            let volume = panel.solid.volume();
            // Beside the middle surface, a folded board is a little larger on one face than on the other.
            let allowed = 0.02 * panel.area * thickness + panel.fold * panel.diagonal * thickness * thickness;
            prop_assert!((volume - panel.area * thickness).abs() < allowed);
            for side in 0..4 {
                let next = (side + 1) % 4;
                let flat = panel.outline[side].distance(panel.outline[next]);
                prop_assert!((flat - panel.corners[side].distance(panel.corners[next])).abs() < 1e-9);
            }
            let (low, _) = crate::fabricate::fit::bounds(&panel.outline);
            prop_assert_eq!(low, DVec2::ZERO);
            let along = match grain {
                Grain::U => panel.outline[1] - panel.outline[0],
                Grain::V => panel.outline[2] - panel.outline[1],
                Grain::Free => return Ok(()),
            };
            prop_assert!(along.x > 0.0 && along.y.abs() < 1e-9);
        }
    }
}
