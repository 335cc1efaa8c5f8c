//! Quick fixes: each of a table of texts becomes the text it should; and every fix that is offered in the suite is a change
//! of the text after which its diagnostic is gone.
#![allow(clippy::disallowed_methods, clippy::unwrap_used, reason = "the tests read the suite")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use ifs_compiler::analysis::{Analysis, analyse, read_indexed, work_out};
use ifs_compiler::diagnostic::{Diagnostic, Edit, Severity};
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::{FileId, Files, MemoryFiles, ReadError};
use ifs_lsp::{Mend, mends};
use ifs_tests::annotations::Annotations;
use ifs_tests::{root, suite};

/// The files beside a case, one of them with another text.
struct Folder {
    folder: PathBuf,
    changed: (String, String),
}

impl Files for Folder {
    fn read(&self, path: &str) -> Result<Vec<u8>, ReadError> {
        if path == self.changed.0 {
            return Ok(self.changed.1.clone().into_bytes());
        }
        fs::read(self.folder.join(path)).map_err(|_| ReadError::NotFound)
    }
}

/// As the server knows it: with its index, worked out.
fn known(files: &dyn Files, name: &str, overrides: &Overrides) -> Analysis {
    work_out(read_indexed(files, name, overrides), overrides)
}

fn applied(text: &str, edits: &[Edit]) -> String {
    let mut text = text.to_owned();
    for edit in edits.iter().rev() {
        text.replace_range(edit.span.range(), &edit.replacement);
    }
    text
}

/// Where a place of the old text lies in the new one.
fn moved(offset: u32, edits: &[Edit]) -> i64 {
    let mut at = i64::from(offset);
    for edit in edits.iter().filter(|edit| edit.span.end <= offset) {
        at += edit.replacement.len() as i64 - i64::from(edit.span.end - edit.span.start);
    }
    at
}

fn errors(analysis: &Analysis) -> usize {
    analysis.diagnostics.iter().filter(|found| found.severity() == Severity::Error).count()
}

/// What is wrong with a fix; nothing where it does what it says.
fn fault(
    analysis: &Analysis,
    found: &Diagnostic,
    mend: &Mend,
    again: impl Fn(&str, String) -> Analysis,
) -> Option<String> {
    let file = mend.edits.first()?.span.file;
    let source = analysis.sources.get(file)?;
    if mend.edits.iter().any(|edit| source.text.get(edit.span.range()).is_none()) {
        return Some("a place outside of the text".to_owned());
    }
    let text = applied(&source.text, &mend.edits);
    let after = again(&source.path, text.clone());
    let same = |other: &&Diagnostic| {
        let there = moved(found.span.start, &mend.edits);
        let path =
            |analysis: &Analysis, file: FileId| analysis.sources.get(file).map(|source| source.path.clone());
        other.code == found.code
            && path(&after, other.span.file) == path(analysis, found.span.file)
            && (i64::from(other.span.start) - there).abs() <= 1
            && other.message == found.message
    };
    if let Some(still) = after.diagnostics.iter().find(same) {
        return Some(format!("it is still said: {}\n{text}", still.message));
    }
    if errors(&after) > errors(analysis) {
        let new: Vec<String> = after
            .diagnostics
            .iter()
            .filter(|new| analysis.diagnostics.iter().all(|old| old.message != new.message))
            .map(|new| format!("{} {}", new.code.name(), new.message))
            .collect();
        return Some(format!("new errors: {}\n{text}", new.join("; ")));
    }
    None
}

fn offered_in_suite(mut each: impl FnMut(&Path, &Analysis, &Diagnostic, &Mend, Option<String>)) {
    for path in suite::cases(&root().join("tests/suite")) {
        let text = fs::read_to_string(&path).unwrap();
        let settings = Annotations::parse(&text).unwrap().settings;
        let overrides = Overrides { parameters: settings.into_iter().collect(), ..Overrides::default() };
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let folder = path.parent().unwrap().to_owned();
        let files = Folder { folder: folder.clone(), changed: (name.clone(), text) };
        let analysis = known(&files, &name, &overrides);
        for found in &analysis.diagnostics {
            for mend in mends(&analysis, found) {
                let again = |changed: &str, text: String| {
                    let mut files = Folder { folder: folder.clone(), changed: (changed.to_owned(), text) };
                    if changed != name {
                        files.folder.clone_from(&folder);
                    }
                    analyse(&files, &name, &overrides)
                };
                let fault = fault(&analysis, found, &mend, again);
                each(&path, &analysis, found, &mend, fault);
            }
        }
    }
}

