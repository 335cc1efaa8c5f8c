"""numpy and shapely as referees of the figures a build reports: `python figures.py DIR`.

Everything is worked out again from model.glb (single precision, so to a few thousandths of a millimetre) and from the
other files of the folder:

- the curves give the planks' lengths, faces and mitres; the surfaces give edges, areas, diagonals, folds and planarity;
- the solids have the volumes that the sizes say, and masses in one proportion to them;
- the bevels are half the angle between the triangles at each edge, and the offsets of both faces follow from them; the cut
  outline is what lies inside of every moved edge; the solids of planks give their end cuts, compound ones too;
- the relief of corners is worked out again from planes in space;
- a board's outline built from its four edges and its diagonal by the law of cosines is a simple polygon of the area and
  the size that are stated; boards that share an edge state the same length and the same bevel for it;
- report.json has, digit by digit, the figures of cutlist.csv, and its summaries are those of planarity.csv;
- what a requirement says it measured, the least and the largest and how many, is measured again on these.

Prints one line of JSON with the counts; exit code 1 with the faults on stderr.
"""

import csv
import json
import os
import struct
import sys

import numpy
from shapely import Polygon

MM, DEGREES, PLANARITY = 3e-3, 2e-3, 1e-6
faults = []


def expect(condition, text):
    if not condition:
        faults.append(text)


def near(name, stated, found, tolerance):
    expect(abs(float(stated) - found) <= tolerance, f"{name}: {stated} stated, {found} found")


class Model:
    """A GLB: its nodes by the kind in their extras, with positions in millimetres."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        length = struct.unpack_from("<I", data, 12)[0]
        self.document = json.loads(data[20 : 20 + length])
        self.binary = data[20 + length + 8 :]

    def of_kind(self, *kinds):
        for node in self.document["nodes"]:
            extras = node.get("extras") or {}
            if extras.get("kind") in kinds:
                yield extras, self.document["meshes"][node["mesh"]]["primitives"]

    def array(self, index, kind, width):
        accessor = self.document["accessors"][index]
        view = self.document["bufferViews"][accessor["bufferView"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        count = accessor["count"] * width
        return numpy.frombuffer(self.binary, dtype=kind, count=count, offset=start).reshape(-1, width)

    def positions(self, primitive):
        return self.array(primitive["attributes"]["POSITION"], "<f4", 3).astype(float) * 1000.0

    def volume(self, primitive):
        """Of a closed solid, mm³."""
        kinds = {5121: "u1", 5123: "<u2", 5125: "<u4"}
        kind = kinds[self.document["accessors"][primitive["indices"]]["componentType"]]
        points = self.positions(primitive)
        corners = points[self.array(primitive["indices"], kind, 1).reshape(-1, 3)] - points[0]
        return float(numpy.einsum("ij,ij->i", corners[:, 0], numpy.cross(corners[:, 1], corners[:, 2])).sum() / 6)


def unit(vectors):
    return vectors / numpy.linalg.norm(vectors, axis=-1, keepdims=True)


def angle(first, second):
    sine = numpy.linalg.norm(numpy.cross(first, second), axis=-1)
    return numpy.degrees(numpy.arctan2(sine, (first * second).sum(axis=-1)))


def measure(quads, stated):
    """Edges, area, fold, planarity, diagonal and diagonal ratio of quads, n × 4 × 3, split where they fold less; a quad
    that folds as much over both diagonals, to single precision, is split along the one whose length is nearest to what is stated."""
    edges = numpy.roll(quads, -1, axis=1) - quads
    lengths = numpy.linalg.norm(edges, axis=-1)
    corner = numpy.cross(numpy.roll(edges, 1, axis=1), edges)
    normals = unit(corner)
    folds = numpy.stack([angle(normals[:, 1], normals[:, 3]), angle(normals[:, 0], normals[:, 2])], axis=1)
    cosines = numpy.stack(
        [(normals[:, 1] * normals[:, 3]).sum(-1), (normals[:, 0] * normals[:, 2]).sum(-1)], axis=1
    )
    halves = numpy.linalg.norm(corner, axis=-1) / 2
    areas = numpy.stack([halves[:, 1] + halves[:, 3], halves[:, 0] + halves[:, 2]], axis=1)
    rows = numpy.arange(len(quads))
    across = numpy.stack([quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1]], axis=1)
    diagonals = numpy.linalg.norm(across, axis=-1)
    nearest = numpy.abs(diagonals - stated[:, None]).argmin(axis=1)
    split = numpy.where(numpy.abs(folds[:, 0] - folds[:, 1]) < DEGREES, nearest, folds.argmin(axis=1))
    gap = ((quads[:, 1] - quads[:, 0]) * unit(numpy.cross(across[:, 0], across[:, 1]))).sum(-1)
    return {
        "edges": lengths,
        "area": areas[rows, split],
        "fold": folds[rows, split],
        "planarity": cosines.min(axis=1),
        "diagonal": diagonals[rows, split],
        "ratio": numpy.abs(gap) / diagonals.mean(axis=1),
        "split": split,
    }


def outline(edges, diagonal, split, grain):
    """A board's outline from its lengths, with the side the grain runs along on the x axis."""
    # The triangle over the diagonal that begins at the split's first corner, then the other one on its far side.
    a, b, c, d = edges if split == 0 else edges[1:] + edges[:1]
    cosine = lambda p, q, r: (p * p + q * q - r * r) / (2 * p * q)
    first, second = numpy.arccos(cosine(a, diagonal, b)), numpy.arccos(cosine(d, diagonal, c))
    turn = lambda length, by: length * numpy.array([numpy.cos(by), numpy.sin(by)])
    points = [turn(0, 0), turn(a, 0), turn(diagonal, first), turn(d, first + second)]
    points = points if split == 0 else points[-1:] + points[:-1]
    start = {"u": 0, "v": 1}.get(grain, int(numpy.argmax(edges)))
    along = unit(points[(start + 1) % 4] - points[start])
    return Polygon([(p @ along, along[0] * p[1] - along[1] * p[0]) for p in points])


