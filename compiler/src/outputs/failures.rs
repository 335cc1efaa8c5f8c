//! Boards that get no program, in a diagnostic for all of a block.

use crate::diagnostic::{Code, Diagnostic, Fix};
use crate::fabricate::cut_job::CutJob;
use crate::fabricate::toolpath::Refusal;
use crate::source::Span;

/// How many boards that cannot be cut are named.
const NAMED: usize = 5;

/// A board that gets no program, and why.
pub(super) struct Failure {
    pub(super) code: Code,
    pub(super) alias: String,
    pub(super) address: String,
    pub(super) why: String,
    pub(super) refusal: Option<Refusal>,
}

impl Failure {
    /// E0901: its machine cannot cut it.
    pub(super) fn refused(job: &CutJob, refusal: Refusal) -> Failure {
        let (alias, address) = (job.alias.clone(), job.address.clone());
        Failure { code: Code::E0901, alias, address, why: refusal.to_string(), refusal: Some(refusal) }
    }
}

/// What is said of the boards of a block that fail with a code; `fix` lets them be cut.
pub(super) fn failed(code: Code, failures: &[&Failure], span: Span, fix: Option<Fix>) -> Option<Diagnostic> {
    let first = failures.first()?;
    let message = format!("{} ({}) gets no program: {}", first.alias, first.address, first.why);
    let mut diagnostic = Diagnostic::new(code, span, message).label("cannot be cut by this machine");
    if failures.len() > 1 {
        let others: Vec<&str> =
            failures[1..].iter().take(NAMED).map(|failure| failure.alias.as_str()).collect();
        let more = if failures.len() > NAMED + 1 { ", …" } else { "" };
        diagnostic = diagnostic.note(format!("and {} more: {}{more}", failures.len() - 1, others.join(", ")));
    }
    let remedy = first.refusal.as_ref().and_then(Refusal::remedy);
    Some(match (code, remedy) {
        (Code::E0901, Some(remedy)) => diagnostic.ways(remedy, fix.into_iter().collect()),
        (Code::E0901, None) => diagnostic.hint("change its outline"),
        _ => diagnostic.note("the program was read back and does not cut the board; nothing was written"),
    })
}
