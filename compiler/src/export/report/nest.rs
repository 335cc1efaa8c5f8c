//! Sheets and bars in the report.

use serde::Serialize;

use crate::export::number::Fixed;

/// Boards that are nested together.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SheetsReport {
    /// The name of their material.
    pub material: String,
    /// Of the boards.
    pub thickness_mm: Fixed,
    /// Of a raw board.
    pub length_mm: Fixed,
    /// Of a raw board.
    pub width_mm: Fixed,
    /// The least distance of boards.
    pub gap_mm: Fixed,
    /// The least distance from the edge of a raw board.
    pub margin_mm: Fixed,
    /// A proven least number of sheets: by area, gaps counted.
    pub least_sheets: usize,
    /// The area of the boards by that of their sheets.
    #[serde(rename = "yield")]
    pub part_of_area: Option<Fixed>,
    /// Each sheet.
    pub sheets: Vec<SheetReport>,
    /// Boards that lie on no sheet.
    pub unplaced: Vec<UnplacedReport>,
}

/// One sheet.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SheetReport {
    /// Its name.
    pub name: String,
    /// How many boards lie on it.
    pub boards: usize,
    /// Their area by that of the sheet.
    #[serde(rename = "yield")]
    pub part_of_area: Fixed,
    /// The files made for it, in the output folder.
    pub files: Vec<String>,
}

/// An element that could not be nested.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct UnplacedReport {
    /// Its address.
    pub address: String,
    /// Why.
    pub reason: String,
}

/// Planks that are cut together.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BarsReport {
    /// The name of their material.
    pub material: String,
    /// Of the section, in the plane of the mitres.
    pub depth_mm: Fixed,
    /// Of the section, square to that plane.
    pub width_mm: Fixed,
    /// Of a raw bar.
    pub length_mm: Fixed,
    /// What the saw takes.
    pub kerf_mm: Fixed,
    /// What is left aside at each end of a raw bar.
    pub trim_mm: Fixed,
    /// A proven least number of bars: by length, kerfs counted.
    pub least_bars: usize,
    /// The length of the planks by that of their bars.
    #[serde(rename = "yield")]
    pub part_of_length: Option<Fixed>,
    /// Each bar.
    pub bars: Vec<BarReport>,
    /// Planks that are longer than a bar.
    pub unplaced: Vec<UnplacedReport>,
}

/// One bar.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BarReport {
    /// Its name.
    pub name: String,
    /// How many planks are cut out of it.
    pub planks: usize,
    /// How many strokes of the saw that takes.
    pub cuts: usize,
    /// What is left at its end.
    pub offcut_mm: Fixed,
}
