//! Where lines end: what the author chose, as far as it may stay, and what is broken because it is too long.

use super::COLUMNS;
use super::group::{Group, Groups, Shape};
use super::piece::{Piece, Statement};
use super::spacing::{may_break, space};
use crate::syntax::token::TokenKind;

/// How wide the elements of a list are at most which fill its lines.
const SHORT: usize = 16;
/// How wide a bracket must be for a line to be broken there.
const WORTHWHILE: usize = 24;
/// The spaces of one indent.
pub(super) const INDENT: usize = 4;

/// What stands before a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Break {
    /// It stands on the line of the piece before it.
    None,
    /// It begins a line, and with it an item, an entry or an element.
    Start,
    /// It begins a line and closes a bracket.
    Close,
    /// It begins a later line of a statement or an element.
    Continue,
}

/// The pieces, their groups, and where lines end.
pub(super) struct Layout<'p, 's> {
    /// The pieces.
    pub(super) pieces: &'p [Piece<'s>],
    /// Their brackets.
    pub(super) groups: Groups,
    /// What stands before each piece.
    pub(super) breaks: Vec<Break>,
    /// Whether a comma is written after each piece.
    pub(super) commas: Vec<bool>,
    /// The column at which each piece would stand if the text were one line.
    starts: Vec<usize>,
}

