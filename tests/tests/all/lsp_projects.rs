//! The language server and where designs lie: projects of several files, files outside of any, documents that were never
//! saved, names of all kinds, links, and the library's own files.
#![allow(clippy::disallowed_methods, reason = "the tests write projects")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail anywhere")]

use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;

use ifs_tests::client::{Client, uri};
use ifs_tests::{program_path, scratch};
use serde_json::{Value, json};

const DESIGN: &str = "use \"./parts/ribs.ifs\" (rib)\nparam width: Length = 4m\nfigure arch = rib(width)\n";
const RIBS: &str = "use std.curves (bezier3)\npub fn rib(w: Length) -> Curve = bezier3 on ((0m, 0m), (1m, w), (3m, w), (4m, 0m)) at level 2\n";

fn server() -> Client {
    let mut client = Client::start(program_path(false));
    client.initialize(&json!({}), &[]);
    client
}

fn at(uri: &str, line: u32, character: u32) -> Value {
    json!({ "textDocument": { "uri": uri }, "position": { "line": line, "character": character } })
}

fn project(folder: &Path) {
    fs::create_dir_all(folder.join("parts")).unwrap();
    fs::write(folder.join("ifs.toml"), "[params]\nwidth = \"5m\"\n").unwrap();
    fs::write(folder.join("design.ifs"), DESIGN).unwrap();
    fs::write(folder.join("parts/ribs.ifs"), RIBS).unwrap();
}

#[test]
fn a_project_of_several_files() {
    let folder = scratch("lsp_project").join("a house, 100% of ü");
    project(&folder);
    let (design, ribs) = (uri(&folder.join("design.ifs")), uri(&folder.join("parts/ribs.ifs")));
    let mut client = server();
    client.open(&design, DESIGN);
    assert_eq!(client.diagnostics(&design, 1), [] as [Value; 0]);
    let place = client.request("textDocument/definition", at(&design, 2, 15)).unwrap();
    assert_eq!((&place["uri"], &place["range"]["start"]["line"]), (&json!(ribs), &json!(1)));
    // A file that is used changes in the editor, not on disk: the design that uses it hears of it.
    client.open(&ribs, RIBS);
    assert_eq!(client.diagnostics(&ribs, 1), [] as [Value; 0]);
    client.change(&ribs, 2, json!([{ "text": RIBS.replace("fn rib(", "fn ribs(") }]));
    let found = client.diagnostics_until(&design, |list| !list.is_empty());
    assert!(found[0]["message"].as_str().unwrap().contains("rib"), "{found:#?}");
    // And when it is closed the disk counts again.
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": ribs } }));
    client.diagnostics_until(&design, <[Value]>::is_empty);
    // What is wrong in a file that is not open is said of that file, and taken back.
    fs::write(folder.join("parts/ribs.ifs"), RIBS.replace("level 2", "level two")).unwrap();
    client.notify("workspace/didChangeWatchedFiles", json!({ "changes": [{ "uri": ribs, "type": 2 }] }));
    client.diagnostics_until(&ribs, |list| !list.is_empty());
    fs::write(folder.join("parts/ribs.ifs"), RIBS).unwrap();
    client.notify("textDocument/didSave", json!({ "textDocument": { "uri": design } }));
    client.diagnostics_until(&ribs, <[Value]>::is_empty);
    // A name is changed in both files.
    let mut new = at(&design, 2, 15);
    new["newName"] = json!("arch_of");
    let changes = client.request("textDocument/rename", new).unwrap()["changes"].clone();
    assert_eq!(changes[&design].as_array().map(Vec::len), Some(2), "{changes}");
    assert_eq!(changes[&ribs].as_array().map(Vec::len), Some(1), "{changes}");
    client.finish();
}

/// Asks for another name at a place.
fn renamed(client: &mut Client, uri: &str, (line, column): (u32, u32), new: &str) -> Result<Value, String> {
    let mut params = at(uri, line, column);
    params["newName"] = json!(new);
    client.request("textDocument/rename", params).map_err(|refused| refused.message)
}