def check_panels(model, parts, rows, planarity):
    surfaces = {kind: [model.positions(p[0]).reshape(-1, 4, 3) for _, p in model.of_kind(kind)]
                for kind in ("designed", "planarized")}
    stated = numpy.array([float(row["diagonal_mm"]) for row in rows])
    before, after = (measure(numpy.concatenate(surfaces[kind]), stated) for kind in ("designed", "planarized"))
    expect(len(planarity) == len(after["area"]) == len(parts), "not one quad, one row and one board each")
    by_address = {part["address"]: part for part in parts}
    measured = {name: [] for name in PANEL_MEASURES}
    bevels = measure_bevels(numpy.concatenate(surfaces["planarized"]), after["split"], parts)
    for index, (part, row, flat) in enumerate(zip(parts, rows, planarity)):
        name = row["address"]
        expect(name == flat["address"], f"{name}: {flat['address']} in planarity.csv")
        edges = [float(row[f"edge_{side}_mm"]) for side in range(4)]
        for side in range(4):
            near(f"{name} edge {side}", edges[side], after["edges"][index][side], MM)
        near(f"{name} area", row["area_m2"], after["area"][index] * 1e-6, 5e-6)
        near(f"{name} diagonal", row["diagonal_mm"], after["diagonal"][index], MM)
        near(f"{name} fold", row["fold_deg"], after["fold"][index], DEGREES)
        near(f"{name} planarity", row["planarity"], after["planarity"][index], PLANARITY)
        for when, found in (("before", before), ("after", after)):
            near(f"{name} planarity {when}", flat[f"planarity_{when}"], found["planarity"][index], PLANARITY)
            near(f"{name} fold {when}", flat[f"fold_{when}_deg"], found["fold"][index], DEGREES)
            near(f"{name} area {when}", flat[f"area_{when}_m2"], found["area"][index] * 1e-6, 5e-6)
            near(f"{name} ratio {when}", flat[f"diagonal_ratio_{when}"], found["ratio"][index], 2e-5)
        polygon = outline(edges, float(row["diagonal_mm"]), after["split"][index], row["grain"])
        expect(polygon.is_valid and polygon.is_simple, f"{name}: its outline is no simple polygon")
        near(f"{name} area of the outline", row["area_m2"], polygon.area * 1e-6, 3e-6)
        cut = moved_out(polygon, part, name)
        left, low, right, high = cut.bounds
        near(f"{name} length", row["length_mm"], right - left, 5e-3)
        near(f"{name} width", row["width_mm"], high - low, 5e-3)
        check_neighbours(part, by_address)
        corners = numpy.array(polygon.exterior.coords)[:-1]
        fold = numpy.radians(after["fold"][index])
        values = {
            "planarity": [after["planarity"][index]],
            "fold": [after["fold"][index]],
            "diagonal ratio": [after["ratio"][index]],
            "edge": after["edges"][index],
            "length": [right - left],
            "width": [least_width(polygon)],
            "area": [polygon.area * 1e-6],
            "angle": angles(corners),
            "bevel": bevels[index],
            # (h1 + h2) / (2 fold), the heights of both triangles being twice their area by the diagonal.
            "bend radius": [after["area"][index] / after["diagonal"][index] / fold] if fold > 1e-4 else [],
            "mass": [float(row["mass_kg"])],
        }
        for key, found in values.items():
            measured[key] += [(name, value) for value in found]
        stated = Polygon([[float(x) for x in corner] for corner in part["outline_mm"]])
        near(f"{name} outline in the report", stated.area * 1e-6, cut.area * 1e-6, 1e-5)
        expect(stated.is_valid and stated.is_simple, f"{name}: its cut outline is no simple polygon")
        near(f"{name} outline in the report from x", 0.0, stated.bounds[0], 1e-3)
    check_bevels(numpy.concatenate(surfaces["planarized"]), after["split"], parts)
    return measured, check_relief(numpy.concatenate(surfaces["planarized"]), parts)


