//! The protocol's requests, answered from snapshots. Each handler hands its question to the owner of the documents before
//! it waits for anything, so that questions and changes keep their order.

mod actions;
mod answers;
mod completions;
mod diagnostics;
mod hierarchy;
mod judged;
mod neighbours;
mod patience;
mod progress;
mod publish;
mod renaming;
mod shown;
mod tokens;
mod told;

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use serde_json::json;
use tokio::sync::oneshot;
use tower_lsp::jsonrpc::{Error, ErrorCode, Result};
use tower_lsp::ls_types::*;
use tower_lsp::{Client, LanguageServer};

use crate::protocol::capabilities::{capabilities, watched_files};
use crate::protocol::convert::from_position;
use crate::protocol::errors::failed;
use crate::protocol::plain::{in_one_row, plain_docs, plain_hover};
use crate::protocol::uri::{path_of, path_on_disk};
use crate::world::documents::Change;
use crate::world::names::Names;
use crate::world::outbox::Outbox;
use crate::world::owner::Refusal;
use crate::world::projects::Projects;
use crate::world::{Encoding, Message, Snapshot};

/// The server of one client.
pub(crate) struct Backend {
    client: Client,
    world: Mutex<Sender<Message>>,
    outbox: Outbox,
    names: Names,
    projects: Arc<dyn Projects>,
    orderly: Arc<AtomicBool>,
    settings: OnceLock<told::Told>,
    folders: Mutex<Vec<PathBuf>>,
    workspace: diagnostics::Workspace,
    tokens: tokens::Told,
}

/// Ends work that was not begun yet when its request is cancelled.
struct Work<T>(tokio::task::JoinHandle<T>);

impl<T> Drop for Work<T> {
    fn drop(&mut self) {
        self.0.abort();
    }
}

impl Backend {
    /// # Errors
    /// The system has no thread left.
    pub(crate) fn new(
        client: Client,
        projects: Arc<dyn Projects>,
        world: Sender<Message>,
        names: Names,
        outbox: Outbox,
    ) -> Backend {
        Backend {
            client,
            world: Mutex::new(world),
            outbox,
            names,
            projects,
            orderly: Arc::default(),
            settings: OnceLock::new(),
            folders: Mutex::default(),
            workspace: diagnostics::Workspace::default(),
            tokens: tokens::Told::default(),
        }
    }

    /// Set when the client has asked for the end.
    pub(crate) fn orderly(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.orderly)
    }

    fn tell(&self, message: Message) {
        let world = self.world.lock().unwrap_or_else(PoisonError::into_inner);
        // The owner is gone only when the server is about to end.
        let _ = world.send(message);
    }

    /// What is known of a document, handed to `read` beside the server's own work. A panic in it is an error reply, and
    /// an answer for a text that is not there any more is none.
    async fn ask<T: Send + 'static>(
        &self,
        uri: &Uri,
        read: impl FnOnce(&Snapshot) -> T + Send + 'static,
    ) -> Result<T> {
        let snapshot = self.snapshot(path_of(&self.names, uri)).await.map_err(refused)?;
        beside(move || {
            let answer = read(&snapshot);
            if snapshot.is_stale() { Err(refused(Refusal::Outdated)) } else { Ok(answer) }
        })
        .await?
    }

    async fn snapshot(&self, path: PathBuf) -> std::result::Result<Snapshot, Refusal> {
        let (reply, answer) = oneshot::channel();
        self.tell(Message::Ask { path, reply });
        answer.await.unwrap_or(Err(Refusal::Failed))
    }

    fn folders(&self) -> std::sync::MutexGuard<'_, Vec<PathBuf>> {
        self.folders.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn told(&self) -> told::Told {
        self.settings.get().copied().unwrap_or_default()
    }

    /// Asks the client to say when designs change on disk.
    fn watch(&self) {
        let client = self.client.clone();
        // A client that refuses has its reasons; files are read anew when documents are opened.
        tokio::spawn(async move {
            let _ = client.register_capability(vec![watched_files()]).await;
        });
    }
}

/// Does work beside the server's own; a panic in it is an error reply.
async fn beside<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> Result<T> {
    let mut work = Work(tokio::task::spawn_blocking(work));
    (&mut work.0).await.map_err(|_| failed())
}

fn refused(refusal: Refusal) -> Error {
    match refusal {
        Refusal::Unknown => Error::invalid_params("the document is not open"),
        Refusal::Outdated => Error::content_modified(),
        Refusal::Failed => failed(),
    }
}

