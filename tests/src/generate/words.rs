//! The words and numbers a random design is made of.

/// What every design may use.
pub(super) const IMPORTS: &[&str] = &[
    "use std.curves (bezier2, bezier3, bspline2, bspline3, chord_fractal)\n",
    "use std.surfaces (tensor, sheet, translation, revolution)\n",
    "use std.materials (birch_plywood, sawn_spruce)\n",
    "use std.machines (router3)\n",
];

pub(super) const INTS: &[&str] = &["0", "1", "2", "3", "5", "-1", "12", "1000000", "0 - 7"];
pub(super) const NUMBERS: &[&str] =
    &["1/2", "0", "1", "0.5", "1/3", "0.46", "-1/4", "2", "50%", "1e-300", "1e300", "0.333333333333", "-3"];
pub(super) const LENGTHS: &[&str] =
    &["1m", "0m", "250mm", "12mm", "3.5m", "-1m", "2in", "40cm", "1e-9mm", "1e12m", "6ft", "0.1mm"];
pub(super) const ANGLES: &[&str] = &["30deg", "0deg", "1rad", "90deg", "-45deg", "360deg", "1e9deg"];
pub(super) const TEXTS: &[&str] = &["\"a\"", "\"\"", "\"Träger\"", "\"a\\\"b\""];

/// The measures of requirements and of `until`, with limits of the right dimension.
pub(super) const REQUIREMENTS: &[&str] = &[
    "planarity >= 0.99",
    "edge in 1mm .. 2m",
    "length in 1mm .. 3m",
    "mitre <= 45deg",
    "overlap >= 10mm",
    "bend radius >= material.min_bend_radius",
    "bend radius >= 1m",
    "edge <= 0mm",
    "length >= 4m",
    "area <= 1m2",
    "planarity == 1",
    "count <= 100",
    "mass <= 3kg",
    "fold <= 3deg",
    "angle in 60deg .. 120deg",
    "diagonal ratio <= 1.5",
    "width >= 10mm",
    "bevel <= 10deg",
    "planarity >= 2",
    "edge in 2m .. 1m",
];

pub(super) const SIDES: &[&str] = &["centred", "inner", "outer", "left"];
pub(super) const GRAINS: &[&str] = &["u", "v", "free", "both"];
pub(super) const EDGES: &[&str] = &["square", "bevelled", "stepped"];
pub(super) const ENDS: &[&str] = &["mitred", "square", "round"];
pub(super) const PINS: &[&str] = &["boundary", "none", "corners"];
