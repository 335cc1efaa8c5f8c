//! What each token is, for its colour: what names stand for is the compiler's.

use std::collections::BTreeMap;

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::index::{DeclarationKind, Target};
use ifs_compiler::hir::tree::ItemKind;
use ifs_compiler::hir::type_names::type_names;
use ifs_compiler::hir::types::Type;
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::TokenKind;

/// What a token is, in the order that the client is told of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Meaning {
    Keyword,
    Comment,
    Text,
    Number,
    Operator,
    Module,
    Type,
    Record,
    Ifs,
    Function,
    Transform,
    Property,
    Parameter,
    Variable,
    Choice,
}

/// The protocol's words for them, in the same order.
pub(crate) const MEANINGS: [(Meaning, &str); 15] = [
    (Meaning::Keyword, "keyword"),
    (Meaning::Comment, "comment"),
    (Meaning::Text, "string"),
    (Meaning::Number, "number"),
    (Meaning::Operator, "operator"),
    (Meaning::Module, "namespace"),
    (Meaning::Type, "type"),
    (Meaning::Record, "struct"),
    (Meaning::Ifs, "class"),
    (Meaning::Function, "function"),
    (Meaning::Transform, "method"),
    (Meaning::Property, "property"),
    (Meaning::Parameter, "parameter"),
    (Meaning::Variable, "variable"),
    (Meaning::Choice, "enumMember"),
];

/// What is more to be said of a token: one bit each, in this order.
pub(crate) const MODIFIERS: [&str; 4] = ["declaration", "documentation", "defaultLibrary", "readonly"];
const DECLARATION: u32 = 1;
const DOCUMENTATION: u32 = 2;
const LIBRARY: u32 = 4;
const READONLY: u32 = 8;

/// A token with what it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Meant {
    pub(crate) span: Span,
    pub(crate) meaning: Meaning,
    /// Bits of [`MODIFIERS`].
    pub(crate) modifiers: u32,
}

/// Words that mean something in their place only.
const WORDS: &[&str] = &[
    "as",
    "by",
    "step",
    "level",
    "until",
    "each",
    "join",
    "boundary",
    "germ",
    "keep",
    "transform",
    "require",
    "assert",
    "and",
    "or",
    "not",
    "plane",
    "space",
    "panels",
    "planks",
    "limit",
    "control",
];

/// The tokens of a part of a file.
pub(crate) fn semantics(analysis: &Analysis, file: FileId, part: Option<Span>) -> Vec<Meant> {
    let Some(parsed) = analysis.files.iter().find(|parsed| parsed.file == file) else { return Vec::new() };
    let Some(source) = analysis.sources.get(file) else { return Vec::new() };
    let names = names(analysis, file);
    let inside = |span: Span| part.is_none_or(|part| span.start < part.end && part.start < span.end);
    let tokens = parsed.parse.tokens.iter().filter(|token| inside(token.span));
    let meant = tokens.filter_map(|token| {
        let (meaning, modifiers) = match token.kind {
            TokenKind::Comment => (Meaning::Comment, 0),
            TokenKind::ItemDocs | TokenKind::FileDocs => (Meaning::Comment, DOCUMENTATION),
            TokenKind::Number(_) | TokenKind::BadNumber => (Meaning::Number, 0),
            TokenKind::Text => (Meaning::Text, 0),
            TokenKind::Name => name(&names, token.span, source.slice(token.span))?,
            kind if kind.is_keyword() => (Meaning::Keyword, 0),
            kind if is_operator(kind) => (Meaning::Operator, 0),
            _ => return None,
        };
        Some(Meant { span: token.span, meaning, modifiers })
    });
    meant.flat_map(|meant| by_line(&source.text, meant)).collect()
}

/// A token line by line, without their ends: editors draw a token on one line. A comment between `/*` and `*/`
/// and a carriage return alone in a comment or a text go over several.
fn by_line(text: &str, meant: Meant) -> impl Iterator<Item = Meant> + '_ {
    let inside = &text[meant.span.range()];
    let lines = inside.split_inclusive(['\r', '\n']).scan(meant.span.start, move |start, line| {
        let kept = line.trim_end_matches(['\r', '\n']).len() as u32;
        let span = Span::new(meant.span.file, *start, *start + kept);
        *start += line.len() as u32;
        Some(Meant { span, ..meant })
    });
    lines.filter(|line| line.span.start < line.span.end)
}

