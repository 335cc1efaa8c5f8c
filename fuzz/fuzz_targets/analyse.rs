//! Any bytes through the whole analysis, and to the outputs where they are a design without errors.
#![no_main]

use ifs_tests::invariants::{MODEST, analysis_holds};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    assert_eq!(analysis_holds(bytes, MODEST), Ok(()));
});
