"""Python's own XML parser as a referee of report.html: `python html.py DIR…`.

The page is well-formed XML, holds no script and names nothing outside itself; every figure that says its place in
report.json shows it, rounded to the digits it has; so do the cells of tables that follow a list of report.json; bars of
histograms are as high as their counts, and those of requirements count the parts; every board has its field in the maps and its alias on the assembly map, unless
the page says that it is too large for that. Prints one line of JSON with the counts; exit code 1 with the faults on
stderr.
"""

import json
import os
import re
import sys
from decimal import ROUND_HALF_EVEN, Decimal, InvalidOperation
from xml.etree import ElementTree

HTML = "{http://www.w3.org/1999/xhtml}"
SVG = "{http://www.w3.org/2000/svg}"
NAMESPACES = ("http://www.w3.org/1999/xhtml", "http://www.w3.org/2000/svg")


def resolve(value, pointer):
    """What a JSON pointer (RFC 6901) leads to."""
    for part in pointer.split("/")[1:]:
        part = part.replace("~1", "/").replace("~0", "~")
        value = value[int(part)] if isinstance(value, list) else value[part]
    return value


def plain(text):
    """A shown number without groups and with a plain minus."""
    return text.replace("\u202f", "").replace("\u2212", "-")


def is_rounded(shown, exact):
    """Whether a shown text is a number of report.json rounded to its own decimals, or the text itself."""
    if not isinstance(exact, (Decimal, int)) or isinstance(exact, bool):
        return shown == ("" if exact is None else str(exact))
    try:
        number = Decimal(plain(shown))
    except InvalidOperation:
        return False
    unit = Decimal(1).scaleb(number.as_tuple().exponent)
    exact = Decimal(exact)
    # The page rounds what report.json has rounded already: half a unit of both.
    slack = Decimal(1).scaleb(exact.as_tuple().exponent) / 2
    return abs(exact.quantize(unit, ROUND_HALF_EVEN) - number) <= unit and abs(exact - number) <= unit / 2 + slack


