//! Any bytes through lexer, parser and the forms of diagnostics.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    assert_eq!(ifs_tests::invariants::parse_holds(bytes), Ok(()));
});
