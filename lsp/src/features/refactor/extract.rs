//! A part of an expression gets a name: a `let` before the item, or in its ifs or test before the member or the line.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::Edit;
use ifs_compiler::hir::index::Target;
use ifs_compiler::source::Span;
use ifs_compiler::syntax::TokenKind;
use ifs_compiler::syntax::ast::{
    BinaryOperator, Clause, Expr, ExprKind, Ifs, Item, ItemKind, MemberKind, TestStep,
};

use super::{Refactoring, line_of, typed};
use crate::features::fixes::expression_at;
use crate::features::walk::of_item;
use crate::features::words::written;

/// The longest text that a title tells whole, in characters.
const TOLD: usize = 40;

/// The `let` for the expression that is selected; `None` where the selection is none, or where it is not always worked out
/// exactly once.
pub(crate) fn extract(analysis: &Analysis, selected: Span) -> Option<Refactoring> {
    let file = analysis.files.iter().find(|file| file.file == selected.file)?;
    let source = analysis.sources.get(selected.file)?;
    let text = source.text.get(selected.range())?;
    let start = selected.start + (text.len() - text.trim_start().len()) as u32;
    let span = Span::new(selected.file, start, start + text.trim().len() as u32);
    let around = |outer: Span| outer.start <= span.start && span.end <= outer.end;
    let item = file.parse.ast.items.iter().find(|item| around(item.span))?;
    let before = place(analysis, item, span)?;
    if !is_always_worked_out(item, span) {
        return None;
    }
    let declared_inside = |used: Span| {
        let outside = |found: &&ifs_compiler::hir::index::Declaration| {
            found.scope.is_some() && !around_of(span, found.span)
        };
        analysis.index.declaration(used).filter(outside).is_none_or(|found| {
            // What an ifs gives its members can be seen by a `let` of its own, and so can the lines of a test before it.
            matches!(item.kind, ItemKind::Ifs(_) | ItemKind::Test(_))
                && found.scope.is_some_and(|scope| around_of(scope, before))
        })
    };
    let mut names = analysis.index.references.iter().filter(|used| around_of(span, used.span));
    if !names.all(|used| !matches!(used.target, Target::Declared(name) if !declared_inside(name))) {
        return None;
    }
    let start = with_docs(analysis, before).start;
    let line = source.text[..start as usize].rfind('\n').map_or(0, |end| end + 1);
    let indent = source.text[line..start as usize].to_owned();
    if !indent.trim().is_empty() {
        return None;
    }
    let name = free_name(analysis, item, span);
    let words = written(analysis, span);
    let declaration = format!("let {name} = {words}\n{indent}");
    let value = start + format!("let {name} = ").len() as u32;
    let used = span.start + declaration.len() as u32;
    let ty = typed(analysis, span)?;
    let used = Span::new(span.file, used, used + name.len() as u32);
    let value = Span::new(span.file, value, value + words.len() as u32);
    let told: String = words.chars().take(TOLD).collect();
    let more = if told.len() < words.len() { "…" } else { "" };
    Some(Refactoring {
        title: format!("name `{}{more}` with a `let`", told.split_whitespace().collect::<Vec<_>>().join(" ")),
        edits: vec![
            Edit { span: Span::new(span.file, start, start), replacement: declaration },
            Edit { span, replacement: name },
        ],
        typed: vec![(value, ty.clone()), (used, ty)],
    })
}

fn around_of(outer: Span, inner: Span) -> bool {
    outer.file == inner.file && outer.start <= inner.start && inner.end <= outer.end
}

/// What the `let` stands before: the item, or the member of an ifs.
fn place(analysis: &Analysis, item: &Item, span: Span) -> Option<Span> {
    match &item.kind {
        ItemKind::Let(_) | ItemKind::Figure(_) | ItemKind::Fabricate(_) => Some(item.span),
        ItemKind::Ifs(ifs) => member(ifs, span),
        ItemKind::Test(test) => test.steps.iter().find_map(|step| match step {
            TestStep::Let(value) => {
                around_of(value.value.span, span).then(|| line_of(analysis, value)).flatten()
            }
            TestStep::Assert(_, line) => around_of(*line, span).then_some(*line),
            TestStep::Error(_) => None,
        }),
        // A function has no lines of its own. What uses none of its parameters can stand before it, unless it might fail:
        // a function that is never called fails at nothing.
        ItemKind::Function(function) => {
            let expr = expression_at(analysis, span).filter(|_| around_of(function.body.span, span))?;
            cannot_fail(expr).then_some(item.span)
        }
        // A default is worked out anew for each call, and a parameter of the design is no expression.
        _ => None,
    }
}

