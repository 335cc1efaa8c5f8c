//! Completion and signatures in the protocol's types.

use serde_json::{Value, json};
use tower_lsp::ls_types::*;

use crate::features::completion::{self, Kind, Offer, library_item_docs};
use crate::features::signature;
use crate::world::Snapshot;

/// What can be written at a place; `snippets` says whether the client fills in places.
pub(super) fn completion(
    snapshot: &Snapshot,
    position: Position,
    snippets: bool,
) -> Option<CompletionResponse> {
    let root = snapshot.analysis.root;
    let paths = || paths(snapshot);
    let found = completion::completion(&snapshot.analysis, root, snapshot.offset(position), &paths)?;
    let range = snapshot.range(found.span);
    let items = found.offers.into_iter().enumerate();
    let items = items.map(|(place, offer)| item(snapshot, range, place, offer, snippets));
    Some(CompletionResponse::List(CompletionList { is_incomplete: !found.complete, items: items.collect() }))
}

/// The designs and the meshes of the project, from its root.
pub(super) fn paths(snapshot: &Snapshot) -> Vec<String> {
    let root = &snapshot.places.root;
    let projects = &snapshot.places.projects;
    let open = snapshot.open.keys().cloned();
    let mut paths: Vec<String> = projects
        .designs(root)
        .into_iter()
        .chain(projects.files(root, "glb"))
        .chain(open)
        .filter_map(|path| {
            let parts = path.strip_prefix(root).ok()?.iter().map(|part| part.to_str());
            Some(parts.collect::<Option<Vec<&str>>>()?.join("/"))
        })
        .collect();
    paths.sort();
    paths.dedup();
    paths
}

fn item(snapshot: &Snapshot, range: Range, place: usize, offer: Offer, snippets: bool) -> CompletionItem {
    let text = match offer.plain {
        _ if snippets => offer.snippet,
        Some(text) => text,
        None => plain(&offer.snippet),
    };
    // Lines of a block stand as deep as the line that it begins on.
    let adjusted = text.contains('\n').then_some(InsertTextMode::ADJUST_INDENTATION);
    let docs = (!offer.docs.is_empty()).then(|| markdown(offer.docs));
    let edits = offer.elsewhere.map(|(span, text)| vec![snapshot.edit(span, text)]);
    let details = CompletionItemLabelDetails { detail: None, description: offer.module.clone() };
    CompletionItem {
        kind: Some(kind(offer.kind)),
        detail: (!offer.detail.is_empty()).then_some(offer.detail),
        documentation: docs,
        sort_text: Some(format!("{place:04}")),
        // A path begins inside of its quotes or with them.
        filter_text: Some(offer.label.clone()),
        insert_text_format: Some(if snippets {
            InsertTextFormat::SNIPPET
        } else {
            InsertTextFormat::PLAIN_TEXT
        }),
        insert_text_mode: adjusted,
        text_edit: Some(CompletionTextEdit::Edit(TextEdit { range, new_text: text })),
        additional_text_edits: edits,
        label_details: offer.module.is_some().then_some(details),
        data: offer.module.map(|module| json!({ "module": module, "name": offer.label })),
        label: offer.label,
        ..CompletionItem::default()
    }
}

fn markdown(value: String) -> Documentation {
    Documentation::MarkupContent(MarkupContent { kind: MarkupKind::Markdown, value })
}

/// A snippet up to its first place, for a client that fills in none.
fn plain(snippet: &str) -> String {
    let mut text = String::new();
    let mut letters = snippet.chars();
    while let Some(letter) = letters.next() {
        match letter {
            '\\' => text.extend(letters.next()),
            '$' => break,
            letter => text.push(letter),
        }
    }
    text
}

fn kind(kind: Kind) -> CompletionItemKind {
    match kind {
        Kind::Value => CompletionItemKind::VARIABLE,
        Kind::Parameter => CompletionItemKind::CONSTANT,
        Kind::Function => CompletionItemKind::FUNCTION,
        Kind::Record => CompletionItemKind::STRUCT,
        Kind::Ifs => CompletionItemKind::CLASS,
        Kind::Figure => CompletionItemKind::VALUE,
        Kind::Field => CompletionItemKind::FIELD,
        Kind::Choice => CompletionItemKind::ENUM_MEMBER,
        Kind::Unit => CompletionItemKind::UNIT,
        Kind::Type => CompletionItemKind::TYPE_PARAMETER,
        Kind::Keyword => CompletionItemKind::KEYWORD,
        Kind::Module => CompletionItemKind::MODULE,
        Kind::File => CompletionItemKind::FILE,
        Kind::Measure => CompletionItemKind::PROPERTY,
    }
}

/// The item with the docs of the library, which are told only when they are asked for.
pub(super) fn resolve(mut item: CompletionItem) -> CompletionItem {
    let text = |key: &str| item.data.as_ref().and_then(|data| data.get(key)).and_then(Value::as_str);
    let docs = text("module").zip(text("name")).and_then(|(module, name)| library_item_docs(module, name));
    if let Some(docs) = docs {
        item.detail = Some(docs.signature.clone());
        item.documentation = Some(markdown(docs.docs.join("\n")));
    }
    item
}

/// The signature of the call around a place.
pub(super) fn signature(snapshot: &Snapshot, position: Position) -> Option<SignatureHelp> {
    let found = signature::signature(&snapshot.analysis, snapshot.analysis.root, snapshot.offset(position))?;
    let units =
        |bytes: u32| found.label.get(..bytes as usize).map_or(0, |text| text.encode_utf16().count() as u32);
    let parameters = found.parameters.iter().map(|(start, end)| ParameterInformation {
        label: ParameterLabel::LabelOffsets([units(*start), units(*end)]),
        documentation: None,
    });
    let parameters: Vec<ParameterInformation> = parameters.collect();
    // No parameter is told as one beyond the last.
    let active = Some(found.active.unwrap_or(parameters.len() as u32));
    let signature = SignatureInformation {
        documentation: (!found.docs.is_empty()).then(|| markdown(found.docs.clone())),
        parameters: Some(parameters),
        active_parameter: active,
        label: found.label,
    };
    Some(SignatureHelp { signatures: vec![signature], active_signature: Some(0), active_parameter: active })
}
