//! What editors show beside the text, as clients of both kinds see it: lenses for those that have commands and those that
//! have none, hints and tokens in either count of columns, in designs of boards and of planks and in the library's files.
#![allow(clippy::disallowed_methods, reason = "the tests write projects")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail anywhere")]

use std::fs;

use ifs_tests::client::{Client, uri};
use ifs_tests::{program_path, scratch};
use serde_json::{Value, json};

const ROOF: &str = "\
use std.curves (bspline2)
use std.materials (birch_plywood)
use std.surfaces (sheet)
let net = [[(i * 1m, j * 1m, 10mm * i * j) for j in 0..4] for i in 0..4]
figure roof = sheet(bspline2, bspline2, net) at level 1
fabricate roof as panels { material: birch_plywood(12mm) board: 2500mm by 1250mm }
figure wall = sheet(bspline2, bspline2, net) at level 0
fabricate wall as panels { material: birch_plywood(12mm) board: 2500mm by 1250mm }
";

/// A client that has these commands, with the design worked out.
fn worked_out(test: &str, options: &Value, encoding: &str, text: &str) -> (Client, String) {
    let folder = scratch(test);
    let path = folder.join("house.ifs");
    fs::write(&path, text).unwrap();
    let mut client = Client::start(program_path(false));
    let editor = json!({
        "general": { "positionEncodings": [encoding] },
        "workspace": { "codeLens": { "refreshSupport": true }, "inlayHint": { "refreshSupport": true } },
    });
    let capabilities = client.initialize_with(&editor, &[&folder], options);
    assert_eq!(capabilities["positionEncoding"], encoding);
    let uri = uri(&path);
    client.open(&uri, text);
    client.wait("what was worked out", |message| message["method"] == "workspace/codeLens/refresh");
    (client, uri)
}

/// The line, the title and the command of each lens.
fn lenses(client: &mut Client, uri: &str) -> Vec<(u64, String, String, Value)> {
    let found = client.request("textDocument/codeLens", json!({ "textDocument": { "uri": uri } })).unwrap();
    let lenses = found.as_array().unwrap().iter().map(|lens| {
        let words = |name: &str| lens["command"][name].as_str().unwrap().to_owned();
        let line = lens["range"]["start"]["line"].as_u64().unwrap();
        (line, words("title"), words("command"), lens["command"]["arguments"].clone())
    });
    lenses.collect()
}

#[test]
fn commands_are_offered_to_those_who_have_them() {
    let all = json!({ "commands": ["ifs.build", "ifs.showReport", "ifs.preview"] });
    let (mut client, uri) = worked_out("lsp_lenses_all", &all, "utf-16", ROOF);
    let found = lenses(&mut client, &uri);
    let commands: Vec<(u64, &str, &str)> = found
        .iter()
        .filter(|(_, _, command, _)| !command.is_empty())
        .map(|(line, title, command, _)| (*line, title.as_str(), command.as_str()))
        .collect();
    let expected = [
        (5, "build house.ifs", "ifs.build"),
        (5, "show report of house.ifs", "ifs.showReport"),
        (5, "preview outputs of roof", "ifs.preview"),
        (7, "preview outputs of wall", "ifs.preview"),
    ];
    assert_eq!(commands, expected);
    let given: Vec<&Value> = found.iter().map(|(.., given)| given).filter(|given| given.is_array()).collect();
    let design = json!([uri]);
    assert_eq!(given, [&design, &design, &json!([uri, "roof"]), &json!([uri, "wall"])]);
    client.finish();
}

#[test]
fn others_are_told_what_came_out_and_nothing_to_click() {
    for (test, options) in [
        ("lsp_lenses_none", json!(null)),
        ("lsp_lenses_other", json!({ "commands": ["other.build"] })),
        ("lsp_lenses_wrong", json!({ "commands": true })),
    ] {
        let (mut client, uri) = worked_out(test, &options, "utf-16", ROOF);
        let found = lenses(&mut client, &uri);
        assert!(found.iter().all(|(_, _, command, _)| command.is_empty()), "{found:?}");
        let titles: Vec<&str> = found.iter().map(|(_, title, ..)| title.as_str()).collect();
        assert!(titles[0].starts_with("16 elements"), "{titles:?}");
        assert!(titles[1].starts_with("16 boards · worst planarity 0.99"), "{titles:?}");
        assert_eq!(titles.len(), 4, "{titles:?}");
        client.finish();
    }
}

