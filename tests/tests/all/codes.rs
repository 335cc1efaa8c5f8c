//! The codes of diagnostics: each is covered by the annotated suite, or by a test named here.
#![allow(clippy::disallowed_methods, reason = "the tests read the sources")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use ifs_compiler::analysis::{Analysis, Unwatched, Verdict, analyse, run_tests};
use ifs_compiler::diagnostic::{Code, Diagnostic, Severity};
use ifs_compiler::hir::LIBRARY;
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::outputs::{Selection, outputs, workshop_faults};
use ifs_compiler::source::{Files, MemoryFiles, ReadError};
use ifs_compiler::syntax::limits::MAX_BYTES;
use ifs_tests::pages::{Block, blocks};
use ifs_tests::{root, sources, suite};

/// Codes that no text alone can bring about, each with the test that does.
const ELSEWHERE: &[(&str, &str)] = &[
    ("E0101", "bytes_that_are_no_text"),
    ("E0108", "a_file_beyond_the_limit"),
    ("E0312", "every_use_of_a_missing_file_is_said_and_a_limit_once"),
    ("E0313", "a_text_that_is_no_toml"),
    ("E0314", "an_unknown_key_stands_where_it_is_written"),
    ("E0315", "a_value_that_cannot_be_used"),
    ("W0316", "what_a_project_sets_loses_against_what_is_nearer"),
    ("E0605", "a_parameter_the_design_does_not_have"),
    ("E0606", "a_text_that_is_no_value"),
    ("E0807", "a_design_without_figures_is_not_built"),
    ("E0860", "a_machine_of_a_file_takes_the_place_of_the_designs"),
    ("E0861", "a_machine_of_a_file_takes_the_place_of_the_designs"),
    ("E0862", "a_machine_of_a_file_takes_the_place_of_the_designs"),
    ("E0902", "a_program_that_its_read_back_refuses"),
    ("E0934", "a_nest_that_its_check_refuses"),
    ("E0935", "a_sheet_that_the_machine_cannot_cut"),
    ("E0936", "a_sheet_that_its_read_back_refuses"),
];

#[test]
fn every_code_is_covered() {
    let table: Vec<&str> = Code::ALL.iter().map(|code| code.name()).collect();
    let covered = suite::covered(&root().join("tests/suite")).unwrap();
    let read = |path: &str| fs::read_to_string(root().join(path)).unwrap();
    // A program that does not cut its board is a fault of the compiler: its test stands beside the making of programs.
    let beside = [
        "compiler/src/outputs/programs.rs",
        "compiler/src/outputs/nests.rs",
        "compiler/src/outputs/sheet_programs.rs",
        "compiler/src/analysis/load/tests.rs",
        "compiler/src/analysis/project.rs",
        "tests/tests/all/projects.rs",
    ];
    let tests = beside.iter().fold(read("tests/tests/all/codes.rs"), |tests, path| tests + &read(path));
    let faults = suite::faults_of_coverage(&table, &covered, ELSEWHERE, &tests);
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The analysis of one design with parameters set.
fn analysed(bytes: &[u8], settings: &[(&str, &str)]) -> Analysis {
    analyse(&MemoryFiles::default().with("design.ifs", bytes), "design.ifs", &overrides(settings))
}

fn overrides(settings: &[(&str, &str)]) -> Overrides {
    let parameters = settings.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned()));
    Overrides { parameters: parameters.collect::<BTreeMap<_, _>>(), ..Overrides::default() }
}

/// What the tests of a design find.
fn tested(analysis: &Analysis) -> Vec<Diagnostic> {
    let results = run_tests(analysis, &Overrides::default());
    assert!(results.iter().all(|test| (test.verdict == Verdict::Fails) != test.diagnostics.is_empty()));
    results.into_iter().flat_map(|result| result.diagnostics).collect()
}

/// The only diagnostic of an analysis.
fn only(analysis: &Analysis) -> &Diagnostic {
    let found: Vec<&str> = analysis.diagnostics.iter().map(|found| found.message.as_str()).collect();
    assert_eq!(found.len(), 1, "{found:?}");
    &analysis.diagnostics[0]
}

#[test]
fn bytes_that_are_no_text() {
    let analysis = analysed(b"let width = 27mm\nlet name = \"F\xfcrst\"\n", &[]);
    let found = only(&analysis);
    assert_eq!((found.code, found.span.start), (Code::E0101, 30));
    assert!(found.message.contains("0xfc"), "{}", found.message);
}

