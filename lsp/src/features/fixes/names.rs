//! A name that is declared twice: the second gets another that nothing has.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Fix};
use ifs_compiler::syntax::TokenKind;

use super::dropped;
use super::tokens::words;
use crate::features::words::written;

/// The second under a free name; where it is an import, that out.
pub(super) fn renamed(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let imported = dropped::import(analysis, found);
    if !imported.is_empty() {
        return imported;
    }
    let name = written(analysis, found.span);
    if !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
        return Vec::new();
    }
    let words = words(analysis, found.span);
    let taken = |new: &str| {
        words.iter().any(|token| token.kind == TokenKind::Name && written(analysis, token.span) == new)
    };
    let free = (2..1000).map(|number| match name.starts_with(|c: char| c.is_ascii_uppercase()) {
        true => format!("{name}{number}"),
        false => format!("{name}_{number}"),
    });
    let new = free.into_iter().find(|new| !taken(new));
    let fix = |new: String| {
        Fix::titled(format!("call the second `{new}`: `{name}` still means the first")).with(found.span, new)
    };
    new.map(fix).into_iter().collect()
}
