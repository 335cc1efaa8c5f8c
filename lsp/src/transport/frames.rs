//! Messages cut out of a stream of bytes: a header that says how long, an empty line, that many bytes. What is no message
//! is passed over to the next header. What the bytes mean is not looked at.

use std::io::{BufRead, Read};

/// The most bytes of one message. A design is at most 16 MiB of text, each byte of it six in JSON at worst.
const MOST_BYTES: u64 = 128 << 20;
/// How much of a line without an end is looked at.
const LONGEST_LINE: usize = 8 << 10;
/// The header that says how long a message is, in lower case.
const LENGTH: &[u8] = b"content-length:";

/// What was found in the stream.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Frame {
    /// The bytes of one message.
    Message(Vec<u8>),
    /// What is none, and why.
    Broken(String),
}

/// The next of a stream; `None` at its end.
pub(super) fn next(input: &mut impl BufRead) -> Option<Frame> {
    let mut length = None;
    let mut foreign = false;
    let mut why = "a header without Content-Length".to_owned();
    let mut begun = false;
    loop {
        let line = line(input)?;
        if line.is_empty() {
            // An empty line before a header is harmless.
            if begun {
                break;
            }
            continue;
        }
        begun = true;
        let lower = line.to_ascii_lowercase();
        foreign |= lower.starts_with(b"content-type:") && !is_utf8(&lower);
        // What stands before it in its line is the rest of a message whose length was wrong.
        let Some(at) = lower.windows(LENGTH.len()).rposition(|part| part == LENGTH) else { continue };
        length = number(&lower[at + LENGTH.len()..]);
        match length {
            None => why = "Content-Length is no number".to_owned(),
            Some(bytes) if bytes > MOST_BYTES => {
                why = format!("a message of {bytes} bytes; the most is {MOST_BYTES}");
                length = None;
            }
            Some(_) => {}
        }
    }
    let Some(length) = length else { return Some(Frame::Broken(why)) };
    let mut message = Vec::new();
    let read = input.take(length).read_to_end(&mut message).ok()?;
    if (read as u64) < length {
        return None;
    }
    if foreign {
        return Some(Frame::Broken("Content-Type names another encoding than UTF-8".to_owned()));
    }
    Some(Frame::Message(message))
}

/// A line without its end, of one that is too long its last bytes; `None` at the end of the stream.
fn line(input: &mut impl BufRead) -> Option<Vec<u8>> {
    let mut line = Vec::new();
    loop {
        let read = input.take(LONGEST_LINE as u64).read_until(b'\n', &mut line).ok()?;
        if read == 0 {
            return None;
        }
        if line.ends_with(b"\n") {
            line.pop();
            if line.ends_with(b"\r") {
                line.pop();
            }
            return Some(line);
        }
        let passed = line.len().saturating_sub(LONGEST_LINE);
        line.drain(..passed);
    }
}

fn number(digits: &[u8]) -> Option<u64> {
    std::str::from_utf8(digits).ok()?.trim().parse().ok()
}

fn is_utf8(header: &[u8]) -> bool {
    let header = String::from_utf8_lossy(header);
    header
        .split_once("charset=")
        .is_none_or(|(_, charset)| matches!(charset.trim().trim_matches('"'), "utf-8" | "utf8"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frames(text: &str) -> Vec<Frame> {
        let mut input = text.as_bytes();
        std::iter::from_fn(|| next(&mut input)).collect()
    }

    fn message(text: &str) -> Frame {
        Frame::Message(text.as_bytes().to_vec())
    }

    fn broken(why: &str) -> Frame {
        Frame::Broken(why.to_owned())
    }

    #[test]
    fn messages_follow_each_other() {
        let text = "Content-Length: 2\r\n\r\n{}content-length:3\r\nContent-Type: x; charset=utf8\r\n\r\n[1]";
        assert_eq!(frames(text), [message("{}"), message("[1]")]);
        assert_eq!(
            frames("Content-Length: 0\r\n\r\n\r\nContent-Length: 1\n\n7"),
            [message(""), message("7")]
        );
    }

    #[test]
    fn what_is_wrong_is_passed_over() {
        let good = "Content-Length: 2\r\n\r\n{}";
        for (wrong, why) in [
            ("X-Length: 2\r\n\r\n", "a header without Content-Length"),
            ("Content-Length: two\r\n\r\n", "Content-Length is no number"),
            ("Content-Length: -2\r\n\r\n", "Content-Length is no number"),
            ("Content-Length: 99999999999999999999999\r\n\r\n", "Content-Length is no number"),
            (
                "Content-Length: 999999999999\r\n\r\n",
                "a message of 999999999999 bytes; the most is 134217728",
            ),
            (
                "Content-Length: 1\r\nContent-Type: x; charset=latin1\r\n\r\n7",
                "Content-Type names another encoding than UTF-8",
            ),
        ] {
            assert_eq!(frames(&format!("{wrong}{good}")), [broken(why), message("{}")], "{wrong}");
        }
    }

    #[test]
    fn a_wrong_length_costs_one_message() {
        let second = "Content-Length: 3\r\n\r\n[2]";
        let third = "Content-Length: 3\r\n\r\n[3]";
        assert_eq!(
            frames(&format!("Content-Length: 2\r\n\r\n[123]{second}{third}")),
            [message("[1"), message("[2]"), message("[3]")]
        );
        // Too long: it swallows the beginning of the next one.
        let found = frames(&format!("Content-Length: 6\r\n\r\n[1]{second}{third}"));
        assert_eq!(found.last(), Some(&message("[3]")));
        assert_eq!(frames("Content-Length: 60\r\n\r\n{}"), [], "it never comes");
    }

    #[test]
    fn lines_without_end_take_no_memory() {
        let garbage = "x".repeat(100_000);
        assert_eq!(frames(&format!("{garbage}Content-Length: 2\r\n\r\n{{}}")), [message("{}")]);
        assert_eq!(frames(&garbage), []);
    }
}
