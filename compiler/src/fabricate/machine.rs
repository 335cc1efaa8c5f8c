//! A three-axis machine as toolpaths see it: travel, heights, spindle, tools. Plain data that is checked once when
//! built. No toolpath and no NC text is made here.
//!
//! Inside: millimetres, seconds, feeds in mm/s, spindle speeds in revolutions per second. Only the written program
//! speaks of mm/min and rpm.

mod dialect;
mod faults;
mod fixing;
#[cfg(test)]
pub(crate) mod tests;

pub use dialect::{CommentRule, Dialect, DwellUnit, LAST_PROGRAM_NUMBER, LengthOffset, Profile};
pub use faults::{FigureUnit, MachineError, MachineErrors};
pub use fixing::{Clamp, Fixing};

use faults::Faults;
use glam::DVec3;

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

/// Greatest length in any program, mm: keeps every number short and exact to the third decimal.
pub const MAX_LENGTH: f64 = 100_000.0;

/// Greatest speed of any spindle, rev/s.
const MAX_SPINDLE: f64 = 10_000.0;

impl MachineSpec {
    /// Every figure that is out of range, repeated tool numbers, and a cutter or an engraver that is not there. What
    /// depends on a figure that is wrong itself is left aside.
    #[must_use]
    pub fn faults(&self) -> Vec<MachineError> {
        let mut faults = Faults::default();
        for (what, value, least) in [
            ("length (along X)", self.envelope.x, 1.0),
            ("width (along Y)", self.envelope.y, 1.0),
            ("height (along Z)", self.envelope.z, 1.0),
            ("stock margin", self.stock_margin, 0.0),
            ("cut-through", self.cut_through, 0.0),
        ] {
            faults.length(what, value, least, MAX_LENGTH);
        }
        let safe = faults.length("safe height", self.safe_height, 1.0, MAX_LENGTH);
        faults.within("spin-up time", self.spin_up, (0.0, 600.0), FigureUnit::Seconds);
        let (slow, fast) = self.spindle_range;
        let spindle = FigureUnit::RevolutionsPerMinute;
        let speeds = faults.within("least spindle speed", slow, (0.1, MAX_SPINDLE), spindle)
            && faults.within("greatest spindle speed", fast, (slow, MAX_SPINDLE), spindle);
        let range = if speeds { self.spindle_range } else { (0.1, MAX_SPINDLE) };
        let sound: Vec<bool> = self.tools.iter().map(|tool| tool.check(range, &mut faults)).collect();
        for (i, tool) in self.tools.iter().enumerate() {
            if self.tools[..i].iter().any(|other| other.number == tool.number) {
                faults.0.push(MachineError::RepeatedTool(tool.number));
            }
        }
        self.fixing.check(&mut faults);
        if safe {
            self.clamps.iter().for_each(|clamp| clamp.check(self.safe_height, &mut faults));
        }
        let mut find = |number: u32| {
            let place = self.place_of(number);
            let missing = MachineError::MissingTool(number);
            if place.is_none() && !faults.0.contains(&missing) {
                faults.0.push(missing);
            }
            place.filter(|place| sound[*place])
        };
        let (cutter, engraver) = (find(self.cutter), find(self.engraver));
        if let Some(tool) = cutter.map(|place| &self.tools[place]) {
            faults.length("finishing allowance", self.allowance, 0.0, tool.diameter / 2.0);
        }
        let deepest = engraver.map(|place| &self.tools[place]);
        let deepest = deepest.map_or(MAX_LENGTH, |tool| tool.max_step_down.min(tool.flute_length));
        faults.length("engraving depth", self.engrave_depth, 0.05, deepest);
        faults.0
    }

    /// Where the first tool of this number stands.
    fn place_of(&self, number: u32) -> Option<usize> {
        self.tools.iter().position(|tool| tool.number == number)
    }
}

impl Tool {
    /// Whether all of its figures are in their ranges.
    fn check(&self, speeds: (f64, f64), faults: &mut Faults) -> bool {
        let n = self.number;
        let feeds = (0.01, 10_000.0);
        let before = faults.0.len();
        faults.within("tool number", f64::from(n), (1.0, 99_999.0), FigureUnit::Plain);
        faults.length(&format!("diameter of tool {n}"), self.diameter, 0.1, 200.0);
        faults.length(&format!("flute length of tool {n}"), self.flute_length, 0.05, 1000.0);
        faults.within(&format!("feed of tool {n}"), self.feed, feeds, FigureUnit::MetresPerMinute);
        faults.within(&format!("plunge feed of tool {n}"), self.plunge, feeds, FigureUnit::MetresPerMinute);
        faults.length(&format!("step-down of tool {n}"), self.max_step_down, 0.05, 1000.0);
        let what = format!("spindle speed of tool {n}");
        faults.within(&what, self.spindle, speeds, FigureUnit::RevolutionsPerMinute);
        faults.0.len() == before
    }
}

impl Machine {
    /// Checks every figure of `spec`.
    ///
    /// # Errors
    /// All faults, as [`MachineSpec::faults`] gives them.
    pub fn try_new(spec: MachineSpec) -> Result<Machine, MachineErrors> {
        let faults = spec.faults();
        match (spec.place_of(spec.cutter), spec.place_of(spec.engraver)) {
            (Some(cutter), Some(engraver)) if faults.is_empty() => Ok(Machine { spec, cutter, engraver }),
            _ => Err(MachineErrors(faults)),
        }
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
}
