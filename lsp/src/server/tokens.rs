//! Semantic tokens in the protocol's numbers, whole, in part, and as what has changed.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use ifs_compiler::source::Span;
use tower_lsp::ls_types::*;

use crate::features::semantics::{MEANINGS, MODIFIERS, semantics};
use crate::world::Snapshot;

/// What the numbers mean.
pub(super) fn legend() -> SemanticTokensLegend {
    SemanticTokensLegend {
        token_types: MEANINGS.iter().map(|(_, word)| SemanticTokenType::new(word)).collect(),
        token_modifiers: MODIFIERS.iter().map(|word| SemanticTokenModifier::new(word)).collect(),
    }
}

/// The tokens last told of each document, by which the next ones are told.
#[derive(Default)]
pub(super) struct Told {
    inner: Mutex<Inner>,
}

#[derive(Default)]
struct Inner {
    /// How many were told: the name of the last.
    count: u64,
    /// By document: the name, and the tokens.
    last: BTreeMap<String, (String, Vec<SemanticToken>)>,
}

impl Told {
    /// Keeps what is told of a document and gives it a name.
    fn keep(&self, uri: &str, tokens: &[SemanticToken]) -> String {
        let mut inner = self.inner.lock().unwrap_or_else(PoisonError::into_inner);
        inner.count += 1;
        let id = inner.count.to_string();
        inner.last.insert(uri.to_owned(), (id.clone(), tokens.to_vec()));
        id
    }

    /// What was told of a document by this name.
    fn known(&self, uri: &str, id: &str) -> Option<Vec<SemanticToken>> {
        let inner = self.inner.lock().unwrap_or_else(PoisonError::into_inner);
        inner.last.get(uri).filter(|(known, _)| known == id).map(|(_, tokens)| tokens.clone())
    }

    /// Nothing is told of a document that is closed.
    pub(super) fn forget(&self, uri: &str) {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner).last.remove(uri);
    }

    pub(super) fn whole(&self, uri: &str, tokens: Vec<SemanticToken>) -> SemanticTokens {
        SemanticTokens { result_id: Some(self.keep(uri, &tokens)), data: tokens }
    }

    pub(super) fn changed(
        &self,
        uri: &str,
        before: &str,
        tokens: Vec<SemanticToken>,
    ) -> SemanticTokensFullDeltaResult {
        let Some(known) = self.known(uri, before) else {
            return SemanticTokensFullDeltaResult::Tokens(self.whole(uri, tokens));
        };
        let id = self.keep(uri, &tokens);
        let edits = edit(&known, &tokens).into_iter().collect();
        SemanticTokensFullDeltaResult::TokensDelta(SemanticTokensDelta { result_id: Some(id), edits })
    }
}

/// The one edit from the first token that differs to the last, in the numbers of the protocol: five a token.
fn edit(before: &[SemanticToken], after: &[SemanticToken]) -> Option<SemanticTokensEdit> {
    if before == after {
        return None;
    }
    let same = before.iter().zip(after).take_while(|(a, b)| a == b).count();
    let rest = before.len().min(after.len()) - same;
    let end = before.iter().rev().zip(after.iter().rev()).take(rest).take_while(|(a, b)| a == b).count();
    Some(SemanticTokensEdit {
        start: 5 * same as u32,
        delete_count: 5 * (before.len() - end - same) as u32,
        data: Some(after[same..after.len() - end].to_vec()),
    })
}

/// The tokens of a document, or of a part of it.
pub(super) fn tokens(snapshot: &Snapshot, part: Option<Range>) -> Vec<SemanticToken> {
    let root = snapshot.analysis.root;
    let part = part.map(|range| Span::new(root, snapshot.offset(range.start), snapshot.offset(range.end)));
    let (mut line, mut column) = (0, 0);
    let meant = semantics(&snapshot.analysis, root, part).into_iter();
    meant
        .map(|meant| {
            let range = snapshot.range(meant.span);
            let start = range.start;
            let delta_start = if start.line == line { start.character - column } else { start.character };
            let token = SemanticToken {
                delta_line: start.line - line,
                delta_start,
                length: range.end.character.saturating_sub(start.character),
                token_type: meant.meaning as u32,
                token_modifiers_bitset: meant.modifiers,
            };
            (line, column) = (start.line, start.character);
            token
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn token(kind: u32) -> SemanticToken {
        SemanticToken {
            delta_line: 0,
            delta_start: 1,
            length: 1,
            token_type: kind,
            token_modifiers_bitset: 0,
        }
    }

    #[test]
    fn only_what_differs_is_told() {
        let told = Told::default();
        let whole = told.whole("a", [1, 2, 3, 4].map(token).to_vec());
        let id = whole.result_id.unwrap();
        let changed = told.changed("a", &id, [1, 9, 9, 3, 4].map(token).to_vec());
        let SemanticTokensFullDeltaResult::TokensDelta(delta) = changed else { panic!("a delta") };
        assert_eq!(delta.edits.len(), 1);
        let edit = &delta.edits[0];
        assert_eq!((edit.start, edit.delete_count, edit.data.as_ref().unwrap().len()), (5, 5, 2));
        assert!(matches!(told.changed("a", &id, Vec::new()), SemanticTokensFullDeltaResult::Tokens(_)));
        told.forget("a");
        let id = delta.result_id.unwrap();
        assert!(matches!(told.changed("a", &id, Vec::new()), SemanticTokensFullDeltaResult::Tokens(_)));
    }
}