#[test]
fn names_that_would_mean_something_else_are_refused() {
    let folder = scratch("lsp_rename_clashes");
    project(&folder);
    let design = uri(&folder.join("design.ifs"));
    let text = "use std.curves (bezier3)\nuse \"./parts/ribs.ifs\" (rib)\nlet wide = 3m\nlet roof = rib(wide)\n\
                let other = bezier3\ntest \"t\" {\n    let three = 3\n    assert three == len([1, 2, 3])\n}\n\
                ifs halves(t: Number = 1/2) on (a, b) {\n    let m = lerp(a, b, t)\n    transform l = self on (a, m)\n\
                transform r = self on (m, b)\n    germ segment(a, b)\n}\n";
    let mut client = server();
    client.open(&design, text);
    client.diagnostics(&design, 1);
    for (place, new) in
        [((2, 5), "rib"), ((2, 5), "bezier3"), ((6, 9), "len"), ((9, 11), "lerp"), ((2, 5), "roof")]
    {
        let refused = renamed(&mut client, &design, place, new).expect_err(new);
        assert!(refused.contains(&format!("`{new}`")), "{refused}");
    }
    // From the file that declares it, what another imports counts too.
    let ribs = uri(&folder.join("parts/ribs.ifs"));
    client.open(&ribs, RIBS);
    client.diagnostics(&ribs, 1);
    let declared = 1;
    let column = 7;
    renamed(&mut client, &ribs, (declared, column), "bezier3").expect_err("imported beside it");
    renamed(&mut client, &ribs, (declared, column), "arch_of").unwrap();
    client.finish();
}

#[test]
fn a_parameter_is_renamed_where_the_project_sets_it() {
    let folder = scratch("lsp_rename_param");
    project(&folder);
    fs::write(folder.join("ifs.toml"), "[params]\nspan = \"5m\"\n").unwrap();
    let text = "param span: Length = 6m\nlet half = span / 2\n";
    fs::write(folder.join("first.ifs"), text).unwrap();
    let (first, settings) = (uri(&folder.join("first.ifs")), uri(&folder.join("ifs.toml")));
    let mut client = server();
    client.open(&first, text);
    client.diagnostics(&first, 1);
    let changes = renamed(&mut client, &first, (0, 7), "breadth").unwrap()["changes"].clone();
    assert_eq!(changes[&first].as_array().map(Vec::len), Some(2), "{changes}");
    assert_eq!(changes[&settings][0]["range"]["start"], json!({ "line": 1, "character": 0 }), "{changes}");
    assert_eq!(changes[&settings][0]["range"]["end"], json!({ "line": 1, "character": 4 }), "{changes}");
    // Another design is set by the same line.
    fs::write(folder.join("second.ifs"), text).unwrap();
    let refused = renamed(&mut client, &first, (0, 7), "breadth").expect_err("of both");
    assert!(refused.contains("second.ifs"), "{refused}");
    client.finish();
}

#[test]
fn a_new_file_that_another_uses_before_it_is_saved() {
    let folder = scratch("lsp_new_file");
    fs::create_dir_all(folder.join("parts")).unwrap();
    let (design, ribs) = (uri(&folder.join("design.ifs")), uri(&folder.join("parts/ribs.ifs")));
    let mut client = server();
    client.open(&design, DESIGN);
    let found = client.diagnostics_until(&design, |list| !list.is_empty());
    assert!(found[0]["message"].as_str().unwrap().contains("ribs.ifs"), "{found:#?}");
    client.open(&ribs, RIBS);
    client.diagnostics_until(&design, <[Value]>::is_empty);
    client.finish();
}

#[test]
fn documents_that_lie_nowhere() {
    let mut client = server();
    for uri in [
        "untitled:Untitled-1",
        "untitled:/tmp/a/b.ifs",
        "git:/somewhere/a.ifs?ref=HEAD",
        "inmemory://model/1",
        "file://host/a.ifs",
    ] {
        client.open(uri, "use std.curves (bezier3)\nlet a = 1m + 2\n");
        let found = client.diagnostics(uri, 1);
        assert!(found.iter().any(|one| one["range"]["start"]["line"] == 1), "{uri}: {found:#?}");
        client.change(
            uri,
            2,
            json!([{ "text": "use \"./ribs.ifs\" (rib)\nfigure f = rib(1m)\nlet a = 2m\nlet b = a\n" }]),
        );
        let found = client.diagnostics(uri, 2);
        assert!(found[0]["message"].as_str().unwrap().contains("save it first"), "{uri}: {found:#?}");
        let place = client.request("textDocument/definition", at(uri, 3, 8)).unwrap();
        assert_eq!(place["uri"], uri, "{place}");
        client.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
    }
    client.finish();
}

