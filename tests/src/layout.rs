//! What holds for every text that is laid out: nothing is lost, nothing means anything else, and the second time
//! nothing changes.

use ifs_compiler::source::{FileId, Source};
use ifs_compiler::syntax::format::format;
use ifs_compiler::syntax::{Parse, TokenKind, parse};

/// A text and what the parser makes of it.
pub struct Read {
    /// The text.
    pub source: Source,
    /// Its tokens and its tree.
    pub parse: Parse,
}

impl Read {
    /// Reads a text.
    pub fn new(text: &str) -> Read {
        let source = Source::new(FileId(0), "a.ifs", text);
        let parse = parse(&source);
        Read { source, parse }
    }

    /// Whether anything is wrong with it.
    pub fn is_good(&self) -> bool {
        self.parse.diagnostics.is_empty()
    }

    /// Its layout.
    pub fn formatted(&self) -> Option<String> {
        format(&self.parse, &self.source)
    }

    /// The tree without places.
    fn tree(&self) -> String {
        let printed = format!("{:?}", self.parse.ast);
        let parts = printed.split("Span { file: FileId(0), start: ");
        parts.map(|part| part.split_once('}').map_or(part, |(_, rest)| rest)).collect()
    }

    /// The tokens that are no trivia, without commas.
    fn words(&self) -> Vec<&str> {
        let kept = |kind: TokenKind| !kind.is_trivia() && kind != TokenKind::Comma;
        let tokens = self.parse.tokens.iter().filter(|token| kept(token.kind));
        tokens.map(|token| self.source.slice(token.span)).collect()
    }

    /// The comments, and whether each stands on a line of its own. One behind a comma that follows another comment
    /// does as well, for the comma goes to the end of its element.
    fn comments(&self) -> Vec<(bool, &str)> {
        let mut comments = Vec::new();
        let (mut own_line, mut commented) = (true, false);
        for token in &self.parse.tokens {
            let text = self.source.slice(token.span);
            match token.kind {
                TokenKind::Whitespace => own_line |= text.contains('\n'),
                TokenKind::Comma => own_line = commented,
                kind if kind.is_trivia() => {
                    comments.push((own_line, text.trim_end()));
                    commented = true;
                }
                _ => (own_line, commented) = (false, false),
            }
        }
        comments
    }

    /// For every item, and every comment between items: whether a blank line stands before it.
    fn groups(&self) -> Vec<bool> {
        let items = &self.parse.ast.items;
        let mut groups = Vec::new();
        let mut lines = 0;
        for token in &self.parse.tokens {
            let text = self.source.slice(token.span);
            if token.kind == TokenKind::Whitespace {
                lines += text.matches('\n').count();
                continue;
            }
            let at = items.partition_point(|item| item.span.end <= token.span.start);
            let inside = items.get(at).is_some_and(|item| item.span.start < token.span.start);
            if !inside {
                groups.push(lines > 1 && !groups.is_empty());
            }
            lines = 0;
        }
        groups
    }
}

/// Checks all of it for a text without mistakes; returns the layout.
pub fn check(text: &str) -> String {
    let before = Read::new(text);
    let laid_out =
        before.formatted().unwrap_or_else(|| panic!("refused: {:?}\n{text}", before.parse.diagnostics));
    let after = Read::new(&laid_out);
    let both = format!("{text}\n---\n{laid_out}");
    assert_eq!(after.parse.diagnostics, vec![], "{both}");
    assert_eq!(before.words(), after.words(), "{both}");
    assert_eq!(before.tree(), after.tree(), "{both}");
    assert_eq!(before.comments(), after.comments(), "{both}");
    assert_eq!(before.groups(), after.groups(), "{both}");
    assert_eq!(after.formatted().as_ref(), Some(&laid_out), "the second time\n{both}");
    check_form(&laid_out);
    laid_out
}

/// Spaces and line ends as they have to be.
fn check_form(text: &str) {
    assert!(text.is_empty() || text.ends_with('\n') && !text.ends_with("\n\n"), "{text:?}");
    assert!(!text.starts_with('\n') && !text.contains("\n\n\n"), "{text}");
    for line in text.lines() {
        assert_eq!(line.trim_end(), line, "{text}");
        let indent = line.len() - line.trim_start().len();
        assert!(indent % 4 == 0 && !line.starts_with('\t'), "{line:?} in {text}");
    }
}
