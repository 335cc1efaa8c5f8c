//! The nests of a design: the boards of blocks that share material, raw boards and machine are nested together, planks
//! that share section and bars too. What comes out is checked before anything is made of it.

use crate::analysis::{Analysis, Elements, Fabrication, Nest, Programs, nested_panel, nested_plank};
use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::panel::Panel;
use crate::fabricate::plank::Plank;
use crate::hir::value::Value;
use crate::nest::bars::{self, Sawn, Stock, least_bars, saw};
use crate::nest::check::{Fault, bar_faults, faults};
use crate::nest::sheets::{Nested, Part, Sheet, area, least_sheets, nest};
use crate::source::Span;

/// All nests of a design.
#[derive(Clone, Debug, Default)]
pub struct Nests {
    /// Boards on raw boards.
    pub sheets: Vec<SheetNest>,
    /// Planks on raw bars.
    pub bars: Vec<BarNest>,
}

/// What an element that is nested is called.
#[derive(Clone, Debug, PartialEq)]
pub struct Named {
    /// Its address.
    pub address: String,
    /// Its short name.
    pub alias: String,
    /// Its figure.
    pub figure: String,
    /// The place of its block among those of the design, and its own in the block.
    pub(super) place: (usize, usize),
}

/// Boards that are nested together.
#[derive(Clone, Debug)]
pub struct SheetNest {
    /// The name of their material.
    pub material: String,
    /// mm.
    pub thickness: f64,
    /// Raw boards and distances.
    pub sheet: Sheet,
    /// The boards by address.
    pub named: Vec<Named>,
    /// Their outlines.
    pub parts: Vec<Part>,
    /// Where they lie.
    pub nested: Nested,
    /// A proven least number of sheets.
    pub least: usize,
    /// The names of the sheets: their numbers among all sheets of the design.
    pub names: Vec<String>,
    /// What of them gets a program.
    pub programs: Programs,
    pub(super) span: Span,
}

impl SheetNest {
    /// The area of the boards on a sheet by that of the sheet.
    #[must_use]
    pub fn sheet_yield(&self, sheet: usize) -> f64 {
        let here = self.nested.placements.iter().filter(|placement| placement.sheet == sheet);
        here.map(|placement| area(&self.parts[placement.part].outline)).sum::<f64>() / self.sheet.area()
    }

    /// The area of the boards by that of their sheets; none without sheets.
    #[must_use]
    pub fn whole_yield(&self) -> Option<f64> {
        let sum: f64 = (0..self.nested.sheets).map(|sheet| self.sheet_yield(sheet)).sum();
        (self.nested.sheets > 0).then(|| sum / self.nested.sheets as f64)
    }
}

/// Planks that are cut together.
#[derive(Clone, Debug)]
pub struct BarNest {
    /// The name of their material.
    pub material: String,
    /// Raw bars and saw.
    pub stock: Stock,
    /// The planks by address.
    pub named: Vec<Named>,
    /// As they are cut.
    pub planks: Vec<bars::Plank>,
    /// Where they lie.
    pub sawn: Sawn,
    /// A proven least number of bars.
    pub least: usize,
    /// The names of the bars: their numbers among all bars of the design.
    pub names: Vec<String>,
    span: Span,
}

impl BarNest {
    /// The length of the planks by that of their bars; none without bars.
    #[must_use]
    pub fn whole_yield(&self) -> Option<f64> {
        let placed = self.sawn.bars.iter().flat_map(|bar| &bar.planks);
        let length: f64 = placed.map(|placed| self.planks[placed.plank].length).sum();
        let bars = self.sawn.bars.len();
        (bars > 0).then(|| length / (bars as f64 * self.stock.length))
    }
}

/// What blocks must share to be nested together.
#[derive(PartialEq)]
struct Key<'a> {
    nest: Nest,
    material: &'a str,
    /// The thickness of a board, or the width of a plank.
    thickness: f64,
    machine: Option<&'a Value>,
    fixing: Option<&'a Value>,
}

