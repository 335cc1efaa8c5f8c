//! The signature of the call around a place, and which of its parameters is being written.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::index::{Index, Target};
use ifs_compiler::hir::type_names::type_name;
use ifs_compiler::hir::types::Type;
use ifs_compiler::hir::{native_item_docs, native_parameter, native_result};
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::TokenKind;

use super::completion::library_item_docs;
use super::tokens::{Before, Open, up_to};
use super::words::written;

/// A signature, with the bytes of its label that each parameter takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Signature {
    pub(crate) label: String,
    pub(crate) parameters: Vec<(u32, u32)>,
    /// The place of the parameter that is being written.
    pub(crate) active: Option<u32>,
    /// Markdown.
    pub(crate) docs: String,
}

/// The signature of the innermost call around a place.
pub(crate) fn signature(analysis: &Analysis, file: FileId, offset: u32) -> Option<Signature> {
    let before = up_to(analysis, file, offset)?;
    let (open, callee) = before.open.iter().rev().find_map(|open| Some((*open, callee(&before, *open)?)))?;
    let target = target(&analysis.index, analysis, callee)?;
    let names = parameters(analysis, target)?;
    let mut signature = labelled(written(analysis, callee), &names, gives(analysis, target));
    signature.active = active(&before, open, label_at(analysis, file, offset), &names);
    signature.docs = docs(analysis, target);
    Some(signature)
}

/// The name that is called by a bracket.
fn callee(before: &Before<'_>, open: Open) -> Option<Span> {
    let name = before.tokens.get(open.at.checked_sub(1)?)?;
    let declared = open.at.checked_sub(2).map(|at| before.tokens[at].kind);
    let declares = matches!(declared, Some(TokenKind::Fn | TokenKind::Ifs | TokenKind::Record));
    let called = matches!(name.kind, TokenKind::Name | TokenKind::Itself);
    let glued = name.span.end == before.tokens[open.at].span.start;
    (open.kind == TokenKind::OpenParenthesis && called && glued && !declares).then_some(name.span)
}

/// The name of an argument around a place: a colon follows it.
fn label_at(analysis: &Analysis, file: FileId, offset: u32) -> Option<&str> {
    let parse = &analysis.files.iter().find(|parsed| parsed.file == file)?.parse;
    let mut tokens = parse.tokens.iter().filter(|token| !token.kind.is_trivia());
    let name = tokens.find(|token| token.span.start <= offset && offset <= token.span.end)?;
    let labels = name.kind == TokenKind::Name && tokens.next()?.kind == TokenKind::Colon;
    labels.then(|| written(analysis, name.span))
}

/// What a name stands for: as the compiler read it, or by its letters where the text around is too broken.
fn target(index: &Index, analysis: &Analysis, name: Span) -> Option<Target> {
    let read = index.references.iter().find(|used| used.span == name).map(|used| used.target);
    read.or_else(|| {
        let word = written(analysis, name);
        let visible = index.names(name.file, name.start);
        visible.iter().find(|visible| visible.name == word).map(|visible| visible.target)
    })
}

/// A parameter: its name, and what it takes in words, with what it is when it is left out.
type Parameter = (String, String);

/// The most letters of a default that are shown.
const MOST_OF_A_DEFAULT: usize = 60;

fn parameters(analysis: &Analysis, target: Target) -> Option<Vec<Parameter>> {
    if let Target::Native(native) = target {
        let all = native.declaration().parameters.iter().map(|parameter| {
            let optional = if parameter.required { "" } else { " (may be left out)" };
            (parameter.name.to_owned(), format!("{}{optional}", native_parameter(parameter)))
        });
        return Some(all.collect());
    }
    let all = analysis.index.parameters(target)?.iter().map(|parameter| {
        let ty = type_name(&analysis.hir.items, &parameter.ty);
        let default = parameter.default.map(|span| format!(" = {}", shortened(written(analysis, span))));
        (parameter.name.clone(), ty + &default.unwrap_or_default())
    });
    Some(all.collect())
}

/// A value as it is written, on one line; the beginning of a long one.
fn shortened(value: &str) -> String {
    let line = value.split_whitespace().collect::<Vec<_>>().join(" ");
    match line.char_indices().nth(MOST_OF_A_DEFAULT) {
        Some((end, _)) => format!("{} …", line[..end].trim_end()),
        None => line,
    }
}

/// What a call gives, in words; nothing where the name says it.
fn gives(analysis: &Analysis, target: Target) -> Option<String> {
    if let Target::Native(native) = target {
        return native_result(native).map(str::to_owned);
    }
    let known = analysis.index.modules.iter().flat_map(|module| &module.own);
    let ty = &known.into_iter().find(|known| known.target == target)?.ty;
    (!matches!(ty, Type::Error | Type::Record(_))).then(|| type_name(&analysis.hir.items, ty))
}

fn labelled(name: &str, parameters: &[Parameter], gives: Option<String>) -> Signature {
    let mut label = format!("{name}(");
    let mut spans = Vec::new();
    for (place, (name, takes)) in parameters.iter().enumerate() {
        if place > 0 {
            label += ", ";
        }
        let start = label.len() as u32;
        label += &format!("{name}: {takes}");
        spans.push((start, label.len() as u32));
    }
    label.push(')');
    if let Some(gives) = gives {
        label += &format!(" -> {gives}");
    }
    Signature { label, parameters: spans, active: None, docs: String::new() }
}

