//! What `use` can name: modules, files, and what they offer. And the `use` that a name of the library needs.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::index::{ModuleNames, Target};
use ifs_compiler::hir::native_item_docs;
use ifs_compiler::hir::type_names::type_name;
use ifs_compiler::hir::types::Type;
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::{Token, TokenKind};

use super::{Kind, Offer};
use crate::features::tokens::Before;
use crate::features::words::written;

/// The modules of the library; behind `use` alone the files of the project too.
pub(super) fn modules(
    analysis: &Analysis,
    before: &Before<'_>,
    paths: &dyn Fn() -> Vec<String>,
) -> Vec<Offer> {
    let library = analysis.index.modules.iter().filter(|module| module.library && !module.is_prelude());
    let dotted = before.back(1) == Some(TokenKind::Dot);
    if dotted && before.back_text(2) != "std" {
        return Vec::new();
    }
    let brackets = if before.next == Some(TokenKind::OpenParenthesis) { "" } else { " ($0)" };
    let mut offers: Vec<Offer> = library
        .map(|module| {
            let label = if dotted { module.title.trim_start_matches("std.") } else { &module.title };
            let mut offer = Offer::new(label, Kind::Module).snippet(format!("{label}{brackets}"));
            offer.detail = names_of(module);
            offer
        })
        .collect();
    if !dotted {
        offers.extend(files(analysis, before.word.file, &paths()).into_iter().map(|path| {
            let quoted = format!("\"{path}\"");
            let snippet = format!("{}{brackets}", super::snippets::escaped(&quoted));
            Offer::new(&quoted, Kind::File).snippet(snippet).rank(1)
        }));
    }
    offers
}

/// The first names of a module, in one line.
fn names_of(module: &ModuleNames) -> String {
    let names: Vec<&str> = module.public.iter().take(4).map(|known| known.name.as_str()).collect();
    let more = if module.public.len() > names.len() { ", …" } else { "" };
    format!("{}{more}", names.join(", "))
}

/// The paths of the other files, as the file writes them.
fn files(analysis: &Analysis, file: FileId, paths: &[String]) -> Vec<String> {
    let own = analysis.sources.get(file).map_or("", |source| source.path.as_str());
    let others = paths.iter().filter(|path| *path != own && path.ends_with(".ifs"));
    others.map(|path| relative(own, path)).collect()
}

/// A path of the project from the folder of a file.
pub(in crate::features) fn relative(from: &str, to: &str) -> String {
    let from: Vec<&str> = from.split('/').collect();
    let to: Vec<&str> = to.split('/').collect();
    let folders = from.len().saturating_sub(1);
    let shared = from[..folders].iter().zip(&to[..to.len() - 1]).take_while(|(a, b)| a == b).count();
    let up = "../".repeat(folders - shared);
    format!("{}{}", if up.is_empty() { "./" } else { &up }, to[shared..].join("/"))
}

/// Files, inside the quotes of a `use` or of `import`.
pub(super) fn paths(
    analysis: &Analysis,
    before: &Before<'_>,
    token: Token,
    paths: &dyn Fn() -> Vec<String>,
) -> Option<(Span, Vec<Offer>)> {
    let text = written(analysis, token.span);
    let closed = text.len() > 1 && text.ends_with('"');
    let span = Span::new(token.span.file, token.span.start + 1, token.span.end - u32::from(closed));
    let imports = before.back(1) == Some(TokenKind::OpenParenthesis) && before.back_text(2) == "import";
    let found = if before.back(1) == Some(TokenKind::Use) {
        files(analysis, token.span.file, &paths())
    } else if imports {
        let own = analysis.sources.get(token.span.file).map_or("", |source| source.path.as_str());
        paths().iter().filter(|path| path.ends_with(".glb")).map(|path| relative(own, path)).collect()
    } else {
        return None;
    };
    let quote = if closed { "" } else { "\"" };
    let offers = found.iter().map(|path| {
        Offer::new(path, Kind::File).snippet(format!("{}{quote}", super::snippets::escaped(path)))
    });
    Some((span, offers.collect()))
}

/// What the module named there offers and is not named yet.
pub(super) fn names(analysis: &Analysis, before: &Before<'_>, module: Span) -> Vec<Offer> {
    let path = written(analysis, module);
    let named = analysis.index.references.iter().find_map(|used| match used.target {
        Target::Module(file) if used.span == module => Some(file),
        _ => None,
    });
    let found = analysis.index.modules.iter().find(|known| {
        Some(known.file) == named || known.library && !known.is_prelude() && known.title == path
    });
    let Some(found) = found else { return Vec::new() };
    let taken: Vec<&str> = (0..before.tokens.len()).map(|at| before.written(at)).collect();
    let open = found.public.iter().filter(|known| !taken.contains(&known.name.as_str()));
    open.map(|known| {
        let kind = match (&known.ty, &known.parameters) {
            (Type::Ifs, _) => Kind::Ifs,
            (Type::Record(_), Some(_)) if known.name.starts_with(char::is_uppercase) => Kind::Record,
            (_, Some(_)) => Kind::Function,
            (Type::Error, None) => Kind::Function,
            (ty, None) if ty.is_figure() => Kind::Figure,
            _ => Kind::Value,
        };
        let mut offer = Offer::new(&known.name, kind);
        offer.detail = match known.target {
            Target::Native(native) => native_item_docs(native.declaration()).signature,
            _ => type_name(&analysis.hir.items, &known.ty),
        };
        offer.module = found.library.then(|| found.title.clone());
        offer
    })
    .collect()
}

/// The change that makes a file know a name of a module: `std.curves`, or the path of a file in quotes.
pub(in crate::features) fn to_import(
    analysis: &Analysis,
    file: FileId,
    module: &str,
    name: &str,
) -> Option<(Span, String)> {
    let parse = &analysis.files.iter().find(|parsed| parsed.file == file)?.parse;
    let (at, text) = parse.ast.to_import(module, name);
    Some((Span::new(file, at, at), text))
}
