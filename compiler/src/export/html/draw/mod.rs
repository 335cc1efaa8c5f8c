//! Drawings as SVG: views of space, their order from back to front, plots, scales and what stands beside them. One unit of
//! every drawing is a millimetre on paper.

pub(super) mod axis;
pub(super) mod body;
pub(super) mod colour;
pub(super) mod convergence;
pub(super) mod depth_order;
pub(super) mod dimension;
pub(super) mod histogram;
pub(super) mod legend;
pub(super) mod paper;
pub(super) mod scale_bar;
pub(super) mod view;
