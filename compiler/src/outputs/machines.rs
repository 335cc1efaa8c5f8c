//! Machines of the library's records: from values of the language to checked figures of the workshop.

use crate::analysis::{field, number, text};
use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::machine::{
    Clamp, CutDirection, Dialect, FigureUnit, Fixing, Machine, MachineError, MachineSpec, Tool, WorkOffset,
    ZZero,
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
    let code = number(hir, machine, "work_offset").ok_or_else(incomplete)?;
    let work_offset = WorkOffset::from_code(code.clamp(0.0, 255.0) as u8);
    let spec = spec(hir, machine, work_offset.unwrap_or(WorkOffset::G54)).ok_or_else(incomplete)?;
    let own = read_fixing(hir, field(hir, machine, "fixing").ok_or_else(incomplete)?);
    let fixing_refused = |why: String, span: Span| {
        let message = format!("this cannot hold a board: {why}");
        let diagnostic = Diagnostic::new(Code::E0804, span, message).label("cannot be used");
        diagnostic.hint("write `tabs(count: 4)`, `onion_skin(0.4mm)` or `vacuum()`")
    };
    let own = own.map_err(|why| fixing_refused(why.to_owned(), span))?;
    let mut specs = vec![MachineSpec { fixing: own, ..spec }];
    if let Some(Value::List(spares)) = field(hir, machine, "spare_cutters") {
        for spare in spares.iter() {
            let spare = tool(hir, spare).ok_or_else(incomplete)?;
            let mut spec = specs[0].clone();
            spec.cutter = spare.number;
            spec.tools.push(spare);
            specs.push(spec);
        }
    }
    let range = MachineError::OutOfRange {
        what: "work offset".to_owned(),
        value: code,
        range: (54.0, 59.0),
        unit: FigureUnit::Plain,
    };
    let of_tools = specs.iter().flat_map(MachineSpec::faults);
    let mut faults: Vec<MachineError> = Vec::new();
    for fault in work_offset.is_none().then_some(range).into_iter().chain(of_tools) {
        // Those of the machine itself are those with each of its cutters.
        if !faults.contains(&fault) {
            faults.push(fault);
        }
    }
    if let [first, others @ ..] = &faults[..] {
        let message = format!("this machine cannot work: {first}");
        let diagnostic = Diagnostic::new(Code::E0804, span, message).label("this machine");
        return Err(others.iter().fold(diagnostic, |told, fault| told.note(fault.to_string())));
    }
    let fixing = match fixing {
        Some((value, span)) => {
            Some((read_fixing(hir, value).map_err(|why| fixing_refused(why.to_owned(), span))?, span))
        }
        None => None,
    };
    let (held, place) = fixing.unwrap_or((own, span));
    let made = specs.into_iter().map(|spec| Machine::try_new(MachineSpec { fixing: held, ..spec }));
    made.collect::<Result<Vec<Machine>, _>>().map_err(|faults| fixing_refused(faults.to_string(), place))
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
