//! Labels: each board that was made has one, with its alias, address and outline. The QR codes themselves are not
//! decoded.

use glam::DVec2;

use super::finding::Findings;
use super::report::{Part, Report};
use super::xml::{self, Event, attribute};
use super::{Set, form};

/// A sheet is well-formed, and its numbers are numbers.
pub(super) fn form(path: &str, text: &str, findings: &mut Findings) {
    for event in xml::read(path, text, &[], findings) {
        let Event::Open { name, attributes } = event else { continue };
        if !["svg", "title", "style", "rect", "g", "path", "text"].contains(&name.as_str()) {
            findings.add(path, "an element", "one of a label", &name);
        }
        for (key, value) in &attributes {
            let number = ["x", "y", "font-size", "stroke-width"].contains(&key.as_str());
            if number && value.parse::<f64>().is_err() {
                findings.add(path, format!("{key} of a {name}"), "a number", value);
            }
        }
    }
}

/// One label.
#[derive(Default)]
struct Label {
    texts: Vec<String>,
    paths: Vec<String>,
}

/// Every part has its label, in the order of the report.
pub(super) fn check(set: &Set<'_>, report: &Report, findings: &mut Findings) {
    let mut sheets: Vec<&str> = set
        .manifest
        .files
        .iter()
        .map(|file| file.path.as_str())
        .filter(|path| path.starts_with("labels"))
        .collect();
    // `labels.svg`, `labels-2.svg`, …, `labels-10.svg`.
    sheets.sort_by_key(|path| (path.len() > "labels.svg".len(), path.len(), *path));
    let mut parts = report.parts.iter().filter(|part| part.is_made());
    for path in sheets {
        let Some(bytes) = set.bytes(path) else { return };
        let mut unheard = Findings::default();
        let Some(text) = form::text(path, &bytes, &mut unheard) else { return };
        for label in labels(&xml::read(path, text, &[], &mut unheard)) {
            let alias = label.texts.first().map_or("", String::as_str);
            match parts.find(|part| !set.manifest.is_partial() || part.alias == alias) {
                None => findings.add(path, "labels", "one for each board", alias),
                Some(part) => one(path, part, &label, findings),
            }
        }
    }
    if let Some(part) = parts.next()
        && !set.manifest.is_partial()
    {
        findings.add("labels.svg", "labels", format!("one for {}", part.address), "none");
    }
}

fn labels(events: &[Event]) -> Vec<Label> {
    let (mut labels, mut last) = (Vec::<Label>::new(), "");
    for event in events {
        match event {
            Event::Open { name, attributes } => {
                last = name;
                match (name.as_str(), labels.last_mut()) {
                    ("g", _) => labels.push(Label::default()),
                    ("path", Some(label)) => {
                        label.paths.push(attribute(attributes, "d").unwrap_or_default().to_owned());
                    }
                    _ => {}
                }
            }
            Event::Text(text) if last == "text" => {
                if let Some(label) = labels.last_mut() {
                    label.texts.push(text.clone());
                }
            }
            _ => {}
        }
    }
    labels
}

fn one(path: &str, part: &Part, label: &Label, findings: &mut Findings) {
    let edges = part.outline.len();
    let texts = label.texts.len();
    findings.same(path, "alias of a label", &part.alias, label.texts.first().map_or("", String::as_str));
    if texts < edges + 3 {
        findings.add(path, format!("texts of the label of {}", part.alias), edges + 3, texts);
        return;
    }
    let address = label.texts[1..texts - edges - 1].concat();
    findings.same(path, "address of a label", &part.address, &address);
    let about = &label.texts[texts - edges - 1];
    if !about.starts_with(part.text("material")) {
        findings.add(path, format!("what the label of {} says", part.alias), part.text("material"), about);
    }
    for (edge, number) in label.texts[texts - edges..].iter().enumerate() {
        findings.same(path, "number of an edge", &edge.to_string(), number);
    }
    if let [_, drawn, thick] = label.paths.as_slice() {
        outline(path, part, drawn, thick, findings);
    }
}

/// The drawn outline is the board's to scale; edge 0 is the thick one.
fn outline(path: &str, part: &Part, drawn: &str, thick: &str, findings: &mut Findings) {
    let points = |text: &str| -> Option<Vec<DVec2>> {
        let point = |pair: &str| {
            let (x, y) = pair.split_once(' ')?;
            Some(DVec2::new(x.parse().ok()?, -y.parse::<f64>().ok()?))
        };
        text.strip_prefix('M')?.trim_end_matches('Z').split('L').map(point).collect()
    };
    let what = format!("outline on the label of {}", part.alias);
    let (Some(found), Some(edge)) = (points(drawn), points(thick)) else {
        findings.add(path, what, "a path", "none");
        return;
    };
    if found.len() != part.outline.len() || edge.len() != 2 || edge[0] != found[0] || edge[1] != found[1] {
        findings.add(path, what, "the corners of the board", "others");
        return;
    }
    let size = |points: &[DVec2]| {
        let first = points[0];
        let (low, high) = points.iter().fold((first, first), |(low, high), &at| (low.min(at), high.max(at)));
        (low, high - low)
    };
    let ((low, drawn), (from, real)) = (size(&found), size(&part.outline));
    let scale = if real.x > real.y { drawn.x / real.x } else { drawn.y / real.y };
    for (found, real) in found.iter().zip(&part.outline) {
        findings.near(path, &what, 0.0, (*found - low).distance((*real - from) * scale), 0.003);
    }
}
