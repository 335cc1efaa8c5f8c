//! `model.btlx`: a part for each board and plank, of its length, thickness and weight, with the cuts of its angles.

use std::collections::BTreeSet;

use glam::{DVec2, DVec3};

use super::Manifest;
use super::finding::Findings;
use super::report::{Part, Report};
use super::vote::most;
use super::xml::{self, Event, attribute};

/// An element: its name, its attributes, its text.
type Inner = (String, Vec<(String, String)>, String);

/// A part: its attributes, and what lies in it in order.
#[derive(Default)]
struct Piece {
    attributes: Vec<(String, String)>,
    inner: Vec<Inner>,
}

impl Piece {
    fn said(&self, name: &str) -> &str {
        attribute(&self.attributes, name).unwrap_or_default()
    }

    fn number(&self, name: &str) -> f64 {
        self.said(name).parse().unwrap_or(f64::NAN)
    }

    /// Texts of the elements of a name.
    fn texts<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a str> {
        self.inner.iter().filter(move |one| one.0 == name).map(|one| one.2.as_str())
    }

    fn elements<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a [(String, String)]> {
        self.inner.iter().filter(move |one| one.0 == name).map(|one| one.1.as_slice())
    }

    /// What every part of its kind repeats: names of elements and attributes, and texts that are no numbers.
    fn skeleton(&self) -> Vec<String> {
        let mut lines: Vec<String> = self.attributes.iter().map(|(key, _)| key.clone()).collect();
        for (name, attributes, text) in &self.inner {
            let mut line = name.clone();
            for (key, value) in attributes {
                let varies = key == "GUID" || (value.parse::<f64>().is_ok() && value.contains('.'));
                line += &if varies { format!(" {key}") } else { format!(" {key}={value}") };
            }
            let varies = text.contains('.') || name == "Text" || name.starts_with("Start");
            lines.push(if varies { line } else { format!("{line} {text}") });
        }
        lines
    }
}

pub(super) fn check(
    path: &str,
    text: &str,
    report: Option<&Report>,
    manifest: &Manifest,
    findings: &mut Findings,
) {
    let events = xml::read(path, text, &[], findings);
    let version = events.iter().find_map(|event| match event {
        Event::Open { name, attributes } if name == "BTLx" => attribute(attributes, "Version"),
        _ => None,
    });
    findings.same(path, "version of BTLx", "2.0.0", version.unwrap_or_default());
    let pieces = pieces(&events);
    for one_kind in [true, false] {
        let is_kind = |piece: &&Piece| piece.elements("FreeContour").next().is_some() == one_kind;
        let same_kind: Vec<&Piece> = pieces.iter().filter(is_kind).collect();
        let Some(usual) = most(same_kind.iter().map(|piece| piece.skeleton())) else { continue };
        for piece in same_kind.iter().filter(|_| same_kind.len() > 2) {
            let own = piece.skeleton();
            // Contours have as many lines as their boards have corners.
            if own.len() == usual.len() && own != usual {
                let differs = own.iter().zip(&usual).find(|(a, b)| a != b).map_or("", |(a, _)| a.as_str());
                findings.add(
                    path,
                    format!("part {}", piece.said("Annotation")),
                    "what the others have",
                    differs,
                );
            }
        }
    }
    let Some(report) = report else { return };
    findings.same(path, "name of the project", &report.design, project(&events));
    let made: Vec<&Part> = report.parts.iter().filter(|part| part.is_made()).collect();
    if !manifest.is_partial() && made.len() != pieces.len() {
        findings.add(path, "parts", made.len(), pieces.len());
    }
    let (mut met, mut guids) = (BTreeSet::new(), BTreeSet::new());
    for (place, piece) in pieces.iter().enumerate() {
        let address = piece.said("Annotation");
        match report.part(address) {
            Some(part) if met.insert(address) => one(path, place, piece, part, findings),
            _ => findings.add(path, "a part", "one for each address of report.json", address),
        }
        for guid in piece.elements("Transformation").filter_map(|all| attribute(all, "GUID")) {
            if !guids.insert(guid) {
                findings.add(path, "GUID of a part", "that each has its own", guid);
            }
        }
    }
}

