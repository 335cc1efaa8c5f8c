//! The design as it would be with a name where the cursor is: what a place would like is known of whole texts only. The
//! compiler reads it; nothing is guessed here.

use ifs_compiler::analysis::{Analysis, read_indexed};
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::{FileId, MemoryFiles, Span};

/// The name that stands for what will be written.
const NAME: &str = "name_to_be_written";

/// A design read anew, and where the name was put.
pub(crate) struct Supplemented {
    pub(crate) analysis: Analysis,
    pub(crate) name: Span,
}

/// The design with a name in place of what stands at `span` of the file, and `closing` behind it.
pub(crate) fn supplemented(analysis: &Analysis, span: Span, closing: &str) -> Option<Supplemented> {
    let mut files = MemoryFiles::default();
    for mesh in &analysis.meshes {
        files = files.with(&mesh.path, mesh.bytes.clone());
    }
    for file in &analysis.files {
        let text = &analysis.sources.get(file.file)?.text;
        let text = if file.file == span.file {
            let (before, after) = (text.get(..span.start as usize)?, text.get(span.end as usize..)?);
            format!("{before}{NAME}{closing}{after}")
        } else {
            text.clone()
        };
        files = files.with(&file.path, text);
    }
    let root = analysis.files.first()?;
    let read = read_indexed(&files, &root.path, &Overrides::default());
    let path = &analysis.sources.get(span.file)?.path;
    let file: FileId = read.files.iter().find(|file| file.path == *path)?.file;
    let name = Span::new(file, span.start, span.start + NAME.len() as u32);
    Some(Supplemented { analysis: read, name })
}
