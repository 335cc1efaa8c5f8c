//! Bicubic sheets against OpenSubdiv: after each step the control net, and its limit, are the same points as those of
//! Catmull-Clark refinement wherever that is regular.
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fmt::Write as _;
use std::io::Write as _;
use std::process::{Command, Stdio};

use ifs_compiler::analysis::FigureGeometry;
use ifs_compiler::plan::{Shape, SheetPlan};
use ifs_tests::designs::{analysis_of, geometries};
use ifs_tests::referees::opensubdiv;

const DESIGN: &str = "
use std.curves (bspline3)
use std.surfaces (sheet)

let net = [[ (i * 0.7m, j * 1.1m + i * 0.1m, 0.8m * sin(35deg * i) * cos(25deg * j)) for j in 0..8 ] for i in 0..6]

figure steps = sheet(bspline3(net: true), bspline3(net: true), net) at level LEVEL
figure limit = sheet(bspline3, bspline3, net) at level LEVEL
";

type Point = [f64; 3];

/// The refined net and its limit points.
fn refined(sheet: &SheetPlan, level: u32) -> [Vec<Point>; 2] {
    let mut input = format!("{} {} {level}\n", sheet.net_rows, sheet.net_columns);
    for point in &sheet.net {
        writeln!(input, "{:e} {:e} {:e}", point[0], point[1], point[2]).unwrap();
    }
    let mut command = Command::new(opensubdiv());
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).unwrap();
    let numbers =
        |line: &str| -> Vec<f64> { line.split(' ').map(|number| number.parse().unwrap()).collect() };
    let rows: Vec<Vec<f64>> = text.lines().map(numbers).collect();
    let part = |from: usize| rows.iter().map(|row| [row[from], row[from + 1], row[from + 2]]).collect();
    [part(0), part(3)]
}

#[test]
fn bicubic_sheets_are_catmull_clark_surfaces() {
    for level in 1..=4 {
        let design = analysis_of(&DESIGN.replace("LEVEL", &level.to_string()));
        let plan = &design.plan.as_ref().unwrap().plan;
        let Shape::Sheet(sheet) = &plan.figures()[0].shape else { unreachable!() };
        let size = sheet.net.iter().flatten().fold(1.0_f64, |size, x| size.max(x.abs()));
        for ((name, ours), theirs) in geometries(&design).into_iter().zip(refined(sheet, level)) {
            let FigureGeometry::Surface(mesh) = ours else { unreachable!() };
            let expected = ((3 << level) + 1) * ((5 << level) + 1);
            assert_eq!(mesh.vertices.len(), expected, "{name}");
            let mut taken = vec![false; theirs.len()];
            for vertex in &mesh.vertices {
                let apart = |point: &Point| {
                    let vertex = vertex.to_array();
                    (0..3).map(|i| (point[i] - vertex[i]).abs()).fold(0.0, f64::max)
                };
                let same = theirs.iter().position(|point| apart(point) <= 1e-12 * size);
                let place =
                    same.unwrap_or_else(|| unreachable!("{name} at level {level}: {vertex} is nowhere"));
                assert!(!std::mem::replace(&mut taken[place], true), "{name}: {vertex} twice");
            }
        }
    }
}
