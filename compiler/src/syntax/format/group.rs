//! The brackets of a text: what they are for, and where their elements begin.

use super::piece::{Piece, Statement};
use crate::syntax::token::TokenKind;

/// A pair of brackets.
#[derive(Clone, Debug)]
pub(super) struct Group {
    /// The piece that opens it.
    pub(super) open: usize,
    /// The piece that closes it.
    pub(super) close: usize,
    /// The pieces its elements begin with; of a comprehension the body and the clauses.
    pub(super) elements: Vec<usize>,
    /// What it is for.
    pub(super) shape: Shape,
    /// Whether it spans lines.
    pub(super) broken: bool,
}

/// What a pair of brackets is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// Elements with commas between them.
    Elements,
    /// An expression in parentheses, or a comprehension: there are no commas.
    Expression,
    /// A type or a family, which never spans lines.
    Fixed,
    /// The block of an item.
    Block(Statement),
}

/// All groups of a text.
#[derive(Clone, Debug)]
pub(super) struct Groups {
    /// Each after those that open before it.
    pub(super) all: Vec<Group>,
    /// For each piece, the group that it opens or closes.
    pub(super) of: Vec<Option<usize>>,
    /// For each piece, the innermost group in which it stands; a bracket stands outside of its own.
    pub(super) around: Vec<Option<usize>>,
}

impl Groups {
    /// The group that a piece opens.
    pub(super) fn opened_by(&self, at: usize) -> Option<usize> {
        self.of[at].filter(|group| self.all[*group].open == at)
    }

    /// Whether a piece stands in no bracket but the block of an item.
    pub(super) fn in_statement(&self, at: usize) -> bool {
        self.around[at].is_none_or(|group| self.is_block(group))
    }

    /// Whether a group is the block of an item.
    pub(super) fn is_block(&self, group: usize) -> bool {
        matches!(self.all[group].shape, Shape::Block(_))
    }
}

/// Finds the groups. The brackets of a text without errors are balanced.
pub(super) fn groups(pieces: &[Piece<'_>]) -> Groups {
    let mut found =
        Groups { all: Vec::new(), of: vec![None; pieces.len()], around: vec![None; pieces.len()] };
    let mut open: Vec<usize> = Vec::new();
    let mut item = Statement::Other;
    for (at, piece) in pieces.iter().enumerate() {
        if piece.kind.is_closer()
            && let Some(group) = open.pop()
        {
            found.of[at] = Some(group);
            close(&mut found.all[group], at, pieces);
        }
        found.around[at] = open.last().copied();
        match (open.last(), piece.mark.statement) {
            (Some(group), _) if !piece.kind.is_closer() && begins(&found.all[*group], at, pieces) => {
                found.all[*group].elements.push(at);
            }
            (None, Some(statement)) => item = statement,
            _ => {}
        }
        if piece.kind.closer().is_some() {
            let shape = match piece.kind {
                _ if piece.mark.fixed => Shape::Fixed,
                TokenKind::OpenBrace if open.is_empty() && has_block(item) => Shape::Block(item),
                _ => Shape::Elements,
            };
            found.of[at] = Some(found.all.len());
            open.push(found.all.len());
            found.all.push(Group { open: at, close: at, elements: Vec::new(), shape, broken: false });
        }
    }
    found
}

/// Whether the braces of an item are a block of entries.
fn has_block(item: Statement) -> bool {
    matches!(item, Statement::Fields | Statement::Members)
}

/// Whether a piece that stands directly in a group begins an element of it.
fn begins(group: &Group, at: usize, pieces: &[Piece<'_>]) -> bool {
    match group.shape {
        Shape::Block(_) => pieces[at].mark.statement.is_some(),
        _ => at == group.open + 1 || pieces[at - 1].comma || pieces[at].mark.clause || pieces[at].mark.field,
    }
}

fn close(group: &mut Group, at: usize, pieces: &[Piece<'_>]) {
    group.close = at;
    let clauses = group.elements.iter().any(|element| pieces[*element].mark.clause);
    let opener = &pieces[group.open];
    let placed = group.open > 0 && pieces[group.open - 1].kind == TokenKind::On;
    let grouping = opener.kind == TokenKind::OpenParenthesis && !opener.mark.glued && !placed;
    if group.shape == Shape::Elements && (clauses || grouping && group.elements.len() == 1) {
        group.shape = Shape::Expression;
    }
}
