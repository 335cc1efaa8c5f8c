//! Planarizing the wavy square of GEOMETRY 6, z = 0.1·sin(3πu + v)·cos(2.4πv), to a diagonal ratio of 0.005: ours in the
//! library, and on the same meshes in the same run libigl's `planarize_quad_mesh` (PyPI libigl) and ShapeOp (PyPI
//! compas_shapeop) in whole processes that print the time of their solving alone. For each the time, the largest diagonal
//! ratio it reached, quads that were inverted, and how far a vertex moved at most (the square has a side of 1,000 mm);
//! all of these are measured by one code. Inverted is a quad with a corner whose normal points away from that of the same
//! quad as designed.
//!
//! The references are looked for in the Python that `PLANARIZE_PYTHON` names (`python -m venv V; V/bin/pip install
//! numpy==2.4.6 libigl==2.6.3 compas compas_shapeop==0.1.2`), and are given `PLANARIZE_SECONDS` (60) for each mesh; without it
//! only our own figures are given. Nothing is asserted: machines differ. The aims are 0.05 s for 32 × 32, 1 s for
//! 100 × 100 and 10 s for 300 × 300.

#![allow(
    clippy::expect_used,
    clippy::disallowed_methods,
    reason = "a benchmark that cannot be run says why and ends; it reads clocks and programs"
)]

use std::ffi::OsStr;
use std::fs;
use std::ops::ControlFlow;
use std::process::{Command, Stdio};
use std::time::Duration;

use glam::DVec3;
use ifs_benches::processes::{median, millis, root};
use ifs_compiler::geometry::planarity::corner_normals;
use ifs_compiler::geometry::{QuadMeasure, QuadMesh};
use ifs_compiler::planarize::{Pin, Projection, project};

const RATIO: f64 = 0.005;

/// What is measured of a mesh, however it was made.
struct Reached {
    time: Duration,
    ratio: f64,
    inverted: usize,
    moved: f64,
}

fn main() {
    let python = std::env::var_os("PLANARIZE_PYTHON");
    let seconds = std::env::var("PLANARIZE_SECONDS").ok().and_then(|text| text.parse().ok()).unwrap_or(60.0);
    println!(
        "{:9} {:9} {:>10} {:>8} {:>10} {:>9} {:>10}",
        "quads", "method", "ms", "ratio", "diagonals", "inverted", "moved mm"
    );
    for (side, runs) in [(32, 15), (100, 5), (300, 1)] {
        let mesh = wavy_square(side);
        let start = measured(&mesh, &mesh.vertices, Duration::ZERO);
        row(side, "designed", &start, None);
        let ours = ours(&mesh, runs);
        row(side, "ours", &ours, None);
        for method in ["libigl", "shapeop"] {
            match python.as_ref().map(|python| reference(python, method, &mesh, seconds)) {
                Some(Ok(theirs)) => row(side, method, &theirs, Some(ours.time)),
                Some(Err(why)) => println!("{:9} {method:9} {why}", format!("{side} x {side}")),
                None => {}
            }
        }
    }
}

fn row(side: u32, method: &str, reached: &Reached, ours: Option<Duration>) {
    let Reached { time, ratio, inverted, moved } = reached;
    let times = ours.map_or(String::new(), |ours| format!("{:.0}", time.as_secs_f64() / ours.as_secs_f64()));
    println!(
        "{:9} {method:9} {:>10.1} {times:>8} {ratio:>10.5} {inverted:>9} {moved:>10.2}",
        format!("{side} x {side}"),
        millis(*time)
    );
}

