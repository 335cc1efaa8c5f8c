//! `ifs doc`: the documentation of the library: its modules, one of them, or one item.

use ifs_compiler::diagnostic::closest;
use ifs_compiler::hir::{ItemDocs, ModuleDocs, library_docs, library_page};

use crate::args::Doc;
use crate::exit::Exit;
use crate::output;

/// Prints what is asked for.
pub fn doc(doc: &Doc) -> Exit {
    let print = |text: &str| output::data(text).err().unwrap_or(Exit::Good);
    if doc.markdown {
        return print(&library_page());
    }
    let modules = library_docs();
    let Some(name) = &doc.item else { return print(&overview(&modules)) };
    let text = found(&modules, name.trim());
    if !text.is_empty() {
        return print(&text);
    }
    output::message(&format!("error: the library has no `{name}`\n"));
    let items = modules.iter().flat_map(|module| module.items.iter().map(|item| item.name.as_str()));
    let names = modules.iter().map(|module| module.name).chain(items);
    let last = name.rsplit('.').next().unwrap_or(name);
    match closest(last, names) {
        Some(near) => output::message(&format!("  help: did you mean `{near}`?\n")),
        None => {
            output::message("  help: `ifs doc` lists the modules, `ifs doc curves` what one of them offers\n")
        }
    }
    Exit::Usage
}

/// The module or the items of a name: `curves`, `std.curves`, `bezier3`, `std.curves.bezier3`.
fn found(modules: &[ModuleDocs], name: &str) -> String {
    let name = name.strip_prefix("std.").unwrap_or(name);
    if let Some(module) = modules.iter().find(|module| module.name == name) {
        return one_module(module);
    }
    let (within, item) = match name.split_once('.') {
        Some((module, item)) => (Some(module), item),
        None => (None, name),
    };
    let mut text = String::new();
    for module in modules.iter().filter(|module| within.is_none_or(|within| module.name == within)) {
        for item in module.items.iter().filter(|known| known.name == item) {
            text.push_str(&one_item(module, item));
        }
    }
    text
}

fn overview(modules: &[ModuleDocs]) -> String {
    let rows = modules.iter().map(|module| (module.path(), module.summary()));
    let mut text = columns(rows);
    text.push_str("\n`ifs doc curves` lists a module, `ifs doc bezier3` explains an item.\n");
    text
}

fn one_module(module: &ModuleDocs) -> String {
    let mut text = format!("{}\n\n{}\n\n", module.path(), module.docs.join("\n").trim());
    text.push_str(&columns(module.items.iter().map(|item| (item.name.clone(), item.summary()))));
    text
}

fn one_item(module: &ModuleDocs, item: &ItemDocs) -> String {
    let known = match module.name {
        "prelude" => "known everywhere".to_owned(),
        _ => format!("use {} ({})", module.path(), item.name),
    };
    format!("{}\n\n    {known}\n\n{}\n", item.signature, item.docs.join("\n").trim())
}

/// Two columns, the second aligned.
fn columns(rows: impl Iterator<Item = (String, String)>) -> String {
    let rows: Vec<(String, String)> = rows.collect();
    let width = rows.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    rows.iter()
        .map(|(name, what)| {
            let gap = " ".repeat(width - name.chars().count());
            format!("{}\n", format!("{name}{gap}  {what}").trim_end())
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lead_to_modules_and_items() {
        let modules = library_docs();
        assert!(overview(&modules).contains("std.curves"));
        for name in ["curves", "std.curves"] {
            assert!(found(&modules, name).contains("bezier3"), "{name}");
        }
        for name in ["bezier3", "curves.bezier3", "std.curves.bezier3"] {
            assert!(found(&modules, name).contains("use std.curves (bezier3)"), "{name}");
        }
        assert!(found(&modules, "lerp").contains("known everywhere"));
        for name in ["", "std", "surfaces.bezier3", "bezier33", "curves."] {
            assert_eq!(found(&modules, name), "", "{name}");
        }
    }
}
