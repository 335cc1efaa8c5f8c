//! Names of values, types and figures that can be written, those of the library with the `use` that they need.

use std::sync::LazyLock;

use ifs_compiler::hir::index::{DeclarationKind, Origin, Parameter, Target, Visible};
use ifs_compiler::hir::schema::ChoiceKind;
use ifs_compiler::hir::tree::ItemKind;
use ifs_compiler::hir::type_names::{type_name, type_names};
use ifs_compiler::hir::types::{PointSpace, Type};
use ifs_compiler::hir::{ItemDocs, ModuleDocs, library_docs, native_item_docs, native_result};
use ifs_compiler::source::Span;
use ifs_compiler::syntax::TokenKind;

use super::fit::Fit;
use super::imports::to_import;
use super::place::block_kind;
use super::snippets::call;
use super::{Kind, Known, Offer, fit, ifs, needed, shapes};

static LIBRARY: LazyLock<Vec<ModuleDocs>> = LazyLock::new(library_docs);

/// What is said of an item of the library: `std.curves`, `bezier3`.
pub(crate) fn library_item_docs(module: &str, name: &str) -> Option<&'static ItemDocs> {
    let module = LIBRARY.iter().find(|docs| Some(docs.name) == module.strip_prefix("std."))?;
    module.items.iter().find(|item| item.name == name)
}

/// Everything that can stand where a value is wanted.
pub(super) fn values(known: &Known<'_>) -> Vec<Offer> {
    let expected = known.expected();
    let mut offers = words(known, expected);
    if let Some(Type::Choice(_)) = expected {
        return offers;
    }
    let names = known.index().names(known.name.file, known.name.start);
    let own = defined(known);
    let others = names.iter().filter(|visible| own.is_none_or(|own| visible.target != Target::Declared(own)));
    let continued = ifs::continued(known);
    offers.extend(others.filter_map(|visible| value(known, visible, expected, continued)));
    offers
}

/// The name of the value that is being defined here: it cannot be made of itself.
fn defined(known: &Known<'_>) -> Option<Span> {
    let of_itself = [TokenKind::Let, TokenKind::Param, TokenKind::Figure];
    let item = known.before.item().filter(|item| of_itself.contains(item))?;
    let word = known.before.tokens.iter().position(|token| token.kind == item)?;
    known.before.tokens.get(word + 1).map(|name| name.span)
}

/// Words of the language that are values where `expected` is wanted.
fn words(known: &Known<'_>, expected: Option<&Type>) -> Vec<Offer> {
    let word = |word: &str| Offer::new(word, Kind::Keyword);
    let in_ifs = known.before.item() == Some(TokenKind::Ifs);
    let mut offers = match expected {
        Some(Type::Choice(kind)) => return choices(*kind),
        Some(Type::Bool) => vec![word("true"), word("false")],
        Some(Type::Settings(_)) => vec![word("{ … }").snippet("{ $0 }").detail("fields by name")],
        Some(Type::Record(id)) => {
            let name = known.hir().item(*id).name_span;
            let fields = known.index().parameters(Target::Declared(name)).unwrap_or_default();
            vec![needed::braces(fields).detail("fields by name")]
        }
        Some(Type::Size) => {
            let setting = known.before.back(2).map_or("", |_| known.before.back_text(2));
            vec![word("… by …").snippet(needed::size(setting)).detail("two lengths")]
        }
        Some(Type::Germ) if ifs::space(known.before) == Some(PointSpace::Control) => vec![
            word("limit").docs("The curve itself between its ends: what the figure tends to."),
            word("control").docs("The control points, one joined to the next."),
        ],
        _ => Vec::new(),
    };
    if in_ifs && matches!(expected, None | Some(Type::Ifs)) {
        let around = "The ifs around, with its own arguments.";
        offers.push(word("self").docs(around).rank(if expected.is_some() { 0 } else { 60 }));
    }
    let required = known.before.statement().first().map_or("", |first| known.before.written(*first));
    if known.before.item() == Some(TokenKind::Fabricate) && required == "require" {
        let material = Offer::new("material", Kind::Value).detail("the material of the block");
        offers.push(material.rank(rank(Fit::Unknown, Origin::Local)));
    }
    offers.push(word("if").snippet("if ${1:condition} then ${2:one} else ${3:other}").rank(90));
    if matches!(expected, None | Some(Type::List(_) | Type::Figure)) {
        let list = "[${1:i} for ${2:i} in ${3:0..3}]";
        offers.push(word("for").snippet(list).detail("a list of what is made of each").rank(90));
    }
    offers
}

