//! Names and texts of a drawing, whatever characters they are given: AC1015 holds plain ASCII, and some of that means
//! something.

/// Names of layers may be this long, in characters: all programs take that.
const LONGEST_NAME: usize = 120;

/// A name that every CAD program takes for a layer: other characters than letters and figures of ASCII, space, `-`, `_`,
/// `.` and `$` are `_`.
pub(super) fn layer_name(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() || " -_.$".contains(c) { c } else { '_' };
    let name: String = name.trim().chars().map(plain).take(LONGEST_NAME).collect();
    let name = name.trim_end();
    // The layer 0 is every drawing's own.
    if name.is_empty() || name == "0" { format!("_{name}") } else { name.to_owned() }
}

/// The text with everything but plain characters written as `\U+XXXX`: what is not ASCII, and `\`, `%` and `^`, which
/// begin codes. Control characters are spaces, since a text is one line.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            c if c.is_control() => out.push(' '),
            ' '..='~' if !"\\%^".contains(c) => out.push(c),
            c => {
                for unit in c.encode_utf16(&mut [0; 2]) {
                    out.push_str(&format!("\\U+{unit:04X}"));
                }
            }
        }
    }
    out
}
