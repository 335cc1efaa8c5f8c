//! `nest`: the raw boards and bars that elements are cut from together, and which elements are too large for them. Where
//! they lie is worked out when outputs are made.

use super::super::settings::{self, SettingValue, choice, number};
use super::{Elements, Nest, PanelsMade, PlanksMade, Programs, Work};
use crate::diagnostic::{Code, Diagnostic, Fix};
use crate::fabricate::label::Label;
use crate::fabricate::panel::{Grain, Panel};
use crate::fabricate::plank::Plank;
use crate::hir::value::Value;
use crate::nest::bars::{self, Stock};
use crate::nest::sheets::{self, Part, Sheet};
use crate::source::Span;

/// Least distances where neither the design nor its machine says one, mm.
const GAP: f64 = 10.0;
const MARGIN: f64 = 10.0;

/// What is left beyond the cutter where the design does not say the gap, mm.
const SPACING: f64 = 2.0;

/// What mitres and cuts may take of a bar beside the length of a plank, mm.
const TRIMMED: f64 = 200.0;

/// What a saw blade takes where the design does not say it, mm.
const KERF: f64 = 4.0;

/// The setting that is no length.
const PROGRAMS: &str = "programs";

/// A board as it is nested.
pub(crate) fn nested_panel(panel: &Panel, grain: Grain) -> Part {
    Part { outline: panel.outline.clone(), any_quarter: grain == Grain::Free }
}

/// A plank as it is nested.
pub(crate) fn nested_plank(plank: &Plank) -> bars::Plank {
    bars::Plank { length: plank.length, mitres: plank.mitres, bevels: plank.bevels }
}

