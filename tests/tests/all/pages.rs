//! The tutorial and the reference against the program: what a terminal shows is what the program prints, and nothing that
//! the tables of the compiler know is missing. `UPDATE=1` writes the terminals and the sections out of tables anew.
#![allow(clippy::disallowed_methods, reason = "the tests read and write the pages")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail anywhere")]

use std::fs;
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};

use ifs_compiler::diagnostic::Code;
use ifs_compiler::hir::dimension::Dimension;
use ifs_compiler::hir::library_docs;
use ifs_compiler::hir::native::natives;
use ifs_compiler::hir::schema::{ChoiceKind, Measure, SchemaKind};
use ifs_compiler::syntax::ast::Unit;
use ifs_tests::layout::Read;
use ifs_tests::outcome::run;
use ifs_tests::pages::{Block, blocks, runs, shows, with_block, with_section};
use ifs_tests::{program, root, scratch};

const TUTORIAL: &str = "docs/tutorial.md";
const REFERENCE: &str = "docs/language.md";

/// Held by a test while it reads pages and writes them anew.
static PAGES: Mutex<()> = Mutex::new(());

fn hold() -> MutexGuard<'static, ()> {
    PAGES.lock().unwrap_or_else(PoisonError::into_inner)
}

fn read(page: &str) -> String {
    fs::read_to_string(root().join(page)).unwrap()
}

fn updates() -> bool {
    std::env::var_os("UPDATE").is_some()
}

/// What the program prints in a folder, messages before data.
fn printed(folder: &Path, command: &str) -> String {
    let mut words = command.split_whitespace();
    assert_eq!(words.next(), Some("ifs"), "a terminal of the pages runs only `ifs`: {command}");
    let done = run(program().current_dir(folder).args(words));
    format!("{}{}", done.stderr, done.stdout)
}

/// The terminals of a page that do not show what is printed, each with what should stand there.
fn stale(page: &str, blocks: &[Block]) -> Vec<(Block, String)> {
    let folder = scratch(&page.replace('/', "-"));
    let mut stale = Vec::new();
    for block in blocks {
        if let (true, Some(file)) = (block.is_design(), &block.file) {
            let path = folder.join(file);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, &block.whole).unwrap();
        }
        if !block.has("console") {
            continue;
        }
        let mut now = String::new();
        let mut fits = true;
        for run in runs(&block.text) {
            let printed = printed(&folder, &run.command);
            let shown = shows(&run.printed, &printed);
            fits &= shown;
            // What stands for any lines is chosen by hand, and stays.
            let dots = run.printed.lines().any(|line| line == "…");
            let text = if shown || dots { &run.printed } else { &printed };
            now += &format!("$ {}\n{}", run.command, text);
            if !shown && (dots || !updates()) {
                eprintln!("{page}:{} {} prints\n{printed}", block.line, run.command);
            }
        }
        if !fits {
            let lines = now.lines().map(|line| format!("{}\n", line.trim_end()));
            stale.push((block.clone(), lines.collect::<String>().trim_end().to_owned() + "\n"));
        }
    }
    stale
}

#[test]
fn the_terminals_of_the_pages_show_what_is_printed() {
    let _held = hold();
    let mut faults = Vec::new();
    let mut seen = 0;
    for page in [TUTORIAL, REFERENCE] {
        let mut text = read(page);
        let blocks = blocks(&text);
        seen += blocks
            .iter()
            .filter(|block| block.has("console"))
            .map(|block| runs(&block.text).len())
            .sum::<usize>();
        // From the end, so that the lines of those before stay what they are.
        for (block, now) in stale(page, &blocks).into_iter().rev() {
            faults.push(format!("{page}:{} shows what is not printed", block.line));
            text = with_block(&text, &block, &now);
        }
        if updates() {
            fs::write(root().join(page), text).unwrap();
        }
    }
    assert!(seen > 10, "only {seen} commands are shown");
    assert!(faults.is_empty(), "{}\nUPDATE=1 writes them anew", faults.join("\n"));
}

