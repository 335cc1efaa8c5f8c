//! The machine that is named from outside of a design, which takes the place of those its fabricate blocks name.

use super::load::problems::why;
use crate::diagnostic::{Code, Diagnostic, did_you_mean};
use crate::hir::evaluate::{Evaluator, MachineName, Overrides};
use crate::hir::tree::{Hir, Item, ItemId, ItemKind};
use crate::hir::value::Value;
use crate::source::{FileId, ReadError, Span};

/// That the file of a machine cannot be read.
pub(super) fn unreadable(machine: &MachineName, error: &ReadError, root: FileId) -> Diagnostic {
    let MachineName { file, whence, .. } = machine;
    let message = format!("`{file}`, which {whence} names for the machine, cannot be read: {}", why(error));
    let hint =
        "the file lies in the project's folder: that of the nearest `ifs.toml`, else that of the design";
    Diagnostic::new(Code::E0860, Span::new(root, 0, 0), message).hint(hint)
}

/// What is wrong with the name of the machine, as far as names tell it.
pub(super) fn name_faults(hir: &Hir, overrides: &Overrides) -> Vec<Diagnostic> {
    let (Some(machine), Some(file)) = (&overrides.machine, hir.machine_file) else { return Vec::new() };
    if item(hir, &machine.name, file).is_some() {
        return Vec::new();
    }
    let MachineName { file: path, name, whence } = machine;
    let message = format!("`{path}` has no `{name}`, which {whence} names for the machine");
    let diagnostic = Diagnostic::new(Code::E0861, Span::new(file, 0, 0), message);
    let known: Vec<&str> = values(hir, file).map(|(_, item)| item.name.as_str()).collect();
    vec![match did_you_mean(name, known.iter().copied()) {
        Some(suggestion) => diagnostic.hint(suggestion),
        None if known.is_empty() => {
            diagnostic.hint(format!("declare it there: `let {name} = router3(tool: 8mm)`"))
        }
        None => diagnostic.note(format!("it has {}", known.join(", "))),
    }]
}

/// The machine's record; `Ok(None)` where none is named, `Err(None)` where what is wrong has been said.
///
/// # Errors
/// E0862: what is named is no machine.
pub(super) fn machine(
    hir: &Hir,
    evaluator: &mut Evaluator<'_>,
    overrides: &Overrides,
) -> Result<Option<Value>, Option<Diagnostic>> {
    let (Some(named), Some(file)) = (&overrides.machine, hir.machine_file) else { return Ok(None) };
    let Some((id, item)) = item(hir, &named.name, file) else { return Err(None) };
    let value = evaluator.global(id).map_err(|_| None)?;
    if is_machine(hir, &value) {
        return Ok(Some(value));
    }
    let MachineName { file: path, name, whence } = named;
    let message = format!("`{name}` of `{path}` is no machine, but {whence} names it for one");
    let diagnostic = Diagnostic::new(Code::E0862, item.name_span, message).label("no machine");
    Err(Some(
        diagnostic
            .hint(format!("a machine is a `Machine` of std.machines: `let {name} = router3(tool: 8mm)`")),
    ))
}

/// The values that a file declares.
fn values(hir: &Hir, file: FileId) -> impl Iterator<Item = (ItemId, &Item)> {
    hir.project_items().filter(move |(_, item)| {
        item.name_span.file == file && matches!(item.kind, ItemKind::Let(..) | ItemKind::Param(_))
    })
}

fn item<'h>(hir: &'h Hir, name: &str, file: FileId) -> Option<(ItemId, &'h Item)> {
    values(hir, file).find(|(_, item)| item.name == name)
}

fn is_machine(hir: &Hir, value: &Value) -> bool {
    let Value::Record(id, _) = value else { return false };
    let record = hir.item(*id);
    record.name == "Machine" && hir.is_library(record.name_span.file)
}
