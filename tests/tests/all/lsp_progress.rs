//! While a design is worked out that takes long, a client that can show it is told; what is done at once is not.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail anywhere")]

use std::time::Duration;

use ifs_tests::client::Client;
use ifs_tests::program_path;
use serde_json::{Value, json};

const URI: &str = "untitled:shell.ifs";

/// Curved quads that no iteration makes flat enough.
const LONG: &str = "use std.curves (bspline3)
use std.surfaces (sheet)
use std.materials (birch_plywood)
let net = [[(i * 1m, j * 1m, 1m * sin(40deg * i * j)) for j in 0..7] for i in 0..7]
figure roof = sheet(bspline3, bspline3, net) at level 4
fabricate roof as panels {
    material: birch_plywood(12mm)
    board: 2500mm by 1250mm
    planarize: { iterations: 100000, threshold: 0.999999999, pin: boundary }
}
";

fn progress(message: &Value) -> Option<&Value> {
    (message["method"] == "$/progress").then(|| &message["params"]["value"])
}

#[test]
fn what_takes_long_is_shown_until_it_ends() {
    let mut client = Client::start(program_path(false));
    client.initialize(&json!({ "window": { "workDoneProgress": true } }), &[]);
    client.open(URI, LONG);
    let made = client.wait("a token", |message| message["method"] == "window/workDoneProgress/create");
    let began = client.wait("its begin", |message| progress(message).is_some_and(|it| it["kind"] == "begin"));
    assert_eq!(began["params"]["token"], made["params"]["token"]);
    assert_eq!(progress(&began).unwrap()["title"], "Working out");
    let words = |message: &Value| progress(message).and_then(|it| it["message"].as_str().map(str::to_owned));
    let report = client.wait("how far it is", |message| {
        words(message)
            .is_some_and(|words| words.starts_with("untitled:shell.ifs: planarizes roof, iteration "))
    });
    assert!(words(&report).unwrap().contains(" of at most 100000, worst planarity 0."), "{report}");
    // The next edit ends it; what comes then is done in a moment.
    client.change(URI, 2, json!([{ "text": "let a = 3\n" }]));
    let ended = client.wait("its end", |message| progress(message).is_some_and(|it| it["kind"] == "end"));
    assert_eq!(ended["params"]["token"], made["params"]["token"]);
    let later = client.said(Duration::from_millis(1200));
    assert!(!later.iter().any(|message| message["method"] == "window/workDoneProgress/create"), "{later:?}");
    client.finish();
}

#[test]
fn who_cannot_show_it_is_not_asked() {
    let mut client = Client::start(program_path(false));
    client.initialize(&json!({}), &[]);
    client.open(URI, LONG);
    let said = client.said(Duration::from_millis(1500));
    let of_progress =
        |message: &&Value| message["method"].as_str().is_some_and(|name| name.contains("rogress"));
    assert_eq!(said.iter().find(of_progress), None);
    client.finish();
}
