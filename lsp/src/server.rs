//! The protocol's requests, answered from snapshots. Each handler hands its question to the owner of the documents before
//! it waits for anything, so that questions and changes keep their order.

mod actions;
mod answers;
mod publish;

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;

use tokio::sync::{Mutex, mpsc, oneshot};
use tower_lsp::jsonrpc::{Error, ErrorCode, Result};
use tower_lsp::ls_types::*;
use tower_lsp::{Client, LanguageServer};

use crate::protocol::capabilities::capabilities;
use crate::protocol::convert::from_position;
use crate::protocol::uri::path_of;
use crate::world::documents::Change;
use crate::world::owner::{Outgoing, Refusal};
use crate::world::projects::Projects;
use crate::world::{Encoding, Message, Snapshot, start};

/// The server of one client.
pub(crate) struct Backend {
    client: Client,
    world: std::sync::Mutex<Sender<Message>>,
    /// What the owner says, until the client is ready to hear it.
    outgoing: Mutex<Option<mpsc::UnboundedReceiver<Outgoing>>>,
    projects: Arc<dyn Projects>,
    orderly: Arc<AtomicBool>,
    settings: std::sync::OnceLock<publish::Told>,
}

impl Backend {
    pub(crate) fn new(client: Client, projects: Arc<dyn Projects>) -> Backend {
        let (out, outgoing) = mpsc::unbounded_channel();
        let world = start(Arc::clone(&projects), out);
        Backend {
            client,
            world: std::sync::Mutex::new(world),
            outgoing: Mutex::new(Some(outgoing)),
            projects,
            orderly: Arc::default(),
            settings: std::sync::OnceLock::new(),
        }
    }

    /// Set when the client has asked for the end.
    pub(crate) fn orderly(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.orderly)
    }

    fn tell(&self, message: Message) {
        let world = self.world.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        // The owner is gone only when the server is about to end.
        let _ = world.send(message);
    }

    /// What is known of a document, handed to `read` beside the server's own work. A panic in it is an error reply.
    async fn ask<T: Send + 'static>(
        &self,
        uri: &Uri,
        read: impl FnOnce(&Snapshot) -> T + Send + 'static,
    ) -> Result<T> {
        let (reply, answer) = oneshot::channel();
        self.tell(Message::Ask { path: path_of(uri), reply });
        let snapshot = match answer.await {
            Ok(Ok(snapshot)) => snapshot,
            Ok(Err(refusal)) => return Err(refused(refusal)),
            Err(_) => return Err(refused(Refusal::Failed)),
        };
        let work = tokio::task::spawn_blocking(move || read(&snapshot));
        work.await.map_err(|_| refused(Refusal::Failed))
    }
}

fn refused(refusal: Refusal) -> Error {
    match refusal {
        Refusal::Unknown => Error::invalid_params("the document is not open"),
        Refusal::Outdated => Error::content_modified(),
        Refusal::Failed => {
            let mut error = Error::internal_error();
            error.message = "the server failed on this request; please report it with the file".into();
            error
        }
    }
}

/// An error that the person at the editor reads.
fn said(words: String) -> Error {
    Error { code: ErrorCode::ServerError(-32803), message: words.into(), data: None }
}

impl LanguageServer for Backend {
    async fn initialize(&self, params: InitializeParams) -> Result<InitializeResult> {
        let general = params.capabilities.general.as_ref();
        let encodings = general.and_then(|general| general.position_encodings.as_ref());
        let utf8 = encodings.is_some_and(|all| all.contains(&PositionEncodingKind::UTF8));
        let encoding = if utf8 { Encoding::Utf8 } else { Encoding::Utf16 };
        self.tell(Message::Encoding(encoding));
        let document = params.capabilities.text_document.as_ref();
        let pulls = document.is_some_and(|document| document.diagnostic.is_some());
        let workspace = params.capabilities.workspace.as_ref();
        let refreshes = workspace
            .and_then(|workspace| workspace.diagnostics.as_ref())
            .is_some_and(|diagnostics| diagnostics.refresh_support == Some(true));
        let watches = workspace
            .and_then(|workspace| workspace.did_change_watched_files.as_ref())
            .is_some_and(|watched| watched.dynamic_registration == Some(true));
        let _ = self.settings.set(publish::Told { encoding, pulls, refreshes, watches });
        if let Some(parent) = params.process_id {
            publish::end_with(parent);
        }
        Ok(InitializeResult {
            capabilities: capabilities(encoding, pulls),
            server_info: Some(ServerInfo {
                name: "ifs".to_owned(),
                version: Some(env!("CARGO_PKG_VERSION").to_owned()),
            }),
            ..InitializeResult::default()
        })
    }

