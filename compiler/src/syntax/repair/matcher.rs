//! One pass over the brackets of one region, with or without a look at how the lines are indented.

use crate::diagnostic::{Code, Diagnostic};
use crate::source::Span;
use crate::syntax::lexeme::{Lexeme, Placed, Role};
use crate::syntax::limits::{MAX_DIAGNOSTICS, MAX_NESTING};
use crate::syntax::token::TokenKind;

/// A bracket that is open.
pub(super) struct Open {
    pub(super) kind: TokenKind,
    pub(super) closer: TokenKind,
    pub(super) span: Span,
    /// Where it stands in the output.
    pub(super) place: usize,
    /// The indent of the line it stands on.
    pub(super) indent: u32,
    /// Whether the next line is indented deeper, or what is inside begins on the same line.
    pub(super) indented: bool,
    /// Whether it is the body of a loop or a condition as other languages have them.
    pub(super) foreign: bool,
}

/// How far doubt and lookahead reach, in lexemes, so that the work stays linear.
pub(super) const FAR: usize = 500;

/// A pass and its results.
pub(super) struct Matcher<'s, 'r> {
    pub(super) region: &'r [Placed<'s>],
    pub(super) layout: bool,
    pub(super) open: Vec<Open>,
    pub(super) indent: u32,
    /// Where the last outermost brace was closed.
    pub(super) block_end: Option<usize>,
    /// Whether what follows is in doubt, up to the next statement.
    pub(super) doubt: bool,
    /// The balanced lexemes.
    pub(super) out: Vec<Placed<'s>>,
    /// What is wrong.
    pub(super) said: Vec<Diagnostic>,
}

