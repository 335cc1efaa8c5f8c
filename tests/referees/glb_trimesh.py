"""trimesh as a referee: it loads a GLB, and every node that says it is a board or a plank is a closed solid.

    python glb_trimesh.py FILE [--least COUNT]

A node is a solid where its `extras.kind` is `panel` or `plank`. Vertices at the same place are taken as one first: flat
shading needs them several times. Prints one line of JSON with the counts; exit code 1 if a solid is open, has turned
faces or no volume, or if there are fewer than asked for.
"""

import argparse
import json
import struct
import sys

import trimesh


KINDS = ("panel", "plank")


def solids(path):
    """The kind and the name of each node that is a solid, read from the file's own JSON."""
    with open(path, "rb") as file:
        magic, version, _ = struct.unpack("<4sII", file.read(12))
        length, chunk = struct.unpack("<I4s", file.read(8))
        if (magic, version, chunk) != (b"glTF", 2, b"JSON"):
            raise SystemExit(f"{path}: not a GLB of version 2")
        document = json.loads(file.read(length))
    nodes = document.get("nodes", [])
    kinds = [((node.get("extras") or {}).get("kind"), node.get("name")) for node in nodes]
    return [(kind, name) for kind, name in kinds if kind in KINDS]


def fault(mesh):
    """What is wrong with a mesh that should be a solid; None if nothing is."""
    if not mesh.is_watertight:
        return "not watertight"
    if not mesh.is_winding_consistent:
        return "faces turned against each other"
    if not mesh.volume > 0:
        return f"volume {mesh.volume}"
    return None


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("file")
    arguments.add_argument("--least", type=int, default=1)
    arguments = arguments.parse_args()

    scene = trimesh.load_scene(arguments.file)
    found = solids(arguments.file)
    names = [name for _, name in found]
    faults = []
    if len(names) < arguments.least:
        faults.append(f"{len(names)} solids, not {arguments.least}")
    if len(set(names)) != len(names) or None in names:
        faults.append("nodes without a name of their own")
    volume = 0.0
    for name in names:
        if name not in scene.graph.nodes_geometry:
            faults.append(f"{name}: no mesh")
            continue
        transform, geometry = scene.graph[name]
        mesh = scene.geometry[geometry].copy().apply_transform(transform)
        mesh.merge_vertices(merge_tex=True, merge_norm=True)
        wrong = fault(mesh)
        if wrong:
            faults.append(f"{name}: {wrong}")
        volume += float(mesh.volume)
    counts = {"file": arguments.file, "meshes": len(scene.geometry), "volume": volume}
    counts.update({kind: sum(1 for other, _ in found if other == kind) for kind in KINDS})
    print(json.dumps(counts))
    for text in faults:
        print(f"{arguments.file}: {text}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
