//! The tokens around the cursor: the word that is being written, what stands before it, and the brackets that are open.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::{Token, TokenKind};

/// An open bracket, by the place of its token.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Open {
    pub(crate) kind: TokenKind,
    pub(crate) at: usize,
}

/// What stands before the cursor in its item.
#[derive(Clone)]
pub(crate) struct Before<'a> {
    text: &'a str,
    /// The tokens of the item up to the word, without trivia.
    pub(crate) tokens: Vec<Token>,
    /// The brackets that are open at the word, outermost first.
    pub(crate) open: Vec<Open>,
    /// The word around the cursor, or the empty place at it.
    pub(crate) word: Span,
    /// Whether a line ends between the last token and the word.
    pub(crate) new_line: bool,
    /// What follows the word.
    pub(crate) next: Option<TokenKind>,
    /// Whether that stands on the line where the word ends.
    pub(crate) next_on_line: bool,
    /// How many of the open brackets, innermost first, nothing behind the word closes.
    unclosed: usize,
}

/// What the cursor is in.
pub(crate) enum Cursor<'a> {
    /// Space, or a word.
    Code(Before<'a>),
    /// Right behind a number, or in its unit: the number is the word.
    Number(Before<'a>),
    /// In a text: the tokens before it.
    Text(Before<'a>, Token),
    /// In a comment.
    Comment,
}

/// What the cursor is in.
pub(crate) fn cursor(analysis: &Analysis, file: FileId, offset: u32) -> Option<Cursor<'_>> {
    let parse = &analysis.files.iter().find(|parsed| parsed.file == file)?.parse;
    let text = &analysis.sources.get(file)?.text;
    let all = &parse.tokens;
    let left = all.iter().position(|token| token.span.start < offset && offset <= token.span.end);
    let touched = left.map(|at| (at, all[at]));
    let here = Span::new(file, offset, offset);
    let Some((at, token)) = touched else { return Some(Cursor::Code(before(text, all, 0, here))) };
    let inside = offset < token.span.end;
    let unclosed = |quoted: &str| quoted.len() < 2 || !quoted.ends_with('"');
    Some(match token.kind {
        TokenKind::Comment | TokenKind::ItemDocs | TokenKind::FileDocs => Cursor::Comment,
        TokenKind::Text if inside || unclosed(text.get(token.span.range())?) => {
            Cursor::Text(before(text, all, at, here), token)
        }
        TokenKind::Number(_) | TokenKind::BadNumber => Cursor::Number(before(text, all, at, token.span)),
        kind if kind == TokenKind::Name || kind.is_keyword() => {
            Cursor::Code(before(text, all, at, token.span))
        }
        _ => Cursor::Code(before(text, all, at + 1, here)),
    })
}

/// The item that holds the first `count` tokens' end.
fn before<'a>(text: &'a str, all: &[Token], count: usize, word: Span) -> Before<'a> {
    let mut tokens: Vec<Token> = Vec::new();
    let mut open: Vec<Open> = Vec::new();
    for (at, token) in all[..count].iter().enumerate().filter(|(_, token)| !token.kind.is_trivia()) {
        let public = tokens.len() == 1 && tokens[0].kind == TokenKind::Pub;
        if begins(text, all, at, open.is_empty()) && !public {
            tokens.clear();
            open.clear();
        }
        if token.kind.closer().is_some() {
            open.push(Open { kind: token.kind, at: tokens.len() });
        } else if token.kind.is_closer() {
            let fits = open.iter().rposition(|open| open.kind.closer() == Some(token.kind));
            if let Some(place) = fits {
                open.truncate(place);
            }
        }
        tokens.push(*token);
    }
    let from = tokens.last().map_or(0, |token| token.span.end) as usize;
    let new_line = text.get(from..word.start as usize).is_some_and(|between| between.contains('\n'));
    let following = all[count..].iter().find(|token| !token.kind.is_trivia() && token.span.start >= word.end);
    let next_on_line = following.is_some_and(|next| {
        text.get(word.end as usize..next.span.start as usize).is_some_and(|between| !between.contains('\n'))
    });
    let next = following.map(|token| token.kind);
    let unclosed = unclosed(text, all, count, word.end, &open);
    Before { text, tokens, open, word, new_line, next, next_on_line, unclosed }
}

/// Whether an item begins with a token; `outside` says that no bracket is open before it.
fn begins(text: &str, all: &[Token], at: usize, outside: bool) -> bool {
    let token = all[at];
    token.kind.is_item_keyword() && begins_item(text, all, at)
        || token.kind == TokenKind::Let && (outside || starts_line(text, token.span.start))
}

