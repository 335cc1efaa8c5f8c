//! The grammars of `editors/` are held to the compiler's parser: tree-sitter's finds the same files sound, and both know
//! the same words.
#![allow(clippy::disallowed_methods, reason = "the tests read files and run programs")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use ifs_compiler::diagnostic::Code;
use ifs_compiler::source::SourceMap;
use ifs_compiler::syntax::{TokenKind, parse};
use ifs_tests::referees::{colours, python_referee};
use ifs_tests::{root, sources};

/// What the compiler's parser says that is not about how a text is put together: sizes, depth, characters in comments,
/// where the file is documented, the case of names, the list of measures.
const BESIDE_GRAMMAR: &[Code] =
    &[Code::E0104, Code::E0106, Code::E0107, Code::E0108, Code::E0204, Code::E0205, Code::E0206];

fn grammar() -> PathBuf {
    root().join("editors/tree-sitter-ifs")
}

fn library() -> PathBuf {
    let library = root().join("target/tmp/tree-sitter-ifs.so");
    fs::create_dir_all(library.parent().unwrap()).unwrap();
    let source = grammar().join("src");
    let built = Command::new("cc")
        .args([
            "-shared",
            "-fPIC",
            "-O1",
            "-Wall",
            "-Wextra",
            "-Werror",
            "-Wno-unused-but-set-variable",
            "-I",
        ])
        .arg(&source)
        .args([source.join("parser.c"), source.join("scanner.c")])
        .arg("-o")
        .arg(&library)
        .status()
        .unwrap();
    assert!(built.success(), "the grammar compiles without warnings");
    library
}

/// Whether the compiler finds the text well put together; nothing where only what is beside the grammar is wrong.
fn sound(path: &Path) -> Option<bool> {
    let text = fs::read_to_string(path).ok()?;
    let mut map = SourceMap::default();
    let id = map.add("a.ifs", &text);
    let said = parse(map.get(id).unwrap()).diagnostics;
    let beside = said.iter().filter(|said| BESIDE_GRAMMAR.contains(&said.code)).count();
    match said.len() {
        0 => Some(true),
        all if all == beside => None,
        _ => Some(false),
    }
}

#[test]
fn the_grammar_and_the_compiler_find_the_same_files_sound() {
    let mut files = Vec::new();
    for part in ["examples", "stdlib", "tests", "compiler", "docs"] {
        files.extend(sources::files(&root().join(part), "ifs"));
    }
    let judged: Vec<(PathBuf, bool)> =
        files.into_iter().filter_map(|path| sound(&path).map(|sound| (path, sound))).collect();
    let queries = root().join("editors");
    let library = library();
    let mut arguments: Vec<&Path> = vec![&library, &queries];
    arguments.extend(judged.iter().map(|(path, _)| path.as_path()));
    let verdict = python_referee("grammar.py", &arguments);
    assert!(verdict.good, "{}", verdict.faults);
    let wrong: BTreeSet<&str> =
        verdict.counts["wrong"].as_array().unwrap().iter().map(|path| path.as_str().unwrap()).collect();
    let faults: Vec<String> = judged
        .iter()
        .filter(|(path, sound)| wrong.contains(path.to_str().unwrap()) == *sound)
        .map(|(path, sound)| {
            let who = if *sound { "only the grammar refuses" } else { "only the compiler refuses" };
            format!("{who} {}", path.display())
        })
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    let refused = judged.iter().filter(|(_, sound)| !sound).count();
    assert!(refused >= 10 && judged.len() >= 300, "{refused} of {} refused", judged.len());
    for query in [
        "tree-sitter-ifs/queries/highlights.scm",
        "tree-sitter-ifs/queries/folds.scm",
        "tree-sitter-ifs/queries/indents.scm",
        "tree-sitter-ifs/queries/locals.scm",
        "helix/queries/highlights.scm",
        "helix/queries/indents.scm",
        "helix/queries/textobjects.scm",
        "zed/languages/ifs/highlights.scm",
        "zed/languages/ifs/brackets.scm",
        "zed/languages/ifs/indents.scm",
        "zed/languages/ifs/outline.scm",
    ] {
        assert!(verdict.counts["captures"][query].as_u64().unwrap() > 1000, "{query} finds next to nothing");
    }
}

/// The words in quotes of a file, outside its comments and among them.
fn quoted(text: &str) -> BTreeSet<&str> {
    text.lines().flat_map(|line| line.split('"').skip(1).step_by(2)).collect()
}

#[test]
fn the_words_of_the_grammar_are_those_of_the_language() {
    let words: BTreeSet<&str> = TokenKind::keywords().filter_map(TokenKind::text).collect();
    let scanner = fs::read_to_string(grammar().join("src/scanner.c")).unwrap();
    let table = |name: &str| {
        let start = scanner.find(&format!("{name}[] = {{")).unwrap();
        quoted(scanner[start..].split("};").next().unwrap())
    };
    assert_eq!(table("RESERVED"), words);
    let units: BTreeSet<&str> =
        ifs_compiler::syntax::ast::Unit::ALL.iter().map(|unit| unit.suffix()).collect();
    assert_eq!(table("UNITS"), units);
    for coloured in [
        "tree-sitter-ifs/queries/highlights.scm",
        "helix/queries/highlights.scm",
        "zed/languages/ifs/highlights.scm",
        "emacs/ifs-mode.el",
    ] {
        let text = fs::read_to_string(root().join("editors").join(coloured)).unwrap();
        let missing: Vec<&str> = words.difference(&quoted(&text)).copied().collect();
        assert!(missing.is_empty(), "{coloured} has no colour for {missing:?}");
    }
}

#[test]
fn no_reserved_word_is_without_colour_in_vs_code() {
    let words: Vec<&str> = TokenKind::keywords().filter_map(TokenKind::text).collect();
    let mut files = Vec::new();
    for part in ["examples", "stdlib", "tests/suite", "docs"] {
        files.extend(sources::files(&root().join(part), "ifs"));
    }
    let verdict = colours(&words, &files);
    assert!(verdict.good, "{}", verdict.counts["uncoloured"]);
    let found = verdict.counts["words"].as_u64().unwrap();
    assert!(found > 2000, "only {found} reserved words in {} files", files.len());
}
