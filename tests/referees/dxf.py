"""ezdxf as referee of drawings: `python dxf.py DIR EXPECTED.json`.

EXPECTED lists drawings: {"file", "polylines": {layer: [{"points": [[x, y, bulge], …], "closed"}, …]}, "texts": […]}.
Each file must load, be in millimetres, have nothing that ezdxf's audit finds or mends, no layer without a definition,
and the same polylines in the same order on each layer, to 1e-6 mm; every text listed must be there. Prints one line of
JSON with the counts; exit code 1 with the faults on stderr.
"""

import json
import os
import sys

import ezdxf
from ezdxf import units

TOLERANCE = 1e-6


def same(read, expected):
    if len(read) != len(expected):
        return False
    return all(abs(a - b) <= TOLERANCE for r, e in zip(read, expected) for a, b in zip(r, e))


def decoded(text):
    """The text with its \\U+XXXX undone, which are units of UTF-16."""
    units = ezdxf.decode_dxf_unicode(text).encode("utf-16-le", "surrogatepass")
    return units.decode("utf-16-le")


def faults_of(path, expected):
    try:
        drawing = ezdxf.readfile(path)
    except (ezdxf.DXFError, OSError) as error:
        yield f"does not load: {error}"
        return
    audit = drawing.audit()
    for entry in audit.errors + audit.fixes:
        yield f"audit: {entry.message}"
    if drawing.units != units.MM:
        yield f"units {drawing.units}"
    space = drawing.modelspace()
    polylines = {}
    for entity in space.query("LWPOLYLINE"):
        points = entity.get_points(format="xyb")
        polylines.setdefault(entity.dxf.layer, []).append((points, bool(entity.closed)))
    for entity in space:
        if entity.dxf.layer not in drawing.layers:
            yield f"layer {entity.dxf.layer} is not defined"
    if sorted(polylines) != sorted(layer for layer, lines in expected["polylines"].items() if lines):
        yield f"polylines on {sorted(polylines)}, not {sorted(expected['polylines'])}"
        return
    for layer, lines in expected["polylines"].items():
        read = polylines.get(layer, [])
        if len(read) != len(lines):
            yield f"{layer}: {len(read)} polylines, not {len(lines)}"
        for (points, closed), line in zip(read, lines):
            if not same(points, line["points"]) or closed != line["closed"]:
                yield f"{layer}: {points} is not {line['points']}"
    texts = {decoded(text.dxf.text) for text in space.query("TEXT")}
    for text in expected.get("texts", []):
        if text not in texts:
            yield f"the text {text!r} is not there"


def main():
    folder, listing = sys.argv[1:]
    with open(listing, encoding="utf-8") as file:
        expected = json.load(file)
    faults = [
        f"{entry['file']}: {fault}"
        for entry in expected
        for fault in faults_of(os.path.join(folder, entry["file"]), entry)
    ]
    polylines = sum(len(lines) for entry in expected for lines in entry["polylines"].values())
    print(json.dumps({"drawings": len(expected), "polylines": polylines}))
    print("\n".join(faults[:20]), file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
