//! Changes that leave what a design means as it is: a part of an expression gets a name, a name is written out. Each is
//! offered only where the compiler, given the changed text, finds the same types and no other mistakes. What is pure and
//! always worked out exactly once may stand anywhere its names can be seen.

#[cfg(test)]
mod examples;
mod extract;
mod inline;

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::Edit;
use ifs_compiler::hir::type_names::type_name;
use ifs_compiler::source::Span;
use ifs_compiler::syntax::TokenKind;
use ifs_compiler::syntax::ast::Let;

pub(crate) use extract::extract;
pub(crate) use inline::inline;

/// A change of one file, and what must be true of the changed text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Refactoring {
    pub(crate) title: String,
    /// In order; they do not overlap.
    pub(crate) edits: Vec<Edit>,
    /// Expressions of the changed text by their places, with the types they must have.
    typed: Vec<(Span, String)>,
}

impl Refactoring {
    /// The text after the change.
    pub(crate) fn applied(&self, text: &str) -> String {
        let mut text = text.to_owned();
        for edit in self.edits.iter().rev() {
            text.replace_range(edit.span.range(), &edit.replacement);
        }
        text
    }

    /// The changes in a text whose lines end so. What is written out keeps the ends it has.
    pub(crate) fn with_line_ends(&self, end: &str) -> Vec<Edit> {
        let ended = |text: &str| text.replace("\r\n", "\n").replace('\n', end);
        let edits = self.edits.iter();
        edits.map(|edit| Edit { span: edit.span, replacement: ended(&edit.replacement) }).collect()
    }

    /// Whether the changed design, read anew, means the same: what was wrong is wrong, and nothing else, and the values
    /// that moved have the types they had.
    pub(crate) fn keeps(&self, before: &Analysis, after: &Analysis) -> bool {
        let said = |analysis: &Analysis| {
            let all = analysis.diagnostics.iter();
            let mut all: Vec<_> = all.map(|found| (found.code, found.message.clone())).collect();
            all.sort();
            all
        };
        said(before) == said(after)
            && self.typed.iter().all(|(span, ty)| typed(after, *span).is_some_and(|found| found == *ty))
    }
}

/// A `let` from its first word to the end of its value.
fn line_of(analysis: &Analysis, value: &Let) -> Option<Span> {
    let file = analysis.files.iter().find(|file| file.file == value.name.span.file)?;
    let before = file
        .parse
        .tokens
        .iter()
        .rev()
        .find(|token| token.span.end <= value.name.span.start && !token.kind.is_trivia())?;
    (before.kind == TokenKind::Let).then(|| before.span.to(value.value.span))
}

/// The type of the expression that stands exactly there, in words: numbers of items differ between two readings.
fn typed(analysis: &Analysis, span: Span) -> Option<String> {
    let found = analysis.index.types.iter().find(|(place, _)| *place == span)?;
    Some(type_name(&analysis.hir.items, &found.1))
}

#[cfg(test)]
mod tests {
    use ifs_compiler::analysis::analyse;
    use ifs_compiler::hir::evaluate::Overrides;
    use ifs_compiler::source::MemoryFiles;

    use super::*;
    use crate::features::fixture::fixture;

    /// The text after a change that is offered, read anew and found to keep what it means.
    fn changed(
        text: &str,
        found: impl Fn(&Analysis, Span) -> Option<Refactoring>,
    ) -> Option<(String, String)> {
        let (from, rest) = text.split_once('«').unwrap();
        let (inside, to) = rest.split_once('»').unwrap();
        let design = fixture(&format!("{from}{inside}{to}"));
        let root = design.analysis.root;
        let span = Span::new(root, from.len() as u32, (from.len() + inside.len()) as u32);
        let refactoring = found(&design.analysis, span)?;
        let old = &design.analysis.sources.get(root).unwrap().text;
        let new = refactoring.applied(old);
        let after = fixture(&new).analysis;
        if !refactoring.keeps(&design.analysis, &after) {
            return None;
        }
        // What is made is the same to the last digit.
        let made = |text: &str| {
            let made = analyse(&MemoryFiles::single("design.ifs", text), "design.ifs", &Overrides::default());
            assert!(!made.has_errors(), "{text}\n{:?}", made.diagnostics);
            let elements: Vec<String> =
                made.fabrications.iter().map(|made| format!("{:?}", made.elements)).collect();
            (made.plan.map(|plan| format!("{:?}", plan.counts)), elements)
        };
        let (old, made_new) = (made(old), made(&new));
        assert!(old == made_new, "{new}");
        Some((refactoring.title, new))
    }