PANEL_MEASURES = (
    "planarity", "fold", "diagonal ratio", "edge", "length", "width", "area", "angle", "bevel", "bend radius", "mass",
)


def least_width(polygon):
    """Over the edges of the convex hull, the farthest corner from the edge's line; the least of these."""
    hull = numpy.array(polygon.convex_hull.exterior.coords)[:-1]
    along = unit(numpy.roll(hull, -1, axis=0) - hull)
    normals = numpy.stack([-along[:, 1], along[:, 0]], axis=1)
    heights = numpy.abs(((hull[None, :, :] - hull[:, None, :]) * normals[:, None, :]).sum(-1))
    return heights.max(axis=1).min()


def angles(corners):
    """Inside of a convex outline, degrees."""
    out = unit(numpy.roll(corners, -1, axis=0) - corners)
    back = unit(numpy.roll(corners, 1, axis=0) - corners)
    return numpy.degrees(numpy.arccos((out * back).sum(-1)))


def measure_bevels(quads, splits, parts):
    """For each quad, half of the angle between the triangles on both sides of each edge it shares."""
    place = {part["address"]: index for index, part in enumerate(parts)}
    triangles = ([(0, 1, 2), (0, 1, 2), (2, 3, 0), (2, 3, 0)], [(3, 0, 1), (1, 2, 3), (1, 2, 3), (3, 0, 1)])

    def normal(index, side):
        a, b, c = quads[index][list(triangles[splits[index]][side])]
        return unit(numpy.cross(b - a, c - a))

    found = []
    for index, part in enumerate(parts):
        mine = []
        for side, other in enumerate(part["neighbours"]):
            if other is not None:
                back = parts[place[other]]["neighbours"].index(part["address"])
                mine.append(angle(normal(index, side), normal(place[other], back)) / 2)
        found.append(mine)
    return found


def check_requirements(made, measured, elements):
    """The least and the largest of what was measured, and how many there are."""
    tolerances = {"mm": 6e-3, "deg": 6e-3, "m2": 5e-6, "kg": 1e-3, None: 2e-5}
    checked = 0
    for requirement in made["requirements"]:
        name, measure = requirement["text"], requirement["measure"]
        if measure == "count":
            expect({requirement["least"], requirement["most"]} == {str(elements)}, f"{name}: not {elements}")
        if measure not in measured:
            continue
        values = [value for address, value in measured[measure] if address in made["addresses"]]
        # Flat boards are counted where bends are, and have none.
        expect(measure == "bend radius" or int(requirement["total"]) == len(values), f"{name}: not {len(values)}")
        checked += 1
        if measure == "bend radius":
            # Curvatures: single precision knows a fold to some thousandths of a degree, and 0 from a little.
            curvature = lambda radius: 0.0 if radius is None else 1.0 / float(radius)
            for key, value in (("least", min(values, default=None)), ("most", max(values, default=None))):
                found = curvature(value)
                near(f"{name} {key}", curvature(requirement[key]), found, 5e-3 * found + 2e-6)
            continue
        for key, value in (("least", min(values)), ("most", max(values))):
            near(f"{name} {key}", requirement[key], value, tolerances[requirement["unit"]])
    return checked