#[test]
fn a_file_beyond_the_limit() {
    let analysis = analysed(&vec![b' '; MAX_BYTES + 1], &[]);
    assert_eq!(only(&analysis).code, Code::E0108);
}

/// A folder whose every file is refused.
struct Refused;

impl Files for Refused {
    fn read(&self, _: &str) -> Result<Vec<u8>, ReadError> {
        Err(ReadError::Other("permission denied".to_owned()))
    }
}

#[test]
fn a_file_that_cannot_be_read() {
    let missing = analyse(&MemoryFiles::default(), "vault.ifs", &Overrides::default());
    assert_eq!(only(&missing).code, Code::E0306);
    assert!(only(&missing).message.contains("`vault.ifs`"));
    let refused = analyse(&Refused, "vault.ifs", &Overrides::default());
    assert!(only(&refused).message.ends_with("permission denied"));
}

#[test]
fn a_parameter_the_design_does_not_have() {
    let text = b"param span: Length = 6m in 4m .. 9m\nlet half = span / 2\n";
    let analysis = analysed(text, &[("spam", "7m")]);
    let found = only(&analysis);
    assert_eq!(found.code, Code::E0605);
    assert!(found.hints.iter().any(|hint| hint.text.contains("`span`")), "{:?}", found.hints);

    // That of a file it uses keeps its default.
    let files = MemoryFiles::single("design.ifs", "use \"./parts/sizes.ifs\" (span)\nlet half = span / 2\n")
        .with("parts/sizes.ifs", "pub param span: Length = 6m\n");
    let parameters = BTreeMap::from([("span".to_owned(), "7m".to_owned())]);
    let overrides = Overrides { parameters, ..Overrides::default() };
    let analysis = analyse(&files, "design.ifs", &overrides);
    let found = only(&analysis);
    assert_eq!(found.code, Code::E0605);
    assert!(found.notes[0].contains("`parts/sizes.ifs`") && found.notes[0].contains("keeps its default"));
}

#[test]
fn a_text_that_is_no_value() {
    let text = b"param span: Length = 6m in 4m .. 9m\nlet half = span / 2\n";
    for value in ["7", "7deg", "wide", "-", ""] {
        let analysis = analysed(text, &[("span", value)]);
        let found = only(&analysis);
        assert_eq!(found.code, Code::E0606, "{value}");
        assert!(found.hints.iter().any(|hint| hint.text.contains("--set span=")), "{:?}", found.hints);
    }
    // An example is a value in the range; a number without a unit gets one that puts it there.
    let text = b"param span: Length = 2m in 1m .. 4m\nparam lean: Angle = 15deg in 10deg .. 20deg\n\
                 param count: Int = 7 in 5 .. 9\nparam share: Number = 1/3 in 1/3 .. 3/4\n\
                 param wide: Bool = true\nlet half = span / 2\n";
    for (name, value, example) in [
        ("span", "3", "3m"),
        ("span", "300", "300cm"),
        ("span", "9", "2000mm"),
        ("span", "3kg", "2000mm"),
        ("lean", "12", "12deg"),
        ("count", "3.5", "7"),
        ("share", "many", "0.75"),
        ("wide", "yes", "true"),
    ] {
        let analysis = analysed(text, &[(name, value)]);
        let all = analysis.diagnostics.iter().filter(|found| found.code == Code::E0606);
        let hints: Vec<&str> = all.flat_map(|found| &found.hints).map(|hint| hint.text.as_str()).collect();
        assert_eq!(hints, [format!("write it like `--set {name}={example}`")], "{name}={value}");
        let set = analysed(text, &[(name, example)]);
        assert!(!set.diagnostics.iter().any(|found| matches!(found.code, Code::E0606 | Code::E0601)));
    }
    let text = b"param span: Length = 6m in 4m .. 9m\nlet half = span / 2\n";
    assert!(analysed(text, &[("span", "7m")]).diagnostics.is_empty());
    // What is set is not worked out, which is said.
    let analysis = analysed(text, &[("span", "6m+200mm")]);
    assert!(only(&analysis).notes[0].contains("not worked out"), "{:?}", only(&analysis).notes);
}

