"""Draws a model.glb as a small PNG: `python draw.py MODEL.glb PICTURE.png [AZIMUTH ELEVATION [NAMES]] [NAME=COLOUR]...`.

Parallel projection, one light; faces with the model's own colours and edges, boards with the outlines of their faces;
what is hidden is left out by a depth buffer.
AZIMUTH and ELEVATION are degrees; NAMES keeps only nodes whose name matches it (a regular expression); NAME=COLOUR, with
another, paints nodes (`roof=#c8502a`), NAME=none leaves them out. Needs numpy and Pillow (PyPI).
"""

import json
import math
import re
import struct
import sys

import numpy
from PIL import Image, ImageColor

WIDTH, HEIGHT, MARGIN, FINER = 900, 560, 20, 3
INK = (0.13, 0.14, 0.16)
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


def placed(document, names, paints):
    """Every mesh that is drawn, with where it is moved to and what it is painted with."""
    def walk(index, moved, paint):
        node = document["nodes"][index]
        name = node.get("name", "")
        moved = moved + numpy.array(node.get("translation", [0, 0, 0]))
        for pattern, colour in paints:
            paint = colour if re.search(pattern, name) else paint
        if "mesh" in node and re.search(names, name) and paint != "none":
            yield document["meshes"][node["mesh"]], moved, paint
        for child in node.get("children", []):
            yield from walk(child, moved, paint)

    for root in document["scenes"][document.get("scene", 0)]["nodes"]:
        yield from walk(root, numpy.zeros(3), None)


def shapes(path, names, paints):
    """Faces, segments and points in the model's space: arrays of corners by their count, of colours, and of the numbers
    of solids, 0 for what brings its own edges."""
    document, accessor = read(path)
    found = {3: [], 2: [], 1: []}
    for number, (mesh, moved, paint) in enumerate(placed(document, names, paints), 1):
        lined = any(primitive.get("mode", 4) != 4 for primitive in mesh["primitives"])
        for primitive in mesh["primitives"]:
            points = accessor(primitive["attributes"]["POSITION"]) + moved
            order = accessor(primitive["indices"])[:, 0].astype(int) if "indices" in primitive else numpy.arange(len(points))
            material = document["materials"][primitive["material"]] if "material" in primitive else {}
            base = material.get("pbrMetallicRoughness", {}).get("baseColorFactor", [0.6, 0.6, 0.6, 1])[:3]
            colours = numpy.tile(base, (len(points), 1))
            if "COLOR_0" in primitive["attributes"]:
                colours = colours * accessor(primitive["attributes"]["COLOR_0"])[:, :3]
            colours = numpy.sqrt(colours)
            mode = primitive.get("mode", 4)
            if mode == 3:
                order, mode = numpy.column_stack([order[:-1], order[1:]]).ravel(), 1
            corners = {4: 3, 1: 2, 0: 1}[mode]
            faces = any(other.get("mode", 4) == 4 for other in mesh["primitives"])
            if paint and (corners == 3 or not faces):
                colours[:] = numpy.array(ImageColor.getrgb(paint)) / 255
            elif corners < 3:
                colours[:] = INK
            order = order.reshape(-1, corners)
            solid = numpy.full(len(order), 0 if lined else number)
            found[corners].append((points[order], colours[order[:, 0]], solid))
    return {
        corners: tuple(numpy.concatenate(part) for part in zip(*parts)) for corners, parts in found.items() if parts
    }


class Picture:
    """Pixels with their depths: x to the right, y down, greater depths nearer the eye."""

    def __init__(self, width, height):
        self.colours = numpy.ones((height, width, 3))
        self.depths = numpy.full((height, width), -numpy.inf)
        self.sides = numpy.zeros((height, width), int)

    def face(self, corners, colour, side):
        """A triangle of three (x, y, depth), of a side of a solid or of none: 0."""
        height, width = self.depths.shape
        (left, top), (right, bottom) = corners[:, :2].min(axis=0), corners[:, :2].max(axis=0)
        left, top = max(math.floor(left), 0), max(math.floor(top), 0)
        right, bottom = min(math.ceil(right), width - 1), min(math.ceil(bottom), height - 1)
        a, ab, ac = corners[0], corners[1] - corners[0], corners[2] - corners[0]
        area = ab[0] * ac[1] - ab[1] * ac[0]
        if abs(area) < 1e-9 or left > right or top > bottom:
            return
        x = numpy.arange(left, right + 1) - a[0]
        y = (numpy.arange(top, bottom + 1) - a[1])[:, None]
        b = (x * ac[1] - y * ac[0]) / area
        c = (y * ab[0] - x * ab[1]) / area
        depth = a[2] + b * ab[2] + c * ac[2]
        window = numpy.s_[top : bottom + 1, left : right + 1]
        seen = (b >= -1e-9) & (c >= -1e-9) & (b + c <= 1 + 1e-9) & (depth > self.depths[window])
        self.depths[window][seen] = depth[seen]
        self.colours[window][seen] = colour
        self.sides[window][seen] = side

    def outlines(self, thick):
        """Draws where one side ends and another begins, that many pixels thick."""
        edge = numpy.zeros(self.sides.shape, bool)
        for axis in (0, 1):
            for step in range(1, thick + 1):
                edge |= self.sides != numpy.roll(self.sides, step, axis)
        self.colours[edge] = INK

    def dots(self, spots, colours, radius, reach):
        """Round dots at (x, y, depth), where nothing is nearer than by `reach`."""
        height, width = self.depths.shape
        size = math.ceil(radius)
        for dx in range(-size, size + 1):
            for dy in range(-size, size + 1):
                if dx * dx + dy * dy > radius * radius:
                    continue
                x, y = numpy.rint(spots[:, 0]).astype(int) + dx, numpy.rint(spots[:, 1]).astype(int) + dy
                inside = (x >= 0) & (y >= 0) & (x < width) & (y < height)
                x, y, depth, colour = x[inside], y[inside], spots[inside, 2], colours[inside]
                seen = depth + reach >= self.depths[y, x]
                self.colours[y[seen], x[seen]] = colour[seen]


