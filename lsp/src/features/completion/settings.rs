//! Settings and requirements of fabricate blocks, and fields in braces: those not given yet.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::index::Target;
use ifs_compiler::hir::schema::{SchemaKind, Setting, SettingType};
use ifs_compiler::hir::type_names::type_name;
use ifs_compiler::hir::types::Type;
use ifs_compiler::source::Span;
use ifs_compiler::syntax::TokenKind;

use super::{Kind, Known, Offer, needed, shapes};
use crate::features::tokens::Before;
use crate::features::words::written;

/// What a figure can be fabricated as.
pub(super) fn kinds(analysis: &Analysis, before: &Before<'_>) -> Vec<Offer> {
    let kinds = [
        (SchemaKind::Panels, "flat boards, one for each quad of a surface"),
        (SchemaKind::Planks, "straight planks, one for each segment of a curve"),
    ];
    let has_block = before.next == Some(TokenKind::OpenBrace);
    // A block that is not whole has no names that were looked up.
    let names = analysis.index.names(before.word.file, before.word.start);
    let figure = names.iter().find(|visible| visible.name == before.written(1));
    let fits = figure.and_then(|figure| shapes::of_figure(&analysis.hir, figure.target));
    let offers = kinds.map(|(kind, detail)| {
        let offer = if has_block {
            Offer::new(kind.name(), Kind::Keyword)
        } else {
            needed::kind_with_block(analysis, before.word, kind)
        };
        offer.detail(detail).rank(u8::from(fits.is_some_and(|fits| fits != kind)))
    });
    offers.to_vec()
}

/// The settings of a fabricate block that are not given yet, and `require`.
pub(super) fn entries(known: &Known<'_>, kind: Option<SchemaKind>) -> Vec<Offer> {
    let kinds = kind.map_or(vec![SchemaKind::Panels, SchemaKind::Planks], |kind| vec![kind]);
    let mut settings: Vec<Setting> = kinds.iter().flat_map(|kind| kind.settings()).collect();
    settings.sort_by_key(|setting| !setting.required);
    let mut names = std::collections::BTreeSet::new();
    settings.retain(|setting| names.insert(setting.name));
    let given = given(known);
    let mut offers = missing(known, settings, &given);
    let glued = !known.before.new_line && known.before.next == Some(TokenKind::CloseBrace);
    let whole =
        kind.and_then(|kind| needed::settings(known.analysis, known.before.word, kind, &given, glued));
    if let Some(whole) = whole {
        offers.iter_mut().for_each(|offer| offer.rank += 1);
        offers.insert(0, whole);
    }
    let require = Offer::new("require", Kind::Keyword).detail("what the compiler checks of every board");
    offers.push(require.snippet("require $0").rank(50));
    offers
}

/// The settings that the block around has, before and behind the cursor.
fn given(known: &Known<'_>) -> Vec<String> {
    let (before, _) = known.before.given();
    let mut given: Vec<String> = before.into_iter().map(str::to_owned).collect();
    let file = known.read.files.iter().find(|file| file.file == known.name.file);
    let around = file
        .into_iter()
        .flat_map(|file| &file.parse.ast.items)
        .find(|item| item.span.start <= known.name.start && known.name.end <= item.span.end);
    if let Some(ifs_compiler::syntax::ast::ItemKind::Fabricate(block)) = around.map(|item| &item.kind) {
        given.extend(block.entries.iter().filter_map(|entry| match &entry.kind {
            ifs_compiler::syntax::ast::EntryKind::Setting(name, _) if name.span != known.name => {
                Some(name.text.clone())
            }
            _ => None,
        }));
    }
    given
}