    fn extracted(text: &str) -> Option<(String, String)> {
        changed(text, extract)
    }

    fn inlined(text: &str) -> Option<(String, String)> {
        changed(text, |analysis, span| inline(analysis, span.file, span.start))
    }

    const ARCH: &str = "use std.curves (bezier2)\nuse std.materials (sawn_spruce)\nparam w: Length = 2m\n/// An arch.\nfigure arch = bezier2 on ((0m, 0m), (w / 2, w), (w, 0m)) at level 2\nfabricate arch as planks {\n    material: sawn_spruce\n    section: 100mm by 40mm\n}\n";

    #[test]
    fn a_part_gets_a_name() {
        let (title, new) = extracted(&ARCH.replace("w / 2", "«w / 2»")).unwrap();
        assert_eq!(title, "name `w / 2` with a `let`");
        assert!(
            new.contains("let value = w / 2\n/// An arch.\nfigure arch = bezier2 on ((0m, 0m), (value, w)"),
            "{new}"
        );
        let (_, new) = extracted(&ARCH.replace("100mm", "«100mm»")).unwrap();
        assert!(
            new.contains("let value = 100mm\nfabricate arch") && new.contains("section: value by"),
            "{new}"
        );
        let curve = "ifs c(t: Number = 1/2) on (p, q) {\n    /// Left.\n    transform l = self on (p, «lerp(p, q, t)»)\n    transform r = self on (lerp(p, q, t), q)\n    germ segment(p, q)\n}\nfigure f = c on ((0m, 0m), (1m, 1m)) at level 2\n";
        let (_, new) = extracted(curve).unwrap();
        assert!(
            new.contains(
                "{\n    let value = lerp(p, q, t)\n    /// Left.\n    transform l = self on (p, value)"
            ),
            "{new}"
        );
        // A name that is free, and the name of the argument where it has one.
        let named = "let depth = 3mm\nfn f(depth: Length, n: Int) -> Length = depth * n\nlet b = f(depth: «2mm + 1mm», n: 2)\nlet value = 4\n";
        let (_, new) = extracted(named).unwrap();
        assert!(new.contains("let depth_2 = 2mm + 1mm\nlet b = f(depth: depth_2, n: 2)"), "{new}");
    }

    #[test]
    fn in_tests_and_functions() {
        let test = format!(
            "{ARCH}test \"t\" {{\n    let n = 2\n    // Four.\n    assert len(arch.boards) == «n * 2» and true\n}}\n"
        );
        let (_, new) = extracted(&test).unwrap();
        assert!(
            new.ends_with("let n = 2\n    // Four.\n    let value = n * 2\n    assert len(arch.boards) == value and true\n}\n"),
            "{new}"
        );
        let back = new.replace("let value", "let «»value");
        let (title, back) = inlined(&back).unwrap();
        assert_eq!(title, "write `n * 2` in the place of `value`");
        assert_eq!(back, test.replace('«', "(").replace('»', ")"));
        let (_, new) =
            extracted(&test.replace(['«', '»'], "").replace("len(arch.boards)", "«len(arch.boards)»"))
                .unwrap();
        assert!(new.contains("    let value = len(arch.boards)\n    assert value == n * 2"), "{new}");
        let (_, new) = inlined(&test.replace(['«', '»'], "").replace("let n", "let «»n")).unwrap();
        assert!(new.contains("{\n    // Four.\n    assert len(arch.boards) == 2 * 2"), "{new}");
        // In an ifs, where a control point has the name in both places.
        let curve = "ifs c on (p, q) {\n    let «»m = lerp(p, q, 1/2)\n    transform l = self on (p, m)\n    transform r = self on (m, q)\n    germ segment(p, q)\n}\nfigure f = c on ((0m, 0m), (1m, 1m)) at level 2\n";
        let (_, new) = inlined(curve).unwrap();
        assert!(new.starts_with("ifs c on (p, q) {\n    transform l = self on (p, lerp(p, q, 1/2))\n    transform r = self on (lerp(p, q, 1/2), q)\n"), "{new}");
        // Of a function what its parameters have no part in.
        let function =
            "param w: Length = 2m\nfn rise(n: Int) -> Length = n * («w / 2 + 10mm»)\nlet a = rise(3)\n";
        let (_, new) = extracted(function).unwrap();
        assert!(new.contains("let value = w / 2 + 10mm\nfn rise(n: Int) -> Length = n * (value)\n"), "{new}");
        for text in [
            "fn rise(n: Int) -> Length = «n * 2» * 1m\nlet a = rise(3)\n",
            // It is worked out where it is called, which may be never.
            "let none: [Int] = []\nfn rise(n: Int) -> Int = n * «max(none)»\n",
            "let zero = 0\nfn rise(n: Int) -> Number = n * («1 / zero»)\n",
        ] {
            assert_eq!(extracted(text), None, "{text}");
        }
    }