/// The text with the hints of the server in it, each in `‹…›`, put where its columns say.
fn with_hints(client: &mut Client, uri: &str, text: &str, utf8: bool) -> String {
    let range = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 9999, "character": 0 } });
    let asked = json!({ "textDocument": { "uri": uri }, "range": range });
    let found = client.request("textDocument/inlayHint", asked).unwrap();
    let mut lines: Vec<String> = text.split('\n').map(str::to_owned).collect();
    for hint in found.as_array().unwrap().iter().rev() {
        let number = |name: &str| usize::try_from(hint["position"][name].as_u64().unwrap()).unwrap();
        let line = &mut lines[number("line")];
        let at = byte(line, number("character"), utf8);
        line.insert_str(at, &format!("‹{}›", hint["label"].as_str().unwrap()));
    }
    lines.join("\n")
}

/// The byte of a column of a line.
fn byte(line: &str, column: usize, utf8: bool) -> usize {
    let mut counted = 0;
    for (at, c) in line.char_indices() {
        if counted >= column {
            return at;
        }
        counted += if utf8 { c.len_utf8() } else { c.len_utf16() };
    }
    assert!(counted == column, "column {column} is in {line:?}");
    line.len()
}

/// The words that are coloured, in order, each with the number of its kind.
fn coloured(client: &mut Client, uri: &str, text: &str, utf8: bool) -> Vec<(String, u64)> {
    let asked = json!({ "textDocument": { "uri": uri } });
    let found = client.request("textDocument/semanticTokens/full", asked).unwrap();
    let numbers: Vec<usize> =
        found["data"].as_array().unwrap().iter().map(|n| n.as_u64().unwrap() as usize).collect();
    let lines: Vec<&str> = text.split('\n').map(|line| line.trim_end_matches('\r')).collect();
    let (mut line, mut column) = (0, 0);
    let words = numbers.chunks(5).map(|token| {
        (line, column) = if token[0] == 0 { (line, column + token[1]) } else { (line + token[0], token[1]) };
        let (from, to) = (byte(lines[line], column, utf8), byte(lines[line], column + token[2], utf8));
        (lines[line][from..to].to_owned(), token[3] as u64)
    });
    words.collect()
}