#[test]
fn every_fix_offered_in_the_suite_mends() {
    let mut codes = BTreeSet::new();
    let mut faults = Vec::new();
    offered_in_suite(|path, _, found, mend, fault| {
        codes.insert(found.code.name());
        if let Some(fault) = fault {
            faults.push(format!("{} {}, `{}`: {fault}", path.display(), found.code.name(), mend.title));
        }
    });
    assert!(faults.is_empty(), "{}", faults.join("\n\n"));
    assert!(codes.len() >= 40, "only {}: {codes:?}", codes.len());
}

/// Before each text that begins with `fabricate`: a surface and a curve.
const FIGURES: &str = "use std.curves (bspline3, bezier2)
use std.surfaces (sheet)
use std.materials (birch_plywood, sawn_spruce)
use std.machines (router3)
let net = [[(i * 1m, j * 1m, 0m) for j in 0..5] for i in 0..5]
figure roof = sheet(bspline3, bspline3, net) at level 1
figure rail = bezier2 on ((0m, 0m), (0m, 1m), (1m, 1m)) at level 2
";

/// A code, a text, the title of one of its fixes, and what stands there afterwards in the place of `before`.
struct Row {
    code: &'static str,
    text: &'static str,
    title: &'static str,
    before: &'static str,
    after: &'static str,
}

const fn row(
    code: &'static str,
    text: &'static str,
    title: &'static str,
    before: &'static str,
    after: &'static str,
) -> Row {
    Row { code, text, title, before, after }
}

/// Edges of 1 m, 500 mm, 250 mm, and so on.
const STEEP: &str =
    "use std.curves (line)\nfigure f = line on ((0m, 0m), (1m, 0m)) until edge in 300mm .. 400mm\n";

const LINE: &str = "figure f = c on ((0m, 0m), (1m, 1m)) at level 3\n";

/// Points behind the name of a curve.
const CALLED: &str = "use std.curves (bspline2)\nlet net = [(i * 1m, 0m) for i in 0..5]\nfigure f = bspline2(net) at level 2\n";

const APART: &str = "use std.curves (line)\nfigure f = line((0m, 0m), (1m, 0m)) at level 2\n";

