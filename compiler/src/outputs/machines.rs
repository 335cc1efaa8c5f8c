//! Machines of the library's records: from values of the language to checked figures of the workshop.

use crate::analysis::{field, number, text};
use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::machine::{
    Clamp, CutDirection, Dialect, Fixing, Machine, MachineError, MachineSpec, Tool, WorkOffset, ZZero,
};
use crate::hir::tree::Hir;
use crate::hir::value::Value;
use crate::source::Span;
use glam::{DVec2, DVec3};

/// The machine of a record of the type `Machine`, first with its own cutter, then with each of its spare ones that can
/// take the place; `fixing` is a record of the type `Fixing` that takes precedence, with its place.
///
/// # Errors
/// E0804: figures that are out of range, at the setting they come from.
pub(super) fn machines(
    hir: &Hir,
    machine: &Value,
    span: Span,
    fixing: Option<(&Value, Span)>,
) -> Result<Vec<Machine>, Diagnostic> {
    let incomplete =
        || Diagnostic::new(Code::E0804, span, "this machine is not complete").label("a field is missing");
    let refused = |error: MachineError| {
        let message = format!("this machine cannot work: {error}");
        Diagnostic::new(Code::E0804, span, message).label("this machine")
    };
    let code = number(hir, machine, "work_offset").ok_or_else(incomplete)?;
    let work_offset = work_offset(code).map_err(refused)?;
    let spec = spec(hir, machine, work_offset).ok_or_else(incomplete)?;
    let own = read_fixing(hir, field(hir, machine, "fixing").ok_or_else(incomplete)?);
    let fixing_refused = |why: String, span: Span| {
        let message = format!("this cannot hold a board: {why}");
        let diagnostic = Diagnostic::new(Code::E0804, span, message).label("cannot be used");
        diagnostic.hint("write `tabs(count: 4)`, `onion_skin(0.4mm)` or `vacuum()`")
    };
    let own = own.map_err(|why| fixing_refused(why.to_owned(), span))?;
    let spec = MachineSpec { fixing: own, ..spec };
    let mut made = Machine::try_new(spec).map_err(refused)?;
    if let Some((value, span)) = fixing {
        let fixing = read_fixing(hir, value).map_err(|why| fixing_refused(why.to_owned(), span))?;
        made = made.with_fixing(fixing).map_err(|error| fixing_refused(error.to_string(), span))?;
    }
    let mut out = vec![made];
    if let Some(Value::List(spares)) = field(hir, machine, "spare_cutters") {
        for spare in spares.iter() {
            let spare = tool(hir, spare).ok_or_else(incomplete)?;
            let number = spare.number;
            let mut spec = out[0].spec().clone();
            spec.tools.push(spare);
            spec.cutter = number;
            out.push(Machine::try_new(spec).map_err(refused)?);
        }
    }
    Ok(out)
}

fn work_offset(code: f64) -> Result<WorkOffset, MachineError> {
    WorkOffset::from_code(code.clamp(0.0, 255.0) as u8).ok_or_else(|| MachineError::OutOfRange {
        what: "work offset".to_owned(),
        value: code,
        range: "from 54 to 59".to_owned(),
    })
}

fn spec(hir: &Hir, value: &Value, work_offset: WorkOffset) -> Option<MachineSpec> {
    let get = |name: &str| number(hir, value, name);
    let tool = |name: &str| field(hir, value, name).and_then(|value| tool(hir, value));
    let word = |name: &str| match field(hir, value, name)? {
        Value::Choice(_, place) => Some(*place),
        _ => None,
    };
    let (cutter, engraver) = (tool("cutter")?, tool("engraver")?);
    let numbers = (cutter.number, engraver.number);
    // One tool for both is given twice, and is one.
    let tools = if cutter == engraver { vec![cutter] } else { vec![cutter, engraver] };
    let Value::List(clamps) = field(hir, value, "clamps")? else { return None };
    Some(MachineSpec {
        name: text(hir, value, "name")?,
        envelope: DVec3::new(get("length")?, get("width")?, get("height")?),
        safe_height: get("safe_height")?,
        z_zero: *[ZZero::TopOfStock, ZZero::Table].get(word("z_zero")?)?,
        work_offset,
        stock_margin: get("margin")?,
        cut_through: get("cut_through")?,
        engrave_depth: get("engrave_depth")?,
        spindle_range: (get("least_spindle")?, get("most_spindle")?),
        spin_up: get("spin_up")?,
        direction: *[CutDirection::Climb, CutDirection::Conventional].get(word("direction")?)?,
        allowance: get("allowance")?,
        fixing: Fixing::Held,
        clamps: clamps.iter().map(|clamp| read_clamp(hir, clamp)).collect::<Option<Vec<Clamp>>>()?,
        dialect: *Dialect::ALL.get(word("dialect")?)?,
        cutter: numbers.0,
        engraver: numbers.1,
        tools,
    })
}

fn read_clamp(hir: &Hir, value: &Value) -> Option<Clamp> {
    let get = |name: &str| number(hir, value, name);
    let low = DVec2::new(get("x")?, get("y")?);
    Some(Clamp { low, high: low + DVec2::new(get("length")?, get("width")?), height: get("height")? })
}

fn read_fixing(hir: &Hir, value: &Value) -> Result<Fixing, &'static str> {
    let get = |name: &str| number(hir, value, name).ok_or("a field is missing");
    let (count, skin) = (get("tabs")?, get("skin")?);
    match (count != 0.0, skin != 0.0) {
        (true, true) => Err("tabs and an onion skin are asked for at once"),
        (true, false) if count < 0.0 => Err("the count of tabs is negative"),
        (true, false) => {
            Ok(Fixing::Tabs { count: count as u32, width: get("width")?, height: get("height")? })
        }
        (false, true) => Ok(Fixing::OnionSkin { thickness: skin }),
        (false, false) => Ok(Fixing::Held),
    }
}

fn tool(hir: &Hir, value: &Value) -> Option<Tool> {
    let get = |name: &str| number(hir, value, name);
    Some(Tool {
        number: get("number")? as u32,
        name: text(hir, value, "name")?,
        diameter: get("diameter")?,
        flute_length: get("flute")?,
        feed: get("feed")?,
        plunge: get("plunge")?,
        spindle: get("spindle")?,
        max_step_down: get("step_down")?,
    })
}
