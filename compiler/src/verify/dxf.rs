//! A reader of the drawings of boards: tags, layers, polylines and texts; each against its board in `report.json`, all
//! of one fabrication against each other.

use std::collections::BTreeMap;

use glam::DVec2;

use super::Listed;
use super::finding::Findings;
use super::report::{LAST_DECIMAL, Report};
use super::sheets::Shown;
use super::vote::most;

/// A group code and its value.
type Tag<'a> = (u16, &'a str);

/// What of a drawing others are compared with.
pub(super) struct Drawing {
    pub(super) path: String,
    pub(super) address: String,
    block: Option<usize>,
    /// Everything but the entities and what follows from their extent.
    frame: Vec<String>,
    /// The cut outline, mm.
    pub(super) outline: Vec<DVec2>,
    /// Pen strokes of the engraving, mm.
    pub(super) strokes: Vec<Vec<DVec2>>,
    /// Texts below the board, from the third on: what its program's header says too.
    pub(super) notes: Vec<String>,
    /// Which face is up.
    pub(super) face_up: Option<String>,
}

#[derive(Default)]
struct Entity<'a> {
    kind: &'a str,
    tags: Vec<Tag<'a>>,
}

impl<'a> Entity<'a> {
    fn text(&self, code: u16) -> &'a str {
        self.tags.iter().find(|tag| tag.0 == code).map_or("", |tag| tag.1)
    }

    fn number(&self, code: u16) -> f64 {
        self.text(code).parse().unwrap_or(f64::NAN)
    }

    fn points(&self) -> Vec<DVec2> {
        let all =
            |code: u16| self.tags.iter().filter(move |tag| tag.0 == code).map(|tag| tag.1.parse::<f64>());
        all(10).zip(all(20)).map(|(x, y)| DVec2::new(x.unwrap_or(f64::NAN), y.unwrap_or(f64::NAN))).collect()
    }
}

/// Reads a drawing and compares it with its board.
pub(super) fn read(
    file: &Listed,
    text: &str,
    report: Option<&Report>,
    findings: &mut Findings,
) -> Option<Drawing> {
    let path = file.path.as_str();
    let tags = tags(path, text, findings)?;
    let (frame, entities) = parted(&tags);
    if tags.last() != Some(&(0, "EOF")) {
        findings.add(path, "the last tag", "0 EOF", "another");
    }
    handles(path, &entities, &tags, findings);
    let on = |start: &'static str| {
        entities.iter().filter(move |e| e.kind == "LWPOLYLINE" && e.text(8).starts_with(start))
    };
    for entity in &entities {
        shape(path, entity, &tags, findings);
    }
    let outlines: Vec<Vec<DVec2>> = on("CUT").map(Entity::points).collect();
    let designs: Vec<Vec<DVec2>> = on("DESIGN").map(Entity::points).collect();
    let texts: Vec<&Entity<'_>> = entities.iter().filter(|e| e.kind == "TEXT").collect();
    let part = file.address.as_deref().and_then(|address| report?.part(address));
    let outline = outlines.first().cloned().unwrap_or_default();
    if outlines.len() != 1 {
        findings.add(path, "outlines on layers CUT", 1, outlines.len());
    }
    if let Some(part) = part {
        same_outline(path, "the cut outline", &part.outline, &outline, findings);
        if !part.is_plank {
            let found = designs.first().cloned().unwrap_or_default();
            same_outline(path, "the designed outline", &part.design_outline, &found, findings);
        }
    }
    let numbers = outline.len();
    edge_numbers(path, &outline, &texts, findings);
    let below = texts.get(numbers..).unwrap_or_default();
    lines_below(path, below, findings);
    let lines: Vec<&str> = below.iter().map(|text| text.text(1)).collect();
    if let (Some(part), [about, material, ..]) = (part, lines.as_slice()) {
        findings.same(path, "the first line of text", &format!("{} ({})", part.address, part.alias), about);
        let thickness = part.number("thickness_mm");
        let begins = format!("{}, {:.1} mm, face up: ", part.text("material"), thickness.unwrap_or(f64::NAN));
        if material.is_ascii() && begins.is_ascii() && !material.starts_with(&begins) {
            findings.add(path, "the second line of text", begins, material);
        }
    }
    extents(path, &tags, &entities, findings);
    Some(Drawing {
        path: path.to_owned(),
        address: file.address.clone().unwrap_or_default(),
        block: part.map(|part| part.block),
        frame,
        outline,
        strokes: on("ENGRAVE").map(Entity::points).collect(),
        notes: lines.iter().skip(2).map(|line| (*line).to_owned()).collect(),
        face_up: lines.get(1).and_then(|line| Some(line.split_once("face up: ")?.1.to_owned())),
    })
}

