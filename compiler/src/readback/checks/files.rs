//! A program is one file; where tools are put in by hand, one for each tool in the order they are used.

use crate::readback::{Expected, Fault, FaultKind, File};

pub(in crate::readback) fn check(files: &[File], expected: &Expected, faults: &mut Vec<Fault>) {
    let (engraver, cutter) = (expected.machine.engraver().number, expected.machine.cutter().number);
    let wanted = match expected.machine.spec().dialect.profile().changes_tools {
        true => vec![None],
        false if engraver == cutter => vec![Some(cutter)],
        false => vec![Some(engraver), Some(cutter)],
    };
    let found: Vec<Option<u32>> = files.iter().map(|file| file.tool).collect();
    if found != wanted {
        let words = |files: &[Option<u32>]| {
            let each = files.iter().map(|tool| tool.map_or("all tools".to_owned(), |n| format!("tool {n}")));
            each.collect::<Vec<_>>().join(", ")
        };
        let message = format!("files for {}, not for {}", words(&found), words(&wanted));
        faults.push(Fault::new(FaultKind::FileSet, 0, message));
    }
}
