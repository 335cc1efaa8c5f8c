"""Python's own csv, json and hashlib as referees of an output folder: `python outputs.py DIR [--foreign NAME]…`.

The manifest has its keys in order and lists every file with its length and SHA-256 and nothing else lies there but the
foreign names given; it holds no absolute path. Every .csv is UTF-8 with LF, a header of distinct names, rows of one
width and no cell which a spreadsheet would take for a formula; every .json is JSON; every .nc is ASCII. Prints one line
of JSON with the counts; exit code 1 with the faults on stderr.
"""

import argparse
import csv
import hashlib
import json
import os
import re
import sys

KEYS = ["schema", "program", "version", "sources", "parameters", "left_out", "failed", "files"]
OPTIONAL = {"left_out", "failed"}
NUMBER = re.compile(r"[+-]?\d+(\.\d+)?([eE][+-]?\d+)?")


def read(root, name):
    with open(os.path.join(root, name), "rb") as file:
        return file.read()


def names_below(root):
    for folder, _, files in os.walk(root):
        for file in files:
            yield os.path.relpath(os.path.join(folder, file), root).replace(os.sep, "/")


def text_faults(data, encoding):
    """The text and what is wrong with it as a text."""
    try:
        text = data.decode(encoding)
    except UnicodeDecodeError as error:
        return None, [str(error)]
    faults = []
    if "\r" in text:
        faults.append("a carriage return")
    if not text.endswith("\n"):
        faults.append("no line end at its end")
    if text.startswith("\ufeff"):
        faults.append("a byte order mark")
    return text, faults


def csv_faults(data):
    text, faults = text_faults(data, "utf-8")
    if text is None:
        return faults
    try:
        rows = list(csv.reader(text.splitlines(keepends=True), strict=True))
    except csv.Error as error:
        return faults + [str(error)]
    if not rows or len(set(rows[0])) != len(rows[0]) or "" in rows[0]:
        return faults + ["no header of distinct names"]
    for number, row in enumerate(rows, 1):
        if len(row) != len(rows[0]):
            faults.append(f"row {number} has {len(row)} cells, not {len(rows[0])}")
        formulas = [cell for cell in row if cell[:1] in ("=", "+", "-", "@") and not NUMBER.fullmatch(cell)]
        faults += [f"row {number}: {cell!r} is a formula to a spreadsheet" for cell in formulas]
    return faults


def json_faults(data):
    text, faults = text_faults(data, "utf-8")
    try:
        json.loads(text or "")
    except ValueError as error:
        faults.append(str(error))
    return faults


def manifest_faults(manifest):
    faults = []
    if list(manifest) != [key for key in KEYS if key in manifest or key not in OPTIONAL]:
        faults.append(f"keys {list(manifest)}")
    for part in ("files", "sources"):
        paths = [entry["path"] for entry in manifest.get(part, [])]
        if paths != sorted(set(paths)):
            faults.append(f"{part} out of order or twice")
        faults += [f"{part}: {path!r} leads out" for path in paths if path.startswith("/") or ".." in path.split("/")]
    if list(manifest.get("parameters", {})) != sorted(manifest.get("parameters", {})):
        faults.append("parameters out of order")
    return faults


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("folder")
    arguments.add_argument("--foreign", action="append", default=[])
    arguments = arguments.parse_args()
    root = arguments.folder

    faults = [f"manifest.json: {fault}" for fault in json_faults(read(root, "manifest.json"))]
    manifest = json.loads(read(root, "manifest.json"))
    faults += [f"manifest.json: {fault}" for fault in manifest_faults(manifest)]
    listed = {entry["path"]: entry for entry in manifest["files"]}
    found = set(names_below(root)) - {"manifest.json"} - set(arguments.foreign)
    faults += [f"{name}: listed and not there" for name in sorted(set(listed) - found)]
    faults += [f"{name}: there and not listed" for name in sorted(found - set(listed))]
    kinds = {}
    for name in sorted(found & set(listed)):
        data, entry = read(root, name), listed[name]
        kinds[entry["kind"]] = kinds.get(entry["kind"], 0) + 1
        if (len(data), hashlib.sha256(data).hexdigest()) != (entry["bytes"], entry["sha256"]):
            faults.append(f"{name}: other bytes than listed")
        if name.endswith(".csv"):
            faults += [f"{name}: {fault}" for fault in csv_faults(data)]
        elif name.endswith(".json"):
            faults += [f"{name}: {fault}" for fault in json_faults(data)]
        elif name.endswith(".nc"):
            faults += [f"{name}: {fault}" for fault in text_faults(data, "ascii")[1]]
    print(json.dumps({"folder": root, "files": len(found), "kinds": dict(sorted(kinds.items()))}))
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
