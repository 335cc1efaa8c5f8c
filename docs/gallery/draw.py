"""Draws a model.glb as a small PNG: `python draw.py MODEL.glb PICTURE.png [AZIMUTH ELEVATION [NAMES]]`.

Parallel projection, painter's order, one light; faces with the model's own colours and edges. AZIMUTH and ELEVATION are
degrees; NAMES keeps only nodes whose name matches it (a regular expression). Needs numpy and Pillow (PyPI).
"""

import json
import math
import re
import struct
import sys

import numpy
from PIL import Image, ImageDraw

WIDTH, HEIGHT, MARGIN, FINER = 900, 560, 20, 3
TYPES = {5121: numpy.uint8, 5123: numpy.uint16, 5125: numpy.uint32, 5126: numpy.float32}
SIZES = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


def read(path):
    """The JSON of a GLB and its accessors as arrays."""
    data = open(path, "rb").read()
    (length,) = struct.unpack_from("<I", data, 12)
    document = json.loads(data[20 : 20 + length])
    binary = data[20 + length + 8 :]

    def accessor(index):
        found = document["accessors"][index]
        view = document["bufferViews"][found["bufferView"]]
        start = view.get("byteOffset", 0) + found.get("byteOffset", 0)
        kind, width = numpy.dtype(TYPES[found["componentType"]]), SIZES[found["type"]]
        step = view.get("byteStride") or kind.itemsize * width
        rows = numpy.ndarray((found["count"], width), kind, binary, start, (step, kind.itemsize))
        return rows.astype(float) / (numpy.iinfo(kind).max if found.get("normalized") else 1)

    return document, accessor


def placed(document, names):
    """Every mesh that is drawn, with where it is moved to."""
    def walk(index, moved):
        node = document["nodes"][index]
        moved = moved + numpy.array(node.get("translation", [0, 0, 0]))
        if "mesh" in node and re.search(names, node.get("name", "")):
            yield document["meshes"][node["mesh"]], moved
        for child in node.get("children", []):
            yield from walk(child, moved)

    for root in document["scenes"][document.get("scene", 0)]["nodes"]:
        yield from walk(root, numpy.zeros(3))


def shapes(path, names):
    """Triangles, segments and points in the model's space, with their colours."""
    document, accessor = read(path)
    for mesh, moved in placed(document, names):
        for primitive in mesh["primitives"]:
            points = accessor(primitive["attributes"]["POSITION"]) + moved
            order = accessor(primitive["indices"])[:, 0].astype(int) if "indices" in primitive else numpy.arange(len(points))
            material = document["materials"][primitive["material"]] if "material" in primitive else {}
            base = material.get("pbrMetallicRoughness", {}).get("baseColorFactor", [0.6, 0.6, 0.6, 1])[:3]
            colours = numpy.tile(base, (len(points), 1))
            if "COLOR_0" in primitive["attributes"]:
                colours = colours * accessor(primitive["attributes"]["COLOR_0"])[:, :3]
            mode = primitive.get("mode", 4)
            if mode == 3:
                order, mode = numpy.column_stack([order[:-1], order[1:]]).ravel(), 1
            corners = {4: 3, 1: 2, 0: 1}[mode]
            for element in order.reshape(-1, corners):
                yield points[element], colours[element[0]]


def main():
    if len(sys.argv) not in (3, 5, 6):
        sys.exit(__doc__)
    azimuth, elevation = map(math.radians, map(float, sys.argv[3:5] or ["35", "25"]))
    names = sys.argv[5] if len(sys.argv) == 6 else ""
    # glTF is Y up; right, up and toward the eye.
    toward = numpy.array([
        math.sin(azimuth) * math.cos(elevation), math.sin(elevation), math.cos(azimuth) * math.cos(elevation)
    ])
    right = numpy.cross([0.0, 1.0, 0.0], toward)
    right /= numpy.linalg.norm(right)
    up = numpy.cross(toward, right)
    light = toward + 0.6 * up - 0.5 * right
    light /= numpy.linalg.norm(light)

    drawn = []
    for points, colour in shapes(sys.argv[1], names):
        flat = points @ numpy.column_stack([right, up])
        depth = float((points @ toward).mean())
        if len(points) == 3:
            normal = numpy.cross(points[1] - points[0], points[2] - points[0])
            length = numpy.linalg.norm(normal)
            shine = abs(normal @ light) / length if length > 0 else 1.0
            colour = numpy.clip(numpy.sqrt(colour) * (0.55 + 0.5 * shine), 0, 1)
        drawn.append((depth, len(points), flat, colour))
    everything = numpy.vstack([flat for _, _, flat, _ in drawn])
    low, high = everything.min(axis=0), everything.max(axis=0)
    span = numpy.maximum(high - low, 1e-9)
    scale = min((WIDTH - 2 * MARGIN) / span[0], (HEIGHT - 2 * MARGIN) / span[1]) * FINER
    size = [int(math.ceil(side * scale)) + 2 * MARGIN * FINER for side in span]
    picture = Image.new("RGB", size, "white")
    pen = ImageDraw.Draw(picture)
    # Edges lie on faces: a little nearer the eye they are drawn after them.
    reach = float(numpy.linalg.norm(span)) * 0.004
    for _, corners, flat, colour in sorted(drawn, key=lambda it: it[0] + (reach if it[1] < 3 else 0)):
        spots = [(MARGIN * FINER + (x - low[0]) * scale, MARGIN * FINER + (high[1] - y) * scale) for x, y in flat]
        ink = tuple(int(round(255 * part)) for part in colour)
        if corners == 3:
            pen.polygon(spots, fill=ink)
        elif corners == 2:
            pen.line(spots, fill=ink, width=FINER)
        else:
            (x, y), dot = spots[0], 1.5 * FINER
            pen.ellipse([x - dot, y - dot, x + dot, y + dot], fill=ink)
    picture = picture.resize((size[0] // FINER, size[1] // FINER), Image.LANCZOS)
    picture.quantize(96, dither=Image.Dither.NONE).save(sys.argv[2], optimize=True)


main()
