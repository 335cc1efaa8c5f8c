//! What each function of the program gives, in words, with a short design that uses it. The designs are compiled by a
//! test.

mod figures;
mod values;

use super::native::Native;

/// What a native gives and an example of it, where it has one.
pub(super) fn native_docs(native: Native) -> Option<(&'static str, &'static str)> {
    let mut all = DOCS.iter().chain(figures::DOCS).chain(values::DOCS);
    all.find(|(of, _, _)| *of == native).map(|(_, gives, example)| (*gives, *example))
}

const DOCS: &[(Native, &str, &str)] = &[
    (Native::Sin, "Number", "let rise = 2m * sin(30deg)"),
    (Native::Cos, "Number", "let run = 2m * cos(60deg)"),
    (Native::Tan, "Number", "let slope = tan(45deg)"),
    (Native::Sqrt, "Quantity", "let diagonal = sqrt(3m * 3m + 4m * 4m)"),
    (Native::Abs, "Quantity", "let apart = abs(2m - 5m)"),
    (Native::Floor, "Int", "let whole = floor(7m / 2m)"),
    (Native::Round, "Int", "let nearest = round(7m / 2m)"),
    (Native::Min, "Quantity", "let least = min([3m, 2m, 5m])\nlet smaller = min(least, 1m)"),
    (Native::Max, "Quantity", "let most = max([3m, 2m, 5m])\nlet larger = max(most, 9m)"),
    (Native::Sum, "Quantity", "let total = sum([3m, 2m, 5m])"),
    (Native::Len, "Int", "let count = len([3m, 2m, 5m])"),
    (Native::Mean, "Quantity", "let middle = mean([3m, 2m, 4m])"),
    (Native::All, "Bool", "let every = all([width > 20mm for width in [27mm, 40mm]])"),
    (Native::Any, "Bool", "let some = any([width > 30mm for width in [27mm, 40mm]])"),
    (
        Native::Close,
        "Bool",
        "test \"a diagonal\" {\n    assert close(sqrt(1m2 + 1m2), 1414.2mm, within: 0.1mm)\n}",
    ),
    (Native::Lerp, "Point", "let quarter = lerp((0m, 0m), (4m, 2m), 1/4)"),
    (Native::Interpolate, "Length", "let radius = interpolate(10mm, [(9mm, 1200mm), (12mm, 2000mm)])"),
    (
        Native::Segment,
        "germ",
        "ifs halves on (a, b) {\n    let m = lerp(a, b, 1/2)\n    transform left  = self on (a, m)\n    transform right = self on (m, b)\n    germ segment(a, b)\n}",
    ),
    (
        Native::Tensor,
        "Ifs",
        "use std.curves (bezier2)\nuse std.surfaces (tensor)\n\nlet net = [[(i * 1m, j * 1m, i * j * 0.2m) for j in 0..3] for i in 0..3]\nfigure patch = tensor(bezier2, bezier2) on net at level 3",
    ),
    (
        Native::Sheet,
        "Surface",
        "use std.curves (bspline3)\nuse std.surfaces (sheet)\n\nlet net = [[(i * 1m, j * 1m, 0.2m * sin(60deg * i)) for j in 0..6] for i in 0..6]\nfigure roof = sheet(bspline3, bspline3, net) at level 2",
    ),
    (
        Native::Mesh,
        "germ",
        "ifs tent in space {\n    transform half = scale(1/2) * self\n    germ mesh(\n        [(0m, 0m, 0m), (2m, 0m, 0m), (0m, 2m, 0m), (0m, 0m, 2m)],\n        [[0, 1, 3], [1, 2, 3], [2, 0, 3]],\n    )\n}",
    ),
    (
        Native::Import,
        "germ",
        "ifs column in space {\n    transform up = translate(0m, 0m, 2m) * scale(1/2) * self\n    keep strut((0m, 0m, 0m), (0m, 0m, 2m), width: 160mm)\n    germ import(\"joint.glb\")\n}\nfigure pole = column at level 3",
    ),
];