/// Nests everything that is to be nested; what the check finds wrong is an error.
pub(super) fn nests(analysis: &Analysis) -> Result<Nests, Vec<Diagnostic>> {
    let mut nests = Nests::default();
    let mut keys: Vec<(Key<'_>, Vec<usize>)> = Vec::new();
    for (place, made) in analysis.fabrications.iter().enumerate() {
        let Some(key) = key(made) else { continue };
        match keys.iter_mut().find(|(known, _)| *known == key) {
            Some((_, places)) => places.push(place),
            None => keys.push((key, vec![place])),
        }
    }
    for (key, places) in &keys {
        let blocks: Vec<(usize, &Fabrication)> =
            places.iter().map(|&place| (place, &analysis.fabrications[place])).collect();
        match key.nest {
            Nest::Sheets(sheet, programs) => nests.sheets.push(sheet_nest(key, (sheet, programs), &blocks)),
            Nest::Bars(stock) => nests.bars.push(bar_nest(key, stock, &blocks)),
        }
    }
    name(nests.sheets.iter_mut().map(|nest| (&mut nest.names, nest.nested.sheets)).collect(), "");
    name(nests.bars.iter_mut().map(|nest| (&mut nest.names, nest.sawn.bars.len())).collect(), "bar-");
    let found = refused(&nests);
    if found.is_empty() { Ok(nests) } else { Err(found) }
}

fn key(made: &Fabrication) -> Option<Key<'_>> {
    let setting =
        |wanted: &str| made.settings.iter().find(|(name, _, _)| *name == wanted).map(|(_, value, _)| value);
    let (machine, fixing) = (setting("machine"), setting("fixing"));
    let (material, thickness) = match &made.elements {
        Elements::Panels(panels) => (&panels.settings.material, panels.settings.material.thickness?),
        Elements::Planks(planks) => (&planks.settings.material, planks.settings.width),
    };
    Some(Key { nest: made.nest?, material: &material.name, thickness, machine, fixing })
}

