"""trimesh as a referee of meshes that designs import: what a design draws is what trimesh reads, moved as the design says.

    python imported.py make FOLDER         writes joint.glb and other files of the kinds that trimesh writes
    python imported.py compare FILE BUILT  compares a file with the model of the design in tests/tests/all/imported.rs

Vertices at one place are taken as one. Compared are the number of triangles and of bodies, volume, area, centre and
bounds of the whole, and whether it is closed where the file is.
"""

import json
import sys

import numpy
import trimesh


def joint():
    """A plate with a pin through it, and the pin mirrored at the other end."""
    plate = trimesh.creation.box(extents=[0.4, 0.02, 0.125])
    pin = trimesh.creation.cylinder(radius=0.015625, height=0.25, sections=12)
    scene = trimesh.Scene()
    scene.add_geometry(plate, geom_name="plate", node_name="plate")
    turned = trimesh.transformations.rotation_matrix(numpy.pi / 2, [1, 0, 0])
    turned[:3, 3] = [0.125, 0.0625, 0]
    scene.add_geometry(pin, geom_name="pin", node_name="pin", transform=turned)
    mirrored = numpy.diag([-1.0, 1, 1, 1]) @ turned
    scene.add_geometry(pin, geom_name="pin", node_name="mirrored", transform=mirrored)
    return scene


def nested():
    """Nodes in nodes, skewed and scaled unevenly, one mesh in two of them."""
    scene = trimesh.Scene()
    ball = trimesh.creation.icosphere(subdivisions=2, radius=0.3)
    first = trimesh.transformations.compose_matrix(
        scale=[1, 2, 0.5], shear=[0.1, 0, 0.2], angles=[0.3, 0.2, 0.1], translate=[1, 2, 3]
    )
    scene.add_geometry(ball, geom_name="ball", node_name="outer", transform=first)
    second = trimesh.transformations.compose_matrix(angles=[1, 2, 3], translate=[0.5, -1, 2], scale=[-1, -1, -1])
    scene.add_geometry(ball, geom_name="ball", node_name="inner", parent_node_name="outer", transform=second)
    return scene


def parted():
    """A box with six separate sides, as files with normals have, and an open ring beside it."""
    box = trimesh.creation.box(extents=[0.2, 0.3, 0.4])
    box.unmerge_vertices()
    ring = trimesh.creation.annulus(r_min=0.1, r_max=0.2, height=0.05, sections=20)
    ring.apply_translation([1, 0, 0])
    ring.update_faces(numpy.arange(len(ring.faces)) > 3)
    scene = trimesh.Scene()
    scene.add_geometry(box, geom_name="box", node_name="box")
    scene.add_geometry(ring, geom_name="ring", node_name="ring")
    return scene


MADE = {"joint": joint, "nested": nested, "parted": parted}


def maps():
    """The maps of the design at level 1, in metres, y upwards."""
    turn = trimesh.transformations.rotation_matrix
    move = trimesh.transformations.translation_matrix
    z, x = [0, 0, 1], [1, 0, 0]
    first = move([1, 2, 3]) @ turn(numpy.radians(30), z) @ turn(numpy.radians(-50), x) @ numpy.diag([0.5, 0.5, 0.5, 1])
    second = move([-2, 0, 1]) @ numpy.diag([0.7, 0.2, 0.4, 1])
    upright = turn(numpy.radians(-90), x)
    return [upright @ matrix @ upright.T for matrix in (first, second)]


def whole(scene):
    """All triangles of a scene as one mesh whose vertices at one place are one."""
    mesh = scene.to_mesh()
    mesh = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)
    mesh.merge_vertices(merge_tex=True, merge_norm=True, digits_vertex=5)
    return mesh


def measures(mesh):
    return {
        "triangles": len(mesh.faces),
        "closed": bool(mesh.is_watertight),
        "volume": float(mesh.volume),
        "area": float(mesh.area),
        "centre": mesh.triangles_center.T @ mesh.area_faces / mesh.area,
        "bounds": mesh.bounds,
    }


def compare(file, built):
    source = trimesh.load_scene(file).to_mesh()
    copies = []
    for matrix in maps():
        copy = source.copy()
        copy.apply_transform(matrix)
        copies.append(copy)
    wanted = measures(whole(trimesh.Scene(copies)))
    model = trimesh.load_scene(built)
    for name in [name for name, part in model.geometry.items() if not isinstance(part, trimesh.Trimesh)]:
        model.delete_geometry(name)
    found = measures(whole(model))
    faults = []
    for name, value in wanted.items():
        if not numpy.allclose(found[name], value, rtol=2e-6, atol=2e-6):
            faults.append(f"{name}: {found[name]} and not {value}")
    print(json.dumps({"triangles": found["triangles"], "closed": found["closed"], "volume": found["volume"]}))
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


def make(folder):
    for name, scene in MADE.items():
        with open(f"{folder}/{name}.glb", "wb") as file:
            file.write(scene().export(file_type="glb"))
    print(json.dumps({"files": sorted(MADE)}))
    return 0


sys.exit(make(sys.argv[2]) if sys.argv[1] == "make" else compare(sys.argv[2], sys.argv[3]))