/// The parameter of the argument at the end of `before`: by its name, where that is written or begun there, or the first
/// that has none yet, behind those that are given by their places.
fn active(before: &Before<'_>, open: Open, label: Option<&str>, parameters: &[Parameter]) -> Option<u32> {
    let (named, commas) = before.given_in(open);
    let named_so = |name: &str| parameters.iter().position(|(known, _)| known == name);
    let at = before.argument(open);
    let label = match before.tokens.get(at + 1).map(|token| token.kind) {
        Some(TokenKind::Colon) => Some(before.written(at)),
        Some(_) => None,
        None => label,
    };
    if let Some(label) = label {
        return named_so(label).map(|place| place as u32);
    }
    let by_place = commas.saturating_sub(named.len());
    let open = |(name, _): &Parameter| !named.contains(&name.as_str());
    (by_place..parameters.len()).find(|place| open(&parameters[*place])).map(|place| place as u32)
}

fn docs(analysis: &Analysis, target: Target) -> String {
    if let Target::Native(native) = target {
        return native_item_docs(native.declaration()).docs.join("\n");
    }
    let Target::Declared(span) = target else { return String::new() };
    let module = analysis.index.module(span.file).filter(|module| module.library);
    let name = written(analysis, span);
    if let Some(docs) = module.and_then(|module| library_item_docs(&module.title, name)) {
        return docs.docs.join("\n");
    }
    let item = analysis.hir.items.iter().find(|item| item.name_span == span);
    let lines = item.map_or(&[][..], |item| &item.docs);
    lines.iter().map(|line| line.strip_prefix(' ').unwrap_or(line)).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::features::fixture::fixture;

    /// The label with the active parameter in `[…]`.
    fn shown(text: &str) -> String {
        let design = fixture(text);
        let Some(found) = signature(&design.analysis, design.analysis.root, design.at) else {
            return String::new();
        };
        let Some(active) = found.active else { return found.label };
        let (start, end) = found.parameters[active as usize];
        let (start, end) = (start as usize, end as usize);
        format!("{}[{}]{}", &found.label[..start], &found.label[start..end], &found.label[end..])
    }

    #[test]
    fn the_argument_that_is_written() {
        let arch = "/// An arch.\nfn arch(i: Int, width: Length, tall: Bool = true) -> Length = width\n";
        for (text, expected) in [
            ("let x = arch($0", "arch([i: Int], width: Length, tall: Bool = true) -> Length"),
            ("let x = arch(1, $0)", "arch(i: Int, [width: Length], tall: Bool = true) -> Length"),
            (
                "let x = arch(1, tall: $0\n\nlet y = 2",
                "arch(i: Int, width: Length, [tall: Bool = true]) -> Length",
            ),
            ("let x = arch(tall: true, $0)", "arch([i: Int], width: Length, tall: Bool = true) -> Length"),
            ("let x = arch(1, 2m, true, $0)", "arch(i: Int, width: Length, tall: Bool = true) -> Length"),
            ("let x = arch(1, (2m + $0", "arch(i: Int, [width: Length], tall: Bool = true) -> Length"),
            ("let x = arch(len([1, 2$0]), 2m)", "len([list: [any]]) -> Int"),
            ("let x = arch(1, 2m)$0", ""),
            ("let x = lerp(a, b, 1/$0", "lerp(a: Point, b: Point, [t: Number]) -> Point"),
            ("use std.curves (bezier3)\nfigure f = bezier3(t: 1$0) on", "bezier3([t: Number = 1/2]) -> Ifs"),
            (
                "use std.materials (Radius)\nlet r = Radius(across: 1m, $0)",
                "Radius(across: Length, [along: Length])",
            ),
            ("let x = arch(1, tall: true, $0)", "arch(i: Int, [width: Length], tall: Bool = true) -> Length"),
            ("let x = arch(1, wi$0dth: 2m)", "arch(i: Int, [width: Length], tall: Bool = true) -> Length"),
            ("let x = arch(1, tall$0: true)", "arch(i: Int, width: Length, [tall: Bool = true]) -> Length"),
            ("let x = arch(wid$0)", "arch([i: Int], width: Length, tall: Bool = true) -> Length"),
            (
                "let x = scale(1, 2, abo$0ut: p)",
                "scale(kx: Number, ky: Number (may be left out), kz: Number (may be left out), \
                 [about: Point (may be left out)]) -> Map",
            ),
            (
                "record Arch { base: Length, rise: Length = 2.5m *\n    1 }\nlet x = Arch(base: 3m, $0)",
                "Arch(base: Length, [rise: Length = 2.5m * 1])",
            ),
            (
                "fn f(tool: Length, feed: Speed, plunge: Speed) -> Length = tool\nlet x = f(tool: 6mm, feed: , $0)",
                "f(tool: Length, feed: Speed, [plunge: Speed]) -> Length",
            ),
            ("fn other(a: Int$0) -> Int = a", ""),
            ("let x = nothing(1, $0)", ""),
        ] {
            assert_eq!(shown(&format!("{arch}{text}")), expected, "{text}");
        }
        let design = fixture(&format!("{arch}let x = arch($0)"));
        let found = signature(&design.analysis, design.analysis.root, design.at).unwrap();
        assert_eq!(found.docs, "An arch.");
    }
}
