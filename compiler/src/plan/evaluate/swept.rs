//! Grids of surfaces that are planar by construction (GEOMETRY 6c), each from the vertices of its curves alone.

use glam::{DQuat, DVec3};

use crate::ifs::Automaton;

use super::super::swept::{Path, Rule, SweptPlan, Turn};
use super::chain::{chain_numbers, chain_points, chain_rows, divided};
use super::net::PointGrid;

/// The vertices of a swept surface: rows along the path, columns along the profile.
pub fn swept_points(automaton: &Automaton, swept: &SweptPlan) -> PointGrid {
    let profile = chain_rows(automaton, &swept.profile);
    let rows: Vec<Vec<[f64; 3]>> = match &swept.path {
        Path::Rail(rail, rule) => {
            let rails = chain_rows(automaton, rail);
            match rule {
                Rule::Projective => rails.iter().map(|a| projected(a, &profile)).collect(),
                Rule::Sum => {
                    let rails = rails.into_iter().map(|a| DVec3::from(divided(a)));
                    rails.map(|a| moved(a, 1.0, &profile)).collect()
                }
                Rule::Scaled(scale) => {
                    let scales = chain_numbers(automaton, rail, scale);
                    let rails = rails.into_iter().map(|a| DVec3::from(divided(a)));
                    rails.zip(scales).map(|(a, s)| moved(a, s, &profile)).collect()
                }
            }
        }
        Path::Turn(turn) => turned(turn, &profile),
        Path::Straight { vector, pieces } => {
            let (vector, first) = (DVec3::from(*vector), first_point(&profile));
            let along = (0..=*pieces).map(|piece| first + vector * (f64::from(piece) / f64::from(*pieces)));
            along.map(|start| moved(start, 1.0, &profile)).collect()
        }
    };
    PointGrid { rows: rows.len(), columns: profile.len(), points: rows.concat() }
}

/// The scales that a scale-translation has at the vertices of its rail.
pub fn rail_scales(automaton: &Automaton, swept: &SweptPlan) -> Option<Vec<f64>> {
    match &swept.path {
        Path::Rail(rail, Rule::Scaled(scale)) => Some(chain_numbers(automaton, rail, scale)),
        _ => None,
    }
}

/// The vertices of the profile as it stands.
pub fn profile_points(automaton: &Automaton, swept: &SweptPlan) -> Vec<[f64; 3]> {
    chain_points(automaton, &swept.profile)
}

fn first_point(profile: &[[f64; 4]]) -> DVec3 {
    profile.first().map_or(DVec3::ZERO, |row| DVec3::from(divided(*row)))
}

/// a + s·(b(j) − b(0))
fn moved(a: DVec3, scale: f64, profile: &[[f64; 4]]) -> Vec<[f64; 3]> {
    let first = first_point(profile);
    profile.iter().map(|b| (a + scale * (DVec3::from(divided(*b)) - first)).to_array()).collect()
}

/// A + B(j) in homogeneous coordinates, divided.
fn projected(a: &[f64; 4], profile: &[[f64; 4]]) -> Vec<[f64; 3]> {
    profile.iter().map(|b| divided([0, 1, 2, 3].map(|place| a[place] + b[place]))).collect()
}

fn turned(turn: &Turn, profile: &[[f64; 4]]) -> Vec<Vec<[f64; 3]>> {
    let (point, axis) = (DVec3::from(turn.point), DVec3::from(turn.direction));
    let rows = turn.segments + u32::from(!turn.full);
    let step = |row: u32| {
        let half = turn.angle * (f64::from(row) / f64::from(turn.segments)) / 2.0;
        let (sine, cosine) = (libm::sin(half), libm::cos(half));
        let rotation = DQuat::from_xyzw(axis.x * sine, axis.y * sine, axis.z * sine, cosine);
        let image = |b: &[f64; 4]| (point + rotation * (DVec3::from(divided(*b)) - point)).to_array();
        profile.iter().map(image).collect()
    };
    (0..rows).map(step).collect()
}
