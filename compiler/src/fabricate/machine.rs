//! A three-axis machine as toolpaths see it: travel, heights, spindle, tools. Plain data that is checked once when
//! built. No toolpath and no NC text is made here.
//!
//! Inside: millimetres, seconds, feeds in mm/s, spindle speeds in revolutions per second. Only the written program
//! speaks of mm/min and rpm.

mod dialect;
mod fixing;
#[cfg(test)]
pub(crate) mod tests;

pub use dialect::{CommentRule, Dialect, DwellUnit, LAST_PROGRAM_NUMBER, LengthOffset, Profile};
pub use fixing::{Clamp, Fixing};

use glam::DVec3;
use std::fmt;

/// Where the program's Z = 0 lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ZZero {
    /// The upper face of the stock; cuts have negative Z.
    TopOfStock,
    /// The table the stock lies on; the upper face is at Z = thickness.
    Table,
}

/// The work coordinate system the program selects: G54 to G59.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WorkOffset(u8);

impl WorkOffset {
    /// The first work coordinate system, G54.
    pub const G54: WorkOffset = WorkOffset(54);

    /// `code` 54 to 59, else `None`.
    #[must_use]
    pub fn from_code(code: u8) -> Option<WorkOffset> {
        (54..=59).contains(&code).then_some(WorkOffset(code))
    }

    /// The number after `G`, 54 to 59.
    #[must_use]
    pub fn code(self) -> u8 {
        self.0
    }
}

/// On which side of the cutter, seen along its motion, the part lies (spindle turning clockwise from above).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CutDirection {
    /// Part on the right: an outer contour runs clockwise. The default of workshops with stiff machines.
    Climb,
    /// Part on the left: an outer contour runs anticlockwise.
    Conventional,
}

/// One tool of the magazine.
#[derive(Clone, Debug, PartialEq)]
pub struct Tool {
    /// Its pocket and offset number, `T` and `H`; at least 1.
    pub number: u32,
    /// What people call it; data, escaped when written.
    pub name: String,
    /// Width of the cut in mm (for an engraver: at the engraving depth).
    pub diameter: f64,
    /// Length that cuts, mm: no cut is deeper.
    pub flute_length: f64,
    /// Greatest feed along the path, mm/s.
    pub feed: f64,
    /// Greatest downward speed in material, mm/s.
    pub plunge: f64,
    /// Spindle speed, rev/s.
    pub spindle: f64,
    /// Greatest depth taken in one pass, mm.
    pub max_step_down: f64,
}

/// What a machine is described by; [`Machine::try_new`] checks it.
#[derive(Clone, Debug, PartialEq)]
pub struct MachineSpec {
    /// What people call it.
    pub name: String,
    /// Travel in x, y, z, mm. X and Y are counted from the lower left of the stock, Z from below the cut-through.
    pub envelope: DVec3,
    /// Height above the stock's upper face at which the tool may travel freely, mm.
    pub safe_height: f64,
    /// Where Z = 0 lies.
    pub z_zero: ZZero,
    /// The work coordinate system. Its X and Y origin is the lower left corner of the stock.
    pub work_offset: WorkOffset,
    /// Stock left around the swept region, mm.
    pub stock_margin: f64,
    /// How far the contour goes below the stock's lower face, mm.
    pub cut_through: f64,
    /// Depth of engraved strokes, mm.
    pub engrave_depth: f64,
    /// Least and greatest spindle speed, rev/s.
    pub spindle_range: (f64, f64),
    /// Time the spindle needs to reach its speed, s.
    pub spin_up: f64,
    /// Climb or conventional.
    pub direction: CutDirection,
    /// Stock that passes leave beside the part for a last pass at full depth to take, mm; none if 0.
    pub allowance: f64,
    /// What holds the part.
    pub fixing: Fixing,
    /// Where no tool may go.
    pub clamps: Vec<Clamp>,
    /// The NC dialect.
    pub dialect: Dialect,
    /// The magazine.
    pub tools: Vec<Tool>,
    /// Number of the tool that cuts contours.
    pub cutter: u32,
    /// Number of the tool that engraves; may be the cutter.
    pub engraver: u32,
}

/// A machine whose figures have been checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Machine {
    spec: MachineSpec,
    cutter: usize,
    engraver: usize,
}

/// Why a machine cannot be what it says.
#[derive(Clone, Debug, PartialEq)]
pub enum MachineError {
    /// A figure is not a finite number in its range; `what` names the field, `range` what it must be.
    OutOfRange {
        /// The field, as users call it.
        what: String,
        /// The figure found.
        value: f64,
        /// What it must be.
        range: String,
    },
    /// Two tools have this number.
    RepeatedTool(u32),
    /// The cutter or the engraver is not among the tools.
    MissingTool(u32),
}

impl fmt::Display for MachineError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MachineError::OutOfRange { what, value, range } => {
                write!(f, "{what} is {value}, must be {range}")
            }
            MachineError::RepeatedTool(n) => write!(f, "tool number {n} is given twice"),
            MachineError::MissingTool(n) => write!(f, "tool number {n} is not among the machine's tools"),
        }
    }
}

impl std::error::Error for MachineError {}

/// Greatest length in any program, mm: keeps every number short and exact to the third decimal.
pub const MAX_LENGTH: f64 = 100_000.0;

