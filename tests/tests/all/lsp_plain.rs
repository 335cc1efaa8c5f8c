//! Clients that say that they show less: words without marks, symbols in one row, diagnostics without related places.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail anywhere")]

use ifs_tests::client::Client;
use ifs_tests::program_path;
use serde_json::{Value, json};

const URI: &str = "untitled:house.ifs";
const TEXT: &str = "\
use std.curves (bezier)
/// How **wide** a `bay` is.
let width = 2m
fn half(of: Length) -> Length = of / 2
let width = half(1m)
ifs c on (a, b) {
    transform l = 0.5 * self
}
";

fn opened(capabilities: &Value) -> (Client, Vec<Value>) {
    let mut client = Client::start(program_path(false));
    client.initialize(capabilities, &[]);
    client.open(URI, TEXT);
    let found = client.diagnostics(URI, 1);
    (client, found)
}

fn at(line: u32, character: u32) -> Value {
    json!({ "textDocument": { "uri": URI }, "position": { "line": line, "character": character } })
}

/// What is said by a hover, of an offer and of the called function.
fn told(client: &mut Client) -> [Value; 3] {
    let hover = client.request("textDocument/hover", at(2, 5)).unwrap();
    let list = client.request("textDocument/completion", at(4, 17)).unwrap();
    let items = list.get("items").unwrap_or(&list).as_array().unwrap().clone();
    let width = items.into_iter().find(|item| item["label"] == "width").unwrap();
    let resolved = client.request("completionItem/resolve", width).unwrap();
    let help = client.request("textDocument/signatureHelp", at(4, 17)).unwrap();
    [hover["contents"].clone(), resolved["documentation"].clone(), help["signatures"][0].clone()]
}

#[test]
fn words_have_no_marks_for_who_shows_none() {
    let plain = ["plaintext"];
    let editor = json!({ "textDocument": {
        "hover": { "contentFormat": plain },
        "completion": { "completionItem": { "documentationFormat": plain } },
        "signatureHelp": { "signatureInformation": { "documentationFormat": plain } },
    } });
    let (mut client, _) = opened(&editor);
    let [hover, offer, signature] = told(&mut client);
    assert_eq!(hover["kind"], "plaintext", "{hover}");
    let words = hover["value"].as_str().unwrap();
    assert!(words.contains("How wide a bay is.") && !words.contains(['`', '*']), "{words}");
    let words = offer.as_str().unwrap_or_else(|| panic!("{offer}"));
    assert!(words.contains("How wide a bay is."), "{words}");
    assert!(signature["documentation"].is_null() || signature["documentation"].is_string(), "{signature}");
    client.finish();
    let (mut client, _) =
        opened(&json!({ "textDocument": { "hover": { "contentFormat": ["plaintext", "markdown"] } } }));
    let [hover, offer, _] = told(&mut client);
    assert_eq!(hover["kind"], "markdown", "{hover}");
    assert_eq!(offer["kind"], "markdown", "{offer}");
    client.finish();
}

#[test]
fn symbols_stand_in_one_row_for_who_shows_no_tree() {
    let asked = json!({ "textDocument": { "uri": URI } });
    let (mut client, _) = opened(&json!({ "textDocument": { "documentSymbol": {} } }));
    let found = client.request("textDocument/documentSymbol", asked.clone()).unwrap();
    let row: Vec<(&str, Option<&str>)> = found
        .as_array()
        .unwrap()
        .iter()
        .map(|one| (one["name"].as_str().unwrap(), one["containerName"].as_str()))
        .collect();
    assert!(row.contains(&("half", None)) && row.contains(&("l", Some("c"))), "{row:?}");
    assert!(found.as_array().unwrap().iter().all(|one| one["location"]["uri"] == URI), "{found:#}");
    client.finish();
    let tree = json!({ "textDocument": { "documentSymbol": { "hierarchicalDocumentSymbolSupport": true } } });
    let (mut client, _) = opened(&tree);
    let found = client.request("textDocument/documentSymbol", asked).unwrap();
    assert!(found.as_array().unwrap().iter().any(|one| one["children"].is_array()), "{found:#}");
    client.finish();
}

#[test]
fn related_places_are_told_in_the_message_to_who_shows_none() {
    let twice = |found: &[Value]| found.iter().find(|one| one["code"] == "E0302").cloned().unwrap();
    let (client, found) = opened(&json!({ "textDocument": { "publishDiagnostics": {} } }));
    let found = twice(&found);
    assert!(found["relatedInformation"].is_null(), "{found:#}");
    assert!(found["message"].as_str().unwrap().contains("\nline 3: "), "{found:#}");
    client.finish();
    let (client, found) =
        opened(&json!({ "textDocument": { "publishDiagnostics": { "relatedInformation": true } } }));
    let found = twice(&found);
    assert_eq!(found["relatedInformation"].as_array().unwrap().len(), 1, "{found:#}");
    assert!(!found["message"].as_str().unwrap().contains("line 3"), "{found:#}");
    client.finish();
}
