//! The project's own source files, for tests that read them.

use std::fs;
use std::path::{Path, PathBuf};

/// The greatest number of lines of a source file.
pub const MOST_LINES: usize = 500;

/// All files below a folder with an extension, in order. Built and installed things are left out.
pub fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(next) = open.pop() {
        let Ok(entries) = fs::read_dir(&next) else { continue };
        for entry in entries {
            let path = entry.expect("a folder can be read").path();
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            if path.is_dir() {
                if name != "target" && name != "node_modules" && !name.starts_with('.') {
                    open.push(path);
                }
            } else if path.extension().is_some_and(|e| e == extension) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// What is wrong with the form of a Rust source file: no `//!` head that says what lives in it, or too many lines.
pub fn faults(text: &str) -> Vec<String> {
    let mut faults = Vec::new();
    let head = text.lines().next().unwrap_or_default();
    if head.strip_prefix("//!").is_none_or(|words| words.trim().len() < 10) {
        faults.push("begins with no `//!` that says what lives in it".to_owned());
    }
    let lines = text.lines().count();
    if lines > MOST_LINES {
        faults.push(format!("has {lines} lines, more than {MOST_LINES}"));
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_are_found() {
        assert!(faults("//! The parts of a fern.\n").is_empty());
        assert_eq!(faults("use std::fs;\n").len(), 1);
        assert_eq!(faults("//!\n").len(), 1);
        assert_eq!(faults(&format!("//! The parts of a fern.\n{}", "\n".repeat(MOST_LINES))).len(), 1);
    }
}
