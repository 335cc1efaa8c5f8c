//! What fails is told when it is measured, what would mend it when that is found; and what was known stays meanwhile.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail anywhere")]

use std::time::Duration;

use ifs_tests::client::Client;
use ifs_tests::program_path;
use serde_json::{Value, json};

const URI: &str = "untitled:vault.ifs";

/// What is said of the mitres.
fn failed(list: &[Value]) -> Option<&str> {
    list.iter().find(|one| one["code"] == "E0813")?["message"].as_str()
}

#[test]
fn remedies_follow_what_was_measured_and_stay() {
    let mut client = Client::start(program_path(false));
    client.initialize(&json!({}), &[]);
    let path = ifs_tests::root().join("examples/vault.ifs");
    #[allow(clippy::disallowed_methods, reason = "the tests read the examples")]
    let text = std::fs::read_to_string(path).unwrap().replace("mitre <= 45deg", "mitre <= 1deg");
    client.open(URI, &text);
    let measured = client.diagnostics_until(URI, |list| failed(list).is_some());
    // The client may hear of both at once.
    let first = failed(&measured).unwrap().split("\nhelp:").next().unwrap().to_owned();
    let mended =
        client.diagnostics_until(URI, |list| failed(list).is_some_and(|message| message.contains("help:")));
    assert!(failed(&mended).unwrap().starts_with(&first), "the rest is the same");
    // A line before it: it is worked out again, and what is shown does not come and go.
    let start = json!({ "line": 0, "character": 0 });
    client.change(URI, 2, json!([{ "range": { "start": start, "end": start }, "text": "// x\n" }]));
    let moved = client.diagnostics(URI, 2);
    assert_eq!(failed(&moved), failed(&mended));
    for message in client.said(Duration::from_millis(1500)) {
        if message["params"]["version"] == 2
            && let Some(list) = message["params"]["diagnostics"].as_array()
        {
            assert_eq!(failed(list), failed(&mended));
        }
    }
    client.finish();
}