def moved_out(polygon, part, name):
    """What lies inside of all edges of a convex outline, each moved out by the larger of its two offsets."""
    top, bottom = ([float(x) for x in part[key]] for key in ("top_offsets_mm", "bottom_offsets_mm"))
    thickness, slopes = float(part["thickness_mm"]), [numpy.tan(numpy.radians(float(b or 0))) for b in part["bevels_deg"]]
    share = {"square": 0.0, "bevelled": 1.0, "stepped": 0.5}[part["edge_cut"]]
    corners, left = list(polygon.exterior.coords)[:-1], polygon.buffer(thickness * 50 + 1000.0).envelope
    for side, (x, y) in enumerate(corners):
        near(f"{name} edge {side} offsets", top[side] - bottom[side], share * thickness * slopes[side], 5e-3)
        along = unit(numpy.array(corners[(side + 1) % 4]) - (x, y))
        out = numpy.array([along[1], -along[0]])
        start, far = numpy.array([x, y]) + out * max(top[side], bottom[side]), 1e5
        half = [start - along * far, start + along * far, start + (along - out) * far, start - (along + out) * far]
        left = left.intersection(Polygon(half))
    return left


def check_bevels(quads, split, parts):
    """Half the angle between the normals of the two triangles at each edge; its sign by the side the other one lies on."""
    place = {part["address"]: index for index, part in enumerate(parts)}
    apexes = ((2, 0, 0, 2), (3, 3, 1, 1))

    def triangle(board, side):
        corners = quads[board]
        return corners[side], corners[(side + 1) % 4], corners[apexes[split[board]][side]]

    for board, part in enumerate(parts):
        for side, other in enumerate(part["neighbours"]):
            if other is None:
                continue
            back = int(part["neighbour_edges"][side])
            near_by = parts[place[other]]["neighbours"][back]
            expect(near_by == part["address"], f"{part['address']} edge {side}: {other} has {near_by} across its edge {back}")
            p, q, r = triangle(board, side)
            u, v, w = triangle(place[other], back)
            first, second = (unit(numpy.cross(b - a, c - a)) for a, b, c in ((p, q, r), (u, v, w)))
            sign = -numpy.sign(first @ (w - p))
            found = sign * float(angle(first[None], second[None])[0]) / 2
            near(f"{part['address']} bevel {side}", part["bevels_deg"][side], found, 2 * DEGREES)


def check_relief(quads, parts):
    """Where four flat boards meet, the corner of each is where the plane of its face meets the two planes that halve the
    angles at its edges: worked out in space, compared along the common edges."""
    place = {part["address"]: index for index, part in enumerate(parts)}
    normals = unit(numpy.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1]))
    meeting = {}
    for board, corners in enumerate(numpy.round(quads, 1)):
        for corner in map(tuple, corners):
            meeting.setdefault(corner, []).append(board)
    checked = 0

    def inside(board, corner):
        """From the corner to where the two planes and a face one millimetre above the surface meet."""
        rows = [normals[board]]
        for side in (corner, (corner + 3) % 4):
            other = parts[board]["neighbours"][side]
            edge = unit(quads[board][(side + 1) % 4] - quads[board][side])
            rows.append(numpy.cross(edge, normals[board] + normals[place[other]]))
        return numpy.linalg.solve(numpy.array(rows), [1.0, 0.0, 0.0])

    for board, part in enumerate(parts):
        slopes = [numpy.tan(numpy.radians(float(bevel or 0))) for bevel in part["bevels_deg"]]
        steepest = int(numpy.argmax(numpy.abs(slopes)))
        if part["edge_cut"] != "bevelled" or abs(slopes[steepest]) < 0.02:
            continue
        heights = [float(part[key][steepest]) / slopes[steepest] for key in ("top_offsets_mm", "bottom_offsets_mm")]
        for corner in range(4):
            around = meeting[tuple(numpy.round(quads[board][corner], 1))]
            whole = all(parts[other]["neighbours"].count(None) == 0 for other in around)
            if len(around) < 4 or not whole or any(float(parts[other]["fold_deg"]) > 1e-3 for other in around):
                continue
            beyond = []
            for side in (corner, (corner + 3) % 4):
                other, back = place[part["neighbours"][side]], int(part["neighbour_edges"][side])
                theirs = inside(other, (back + 1) % 4 if side == corner else back)
                far = quads[board][(corner + (1 if side == corner else 3)) % 4]
                along = unit(far - quads[board][corner])
                beyond += [height * float((theirs - inside(board, corner)) @ along) for height in heights]
            near(f"{part['address']} relief {corner}", part["relief_mm"][corner], max(0.0, *beyond), 1e-2)
            near(f"{part['address']} gap {corner}", part["corner_gaps_mm"][corner], max(0.0, -min(beyond)), 1e-2)
            checked += 1
    return checked


