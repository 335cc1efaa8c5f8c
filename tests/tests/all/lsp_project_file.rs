//! The language server and `ifs.toml`: what is wrong in it is said at its own places, whether it is open or not, and mended
//! there.
#![allow(clippy::disallowed_methods, reason = "the tests write projects")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail anywhere")]

use std::fs;

use ifs_tests::client::{Client, uri};
use ifs_tests::{program_path, scratch};
use serde_json::{Value, json};

const DESIGN: &str = "param width: Length = 4m\nlet half = width / 2\n";
const SHOP: &str = "use std.machines (router3)\nlet router = router3(tool: 8mm)\n";
const SETTINGS: &str = "outt = \"made\" # 😀\nmachine = \"shop.ifs:ruoter\"\n[params]\nwidht = \"5m\"\n";

/// A project with these settings: the URIs of the design and of its `ifs.toml`.
fn project(test: &str, settings: &str) -> (std::path::PathBuf, String, String) {
    let folder = scratch(test);
    fs::write(folder.join("ifs.toml"), settings).unwrap();
    fs::write(folder.join("design.ifs"), DESIGN).unwrap();
    fs::write(folder.join("shop.ifs"), SHOP).unwrap();
    let uris = (uri(&folder.join("design.ifs")), uri(&folder.join("ifs.toml")));
    (folder, uris.0, uris.1)
}

/// The code and the words under each diagnostic, by place.
fn said(text: &str, found: &[Value]) -> Vec<(String, String)> {
    let mut found: Vec<&Value> = found.iter().collect();
    found.sort_by_key(|one| one["range"]["start"]["line"].as_u64());
    let words = found.iter().map(|one| {
        let number =
            |end: &str, name: &str| usize::try_from(one["range"][end][name].as_u64().unwrap()).unwrap();
        let line: Vec<u16> = text.lines().nth(number("start", "line")).unwrap().encode_utf16().collect();
        let part = &line[number("start", "character")..number("end", "character")];
        (one["code"].as_str().unwrap().to_owned(), String::from_utf16(part).unwrap())
    });
    words.collect()
}

fn all_three() -> Vec<(String, String)> {
    let found = [("E0314", "outt"), ("E0861", "\"shop.ifs:ruoter\""), ("W0316", "widht")];
    found.map(|(code, word)| (code.to_owned(), word.to_owned())).to_vec()
}

#[test]
fn of_a_file_that_is_not_open() {
    let (folder, design, settings) = project("lsp_project_file_closed", SETTINGS);
    let mut client = Client::start(program_path(false));
    client.initialize(&json!({}), &[]);
    client.open(&design, DESIGN);
    let found = client.diagnostics_until(&settings, |list| !list.is_empty());
    assert_eq!(said(SETTINGS, &found), all_three());
    fs::write(folder.join("ifs.toml"), "out = \"made\"\nmachine = \"shop.ifs:router\"\n").unwrap();
    client.notify("workspace/didChangeWatchedFiles", json!({ "changes": [{ "uri": settings, "type": 2 }] }));
    client.diagnostics_until(&settings, <[Value]>::is_empty);
    client.finish();
}

#[test]
fn of_a_file_that_is_written_and_mended() {
    let (_, design, settings) = project("lsp_project_file_open", "");
    let mut client = Client::start(program_path(false));
    client.initialize(&json!({}), &[]);
    client.open(&design, DESIGN);
    client.open(&settings, SETTINGS);
    // Nothing of it is read as a design.
    let found = client.diagnostics_until(&settings, |list| list.len() == 3);
    assert_eq!(said(SETTINGS, &found), all_three());
    for method in ["documentSymbol", "codeLens", "foldingRange", "semanticTokens/full", "formatting"] {
        let asked =
            json!({ "textDocument": { "uri": settings }, "options": { "tabSize": 4, "insertSpaces": true } });
        let answer = client.request(&format!("textDocument/{method}"), asked).unwrap();
        let answer = answer.get("data").unwrap_or(&answer);
        assert!(answer.is_null() || *answer == json!([]), "{method}: {answer}");
    }
    let end = json!({ "line": 9, "character": 0 });
    let range = json!({ "start": { "line": 0, "character": 0 }, "end": end });
    let asked =
        json!({ "textDocument": { "uri": settings }, "range": range, "context": { "diagnostics": [] } });
    let actions = client.request("textDocument/codeAction", asked.clone()).unwrap();
    let mut text: Vec<String> = SETTINGS.lines().map(str::to_owned).collect();
    let mut titles = Vec::new();
    for action in actions.as_array().unwrap() {
        titles.push(action["title"].as_str().unwrap());
        for edit in action["edit"]["changes"][&settings].as_array().unwrap() {
            let number =
                |end: &str, name: &str| usize::try_from(edit["range"][end][name].as_u64().unwrap()).unwrap();
            let line = &mut text[number("start", "line")];
            line.replace_range(
                number("start", "character")..number("end", "character"),
                edit["newText"].as_str().unwrap(),
            );
        }
    }
    let machine = "replace `\"shop.ifs:ruoter\"` with `\"shop.ifs:router\"`";
    assert_eq!(titles, ["replace `outt` with `out`", machine, "replace `widht` with `width`"]);
    let mended = text.join("\n") + "\n";
    client.change(&settings, 2, json!([{ "text": mended }]));
    client.diagnostics_until(&settings, <[Value]>::is_empty);
    // A mistake in the design's name of the parameter is one of the settings too.
    client.change(&design, 2, json!([{ "text": DESIGN.replace("width", "widths") }]));
    let found = client.diagnostics_until(&settings, |list| !list.is_empty());
    assert_eq!(said(&mended, &found), [("W0316".to_owned(), "width".to_owned())]);
    client.finish();
}

