//! A walk over what the server says it can do: each is asked for on one project and must answer something real, and what it
//! does not say it can do it refuses. **A new capability is one row in `ROWS`.**
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail anywhere")]
#![allow(clippy::disallowed_methods, reason = "the tests write projects")]

use std::collections::BTreeSet;
use std::fs;

use ifs_tests::client::{Client, Refused, uri};
use ifs_tests::{program_path, scratch};
use serde_json::{Value, json};

/// The document that is asked about; it lies beside `RIBS`, and is not laid out.
const DESIGN: &str = "\
use std.curves (bezier3, bspline3)
use std.materials (birch_plywood)
use std.surfaces (tensor)
use \"./ribs.ifs\" (rib, Rib)

/// How wide it is.
param width: Length = 4m in 2m .. 6m step 250mm
let height = width /   2
let first = Rib(depth: 120mm)

figure arch = rib(height)

let net = [[(i * 400mm, j * 300mm, 10mm * i * j) for j in 0..4] for i in 0..4]
fn tensor_roof(net: [[Point]]) -> Surface = tensor(bezier3, bezier3) on net at level 1
figure roof = tensor_roof(net)

fabricate roof as panels {
    material: birch_plywood(12mm)
    board: 2500mm by 1250mm
    require planarity >= 0.999999999
}
";

const RIBS: &str = "\
use std.curves (bezier3)

/// A rib of a width.
pub fn rib(height: Length) -> Curve = bezier3 on ((0m, 0m), (1m, height), (3m, height), (4m, 0m)) at level 2

/// How a rib is made.
pub record Rib { depth: Length }
";

/// What says that it is there (a JSON pointer into the capabilities), the method, what is asked, and what is true of a real
/// answer.
struct Row {
    capability: &'static str,
    method: &'static str,
    /// The place that is asked about is behind these words of the design; `""` asks about all of it.
    before: &'static str,
    /// What is asked beside the document and the place.
    more: fn() -> Value,
    is_real: fn(&Value) -> bool,
}

fn nothing_more() -> Value {
    json!({})
}

const fn row(
    capability: &'static str,
    method: &'static str,
    before: &'static str,
    is_real: fn(&Value) -> bool,
) -> Row {
    Row { capability, method, before, more: nothing_more, is_real }
}

/// The lines of the design up to its first figure.
fn some_lines() -> Value {
    json!({ "range": { "start": { "line": 5, "character": 0 }, "end": { "line": 9, "character": 0 } } })
}