const ROWS: &[Row] = &[
    row("E0406", CALLED, "write `bspline2 on net`", "bspline2(net)", "bspline2 on net"),
    row("E0406", APART, "write `line on (p, q, …)`", "line((0m", "line on ((0m"),
    row("E0408", "let w = [1m, 2m]\nlet a = w (1)\n", "pick an element with `[…]`", "w (1)", "w[1]"),
    row("E0602", "let w = [1m, 2m]\nlet a = w[0..7]\n", "take 0..2, to the end of the list", "0..7", "0..2"),
    row("E0552", STEEP, "begin at 250mm, which level 2 meets", "in 300mm", "in 250mm"),
    row("E0552", STEEP, "end at 500mm, which level 1 meets", "400mm", "500mm"),
    row("E0102", "let a = 3;\n", "remove `;`", ";", ""),
    row("E0103", "param wood: Text = \"spruce\n", "insert `\"`", "spruce", "spruce\""),
    row("E0105", "let a = 12mn\n", "replace `mn` with `mm`", "mn", "mm"),
    row("E0408", "let v = 2m/min(3, 4)\n", "replace `2m/min` with `2m / min`", "2m/min", "2m / min"),
    row("E0201", "let in = 3\n", "call it `in_`: `in` is a word of the language", "in =", "in_ ="),
    row(
        "E0201",
        "let a = 3\nlet b = 1 < a + 1 < 5 <= 7\n",
        "compare one by one: insert `and a + 1`, `and 5`",
        "1 < a + 1 < 5 <= 7",
        "1 < a + 1 and a + 1 < 5 and 5 <= 7",
    ),
    row("E0202", "let a = [1, 2\nlet b = 3\n", "insert `]`", "2\n", "2]\n"),
    row("E0203", "let a = (1m, 2m))\n", "remove `)`", "))", ")"),
    row("E0204", "let a = 3\n//! All.\nlet b = 4\n", "replace `//!` with `///`", "//!", "///"),
    row(
        "E0205",
        "let Wide = 3m\nlet b = Wide + Wide\n",
        "write `wide` instead of `Wide` here and at 2 more places",
        "let Wide = 3m\nlet b = Wide + Wide",
        "let wide = 3m\nlet b = wide + wide",
    ),
    row("E0301", "let width = 3\nlet b = widht + 1\n", "replace `widht` with `width`", "widht", "width"),
    row(
        "E0301",
        "ifs a on (p) {\n    transform t = slef on (p)\n    germ point(p)\n}\n",
        "replace `slef` with `self`",
        "slef",
        "self",
    ),
    row(
        "E0302",
        "let width = 3\nlet width = 4\n",
        "call the second `width_2`: `width` still means the first",
        "let width = 4",
        "let width_2 = 4",
    ),
    row(
        "E0302",
        "ifs c on (a, b) {\n    transform l = self on (a, lerp(a, b, 1/2))\n    transform r = self on (lerp(a, b, 1/2), b)\n    germ segment(a, b)\n    germ segment(b, a)\n}\n",
        "remove the second, `germ segment(b, a)`",
        "    germ segment(b, a)\n",
        "",
    ),
    row(
        "E0304",
        "use std.curves (bezier2, sheet)\nlet f = [bezier2]\nlet g = sheet\n",
        "import `sheet` from `std.surfaces` instead",
        "(bezier2, sheet)\n",
        "(bezier2)\nuse std.surfaces (sheet)\n",
    ),
    row(
        "E0304",
        "use std.curves (sheet)\nlet g = 3\n",
        "import `sheet` from `std.surfaces` instead",
        "std.curves",
        "std.surfaces",
    ),
    row(
        "E0304",
        "use std.surfaces (bezier2)\nuse std.curves (bezier3)\nlet f = [bezier2, bezier3]\n",
        "import `bezier2` from `std.curves` instead",
        "use std.surfaces (bezier2)\nuse std.curves (bezier3)",
        "use std.curves (bezier3, bezier2)",
    ),
    row(
        "W0307",
        "use std.curves (bezier2, bezier3)\nlet f = bezier2\n",
        "remove the import of `bezier3`",
        "bezier2, bezier3",
        "bezier2",
    ),
    row(
        "W0307",
        "use std.curves (bezier3)\nlet a = 3\n",
        "remove the import of `bezier3`",
        "use std.curves (bezier3)\n",
        "",
    ),
    row(
        "W0308",
        "figure r = bezier2 on ((0m, 0m), (0m, 1m), (1m, 1m)) at level 2\n",
        "add `use std.curves (bezier2)`",
        "figure",
        "use std.curves (bezier2)\n\nfigure",
    ),
    // Before what documents the first item, and beside what is imported of the module.
    row(
        "W0308",
        "/// A rail.\nfigure r = bezier2 on ((0m, 0m), (0m, 1m), (1m, 1m)) at level 2\n",
        "add `use std.curves (bezier2)`",
        "///",
        "use std.curves (bezier2)\n\n///",
    ),
    row(
        "W0308",
        "use std.curves (line)\nfigure r = bezier2 on ((0m, 0m), (0m, 1m), (1m, 1m)) at level 2\nlet l = line\n",
        "add `use std.curves (bezier2)`",
        "(line)",
        "(line, bezier2)",
    ),
    row("E0401", "let a: Length = 27\n", "replace `27` with `27mm`", "27", "27mm"),
    row("E0401", "let a: Length = 27\n", "replace `27` with `27cm`", "27", "27cm"),
    row("E0401", "let a: Length = 27\n", "replace `27` with `27m`", "27", "27m"),
    row("E0401", "let a: Int = 2.0\n", "replace `2.0` with `2`", "2.0", "2"),
    row("E0401", "let a: Int = 3.5\n", "replace `3.5` with `3`", "3.5", "3"),
    row("E0401", "let a: Int = 3.5\n", "replace `3.5` with `4`", "3.5", "4"),
    row("E0401", "let a: Int = 3m\n", "replace `3m` with `3`", "3m", "3"),
    row("E0401", "let a: Angle = 30\n", "replace `30` with `30deg`", "30", "30deg"),
    row("E0401", "let a: Length = 30deg\n", "replace `30deg` with `30mm`", "30deg", "30mm"),
    row("E0401", "let a: Number = 30mm\n", "replace `30mm` with `30`", "30mm", "30"),
    row(
        "E0401",
        "param bays: Int = 7\nlet half: Int = bays / 2\n",
        "replace `bays / 2` with `floor(bays / 2)`",
        "bays / 2",
        "floor(bays / 2)",
    ),
    row(
        "E0401",
        "use std.materials (birch_plywood)\nlet bent: Length = birch_plywood(12mm).min_bend_radius\n",
        "replace `.min_bend_radius` with `.min_bend_radius.along`",
        "min_bend_radius\n",
        "min_bend_radius.along\n",
    ),
    row("E0402", "let a = 3m + 4\n", "replace `4` with `4mm`", "4", "4mm"),
    row(
        "E0403",
        "fn f(a: Length, b: Angle) = a\nlet c = f(3m)\n",
        "add `b: 30deg`",
        "f(3m)",
        "f(3m, b: 30deg)",
    ),
    row(
        "E0403",
        "fabricate roof as panels { board: 2m by 1m }\n",
        "add `material` to begin with",
        "{ board",
        "{ material: birch_plywood(12mm)\n    board",
    ),
    row(
        "E0404",
        "fabricate rail as planks {\n    material: sawn_spruce\n    section: 120mm by 27mm\n    colour: 3\n}\n",
        "remove `colour: 3`",
        "    colour: 3\n",
        "",
    ),
    row("E0404", "fn f(a: Int) = a\nlet c = f(1, depth: 2)\n", "remove `depth: 2`", "1, depth: 2", "1"),
    row("E0405", "fn f(a: Int) = a\nlet c = f(a: 1, a: 2)\n", "remove the second, `a: 2`", "1, a: 2", "1"),
    row(
        "E0405",
        "fabricate roof as panels {\n    material: birch_plywood(12mm)\n    board: 2m by 1m\n    board: 3m by 1m\n}\n",
        "remove the second, `board: 3m by 1m`",
        "    board: 3m by 1m\n",
        "",
    ),
    row("E0406", "fn f(a: Int) = a\nlet c = f(1, 2, 3)\n", "remove `, 2, 3`", "1, 2, 3", "1"),
    row("E0408", "let a = 3\nfn f(b: Int) = b(2)\nlet c = f(a)\n", "multiply with `*`", "b(2)", "b * (2)"),
    row("E0409", "fn f(a: Float) = a\n", "replace `Float` with `Number`", "Float", "Number"),
    row("E0409", "param a: Metre = 2m\n", "replace `Metre` with `Length`", "Metre", "Length"),
    row(
        "E0501",
        "ifs c on (a, b) {\n  let m = 1/2 * a + 1/3 * b\n  transform l = self on (a, m)\n  transform r = self on (m, b)\n  germ segment(a, b)\n}\n",
        "weigh `b` by 1/2 instead of 1/3, so that the weights sum to 1",
        "1/3 * b",
        "1/2 * b",
    ),
    row(
        "E0501",
        "ifs c on (a, b) {\n  let m = (a + b) / 3\n  transform l = self on (a, m)\n  transform r = self on (m, b)\n  germ segment(a, b)\n}\n",
        "divide by 2 instead of 3, so that the weights sum to 1",
        "/ 3",
        "/ 2",
    ),
    row(
        "E0505",
        "ifs c on (a, b) {\n  let m = lerp(a, b, 1/2)\n  transform l = self on (a, m)\n  transform r = self on (a, b)\n  germ segment(a, b)\n}\nfigure h: Curve = c on ((0m, 0m), (1m, 1m)) at level 3\n",
        "let `r` start at `m` instead of `a`, with `l`",
        "r = self on (a, b)",
        "r = self on (m, b)",
    ),
    row(
        "E0507",
        "ifs c on (a, b) {\n    transform l = self on (a, lerp(a, b, 1/2))\n    transform r = self on (lerp(a, b, 1/2), b)\n}\n",
        "add `germ segment(a, b)`",
        "b, 1/2), b)\n",
        "b, 1/2), b)\n    germ segment(a, b)\n",
    ),
    row(
        "E0550",
        "figure s = bezier2 on ((0m, 0m), (0m, 1m), (1m, 1m)) until egde <= 300mm\nfabricate",
        "replace `egde` with `edge`",
        "egde",
        "edge",
    ),
    row(
        "E0601",
        "param n: Int = 9 in 1 .. 5\n",
        "set `n` to 5, the nearest in its range, instead of 9",
        "= 9",
        "= 5",
    ),
    row("E0602", "let a = [1, 2]\nlet b = a[2]\n", "take element 1 instead of 2", "a[2]", "a[1]"),
    row(
        "E0604",
        "use std.curves (bezier2)\nfigure r = bezier2 on ((0m, 0m), (0m, 1m), (1m, 1m)) at level (2, 3)\n",
        "take level 3 instead of (2, 3)",
        "(2, 3)",
        "3",
    ),
    row("E0607", "param n: Int = 3 in 5 .. 1\n", "write the smaller end first: `1 .. 5`", "5 .. 1", "1 .. 5"),
    row(
        "E0801",
        "use std.curves (bezier2)\nfigure r = bezier2 on ((0m, 0m), (0m, 1m), (1m, 1m))\n",
        "insert `at level 3`",
        "(1m, 1m))",
        "(1m, 1m)) at level 3",
    ),
    row(
        "E0803",
        "fabricate rail as planks {\n    material: sawn_spruce\n    section: 120mm by 27mm\n}\nfabricate rail as planks {\n    material: sawn_spruce\n    section: 100mm by 27mm\n}\n",
        "remove the second block of `rail`, 4 lines",
        "fabricate rail as planks {\n    material: sawn_spruce\n    section: 100mm by 27mm\n}\n",
        "",
    ),
    row(
        "E0811",
        "fabricate roof as panels {\n    material: birch_plywood(12mm)\n    board: 2500mm by 1250mm\n    require edge >= 600mm\n}\n",
        "take level 0 instead of 1 (1000mm)",
        "net) at level 1",
        "net) at level 0",
    ),
    row(
        "E0834",
        "fabricate rail as planks {\n    material: sawn_spruce\n    section: 120mm by 27mm\n    stock: 300mm\n}\n",
        "set `stock` to 455mm",
        "stock: 300mm",
        "stock: 455mm",
    ),
    row(
        "E0931",
        "fabricate roof as panels {\n    material: birch_plywood(12mm)\n    board: 2500mm by 1250mm\n    machine: router3(tool: 6mm, flute: 22mm)\n    nest: { gap: 4mm }\n}\n",
        "set `gap` to 6mm instead of 4mm",
        "gap: 4mm",
        "gap: 6mm",
    ),
    row(
        "E0933",
        "fabricate rail as planks {\n    material: sawn_spruce\n    section: 120mm by 27mm\n    nest: {}\n}\n",
        "add `stock: 4m`: the longest plank is 442mm",
        "    nest",
        "    stock: 4m\n    nest",
    ),
    row(
        "W0546",
        "ifs hinge on (a) {\n    transform same = self on (a)\n    germ segment(a, a)\n}\nifs arm on (p, q) {\n    boundary near = hinge on (p)\n    boundary far = hinge on (q)\n    transform left = self on (p, lerp(p, q, sqrt(7) / 10))\n    transform right = self on (lerp(p, q, sqrt(0.07)), q)\n    join left.far = right.near\n    germ segment(p, q)\n}\nfigure f = arm on ((0m, 0m), (1m, 1m)) at level 2\n",
        "put `right` on the very points of `left` where they join",
        "sqrt(0.07)",
        "sqrt(7) / 10",
    ),
    row(
        "W0546",
        "ifs c on (a, b) {\n    transform left = self on (a, lerp(a, b, sqrt(7) / 10))\n    transform right = self on (lerp(a, b, sqrt(0.07)), b)\n    germ segment(a, b)\n}\n",
        "let each piece of `c` start at the very point where the one before it ends",
        "sqrt(0.07)",
        "sqrt(7) / 10",
    ),
];

