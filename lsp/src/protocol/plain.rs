//! What is said to clients that show less: words without marks, symbols in one row. Diagnostics
//! without related places are made in `diagnostics`.

use tower_lsp::ls_types::*;

/// Markdown as words: without fences, rules and the marks of names.
fn plain(markdown: &str) -> String {
    let lines = markdown.lines().filter(|line| !line.starts_with("```") && *line != "---");
    let mut text: Vec<String> = lines.map(|line| line.replace("**", "").replace('`', "")).collect();
    text.dedup_by(|one, before| one.is_empty() && before.is_empty());
    text.join("\n").trim().to_owned()
}

/// A hover in words.
pub(crate) fn plain_hover(mut hover: Hover) -> Hover {
    if let HoverContents::Markup(said) = &mut hover.contents {
        *said = MarkupContent { kind: MarkupKind::PlainText, value: plain(&said.value) };
    }
    hover
}

/// What is said of an offer, or of a signature, in words.
pub(crate) fn plain_docs(docs: &mut Option<Documentation>) {
    if let Some(Documentation::MarkupContent(said)) = docs {
        *docs = Some(Documentation::String(plain(&said.value)));
    }
}

/// Symbols one after the other, each with the name of what it is in.
pub(crate) fn in_one_row(symbols: Vec<DocumentSymbol>, uri: &Uri) -> Vec<SymbolInformation> {
    let mut row = Vec::new();
    for symbol in symbols {
        put(symbol, None, uri, &mut row);
    }
    row
}

#[allow(deprecated, reason = "the protocol's type has an old field that must be given")]
fn put(symbol: DocumentSymbol, container_name: Option<String>, uri: &Uri, row: &mut Vec<SymbolInformation>) {
    let DocumentSymbol { name, kind, tags, range, children, .. } = symbol;
    let location = Location { uri: uri.clone(), range };
    row.push(SymbolInformation {
        name: name.clone(),
        kind,
        tags,
        deprecated: None,
        location,
        container_name,
    });
    for child in children.into_iter().flatten() {
        put(child, Some(name.clone()), uri, row);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_left_out() {
        let markdown = "```ifs\nlet a: Length\n```\n\n---\n\nvalue `2mm`, **not** more";
        assert_eq!(plain(markdown), "let a: Length\n\nvalue 2mm, not more");
    }
}
