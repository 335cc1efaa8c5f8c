//! Nests as lists, pictures and figures of the report.

use super::Output;
use super::nests::{BarNest, Named, Nests, SheetNest};
use crate::export::html::SheetShape;
use crate::export::nest_csv::{Row, nest_csv};
use crate::export::number::Fixed;
use crate::export::part::Part;
use crate::export::report::{BarReport, BarsReport, SheetReport, SheetsReport, UnplacedReport};
use crate::export::sheet_svg::{SheetPicture, sheet_svg};
use crate::export::stock_csv::{Bars, stock_csv};
use crate::nest::sheets::Placement;
use glam::DVec2;
use std::collections::BTreeMap;

/// `nest.csv`; none without nested boards.
pub(super) fn nest_list(nests: &Nests) -> Option<String> {
    let mut rows = Vec::new();
    for nest in &nests.sheets {
        let row = |part: usize, lies| {
            let named = &nest.named[part];
            let texts = [&*named.address, &*named.alias, &*named.figure, &*nest.material];
            Row { texts, thickness: nest.thickness, lies }
        };
        rows.extend(
            nest.nested
                .placements
                .iter()
                .map(|placement| row(placement.part, Ok((nest.names[placement.sheet].as_str(), *placement)))),
        );
        rows.extend(nest.nested.unplaced.iter().map(|part| row(part.part, Err(part.reason.to_string()))));
    }
    (!nests.sheets.is_empty()).then(|| nest_csv(&rows))
}

/// `stock.csv`; none without nested planks.
pub(super) fn stock_list(nests: &Nests) -> Option<String> {
    let kinds = nests.bars.iter().map(|nest| {
        let planks = nest.named.iter().zip(&nest.planks);
        Bars {
            material: &nest.material,
            stock: &nest.stock,
            bars: nest.names.iter().map(String::as_str).zip(&nest.sawn.bars).collect(),
            planks: planks.map(|(named, plank)| (texts(named), plank.length)).collect(),
            too_long: nest.sawn.too_long.iter().map(|long| (long.plank, long.to_string())).collect(),
        }
    });
    let kinds: Vec<Bars<'_>> = kinds.collect();
    (!kinds.is_empty()).then(|| stock_csv(&kinds))
}

fn texts(named: &Named) -> [&str; 3] {
    [&named.address, &named.alias, &named.figure]
}

/// Where a file of a sheet lies in the output folder.
pub(super) fn sheet_path(name: &str, extension: &str) -> String {
    format!("sheets/{name}.{extension}")
}

/// The files of sheets among the outputs, by the names of the sheets.
pub(super) fn files_of(outputs: &[Output]) -> BTreeMap<String, Vec<String>> {
    let mut files: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for path in outputs.iter().map(|output| &output.path) {
        let name = path.strip_prefix("sheets/").and_then(|file| file.split('.').next());
        if let Some(name) = name {
            files.entry(name.to_owned()).or_default().push(path.clone());
        }
    }
    files
}

/// The pictures of all sheets, with the paths they have in the output folder.
pub(super) fn pictures(nests: &Nests) -> Vec<(String, String)> {
    let sheets = nests.sheets.iter().flat_map(|nest| (0..nest.nested.sheets).map(move |sheet| (nest, sheet)));
    sheets.map(|(nest, sheet)| (sheet_path(&nest.names[sheet], "svg"), picture(nest, sheet))).collect()
}

fn picture(nest: &SheetNest, sheet: usize) -> String {
    let placements: Vec<&Placement> =
        nest.nested.placements.iter().filter(|placement| placement.sheet == sheet).collect();
    let title = format!(
        "sheet {} · {}, {} mm · {} by {} mm · {} boards · {:.1} %",
        nest.names[sheet],
        nest.material,
        nest.thickness,
        nest.sheet.length,
        nest.sheet.width,
        placements.len(),
        100.0 * nest.sheet_yield(sheet),
    );
    sheet_svg(&SheetPicture {
        title,
        size: DVec2::new(nest.sheet.length, nest.sheet.width),
        margin: nest.sheet.margin,
        grain: placements.iter().any(|placement| !nest.parts[placement.part].any_quarter),
        parts: lying(nest, sheet).collect(),
    })
}

