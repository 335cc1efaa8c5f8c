//! The text at places, and the words of messages that several features share.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::source::Span;

/// What stands there.
pub(crate) fn written(analysis: &Analysis, span: Span) -> &str {
    analysis.sources.get(span.file).map_or("", |source| source.slice(span))
}

/// A text without the spaces that stand under each other in columns: of several between two words one is left. The
/// beginnings of lines and what stands in quotes stay.
pub(super) fn one_spaced(text: &str) -> String {
    let mut spaced = String::with_capacity(text.len());
    let (mut quoted, mut escaped) = (false, false);
    for c in text.chars() {
        let doubled =
            c == ' ' && !quoted && spaced.ends_with(' ') && !spaced.trim_end_matches(' ').ends_with('\n');
        if !doubled {
            spaced.push(c);
        }
        quoted ^= c == '"' && !escaped;
        escaped = quoted && c == '\\' && !escaped;
    }
    spaced
}

#[cfg(test)]
mod tests {
    use super::one_spaced;

    #[test]
    fn columns_become_words() {
        assert_eq!(
            one_spaced("param span: Length = 6m   in 4m .. 9m   step 100mm"),
            "param span: Length = 6m in 4m .. 9m step 100mm"
        );
        assert_eq!(
            one_spaced("param a: Text =  \"b   \\\"   c\"  in"),
            "param a: Text = \"b   \\\"   c\" in"
        );
        assert_eq!(one_spaced("ifs a {\n    let b  = c\n}"), "ifs a {\n    let b = c\n}");
    }
}
