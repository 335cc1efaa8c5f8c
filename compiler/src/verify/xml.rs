//! A reader of the little XML there is in a set: elements, attributes, texts. No entities but the five of XML, no
//! comments, no CDATA; nesting is counted, not recursed.

use super::finding::Findings;

/// One element's beginning, end, or a text in between.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Event {
    Open { name: String, attributes: Vec<(String, String)> },
    Text(String),
    Close,
}

/// Everything in order; a fault where it is no well-formed text, and what was read up to there. `void` are names of
/// elements that have no end.
pub(super) fn read(path: &str, text: &str, void: &[&str], findings: &mut Findings) -> Vec<Event> {
    let (mut events, mut open) = (Vec::new(), Vec::<String>::new());
    let mut rest = text;
    let at = |rest: &str| text.len() - rest.len();
    while let Some(start) = rest.find('<') {
        let between = &rest[..start];
        if let Some(bad) = between.find('>') {
            findings.add(path, format!("byte {}", at(rest) + bad), "text without `>`", ">");
        }
        if !between.trim().is_empty() {
            let Some(plain) = unescaped(between) else {
                findings.add(path, format!("byte {}", at(rest)), "text with known entities", between.trim());
                return events;
            };
            events.push(Event::Text(plain));
        }
        let tag = &rest[start..];
        let Some(end) = tag_end(tag) else {
            findings.add(path, format!("byte {}", at(tag)), "a tag that ends", "none");
            return events;
        };
        rest = &tag[end + 1..];
        let inner = &tag[1..end];
        if inner.starts_with('?') || inner.starts_with('!') {
            continue;
        }
        if let Some(name) = inner.strip_prefix('/') {
            if open.pop().as_deref() != Some(name) {
                findings.add(path, format!("byte {}", at(tag)), "the end of the element that is open", inner);
                return events;
            }
            events.push(Event::Close);
            continue;
        }
        let (inner, closed) = inner.strip_suffix('/').map_or((inner, false), |inner| (inner, true));
        let Some((name, attributes)) = element(inner) else {
            findings.add(path, format!("byte {}", at(tag)), "a name and attributes", inner);
            return events;
        };
        let ends = closed || void.contains(&name.as_str());
        events.push(Event::Open { name: name.clone(), attributes });
        if ends {
            events.push(Event::Close);
        } else {
            open.push(name.clone());
            if let ("style" | "script", Some(end)) = (name.as_str(), rest.find("</")) {
                events.push(Event::Text(rest[..end].to_owned()));
                rest = &rest[end..];
            }
        }
    }
    if !rest.trim().is_empty() || !open.is_empty() {
        findings.add(path, "the end", "that all elements are closed", open.pop().unwrap_or_default());
    }
    events
}

/// Where the tag that a text begins with ends: a `>` outside quotes.
fn tag_end(tag: &str) -> Option<usize> {
    let mut quoted = false;
    for (at, byte) in tag.bytes().enumerate() {
        match byte {
            b'"' => quoted = !quoted,
            b'>' if !quoted => return Some(at),
            b'<' if at > 0 => return None,
            _ => {}
        }
    }
    None
}

/// A name and attributes, each once; an attribute may have no value.
fn element(inner: &str) -> Option<(String, Vec<(String, String)>)> {
    let is_name = |text: &str| {
        let plain = |c: char| c.is_ascii_alphanumeric() || "-_:.".contains(c);
        text.starts_with(|c: char| c.is_ascii_alphabetic()) && text.chars().all(plain)
    };
    let (name, mut rest) = inner.split_once([' ', '\n']).unwrap_or((inner, ""));
    let mut attributes: Vec<(String, String)> = Vec::new();
    while !rest.trim_start().is_empty() {
        rest = rest.trim_start();
        let end = rest.find(['=', ' ', '\n']).unwrap_or(rest.len());
        let key = &rest[..end];
        let value = if rest[end..].starts_with("=\"") {
            let (value, after) = rest[end + 2..].split_once('"')?;
            if !after.is_empty() && !after.starts_with([' ', '\n']) {
                return None;
            }
            rest = after;
            unescaped(value)?
        } else {
            if rest[end..].starts_with('=') {
                return None;
            }
            rest = &rest[end..];
            String::new()
        };
        if !is_name(key) || attributes.iter().any(|(known, _)| known == key) {
            return None;
        }
        attributes.push((key.to_owned(), value));
    }
    is_name(name).then(|| (name.to_owned(), attributes))
}

/// Text with the entities of XML undone; none where there is another one.
fn unescaped(text: &str) -> Option<String> {
    let (mut out, mut rest) = (String::new(), text);
    while let Some((before, after)) = rest.split_once('&') {
        let (name, tail) = after.split_once(';')?;
        out.push_str(before);
        out.push(match name {
            "amp" => '&',
            "lt" => '<',
            "gt" => '>',
            "quot" => '"',
            "apos" | "#39" => '\'',
            "nbsp" => '\u{a0}',
            _ => return None,
        });
        rest = tail;
    }
    Some(out + rest)
}

/// The value of an attribute.
pub(super) fn attribute<'a>(attributes: &'a [(String, String)], name: &str) -> Option<&'a str> {
    attributes.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_str())
}
