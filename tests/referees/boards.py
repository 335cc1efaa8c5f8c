"""trimesh and scipy as referees of boards that meet: `python boards.py DIR`.

The solids of model.glb, as trimesh loads them, against report.json:

- the volume of each times the density that all share is its mass, and trimesh's centre of mass is where the report says;
- flat boards with bevelled edges lie against their neighbours: the largest ball that fits into both (a linear program) has
  no size.

Prints one line of JSON with the counts; exit code 1 with the faults on stderr.
"""

import json
import os
import struct
import sys

import numpy
import trimesh
from scipy.optimize import linprog

FLAT_DEG, SINGLE = 1e-3, 0.02
MOST_PAIRS = 60
faults = []


def node_names(path):
    """The name of the node of each board and plank, by its address: names of nodes are made unique, addresses are not."""
    with open(path, "rb") as file:
        length = struct.unpack("<12xI4x", file.read(20))[0]
        nodes = json.loads(file.read(length))["nodes"]
    solid = [node for node in nodes if (node.get("extras") or {}).get("kind") in ("panel", "plank")]
    return {node["extras"]["address"]: node["name"] for node in solid}


def load(root):
    scene = trimesh.load_scene(os.path.join(root, "model.glb"))
    with open(os.path.join(root, "report.json"), encoding="utf-8") as file:
        report = json.load(file)
    parts = [part for made in report["fabrications"] for part in made["parts"] if part["status"] == "made"]
    names = node_names(os.path.join(root, "model.glb"))
    solids = {}
    for part in parts:
        transform, geometry = scene.graph[names[part["address"]]]
        mesh = scene.geometry[geometry].copy().apply_transform(transform)
        mesh.merge_vertices(merge_tex=True, merge_norm=True)
        # glTF is in metres with Y up; designs are in millimetres with Z up.
        mesh.vertices = mesh.vertices[:, [0, 2, 1]] * numpy.array([1000.0, -1000.0, 1000.0])
        solids[part["address"]] = mesh
    return parts, solids


def check_masses(parts, solids):
    heavy = [part for part in parts if (part["mass_kg"] or 0) >= 0.2]
    if heavy:
        densities = numpy.array([part["mass_kg"] / solids[part["address"]].volume for part in heavy])
        spread = (densities.max() - densities.min()) / densities.max()
        # Masses are whole grams, and the solid of a bent board follows its fold.
        bent = max(part["fold_deg"] or 0.0 for part in heavy)
        if spread > 6e-3 + numpy.radians(bent) * 0.1:
            faults.append(f"densities from {densities.min() * 1e9} to {densities.max() * 1e9} kg/m³")
    for part in parts:
        off = numpy.linalg.norm(solids[part["address"]].center_mass - part["centre_mm"])
        if off > 0.05:
            faults.append(f"{part['address']}: its centre of mass is {off} mm off")


def common_ball(first, second):
    """The radius of the largest ball in both convex solids."""
    normals, limits = [], []
    for solid in (first, second):
        points = solid.triangles[:, 0]
        normals.append(solid.face_normals)
        limits.append((solid.face_normals * points).sum(axis=1))
    normals, limits = numpy.concatenate(normals), numpy.concatenate(limits)
    origin = first.vertices.mean(axis=0)
    limits = limits - normals @ origin
    rows = numpy.column_stack([normals, numpy.ones(len(normals))])
    found = linprog([0, 0, 0, -1], A_ub=rows, b_ub=limits, bounds=[(None, None)] * 4, method="highs")
    return found.x[3] if found.status == 0 else 0.0


def is_flat(part):
    return part["edge_cut"] is not None and part["fold_deg"] < FLAT_DEG


def check_neighbours(parts, solids):
    by_address = {part["address"]: part for part in parts}
    pairs = [
        (part, by_address[other])
        for part in parts
        for other in part["neighbours"]
        if part["edge_cut"] == "bevelled" and other and part["address"] < other
        and is_flat(part) and is_flat(by_address[other])
    ]
    chosen = pairs[:: max(1, len(pairs) // MOST_PAIRS)]
    for first, second in chosen:
        radius = common_ball(solids[first["address"]], solids[second["address"]])
        if radius > SINGLE:
            faults.append(f"{first['address']} and {second['address']} share a ball of {radius} mm")
    return len(chosen)


def main(root):
    parts, solids = load(root)
    check_masses(parts, solids)
    pairs = check_neighbours(parts, solids)
    print(json.dumps({"folder": root, "parts": len(parts), "pairs": pairs, "faults": len(faults)}))
    for fault in faults[:20]:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python boards.py DIR")
    sys.exit(main(sys.argv[1]))