def check_neighbours(part, by_address):
    for side, other in enumerate(part["neighbours"]):
        bevel = part["bevels_deg"][side]
        expect((other is None) == (bevel is None), f"{part['address']} side {side}: a bevel on the border, or none inside")
        if other is None:
            continue
        back = [n for n, address in enumerate(by_address[other]["neighbours"]) if address == part["address"]]
        expect(len(back) == 1, f"{part['address']} and {other} are neighbours one way only")
        for key, mine in (("edges_mm", part["edges_mm"][side]), ("bevels_deg", bevel)):
            theirs = [by_address[other][key][n] for n in back]
            expect(theirs == [mine], f"{part['address']} and {other}: {key} {mine} and {theirs}")


def check_ends(name, corners, segment, mitres, bevels, depth):
    """The end cuts of a plank out of the eight corners of its solid; its length on the axis."""
    along = unit(segment)
    centre = corners.mean(axis=0)
    across = (corners - centre) - numpy.outer((corners - centre) @ along, along)
    # The four long edges stand at the corners of the section: the sides that measure the depth are left and right.
    apart = numpy.linalg.norm(across[:, None] - across[None], axis=-1)
    sizes = [pair for pair in numpy.argwhere(numpy.abs(apart - depth) < 0.02)]
    left = unit(across[sizes[0][0]] - across[sizes[0][1]])
    up = numpy.cross(along, left)
    middles = []
    for side, (mitre, bevel) in zip((-1, 1), zip(mitres, bevels)):
        end = corners[numpy.sign((corners - centre) @ along) == side]
        expect(len(end) == 4, f"{name}: {len(end)} corners at an end")
        rows = numpy.column_stack([end @ left, end @ up, numpy.ones(len(end))])
        (y, z, _), *_ = numpy.linalg.lstsq(rows, end @ along, rcond=None)
        found_mitre = abs(numpy.degrees(numpy.arctan(y)))
        found_bevel = abs(numpy.degrees(numpy.arctan(z / numpy.hypot(1.0, y))))
        near(f"{name} mitre of its solid", abs(mitre), found_mitre, 5e-3)
        near(f"{name} bevel of its solid", abs(bevel), found_bevel, 1e-2)
        middles.append((end @ along).mean())
    return middles[1] - middles[0]


