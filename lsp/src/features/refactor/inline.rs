//! A `let` of a file, an ifs or a test is written out where it is used, and goes.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::Edit;
use ifs_compiler::hir::index::Target;
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::TokenKind;
use ifs_compiler::syntax::ast::{Expr, ExprKind, Item, ItemKind, Let, MemberKind, Placement, TestStep};

use super::{Refactoring, line_of, typed};
use crate::features::walk::expressions;
use crate::features::words::written;

/// The `let` whose name, or a use of it, stands at a place, written out; `None` where other files may use it, where it says
/// a type, or where its names mean something else at a use.
pub(crate) fn inline(analysis: &Analysis, file: FileId, offset: u32) -> Option<Refactoring> {
    let Target::Declared(declared) = analysis.index.name_at(file, offset)?.target else { return None };
    let parsed = analysis.files.iter().find(|parsed| parsed.file == file && declared.file == file)?;
    let (value, whole, is_public) = parsed.parse.ast.items.iter().find_map(|item| {
        let is_public = item.public.is_some();
        let value = lets(item).into_iter().find(|value| value.name.span == declared)?;
        match &item.kind {
            ItemKind::Let(_) => Some((value, item.span, is_public)),
            _ => Some((value, line_of(analysis, value)?, false)),
        }
    })?;
    let uses: Vec<Span> = analysis.index.uses(Target::Declared(declared)).collect();
    let own = |span: &Span| span.file == file && !(whole.start <= span.start && span.end <= whole.end);
    if is_public || value.ty.is_some() || uses.is_empty() || !uses.iter().all(own) {
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
    let mut edits = vec![Edit { span: removed(analysis, whole), replacement: String::new() }];
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

/// The `let`s of an item: itself, the members of an ifs, the lines of a test.
fn lets(item: &Item) -> Vec<&Let> {
    match &item.kind {
        ItemKind::Let(value) => vec![value],
        ItemKind::Ifs(ifs) => {
            let members = ifs.members.iter().filter_map(|member| match &member.kind {
                MemberKind::Let(value) => Some(value),
                _ => None,
            });
            members.collect()
        }
        ItemKind::Test(test) => {
            let lines = test.steps.iter().filter_map(|step| match step {
                TestStep::Let(value) => Some(value),
                _ => None,
            });
            lines.collect()
        }
        _ => Vec::new(),
    }
}

/// Whether each name of the value means at a use what it means in the value.
fn sees_the_same(analysis: &Analysis, value: &Expr, used: Span) -> bool {
    let inside = |span: Span| {
        span.file == value.span.file && value.span.start <= span.start && span.end <= value.span.end
    };
    let locals = analysis.index.visible(used.file, used.start);
    analysis.index.references.iter().filter(|name| inside(name.span)).all(|name| {
        let word = written(analysis, name.span);
        let declared = match name.target {
            Target::Declared(span) => analysis.index.declaration(span),
            _ => None,
        };
        // What is declared inside of the value goes with it.
        if declared.is_some_and(|found| inside(found.span)) {
            return true;
        }
        let local = locals.iter().find(|local| local.name == word);
        match declared.filter(|found| found.scope.is_some()) {
            Some(own) => local.is_some_and(|local| local.span == own.span),
            None => local.is_none(),
        }
    })
}

/// The `let` with the lines that document it, and its line where nothing else stands on it.
fn removed(analysis: &Analysis, whole: Span) -> Span {
    let file = analysis.files.iter().find(|file| file.file == whole.file);
    let tokens = file.map_or(&[][..], |file| &file.parse.tokens);
    let before = tokens.iter().rev().filter(|token| token.span.end <= whole.start);
    let docs = before.take_while(|token| matches!(token.kind, TokenKind::Whitespace | TokenKind::ItemDocs));
    let first = docs.filter(|token| token.kind == TokenKind::ItemDocs).last();
    let start = first.map_or(whole.start, |token| token.span.start);
    let text = analysis.sources.get(whole.file).map_or("", |source| source.text.as_str());
    let rest = &text[whole.end as usize..];
    let spaces = rest.len() - rest.trim_start_matches([' ', '\t', '\r']).len();
    if !rest[spaces..].starts_with('\n') {
        return Span::new(whole.file, start, whole.end);
    }
    let indented = text[..start as usize].trim_end_matches([' ', '\t']);
    let start = if indented.is_empty() || indented.ends_with('\n') { indented.len() as u32 } else { start };
    Span::new(whole.file, start, whole.end + spaces as u32 + 1)
}
