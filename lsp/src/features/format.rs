//! The layout of `ifs fmt`, as the smallest edits of whole lines.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::format::format;

/// The edits that lay a file out; `None` where it cannot be, since it is broken.
pub(crate) fn edits(analysis: &Analysis, file: FileId) -> Option<Vec<(Span, String)>> {
    let parsed = analysis.files.iter().find(|candidate| candidate.file == file)?;
    let source = analysis.sources.get(file)?;
    let laid_out = format(&parsed.parse, source)?;
    Some(line_edits(file, &source.text, &laid_out))
}

/// The lines that differ between the first and the last that are the same, as one edit.
fn line_edits(file: FileId, old: &str, new: &str) -> Vec<(Span, String)> {
    if old == new {
        return Vec::new();
    }
    let (before, after): (Vec<&str>, Vec<&str>) =
        (old.split_inclusive('\n').collect(), new.split_inclusive('\n').collect());
    let same = before.iter().zip(&after).take_while(|(a, b)| a == b).count();
    let rest = before.len().min(after.len()) - same;
    let end = before.iter().rev().zip(after.iter().rev()).take(rest).take_while(|(a, b)| a == b).count();
    let start: usize = before[..same].iter().map(|line| line.len()).sum();
    let length: usize = before[same..before.len() - end].iter().map(|line| line.len()).sum();
    let span = Span::new(file, start as u32, (start + length) as u32);
    vec![(span, after[same..after.len() - end].concat())]
}
