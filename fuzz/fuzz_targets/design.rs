//! Random designs, made of the bytes, through the whole analysis and to the outputs.
#![no_main]

use ifs_tests::generate;
use ifs_tests::invariants::{MODEST, analysis_holds, parse_holds};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let text = generate::design(bytes);
    let found = parse_holds(text.as_bytes()).and_then(|()| analysis_holds(text.as_bytes(), MODEST));
    assert_eq!(found, Ok(()), "{text}");
});
