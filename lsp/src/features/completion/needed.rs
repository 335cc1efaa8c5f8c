//! All that a block, a call or a record cannot be without, as one snippet with places to fill in.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::index::{Known, Origin, Parameter};
use ifs_compiler::hir::schema::{SchemaKind, Setting, SettingType};
use ifs_compiler::hir::types::Type;
use ifs_compiler::hir::value_to_begin_with;
use ifs_compiler::source::Span;

use super::fit::{Fit, serves};
use super::imports::to_import;
use super::snippets::{escaped, filled};
use super::{Kind, Offer, shapes};

/// The material that is written where the design has none.
fn usual_material(kind: SchemaKind) -> (&'static str, &'static str) {
    match kind {
        SchemaKind::Panels => ("birch_plywood", "birch_plywood(12mm)"),
        _ => ("sawn_spruce", "sawn_spruce"),
    }
}

/// A material of the design, else the usual one with what must be imported for it.
fn material(analysis: &Analysis, place: Span, kind: SchemaKind) -> (String, Option<(Span, String)>) {
    let (usual, call) = usual_material(kind);
    let names = analysis.index.names(place.file, place.start);
    let known = names.iter().filter(|visible| matches!(visible.origin, Origin::Own | Origin::Imported));
    let own = known.filter(|visible| visible.name.starts_with(|c: char| c.is_ascii_lowercase())).find_map(
        |visible| {
            let fits = Fit::of(&analysis.index, visible.ty, Some(&Type::Material)) == Fit::Yes;
            if !fits || !serves(&analysis.index, &analysis.hir, visible.ty, Some(kind)) {
                return None;
            }
            let needed =
                visible.parameters.map(|all| all.iter().filter(|one| one.required).collect::<Vec<_>>());
            match needed.as_deref() {
                _ if visible.name == usual => Some(call.to_owned()),
                None => Some(visible.name.to_owned()),
                Some([]) => Some(format!("{}()", visible.name)),
                Some([one]) if one.ty == Type::LENGTH => Some(format!("{}(12mm)", visible.name)),
                Some(_) => None,
            }
        },
    );
    match own {
        Some(own) => (own, None),
        None => (call.to_owned(), to_import(analysis, place.file, "std.materials", usual)),
    }
}

/// The places of a snippet, one after the other.
#[derive(Default)]
struct Places(usize);

impl Places {
    fn of(&mut self, text: &str) -> String {
        self.0 += 1;
        format!("${{{}:{}}}", self.0, escaped(text))
    }
}

/// The sides of a size to begin with, in a setting of this name: a section, or a raw board.
fn sides(setting: &str) -> (&'static str, &'static str) {
    if setting == "section" { ("120mm", "40mm") } else { ("2500mm", "1250mm") }
}

/// The same as a snippet.
pub(super) fn size(setting: &str) -> String {
    let (first, second) = sides(setting);
    format!("${{1:{first}}} by ${{2:{second}}}")
}

/// The fields of a record that must be given, in braces.
pub(super) fn braces(fields: &[Parameter]) -> Offer {
    let must: Vec<_> = fields.iter().filter(|field| field.required).collect();
    if must.is_empty() {
        return Offer::new("{ … }", Kind::Keyword).snippet("{ $0 }");
    }
    // What is made elsewhere is better than braces with fields that nothing is known for.
    let known = must.iter().all(|field| value_to_begin_with(&field.ty).is_some());
    let must: Vec<_> = must.iter().map(|field| (field.name.as_str(), Some(&field.ty))).collect();
    whole("{ … }", Kind::Keyword, format!("{{ {} }}", given(&must))).rank(if known { 0 } else { 29 })
}

/// Arguments or fields with values to begin with, as a snippet.
fn given(needed: &[(&str, Option<&Type>)]) -> String {
    let mut places = Places::default();
    let given = needed.iter().map(|(name, ty)| {
        let value = ty.and_then(value_to_begin_with).unwrap_or_else(|| (*name).to_owned());
        format!("{name}: {}", places.of(&value))
    });
    given.collect::<Vec<_>>().join(", ")
}

