//! The outputs of a design without errors: names that stay in the folder, the same bytes twice, numbers that are some.

use std::collections::BTreeMap;
use std::path::{Component, Path};

use ifs_compiler::analysis::{Analysis, Unwatched};
use ifs_compiler::diagnostic::{Diagnostic, Severity};
use ifs_compiler::outputs::{Selection, outputs, workshop_faults};

use super::diagnostics::printed;
use super::{Holds, holds};

/// The outputs of two analyses of the same text.
pub(super) fn outputs_hold(first: &Analysis, again: &Analysis) -> Holds {
    let (files, said) = contents(first)?;
    let (repeated, said_again) = contents(again)?;
    holds(said == said_again, || format!("two builds differ: {said} and {said_again}"))?;
    let changed = files.iter().find(|(name, bytes)| repeated.get(*name) != Some(bytes));
    let other = changed.map(|(name, _)| name);
    holds(other.is_none() && files.len() == repeated.len(), || format!("two builds differ in {other:?}"))?;
    files.iter().try_for_each(|(name, bytes)| content_holds(name, bytes))
}

/// The bytes of all files by name, and what is said where there are none.
fn contents(analysis: &Analysis) -> Result<(BTreeMap<String, Vec<u8>>, String), String> {
    let made = outputs(analysis, &Selection::all());
    let said = printed(&made.diagnostics, &analysis.sources)?;
    let fails = |found: &[Diagnostic]| found.iter().any(|found| found.severity() == Severity::Error);
    holds(made.files.is_empty() == fails(&made.diagnostics), || format!("neither files nor words: {said}"))?;
    // What is said before a build is said of no design that can be built.
    let before = workshop_faults(analysis, &mut Unwatched);
    let words = printed(&before, &analysis.sources)?;
    holds(made.files.is_empty() || !fails(&before), || format!("built in spite of {words}"))?;
    let mut files = BTreeMap::new();
    for file in made.files {
        let mut bytes = Vec::new();
        file.write(&mut bytes).map_err(|error| format!("{}: {error}", file.path))?;
        let inside = Path::new(&file.path).components().all(|part| matches!(part, Component::Normal(_)));
        holds(inside && file.path.is_ascii(), || format!("the name of a file is {:?}", file.path))?;
        let twice = files.insert(file.path.to_lowercase(), bytes).is_some();
        holds(!twice, || format!("two files are called {}", file.path))?;
    }
    Ok((files, said))
}

fn content_holds(name: &str, bytes: &[u8]) -> Holds {
    if name.ends_with(".glb") {
        return holds(bytes.starts_with(b"glTF"), || format!("{name} is no glTF"));
    }
    let text = std::str::from_utf8(bytes).map_err(|error| format!("{name}: {error}"))?;
    if name.ends_with(".json") {
        serde_json::from_str::<serde_json::Value>(text).map_err(|error| format!("{name}: {error}"))?;
    }
    if name.ends_with(".csv") || name.ends_with(".nc") {
        let strange = text.split([',', '\n', ' ']).find(|word| {
            let letters = word.trim_start_matches(|letter: char| "XYZIJFS-".contains(letter));
            matches!(letters.to_ascii_lowercase().as_str(), "nan" | "inf" | "infinity")
        });
        holds(strange.is_none(), || format!("{name} has the number {strange:?}"))?;
    }
    Ok(())
}
