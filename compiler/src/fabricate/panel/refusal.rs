//! Why a board, or all boards of a figure, cannot be made: the reasons and their words.

use std::fmt;

use glam::DVec2;

use super::Face;
use crate::geometry::UnrollError;

/// Why no board can be made for a quad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PanelRefusal {
    /// One of its corners is reflex.
    Dart,
    /// Three neighbouring corners lie on a line.
    CollinearCorner,
    /// Folded over a diagonal by a right angle or more, or crossing itself.
    FoldedOver,
    /// A side, a diagonal or the whole quad without length or area.
    Degenerate,
    /// It cannot be unrolled.
    Unroll(UnrollError),
    /// With its bevels a face keeps nothing of a side.
    SideVanishes {
        /// Of which face.
        face: Face,
        /// Which side, 0 to 3.
        side: usize,
        /// The largest bevel of the board without its sign, rad.
        bevel: f64,
    },
    /// Two sides run on straight and have different bevels, so that they have no corner.
    NoCorner {
        /// The two sides.
        sides: [usize; 2],
    },
    /// Larger than the sheet in every way the grain lets it lie. mm.
    TooLarge {
        /// The box around its outline as it is placed.
        size: DVec2,
        /// Length and width of the sheet.
        board: (f64, f64),
    },
}

impl fmt::Display for PanelRefusal {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Dart => out.write_str("one of its corners is reflex"),
            Self::CollinearCorner => out.write_str("three of its corners lie on a line"),
            Self::FoldedOver => out.write_str("it is folded over a diagonal"),
            Self::Degenerate => out.write_str("it has no area, or a side without length"),
            Self::Unroll(reason) => reason.fmt(out),
            Self::SideVanishes { face, side, bevel } => write!(
                out,
                "with bevels of up to {:.1}deg nothing is left of edge {side} on its {} face",
                bevel.to_degrees(),
                face.word()
            ),
            Self::NoCorner { sides: [first, second] } => write!(
                out,
                "edges {first} and {second} run on straight with different bevels: they have no corner"
            ),
            Self::TooLarge { size, board: (length, width) } => write!(
                out,
                "it measures {:.1}mm by {:.1}mm and does not fit a board of {length}mm by {width}mm",
                size.x, size.y
            ),
        }
    }
}

/// Why no boards at all can be made of a figure.
#[derive(Debug, Clone, PartialEq)]
pub enum PanelError {
    /// The material has no thickness, or one that is not above 0.
    NoThickness,
    /// The sheet has a side that is not above 0, mm.
    NoBoard {
        /// Length and width as given.
        board: (f64, f64),
    },
    /// The designed and the planarized mesh are not the same quads on the same vertices.
    DifferentMeshes,
    /// Not one label for each quad.
    WrongLabelCount {
        /// How many quads there are.
        quads: usize,
        /// How many labels.
        labels: usize,
    },
}

impl fmt::Display for PanelError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoThickness => out.write_str("boards need a material with a thickness above 0mm"),
            Self::NoBoard { board: (length, width) } => {
                write!(out, "a board of {length}mm by {width}mm has no area")
            }
            Self::DifferentMeshes => {
                out.write_str("the designed and the planarized surface have different quads")
            }
            Self::WrongLabelCount { quads, labels } => write!(out, "{labels} labels for {quads} quads"),
        }
    }
}

impl std::error::Error for PanelError {}
