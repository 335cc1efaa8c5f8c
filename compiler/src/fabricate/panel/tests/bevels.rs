//! Bevelled and stepped edges: outlines, solids that lie against each other, corners, and what cannot be bevelled.

use super::*;
use std::f64::consts::FRAC_PI_8;

fn edged(edges: Edges, side: Side) -> PanelSettings {
    PanelSettings { edges, side, ..settings(Grain::U) }
}

/// Two rectangles of 400 by 300 which meet at a ridge of a right angle (or a valley) along the side of 300.
fn ridge(sign: f64) -> QuadMesh {
    let run = 400.0 * std::f64::consts::FRAC_1_SQRT_2;
    samples::mesh(3, 2, |i, j| DVec3::new(i * run, j * 300.0, if i == 1.0 { sign * run } else { 0.0 }))
}

/// A sum of two polylines: every quad is a parallelogram, so every board is flat.
fn translation(u: &[(f64, f64)], v: &[(f64, f64)]) -> QuadMesh {
    let (us, vs) = (u.to_vec(), v.to_vec());
    samples::mesh(us.len(), vs.len(), |i, j| {
        let ((x, a), (y, b)) = (us[i as usize], vs[j as usize]);
        DVec3::new(x, y, a + b)
    })
}

/// How deep the convex solid of one board reaches into that of the other: the least depth over the planes of the
/// first of the deepest corner of the second. 0 or less where a plane parts them.
fn depth_into(first: &Solid, second: &Solid) -> f64 {
    let planes = first.triangles.iter().filter_map(|triangle| {
        let [a, b, c] = triangle.map(|corner| first.vertices[corner as usize]);
        Some((a, (b - a).cross(c - a).try_normalize()?))
    });
    planes
        .map(|(point, normal)| {
            let below = second.vertices.iter().map(|vertex| (point - *vertex).dot(normal));
            below.fold(f64::NEG_INFINITY, f64::max)
        })
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn a_ridge_and_a_valley_of_a_right_angle() {
    for (sign, side, top, bottom) in [
        (1.0, Side::Centred, 6.0, -6.0),
        (1.0, Side::Inner, 12.0, 0.0),
        (1.0, Side::Outer, 0.0, -12.0),
        (-1.0, Side::Centred, -6.0, 6.0),
        (-1.0, Side::Inner, -12.0, 0.0),
    ] {
        let made = make(&ridge(sign), &edged(Edges::Bevelled, side));
        let [first, second] = made.panels.as_slice() else { panic!("two boards") };
        let offsets = first.offsets[1];
        assert!((offsets.top - top).abs() < 1e-9 && (offsets.bottom - bottom).abs() < 1e-9, "{offsets:?}");
        assert!((first.size().x - (400.0 + top.max(bottom))).abs() < 1e-9);
        let volume = 400.0 * 300.0 * 12.0 + (top + bottom) / 2.0 * 300.0 * 12.0;
        assert!((first.volume - volume).abs() < 1e-6);
        assert!((first.solid.volume() - volume).abs() < 1e-5 && first.solid.is_watertight());
        assert!((first.mass.unwrap() - volume * 650e-9).abs() < 1e-9);
        // The two ends lie flat against each other: the same four corners.
        let meets =
            |vertex: &&DVec3| second.solid.vertices.iter().any(|other| other.distance(**vertex) < 1e-9);
        assert_eq!(first.solid.vertices.iter().filter(meets).count(), 4);
        assert!(first.centre.distance(second.centre) > 100.0);
    }
}

#[test]
fn a_step_halfway_touches_the_bevel_and_stays_within() {
    for (sign, side) in [(1.0, Side::Centred), (-1.0, Side::Centred), (1.0, Side::Inner), (-1.0, Side::Outer)]
    {
        let stepped = make(&ridge(sign), &edged(Edges::Stepped, side));
        let bevelled = make(&ridge(sign), &edged(Edges::Bevelled, side));
        let (first, full) = (&stepped.panels[0], &bevelled.panels[0]);
        assert!((first.offsets[1].top - first.offsets[1].bottom - sign * 6.0).abs() < 1e-9);
        assert!(first.solid.is_watertight());
        assert!((first.solid.volume() - first.volume).abs() < 1e-5);
        // Two triangles of half the thickness are missing.
        assert!((full.volume - first.volume - 2.0 * 18.0 * 300.0).abs() < 1e-5);
        assert!(depth_into(&full.solid, &stepped.panels[1].solid) < 1e-9);
    }
}

/// Where three boards meet, all corners coincide, whatever the angles are.
#[test]
fn three_boards_meet_in_a_point() {
    let vertices = [
        (0.0, 0.0, 200.0),
        (400.0, 0.0, 30.0),
        (300.0, 400.0, -200.0),
        (-150.0, 380.0, 10.0),
        (-400.0, 0.0, -150.0),
        (-200.0, -420.0, 40.0),
        (250.0, -350.0, -100.0),
    ];
    let vertices = vertices.map(|(x, y, z)| DVec3::new(x, y, z)).to_vec();
    let mesh = QuadMesh::try_new(vertices, vec![[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]]).unwrap();
    // Splitting from the middle corner keeps the three triangles there plane; the middle is corner A of each.
    let made = make(&mesh, &edged(Edges::Bevelled, Side::Inner));
    assert_eq!((made.panels.len(), made.corners.len()), (3, 0));
    assert!(made.panels.iter().all(|panel| panel.relief == [0.0; 4]));
}

/// Four boards on a saddle: the two on the ridges reach past the two others by the same figure at all of them.
#[test]
fn four_boards_on_a_saddle_need_relief() {
    let mesh = translation(
        &[(0.0, 0.0), (400.0, 400.0), (800.0, 400.0)],
        &[(0.0, 0.0), (400.0, -400.0), (800.0, -400.0)],
    );
    let made = make(&mesh, &edged(Edges::Bevelled, Side::Centred));
    assert_eq!((made.panels.len(), made.corners.len()), (4, 1));
    assert_eq!(made.corners[0].boards, ["shell.0", "shell.1", "shell.2", "shell.3"]);
    let most = made.panels.iter().flat_map(|panel| panel.relief).fold(0.0, f64::max);
    assert!(most > RELIEF_TOLERANCE && made.corners[0].relief == most, "{most}");
    // Opposite boards run into each other there; neighbours never do.
    let solid = |board: usize| &made.panels[board].solid;
    let opposite =
        [(0, 3), (1, 2)].map(|(a, b)| depth_into(solid(a), solid(b)).min(depth_into(solid(b), solid(a))));
    assert!(opposite.iter().any(|depth| *depth > 0.05), "{opposite:?}");
    for (a, b) in [(0, 1), (1, 3), (3, 2), (2, 0)] {
        assert!(depth_into(solid(a), solid(b)).min(depth_into(solid(b), solid(a))) < 1e-7);
    }
}

/// A flat grid has nothing to cut back, and is put up ring by ring from its rim.
#[test]
fn a_flat_grid_is_put_up_from_its_rim() {
    let made = make(&samples::flat_grid(5, 5, 200.0), &edged(Edges::Bevelled, Side::Centred));
    let rings: Vec<u32> = made.panels.iter().map(|panel| panel.ring).collect();
    assert_eq!(rings, [0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0]);
    assert!(made.corners.is_empty());
    assert_eq!(made.panels[5].neighbour_sides, [Some(2), Some(3), Some(0), Some(1)]);
}

#[test]
fn boards_that_bevels_eat_up() {
    // A gutter 14 wide between two walls that stand almost upright: the bevels of 40 degrees take 20 off its face.
    let profile = [(0.0, 100.0), (17.0, 0.0), (31.0, 0.0), (48.0, 100.0)];
    let mesh = translation(&profile, &[(0.0, 0.0), (300.0, 0.0)]);
    let made = make(&mesh, &edged(Edges::Bevelled, Side::Inner));
    let reason = made.refused.iter().find(|refused| refused.label.address == "shell.1").unwrap().reason;
    assert!(matches!(reason, PanelRefusal::SideVanishes { face: Face::Top, .. }), "{reason:?}");
    assert_eq!(
        reason.to_string(),
        "with bevels of up to 40.2deg nothing is left of edge 0 on its outer face"
    );
    assert_eq!(make(&mesh, &edged(Edges::Square, Side::Inner)).refused, []);
    assert!(made.panels.iter().all(|panel| panel.order > 0));
}

fn polyline() -> impl Strategy<Value = Vec<(f64, f64)>> {
    proptest::collection::vec((150.0f64..400.0, -0.5f64..0.5), 3..5).prop_map(|steps| {
        let (mut points, mut heading) = (vec![(0.0, 0.0)], 0.0);
        for (length, turn) in steps {
            heading += turn;
            let (x, z) = points[points.len() - 1];
            points.push((x + length * libm::cos(heading), z + length * libm::sin(heading)));
        }
        points
    })
}

proptest! {
    #[test]
    fn flat_boards_never_enter_their_neighbours(
        u in polyline(),
        v in polyline(),
        side in proptest::sample::select(vec![Side::Inner, Side::Centred, Side::Outer]),
        edges in proptest::sample::select(vec![Edges::Bevelled, Edges::Stepped]),
        thickness in 2.0f64..40.0,
    ) {
        let mesh = translation(&u, &v);
        let mut settings = edged(edges, side);
        settings.material = plywood(thickness);
        let made = make(&mesh, &settings);
        prop_assert!(made.refused.is_empty(), "{:?}", made.refused);
        for panel in &made.panels {
            prop_assert!(panel.solid.is_watertight());
            prop_assert!((panel.solid.volume() - panel.volume).abs() < 1e-7 * panel.volume);
            let (low, _) = crate::fabricate::fit::bounds(&panel.outline);
            prop_assert!(low.length() < 1e-9);
            for side in 0..4 {
                let offset = panel.offsets[side];
                let slope = libm::tan(panel.bevels[side].unwrap_or(0.0));
                let share = if edges == Edges::Bevelled { slope } else { slope / 2.0 };
                prop_assert!((offset.top - offset.bottom - thickness * share).abs() < 2e-3);
                let Some(neighbour) = panel.neighbours[side].as_ref() else { continue };
                let other = made.panels.iter().find(|other| &other.label.address == neighbour).unwrap();
                let far = usize::from(panel.neighbour_sides[side].unwrap());
                prop_assert_eq!(other.neighbours[far].as_ref(), Some(&panel.label.address));
                prop_assert!((other.bevels[far].unwrap() - panel.bevels[side].unwrap()).abs() < 1e-12);
                if edges == Edges::Bevelled {
                    let depth = depth_into(&panel.solid, &other.solid).min(depth_into(&other.solid, &panel.solid));
                    prop_assert!(depth < 1e-6, "{depth}");
                }
            }
        }
    }

    #[test]
    fn bent_boards_stay_whole(
        heights in proptest::collection::vec(-40.0f64..40.0, 16),
        edges in proptest::sample::select(vec![Edges::Bevelled, Edges::Stepped]),
        side in proptest::sample::select(vec![Side::Inner, Side::Centred, Side::Outer]),
        thickness in 0.5f64..30.0,
    ) {
        let mesh = samples::mesh(4, 4, |i, j| DVec3::new(i * 200.0, j * 150.0, heights[(i * 4.0 + j) as usize]));
        let settings = PanelSettings { material: plywood(thickness), ..edged(edges, side) };
        for panel in make(&mesh, &settings).panels {
            prop_assert!(panel.solid.is_watertight());
            let allowed = 1e-3 * panel.volume + 2.0 * panel.fold * panel.diagonal * thickness * thickness;
            prop_assert!((panel.solid.volume() - panel.volume).abs() < allowed);
        }
    }
}

#[test]
fn the_angle_is_halved() {
    let run =
        [(0.0, 0.0), (300.0, 0.0), (300.0 + 300.0 * libm::cos(FRAC_PI_4), -300.0 * libm::sin(FRAC_PI_4))];
    let made = make(&translation(&run, &[(0.0, 0.0), (300.0, 0.0)]), &edged(Edges::Bevelled, Side::Inner));
    assert!((made.panels[0].bevels[1].unwrap() - FRAC_PI_8).abs() < 1e-12);
}