#[test]
fn a_client_reads_its_own_names() {
    let folder = scratch("lsp_names");
    project(&folder.join("real"));
    symlink(folder.join("real"), folder.join("link")).unwrap();
    let mut client = server();
    // Through a link, and spelt in another way than ours.
    let linked = uri(&folder.join("link/parts/ribs.ifs"));
    for uri in [linked.clone(), uri(&folder.join("real/design.ifs")).replace("design", "d%65sign")] {
        client.open(&uri, "let a = 2m\nlet b = a + 1\n");
        assert_eq!(client.diagnostics(&uri, 1).len(), 1);
        let place = client.request("textDocument/definition", at(&uri, 1, 8)).unwrap();
        assert_eq!(place["uri"], uri);
        let mut new = at(&uri, 1, 8);
        new["newName"] = json!("c");
        let changes = client.request("textDocument/rename", new).unwrap()["changes"].clone();
        assert_eq!(changes[&uri].as_array().map(Vec::len), Some(2), "{changes}");
    }
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": linked } }));
    client.diagnostics_until(&linked, <[Value]>::is_empty);
    client.finish();
}

#[test]
fn the_files_of_the_library_as_documents() {
    let mut client = server();
    client.open(
        "untitled:a.ifs",
        "use std.curves (bezier3)\nfigure f = bezier3 on ((0m, 0m), (1m, 2m), (3m, 2m), (4m, 0m))\n",
    );
    let place = client.request("textDocument/definition", at("untitled:a.ifs", 1, 12)).unwrap();
    let curves = place["uri"].as_str().unwrap().to_owned();
    assert!(curves.ends_with("/std/curves.ifs"), "{curves}");
    let folder = ifs_tests::root().join("stdlib");
    let library = curves.trim_end_matches("curves.ifs");
    let mut asked = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let uri = format!("{library}{}", path.file_name().unwrap().to_str().unwrap());
        let text = fs::read_to_string(&path).unwrap();
        client.open(&uri, &text);
        assert_eq!(client.diagnostics(&uri, 1), [] as [Value; 0], "{uri}");
        let symbols =
            client.request("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri } })).unwrap();
        let symbols = symbols.as_array().unwrap();
        for symbol in symbols.iter().take(5) {
            let position = &symbol["selectionRange"]["start"];
            let hover = client
                .request(
                    "textDocument/hover",
                    json!({ "textDocument": { "uri": uri }, "position": position }),
                )
                .unwrap();
            assert!(hover["contents"]["value"].is_string(), "{uri}: {symbol}");
            asked += 1;
        }
    }
    assert!(asked > 30, "{asked}");
    let refused = client.request("textDocument/prepareRename", at(&curves, 20, 5));
    assert!(refused.is_err_and(|why| why.message.contains("of the library")));
    client.finish();
}

#[test]
fn what_has_not_changed_is_said_to_be_so() {
    let folder = scratch("lsp_pull");
    project(&folder);
    let said = json!({
        "textDocument": { "diagnostic": { "relatedDocumentSupport": true } },
        "workspace": { "diagnostics": { "refreshSupport": true } },
    });
    let mut client = Client::start(program_path(false));
    client.initialize(&said, &[&folder]);
    let (design, ribs) = (uri(&folder.join("design.ifs")), uri(&folder.join("parts/ribs.ifs")));
    client.open(&design, &format!("{DESIGN}let a = 1m + 1\n"));
    let pull = |client: &mut Client, known: Option<&Value>| {
        let params = json!({ "textDocument": { "uri": design }, "previousResultId": known });
        client.request("textDocument/diagnostic", params).unwrap()
    };
    let first = pull(&mut client, None);
    assert_eq!(
        (first["kind"].as_str(), first["items"].as_array().map(Vec::len)),
        (Some("full"), Some(1)),
        "{first}"
    );
    assert_eq!(first["relatedDocuments"][&ribs]["kind"], "full");
    let again = pull(&mut client, Some(&first["resultId"]));
    assert_eq!((&again["kind"], &again["resultId"]), (&json!("unchanged"), &first["resultId"]));
    let whole = |client: &mut Client, known: &[Value]| {
        let report = client.request("workspace/diagnostic", json!({ "previousResultIds": known })).unwrap();
        let items: Vec<Value> = report["items"].as_array().unwrap().clone();
        let kinds = items.iter().map(|item| item["kind"].as_str().unwrap().to_owned()).collect::<Vec<_>>();
        let ids = items
            .iter()
            .map(|item| json!({ "uri": item["uri"], "value": item["resultId"] }))
            .collect::<Vec<_>>();
        (kinds, ids)
    };
    let (kinds, known) = whole(&mut client, &[]);
    assert_eq!(kinds, ["full", "full", "full"], "two designs and their `ifs.toml`");
    assert_eq!(whole(&mut client, &known).0, ["unchanged", "unchanged", "unchanged"]);
    // A file that another uses: both have changed.
    fs::write(folder.join("parts/ribs.ifs"), format!("{RIBS}let x = 1m + 1\n")).unwrap();
    client.notify("textDocument/didSave", json!({ "textDocument": { "uri": design } }));
    assert_eq!(whole(&mut client, &known).0, ["unchanged", "unchanged", "full"]);
    let pushed = client.said(std::time::Duration::from_millis(100));
    let pushed = pushed.iter().filter(|message| message["method"] == "textDocument/publishDiagnostics");
    assert_eq!(pushed.count(), 0, "who pulls is not pushed to");
    client.finish();
}

