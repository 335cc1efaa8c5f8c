//! `report.json`: its boards and planks as far as other files repeat them, its totals, and its word on the manifest.
//! `diagnostics.json` too, which is small.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec2;
use serde_json::Value;

use super::Manifest;
use super::finding::Findings;
use super::form;
use super::machine::Workshop;

/// The version of the report that is known here.
const SCHEMA_VERSION: u64 = 1;

/// Half of the last decimal of lengths, mm, and a hair.
pub(super) const LAST_DECIMAL: f64 = 0.000_501;

const PATH: &str = "report.json";

/// A board or plank that was made.
#[derive(Debug, Clone)]
pub(super) struct Part {
    pub(super) address: String,
    pub(super) alias: String,
    pub(super) status: String,
    /// The number of its fabrication.
    pub(super) block: usize,
    pub(super) is_plank: bool,
    pub(super) outline: Vec<DVec2>,
    /// Of boards alone.
    pub(super) design_outline: Vec<DVec2>,
    pub(super) value: Value,
}

impl Part {
    /// A number of it; none where it has none.
    pub(super) fn number(&self, name: &str) -> Option<f64> {
        self.value.get(name)?.as_f64()
    }

    /// One of a list of numbers.
    pub(super) fn item(&self, name: &str, place: usize) -> Option<f64> {
        self.value.get(name)?.get(place)?.as_f64()
    }

    pub(super) fn text(&self, name: &str) -> &str {
        self.value.get(name).and_then(Value::as_str).unwrap_or_default()
    }

    pub(super) fn is_made(&self) -> bool {
        self.status == "made"
    }
}

/// The report.
#[derive(Debug, Clone)]
pub(super) struct Report {
    pub(super) design: String,
    pub(super) design_hash: String,
    pub(super) parts: Vec<Part>,
    /// For each fabrication what its programs are made with; none where no machine is named.
    pub(super) workshops: Vec<Option<Workshop>>,
    pub(super) by_address: BTreeMap<String, usize>,
    pub(super) value: Value,
}

/// Reads the report and checks what it says of itself.
pub(super) fn read(bytes: &[u8], manifest: &Manifest, findings: &mut Findings) -> Option<Report> {
    let value = form::json(PATH, bytes, usize::MAX, findings)?;
    let version = value.get("schema_version").and_then(Value::as_u64);
    if version != Some(SCHEMA_VERSION) {
        let found = version.map_or_else(|| "none".to_owned(), |version| version.to_string());
        findings.add(PATH, "schema_version", SCHEMA_VERSION, found);
        return None;
    }
    let text = |name: &str| value.get(name).and_then(Value::as_str).unwrap_or_default().to_owned();
    let mut report = Report {
        design: text("design"),
        design_hash: text("design_hash"),
        parts: Vec::new(),
        workshops: Vec::new(),
        by_address: BTreeMap::new(),
        value: value.clone(),
    };
    findings.same(PATH, "compiler", &manifest.version, &text("compiler"));
    said_of_sources(&value, manifest, findings);
    for (block, fabrication) in list(&value, "fabrications").iter().enumerate() {
        let is_plank = fabrication.get("kind").and_then(Value::as_str) == Some("planks");
        let parts: Vec<Part> =
            list(fabrication, "parts").iter().map(|value| part(value, block, is_plank)).collect();
        totals(fabrication, &parts, findings);
        let machine = fabrication.get("machine").filter(|machine| !machine.is_null());
        let workshop = machine.and_then(Workshop::of);
        if machine.is_some() && workshop.is_none() {
            findings.add(PATH, "the machine", "one that can work", "another");
        }
        report.workshops.push(workshop);
        for part in parts {
            one(&part, findings);
            if report.by_address.insert(part.address.clone(), report.parts.len()).is_some() {
                findings.add(PATH, "addresses", "that each is there once", &part.address);
            }
            report.parts.push(part);
        }
    }
    report.neighbours(findings);
    report.worst(findings);
    Some(report)
}

/// A list in an object; an empty one where there is none.
pub(super) fn list<'a>(value: &'a Value, name: &str) -> &'a [Value] {
    value.get(name).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

