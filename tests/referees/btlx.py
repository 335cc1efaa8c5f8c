"""compas_timber as referee of timber models: `python btlx.py DIR EXPECTED.json`.

EXPECTED lists models: {"file", "parts": [{"address", "alias", "size": [length, width, height], "origin", "bevels" or
"planes"}]}. Each file must be XML of BTLx 2.0.0 without anything that compas_timber's reader complains of, with the same
parts in the same order: the box of each and where it lies to 1e-3 mm; of a board the inclination of each side to 1e-3
degrees, its contour closed and anticlockwise on the face that lies up, inside the box; of a plank the cutting planes as
compas_timber works them out, by a point to 1e-3 mm and the unit normal to 1e-5; and the alias as text. GUIDs are distinct.
Prints one line of JSON with the counts; exit code 1 with the faults on stderr.
"""

import json
import os
import sys
import warnings
import xml.etree.ElementTree as ET

from compas.geometry import dot_vectors
from compas_timber.btlx.reader import BTLxReader
from compas_timber.fabrication import FreeContour, JackRafterCut, Text

NAMESPACE = "{https://www.design2machine.com}"
LENGTH = 1e-3
DEGREES = 1e-3


def near(found, expected, tolerance):
    return len(found) == len(expected) and all(abs(a - b) <= tolerance for a, b in zip(found, expected))


def structure_faults(path):
    """What compas_timber does not look at."""
    root = ET.parse(path).getroot()
    if root.tag != NAMESPACE + "BTLx" or root.attrib.get("Version") != "2.0.0":
        yield f"the root is {root.tag} {root.attrib}"
    identities = [part.attrib["GUID"] for part in root.iter(NAMESPACE + "Transformation")]
    if len(set(identities)) != len(identities):
        yield "two parts have one GUID"


def area(points):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(points, points[1:])) / 2


def board_faults(element, cut, expected):
    contour = cut.contour_param_object
    points = [list(point) for point in contour.polyline]
    if not near(contour.inclination, expected["bevels"], DEGREES):
        yield f"inclinations {contour.inclination}, not {expected['bevels']}"
    if points[0] != points[-1] or area(points) <= 0:
        yield f"the contour is open or clockwise: {points}"
    length, width, height = expected["size"]
    if not all(-LENGTH <= x <= length + LENGTH and -LENGTH <= y <= width + LENGTH and z == 0 for x, y, z in points):
        yield f"the contour leaves the box: {points}"
    if abs(contour.depth - height) > LENGTH or cut.counter_sink or cut.tool_position != "right":
        yield f"it is not cut around and through: depth {contour.depth}, tool {cut.tool_position}"
    # The face that lies up.
    if abs(dot_vectors(element.ref_sides[0].normal, expected["normal"]) - 1) > 1e-9:
        yield f"side 1 looks along {element.ref_sides[0].normal}"


def plank_faults(element, cuts, expected):
    for cut, (point, normal) in zip(cuts, expected["planes"]):
        plane = cut.plane_from_params_and_beam(element)
        distance = dot_vectors([a - b for a, b in zip(point, plane.point)], plane.normal)
        if abs(distance) > LENGTH:
            yield f"the {cut.orientation} cut passes {point} at {distance} mm"
        if not near(list(plane.normal), normal, 1e-5):
            yield f"the {cut.orientation} cut looks along {list(plane.normal)}, not {normal}"
    if [cut.orientation for cut in cuts] != ["start", "end"]:
        yield "the cuts are not those of start and end"


def part_faults(element, expected):
    if element.name != expected["address"]:
        yield f"it is {element.name}"
    box = [element.length, element.width, element.thickness if hasattr(element, "thickness") else element.height]
    if not near(sorted(box), sorted(expected["size"]), LENGTH):
        yield f"its box is {box}, not {expected['size']}"
    if not near(list(element.ref_frame.point), expected["origin"], LENGTH):
        yield f"it lies at {list(element.ref_frame.point)}, not at {expected['origin']}"
    # Not `features`, to which a plate adds the contour of its own blank.
    features = list(element._features)
    texts = [feature for feature in features if isinstance(feature, Text)]
    if [text.text for text in texts] != [expected["alias"]]:
        yield f"its texts are {[text.text for text in texts]}"
    contours = [feature for feature in features if isinstance(feature, FreeContour)]
    cuts = [feature for feature in features if isinstance(feature, JackRafterCut)]
    if "bevels" in expected and len(contours) == 1 and not cuts:
        yield from board_faults(element, contours[0], expected)
    elif "planes" in expected and len(cuts) == 2 and not contours:
        yield from plank_faults(element, cuts, expected)
    else:
        yield f"it has {len(contours)} contours and {len(cuts)} end cuts"


def faults_of(path, expected):
    yield from structure_faults(path)
    reader = BTLxReader()
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        model = reader.read(path)
    yield from (str(error) for error in reader.errors)
    yield from (str(warning.message) for warning in caught if issubclass(warning.category, UserWarning))
    elements = list(model.elements())
    if len(elements) != len(expected["parts"]):
        yield f"{len(elements)} parts, not {len(expected['parts'])}"
    for element, part in zip(elements, expected["parts"]):
        yield from (f"{part['address']}: {fault}" for fault in part_faults(element, part))


def main():
    folder, listing = sys.argv[1:]
    with open(listing, encoding="utf-8") as file:
        expected = json.load(file)
    faults = [
        f"{entry['file']}: {fault}"
        for entry in expected
        for fault in faults_of(os.path.join(folder, entry["file"]), entry)
    ]
    print(json.dumps({"models": len(expected), "parts": sum(len(entry["parts"]) for entry in expected)}))
    print("\n".join(faults[:20]), file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