const ROWS: &[Row] = &[
    row("/hoverProvider", "textDocument/hover", "let hei", |it| says(&it["contents"], "Length")),
    row("/definitionProvider", "textDocument/definition", "figure arch = ri", |it| {
        says(&it["uri"], "ribs.ifs")
    }),
    row("/typeDefinitionProvider", "textDocument/typeDefinition", "let fir", |it| {
        says(&it["uri"], "ribs.ifs")
    }),
    Row {
        more: || json!({ "context": { "includeDeclaration": true } }),
        ..row("/referencesProvider", "textDocument/references", "let hei", |it| count(it) == 2)
    },
    row("/documentHighlightProvider", "textDocument/documentHighlight", "let hei", |it| count(it) == 2),
    row("/documentSymbolProvider", "textDocument/documentSymbol", "", |it| {
        says(it, "height") && says(it, "roof")
    }),
    Row {
        more: || json!({ "options": { "tabSize": 4, "insertSpaces": true } }),
        ..row("/documentFormattingProvider", "textDocument/formatting", "", |it| says(it, "width / 2"))
    },
    Row {
        more: || json!({ "ch": "}", "options": { "tabSize": 4, "insertSpaces": true } }),
        ..row(
            "/documentOnTypeFormattingProvider",
            "textDocument/onTypeFormatting",
            "planarity >= 0.999999999\n}",
            |it| count(it) == 1 && says(it, "board:    2500mm"),
        )
    },
    Row {
        more: || {
            let (start, end) = (json!({ "line": 0, "character": 0 }), json!({ "line": 99, "character": 0 }));
            json!({ "range": { "start": start, "end": end }, "context": { "diagnostics": [] } })
        },
        ..row("/codeActionProvider", "textDocument/codeAction", "", |it| {
            count(it) > 0 && says(it, "bspline3") && it[0]["edit"].is_object()
        })
    },
    Row {
        more: || {
            let at = json!({ "line": 7, "character": 6 });
            let context = json!({ "diagnostics": [], "only": ["refactor"] });
            json!({ "range": { "start": at, "end": at }, "context": context })
        },
        ..row("/codeActionProvider", "textDocument/codeAction", "", |it| {
            count(it) == 1 && it[0]["kind"] == "refactor.inline" && says(&it[0]["title"], "height")
        })
    },
    row("/completionProvider", "textDocument/completion", "let height = w", |it| {
        it["isIncomplete"] == false && says(&it["items"], "\"label\":\"width\"")
    }),
    Row {
        more: || json!({ "label": "bezier3", "data": { "module": "std.curves", "name": "bezier3" } }),
        ..row("/completionProvider/resolveProvider", "completionItem/resolve", "", |it| {
            says(&it["documentation"], "Bézier")
        })
    },
    row("/signatureHelpProvider", "textDocument/signatureHelp", "figure arch = rib(", |it| {
        it["activeParameter"] == 0 && says(&it["signatures"], "height: Length")
    }),
    row("/semanticTokensProvider/full", "textDocument/semanticTokens/full", "", |it| {
        count(&it["data"]) > 100
    }),
    Row {
        more: || json!({ "previousResultId": "1" }),
        ..row("/semanticTokensProvider/full/delta", "textDocument/semanticTokens/full/delta", "", |it| {
            it["edits"].is_array()
        })
    },
    Row {
        more: some_lines,
        ..row("/semanticTokensProvider/range", "textDocument/semanticTokens/range", "", |it| {
            (5..200).contains(&count(&it["data"]))
        })
    },
    Row {
        more: some_lines,
        ..row("/inlayHintProvider", "textDocument/inlayHint", "", |it| says(it, ": Length"))
    },
    row("/codeLensProvider", "textDocument/codeLens", "", |it| says(it, "4 boards")),
    row("/foldingRangeProvider", "textDocument/foldingRange", "", |it| says(it, "imports")),
    Row {
        more: || json!({ "positions": [{ "line": 7, "character": 6 }] }),
        ..row("/selectionRangeProvider", "textDocument/selectionRange", "", |it| {
            it[0]["parent"]["range"].is_object()
        })
    },
    Row {
        more: || {
            let mut more = some_lines();
            more["options"] = json!({ "tabSize": 4, "insertSpaces": true });
            more
        },
        ..row("/documentRangeFormattingProvider", "textDocument/rangeFormatting", "", |it| {
            says(it, "width / 2")
        })
    },
    Row {
        more: || json!({ "query": "rib" }),
        ..row("/workspaceSymbolProvider", "workspace/symbol", "", |it| says(it, "ribs.ifs"))
    },
    row("/callHierarchyProvider", "textDocument/prepareCallHierarchy", "figure arch = ri", |it| {
        it[0]["name"] == "rib" && says(&it[0]["uri"], "ribs.ifs")
    }),
    row("/callHierarchyProvider", "callHierarchy/incomingCalls", "figure arch = ri", |it| {
        count(it) == 1 && it[0]["from"]["name"] == "arch"
    }),
    row("/callHierarchyProvider", "callHierarchy/outgoingCalls", "figure arch = ri", |it| {
        it[0]["to"]["name"] == "bezier3"
    }),
    row("/documentLinkProvider", "textDocument/documentLink", "", |it| {
        says(it, "ribs.ifs") && says(it, "curves.ifs")
    }),
    row("/renameProvider/prepareProvider", "textDocument/prepareRename", "let hei", |it| {
        it["start"]["line"] == 7
    }),
    Row {
        more: || json!({ "newName": "rise" }),
        ..row("/renameProvider", "textDocument/rename", "let hei", |it| says(&it["changes"], "rise"))
    },
    row("/diagnosticProvider", "textDocument/diagnostic", "", |it| {
        it["kind"] == "full" && it["resultId"].is_string()
    }),
    Row {
        more: || json!({ "previousResultIds": [] }),
        ..row("/diagnosticProvider/workspaceDiagnostics", "workspace/diagnostic", "", |it| {
            says(&it["items"], "design.ifs")
                && says(&it["items"], "broken.ifs")
                && says(&it["items"], "E0301")
        })
    },
];