/// A long chain of values is worked out where each stands before those that need it; the other way round it is too deep,
/// which is said as it is.
#[test]
fn a_chain_of_values_that_wait_for_each_other() {
    let mut chain: Vec<String> = (0..6000).map(|i| format!("let a{i} = a{} + 1\n", i + 1)).collect();
    chain.push("let a6000 = 1\n".to_owned());
    let analysis = analysed(chain.concat().as_bytes(), &[]);
    let found = only(&analysis);
    assert_eq!(found.code, Code::E0703);
    assert!(found.message.contains("wait for each other"), "{}", found.message);
    assert!(found.hints.iter().any(|hint| hint.text.contains("before")), "{:?}", found.hints);
    chain.reverse();
    let analysis = analysed(chain.concat().as_bytes(), &[]);
    assert!(analysis.diagnostics.is_empty(), "{:?}", said("", &analysis));
}

/// A flute of 8mm does not reach through a board of 12mm.
#[test]
fn a_board_that_the_machine_cannot_cut() {
    let text = r#"
        use std.curves (bspline3)
        use std.surfaces (sheet)
        use std.materials (birch_plywood)
        use std.machines (router3)

        let net = [[(i * 1m, j * 1m, 0m) for j in 0..5] for i in 0..5]
        figure roof = sheet(bspline3, bspline3, net) at level 1

        fabricate roof as panels {
            material: birch_plywood(12mm)
            board: 2500mm by 1250mm
            machine: router3(tool: 6mm, flute: 8mm)
        }
    "#;
    let analysis = analysed(text.as_bytes(), &[]);
    assert!(analysis.diagnostics.is_empty(), "{:?}", said("", &analysis));
    let made = outputs(&analysis, &Selection::all());
    assert_eq!(made.diagnostics.len(), 1, "{:?}", made.diagnostics);
    let found = &made.diagnostics[0];
    assert_eq!(found.code, Code::E0901);
    let place = found.span.range();
    assert_eq!(&text[place], "router3(tool: 6mm, flute: 8mm)");
    assert!(found.message.contains("roof-00-00"), "{}", found.message);
    // What is offered lets it be cut, whether the block gives the argument or leaves it out.
    let mended = |text: &str, title: &str| {
        let analysis = analysed(text.as_bytes(), &[]);
        let made = outputs(&analysis, &Selection::all());
        let refused = made.diagnostics.iter().find(|found| found.code == Code::E0901);
        let Some(found) = refused else { panic!("{text}\n{:?}", said("", &analysis)) };
        let fixes: Vec<_> = found.fixes().collect();
        let [fix] = fixes.as_slice() else { panic!("{fixes:?}, {found:?}") };
        assert_eq!(fix.title(&analysis.sources), title);
        let mut text = text.to_owned();
        for edit in &fix.edits {
            text.replace_range(edit.span.range(), &edit.replacement);
        }
        let made = outputs(&analysed(text.as_bytes(), &[]), &Selection::all());
        assert!(made.diagnostics.is_empty(), "{text}\n{:?}", made.diagnostics);
        text
    };
    let new = mended(text, "take a cutter with flutes of 13mm instead of 8mm");
    assert!(new.contains("router3(tool: 6mm, flute: 13mm)"), "{new}");
    let thick = text.replace("flute: 8mm", "step_down: 3mm").replace("router3", "desktop_router");
    let thick = thick.replace("tool: 6mm, step_down: 3mm", "").replace("12mm", "18mm");
    // A desktop router is too small for the boards: a model of them.
    let thick = thick.replace("machine:", "scale: 1/4\n            machine:");
    let new = mended(&thick, "take a cutter with flutes of 19mm instead of 15mm");
    assert!(new.contains("desktop_router(flute: 19mm)"), "{new}");
    let tabs = text.replace("flute: 8mm)", "flute: 22mm)\n            fixing: tabs(12, width: 200mm)");
    let new = mended(
        &tabs.replace("std.machines (router3", "std.machines (router3, tabs"),
        "hold each board by 8 tabs instead of 12",
    );
    assert!(new.contains("tabs(8, width: 200mm)"), "{new}");
    let skin = text.replace("flute: 8mm)", "flute: 22mm)\n            fixing: onion_skin(7mm)");
    let skin = skin.replace("std.machines (router3", "std.machines (router3, onion_skin");
    let new = mended(&skin, "leave a skin of 6mm instead of 7mm");
    assert!(new.contains("onion_skin(6mm)"), "{new}");
}

