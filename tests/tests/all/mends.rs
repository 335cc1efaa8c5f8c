//! What a message says would mend a requirement holds where it is done, on surfaces as they are designed and planarized.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail anywhere")]

use ifs_compiler::analysis::{Analysis, analyse};
use ifs_compiler::diagnostic::{Code, Severity};
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::MemoryFiles;

/// Ways to planarize, or not.
const SETTINGS: [&str; 5] = [
    "",
    "planarize: {}",
    "planarize: { method: projection }",
    "planarize: { method: projection, pin: none }",
    "scale: 1/2 planarize: { pin: corners }",
];

/// Requirements that some of the surfaces fail.
const REQUIREMENTS: [&str; 8] = [
    "planarity >= 0.9995",
    "edge <= 300mm",
    "edge >= 420mm",
    "width >= 350mm",
    "area <= 0.1m2",
    "bevel <= 4deg",
    "angle in 80deg .. 100deg",
    "diagonal ratio <= 0.5%",
];

fn design(settings: &str, requirement: &str, level: u32) -> String {
    format!(
        "use std.curves (bspline3)\nuse std.surfaces (sheet)\nuse std.materials (birch_plywood)\n\
         param rise: Length = 1.4m in 0m .. 2m step 100mm\n\
         param wide: Length = 0.8m in 0.4m .. 1.6m step 50mm\n\
         param unused: Int = 3 in 1 .. 4\n\
         let net = [[(i * wide, j * wide, rise * sin(40deg * i) * sin(50deg * j)) for j in 0..4] for i in 0..5]\n\
         figure roof = sheet(bspline3, bspline3, net) at level {level}\n\
         fabricate roof as panels {{\n material: birch_plywood(12mm)\n board: 9m by 9m\n {settings}\n \
         require {requirement}\n}}\n"
    )
}

fn analysed(text: &str, overrides: &Overrides) -> Analysis {
    analyse(&MemoryFiles::single("design.ifs", text), "design.ifs", overrides)
}

fn fails(text: &str, code: Code) -> bool {
    let analysis = analysed(text, &Overrides::default());
    let errors = || analysis.diagnostics.iter().filter(|found| found.severity() == Severity::Error);
    assert!(errors().all(|found| found.code == code), "{:?}\n{text}", errors().collect::<Vec<_>>());
    errors().count() > 0
}

/// The designs that a sentence says hold: `it holds at level 3 (…); or …` or `it holds with rise = 1m or 2m; now …`. What
/// breaks something else is left out, and what was not planarized.
fn mended(text: &str, sentence: &str) -> Vec<String> {
    let Some(ways) = sentence.strip_prefix("it holds ") else { return Vec::new() };
    let ways = ways.split("; now it is").next().unwrap();
    if let Some((name, values)) = ways.strip_prefix("with ").and_then(|with| with.split_once(" = ")) {
        let values = values.split(" or ").filter(|value| !value.contains(' '));
        let line = text.lines().find(|line| line.starts_with(&format!("param {name}:"))).unwrap();
        let now = line.split(" = ").nth(1).unwrap().split(' ').next().unwrap();
        return values.map(|value| text.replace(line, &line.replacen(now, value, 1))).collect();
    }
    let clean =
        ways.split("; or ").filter(|way| !way.contains("but then") && !way.contains("before planarizing"));
    let put = |way: &str| {
        if let Some(level) = way.strip_prefix("at level ") {
            let level = level.split(' ').next().unwrap();
            let (before, after) = text.split_once("at level ").unwrap();
            return format!("{before}at level {level}{}", &after[1..]);
        }
        let setting = way.split('`').nth(1).expect("a level or a setting");
        match text.split_once("planarize: {") {
            None => text.replacen(" require", &format!(" {setting}\n require"), 1),
            Some((before, after)) if setting.starts_with("pin") => {
                format!("{before}planarize: {{ {setting}, {after}").replace(", }", " }")
            }
            Some((before, after)) => {
                format!("{before}planarize: {{ {setting}, {after}").replace(",  }", " }")
            }
        }
    };
    clean.map(put).collect()
}

#[test]
fn what_is_said_to_hold_holds() {
    let (mut held, mut of_planarizing) = (0, 0);
    for (settings, requirement, level) in SETTINGS
        .into_iter()
        .flat_map(|settings| REQUIREMENTS.into_iter().map(move |requirement| (settings, requirement)))
        .flat_map(|(settings, requirement)| [1, 2].map(|level| (settings, requirement, level)))
    {
        let text = design(settings, requirement, level);
        let analysis = analysed(&text, &Overrides::default());
        for failed in analysis.diagnostics.iter().filter(|found| found.severity() == Severity::Error) {
            for hint in &failed.hints {
                assert!(!hint.text.contains("unused"), "{}\n{text}", hint.text);
                for other in mended(&text, &hint.text) {
                    assert!(!fails(&other, failed.code), "{}\n{text}", hint.text);
                    held += 1;
                    of_planarizing += usize::from(hint.text.contains('`'));
                }
            }
        }
    }
    assert!(held > 60 && of_planarizing > 5, "{held} and {of_planarizing} are too few to say anything");
}
