//! A real `ifs build`, killed at many moments while it rebuilds a folder with another design: the folder is the old set
//! or the new one, whole, every time, and the next build leaves nothing behind.
#![allow(clippy::disallowed_methods, reason = "the test starts programs and reads what they write")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use ifs_tests::designs::{contents, example_text};
use ifs_tests::outcome::run;
use ifs_tests::{program, scratch};

/// How many builds are killed.
const KILLS: u32 = 44;

/// A design, and the set that a whole build of it writes.
struct Design {
    path: PathBuf,
    set: BTreeMap<String, Vec<u8>>,
}

fn design(root: &Path, name: &str, text: &str) -> Design {
    let path = root.join(name).join("shell.ifs");
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(&path, text).unwrap();
    let out = root.join(name).join("out");
    run(program().arg("build").arg(&path).arg("-o").arg(&out)).good();
    // A file of the user's own lies among the outputs throughout.
    fs::write(out.join("notes.txt"), "mine").unwrap();
    Design { path, set: contents(&out) }
}

fn start(design: &Design, target: &Path) -> Child {
    let mut command = program();
    command.arg("build").arg(&design.path).arg("-o").arg(target);
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

/// Waits until a kill: every second one at any time within two builds' time, the others around the one step in which
/// the new set takes the old one's place. Both are spread evenly, in an order that looks random.
fn wait_for_the_moment(staging: &Path, kill: u32, whole: Duration) {
    let part = f64::from(kill * 37 % KILLS) / f64::from(KILLS);
    if kill.is_multiple_of(2) {
        return std::thread::sleep(whole.mul_f64(2.0 * part));
    }
    let begun = Instant::now();
    while !staging.join("manifest.json").exists() && begun.elapsed() < whole * 5 {
        std::hint::spin_loop();
    }
    std::thread::sleep(Duration::from_millis(4).mul_f64(part));
}

/// The names in the folder of the target that are not the target.
fn beside(target: &Path) -> Vec<String> {
    let entries = fs::read_dir(target.parent().unwrap()).unwrap();
    entries
        .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
        .filter(|name| name != "out")
        .collect()
}

#[test]
fn a_killed_build_leaves_the_old_set_or_the_new_one() {
    let root = scratch("killing");
    let text = example_text("shell");
    let other = text.replace("0.8m * sin", "0.78m * sin");
    assert_ne!(text, other);
    let designs = [design(&root, "a", &text), design(&root, "b", &other)];
    assert_ne!(designs[0].set["model.glb"], designs[1].set["model.glb"]);

    let target = root.join("target/out");
    fs::create_dir_all(&target).unwrap();
    fs::write(target.join("notes.txt"), "mine").unwrap();
    run(program().arg("build").arg(&designs[0].path).arg("-o").arg(&target));
    let begun = Instant::now();
    assert!(start(&designs[0], &target).wait().unwrap().success());
    let whole = begun.elapsed();

    let staging = root.join("target/.out.ifs-staging");
    let (mut there, mut kept, mut replaced, mut in_the_middle) = (0, 0, 0, 0);
    for kill in 0..KILLS {
        let coming = 1 - there;
        let mut child = start(&designs[coming], &target);
        wait_for_the_moment(&staging, kill, whole);
        // One that has ended already cannot be killed; then all of it must be there.
        let _ = child.kill();
        let complete = child.wait().unwrap().success();
        in_the_middle += u32::from(staging.exists());
        let found = contents(&target);
        if found == designs[coming].set {
            there = coming;
            replaced += 1;
        } else {
            let names: Vec<&String> = found.keys().collect();
            assert!(found == designs[there].set, "kill {kill} left neither set: {names:?}");
            assert!(!complete, "a build that ended well left the old set");
            kept += 1;
        }
    }
    println!(
        "{KILLS} kills: {kept} left the old set, {replaced} the new one, {in_the_middle} met a set in the making"
    );
    assert!(kept >= 5 && replaced >= 3 && in_the_middle >= 5, "the kills met no build where it matters");

    assert!(start(&designs[1], &target).wait().unwrap().success());
    assert_eq!(contents(&target), designs[1].set);
    assert_eq!(beside(&target), Vec::<String>::new(), "left behind");
}
