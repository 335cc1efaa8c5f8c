//! The machine of a fabrication as `report.json` says it: all figures that its programs follow from. Speeds mm/min and
//! revolutions a minute, as machines have them. Reading them again is `verify`'s.

use serde::Serialize;

use super::Fixed;
use crate::fabricate::machine::{Clamp, CutDirection, Fixing, Machine, Tool, ZZero};

/// Decimals of a machine's figures: tools are also sold in inches.
const DECIMALS: usize = 6;

/// A machine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MachineReport {
    /// What people call it.
    pub name: String,
    /// The dialect of its programs: `linuxcnc`, `grbl` or `fanuc`.
    pub dialect: &'static str,
    /// Where the program's Z = 0 lies: `top of stock` or `table`.
    pub z_zero: &'static str,
    /// The work coordinate system, 54 to 59.
    pub work_offset: u8,
    /// Travel in x, y and z.
    pub envelope_mm: [Fixed; 3],
    /// Height above the stock at which tools may travel freely.
    pub safe_height_mm: Fixed,
    /// Stock left around the swept region of a board alone.
    pub stock_margin_mm: Fixed,
    /// How far the contour goes below the stock.
    pub cut_through_mm: Fixed,
    /// Stock that passes leave for a last pass to take.
    pub allowance_mm: Fixed,
    /// `climb` or `conventional`.
    pub direction: &'static str,
    /// Least and greatest spindle speed.
    pub spindle_rpm: [Fixed; 2],
    /// Time the spindle needs to reach its speed.
    pub spin_up_s: Fixed,
    /// What holds a board.
    pub fixing: FixingReport,
    /// Where no tool may go.
    pub clamps: Vec<ClampReport>,
    /// The magazine.
    pub tools: Vec<ToolReport>,
    /// The number of the tool that cuts, then those that may take its place where it is refused.
    pub cutters: Vec<u32>,
    /// How addresses are engraved.
    pub engraving: EngravingReport,
}

/// What holds a board while it is cut.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum FixingReport {
    /// The table.
    Held,
    /// Bridges.
    Tabs {
        /// How many.
        count: u32,
        /// How wide at the part.
        width_mm: Fixed,
        /// How high over the stock's lower face.
        height_mm: Fixed,
    },
    /// A layer under the contour.
    OnionSkin {
        /// How thick it is.
        thickness_mm: Fixed,
    },
}

/// A box that no tool may touch.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ClampReport {
    /// Its least x and y in programs.
    pub low_mm: [Fixed; 2],
    /// Its greatest x and y.
    pub high_mm: [Fixed; 2],
    /// Its height over the stock.
    pub height_mm: Fixed,
}

/// A tool.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ToolReport {
    /// Its number in the magazine.
    pub number: u32,
    /// What people call it.
    pub name: String,
    /// How wide it cuts.
    pub diameter_mm: Fixed,
    /// How deep it can cut.
    pub flute_mm: Fixed,
    /// The greatest feed along the path.
    pub feed_mm_min: Fixed,
    /// The greatest speed downwards in material.
    pub plunge_mm_min: Fixed,
    /// Its speed.
    pub spindle_rpm: Fixed,
    /// The greatest depth of one pass.
    pub step_down_mm: Fixed,
}

/// How addresses are engraved.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EngravingReport {
    /// The number of the tool.
    pub tool: u32,
    /// How deep.
    pub depth_mm: Fixed,
    /// The height of capitals that is asked for.
    pub height_mm: Fixed,
    /// The least height where there is no room for that.
    pub least_height_mm: Fixed,
}

impl MachineReport {
    /// Of a machine and the same one with its spare cutters, and of the height and least height of engraved capitals, mm.
    /// None where there is no machine.
    #[must_use]
    pub fn of(machines: &[&Machine], (height, least): (f64, f64)) -> Option<Self> {
        let spec = machines.first()?.spec();
        // A spare cutter stands in the magazine of its own machine alone.
        let spares = machines[1..].iter().map(|machine| machine.cutter());
        let tools = spec.tools.iter().chain(spares);
        Some(Self {
            name: spec.name.clone(),
            dialect: spec.dialect.profile().name,
            z_zero: match spec.z_zero {
                ZZero::TopOfStock => "top of stock",
                ZZero::Table => "table",
            },
            work_offset: spec.work_offset.code(),
            envelope_mm: spec.envelope.to_array().map(figure),
            safe_height_mm: figure(spec.safe_height),
            stock_margin_mm: figure(spec.stock_margin),
            cut_through_mm: figure(spec.cut_through),
            allowance_mm: figure(spec.allowance),
            direction: match spec.direction {
                CutDirection::Climb => "climb",
                CutDirection::Conventional => "conventional",
            },
            spindle_rpm: [spec.spindle_range.0, spec.spindle_range.1].map(a_minute),
            spin_up_s: figure(spec.spin_up),
            fixing: fixing(spec.fixing),
            clamps: spec.clamps.iter().map(clamp).collect(),
            tools: tools.map(tool).collect(),
            cutters: machines.iter().map(|machine| machine.cutter().number).collect(),
            engraving: EngravingReport {
                tool: spec.engraver,
                depth_mm: figure(spec.engrave_depth),
                height_mm: figure(height),
                least_height_mm: figure(least),
            },
        })
    }
}

fn figure(value: f64) -> Fixed {
    Fixed { value, decimals: DECIMALS }
}

fn a_minute(a_second: f64) -> Fixed {
    figure(a_second * 60.0)
}

fn fixing(fixing: Fixing) -> FixingReport {
    match fixing {
        Fixing::Held => FixingReport::Held,
        Fixing::Tabs { count, width, height } => {
            FixingReport::Tabs { count, width_mm: figure(width), height_mm: figure(height) }
        }
        Fixing::OnionSkin { thickness } => FixingReport::OnionSkin { thickness_mm: figure(thickness) },
    }
}

fn clamp(clamp: &Clamp) -> ClampReport {
    ClampReport {
        low_mm: clamp.low.to_array().map(figure),
        high_mm: clamp.high.to_array().map(figure),
        height_mm: figure(clamp.height),
    }
}

fn tool(tool: &Tool) -> ToolReport {
    ToolReport {
        number: tool.number,
        name: tool.name.clone(),
        diameter_mm: figure(tool.diameter),
        flute_mm: figure(tool.flute_length),
        feed_mm_min: a_minute(tool.feed),
        plunge_mm_min: a_minute(tool.plunge),
        spindle_rpm: a_minute(tool.spindle),
        step_down_mm: figure(tool.max_step_down),
    }
}
