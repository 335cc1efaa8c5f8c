//! Text in XML, for the formats that are made of it.

use std::fmt;

/// Text as it stands in an element or in an attribute between double quotes: what has a meaning in XML is escaped, and
/// what XML 1.0 cannot hold at all (control characters, the two noncharacters of the first plane) is U+FFFD.
#[derive(Debug, Clone, Copy)]
pub struct Escaped<'a>(pub &'a str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        use fmt::Write;
        for c in self.0.chars() {
            match c {
                '&' => out.write_str("&amp;")?,
                '<' => out.write_str("&lt;")?,
                '>' => out.write_str("&gt;")?,
                '"' => out.write_str("&quot;")?,
                '\'' => out.write_str("&apos;")?,
                // Written as they are, a reader would make them spaces in attributes.
                '\t' | '\n' | '\r' => write!(out, "&#{};", u32::from(c))?,
                '\0'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => out.write_char('\u{fffd}')?,
                c => out.write_char(c)?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn what_means_something_is_escaped() {
        assert_eq!(
            Escaped("a<b>&\"c'\n\0\u{ffff}ü").to_string(),
            "a&lt;b&gt;&amp;&quot;c&apos;&#10;\u{fffd}\u{fffd}ü"
        );
    }

    proptest! {
        #[test]
        fn nothing_of_a_text_is_markup(text in "\\PC*|[\\x00-\\x7f]*") {
            let escaped = Escaped(&text).to_string();
            prop_assert!(!escaped.contains(['<', '>', '"', '\'']));
            prop_assert!(escaped.chars().all(|c| c >= ' '));
            let mut back = escaped.clone();
            for (code, c) in [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&apos;", "'"), ("&#9;", "\t"),
                              ("&#10;", "\n"), ("&#13;", "\r"), ("&amp;", "&")] {
                back = back.replace(code, c);
            }
            let lost = |c: char| if c < ' ' && !"\t\n\r".contains(c) { '\u{fffd}' } else { c };
            prop_assert_eq!(back, text.chars().map(lost).collect::<String>());
        }
    }
}