/// The words of a choice.
pub(super) fn choices(kind: ChoiceKind) -> Vec<Offer> {
    let words = kind.words().iter().enumerate();
    words.map(|(place, word)| Offer::new(word.name, Kind::Choice).rank(place as u8)).collect()
}

/// How near a name is, after how well it fits.
fn rank(fit: Fit, origin: Origin<'_>) -> u8 {
    let origin = match origin {
        Origin::Local => 0,
        Origin::Own => 1,
        Origin::Imported => 2,
        Origin::Prelude => 5,
        Origin::Library(_) => 6,
    };
    10 + 20 * fit as u8 + origin
}

/// A name as a value; `continued` is the space of the ifs around where that continues with what is written.
fn value(
    known: &Known<'_>,
    visible: &Visible<'_>,
    expected: Option<&Type>,
    continued: Option<PointSpace>,
) -> Option<Offer> {
    let kind = kind_of(known, visible);
    let of_type = || match visible.target {
        Target::Native(native) => Fit::of_words(known.index(), native_result(native).unwrap_or(""), expected),
        _ => Fit::of(known.index(), visible.ty, expected),
    };
    if ifs::elsewhere(visible, known.before) {
        return None;
    }
    let mut fit = continued.map_or_else(of_type, |own| ifs::fit(visible, own));
    let material = expected == Some(&Type::Material) && fit == Fit::Yes;
    if material && !fit::serves(known.index(), known.hir(), visible.ty, block_kind(known.before)) {
        fit = Fit::No;
    }
    let origin = visible.origin;
    // Of all that the library could bring, what does not fit is not told.
    if fit == Fit::No && matches!(origin, Origin::Prelude | Origin::Library(_)) {
        return None;
    }
    let mut offer = named(known, visible, kind);
    offer.rank = rank(fit, origin);
    if material && kind == Kind::Record {
        // What is known already comes before what is made of its fields.
        offer.rank += 6;
    }
    if known.before.next != Some(TokenKind::OpenParenthesis) {
        offer.snippet = match visible.target {
            Target::Native(native) => {
                let needed = native.declaration().parameters.iter().filter(|parameter| parameter.required);
                call(visible.name, needed.map(|parameter| parameter.name))
            }
            _ => match visible.parameters {
                Some(parameters) => of_parameters(visible.name, kind, parameters),
                None => visible.name.to_owned(),
            },
        };
        let moves = known.before.next_on_line && known.before.next == Some(TokenKind::Star);
        if continued.is_some() && ifs::is_map(visible) && !moves {
            offer.snippet += " * self";
        }
    }
    Some(offer)
}

/// A call with what it needs; an ifs that needs nothing is named alone.
fn of_parameters(name: &str, kind: Kind, parameters: &[Parameter]) -> String {
    let needed: Vec<&str> =
        parameters.iter().filter(|parameter| parameter.required).map(|needed| needed.name.as_str()).collect();
    if kind == Kind::Ifs && needed.is_empty() {
        return name.to_owned();
    }
    if kind == Kind::Record {
        let fields = needed.iter().enumerate().map(|(place, name)| format!("{name}: ${{{}}}", place + 1));
        return format!("{name}({})", fields.collect::<Vec<_>>().join(", "));
    }
    call(name, needed.into_iter())
}

