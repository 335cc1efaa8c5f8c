//! The files of programs as text: what their headers say, and what all programs of a machine have in common. What they
//! cut is judged in `nc` and `sheet_nc`.

use std::collections::{BTreeMap, BTreeSet};

use super::Listed;
use super::finding::Findings;
use super::vote::most;
use crate::fabricate::machine::Profile;

/// A file of a program.
pub(super) struct NcFile {
    pub(super) path: String,
    /// The address of a board; of sheets none.
    pub(super) address: String,
    /// The tool that is put in before, where there is a file for each.
    pub(super) tool: Option<u32>,
    pub(super) text: String,
    /// Figures by their letter and the tool that was loaded, in thousandths.
    words: BTreeMap<(u8, u32), BTreeSet<i64>>,
    /// What every program of the machine repeats: lines without places.
    steady: Vec<String>,
}

impl NcFile {
    /// Reads a file.
    pub(super) fn read(file: &Listed, text: &str) -> Self {
        let mut read = Self {
            path: file.path.clone(),
            address: file.address.clone().unwrap_or_default(),
            tool: tool(&file.path),
            text: text.to_owned(),
            words: BTreeMap::new(),
            steady: Vec::new(),
        };
        let mut feed = None;
        let mut loaded = read.tool.unwrap_or(0);
        let body =
            text.lines().skip_while(|line| !line.starts_with('(')).skip_while(|line| line.starts_with('('));
        for line in body {
            let words: Vec<(u8, f64)> = line.split(' ').filter_map(word).collect();
            if line.starts_with('(') || !words.iter().any(|(letter, _)| b"XYZ".contains(letter)) {
                read.steady.push(line.to_owned());
            }
            if line.starts_with('(') {
                continue;
            }
            if let Some((_, tool)) = words.iter().find(|(letter, _)| *letter == b'T') {
                loaded = *tool as u32;
            }
            // A feed holds until another is said, through changes of tools too.
            feed = words.iter().find(|(letter, _)| *letter == b'F').map(|word| word.1).or(feed);
            if let Some(feed) =
                feed.filter(|_| ["G1 ", "G2 ", "G3 "].iter().any(|code| line.starts_with(code)))
            {
                read.words.entry((b'F', loaded)).or_default().insert((feed * 1000.0).round() as i64);
            }
            for &(letter, value) in words.iter().filter(|(letter, _)| b"SP".contains(letter)) {
                read.words.entry((letter, loaded)).or_default().insert((value * 1000.0).round() as i64);
            }
        }
        read
    }

    /// `key: value` of the comments at the top; long ones joined, escapes undone.
    pub(super) fn header(&self, profile: &Profile) -> BTreeMap<String, Vec<String>> {
        let mut joined: Vec<String> = Vec::new();
        for line in self.text.lines().skip_while(|line| !line.starts_with('(')) {
            let Some(comment) = line.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')) else { break };
            match (comment.strip_prefix("+ "), joined.last_mut()) {
                (Some(more), Some(last)) => last.push_str(more),
                _ => joined.push(comment.to_owned()),
            }
        }
        let mut header: BTreeMap<String, Vec<String>> = BTreeMap::new();
        for (key, value) in joined.iter().filter_map(|line| line.split_once(": ")) {
            header
                .entry(key.to_ascii_lowercase())
                .or_default()
                .push(unescaped(value, profile.comment.escape));
        }
        header
    }
}

/// The tool in a name such as `shell.7-12.t2.nc`.
fn tool(path: &str) -> Option<u32> {
    path.strip_suffix(".nc")?.rsplit_once(".t")?.1.parse().ok()
}

fn word(text: &str) -> Option<(u8, f64)> {
    let letter = *text.as_bytes().first()?;
    Some((letter, text.get(1..)?.parse().ok().filter(|value: &f64| value.is_finite())?))
}

/// A text with code points between `open` and `close` as their characters.
fn unescaped(text: &str, (open, close): (char, char)) -> String {
    let mut parts = text.split(open);
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let code = part.split_once(close).and_then(|(code, rest)| {
            Some((u32::from_str_radix(code, 16).ok().and_then(char::from_u32)?, rest))
        });
        match code {
            Some((c, rest)) => {
                out.push(c);
                out.push_str(rest);
            }
            None => {
                out.push(open);
                out.push_str(part);
            }
        }
    }
    out
}

/// Lines that say no place are the same in all programs that cut alike: modes, tools, feeds, speeds, the end.
pub(super) fn steady(files: &[&NcFile], findings: &mut Findings) {
    if files.len() < 3 {
        return;
    }
    // What names the board, and in some dialects the program, is its own.
    let own = |line: &&String| !line.to_ascii_lowercase().starts_with("(engraving");
    let usual = most(files.iter().map(|file| file.steady.iter().filter(own).collect::<Vec<_>>()));
    for file in files {
        let lines: Vec<&String> = file.steady.iter().filter(own).collect();
        if let Some(usual) = &usual
            && lines != *usual
        {
            let differs = lines.iter().zip(usual).find(|(found, usual)| found != usual);
            let (found, expected) = differs.map_or(("fewer or more", "those of the others"), |(a, b)| (a, b));
            findings.add(&file.path, "lines without places", expected, found);
        }
    }
    for letter in [b'F', b'S', b'P'] {
        let of = |file: &NcFile| -> BTreeMap<u32, BTreeSet<i64>> {
            let own = file.words.iter().filter(|((found, _), _)| *found == letter);
            own.map(|((_, tool), values)| (*tool, values.clone())).collect()
        };
        let Some(usual) = most(files.iter().map(|file| of(file))) else { continue };
        for file in files.iter().filter(|file| of(file) != usual) {
            let what = format!("the values of {}", char::from(letter));
            findings.add(&file.path, what, "those of the other programs", "others");
        }
    }
}
