"""numpy as the referee of the library's figures of plane and space: `python textbook.py FILE`.

The file is JSON with our elements in full double precision, in millimetres:

    {"figures": [{"name": "fern", "level": 7, "size": 10000.0, "elements": [[[x, y, z], …], …]}]}

Each figure is worked out again from its maps as the textbooks print them, or by its digits in base 3 (carpet and
sponge), as an array of elements by vertices by coordinates. The counts and the boxes must agree, and the elements as
sets: each of ours is one of the reference's and the other way round, with all vertices within 1e-9 of the figure's
size, and as many stand on one place.

Prints one line of JSON with the counts; exit code 1 with the faults on stderr.
"""

import itertools
import json
import sys

import numpy
from scipy.spatial import cKDTree

TOLERANCE = 1e-9


def iterated(maps, germ, level):
    """All words of `level` maps (A, t) on the vertices of a germ."""
    elements = numpy.array([germ], dtype=float)
    for _ in range(level):
        elements = numpy.concatenate([elements @ numpy.array(a).T + numpy.array(t) for a, t in maps])
    return elements


def fern(size, level):
    """Barnsley's table of ten units; the largest frond as the turn by -2.66 degrees and the scale 0.85."""
    unit, turn = size / 10, numpy.radians(-2.66)
    c, s = 0.85 * numpy.cos(turn), 0.85 * numpy.sin(turn)
    maps = [
        ([[0, 0], [0, 0.16]], [0, 0]),
        ([[c, -s], [s, c]], [0, 1.6 * unit]),
        ([[0.20, -0.26], [0.23, 0.22]], [0, 1.6 * unit]),
        ([[-0.15, 0.28], [0.26, 0.24]], [0, 0.44 * unit]),
    ]
    return iterated(maps, [[0, 0], [0, size]], level)


def von_koch(size, level):
    """Each segment of complex numbers becomes four, the second turned by 60 degrees."""
    line = numpy.array([0, size], dtype=complex)
    for _ in range(level):
        a, step = line[:-1], numpy.diff(line) / 3
        tip = a + step + step * numpy.exp(1j * numpy.pi / 3)
        line = numpy.append(numpy.stack([a, a + step, tip, a + 2 * step], axis=1).ravel(), line[-1])
    points = numpy.stack([line.real, line.imag], axis=1)
    return numpy.stack([points[:-1], points[1:]], axis=1)


def heighway(size, level):
    """z -> (1 + i) z / 2 and z -> 1 - (1 - i) z / 2."""
    half = 0.5
    maps = [([[half, -half], [half, half]], [0, 0]), ([[-half, -half], [half, -half]], [size, 0])]
    return iterated(maps, [[0, 0], [size, 0]], level)


def sierpinski_triangle(size, level):
    """On a base and a height of `size`."""
    corners = [[0, 0], [size, 0], [size / 2, size]]
    half = [[0.5, 0], [0, 0.5]]
    return iterated([(half, [x / 2, y / 2]) for x, y in corners], corners, level)


def sierpinski_tetrahedron(size, level):
    corners = [[0, 0, 0], [size, size, 0], [size, 0, size], [0, size, size]]
    half = numpy.eye(3) / 2
    return iterated([(half, numpy.array(corner) / 2) for corner in corners], corners, level)


def by_digits(size, level, dimension, most):
    """The cells of a grid of 3^level whose digits in base 3 have at no place more than `most` ones."""
    digits = [d for d in itertools.product(range(3), repeat=dimension) if d.count(1) <= most]
    cells = numpy.zeros((1, dimension), dtype=int)
    for _ in range(level):
        cells = (3 * cells[:, None, :] + numpy.array(digits)[None, :, :]).reshape(-1, dimension)
    return cells * (size / 3**level)


def sierpinski_carpet(size, level):
    corners = numpy.array([[0, 0], [1, 0], [1, 1], [0, 1]]) * (size / 3**level)
    return by_digits(size, level, 2, 1)[:, None, :] + corners


def menger_sponge(size, level):
    corners = numpy.array(list(itertools.product(range(2), repeat=3))) * (size / 3**level)
    return by_digits(size, level, 3, 1)[:, None, :] + corners


FIGURES = [
    fern,
    von_koch,
    heighway,
    sierpinski_triangle,
    sierpinski_tetrahedron,
    sierpinski_carpet,
    menger_sponge,
]


def judged(ours, reference, allowed):
    """The faults of one figure, and the greatest difference."""
    if ours.shape[:2] != reference.shape[:2]:
        return [f"{ours.shape[:2]} elements and vertices, expected {reference.shape[:2]}"], 0.0
    if reference.shape[2] == 2:
        reference = numpy.pad(reference, ((0, 0), (0, 0), (0, 1)))
    faults = []
    for name, corner in (("low", numpy.min), ("high", numpy.max)):
        apart = float(numpy.abs(corner(ours, axis=(0, 1)) - corner(reference, axis=(0, 1))).max())
        if not apart <= allowed:
            faults.append(f"the {name} corners of the boxes are {apart} apart")
    # Elements that the maps put on one place are matched as often as they are there.
    flat, other = (elements.reshape(len(elements), -1) for elements in (ours, reference))
    distances = [cKDTree(a).query(b, p=numpy.inf)[0].max() for a, b in ((flat, other), (other, flat))]
    worst = float(max(distances))
    if not worst <= allowed:
        faults.append(f"an element is {worst} from the nearest one of the other set")
    if multiplicities(flat, allowed) != multiplicities(other, allowed):
        faults.append("an element stands on its place more or less often")
    return faults, worst


def multiplicities(rows, allowed):
    """How many elements have how many others on their place."""
    found = cKDTree(rows).query_ball_point(rows, 2 * allowed, p=numpy.inf, return_length=True)
    return dict(zip(*(part.tolist() for part in numpy.unique(found, return_counts=True))))


def main(path):
    with open(path, encoding="utf-8") as file:
        figures = json.load(file)["figures"]
    known = {figure.__name__: figure for figure in FIGURES}
    elements, worst, bad = {}, 0.0, False
    for figure in figures:
        name, size = figure["name"], figure["size"]
        ours = numpy.array(figure["elements"], dtype=float)
        faults, apart = judged(ours, known[name](size, figure["level"]), TOLERANCE * size)
        worst = max(worst, apart / size)
        elements[f"{name} {figure['level']}"] = len(ours)
        for fault in faults:
            bad = True
            print(f"{name} at level {figure['level']}: {fault}", file=sys.stderr)
    print(json.dumps({"elements": elements, "worst": worst}))
    return 1 if bad or not figures else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python textbook.py FILE")
    sys.exit(main(sys.argv[1]))
