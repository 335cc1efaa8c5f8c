"""scipy and geomdl as referees of curve and surface points: `python curves.py FILE` (or `-` for the standard input).

The file is JSON with our points in full double precision (the shortest decimal that gives the same number back):

    {"curves":   [{"kind": "bezier"|"bspline", "degree": 3, "split": null|0.46, "level": 4,
                   "points": [[x, y, z], …], "weights": null|[w, …], "closed": false,
                   "vertices": [[x, y, z], …]}],
     "surfaces": [{"kind": …, "degree": …, "split": …, "levels": [2, 2],
                   "net": [[[x, y, z], …], …], "weights": null|[[w, …], …], "closed": [false, false],
                   "vertices": [[[x, y, z], …], …]}]}

`kind`, `degree` and `split` of a surface are one value for both directions or a pair [u, v]. `net[i][j]` and
`vertices[i][j]` run with i in u and j in v. A Bézier curve has degree + 1 points; each level splits every interval of
its parameter at `split` (1/2 if null). A B-spline is uniform, its n points give n - degree spans, and each level halves
them; `split` must be null. Vertices lie on the curve, in the order of the parameter, both ends included. A closed
B-spline is continued by its own first points, and its last vertex, the first one again, is left out. With weights a
curve or surface is rational: scipy gets the homogeneous coordinates, to be divided here, and geomdl its own NURBS.

A coordinate may differ by 1e-12 times the greatest control coordinate (at least 1), from scipy and from geomdl. Prints
one line of JSON with the greatest differences; exit code 1 if one is too great or the number of vertices is wrong.
"""

import json
import sys

import numpy
from geomdl import NURBS
from geomdl import BSpline as geomdl_bspline
from scipy.interpolate import BPoly, BSpline

TOLERANCE = 1e-12


def parameters(kind, degree, split, level, count):
    """The parameters of the vertices, from the first end to the last."""
    if kind == "bezier":
        if count != degree + 1:
            raise ValueError(f"{count} points for a Bézier curve of degree {degree}")
        ends = [0.0, 1.0]
    elif kind == "bspline":
        if split is not None or count <= degree:
            raise ValueError("a B-spline is split in halves and has more points than its degree")
        ends = [float(u) for u in range(count - degree + 1)]
    else:
        raise ValueError(f"unknown kind {kind!r}")
    t = 0.5 if split is None else split
    for _ in range(level):
        between = [a + t * (b - a) for a, b in zip(ends, ends[1:])]
        ends = [u for pair in zip(ends, between) for u in pair] + ends[-1:]
    return numpy.array(ends)


def knots(kind, degree, count):
    """The knots over which the vertices' parameters run."""
    if kind == "bezier":
        return [0.0] * (degree + 1) + [1.0] * (degree + 1)
    return [float(k - degree) for k in range(count + degree + 1)]


def by_scipy(kind, degree, points, at):
    """Points along the first axis of `points`: by the Bernstein form for Bézier, by the B-spline form else."""
    if kind == "bezier":
        return BPoly(points[:, numpy.newaxis], [0.0, 1.0])(at)
    return BSpline(numpy.array(knots(kind, degree, len(points))), points, degree)(at)


def curve_by_geomdl(kind, degree, points, at):
    rational = points.shape[-1] == 4
    curve = (NURBS if rational else geomdl_bspline).Curve(normalize_kv=False)
    curve.degree = degree
    if rational:
        curve.ctrlptsw = points.tolist()
    else:
        curve.ctrlpts = points.tolist()
    curve.knotvector = knots(kind, degree, len(points))
    return numpy.array(curve.evaluate_list(at.tolist()))


