//! The layout of `ifs fmt`, as the smallest edits of whole lines; and of a part of a file, item by item.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::source::{FileId, Source, Span};
use ifs_compiler::syntax::format::format;
use ifs_compiler::syntax::parse;

/// The edits that lay a file out; `None` where it cannot be, since it is broken.
pub(crate) fn edits(analysis: &Analysis, file: FileId) -> Option<Vec<(Span, String)>> {
    let parsed = analysis.files.iter().find(|candidate| candidate.file == file)?;
    let source = analysis.sources.get(file)?;
    let laid_out = format(&parsed.parse, source)?;
    Some(line_edits(file, &source.text, &laid_out))
}

/// The lines that differ between the first and the last that are the same, as one edit.
pub(crate) fn line_edits(file: FileId, old: &str, new: &str) -> Vec<(Span, String)> {
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

/// The edits that lay out the items that a part of a file touches, as they are in the whole laid out.
pub(crate) fn part_edits(analysis: &Analysis, part: Span) -> Option<Vec<(Span, String)>> {
    let parsed = analysis.files.iter().find(|candidate| candidate.file == part.file)?;
    let source = analysis.sources.get(part.file)?;
    let laid_out = Source::new(part.file, source.path.clone(), format(&parsed.parse, source)?);
    let after = parse(&laid_out).ast.items;
    let before = &parsed.parse.ast.items;
    // Layout neither adds items nor takes them away.
    if before.len() != after.len() {
        return None;
    }
    let touched = before
        .iter()
        .zip(&after)
        .filter(|(item, _)| item.span.start <= part.end && part.start <= item.span.end);
    let edits = touched.filter_map(|(old, new)| {
        let text = laid_out.slice(new.span);
        (source.slice(old.span) != text).then(|| (old.span, text.to_owned()))
    });
    Some(edits.collect())
}

/// The edits that lay out the item that a bracket at a place ends.
pub(crate) fn ended_edits(analysis: &Analysis, file: FileId, offset: u32) -> Option<Vec<(Span, String)>> {
    let parsed = analysis.files.iter().find(|candidate| candidate.file == file)?;
    let item = parsed.parse.ast.items.iter().find(|item| item.span.end == offset)?;
    part_edits(analysis, item.span)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::features::fixture::fixture;

    #[test]
    fn a_part_is_laid_out_like_the_whole() {
        let text = "let a   = 1\nlet b =  [1,\n2]\nfn f( i : Int )->Int=i\n";
        let design = fixture(text);
        let root = design.analysis.root;
        let edits = part_edits(&design.analysis, Span::new(root, 14, 16)).unwrap();
        assert_eq!(edits.len(), 1);
        assert_eq!(text.get(edits[0].0.range()).unwrap(), "let b =  [1,\n2]");
        let all = part_edits(&design.analysis, Span::new(root, 0, text.len() as u32)).unwrap();
        let mut laid_out = text.to_owned();
        for (span, new) in all.iter().rev() {
            laid_out.replace_range(span.range(), new);
        }
        let whole = edits_applied(text, &super::edits(&design.analysis, root).unwrap());
        assert_eq!(laid_out, whole);
        assert_eq!(part_edits(&fixture("let = (").analysis, Span::new(root, 0, 3)), None);
    }

    #[test]
    fn the_item_that_a_bracket_ends() {
        let text = "let a   = 1\nrecord Part {\nwidth :Length\n}$0\nlet b   = 2\n";
        let design = fixture(text);
        let edits = ended_edits(&design.analysis, design.analysis.root, design.at).unwrap();
        let laid_out = edits_applied(&text.replacen("$0", "", 1), &edits);
        assert_eq!(laid_out, "let a   = 1\nrecord Part {\n    width: Length\n}\nlet b   = 2\n");
        let inside = fixture("fabricate a as panels {\n  nest: { gap: 3mm }$0\n}\n");
        assert_eq!(ended_edits(&inside.analysis, inside.analysis.root, inside.at), None);
    }

    fn edits_applied(text: &str, edits: &[(Span, String)]) -> String {
        let mut text = text.to_owned();
        for (span, new) in edits.iter().rev() {
            text.replace_range(span.range(), new);
        }
        text
    }
}
