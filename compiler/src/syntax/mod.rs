//! Text to tree: tokens with their trivia, the parser by grammar area, recovery, and the tree.
//!
//! Names and types are not looked up here, and parsing never fails.

mod again;
pub mod ast;
mod docs;
pub mod format;
mod imports;
mod lexeme;
mod lexer;
pub mod limits;
mod parser;
mod repair;
mod token;
mod unit;

#[cfg(test)]
mod tests;

use crate::diagnostic::{Code, Diagnostic, Diagnostics};
use crate::source::{Source, Span};
use again::Earlier;
pub use imports::imported_paths;
use limits::{MAX_BYTES, Said};
pub use parser::MEASURES;
pub use token::{Token, TokenKind};

/// What a text is: always a tree, all its tokens, and what is wrong with it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parse {
    /// The tree. What could not be understood is an error node, of which a diagnostic speaks.
    pub ast: ast::File,
    /// Every byte of the text, in order, trivia and errors included.
    pub tokens: Vec<Token>,
    /// What is wrong, by place; at most [`limits::MAX_DIAGNOSTICS`].
    pub diagnostics: Vec<Diagnostic>,
    /// Of each item whether it was read without a doubt: nothing is wrong in it, and nothing around it is put right.
    sound: Vec<bool>,
}

impl Parse {
    /// A copy of what the next text of the file may have in common with it.
    pub(crate) fn tree(&self) -> Parse {
        Parse { ast: self.ast.clone(), sound: self.sound.clone(), ..Parse::default() }
    }
}

/// Parses a text. Never fails; a good item is in the tree whatever stands around it.
pub fn parse(source: &Source) -> Parse {
    counted(source, None).0
}

/// The same, quicker where much of the text is as it was before: `parse` is what `before` was.
pub fn parse_again(source: &Source, before: &Source, parse: Parse) -> Parse {
    counted(source, Earlier::of(source, before, parse)).0
}

/// Parses a text, and counts the lexemes the grammar has read for it.
fn counted(source: &Source, mut earlier: Option<Earlier>) -> (Parse, usize) {
    if source.text.len() > MAX_BYTES {
        return (too_large(source), 0);
    }
    let mut said = Said::default();
    let lexed = lexer::lex(source, &mut said);
    let mut lexemes = lexeme::lexemes(source, &lexed);
    lexeme::assign_roles(&mut lexemes);
    let (mut lexemes, unsound) = repair::balance(lexemes, &mut said);
    lexeme::assign_roles(&mut lexemes);
    let mut read = |whole: Span| {
        let before = unsound.partition_point(|region| region.start <= whole.start);
        let sound = before.checked_sub(1).is_none_or(|last| unsound[last].end <= whole.start);
        (sound, earlier.as_mut().filter(|_| sound).and_then(|earlier| earlier.take(whole)))
    };
    let (items, sound) = parser::parse_items(&lexemes, repair::items(&lexemes), &mut read, &mut said);
    let mut ast = ast::File { items, ..Default::default() };
    docs::attach(source, &lexed.tokens, &mut ast, &mut said);
    let steps = said.steps;
    let mut diagnostics = Diagnostics::default();
    diagnostics.extend(said.into_vec());
    (Parse { ast, tokens: lexed.tokens, diagnostics: diagnostics.finish(), sound }, steps)
}

/// A file that is not read: one token, no items, one diagnostic.
fn too_large(source: &Source) -> Parse {
    let length = u32::try_from(source.text.len()).unwrap_or(u32::MAX);
    let whole = Span::new(source.id, 0, length);
    let message = format!("the file has {} bytes, more than the limit of {MAX_BYTES}", source.text.len());
    let diagnostic = Diagnostic::new(Code::E0108, Span::new(source.id, 0, 0), message)
        .hint("a design is a text of some pages: split it into several files with `use`");
    let tokens = vec![Token { kind: TokenKind::Error, span: whole }];
    Parse { tokens, diagnostics: vec![diagnostic], ..Parse::default() }
}
