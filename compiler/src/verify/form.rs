//! What every text of a set has in common: UTF-8, line feeds, nothing that steers; and the one layout of JSON.

use super::finding::Findings;

/// The text of bytes that must be one.
pub(super) fn text<'a>(path: &str, bytes: &'a [u8], findings: &mut Findings) -> Option<&'a str> {
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => {
            let at = error.valid_up_to();
            findings.add(path, "the text", "UTF-8", format!("other bytes at byte {at}"));
            return None;
        }
    };
    let strange = |c: char| (c.is_control() && c != '\n') || c == '\u{fffe}' || c == '\u{feff}';
    if let Some((at, c)) = text.char_indices().find(|(_, c)| strange(*c)) {
        findings.add(path, "the text", "no control characters", format!("{:x} at byte {at}", u32::from(c)));
    }
    if !text.ends_with('\n') {
        findings.add(path, "the end of the text", "a line feed", "none");
    }
    Some(text)
}

/// JSON that was written indented by two, or what is wrong with it. What is nested `dense` deep is written without
/// spaces, on one line.
pub(super) fn json(
    path: &str,
    bytes: &[u8],
    dense: usize,
    findings: &mut Findings,
) -> Option<serde_json::Value> {
    let text = text(path, bytes, findings)?;
    let value = match serde_json::from_str(text) {
        Ok(value) => value,
        Err(error) => {
            findings.add(path, "the text", "JSON", error);
            return None;
        }
    };
    let laid_out = laid_out(text, dense) + "\n";
    if laid_out != text {
        let differs = laid_out.lines().zip(text.lines()).position(|(a, b)| a != b).map_or(0, |line| line + 1);
        findings.add(path, "layout", "as builds write it", format!("line {differs} differs"));
    }
    Some(value)
}

/// JSON text indented by two, its strings and numbers as they are, dense where it is nested so deep.
fn laid_out(text: &str, dense: usize) -> String {
    let (mut out, mut depth, mut rest) = (String::with_capacity(text.len()), 0_usize, text.trim_start());
    let line = |out: &mut String, depth: usize| {
        if depth <= dense {
            out.push('\n');
            out.extend(std::iter::repeat_n(' ', 2 * depth));
        }
    };
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '"' => string_length(rest),
            '{' | '}' | '[' | ']' | ',' | ':' => 1,
            _ => rest.find([',', ':', '}', ']', ' ', '\n', '\t', '\r']).unwrap_or(rest.len()),
        };
        let (token, after) = rest.split_at(length.max(first.len_utf8()));
        rest = after.trim_start();
        match token {
            "{" | "[" => {
                out.push_str(token);
                if rest.starts_with(['}', ']']) {
                    out.push_str(&rest[..1]);
                    rest = rest[1..].trim_start();
                } else {
                    depth += 1;
                    line(&mut out, depth);
                }
            }
            "}" | "]" => {
                if depth <= dense {
                    line(&mut out, depth.saturating_sub(1));
                }
                depth = depth.saturating_sub(1);
                out.push_str(token);
            }
            "," => {
                out.push(',');
                line(&mut out, depth);
            }
            ":" => out.push_str(if depth <= dense { ": " } else { ":" }),
            _ => out.push_str(token),
        }
    }
    out
}

/// Bytes of the string that a text begins with, quotes and all.
fn string_length(text: &str) -> usize {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            '"' => return at + 1,
            _ => {}
        }
    }
    text.len()
}