impl<'p, 's> Layout<'p, 's> {
    /// The layout the author chose, in order.
    pub(super) fn new(pieces: &'p [Piece<'s>], groups: Groups) -> Self {
        let commas = commas(pieces.len(), &groups);
        let starts = starts(pieces, &commas);
        let breaks = vec![Break::None; pieces.len()];
        let mut layout = Layout { pieces, groups, breaks, commas, starts };
        layout.break_groups();
        layout.break_statements();
        layout
    }

    /// Breaks the brackets that the author broke, or that have comments between their elements.
    fn break_groups(&mut self) {
        let ends = |piece: &Piece<'_>| piece.newline || !piece.comments.is_empty();
        let mut before = Vec::with_capacity(self.pieces.len());
        let mut count = 0usize;
        for piece in self.pieces {
            count += usize::from(ends(piece));
            before.push(count);
        }
        for index in 0..self.groups.all.len() {
            let group = &self.groups.all[index];
            let here = |at: &usize| ends(&self.pieces[*at]);
            let empty = group.elements.is_empty();
            let chosen = match group.shape {
                Shape::Fixed => false,
                _ if empty => !self.pieces[group.close].comments.is_empty(),
                Shape::Block(_) => before[group.close] > before[group.open],
                _ => here(&group.close) || group.elements.iter().any(here),
            };
            if chosen {
                let block = matches!(group.shape, Shape::Block(_));
                self.open(index, |at, place| at == 0 || block || ends(place));
            }
        }
    }

    /// Lets a group span lines. Which elements begin a line is said by their index and first piece.
    fn open(&mut self, index: usize, mut begins: impl FnMut(usize, &Piece<'s>) -> bool) {
        let pieces = self.pieces;
        let group = &mut self.groups.all[index];
        group.broken = true;
        for (number, element) in group.elements.iter().enumerate() {
            if begins(number, &pieces[*element]) {
                self.breaks[*element] = Break::Start;
            }
            if matches!(group.shape, Shape::Block(_)) {
                self.commas[element - 1] = false;
            }
        }
        self.breaks[group.close] = Break::Close;
        if group.shape == Shape::Elements && !group.elements.is_empty() {
            self.commas[group.close - 1] = true;
        }
    }

    /// Begins a line with each item, and after each comment; keeps the line ends that may stay.
    fn break_statements(&mut self) {
        for (at, piece) in self.pieces.iter().enumerate() {
            if self.breaks[at] != Break::None {
                continue;
            }
            let outermost = self.groups.around[at].is_none();
            let end = at + 1 == self.pieces.len();
            if outermost && piece.mark.statement.is_some() || end {
                self.breaks[at] = Break::Start;
            } else if !piece.comments.is_empty()
                || piece.newline && may_break(self.pieces, at, self.groups.in_statement(at))
            {
                self.breaks[at] = Break::Continue;
            }
        }
    }

    /// The first piece after `at` that begins a line.
    fn line_end(&self, at: usize) -> usize {
        let mut rest = self.breaks.iter().enumerate().skip(at + 1);
        rest.find(|(_, found)| **found != Break::None).map_or(self.pieces.len(), |(end, _)| end)
    }

    /// The width of some pieces on one line, the comma after them included.
    fn width(&self, from: usize, to: usize) -> usize {
        let Some(last) = to.checked_sub(1).filter(|last| *last >= from) else { return 0 };
        let comma = usize::from(self.commas[last]);
        self.starts[last] - self.starts[from] + length(&self.pieces[last]) + comma
    }

    /// Breaks the line that begins with the piece at `at` until it fits, as far as it can be broken.
    pub(super) fn fit(&mut self, at: usize, indent: usize) {
        loop {
            let end = self.line_end(at);
            if indent + self.width(at, end) <= COLUMNS {
                return;
            }
            let broken = self.break_after_equals(at, end, indent)
                || self.open_block(at, end)
                || self.fill_row(at, end, indent)
                || self.open_widest(at, end);
            if !broken {
                return;
            }
        }
    }

    /// Puts the value of a statement on a line of its own, where it fits there.
    fn break_after_equals(&mut self, at: usize, end: usize, indent: usize) -> bool {
        let around = self.groups.around[at];
        let whole = self.pieces[at].mark.statement.is_some()
            && matches!(self.breaks.get(end), Some(Break::Start | Break::Close));
        let same = |place: &usize| {
            self.groups.around[*place] == around && self.pieces[*place].kind == TokenKind::Equals
        };
        let Some(equals) = (at..end).find(same).filter(|_| whole) else { return false };
        let fits = indent + INDENT + self.width(equals + 1, end) <= COLUMNS;
        if fits {
            self.breaks[equals + 1] = Break::Continue;
        }
        fits
    }

    /// Gives each entry of a block a line.
    fn open_block(&mut self, at: usize, end: usize) -> bool {
        let block = |place| self.groups.opened_by(place).filter(|group| self.groups.is_block(*group));
        let found = (at..end).find_map(block).filter(|group| self.may_open(*group));
        if let Some(group) = found {
            self.open(group, |_, _| true);
        }
        found.is_some()
    }

    /// Whether a group stands on one line and has something in it.
    fn may_open(&self, group: usize) -> bool {
        let Group { broken, shape, elements, .. } = &self.groups.all[group];
        !broken && *shape != Shape::Fixed && !elements.is_empty()
    }

    /// Moves elements of a row to further lines.
    fn fill_row(&mut self, at: usize, end: usize, indent: usize) -> bool {
        let around = self.groups.around[at].filter(|group| self.groups.all[*group].broken);
        let Some(group) = around else { return false };
        let elements = &self.groups.all[group].elements;
        let first = elements.partition_point(|element| *element <= at);
        let mut row = at;
        let mut filled = false;
        for index in first..elements.len() {
            let element = elements[index];
            if element >= end {
                break;
            }
            let next = elements.get(index + 1).map_or(end, |next| (*next).min(end));
            if indent + self.width(row, next) > COLUMNS {
                self.breaks[element] = Break::Start;
                (row, filled) = (element, true);
            }
        }
        filled
    }

    /// Breaks the widest of the outermost brackets that open on a line.
    fn open_widest(&mut self, at: usize, end: usize) -> bool {
        let mut widest = None;
        let mut place = at;
        while place < end {
            let Some(index) = self.groups.opened_by(place) else {
                place += 1;
                continue;
            };
            let group = &self.groups.all[index];
            let width = self.width(group.open, group.close + 1);
            let wider = widest.is_none_or(|(widest, _)| width > widest);
            if self.may_open(index) && width >= WORTHWHILE && wider {
                widest = Some((width, index));
            }
            place = if group.broken { place } else { group.close } + 1;
        }
        let Some((_, widest)) = widest else { return false };
        let group = self.innermost_alone(widest);
        let fills = self.is_list_of_short(group);
        self.open(group, |number, _| number == 0 || !fills);
        true
    }

    /// Where brackets hold nothing but one thing that ends with brackets, those: `f([…])` is broken inside `[]`.
    fn innermost_alone(&self, mut group: usize) -> usize {
        loop {
            let Group { close, elements, .. } = &self.groups.all[group];
            let inner = self.groups.of[close - 1].filter(|inner| self.may_open(*inner));
            match inner.filter(|_| elements.len() == 1) {
                Some(inner) => group = inner,
                None => return group,
            }
        }
    }

    fn is_list_of_short(&self, group: usize) -> bool {
        let Group { open, close, elements, shape, .. } = &self.groups.all[group];
        let list = self.pieces[*open].kind == TokenKind::OpenBracket && *shape == Shape::Elements;
        let ends = elements.iter().skip(1).chain(std::iter::once(close));
        list && elements.iter().zip(ends).all(|(from, to)| self.width(*from, *to) <= SHORT)
    }
}

/// How many columns a piece takes.
pub(super) fn length(piece: &Piece<'_>) -> usize {
    piece.text.chars().count()
}

/// The commas between elements.
fn commas(pieces: usize, groups: &Groups) -> Vec<bool> {
    let mut commas = vec![false; pieces];
    for group in &groups.all {
        if matches!(group.shape, Shape::Elements | Shape::Block(Statement::Fields)) {
            group.elements.iter().skip(1).for_each(|element| commas[element - 1] = true);
        }
    }
    commas
}

/// The column of each piece on one endless line.
fn starts(pieces: &[Piece<'_>], commas: &[bool]) -> Vec<usize> {
    let mut starts = Vec::with_capacity(pieces.len());
    let mut column = 0usize;
    for (at, piece) in pieces.iter().enumerate() {
        column += space(pieces, commas, at);
        starts.push(column);
        column += length(piece) + usize::from(commas[at]);
    }
    starts
}
