//! Quick fixes: what an editor can change so that a diagnostic goes away. Those the compiler knows come with the
//! diagnostic; those that need the words around the place are found here, one file each, from the tree, the tokens and
//! the index. No text is changed here.

mod apart;
mod case;
mod chained;
mod converted;
mod dropped;
mod elsewhere;
mod foreign;
mod germ;
mod imported;
mod limits;
mod names;
mod paths;
mod rounded;
mod sibling;
mod swapped;
mod tokens;
mod tree;
mod weights;

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Code, Diagnostic, Edit, Fix};
use ifs_compiler::source::{Source, Span};

pub(crate) use dropped::organized;
pub(crate) use imported::{imported, missing};
pub(crate) use paths::nearest;
pub(crate) use sibling::siblings;
pub(super) use tree::expression_at;

/// A change that can be offered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mend {
    /// What it changes, with numbers.
    pub title: String,
    /// The places, in order; they do not overlap.
    pub edits: Vec<Edit>,
    /// Whether it is the only one of its diagnostic.
    pub preferred: bool,
    /// Whether it may be made without asking: it changes nothing that the design means.
    pub safe: bool,
}

/// The changes that would mend a diagnostic, those of the compiler first. Only files of the project are changed.
pub fn mends(analysis: &Analysis, found: &Diagnostic) -> Vec<Mend> {
    let mut fixes: Vec<Fix> = found.fixes().cloned().collect();
    fixes.extend(computed(analysis, found));
    let mut mends: Vec<Mend> = Vec::new();
    for fix in fixes {
        let Some(edits) = tidied(analysis, &fix) else { continue };
        if mends.iter().any(|other| other.edits == edits) {
            continue;
        }
        let safe = is_safe(found.code);
        mends.push(Mend { title: fix.title(&analysis.sources), edits, preferred: false, safe });
    }
    if let [only] = mends.as_mut_slice() {
        only.preferred = true;
    } else {
        mends.iter_mut().for_each(|mend| mend.safe = false);
    }
    mends
}

/// Codes whose only fix leaves the meaning as it is: imports, comments, signs that mean nothing.
fn is_safe(code: Code) -> bool {
    matches!(code, Code::E0102 | Code::E0106 | Code::E0204 | Code::W0307 | Code::W0308 | Code::W0525)
}

fn computed(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    match found.code {
        Code::E0201 => [names::reserved(analysis, found), chained::apart(analysis, found)].concat(),
        Code::E0205 => case::renamed(analysis, found),
        Code::E0302 => [names::renamed(analysis, found), germ::second(analysis, found)].concat(),
        Code::E0304 => elsewhere::imported(analysis, found),
        Code::E0401 => converted::fitting(analysis, found),
        Code::E0404 => dropped::unknown(analysis, found),
        Code::E0405 => dropped::argument(analysis, found),
        Code::E0406 => dropped::surplus(analysis, found),
        Code::E0409 => foreign::named(analysis, found),
        Code::E0501 => weights::completed(analysis, found),
        Code::E0505 => apart::joined(analysis, found),
        Code::E0507 => germ::added(analysis, found),
        Code::E0553 => dropped::each(analysis, found),
        Code::E0604 => dropped::level(analysis, found),
        Code::E0607 => swapped::ends(analysis, found),
        Code::E0803 => dropped::block(analysis, found),
        Code::E0806 | Code::W0608 | Code::W0525 | Code::E0820 => dropped::entry(analysis, found),
        Code::E0835 => limits::one_of_two(analysis, found),
        Code::W0307 => dropped::import(analysis, found),
        Code::W0546 => rounded::same_points(analysis, found),
        _ => Vec::new(),
    }
}

/// The places of a fix in order, lines that would be left empty taken out; `None` where it leads out of the project.
fn tidied(analysis: &Analysis, fix: &Fix) -> Option<Vec<Edit>> {
    let mut edits = Vec::new();
    for edit in &fix.edits {
        let source = analysis.sources.get(edit.span.file)?;
        let own = analysis.files.iter().any(|file| file.file == source.id);
        if !own && source.path != "ifs.toml" {
            return None;
        }
        source.text.get(edit.span.range())?;
        let span = if edit.replacement.is_empty() { whole_line(source, edit.span) } else { edit.span };
        let replacement = match source.text.contains("\r\n") {
            true => edit.replacement.replace('\n', "\r\n"),
            false => edit.replacement.clone(),
        };
        edits.push(Edit { span, replacement });
    }
    edits.sort_by_key(|edit| (edit.span.file, edit.span.start, edit.span.end));
    let apart = edits
        .windows(2)
        .all(|pair| pair[0].span.file != pair[1].span.file || pair[0].span.end <= pair[1].span.start);
    (apart && !edits.is_empty()).then_some(edits)
}

/// The line with its end, where nothing else stands on it.
fn whole_line(source: &Source, span: Span) -> Span {
    let (start, end) = (span.start as usize, span.end as usize);
    let before = source.text[..start].trim_end_matches([' ', '\t']);
    let after = source.text[end..].trim_start_matches([' ', '\t', '\r']);
    let alone = before.is_empty() || before.ends_with('\n');
    match (alone && span.start < span.end, after.strip_prefix('\n')) {
        (true, Some(rest)) => {
            Span::new(span.file, before.len() as u32, (source.text.len() - rest.len()) as u32)
        }
        _ => span,
    }
}
