//! One pass over the brackets of one region, with or without a look at how the lines are indented.

use crate::diagnostic::{Code, Diagnostic};
use crate::source::Span;
use crate::syntax::lexeme::{Lexeme, Placed, Role};
use crate::syntax::limits::{MAX_DIAGNOSTICS, MAX_NESTING};
use crate::syntax::token::TokenKind;

/// A bracket that is open.
struct Open {
    kind: TokenKind,
    closer: TokenKind,
    span: Span,
    /// The indent of the line it stands on.
    indent: u32,
    /// Whether the next line is indented deeper.
    indented: bool,
}

/// A pass and its results.
pub(super) struct Matcher<'s, 'r> {
    region: &'r [Placed<'s>],
    layout: bool,
    open: Vec<Open>,
    indent: u32,
    /// The balanced lexemes.
    pub(super) out: Vec<Placed<'s>>,
    /// What is wrong.
    pub(super) said: Vec<Diagnostic>,
}

impl<'s, 'r> Matcher<'s, 'r> {
    /// Matches the brackets of a region. With `layout`, an unclosed bracket ends where the lines stop being indented.
    pub(super) fn run(region: &'r [Placed<'s>], layout: bool) -> Self {
        let out = Vec::with_capacity(region.len());
        let mut pass = Matcher { region, layout, open: Vec::new(), indent: 0, out, said: Vec::new() };
        let mut at = 0;
        while at < region.len() {
            at = pass.step(at);
        }
        pass.close_rest();
        pass
    }

    /// Takes one lexeme, or all of what is nested too deeply, and says where to go on.
    fn step(&mut self, at: usize) -> usize {
        let (lexeme, span) = self.region[at];
        if let Some(indent) = lexeme.indent {
            if self.layout {
                self.end_by_layout(at, indent);
            }
            self.indent = indent;
        }
        if let Some(closer) = lexeme.kind.closer() {
            if self.open.len() >= MAX_NESTING {
                return self.cut(at);
            }
            let indented = self.next_line_indent(at).is_some_and(|next| next > self.indent);
            self.open.push(Open { kind: lexeme.kind, closer, span, indent: self.indent, indented });
        } else if lexeme.kind.is_closer() && !self.close(at) {
            return at + 1;
        }
        self.out.push((lexeme, span));
        at + 1
    }

    /// The indent of the line after the one `at` stands on, when only little stands between.
    fn next_line_indent(&self, at: usize) -> Option<u32> {
        if !self.layout {
            return None;
        }
        self.region[at + 1..].iter().take(200).find_map(|(lexeme, _)| lexeme.indent)
    }

    /// Matches a closing bracket; `false` if it is left out or was put in another form.
    fn close(&mut self, at: usize) -> bool {
        let (lexeme, span) = self.region[at];
        let Some(place) = self.open.iter().rposition(|open| open.closer == lexeme.kind) else {
            return self.unmatched(at);
        };
        while self.open.len() > place + 1 {
            if let Some(open) = self.open.pop() {
                self.unclosed(&open, span);
            }
        }
        self.open.pop();
        true
    }

    /// A closing bracket of a kind that is not open: another one is meant, or none.
    fn unmatched(&mut self, at: usize) -> bool {
        let (lexeme, span) = self.region[at];
        let found = lexeme.kind.text().unwrap_or_default();
        let meant = self.open.last().filter(|open| {
            let next = self.region.get(at + 1).map(|(next, _)| next.kind);
            open.kind != TokenKind::OpenBrace && next != Some(open.closer)
        });
        let stray = Diagnostic::new(Code::E0203, span, format!("this `{found}` closes nothing"));
        let Some(open) = meant else {
            self.say(stray.fix("leave it out", span, ""));
            self.mark_last();
            return false;
        };
        let (opened, wanted) = (open.kind.text().unwrap_or_default(), open.closer);
        let wanted_text = wanted.text().unwrap_or_default();
        let wrong = Diagnostic::new(Code::E0203, span, format!("this `{found}` cannot close a `{opened}`"))
            .also(open.span, format!("the `{opened}` is opened here"))
            .fix(format!("close it with `{wanted_text}`"), span, wanted_text);
        self.say(wrong);
        self.open.pop();
        self.out.push((put_in(wanted), span));
        false
    }

    /// Closes the brackets which, by the indent of the line that begins at `at`, have ended.
    fn end_by_layout(&mut self, at: usize, indent: u32) {
        let (lexeme, span) = self.region[at];
        while let Some(open) = self.open.last() {
            let begins = lexeme.kind == TokenKind::Let
                || lexeme.role != Role::Plain
                || open.kind == TokenKind::OpenBrace && !lexeme.kind.is_closer();
            let own_closer = lexeme.kind == open.closer && indent >= open.indent;
            let others = self.open.iter().filter(|other| other.kind == open.kind).count();
            let outer_closer = lexeme.kind == open.closer && indent < open.indent && others > 1;
            let fits = if open.kind == TokenKind::OpenBrace { open.indented } else { !own_closer };
            let ended = indent <= open.indent && fits && (begins && !own_closer || outer_closer);
            let goes_on = |last: TokenKind| last == TokenKind::Comma || last.closer().is_some();
            let fresh = self.out.last().is_some_and(|(last, _)| !goes_on(last.kind));
            if !ended || !(fresh || open.kind == TokenKind::OpenBrace) {
                return;
            }
            if let Some(open) = self.open.pop() {
                self.unclosed(&open, span);
            }
        }
    }

    /// Puts in what closes `open`, and says that it was missing before `found`.
    fn unclosed(&mut self, open: &Open, found: Span) {
        let place = self.put(open.closer, open.span);
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

/// A lexeme that the text does not have.
fn put_in(kind: TokenKind) -> Lexeme<'static> {
    let text = kind.text().unwrap_or_default();
    Lexeme { kind, text, role: Role::Plain, indent: None, suspect: true }
}