def samples(segments, colours):
    """Points along segments, less than a pixel apart."""
    from_, along = segments[:, 0], segments[:, 1] - segments[:, 0]
    counts = numpy.ceil(1.5 * numpy.abs(along[:, :2]).max(axis=1)).astype(int) + 1
    owner = numpy.repeat(numpy.arange(len(segments)), counts)
    step = numpy.arange(len(owner)) - numpy.repeat(numpy.cumsum(counts) - counts, counts)
    part = step / numpy.maximum(counts[owner] - 1, 1)
    return from_[owner] + part[:, None] * along[owner], colours[owner]


def arguments():
    """The model, the picture, the two angles, names and paints."""
    paints = [argument.split("=", 1) for argument in sys.argv[3:] if "=" in argument]
    plain = [argument for argument in sys.argv[1:] if "=" not in argument]
    if len(plain) not in (2, 4, 5):
        sys.exit(__doc__)
    azimuth, elevation = map(math.radians, map(float, plain[2:4] or ["35", "25"]))
    return plain[0], plain[1], azimuth, elevation, plain[4] if len(plain) == 5 else "", paints


def main():
    model, target, azimuth, elevation, names, paints = arguments()
    # glTF is Y up; right, up and toward the eye.
    toward = numpy.array([
        math.sin(azimuth) * math.cos(elevation), math.sin(elevation), math.cos(azimuth) * math.cos(elevation)
    ])
    right = numpy.array([math.cos(azimuth), 0.0, -math.sin(azimuth)])
    up = numpy.cross(toward, right)
    light = toward + 0.6 * up - 0.5 * right
    light /= numpy.linalg.norm(light)

    found = shapes(model, names, paints)
    view = numpy.column_stack([right, -up, toward])
    seen = {corners: points @ view for corners, (points, _, _) in found.items()}
    everything = numpy.concatenate([points.reshape(-1, 3) for points in seen.values()])
    low, high = everything.min(axis=0), everything.max(axis=0)
    span = numpy.maximum(high - low, 1e-9)
    scale = min((WIDTH - 2 * MARGIN) / span[0], (HEIGHT - 2 * MARGIN) / span[1]) * FINER
    width, height = (FINER * (math.ceil(side * scale / FINER) + 2 * MARGIN) for side in span[:2])
    picture = Picture(width, height)
    for points in seen.values():
        points[:] = (points - low) * scale
        points[..., :2] += MARGIN * FINER

    if 3 in found:
        points, colours, solids = found[3]
        normals = numpy.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0])
        normals /= numpy.maximum(numpy.linalg.norm(normals, axis=1), 1e-30)[:, None]
        shine = numpy.abs(normals @ light)
        colours = numpy.clip(colours * (0.5 + 0.55 * shine)[:, None], 0, 1)
        directions = numpy.rint(12 * normals).astype(int) @ [1, 1000, 1000000]
        sides = numpy.unique(numpy.column_stack([solids, directions]), axis=0, return_inverse=True)[1].ravel() + 1
        for corners, colour, side in zip(seen[3], colours, numpy.where(solids > 0, sides, 0)):
            picture.face(corners, colour, side)
        picture.outlines(1)
    reach = 1.5 * FINER
    if 2 in found:
        spots, colours = samples(seen[2], found[2][1])
        picture.dots(spots, colours, 0.45 * FINER, reach)
    if 1 in found:
        picture.dots(seen[1][:, 0], found[1][1], 1.5 * FINER, reach)

    image = Image.fromarray((255 * picture.colours + 0.5).astype(numpy.uint8))
    image = image.resize((width // FINER, height // FINER), Image.LANCZOS)
    image.quantize(64, dither=Image.Dither.NONE).save(target, optimize=True)


main()
