//! Every text has an analysis that ends, says the same twice, and has a plan where it has no errors.

use ifs_compiler::analysis::{Analysis, analyse};
use ifs_compiler::hir::evaluate::{Limits, Overrides};
use ifs_compiler::source::MemoryFiles;

use super::diagnostics::printed;
use super::outputs::outputs_hold;
use super::{Holds, holds};

/// Enough for every design of a page, and answered at once.
pub const MODEST: Limits = Limits { steps: 50_000, elements: 2_000, boards: 40 };

/// The whole analysis of any bytes, and the outputs where there are no errors.
///
/// # Errors
/// What does not hold, in words.
pub fn analysis_holds(bytes: &[u8], limits: Limits) -> Holds {
    let files = MemoryFiles::default().with("a.ifs", bytes);
    let overrides = Overrides { limits, ..Overrides::default() };
    let first = analyse(&files, "a.ifs", &overrides);
    let said = printed(&first.diagnostics, &first.sources)?;
    let again = analyse(&files, "a.ifs", &overrides);
    let repeated = printed(&again.diagnostics, &again.sources)?;
    holds(said == repeated, || format!("two analyses differ:\n{said}\nand\n{repeated}"))?;
    holds(plan(&first) == plan(&again), || "two analyses have different plans".to_owned())?;
    if first.has_errors() {
        return Ok(());
    }
    holds(first.plan.is_some(), || "no plan, and nothing is wrong".to_owned())?;
    outputs_hold(&first, &again)
}

fn plan(analysis: &Analysis) -> Option<String> {
    analysis.plan.as_ref().map(|lowered| format!("{:?}", lowered.plan))
}
