//! A `let` of a file is written out where it is used, and goes.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::Edit;
use ifs_compiler::hir::index::Target;
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::TokenKind;
use ifs_compiler::syntax::ast::{Expr, ExprKind, Item, ItemKind, Let, Placement};

use super::{Refactoring, typed};
use crate::features::walk::expressions;
use crate::features::words::written;

/// The `let` whose name, or a use of it, stands at a place, written out; `None` where other files may use it, where it says
/// a type, or where its names mean something else at a use.
pub(crate) fn inline(analysis: &Analysis, file: FileId, offset: u32) -> Option<Refactoring> {
    let Target::Declared(declared) = analysis.index.name_at(file, offset)?.target else { return None };
    let parsed = analysis.files.iter().find(|parsed| parsed.file == file && declared.file == file)?;
    let (item, value) = parsed.parse.ast.items.iter().find_map(|item| match &item.kind {
        ItemKind::Let(value) if value.name.span == declared => Some((item, value)),
        _ => None,
    })?;
    let uses: Vec<Span> = analysis.index.uses(Target::Declared(declared)).collect();
    let own =
        |span: &Span| span.file == file && !(item.span.start <= span.start && span.end <= item.span.end);
    if item.public.is_some() || value.ty.is_some() || uses.is_empty() || !uses.iter().all(own) {
        return None;
    }
    if !uses.iter().all(|used| sees_the_same(analysis, &value.value, *used)) {
        return None;
    }
    let ty = typed(analysis, value.value.span)?;
    let text = written(analysis, value.value.span);
    let atomic = is_atomic(&value.value);
    let mut placed = false;
    expressions(&parsed.parse.ast, |expr| {
        if let ExprKind::On(_, Placement::Value(points)) = &expr.kind {
            placed |= uses.contains(&points.span);
        }
    });
    // Brackets behind `on` are a list of control points.
    if placed && !atomic {
        return None;
    }
    let replacement = if atomic { text.to_owned() } else { format!("({text})") };
    let mut edits = vec![Edit { span: removed(analysis, item), replacement: String::new() }];
    edits.extend(uses.iter().map(|span| Edit { span: *span, replacement: replacement.clone() }));
    edits.sort_by_key(|edit| edit.span.start);
    let mut moved: i64 = 0;
    let mut places = Vec::new();
    for edit in &edits {
        if !edit.replacement.is_empty() {
            let start = u32::try_from(i64::from(edit.span.start) + moved).ok()? + u32::from(!atomic);
            places.push((Span::new(file, start, start + text.len() as u32), ty.clone()));
        }
        moved += edit.replacement.len() as i64 - i64::from(edit.span.end - edit.span.start);
    }
    Some(Refactoring { title: title(value, text, uses.len()), edits, typed: places })
}

fn title(value: &Let, text: &str, uses: usize) -> String {
    let told: String = text.chars().take(40).collect();
    let more = if told.len() < text.len() { "…" } else { "" };
    let told = told.split_whitespace().collect::<Vec<_>>().join(" ");
    let name = &value.name.text;
    match uses {
        1 => format!("write `{told}{more}` in the place of `{name}`"),
        uses => format!("write `{told}{more}` in the {uses} places of `{name}`"),
    }
}

/// Whether it needs no brackets wherever it stands.
fn is_atomic(value: &Expr) -> bool {
    matches!(
        value.kind,
        ExprKind::Number { .. }
            | ExprKind::Text(_)
            | ExprKind::Bool(_)
            | ExprKind::Name(_)
            | ExprKind::Call { .. }
            | ExprKind::Index(..)
            | ExprKind::Field(..)
            | ExprKind::List(_)
            | ExprKind::Comprehension { .. }
    )
}

/// Whether no name of the value is hidden by a local at a use.
fn sees_the_same(analysis: &Analysis, value: &Expr, used: Span) -> bool {
    let inside = |span: Span| {
        span.file == value.span.file && value.span.start <= span.start && span.end <= value.span.end
    };
    let names: Vec<&str> = analysis
        .index
        .references
        .iter()
        .filter(|name| inside(name.span))
        .map(|name| written(analysis, name.span))
        .collect();
    analysis.index.visible(used.file, used.start).iter().all(|local| !names.contains(&local.name.as_str()))
}

/// The `let` with the lines that document it and the end of its line.
fn removed(analysis: &Analysis, item: &Item) -> Span {
    let file = analysis.files.iter().find(|file| file.file == item.span.file);
    let tokens = file.map_or(&[][..], |file| &file.parse.tokens);
    let before = tokens.iter().rev().filter(|token| token.span.end <= item.span.start);
    let docs = before.take_while(|token| matches!(token.kind, TokenKind::Whitespace | TokenKind::ItemDocs));
    let first = docs.filter(|token| token.kind == TokenKind::ItemDocs).last();
    let start = first.map_or(item.span.start, |token| token.span.start);
    let text = analysis.sources.get(item.span.file).map_or("", |source| source.text.as_str());
    let rest = &text[item.span.end as usize..];
    let spaces = rest.len() - rest.trim_start_matches([' ', '\t', '\r']).len();
    let line = if rest[spaces..].starts_with('\n') { spaces + 1 } else { 0 };
    Span::new(item.span.file, start, item.span.end + line as u32)
}