impl Work<'_> {
    /// What the block asks for, `Some(None)` where it asks for nothing; `None` after a report.
    pub(super) fn nest(&mut self, elements: &Elements) -> Option<Option<Nest>> {
        let Some((_, Value::Settings(given), span)) = self.setting("nest").cloned() else {
            return Some(None);
        };
        let lengths = given.iter().filter(|(name, _, _)| *name != PROGRAMS);
        for (name, value, place) in lengths {
            let value = value.number().unwrap_or(f64::NAN);
            if !(value >= 0.0 && value.is_finite()) {
                let why = format!("`{name}` is 0mm or more, but here it is {value}mm");
                self.diagnostics.push(Diagnostic::new(Code::E0804, *place, why).label("cannot be used"));
                return None;
            }
        }
        let nest = match elements {
            Elements::Panels(made) => Nest::Sheets(self.sheets(made, &given, span)?, programs(&given)),
            Elements::Planks(made) => Nest::Bars(self.bars(made, &given, span)?),
        };
        Some(Some(nest))
    }

    fn sheets(&mut self, made: &PanelsMade, given: &[SettingValue], span: Span) -> Option<Sheet> {
        let tool = self.tool();
        let asked = |name: &str| find(given, name);
        let gap = asked("gap").map_or(tool.as_ref().map_or(GAP, |tool| tool.gap() + SPACING), |(gap, _)| gap);
        let margin = asked("margin").map_or(tool.as_ref().map_or(MARGIN, Tool::margin), |(margin, _)| margin);
        let (length, width) = made.settings.board;
        let sheet = Sheet { length, width, margin, gap };
        if sheet.room().min_element() <= 0.0 {
            let place = asked("margin").map_or(span, |(_, place)| place);
            let message = format!(
                "margins of {margin}mm leave nothing of a board of {length}mm by {width}mm: they need less than {}mm",
                length.min(width) / 2.0
            );
            let diagnostic = Diagnostic::new(Code::E0930, place, message).label("no room is left");
            let fixes = match asked("margin") {
                Some((_, place)) if MARGIN < length.min(width) / 2.0 => {
                    let title = format!("set `margin` to {MARGIN}mm instead of {margin}mm");
                    vec![Fix::titled(title).with(place, format!("{MARGIN}mm"))]
                }
                _ => Vec::new(),
            };
            self.diagnostics.push(diagnostic.ways("use a smaller `margin` or a larger `board`", fixes));
            return None;
        }
        if let Some(tool) = tool {
            self.room_for(&tool, &sheet, given, span)?;
        }
        let named = made.panels.iter().filter_map(|panel| {
            let reason = sheets::too_large(&nested_panel(panel, made.settings.grain), &sheet)?;
            Some((&panel.label, reason.to_string()))
        });
        let hint = "use a larger `board`, a smaller `margin`, or a higher level: the boards get smaller";
        self.too_large(&named.collect::<Vec<_>>(), "sheet", span, hint);
        Some(sheet)
    }

    /// Whether the cutter passes between boards and stays on the raw board.
    fn room_for(&mut self, tool: &Tool, sheet: &Sheet, given: &[SettingValue], span: Span) -> Option<()> {
        let needs = [
            (
                "gap",
                sheet.gap,
                tool.gap(),
                "the cutter passes between boards once, and leaves its `allowance` at first",
            ),
            (
                "margin",
                sheet.margin,
                tool.margin(),
                "the machine keeps its own margin around what the cutter sweeps",
            ),
        ];
        for (name, value, least, why) in needs {
            if value >= least {
                continue;
            }
            let place = find(given, name).map_or(span, |(_, place)| place);
            let message = format!(
                "a {name} of {value}mm is too small for a cutter of {}mm: it takes {least}mm",
                tool.diameter
            );
            let diagnostic = Diagnostic::new(Code::E0931, place, message).label("too small").note(why);
            let fixes = find(given, name).map(|(_, place)| {
                let title = format!("set `{name}` to {least}mm instead of {value}mm");
                Fix::titled(title).with(place, format!("{least}mm"))
            });
            let hint = format!("write `{name}: {least}mm`, or leave `{name}` out");
            self.diagnostics.push(diagnostic.ways(hint, fixes.into_iter().collect()));
            return None;
        }
        Some(())
    }

    fn bars(&mut self, made: &PlanksMade, given: &[SettingValue], span: Span) -> Option<Stock> {
        let Some((_, length, _)) = self.setting("stock") else {
            let message = "planks are nested on bars, but the block does not say how long a bar is";
            let diagnostic = Diagnostic::new(Code::E0933, span, message).label("on bars of which length?");
            // Whole metres that the longest plank can be cut from, and what trade sells at least.
            let longest = made.planks.iter().map(|made| made.length).fold(0.0, f64::max);
            let metres = ((longest + TRIMMED) / 1000.0).ceil().max(4.0);
            let block = self.block.settings.iter().find(|setting| setting.name == "nest");
            let fixes = block.map(|setting| {
                Fix::titled(format!("add `stock: {metres}m`: the longest plank is {}mm", longest.ceil()))
                    .with(before(setting.name_span), format!("stock: {metres}m\n    "))
            });
            let hint = "add the length of a raw bar: `stock: 4m`";
            self.diagnostics.push(diagnostic.ways(hint, fixes.into_iter().collect()));
            return None;
        };
        let length = length.number().unwrap_or(0.0);
        let value = |name: &str, default: f64| find(given, name).map_or(default, |(value, _)| value);
        let (kerf, trim) = (value("kerf", KERF), value("trim", 0.0));
        let (depth, width) = (made.settings.depth, made.settings.width);
        let stock = Stock { length, depth, width, kerf, trim };
        if length - 2.0 * trim <= 0.0 {
            let place = find(given, "trim").map_or(span, |(_, place)| place);
            let message = format!(
                "a trim of {trim}mm at each end leaves nothing of a bar of {length}mm: it needs less than {}mm",
                length / 2.0
            );
            let diagnostic = Diagnostic::new(Code::E0930, place, message).label("no room is left");
            let title = format!("set `trim` to 0mm instead of {trim}mm");
            let fixes = find(given, "trim").map(|(_, place)| Fix::titled(title).with(place, "0mm"));
            let hint = "use a smaller `trim` or longer `stock`";
            self.diagnostics.push(diagnostic.ways(hint, fixes.into_iter().collect()));
            return None;
        }
        let named = made.planks.iter().filter_map(|made| {
            let reason = bars::too_long(&nested_plank(made), &stock)?;
            Some((&made.label, reason.to_string()))
        });
        let hint = "use longer `stock`, a smaller `trim`, or a higher level: the planks get shorter";
        self.too_large(&named.collect::<Vec<_>>(), "bar", span, hint);
        Some(stock)
    }

    fn too_large(&mut self, named: &[(&Label, String)], on: &str, span: Span, hint: &str) {
        let Some((label, reason)) = named.first() else { return };
        let message = format!("{} ({}) lies on no {on}: {reason}", label.alias, label.address);
        let mut diagnostic = Diagnostic::new(Code::W0932, span, message).label("nested here");
        if named.len() > 1 {
            let others: Vec<&str> =
                named[1..].iter().take(5).map(|(label, _)| label.alias.as_str()).collect();
            let more = if named.len() > 6 { ", …" } else { "" };
            diagnostic =
                diagnostic.note(format!("and {} more: {}{more}", named.len() - 1, others.join(", ")));
        }
        self.diagnostics.push(diagnostic.hint(hint));
    }

    /// The tool of the block's machine.
    fn tool(&self) -> Option<Tool> {
        let (_, machine, _) = self.setting("machine")?;
        let cutter = settings::field(self.hir, machine, "cutter")?;
        let stock_margin = number(self.hir, machine, "margin")?;
        let allowance = number(self.hir, machine, "allowance")?;
        Some(Tool { diameter: number(self.hir, cutter, "diameter")?, stock_margin, allowance })
    }
}

/// What the machine needs around a board, mm.
struct Tool {
    diameter: f64,
    stock_margin: f64,
    allowance: f64,
}

impl Tool {
    /// Between boards.
    fn gap(&self) -> f64 {
        self.diameter + self.allowance
    }

    /// From a board to the edge of its sheet.
    fn margin(&self) -> f64 {
        self.diameter + self.allowance + self.stock_margin
    }
}

/// What of the boards gets a program.
fn programs(given: &[SettingValue]) -> Programs {
    match choice(given.iter().find(|(name, _, _)| *name == PROGRAMS)) {
        Some(1) => Programs::Boards,
        Some(2) => Programs::Sheets,
        _ => Programs::Both,
    }
}

/// Where something can be put before a name.
fn before(name: Span) -> Span {
    Span::new(name.file, name.start, name.start)
}

fn find(given: &[SettingValue], name: &str) -> Option<(f64, Span)> {
    let (_, value, place) = given.iter().find(|(known, _, _)| *known == name)?;
    Some((value.number()?, *place))
}
