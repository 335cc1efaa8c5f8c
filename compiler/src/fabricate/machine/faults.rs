//! What is wrong with the figures of a machine: every fault of it, in the units in which machines are described.

use std::fmt;

/// Why a machine cannot be what it says.
#[derive(Clone, Debug, PartialEq)]
pub enum MachineError {
    /// A figure is not a finite number in its range.
    OutOfRange {
        /// What it is a figure of, as users call it.
        what: String,
        /// The figure found, in inner units.
        value: f64,
        /// The least and the greatest it may be, in inner units.
        range: (f64, f64),
        /// What it counts.
        unit: FigureUnit,
    },
    /// Two tools have this number.
    RepeatedTool(u32),
    /// The cutter or the engraver is not among the tools.
    MissingTool(u32),
}

/// The unit that a figure of a machine is told in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FigureUnit {
    /// No unit: counts and numbers.
    Plain,
    /// mm, as inside.
    Millimetres,
    /// s, as inside.
    Seconds,
    /// m/min; mm/s inside.
    MetresPerMinute,
    /// rpm; revolutions per second inside.
    RevolutionsPerMinute,
}

impl FigureUnit {
    /// Its suffix in the language and how many inner units it is worth.
    fn suffix(self) -> (&'static str, f64) {
        match self {
            FigureUnit::Plain => ("", 1.0),
            FigureUnit::Millimetres => ("mm", 1.0),
            FigureUnit::Seconds => ("s", 1.0),
            FigureUnit::MetresPerMinute => ("m/min", 1000.0 / 60.0),
            FigureUnit::RevolutionsPerMinute => ("rpm", 1.0 / 60.0),
        }
    }

    /// A figure in words: at most four decimals, none that are 0.
    fn words(self, value: f64) -> String {
        let (suffix, worth) = self.suffix();
        let digits = format!("{:.4}", value / worth);
        let digits = match digits.trim_end_matches('0').trim_end_matches('.') {
            short if digits.contains('.') => short,
            _ => &digits,
        };
        format!("{}{suffix}", if digits == "-0" { "0" } else { digits })
    }
}

impl fmt::Display for MachineError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MachineError::OutOfRange { what, value, range: (least, greatest), unit } => {
                let [value, least, greatest] = [*value, *least, *greatest].map(|figure| unit.words(figure));
                write!(f, "{what} is {value}, must be from {least} to {greatest}")
            }
            MachineError::RepeatedTool(n) => write!(f, "tool number {n} is given twice"),
            MachineError::MissingTool(n) => write!(f, "tool number {n} is not among the machine's tools"),
        }
    }
}

/// All faults of a machine, at least one.
#[derive(Clone, Debug, PartialEq)]
pub struct MachineErrors(pub Vec<MachineError>);

impl fmt::Display for MachineErrors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words: Vec<String> = self.0.iter().map(ToString::to_string).collect();
        f.write_str(&words.join("; "))
    }
}

impl std::error::Error for MachineErrors {}

/// Faults as they are found.
#[derive(Default)]
pub(super) struct Faults(pub(super) Vec<MachineError>);

impl Faults {
    /// Whether a figure is finite and in its range; a fault where it is not.
    pub(super) fn within(&mut self, what: &str, value: f64, range: (f64, f64), unit: FigureUnit) -> bool {
        let good = value.is_finite() && (range.0..=range.1).contains(&value);
        if !good {
            self.0.push(MachineError::OutOfRange { what: what.to_owned(), value, range, unit });
        }
        good
    }

    /// The same for a length in mm.
    pub(super) fn length(&mut self, what: &str, value: f64, least: f64, greatest: f64) -> bool {
        self.within(what, value, (least, greatest), FigureUnit::Millimetres)
    }
}
