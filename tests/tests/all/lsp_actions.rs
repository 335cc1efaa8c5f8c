//! Code actions that take more than the text around a mistake: imports from other files of the project, and refactorings.
//! Each is applied, as a client applies it.
#![allow(clippy::disallowed_methods, reason = "the tests write projects")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail anywhere")]

use std::fs;

use ifs_tests::client::{Client, uri};
use ifs_tests::{program_path, scratch};
use serde_json::{Value, json};

/// The actions at the words between `«` and `»`: their titles, and the text after each.
fn actions(client: &mut Client, uri: &str, marked: &str, context: &Value) -> Vec<(String, String)> {
    let (from, rest) = marked.split_once('«').unwrap();
    let (inside, _) = rest.split_once('»').unwrap();
    let text = marked.replace(['«', '»'], "");
    let place = |at: usize| {
        let head = &text[..at];
        let line = &head[head.rfind('\n').map_or(0, |end| end + 1)..];
        json!({ "line": head.matches('\n').count(), "character": line.encode_utf16().count() })
    };
    let range = json!({ "start": place(from.len()), "end": place(from.len() + inside.len()) });
    let asked = json!({ "textDocument": { "uri": uri }, "range": range, "context": context });
    let found = client.request("textDocument/codeAction", asked).unwrap();
    let found = found.as_array().unwrap().iter().map(|action| {
        let edits = action["edit"]["changes"][uri].as_array().unwrap();
        (action["title"].as_str().unwrap().to_owned(), applied(&text, edits))
    });
    found.collect()
}

/// The text after edits in UTF-16 columns.
fn applied(text: &str, edits: &[Value]) -> String {
    let byte = |place: &Value| {
        let number = |name: &str| usize::try_from(place[name].as_u64().unwrap()).unwrap();
        let start: usize = text.split_inclusive('\n').take(number("line")).map(str::len).sum();
        let mut units = 0;
        let mut chars = text[start..].char_indices().take_while(|(_, c)| {
            units += c.len_utf16();
            units <= number("character")
        });
        chars.by_ref().last().map_or(start, |(at, c)| start + at + c.len_utf8())
    };
    let mut places: Vec<(usize, usize, &str)> = edits
        .iter()
        .map(|edit| {
            (byte(&edit["range"]["start"]), byte(&edit["range"]["end"]), edit["newText"].as_str().unwrap())
        })
        .collect();
    places.sort_unstable();
    let mut new = text.to_owned();
    for (from, to, with) in places.into_iter().rev() {
        new.replace_range(from..to, with);
    }
    new
}

fn everything() -> Value {
    json!({ "diagnostics": [] })
}

