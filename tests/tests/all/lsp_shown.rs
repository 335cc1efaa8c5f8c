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
