//! Evaluation of figures in doubles: basis tables of curves, points of curves, grids of sheets, elements of
//! separate pieces.
//!
//! A sheet is evaluated separably (GEOMETRY 4): one basis table a direction, never a Kronecker product, never a
//! recursion over nets. Sums run in a fixed order, so results are the same bytes on every machine.

mod basis;
mod chain;
mod combine;
mod curve;
mod infinite;
mod net;
mod patchwork;
mod pieces;
mod sheet;
mod swept;

pub use basis::{Basis, basis};
pub use chain::{chain_points, chain_rows};
pub use curve::curve_points;
pub use infinite::vertex_at_infinity;
pub use net::{PointGrid, net_points};
pub use patchwork::{Patchwork, patchwork};
pub use pieces::{DrawnGerm, EachError, GermShape, PieceElement, PiecesEvaluator, Tile};
pub use sheet::{SheetEvaluator, TILE_ROWS};
pub use swept::{profile_points, rail_scales, swept_points};
