//! What the client says of itself at the start.

use tower_lsp::ls_types::{InitializeParams, MarkupKind, TextDocumentClientCapabilities};

use crate::protocol::commands::Commands;
use crate::world::Encoding;

/// What the client has told of itself.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Told {
    pub(crate) encoding: Encoding,
    /// It pulls diagnostics, and again when it is asked to: they are not pushed too.
    pub(crate) pulls: bool,
    /// It takes what is wrong in other files with what it pulls of one.
    pub(crate) takes_related: bool,
    /// It can watch files.
    pub(crate) watches: bool,
    /// It fills in the places of snippets.
    pub(crate) snippets: bool,
    /// It shows that something is being done.
    pub(crate) shows_progress: bool,
    /// What it shows only without marks, or in a simpler way.
    pub(crate) plain: Plain,
    /// What its extension can carry out.
    pub(crate) commands: Commands,
    /// What it asks for again when it is told to.
    pub(crate) refreshed: Refreshed,
}

/// What a client says that it shows no better than this.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Plain {
    pub(crate) hover: bool,
    pub(crate) completion: bool,
    pub(crate) signature: bool,
    /// Diagnostics without related places.
    pub(crate) diagnostics: bool,
    /// Symbols in one row.
    pub(crate) symbols: bool,
}

impl Plain {
    fn of(document: &TextDocumentClientCapabilities) -> Plain {
        let no_marks = |kinds: Option<&Vec<MarkupKind>>| {
            kinds.is_some_and(|kinds| !kinds.is_empty() && !kinds.contains(&MarkupKind::Markdown))
        };
        let hover = document.hover.as_ref().and_then(|hover| hover.content_format.as_ref());
        let item = document.completion.as_ref().and_then(|completion| completion.completion_item.as_ref());
        let signature = document.signature_help.as_ref().and_then(|help| help.signature_information.as_ref());
        Plain {
            hover: no_marks(hover),
            completion: no_marks(item.and_then(|item| item.documentation_format.as_ref())),
            signature: no_marks(signature.and_then(|signature| signature.documentation_format.as_ref())),
            diagnostics: document
                .publish_diagnostics
                .as_ref()
                .is_some_and(|it| it.related_information != Some(true)),
            symbols: document
                .document_symbol
                .as_ref()
                .is_some_and(|it| it.hierarchical_document_symbol_support != Some(true)),
        }
    }
}

/// What a client asks for again when it is told to.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Refreshed {
    pub(crate) hints: bool,
    pub(crate) lenses: bool,
}

impl Told {
    /// What is said in the first request, beside how columns are counted.
    pub(crate) fn of(params: &InitializeParams, encoding: Encoding) -> Told {
        let document = params.capabilities.text_document.as_ref();
        let workspace = params.capabilities.workspace.as_ref();
        let pulling = document.and_then(|document| document.diagnostic.as_ref());
        // Who cannot be asked to pull again would never hear what was worked out.
        let pulls_again = workspace
            .and_then(|workspace| workspace.diagnostics.as_ref())
            .is_some_and(|diagnostics| diagnostics.refresh_support == Some(true));
        Told {
            encoding,
            pulls: pulling.is_some() && pulls_again,
            takes_related: pulling.is_some_and(|pulling| pulling.related_document_support == Some(true)),
            watches: workspace
                .and_then(|workspace| workspace.did_change_watched_files.as_ref())
                .is_some_and(|watched| watched.dynamic_registration == Some(true)),
            snippets: document
                .and_then(|document| document.completion.as_ref()?.completion_item.as_ref())
                .is_some_and(|item| item.snippet_support == Some(true)),
            shows_progress: params
                .capabilities
                .window
                .as_ref()
                .is_some_and(|window| window.work_done_progress == Some(true)),
            plain: document.map_or_else(Plain::default, Plain::of),
            commands: Commands::of(params.initialization_options.as_ref()),
            refreshed: Refreshed {
                hints: workspace
                    .and_then(|workspace| workspace.inlay_hint.as_ref())
                    .is_some_and(|hints| hints.refresh_support == Some(true)),
                lenses: workspace
                    .and_then(|workspace| workspace.code_lens.as_ref())
                    .is_some_and(|lenses| lenses.refresh_support == Some(true)),
            },
        }
    }
}
