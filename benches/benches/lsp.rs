//! The language server as a client feels it: from a keystroke to what is wrong with the text, to answers, to what is wrong
//! with the boards; and its memory over many edits. The aims are printed beside the figures; nothing is asserted, since
//! machines differ.

#![allow(
    clippy::expect_used,
    clippy::disallowed_methods,
    reason = "a benchmark reads clocks and ends where it fails"
)]

use std::fs;
use std::thread;
use std::time::{Duration, Instant};

use ifs_benches::large;
use ifs_benches::processes::{build_release, millis};
use ifs_tests::client::Client;
use serde_json::json;

const KEYSTROKES: usize = 200;
const REQUESTS: usize = 200;
const EDITS: i64 = 10_000;
/// Between two keystrokes of a quick writer.
const PAUSE: Duration = Duration::from_millis(60);

/// A surface of 64 by 64 boards; how flat they must be is changed.
const BOARDS: &str = "\
use std.curves (bezier3)
use std.surfaces (tensor)
use std.materials (birch_plywood)

let net = [[(i * 8m, j * 8m, 300mm * i * j) for j in 0..4] for i in 0..4]
figure roof = tensor(bezier3, bezier3) on net at level 6

fabricate roof as panels {
    material: birch_plywood(12mm)
    board: 2500mm by 1250mm
    require planarity >= 0.9
}
";

fn main() {
    let program = build_release();
    let start = || {
        let mut client = Client::start(&program);
        client.initialize(&json!({}), &[]);
        client
    };
    for (lines, aim) in [(1_000, 16), (10_000, 100)] {
        let mut client = start();
        keystrokes(&mut client, lines, aim);
        requests(&mut client, "hover");
        requests(&mut client, "completion");
        client.finish();
        let mut client = start();
        completions_with_keystrokes(&mut client, lines);
        client.finish();
    }
    let mut client = start();
    boards(&mut client);
    client.finish();
    let mut client = start();
    memory(&mut client);
    client.finish();
}

const URI: &str = "untitled:long.ifs";

/// Where things are written: a line of its own at the end of the imports.
const LINE: usize = 6;

/// Replaces so many columns of that line.
fn write(client: &mut Client, version: i64, (column, columns): (usize, usize), text: &str) {
    let place = |column: usize| json!({ "line": LINE, "character": column });
    let range = json!({ "start": place(column), "end": place(column + columns) });
    client.change(URI, version, json!([{ "range": range, "text": text }]));
}

const WRITTEN: &str = "let some_name = max(1m, 250mm) * 2  // and why";

/// Writes a line again and again, and asks at each letter; what was asked takes its version and its column.
fn at_each_key(
    client: &mut Client,
    lines: usize,
    mut ask: impl FnMut(&mut Client, i64, usize),
) -> Vec<Duration> {
    client.open(URI, &large::design("all", lines));
    client.diagnostics(URI, 1);
    let keys = WRITTEN.chars().cycle().take(KEYSTROKES).enumerate().zip(2..);
    let time = |((place, key), version): ((usize, char), i64)| {
        let column = place % WRITTEN.len();
        // The first letter takes the place of the line that was written before.
        let replaced = if column == 0 { WRITTEN.len() } else { 0 };
        let start = Instant::now();
        write(client, version, (column, replaced), key.encode_utf8(&mut [0; 4]));
        ask(client, version, column);
        let time = start.elapsed();
        thread::sleep(PAUSE);
        time
    };
    keys.map(time).collect()
}

fn keystrokes(client: &mut Client, lines: usize, aim: u32) {
    let times = at_each_key(client, lines, |client, version, _| {
        client.diagnostics(URI, version);
    });
    print(&format!("{lines} lines, keystroke to syntax and types"), times, aim);
}

/// What a list of completions takes that opens with the letter: the text is read anew for it.
fn completions_with_keystrokes(client: &mut Client, lines: usize) {
    let times = at_each_key(client, lines, |client, _, column| {
        let behind = json!({ "line": LINE, "character": column + 1 });
        let params = json!({ "textDocument": { "uri": URI }, "position": behind });
        client.request("textDocument/completion", params).expect("completions");
    });
    print(&format!("{lines} lines, completion with its keystroke"), times, 10);
}

fn requests(client: &mut Client, what: &str) {
    let mut times = Vec::new();
    for turn in 0..REQUESTS {
        let params =
            json!({ "textDocument": { "uri": URI }, "position": { "line": 20 + turn, "character": 9 } });
        let start = Instant::now();
        if let Err(refused) = client.request(&format!("textDocument/{what}"), params) {
            println!("{what}: {}", refused.message);
            return;
        }
        times.push(start.elapsed());
    }
    print(what, times, 10);
}

fn boards(client: &mut Client) {
    client.open(URI, BOARDS);
    let line = BOARDS.lines().position(|line| line.contains("require")).expect("a requirement");
    let mut times = Vec::new();
    for version in 2..=41_i64 {
        // Flat enough and not in turn: what is found shows which text was worked out.
        let (limit, fails) = if version % 2 == 0 { ("1", true) } else { ("0.9", false) };
        let (start, end) =
            (json!({ "line": line, "character": 25 }), json!({ "line": line, "character": 99 }));
        let began = Instant::now();
        client.change(URI, version, json!([{ "range": { "start": start, "end": end }, "text": limit }]));
        client.wait("the requirement", |message| {
            let found = message["params"]["diagnostics"].as_array();
            let failed = found.is_some_and(|found| found.iter().any(|one| one["code"] == "E0810"));
            message["params"]["version"] == version && failed == fails
        });
        times.push(began.elapsed());
    }
    print("4096 boards, keystroke to requirements", times, 500);
}

fn memory(client: &mut Client) {
    client.open(URI, &large::design("all", 1_000));
    client.diagnostics(URI, 1);
    for version in 2..EDITS + 2 {
        let text = if version % 40 == 1 { "\n" } else { "a" };
        write(client, version, (0, 0), text);
        if version % 50 == 0 {
            client.diagnostics(URI, version);
        }
        if [100, 2_000, 4_000, 6_000, 8_000, EDITS].contains(&version) {
            client.diagnostics_until(URI, |_| true);
            println!("after {version} edits: {:.1} MiB", resident(client.process()));
        }
    }
}

/// What a process has in memory, in MiB.
fn resident(process: u32) -> f64 {
    let status = fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:")).unwrap_or_default();
    line.trim().trim_end_matches(" kB").parse::<f64>().unwrap_or_default() / 1024.0
}

fn print(what: &str, mut times: Vec<Duration>, aim: u32) {
    times.sort_unstable();
    let of = |hundredths: usize| millis(times[(times.len() - 1) * hundredths / 100]);
    println!("{what}: p50 {:.1} ms, p95 {:.1} ms (aim {aim} ms)", of(50), of(95));
}