fn part(value: &Value, block: usize, is_plank: bool) -> Part {
    let text = |name: &str| value.get(name).and_then(Value::as_str).unwrap_or_default().to_owned();
    let outline = |name: &str| {
        let number = |point: &Value, axis: usize| point.get(axis).and_then(Value::as_f64).unwrap_or(f64::NAN);
        list(value, name).iter().map(|point| DVec2::new(number(point, 0), number(point, 1))).collect()
    };
    Part {
        address: text("address"),
        alias: text("alias"),
        status: text("status"),
        block,
        is_plank,
        outline: outline("outline_mm"),
        design_outline: outline("design_outline_mm"),
        value: value.clone(),
    }
}

/// Twice the area of an outline, anticlockwise positive, is the sum of these; mm².
pub(super) fn area(outline: &[DVec2]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum::<f64>() / 2.0
}

/// Lengths of the sides of an outline, mm.
pub(super) fn sides(outline: &[DVec2]) -> Vec<f64> {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).map(|(a, b)| a.distance(*b)).collect()
}

fn said_of_sources(value: &Value, manifest: &Manifest, findings: &mut Findings) {
    let mut said: Vec<(&str, &str)> = Vec::new();
    for source in list(value, "sources") {
        let text = |name: &str| source.get(name).and_then(Value::as_str).unwrap_or_default();
        said.push((text("path"), text("sha256")));
    }
    said.sort_unstable();
    let listed: Vec<(&str, &str)> =
        manifest.sources.iter().map(|source| (source.path.as_str(), source.sha256.as_str())).collect();
    if said != listed {
        findings.add(PATH, "sources", "those of manifest.json", "others");
    }
    let mut parameters = BTreeMap::new();
    for parameter in list(value, "parameters") {
        let text = |name: &str| parameter.get(name).and_then(Value::as_str).unwrap_or_default().to_owned();
        parameters.insert(text("name"), text("value"));
    }
    if parameters != manifest.parameters {
        findings.add(PATH, "parameters", "those of manifest.json", "others");
    }
}

fn totals(fabrication: &Value, parts: &[Part], findings: &mut Findings) {
    let count = |name: &str| fabrication.get("counts").and_then(|counts| counts.get(name)?.as_u64());
    let (elements, made, refused) = (count("elements"), count("made"), count("refused"));
    let found = parts.iter().filter(|part| part.is_made()).count() as u64;
    if elements != Some(parts.len() as u64)
        || made != Some(found)
        || refused != Some(parts.len() as u64 - found)
    {
        findings.add(PATH, "counts", format!("{} elements, {found} made", parts.len()), "others");
    }
    let material = |name: &str| fabrication.get("material").and_then(|material| material.get(name)?.as_f64());
    for (name, decimal, of) in
        [("mass_kg", 0.001, "mass_kg"), ("area_m2", 0.000_001, "area_m2"), ("length_mm", 0.001, "length_mm")]
    {
        let made = parts.iter().filter(|part| part.is_made());
        let sum: f64 = made.filter_map(|part| part.number(of)).sum();
        if let Some(said) = material(name) {
            let tolerance = decimal * (0.51 * parts.len() as f64 + 1.0);
            findings.near(PATH, &format!("{name} of the material"), sum, said, tolerance);
        }
    }
    densities(parts, findings);
}