/// Who pulls diagnostics of a text that has changed since shall pull them again, and keep what it has.
fn pull_again(error: Error) -> Error {
    if error.code != ErrorCode::ContentModified {
        return error;
    }
    let data = Some(json!({ "retriggerRequest": true }));
    Error { code: ErrorCode::ServerError(-32802), message: "the document has changed since".into(), data }
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
        let told = told::Told::of(&params, encoding);
        let _ = self.settings.set(told);
        #[allow(deprecated, reason = "older clients say no other")]
        let root = params.root_uri.into_iter();
        let folders = params.workspace_folders.unwrap_or_default().into_iter().map(|folder| folder.uri);
        let mut named: Vec<PathBuf> = folders.chain(root).map(|uri| path_on_disk(&uri)).collect();
        named.sort();
        named.dedup();
        *self.folders() = named;
        if let Some(parent) = params.process_id {
            publish::end_with(parent);
        }
        Ok(InitializeResult {
            capabilities: capabilities(encoding, told.pulls, tokens::legend()),
            server_info: Some(ServerInfo {
                name: "ifs".to_owned(),
                version: Some(env!("CARGO_PKG_VERSION").to_owned()),
            }),
            ..InitializeResult::default()
        })
    }

    async fn initialized(&self, _: InitializedParams) {
        let told = self.told();
        let (client, names) = (self.client.clone(), self.names.clone());
        tokio::spawn(publish::publish(client, self.outbox.clone(), told, names));
        if told.shows_progress {
            tokio::spawn(progress::show(self.client.clone(), self.outbox.working.seen()));
        }
        if told.watches {
            self.watch();
        }
    }

    async fn shutdown(&self) -> Result<()> {
        self.orderly.store(true, Ordering::Relaxed);
        self.tell(Message::Stop);
        Ok(())
    }

    async fn did_open(&self, params: DidOpenTextDocumentParams) {
        let document = params.text_document;
        let path = path_on_disk(&document.uri);
        self.names.opened(document.uri.as_str(), &path);
        self.tell(Message::Open { path, text: document.text, version: document.version });
    }

    async fn did_change(&self, params: DidChangeTextDocumentParams) {
        let changes = params.content_changes.into_iter().map(|change| Change {
            range: change.range.map(|range| (from_position(range.start), from_position(range.end))),
            text: change.text,
        });
        self.tell(Message::Change {
            path: path_of(&self.names, &params.text_document.uri),
            version: params.text_document.version,
            changes: changes.collect(),
        });
    }

    async fn did_close(&self, params: DidCloseTextDocumentParams) {
        let uri = params.text_document.uri;
        self.tell(Message::Close { path: path_of(&self.names, &uri) });
        self.tokens.forget(uri.as_str());
        self.names.closed(uri.as_str());
    }

    async fn did_save(&self, _: DidSaveTextDocumentParams) {
        self.tell(Message::DiskChanged);
    }

    async fn did_change_watched_files(&self, _: DidChangeWatchedFilesParams) {
        self.tell(Message::DiskChanged);
    }

    async fn did_change_workspace_folders(&self, params: DidChangeWorkspaceFoldersParams) {
        let gone: Vec<PathBuf> =
            params.event.removed.iter().map(|folder| path_on_disk(&folder.uri)).collect();
        let mut folders = self.folders();
        folders.retain(|folder| !gone.contains(folder));
        folders.extend(params.event.added.iter().map(|folder| path_on_disk(&folder.uri)));
    }

    async fn diagnostic(&self, params: DocumentDiagnosticParams) -> Result<DocumentDiagnosticReportResult> {
        let (known, told) = (params.previous_result_id, self.told());
        let (reply, answer) = oneshot::channel();
        self.tell(Message::AskWrong { path: path_of(&self.names, &params.text_document.uri), reply });
        let answer = answer.await.unwrap_or(Err(Refusal::Failed));
        let (snapshot, wrong) = answer.map_err(refused).map_err(pull_again)?;
        let pull = move || {
            let report = diagnostics::pulled(&snapshot, &wrong, known.as_deref(), told);
            if snapshot.is_stale() { Err(refused(Refusal::Outdated)) } else { Ok(report) }
        };
        let report = beside(pull).await?.map_err(pull_again)?;
        Ok(DocumentDiagnosticReportResult::Report(report))
    }

    async fn workspace_diagnostic(
        &self,
        params: WorkspaceDiagnosticParams,
    ) -> Result<WorkspaceDiagnosticReportResult> {
        let (reply, answer) = oneshot::channel();
        self.tell(Message::AskAllWrong(reply));
        let (moment, wrong) = answer.await.map_err(|_| failed())?;
        let known = params.previous_result_ids.into_iter();
        let known: BTreeMap<String, String> =
            known.map(|known| (known.uri.as_str().to_owned(), known.value)).collect();
        let (workspace, projects, names) =
            (self.workspace.clone(), Arc::clone(&self.projects), self.names.clone());
        let (folders, told) = (self.folders().clone(), self.told());
        let items =
            beside(move || workspace.pulled(&projects, &names, &folders, (&moment, &wrong), &known, told));
        Ok(WorkspaceDiagnosticReportResult::Report(WorkspaceDiagnosticReport { items: items.await? }))
    }

    async fn hover(&self, params: HoverParams) -> Result<Option<Hover>> {
        let at = params.text_document_position_params;
        let hover =
            self.ask(&at.text_document.uri, move |snapshot| answers::hover(snapshot, at.position)).await?;
        Ok(if self.told().plain.hover { hover.map(plain_hover) } else { hover })
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
        let uri = params.text_document.uri;
        let found = self.ask(&uri, answers::symbols).await?;
        Ok(Some(match self.told().plain.symbols {
            true => DocumentSymbolResponse::Flat(in_one_row(found, &uri)),
            false => DocumentSymbolResponse::Nested(found),
        }))
    }

    async fn formatting(&self, params: DocumentFormattingParams) -> Result<Option<Vec<TextEdit>>> {
        self.ask(&params.text_document.uri, answers::format).await
    }

    async fn code_action(&self, params: CodeActionParams) -> Result<Option<CodeActionResponse>> {
        let (range, context) = (params.range, params.context);
        self.ask(&params.text_document.uri, move |snapshot| Some(actions::actions(snapshot, range, &context)))
            .await
    }

    async fn completion(&self, params: CompletionParams) -> Result<Option<CompletionResponse>> {
        let (at, snippets) = (params.text_document_position, self.told().snippets);
        let read = move |snapshot: &Snapshot| completions::completion(snapshot, at.position, snippets);
        let mut found = self.ask(&at.text_document.uri, read).await?;
        if let (true, Some(CompletionResponse::List(list))) = (self.told().plain.completion, &mut found) {
            list.items.iter_mut().for_each(|item| plain_docs(&mut item.documentation));
        }
        Ok(found)
    }

    async fn completion_resolve(&self, item: CompletionItem) -> Result<CompletionItem> {
        let mut item = beside(move || completions::resolve(item)).await?;
        if self.told().plain.completion {
            plain_docs(&mut item.documentation);
        }
        Ok(item)
    }

    async fn signature_help(&self, params: SignatureHelpParams) -> Result<Option<SignatureHelp>> {
        let at = params.text_document_position_params;
        let read = move |snapshot: &Snapshot| completions::signature(snapshot, at.position);
        let mut found = self.ask(&at.text_document.uri, read).await?;
        if self.told().plain.signature {
            let signatures = found.iter_mut().flat_map(|help| &mut help.signatures);
            signatures.for_each(|signature| plain_docs(&mut signature.documentation));
        }
        Ok(found)
    }

    async fn semantic_tokens_full(
        &self,
        params: SemanticTokensParams,
    ) -> Result<Option<SemanticTokensResult>> {
        let uri = params.text_document.uri;
        let found = self.ask(&uri, |snapshot| tokens::tokens(snapshot, None)).await?;
        Ok(Some(self.tokens.whole(uri.as_str(), found).into()))
    }

    async fn semantic_tokens_full_delta(
        &self,
        params: SemanticTokensDeltaParams,
    ) -> Result<Option<SemanticTokensFullDeltaResult>> {
        let uri = params.text_document.uri;
        let found = self.ask(&uri, |snapshot| tokens::tokens(snapshot, None)).await?;
        Ok(Some(self.tokens.changed(uri.as_str(), &params.previous_result_id, found)))
    }

    async fn semantic_tokens_range(
        &self,
        params: SemanticTokensRangeParams,
    ) -> Result<Option<SemanticTokensRangeResult>> {
        let range = params.range;
        let read = move |snapshot: &Snapshot| tokens::tokens(snapshot, Some(range));
        let data = self.ask(&params.text_document.uri, read).await?;
        Ok(Some(SemanticTokens { result_id: None, data }.into()))
    }

    async fn inlay_hint(&self, params: InlayHintParams) -> Result<Option<Vec<InlayHint>>> {
        let range = params.range;
        self.ask(&params.text_document.uri, move |snapshot| Some(shown::hints(snapshot, range))).await
    }

    async fn code_lens(&self, params: CodeLensParams) -> Result<Option<Vec<CodeLens>>> {
        let (uri, commands) = (params.text_document.uri, self.told().commands);
        self.ask(&uri.clone(), move |snapshot| Some(shown::lenses(snapshot, &uri, commands))).await
    }

    async fn folding_range(&self, params: FoldingRangeParams) -> Result<Option<Vec<FoldingRange>>> {
        self.ask(&params.text_document.uri, |snapshot| Some(shown::folding(snapshot))).await
    }

    async fn selection_range(&self, params: SelectionRangeParams) -> Result<Option<Vec<SelectionRange>>> {
        let positions = params.positions;
        self.ask(&params.text_document.uri, move |snapshot| Some(shown::selections(snapshot, &positions)))
            .await
    }

    async fn range_formatting(&self, params: DocumentRangeFormattingParams) -> Result<Option<Vec<TextEdit>>> {
        let range = params.range;
        self.ask(&params.text_document.uri, move |snapshot| shown::format_part(snapshot, range)).await
    }

    async fn on_type_formatting(
        &self,
        params: DocumentOnTypeFormattingParams,
    ) -> Result<Option<Vec<TextEdit>>> {
        let at = params.text_document_position;
        self.ask(&at.text_document.uri, move |snapshot| shown::format_ended(snapshot, at.position)).await
    }

    async fn symbol(&self, params: WorkspaceSymbolParams) -> Result<Option<WorkspaceSymbolResponse>> {
        let (reply, moment) = oneshot::channel();
        self.tell(Message::AskMoment(reply));
        let moment = moment.await.map_err(|_| failed())?;
        let (projects, names, folders) =
            (Arc::clone(&self.projects), self.names.clone(), self.folders().clone());
        let find = move || hierarchy::symbols(&projects, &names, &folders, &moment, &params.query);
        Ok(Some(WorkspaceSymbolResponse::Nested(beside(find).await?)))
    }

    async fn prepare_call_hierarchy(
        &self,
        params: CallHierarchyPrepareParams,
    ) -> Result<Option<Vec<CallHierarchyItem>>> {
        let at = params.text_document_position_params;
        let uri = at.text_document.uri;
        self.ask(&uri.clone(), move |snapshot| hierarchy::prepare(snapshot, at.position, &uri)).await
    }

    async fn incoming_calls(
        &self,
        params: CallHierarchyIncomingCallsParams,
    ) -> Result<Option<Vec<CallHierarchyIncomingCall>>> {
        let Some(uri) = hierarchy::document(&params.item) else { return Ok(None) };
        self.ask(&uri, move |snapshot| hierarchy::incoming(snapshot, &params.item)).await
    }

    async fn outgoing_calls(
        &self,
        params: CallHierarchyOutgoingCallsParams,
    ) -> Result<Option<Vec<CallHierarchyOutgoingCall>>> {
        let Some(uri) = hierarchy::document(&params.item) else { return Ok(None) };
        self.ask(&uri, move |snapshot| hierarchy::outgoing(snapshot, &params.item)).await
    }

    async fn document_link(&self, params: DocumentLinkParams) -> Result<Option<Vec<DocumentLink>>> {
        self.ask(&params.text_document.uri, |snapshot| Some(answers::links(snapshot))).await
    }

    async fn prepare_rename(
        &self,
        params: TextDocumentPositionParams,
    ) -> Result<Option<PrepareRenameResponse>> {
        let prepared = self
            .ask(&params.text_document.uri, move |snapshot| renaming::prepare(snapshot, params.position))
            .await?;
        prepared.map(Some).map_err(said)
    }

    async fn rename(&self, params: RenameParams) -> Result<Option<WorkspaceEdit>> {
        let at = params.text_document_position;
        let new = params.new_name;
        let renamed = self
            .ask(&at.text_document.uri, move |snapshot| renaming::rename(snapshot, at.position, &new))
            .await?;
        renamed.map(Some).map_err(said)
    }
}