/// Reads the drawing of a sheet: the raw board, the cut outlines and the names on them.
pub(super) fn read_sheet(path: &str, text: &str, findings: &mut Findings) -> Option<Shown> {
    let tags = tags(path, text, findings)?;
    let (_, entities) = parted(&tags);
    if tags.last() != Some(&(0, "EOF")) {
        findings.add(path, "the last tag", "0 EOF", "another");
    }
    handles(path, &entities, &tags, findings);
    entities.iter().for_each(|entity| shape(path, entity, &tags, findings));
    extents(path, &tags, &entities, findings);
    let on = |start: &'static str| {
        entities.iter().filter(move |e| e.kind == "LWPOLYLINE" && e.text(8).starts_with(start))
    };
    let board: Vec<DVec2> = on("SHEET").flat_map(Entity::points).collect();
    if board.len() != 4 || board[0] != DVec2::ZERO {
        findings.add(path, "corners of the raw board", "four from the origin", board.len());
    }
    let size = board.get(2).copied().unwrap_or(DVec2::NAN);
    let outlines: Vec<Vec<DVec2>> = on("CUT").map(Entity::points).collect();
    if on("DESIGN").count() != outlines.len() {
        findings.add(path, "designed outlines", outlines.len(), on("DESIGN").count());
    }
    let texts = entities.iter().filter(|e| e.kind == "TEXT").map(|e| e.text(1).to_owned());
    let names = texts.take(outlines.len()).collect();
    Some(Shown { path: path.to_owned(), size, outlines, names })
}

/// The tags of a file, each on two lines: its code, right-aligned, and its value, of the type that the code is for.
fn tags<'a>(path: &str, text: &'a str, findings: &mut Findings) -> Option<Vec<Tag<'a>>> {
    let lines: Vec<&str> = text.lines().collect();
    if !lines.len().is_multiple_of(2) {
        findings.add(path, "lines", "pairs", lines.len());
        return None;
    }
    let mut tags = Vec::with_capacity(lines.len() / 2);
    for (place, pair) in lines.chunks(2).enumerate() {
        let code = pair[0].trim_start().parse::<u16>().ok().filter(|code| format!("{code:>3}") == pair[0]);
        let Some(code) = code else {
            findings.add(path, format!("line {}", 2 * place + 1), "a group code", pair[0]);
            return None;
        };
        if !is_of_code(code, pair[1]) {
            findings.add(
                path,
                format!("line {}", 2 * place + 2),
                format!("a value of group {code}"),
                pair[1],
            );
        }
        tags.push((code, pair[1]));
    }
    Some(tags)
}

/// Whether a value is of the type that its group code is for.
fn is_of_code(code: u16, value: &str) -> bool {
    match code {
        10..=59 => {
            let digits = value.strip_prefix('-').unwrap_or(value);
            let plain = digits.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
            let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
            let padded =
                (part.len() > 1 && part.ends_with('0')) || (whole.len() > 1 && whole.starts_with('0'));
            plain
                && !padded
                && !part.is_empty()
                && value != "-0.0"
                && value.parse::<f64>().is_ok_and(f64::is_finite)
        }
        60..=79 | 90..=99 | 280..=289 => value.parse::<i64>().is_ok_and(|number| number.to_string() == value),
        5 | 105 | 320..=399 => {
            u64::from_str_radix(value, 16).is_ok_and(|number| format!("{number:X}") == value)
        }
        0..=9 | 100..=102 => true,
        _ => false,
    }
}