fn is_operator(kind: TokenKind) -> bool {
    use TokenKind::*;
    matches!(
        kind,
        DotDot
            | Arrow
            | Equals
            | EqualEqual
            | NotEqual
            | Less
            | AtMost
            | Greater
            | AtLeast
            | Plus
            | Minus
            | Star
            | Slash
    )
}

/// The names of a file by where they start, with their ends.
type Names = BTreeMap<u32, (u32, Meaning, u32)>;

fn names(analysis: &Analysis, file: FileId) -> Names {
    let mut names = Names::new();
    let kinds: BTreeMap<Span, (Meaning, u32)> = analysis
        .index
        .declarations
        .iter()
        .map(|declared| {
            let (meaning, modifiers) = declaration(analysis, declared.kind, &declared.ty);
            let library = if analysis.hir.is_library(declared.span.file) { LIBRARY } else { 0 };
            (declared.span, (meaning, modifiers | library))
        })
        .collect();
    for used in analysis.index.references.iter().filter(|used| used.span.file == file) {
        let (meaning, modifiers) = match used.target {
            Target::Declared(span) => kinds.get(&span).copied().unwrap_or((Meaning::Variable, 0)),
            Target::Module(_) => (Meaning::Module, 0),
            Target::Native(_) => (Meaning::Function, LIBRARY),
            Target::NativeParameter(..) => (Meaning::Parameter, LIBRARY),
            Target::Setting(..) | Target::Measure(_) | Target::Size(_) | Target::Made(_) => {
                (Meaning::Property, LIBRARY)
            }
            Target::Choice(..) => (Meaning::Choice, 0),
        };
        names.insert(used.span.start, (used.span.end, meaning, modifiers));
    }
    for (span, (meaning, modifiers)) in kinds.iter().filter(|(span, _)| span.file == file) {
        names.insert(span.start, (span.end, *meaning, modifiers | DECLARATION));
    }
    names
}

fn declaration(analysis: &Analysis, kind: DeclarationKind, ty: &Type) -> (Meaning, u32) {
    match kind {
        DeclarationKind::Item(id) => match (&analysis.hir.item(id).kind, ty) {
            (ItemKind::Param(_), _) => (Meaning::Parameter, 0),
            (ItemKind::Let(_) | ItemKind::Figure(_), _) => (Meaning::Variable, READONLY),
            (ItemKind::Function(_), _) => (Meaning::Function, 0),
            (ItemKind::Record(_), _) => (Meaning::Record, 0),
            (ItemKind::Ifs(_), _) => (Meaning::Ifs, 0),
            // An item of the library is checked only where it is used.
            (ItemKind::Broken, _) => unchecked(analysis, id.0),
        },
        DeclarationKind::Field(owner, _) => match analysis.hir.item(owner).kind {
            ItemKind::Record(_) => (Meaning::Property, 0),
            _ => (Meaning::Parameter, 0),
        },
        DeclarationKind::ControlPoint | DeclarationKind::Local | DeclarationKind::Running => {
            (Meaning::Variable, READONLY)
        }
        DeclarationKind::Transform(_) => (Meaning::Transform, 0),
        DeclarationKind::Boundary(_) => (Meaning::Property, 0),
    }
}

fn unchecked(analysis: &Analysis, id: u32) -> (Meaning, u32) {
    let item = &analysis.hir.items[id as usize];
    let known = analysis.index.modules.iter().flat_map(|module| &module.own);
    let known = known.into_iter().find(|known| known.target == Target::Declared(item.name_span));
    match known {
        Some(known) if known.parameters.is_none() => (Meaning::Variable, READONLY),
        Some(known) if known.ty == Type::Ifs => (Meaning::Ifs, 0),
        Some(known) if known.name.starts_with(char::is_uppercase) => (Meaning::Record, 0),
        _ => (Meaning::Function, 0),
    }
}