#[test]
fn of_a_file_that_is_pulled() {
    let (folder, design, settings) = project("lsp_project_file_pulled", SETTINGS);
    let mut client = Client::start(program_path(false));
    let editor = json!({
        "textDocument": { "diagnostic": { "relatedDocumentSupport": true } },
        "workspace": { "diagnostics": { "refreshSupport": true } },
    });
    client.initialize(&editor, &[&folder]);
    let workspace = client.request("workspace/diagnostic", json!({ "previousResultIds": [] })).unwrap();
    let reports: Vec<&Value> =
        workspace["items"].as_array().unwrap().iter().filter(|one| one["uri"] == settings.as_str()).collect();
    assert_eq!(reports.len(), 1, "{workspace:#}");
    assert_eq!(said(SETTINGS, reports[0]["items"].as_array().unwrap()), all_three());
    client.open(&design, DESIGN);
    let asked = |uri: &str| json!({ "textDocument": { "uri": uri } });
    let pulled = client.request("textDocument/diagnostic", asked(&design)).unwrap();
    assert_eq!(
        said(SETTINGS, pulled["relatedDocuments"][&settings]["items"].as_array().unwrap()),
        all_three()
    );
    client.open(&settings, SETTINGS);
    let pulled = client.request("textDocument/diagnostic", asked(&settings)).unwrap();
    assert_eq!(said(SETTINGS, pulled["items"].as_array().unwrap()), all_three());
    client.finish();
}

#[test]
fn a_misspelt_machine_is_mended_where_it_is_named() {
    let text = "# 😀\r\nmachine = \"shop.ifs:ruoter\"\r\n";
    let (folder, design, settings) = project("lsp_project_file_machine", text);
    let mut client = Client::start(program_path(false));
    client.initialize(&json!({}), &[]);
    client.open(&design, DESIGN);
    client.open(&settings, text);
    let found = client.diagnostics_until(&settings, |list| !list.is_empty());
    assert_eq!(said(text, &found), [("E0861".to_owned(), "\"shop.ifs:ruoter\"".to_owned())]);
    let range = found[0]["range"].clone();
    let asked =
        json!({ "textDocument": { "uri": settings }, "range": range, "context": { "diagnostics": found } });
    let actions = client.request("textDocument/codeAction", asked).unwrap();
    let [action] = actions.as_array().unwrap().as_slice() else { panic!("{actions:#}") };
    assert_eq!(action["title"], "replace `\"shop.ifs:ruoter\"` with `\"shop.ifs:router\"`");
    let edit = &action["edit"]["changes"][&settings][0];
    assert_eq!(edit["range"], range);
    client.change(&settings, 2, json!([{ "range": edit["range"], "text": edit["newText"] }]));
    let mended = text.replace("ruoter", "router");
    fs::write(folder.join("ifs.toml"), &mended).unwrap();
    client.notify("textDocument/didSave", json!({ "textDocument": { "uri": settings } }));
    client.diagnostics_until(&settings, <[Value]>::is_empty);
    client.finish();
    // The command line finds nothing either.
    let checked = std::process::Command::new(program_path(false))
        .arg("check")
        .arg("design.ifs")
        .current_dir(&folder)
        .output()
        .unwrap();
    assert!(checked.status.success(), "{}", String::from_utf8_lossy(&checked.stderr));
}

#[test]
fn what_is_not_saved_yet_sets_parameters() {
    let text = "[params]\nwidth = \"5m\"\n";
    let (_, design, settings) = project("lsp_project_file_unsaved", text);
    let mut client = Client::start(program_path(false));
    client.initialize(&json!({}), &[]);
    client.open(&design, DESIGN);
    client.open(&settings, text);
    let half = |client: &mut Client| {
        let at = json!({ "textDocument": { "uri": design }, "position": { "line": 1, "character": 5 } });
        let hover = client.request("textDocument/hover", at).unwrap();
        hover["contents"]["value"].as_str().unwrap().rsplit('\n').next().unwrap().to_owned()
    };
    assert_eq!(half(&mut client), "value `2500mm`");
    client.change(&settings, 2, json!([{ "text": text.replace("5m", "7m") }]));
    assert_eq!(half(&mut client), "value `3500mm`");
    client.change(&settings, 3, json!([{ "text": text.replace("5m", "5kg") }]));
    let found = client.diagnostics_until(&design, |list| !list.is_empty());
    assert_eq!(found[0]["code"], "E0606");
    client.finish();
}
