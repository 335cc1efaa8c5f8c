//! The diagonal ratio of every quad of the examples' surfaces, as designed and as planarized, against libigl.
#![allow(clippy::disallowed_methods, reason = "the test writes what the referee reads")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fs;

use ifs_compiler::analysis::{Elements, PanelFigure};
use ifs_compiler::geometry::{QuadMeasure, QuadMesh};
use ifs_tests::designs::{analysis_of, example_text};
use ifs_tests::referees::python_referee;
use ifs_tests::scratch;
use serde_json::{Value, json};

fn measured(name: &str, mesh: &QuadMesh) -> Value {
    let ratio = |quad: &[u32; 4]| {
        let corners = quad.map(|corner| mesh.vertices[corner as usize]);
        QuadMeasure::of(corners).diagonal_ratio.unwrap()
    };
    let ratios: Vec<f64> = mesh.quads.iter().map(ratio).collect();
    let vertices: Vec<[f64; 3]> = mesh.vertices.iter().map(|vertex| vertex.to_array()).collect();
    json!({"name": name, "vertices": vertices, "quads": mesh.quads, "ratios": ratios})
}

#[test]
fn libigl_measures_the_same_planarity_of_every_quad() {
    let mut meshes = Vec::new();
    for name in ["shell", "rough_shell", "folded_shell"] {
        let analysis = analysis_of(&example_text(name));
        let panels = analysis.fabrications.iter().filter_map(|made| match &made.elements {
            Elements::Panels(panels) => Some(&panels.figures),
            Elements::Planks(_) => None,
        });
        for PanelFigure { designed, built, .. } in panels.flatten() {
            meshes.push(measured(&format!("{name} as designed"), designed));
            meshes.push(measured(&format!("{name} as built"), built));
        }
    }
    assert!(meshes.len() >= 6, "the examples have no surfaces any more");
    let path = scratch("planarity").join("meshes.json");
    fs::write(&path, json!({"meshes": meshes}).to_string()).unwrap();
    let verdict = python_referee("planarity.py", &[&path]);
    println!("{}", verdict.counts);
    assert!(verdict.good, "{}", verdict.faults);
}
