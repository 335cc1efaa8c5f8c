//! The files that `use` and `import` name, as links.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::index::Target;
use ifs_compiler::source::{FileId, Span};

/// Each mesh that a file names and that there is, and its path from the root of the project.
pub(crate) fn meshes(analysis: &Analysis, file: FileId) -> &[(Span, String)] {
    analysis.files.iter().find(|known| known.file == file).map_or(&[], |known| &known.meshes)
}

/// Each name of a module in a file, and the file it leads to.
pub(crate) fn links(analysis: &Analysis, file: FileId) -> Vec<(Span, FileId)> {
    let names = analysis.index.references.iter().filter(|reference| reference.span.file == file);
    names
        .filter_map(|reference| match reference.target {
            Target::Module(to) => Some((reference.span, to)),
            _ => None,
        })
        .collect()
}