class Page:
    def __init__(self, root):
        with open(os.path.join(root, "report.html"), encoding="utf-8") as file:
            self.text = file.read()
        with open(os.path.join(root, "report.json"), encoding="utf-8") as file:
            self.report = json.load(file, parse_float=Decimal)
        self.tree = ElementTree.fromstring(self.text)
        self.faults = []
        self.counts = {"figures": 0, "cells": 0, "bars": 0, "aliases": 0, "distributions": 0, "bytes": len(self.text.encode())}

    def fault(self, text):
        self.faults.append(text)

    def judge(self):
        self.nothing_outside()
        self.figures()
        self.tables()
        self.histograms()
        self.maps()
        for made in self.report["fabrications"]:
            self.aliases(made)
            self.distributions(made)
        self.verdict()

    def nothing_outside(self):
        for element in self.tree.iter():
            if element.tag.rpartition("}")[2] in ("script", "link", "img", "iframe", "object", "image", "use", "a"):
                self.fault(f"<{element.tag}>")
            for name, value in element.attrib.items():
                if name.startswith("on") or name.endswith(("href", "src")) or "url(" in value or "NaN" in value:
                    self.fault(f"{name}={value!r}")
        rest = self.text
        for namespace in NAMESPACES:
            rest = rest.replace(f'xmlns="{namespace}"', "")
        style = "".join(element.text or "" for element in self.tree.iter(HTML + "style"))
        if "://" in style or "@import" in style or "url(" in style:
            self.fault("the style sheet names something outside")
        if re.search(r'="(https?:)?//', rest):
            self.fault("an attribute names something outside")

    def figures(self):
        for element in self.tree.iter(HTML + "data"):
            at, value, shown = element.get("data-at"), element.get("value"), "".join(element.itertext())
            exact = resolve(self.report, at)
            if str(exact) != value and Decimal(value) != exact:
                self.fault(f"{at} is {exact}, not {value}")
            if not is_rounded(shown, exact):
                self.fault(f"{at} is {exact}, shown as {shown}")
            self.counts["figures"] += 1

    def tables(self):
        for table in self.tree.iter(HTML + "table"):
            at = table.get("data-rows")
            if at is None:
                continue
            fields = [head.get("data-field") for head in table.iter(HTML + "th")]
            rows = resolve(self.report, at)
            for row in table.iter(HTML + "tr"):
                if row.get("data-row") is None:
                    continue
                of = rows[int(row.get("data-row"))]
                cells = row.findall(HTML + "td")
                if len(cells) != len(fields):
                    self.fault(f"{at}: a row of {len(cells)} cells under {len(fields)} heads")
                for field, cell in zip(fields, cells):
                    if field is None:
                        continue
                    shown = "".join(cell.itertext())
                    exact = resolve(of, "/" + field) if field.partition("/")[0] in of and of[field.partition("/")[0]] is not None else None
                    if not is_rounded(shown, exact):
                        self.fault(f"{at}/{row.get('data-row')}/{field} is {exact}, shown as {shown!r}")
                    self.counts["cells"] += 1

    def histograms(self):
        for group in self.tree.iter(SVG + "g"):
            if group.get("class") != "bars":
                continue
            counts = resolve(self.report, group.get("data-at"))
            bars = group.findall(SVG + "rect")
            if {int(bar.get("data-bin")) for bar in bars} != {place for place, count in enumerate(counts) if count}:
                self.fault(f"{group.get('data-at')}: bars for other bins than those with counts")
                continue
            most = max(counts)
            top = max(Decimal(bar.get("height")) for bar in bars)
            for bar in bars:
                count = counts[int(bar.get("data-bin"))]
                height = Decimal(bar.get("height"))
                if abs(height - top * count / most) > Decimal("0.26"):
                    self.fault(f"{group.get('data-at')}/{bar.get('data-bin')}: a bar of {height} for {count} of {most}")
                self.counts["bars"] += 1

    def maps(self):
        """Every quad has its field in every map."""
        panels = [made for made in self.report["fabrications"] if made["kind"] == "panels"]
        maps = [group for group in self.tree.iter(SVG + "g") if group.get("class") == "map"]
        if "Drawn coarser" in self.text or "it is in the model only" in self.text:
            return
        expected = []
        for made in panels:
            moved = made["planarity"]["moved"]["count"] > 0
            expected += [made["counts"]["elements"]] * (3 if moved else 1)
        drawn = [len(group.findall(f".//{SVG}path")) for group in maps]
        stated = [int(group.get("data-fields")) for group in maps]
        if drawn != expected or stated != expected:
            self.fault(f"maps of {drawn} fields, stated as {stated}; expected {expected}")

    def aliases(self, made):
        if made["counts"]["made"] > 2000:
            return
        shown = {"".join(element.itertext()) for element in self.tree.iter(SVG + "text") if element.get("class") == "cell-text"}
        shown |= {"".join(cell.itertext()) for cell in self.tree.iter(HTML + "td")}
        starts = set(re.findall("Every alias starts with “(.*?)”", "".join(self.tree.itertext()))) | {""}
        drawn = {start + end for start in starts for end in shown}
        for part in made["parts"]:
            if part["alias"] not in drawn:
                self.fault(f"{part['alias']} is on no assembly map")
            self.counts["aliases"] += 1

    def distributions(self, made):
        """The counts of requirements are those of the parts, but for values within rounding of a border."""
        of = {
            "planarity": lambda part: [part["planarity"]],
            "edge": lambda part: part["edges_mm"],
            "length": lambda part: [part["length_mm"]],
            "bend radius": lambda part: [part["bend_radius_mm"]],
        }
        parts = [part for part in made["parts"] if part["status"] == "made"]
        for requirement in made["requirements"]:
            words = re.match(r"(?:require )?([a-z ]+?) (?:>|<|=|in )", requirement["text"])
            spread = requirement["distribution"]
            if spread is None or words is None or words[1] not in of:
                continue
            values = sorted(float(value) for part in parts for value in of[words[1]](part) if value is not None)
            low, high, counts = float(spread["low"]), float(spread["high"]), spread["counts"]
            if sum(counts) != len(values):
                self.fault(f"{requirement['text']}: {sum(counts)} counted of {len(values)}")
            slack, below = 1e-8 * max(1.0, high) + 0.001 * (requirement["unit"] is not None), 0
            for bin, count in enumerate(counts[:-1]):
                part = (bin + 1) / len(counts)
                border = low * (high / low) ** part if spread["logarithmic"] else low + (high - low) * part
                below += count
                surely = sum(value < border - slack for value in values)
                perhaps = sum(value <= border + slack for value in values)
                if not surely <= below <= perhaps:
                    self.fault(f"{requirement['text']}: {below} below {border}, not {surely} to {perhaps}")
            self.counts["distributions"] += 1

    def verdict(self):
        holds = all(
            made["counts"]["refused"] == 0 and all(requirement["holds"] for requirement in made["requirements"])
            for made in self.report["fabrications"]
        )
        said = [element.get("data-holds") for element in self.tree.iter(HTML + "div") if element.get("data-holds")]
        if said != [str(holds).lower()]:
            self.fault(f"the verdict is {said}, but that everything holds is {holds}")


def main():
    counts, faults = {}, []
    for root in sys.argv[1:]:
        page = Page(root)
        page.judge()
        counts = page.counts
        faults += [f"{root}: {fault}" for fault in page.faults]
    print(json.dumps(counts))
    for fault in faults[:40]:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
