//! Nesting: where parts lie on raw sheets, and which are sawn from which raw bar. Plain geometry in mm: polygons,
//! lengths and angles, without names, materials or files. The same parts in the same order give the same result.
//!
//! [`sheets`] packs and [`bars`] cuts; [`check`] holds a packing against what was asked for, in code of its own.

pub mod bars;
pub mod check;
pub mod sheets;