#[test]
fn a_sheet_that_the_machine_cannot_cut() {
    let text = |programs: &str| {
        format!(
            "use std.curves (bspline3)
            use std.surfaces (sheet)
            use std.materials (birch_plywood)
            use std.machines (router3)

            let net = [[(i * 1m, j * 1m, 0m) for j in 0..5] for i in 0..5]
            figure roof = sheet(bspline3, bspline3, net) at level 1

            fabricate roof as panels {{
                material: birch_plywood(12mm)
                board: 2500mm by 1250mm
                machine: router3(tool: 6mm, length: 2m)
                nest: {{ gap: 8mm, programs: {programs} }}
            }}"
        )
    };
    let made = |programs: &str| {
        let analysis = analysed(text(programs).as_bytes(), &[]);
        assert!(analysis.diagnostics.is_empty(), "{:?}", said("", &analysis));
        outputs(&analysis, &Selection::all())
    };
    let refused = made("both");
    assert_eq!(refused.diagnostics.len(), 1, "{:?}", refused.diagnostics);
    let found = &refused.diagnostics[0];
    assert_eq!(found.code, Code::E0935);
    assert!(text("both")[found.span.range()].starts_with("{ gap: 8mm"));
    assert!(found.message.starts_with("sheet 1 gets no program: roof-"), "{}", found.message);
    assert!(found.message.contains("of travel in x, the machine has 2000.000 mm"), "{}", found.message);
    let paths = |made: &ifs_compiler::outputs::Outputs| -> Vec<String> {
        made.files.iter().map(|file| file.path.clone()).filter(|path| path.ends_with(".nc")).collect()
    };
    let boards = made("boards");
    assert!(boards.diagnostics.is_empty());
    assert!(!paths(&boards).is_empty() && paths(&boards).iter().all(|path| path.starts_with("boards/")));
}

#[test]
fn every_fault_of_a_machine_is_told_once_in_the_units_it_is_written_in() {
    let text = r#"
        use std.curves (bezier2)
        use std.materials (sawn_spruce)
        use std.machines (Machine, Tool)
        let cutter = Tool(
            number: 1, name: "cutter", diameter: 6mm, flute: 40mm,
            feed: 3m/min, plunge: 1000m/min, spindle: 200000rpm, step_down: 5mm,
        )
        let engraver = Tool(
            number: 2, name: "engraver", diameter: 1mm, flute: 5mm,
            feed: 1m/min, plunge: 0.5m/min, spindle: 16000rpm, step_down: 0.5mm,
        )
        let spare = Tool(
            number: 3, name: "spare", diameter: 0mm, flute: 40mm,
            feed: 3m/min, plunge: 1m/min, spindle: 16000rpm, step_down: 5mm,
        )
        let own = Machine(
            name: "workshop", length: 2600mm, width: 1300mm, height: 150mm, work_offset: 60,
            cutter: cutter, engraver: engraver, spare_cutters: [spare],
        )
        figure rail = bezier2 on ((0m, 0m), (0m, 1m), (1m, 1m)) at level 1
        fabricate rail as planks { material: sawn_spruce section: 120mm by 27mm machine: own }
    "#;
    let analysis = analysed(text.as_bytes(), &[]);
    assert!(analysis.diagnostics.is_empty(), "{:?}", said("", &analysis));
    let made = outputs(&analysis, &Selection::all());
    let [found] = &made.diagnostics[..] else { panic!("{:?}", made.diagnostics) };
    assert_eq!(found.code, Code::E0804);
    assert_eq!(found.message, "this machine cannot work: work offset is 60, must be from 54 to 59");
    let others = [
        "plunge feed of tool 1 is 1000m/min, must be from 0.0006m/min to 600m/min",
        "spindle speed of tool 1 is 200000rpm, must be from 1000rpm to 24000rpm",
        "diameter of tool 3 is 0mm, must be from 0.1mm to 200mm",
    ];
    assert_eq!(found.notes, others);
}

#[test]
fn a_design_without_figures_is_not_built() {
    for text in ["", "// nothing yet\n", "let width = 27mm\n"] {
        let analysis = analysed(text.as_bytes(), &[]);
        assert!(analysis.diagnostics.is_empty(), "{:?}", said("", &analysis));
        let made = outputs(&analysis, &Selection::all());
        assert!(made.files.is_empty());
        let codes: Vec<Code> = made.diagnostics.iter().map(|found| found.code).collect();
        assert_eq!(codes, [Code::E0807]);
    }
}