/// How many of the brackets that are open before `from`, innermost first, the rest of the item does not close before it
/// closes one around them, or at all.
fn unclosed(text: &str, all: &[Token], count: usize, from: u32, open: &[Open]) -> usize {
    let mut inner: Vec<TokenKind> = Vec::new();
    for (at, token) in all.iter().enumerate().skip(count) {
        if token.kind.is_trivia() || token.span.start < from {
            continue;
        }
        if begins(text, all, at, inner.is_empty() && open.is_empty()) {
            break;
        }
        if token.kind.closer().is_some() {
            inner.push(token.kind);
        } else if token.kind.is_closer() {
            let closes = |opened: TokenKind| opened.closer() == Some(token.kind);
            match inner.iter().rposition(|opened| closes(*opened)) {
                Some(place) => inner.truncate(place),
                None => {
                    if let Some(place) = open.iter().rposition(|opened| closes(opened.kind)) {
                        return open.len() - 1 - place;
                    }
                }
            }
        }
    }
    open.len()
}

fn starts_line(text: &str, at: u32) -> bool {
    at == 0 || text.as_bytes().get(at as usize - 1) == Some(&b'\n')
}

/// Whether a keyword begins an item, as the compiler sees it: it begins its line, or is followed by a name; no label.
fn begins_item(text: &str, all: &[Token], at: usize) -> bool {
    let next = all[at + 1..].iter().find(|token| !token.kind.is_trivia()).map(|token| token.kind);
    if next == Some(TokenKind::Colon) {
        return false;
    }
    let line = text[..all[at].span.start as usize].rsplit('\n').next().unwrap_or("");
    let keyword = next.is_some_and(TokenKind::is_keyword);
    line.trim().is_empty() || keyword || matches!(next, Some(TokenKind::Name | TokenKind::Text))
}

/// What stands before a place, whatever it is in.
pub(crate) fn up_to(analysis: &Analysis, file: FileId, offset: u32) -> Option<Before<'_>> {
    let parse = &analysis.files.iter().find(|parsed| parsed.file == file)?.parse;
    let text = &analysis.sources.get(file)?.text;
    let count = parse.tokens.iter().take_while(|token| token.span.end <= offset).count();
    Some(before(text, &parse.tokens, count, Span::new(file, offset, offset)))
}