/// Boards of one material weigh the same for their volume.
fn densities(parts: &[Part], findings: &mut Findings) {
    let volume = |part: &Part| Some(part.number("area_m2")? * part.number("thickness_mm")? / 1000.0);
    let heaviest = parts.iter().filter_map(|part| Some((part.number("mass_kg")?, volume(part)?)));
    let (mass, sum) = heaviest.fold((0.0, 0.0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
    if sum > 0.0 {
        for part in parts {
            if let (Some(found), Some(volume)) = (part.number("mass_kg"), volume(part)) {
                let tolerance = 0.0006 + 0.0002 * found;
                findings.near(
                    PATH,
                    &format!("mass of {}", part.address),
                    mass / sum * volume,
                    found,
                    tolerance,
                );
            }
        }
    }
}

/// Area and edges against the outline.
fn one(part: &Part, findings: &mut Findings) {
    if !part.is_made() {
        return;
    }
    let address = &part.address;
    let perimeter: f64 = sides(&part.outline).iter().sum();
    let rounding = 1e-6 + perimeter * 0.001 * 1e-6;
    // The outline of a plank whose ends lean in both directions is its longest face, not its middle.
    let slanted = (0..2).any(|end| part.item("end_bevels_deg", end).is_some_and(|bevel| bevel.abs() > 1e-3));
    let bent = part.number("fold_deg").is_some_and(|fold| fold >= 0.01);
    if let Some(said) = part.number("area_m2").filter(|_| !bent && !slanted) {
        let shape = if part.is_plank { &part.outline } else { &part.design_outline };
        let expected = area(shape) * 1e-6;
        findings.near(PATH, &format!("area of {address}"), expected, said, rounding);
    }
    if !part.is_plank {
        for (edge, length) in sides(&part.design_outline).into_iter().enumerate() {
            let said = part.item("edges_mm", edge).unwrap_or(f64::NAN);
            findings.near(PATH, &format!("edge {edge} of {address}"), length, said, 0.0021);
        }
    }
}

impl Report {
    /// The part of an address.
    pub(super) fn part(&self, address: &str) -> Option<&Part> {
        self.parts.get(*self.by_address.get(address)?)
    }

    /// Who is beside whom is said by both.
    fn neighbours(&self, findings: &mut Findings) {
        for part in &self.parts {
            let list = list(&part.value, "neighbours");
            for neighbour in list.iter().filter_map(Value::as_str) {
                let back = self.part(neighbour).is_none_or(|other| {
                    self::list(&other.value, "neighbours")
                        .iter()
                        .any(|back| back.as_str() == Some(&part.address))
                });
                if !back || !self.by_address.contains_key(neighbour) {
                    let what = format!("neighbours of {}", part.address);
                    findings.add(PATH, what, "boards that have it beside them too", neighbour);
                }
            }
        }
    }

    /// Addresses in the report are of its parts.
    fn worst(&self, findings: &mut Findings) {
        for fabrication in list(&self.value, "fabrications") {
            for requirement in list(fabrication, "requirements") {
                for worst in list(requirement, "worst") {
                    let address = worst.get("address").and_then(Value::as_str).unwrap_or_default();
                    let alias = worst.get("alias").and_then(Value::as_str);
                    let part = self.part(address);
                    if part.is_some_and(|part| alias.is_some_and(|alias| alias != part.alias)) {
                        findings.add(PATH, "worst of a requirement", "a board and its alias", address);
                    }
                }
            }
        }
    }

    /// The files that parts name are the listed ones, and the other way round.
    pub(super) fn check_files(&self, manifest: &Manifest, findings: &mut Findings) {
        let mut named = BTreeSet::new();
        for part in &self.parts {
            for file in list(&part.value, "files").iter().filter_map(Value::as_str) {
                named.insert(file);
                let listed = manifest.files.iter().any(|listed| listed.path == file);
                if !listed && !manifest.is_partial() {
                    findings.add(
                        file,
                        "the file",
                        format!("one for {}", part.address),
                        "not in manifest.json",
                    );
                }
            }
        }
        for file in &manifest.files {
            let Some(address) = &file.address else { continue };
            match self.part(address) {
                None => findings.add(&file.path, "address in manifest.json", "one of report.json", address),
                Some(part) => {
                    let own = list(&part.value, "files").iter().any(|name| name.as_str() == Some(&file.path));
                    if !own {
                        findings.add(
                            &file.path,
                            "address in manifest.json",
                            "the board that names it",
                            address,
                        );
                    }
                }
            }
        }
    }
}

/// How deep the list of `diagnostics.json` lies: each of its diagnostics is one line.
const DIAGNOSTIC_DEPTH: usize = 2;

/// `diagnostics.json`: its numbers are those of its list.
pub(super) fn diagnostics(path: &str, bytes: &[u8], manifest: &Manifest, findings: &mut Findings) {
    let Some(value) = form::json(path, bytes, DIAGNOSTIC_DEPTH, findings) else { return };
    if value.get("schema").and_then(Value::as_u64) != Some(1) {
        findings.add(path, "schema", 1, "another");
    }
    let failed = value.get("failed").and_then(Value::as_bool);
    if failed != Some(manifest.failed) {
        findings.add(path, "failed", manifest.failed, "otherwise");
    }
    let said = |name: &str| value.get(name).and_then(Value::as_u64);
    let listed = list(&value, "diagnostics").len() as u64;
    let sum = said("errors").and_then(|errors| errors.checked_add(said("warnings")?));
    if sum != Some(listed) {
        findings.add(path, "errors and warnings", format!("{listed} together"), "others");
    }
}
