//! The pages of documentation for the codes of this room: their examples do what they say.

use super::parsed;
use crate::diagnostic::Code;

/// The blocks of a page whose fence says `kind`.
fn blocks(page: &str, kind: &str) -> Vec<String> {
    let fence = format!("```{kind}\n");
    let parts = page.split(&fence).skip(1);
    parts.map(|part| part.split("```").next().unwrap_or_default().to_owned()).collect()
}

#[test]
fn wrong_examples_are_wrong_and_right_ones_are_right() {
    let mut wrong_ones = 0;
    for code in Code::ALL {
        let ours = code.name().starts_with("E01") || code.name().starts_with("E02");
        for wrong in blocks(code.page(), "ifs wrong") {
            let codes: Vec<Code> = parsed(&wrong).diagnostics.iter().map(|found| found.code).collect();
            if ours {
                wrong_ones += 1;
                assert!(codes.contains(code), "{}: {codes:?}\n{wrong}", code.name());
            } else {
                assert_eq!(codes, vec![], "{}\n{wrong}", code.name());
            }
        }
        for right in blocks(code.page(), "ifs") {
            assert_eq!(parsed(&right).diagnostics, vec![], "{}\n{right}", code.name());
        }
    }
    assert!(wrong_ones >= 9, "{wrong_ones}");
}
