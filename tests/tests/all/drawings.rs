//! ezdxf as referee of the drawings of boards.
#![allow(clippy::disallowed_methods, reason = "the tests write what the referee reads")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fs;
use std::path::Path;

use glam::DVec2;
use ifs_compiler::analysis::{Analysis, Elements};
use ifs_compiler::export::dxf::{Colour, Drawing, Vertex};
use ifs_compiler::outputs::{Format, Selection, outputs};
use ifs_tests::designs::{analysis_of, example_text, examples};
use ifs_tests::referees::{Verdict, python_referee};
use ifs_tests::scratch;
use serde_json::{Value, json};

/// How many boards of a design are drawn: reading a drawing takes the referee 30 ms.
const DRAWN: usize = 4;

pub(crate) fn closed(corners: &[DVec2]) -> Value {
    let points: Vec<[f64; 3]> = corners.iter().map(|at| [at.x, at.y, 0.0]).collect();
    json!([{ "points": points, "closed": true }])
}

/// Of the first boards of each block: the address, what the drawing says of it, the design and the cut outline.
fn outlines(analysis: &Analysis) -> Vec<(String, String, Vec<DVec2>, Vec<DVec2>)> {
    let mut found = Vec::new();
    for made in &analysis.fabrications {
        let outlines: Vec<_> = match &made.elements {
            Elements::Panels(made) => made
                .panels
                .iter()
                .map(|made| (&made.label, made.design_outline.to_vec(), &made.outline))
                .collect(),
            Elements::Planks(made) => {
                made.planks.iter().map(|made| (&made.label, made.outline.clone(), &made.outline)).collect()
            }
        };
        found.extend(outlines.into_iter().take(DRAWN).map(|(label, design, outline)| {
            let about = format!("{} ({})", label.address, label.alias);
            (label.address.clone(), about, design, outline.clone())
        }));
    }
    found
}

/// Strokes of a drawing's layer as its text has them; that they are those of the program is a test of `toolpath`.
pub(crate) fn polylines_on(text: &str, layer: &str) -> Value {
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    let tags: Vec<(&str, &str)> = lines.chunks(2).map(|pair| (pair[0], pair[1])).collect();
    let starts = tags.iter().enumerate().filter(|(_, tag)| **tag == ("0", "LWPOLYLINE")).map(|(at, _)| at);
    let found = starts.filter_map(|start| {
        let body: Vec<(&str, &str)> =
            tags[start + 1..].iter().take_while(|tag| tag.0 != "0").copied().collect();
        let values = |code: &'static str| body.iter().filter(move |tag| tag.0 == code).map(|tag| tag.1);
        let number = |text: &str| text.parse::<f64>().unwrap();
        let on_it = values("8").next() == Some(layer);
        let points: Vec<[f64; 3]> =
            values("10").zip(values("20")).map(|(x, y)| [number(x), number(y), 0.0]).collect();
        on_it.then(|| json!({ "points": points, "closed": false }))
    });
    Value::Array(found.collect())
}

pub(crate) fn judged(folder: &Path, expected: &[Value]) -> Verdict {
    let listing = folder.join("expected.json");
    fs::write(&listing, Value::from(expected).to_string()).unwrap();
    python_referee("dxf.py", &[folder, &listing])
}

