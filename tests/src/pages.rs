//! The pages of documentation as the tests read them: the designs and the terminals they show, and the sections that
//! are written from the tables of the compiler.
//!
//! A block that begins with three backticks and `ifs` is a design. Words after it say more: `wrong` shows a mistake,
//! `name=value` sets a parameter, `vault.ifs` names the file that it shows, `more` adds to the last design of the page
//! that is not wrong, `files` names files that are shown nowhere, `loose` is not laid out. A block `console` is what a
//! terminal shows: commands after `$ `, and below each what it prints; a line `…` stands for any lines.

use std::fmt::Write;

/// A fenced block of a page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// The line of its first fence, from 1.
    pub line: usize,
    /// What stands after the three backticks.
    pub words: Vec<String>,
    /// What it shows.
    pub text: String,
    /// The design it shows together with those it adds to.
    pub whole: String,
    /// The file whose text `whole` is, where it is named.
    pub file: Option<String>,
}

impl Block {
    /// Whether it shows a design.
    pub fn is_design(&self) -> bool {
        self.words.first().is_some_and(|word| word == "ifs")
    }

    /// Whether this word stands after the three backticks.
    pub fn has(&self, word: &str) -> bool {
        self.words.iter().any(|other| other == word)
    }

    /// The parameters that it sets.
    pub fn settings(&self) -> Vec<(&str, &str)> {
        self.words.iter().filter_map(|word| word.split_once('=')).collect()
    }
}

/// The blocks of a page in order.
pub fn blocks(page: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut last: Option<(Option<String>, String)> = None;
    let mut lines = page.lines().enumerate();
    while let Some((line, fence)) = lines.next() {
        let Some(words) = fence.trim_start().strip_prefix("```") else { continue };
        let inner = lines.by_ref().map(|(_, line)| line).take_while(|line| line.trim() != "```");
        let text: String = inner.map(|line| format!("{line}\n")).collect();
        let words = words.split_whitespace().map(str::to_owned).collect();
        let mut block = Block { line: line + 1, words, whole: text.clone(), text, file: None };
        if block.is_design() {
            block.file = block.words.iter().find(|word| word.ends_with(".ifs")).cloned();
            if let (true, Some((file, before))) = (block.has("more"), &last) {
                block.whole = format!("{before}\n{}", block.text);
                block.file.clone_from(file);
            }
            if !block.has("wrong") {
                last = Some((block.file.clone(), block.whole.clone()));
            }
        }
        blocks.push(block);
    }
    blocks
}

/// A command of a terminal and what it prints.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    /// What stands after `$ `.
    pub command: String,
    /// The lines below it.
    pub printed: String,
}

/// The commands that a terminal shows.
pub fn runs(text: &str) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for line in text.lines() {
        if let Some(command) = line.strip_prefix("$ ") {
            runs.push(Run { command: command.to_owned(), printed: String::new() });
        } else if let Some(run) = runs.last_mut() {
            let _ = writeln!(run.printed, "{}", line.trim_end());
        }
    }
    runs
}

/// Whether what is printed is what is shown; a line `…` stands for any lines.
pub fn shows(shown: &str, printed: &str) -> bool {
    let lines =
        |text: &str| text.trim_end().lines().map(|line| line.trim_end().to_owned()).collect::<Vec<_>>();
    let (shown, printed) = (lines(shown), lines(printed));
    let mut parts = shown.split(|line| line == "…").peekable();
    let mut rest = printed.as_slice();
    if let Some(first) = parts.next() {
        match rest.strip_prefix(first) {
            Some(after) => rest = after,
            None => return false,
        }
        if parts.peek().is_none() {
            return rest.is_empty();
        }
    }
    while let Some(part) = parts.next() {
        if parts.peek().is_none() {
            return rest.ends_with(part);
        }
        let found = (0..=rest.len()).find(|start| rest[*start..].starts_with(part));
        match found {
            Some(start) => rest = &rest[start + part.len()..],
            None => return false,
        }
    }
    true
}

/// A page with another text in one of its blocks.
pub fn with_block(page: &str, block: &Block, text: &str) -> String {
    let lines: Vec<&str> = page.lines().collect();
    let (before, rest) = lines.split_at(block.line);
    let after = &rest[block.text.lines().count()..];
    let mut lines = before.to_vec();
    lines.extend(text.trim_end().lines());
    lines.extend(after);
    lines.join("\n") + "\n"
}

/// A page with the section between `<!-- name -->` and `<!-- end -->` written anew; `None` where there is no such
/// section.
pub fn with_section(page: &str, name: &str, text: &str) -> Option<String> {
    let start = format!("<!-- {name} -->\n");
    let from = page.find(&start)? + start.len();
    let to = from + page[from..].find("<!-- end -->")?;
    Some(format!("{}\n{}\n\n{}", &page[..from], text.trim(), &page[to..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_adds_to_the_last_one_that_is_not_wrong() {
        let page = "# A\n```ifs a.ifs\nlet a = 1\n```\n```ifs more wrong\nlet b = c\n```\n```ifs more n=2\nlet d = a\n```\n";
        let blocks = blocks(page);
        assert_eq!(blocks.iter().map(|block| block.line).collect::<Vec<_>>(), [2, 5, 8]);
        assert_eq!(blocks[1].whole, "let a = 1\n\nlet b = c\n");
        assert_eq!(blocks[2].whole, "let a = 1\n\nlet d = a\n");
        assert_eq!(blocks[2].file.as_deref(), Some("a.ifs"));
        assert_eq!(blocks[2].settings(), [("n", "2")]);
    }

    #[test]
    fn dots_stand_for_any_lines() {
        assert!(shows("a\nb\n", "a  \nb\n\n"));
        assert!(shows("a\n…\nd\n", "a\nb\nc\nd\n"));
        assert!(shows("…\nc\n…\n", "a\nb\nc\nd\n"));
        assert!(shows("a\n…", "a\n"));
        assert!(!shows("a\n", "a\nb\n"));
        assert!(!shows("a\n…\nd\n", "a\nd\nb\n"));
        assert!(!shows("b\n…\n", "a\nb\n"));
        assert_eq!(runs("$ one\nx\n$ two\n")[1], Run { command: "two".to_owned(), printed: String::new() });
    }

    #[test]
    fn a_block_is_written_anew() {
        let page = "a\n```console\n$ x\n```\n```console\n$ x\n```\nb\n";
        let second = &blocks(page)[1];
        assert_eq!(
            with_block(page, second, "$ x\ny\n"),
            "a\n```console\n$ x\n```\n```console\n$ x\ny\n```\nb\n"
        );
    }

    #[test]
    fn a_section_is_written_anew() {
        let page = "# A\n\n<!-- codes -->\nold\n<!-- end -->\n\nrest\n";
        let new = "# A\n\n<!-- codes -->\n\nnew\n\n<!-- end -->\n\nrest\n";
        assert_eq!(with_section(page, "codes", "new\n").as_deref(), Some(new));
        assert_eq!(with_section(new, "codes", "new\n").as_deref(), Some(new));
        assert_eq!(with_section(page, "words", "new\n"), None);
    }
}
