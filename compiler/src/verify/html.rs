//! `report.html`: well-formed, without anything from outside, and every figure that names its place in `report.json`
//! has the value that is there.

use super::finding::Findings;
use super::report::Report;
use super::xml::{self, Event, attribute};

/// Elements of HTML that have no end.
const VOID: [&str; 8] = ["meta", "br", "hr", "img", "input", "col", "link", "wbr"];

pub(super) fn check(path: &str, text: &str, report: Option<&Report>, findings: &mut Findings) {
    let events = xml::read(path, text, &VOID, findings);
    for event in &events {
        let Event::Open { name, attributes } = event else { continue };
        for key in ["src", "href"] {
            let outside =
                attribute(attributes, key).is_some_and(|to| !to.starts_with('#') && !to.starts_with("data:"));
            if outside {
                findings.add(path, format!("{key} of a {name}"), "a place in the page", "another");
            }
        }
        let (Some(place), Some(report)) = (attribute(attributes, "data-at"), report) else { continue };
        let expected = report.value.pointer(place);
        let Some(found) = attribute(attributes, "value") else { continue };
        match expected {
            None => findings.add(path, "a figure", format!("{place} of report.json"), "no such place"),
            Some(expected) => {
                let same = match (expected.as_f64(), found.parse::<f64>()) {
                    (Some(a), Ok(b)) => (a - b).abs() <= 1e-9 * (1.0 + a.abs()),
                    _ => expected.as_str() == Some(found),
                };
                if !same {
                    findings.add(path, format!("the figure of {place}"), expected, found);
                }
            }
        }
    }
}
