//! The triangles of a mesh: lists, strips and fans of them, by indices or in order (glTF 2.0, section 3.7.2).

use super::accessor::{Reader, Values};
use super::document::Primitive;
use super::nodes::PlacedMesh;
use super::weld::Welder;
use super::{FARTHEST, Fault, MOST_TRIANGLES};
use glam::{DAffine3, DVec3};

/// How corners make triangles.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Mode {
    List,
    Strip,
    Fan,
}

impl Mode {
    fn triangles(self, corners: usize) -> usize {
        match self {
            Mode::List => corners / 3,
            Mode::Strip | Mode::Fan => corners.saturating_sub(2),
        }
    }

    /// The corners of a triangle; all of a strip go around the same way.
    fn corners(self, triangle: usize) -> [usize; 3] {
        let i = triangle;
        match self {
            Mode::List => [3 * i, 3 * i + 1, 3 * i + 2],
            Mode::Strip => [i, i + 1 + i % 2, i + 2 - i % 2],
            Mode::Fan => [i + 1, i + 2, 0],
        }
    }
}

/// Adds the triangles of a mesh where it stands.
pub(super) fn add_mesh(
    reader: &Reader<'_>,
    placed: &PlacedMesh<'_>,
    welder: &mut Welder,
) -> Result<(), Fault> {
    for (number, primitive) in placed.mesh.primitives.iter().enumerate() {
        let place = || format!("meshes[{}].primitives[{number}]", placed.number);
        let mode = match primitive.mode.unwrap_or(4) {
            // Points and lines have no surface.
            0..=3 => continue,
            4 => Mode::List,
            5 => Mode::Strip,
            6 => Mode::Fan,
            other => return Err(Fault::malformed(place(), format!("there is no mode {other}"))),
        };
        add_primitive(reader, primitive, (mode, &place), placed.place, welder)?;
    }
    Ok(())
}

fn add_primitive(
    reader: &Reader<'_>,
    primitive: &Primitive,
    (mode, place): (Mode, &dyn Fn() -> String),
    node: DAffine3,
    welder: &mut Welder,
) -> Result<(), Fault> {
    let Some(positions) = primitive.attributes.position else {
        return Err(Fault::malformed(place(), "it has no positions"));
    };
    let positions = reader.positions(positions)?;
    let indices = primitive.indices.map(|indices| reader.indices(indices)).transpose()?;
    let corners = indices.as_ref().map_or(positions.count, |indices| indices.count);
    if mode == Mode::List && corners % 3 != 0 {
        let what = format!("{corners} corners make no triangles: that is no multiple of 3");
        return Err(Fault::malformed(place(), what));
    }
    let triangles = mode.triangles(corners);
    if welder.triangles_read.saturating_add(triangles) > MOST_TRIANGLES {
        let what = format!("the mesh has more than the limit of {MOST_TRIANGLES} triangles");
        return Err(Fault::too_large(place(), what, "reduce the mesh (decimate it) before you export it"));
    }
    welder.triangles_read += triangles;
    // A mirrored mesh is turned inside out, unless its triangles go around the other way.
    let mirrored = node.matrix3.determinant() < 0.0;
    for triangle in 0..triangles {
        let mut corners = [[0; 3]; 3];
        for (corner, at) in corners.iter_mut().zip(mode.corners(triangle)) {
            *corner = welder.place_of(vertex(&positions, indices.as_ref(), at, node)?);
        }
        if mirrored {
            corners.swap(1, 2);
        }
        welder.add(corners);
    }
    Ok(())
}

/// A vertex in millimetres, z upwards: glTF has metres, y upwards.
fn vertex(
    positions: &Values<'_>,
    indices: Option<&Values<'_>>,
    at: usize,
    node: DAffine3,
) -> Result<DVec3, Fault> {
    let index = match indices {
        None => at,
        Some(indices) => match indices.whole(at) {
            Some(index) if (index as usize) < positions.count => index as usize,
            found => {
                let named = found.map_or("none".to_owned(), |index| index.to_string());
                let what = format!(
                    "corner {at} is vertex {named}, and {} has {} of them",
                    positions.place, positions.count
                );
                return Err(Fault::malformed(indices.place.clone(), what));
            }
        },
    };
    let point = positions.point(index).unwrap_or([f64::NAN; 3]);
    let point = node.transform_point3(DVec3::from_array(point)) * 1000.0;
    // Not so for numbers that are none.
    if point.abs().max_element() <= FARTHEST && point.is_finite() {
        return Ok(DVec3::new(point.x, -point.z, point.y));
    }
    let what = if point.is_finite() {
        format!("vertex {index} lies more than {} km from the origin", FARTHEST / 1e6)
    } else {
        format!("vertex {index} has a coordinate that is no finite number")
    };
    Err(Fault::malformed(positions.place.clone(), what))
}
