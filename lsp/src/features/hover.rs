//! What stands at a place, in words: how it is declared, its type, what is said of it, and what was made of it.

use std::borrow::Cow;

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::index::{Declaration, DeclarationKind, Target};
use ifs_compiler::hir::schema::{ChoiceKind, Measure, SchemaKind, SettingType};
use ifs_compiler::hir::tree::{ItemId, ItemKind, Made};
use ifs_compiler::hir::type_names::type_name;
use ifs_compiler::hir::types::Type;
use ifs_compiler::hir::{ItemDocs, item_docs, library_docs, native_item_docs, native_parameter};
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::{ast, parse};

use super::boards::board;
use super::facts::{self, WorkedOut};
use super::keywords::{built_in_type, keyword};
use super::words::one_spaced;
use super::{states, sums};

/// Words on a place, as Markdown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Hover {
    pub(crate) span: Span,
    pub(crate) markdown: String,
}

/// What stands at a place.
pub(crate) fn hover(analysis: &Analysis, known: WorkedOut<'_>, file: FileId, offset: u32) -> Option<Hover> {
    if let Some(name) = analysis.index.name_at(file, offset)
        && let Some(markdown) = target(analysis, known, name.target)
    {
        return Some(Hover { span: name.span, markdown });
    }
    if let Some((span, markdown)) = known.made.and_then(|made| board(analysis, made, file, offset)) {
        return Some(Hover { span, markdown: known.dated(markdown) });
    }
    let word = keyword(analysis, file, offset).or_else(|| built_in_type(analysis, file, offset));
    if let Some((span, markdown)) = word {
        return Some(Hover { span, markdown });
    }
    let (span, ty) = analysis.index.type_at(file, offset)?;
    Some(Hover { span, markdown: code(&type_name(&analysis.hir.items, ty)) })
}

fn target(analysis: &Analysis, known: WorkedOut<'_>, target: Target) -> Option<String> {
    match target {
        Target::Declared(span) => declared(analysis, known, analysis.index.declaration(span)?),
        Target::Module(file) => module(analysis, file),
        Target::Native(native) => Some(documented(&native_item_docs(native.declaration()))),
        Target::NativeParameter(native, place) => {
            let declaration = native.declaration();
            let parameter = declaration.parameters.get(place)?;
            let declared = code(&format!("{}: {}", parameter.name, native_parameter(parameter)));
            let optional = if parameter.required { "" } else { "; may be left out" };
            Some(format!("{declared}\nparameter of `{}`{optional}", declaration.name))
        }
        Target::Setting(kind, name) => setting(analysis, kind, name),
        Target::Measure(measure) => Some(of_measure(measure)),
        Target::Size(size) => {
            Some(format!("{}\n---\n{}", code(&format!("until {}: Length", size.word())), size.doc()))
        }
        Target::Made(made) => of_made(made),
        Target::Choice(kind, place) => choice(kind, place),
    }
}

fn code(text: &str) -> String {
    format!("```ifs\n{text}\n```")
}

fn documented(docs: &ItemDocs) -> String {
    let said = docs.docs.join("\n");
    if said.trim().is_empty() {
        code(&one_spaced(&docs.signature))
    } else {
        format!("{}\n---\n{said}", code(&one_spaced(&docs.signature)))
    }
}

fn declared(analysis: &Analysis, known: WorkedOut<'_>, declaration: &Declaration) -> Option<String> {
    let typed = |word: &str| {
        let ty = match declaration.ty {
            Type::Error => String::new(),
            ref ty => format!(": {}", type_name(&analysis.hir.items, ty)),
        };
        code(format!("{word} {}{ty}", declaration.name).trim_start())
    };
    Some(match declaration.kind {
        DeclarationKind::Item(id) => item(analysis, known, declaration, id)?,
        DeclarationKind::Field(owner, place) => {
            let mut text = typed("");
            let owner_item = analysis.hir.item(owner);
            let what = if matches!(owner_item.kind, ItemKind::Record(_)) { "field" } else { "parameter" };
            text += &format!("\n{what} of `{}`", owner_item.name);
            if let Some(docs) = field_docs(analysis, declaration.span, place) {
                text += &format!("\n\n---\n{docs}");
            }
            text
        }
        DeclarationKind::ControlPoint => format!("{}\ncontrol point", typed("")),
        DeclarationKind::Local => match sums::named(analysis, known.overrides, declaration.span) {
            Some(sum) => {
                let ty = type_name(&analysis.hir.items, sum.ty.as_ref().unwrap_or(&declaration.ty));
                let declared = code(&format!("let {}: {ty}", declaration.name));
                format!("{declared}\n---\nweights `{}`", sum.weights)
            }
            None => typed("let"),
        },
        DeclarationKind::Running => typed("for"),
        DeclarationKind::Transform(owner) => {
            let ifs = &analysis.hir.item(owner).name;
            let mut text = format!("{}\ntransform of `{ifs}`", code(&member_of(analysis, declaration.span)));
            if let Some(facts) = states::of_transform(analysis, known, owner, &declaration.name) {
                text += &format!("\n\n---\n{facts}");
            }
            text
        }
        DeclarationKind::Boundary(owner) => {
            format!(
                "{}\nboundary of `{}`",
                code(&member_of(analysis, declaration.span)),
                analysis.hir.item(owner).name
            )
        }
    })
}

