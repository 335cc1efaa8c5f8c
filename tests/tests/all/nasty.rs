//! Designs that nobody means: each ends soon, on a small stack, with the codes it deserves, and says the same twice.

mod evaluation;
mod figures;
mod text;

use std::collections::BTreeSet;
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use ifs_compiler::analysis::analyse;
use ifs_compiler::diagnostic::{Diagnostic, HumanStyle, render_human, render_json, render_short};
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::MemoryFiles;

/// A design, and the codes of everything found in it.
pub(crate) struct Case {
    /// What it tries.
    pub(crate) name: String,
    /// Its bytes.
    pub(crate) bytes: Vec<u8>,
    /// The codes expected, each once.
    pub(crate) codes: &'static [&'static str],
}

/// One case.
pub(crate) fn case(
    name: impl Into<String>,
    codes: &'static [&'static str],
    text: impl Into<Vec<u8>>,
) -> Case {
    Case { name: name.into(), bytes: text.into(), codes }
}

/// As small as the stack of a thread made by `std` is.
const STACK: usize = 2 << 20;

/// Far more than any case takes, on a slow and busy machine: what reaches it hangs.
const PATIENCE: Duration = Duration::from_secs(100);

/// What is found in a design, in words for people and programs, and its codes.
fn found(bytes: Vec<u8>) -> (String, BTreeSet<&'static str>) {
    let files = MemoryFiles::default().with("a.ifs", bytes);
    let analysis = analyse(&files, "a.ifs", &Overrides::default());
    let mut text = String::new();
    let style = HumanStyle { color: false, unicode: true };
    for diagnostic in analysis.diagnostics.iter().take(100) {
        text.push_str(&render_short(diagnostic, &analysis.sources));
        text.push_str(&render_human(diagnostic, &analysis.sources, style));
        text.push_str(&render_json(diagnostic, &analysis.sources));
    }
    let name = |diagnostic: &Diagnostic| diagnostic.code.name();
    (text, analysis.diagnostics.iter().map(name).collect())
}

fn ends_well(case: Case) -> Result<(), String> {
    let (send, receive) = mpsc::channel();
    let bytes = case.bytes;
    let work = move || {
        let first = found(bytes.clone());
        let same = bytes.len() > 100_000 || found(bytes) == first;
        // Nobody listens any more when this took too long.
        let _ = send.send((first.1, same));
    };
    let thread = thread::Builder::new().stack_size(STACK).spawn(work);
    thread.map_err(|error| error.to_string())?;
    match receive.recv_timeout(PATIENCE) {
        Err(mpsc::RecvTimeoutError::Timeout) => Err(format!("{} hangs", case.name)),
        Err(mpsc::RecvTimeoutError::Disconnected) => Err(format!("{} panics", case.name)),
        Ok((_, false)) => Err(format!("{} is not told the same way twice", case.name)),
        Ok((codes, true)) if codes != case.codes.iter().copied().collect() => {
            Err(format!("{} gives {codes:?}, not {:?}", case.name, case.codes))
        }
        Ok(_) => Ok(()),
    }
}

fn all_end_well(cases: Vec<Case>) {
    let faults: Vec<String> = cases.into_iter().filter_map(|case| ends_well(case).err()).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn strange_texts_end_well() {
    all_end_well(text::cases());
}

#[test]
fn deep_nesting_ends_well() {
    all_end_well(text::nested());
}

#[test]
fn endless_evaluations_end_well() {
    all_end_well(evaluation::cases());
}

#[test]
fn strange_ifs_and_figures_end_well() {
    all_end_well(figures::cases());
}
