//! A client of the language server for tests and benchmarks: it frames messages, gives each request its number, keeps what
//! the server says unasked, and agrees to what the server asks. What is sent and what is true of the answers is the test's.

use std::collections::{BTreeMap, VecDeque};
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

/// How long a test waits before it gives up.
pub const PATIENCE: Duration = Duration::from_secs(60);

/// An error reply.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refused {
    /// Its number.
    pub code: i64,
    /// Its words.
    pub message: String,
}

/// What a request was answered with.
pub type Answer = Result<Value, Refused>;

/// One client with its server.
pub struct Client {
    child: Option<Child>,
    input: Option<Box<dyn Write + Send>>,
    messages: Receiver<Value>,
    next: i64,
    answers: BTreeMap<String, Vec<Answer>>,
    unasked: VecDeque<Value>,
}

impl Client {
    /// Starts `ifs lsp`.
    ///
    /// # Panics
    /// The program does not start.
    pub fn start(program: &Path) -> Client {
        // The library is put where the tests may write.
        let cache = crate::root().join("target/tmp/cache");
        Self::spawn(Command::new(program).arg("lsp").env("XDG_CACHE_HOME", cache))
    }

    /// Starts a command as a server.
    ///
    /// # Panics
    /// It does not start.
    pub fn spawn(command: &mut Command) -> Client {
        let mut child = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::inherit())
            .spawn()
            .expect("the server starts");
        let (input, output) = (child.stdin.take().expect("a pipe"), child.stdout.take().expect("a pipe"));
        let mut client = Self::over(output, input);
        client.child = Some(child);
        client
    }

    /// A client of a server at the other ends of two streams.
    pub fn over(output: impl Read + Send + 'static, input: impl Write + Send + 'static) -> Client {
        let (sender, messages) = channel();
        thread::spawn(move || {
            let mut output = BufReader::new(output);
            while let Some(message) = read_message(&mut output) {
                if sender.send(message).is_err() {
                    return;
                }
            }
        });
        Client {
            child: None,
            input: Some(Box::new(input)),
            messages,
            next: 0,
            answers: BTreeMap::new(),
            unasked: VecDeque::new(),
        }
    }

    /// Says hello with these capabilities and folders, and gives the server's capabilities.
    ///
    /// # Panics
    /// The server refuses.
    pub fn initialize(&mut self, capabilities: &Value, folders: &[&Path]) -> Value {
        self.initialize_with(capabilities, folders, &Value::Null)
    }

    /// The same with initialization options.
    ///
    /// # Panics
    /// The server refuses.
    pub fn initialize_with(&mut self, capabilities: &Value, folders: &[&Path], options: &Value) -> Value {
        let folders: Vec<Value> =
            folders.iter().map(|folder| json!({ "uri": uri(folder), "name": "tests" })).collect();
        let hello = json!({
            "processId": std::process::id(),
            "capabilities": capabilities,
            "workspaceFolders": folders,
            "initializationOptions": options,
        });
        let answer = self.request("initialize", hello).expect("an answer");
        self.notify("initialized", json!({}));
        answer["capabilities"].clone()
    }

    /// Sends bytes as they are.
    ///
    /// # Panics
    /// Nobody reads them.
    pub fn send_bytes(&mut self, bytes: &[u8]) {
        let input = self.input.as_mut().expect("the input was not closed");
        input.write_all(bytes).and_then(|()| input.flush()).expect("the server reads");
    }

    /// Sends a message.
    pub fn send(&mut self, message: &Value) {
        let body = message.to_string();
        self.send_bytes(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
    }

    /// Says something that has no answer.
    #[allow(clippy::needless_pass_by_value, reason = "parameters are made where they are given")]
    pub fn notify(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// Sends a request and gives its number.
    #[allow(clippy::needless_pass_by_value, reason = "parameters are made where they are given")]
    pub fn begin(&mut self, method: &str, params: Value) -> i64 {
        self.next += 1;
        let id = self.next;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        id
    }

    /// Sends a request and waits for its answer.
    ///
    /// # Errors
    /// The error reply.
    pub fn request(&mut self, method: &str, params: Value) -> Answer {
        let id = self.begin(method, params);
        self.answer(id)
    }

    /// Waits for the answer to a request.
    ///
    /// # Errors
    /// The error reply.
    ///
    /// # Panics
    /// None comes.
    pub fn answer(&mut self, id: i64) -> Answer {
        let id = id.to_string();
        let end = Instant::now() + PATIENCE;
        loop {
            if let Some(mut answers) = self.answers.remove(&id) {
                assert_eq!(answers.len(), 1, "request {id} was answered more than once");
                return answers.remove(0);
            }
            assert!(self.take(end), "request {id} was not answered");
        }
    }

    /// Waits for an error reply to what was no message.
    ///
    /// # Panics
    /// None comes.
    pub fn refusal(&mut self) -> Refused {
        let end = Instant::now() + PATIENCE;
        loop {
            if let Some(answers) = self.answers.get_mut("null").filter(|answers| !answers.is_empty()) {
                return answers.remove(0).expect_err("an error reply");
            }
            assert!(self.take(end), "there was no error reply");
        }
    }

    /// Waits for the first thing said unasked that this is true of.
    ///
    /// # Panics
    /// None comes.
    pub fn wait(&mut self, what: &str, is: impl Fn(&Value) -> bool) -> Value {
        let end = Instant::now() + PATIENCE;
        loop {
            if let Some(place) = self.unasked.iter().position(&is) {
                return self.unasked.remove(place).expect("it is there");
            }
            assert!(self.take(end), "{what} was not said: {:?}", self.unasked);
        }
    }

    /// What was said unasked up to now, after waiting so long for more.
    pub fn said(&mut self, wait: Duration) -> Vec<Value> {
        let end = Instant::now() + wait;
        while self.take(end) {}
        self.unasked.drain(..).collect()
    }

    /// Waits for the diagnostics of a version of a document.
    pub fn diagnostics(&mut self, uri: &str, version: i64) -> Vec<Value> {
        let said = self.wait(&format!("what is wrong in version {version} of {uri}"), |message| {
            message["method"] == "textDocument/publishDiagnostics"
                && message["params"]["uri"] == uri
                && message["params"]["version"] == version
        });
        said["params"]["diagnostics"].as_array().cloned().unwrap_or_default()
    }

    /// Waits for diagnostics of a document, of whatever version, that this is true of.
    pub fn diagnostics_until(&mut self, uri: &str, is: impl Fn(&[Value]) -> bool) -> Vec<Value> {
        let list = |message: &Value| message["params"]["diagnostics"].as_array().cloned().unwrap_or_default();
        let said = self.wait(&format!("such diagnostics of {uri}"), |message| {
            message["method"] == "textDocument/publishDiagnostics"
                && message["params"]["uri"] == uri
                && is(&list(message))
        });
        list(&said)
    }

    /// Opens a document.
    pub fn open(&mut self, uri: &str, text: &str) {
        let document = json!({ "uri": uri, "languageId": "ifs", "version": 1, "text": text });
        self.notify("textDocument/didOpen", json!({ "textDocument": document }));
    }

    /// Changes a document.
    #[allow(clippy::needless_pass_by_value, reason = "changes are made where they are given")]
    pub fn change(&mut self, uri: &str, version: i64, changes: Value) {
        let document = json!({ "uri": uri, "version": version });
        self.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    }

    /// Closes the server's input.
    pub fn close(&mut self) {
        self.input = None;
    }

    /// The server's process.
    ///
    /// # Panics
    /// It has none.
    pub fn process(&self) -> u32 {
        self.child.as_ref().expect("a process").id()
    }

    /// Waits for the end of the process, at most so long.
    ///
    /// # Panics
    /// It does not end.
    pub fn ended(&mut self, within: Duration) -> ExitStatus {
        let child = self.child.as_mut().expect("a process");
        let end = Instant::now() + within;
        loop {
            if let Some(status) = child.try_wait().expect("a process can be waited for") {
                return status;
            }
            assert!(Instant::now() < end, "the server did not end within {within:?}");
            thread::sleep(Duration::from_millis(5));
        }
    }

    /// Shuts the server down as the protocol has it.
    ///
    /// # Panics
    /// It does not end well.
    pub fn finish(mut self) {
        assert_eq!(self.request("shutdown", Value::Null), Ok(Value::Null));
        self.notify("exit", Value::Null);
        if self.child.is_some() {
            assert_eq!(self.ended(Duration::from_secs(5)).code(), Some(0));
        }
    }

    /// Takes one message before a time. Requests are agreed to.
    fn take(&mut self, end: Instant) -> bool {
        let left = end.saturating_duration_since(Instant::now());
        let message = match self.messages.recv_timeout(left) {
            Ok(message) => message,
            Err(RecvTimeoutError::Timeout | RecvTimeoutError::Disconnected) => return false,
        };
        if message.get("method").is_none() {
            let answer = match message.get("error") {
                Some(error) => Err(Refused {
                    code: error["code"].as_i64().expect("a code"),
                    message: error["message"].as_str().expect("words").to_owned(),
                }),
                None => Ok(message["result"].clone()),
            };
            self.answers.entry(message["id"].to_string()).or_default().push(answer);
            return true;
        }
        if let Some(id) = message.get("id") {
            self.send(&json!({ "jsonrpc": "2.0", "id": id, "result": null }));
        }
        self.unasked.push_back(message);
        true
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        if let Some(child) = &mut self.child {
            // It is gone already where the test went well.
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

fn read_message(output: &mut impl BufRead) -> Option<Value> {
    let mut length = None;
    loop {
        let mut line = String::new();
        if output.read_line(&mut line).ok()? == 0 {
            return None;
        }
        match line.trim_end().split_once(": ") {
            Some(("Content-Length", bytes)) => length = bytes.parse().ok(),
            Some(_) => {}
            None => break,
        }
    }
    let mut body = vec![0; length?];
    output.read_exact(&mut body).ok()?;
    serde_json::from_slice(&body).ok()
}

/// The URI of a path.
pub fn uri(path: &Path) -> String {
    let mut uri = "file://".to_owned();
    for byte in path.to_str().expect("a path of a test").bytes() {
        match byte {
            b'/' | b'-' | b'.' | b'_' | b'~' => uri.push(byte.into()),
            _ if byte.is_ascii_alphanumeric() => uri.push(byte.into()),
            _ => uri += &format!("%{byte:02X}"),
        }
    }
    uri
}
