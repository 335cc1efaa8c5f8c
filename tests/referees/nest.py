"""Shapely as referee of nested sheets: `python nest.py DIR`.

Reads sheets/*.svg and report.json of an output folder. On every sheet the parts lie inside the margin and at least the gap
apart, and there are as many as the report and nest.csv say. Prints one line of JSON with the counts; exit code 1 with the
faults on stderr.
"""

import csv
import json
import os
import sys
import xml.etree.ElementTree as ElementTree

from shapely import STRtree
from shapely.geometry import Polygon, box

SVG = "{http://www.w3.org/2000/svg}"
# The pictures have three decimals.
ROUNDING = 2e-3


def number(element, name):
    return float(element.get(name))


def rectangle(root, kind):
    element = root.find(f"{SVG}rect[@class='{kind}']")
    x, y = number(element, "x"), number(element, "y")
    return box(x, y, x + number(element, "width"), y + number(element, "height"))


def parts(root):
    for element in root.iterfind(f"{SVG}polygon[@class='part']"):
        yield Polygon([tuple(map(float, pair.split(","))) for pair in element.get("points").split()])


def sheet_faults(root, gap, margin):
    board, room, found = rectangle(root, "board"), rectangle(root, "margin"), list(parts(root))
    if abs(board.exterior.distance(room) - margin) > ROUNDING:
        yield f"the margin is drawn {board.exterior.distance(room)} wide"
    tree = STRtree(found)
    for index, part in enumerate(found):
        if not part.is_valid or not room.buffer(ROUNDING, join_style="mitre").covers(part):
            yield f"part {index} is not inside the margin"
        for other in tree.query(part.buffer(gap)):
            if other > index and part.distance(found[other]) < gap - ROUNDING:
                yield f"parts {index} and {other} are {part.distance(found[other]):.3f} apart"


def main(folder):
    with open(os.path.join(folder, "report.json"), encoding="utf-8") as file:
        report = json.load(file)
    with open(os.path.join(folder, "nest.csv"), encoding="utf-8", newline="") as file:
        placed = [row["sheet"] for row in csv.DictReader(file) if row["status"] == "placed"]
    faults, boards, sheets = [], 0, 0
    for nest in report["sheets"]:
        for sheet in nest["sheets"]:
            path = os.path.join(folder, "sheets", sheet["name"] + ".svg")
            root = ElementTree.parse(path).getroot()
            count = sum(1 for _ in parts(root))
            if not count == sheet["boards"] == placed.count(sheet["name"]):
                faults.append(f"{sheet['name']}: {count} parts drawn, {sheet['boards']} said")
            area = sum(part.area for part in parts(root)) / (nest["length_mm"] * nest["width_mm"])
            if abs(area - sheet["yield"]) > 1e-4:
                faults.append(f"{sheet['name']}: a yield of {area}, {sheet['yield']} said")
            faults += [f"{sheet['name']}: {fault}" for fault in sheet_faults(root, nest["gap_mm"], nest["margin_mm"])]
            boards += count
            sheets += 1
    print(json.dumps({"sheets": sheets, "boards": boards}))
    if faults:
        print("\n".join(faults), file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