#[test]
fn names_of_other_files_are_imported() {
    let folder = scratch("lsp_imports");
    fs::create_dir_all(folder.join("parts")).unwrap();
    fs::write(folder.join("ifs.toml"), "").unwrap();
    fs::write(
        folder.join("parts/ribs.ifs"),
        "pub let purlin = 2m\nlet secret = 3m\npub record Rib { depth: Length }\n",
    )
    .unwrap();
    // One that uses the design: to use it back would be a circle.
    fs::write(folder.join("uses.ifs"), "use \"design.ifs\" (a)\npub let crossing = a\n").unwrap();
    let (design, unsaved) = (uri(&folder.join("design.ifs")), uri(&folder.join("new.ifs")));
    let mut client = Client::start(program_path(false));
    client.initialize(&json!({}), &[]);
    client.open(&unsaved, "pub fn ridge(n: Int) -> Length = n * 1m\n");
    let mut version = 1;
    client.open(&design, "");
    let mut offered = |client: &mut Client, marked: &str| {
        version += 1;
        client.change(&design, version, json!([{ "text": marked.replace(['«', '»'], "") }]));
        let found = actions(client, &design, marked, &everything());
        found.into_iter().filter(|(title, _)| title.starts_with("import `")).collect::<Vec<_>>()
    };
    let found = offered(&mut client, "/* 😀 */ let b = «purlin» * 2\n".trim_start_matches("/* 😀 */ "));
    let expected = (
        "import `purlin`: `use \"./parts/ribs.ifs\" (purlin)`".to_owned(),
        "use \"./parts/ribs.ifs\" (purlin)\n\nlet b = purlin * 2\n".to_owned(),
    );
    assert_eq!(found, [expected]);
    let found = offered(
        &mut client,
        "use \"parts/ribs.ifs\" (purlin)\nlet b = [purlin]\nfn f(r: «Rib») -> Length = r.depth\n",
    );
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].1.starts_with("use \"parts/ribs.ifs\" (purlin, Rib)\n"), "{found:?}");
    let found = offered(&mut client, "let b = «ridge»(3)\n");
    assert_eq!(found.len(), 1, "of a document that was never saved: {found:?}");
    assert_eq!(offered(&mut client, "let b = «secret»\n"), [], "it is not offered to others");
    assert_eq!(
        offered(&mut client, "pub let a = 1m\nlet b = «crossing»\n"),
        [],
        "files would use each other"
    );
    // Three points for a curve that takes four: of its siblings the one that takes three.
    let text =
        "use std.curves (bezier3)\nfigure a = bezier3 on «((0m, 0m), (3m, 4m), (6m, 0m))» at level 3\n";
    client.change(&design, 90, json!([{ "text": text.replace(['«', '»'], "") }]));
    let found = actions(&mut client, &design, text, &everything());
    let titles: Vec<&str> = found.iter().map(|(title, _)| title.as_str()).collect();
    assert_eq!(titles, ["place `bezier2` there instead of `bezier3`"]);
    assert!(found[0].1.starts_with("use std.curves (bezier3, bezier2)\nfigure a = bezier2 on"), "{found:?}");
    // A path that leads nowhere, and the file that was meant.
    let text = "use «\"./parts/rips.ifs\"» (purlin)\nlet b = purlin\n";
    client.change(&design, 100, json!([{ "text": text.replace(['«', '»'], "") }]));
    let found = actions(&mut client, &design, text, &everything());
    let (title, after) = found.first().unwrap();
    assert_eq!(title, "replace `./parts/rips.ifs` with `./parts/ribs.ifs`");
    assert_eq!(after, "use \"./parts/ribs.ifs\" (purlin)\nlet b = purlin\n");
    client.finish();
}

#[test]
fn refactorings() {
    let folder = scratch("lsp_refactorings");
    let design = uri(&folder.join("design.ifs"));
    let mut client = Client::start(program_path(false));
    client.initialize(&json!({}), &[]);
    client.open(&design, "");
    let mut version = 1;
    let mut offered = |client: &mut Client, marked: &str, context: &Value| {
        version += 1;
        client.change(&design, version, json!([{ "text": marked.replace(['«', '»'], "") }]));
        actions(client, &design, marked, context)
    };
    let (extract, inline) = (
        json!({ "diagnostics": [], "only": ["refactor.extract"] }),
        json!({ "diagnostics": [], "only": ["refactor.inline"] }),
    );
    let marked = "let w = 2m\r\nlet names = [\"😀\"] let a = [w, «w / 2 + 1m»]\r\n";
    let found = offered(&mut client, marked, &extract);
    // Two on a line: a `let` before the item would not begin a line.
    assert_eq!(found, []);
    let marked = "let w = 2m\r\nlet a = [\"😀\", \"a\"]\r\nfn f(name: Text, b: Length) = b\r\nlet c = f(\"😀\", «w / 2 + 1m»)\r\n";
    let found = offered(&mut client, marked, &extract);
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0].0, "name `w / 2 + 1m` with a `let`");
    assert!(
        found[0].1.ends_with("= b\r\nlet value = w / 2 + 1m\r\nlet c = f(\"😀\", value)\r\n"),
        "{found:?}"
    );
    let back = found[0].1.replace("let value", "let «»value");
    let found = offered(&mut client, &back, &inline);
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0].1, marked.replace('«', "(").replace('»', ")"));
    // Asked for everything they come too, but not at each step of the caret.
    let whole = json!({ "diagnostics": [], "triggerKind": 1 });
    assert_eq!(offered(&mut client, &back, &whole).len(), 1);
    let steps = json!({ "diagnostics": [], "triggerKind": 2 });
    assert_eq!(offered(&mut client, &back, &steps), []);
    // A point where a vector is meant would be another thing with a name of its own.
    let vector = "fn f(v: Vector) -> Vector = v\nlet a = f(«(1m, 2m)»)\n";
    assert_eq!(offered(&mut client, vector, &extract), []);
    client.finish();
}