    #[test]
    fn what_a_list_runs_through() {
        let (_, new) = extracted("let a = [i * 2 for i in «[3, 1 + 1]» if i > 1]\n").unwrap();
        assert_eq!(new, "let value = [3, 1 + 1]\nlet a = [i * 2 for i in value if i > 1]\n");
        let test =
            format!("{ARCH}test \"t\" {{\n    assert max([b.length for b in «arch.boards»]) > 1mm\n}}\n");
        let (_, new) = extracted(&test).unwrap();
        assert!(
            new.contains("    let value = arch.boards\n    assert max([b.length for b in value]) > 1mm\n"),
            "{new}"
        );
    }

    #[test]
    fn what_would_mean_something_else_stays() {
        for text in [
            "let a = [j for i in 0..3 for j in «[1, 2]»]\n",
            "let a = [«i * 2» for i in 0..3]\n",
            "let a = [«1 / 2» for i in 0..3]\n",
            "let a = if 1 < 2 then 3 else «1 / 4»\n",
            "fn f(a: Int) = «a + 1»\n",
            "let a = 1 + 2 «* 3»\n",
            "let a = 1 + «2 + 3»\n",
            "let a = true or «1 < 2»\n",
            "let «a» = 3\n",
            "param a: Length = «3m» in 1m .. 4m\n",
            "fn f(v: Vector) -> Vector = v\nlet a = f(«(1m, 2m)»)\n",
        ] {
            let (from, rest) = text.split_once('«').unwrap();
            let (inside, to) = rest.split_once('»').unwrap();
            let design = fixture(&format!("{from}{inside}{to}"));
            let root = design.analysis.root;
            let span = Span::new(root, from.len() as u32, (from.len() + inside.len()) as u32);
            let kept = extract(&design.analysis, span).filter(|found| {
                let new = found.applied(&design.analysis.sources.get(root).unwrap().text);
                found.keeps(&design.analysis, &fixture(&new).analysis)
            });
            assert_eq!(kept, None, "{text}");
        }
    }

    #[test]
    fn a_name_is_written_out() {
        let text = "param w: Length = 2m\n/// Half of it.\nlet «half» = w + 1m\nlet a = half * 2\nlet b = [half, w][0]\n";
        let (title, new) = inlined(text).unwrap();
        assert_eq!(title, "write `w + 1m` in the 2 places of `half`");
        assert_eq!(
            new,
            "param w: Length = 2m\nlet a = (w + 1m) * 2\nlet b = [w + 1m, w][0]\n"
                .replace("[w + 1m, w]", "[(w + 1m), w]")
        );
        let (_, new) = inlined("let a = [1, 2]\nlet b = «a»[0] + 1\n").unwrap();
        assert_eq!(new, "let b = [1, 2][0] + 1\n");
        for text in [
            // Used nowhere; by another file, as may be; where its own names mean something else; of another type there.
            "let «a» = 3\n",
            "pub let «a» = 3\nlet b = a\n",
            "let i = 3\nlet «a» = i + 1\nlet b = [a for i in 0..2]\n",
            "let «a»: Number = 3\nlet b = a\n",
            "param «a»: Int = 3\nlet b = a\n",
        ] {
            assert_eq!(inlined(text), None, "{text}");
        }
    }
}