#[test]
fn designs_that_nobody_has_open_are_worked_out_too() {
    let folder = scratch("lsp_workspace_boards");
    fs::write(folder.join("ifs.toml"), "").unwrap();
    let text = "use std.curves (line)\nuse std.materials (sawn_spruce)\nfigure beam = line on ((0m, 0m), (4m, 0m)) at level 1\n\
                fabricate beam as planks {\n    material: sawn_spruce\n    section: 100mm by 40mm\n    require length <= 1m\n}\n";
    fs::write(folder.join("long.ifs"), text).unwrap();
    fs::write(folder.join("good.ifs"), text.replace("<= 1m", "<= 2m")).unwrap();
    let mut client = Client::start(program_path(false));
    client.initialize(&json!({ "textDocument": { "diagnostic": {} } }), &[&folder]);
    let report = client.request("workspace/diagnostic", json!({ "previousResultIds": [] })).unwrap();
    let of = |name: &str| {
        let own = uri(&folder.join(name));
        let item = report["items"].as_array().unwrap().iter().find(|item| item["uri"] == own).unwrap();
        item["items"].as_array().unwrap().clone()
    };
    let found = of("long.ifs");
    assert_eq!(
        (found.len(), &found[0]["code"], &found[0]["range"]["start"]["line"]),
        (1, &json!("E0812"), &json!(6))
    );
    assert_eq!(of("good.ifs"), [] as [Value; 0]);
    client.finish();
}

#[test]
fn a_mistake_that_another_design_finds_is_pulled_too() {
    let folder = scratch("lsp_pull_elsewhere");
    fs::write(folder.join("ifs.toml"), "").unwrap();
    let lib = "let list = [1m, 2m]\npub fn pick(i: Int) -> Length = list[i]\n";
    let user = "use \"./lib.ifs\" (pick)\nlet a = pick(10)\n";
    fs::write(folder.join("lib.ifs"), lib).unwrap();
    fs::write(folder.join("user.ifs"), user).unwrap();
    let said = json!({
        "textDocument": { "diagnostic": {} },
        "workspace": { "diagnostics": { "refreshSupport": true } },
    });
    let mut client = Client::start(program_path(false));
    client.initialize(&said, &[&folder]);
    let (lib_uri, user_uri) = (uri(&folder.join("lib.ifs")), uri(&folder.join("user.ifs")));
    let found = |client: &mut Client| {
        let report = client.request("workspace/diagnostic", json!({ "previousResultIds": [] })).unwrap();
        let item = report["items"].as_array().unwrap().iter().find(|item| item["uri"] == lib_uri).unwrap();
        item["items"].as_array().unwrap().iter().map(|one| one["code"].clone()).collect::<Vec<_>>()
    };
    assert_eq!(found(&mut client), [json!("E0602")], "nobody has them open");
    client.open(&user_uri, user);
    client.open(&lib_uri, lib);
    let pull = |client: &mut Client| {
        let params = json!({ "textDocument": { "uri": lib_uri } });
        let report = client.request("textDocument/diagnostic", params).unwrap();
        report["items"].as_array().unwrap().iter().map(|one| one["code"].clone()).collect::<Vec<_>>()
    };
    // It is found, and gone, when the design is worked out.
    let becomes = |client: &mut Client, expected: &[Value]| {
        (0..200).any(|_| {
            std::thread::sleep(std::time::Duration::from_millis(50));
            pull(client) == expected
        })
    };
    assert!(becomes(&mut client, &[json!("E0602")]), "{:?}", pull(&mut client));
    assert_eq!(found(&mut client), [json!("E0602")]);
    client.change(&user_uri, 2, json!([{ "text": user.replace("10", "1") }]));
    assert!(becomes(&mut client, &[]), "{:?}", pull(&mut client));
    assert_eq!(found(&mut client), [] as [Value; 0]);
    client.finish();
}
