//! A name that is not known here but declared in another file of the project: the `use` that brings it. What the files of
//! the project declare is the caller's to find.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Code, Diagnostic, Edit};
use ifs_compiler::hir::index::Target;
use ifs_compiler::source::FileId;

use super::Mend;
use crate::features::completion::{relative, to_import};
use crate::features::words::written;

/// What a diagnostic lacks: a name of a value or a type.
pub(crate) fn missing<'a>(analysis: &'a Analysis, found: &Diagnostic) -> Option<&'a str> {
    let is_unknown = matches!(found.code, Code::E0301 | Code::E0409);
    let name = written(analysis, found.span);
    let is_name = !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    (is_unknown && is_name).then_some(name)
}

/// The change by which a file knows a name that another file of the project offers; paths are those from its root.
pub(crate) fn imported(analysis: &Analysis, file: FileId, name: &str, from: &str) -> Option<Mend> {
    let own = analysis.sources.get(file)?;
    let known = analysis.index.references.iter().find(|used| match used.target {
        Target::Module(module) => used.span.file == file && path(analysis, module) == from,
        _ => false,
    });
    let module = match known {
        Some(used) => written(analysis, used.span).to_owned(),
        None => format!("\"{}\"", relative(&own.path, from)),
    };
    let (span, replacement) = to_import(analysis, file, &module, name)?;
    let replacement = if own.text.contains("\r\n") { replacement.replace('\n', "\r\n") } else { replacement };
    let title = format!("import `{name}`: `use {module} ({name})`");
    Some(Mend { title, edits: vec![Edit { span, replacement }], preferred: false, safe: false })
}

fn path(analysis: &Analysis, file: FileId) -> &str {
    analysis.sources.get(file).map_or("", |source| source.path.as_str())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::features::fixture::with_files;

    #[test]
    fn beside_what_is_imported_already_or_on_a_line_of_its_own() {
        let ribs = ("parts/ribs.ifs", "pub let rib = 3m\npub let purlin = 2m\n");
        let after = |text: &str| {
            let design = with_files(text, &[ribs]);
            let root = design.analysis.root;
            let found = design.analysis.diagnostics.iter().find_map(|found| missing(&design.analysis, found));
            let mend = imported(&design.analysis, root, found.unwrap(), "parts/ribs.ifs").unwrap();
            let mut text = design.analysis.sources.get(root).unwrap().text.clone();
            for edit in mend.edits.iter().rev() {
                text.replace_range(edit.span.range(), &edit.replacement);
            }
            assert!(!with_files(&text, &[ribs]).analysis.has_errors(), "{text}");
            text
        };
        assert_eq!(
            after("use \"parts/ribs.ifs\" (rib)\nlet a = rib + purlin\n"),
            "use \"parts/ribs.ifs\" (rib, purlin)\nlet a = rib + purlin\n"
        );
        assert_eq!(
            after("use std.curves (bezier2)\r\nlet a = purlin\r\n"),
            "use std.curves (bezier2)\r\nuse \"./parts/ribs.ifs\" (purlin)\r\nlet a = purlin\r\n"
        );
        assert_eq!(after("let a = purlin\n"), "use \"./parts/ribs.ifs\" (purlin)\n\nlet a = purlin\n");
    }
}
