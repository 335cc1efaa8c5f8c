"""LinuxCNC's rs274 as referee of NC programs: `python nc.py DIR EXPECTED.json`.

EXPECTED.json lists `{"file", "outline": [[x, y], …], "tool_diameter", "thickness"}`, the outline in program coordinates
(mm), and where they are not the usual: `dialect` (linuxcnc), `top`, the Z of the stock's upper face (0), `floor`, the Z of
the deepest cut, `tab_top`, the Z to which the deepest pass is raised over tabs. Instead of `file` there may be `files`,
`[{"file", "tool"}, …]`, of a dialect without tool change; instead of `outline`, `outlines` of a sheet's parts.

rs274 must read every file in DIR that is listed, with a tool table made from the programs' headers, and every .nc in DIR
must be listed. It is no judge of words of other dialects: there the words are held against a list of the dialect's, made
here, and rs274 gets what it knows (not the number of a fanuc program) to tell the motion. shapely sweeps the canonical
motion of the cutter: the hole that its full-depth path leaves must be the outline within 0.05 mm, and no cut at any depth
may reach further into it. Prints one line of JSON with the counts; exit code 1 with the faults on stderr, 2 if rs274 or
shapely is missing.
"""

import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
from multiprocessing import Pool

try:
    import shapely
    from shapely.geometry import MultiLineString, Polygon
except ImportError as error:
    sys.exit(print(f"nc.py: {error}: run tests/setup.sh", file=sys.stderr) or 2)

TOLERANCE = 0.05
CALL = re.compile(r"^\s*\d+\s+N\S*\s+(\w+)\((.*)\)$")
TOOL = re.compile(r"^\(tool: (\d+) diameter ([\d.]+)", re.IGNORECASE)

MODES = "G0 G1 G2 G3 G4 G17 G21 G40 G49 G54 G55 G56 G57 G58 G59 G80 G90 G94 M3 M5".split()
POINT, WHOLE = r"-?\d+\.\d+", r"\d+"
AXES = {letter: POINT for letter in "XYZIJF"}
# By dialect: codes, other words by letter and the form of their number, what may stand in a comment.
DIALECTS = {
    "linuxcnc": ([*MODES, "G43", "M2", "M6"], {**AXES, "S": POINT, "P": POINT, "T": WHOLE, "H": WHOLE}, r"[ -~]*"),
    "grbl": ([*MODES, "M2"], {**AXES, "S": POINT, "P": POINT}, r"[^!?~$%;]*"),
    "fanuc": (
        [*MODES, "G43", "M6", "M30"],
        {**AXES, "S": WHOLE, "P": WHOLE, "T": WHOLE, "H": WHOLE, "O": r"\d{4}"},
        r"[A-Z0-9 +\-:/.#$&'*,<=>?@\"\[\]]*",
    ),
}


def alien(text, dialect):
    """The first line that is not of the dialect, or nothing."""
    codes, words, comment = DIALECTS[dialect]
    lines = text.splitlines()
    if dialect == "fanuc":
        if lines[0] != "%" or lines[-1] != "%" or not re.fullmatch(r"O\d{4}", lines[1]):
            return "its first and last lines"
        lines = lines[1:-1]
    for line in lines:
        if line.startswith("("):
            good = line.endswith(")") and re.fullmatch(comment, line[1:-1]) and not re.search(r"[()]", line[1:-1])
        else:
            good = all(
                word in codes or (word[0] in words and re.fullmatch(words[word[0]], word[1:]))
                for word in line.split(" ")
            )
        if not good or len(line) >= 70:
            return line
    return None



def tool_table(text, folder):
    """The tools of a program's header by number, and a tool table that has them."""
    tools = {int(m[1]): float(m[2]) for m in map(TOOL.match, text.splitlines()) if m}
    path = os.path.join(folder, "tools.tbl")
    with open(path, "w", encoding="ascii") as file:
        for number, diameter in sorted(tools.items()):
            file.write(f"T{number} P{number} Z0.0 D{diameter:.3f}\n")
    return tools, path


def canonical(rs274, program, dialect, folder):
    """The canonical calls of a program, or what speaks against it."""
    text = open(program, encoding="ascii").read()
    tools, table = tool_table(text, folder)
    line = alien(text, dialect)
    if line is not None:
        return None, tools, f"is no {dialect}: {line}"
    if dialect == "fanuc":
        program = os.path.join(folder, "known.ngc")
        with open(program, "w", encoding="ascii") as file:
            file.write("\n".join(line for line in text.splitlines() if not line.startswith("O")) + "\n")
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


def cuts(calls, tool=None):
    """The feed motion: tool, points in X and Y, lowest and highest Z; with a tool in the spindle at the start."""
    at = None
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


def lines(paths):
    return MultiLineString([points for points in paths if len(set(points)) > 1])