def check_planks(model, rows, parts):
    parts = {part["address"]: part for part in parts}
    place = 0
    measured = {"length": [], "mitre": [], "mass": []}
    solids = {
        extras["address"]: numpy.unique(numpy.round(model.positions(primitives[0]), 3), axis=0)
        for extras, primitives in model.of_kind("plank")
    }
    for _, primitives in model.of_kind("curve"):
        points = model.positions(primitives[0])
        segments = numpy.diff(points, axis=0)
        lengths = numpy.linalg.norm(segments, axis=1)
        # A closed curve ends where it begins, and is mitred there too.
        closed = numpy.linalg.norm(points[0] - points[-1]) <= MM
        seam = angle(segments[-1:], segments[:1]) / 2 if closed else numpy.zeros(1)
        mitres = numpy.concatenate([seam, angle(segments[:-1], segments[1:]) / 2, seam])
        planks, place = rows[place : place + len(lengths)], place + len(lengths)
        for index, row in enumerate(planks):
            name = row["address"]
            ends = [float(row["mitre_start_deg"]), float(row["mitre_end_deg"])]
            bevels = [float(row["bevel_start_deg"]), float(row["bevel_end_deg"])]
            length = check_ends(name, solids[name], segments[index], ends, bevels, float(row["width_mm"]))
            near(f"{name} length", row["length_mm"], length, MM)
            # The outer ends of an open curve may be cut to a plane.
            outer = [not closed and index == 0, not closed and index == len(planks) - 1]
            for end, (stated, found) in enumerate(zip(ends, mitres[index : index + 2])):
                if not outer[end]:
                    near(f"{name} mitre", abs(stated), found, DEGREES)
                    expect(bevels[end] == 0.0, f"{name}: a bevel of {bevels[end]} at a joint")
            if not any(outer) or ends + bevels == [0.0] * 4:
                near(f"{name} length", row["length_mm"], lengths[index], MM)
            lean = (numpy.tan(numpy.radians(ends[1])) - numpy.tan(numpy.radians(ends[0]))) * float(row["width_mm"]) / 2
            faces = sorted([float(row["length_mm"]) - lean, float(row["length_mm"]) + lean])
            near(f"{name} inner face", row["inner_length_mm"], faces[0], MM)
            near(f"{name} outer face", row["outer_length_mm"], faces[1], MM)
            near(f"{name} area", row["area_m2"], length * float(row["width_mm"]) * 1e-6, 2e-6)
            measured["length"].append((name, length))
            measured["mass"].append((name, float(row["mass_kg"])))
            joints = [end for end, other in zip((0, 1), parts[name]["neighbours"]) if other is not None]
            measured["mitre"] += [(name, abs(ends[end])) for end in joints]
        for first, second in zip(planks, planks[1:] + planks[: 1 if closed else 0]):
            joint = float(first["mitre_end_deg"]) + float(second["mitre_start_deg"])
            expect(joint == 0, f"{first['address']} and {second['address']}: mitres that are not opposite")
    expect(place == len(rows), f"{place} segments, {len(rows)} planks")
    return measured


def cut_volume(part):
    """Of a board between its two faces, or of its two halves: the mean of the areas, but for the share of the bevels."""
    corners = lambda key: numpy.array([[float(x) for x in corner] for corner in part[key]])
    top, bottom, thickness = corners("top_outline_mm"), corners("bottom_outline_mm"), float(part["thickness_mm"])
    areas = [Polygon(outline).area for outline in (top, (top + bottom) / 2, bottom)]
    weights = {"bevelled": (1 / 6, 4 / 6, 1 / 6), "stepped": (1 / 2, 0, 1 / 2)}[part["edge_cut"]]
    return thickness * sum(area * weight for area, weight in zip(areas, weights))


def check_solids(model, rows, kind, by_address):
    """The volumes of the solids, and one density for all."""
    volumes = {extras["address"]: model.volume(primitives[0]) for extras, primitives in model.of_kind(kind)}
    expect(sorted(volumes) == sorted(row["address"] for row in rows), "solids and rows of other addresses")
    densities = []
    for row in rows:
        # A plank is exact; a board's solid follows its fold, so that its faces differ a little from the flat ones.
        thickness, exact = float(row["thickness_mm"]), kind == "plank"
        volume = float(row["area_m2"]) * 1e6 * thickness
        if kind == "panel" and row["edge_cut"] != "square":
            volume = cut_volume(by_address[row["address"]])
        allowed = volume * (1e-4 if exact else 5e-3)
        near(f"{row['address']} volume", volume, volumes.get(row["address"], 0.0), allowed)
        # Masses are whole grams: those of a model's boards say too little.
        if float(row["mass_kg"]) >= 0.2:
            densities.append(float(row["mass_kg"]) / volume * 1e9)
    if densities:
        spread = (max(densities) - min(densities)) / max(densities)
        expect(spread < 3e-3, f"densities from {min(densities)} to {max(densities)} kg/m³")


