//! The binary part: what each piece of it is, how many bytes it has, and writing them. Little-endian, every piece a
//! multiple of four bytes.

use std::io::{self, Write};

use glam::DVec3;

use super::Part;
use super::colour::Scale;
use super::edges::EdgeList;
use super::pieces::{Places, places, vertices};
use super::split::{split, splits};
use crate::geometry::planarity::Diagonal;
use crate::geometry::{QuadMeasure, QuadMesh};
use crate::plan::evaluate::PiecesEvaluator;

/// Bytes gathered before the writer is called.
const CHUNK: usize = 1 << 16;

/// Something the binary part holds. Its elements are made while they are written.
pub(super) enum Piece<'a> {
    /// Positions.
    Points(&'a [DVec3]),
    /// The quads of a mesh as triangles on its vertices, split along the diagonal of the smaller fold. Triangles
    /// that use a vertex twice are left out.
    Triangles(&'a QuadMesh),
    /// Edges as pairs of vertices.
    Edges(EdgeList),
    /// Positions, four of its own for each quad.
    Corners(&'a QuadMesh),
    /// A colour for each of these positions.
    CornerColours(&'a QuadMesh, Scale),
    /// The quads as triangles on these positions.
    CornerTriangles(&'a QuadMesh),
    /// Positions of all solids, one after the other.
    PartPoints(&'a [Part<'a>]),
    /// Triangles of all solids on these positions.
    PartTriangles(&'a [Part<'a>]),
    /// Triangles as given.
    Indices(&'a [[u32; 3]]),
    /// Positions of separate pieces, so many.
    SeparateVertices(&'a PiecesEvaluator, usize),
    /// Places of these positions, so many.
    SeparatePlaces(&'a PiecesEvaluator, Places, usize),
}

impl Piece<'_> {
    /// How many bytes it has.
    pub(super) fn length(&self) -> u64 {
        let (count, size) = match self {
            Self::Points(points) => (points.len(), 12),
            Self::Triangles(mesh) => (triangle_count(mesh), 12),
            Self::Edges(edges) => (edges.len(), 8),
            Self::Corners(mesh) => (mesh.quads.len(), 48),
            Self::CornerColours(mesh, _) => (mesh.quads.len(), 32),
            Self::CornerTriangles(mesh) => (mesh.quads.len(), 24),
            Self::PartPoints(parts) => (parts.iter().map(|part| part.solid.vertices.len()).sum(), 12),
            Self::PartTriangles(parts) => (parts.iter().map(|part| part.solid.triangles.len()).sum(), 12),
            Self::Indices(triangles) => (triangles.len(), 12),
            Self::SeparateVertices(_, count) => (*count, 12),
            Self::SeparatePlaces(_, _, count) => (*count, 4),
        };
        count as u64 * size
    }

    /// Writes its bytes.
    pub(super) fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let mut sink = Sink { bytes: Vec::with_capacity(CHUNK + 64), out };
        match self {
            Self::Points(points) => points.iter().try_for_each(|&point| sink.point(point))?,
            Self::Triangles(mesh) => {
                for (corners, diagonal) in mesh.quads.iter().zip(splits(mesh)) {
                    for triangle in triangles(*corners, diagonal).into_iter().filter(has_area) {
                        sink.indices(triangle)?;
                    }
                }
            }
            Self::Edges(edges) => edges.iter().try_for_each(|edge| sink.indices(edge))?,
            Self::Corners(mesh) => {
                for quad in 0..mesh.quads.len() {
                    mesh.corners_of(quad).into_iter().try_for_each(|corner| sink.point(corner))?;
                }
            }
            Self::CornerColours(mesh, scale) => {
                for quad in 0..mesh.quads.len() {
                    let colour = scale.of(&QuadMeasure::of(mesh.corners_of(quad)));
                    (0..4).try_for_each(|_| sink.colour(colour))?;
                }
            }
            Self::CornerTriangles(mesh) => {
                for quad in 0..mesh.quads.len() {
                    let first = quad as u32 * 4;
                    for triangle in split(mesh.corners_of(quad)).triangles() {
                        sink.indices(triangle.map(|corner| first + corner as u32))?;
                    }
                }
            }
            Self::PartPoints(parts) => {
                for part in *parts {
                    part.solid.vertices.iter().try_for_each(|&point| sink.point(point))?;
                }
            }
            Self::PartTriangles(parts) => {
                let mut first = 0u32;
                for part in *parts {
                    for triangle in &part.solid.triangles {
                        sink.indices(triangle.map(|corner| first + corner))?;
                    }
                    first += part.solid.vertices.len() as u32;
                }
            }
            Self::SeparateVertices(evaluator, _) => vertices(evaluator, |vertex| sink.point(vertex))?,
            Self::SeparatePlaces(evaluator, kind, _) => {
                places(evaluator, *kind, |place| sink.indices([place]))?;
            }
            Self::Indices(triangles) => triangles.iter().try_for_each(|&three| sink.indices(three))?,
        }
        sink.flush()
    }
}

/// The two triangles of a quad as vertices.
fn triangles(corners: [u32; 4], diagonal: Diagonal) -> [[u32; 3]; 2] {
    diagonal.triangles().map(|three| three.map(|corner| corners[corner]))
}

fn has_area(&[a, b, c]: &[u32; 3]) -> bool {
    a != b && b != c && c != a
}

/// How many triangles [`Piece::Triangles`] writes.
pub(super) fn triangle_count(mesh: &QuadMesh) -> usize {
    let whole = |&[a, b, c, d]: &[u32; 4]| a != b && a != c && a != d && b != c && b != d && c != d;
    (0..mesh.quads.len())
        .map(|quad| match whole(&mesh.quads[quad]) {
            true => 2,
            false => {
                let diagonal = split(mesh.corners_of(quad));
                triangles(mesh.quads[quad], diagonal).iter().filter(|three| has_area(three)).count()
            }
        })
        .sum()
}

/// A position in metres and Y up. Adding 0 makes 0 of −0.
pub(super) fn position(point: DVec3) -> [f32; 3] {
    [point.x, point.z, -point.y].map(|part| (part * 1e-3) as f32 + 0.0)
}

/// Bytes on their way to the writer.
struct Sink<'w, W> {
    bytes: Vec<u8>,
    out: &'w mut W,
}

impl<W: Write> Sink<'_, W> {
    fn point(&mut self, point: DVec3) -> io::Result<()> {
        let [x, y, z] = position(point).map(f32::to_le_bytes);
        self.group([x, y, z])
    }

    fn indices<const N: usize>(&mut self, indices: [u32; N]) -> io::Result<()> {
        self.group(indices.map(u32::to_le_bytes))
    }

    fn colour(&mut self, [red, green, blue, alpha]: [u16; 4]) -> io::Result<()> {
        self.group([red, green, blue, alpha].map(u16::to_le_bytes))
    }

    fn group<const N: usize, const S: usize>(&mut self, parts: [[u8; S]; N]) -> io::Result<()> {
        self.bytes.extend_from_slice(parts.as_flattened());
        if self.bytes.len() >= CHUNK { self.flush() } else { Ok(()) }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.write_all(&self.bytes)?;
        self.bytes.clear();
        Ok(())
    }
}
