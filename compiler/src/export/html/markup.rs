//! Writing HTML and SVG that is well-formed XML too: tags close, every text and attribute is escaped. What the elements
//! mean is the caller's business.

/// A document being written.
#[derive(Debug, Default)]
pub(super) struct Markup {
    text: String,
}

/// Elements after which a line may end: between them spaces show nothing.
const ON_A_LINE: [&str; 20] = [
    "html",
    "head",
    "body",
    "title",
    "style",
    "meta",
    "header",
    "footer",
    "section",
    "div",
    "figure",
    "figcaption",
    "table",
    "tr",
    "thead",
    "tbody",
    "svg",
    "p",
    "dl",
    "g",
];

impl Markup {
    /// A document of HTML that starts with its declaration.
    pub(super) fn html() -> Self {
        Self { text: "<!DOCTYPE html>\n".to_owned() }
    }

    /// What was written.
    pub(super) fn finish(self) -> String {
        self.text
    }

    /// An element with what `inside` writes.
    pub(super) fn element(
        &mut self,
        tag: &'static str,
        attributes: &[(&'static str, &str)],
        inside: impl FnOnce(&mut Markup),
    ) {
        self.start(tag, attributes);
        self.text.push('>');
        inside(self);
        self.text.push_str("</");
        self.text.push_str(tag);
        self.text.push('>');
        self.end_line(tag);
    }

    /// An element of a text alone.
    pub(super) fn texts(&mut self, tag: &'static str, attributes: &[(&'static str, &str)], text: &str) {
        self.element(tag, attributes, |page| page.text(text));
    }

    /// An element that never holds anything: `meta`, or a shape.
    pub(super) fn empty(&mut self, tag: &'static str, attributes: &[(&'static str, &str)]) {
        self.start(tag, attributes);
        self.text.push_str("/>");
        self.end_line(tag);
    }

    /// Text, escaped.
    pub(super) fn text(&mut self, text: &str) {
        escape(text, &mut self.text);
    }

    /// The style sheet, which is ours and has nothing to escape.
    pub(super) fn style(&mut self, sheet: &'static str) {
        self.element("style", &[], |page| page.text.push_str(sheet));
    }

    fn start(&mut self, tag: &'static str, attributes: &[(&'static str, &str)]) {
        self.text.push('<');
        self.text.push_str(tag);
        for (name, value) in attributes {
            self.text.push(' ');
            self.text.push_str(name);
            self.text.push_str("=\"");
            escape(value, &mut self.text);
            self.text.push('"');
        }
    }

    fn end_line(&mut self, tag: &str) {
        if ON_A_LINE.contains(&tag) {
            self.text.push('\n');
        }
    }
}

/// Characters that mean something become entities. Those no XML may hold, and those that turn the direction of all that
/// follows, become the replacement character: a name from a design changes nothing but its own place.
fn escape(text: &str, out: &mut String) {
    for character in text.chars() {
        match character {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\t' | '\n' | '\r' => out.push(' '),
            '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{200e}' | '\u{200f}' | '\u{61c}' => {
                out.push('\u{fffd}');
            }
            '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            other if other.is_control() => out.push('\u{fffd}'),
            other => out.push(other),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn elements_close_and_texts_are_escaped() {
        let mut page = Markup::default();
        page.element("p", &[("title", "a\"b'<")], |page| {
            page.text("1 < 2 & 3 \u{202e}txt\u{0}");
            page.empty("rect", &[("x", "1")]);
        });
        assert_eq!(
            page.finish(),
            "<p title=\"a&quot;b&#39;&lt;\">1 &lt; 2 &amp; 3 \u{fffd}txt\u{fffd}<rect x=\"1\"/></p>\n"
        );
    }

    proptest! {
        #[test]
        fn no_text_leaves_its_place(text in "(<script>|</style>|]]>|\"|'|&|<!--|\u{202e}|\u{5d0}\u{5d1}|\\PC|\\pC){0,20}") {
            let mut page = Markup::default();
            page.texts("p", &[("title", &text)], &text);
            let written = page.finish();
            let inner = written.strip_prefix("<p title=\"").and_then(|rest| rest.strip_suffix("</p>\n")).unwrap();
            let (attribute, inside) = inner.split_once("\">").unwrap();
            prop_assert_eq!(attribute, inside);
            prop_assert!(!inside.contains(['<', '>', '"', '\'']));
            let plain = |part: &str| part.starts_with("amp;") || part.starts_with("lt;") || part.starts_with("gt;")
                || part.starts_with("quot;") || part.starts_with("#39;");
            prop_assert!(inside.split('&').skip(1).all(plain));
            let bad = |c: char| c.is_control() || ('\u{202a}'..='\u{202e}').contains(&c);
            prop_assert!(!inside.chars().any(bad));
        }
    }
}