/// What is said of the server that is asked for by every other row.
const SAID: &[&str] = &["positionEncoding", "textDocumentSync", "workspace"];

/// Requests of the protocol that a server may answer.
const METHODS: &[&str] = &[
    "callHierarchy/incomingCalls",
    "callHierarchy/outgoingCalls",
    "codeAction/resolve",
    "codeLens/resolve",
    "completionItem/resolve",
    "documentLink/resolve",
    "inlayHint/resolve",
    "textDocument/codeAction",
    "textDocument/codeLens",
    "textDocument/colorPresentation",
    "textDocument/completion",
    "textDocument/declaration",
    "textDocument/definition",
    "textDocument/diagnostic",
    "textDocument/documentColor",
    "textDocument/documentHighlight",
    "textDocument/documentLink",
    "textDocument/documentSymbol",
    "textDocument/foldingRange",
    "textDocument/formatting",
    "textDocument/hover",
    "textDocument/implementation",
    "textDocument/inlayHint",
    "textDocument/inlineValue",
    "textDocument/linkedEditingRange",
    "textDocument/moniker",
    "textDocument/onTypeFormatting",
    "textDocument/prepareCallHierarchy",
    "textDocument/prepareRename",
    "textDocument/prepareTypeHierarchy",
    "textDocument/rangeFormatting",
    "textDocument/references",
    "textDocument/rename",
    "textDocument/selectionRange",
    "textDocument/semanticTokens/full",
    "textDocument/semanticTokens/full/delta",
    "textDocument/semanticTokens/range",
    "textDocument/signatureHelp",
    "textDocument/typeDefinition",
    "textDocument/willSaveWaitUntil",
    "typeHierarchy/subtypes",
    "typeHierarchy/supertypes",
    "workspace/diagnostic",
    "workspace/executeCommand",
    "workspace/symbol",
    "workspace/willCreateFiles",
    "workspace/willDeleteFiles",
    "workspace/willRenameFiles",
    "workspaceSymbol/resolve",
];

/// Parts of a capability that promise a method of their own.
const PARTS: &[&str] = &["prepareProvider", "resolveProvider", "workspaceDiagnostics", "delta"];

fn says(value: &Value, words: &str) -> bool {
    value.to_string().contains(words)
}

fn count(value: &Value) -> usize {
    value.as_array().map_or(0, Vec::len)
}

/// What a capable editor says of itself.
fn editor() -> Value {
    json!({
        "general": { "positionEncodings": ["utf-16"] },
        "textDocument": {
            "diagnostic": { "relatedDocumentSupport": true },
            "publishDiagnostics": { "relatedInformation": true },
            "completion": { "completionItem": { "snippetSupport": true } },
            "documentSymbol": { "hierarchicalDocumentSymbolSupport": true },
            "rename": { "prepareSupport": true },
        },
        "workspace": { "diagnostics": { "refreshSupport": true }, "workspaceFolders": true },
    })
}

fn fixture(test: &str) -> (Client, Value, String) {
    let folder = scratch(test);
    fs::write(folder.join("ifs.toml"), "").unwrap();
    fs::write(folder.join("design.ifs"), DESIGN).unwrap();
    fs::write(folder.join("ribs.ifs"), RIBS).unwrap();
    fs::write(folder.join("broken.ifs"), "let a = nowhere\n").unwrap();
    let mut client = Client::start(program_path(false));
    let capabilities = client.initialize(&editor(), &[&folder]);
    let uri = uri(&folder.join("design.ifs"));
    client.open(&uri, DESIGN);
    (client, capabilities, uri)
}

