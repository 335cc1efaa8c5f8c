//! From the layout to lines: indents, comments, blank lines, and where columns could stand.

use super::group::Shape;
use super::layout::{Break, INDENT, Layout};
use super::piece::{Piece, Statement};
use super::spacing::space;
use crate::syntax::token::TokenKind;

/// A line without the spaces of its columns.
#[derive(Clone, Debug, Default)]
pub(super) struct Line<'s> {
    /// How many spaces it begins with.
    pub(super) indent: usize,
    /// Whether a blank line stands before it.
    pub(super) blank: bool,
    /// The code, or a comment on its own line.
    pub(super) text: String,
    /// The comment behind the code.
    pub(super) comment: Option<&'s str>,
    /// What its columns are.
    pub(super) kind: Option<Kind>,
    /// Which columns begin at which bytes of the text.
    pub(super) columns: Vec<(usize, usize)>,
}

/// Lines of one kind that follow each other have columns in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A statement: its `=`, its value.
    Statement(Statement),
    /// A point or a list that fills the line: what opens it, and how many parts it has.
    Row(TokenKind, usize),
}

/// The lines of a text.
pub(super) fn lines<'s>(layout: Layout<'_, 's>) -> Vec<Line<'s>> {
    let mut writer = Writer { layout, lines: Vec::new(), frames: Vec::new(), first: 0 };
    for at in 0..writer.layout.pieces.len() {
        writer.piece(at);
    }
    writer.lines.pop_if(|last| last.text.is_empty());
    writer.lines
}

struct Writer<'p, 's> {
    layout: Layout<'p, 's>,
    lines: Vec<Line<'s>>,
    /// For each open bracket that spans lines, the indent of its inside and of what closes it.
    frames: Vec<(usize, usize)>,
    /// The piece that the line began with.
    first: usize,
}

impl<'s> Writer<'_, 's> {
    fn piece(&mut self, at: usize) {
        match self.layout.breaks[at] {
            Break::None => {
                let spaces = space(self.layout.pieces, &self.layout.commas, at);
                self.push(&" ".repeat(spaces));
            }
            found => self.begin_line(at, found),
        }
        self.note_column(at);
        self.push(self.layout.pieces[at].text);
        if self.layout.commas[at] {
            self.push(",");
        }
        let opened = self.layout.groups.opened_by(at);
        if opened.is_some_and(|group| self.layout.groups.all[group].broken) {
            let indent = self.lines.last().map_or(0, |line| line.indent);
            self.frames.push((indent + INDENT, indent));
        }
    }

    fn push(&mut self, text: &str) {
        if let Some(line) = self.lines.last_mut() {
            line.text.push_str(text);
        }
    }

    /// Ends the line, writes the comments, and begins the line of the piece at `at`.
    fn begin_line(&mut self, at: usize, found: Break) {
        let piece: &Piece<'s> = &self.layout.pieces[at];
        let base = self.frames.last().map_or(0, |(inner, _)| *inner);
        let (comments, indent) = match found {
            Break::Close => (base, self.frames.pop().map_or(0, |(_, outer)| outer)),
            Break::Continue => (base + INDENT, base + INDENT),
            Break::Start | Break::None => (base, base),
        };
        let opened = at.checked_sub(1).and_then(|before| self.layout.groups.opened_by(before));
        let mut just_inside = self.lines.is_empty() || opened.is_some();
        for comment in &piece.comments {
            match self.lines.last_mut().filter(|_| !comment.own_line) {
                Some(line) => line.comment = Some(comment.text),
                None => {
                    let blank = comment.blank && !just_inside && found != Break::Continue;
                    let text = comment.text.to_owned();
                    self.lines.push(Line { indent: comments, blank, text, ..Line::default() });
                    just_inside = false;
                }
            }
        }
        let blank = piece.blank && !just_inside && found == Break::Start;
        self.lines.push(Line { indent, blank, ..Line::default() });
        self.first = at;
        self.layout.fit(at, indent);
        let kind = self.kind(at, found);
        if let Some(line) = self.lines.last_mut() {
            line.kind = kind;
        }
    }

    /// What kind of line begins with a piece.
    fn kind(&self, at: usize, found: Break) -> Option<Kind> {
        if found != Break::Start {
            return None;
        }
        match self.layout.pieces[at].mark.statement {
            Some(Statement::Other | Statement::Fields | Statement::Members) => None,
            Some(statement) => Some(Kind::Statement(statement)),
            None => self.row(at),
        }
    }

    /// Whether a point or a list fills the line that begins with it.
    fn row(&self, at: usize) -> Option<Kind> {
        let group = &self.layout.groups.all[self.layout.groups.opened_by(at)?];
        let whole = self.layout.breaks[at + 1..=group.close].iter().all(|found| *found == Break::None);
        let alone = self.layout.breaks.get(group.close + 1).is_some_and(|next| *next != Break::None);
        let parts = group.elements.len();
        let opener = self.layout.pieces[at].kind;
        let fits = whole && alone && group.shape == Shape::Elements && opener != TokenKind::OpenBrace;
        (fits && parts > 1).then_some(Kind::Row(opener, parts))
    }

    /// Notes the column that begins with a piece, if one does.
    fn note_column(&mut self, at: usize) {
        let Some(column) = self.column(at) else { return };
        if let Some(line) = self.lines.last_mut() {
            line.columns.push((line.text.len(), column));
        }
    }

    fn column(&self, at: usize) -> Option<usize> {
        let line = self.lines.last()?;
        let layout = &self.layout;
        match line.kind? {
            Kind::Statement(_) => {
                let own = layout.groups.around[at] == layout.groups.around[self.first];
                let piece = &layout.pieces[at];
                let last = layout.breaks.get(at + 1).is_some_and(|next| *next != Break::None);
                let equals = piece.kind == TokenKind::Equals && !last;
                let found = piece.mark.column.map(usize::from).or(equals.then_some(0));
                found.filter(|_| own)
            }
            Kind::Row(..) => {
                let group = layout.groups.opened_by(self.first).map(|group| &layout.groups.all[group])?;
                group.elements.binary_search(&at).ok().filter(|number| *number > 0)
            }
        }
    }
}
