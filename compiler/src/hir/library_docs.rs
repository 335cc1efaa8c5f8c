//! The documentation of the library, read from its own text and from the table of natives: modules, items, signatures,
//! doc comments. How it is printed is the caller's business, but for the one page of all.

use super::library::LIBRARY;
use super::native::{Native, NativeDeclaration, NativeParameter, Takes, natives};
use super::native_docs::native_docs;
use super::types::Type;
use crate::source::{FileId, Source};
use crate::syntax::{ast, parse};

/// The documentation of a module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ModuleDocs {
    /// Its name after `std.`; `prelude` is known everywhere.
    pub name: &'static str,
    /// Its `//!` lines.
    pub docs: Vec<String>,
    /// What it offers, by name.
    pub items: Vec<ItemDocs>,
}

/// The documentation of an item.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ItemDocs {
    /// Its name.
    pub name: String,
    /// How it is declared, without `pub` and without a body.
    pub signature: String,
    /// Its `///` lines, Markdown; designs in blocks of three backticks and `ifs` can be used as they stand.
    pub docs: Vec<String>,
}

impl ModuleDocs {
    /// The name that `use` takes.
    pub fn path(&self) -> String {
        if self.name == "prelude" { self.name.to_owned() } else { format!("std.{}", self.name) }
    }

    /// What it is, in one sentence.
    pub fn summary(&self) -> String {
        summary(&self.docs)
    }
}

impl ItemDocs {
    /// What it is, in one sentence.
    pub fn summary(&self) -> String {
        summary(&self.docs)
    }
}

/// The first sentence of the first paragraph.
fn summary(docs: &[String]) -> String {
    let lines: Vec<&str> = docs.iter().map(|line| line.trim()).take_while(|line| !line.is_empty()).collect();
    let text = lines.join(" ");
    match text.find(". ") {
        Some(end) => text[..=end].to_owned(),
        None => text,
    }
}

/// All modules of the library with all that they offer.
pub fn library_docs() -> Vec<ModuleDocs> {
    LIBRARY.iter().map(|(name, text)| module(name, text)).collect()
}

fn module(name: &'static str, text: &str) -> ModuleDocs {
    let file = parse(&Source::new(FileId(0), name, text)).ast;
    let declared =
        file.items.iter().filter(|item| item.public.is_some()).filter_map(|item| item_docs(item, text));
    let natives = natives().filter(|native| native.module == name).map(native_item_docs);
    let mut items: Vec<ItemDocs> = declared.chain(natives).collect();
    items.sort_by(|a, b| a.name.cmp(&b.name));
    ModuleDocs { name, docs: file.docs.iter().map(|line| unindented(line)).collect(), items }
}

/// Without the one blank after the marks of a comment.
fn unindented(line: &str) -> String {
    line.strip_prefix(' ').unwrap_or(line).trim_end().to_owned()
}

/// What is said of an item of a file with this text; nothing of what has no name.
pub fn item_docs(item: &ast::Item, text: &str) -> Option<ItemDocs> {
    let until = |end: u32| text.get(item.span.start as usize..end as usize).unwrap_or("").trim();
    let whole = until(item.span.end);
    let before = |value: &ast::Expr| until(value.span.start).trim_end_matches('=');
    let (name, signature) = match &item.kind {
        ast::ItemKind::Function(function) => (&function.name, before(&function.body)),
        ast::ItemKind::Ifs(ifs) => (&ifs.name, whole.split('{').next().unwrap_or(whole)),
        ast::ItemKind::Record(record) => (&record.name, whole),
        ast::ItemKind::Let(value) => (&value.name, before(&value.value)),
        ast::ItemKind::Param(param) => (&param.name, whole),
        ast::ItemKind::Figure(figure) => (&figure.name, before(&figure.value)),
        _ => return None,
    };
    let signature = signature.trim().strip_prefix("pub").map_or(signature, str::trim_start);
    Some(ItemDocs {
        name: name.text.clone(),
        signature: signature.trim().to_owned(),
        docs: item.docs.iter().map(|line| unindented(line)).collect(),
    })
}

/// What is said of a function of the program.
pub fn native_item_docs(declaration: &NativeDeclaration) -> ItemDocs {
    let parameters = declaration.parameters.iter().map(|parameter| {
        let optional = if parameter.required { "" } else { " (may be left out)" };
        format!("{}: {}{optional}", parameter.name, takes(parameter.takes))
    });
    let parameters: Vec<String> = parameters.collect();
    let mut signature = format!("fn {}({})", declaration.name, parameters.join(", "));
    let mut docs = vec![sentence(declaration.doc)];
    if let Some((gives, example)) = native_docs(declaration.native) {
        signature.push_str(&format!(" -> {gives}"));
        docs.extend(["", "```ifs"].map(str::to_owned));
        docs.extend(example.lines().map(str::to_owned));
        docs.push("```".to_owned());
    }
    ItemDocs { name: declaration.name.to_owned(), signature, docs }
}

