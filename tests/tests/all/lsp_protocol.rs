//! The life of a language server as a process: hello and goodbye, bytes that are no messages, panics, and clients that die.
#![allow(clippy::disallowed_methods, reason = "the tests start processes")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail anywhere")]

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::{Files, ReadError};
use ifs_lsp::{Project, Projects};
use ifs_tests::client::Client;
use ifs_tests::program_path;
use serde_json::{Value, json};

const PARSE_ERROR: i64 = -32700;
const INVALID_REQUEST: i64 = -32600;
const METHOD_NOT_FOUND: i64 = -32601;
const INVALID_PARAMS: i64 = -32602;
const INTERNAL_ERROR: i64 = -32603;
const NOT_INITIALIZED: i64 = -32002;

/// How soon the process ends when its client is gone.
const SOON: Duration = Duration::from_secs(2);

fn server() -> Client {
    Client::start(program_path(false))
}

fn code(client: &mut Client, method: &str, params: Value) -> i64 {
    client.request(method, params).expect_err(method).code
}

fn hover(uri: &str) -> Value {
    json!({ "textDocument": { "uri": uri }, "position": { "line": 0, "character": 5 } })
}

#[test]
fn requests_have_their_time() {
    let mut client = server();
    let uri = "untitled:x.ifs";
    assert_eq!(code(&mut client, "textDocument/hover", hover(uri)), NOT_INITIALIZED);
    assert_eq!(code(&mut client, "shutdown", Value::Null), NOT_INITIALIZED);
    // What is said before hello is not heard.
    client.open(uri, "let a = 1\n");
    let capabilities = client.initialize(&json!({}), &[]);
    assert_eq!(capabilities["positionEncoding"], "utf-16");
    assert_eq!(code(&mut client, "textDocument/hover", hover(uri)), INVALID_PARAMS);
    assert_eq!(code(&mut client, "initialize", json!({ "capabilities": {} })), INVALID_REQUEST);
    client.open(uri, "let a = 1\n");
    assert!(client.request("textDocument/hover", hover(uri)).unwrap().is_object());
    assert_eq!(client.request("shutdown", Value::Null), Ok(Value::Null));
    assert_eq!(code(&mut client, "textDocument/hover", hover(uri)), INVALID_REQUEST);
    assert_eq!(code(&mut client, "shutdown", Value::Null), INVALID_REQUEST);
    client.notify("exit", Value::Null);
    assert_eq!(client.ended(SOON).code(), Some(0));
}

#[test]
fn to_leave_without_a_word_is_1() {
    let mut client = server();
    client.notify("exit", Value::Null);
    assert_eq!(client.ended(SOON).code(), Some(1), "before hello");
    let mut client = server();
    client.initialize(&json!({}), &[]);
    client.notify("exit", Value::Null);
    assert_eq!(client.ended(SOON).code(), Some(1), "without shutdown");
    let mut client = server();
    client.close();
    assert_eq!(client.ended(SOON).code(), Some(1), "the input ended");
}

#[test]
fn the_end_of_the_input_ends_a_server_at_work() {
    let mut client = server();
    client.initialize(&json!({}), &[]);
    // A shell whose planarizing takes minutes.
    let path = ifs_tests::root().join("examples/shell.ifs");
    let text = std::fs::read_to_string(&path).unwrap().replace("at level 2", "at level 5");
    client.open("untitled:shell.ifs", &text);
    let asked = client
        .begin("textDocument/documentSymbol", json!({ "textDocument": { "uri": "untitled:shell.ifs" } }));
    thread::sleep(Duration::from_millis(300));
    client.close();
    assert_eq!(client.ended(SOON).code(), Some(1));
    assert!(
        client.answer(asked).unwrap().as_array().is_some_and(|all| !all.is_empty()),
        "what was asked is answered"
    );
}

#[test]
fn a_dead_parent_ends_the_server() {
    let mut parent = Command::new("sleep").arg("60").spawn().unwrap();
    let mut client = server();
    let hello = json!({ "processId": parent.id(), "capabilities": {} });
    client.request("initialize", hello).unwrap();
    client.notify("initialized", json!({}));
    parent.kill().unwrap();
    parent.wait().unwrap();
    // The input stays open.
    assert_eq!(client.ended(SOON).code(), Some(1));
}

