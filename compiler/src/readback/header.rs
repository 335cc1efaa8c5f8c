//! The header's comments as keys and values, escapes undone. Where a dialect has capitals only, so have its keys and
//! values. Whether they are true is judged in `checks`.

use super::lines::Line;
use crate::fabricate::machine::{CommentRule, Profile};

/// One `key: value` of the header.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Entry {
    pub(super) line: usize,
    pub(super) key: String,
    pub(super) value: String,
}

/// All entries: the comments before the first other line, those that begin with a plus joined to the one before.
pub(super) fn entries(lines: &[Line], profile: &Profile) -> Vec<Entry> {
    let mut joined: Vec<(usize, String)> = Vec::new();
    // A program's number and the mark of its start may stand before.
    for line in lines.iter().skip_while(|line| line.comment.is_none()) {
        let Some(comment) = &line.comment else { break };
        match (comment.strip_prefix("+ "), joined.last_mut()) {
            (Some(more), Some(last)) => last.1 += more,
            _ => joined.push((line.number, comment.clone())),
        }
    }
    let entry = |(line, text): (usize, String)| {
        let (key, value) = text.split_once(": ").or_else(|| text.split_once(':'))?;
        let key = if profile.comment.capitals { key.to_ascii_lowercase() } else { key.to_owned() };
        Some(Entry { line, key, value: unescaped(value, &profile.comment) })
    };
    joined.into_iter().filter_map(entry).collect()
}

/// An escape such as `{29}` becomes the character with that code point; what is no escape stays.
fn unescaped(text: &str, rule: &CommentRule) -> String {
    let (open, close) = rule.escape;
    let mut out = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(open) {
        out += before;
        let read = after.split_once(close).and_then(|(code, tail)| {
            let c = u32::from_str_radix(code, 16).ok().and_then(char::from_u32)?;
            Some((c, tail))
        });
        match read {
            Some((c, tail)) => {
                out.push(c);
                rest = tail;
            }
            None => {
                out.push(open);
                rest = after;
            }
        }
    }
    out + rest
}