/// The elements of some blocks by their addresses, so that the order of blocks makes no difference.
fn by_address<'a, T: 'a>(
    blocks: &[(usize, &'a Fabrication)],
    elements: impl Fn(&'a Fabrication) -> Vec<(&'a crate::fabricate::label::Label, T)>,
) -> Vec<(Named, T)> {
    let mut all: Vec<(Named, T)> = Vec::new();
    for &(place, made) in blocks {
        all.extend(elements(made).into_iter().enumerate().map(|(index, (label, element))| {
            let (address, alias) = (label.address.clone(), label.alias.clone());
            (Named { address, alias, figure: made.figure.clone(), place: (place, index) }, element)
        }));
    }
    all.sort_by(|(a, _), (b, _)| a.address.cmp(&b.address));
    all
}

fn span_of(blocks: &[(usize, &Fabrication)]) -> Span {
    let settings = blocks.iter().flat_map(|(_, made)| &made.settings);
    settings.filter(|(name, _, _)| *name == "nest").map(|(_, _, span)| *span).next().unwrap_or_default()
}

fn sheet_nest(
    key: &Key<'_>,
    (sheet, programs): (Sheet, Programs),
    blocks: &[(usize, &Fabrication)],
) -> SheetNest {
    let all = by_address(blocks, |made| {
        let Elements::Panels(panels) = &made.elements else { return Vec::new() };
        let part = |panel: &Panel| nested_panel(panel, panels.settings.grain);
        panels.panels.iter().map(|panel| (&panel.label, part(panel))).collect()
    });
    let (named, parts): (Vec<Named>, Vec<Part>) = all.into_iter().unzip();
    let nested = nest(&parts, &sheet);
    let least = least_sheets(nested.placements.iter().map(|placement| &parts[placement.part]), &sheet);
    let (material, thickness) = (key.material.to_owned(), key.thickness);
    SheetNest {
        material,
        thickness,
        sheet,
        named,
        parts,
        nested,
        least,
        names: Vec::new(),
        programs,
        span: span_of(blocks),
    }
}

fn bar_nest(key: &Key<'_>, stock: Stock, blocks: &[(usize, &Fabrication)]) -> BarNest {
    let all = by_address(blocks, |made| {
        let Elements::Planks(planks) = &made.elements else { return Vec::new() };
        planks.planks.iter().map(|plank: &Plank| (&plank.label, nested_plank(plank))).collect()
    });
    let (named, planks): (Vec<Named>, Vec<bars::Plank>) = all.into_iter().unzip();
    let sawn = saw(&planks, &stock);
    let placed = sawn.bars.iter().flat_map(|bar| &bar.planks).map(|placed| planks[placed.plank]);
    let least = least_bars(&placed.collect::<Vec<_>>(), &stock);
    let material = key.material.to_owned();
    BarNest { material, stock, named, planks, sawn, least, names: Vec::new(), span: span_of(blocks) }
}

/// Numbers from 1 through all nests, with as many digits as the last one has.
fn name(nests: Vec<(&mut Vec<String>, usize)>, prefix: &str) {
    let total: usize = nests.iter().map(|(_, count)| count).sum();
    let digits = total.to_string().len();
    let mut number = 0;
    for (names, count) in nests {
        for _ in 0..count {
            number += 1;
            names.push(format!("{prefix}{number:0digits$}"));
        }
    }
}

/// What the check finds wrong, said with names.
fn refused(nests: &Nests) -> Vec<Diagnostic> {
    let sheets = nests.sheets.iter().filter_map(|nest| {
        let found = faults(&nest.parts, &nest.sheet, &nest.nested);
        failed(&found, &nest.named, nest.span)
    });
    let bars = nests.bars.iter().filter_map(|nest| {
        let found = bar_faults(&nest.planks, &nest.stock, &nest.sawn);
        failed(&found, &nest.named, nest.span)
    });
    sheets.chain(bars).collect()
}

fn failed(found: &[Fault], named: &[Named], span: Span) -> Option<Diagnostic> {
    let first = found.first()?;
    let parts = match *first {
        Fault::TooNear { parts, .. } => parts.to_vec(),
        Fault::NotOnce { part, .. } | Fault::NotAllowed { part } | Fault::OutsideMargin { part, .. } => {
            vec![part]
        }
    };
    let aliases: Vec<&str> =
        parts.iter().filter_map(|&part| named.get(part)).map(|named| named.alias.as_str()).collect();
    let message = format!("the nest with {} is not as asked for: {first}", aliases.join(" and "));
    let diagnostic = Diagnostic::new(Code::E0934, span, message).label("nested here");
    let note = format!("{} faults were found by measuring it anew; nothing was written", found.len());
    Some(diagnostic.note(note).hint("leave `nest` out, and please report this"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The check itself is tested with packings that were tampered with; here is what is said then.
    #[test]
    fn a_nest_that_its_check_refuses() {
        let named = ["shell-00", "shell-01"].map(|alias| Named {
            address: alias.replace('-', "."),
            alias: alias.to_owned(),
            figure: "shell".to_owned(),
            place: (0, 0),
        });
        let found = [Fault::TooNear { parts: [1, 0], distance: 0.5 }, Fault::NotAllowed { part: 0 }];
        let said = failed(&found, &named, Span::default()).unwrap();
        assert_eq!(said.code, Code::E0934);
        assert_eq!(
            said.message,
            "the nest with shell-01 and shell-00 is not as asked for: parts 1 and 0 are 0.500mm apart"
        );
        assert!(said.notes[0].starts_with("2 faults"));
        assert!(failed(&[], &named, Span::default()).is_none());
    }

    #[test]
    fn names_are_numbers_through_all_nests() {
        let (mut first, mut second) = (Vec::new(), Vec::new());
        name(vec![(&mut first, 9), (&mut second, 2)], "");
        assert_eq!((first[0].as_str(), second[1].as_str()), ("01", "11"));
    }
}
