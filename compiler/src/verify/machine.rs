//! The machines of `report.json`: its figures as those that programs are read back with. Whether they can be a machine's
//! is judged by [`Machine::try_new`].

use glam::{DVec2, DVec3};
use serde_json::Value;

use super::report::list;
use crate::fabricate::machine::{
    Clamp, CutDirection, Dialect, Fixing, Machine, MachineSpec, Tool, WorkOffset, ZZero,
};

/// What the programs of a fabrication are made with.
#[derive(Debug, Clone)]
pub(super) struct Workshop {
    /// The machine with each of its cutters: its own first, then those that may take its place.
    pub(super) machines: Vec<Machine>,
    /// The height of engraved capitals that is asked for, mm.
    pub(super) height: f64,
    /// The least one, mm.
    pub(super) least_height: f64,
}

impl Workshop {
    /// Of the record of a machine; none where a figure is missing or cannot be a machine's.
    pub(super) fn of(value: &Value) -> Option<Self> {
        let engraving = value.get("engraving")?;
        let tools: Vec<Tool> = list(value, "tools").iter().map(tool).collect::<Option<_>>()?;
        let cutters: Vec<u32> = list(value, "cutters").iter().map(whole).collect::<Option<_>>()?;
        let (own, engraver) = (*cutters.first()?, whole(engraving.get("tool")?)?);
        let machine = |&cutter: &u32| {
            // Its own machine has its own tools; a spare cutter is added to those.
            let has = |tool: &&Tool| [own, engraver, cutter].contains(&tool.number);
            let tools: Vec<Tool> = tools.iter().filter(has).cloned().collect();
            Machine::try_new(spec(value, engraving, tools, (cutter, engraver))?).ok()
        };
        Some(Self {
            machines: cutters.iter().map(machine).collect::<Option<_>>()?,
            height: number(engraving, "height_mm")?,
            least_height: number(engraving, "least_height_mm")?,
        })
    }

    /// How programs are written.
    pub(super) fn dialect(&self) -> Option<Dialect> {
        self.machines.first().map(|machine| machine.spec().dialect)
    }
}

fn spec(
    value: &Value,
    engraving: &Value,
    tools: Vec<Tool>,
    (cutter, engraver): (u32, u32),
) -> Option<MachineSpec> {
    let [slow, fast] = numbers(value, "spindle_rpm")?;
    Some(MachineSpec {
        name: text(value, "name")?.to_owned(),
        envelope: DVec3::from_array(numbers(value, "envelope_mm")?),
        safe_height: number(value, "safe_height_mm")?,
        z_zero: match text(value, "z_zero")? {
            "top of stock" => ZZero::TopOfStock,
            "table" => ZZero::Table,
            _ => return None,
        },
        work_offset: WorkOffset::from_code(u8::try_from(whole(value.get("work_offset")?)?).ok()?)?,
        stock_margin: number(value, "stock_margin_mm")?,
        cut_through: number(value, "cut_through_mm")?,
        engrave_depth: number(engraving, "depth_mm")?,
        spindle_range: (slow / 60.0, fast / 60.0),
        spin_up: number(value, "spin_up_s")?,
        direction: match text(value, "direction")? {
            "climb" => CutDirection::Climb,
            "conventional" => CutDirection::Conventional,
            _ => return None,
        },
        allowance: number(value, "allowance_mm")?,
        fixing: fixing(value.get("fixing")?)?,
        clamps: list(value, "clamps").iter().map(clamp).collect::<Option<_>>()?,
        dialect: Dialect::named(text(value, "dialect")?)?,
        tools,
        cutter,
        engraver,
    })
}

fn tool(value: &Value) -> Option<Tool> {
    Some(Tool {
        number: whole(value.get("number")?)?,
        name: text(value, "name")?.to_owned(),
        diameter: number(value, "diameter_mm")?,
        flute_length: number(value, "flute_mm")?,
        feed: number(value, "feed_mm_min")? / 60.0,
        plunge: number(value, "plunge_mm_min")? / 60.0,
        spindle: number(value, "spindle_rpm")? / 60.0,
        max_step_down: number(value, "step_down_mm")?,
    })
}

fn fixing(value: &Value) -> Option<Fixing> {
    Some(match text(value, "kind")? {
        "held" => Fixing::Held,
        "tabs" => Fixing::Tabs {
            count: whole(value.get("count")?)?,
            width: number(value, "width_mm")?,
            height: number(value, "height_mm")?,
        },
        "onion_skin" => Fixing::OnionSkin { thickness: number(value, "thickness_mm")? },
        _ => return None,
    })
}

fn clamp(value: &Value) -> Option<Clamp> {
    let [low, high] = ["low_mm", "high_mm"].map(|name| numbers(value, name).map(DVec2::from_array));
    Some(Clamp { low: low?, high: high?, height: number(value, "height_mm")? })
}

fn number(value: &Value, name: &str) -> Option<f64> {
    value.get(name)?.as_f64()
}

fn numbers<const COUNT: usize>(value: &Value, name: &str) -> Option<[f64; COUNT]> {
    let all: Vec<f64> = list(value, name).iter().map(Value::as_f64).collect::<Option<_>>()?;
    all.try_into().ok()
}

fn whole(value: &Value) -> Option<u32> {
    u32::try_from(value.as_u64()?).ok()
}

fn text<'a>(value: &'a Value, name: &str) -> Option<&'a str> {
    value.get(name)?.as_str()
}
