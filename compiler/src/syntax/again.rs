//! Parsing a text again after a change of it: items that the change has left alone are taken from the earlier tree. What
//! comes out is what parsing the text alone gives; it only takes less time.

use super::Parse;
use super::ast::Item;
use super::ast::moved::{Places, Shift};
use crate::source::{FileId, Source, Span};

/// An earlier text of a file, and what the two have in common.
pub(super) struct Earlier {
    /// Its items, in order; those that are taken are gone.
    items: Vec<Option<Item>>,
    /// Where they are.
    places: Vec<Span>,
    /// Which of them were read without a doubt.
    sound: Vec<bool>,
    /// The file of the text as it is now.
    file: FileId,
    /// How many bytes are the same at the start.
    start: u32,
    /// Where the bytes begin that are the same to the end, in the text as it is now.
    end: u32,
    /// By how much those have moved.
    by: i64,
}

impl Earlier {
    /// What of an earlier text is found in a text; `None` where one of them is too long for places.
    pub(super) fn of(source: &Source, before: &Source, parse: Parse) -> Option<Earlier> {
        let (now, then) = (source.text.as_bytes(), before.text.as_bytes());
        let start = now.iter().zip(then).take_while(|(now, then)| now == then).count();
        let rest = now[start..].iter().rev().zip(then[start..].iter().rev());
        let same = rest.take_while(|(now, then)| now == then).count();
        let by = i64::try_from(now.len()).ok()? - i64::try_from(then.len()).ok()?;
        let (start, end) = (u32::try_from(start).ok()?, u32::try_from(now.len() - same).ok()?);
        let places = parse.ast.items.iter().map(|item| item.span).collect();
        let items = parse.ast.items.into_iter().map(Some).collect();
        Some(Earlier { items, places, sound: parse.sound, file: source.id, start, end, by })
    }

    /// The item whose lexemes lie there, from the earlier tree, if it was read without a doubt. Those of now must be
    /// without doubt too.
    pub(super) fn take(&mut self, span: Span) -> Option<Item> {
        let by = match () {
            () if span.end <= self.start => 0,
            () if span.start >= self.end => self.by,
            () => return None,
        };
        let then = |offset: u32| u32::try_from(i64::from(offset) - by).ok();
        let (start, end) = (then(span.start)?, then(span.end)?);
        let place = self.places.binary_search_by_key(&start, |place| place.start).ok()?;
        if self.places[place].end != end || !self.sound.get(place).is_some_and(|sound| *sound) {
            return None;
        }
        let mut item = self.items[place].take()?;
        if by != 0 || item.span.file != self.file {
            item.shift(Shift { file: self.file, by });
        }
        Some(item)
    }
}
