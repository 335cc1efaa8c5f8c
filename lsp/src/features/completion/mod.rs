//! What can be written at a place. What the tokens before it allow is in `place`; what the compiler knows of a design with
//! a name put there gives types and names.

mod after;
mod arguments;
mod fit;
mod ifs;
mod imports;
mod joins;
mod measures;
mod members;
mod names;
mod needed;
mod place;
mod settings;
mod shapes;
mod snippets;
#[cfg(test)]
mod tests;
mod units;

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::index::Index;
use ifs_compiler::hir::tree::Hir;
use ifs_compiler::hir::types::Type;
use ifs_compiler::source::{FileId, Span};

use super::search::has_letters;
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
    /// Best first, and no more than [`MOST_OFFERS`].
    pub(crate) offers: Vec<Offer>,
    /// Whether these are all: else others may fit when more of the word is written.
    pub(crate) complete: bool,
}

/// How many offers are told at once: nobody reads more, and a client is slow with thousands.
const MOST_OFFERS: usize = 300;

/// What can be written at a place; `paths` gives the files of the project, from its root.
pub(crate) fn completion(
    analysis: &Analysis,
    file: FileId,
    offset: u32,
    paths: &dyn Fn() -> Vec<String>,
) -> Option<Completion> {
    let (span, mut offers) = match cursor(analysis, file, offset)? {
        Cursor::Comment => return None,
        Cursor::Number(before) => units::units(analysis, &before, offset)?,
        Cursor::Text(before, token) => imports::paths(analysis, &before, token, paths)?,
        Cursor::Code(before) => (before.word, code(analysis, &before, paths)),
    };
    let complete = offers.len() <= MOST_OFFERS;
    if !complete {
        let text = &analysis.sources.get(file)?.text;
        let typed = text.get(span.start as usize..offset as usize).unwrap_or("");
        offers.retain(|offer| has_letters(&offer.label, typed));
    }
    offers.sort_by(|a, b| (a.rank, &a.label).cmp(&(b.rank, &b.label)));
    offers.truncate(MOST_OFFERS);
    Some(Completion { span, offers, complete })
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

/// Whether nothing is wrong with the text of a file.
fn is_sound(analysis: &Analysis, file: FileId) -> bool {
    let file = analysis.files.iter().find(|parsed| parsed.file == file);
    file.is_some_and(|file| file.parse.diagnostics.is_empty())
}

fn code(analysis: &Analysis, before: &Before<'_>, paths: &dyn Fn() -> Vec<String>) -> Vec<Offer> {
    let place = place(before);
    match &place {
        Place::Nothing => return Vec::new(),
        Place::Item => return snippets::items(analysis, before.word),
        Place::Module => return imports::modules(analysis, before, paths),
        Place::Import(module) => return imports::names(analysis, before, *module),
        Place::Kind => return settings::kinds(analysis, before),
        Place::Measure(kind) => return measures::measures(*kind),
        Place::Limit(kind, words) => return measures::limits(*kind, words),
        Place::Size => return measures::sizes(),
        Place::SizeLimit => return measures::size_limits(),
        Place::Space => return after::spaces(before),
        Place::Word(word) => return vec![Offer::new(word, Kind::Keyword)],
        _ => {}
    }
    let as_it_is = Known { analysis, read: analysis, name: before.word, before };
    match &place {
        Place::After => return after::words(&as_it_is),
        Place::Join => return joins::paths(&as_it_is),
        Place::Member => return snippets::members(ifs::space(before)),
        Place::Step => return snippets::steps(),
        Place::Entry(kind) => return settings::entries(&as_it_is, *kind),
        Place::Field(label) => return settings::fields(&as_it_is, *label),
        Place::FieldOf(brace) => return settings::fields_of(&as_it_is, *brace),
        Place::Type => return names::types(&as_it_is),
        _ => {}
    }
    // A sound text with a name at the place says what is to be said.
    let sound = is_sound(analysis, before.word.file);
    let named = analysis.index.expected_at(before.word).is_some()
        || analysis.index.references.iter().any(|used| used.span == before.word);
    let supplement =
        (!sound || !named).then(|| supplemented(analysis, before.word, &before.completed(sound))).flatten();
    let known = match &supplement {
        Some(read) => Known { analysis, read: &read.analysis, name: read.name, before },
        None => as_it_is,
    };
    match place {
        Place::Argument(callee) => {
            let mut offers = arguments::labels(&known, callee);
            offers.extend(names::values(&known));
            offers
        }
        Place::Part => members::parts(&known),
        Place::Figure => names::figures(&known),
        _ => names::values(&known),
    }
}
