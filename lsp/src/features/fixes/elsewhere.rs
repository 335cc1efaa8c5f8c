//! A name that a `use` takes from a module that does not have it, where the library has it elsewhere.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Fix};
use ifs_compiler::syntax::ast::ItemKind;

use super::dropped;
use crate::features::completion::to_import;
use crate::features::words::written;

/// The name taken from the module that has it; out of the `use` where every file knows it.
pub(super) fn imported(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let name = written(analysis, found.span);
    let Some((whole, import)) = dropped::import_of(analysis, found.span) else { return Vec::new() };
    let library = analysis.index.modules.iter().filter(|module| module.library);
    let has = library.filter(|module| module.public.iter().any(|public| public.name == name));
    let module = has.max_by_key(|module| module.is_prelude());
    let Some(module) = module else { return Vec::new() };
    let taken = analysis.files.iter().flat_map(|file| &file.parse.ast.items).any(|item| match &item.kind {
        ItemKind::Use(other) => {
            let names = || other.names.iter().any(|other| other.text == name);
            item.span.file == whole.file && other.module.written() == module.title && names()
        }
        _ => false,
    });
    if module.is_prelude() || taken {
        return dropped::import(analysis, found);
    }
    let title = format!("import `{name}` from `{}` instead", module.title);
    if import.names.len() == 1 {
        let other = import.module.span();
        let known = to_import(analysis, whole.file, &module.title, name);
        // Beside what is imported from there already.
        return match known.filter(|(_, text)| text.starts_with(',')) {
            Some((at, text)) => vec![Fix::titled(title).with(whole, "").with(at, text)],
            None => vec![Fix::titled(title).with(other, &module.title)],
        };
    }
    let Some((at, text)) = to_import(analysis, whole.file, &module.title, name) else { return Vec::new() };
    let dropped = dropped::import(analysis, found).into_iter().flat_map(|fix| fix.edits);
    let fix = Fix::titled(title).with(at, text);
    vec![dropped.fold(fix, |fix, edit| fix.with(edit.span, edit.replacement))]
}
