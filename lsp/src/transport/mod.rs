//! Messages from a stream to the service and back. Each is begun in the order it came, before the next one is looked at, so
//! that what a handler does before it first waits keeps its order; then they go on beside each other. What they say is
//! `server`'s.
//!
//! tower-lsp's own transport ends with the first message it cannot read, keeps `$/cancelRequest` waiting behind full places,
//! and answers nothing where a handler panics.

mod frames;

use std::future::poll_fn;
use std::io::{BufReader, Read, Write};
use std::panic::AssertUnwindSafe;
use std::pin::Pin;
use std::sync::Arc;
use std::task::Poll;
use std::thread;
use std::time::Duration;

use futures_util::{FutureExt, SinkExt, StreamExt};
use serde_json::Value;
use tokio::sync::{OwnedSemaphorePermit, Semaphore, mpsc, oneshot};
use tokio::task::JoinSet;
use tokio::time::timeout;
use tower_lsp::jsonrpc::{Error, Id, Request, Response};
use tower_lsp::{ClientSocket, ExitedError, LanguageServer, LspService};
use tower_service::Service;

use crate::protocol::errors::failed;
use frames::Frame;

/// How many messages may wait to be looked at.
const WAITING: usize = 256;
/// How many things said unasked may wait to be taken by the client. Answers are as many as it asks.
const UNASKED: usize = 16;
/// How long what is under way may still take when the input has ended, and what is written to be taken.
const LAST_WORDS: Duration = Duration::from_millis(700);

/// What comes from the client's side.
enum Incoming {
    Frame(Frame),
    /// It has ended, or nobody reads any more.
    End,
}

/// A request that was begun.
type Begun = Pin<Box<dyn Future<Output = Option<Response>> + Send>>;

/// Serves until the input ends, nobody reads the output, or the client says `exit`.
pub(crate) async fn serve<S: LanguageServer>(
    input: impl Read + Send + 'static,
    output: impl Write + Send + 'static,
    mut service: LspService<S>,
    socket: ClientSocket,
) {
    let (came, mut incoming) = mpsc::channel(WAITING);
    let (out, written) = write(output, came.clone());
    let places = Arc::new(Semaphore::new(UNASKED));
    read(input, came);
    let (mut asked, mut answers) = socket.split();
    let asking = out.clone();
    let asks = tokio::spawn(async move {
        while let Some(request) = asked.next().await {
            let place = Arc::clone(&places).acquire_owned().await.ok();
            send(&asking, &request, place);
        }
    });
    let mut under_way = JoinSet::new();
    while let Some(Incoming::Frame(frame)) = incoming.recv().await {
        while under_way.try_join_next().is_some() {}
        match message(frame) {
            Ok(Message::Request(request)) => {
                let exits = request.method() == "exit";
                let mut begun = begin(&mut service, request);
                match poll_fn(|context| Poll::Ready(begun.as_mut().poll(context))).await {
                    Poll::Ready(Some(response)) => send(&out, &response, None),
                    Poll::Ready(None) => {}
                    Poll::Pending => {
                        let out = out.clone();
                        under_way.spawn(async move {
                            if let Some(response) = begun.await {
                                send(&out, &response, None);
                            }
                        });
                    }
                }
                if exits {
                    under_way.abort_all();
                    break;
                }
            }
            Ok(Message::Response(response)) => {
                // It fails after `exit` only.
                let _ = answers.send(response).await;
            }
            Err(error) => send(&out, &Response::from_error(Id::Null, error), None),
        }
    }
    // Who asked and closed the stream still gets what is soon done.
    let _ = timeout(LAST_WORDS, async { while under_way.join_next().await.is_some() {} }).await;
    under_way.abort_all();
    asks.abort();
    let _ = asks.await;
    while under_way.join_next().await.is_some() {}
    drop(out);
    let _ = timeout(LAST_WORDS, written).await;
}

/// Begins a request; a panic in it becomes an error reply.
fn begin<S: LanguageServer>(service: &mut LspService<S>, request: Request) -> Begun {
    let id = request.id().cloned();
    let answer = service.call(request);
    Box::pin(async move {
        match AssertUnwindSafe(answer).catch_unwind().await {
            Ok(Ok(response)) => response,
            Ok(Err(ExitedError { .. })) => id.map(|id| Response::from_error(id, Error::invalid_request())),
            Err(_) => id.map(|id| Response::from_error(id, failed())),
        }
    })
}

enum Message {
    Request(Request),
    Response(Response),
}

/// What a frame says; else the error that answers it.
fn message(frame: Frame) -> Result<Message, Error> {
    let said = |mut error: Error, words: String| {
        error.message = words.into();
        error
    };
    let bytes = match frame {
        Frame::Message(bytes) => bytes,
        Frame::Broken(why) => return Err(said(Error::parse_error(), why)),
    };
    let value: Value = serde_json::from_slice(&bytes)
        .map_err(|error| said(Error::parse_error(), format!("the message is no JSON: {error}")))?;
    let is_request = value.get("method").is_some();
    let found = if is_request {
        serde_json::from_value(value).map(Message::Request)
    } else {
        serde_json::from_value(value).map(Message::Response)
    };
    found.map_err(|error| said(Error::invalid_request(), format!("the message is no request: {error}")))
}

/// The bytes of a message, and the place it takes until it is written.
type Outgoing = (Vec<u8>, Option<OwnedSemaphorePermit>);

fn send(
    out: &mpsc::UnboundedSender<Outgoing>,
    message: &impl serde::Serialize,
    place: Option<OwnedSemaphorePermit>,
) {
    // A message of ours can always be written as JSON; nobody reads any more where the channel is closed.
    if let Ok(body) = serde_json::to_vec(message) {
        let mut bytes = format!("Content-Length: {}\r\n\r\n", body.len()).into_bytes();
        bytes.extend(body);
        let _ = out.send((bytes, place));
    }
}

/// Reads on a thread of its own, which may hang as long as the input does.
fn read(input: impl Read + Send + 'static, came: mpsc::Sender<Incoming>) {
    thread::spawn(move || {
        let mut input = BufReader::new(input);
        while let Some(frame) = frames::next(&mut input) {
            if came.blocking_send(Incoming::Frame(frame)).is_err() {
                return;
            }
        }
        let _ = came.blocking_send(Incoming::End);
    });
}

/// Writes on a thread of its own, which says when it has written the last.
fn write(
    mut output: impl Write + Send + 'static,
    came: mpsc::Sender<Incoming>,
) -> (mpsc::UnboundedSender<Outgoing>, oneshot::Receiver<()>) {
    let (out, mut messages) = mpsc::unbounded_channel::<Outgoing>();
    let (done, written) = oneshot::channel();
    thread::spawn(move || {
        while let Some((bytes, _place)) = messages.blocking_recv() {
            if output.write_all(&bytes).and_then(|()| output.flush()).is_err() {
                let _ = came.blocking_send(Incoming::End);
                break;
            }
        }
        let _ = done.send(());
    });
    (out, written)
}
