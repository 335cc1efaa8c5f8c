//! Quoted texts: whether they are closed, and what their escapes stand for.

use std::ops::Range;

/// Whether a slice that begins with a quote ends with another one that is not escaped.
pub(super) fn is_closed(slice: &str) -> bool {
    let mut characters = slice.chars().skip(1);
    while let Some(c) = characters.next() {
        match c {
            '"' => return true,
            '\\' => {
                characters.next();
            }
            _ => {}
        }
    }
    false
}

/// The ranges of the escapes that the language does not know.
pub(super) fn unknown_escapes(slice: &str) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let mut characters = slice.char_indices();
    while let Some((at, c)) = characters.next() {
        if c != '\\' {
            continue;
        }
        if let Some((next, escaped)) = characters.next()
            && !matches!(escaped, '"' | '\\' | 'n' | 't')
        {
            found.push(at..next + escaped.len_utf8());
        }
    }
    found
}

/// The text that a quoted slice stands for; unknown escapes stand for themselves.
pub(in crate::syntax) fn unescape(slice: &str) -> String {
    let inner = slice.strip_prefix('"').unwrap_or(slice);
    let inner = if is_closed(slice) { inner.strip_suffix('"').unwrap_or(inner) } else { inner };
    let mut value = String::with_capacity(inner.len());
    let mut characters = inner.chars();
    while let Some(c) = characters.next() {
        if c != '\\' {
            value.push(c);
            continue;
        }
        match characters.next() {
            Some('n') => value.push('\n'),
            Some('t') => value.push('\t'),
            Some(same @ ('"' | '\\')) => value.push(same),
            Some(other) => value.extend(['\\', other]),
            None => value.push('\\'),
        }
    }
    value
}