/// The frame of a drawing, as text, and its entities.
fn parted<'a>(tags: &[Tag<'a>]) -> (Vec<String>, Vec<Entity<'a>>) {
    let (mut frame, mut entities, mut inside, mut variable) =
        (Vec::new(), Vec::<Entity<'_>>::new(), false, "");
    for (place, &(code, value)) in tags.iter().enumerate() {
        if inside && (code, value) != (0, "ENDSEC") {
            match entities.last_mut() {
                Some(last) if code != 0 => last.tags.push((code, value)),
                _ => entities.push(Entity { kind: value, tags: Vec::new() }),
            }
            continue;
        }
        inside = (code, value) == (2, "ENTITIES") && place > 0 && tags[place - 1] == (0, "SECTION");
        if code == 9 {
            variable = value;
        }
        // What follows from the extent: the header's variables, and what the viewport shows.
        let varies = ["$EXTMIN", "$EXTMAX", "$HANDSEED"].contains(&variable) && [5, 10, 20].contains(&code);
        if code == 0 {
            variable = value;
        }
        let shown = variable == "VPORT" && [12, 22, 40].contains(&code);
        frame.push(if varies || shown { format!("{code}") } else { format!("{code} {value}") });
    }
    (frame, entities)
}

/// Handles of entities follow each other, and the next one is in the header.
fn handles(path: &str, entities: &[Entity<'_>], tags: &[Tag<'_>], findings: &mut Findings) {
    let handle = |text: &str| u64::from_str_radix(text, 16).unwrap_or(u64::MAX);
    let mut next: Option<u64> = None;
    for entity in entities {
        let found = handle(entity.text(5));
        if next.is_some_and(|next| next != found) {
            findings.add(path, "handles of entities", "each one more than the one before", entity.text(5));
        }
        next = found.checked_add(1);
    }
    let seed = tags.windows(2).find(|pair| pair[0] == (9, "$HANDSEED")).map(|pair| handle(pair[1].1));
    if next.is_some() && seed != next {
        findings.add(path, "$HANDSEED", "the handle after the last one", "another");
    }
}

/// An entity has the groups of its kind, and a layer that the drawing has.
fn shape(path: &str, entity: &Entity<'_>, tags: &[Tag<'_>], findings: &mut Findings) {
    let layer = entity.text(8);
    if !tags.windows(2).any(|pair| pair[1] == (2, layer)) && !tags.contains(&(2, layer)) {
        findings.add(path, "layer of an entity", "one of the drawing's", layer);
    }
    let owner = entity.text(330);
    if owner != "18" && !tags.contains(&(5, owner)) {
        findings.add(path, "owner of an entity", "one of the drawing's", owner);
    }
    let markers: Vec<&str> = entity.tags.iter().filter(|tag| tag.0 == 100).map(|tag| tag.1).collect();
    let known: &[&str] = match entity.kind {
        "LWPOLYLINE" => &["AcDbEntity", "AcDbPolyline"],
        "TEXT" => &["AcDbEntity", "AcDbText", "AcDbText"],
        "LINE" => &["AcDbEntity", "AcDbLine"],
        "CIRCLE" => &["AcDbEntity", "AcDbCircle"],
        kind => return findings.add(path, "an entity", "LWPOLYLINE, TEXT, LINE or CIRCLE", kind),
    };
    if markers != known {
        findings.add(path, format!("markers of a {}", entity.kind), known.join(", "), markers.join(", "));
    }
    let codes: &[u16] = match entity.kind {
        "LWPOLYLINE" => &[5, 330, 100, 8, 90, 70, 43, 10, 20, 42],
        "TEXT" => &[5, 330, 100, 8, 10, 20, 30, 40, 1, 50, 7, 72, 73, 11, 21, 31],
        _ => return,
    };
    if let Some(other) = entity.tags.iter().find(|tag| !codes.contains(&tag.0)) {
        findings.add(path, format!("groups of a {}", entity.kind), "those of its kind", other.0);
    }
    if entity.kind == "LWPOLYLINE" {
        let closed = !layer.starts_with("ENGRAVE");
        findings.same(path, "flag of a polyline", if closed { "1" } else { "0" }, entity.text(70));
        findings.same(path, "width of a polyline", "0.0", entity.text(43));
        let count = entity.points().len().to_string();
        findings.same(path, "corners of a polyline", &count, entity.text(90));
        let alternate: Vec<u16> =
            entity.tags.iter().map(|tag| tag.0).filter(|code| [10, 20].contains(code)).collect();
        if alternate.chunks(2).any(|pair| pair != [10, 20]) {
            findings.add(path, "corners of a polyline", "x and y by turns", "others");
        }
    } else {
        findings.same(path, "height of a point", "0.0", entity.text(30));
        findings.same(path, "style of a text", "Standard", entity.text(7));
    }
}

fn same_outline(path: &str, what: &str, expected: &[DVec2], found: &[DVec2], findings: &mut Findings) {
    if expected.len() != found.len() {
        findings.add(path, format!("corners of {what}"), expected.len(), found.len());
        return;
    }
    for (corner, (expected, found)) in expected.iter().zip(found).enumerate() {
        for (axis, name) in ["x", "y"].iter().enumerate() {
            let what = format!("{name} of corner {corner} of {what}");
            findings.near(path, &what, expected[axis], found[axis], LAST_DECIMAL);
        }
    }
}