    async fn initialized(&self, _: InitializedParams) {
        let told = self.settings.get().copied().unwrap_or_default();
        if let Some(outgoing) = self.outgoing.lock().await.take() {
            let places = Arc::clone(&self.projects);
            tokio::spawn(publish::publish(self.client.clone(), outgoing, told, places));
        }
        if told.watches {
            let watch = Registration {
                id: "watched".to_owned(),
                method: "workspace/didChangeWatchedFiles".to_owned(),
                register_options: serde_json::to_value(DidChangeWatchedFilesRegistrationOptions {
                    watchers: ["**/*.ifs", "**/ifs.toml"]
                        .map(|glob| FileSystemWatcher {
                            glob_pattern: GlobPattern::String(glob.to_owned()),
                            kind: None,
                        })
                        .to_vec(),
                })
                .ok(),
            };
            let client = self.client.clone();
            // A client that refuses has its reasons; files are read anew when documents are opened.
            tokio::spawn(async move {
                let _ = client.register_capability(vec![watch]).await;
            });
        }
    }

    async fn shutdown(&self) -> Result<()> {
        self.orderly.store(true, Ordering::Relaxed);
        self.tell(Message::Stop);
        Ok(())
    }

    async fn did_open(&self, params: DidOpenTextDocumentParams) {
        let document = params.text_document;
        let path = path_of(&document.uri);
        self.tell(Message::Open { path, text: document.text, version: document.version });
    }

    async fn did_change(&self, params: DidChangeTextDocumentParams) {
        let changes = params.content_changes.into_iter().map(|change| Change {
            range: change.range.map(|range| (from_position(range.start), from_position(range.end))),
            text: change.text,
        });
        self.tell(Message::Change {
            path: path_of(&params.text_document.uri),
            version: params.text_document.version,
            changes: changes.collect(),
        });
    }

    async fn did_close(&self, params: DidCloseTextDocumentParams) {
        self.tell(Message::Close { path: path_of(&params.text_document.uri) });
    }

    async fn did_save(&self, _: DidSaveTextDocumentParams) {
        self.tell(Message::DiskChanged);
    }

    async fn did_change_watched_files(&self, _: DidChangeWatchedFilesParams) {
        self.tell(Message::DiskChanged);
    }

    async fn diagnostic(&self, params: DocumentDiagnosticParams) -> Result<DocumentDiagnosticReportResult> {
        let report = self.ask(&params.text_document.uri, answers::pulled).await?;
        Ok(DocumentDiagnosticReportResult::Report(report))
    }

    async fn hover(&self, params: HoverParams) -> Result<Option<Hover>> {
        let at = params.text_document_position_params;
        self.ask(&at.text_document.uri, move |snapshot| answers::hover(snapshot, at.position)).await
    }

    async fn goto_definition(&self, params: GotoDefinitionParams) -> Result<Option<GotoDefinitionResponse>> {
        let at = params.text_document_position_params;
        self.ask(&at.text_document.uri, move |snapshot| answers::definition(snapshot, at.position)).await
    }

    async fn goto_type_definition(
        &self,
        params: request::GotoTypeDefinitionParams,
    ) -> Result<Option<request::GotoTypeDefinitionResponse>> {
        let at = params.text_document_position_params;
        self.ask(&at.text_document.uri, move |snapshot| answers::type_definition(snapshot, at.position)).await
    }

    async fn references(&self, params: ReferenceParams) -> Result<Option<Vec<Location>>> {
        let at = params.text_document_position;
        let declaration = params.context.include_declaration;
        self.ask(&at.text_document.uri, move |snapshot| {
            answers::references(snapshot, at.position, declaration)
        })
        .await
    }

    async fn document_highlight(
        &self,
        params: DocumentHighlightParams,
    ) -> Result<Option<Vec<DocumentHighlight>>> {
        let at = params.text_document_position_params;
        self.ask(&at.text_document.uri, move |snapshot| Some(answers::highlights(snapshot, at.position)))
            .await
    }

    async fn document_symbol(&self, params: DocumentSymbolParams) -> Result<Option<DocumentSymbolResponse>> {
        self.ask(&params.text_document.uri, |snapshot| Some(answers::symbols(snapshot))).await
    }

    async fn formatting(&self, params: DocumentFormattingParams) -> Result<Option<Vec<TextEdit>>> {
        self.ask(&params.text_document.uri, answers::format).await
    }

    async fn code_action(&self, params: CodeActionParams) -> Result<Option<CodeActionResponse>> {
        let (range, only) = (params.range, params.context.only);
        self.ask(&params.text_document.uri, move |snapshot| {
            Some(actions::actions(snapshot, range, only.as_deref()))
        })
        .await
    }

    async fn document_link(&self, params: DocumentLinkParams) -> Result<Option<Vec<DocumentLink>>> {
        self.ask(&params.text_document.uri, |snapshot| Some(answers::links(snapshot))).await
    }

    async fn prepare_rename(
        &self,
        params: TextDocumentPositionParams,
    ) -> Result<Option<PrepareRenameResponse>> {
        let prepared = self
            .ask(&params.text_document.uri, move |snapshot| {
                answers::prepare_rename(snapshot, params.position)
            })
            .await?;
        prepared.map(Some).map_err(said)
    }

    async fn rename(&self, params: RenameParams) -> Result<Option<WorkspaceEdit>> {
        let at = params.text_document_position;
        let new = params.new_name;
        let renamed = self
            .ask(&at.text_document.uri, move |snapshot| answers::rename(snapshot, at.position, &new))
            .await?;
        renamed.map(Some).map_err(said)
    }
}
