//! A change of the text that mends what a diagnostic says: its places, and its title for a list to choose from. How it is
//! found lives with each check.

use crate::source::{SourceMap, Span};

/// Texts longer than this many characters are shortened in a title.
const LONGEST_SHOWN: usize = 48;

/// One place where the text changes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// What is replaced; empty where something is put between.
    pub span: Span,
    /// What stands there afterwards; empty where something is taken out.
    pub replacement: String,
}

/// A change of the text that would mend the matter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// What it does, with numbers, where the text alone does not say it.
    said: Option<String>,
    /// The places that change; they neither overlap nor touch.
    pub edits: Vec<Edit>,
}

impl Fix {
    /// A place with another text; the title is found from the two.
    pub fn replacing(span: Span, replacement: impl Into<String>) -> Self {
        Fix { said: None, edits: vec![Edit { span, replacement: replacement.into() }] }
    }

    /// What is changed at places added with [`Fix::with`], in words.
    pub fn titled(title: impl Into<String>) -> Self {
        Fix { said: Some(title.into()), edits: Vec::new() }
    }

    /// One more place.
    #[must_use]
    pub fn with(mut self, span: Span, replacement: impl Into<String>) -> Self {
        self.edits.push(Edit { span, replacement: replacement.into() });
        self
    }

    /// What it does in one line: ``replace `widht` with `width` ``.
    pub fn title(&self, sources: &SourceMap) -> String {
        if let Some(said) = &self.said {
            return said.clone();
        }
        self.edits.iter().map(|edit| words(edit, sources)).collect::<Vec<_>>().join(", ")
    }
}

fn words(edit: &Edit, sources: &SourceMap) -> String {
    let source = sources.get(edit.span.file);
    let old = source.map_or("", |source| source.slice(edit.span));
    // What is glued to a word changes that word: `27` becomes `27mm`.
    let start = edit.span.start as usize;
    let before = source.and_then(|source| source.text.get(..start)).unwrap_or("");
    let part = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '.');
    let word = &before[before.trim_end_matches(part).len()..];
    if old.is_empty() && !word.is_empty() && edit.replacement.starts_with(part) {
        return format!("replace `{word}` with `{word}{}`", edit.replacement);
    }
    match (shown(old), shown(&edit.replacement)) {
        (old, new) if old.is_empty() => format!("insert `{new}`"),
        (old, new) if new.is_empty() && old.trim().is_empty() => "remove the space".to_owned(),
        (old, new) if new.is_empty() => format!("remove `{old}`"),
        (old, new) => format!("replace `{old}` with `{new}`"),
    }
}

/// A text in one line, without the space around it where there is more, and with its middle left out where it is long.
fn shown(text: &str) -> String {
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if line.is_empty() {
        return text.to_owned();
    }
    let characters: Vec<char> = line.chars().collect();
    if characters.len() <= LONGEST_SHOWN {
        return line;
    }
    let half = LONGEST_SHOWN / 2;
    let start: String = characters[..half].iter().collect();
    let end: String = characters[characters.len() - half + 1..].iter().collect();
    format!("{start}…{end}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::FileId;

    #[test]
    fn titles_say_what_changes() {
        let mut sources = SourceMap::default();
        let file = sources.add("a.ifs", "let a = widht; 27\n".to_owned());
        let at = |start, end| Span::new(file, start, end);
        let title = |fix: Fix| fix.title(&sources);
        assert_eq!(title(Fix::replacing(at(8, 13), "width")), "replace `widht` with `width`");
        assert_eq!(title(Fix::replacing(at(13, 14), "")), "remove `;`");
        assert_eq!(title(Fix::replacing(at(13, 13), "+")), "insert `+`");
        assert_eq!(title(Fix::replacing(at(17, 17), "mm")), "replace `27` with `27mm`");
        assert_eq!(title(Fix::replacing(at(14, 15), "")), "remove the space");
        assert_eq!(title(Fix::titled("level 3 instead of 4").with(at(0, 1), "3")), "level 3 instead of 4");
        let long = title(Fix::replacing(at(0, 0), "a ".repeat(100)));
        assert!(long.chars().count() < 64 && long.contains('…'), "{long}");
        assert_eq!(sources.get(FileId(0)).map(|source| source.path.as_str()), Some("a.ifs"));
    }
}