#[test]
fn a_design_whose_figures_are_empty_lists_is_told_so() {
    let text = "use std.curves (line)\n\
                param n: Int = 0 in 0 .. 4\n\
                figure u = [line on ((0m, 0m), (1m, i * 1m)) at level 1 for i in 0..n]\n\
                figure v = [line on ((0m, 0m), (1m, i * 1m)) at level 1 for i in 0..n]\n";
    let analysis = analysed(text.as_bytes(), &[]);
    assert!(analysis.diagnostics.is_empty(), "{:?}", said("", &analysis));
    let made = outputs(&analysis, &Selection::all());
    let [found] = &made.diagnostics[..] else { panic!("{:?}", made.diagnostics) };
    assert_eq!(found.code, Code::E0807);
    assert_eq!(found.message, "there is nothing to build: `u` is an empty list of figures");
    assert_eq!(&text[found.span.range()], "u");
    assert_eq!(found.labels.len(), 1, "{found:?}");
}

/// What is wrong in a design, each with its place.
fn said(name: &str, analysis: &Analysis) -> Vec<String> {
    let found = analysis.diagnostics.iter();
    found
        .map(|found| format!("{name} at byte {}: {} {}", found.span.start, found.code.name(), found.message))
        .collect()
}

#[test]
fn every_example_is_without_fault() {
    let examples = sources::files(&root().join("examples"), "ifs");
    assert!(examples.len() > 1);
    for path in examples {
        let mut analysis = analysed(&fs::read(&path).unwrap(), &[]);
        assert!(!analysis.hir.tests.is_empty(), "{} has no test", path.display());
        analysis.diagnostics.extend(tested(&analysis));
        let said = said(&path.display().to_string(), &analysis);
        assert!(said.is_empty(), "{}", said.join("\n"));
    }
}

/// Each module of the library as a design of its own: all of it is checked, also what no design uses.
#[test]
fn every_module_of_the_library_is_without_fault() {
    for (name, text) in LIBRARY {
        let analysis = analysed(text.as_bytes(), &[]);
        let said = said(name, &analysis);
        assert!(said.is_empty(), "{}", said.join("\n"));
    }
}

/// The mesh that the pages import.
const JOINT: &[u8] = include_bytes!("../../suite/meshes/joint.glb");

/// The pages of documentation with their paths.
fn pages() -> Vec<(String, String)> {
    let mut paths = sources::files(&root().join("docs"), "md");
    paths.push(root().join("README.md"));
    let read = |path: &PathBuf| fs::read_to_string(path).unwrap();
    let name = |path: &PathBuf| path.strip_prefix(root()).unwrap().display().to_string();
    paths.iter().map(|path| (name(path), read(path))).collect()
}

/// What a page shows as wrong has the page's code; all else can be used as it stands.
#[test]
fn the_designs_in_the_documentation_mean_what_it_says() {
    let mut faults = Vec::new();
    let mut seen = 0;
    for (path, page) in pages() {
        let code = path.rsplit('/').next().and_then(|name| Code::parse(name.split('.').next()?));
        let mut files = MemoryFiles::default().with("joint.glb", JOINT);
        for block in blocks(&page).into_iter().filter(Block::is_design) {
            seen += 1;
            let name = block.file.as_deref().unwrap_or("design.ifs");
            let settings = overrides(&block.settings());
            let mut analysis = analyse(&files.clone().with(name, block.whole.as_bytes()), name, &settings);
            analysis.diagnostics.extend(tested(&analysis));
            let in_the_workshop = workshop_faults(&analysis, &mut Unwatched);
            analysis.diagnostics.extend(in_the_workshop);
            // That irrational coefficients are rounded is said wherever it is so, in the library's examples too.
            analysis.diagnostics.retain(|found| path != "docs/library.md" || found.code != Code::W0546);
            if !block.has("wrong") {
                files = files.with(name, block.whole.as_bytes());
            }
            faults.extend(fault_of_block(&format!("{path}:{}", block.line), &block, code, analysis));
        }
    }
    assert!(seen > 50, "only {seen} designs are shown");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

fn fault_of_block(place: &str, block: &Block, code: Option<Code>, mut analysis: Analysis) -> Vec<String> {
    // A block that names files that are shown nowhere shows only that.
    if block.has("files") {
        analysis.diagnostics.retain(|found| !matches!(found.code, Code::E0001 | Code::E0306));
        if analysis.diagnostics.is_empty() {
            return Vec::new();
        }
    }
    let errors = analysis.diagnostics.iter().filter(|found| found.code.severity() == Severity::Error);
    match (block.has("wrong"), code) {
        (true, Some(code)) if !analysis.diagnostics.iter().any(|found| found.code == code) => {
            vec![format!("{place} is to show {}: {:?}", code.name(), said("", &analysis))]
        }
        (true, None) if errors.count() == 0 => vec![format!("{place} shows no error")],
        (false, _) => said(place, &analysis),
        _ => Vec::new(),
    }
}