/// All sheets for the report, with their boards as they lie.
pub(super) fn shapes_of(nests: &Nests) -> Vec<SheetShape> {
    let sheets = nests.sheets.iter().flat_map(|nest| (0..nest.nested.sheets).map(move |sheet| (nest, sheet)));
    let shape = |(nest, sheet): (&SheetNest, usize)| SheetShape {
        name: nest.names[sheet].clone(),
        size: DVec2::new(nest.sheet.length, nest.sheet.width),
        used: nest.sheet_yield(sheet),
        parts: lying(nest, sheet).map(|(alias, outline)| (alias.to_owned(), outline)).collect(),
    };
    sheets.map(shape).collect()
}

/// The boards of a sheet: aliases, and outlines as they lie.
fn lying(nest: &SheetNest, sheet: usize) -> impl Iterator<Item = (&str, Vec<DVec2>)> {
    let here = nest.nested.placements.iter().filter(move |placement| placement.sheet == sheet);
    here.map(|placement| {
        let outline = &nest.parts[placement.part].outline;
        let lying = outline.iter().map(|&corner| placement.put(corner)).collect();
        (nest.named[placement.part].alias.as_str(), lying)
    })
}

/// Writes the sheet or bar of each part into the parts of the blocks.
pub(super) fn mark(nests: &Nests, parts: &mut [Vec<Part>]) {
    let mut mark = |named: &Named, name: &str| {
        let (block, index) = named.place;
        if let Some(part) = parts.get_mut(block).and_then(|parts| parts.get_mut(index)) {
            part.sheet = Some(name.to_owned());
        }
    };
    for nest in &nests.sheets {
        for placement in &nest.nested.placements {
            mark(&nest.named[placement.part], &nest.names[placement.sheet]);
        }
    }
    for nest in &nests.bars {
        for (name, bar) in nest.names.iter().zip(&nest.sawn.bars) {
            bar.planks.iter().for_each(|placed| mark(&nest.named[placed.plank], name));
        }
    }
}

/// The sheets of the report, and the files that are made for them by name.
pub(super) fn sheets_report(nest: &SheetNest, files: &BTreeMap<String, Vec<String>>) -> SheetsReport {
    let sheets = nest.names.iter().enumerate().map(|(sheet, name)| SheetReport {
        name: name.clone(),
        boards: nest.nested.placements.iter().filter(|placement| placement.sheet == sheet).count(),
        part_of_area: Fixed::ratio(nest.sheet_yield(sheet)),
        files: files.get(name).cloned().unwrap_or_default(),
    });
    let unplaced = nest.nested.unplaced.iter().map(|part| UnplacedReport {
        address: nest.named[part.part].address.clone(),
        reason: part.reason.to_string(),
    });
    SheetsReport {
        material: nest.material.clone(),
        thickness_mm: Fixed::mm(nest.thickness),
        length_mm: Fixed::mm(nest.sheet.length),
        width_mm: Fixed::mm(nest.sheet.width),
        gap_mm: Fixed::mm(nest.sheet.gap),
        margin_mm: Fixed::mm(nest.sheet.margin),
        least_sheets: nest.least,
        part_of_area: nest.whole_yield().map(Fixed::ratio),
        sheets: sheets.collect(),
        unplaced: unplaced.collect(),
    }
}

/// The bars of the report.
pub(super) fn bars_report(nest: &BarNest) -> BarsReport {
    let bars = nest.names.iter().zip(&nest.sawn.bars).map(|(name, bar)| BarReport {
        name: name.clone(),
        planks: bar.planks.len(),
        cuts: bar.cuts.len(),
        offcut_mm: Fixed::mm(bar.offcut),
    });
    let unplaced = nest.sawn.too_long.iter().map(|long| UnplacedReport {
        address: nest.named[long.plank].address.clone(),
        reason: long.to_string(),
    });
    BarsReport {
        material: nest.material.clone(),
        depth_mm: Fixed::mm(nest.stock.depth),
        width_mm: Fixed::mm(nest.stock.width),
        length_mm: Fixed::mm(nest.stock.length),
        kerf_mm: Fixed::mm(nest.stock.kerf),
        trim_mm: Fixed::mm(nest.stock.trim),
        least_bars: nest.least,
        part_of_length: nest.whole_yield().map(Fixed::ratio),
        bars: bars.collect(),
        unplaced: unplaced.collect(),
    }
}