/// The name itself with its docs and its import.
fn named(known: &Known<'_>, visible: &Visible<'_>, kind: Kind) -> Offer {
    let mut offer = Offer::new(visible.name, kind);
    offer.module = match visible.origin {
        Origin::Local | Origin::Own if !known.hir().is_library(known.name.file) => None,
        _ => {
            let mut library = known.index().modules.iter().filter(|module| module.library);
            let offers =
                library.find(|module| module.public.iter().any(|public| public.target == visible.target));
            offers.map(|module| module.title.clone())
        }
    };
    offer.detail = match (visible.target, visible.ty) {
        (Target::Native(native), _) => native_item_docs(native.declaration()).signature,
        (_, Type::Error) => String::new(),
        (_, ty) => type_name(&known.hir().items, ty),
    };
    if offer.module.is_none()
        && let Target::Declared(span) = visible.target
    {
        offer.docs = match known.index().declaration(span).map(|declared| declared.kind) {
            Some(DeclarationKind::Item(id)) => unindented(&known.hir().item(id).docs),
            _ => String::new(),
        };
    }
    if let Origin::Library(module) = visible.origin {
        offer.elsewhere = to_import(known.analysis, known.before.word.file, module, visible.name);
    }
    offer
}

/// Lines of docs without the blank behind the marks.
fn unindented(docs: &[String]) -> String {
    docs.iter().map(|line| line.strip_prefix(' ').unwrap_or(line)).collect::<Vec<_>>().join("\n")
}

fn kind_of(known: &Known<'_>, visible: &Visible<'_>) -> Kind {
    let Target::Declared(span) = visible.target else { return Kind::Function };
    let Some(declared) = known.index().declaration(span) else { return Kind::Value };
    match declared.kind {
        DeclarationKind::Item(id) => match &known.hir().item(id).kind {
            ItemKind::Param(_) => Kind::Parameter,
            ItemKind::Let(_) => Kind::Value,
            ItemKind::Figure(_) => Kind::Figure,
            ItemKind::Function(_) => Kind::Function,
            ItemKind::Record(_) => Kind::Record,
            ItemKind::Ifs(_) => Kind::Ifs,
            // An item of the library is checked only where it is used.
            ItemKind::Broken => match (visible.parameters, visible.ty) {
                (Some(_), Type::Ifs) => Kind::Ifs,
                (Some(_), Type::Record(_)) if visible.name.starts_with(char::is_uppercase) => Kind::Record,
                (Some(_), _) => Kind::Function,
                (None, _) => Kind::Value,
            },
        },
        DeclarationKind::Field(..) => Kind::Parameter,
        _ => Kind::Value,
    }
}

/// The types that can be written: those of the language, and records.
pub(super) fn types(known: &Known<'_>) -> Vec<Offer> {
    let mut offers: Vec<Offer> =
        type_names().map(|name| Offer::new(name, Kind::Type).rank(u8::from(name != "Number"))).collect();
    offers.push(Offer::new("[…]", Kind::Type).snippet("[${1:Number}]").detail("a list").rank(2));
    let names = known.index().names(known.name.file, known.name.start);
    let records = names.iter().filter(|visible| kind_of(known, visible) == Kind::Record);
    offers.extend(records.map(|visible| {
        let mut offer = named(known, visible, Kind::Record);
        offer.rank = rank(Fit::Yes, visible.origin);
        offer
    }));
    offers
}

/// The figures of the design that no other block makes boards of.
pub(super) fn figures(known: &Known<'_>) -> Vec<Offer> {
    let names = known.index().names(known.name.file, known.name.start);
    let figures = names.iter().filter(|visible| kind_of(known, visible) == Kind::Figure);
    let made = |visible: &&Visible<'_>| shapes::is_made(known.analysis, visible.name, known.before.word);
    figures.filter(|visible| !made(visible)).map(|visible| named(known, visible, Kind::Figure)).collect()
}