/// The tree of a file of the project or of the library.
fn tree(analysis: &Analysis, file: FileId) -> Option<Cow<'_, ast::File>> {
    let own = analysis.files.iter().find(|project| project.file == file);
    match own {
        Some(project) => Some(Cow::Borrowed(&project.parse.ast)),
        None => Some(Cow::Owned(parse(analysis.sources.get(file)?).ast)),
    }
}

/// The member of an ifs whose name stands there, as it is written.
fn member_of(analysis: &Analysis, name: Span) -> String {
    let Some(source) = analysis.sources.get(name.file) else { return String::new() };
    let Some(tree) = tree(analysis, name.file) else { return String::new() };
    let around = |span: Span| span.start <= name.start && name.end <= span.end;
    let member = tree.items.iter().filter(|item| around(item.span)).find_map(|item| match &item.kind {
        ast::ItemKind::Ifs(ifs) => ifs.members.iter().map(|member| member.span).find(|span| around(*span)),
        _ => None,
    });
    one_spaced(source.slice(member.unwrap_or(name)))
}

fn item(analysis: &Analysis, known: WorkedOut<'_>, declaration: &Declaration, id: ItemId) -> Option<String> {
    let docs = ast_item(analysis, declaration).unwrap_or_else(|| ItemDocs {
        name: declaration.name.clone(),
        signature: declaration.name.clone(),
        docs: analysis.hir.item(id).docs.clone(),
    });
    let mut docs = docs;
    let written_type = docs.signature.contains(':') || docs.signature.contains('(');
    if !written_type && matches!(analysis.hir.item(id).kind, ItemKind::Let(_) | ItemKind::Figure(_)) {
        docs.signature += &format!(": {}", type_name(&analysis.hir.items, &declaration.ty));
    }
    let mut text = documented(&docs);
    if let Some(facts) = facts::of_item(analysis, known, id) {
        text += &format!("\n\n---\n{facts}");
    }
    Some(text)
}

/// What is said where an item is declared, in the project or in the library.
fn ast_item(analysis: &Analysis, declaration: &Declaration) -> Option<ItemDocs> {
    let source = analysis.sources.get(declaration.span.file)?;
    if let Some(module) = source.path.strip_prefix("std.").filter(|_| analysis.hir.is_library(source.id)) {
        let docs = library_docs().into_iter().find(|docs| docs.name == module)?;
        return docs.items.into_iter().find(|item| item.name == declaration.name);
    }
    let file = analysis.files.iter().find(|file| file.file == declaration.span.file)?;
    let here = |item: &&ast::Item| {
        item.span.start <= declaration.span.start && declaration.span.end <= item.span.end
    };
    item_docs(file.parse.ast.items.iter().find(here)?, &source.text)
}

fn field_docs(analysis: &Analysis, span: Span, place: usize) -> Option<String> {
    let here = |item: &&ast::Item| item.span.start <= span.start && span.end <= item.span.end;
    let tree = tree(analysis, span.file)?;
    let fields = match &tree.items.iter().find(here)?.kind {
        ast::ItemKind::Function(function) => &function.parameters,
        ast::ItemKind::Record(record) => &record.fields,
        ast::ItemKind::Ifs(ifs) => &ifs.parameters,
        _ => return None,
    };
    let docs: Vec<&str> = fields.get(place)?.docs.iter().map(|line| line.trim()).collect();
    (!docs.is_empty()).then(|| docs.join("\n"))
}

fn module(analysis: &Analysis, file: FileId) -> Option<String> {
    let source = analysis.sources.get(file)?;
    let docs = match source.path.strip_prefix("std.") {
        Some(name) => library_docs().into_iter().find(|docs| docs.name == name)?.docs,
        None => analysis.files.iter().find(|project| project.file == file)?.parse.ast.docs.clone(),
    };
    Some(format!("{}\n---\n{}", code(&source.path), docs.join("\n")))
}

fn setting(analysis: &Analysis, kind: SchemaKind, name: &str) -> Option<String> {
    let setting = kind.setting(name)?;
    let (ty, words) = match &setting.ty {
        SettingType::Of(Type::Choice(choice)) => {
            let words = choice.words().iter().map(|word| format!("\n- `{}`: {}", word.name, word.doc));
            (choice.words().iter().map(|word| word.name).collect::<Vec<_>>().join(" | "), words.collect())
        }
        SettingType::Of(ty) => (type_name(&analysis.hir.items, ty), String::new()),
        SettingType::Library(record) => ((*record).to_owned(), String::new()),
    };
    let needed = if setting.required { "needed" } else { "may be left out" };
    Some(format!("{}\n---\n{}; {needed}{words}", code(&format!("{name}: {ty}")), setting.doc))
}

fn of_measure(measure: Measure) -> String {
    let declared = code(&format!("require {}: {}", measure.words(), measure.dimension().name()));
    format!("{declared}\n---\n{}", measure.doc())
}

fn of_made(made: Made) -> Option<String> {
    let (word, _, doc) = Made::ALL.into_iter().find(|(_, known, _)| *known == made)?;
    Some(format!("{}\n---\n{doc}", code(word)))
}

fn choice(kind: ChoiceKind, place: usize) -> Option<String> {
    let word = kind.words().get(place)?;
    Some(format!("{}\n---\n{}", code(word.name), word.doc))
}
