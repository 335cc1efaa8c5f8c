//! `diagnostics.json`: what a build said, for programs. Also written where the build failed.

use std::fmt::Write as _;

use crate::diagnostic::{Diagnostic, Severity, render_json};
use crate::source::SourceMap;

/// The name of the file in the output folder.
pub const DIAGNOSTICS: &str = "diagnostics.json";

/// The version of the file's shape.
const SCHEMA: u32 = 1;

/// The text of the file: whether the build `failed`, and all diagnostics, one on a line, in their order. Paths are those of
/// `sources`: relative to the project's root, so that the file is the same wherever the project lies.
pub fn diagnostics_json(diagnostics: &[Diagnostic], sources: &SourceMap, failed: bool) -> String {
    let errors = diagnostics.iter().filter(|found| found.severity() == Severity::Error).count();
    let warnings = diagnostics.len() - errors;
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = write!(
        text,
        "{{\n  \"schema\": {SCHEMA},\n  \"failed\": {failed},\n  \"errors\": {errors},\n  \"warnings\": {warnings},\n  \
        \"diagnostics\": ["
    );
    for (place, diagnostic) in diagnostics.iter().enumerate() {
        let comma = if place == 0 { "" } else { "," };
        let _ = write!(text, "{comma}\n    {}", render_json(diagnostic, sources));
    }
    text.push_str(if diagnostics.is_empty() { "]\n}\n" } else { "\n  ]\n}\n" });
    text
}