fn missing(known: &Known<'_>, settings: Vec<Setting>, given: &[String]) -> Vec<Offer> {
    let missing = settings.into_iter().filter(|setting| !given.iter().any(|given| given == setting.name));
    missing
        .enumerate()
        .map(|(place, setting)| {
            let ty = match &setting.ty {
                SettingType::Of(ty) => type_name(&known.hir().items, ty),
                SettingType::Library(record) => (*record).to_owned(),
            };
            let needed = if setting.required { "needed" } else { "may be left out" };
            let value = match &setting.ty {
                SettingType::Of(Type::Settings(_)) => "{ $0 }",
                SettingType::Of(Type::Size) => &needed::size(setting.name),
                _ => "$0",
            };
            Offer::new(setting.name, Kind::Field)
                .detail(ty)
                .docs(format!("{}; {needed}", setting.doc))
                .snippet(format!("{}: {value}", setting.name))
                .rank(place as u8)
        })
        .collect()
}

/// The fields of what stands in braces behind a label, that are not given yet.
pub(super) fn fields(known: &Known<'_>, label: Span) -> Vec<Offer> {
    let named = known.index().name_at(label.file, label.start);
    let setting = match named.map(|name| name.target) {
        Some(Target::Setting(kind, name)) => kind.setting(name).map(|setting| setting.ty),
        Some(Target::Declared(span)) => {
            known.index().declaration(span).map(|declared| SettingType::Of(declared.ty.clone()))
        }
        // A block that is too broken to be read still has its label.
        _ => by_label(known, written(known.analysis, label)),
    };
    fields_of_type(known, setting)
}

/// The fields of what stands in the braces that open there, by the type that their place would like.
pub(super) fn fields_of(known: &Known<'_>, brace: Span) -> Vec<Offer> {
    let here = |place: &Span| (place.file, place.start) == (brace.file, brace.start);
    let expected = known.index().expected.iter().find(|(place, _)| here(place));
    fields_of_type(known, expected.map(|(_, ty)| SettingType::Of(ty.clone())))
}

fn fields_of_type(known: &Known<'_>, ty: Option<SettingType>) -> Vec<Offer> {
    let (given, _) = known.before.given();
    let given: Vec<String> = given.into_iter().map(str::to_owned).collect();
    match ty {
        Some(SettingType::Of(Type::Settings(kind))) => missing(known, kind.settings(), &given),
        Some(SettingType::Of(Type::Record(id))) => {
            let name = known.hir().item(id).name_span;
            record(known, known.index().parameters(Target::Declared(name)), &given)
        }
        Some(SettingType::Library(record_name)) => {
            let public = known.index().modules.iter().filter(|module| module.library);
            let found = public.flat_map(|module| &module.public).find(|public| public.name == record_name);
            record(known, found.and_then(|found| found.parameters.as_deref()), &given)
        }
        _ => Vec::new(),
    }
}

fn by_label(known: &Known<'_>, label: &str) -> Option<SettingType> {
    let at = known.before.tokens.iter().position(|token| token.kind.text() == Some("{"))?;
    let kind = match known.before.written(at.checked_sub(1)?) {
        "panels" => SchemaKind::Panels,
        "planks" => SchemaKind::Planks,
        _ => return None,
    };
    kind.setting(label).map(|setting| setting.ty)
}

fn record(
    known: &Known<'_>,
    fields: Option<&[ifs_compiler::hir::index::Parameter]>,
    given: &[String],
) -> Vec<Offer> {
    let fields = fields.unwrap_or_default().iter().filter(|field| !given.contains(&field.name));
    let fields: Vec<_> = fields.collect();
    let must = fields.iter().filter(|field| field.required);
    let must: Vec<_> = must.map(|field| (field.name.as_str(), Some(&field.ty))).collect();
    let each = fields.iter().enumerate().map(|(place, field)| {
        Offer::new(&field.name, Kind::Field)
            .detail(type_name(&known.hir().items, &field.ty))
            .snippet(format!("{}: $0", field.name))
            .rank((place as u8).saturating_add(if field.required { 1 } else { 101 }))
    });
    needed::named(&must).into_iter().chain(each).collect()
}