fn ask(client: &mut Client, uri: &str, row: &Row) -> Result<Value, Refused> {
    let mut params = json!({ "textDocument": { "uri": uri } });
    if !row.before.is_empty() {
        let at = DESIGN.find(row.before).unwrap_or_else(|| panic!("`{}` is in the design", row.before));
        let head = &DESIGN[..at + row.before.len()];
        let column = head.len() - head.rfind('\n').map_or(0, |end| end + 1);
        params["position"] = json!({ "line": head.matches('\n').count(), "character": column });
    }
    for (name, value) in (row.more)().as_object().unwrap() {
        params[name] = value.clone();
    }
    // Calls are asked of an item that was prepared.
    if row.method.starts_with("callHierarchy/") {
        params["item"] = client.request("textDocument/prepareCallHierarchy", params.clone())?[0].clone();
    }
    client.request(row.method, params)
}

#[test]
fn every_capability_answers_something_real() {
    let (mut client, capabilities, uri) = fixture("lsp_capabilities_answer");
    // What is worked out in the background is known when the server asks to be asked again.
    client.wait("a refresh", |message| message["method"] == "workspace/diagnostic/refresh");
    for row in ROWS {
        let said = capabilities.pointer(row.capability);
        let there = said.is_some_and(|said| !said.is_null() && *said != Value::Bool(false));
        assert!(there, "{} is answered but not advertised at {}", row.method, row.capability);
        let answer = ask(&mut client, &uri, row);
        let real = answer.as_ref().is_ok_and(|answer| (row.is_real)(answer));
        assert!(real, "{}: {answer:#?}", row.method);
    }
    client.finish();
}

#[test]
fn everything_advertised_is_asked_for() {
    let (client, capabilities, _) = fixture("lsp_capabilities_asked");
    let mut missing = BTreeSet::new();
    for (name, said) in capabilities.as_object().unwrap() {
        let provided = |pointer: &str| ROWS.iter().any(|row| row.capability == pointer);
        if said.is_null() || SAID.contains(&name.as_str()) {
            continue;
        }
        let own = ROWS.iter().any(|row| row.capability.split('/').nth(1) == Some(name.as_str()));
        if !own {
            missing.insert(format!("/{name}"));
        }
        for part in PARTS.iter().filter(|part| said[**part] == Value::Bool(true)) {
            let pointer = format!("/{name}/{part}");
            if !provided(&pointer) {
                missing.insert(pointer);
            }
        }
        for (outer, inner) in [("full", "delta"), ("range", "")] {
            let pointer = format!("/{name}/{outer}/{inner}").trim_end_matches('/').to_owned();
            let promised = capabilities.pointer(&pointer).is_some_and(|said| *said == Value::Bool(true));
            if promised && !provided(&pointer) {
                missing.insert(pointer);
            }
        }
    }
    assert!(missing.is_empty(), "advertised, but without a row that asks for it: {missing:?}");
    client.finish();
}

#[test]
fn what_is_not_advertised_is_refused() {
    let (mut client, _, uri) = fixture("lsp_capabilities_refused");
    for method in METHODS {
        if ROWS.iter().any(|row| row.method == *method) {
            continue;
        }
        let mut params = anything(&uri);
        match *method {
            "codeAction/resolve" => params["kind"] = json!("quickfix"),
            "workspace/executeCommand" => params["command"] = json!("a"),
            _ => {}
        }
        let answer = client.request(method, params);
        let nobody = answer.as_ref().is_err_and(|refused| refused.code == -32601);
        assert!(nobody, "{method} is handled but no row asks for it: {answer:?}");
    }
    client.finish();
}

/// Parameters that fit every method.
fn anything(uri: &str) -> Value {
    let start = json!({ "line": 0, "character": 0 });
    let range = json!({ "start": start, "end": start });
    json!({
        "textDocument": { "uri": uri }, "position": start, "positions": [start], "range": range,
        "item": { "name": "a", "kind": 1, "uri": uri, "range": range, "selectionRange": range },
        "context": {
            "diagnostics": [], "includeDeclaration": true, "frameId": 0, "stoppedLocation": range,
            "triggerKind": 1, "isRetrigger": false,
        },
        "options": { "tabSize": 4, "insertSpaces": true },
        "color": { "red": 0.0, "green": 0.0, "blue": 0.0, "alpha": 0.0 },
        "name": "a", "newName": "a", "label": "a", "title": "a", "query": "", "ch": "a",
        "kind": 1, "reason": 1, "files": [], "location": { "uri": uri, "range": range },
        "previousResultId": "a", "previousResultIds": [],
    })
}
