"""Planarizes a quad mesh by another's solver: `python planarize.py libigl|shapeop GIVEN MADE RATIO SECONDS`.

GIVEN begins with the number of vertices; then one vertex or quad a line. MADE gets the vertices. Prints the seconds of
the solving alone: of the run that reached the ratio, or of the last one within the time. The mesh is scaled to a size of
1 for the solver, whose weights and thresholds are made for that.

libigl's `planarize_quad_mesh` works from the mesh as it was given for a number of steps, and ends by itself where it has
reached the ratio: it is given twice as many steps again and again. ShapeOp goes on from where it was, with a plane for
each quad and vertices held close to where they were by a weight of a thousandth of that, as its examples do.
"""

import sys
import time

import numpy


def ratios(vertices, quads):
    """The largest distance of diagonals by their mean length."""
    a, b, c, d = (vertices[quads[:, corner]] for corner in range(4))
    e, f = c - a, d - b
    normal = numpy.cross(e, f)
    lengths = (numpy.linalg.norm(e, axis=1) + numpy.linalg.norm(f, axis=1)) / 2
    distances = numpy.abs(numpy.einsum("ij,ij->i", b - a, normal)) / numpy.linalg.norm(normal, axis=1)
    return float((distances / lengths).max())


def libigl(vertices, quads, ratio, seconds):
    import igl

    steps, spent = 25, 0.0
    while True:
        begun = time.perf_counter()
        made = igl.planarize_quad_mesh(vertices, quads, steps, ratio)
        took = time.perf_counter() - begun
        spent += took
        if ratios(made, quads) <= ratio * 1.001 or spent + 2 * took > seconds:
            return made, took
        steps *= 2


def shapeop(vertices, quads, ratio, seconds):
    from compas_shapeop.shapeop import Solver

    begun = time.perf_counter()
    solver = Solver()
    solver.points = vertices
    for quad in quads.tolist():
        solver.add_plane_constraint(quad, 1.0)
    for vertex in range(len(vertices)):
        solver.add_closeness_constraint(vertex, 1e-3)
    solver.init()
    while True:
        solver.solve(50)
        took = time.perf_counter() - begun
        made = numpy.array(solver.points)
        if ratios(made, quads) <= ratio or took > seconds:
            return made, took


def main(method, given, made, ratio, seconds):
    with open(given, encoding="utf-8") as file:
        count = int(file.readline())
        rows = file.read().split("\n")
    vertices = numpy.array([row.split() for row in rows[:count]], dtype=float)
    quads = numpy.array([row.split() for row in rows[count:] if row], dtype=numpy.int64)
    size = float(numpy.abs(vertices).max())
    found, took = {"libigl": libigl, "shapeop": shapeop}[method](vertices / size, quads, float(ratio), float(seconds))
    numpy.savetxt(made, found * size, fmt="%.17g")
    print(took)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
