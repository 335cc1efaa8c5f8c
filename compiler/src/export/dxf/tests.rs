use super::text::{escaped, layer_name};
use super::*;
use proptest::prelude::*;

fn written(drawing: &Drawing) -> String {
    let mut bytes = Vec::new();
    drawing.write(&mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

/// The tags of a file, code and value.
fn tags(text: &str) -> Vec<(u16, String)> {
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len() % 2, 0, "a code without a value");
    lines.chunks(2).map(|pair| (pair[0].trim().parse().unwrap(), pair[1].to_owned())).collect()
}

#[test]
fn an_outline_is_a_closed_polyline_on_its_layer() {
    let mut drawing = Drawing::default();
    let cut = drawing.layer("CUT", Colour::Red);
    drawing.outline(cut, &[DVec2::ZERO, DVec2::new(10.0, 0.0), DVec2::new(10.0, 2.5)]);
    drawing.stroke(cut, &[DVec2::ZERO]);
    let tags = tags(&written(&drawing));
    let start = tags.iter().position(|tag| tag.1 == "LWPOLYLINE").unwrap();
    let numbers: Vec<&str> =
        tags[start..].iter().filter(|tag| [10, 20].contains(&tag.0)).map(|tag| tag.1.as_str()).collect();
    assert_eq!(numbers, ["0.0", "0.0", "10.0", "0.0", "10.0", "2.5"]);
    assert!(tags[start..].contains(&(8, "CUT".to_owned())));
    assert!(tags[start..].contains(&(70, "1".to_owned())));
    assert_eq!(tags.iter().filter(|tag| tag.1 == "LWPOLYLINE").count(), 1, "one point is no stroke");
}

#[test]
fn handles_are_unique_and_below_the_seed() {
    let mut drawing = Drawing::default();
    for name in ["A", "B", "a", "0", ""] {
        let layer = drawing.layer(name, Colour::Black);
        drawing.line(layer, DVec2::ZERO, DVec2::ONE);
        drawing.circle(layer, DVec2::ZERO, 3.0);
        drawing.text(layer, DVec2::ZERO, 3.0, 0.5, "shell.0");
    }
    assert_eq!(drawing.layers.len(), 4, "A and a are one layer");
    let tags = tags(&written(&drawing));
    let seed = tags.iter().position(|tag| tag.1 == "$HANDSEED").unwrap() + 1;
    let number = |text: &str| u64::from_str_radix(text, 16).unwrap();
    let handles: Vec<u64> =
        tags[seed + 1..].iter().filter(|tag| [5, 105].contains(&tag.0)).map(|tag| number(&tag.1)).collect();
    let unique: std::collections::BTreeSet<u64> = handles.iter().copied().collect();
    assert_eq!(unique.len(), handles.len());
    assert!(handles.iter().all(|handle| *handle < number(&tags[seed].1)));
}

#[test]
fn what_is_not_finite_is_an_error() {
    let mut drawing = Drawing::default();
    let layer = drawing.layer("CUT", Colour::Red);
    drawing.line(layer, DVec2::ZERO, DVec2::new(f64::NAN, 0.0));
    assert!(drawing.write(&mut Vec::new()).is_err());
}

proptest! {
    #[test]
    fn no_text_adds_a_tag(text in "\\PC*|[\\x00-\\x7f]*", name in "\\PC*|[\\x00-\\x7f]*") {
        let mut drawing = Drawing::default();
        let layer = drawing.layer(&name, Colour::Grey);
        drawing.text(layer, DVec2::ZERO, 1.0, 0.0, &text);
        let file = written(&drawing);
        prop_assert!(file.is_ascii());
        let plain = {
            let mut drawing = Drawing::default();
            let layer = drawing.layer("CUT", Colour::Grey);
            drawing.text(layer, DVec2::ZERO, 1.0, 0.0, "x");
            tags(&written(&drawing))
        };
        let codes = |tags: &[(u16, String)]| tags.iter().map(|tag| tag.0).collect::<Vec<_>>();
        prop_assert_eq!(codes(&tags(&file)), codes(&plain));
    }

    #[test]
    fn texts_keep_what_they_say(text in "\\PC*") {
        // Undone as a reader does: `\U+XXXX` are units of UTF-16.
        let escaped = escaped(&text);
        let mut units: Vec<u16> = Vec::new();
        let mut rest = escaped.as_str();
        while !rest.is_empty() {
            let taken = match rest.strip_prefix("\\U+") {
                Some(code) => { units.push(u16::from_str_radix(&code[..4], 16).unwrap()); 7 }
                None => { units.push(u16::from(rest.as_bytes()[0])); 1 }
            };
            rest = &rest[taken..];
        }
        let spaces: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        prop_assert_eq!(String::from_utf16(&units).unwrap(), spaces);
    }

    #[test]
    fn names_of_layers_are_plain(name in "\\PC*") {
        let name = layer_name(&name);
        prop_assert!(!name.is_empty() && name != "0" && name.len() <= 121);
        prop_assert_eq!(layer_name(&name), name);
    }
}
