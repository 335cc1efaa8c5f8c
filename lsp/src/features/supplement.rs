//! The design as it would be with a name where the cursor is: what a place would like is known of whole texts only. The
//! compiler reads it; nothing is guessed here.

use ifs_compiler::analysis::{Analysis, Earlier, read_indexed_again, with_item_changed};
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
    let name = Span::new(span.file, span.start, span.start + NAME.len() as u32);
    match with_item_changed(analysis, span, &format!("{NAME}{closing}")) {
        Some(analysis) => Some(Supplemented { analysis, name }),
        None => read_anew(analysis, span, closing),
    }
}

/// The same with all of the design read again.
fn read_anew(analysis: &Analysis, span: Span, closing: &str) -> Option<Supplemented> {
    let mut files = MemoryFiles::default();
    for mesh in analysis.meshes.iter() {
        files = files.with(&mesh.path, mesh.bytes.clone());
    }
    for file in analysis.files.iter() {
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
    let earlier = Earlier::beside(analysis);
    let read = read_indexed_again(&files, &root.path, &Overrides::default(), earlier);
    let path = &analysis.sources.get(span.file)?.path;
    let file: FileId = read.files.iter().find(|file| file.path == *path)?.file;
    let name = Span::new(file, span.start, span.start + NAME.len() as u32);
    Some(Supplemented { analysis: read, name })
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "the test reads the designs")]
mod tests {
    use super::*;
    use ifs_compiler::analysis::read_indexed;
    use ifs_compiler::hir::types::Type;
    use ifs_compiler::syntax::TokenKind;
    use std::fs;
    use std::path::Path;

    /// What is known of the place: the type it would like, and the local names.
    fn known(read: &Supplemented) -> (Option<Type>, Vec<(String, Type)>) {
        let index = &read.analysis.index;
        let locals = index.visible(read.name.file, read.name.start).into_iter();
        let locals = locals.map(|local| (local.name.clone(), local.ty.clone()));
        (index.expected_at(read.name).cloned(), locals.collect())
    }

    #[test]
    fn an_item_read_again_says_what_the_whole_says() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples");
        let (mut parts, mut wholes) = (0, 0);
        for name in ["vault.ifs", "shell.ifs"] {
            let text = fs::read_to_string(folder.join(name)).unwrap();
            let files = MemoryFiles::single("design.ifs", &text);
            let analysis = read_indexed(&files, "design.ifs", &Overrides::default());
            let tokens = || analysis.files[0].parse.tokens.iter().filter(|token| !token.kind.is_trivia());
            let values =
                tokens().filter(|token| matches!(token.kind, TokenKind::Name | TokenKind::Number(_)));
            let replaced = values.step_by(3).map(|token| (token.span, ""));
            // Beside a token a name is rarely good: of what is wrong nothing may be said of other items.
            let before = |span: Span| Span::new(span.file, span.start, span.start);
            let inserted = tokens().step_by(3).map(|token| (before(token.span), " "));
            for (span, closing) in replaced.chain(inserted) {
                let whole = read_anew(&analysis, span, closing).unwrap();
                wholes += 1;
                let Some(part) = with_item_changed(&analysis, span, &format!("{NAME}{closing}")) else {
                    continue;
                };
                parts += 1;
                let part = Supplemented { analysis: part, name: whole.name };
                assert_eq!(known(&part), known(&whole), "{name} at {span:?}");
            }
        }
        assert!(parts * 5 > wholes * 2 && parts > 100, "{parts} of {wholes} places");
    }
}
