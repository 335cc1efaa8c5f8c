//! Every text has tokens that tile it, a tree inside it, and a diagnostic for whatever the tree leaves out.

use ifs_compiler::source::{FileId, Source, SourceMap};
use ifs_compiler::syntax::ast::{File, Item};
use ifs_compiler::syntax::{Parse, Token, parse};

use super::diagnostics::{lies_inside, printed};
use super::{Holds, holds};

/// Lexer, parser and the forms of diagnostics on any bytes.
///
/// # Errors
/// What does not hold, in words.
pub fn parse_holds(bytes: &[u8]) -> Holds {
    let text = String::from_utf8_lossy(bytes).into_owned();
    let parsed = parse(&Source::new(FileId(0), "a.ifs", text.clone()));
    let again = parse(&Source::new(FileId(0), "a.ifs", text.clone()));
    holds(parsed == again, || "the same text has two trees".to_owned())?;
    tiles(&text, &parsed.tokens)?;
    let mut sources = SourceMap::default();
    sources.add("a.ifs", text);
    tree_lies_inside(&parsed.ast, &sources)?;
    complete(&parsed)?;
    printed(&parsed.diagnostics, &sources)?;
    fixes_can_be_parsed(&parsed, &sources)
}

/// The tokens are the text, byte for byte.
fn tiles(text: &str, tokens: &[Token]) -> Holds {
    let mut at = 0;
    for token in tokens {
        let (start, end) = (token.span.start, token.span.end);
        holds(start == at && end > start, || format!("a token at {start}..{end} follows the byte {at}"))?;
        holds(text.is_char_boundary(end as usize), || format!("a token ends inside a character at {end}"))?;
        at = end;
    }
    holds(at as usize == text.len(), || format!("the tokens end at {at} of {} bytes", text.len()))
}

/// Every span of the tree, read from its printed form, lies in the text.
fn tree_lies_inside(tree: &File, sources: &SourceMap) -> Holds {
    let printed = format!("{tree:?}");
    let number = |text: &str, after: &str| -> Option<u32> {
        let (_, rest) = text.split_once(after)?;
        rest.split(|letter: char| !letter.is_ascii_digit()).next()?.parse().ok()
    };
    for part in printed.split("Span { ").skip(1) {
        let (Some(start), Some(end)) = (number(part, "start: "), number(part, "end: ")) else {
            // The words of a text literal may look like a span.
            continue;
        };
        if part.starts_with("file: FileId(0), start: ") {
            holds(start <= end, || format!("a span {start}..{end} in the tree"))?;
            lies_inside(ifs_compiler::source::Span::new(FileId(0), start, end), sources)?;
        }
    }
    Ok(())
}

/// Without diagnostics, every word of the text is in an item, and no node says that it was not understood.
fn complete(parsed: &Parse) -> Holds {
    if !parsed.diagnostics.is_empty() {
        return Ok(());
    }
    let mut items = parsed.ast.items.iter().peekable();
    for token in parsed.tokens.iter().filter(|token| !token.kind.is_trivia()) {
        while items.peek().is_some_and(|item: &&Item| item.span.end <= token.span.start) {
            items.next();
        }
        let inside = items.peek().is_some_and(|item| item.span.start <= token.span.start);
        holds(inside, || format!("a token at {:?} is in no item, and nothing is said of it", token.span))?;
    }
    let printed = format!("{:?}", parsed.ast);
    let silent = ["kind: Error", "Error(Span"].iter().any(|word| printed.contains(word));
    // A text literal may hold these words.
    let quoted = parsed.tokens.iter().any(|token| token.kind == ifs_compiler::syntax::TokenKind::Text);
    holds(!silent || quoted, || "an error in the tree without a diagnostic".to_owned())
}

/// A text with a proposed change made is a text like any other.
fn fixes_can_be_parsed(parsed: &Parse, sources: &SourceMap) -> Holds {
    let Some(source) = sources.get(FileId(0)) else { return Ok(()) };
    let fixes = parsed.diagnostics.iter().flat_map(|diagnostic| diagnostic.fixes());
    for fix in fixes.take(3) {
        let mut text = source.text.clone();
        for edit in fix.edits.iter().rev() {
            text.replace_range(edit.span.range(), &edit.replacement);
        }
        let mended = parse(&Source::new(FileId(0), "a.ifs", text.clone()));
        tiles(&text, &mended.tokens)?;
    }
    Ok(())
}