fn project(events: &[Event]) -> &str {
    let name = events.iter().find_map(|event| match event {
        Event::Open { name, attributes } if name == "Project" => attribute(attributes, "Name"),
        _ => None,
    });
    name.unwrap_or_default()
}

fn pieces(events: &[Event]) -> Vec<Piece> {
    let (mut pieces, mut depth, mut of_part) = (Vec::<Piece>::new(), 0_usize, None);
    for event in events {
        match event {
            Event::Open { name, attributes } => {
                depth += 1;
                if name == "Part" {
                    of_part = Some(depth);
                    pieces.push(Piece { attributes: attributes.clone(), inner: Vec::new() });
                } else if let (Some(_), Some(piece)) = (of_part, pieces.last_mut()) {
                    piece.inner.push((name.clone(), attributes.clone(), String::new()));
                }
            }
            Event::Text(text) => {
                if let Some(last) = pieces.last_mut().and_then(|piece| piece.inner.last_mut()) {
                    last.2.push_str(text);
                }
            }
            Event::Close => {
                if of_part == Some(depth) {
                    of_part = None;
                }
                depth = depth.saturating_sub(1);
            }
        }
    }
    pieces
}

fn one(path: &str, place: usize, piece: &Piece, part: &Part, findings: &mut Findings) {
    let address = &part.address;
    for (name, expected) in [
        ("Designation", part.alias.as_str()),
        ("Group", part.text("figure")),
        ("Material", part.text("material")),
        ("Count", "1"),
    ] {
        findings.same(path, &format!("{name} of {address}"), expected, piece.said(name));
    }
    let numbers = ["SingleMemberNumber", "OrderNumber"].map(|name| piece.said(name).parse::<u64>().ok());
    if numbers != [Some(place as u64 + 1); 2] {
        findings.add(path, format!("numbers of {address}"), place + 1, piece.said("OrderNumber"));
    }
    let number = |name: &str| part.number(name).unwrap_or(f64::NAN);
    findings.near(path, &format!("Weight of {address}"), number("mass_kg"), piece.number("Weight"), 0.000_51);
    findings.near(
        path,
        &format!("Height of {address}"),
        number("thickness_mm"),
        piece.number("Height"),
        0.000_51,
    );
    let vector = |name: &str| {
        let all = piece.elements(name).next()?;
        let axis = |key: &str| attribute(all, key)?.parse::<f64>().ok();
        Some(DVec3::new(axis("X")?, axis("Y")?, axis("Z")?))
    };
    if let (Some(x), Some(y)) = (vector("XVector"), vector("YVector")) {
        for (what, expected, found) in [
            ("XVector", 1.0, x.length()),
            ("YVector", 1.0, y.length()),
            ("angle of the vectors", 0.0, x.dot(y)),
        ] {
            findings.near(path, &format!("{what} of {address}"), expected, found, 1e-9);
        }
    } else {
        findings.add(path, format!("position of {address}"), "two vectors", "others");
    }
    let texts: Vec<&str> = piece.texts("Text").filter(|text| !text.trim().is_empty()).collect();
    if texts.len() > 1 || texts.iter().any(|text| text.trim() != part.alias) {
        findings.add(path, format!("text on {address}"), &part.alias, texts.join(" "));
    }
    if part.is_plank { plank(path, piece, part, findings) } else { panel(path, piece, part, findings) }
}