impl Machine {
    /// Checks every figure of `spec`.
    ///
    /// # Errors
    /// The first figure that is out of range, a repeated tool number, or a cutter or engraver that is not there.
    pub fn try_new(spec: MachineSpec) -> Result<Machine, MachineError> {
        let length = |what: &str, value: f64, least: f64| within(what, value, least, MAX_LENGTH);
        length("envelope x", spec.envelope.x, 1.0)?;
        length("envelope y", spec.envelope.y, 1.0)?;
        length("envelope z", spec.envelope.z, 1.0)?;
        length("safe height", spec.safe_height, 1.0)?;
        length("stock margin", spec.stock_margin, 0.0)?;
        length("cut-through", spec.cut_through, 0.0)?;
        length("engraving depth", spec.engrave_depth, 0.05)?;
        within("spin-up time", spec.spin_up, 0.0, 600.0)?;
        let (slow, fast) = spec.spindle_range;
        within("least spindle speed", slow, 0.1, 10_000.0)?;
        within("greatest spindle speed", fast, slow, 10_000.0)?;
        for (i, tool) in spec.tools.iter().enumerate() {
            check_tool(tool, spec.spindle_range)?;
            if spec.tools[..i].iter().any(|other| other.number == tool.number) {
                return Err(MachineError::RepeatedTool(tool.number));
            }
        }
        spec.fixing.check()?;
        spec.clamps.iter().try_for_each(|clamp| clamp.check(spec.safe_height))?;
        let find = |number: u32| {
            spec.tools.iter().position(|t| t.number == number).ok_or(MachineError::MissingTool(number))
        };
        let (cutter, engraver) = (find(spec.cutter)?, find(spec.engraver)?);
        within("finishing allowance", spec.allowance, 0.0, spec.tools[cutter].diameter / 2.0)?;
        let tool = &spec.tools[engraver];
        let deepest = tool.max_step_down.min(tool.flute_length);
        within("engraving depth", spec.engrave_depth, 0.05, deepest)?;
        Ok(Machine { spec, cutter, engraver })
    }

    /// All figures.
    #[must_use]
    pub fn spec(&self) -> &MachineSpec {
        &self.spec
    }

    /// The tool that cuts contours.
    #[must_use]
    pub fn cutter(&self) -> &Tool {
        &self.spec.tools[self.cutter]
    }

    /// The tool that engraves.
    #[must_use]
    pub fn engraver(&self) -> &Tool {
        &self.spec.tools[self.engraver]
    }

    /// Program Z of the upper face of a stock of this thickness, mm.
    #[must_use]
    pub fn top(&self, thickness: f64) -> f64 {
        match self.spec.z_zero {
            ZZero::TopOfStock => 0.0,
            ZZero::Table => thickness,
        }
    }

    /// Program Z of the safe height over a stock of this thickness, mm.
    #[must_use]
    pub fn safe_z(&self, thickness: f64) -> f64 {
        self.top(thickness) + self.spec.safe_height
    }

    /// Program Z of the deepest cut in a stock of this thickness, mm: through it, or down to the onion skin.
    #[must_use]
    pub fn bottom(&self, thickness: f64) -> f64 {
        let left = match self.spec.fixing {
            Fixing::OnionSkin { thickness } => thickness,
            Fixing::Held | Fixing::Tabs { .. } => -self.spec.cut_through,
        };
        self.top(thickness) - thickness + left
    }

    /// Program Z of the upper side of tabs in a stock of this thickness, mm, where there are tabs.
    #[must_use]
    pub fn tab_top(&self, thickness: f64) -> Option<f64> {
        match self.spec.fixing {
            Fixing::Tabs { height, .. } => Some(self.top(thickness) - thickness + height),
            Fixing::Held | Fixing::OnionSkin { .. } => None,
        }
    }

    /// How far the outline of a board lies from the edges of a stock that is cut for it alone, mm: the stock margin,
    /// one cutter diameter, and the finishing allowance.
    #[must_use]
    pub fn border(&self) -> f64 {
        self.spec.stock_margin + self.cutter().diameter + self.spec.allowance
    }

    /// The same machine with its parts held otherwise.
    ///
    /// # Errors
    /// Figures of the fixing that are out of range.
    pub fn with_fixing(&self, fixing: Fixing) -> Result<Machine, MachineError> {
        Machine::try_new(MachineSpec { fixing, ..self.spec.clone() })
    }
}

fn check_tool(tool: &Tool, (slow, fast): (f64, f64)) -> Result<(), MachineError> {
    let n = tool.number;
    within(&format!("tool number {n}"), f64::from(n), 1.0, 99_999.0)?;
    within(&format!("diameter of tool {n}"), tool.diameter, 0.1, 200.0)?;
    within(&format!("flute length of tool {n}"), tool.flute_length, 0.05, 1000.0)?;
    within(&format!("feed of tool {n} in mm/s"), tool.feed, 0.01, 10_000.0)?;
    within(&format!("plunge feed of tool {n} in mm/s"), tool.plunge, 0.01, 10_000.0)?;
    within(&format!("step-down of tool {n}"), tool.max_step_down, 0.05, 1000.0)?;
    within(&format!("spindle speed of tool {n} in rev/s"), tool.spindle, slow, fast)
}

fn within(what: &str, value: f64, least: f64, greatest: f64) -> Result<(), MachineError> {
    if value.is_finite() && (least..=greatest).contains(&value) {
        return Ok(());
    }
    let range = format!("from {least} to {greatest}");
    Err(MachineError::OutOfRange { what: what.to_owned(), value, range })
}