#[test]
fn a_reader_that_goes_away_ends_the_server() {
    let (reader, writer) = std::io::pipe().unwrap();
    let mut child = Command::new(program_path(false))
        .arg("lsp")
        .stdin(std::process::Stdio::piped())
        .stdout(writer)
        .spawn()
        .unwrap();
    drop(reader);
    let mut input = child.stdin.take().unwrap();
    let body = r#"{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}"#;
    std::io::Write::write_all(&mut input, format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes())
        .unwrap();
    let end = Instant::now() + SOON;
    while child.try_wait().unwrap().is_none() {
        assert!(Instant::now() < end, "nobody reads any more");
        thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn bytes_that_are_no_message_are_refused_and_the_server_lives() {
    let mut client = server();
    client.initialize(&json!({}), &[]);
    let framed = |body: &str| format!("Content-Length: {}\r\n\r\n{body}", body.len());
    let deep = "[".repeat(100_000);
    for (bytes, code) in [
        (framed("{"), PARSE_ERROR),
        (framed("nonsense"), PARSE_ERROR),
        (framed(""), PARSE_ERROR),
        (framed(&deep), PARSE_ERROR),
        (framed("[]"), INVALID_REQUEST),
        (framed("7"), INVALID_REQUEST),
        (framed(r#"{"jsonrpc":"1.0","id":1,"method":"shutdown"}"#), INVALID_REQUEST),
        (framed(r#"{"jsonrpc":"2.0","id":{},"method":"shutdown"}"#), INVALID_REQUEST),
        (framed(r#"{"jsonrpc":"2.0","method":7}"#), INVALID_REQUEST),
        ("Content-Length: 99999999999999999999\r\n\r\n".to_owned(), PARSE_ERROR),
        ("Content-Length: 18446744073709551615\r\n\r\n".to_owned(), PARSE_ERROR),
        ("Content-Length: -5\r\n\r\n".to_owned(), PARSE_ERROR),
        ("Content-Length: \r\n\r\n".to_owned(), PARSE_ERROR),
        ("Host: nowhere\r\n\r\n".to_owned(), PARSE_ERROR),
        (
            framed("{}").replace("\r\n\r\n", "\r\nContent-Type: application/x; charset=utf-16\r\n\r\n"),
            PARSE_ERROR,
        ),
    ] {
        client.send_bytes(bytes.as_bytes());
        assert_eq!(client.refusal().code, code, "{}", &bytes[..bytes.len().min(80)]);
    }
    client.send_bytes(b"Content-Length: 4\r\n\r\n\"\xff\xfe\"");
    assert_eq!(client.refusal().code, PARSE_ERROR);
    // Too short a length: the rest of the message is passed over.
    client.send_bytes(framed(r#"{"jsonrpc":"2.0","method":"$/none"}"#).replace("35", "30").as_bytes());
    assert_eq!(client.refusal().code, PARSE_ERROR);
    assert_eq!(code(&mut client, "textDocument/nonsense", json!({})), METHOD_NOT_FOUND);
    assert_eq!(code(&mut client, "textDocument/hover", json!({})), INVALID_PARAMS);
    assert_eq!(code(&mut client, "textDocument/hover", json!([1, 2])), INVALID_PARAMS);
    client.notify("$/nonsense", json!({}));
    client.notify("textDocument/nonsense", json!({}));
    client.notify("textDocument/didChange", json!({ "textDocument": 7 }));
    client.send(&json!({ "jsonrpc": "2.0", "id": 4711, "result": "nobody asked" }));
    // Numbers of requests may be texts.
    client.send(&json!({ "jsonrpc": "2.0", "id": "s", "method": "textDocument/nonsense" }));
    assert_eq!(code(&mut client, "textDocument/hover", hover("file:///no/where.ifs")), INVALID_PARAMS);
    client.finish();
}

#[test]
fn what_is_unknown_changes_nothing() {
    let mut client = server();
    client.initialize(&json!({}), &[]);
    let uri = "untitled:a.ifs";
    client.change("untitled:b.ifs", 2, json!([{ "text": "let" }]));
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": "untitled:b.ifs" } }));
    client.open(uri, "let a = 1m + 1\n");
    assert_eq!(client.diagnostics(uri, 1).len(), 1);
    let far = json!({ "start": { "line": 9, "character": 4_000_000_000_u32 }, "end": { "line": 0, "character": 0 } });
    client.change(uri, 2, json!([{ "range": far, "text": "let b = 1m + 2\n" }]));
    assert_eq!(client.diagnostics(uri, 2).len(), 2, "places beyond the text are its end");
    client.finish();
}

/// A disk whose every file is there and says the same, and which fails when it is asked for a project's designs, or for the
/// project of a design that is called so.
struct Failing;

struct Same;

impl Files for Same {
    fn read(&self, _: &str) -> Result<Vec<u8>, ReadError> {
        Ok(b"let a = 1\n".to_vec())
    }
}

impl Projects for Failing {
    fn project(&self, path: &Path, _: &dyn Fn(&Path) -> Option<String>) -> Option<Project> {
        assert!(!path.ends_with("failing.ifs"), "as this test wants it");
        Some(Project {
            root: path.parent()?.to_owned(),
            design: path.file_name()?.to_str()?.to_owned(),
            files: Arc::new(Same),
            overrides: Overrides::default(),
        })
    }

    fn files(&self, _: &Path, _: &str) -> Vec<PathBuf> {
        panic!("as this test wants it");
    }

    fn library(&self, _: &str) -> Option<PathBuf> {
        None
    }
}

#[test]
fn a_panic_is_an_error_reply_and_the_server_lives() {
    let (input, to_server) = std::io::pipe().unwrap();
    let (from_server, output) = std::io::pipe().unwrap();
    let server = thread::spawn(|| ifs_lsp::serve_on(input, output, Arc::new(Failing)));
    let mut client = Client::over(from_server, to_server);
    client.initialize(&json!({}), &[]);
    let uri = "file:///somewhere/a.ifs";
    client.open(uri, "let a = 1\nlet b = a\n");
    let at = |uri: &str| {
        json!({ "textDocument": { "uri": uri }, "position": { "line": 0, "character": 4 },
        "context": { "includeDeclaration": true } })
    };
    for _ in 0..20 {
        let refused = client.request("textDocument/references", at(uri)).unwrap_err();
        assert_eq!(refused.code, INTERNAL_ERROR);
        assert!(refused.message.contains("report"), "{refused:?}");
    }
    // A panic while the documents are read: it is said, and the other documents live.
    let failing = "file:///somewhere/failing.ifs";
    client.open(failing, "let a = 1\n");
    assert_eq!(client.request("textDocument/hover", at(failing)).unwrap_err().code, INTERNAL_ERROR);
    client.wait("the failure", |message| message["method"] == "window/logMessage");
    client.change(uri, 2, json!([{ "text": "let a = 1m\n" }]));
    let hover = client.request("textDocument/hover", at(uri)).unwrap().to_string();
    assert!(hover.contains("Length"), "{hover}");
    client.finish();
    assert!(server.join().unwrap().unwrap(), "shut down in order");
}