/// Two cuts with the plank's mitres, the second at its end.
fn plank(path: &str, piece: &Piece, part: &Part, findings: &mut Findings) {
    let address = &part.address;
    findings.near(
        path,
        &format!("Width of {address}"),
        part.number("width_mm").unwrap_or(f64::NAN),
        piece.number("Width"),
        0.000_51,
    );
    let longest = part.outline.iter().map(|at| at.x).fold(f64::MIN, f64::max)
        - part.outline.iter().map(|at| at.x).fold(f64::MAX, f64::min);
    let has_bevels =
        (0..2).any(|end| part.item("end_bevels_deg", end).is_some_and(|bevel| bevel.abs() > 1e-3));
    if !has_bevels {
        findings.near(path, &format!("Length of {address}"), longest, piece.number("Length"), 0.0011);
    }
    let angles: Vec<f64> = piece.texts("Angle").filter_map(|text| text.trim().parse().ok()).collect();
    for end in 0..2 {
        if let (Some(mitre), Some(angle)) = (part.item("mitres_deg", end), angles.get(end)) {
            let found = (angle - 90.0).abs();
            findings.near(path, &format!("mitre {end} of {address}"), mitre.abs(), found, 0.0002);
        }
    }
    let orientations: Vec<&str> = piece.texts("Orientation").map(str::trim).collect();
    findings.same(path, &format!("ends of {address}"), "start end", &orientations.join(" "));
    let last = piece.texts("StartX").nth(1).and_then(|text| text.trim().parse().ok()).unwrap_or(f64::NAN);
    if !(0.0..=piece.number("Length") + 1e-6).contains(&last) {
        findings.add(path, format!("place of the end of {address}"), "on the plank", last);
    }
}

/// A closed contour with the board's bevels, as wide as they let it be.
fn panel(path: &str, piece: &Piece, part: &Part, findings: &mut Findings) {
    let address = &part.address;
    let point = |all: &[(String, String)]| {
        let axis = |key: &str| attribute(all, key).and_then(|text| text.parse().ok()).unwrap_or(f64::NAN);
        DVec2::new(axis("X"), axis("Y"))
    };
    let corners: Vec<DVec2> = piece.elements("EndPoint").map(point).collect();
    let start = piece.elements("StartPoint").next().map(point);
    if corners.is_empty() || start != corners.last().copied() {
        findings.add(path, format!("contour of {address}"), "one that closes", "another");
        return;
    }
    let size = |points: &[DVec2]| {
        let first = points[0];
        let (low, high) = points.iter().fold((first, first), |(low, high), &at| (low.min(at), high.max(at)));
        high - low
    };
    let found = size(&corners);
    let bevels: Vec<Option<f64>> = (0..4).map(|edge| part.item("bevels_deg", edge)).collect();
    let widest = bevels.iter().flatten().map(|bevel| libm::tan(bevel.abs().to_radians())).fold(0.0, f64::max);
    let room = 2.0 * widest * part.number("thickness_mm").unwrap_or(0.0) + 0.01;
    if part.outline.len() > 2 {
        // The reference side may lie turned; its sides are still the board's, as far as the bevels let them.
        let sides = |points: &[DVec2]| {
            let mut all = super::report::sides(points);
            all.sort_by(f64::total_cmp);
            all
        };
        let (own, here) = (sides(&part.outline), sides(&corners));
        if own.len() == here.len() {
            for (own, here) in own.iter().zip(&here) {
                findings.near(path, &format!("a side of {address}"), *own, *here, 4.0 * room);
            }
        }
    }
    // The raw part holds the other face too, which reaches further where edges lean out.
    for (name, contour) in [("Length", found.x), ("Width", found.y)] {
        let raw = piece.number(name);
        if !(contour - 2e-6..=contour + 5.0 * room).contains(&raw) {
            findings.add(path, format!("{name} of {address}"), format!("{contour} and room for bevels"), raw);
        }
    }
    let mut inclined: Vec<f64> = piece
        .elements("Line")
        .filter_map(|all| attribute(all, "Inclination")?.parse::<f64>().ok())
        .map(f64::abs)
        .collect();
    let mut expected: Vec<f64> = bevels.iter().map(|bevel| bevel.unwrap_or(0.0).abs()).collect();
    if inclined.len() == expected.len() {
        inclined.sort_by(f64::total_cmp);
        expected.sort_by(f64::total_cmp);
        for (found, expected) in inclined.iter().zip(&expected) {
            findings.near(path, &format!("an inclination of {address}"), *expected, *found, 0.0002);
        }
    }
}
