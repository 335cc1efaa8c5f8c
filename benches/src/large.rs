//! Long designs of one kind of item each, and of all kinds: the texts that lexing, parsing, checking and formatting are
//! measured on. Every one of them has no errors.

/// The kinds of long designs.
pub const MIXES: [&str; 11] = [
    "ifs",
    "lets",
    "reverse",
    "functions",
    "records",
    "figures",
    "arches",
    "params",
    "fabricate",
    "tests",
    "all",
];

/// A design of a kind with this many lines, or a few more.
pub fn design(mix: &str, lines: usize) -> String {
    let mut text = IMPORTS.to_owned();
    let mut written = IMPORTS.lines().count();
    let mut parts = Vec::new();
    let mut number = 0;
    while written < lines {
        let part = part(mix, number);
        written += part.lines().count();
        parts.push(part);
        number += 1;
    }
    if mix == "reverse" {
        parts.reverse();
    }
    text.extend(parts);
    text
}

const IMPORTS: &str = "\
//! A long design.

use std.curves (bezier3, bspline3)
use std.surfaces (sheet, tensor)
use std.materials (birch_plywood, sawn_spruce)
use std.machines (router3)

figure used = sheet(bspline3, bspline3, [[(i * 1m, j * 1m, 0m) for j in 0..4] for i in 0..4]) at level 1
figure also = tensor(bezier3, bezier3) on [[(i * 1m, j * 1m, 0m) for j in 0..4] for i in 0..4] at level 1

fabricate used as panels {
    material: birch_plywood(12mm)
    board: 2500mm by 1250mm
    machine: router3(tool: 6mm, feed: 4m/min, spindle: 18000rpm)
}

let spruce = sawn_spruce

";

fn part(mix: &str, number: usize) -> String {
    match mix {
        "ifs" => ifs(number),
        "lets" | "reverse" => lets(number),
        "functions" => function(number),
        "records" => record(number),
        "figures" => figure(number),
        "arches" => arch(number),
        "params" => param(number),
        "fabricate" => fabricate(number),
        "tests" => test(number),
        _ => everything(number),
    }
}

fn everything(number: usize) -> String {
    let turn = number / 8;
    match number % 8 {
        0 => ifs(turn),
        1 => lets(turn),
        2 => function(turn),
        3 => record(turn),
        4 => figure(turn),
        5 => param(turn),
        6 if turn.is_multiple_of(16) => fabricate(turn),
        6 => arch(turn),
        _ => test(turn),
    }
}

/// An arc with a split of its own, and a curve of it.
fn ifs(number: usize) -> String {
    format!(
        "\
/// A cubic arc, split early or late.
/// It is number {number}.
ifs arc_{number}(t: Number = {split}/100) on (p0, p1, p2, p3) {{
    let a = lerp(p0, p1, t)
    let h = lerp(p1, p2, t)
    let d = lerp(p2, p3, t)
    let b = (1 - t) * a + t * h
    let c = (1 - t) * h + t * d
    let m = lerp(b, c, t)

    transform left  = self on (p0, a, b, m)
    transform right = self on (m, c, d, p3)

    germ segment(p0, p3)
}}

figure drawn_{number} = arc_{number} on ((0m, 0m), (1m, 2m), (3m, 2m), (4m, {number}mm)) at level 3

",
        split = 35 + number % 30
    )
}

/// Values that lead to the ones before.
fn lets(number: usize) -> String {
    let before = match number {
        0 => "27mm".to_owned(),
        // A chain of values that is not too deep, however long the file.
        _ if number.is_multiple_of(50) => "30mm".to_owned(),
        _ => format!("width_{} + 1mm", number - 1),
    };
    format!(
        "\
// A comment that says why the width is what it is.
let width_{number} = {before}
let half_{number}: Length = (width_{number} / 2) * cos(30deg) + max(1mm, 2mm)  // half of it
let splits_{number} = [0.46, 0.48, 0.50, 0.52, 0.54]
let points_{number} = [(i * width_{number}, splits_{number}[i] * 1m, half_{number}) for i in 0..5]

"
    )
}

fn function(number: usize) -> String {
    format!(
        "\
/// How high the roof is there.
///
/// It is number {number}.
fn height_{number}(i: Int, j: Int, rise: Length = 4m) -> Length =
    if i < 3 and j != 4 then rise * sin(180deg * i / 6) * sin(180deg * j / {turns}) / 3
    else rise + abs(2mm * i - 3mm * j)

let at_{number} = height_{number}(1, 2) + height_{number}(4, 1, rise: 3m)

",
        turns = 6 + number % 9
    )
}

fn record(number: usize) -> String {
    format!(
        "\
/// A bay of the hall.
record Bay{number} {{
    offset: Length      // from the gable
    crown: Length
    lean: Length = {number}mm
    name: Text = \"bay\"
}}

let bay_{number} = Bay{number}(offset: 2m, crown: {number}mm + 3m)
let lean_{number} = bay_{number}.lean + bay_{number}.offset

"
    )
}

/// A sheet on a net of its own.
fn figure(number: usize) -> String {
    format!(
        "\
let net_{number} = [[(i * 1m, j * 1m, {number}mm * i * j) for j in 0..5] for i in 0..5]

/// Roof {number}: every window of its net.
figure roof_{number} = sheet(bspline3, bspline3, net_{number}) at level 2
figure canopy_{number} = tensor(bezier3, bezier3) on net_{number}[0..4, 0..4] at level (2, 1)

"
    )
}

/// Lists of arches made by a function; every so often with a split of their own.
fn arch(number: usize) -> String {
    format!(
        "\
fn rib_{number}(i: Int) -> Curve =
    bezier3(t: {split}/100) on (
        (0m, i * 60mm, 0m),
        (1m, i * 60mm, 4m),
        (9m, i * 60mm, 4m),
        (10m, i * 60mm, 0m),
    ) at level 3

figure ribs_{number} = [rib_{number}(i) for i in 0..6]

",
        split = 40 + number % 20
    )
}

fn param(number: usize) -> String {
    format!(
        "\
/// The span of bay {number}.
param span_{number}: Length = 12m in 8m .. 16m step 250mm
param bays_{number}: Int = {count} in 2 .. 12
param tilt_{number}: Angle = 5deg in 0deg .. 20deg step 1deg

",
        count = 2 + number % 11
    )
}

/// Two boards and how they are made.
fn fabricate(number: usize) -> String {
    format!(
        "\
let floor_{number} = [[(i * 400mm, j * 300mm, {number}mm) for j in 0..4] for i in 0..4]

figure slab_{number} = tensor(bezier3, bezier3) on floor_{number} at level (1, 0)

fabricate slab_{number} as panels {{
    material: birch_plywood(12mm)
    board:    2500mm by 1250mm
    side:     centred
    grain:    u
    address:  engraved(height: 18mm)

    require edge in 150mm .. 1500mm
    require planarity >= 0.99
}}

"
    )
}

fn test(number: usize) -> String {
    format!(
        "\
test \"the boards can be built, {number}\" {{
    let largest = max(used.boards.area)
    assert len(used.boards) == 4
    assert min(used.boards.planarity) >= 0.9998  // list.field maps over the list
    assert all([len(edges) == 4 for edges in used.boards.edges]) and largest < 40m2
}}

"
    )
}
