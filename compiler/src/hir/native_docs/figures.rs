//! What the functions of maps, germs, curves and surfaces give, each with a short design that uses it.

use crate::hir::native::Native;

pub(super) const DOCS: &[(Native, &str, &str)] = &[
    (Native::Translate, "Map", "let aside = translate(1m, 0m) * (0m, 0m)"),
    (Native::Rotate, "Map", "let turned = rotate(90deg, about: (1m, 1m)) * (2m, 1m)"),
    (Native::Turn, "Map", "let turned = turn(z, 90deg) * (1m, 0m, 0m)"),
    (Native::Scale, "Map", "let half = scale(1/2) * (4m, 2m)"),
    (Native::Mirror, "Map", "let other = mirror(x) * (1m, 0m, 2m)"),
    (Native::Affine, "Map", "let sheared = affine(1, 1/2, 0, 1) * (0m, 2m)"),
    (
        Native::Point,
        "germ",
        "ifs dust in plane {\n    transform left  = scale(1/3) * self\n    transform right = translate(2m, 0m) * scale(1/3) * self\n    germ point((0m, 0m))\n}\nfigure points = dust at level 4",
    ),
    (
        Native::Polygon,
        "germ",
        "ifs triangles in plane {\n    transform left  = scale(1/2) * self\n    transform right = translate(1m, 0m) * scale(1/2) * self\n    transform top   = translate(0.5m, 0.8m) * scale(1/2) * self\n    germ polygon((0m, 0m), (2m, 0m), (1m, 1.6m))\n}\nfigure gasket = triangles at level 3",
    ),
    (
        Native::Quad,
        "germ",
        "ifs quarter on (a, b, c, d) {\n    let m = (a + b + c + d) / 4\n    transform first  = self on (a, (a + b) / 2, m, (a + d) / 2)\n    transform second = self on ((a + b) / 2, b, (b + c) / 2, m)\n    transform third  = self on (m, (b + c) / 2, c, (c + d) / 2)\n    transform fourth = self on ((a + d) / 2, m, (c + d) / 2, d)\n    germ quad(a, b, c, d)\n}\nfigure sail = quarter on ((0m, 0m, 0m), (4m, 0m, 1m), (4m, 4m, 0m), (0m, 4m, 1m)) at level 2",
    ),
    (
        Native::Strut,
        "germ",
        "ifs mast in space {\n    transform up = translate(0m, 0m, 2m) * scale(1/2) * self\n    keep strut((0m, 0m, 0m), (0m, 0m, 2m), width: 160mm)\n    germ strut((0m, 0m, 0m), (0m, 0m, 2m), width: 160mm)\n}\nfigure pole = mast at level 3",
    ),
    (
        Native::Chain,
        "Curve",
        "use std.curves (bspline3, chain)\n\nfigure ring = chain(bspline3, [(2m * cos(60deg * i), 2m * sin(60deg * i)) for i in 0..6], closed: true) at level 2",
    ),
    (
        Native::Weighted,
        "control point",
        "use std.curves (bezier2)\n\nfigure quarter = bezier2 on ((1m, 0m), weighted((1m, 1m), w: sqrt(2) / 2), (0m, 1m)) at level 4",
    ),
    (
        Native::Translation,
        "Surface",
        "use std.curves (bezier2)\nuse std.surfaces (translation)\n\nlet rail = bezier2 on ((0m, 0m, 0m), (3m, 0m, 2m), (6m, 0m, 0m)) at level 3\nlet profile = bezier2 on ((0m, 0m, 0m), (0m, 2m, 1m), (0m, 4m, 0m)) at level 2\nfigure roof = translation(rail, profile)",
    ),
    (
        Native::ScaleTranslation,
        "Surface",
        "use std.curves (bezier2)\nuse std.surfaces (scale_translation)\n\nlet rail = bezier2 on ((0m, 0m, 0m), (3m, 0m, 2m), (6m, 0m, 0m)) at level 3\nlet profile = bezier2 on ((0m, 0m, 0m), (0m, 2m, 1m), (0m, 4m, 0m)) at level 2\nfigure roof = scale_translation(rail, profile, scale: [1, 1.4, 0.6])",
    ),
    (
        Native::ProjectiveSum,
        "Surface",
        "use std.curves (bezier2)\nuse std.surfaces (projective_sum)\n\nlet rail = bezier2 on ((0m, 0m, 0m), weighted((3m, 0m, 2m), w: 2), (6m, 0m, 0m)) at level 3\nlet profile = bezier2 on ((0m, 0m, 0m), (0m, 2m, 1m), (0m, 4m, 0m)) at level 2\nfigure roof = projective_sum(rail, profile)",
    ),
    (
        Native::Revolution,
        "Surface",
        "use std.curves (bezier2)\nuse std.surfaces (revolution)\n\nlet profile = bezier2 on ((3m, 0m, 0m), (3m, 0m, 2m), (1m, 0m, 3m)) at level 3\nfigure dome = revolution(profile, point: (0m, 0m, 0m), direction: z, segments: 16)",
    ),
    (Native::Plane, "Plane", "let ground = plane((0m, 0m, 0m), z)"),
    (
        Native::Cut,
        "Cut",
        "use std.curves (bezier2)\nuse std.materials (sawn_spruce)\n\nlet ground = plane((0m, 0m, 0m), z)\nfigure rib = bezier2 on ((0m, 0m, 0m), (2m, 0m, 3m), (4m, 0m, 0m)) at level 2\nfabricate rib as planks {\n    material: sawn_spruce\n    section:  120mm by 40mm\n    first:    cut(ground)\n    last:     cut(ground)\n}",
    ),
    (
        Native::Extrusion,
        "Surface",
        "use std.curves (bezier2)\nuse std.surfaces (extrusion)\n\nlet profile = bezier2 on ((0m, 0m, 0m), (2m, 0m, 3m), (4m, 0m, 0m)) at level 3\nfigure barrel = extrusion(profile, vector: (0m, 6m, 0m), pieces: 6)",
    ),
];
