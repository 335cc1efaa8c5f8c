//! Meshes that a design imports: trimesh writes them, and reads what the design draws of them.
#![allow(clippy::disallowed_methods, reason = "the tests write what the referee reads")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fs;
use std::path::Path;

use ifs_tests::outcome::run;
use ifs_tests::referees::{gltf_validator, python_referee};
use ifs_tests::{program, root, scratch};

/// Two copies, the second one squeezed: the maps that the referee knows.
const DESIGN: &str = "ifs pair in space {
    transform first  = translate(1m, 2m, 3m) * turn(z, 30deg) * turn(x, -50deg) * scale(0.5) * self
    transform second = translate(-2m, 0m, 1m) * scale(0.7, 0.2, 0.4) * self
    germ import(\"mesh.glb\")
}
figure copies = pair at level 1
";

#[test]
fn what_is_drawn_is_what_trimesh_reads_moved_by_the_maps() {
    let folder = scratch("imported");
    let made = python_referee("imported.py", &[Path::new("make"), &folder]);
    assert!(made.good, "{}", made.faults);
    // The mesh of the suite is the one that is made here.
    let joint = fs::read(folder.join("joint.glb")).unwrap();
    assert!(joint == fs::read(root().join("tests/suite/meshes/joint.glb")).unwrap());
    fs::write(folder.join("pair.ifs"), DESIGN).unwrap();
    for (name, triangles, closed) in [("joint", 108, true), ("nested", 640, true), ("parted", 168, false)] {
        let mesh = folder.join(format!("{name}.glb"));
        fs::copy(&mesh, folder.join("mesh.glb")).unwrap();
        let out = folder.join(name);
        run(program().arg("build").arg(folder.join("pair.ifs")).arg("-o").arg(&out)).good();
        let model = out.join("model.glb");
        let verdict = gltf_validator(&[&model]);
        assert!(verdict.good, "{name}: {}", verdict.faults);
        let verdict = python_referee("imported.py", &[Path::new("compare"), &mesh, &model]);
        assert!(verdict.good, "{name}: {}", verdict.faults);
        assert_eq!(
            (&verdict.counts["triangles"], &verdict.counts["closed"]),
            (&(2 * triangles).into(), &closed.into()),
            "{name}"
        );
    }
}

/// The referee finds a mesh that is another one, or lies elsewhere.
#[test]
fn the_referee_finds_another_mesh() {
    let folder = scratch("imported_wrong");
    python_referee("imported.py", &[Path::new("make"), &folder]);
    fs::copy(folder.join("joint.glb"), folder.join("mesh.glb")).unwrap();
    for (name, design, file) in [
        ("another", DESIGN.to_owned(), "parted.glb"),
        ("moved", DESIGN.replace("3m)", "3.001m)"), "joint.glb"),
        ("mirrored", DESIGN.replace("scale(0.7,", "scale(-0.7,"), "joint.glb"),
    ] {
        fs::write(folder.join("pair.ifs"), design).unwrap();
        let out = folder.join(name);
        run(program().arg("build").arg(folder.join("pair.ifs")).arg("-o").arg(&out)).good();
        let verdict = python_referee(
            "imported.py",
            &[Path::new("compare"), &folder.join(file), &out.join("model.glb")],
        );
        assert!(!verdict.good, "{name} passes");
    }
}
