//! What can be written at a place. What the tokens before it allow is in `place`; what the compiler knows of a design with
//! a name put there gives types and names.

mod after;
mod arguments;
mod fit;
mod imports;
mod members;
mod names;
mod needed;
mod place;
mod settings;
mod snippets;
#[cfg(test)]
mod tests;
mod units;

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::index::Index;
use ifs_compiler::hir::tree::Hir;
use ifs_compiler::hir::types::Type;
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::TokenKind;

use super::supplement::supplemented;
use super::tokens::{Before, Cursor, cursor};
pub(super) use imports::{relative, to_import};
pub(crate) use names::library_item_docs;
use place::{Place, place};

/// What kind of thing is offered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Value,
    Parameter,
    Function,
    Record,
    Ifs,
    Figure,
    Field,
    Choice,
    Unit,
    Type,
    Keyword,
    Module,
    File,
    Measure,
}

/// One thing that can be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Offer {
    pub(crate) label: String,
    pub(crate) kind: Kind,
    /// What stands beside the label: a type or a signature.
    pub(crate) detail: String,
    /// Markdown.
    pub(crate) docs: String,
    /// What is written, with places to fill in as the protocol writes them.
    pub(crate) snippet: String,
    /// What is written where no places can be filled in; the snippet up to its first place where this is none.
    pub(crate) plain: Option<String>,
    /// How well it fits, best first.
    pub(crate) rank: u8,
    /// The module of the library that it is of, whose docs are told when they are asked for.
    pub(crate) module: Option<String>,
    /// What must be written elsewhere: the `use`.
    pub(crate) elsewhere: Option<(Span, String)>,
}

impl Offer {
    pub(crate) fn new(label: &str, kind: Kind) -> Offer {
        Offer {
            label: label.to_owned(),
            kind,
            detail: String::new(),
            docs: String::new(),
            snippet: snippets::escaped(label),
            plain: None,
            rank: 0,
            module: None,
            elsewhere: None,
        }
    }

    fn detail(mut self, detail: impl Into<String>) -> Offer {
        self.detail = detail.into();
        self
    }

    fn docs(mut self, docs: impl Into<String>) -> Offer {
        self.docs = docs.into();
        self
    }

    fn snippet(mut self, snippet: impl Into<String>) -> Offer {
        self.snippet = snippet.into();
        self
    }

    fn rank(mut self, rank: u8) -> Offer {
        self.rank = rank;
        self
    }
}

/// What can be written in place of `span`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Completion {
    pub(crate) span: Span,
    /// Best first.
    pub(crate) offers: Vec<Offer>,
}

/// What can be written at a place; `paths` are the files of the project, from its root.
pub(crate) fn completion(
    analysis: &Analysis,
    file: FileId,
    offset: u32,
    paths: &[String],
) -> Option<Completion> {
    let (span, mut offers) = match cursor(analysis, file, offset)? {
        Cursor::Comment => return None,
        Cursor::Number(token) => units::units(analysis, token, offset)?,
        Cursor::Text(before, token) => imports::paths(analysis, &before, token, paths)?,
        Cursor::Code(before) => (before.word, code(analysis, &before, paths)),
    };
    offers.sort_by(|a, b| (a.rank, &a.label).cmp(&(b.rank, &b.label)));
    Some(Completion { span, offers })
}

/// What the compiler knows of the place of the word.
struct Known<'a> {
    /// The design as it is.
    analysis: &'a Analysis,
    /// The design with a name where the word is, or as it is where that says as much.
    read: &'a Analysis,
    /// Where that name stands.
    name: Span,
    before: &'a Before<'a>,
}

impl<'a> Known<'a> {
    fn index(&self) -> &'a Index {
        &self.read.index
    }

    fn hir(&self) -> &'a Hir {
        &self.read.hir
    }

    /// The type that the place would like.
    fn expected(&self) -> Option<&'a Type> {
        self.index().expected_at(self.name)
    }
}

fn code(analysis: &Analysis, before: &Before<'_>, paths: &[String]) -> Vec<Offer> {
    let place = place(before);
    match &place {
        Place::Nothing => return Vec::new(),
        Place::Item => return snippets::items(analysis, before.word),
        Place::Module => return imports::modules(analysis, before, paths),
        Place::Import(module) => return imports::names(analysis, before, *module),
        Place::Kind => return settings::kinds(analysis, before),
        Place::Measure(kind) => return settings::measures(*kind),
        Place::Size => return settings::sizes(),
        Place::Space => return after::spaces(before),
        Place::Word(word) => return vec![Offer::new(word, Kind::Keyword)],
        Place::After => return after::words(before),
        _ => {}
    }
    // A whole text with a name at the place says what is to be said.
    let whole = analysis.files.iter().find(|file| file.file == before.word.file);
    let whole = whole.is_some_and(|file| file.parse.diagnostics.is_empty());
    let named = analysis.index.expected_at(before.word).is_some()
        || analysis.index.references.iter().any(|used| used.span == before.word);
    let supplement = if whole && named {
        None
    } else {
        let text = [before.closing(), String::new()];
        let closing =
            if whole || before.next.is_some_and(TokenKind::is_closer) { &text[1] } else { &text[0] };
        supplemented(analysis, before.word, closing)
    };
    let known = match &supplement {
        Some(read) => Known { analysis, read: &read.analysis, name: read.name, before },
        None => Known { analysis, read: analysis, name: before.word, before },
    };
    match place {
        Place::Member => snippets::members(),
        Place::Step => snippets::steps(),
        Place::Entry(kind) => settings::entries(&known, kind),
        Place::Field(label) => settings::fields(&known, label),
        Place::Argument(callee) => {
            let mut offers = arguments::labels(&known, callee);
            offers.extend(names::values(&known));
            offers
        }
        Place::Type => names::types(&known),
        Place::Part => members::parts(&known),
        Place::Figure => names::figures(&known),
        _ => names::values(&known),
    }
}
