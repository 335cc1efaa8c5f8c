//! One item of a design read again with a change in it: what an editor asks at every letter of a word must not read the
//! whole design each time.

use super::{Analysis, ProjectFile, load, modules};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::check_in_place;
use crate::hir::index::{DeclarationKind, Index};
use crate::source::{FileId, Source, Span};
use crate::syntax::ast::{Item, ItemKind};
use crate::syntax::parse;
use std::mem::discriminant;
use std::sync::Arc;

/// The design with `text` in place of `span`, where that changes nothing but the inside of one item and leaves its brackets
/// balanced; else `None`. Of the result only the index, the typed tree as it was before the change, and the
/// tree of the changed item are meant; places behind the item are those before the change.
pub fn with_item_changed(analysis: &Analysis, span: Span, text: &str) -> Option<Analysis> {
    let file = analysis.files.iter().find(|file| file.file == span.file)?;
    let items = &file.parse.ast.items;
    let place = items.partition_point(|item| item.span.start <= span.start).checked_sub(1)?;
    let old = &items[place];
    let source = analysis.sources.get(span.file)?;
    let end = items.get(place + 1).map_or(source.text.len(), |next| next.span.start as usize);
    // A change before the first inner word or behind the item may be one of where items begin.
    if span.start <= old.span.start || span.end as usize > end {
        return None;
    }
    let changed = changed_item(source, old, span, text, end)?;
    let index = check_in_place(&modules(&analysis.files, load::library()), file.file, &changed)?;
    let mut parse = crate::syntax::Parse::default();
    parse.ast.items.push(changed);
    let file = ProjectFile {
        file: file.file,
        path: file.path.clone(),
        parse,
        uses: Vec::new(),
        meshes: Vec::new(),
        imports: Vec::new(),
        readable: true,
    };
    Some(Analysis {
        files: Arc::new(vec![file]),
        index: Arc::new(with_the_rest(index, &analysis.index)),
        ..analysis.clone()
    })
}

/// The item parsed again where it stands, up to `end`: before it there is only space.
fn changed_item(source: &Source, old: &Item, span: Span, text: &str, end: usize) -> Option<Item> {
    let start = old.span.start as usize;
    let (before, after) =
        (source.text.get(start..span.start as usize)?, source.text.get(span.end as usize..end)?);
    // It begins its line if it did.
    let begins_line = source.text.get(..start)?.rsplit('\n').next()?.trim().is_empty();
    let mut room = " ".repeat(start);
    if let Some(last) = room.pop() {
        room.push(if begins_line { '\n' } else { last });
    }
    let parsed = parse(&Source::new(FileId(source.id.0), "", format!("{room}{before}{text}{after}")));
    let mut items = parsed.ast.items;
    let item = items.pop()?;
    let same = discriminant(&item.kind) == discriminant(&old.kind) && !matches!(item.kind, ItemKind::Error);
    let alone = items.is_empty() && item.span.start == old.span.start;
    (same && alone && parsed.diagnostics.iter().all(stays_inside)).then_some(item)
}

/// Whether a mistake in the text of an item says nothing of what stands around it: brackets that are not balanced do.
fn stays_inside(wrong: &Diagnostic) -> bool {
    !matches!(wrong.code, Code::E0107 | Code::E0201 | Code::E0202 | Code::E0203)
}

/// What is known of the item, with what is known of all names from before.
fn with_the_rest(item: Index, whole: &Index) -> Index {
    let of_items =
        |declared: &&crate::hir::index::Declaration| matches!(declared.kind, DeclarationKind::Item(_));
    let declared = whole.declarations.iter().filter(of_items).cloned();
    let inner = item.declarations.into_iter().filter(|declared| !of_items(&declared));
    let mut index = Index {
        declarations: inner.chain(declared).collect(),
        modules: whole.modules.clone(),
        materials: whole.materials.clone(),
        ..item
    };
    index.sort();
    index
}
