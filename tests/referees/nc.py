"""LinuxCNC's rs274 as referee of NC programs: `python nc.py DIR EXPECTED.json`.

EXPECTED.json lists `{"file", "outline": [[x, y], …], "tool_diameter", "thickness", "top"}`, the outline in program
coordinates (mm) and `top` the Z of the stock's upper face (0 unless said). rs274 must read every file in DIR that is
listed, with a tool table made from the programs' headers, and every .nc in DIR must be listed. shapely sweeps the
canonical motion of the cutter: the hole that its full-depth path leaves must be the outline within 0.05 mm, and no cut
at any depth may reach further into it. Prints one line of JSON with the counts; exit code 1 with the faults on stderr, 2
if rs274 or shapely is missing.
"""

import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

try:
    import shapely
    from shapely.geometry import LineString, Polygon
except ImportError as error:
    sys.exit(print(f"nc.py: {error}: run tests/setup.sh", file=sys.stderr) or 2)

TOLERANCE = 0.05
CALL = re.compile(r"^\s*\d+\s+N\S*\s+(\w+)\((.*)\)$")
TOOL = re.compile(r"^\(tool: (\d+) diameter ([\d.]+)")


def tool_table(text, folder):
    """The tools of a program's header by number, and a tool table that has them."""
    tools = {int(m[1]): float(m[2]) for m in map(TOOL.match, text.splitlines()) if m}
    path = os.path.join(folder, "tools.tbl")
    with open(path, "w", encoding="ascii") as file:
        for number, diameter in sorted(tools.items()):
            file.write(f"T{number} P{number} Z0.0 D{diameter:.3f}\n")
    return tools, path


def canonical(rs274, program, folder):
    """The canonical calls of a program, or what rs274 said against it."""
    text = open(program, encoding="ascii").read()
    tools, table = tool_table(text, folder)
    command = [rs274, "-t", table, "-g", os.path.abspath(program)]
    # rs274 keeps its tools in $HOME/.tool.mmap and truncates it at the start: two at once with one home end in SIGBUS.
    home = {**os.environ, "HOME": folder}
    run = subprocess.run(command, cwd=folder, env=home, capture_output=True, text=True, timeout=60)
    if run.returncode != 0:
        return None, tools, f"rs274 ends with {run.returncode}: {' '.join(run.stderr.split())}"
    calls = [(m[1], m[2].split(", ")) for m in map(CALL.match, run.stdout.splitlines()) if m]
    if not any(name == "PROGRAM_END" for name, _ in calls):
        return None, tools, "rs274 finds no program end"
    return calls, tools, None


def arc(start, end, centre, turn):
    """Points of an arc that stay within 0.0005 mm of it; `turn` is 1 anticlockwise, -1 clockwise."""
    radius = math.dist(start, centre)
    first = math.atan2(start[1] - centre[1], start[0] - centre[0])
    last = math.atan2(end[1] - centre[1], end[0] - centre[0])
    sweep = (last - first) * turn % (2 * math.pi) or 2 * math.pi
    count = max(1, math.ceil(sweep / (2 * math.acos(max(0.0, 1 - 0.0005 / radius)))))
    angles = [first + turn * sweep * i / count for i in range(1, count)]
    return [start, *((centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a)) for a in angles), end]


def cuts(calls):
    """The feed motion: tool, points in X and Y, lowest and highest Z."""
    at, tool = None, None
    for name, words in calls:
        if name == "CHANGE_TOOL":
            tool = int(words[0])
        elif name == "STRAIGHT_TRAVERSE":
            at = tuple(map(float, words[:3]))
        elif name == "STRAIGHT_FEED":
            to = tuple(map(float, words[:3]))
            yield tool, [at[:2], to[:2]], min(at[2], to[2]), max(at[2], to[2])
            at = to
        elif name == "ARC_FEED":
            x, y, centre_x, centre_y, turn, z = map(float, words[:6])
            yield tool, arc(at[:2], (x, y), (centre_x, centre_y), int(turn)), min(at[2], z), max(at[2], z)
            at = (x, y, z)


def swept(paths, radius):
    lines = [LineString(points).buffer(radius, quad_segs=64) for points in paths if len(set(points)) > 1]
    return shapely.union_all(lines)


def faults_of(calls, tools, entry):
    """What is wrong with the part that the canonical motion cuts, and how far it is from the outline."""
    outline, radius = Polygon(entry["outline"]), entry["tool_diameter"] / 2
    top = entry.get("top", 0.0)
    cutters = [number for number, diameter in tools.items() if abs(diameter - 2 * radius) < 1e-3]
    motion = [cut for cut in cuts(calls) if cut[0] in cutters]
    if not motion:
        return [f"nothing is cut with a tool of {2 * radius} mm"], None
    # With one tool for both, engraving is what stays in the upper half inside the part.
    shallow = top - entry["thickness"] / 2
    engraved = lambda cut: cut[2] >= shallow and outline.contains(LineString(cut[1]).centroid)
    contour = [cut for cut in motion if cut[2] < top - 1e-3 and not engraved(cut)]
    lowest = min(cut[2] for cut in contour)
    faults = []
    if lowest > top - entry["thickness"] + 1e-3:
        faults.append(f"cuts to Z {lowest}, not through {entry['thickness']} mm")
    full = swept([cut[1] for cut in contour if cut[3] < lowest + 2e-3], radius)
    holes = [Polygon(ring) for ring in getattr(full, "interiors", [])]
    if len(holes) != 1:
        return [*faults, f"the full-depth path leaves {len(holes)} parts, not one"], None
    apart = shapely.hausdorff_distance(
        shapely.segmentize(holes[0].exterior, 1.0), shapely.segmentize(outline.exterior, 1.0)
    )
    # Up to the outline's own corners, where the two boundaries run side by side.
    off = holes[0].symmetric_difference(outline).difference(outline.exterior.buffer(TOLERANCE))
    if apart > TOLERANCE or not off.is_empty:
        faults.append(f"the part is {apart:.4f} mm off its outline")
    gouged = swept([cut[1] for cut in contour], radius).intersection(outline.buffer(-TOLERANCE))
    if not gouged.is_empty:
        faults.append(f"cuts {gouged.area:.3f} mm² out of the part above full depth")
    return faults, apart


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    root, listing = sys.argv[1:]
    rs274 = shutil.which("rs274")
    if rs274 is None:
        print("nc.py: rs274 is missing (Debian linuxcnc-uspace): run tests/setup.sh", file=sys.stderr)
        sys.exit(2)
    with open(listing, encoding="utf-8") as file:
        entries = json.load(file)
    there = {
        os.path.relpath(os.path.join(folder, file), root).replace(os.sep, "/")
        for folder, _, files in os.walk(root)
        for file in files
        if file.endswith(".nc")
    }
    listed = {entry["file"] for entry in entries}
    faults = [f"{name}: there and not listed" for name in sorted(there - listed)]
    faults += [f"{name}: listed and not there" for name in sorted(listed - there)]
    worst = 0.0
    with tempfile.TemporaryDirectory() as scratch:
        for entry in entries:
            if entry["file"] not in there:
                continue
            calls, tools, fault = canonical(rs274, os.path.join(root, entry["file"]), scratch)
            found, apart = ([fault], None) if fault else faults_of(calls, tools, entry)
            faults += [f"{entry['file']}: {fault}" for fault in found]
            worst = max(worst, apart or 0.0)
    if not entries:
        faults.append("no program is listed")
    print(json.dumps({"programs": len(entries), "worst": round(worst, 4)}))
    for fault in faults:
        print(fault, file=sys.stderr)
    sys.exit(1 if faults else 0)


main()