/// The number of each edge stands beside it, along it.
fn edge_numbers(path: &str, outline: &[DVec2], texts: &[&Entity<'_>], findings: &mut Findings) {
    let height = texts.first().map_or(0.0, |text| text.number(40));
    for text in texts {
        findings.near(path, "height of a text", height, text.number(40), 1e-9);
    }
    for (edge, &from) in outline.iter().enumerate() {
        let to = outline[(edge + 1) % outline.len()];
        let Some(text) = texts.get(edge) else {
            findings.add(path, format!("number of edge {edge}"), "a text", "none");
            continue;
        };
        findings.same(path, "number of an edge", &edge.to_string(), text.text(1));
        let at = DVec2::new(text.number(10), text.number(20));
        let along = (to - from).normalize_or_zero();
        let off = at - (from + to) / 2.0;
        findings.near(
            path,
            &format!("place of number {edge} along its edge"),
            -0.4 * height,
            off.dot(along),
            0.01,
        );
        findings.near(
            path,
            &format!("place of number {edge} off its edge"),
            0.5 * height,
            off.dot(along.perp()),
            0.01,
        );
        let turned = DVec2::from_angle(text.number(50).to_radians());
        findings.near(path, &format!("turn of number {edge}"), 0.0, turned.distance(along), 0.001);
    }
}

/// The lines below stand at one left edge, evenly, upright.
fn lines_below(path: &str, texts: &[&Entity<'_>], findings: &mut Findings) {
    let [first, second, ..] = texts else { return };
    let step = second.number(20) - first.number(20);
    for (line, text) in texts.iter().enumerate() {
        findings.near(path, "left edge of a text", first.number(10), text.number(10), 1e-6);
        findings.near(path, "place of a text", first.number(20) + step * line as f64, text.number(20), 1e-5);
        findings.near(path, "turn of a text", 0.0, text.number(50), 1e-9);
    }
}

/// The extent in the header is that of what is drawn.
fn extents(path: &str, tags: &[Tag<'_>], entities: &[Entity<'_>], findings: &mut Findings) {
    let points: Vec<DVec2> = entities.iter().flat_map(Entity::points).collect();
    let Some(&first) = points.first() else { return };
    let (low, high) = points.iter().fold((first, first), |(low, high), &at| (low.min(at), high.max(at)));
    for (name, expected) in [("$EXTMIN", low), ("$EXTMAX", high)] {
        let found = tags.windows(3).find(|run| run[0] == (9, name));
        let number = |place: usize| found.and_then(|run| run[place].1.parse().ok()).unwrap_or(f64::NAN);
        findings.near(path, &format!("x of {name}"), expected.x, number(1), 1e-6);
        findings.near(path, &format!("y of {name}"), expected.y, number(2), 1e-6);
    }
    let port = tags.windows(2).position(|pair| pair[0] == (0, "VPORT") && pair[1].0 == 5);
    let shown = |code: u16| {
        let rest = tags.get(port?..)?;
        rest.iter().find(|tag| tag.0 == code)?.1.parse::<f64>().ok()
    };
    let middle = (low + high) / 2.0;
    for (name, expected, code) in [("x", middle.x, 12), ("y", middle.y, 22)] {
        findings.near(path, &format!("{name} of the view"), expected, shown(code).unwrap_or(f64::NAN), 1e-6);
    }
    if !shown(40).is_some_and(|height| height >= high.y - low.y && height <= 2.0 * (high - low).max_element())
    {
        findings.add(path, "height of the view", "that of the drawing", shown(40).unwrap_or(f64::NAN));
    }
}

/// All drawings of a fabrication have one frame: the same header, tables and blocks.
pub(super) fn check_together(drawings: &[Drawing], findings: &mut Findings) {
    let mut blocks: BTreeMap<Option<usize>, Vec<&Drawing>> = BTreeMap::new();
    for drawing in drawings {
        blocks.entry(drawing.block).or_default().push(drawing);
    }
    for drawings in blocks.values().filter(|drawings| drawings.len() > 2) {
        let Some(usual) = most(drawings.iter().map(|drawing| &drawing.frame)) else { continue };
        for drawing in drawings.iter().filter(|drawing| drawing.frame != *usual) {
            let differs = drawing.frame.iter().zip(usual).find(|(found, usual)| found != usual);
            let (found, expected) =
                differs.map_or(("fewer or more tags", "those of the others"), |(a, b)| (a, b));
            findings.add(&drawing.path, "header and tables", expected, found);
        }
    }
}
