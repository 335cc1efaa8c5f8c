//! Thousands of random edits in one burst, with requests between them: the server's text is that of a model written here,
//! and what it says of it is what a new server says.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail anywhere")]

use std::time::Duration;

use ifs_tests::client::{Client, Refused};
use ifs_tests::program_path;
use serde_json::{Value, json};

const EDITS: usize = 10_000;
const URI: &str = "untitled:Entwurf%20%F0%9F%8F%A0.ifs";
const REQUEST_CANCELLED: i64 = -32800;
const CONTENT_MODIFIED: i64 = -32801;

const WORDS: &[&str] = &[
    "let a = 1m\n",
    "param b: Length = 2m\r\n",
    "😀",
    "🏠🏠",
    "ß",
    "字",
    "\n",
    "\r\n",
    "\r",
    "(",
    ")",
    "{",
    "}",
    " ",
    "\t",
    "// x\n",
    "a",
    "b + 1",
    "\"text",
    "\"",
    "figure f = a",
    "1e3mm",
    "\u{301}",
    "",
    "",
    "",
];

/// Numbers that look random and are the same in every run (Marsaglia's xorshift, 2003).
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % end.max(1) as u64) as usize
    }
}

/// A document as the protocol counts it: code units of UTF-16, in lines that end with LF, CR LF, or CR.
struct Model {
    units: Vec<u16>,
}

impl Model {
    /// Start and end of each line, without what ends it.
    fn lines(&self) -> Vec<(usize, usize)> {
        let (mut lines, mut start, mut at) = (Vec::new(), 0, 0);
        while at < self.units.len() {
            let wide = match (self.units[at], self.units.get(at + 1)) {
                (13, Some(10)) => 2,
                (10 | 13, _) => 1,
                _ => {
                    at += 1;
                    continue;
                }
            };
            lines.push((start, at));
            at += wide;
            start = at;
        }
        lines.push((start, at));
        lines
    }

    /// A place, sometimes beyond the end of its line, never inside of a character.
    fn place(&self, random: &mut Random) -> (usize, Value) {
        let lines = self.lines();
        let line = random.below(lines.len());
        let (start, end) = lines[line];
        let mut at = start + random.below(end - start + 1);
        if at < end && (0xDC00..0xE000).contains(&self.units[at]) {
            at -= 1;
        }
        let beyond = if at == end { random.below(3) } else { 0 };
        (at, json!({ "line": line, "character": at - start + beyond }))
    }

    /// A random change as the protocol has it, made here too.
    fn change(&mut self, random: &mut Random) -> Value {
        let ((mut from, mut start), (mut to, mut end)) = (self.place(random), self.place(random));
        // Mostly near, so that the text stays.
        if from.abs_diff(to) > 12 {
            (to, end) = (from, start.clone());
        }
        if from > to {
            (from, start, to, end) = (to, end, from, start);
        }
        let word = WORDS[random.below(WORDS.len())];
        self.units.splice(from..to, word.encode_utf16());
        json!({ "range": { "start": start, "end": end }, "text": word })
    }

    fn text(&self) -> String {
        String::from_utf16(&self.units).unwrap()
    }
}