fn name(names: &Names, span: Span, text: &str) -> Option<(Meaning, u32)> {
    // A measure is of several words.
    let around = names.range(..=span.start).next_back().filter(|(_, (end, ..))| span.end <= *end);
    if let Some((_, (_, meaning, modifiers))) = around {
        return Some((*meaning, *modifiers));
    }
    if WORDS.contains(&text) {
        return Some((Meaning::Keyword, 0));
    }
    type_names().any(|known| known == text).then_some((Meaning::Type, LIBRARY))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::features::fixture::fixture;

    fn shown(text: &str) -> Vec<String> {
        let design = fixture(text);
        let text = &design.analysis.sources.get(design.analysis.root).unwrap().text;
        let found = semantics(&design.analysis, design.analysis.root, None);
        let word = |meant: &Meant| MEANINGS.iter().find(|(meaning, _)| *meaning == meant.meaning).unwrap().1;
        found
            .iter()
            .filter(|meant| !matches!(meant.meaning, Meaning::Operator | Meaning::Number))
            .map(|meant| {
                let modifiers =
                    MODIFIERS.iter().enumerate().filter(|(bit, _)| meant.modifiers & (1 << bit) != 0);
                let modifiers: String = modifiers.map(|(_, word)| format!(".{}", &word[..3])).collect();
                format!("{}:{}{modifiers}", &text[meant.span.range()], word(meant))
            })
            .collect()
    }

    #[test]
    fn each_name_by_what_it_stands_for() {
        for (at, (meaning, _)) in MEANINGS.iter().enumerate() {
            assert_eq!(*meaning as usize, at);
        }
        let text = "/// D\nparam w: Length = 2m\nfn f(a: Int) -> Length = a * w\nlet x = sin(30deg)";
        assert_eq!(
            shown(text).join(" "),
            "/// D:comment.doc param:keyword w:parameter.dec Length:type.def fn:keyword f:function.dec \
             a:parameter.dec Int:type.def Length:type.def a:parameter w:parameter let:keyword \
             x:variable.dec.rea sin:function.def"
        );
        let text = "ifs c on (p, q) {\n    transform l = self on (p, lerp(p, q, 1/2))\n    germ segment(p, q)\n}\nfigure = ";
        assert_eq!(
            shown(text).join(" "),
            "ifs:keyword c:class.dec on:keyword p:variable.dec.rea q:variable.dec.rea transform:keyword \
             l:method.dec self:keyword on:keyword p:variable.rea lerp:function.def p:variable.rea q:variable.rea \
             germ:keyword segment:function.def p:variable.rea q:variable.rea figure:keyword"
        );
        let text = "use std.curves (bezier2)\nfigure f = bezier2 on ((0m, 0m), (1m, 1m), (2m, 0m)) at level 2\nfabricate f as planks {\n    ends: mitred\n    require mitre <= 45deg\n}";
        let found = shown(text).join(" ");
        for part in [
            "std:namespace curves:namespace bezier2:class.def",
            "ends:property.def mitred:enumMember",
            "require:keyword mitre:property.def",
        ] {
            assert!(found.contains(part), "no {part}: {found}");
        }
    }

    #[test]
    fn a_token_ends_with_its_line() {
        assert_eq!(
            shown("// a\r\n//\rb  c\r\r\nlet d = \"e\rf\"").join("|"),
            "// a:comment|//:comment|b  c:comment|let:keyword|d:variable.dec.rea|\"e:string|f\":string"
        );
        // A comment of other languages is an error, but one token.
        assert_eq!(
            shown("/* a\n  b */ let c = 1").join("|"),
            "/* a:comment|  b */:comment|let:keyword|c:variable.dec.rea"
        );
        // No text goes over a line feed: there are no raw ones, and a backslash does not carry it on.
        let design = fixture("let c = \"d\ne\" + 1\n r\"h\ni\" \"j\\\nk\" r#\"l\nm\"#");
        let text = &design.analysis.sources.get(design.analysis.root).unwrap().text;
        for token in &design.analysis.files[0].parse.tokens {
            let apart = matches!(token.kind, TokenKind::Whitespace | TokenKind::Comment);
            assert!(apart || !text[token.span.range()].contains('\n'), "{token:?}");
        }
    }

    #[test]
    fn a_part_is_of_the_whole() {
        let design = fixture("let a = 1\nlet b = a\nlet c = b");
        let root = design.analysis.root;
        let all = semantics(&design.analysis, root, None);
        let part = semantics(&design.analysis, root, Some(Span::new(root, 10, 19)));
        assert!(!part.is_empty() && part.iter().all(|meant| all.contains(meant)));
        assert_eq!(part.len(), 4);
    }
}