#[test]
fn all_that_is_safe_is_mended_in_one_go() {
    let design = "untitled:a.ifs";
    let mut client = Client::start(program_path(false));
    client.initialize(&json!({}), &[]);
    let marked =
        "«»use std.curves (bezier3, bspline3)\nuse std.surfaces (tensor, sheet)\n\nlet b = 3;\nlet c = b\n";
    client.open(design, &marked.replace(['«', '»'], ""));
    let context = json!({ "diagnostics": [], "only": ["source.fixAll.ifs"] });
    let found = actions(&mut client, design, marked, &context);
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0].1.trim_start(), "let b = 3\nlet c = b\n");
    client.finish();
}

#[test]
fn what_would_be_wrong_otherwise_is_not_offered() {
    let mut client = Client::start(program_path(false));
    client.initialize(&json!({}), &[]);
    let name = "untitled:judged.ifs";
    client.open(name, "");
    let mut version = 1;
    let mut offered = |marked: &str| -> Vec<(String, bool)> {
        version += 1;
        client.change(name, version, json!([{ "text": marked.replace(['«', '»'], "") }]));
        client.diagnostics(name, version);
        let (before, rest) = marked.split_once('«').unwrap();
        let place = |text: &str| {
            let line = &text[text.rfind('\n').map_or(0, |end| end + 1)..];
            json!({ "line": text.matches('\n').count(), "character": line.len() })
        };
        let end = place(&format!("{before}{}", rest.split_once('»').unwrap().0));
        let range = json!({ "start": place(before), "end": end });
        let asked = json!({ "textDocument": { "uri": name }, "range": range, "context": everything() });
        let found = client.request("textDocument/codeAction", asked).unwrap();
        let fixes = found.as_array().unwrap().iter().filter(|action| action["kind"] == "quickfix");
        let told =
            |action: &Value| (action["title"].as_str().unwrap().to_owned(), action["isPreferred"] == true);
        fixes.map(told).collect()
    };
    // The form would be wrong in another way.
    for text in ["param lean: «»= 25deg\n", "let x = [1«;» 2]\n", "let x = 12«\"»\n"] {
        assert_eq!(offered(text), [], "{text}");
    }
    assert!(offered("let x = 1«;»\n").iter().all(|(_, preferred)| *preferred));
    // Offered, but for whoever asks: something else is wrong there then.
    let doubtful = offered("fn mine(a: Int, b: Int) -> Int = a + b\nfigure f = «mime»(3)\n");
    assert_eq!(doubtful, [("replace `mime` with `mine`".to_owned(), false)]);
    let good = offered("let width = 3m\nlet half = «widht» / 2\n");
    assert_eq!(good, [("replace `widht` with `width`".to_owned(), true)]);
    // What is imported already is not imported again, and a type keeps its name.
    let twice = "use std.curves (bezier2, line)\nuse std.materials («bezier2»)\nlet a = [bezier2, line]\n";
    let titles: Vec<String> = offered(twice).into_iter().map(|(title, _)| title).collect();
    assert!(titles.iter().all(|title| !title.contains("import `bezier2`")), "{titles:?}");
    let case = offered("param «Length»: Length = 2m\nlet b: Length = Length\n");
    assert!(
        case.iter().any(|(title, _)| title == "write `length` instead of `Length` here and at its use"),
        "{case:?}"
    );
    client.finish();
}