impl<'s, 'r> Matcher<'s, 'r> {
    /// Matches the brackets of a region. With `layout`, an unclosed bracket ends where the lines stop being indented.
    pub(super) fn run(region: &'r [Placed<'s>], layout: bool) -> Self {
        let out = Vec::with_capacity(region.len());
        let (open, said) = (Vec::new(), Vec::new());
        let mut pass = Matcher { region, layout, open, indent: 0, block_end: None, doubt: false, out, said };
        let mut at = 0;
        while at < region.len() {
            at = pass.step(at);
        }
        pass.close_rest();
        pass
    }

    /// Takes one lexeme, or all of what is nested too deeply, and says where to go on.
    fn step(&mut self, at: usize) -> usize {
        let (mut lexeme, span) = self.region[at];
        if let Some(indent) = lexeme.indent {
            if self.layout {
                self.end_by_layout(at, indent);
            }
            self.indent = indent;
        }
        self.end_by_meaning(lexeme, span);
        if let Some(closer) = lexeme.kind.closer() {
            if self.open.len() >= MAX_NESTING {
                return self.cut(at);
            }
            let inline = self.region.get(at + 1).is_some_and(|(next, _)| next.indent.is_none());
            let indented = inline || self.next_line_indent(at).is_some_and(|next| next > self.indent);
            let place = self.out.len();
            let foreign = lexeme.kind == TokenKind::OpenBrace && self.after_foreign_head();
            let (kind, indent) = (lexeme.kind, self.indent);
            self.open.push(Open { kind, closer, span, place, indent, indented, foreign });
        } else if lexeme.kind.is_closer() && !self.close(at) {
            return at + 1;
        }
        self.doubt &= !begins_statement(lexeme);
        lexeme.suspect |= self.doubt;
        self.out.push((lexeme, span));
        at + 1
    }

    /// Matches a closing bracket; `false` if it is left out or was put in another form.
    fn close(&mut self, at: usize) -> bool {
        let (lexeme, span) = self.region[at];
        let Some(place) = self.open.iter().rposition(|open| open.closer == lexeme.kind) else {
            return self.unmatched(at);
        };
        let inner = self.open.last().is_some_and(|inner| inner.kind != TokenKind::OpenBrace);
        let kind = self.open[place].kind;
        if inner && place + 1 < self.open.len() && self.all_close_later(kind, lexeme.kind, at + 1) {
            return self.wrong_closer(at);
        }
        self.unclosed_above(place + 1, span);
        self.open.pop();
        if self.open.is_empty() && lexeme.kind == TokenKind::CloseBrace {
            self.block_end = Some(self.out.len());
        }
        true
    }

    /// A closing bracket of a kind that is not open: another one is meant, or none. `true` if it may stay.
    fn unmatched(&mut self, at: usize) -> bool {
        let (lexeme, span) = self.region[at];
        let found = lexeme.kind.text().unwrap_or_default();
        let meant = self.open.last().filter(|open| open.kind != TokenKind::OpenBrace);
        if meant.is_some_and(|open| !self.all_close_later(open.kind, open.closer, at + 1)) {
            return self.wrong_closer(at);
        }
        if lexeme.kind == TokenKind::CloseBrace
            && self.open.is_empty()
            && let Some(missing) = super::block::open(&mut self.out)
        {
            self.say(missing);
            self.block_end = Some(self.out.len());
            return true;
        }
        let start = self.block_end.filter(|_| lexeme.kind == TokenKind::CloseBrace);
        self.distrust(start.unwrap_or_default(), start.is_none());
        let stray = Diagnostic::new(Code::E0203, span, format!("this `{found}` closes nothing"));
        self.say(stray.fix("leave it out, or open it before", span, ""));
        false
    }

    /// Puts the closing bracket that is meant in the place of the one that was written.
    fn wrong_closer(&mut self, at: usize) -> bool {
        let (lexeme, span) = self.region[at];
        let Some(open) = self.open.pop() else { return false };
        let found = lexeme.kind.text().unwrap_or_default();
        let (opened, right) = (open.kind.text().unwrap_or_default(), open.closer.text().unwrap_or_default());
        self.out.push((put_in(open.closer), span));
        self.say(
            Diagnostic::new(Code::E0203, span, format!("this `{found}` cannot close a `{opened}`"))
                .also(open.span, format!("the `{opened}` is opened here"))
                .fix(format!("close it with `{right}`"), span, right),
        );
        false
    }

    /// Whether all open brackets of a kind are still closed by their own kind, not far after `at`.
    fn all_close_later(&self, kind: TokenKind, closer: TokenKind, at: usize) -> bool {
        let mut wanting = self.open.iter().filter(|open| open.kind == kind).count();
        let mut depth = 0usize;
        for (lexeme, _) in self.region[at..].iter().take(FAR) {
            if lexeme.kind == kind {
                depth += 1;
            } else if lexeme.kind == closer && depth > 0 {
                depth -= 1;
            } else if lexeme.kind == closer {
                wanting -= 1;
            } else if begins_statement(*lexeme) {
                return false;
            }
            if wanting == 0 {
                return true;
            }
        }
        false
    }

    /// Puts what was made of the lexemes since `start` in doubt, and what follows up to the next statement. With
    /// `statement`, only back to where the statement began.
    fn distrust(&mut self, start: usize, statement: bool) {
        for (lexeme, _) in self.out[start..].iter_mut().rev().take(FAR) {
            lexeme.suspect = true;
            if statement && begins_statement(*lexeme) {
                break;
            }
        }
        self.doubt = true;
    }

    /// Closes all but the first `keep` open brackets before `found`.
    pub(super) fn unclosed_above(&mut self, keep: usize, found: Span) {
        while self.open.len() > keep {
            if let Some(open) = self.open.pop() {
                self.unclosed(&open, found);
            }
        }
    }

    /// Puts in what closes `open`, and says that it was missing before `found`.
    pub(super) fn unclosed(&mut self, open: &Open, found: Span) {
        let place = self.put(open.closer, open.span);
        self.distrust(open.place, false);
        let closer = open.closer.text().unwrap_or_default();
        self.say(unclosed(open).also(found, format!("`{closer}` is missing before this")).fix(
            format!("close it with `{closer}`"),
            place,
            closer,
        ));
    }

    /// Closes what is still open at the end: one diagnostic for the innermost, which names the others.
    fn close_rest(&mut self) {
        let Some(innermost) = self.open.pop() else { return };
        let closers: Vec<TokenKind> =
            self.open.iter().rev().map(|open| open.closer).fold(vec![innermost.closer], |mut all, closer| {
                all.push(closer);
                all
            });
        self.distrust(innermost.place, false);
        let mut missing = String::new();
        let mut place = innermost.span.after();
        for closer in closers {
            place = self.put(closer, innermost.span);
            missing.push_str(closer.text().unwrap_or_default());
        }
        let mut found = unclosed(&innermost).fix(format!("close it with `{missing}`"), place, missing);
        for open in self.open.iter().rev().take(3) {
            let opener = open.kind.text().unwrap_or_default();
            found = found.also(open.span, format!("this `{opener}` is open too"));
        }
        self.open.clear();
        self.say(found);
    }

    /// Puts a bracket in after the last lexeme, and says where that is.
    fn put(&mut self, kind: TokenKind, fallback: Span) -> Span {
        self.mark_last();
        let place = self.out.last().map_or(fallback, |(_, span)| *span).after();
        self.out.push((put_in(kind), place));
        place
    }

    /// Replaces what is nested too deeply, up to its end, by one lexeme that stands for it.
    fn cut(&mut self, at: usize) -> usize {
        let (_, span) = self.region[at];
        let mut depth = 0usize;
        let mut end = self.region.len();
        for (place, (lexeme, _)) in self.region.iter().enumerate().skip(at) {
            if lexeme.kind.closer().is_some() {
                depth += 1;
            } else if lexeme.kind.is_closer() {
                depth -= 1;
            }
            if depth == 0 {
                end = place + 1;
                break;
            }
        }
        let deep = format!("brackets are nested more than {MAX_NESTING} deep");
        self.say(
            Diagnostic::new(Code::E0107, span, deep)
                .label(format!("bracket number {} that is open here", MAX_NESTING + 1))
                .hint("give the inner part a name with `let`"),
        );
        let whole = span.to(self.region[end - 1].1);
        self.out.push((put_in(TokenKind::Error), whole));
        if depth > 0 {
            self.close_silently();
        }
        end
    }

    /// Closes all that is open without a word: one has been said already.
    fn close_silently(&mut self) {
        while let Some(open) = self.open.pop() {
            self.put(open.closer, open.span);
        }
    }

    fn mark_last(&mut self) {
        if let Some((last, _)) = self.out.last_mut() {
            last.suspect = true;
        }
    }

    fn say(&mut self, diagnostic: Diagnostic) {
        if self.said.len() < MAX_DIAGNOSTICS {
            self.said.push(diagnostic);
        }
    }
}

fn unclosed(open: &Open) -> Diagnostic {
    let opener = open.kind.text().unwrap_or_default();
    Diagnostic::new(Code::E0202, open.span, format!("this `{opener}` is never closed")).label("opened here")
}

/// Whether a field, a member or a line of a test begins with this.
fn begins_statement(lexeme: Lexeme<'_>) -> bool {
    match lexeme.role {
        Role::Plain => lexeme.kind == TokenKind::Let,
        Role::Label => lexeme.indent.is_some(),
        _ => true,
    }
}

/// A lexeme that the text does not have.
pub(super) fn put_in(kind: TokenKind) -> Lexeme<'static> {
    let text = kind.text().unwrap_or_default();
    Lexeme { kind, text, role: Role::Plain, indent: None, suspect: true }
}