def check_report(made, rows, planarity):
    """Digit by digit: the numbers of the report are read as text."""
    parts = made["parts"]
    expect([part["address"] for part in parts] == [row["address"] for row in rows], "parts and rows differ")
    text = lambda value: "" if value is None else value
    for part, row in zip(parts, rows):
        cells = {key: text(part[key]) for key in row if key in part and key != "files"}
        for key, place in (("edges_mm", "edge_{}_mm"), ("bevels_deg", "bevel_{}_deg")):
            cells.update({place.format(side): text(value) for side, value in enumerate(part[key] or [None] * 4)})
        relief = part["relief_mm"] or [None] * 4
        cells.update({f"relief_{corner}_mm": text(value) for corner, value in enumerate(relief)})
        for key, place in (("mitres_deg", "mitre_{}_deg"), ("end_bevels_deg", "bevel_{}_deg")):
            ends = part[key] or [None] * 2
            cells.update({place.format(end): text(value) for end, value in zip(("start", "end"), ends)})
        cells["files"] = "; ".join(part["files"])
        if row["bend_radius_mm"] == "flat":
            cells["bend_radius_mm"] = "flat"
        expect(set(cells) == set(row), f"columns {set(cells) ^ set(row)}")
        other = {key: (cells.get(key), row[key]) for key in row if cells.get(key) != row[key]}
        expect(not other, f"{row['address']}: the report and the cut list differ in {other}")
    counts = made["counts"]
    expect(counts["made"] == str(len(parts)) and counts["refused"] == "0", f"{counts} and {len(parts)} parts")
    near("mass", made["material"]["mass_kg"], sum(float(row["mass_kg"]) for row in rows), 5e-4 * len(rows) + 5e-4)
    for when in ("before", "after") if made["planarity"] else ():
        check_summary(made["planarity"][when], planarity, when)


def check_summary(summary, planarity, when):
    column = lambda name: [row[name.format(when)] for row in planarity]
    for key, name, choose in (
        ("worst_planarity", "planarity_{}", min),
        ("largest_fold_deg", "fold_{}_deg", max),
        ("largest_diagonal_ratio", "diagonal_ratio_{}", max),
    ):
        stated, values = summary[key], column(name)
        expect(stated["value"] == choose(values, key=float), f"{key} {when}: {stated} and {choose(values, key=float)}")
        at = [row["address"] for row, value in zip(planarity, values) if value == stated["value"]]
        expect(stated["address"] in at, f"{key} {when} is said to be at {stated['address']}, not {at}")
    near(f"mean planarity {when}", summary["mean_planarity"], numpy.mean([float(x) for x in column("planarity_{}")]), 2e-9)
    near(f"mean fold {when}", summary["mean_fold_deg"], numpy.mean([float(x) for x in column("fold_{}_deg")]), 1e-4)
    near(f"area {when}", summary["area_m2"], sum(float(x) for x in column("area_{}_m2")), 1e-6 * len(planarity))


def main(root):
    def table(name):
        path = os.path.join(root, name)
        if not os.path.exists(path):
            return []
        with open(path, encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file, strict=True))

    with open(os.path.join(root, "report.json"), encoding="utf-8") as file:
        report = json.load(file, parse_float=str, parse_int=str)
    model, rows, planarity = Model(os.path.join(root, "model.glb")), table("cutlist.csv"), table("planarity.csv")
    made_of = {"panels": "panel", "planks": "plank"}
    kinds = {made["kind"] for made in report["fabrications"]}
    if len(kinds) != 1:
        sys.exit(f"fabrications of one kind, please, not {kinds}")
    kind = kinds.pop()
    parts = [part for made in report["fabrications"] for part in made["parts"]]
    corners = 0
    if kind == "panels":
        measured, corners = check_panels(model, parts, rows, planarity)
    else:
        measured = check_planks(model, rows, parts)
    check_solids(model, rows, made_of[kind], {part["address"]: part for part in parts})
    requirements = 0
    for made in report["fabrications"]:
        addresses = made["addresses"] = {part["address"] for part in made["parts"]}
        requirements += check_requirements(made, measured, len(addresses))
        mine = lambda table: [row for row in table if row["address"] in addresses]
        check_report(made, mine(rows), mine(planarity))
    print(
        json.dumps(
            {
                "folder": root,
                "parts": len(parts),
                "planarity": len(planarity),
                "corners": corners,
                "requirements": requirements,
                "faults": len(faults),
            }
        )
    )
    for fault in faults[:20]:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python figures.py DIR")
    sys.exit(main(sys.argv[1]))