/// The lines of settings that a block needs, and what must be imported for them.
fn lines(
    analysis: &Analysis,
    place: Span,
    kind: SchemaKind,
    needed: &[&Setting],
    places: &mut Places,
) -> (Vec<String>, Option<(Span, String)>) {
    let mut import = None;
    let lines = needed.iter().map(|setting| {
        let value = match (&setting.ty, setting.name) {
            (SettingType::Of(Type::Material), _) => {
                let (text, elsewhere) = material(analysis, place, kind);
                import = elsewhere;
                places.of(&text)
            }
            (SettingType::Of(Type::Size), name) => {
                let (first, second) = sides(name);
                format!("{} by {}", places.of(first), places.of(second))
            }
            (SettingType::Of(ty), name) => {
                places.of(&value_to_begin_with(ty).unwrap_or_else(|| name.to_owned()))
            }
            (SettingType::Library(_), _) => "{ }".to_owned(),
        };
        format!("{}: {value}", setting.name)
    });
    (lines.collect(), import)
}

/// What is written whole, whether places can be filled in or not.
fn whole(label: &str, kind: Kind, snippet: String) -> Offer {
    let plain = filled(&snippet);
    Offer { plain: Some(plain), ..Offer::new(label, kind).snippet(snippet) }
}

/// `panels` or `planks` with its block.
pub(super) fn kind_with_block(analysis: &Analysis, place: Span, kind: SchemaKind) -> Offer {
    let settings = kind.settings();
    let needed: Vec<&Setting> = settings.iter().filter(|setting| setting.required).collect();
    let (lines, import) = lines(analysis, place, kind, &needed, &mut Places::default());
    let word = kind.name();
    let mut offer =
        whole(word, Kind::Keyword, format!("{word} {{\n    {}\n    $0\n}}", lines.join("\n    ")));
    offer.elsewhere = import;
    offer
}

/// A whole block for a figure that has none, where the design has one.
pub(super) fn block(analysis: &Analysis, place: Span, kind: SchemaKind) -> Offer {
    let own = analysis.index.module(place.file).map_or(&[][..], |module| &module.own);
    let free = || {
        let figures = own.iter().filter(|known| shapes::is_figure(&analysis.hir, known.target));
        figures.filter(|known| !shapes::is_made(analysis, &known.name, place))
    };
    let fits = |known: &&Known| shapes::of_figure(&analysis.hir, known.target) == Some(kind);
    let unknown =
        |known: &&Known| known.ty.is_figure() && shapes::of_figure(&analysis.hir, known.target).is_none();
    let figure = free().find(fits).or_else(|| free().find(unknown));
    let settings = kind.settings();
    let needed: Vec<&Setting> = settings.iter().filter(|setting| setting.required).collect();
    let mut places = Places::default();
    let name = places.of(figure.map_or("figure", |known| &known.name));
    let (lines, import) = lines(analysis, place, kind, &needed, &mut places);
    let word = kind.name();
    let snippet = format!("fabricate {name} as {word} {{\n    {}\n    $0\n}}", lines.join("\n    "));
    let mut offer = whole(&format!("fabricate as {word}"), Kind::Keyword, snippet);
    offer.detail = format!("{word} out of a figure, with what they need");
    offer.elsewhere = import;
    offer
}

/// All settings that a block of a kind needs and does not have, where they are more than one; `glued` says that the
/// braces stand on one line.
pub(super) fn settings(
    analysis: &Analysis,
    place: Span,
    kind: SchemaKind,
    given: &[String],
    glued: bool,
) -> Option<Offer> {
    let settings = kind.settings();
    let absent = |setting: &&Setting| setting.required && !given.iter().any(|given| given == setting.name);
    let needed: Vec<&Setting> = settings.iter().filter(absent).collect();
    if needed.len() < 2 {
        return None;
    }
    let label = needed.iter().map(|setting| setting.name).collect::<Vec<_>>().join(", ");
    let (lines, import) = lines(analysis, place, kind, &needed, &mut Places::default());
    let snippet = if glued { format!("\n    {}\n", lines.join("\n    ")) } else { lines.join("\n") };
    let mut offer = whole(&label, Kind::Field, snippet).detail(format!("all that {} need", kind.name()));
    offer.elsewhere = import;
    Some(offer)
}

/// All arguments or fields that must be given and are not, where they are more than one: their names, and their types
/// where they are known.
pub(super) fn named(needed: &[(&str, Option<&Type>)]) -> Option<Offer> {
    if needed.len() < 2 {
        return None;
    }
    let label = needed.iter().map(|(name, _)| format!("{name}: …")).collect::<Vec<_>>().join(", ");
    Some(whole(&label, Kind::Field, given(needed)).detail("all that must be given"))
}
