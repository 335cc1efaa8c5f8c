//! The diagonal a quad is split along, found without an angle: for models of a million quads, where the two arcus
//! tangents of the full measure would take longest.

use glam::DVec3;

use crate::geometry::QuadMesh;
use crate::geometry::planarity::{Diagonal, FOLD_TIE, QuadMeasure};

/// A quad whose corner normals have at least this much of the square of its size is far from any collinear corner.
const SOUND: f64 = 1e-8;

/// The same diagonal as [`QuadMeasure::split`].
///
/// With the tangents t of the two folds, both below a right angle, that of BD is smaller than that of AC by more than
/// (t_AC² − t_BD²)/(1 + t_AC²)²: angles differ by at least (t − t′)/(1 + t²), and t + t′ ≤ 1 + t² for t ≥ t′. Where
/// that does not settle it, the full measure does.
pub(super) fn split(corners: [DVec3; 4]) -> Diagonal {
    let [a, b, c, d] = corners;
    let sides = [b - a, c - b, d - c, a - d];
    let [at_a, at_b, at_c, at_d] = [
        sides[3].cross(sides[0]),
        sides[0].cross(sides[1]),
        sides[1].cross(sides[2]),
        sides[2].cross(sides[3]),
    ];
    let size = sides.iter().map(|side| side.length_squared()).sum::<f64>();
    let (dot_ac, dot_bd) = (at_b.dot(at_d), at_a.dot(at_c));
    if dot_ac.min(dot_bd) > SOUND * size * size {
        let tangent_ac = at_b.cross(at_d).length_squared() / (dot_ac * dot_ac);
        let tangent_bd = at_a.cross(at_c).length_squared() / (dot_bd * dot_bd);
        if tangent_bd >= tangent_ac {
            return Diagonal::Ac;
        }
        let most = 1.0 + tangent_ac;
        if tangent_ac - tangent_bd > 1.001 * FOLD_TIE * most * most {
            return Diagonal::Bd;
        }
    }
    QuadMeasure::of(corners).split
}

/// Meshes of fewer quads are measured without further threads.
const MANY: usize = 50_000;

/// Over how many threads a large mesh is spread. What is found does not depend on it.
const THREADS: usize = 4;

/// The diagonal of every quad of a mesh, in order.
pub(super) fn splits(mesh: &QuadMesh) -> Vec<Diagonal> {
    let quads = mesh.quads.len();
    let measure =
        |from: usize, to: usize| (from..to).map(|quad| split(mesh.corners_of(quad))).collect::<Vec<_>>();
    if quads < MANY {
        return measure(0, quads);
    }
    let share = quads.div_ceil(THREADS);
    std::thread::scope(|scope| {
        let measure = &measure;
        let parts: Vec<_> = (0..quads)
            .step_by(share)
            .map(|from| (from, scope.spawn(move || measure(from, (from + share).min(quads)))))
            .collect();
        let done = parts.into_iter().flat_map(|(from, part)| {
            part.join().unwrap_or_else(|_| measure(from, (from + share).min(quads)))
        });
        done.collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn agrees_with_the_measure(
            heights in proptest::array::uniform4(prop_oneof![Just(0.0), -1e-7f64..1e-7, -1.0f64..1.0, -200.0f64..200.0]),
            shifts in proptest::array::uniform8(prop_oneof![Just(0.0), -90.0f64..90.0]),
        ) {
            let square = [(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)];
            let corners = [0, 1, 2, 3].map(|k| {
                DVec3::new(square[k].0 + shifts[k], square[k].1 + shifts[k + 4], heights[k])
            });
            prop_assert_eq!(split(corners), QuadMeasure::of(corners).split);
        }
    }

    #[test]
    fn a_large_mesh_is_split_as_each_of_its_quads() {
        let point = |i: f64, j: f64| DVec3::new(i, j, libm::sin(i * 0.7) * libm::cos(j * 1.3));
        let mesh = crate::geometry::samples::mesh(260, 240, point);
        assert!(mesh.quads.len() > MANY);
        let each: Vec<Diagonal> = (0..mesh.quads.len()).map(|quad| split(mesh.corners_of(quad))).collect();
        assert_eq!(splits(&mesh), each);
    }

    #[test]
    fn agrees_where_there_is_no_area() {
        let point = DVec3::new(3.0, 4.0, 5.0);
        for corners in
            [[point; 4], [point, point, DVec3::X, DVec3::Y], [DVec3::ZERO, DVec3::X, DVec3::X * 2.0, point]]
        {
            assert_eq!(split(corners), QuadMeasure::of(corners).split);
        }
    }
}