/// What a function of the program gives, as its signature says it: a type, or the word for one.
pub fn native_result(native: Native) -> Option<&'static str> {
    native_docs(native).map(|(gives, _)| gives)
}

/// What a parameter of a function of the program takes, as its signature says it.
pub fn native_parameter(parameter: &NativeParameter) -> String {
    takes(parameter.takes)
}

/// A phrase as a sentence.
fn sentence(phrase: &str) -> String {
    let mut letters = phrase.chars();
    let first: String = letters.next().map(|first| first.to_uppercase().collect()).unwrap_or_default();
    format!("{first}{}.", letters.as_str().trim_end_matches('.'))
}

/// What a parameter takes, as near as possible to how the language writes types.
fn takes(takes: Takes) -> String {
    match (takes, takes.expected()) {
        (Takes::Closed, _) => "u, v or uv".to_owned(),
        (_, Some(ty)) => type_name(&ty),
        (Takes::Quantity, _) => "Quantity".to_owned(),
        (Takes::QuantityOrList, _) => "Quantity or [Quantity]".to_owned(),
        (Takes::Quantities, _) => "[Quantity]".to_owned(),
        (Takes::List, _) => "[any]".to_owned(),
        (Takes::Lists, _) => "[[any]]".to_owned(),
        (Takes::Summands, _) => "[Quantity] or [Vector]".to_owned(),
        (Takes::Plain, _) => "Quantity, Bool or Text".to_owned(),
        _ => "any".to_owned(),
    }
}

fn type_name(ty: &Type) -> String {
    match ty {
        Type::List(element) => format!("[{}]", type_name(element)),
        Type::Point(_) | Type::Weighted(_) => "Point".to_owned(),
        Type::Vector(_) => "Vector".to_owned(),
        Type::Ifs => "Ifs".to_owned(),
        Type::Int => "Int".to_owned(),
        Type::Bool => "Bool".to_owned(),
        Type::Text => "Text".to_owned(),
        Type::Curve => "Curve".to_owned(),
        Type::Surface => "Surface".to_owned(),
        Type::Figure => "Figure".to_owned(),
        other => other.dimension().map_or("any".to_owned(), |dimension| dimension.name()),
    }
}

/// The whole library as one page of Markdown.
pub fn library_page() -> String {
    let modules = library_docs();
    let mut page = String::from(
        "# The standard library\n\n\
         It ships inside the program. The prelude is known everywhere; all else is named in a `use`, as in\n\
         `use std.curves (bezier3)`. `Quantity` is a number of any dimension.\n\n\
         This page is made of the library's own text: `ifs doc --markdown` prints it, `ifs doc bezier3` one item.\n\n\
         | module | what |\n|---|---|\n",
    );
    for module in &modules {
        let anchor = module.path().replace('.', "");
        page.push_str(&format!("| [`{}`](#{anchor}) | {} |\n", module.path(), module.summary()));
    }
    for module in &modules {
        page.push_str(&format!("\n## {}\n\n{}\n", module.path(), module.docs.join("\n").trim()));
        for item in &module.items {
            page.push_str(&format!("\n### `{}`\n\n```text\n{}\n```\n", item.name, item.signature));
            let docs = item.docs.join("\n");
            if !docs.trim().is_empty() {
                page.push_str(&format!("\n{}\n", docs.trim()));
            }
        }
    }
    page
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_public_is_there_with_its_signature() {
        let modules = library_docs();
        assert_eq!(modules.len(), LIBRARY.len());
        let find = |module: &str, name: &str| {
            let module = modules.iter().find(|known| known.name == module).unwrap();
            module.items.iter().find(|item| item.name == name).cloned()
        };
        let bezier = find("curves", "bezier3").unwrap();
        assert_eq!(bezier.signature, "ifs bezier3(t: Number = 1/2) on (p0, p1, p2, p3)");
        assert!(bezier.summary().starts_with("A cubic Bézier arc"), "{}", bezier.summary());
        let engraved = find("prelude", "engraved").unwrap();
        assert_eq!(
            engraved.signature,
            "fn engraved(height: Length = 12mm, least: Length = 5mm) -> Engraving"
        );
        assert!(find("boards", "Board").unwrap().signature.starts_with("record Board {"));
        assert_eq!(
            find("prelude", "min").unwrap().signature,
            "fn min(a: Quantity or [Quantity], b: Quantity (may be left out)) -> Quantity"
        );
        assert_eq!(find("materials", "whole_millimetres_above"), None);
        for module in &modules {
            assert!(!module.summary().is_empty(), "{} says what it is", module.name);
            for item in &module.items {
                assert!(!item.summary().is_empty(), "{} says what it is", item.name);
                assert!(!item.signature.is_empty() && !item.signature.ends_with('='));
            }
        }
    }
}