#[test]
fn a_fix_says_what_it_changes_and_changes_that() {
    let mut faults = Vec::new();
    for Row { code, text, title, before, after } in ROWS {
        let mut design = if text.contains("fabricate") {
            format!("{FIGURES}{}", text.trim_end_matches("fabricate"))
        } else {
            (*text).to_owned()
        };
        if text.starts_with("ifs c") && !text.contains("figure") {
            design += LINE;
        }
        let overrides = Overrides::default();
        let analysis = known(&MemoryFiles::single("a.ifs", &design), "a.ifs", &overrides);
        let found = analysis.diagnostics.iter().filter(|found| found.code.name() == *code);
        let offered: Vec<(&Diagnostic, Mend)> = found
            .flat_map(|found| mends(&analysis, found).into_iter().map(move |mend| (found, mend)))
            .collect();
        let Some((found, mend)) = offered.iter().find(|(_, mend)| mend.title == *title) else {
            let titles: Vec<&str> = offered.iter().map(|(_, mend)| mend.title.as_str()).collect();
            let said: Vec<String> = analysis
                .diagnostics
                .iter()
                .map(|found| format!("{} {}", found.code.name(), found.message))
                .collect();
            faults.push(format!("{code} `{title}` is not offered, but {titles:?}; {said:?}"));
            continue;
        };
        let mended = applied(&design, &mend.edits);
        let expected = design.replacen(before, after, 1);
        if mended != expected {
            faults.push(format!("{code} `{title}` gives\n{mended}\nnot\n{expected}"));
        }
        let again =
            |_: &str, text: String| analyse(&MemoryFiles::single("a.ifs", &text), "a.ifs", &overrides);
        faults.extend(fault(&analysis, found, mend, again).map(|fault| format!("{code} `{title}`: {fault}")));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n\n"));
}