impl Before<'_> {
    pub(crate) fn written(&self, at: usize) -> &str {
        self.tokens.get(at).and_then(|token| self.text.get(token.span.range())).unwrap_or("")
    }

    /// The `back`-th token before the word; 1 is the last.
    pub(crate) fn back(&self, back: usize) -> Option<TokenKind> {
        Some(self.tokens.get(self.tokens.len().checked_sub(back)?)?.kind)
    }

    pub(crate) fn back_text(&self, back: usize) -> &str {
        self.tokens.len().checked_sub(back).map_or("", |at| self.written(at))
    }

    /// The word that begins the item, behind `pub`.
    pub(crate) fn item(&self) -> Option<TokenKind> {
        self.tokens.iter().map(|token| token.kind).find(|kind| *kind != TokenKind::Pub)
    }

    /// Whether what stands before the word could be the end of a value.
    pub(crate) fn after_value(&self) -> bool {
        self.value_ends(self.tokens.len())
    }

    /// Whether the first `count` tokens could end with a value.
    pub(crate) fn value_ends(&self, count: usize) -> bool {
        use TokenKind::*;
        let Some(last) = count.checked_sub(1) else { return false };
        match self.tokens[last].kind {
            Name => !self.is_operator_word(last),
            Number(_) | BadNumber | Text | Itself | True | False => true,
            kind => kind.is_closer(),
        }
    }

    /// Whether a name is a word that stands before a value.
    fn is_operator_word(&self, at: usize) -> bool {
        let word = self.written(at);
        let back = at.checked_sub(1).map(|back| self.tokens[back].kind);
        let label = back == Some(TokenKind::Dot);
        let begins = matches!(word, "germ" | "keep" | "require" | "assert" | "until" | "join")
            && !matches!(back, Some(TokenKind::Colon | TokenKind::Equals | TokenKind::Plus));
        !label && (matches!(word, "by" | "and" | "or" | "not" | "step" | "level" | "as" | "each") || begins)
    }

    /// What stands before one of the tokens, which must be there, as if the word were written there.
    pub(crate) fn cut(&self, at: usize) -> Self {
        let here = self.tokens[at].span;
        let mut cut = self.clone();
        cut.tokens.truncate(at);
        cut.open.retain(|open| open.at < at);
        cut.word = Span::new(here.file, here.start, here.start);
        let from = cut.tokens.last().map_or(0, |token| token.span.end);
        let between = self.text.get(from as usize..here.start as usize);
        cut.new_line = between.is_some_and(|between| between.contains('\n'));
        cut.next = Some(self.tokens[at].kind);
        cut.next_on_line = true;
        cut.unclosed = cut.unclosed.min(cut.open.len());
        cut
    }

    /// The tokens of what is being written in the innermost bracket, by their places: since its last comma, in braces
    /// since the word that begins the line. Of brackets inside only the ends are among them.
    pub(crate) fn statement(&self) -> Vec<usize> {
        let (mut part, mut depth) = (Vec::new(), 0usize);
        for at in self.open.last().map_or(0, |open| open.at + 1)..self.tokens.len() {
            let kind = self.tokens[at].kind;
            if kind.is_closer() {
                depth = depth.saturating_sub(1);
            }
            match (depth, kind) {
                (0, TokenKind::Comma) => part.clear(),
                (0, _) => part.push(at),
                _ => {}
            }
            if kind.closer().is_some() {
                depth += 1;
            }
        }
        let braces = self.open.last().is_some_and(|open| open.kind == TokenKind::OpenBrace);
        if braces && let Some(start) = part.iter().rposition(|at| self.begins_line(*at)) {
            part.drain(..start);
        }
        part
    }

    /// Whether a token begins a member of an ifs, a line of a test, or a setting or a requirement of a block.
    fn begins_line(&self, at: usize) -> bool {
        let label = self.tokens.get(at + 1).is_some_and(|next| next.kind == TokenKind::Colon);
        let begins = match (self.item(), self.tokens[at].kind) {
            (Some(TokenKind::Ifs | TokenKind::Test), TokenKind::Let) => true,
            (Some(TokenKind::Ifs), TokenKind::Name) => {
                matches!(self.written(at), "transform" | "germ" | "keep" | "boundary" | "join")
            }
            (Some(TokenKind::Test), TokenKind::Name) => self.written(at) == "assert",
            (_, TokenKind::Name) => label || self.written(at) == "require",
            _ => false,
        };
        let before = at.checked_sub(1).map(|back| self.tokens[back].kind);
        begins && (before == Some(TokenKind::OpenBrace) || self.value_ends(at))
    }

    /// The brackets that the item leaves open at the word and does not close behind it, closed.
    fn closing(&self) -> String {
        let open = self.open.iter().rev().take(self.unclosed);
        open.filter_map(|open| open.kind.closer()?.text()).collect()
    }

    /// What must stand behind a name at the word so that it can be understood; `sound` says whether the text is as it is.
    pub(crate) fn completed(&self, sound: bool) -> String {
        match self.next {
            _ if sound || self.unclosed == 0 && !self.open.is_empty() => self.parting().to_owned(),
            Some(next) if next.is_closer() => String::new(),
            _ => self.closing(),
        }
    }

    /// What parts a value at the word from one that follows on its line, so that both can stand: a comma or an operator.
    fn parting(&self) -> &'static str {
        use TokenKind::*;
        let value = matches!(
            self.next,
            Some(Name | Number(_) | BadNumber | Text | Itself | True | False | OpenParenthesis | OpenBracket)
        );
        match self.back(1) {
            _ if !value || !self.next_on_line || self.word.start < self.word.end => "",
            Some(Comma | OpenParenthesis | OpenBracket) => ", ",
            _ => " + ",
        }
    }

    /// Where the token stands, or would, that is the first since the last comma of an open bracket.
    pub(crate) fn argument(&self, open: Open) -> usize {
        let (mut start, mut depth) = (open.at + 1, 0usize);
        for (at, token) in self.tokens.iter().enumerate().skip(open.at + 1) {
            match token.kind {
                TokenKind::Comma if depth == 0 => start = at + 1,
                kind if kind.closer().is_some() => depth += 1,
                kind if kind.is_closer() => depth = depth.saturating_sub(1),
                _ => {}
            }
        }
        start
    }

    /// The names before a colon in the innermost bracket, and how many commas it has.
    pub(crate) fn given(&self) -> (Vec<&str>, usize) {
        self.open.last().map_or((Vec::new(), 0), |open| self.given_in(*open))
    }

    /// The same of an open bracket.
    pub(crate) fn given_in(&self, open: Open) -> (Vec<&str>, usize) {
        let (mut names, mut commas, mut depth) = (Vec::new(), 0, 0usize);
        for at in open.at + 1..self.tokens.len() {
            let kind = self.tokens[at].kind;
            match kind {
                TokenKind::Comma if depth == 0 => commas += 1,
                TokenKind::Colon if depth == 0 => names.push(self.written(at - 1)),
                kind if kind.closer().is_some() => depth += 1,
                kind if kind.is_closer() => depth = depth.saturating_sub(1),
                _ => {}
            }
        }
        (names, commas)
    }
}