fn wavy_square(side: u32) -> QuadMesh {
    use std::f64::consts::PI;
    let part = |place: u32| f64::from(place) / f64::from(side);
    let at = |i: u32, j: u32| i * (side + 1) + j;
    let grid = || (0..=side).flat_map(|i| (0..=side).map(move |j| (part(i), part(j))));
    let height = |(u, v): (f64, f64)| 0.1 * (3.0 * PI * u + v).sin() * (2.4 * PI * v).cos();
    let quads = (0..side).flat_map(|i| (0..side).map(move |j| (i, j)));
    QuadMesh {
        vertices: grid().map(|(u, v)| DVec3::new(u, v, height((u, v))) * 1000.0).collect(),
        quads: quads.map(|(i, j)| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]).collect(),
    }
}

fn ours(mesh: &QuadMesh, runs: usize) -> Reached {
    let options = Projection { threshold: 0.0, diagonal_ratio: Some(RATIO), iterations: 200, pin: Pin::None };
    let run = || project(mesh, &options, &mut |_| ControlFlow::Continue(()));
    let outcome = run();
    measured(mesh, &outcome.mesh.vertices, median(runs, || drop(run())))
}

fn measured(mesh: &QuadMesh, vertices: &[DVec3], time: Duration) -> Reached {
    let corners = |vertices: &[DVec3], quad: [u32; 4]| quad.map(|corner| vertices[corner as usize]);
    let mut reached = Reached { time, ratio: 0.0, inverted: 0, moved: 0.0 };
    for &quad in &mesh.quads {
        let (before, after) = (corners(&mesh.vertices, quad), corners(vertices, quad));
        let ratio = QuadMeasure::of(after).diagonal_ratio.unwrap_or(f64::INFINITY);
        reached.ratio = reached.ratio.max(ratio);
        let [a, b, c, d] = before;
        let normal = (c - a).cross(d - b);
        let upright = corner_normals(after).into_iter().all(|corner| corner.dot(normal) > 0.0);
        reached.inverted += usize::from(!upright);
    }
    let moved = mesh.vertices.iter().zip(vertices).map(|(before, after)| before.distance(*after));
    reached.moved = moved.fold(0.0, f64::max);
    reached
}

/// What another solver makes of the mesh in so many seconds.
fn reference(python: &OsStr, method: &str, mesh: &QuadMesh, seconds: f64) -> Result<Reached, String> {
    let folder = root().join("target/planarize-race");
    fs::create_dir_all(&folder).expect("a folder for the meshes");
    let (given, made) = (folder.join("given.txt"), folder.join("made.txt"));
    let mut text = format!("{}\n", mesh.vertices.len());
    mesh.vertices.iter().for_each(|at| text.push_str(&format!("{:?} {:?} {:?}\n", at.x, at.y, at.z)));
    mesh.quads.iter().for_each(|[a, b, c, d]| text.push_str(&format!("{a} {b} {c} {d}\n")));
    fs::write(&given, text).expect("the mesh can be written");
    let mut command = Command::new(python);
    command.arg(root().join("benches/benches/planarize.py")).arg(method).args([&given, &made]);
    let done = command.args([RATIO.to_string(), seconds.to_string()]).stdin(Stdio::null()).output();
    let done = done.expect("the Python of PLANARIZE_PYTHON can be started");
    let last = |bytes: &[u8]| String::from_utf8_lossy(bytes).lines().last().unwrap_or_default().to_owned();
    if !done.status.success() {
        return Err(format!("failed: {}", last(&done.stderr)));
    }
    let time: f64 = last(&done.stdout).parse().map_err(|_| "said no time".to_owned())?;
    let vertices = fs::read_to_string(&made).expect("it wrote its mesh");
    let vertices: Vec<DVec3> = vertices.lines().filter_map(point).collect();
    if vertices.len() != mesh.vertices.len() {
        return Err("lost vertices".to_owned());
    }
    Ok(measured(mesh, &vertices, Duration::from_secs_f64(time)))
}

fn point(line: &str) -> Option<DVec3> {
    let numbers: Vec<f64> = line.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    Some(DVec3::new(*numbers.first()?, *numbers.get(1)?, *numbers.get(2)?))
}