#[test]
fn the_designs_of_the_pages_are_laid_out() {
    let _held = hold();
    let mut faults = Vec::new();
    for page in [TUTORIAL, REFERENCE] {
        let mut text = read(page);
        let designs = blocks(&text).into_iter().filter(|block| block.is_design() && !block.has("loose"));
        for block in designs.rev() {
            let Some(now) = Read::new(&block.text).formatted().filter(|now| *now != block.text) else {
                continue;
            };
            faults.push(format!("{page}:{} is not as `ifs fmt` lays it out", block.line));
            text = with_block(&text, &block, &now);
        }
        if updates() {
            fs::write(root().join(page), text).unwrap();
        }
    }
    assert!(faults.is_empty(), "{}\nUPDATE=1 writes them anew", faults.join("\n"));
}

/// A table of Markdown.
fn table(heads: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let heads: Vec<String> = heads.iter().map(|&head| head.to_owned()).collect();
    let rule = format!("|{}\n", "---|".repeat(heads.len()));
    rows.fold(line(&heads) + &rule, |table, row| table + &line(&row))
}

fn functions() -> String {
    let rows = natives().map(|native| {
        let parameters = native.parameters.iter().map(|parameter| {
            let mark = if parameter.required { "" } else { "?" };
            format!("{}{mark}", parameter.name)
        });
        let call = format!("`{}({})`", native.name, parameters.collect::<Vec<_>>().join(", "));
        let module =
            if native.module == "prelude" { String::new() } else { format!("`std.{}`", native.module) };
        vec![call, native.doc.to_owned(), module]
    });
    table(&["function", "what it gives", "from"], rows)
}

/// The modules of the library and what they offer.
fn library() -> String {
    let rows = library_docs().into_iter().map(|module| {
        let items: Vec<String> = module.items.iter().map(|item| format!("`{}`", item.name)).collect();
        vec![format!("`{}`", module.path()), module.summary(), items.join(" ")]
    });
    table(&["module", "what", "its items"], rows)
}

fn diagnostics() -> String {
    let rows = Code::ALL.iter().map(|code| {
        let name = code.name();
        vec![format!("[{name}](diagnostics/{name}.md)"), code.title().to_owned()]
    });
    table(&["code", "what it says"], rows)
}

#[test]
fn the_sections_out_of_tables_are_up_to_date() {
    let _held = hold();
    let before = read(REFERENCE);
    let mut page = before.clone();
    for (name, text) in [("functions", functions()), ("library", library()), ("diagnostics", diagnostics())] {
        page =
            with_section(&page, name, &text).unwrap_or_else(|| panic!("{REFERENCE} has no section {name}"));
    }
    if updates() {
        fs::write(root().join(REFERENCE), &page).unwrap();
    }
    assert!(page == before, "{REFERENCE} is behind the tables of the compiler: UPDATE=1 writes it anew");
}

/// The words of the language that stand in the tables of the compiler, each as the reference writes it.
fn words() -> Vec<String> {
    let units = Unit::ALL.iter().map(|unit| unit.suffix().to_owned());
    let dimensions = Dimension::names().map(str::to_owned);
    let measures = Measure::ALL.iter().map(|measure| measure.words().to_owned());
    let blocks =
        [SchemaKind::Panels, SchemaKind::Planks, SchemaKind::Planarize, SchemaKind::Sheets, SchemaKind::Bars];
    let settings = blocks.into_iter().flat_map(SchemaKind::settings);
    let settings = settings.map(|setting| setting.name.to_owned());
    let choices = [ChoiceKind::Side, ChoiceKind::Grain, ChoiceKind::Edges, ChoiceKind::Ends, ChoiceKind::Pin];
    let choices =
        choices.into_iter().flat_map(|choice| choice.words().iter().map(|word| word.name.to_owned()));
    units.chain(dimensions).chain(measures).chain(settings).chain(choices).collect()
}

#[test]
fn the_reference_names_every_word_of_the_language() {
    let _held = hold();
    let page = read(REFERENCE);
    let words = words();
    assert!(words.len() > 50);
    let missing: Vec<&String> = words.iter().filter(|word| !page.contains(&format!("`{word}`"))).collect();
    assert!(missing.is_empty(), "{REFERENCE} does not say {missing:?}");
    for keyword in ["use", "pub", "param", "let", "fn", "record", "ifs", "figure", "fabricate", "test"] {
        assert!(page.contains(&format!("`{keyword}`")), "{keyword}");
    }
}