/// Whether the value of an expression is known to be one without working it out.
fn cannot_fail(expr: &Expr) -> bool {
    let mut open = vec![expr];
    while let Some(expr) = open.pop() {
        match &expr.kind {
            ExprKind::Number { .. } | ExprKind::Text(_) | ExprKind::Bool(_) | ExprKind::Name(_) => {}
            ExprKind::Group(inner) | ExprKind::Unary(_, inner) => open.push(inner),
            ExprKind::Tuple(parts) | ExprKind::List(parts) => open.extend(parts),
            ExprKind::Binary(BinaryOperator::Divide, _, left, right) => {
                let ExprKind::Number { digits, .. } = &right.kind else { return false };
                if digits.chars().all(|digit| !matches!(digit, '1'..='9')) {
                    return false;
                }
                open.push(left);
            }
            ExprKind::Binary(
                BinaryOperator::Add | BinaryOperator::Subtract | BinaryOperator::Multiply,
                _,
                left,
                right,
            ) => {
                open.extend([&**left, &**right]);
            }
            _ => return false,
        }
    }
    true
}

fn member(ifs: &Ifs, span: Span) -> Option<Span> {
    let member = ifs.members.iter().find(|member| around_of(member.span, span))?;
    match &member.kind {
        MemberKind::Let(_) | MemberKind::Germ(_) | MemberKind::Keep(_) => Some(member.span),
        // A family is worked out once for each of its numbers.
        MemberKind::Transform(transform) if transform.family.is_none() => Some(member.span),
        _ => None,
    }
}

/// Whether an expression stands exactly there that can have a name, outside of what is worked out never or several times.
fn is_always_worked_out(item: &Item, span: Span) -> bool {
    let (mut found, mut good) = (false, true);
    let mut visit = |expr: &Expr| {
        if expr.span == span {
            found |= !matches!(
                expr.kind,
                ExprKind::Name(_)
                    | ExprKind::Fields(_)
                    | ExprKind::Range(_)
                    | ExprKind::At(..)
                    | ExprKind::Error
            );
            good &= !matches!(expr.kind, ExprKind::Name(_));
        } else if around_of(expr.span, span) {
            good &= match &expr.kind {
                // What the first numbers run through is worked out once, all the rest for each of them.
                ExprKind::Comprehension { clauses, .. } => {
                    matches!(clauses.first(), Some(Clause::For(_, list)) if around_of(list.span, span))
                }
                ExprKind::If(condition, ..) => around_of(condition.span, span),
                ExprKind::Binary(operator, _, left, _) => {
                    !matches!(operator, BinaryOperator::And | BinaryOperator::Or)
                        || around_of(left.span, span)
                }
                _ => true,
            };
        }
    };
    of_item(item, &mut visit);
    found && good
}

/// The place with the lines that document it.
fn with_docs(analysis: &Analysis, place: Span) -> Span {
    let file = analysis.files.iter().find(|file| file.file == place.file);
    let tokens = file.map_or(&[][..], |file| &file.parse.tokens);
    let before = tokens.iter().rev().filter(|token| token.span.end <= place.start);
    let docs = before.take_while(|token| matches!(token.kind, TokenKind::Whitespace | TokenKind::ItemDocs));
    let first = docs.filter(|token| token.kind == TokenKind::ItemDocs).last();
    Span::new(place.file, first.map_or(place.start, |token| token.span.start), place.end)
}

/// The name of the argument that is extracted, else `value`; with a number where that is taken.
fn free_name(analysis: &Analysis, item: &Item, span: Span) -> String {
    let mut base = "value".to_owned();
    let mut visit = |expr: &Expr| {
        if let ExprKind::Call { arguments, .. } | ExprKind::Fields(arguments) = &expr.kind {
            let named = arguments.iter().find(|argument| argument.value.span == span);
            if let Some(name) = named.and_then(|argument| argument.name.as_ref()) {
                base.clone_from(&name.text);
            }
        }
    };
    of_item(item, &mut visit);
    let file = analysis.files.iter().find(|file| file.file == span.file);
    let tokens = file.map_or(&[][..], |file| &file.parse.tokens);
    let used: Vec<&str> = tokens
        .iter()
        .filter(|token| token.kind == TokenKind::Name)
        .map(|token| written(analysis, token.span))
        .collect();
    // A field or a parameter of that name is no clash, but its use would read as one.
    let numbered = (2..=used.len() + 2).map(|number| format!("{base}_{number}"));
    let mut free =
        std::iter::once(base.clone()).chain(numbered).filter(|name| !used.contains(&name.as_str()));
    free.next().unwrap_or(base)
}