#[test]
fn ten_thousand_edits_in_a_burst() {
    let mut random = Random(0x2545_F491_4F6C_DD1D);
    let mut model = Model { units: "let a = 1m // 😀\r\nlet b = a + 2\r\n".encode_utf16().collect() };
    let mut client = Client::start(program_path(false));
    client.initialize(&json!({}), &[]);
    client.open(URI, &model.text());
    let (mut asked, mut version) = (Vec::new(), 1);
    for turn in 0..EDITS {
        version += 1;
        let changes: Vec<Value> = (0..1 + random.below(3)).map(|_| model.change(&mut random)).collect();
        client.change(URI, version, json!(changes));
        if turn % 10 == 0 {
            let (_, position) = model.place(&mut random);
            let method = ["hover", "documentSymbol", "formatting", "documentHighlight"][random.below(4)];
            let params = json!({ "textDocument": { "uri": URI }, "position": position,
                "options": { "tabSize": 4, "insertSpaces": true } });
            let id = client.begin(&format!("textDocument/{method}"), params);
            let cancelled = random.below(3) == 0;
            if cancelled {
                client.notify("$/cancelRequest", json!({ "id": id }));
            }
            asked.push((id, cancelled));
        }
    }
    let mut counts = [0; 3];
    for (id, cancelled) in asked {
        match client.answer(id) {
            Ok(_) => counts[0] += 1,
            Err(Refused { code: CONTENT_MODIFIED, .. }) => counts[1] += 1,
            Err(Refused { code: REQUEST_CANCELLED, .. }) if cancelled => counts[2] += 1,
            Err(refused) => panic!("request {id}, cancelled: {cancelled}: {refused:?}"),
        }
    }
    let [_, modified, cancelled] = counts;
    assert!(cancelled > 100 && modified > 100, "answered, modified, cancelled: {counts:?}");
    let found = client.diagnostics(URI, version);
    let mut cold = Client::start(program_path(false));
    cold.initialize(&json!({}), &[]);
    cold.open(URI, &model.text());
    assert_eq!(found, cold.diagnostics(URI, 1), "what is wrong with the last text");
    assert!(!found.is_empty(), "a random text has errors");
    // Every line becomes a comment that is indented: laying it out gives the whole text.
    for line in (0..model.lines().len()).rev() {
        let start = model.lines()[line].0;
        model.units.splice(start..start, "    // ".encode_utf16());
        version += 1;
        let place = json!({ "line": line, "character": 0 });
        client.change(
            URI,
            version,
            json!([{ "range": { "start": place, "end": place }, "text": "    // " }]),
        );
    }
    cold.change(URI, 2, json!([{ "text": model.text() }]));
    let format = json!({ "textDocument": { "uri": URI }, "options": { "tabSize": 4, "insertSpaces": true } });
    let laid_out = client.request("textDocument/formatting", format.clone()).unwrap();
    assert_eq!(laid_out, cold.request("textDocument/formatting", format).unwrap());
    let whole = laid_out[0]["newText"].as_str().expect("one edit of all lines");
    let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(words(whole), words(&model.text()), "the text of the model is the server's");
    client.finish();
    cold.finish();
}

#[test]
fn places_count_bytes_where_the_client_does() {
    for (encoding, after) in [("utf-8", 18), ("utf-16", 16)] {
        let mut client = Client::start(program_path(false));
        let said = json!({ "general": { "positionEncodings": [encoding, "utf-16"] } });
        assert_eq!(client.initialize(&said, &[])["positionEncoding"], encoding);
        client.open("untitled:a", "let a = 1\nlet b = 2m // 😀ü 😀\n");
        let of = |column: usize| json!({ "line": 1, "character": column });
        client.change(
            "untitled:a",
            2,
            json!([{ "range": { "start": of(10), "end": of(after) }, "text": " + 1 // ü " }]),
        );
        let found = client.diagnostics("untitled:a", 2);
        let symbols = client
            .request("textDocument/documentSymbol", json!({ "textDocument": { "uri": "untitled:a" } }))
            .unwrap();
        assert!(symbols.to_string().contains("\"b\""), "{symbols}");
        assert!(found.iter().any(|one| one["range"]["start"]["line"] == 1), "{found:#?}");
        client.finish();
    }
}

#[test]
fn diagnostics_stay_with_their_words_between_evaluations() {
    let mut client = Client::start(program_path(false));
    client.initialize(&json!({}), &[]);
    let path = ifs_tests::root().join("examples/vault.ifs");
    #[allow(clippy::disallowed_methods, reason = "the tests read the examples")]
    let text = std::fs::read_to_string(path).unwrap().replace("mitre <= 45deg", "mitre <= 1deg");
    let uri = "untitled:vault.ifs";
    client.open(uri, &text);
    let line = text.lines().position(|line| line.contains("mitre <= 1deg")).unwrap();
    let fails = |list: &[Value]| list.iter().any(|one| one["code"] == "E0813");
    let found = client.diagnostics_until(uri, fails);
    let failed = found.iter().find(|one| one["code"] == "E0813").unwrap();
    assert_eq!(failed["range"]["start"]["line"], line, "at the line that asks");
    let related = failed["relatedInformation"].to_string();
    assert!(related.contains("vault-") && related.contains("deg"), "it names the worst planks: {related}");
    client.said(Duration::from_millis(50));
    // Two lines before it: it moves at once, before anything is worked out again.
    let start = json!({ "line": 0, "character": 0 });
    client.change(uri, 2, json!([{ "range": { "start": start, "end": start }, "text": "// x\n// y\n" }]));
    let moved = client.diagnostics(uri, 2);
    let failed = moved.iter().find(|one| one["code"] == "E0813").expect("it is still there");
    assert_eq!(failed["range"]["start"]["line"], line + 2);
    // And goes when it is mended.
    let of = |column: usize| json!({ "line": line + 2, "character": column });
    let ends = text.lines().nth(line).unwrap().len();
    client.change(
        uri,
        3,
        json!([{ "range": { "start": of(0), "end": of(ends) }, "text": "    require mitre <= 45deg" }]),
    );
    client.diagnostics_until(uri, |list| !fails(list));
    client.finish();
}