#[test]
fn ezdxf_reads_the_outlines_of_the_examples() {
    let folder = scratch("drawings");
    let mut expected = Vec::new();
    for name in examples() {
        let analysis = analysis_of(&example_text(&name));
        let made = outputs(&analysis, &Selection::of(&[Format::Dxf]));
        assert!(made.diagnostics.is_empty(), "{name}: {:?}", made.diagnostics);
        for (address, about, design, outline) in outlines(&analysis) {
            let output = made.files.iter().find(|file| file.address.as_ref() == Some(&address)).unwrap();
            assert_eq!(output.kind, "drawing");
            let mut bytes = Vec::new();
            output.write(&mut bytes).unwrap();
            let file = format!("{name}.{address}.dxf");
            fs::write(folder.join(&file), &bytes).unwrap();
            let text = String::from_utf8(bytes).unwrap();
            let named = |operation: &str| {
                let begins = |line: &&str| *line == operation || line.starts_with(&format!("{operation} T"));
                text.lines().find(begins).unwrap().to_owned()
            };
            let (cut, engraved) = (named("CUT"), named("ENGRAVE"));
            let strokes = polylines_on(&text, &engraved);
            let letters = about.chars().filter(|c| *c == '(').count();
            assert!(strokes.as_array().unwrap().len() > letters, "{file}: nothing is engraved");
            expected.push(json!({
                "file": file, "texts": [about],
                "polylines": { "DESIGN": closed(&design), cut: closed(&outline), engraved: strokes },
            }));
        }
    }
    assert!(expected.len() > 20, "{} drawings", expected.len());
    let verdict = judged(&folder, &expected);
    assert!(verdict.good, "{}", verdict.faults);
    assert_eq!(verdict.counts["drawings"], expected.len());
}

#[test]
fn layers_say_operation_tool_and_depth() {
    let analysis = analysis_of(&example_text("shell"));
    let made = outputs(&analysis, &Selection::of(&[Format::Dxf]));
    let mut bytes = Vec::new();
    made.files[0].write(&mut bytes).unwrap();
    let text = String::from_utf8(bytes).unwrap();
    let has = |name: &str| text.lines().any(|line| line == name);
    assert!(has("DESIGN") && has("NOTES"), "{text}");
    assert!(text.contains("\nCUT T1 straight cutter "), "{text}");
    assert!(has("ENGRAVE T2 engraver 0.4mm"), "{text}");
}

/// Everything a drawing can hold, with the texts that are hardest to hold.
#[test]
fn ezdxf_reads_arcs_and_any_text() {
    let folder = scratch("drawings-nasty");
    let texts = ["a\\P b", "100 %%c 5", "^J^M", "Fuß \u{1f332} 木", "\\U+0041", "  two  ", "{\\fArial;x}"];
    let mut drawing = Drawing::default();
    let cut = drawing.layer("CUT T1 <8mm> \"a\"|*?", Colour::Red);
    let rounded = [(0.0, 0.0, 0.0), (30.0, 0.0, 0.5), (40.0, 10.0, -1.0), (0.0, 10.0, 1e-7)];
    let vertex = |&(x, y, bulge): &(f64, f64, f64)| Vertex { at: DVec2::new(x, y), bulge };
    drawing.polyline(cut, rounded.iter().map(vertex).collect(), true);
    drawing.circle(cut, DVec2::new(5.0, 5.0), 2.0);
    drawing.line(cut, DVec2::ZERO, DVec2::new(1e5, -1e-7));
    let notes = drawing.layer("Notizen ü", Colour::Magenta);
    for text in texts {
        drawing.text(notes, DVec2::ONE, 2.5, 1.0, text);
    }
    let mut bytes = Vec::new();
    drawing.write(&mut bytes).unwrap();
    fs::write(folder.join("nasty.dxf"), bytes).unwrap();
    let points: Vec<[f64; 3]> = rounded.iter().map(|&(x, y, bulge)| [x, y, bulge]).collect();
    let expected = json!({
        "file": "nasty.dxf", "texts": texts,
        "polylines": { "CUT T1 _8mm_ _a____": [{ "points": points, "closed": true }] },
    });
    let verdict = judged(&folder, std::slice::from_ref(&expected));
    assert!(verdict.good, "{}", verdict.faults);

    // And what is not there is missed.
    let mut other = expected;
    other["polylines"]["CUT T1 _8mm_ _a____"][0]["points"][1][0] = json!(30.00001);
    assert!(!judged(&folder, &[other]).good);
}