def surface_by_geomdl(kinds, degrees, net, at_u, at_v):
    surface = (NURBS if net.shape[-1] == 4 else geomdl_bspline).Surface(normalize_kv=False)
    surface.degree_u, surface.degree_v = degrees
    surface.ctrlpts2d = net.tolist()
    surface.knotvector_u = knots(kinds[0], degrees[0], net.shape[0])
    surface.knotvector_v = knots(kinds[1], degrees[1], net.shape[1])
    pairs = [(u, v) for u in at_u.tolist() for v in at_v.tolist()]
    return numpy.array(surface.evaluate_list(pairs)).reshape(len(at_u), len(at_v), -1)


def both(value):
    """A value for both directions, or a pair, as a pair."""
    return value if isinstance(value, list) else [value, value]


def homogeneous(points, weights):
    """Rows (wx, wy, wz, w), or the points as they are where they have no weights."""
    if weights is None:
        return points
    weights = numpy.array(weights, dtype=float)[..., numpy.newaxis]
    return numpy.concatenate([points * weights, weights], axis=-1)


def divided(points):
    return points[..., :3] / points[..., 3:] if points.shape[-1] == 4 else points


def continued(points, degree, closed, axis):
    """A closed list is followed by its own first points."""
    return numpy.concatenate([points, points.take(range(degree), axis)], axis) if closed else points


def check_curve(curve):
    kind, degree, points = curve["kind"], curve["degree"], numpy.array(curve["points"], dtype=float)
    closed = curve.get("closed", False)
    rows = continued(homogeneous(points, curve.get("weights")), degree, closed, 0)
    at = parameters(kind, degree, curve.get("split"), curve["level"], len(rows))
    at = at[:-1] if closed else at
    return points, [divided(by_scipy(kind, degree, rows, at)), curve_by_geomdl(kind, degree, rows, at)]


def check_surface(surface):
    kinds, degrees, splits = both(surface["kind"]), both(surface["degree"]), both(surface.get("split"))
    net = numpy.array(surface["net"], dtype=float)
    closed, heavy = both(surface.get("closed", False)), homogeneous(net, surface.get("weights"))
    for d in (0, 1):
        heavy = continued(heavy, degrees[d], closed[d], d)
    at = [parameters(kinds[d], degrees[d], splits[d], surface["levels"][d], heavy.shape[d]) for d in (0, 1)]
    at = [at[d][:-1] if closed[d] else at[d] for d in (0, 1)]
    rows = by_scipy(kinds[0], degrees[0], heavy, at[0])
    grid = divided(by_scipy(kinds[1], degrees[1], rows.transpose(1, 0, 2), at[1]).transpose(1, 0, 2))
    return net, [grid, surface_by_geomdl(kinds, degrees, heavy, at[0], at[1])]


def main(path):
    with sys.stdin if path == "-" else open(path, encoding="utf-8") as file:
        document = json.load(file)
    named = [(f"curve {n}", c, check_curve) for n, c in enumerate(document.get("curves", []))]
    named += [(f"surface {n}", s, check_surface) for n, s in enumerate(document.get("surfaces", []))]
    if not named:
        print("nothing to compare", file=sys.stderr)
        return 2
    worst, vertices, faults = {"scipy": 0.0, "geomdl": 0.0}, 0, 0
    for name, item, check in named:
        control, references = check(item)
        ours = numpy.array(item["vertices"], dtype=float)
        vertices += ours.size // ours.shape[-1]
        allowed = TOLERANCE * max(1.0, float(numpy.abs(control).max()))
        for who, reference in zip(worst, references):
            if ours.shape != reference.shape:
                print(f"{name}: vertices {ours.shape}, {who} {reference.shape}", file=sys.stderr)
                faults += 1
                continue
            difference = float(numpy.abs(ours - reference).max())
            worst[who] = max(worst[who], difference)
            if not difference <= allowed:
                print(f"{name}: {difference} from {who}, allowed {allowed}", file=sys.stderr)
                faults += 1
    print(json.dumps({"compared": len(named), "vertices": vertices, "worst": worst}))
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python curves.py FILE")
    sys.exit(main(sys.argv[1]))
