//! The sections of the report, one file each.

pub(super) mod assembly_boards;
pub(super) mod assembly_planks;
pub(super) mod cut_list;
pub(super) mod fabrication;
pub(super) mod opening;
pub(super) mod planarity;
pub(super) mod provenance;
pub(super) mod refused;
pub(super) mod requirements;
pub(super) mod scene;
pub(super) mod surface_map;
pub(super) mod views;
