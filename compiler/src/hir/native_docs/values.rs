//! What the functions of maths, lists, vectors and texts give, each with a short design that uses it.

use crate::hir::native::Native;

pub(super) const DOCS: &[(Native, &str, &str)] = &[
    (Native::Asin, "Angle", "let lean = asin(1/2)"),
    (Native::Acos, "Angle", "let lean = acos(0.8)"),
    (Native::Atan, "Angle", "let slope = atan(0.35)"),
    (Native::Atan2, "Angle", "let heading = atan2(2m, 3m)"),
    (Native::Exp, "Number", "let growth = exp(0.5)"),
    (Native::Ln, "Number", "let octaves = ln(8) / ln(2)"),
    (Native::Pow, "Number", "let shrunk = pow(2/3, 4)"),
    (Native::Ceil, "Int", "let boards = ceil(7.3m / 1.25m)"),
    (Native::Mod, "Quantity", "let rest = mod(7.3m, 1.25m)"),
    (Native::Concat, "a list", "let all = concat([[1m, 2m], [3m]])"),
    (Native::Reverse, "the list", "let down = reverse([1m, 2m, 3m])"),
    (
        Native::Transpose,
        "a list of lists",
        "let net = [[(i * 1m, j * 1m, 0m) for j in 0..3] for i in 0..4]\nlet turned = transpose(net)",
    ),
    (Native::Norm, "Length", "let far = norm((3m, 4m) - (0m, 0m))"),
    (Native::Distance, "Length", "let far = distance((0m, 0m), (3m, 4m))"),
    (Native::Dot, "Area", "let v = (3m, 4m) - (0m, 0m)\nlet square = dot(v, v)"),
    (Native::Toward, "Point", "let foot = toward((0m, 0m), (3m, 4m), 500mm)"),
    (Native::WithLength, "Vector", "let v = (3m, 4m, 0m) - (0m, 0m, 0m)\nlet offset = with_length(v, 120mm)"),
    (
        Native::Perpendicular,
        "Vector",
        "let v = (3m, 0m, 0m) - (0m, 0m, 0m)\nlet w = (0m, 4m, 0m) - (0m, 0m, 0m)\nlet up = perpendicular(v, w, 200mm)",
    ),
    (Native::Text, "Text", "let label = \"arch of \" + text(2.5m)"),
];