#[test]
fn hints_and_colours_in_either_columns() {
    let text = "\
use std.curves (bezier2)\r
use std.materials (sawn_spruce)\r
test \"🏠 ü\" { let 長 = 1 } /* 😀 one\r
 of two lines 😀 */ fn f(name: Text, n: Int) -> Int = n let twice = f(\"🏠 é 🏠\", 2) * 2\r
figure arch = /* 🏠 */ bezier2 on ((0m, 0m), (1m, 2m), (2m, 0m)) until edge <= 600mm\r
";
    // The same without what the language does not have, and with planks.
    let planks = "\
use std.curves (bezier2)\r
use std.materials (sawn_spruce)\r
fn f(name: Text, n: Int) -> Int = n let twice = f(\"🏠 é 🏠\", 2) * 2 // 😀\r
figure arch = [bezier2 on ((0m, 0m), (1m, 2m), (2m, 0m)) until edge <= 600mm for name in [\"🏠\"]]\r
fabricate arch as planks { material: sawn_spruce section: 100mm by 40mm require count <= 9 }\r
";
    let mut seen = Vec::new();
    for encoding in ["utf-8", "utf-16"] {
        let utf8 = encoding == "utf-8";
        let (mut client, uri) = worked_out(&format!("lsp_hints_{encoding}"), &json!(null), encoding, planks);
        let hints = with_hints(&mut client, &uri, planks, utf8);
        for part in [
            "twice‹: Int› = f(‹name:›\"🏠 é 🏠\", 2)",
            "until edge <= 600mm‹level 3› for name",
            "[\"🏠\"]]‹8 elements›",
            "as planks‹8 planks · its requirement holds› {",
            "require count <= 9‹8› }",
        ] {
            assert!(hints.contains(part), "no {part}:\n{hints}");
        }
        client.change(&uri, 2, json!([{ "text": text }]));
        let words = coloured(&mut client, &uri, text, utf8);
        for part in ["\"🏠 ü\"", "/* 😀 one", " of two lines 😀 */", "twice", "/* 🏠 */", "600mm"] {
            assert!(words.iter().any(|(word, _)| word == part), "no {part}: {words:?}");
        }
        seen.push((hints, words));
        client.finish();
    }
    assert_eq!(seen[0], seen[1]);
}

#[test]
fn the_library_has_hints_and_colours_too() {
    let (mut client, design) = worked_out("lsp_shown_library", &json!(null), "utf-16", ROOF);
    let asked = json!({ "textDocument": { "uri": design }, "position": { "line": 0, "character": 18 } });
    let place = client.request("textDocument/definition", asked).unwrap();
    let library = place["uri"].as_str().unwrap().to_owned();
    let text = fs::read_to_string(ifs_tests::root().join("stdlib/curves.ifs")).unwrap();
    client.open(&library, &text);
    let words = coloured(&mut client, &library, &text, false);
    assert!(words.len() > 500 && words.iter().any(|(word, _)| word == "bspline2"), "{}", words.len());
    let hints = with_hints(&mut client, &library, &text, false);
    assert!(hints.contains("‹: Point›"), "{hints}");
    let asked = json!({ "textDocument": { "uri": library } });
    assert_eq!(client.request("textDocument/codeLens", asked).unwrap(), json!([]));
    client.finish();
}

#[test]
fn what_came_out_stays_while_the_text_is_unfinished() {
    let text =
        ROOF.replacen("at level 1", "until edge <= 1m", 1).replacen(" }", " require planarity >= 0.9 }", 1);
    let (mut client, uri) = worked_out("lsp_unfinished", &json!(null), "utf-16", &text);
    let facts = |client: &mut Client| -> Vec<(u64, u64, String)> {
        let end = json!({ "line": 99, "character": 0 });
        let range = json!({ "start": { "line": 0, "character": 0 }, "end": end });
        let asked = json!({ "textDocument": { "uri": uri }, "range": range });
        let found = client.request("textDocument/inlayHint", asked).unwrap();
        let facts = found.as_array().unwrap().iter().filter(|hint| hint["kind"].is_null()).map(|hint| {
            let at = |name: &str| hint["position"][name].as_u64().unwrap();
            (at("line"), at("character"), hint["label"].as_str().unwrap().to_owned())
        });
        facts.collect()
    };
    let (lens, hints) = (lenses(&mut client, &uri), facts(&mut client));
    assert!(hints.iter().any(|(_, _, label)| label.starts_with("level ")), "{hints:?}");
    assert!(hints.iter().any(|(_, _, label)| label.starts_with("worst 0.99")), "{hints:?}");
    // A line that is not finished, before all of it.
    let start = json!({ "line": 0, "character": 0 });
    let range = json!({ "start": start, "end": start });
    client.change(&uri, 2, json!([{ "range": range, "text": "let q = 3 +\n" }]));
    client.diagnostics(&uri, 2);
    let below =
        |(line, title, command, given): (u64, String, String, Value)| (line + 1, title, command, given);
    let lens: Vec<_> = lens.into_iter().map(below).collect();
    assert_eq!(lenses(&mut client, &uri), lens);
    let hints: Vec<_> = hints.into_iter().map(|(line, column, label)| (line + 1, column, label)).collect();
    assert_eq!(facts(&mut client), hints);
    client.finish();
}
