//! The figures of `std.plane` and `std.space` from their text to doubles, against a run of the textbooks' maps in numpy.
#![allow(clippy::disallowed_methods, reason = "the tests write what the referee reads")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail anywhere")]

use std::convert::Infallible;
use std::fs;

use ifs_compiler::analysis::FigureGeometry;
use ifs_tests::designs::{analysis_of, geometries};
use ifs_tests::outcome::run;
use ifs_tests::referees::{Verdict, gltf_validator, python_referee};
use ifs_tests::{program, scratch};
use serde_json::{Value, json};

/// The vertices of each element of a figure.
fn elements(geometry: &FigureGeometry) -> Vec<Vec<[f64; 3]>> {
    match geometry {
        FigureGeometry::Curve(points) => {
            points.windows(2).map(|pair| pair.iter().map(|point| point.to_array()).collect()).collect()
        }
        FigureGeometry::Surface(mesh) => {
            let corner = |at: &u32| mesh.vertices[*at as usize].to_array();
            mesh.quads.iter().map(|quad| quad.iter().map(corner).collect()).collect()
        }
        FigureGeometry::Pieces(pieces) => {
            let mut found = Vec::new();
            let Ok(()) = pieces.stream(|tile| {
                for element in tile.elements() {
                    let mut vertices = Vec::new();
                    tile.copy_vertices(&element, &mut vertices);
                    found.push(vertices);
                }
                Ok::<(), Infallible>(())
            });
            found
        }
    }
}

/// A figure of the library at a level, for the referee; `call` is what it is called with.
fn figure(module: &str, (name, call, size): (&str, &str, f64), level: u32) -> Value {
    let text = format!("use std.{module} ({name})\nfigure it = {name}{call} at level {level}\n");
    let (_, geometry) = geometries(&analysis_of(&text)).remove(0);
    json!({"name": name, "level": level, "size": size, "elements": elements(&geometry)})
}

fn judge(test: &str, figures: &[Value]) -> Verdict {
    let path = scratch(test).join("figures.json");
    fs::write(&path, json!({"figures": figures}).to_string()).unwrap();
    let verdict = python_referee("textbook.py", &[&path]);
    println!("{test}: {}", verdict.counts);
    verdict
}

#[test]
fn figures_of_the_plane_are_those_of_the_textbooks() {
    let of = |name: (&'static str, &'static str, f64), levels: [u32; 2]| {
        levels.map(|level| figure("plane", name, level))
    };
    let figures = [
        of(("fern", "(height: 3m)", 3000.0), [1, 7]),
        of(("von_koch", "(length: 2m)", 2000.0), [2, 6]),
        of(("heighway", "(length: 2m)", 2000.0), [3, 11]),
        of(("sierpinski_triangle", "(width: 2m, height: 2m)", 2000.0), [0, 7]),
        of(("sierpinski_carpet", "(size: 900mm)", 900.0), [1, 4]),
    ]
    .concat();
    let verdict = judge("figures-plane", &figures);
    assert!(verdict.good, "{}", verdict.faults);
    let count = |of: &str| verdict.counts["elements"][of].as_u64().unwrap();
    assert_eq!((count("fern 7"), count("von_koch 6"), count("heighway 11")), (1 << 14, 1 << 12, 1 << 11));
    assert_eq!((count("sierpinski_triangle 7"), count("sierpinski_carpet 4")), (2187, 4096));
}

#[test]
fn figures_of_space_are_those_of_the_textbooks() {
    let of = |name: (&'static str, &'static str, f64), levels: [u32; 2]| {
        levels.map(|level| figure("space", name, level))
    };
    let figures = [
        of(("menger_sponge", "(size: 900mm)", 900.0), [1, 3]),
        of(("sierpinski_tetrahedron", "(size: 2m)", 2000.0), [2, 6]),
    ]
    .concat();
    let verdict = judge("figures-space", &figures);
    assert!(verdict.good, "{}", verdict.faults);
    let count = |of: &str| verdict.counts["elements"][of].as_u64().unwrap();
    assert_eq!((count("menger_sponge 3"), count("sierpinski_tetrahedron 6")), (8000, 4096));
}

/// The referee sees a leaf that is a micrometre off, and one that is there twice in place of another.
#[test]
fn a_leaf_out_of_its_place_is_refused() {
    let sponge = || figure("space", ("menger_sponge", "(size: 900mm)", 900.0), 2);
    let mut moved = sponge();
    moved["elements"][7][3][1] = json!(moved["elements"][7][3][1].as_f64().unwrap() + 1e-3);
    assert!(!judge("figures-moved", &[moved]).good);
    let mut twice = sponge();
    twice["elements"][7] = twice["elements"][8].clone();
    assert!(!judge("figures-twice", &[twice]).good);
}

#[test]
fn meshes_are_built_into_a_valid_model() {
    let folder = scratch("figures-model");
    let path = folder.join("sponge.ifs");
    fs::write(&path, "use std.space (menger_sponge)\nfigure sponge = menger_sponge at level 2\n").unwrap();
    run(program().arg("build").arg(&path).arg("-o").arg(folder.join("out"))).good();
    let verdict = gltf_validator(&[&folder.join("out/model.glb")]);
    assert!(verdict.good, "{}", verdict.faults);
    // Four hundred cubes of six faces, each of two triangles.
    assert_eq!(verdict.counts["totalTriangleCount"], 400 * 12);
}
