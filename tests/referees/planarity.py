"""libigl as the referee of the planarity of quads: `python planarity.py FILE`.

The file is JSON with our meshes and what we measure of each of their quads, in full double precision:

    {"meshes": [{"name": "rough_shell", "vertices": [[x, y, z], …], "quads": [[a, b, c, d], …], "ratios": [0.004, …]}]}

A ratio is the distance of the diagonals by their mean length. Those of libigl's `quad_planarity`, which carry a sign,
must agree within 1e-9. Prints one line of JSON with the counts and the worst difference; exit code 1 with the faults
on stderr.
"""

import json
import sys

import igl
import numpy

TOLERANCE = 1e-9


def main(path):
    with open(path, encoding="utf-8") as file:
        meshes = json.load(file)["meshes"]
    quads, worst, faults = {}, 0.0, []
    for mesh in meshes:
        faces = numpy.array(mesh["quads"], dtype=numpy.int64)
        theirs = numpy.abs(igl.quad_planarity(numpy.array(mesh["vertices"], dtype=float), faces))
        apart = numpy.abs(theirs - numpy.array(mesh["ratios"], dtype=float))
        quads[mesh["name"]] = len(faces)
        worst = max(worst, float(apart.max()))
        for quad in numpy.flatnonzero(~(apart <= TOLERANCE)).tolist():
            faults.append(f"{mesh['name']}, quad {quad}: {mesh['ratios'][quad]}, libigl says {theirs[quad]}")
    print(json.dumps({"quads": quads, "worst": worst}))
    for fault in faults[:20]:
        print(fault, file=sys.stderr)
    return 1 if faults or not meshes else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python planarity.py FILE")
    sys.exit(main(sys.argv[1]))
