//! What can be wrong with a set. Plain data.

use std::collections::BTreeMap;
use std::fmt;

/// One thing that is not as it must be.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Finding {
    /// The file, relative to the folder, with `/`.
    pub path: String,
    /// What was looked at.
    pub what: String,
    /// What it must be.
    pub expected: String,
    /// What it is.
    pub found: String,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}: expected {}, found {}", self.path, self.what, self.expected, self.found)
    }
}

/// The most findings about one file: what follows the first few says no more.
const MOST_OF_A_FILE: usize = 5;

/// The most characters of a text that are shown.
const SHOWN: usize = 80;

/// Findings being gathered.
#[derive(Debug, Default)]
pub(super) struct Findings {
    all: Vec<Finding>,
    of_file: BTreeMap<String, usize>,
}

impl Findings {
    /// Adds one, unless the file has enough of them.
    pub(super) fn add(
        &mut self,
        path: &str,
        what: impl Into<String>,
        expected: impl fmt::Display,
        found: impl fmt::Display,
    ) {
        let count = self.of_file.entry(path.to_owned()).or_default();
        *count += 1;
        if *count <= MOST_OF_A_FILE {
            let (what, expected, found) = (what.into(), shown(&expected), shown(&found));
            self.all.push(Finding { path: path.to_owned(), what: shown(&what), expected, found });
        }
    }

    /// Adds one if two texts differ.
    pub(super) fn same(&mut self, path: &str, what: &str, expected: &str, found: &str) {
        if expected != found {
            self.add(path, what, format!("{expected:?}"), format!("{found:?}"));
        }
    }

    /// Adds one if two numbers are further apart than `tolerance`, or one is none.
    pub(super) fn near(&mut self, path: &str, what: &str, expected: f64, found: f64, tolerance: f64) {
        // Not-a-number is near nothing.
        if (expected - found).abs().partial_cmp(&tolerance).is_none_or(std::cmp::Ordering::is_gt) {
            self.add(path, what, expected, found);
        }
    }

    pub(super) fn sorted(mut self) -> Vec<Finding> {
        self.all.sort_by(|a, b| a.path.cmp(&b.path));
        self.all.dedup();
        self.all
    }
}

/// The beginning of a text on one line, without what steers a terminal.
fn shown(text: &impl fmt::Display) -> String {
    let text = text.to_string();
    let plain = |c: char| if c.is_control() { '\u{fffd}' } else { c };
    let mut shown: String = text.chars().take(SHOWN).map(plain).collect();
    if text.chars().nth(SHOWN).is_some() {
        shown.push('…');
    }
    shown
}
