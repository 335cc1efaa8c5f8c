//! Meshes that designs import, in the editor: their paths are offered and are links, and what is wrong with them is said anew
//! when they change on disk.
#![allow(clippy::disallowed_methods, reason = "the test writes a project")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail anywhere")]

use std::fs;

use ifs_tests::client::{Client, uri};
use ifs_tests::{program_path, root, scratch};
use serde_json::json;

#[test]
fn of_a_project() {
    let folder = scratch("lsp_meshes");
    let (parts, joint) = (folder.join("parts"), folder.join("joint.glb"));
    fs::create_dir(&parts).unwrap();
    fs::write(folder.join("ifs.toml"), "").unwrap();
    let (mesh, broken) = ("tests/suite/meshes/joint.glb", "tests/suite/meshes/cut_off.glb");
    fs::copy(root().join(mesh), &joint).unwrap();
    let design = uri(&parts.join("node.ifs"));
    let mut client = Client::start(program_path(false));
    let editor = json!({ "workspace": { "didChangeWatchedFiles": { "dynamicRegistration": true } } });
    client.initialize(&editor, &[&folder]);
    let asked = client.wait("what is watched", |message| message["method"] == "client/registerCapability");
    assert!(asked.to_string().contains("**/*.glb"), "{asked}");

    // Nothing reads it yet.
    client.open(&design, "pub ifs joint in space {\n    germ import(\"\n}\n");
    let here = json!({ "textDocument": { "uri": design }, "position": { "line": 1, "character": 17 } });
    let list = client.request("textDocument/completion", here).unwrap();
    let labels: Vec<&str> =
        list["items"].as_array().unwrap().iter().map(|one| one["label"].as_str().unwrap()).collect();
    assert_eq!(labels, ["../joint.glb"]);

    let text =
        "pub ifs joint in space {\n    germ import(\"../joint.glb\")\n    transform half = scale(0.5)\n}\n";
    client.change(&design, 2, json!([{ "text": text }]));
    let asked = json!({ "textDocument": { "uri": design } });
    let links = client.request("textDocument/documentLink", asked.clone()).unwrap();
    assert_eq!(links.as_array().unwrap().len(), 1, "{links:#}");
    assert_eq!(links[0]["target"], uri(&joint));
    assert_eq!(links[0]["range"]["start"], json!({ "line": 1, "character": 16 }));

    fs::copy(root().join(broken), &joint).unwrap();
    let changed = json!({ "changes": [{ "uri": uri(&joint), "type": 2 }] });
    client.notify("workspace/didChangeWatchedFiles", changed);
    client.diagnostics_until(&design, |list| list.iter().any(|one| one["code"] == "E0556"));
    assert_eq!(client.request("textDocument/documentLink", asked.clone()).unwrap(), links);

    fs::remove_file(&joint).unwrap();
    client
        .notify("workspace/didChangeWatchedFiles", json!({ "changes": [{ "uri": uri(&joint), "type": 3 }] }));
    client.diagnostics_until(&design, |list| list.iter().any(|one| one["code"] == "E0306"));
    assert_eq!(client.request("textDocument/documentLink", asked).unwrap(), json!([]));
    client.finish();
}