def holes_of(full, outlines):
    """What the full-depth path leaves of each part, and what is wrong with that."""
    # The slots around parts that lie apart do not touch each other.
    slots = getattr(full, "geoms", [full])
    holes = [Polygon(ring) for slot in slots for ring in getattr(slot, "interiors", [])]
    if len(outlines) == 1 and len(holes) != 1:
        return None, f"the full-depth path leaves {len(holes)} parts, not one"
    found = []
    for outline in outlines:
        # Between the parts of a sheet there are pieces of waste too.
        inside = outline.representative_point()
        of_part = [hole for hole in holes if hole.contains(inside)]
        if len(of_part) != 1:
            return None, f"the full-depth path leaves {len(of_part)} parts about {inside.wkt}"
        found += of_part
    return found, None


def faults_of(motion, entry):
    """What is wrong with the parts that the canonical motion cuts, and how far they are from their outlines."""
    outlines = [Polygon(points) for points in entry.get("outlines") or [entry["outline"]]]
    radius, top = entry["tool_diameter"] / 2, entry.get("top", 0.0)
    # With one tool for both, engraving is what stays in the upper half inside a part.
    shallow = top - entry["thickness"] / 2
    middle = lambda cut: shapely.Point(cut[1][len(cut[1]) // 2 - 1]).union(shapely.Point(cut[1][-1])).centroid
    engraved = lambda cut: cut[2] >= shallow and any(outline.contains(middle(cut)) for outline in outlines)
    contour = [cut for cut in motion if cut[2] < top - 1e-3 and not engraved(cut)]
    if not contour:
        return ["nothing is cut"], None
    lowest = min(cut[2] for cut in contour)
    faults = []
    if "floor" in entry and abs(lowest - entry["floor"]) > 2e-3:
        faults.append(f"cuts to Z {lowest}, not {entry['floor']}")
    if "floor" not in entry and lowest > top - entry["thickness"] + 1e-3:
        faults.append(f"cuts to Z {lowest}, not through {entry['thickness']} mm")
    over_tab = lambda cut: "tab_top" in entry and abs(cut[2] - entry["tab_top"]) < 2e-3 and cut[2] == cut[3]
    full = lines(cut[1] for cut in contour if cut[3] < lowest + 2e-3 or over_tab(cut)).buffer(radius, quad_segs=24)
    holes, fault = holes_of(full, outlines)
    if fault:
        return [*faults, fault], None
    worst = 0.0
    for hole, outline in zip(holes, outlines):
        apart = shapely.hausdorff_distance(
            shapely.segmentize(hole.exterior, 2.0), shapely.segmentize(outline.exterior, 2.0)
        )
        worst = max(worst, apart)
        # Up to the outline's own corners, where the two boundaries run side by side.
        off = hole.symmetric_difference(outline).difference(outline.exterior.buffer(TOLERANCE))
        if apart > TOLERANCE or not off.is_empty:
            faults.append(f"the part is {apart:.4f} mm off its outline")
    paths = lines(cut[1] for cut in contour)
    for outline in outlines:
        into = radius - TOLERANCE - paths.distance(outline)
        if into > 0:
            faults.append(f"cuts {into + TOLERANCE:.3f} mm into the part above full depth")
    return faults, worst


def judged(task):
    """The faults of one entry, and how far its parts are from their outlines."""
    rs274, root, entry = task
    radius = entry["tool_diameter"] / 2
    files = entry.get("files") or [{"file": entry["file"], "tool": None}]
    motion = []
    with tempfile.TemporaryDirectory() as scratch:
        for file in files:
            program = os.path.join(root, file["file"])
            calls, tools, fault = canonical(rs274, program, entry.get("dialect", "linuxcnc"), scratch)
            if fault:
                return [f"{file['file']}: {fault}"], None
            cutters = [number for number, diameter in tools.items() if abs(diameter - 2 * radius) < 1e-3]
            motion += [cut for cut in cuts(calls, file["tool"]) if cut[0] in cutters]
    name = files[0]["file"]
    if not motion:
        return [f"{name}: nothing is cut with a tool of {2 * radius} mm"], None
    found, apart = faults_of(motion, entry)
    return [f"{name}: {fault}" for fault in found], apart


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
    names = lambda entry: [file["file"] for file in entry.get("files") or [entry]]
    listed = {name for entry in entries for name in names(entry)}
    faults = [f"{name}: there and not listed" for name in sorted(there - listed)]
    faults += [f"{name}: listed and not there" for name in sorted(listed - there)]
    worst = 0.0
    tasks = [(rs274, root, entry) for entry in entries if there.issuperset(names(entry))]
    with Pool(min(4, os.cpu_count() or 1)) as pool:
        for found, apart in pool.imap(judged, tasks, chunksize=8):
            faults += found
            worst = max(worst, apart or 0.0)
    if not entries:
        faults.append("no program is listed")
    print(json.dumps({"programs": len(entries), "worst": round(worst, 4)}))
    for fault in faults:
        print(fault, file=sys.stderr)
    sys.exit(1 if faults else 0)


main()
