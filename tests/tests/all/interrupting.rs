//! A real `ifs build` that is asked to stop, by Ctrl-C or a plain `kill`, at many moments: it ends soon with 130, and the
//! output folder is byte for byte as it was, or is not there if it was not. And its line of progress: on a terminal
//! alone, and gone at the end.
#![allow(clippy::disallowed_methods, reason = "the test starts programs and reads what they write")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use ifs_tests::designs::{contents, example_text};
use ifs_tests::outcome::run;
use ifs_tests::referees::python_referee;
use ifs_tests::{is_release, program, program_path, scratch};
use rustix::process::{Pid, Signal, kill_process};

/// How soon a build that is asked to stop must have ended. It does in a few hundredths of a second; a machine with much
/// to do may take its time.
const SOON: Duration = Duration::from_millis(1500);

/// A shell of 1,024 boards: its planarizing takes long, for it is to be flatter than it gets.
fn planarized() -> String {
    let text = example_text("shell").replace("at level 2", "at level 3").replace("== 256", "== 1024");
    let text = text.replace("worst: 1,", "threshold: 0.9999999, worst: 1,");
    // One requirement stays, which holds: without any it would be warned that the aim is missed.
    let stays = |line: &&str| !line.contains("require ") || line.contains(">= 0.9");
    text.lines().filter(stays).map(|line| format!("{line}\n")).collect()
}

/// The same left as designed: what takes long are the programs and the files.
fn as_designed() -> String {
    let text = planarized();
    text.lines().filter(|line| !line.contains("planarize")).map(|line| format!("{line}\n")).collect()
}

fn start(design: &Path, out: &Path) -> Child {
    let mut command = program();
    command.arg("build").arg(design).arg("-o").arg(out);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

/// When a build is asked to stop.
#[derive(Debug, Clone, Copy)]
enum Moment {
    /// So long after its start.
    Started(u64),
    /// So long after the first file of its set is there.
    Writing(u64),
    /// So long after the list of its files is there: the last thing before they take the place of the old ones.
    Listed(u64),
}

fn wait_for(moment: Moment, beside: &Path) {
    let (there, after) = match moment {
        Moment::Started(after) => (None, after),
        Moment::Writing(after) => (Some(beside.join(".out.ifs-staging")), after),
        Moment::Listed(after) => (Some(beside.join(".out.ifs-staging/manifest.json")), after),
    };
    let begun = Instant::now();
    while there.as_ref().is_some_and(|path| !path.exists()) && begun.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_micros(200));
    }
    std::thread::sleep(Duration::from_millis(after));
}

struct Stopped {
    code: Option<i32>,
    stderr: String,
    took: Duration,
}

fn stopped(design: &Path, out: &Path, moment: Moment, signal: Signal) -> Stopped {
    let child = start(design, out);
    wait_for(moment, out.parent().unwrap());
    let asked = Instant::now();
    // One that has ended already cannot be asked; then all of it must be there.
    let _ = kill_process(Pid::from_child(&child), signal);
    let done = child.wait_with_output().unwrap();
    let stderr = String::from_utf8(done.stderr).unwrap();
    Stopped { code: done.status.code(), stderr, took: asked.elapsed() }
}

/// All that lies in the folder beside the output folder, and in it; nothing where there is none.
fn all_in(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    if folder.exists() { contents(folder) } else { BTreeMap::new() }
}

fn written(root: &Path, name: &str, text: &str) -> PathBuf {
    let path = root.join(name);
    fs::write(&path, text).unwrap();
    path
}

#[test]
fn a_build_that_is_asked_to_stop_leaves_the_folder_as_it_was() {
    let root = scratch("interrupting");
    let smooth = written(&root, "smooth.ifs", &planarized());
    let rough = written(&root, "rough.ifs", &as_designed());
    let small = written(&root, "small.ifs", &example_text("lattice"));
    let moments = [
        (&smooth, Moment::Started(40)),
        (&smooth, Moment::Started(250)),
        (&smooth, Moment::Started(700)),
        (&rough, Moment::Started(500)),
        (&rough, Moment::Writing(0)),
        (&rough, Moment::Writing(8)),
        (&rough, Moment::Writing(40)),
        (&rough, Moment::Writing(90)),
        (&rough, Moment::Listed(0)),
        (&rough, Moment::Listed(2)),
    ];
    let (mut in_the_making, mut too_late, mut slowest) = (0, 0, Duration::ZERO);
    for (place, (design, moment)) in moments.into_iter().enumerate() {
        let beside = root.join(format!("{place}"));
        let out = beside.join("out");
        fs::create_dir_all(&beside).unwrap();
        // Every second one builds into a folder that is not there yet.
        if place % 2 == 0 {
            run(program().arg("build").arg(&small).arg("-o").arg(&out)).good();
            fs::write(out.join("notes.txt"), "mine").unwrap();
        }
        let before = all_in(&beside);
        let signal = if place % 3 == 0 { Signal::TERM } else { Signal::INT };
        let Stopped { code, stderr, took } = stopped(design, &out, moment, signal);
        if code == Some(0) {
            // The new set was in place: all of it.
            too_late += 1;
            run(program().arg("verify").arg(&out)).good();
            continue;
        }
        assert_eq!(code, Some(130), "{moment:?}: {stderr}");
        assert_eq!(stderr, "interrupted: nothing was written\n", "{moment:?}");
        assert!(all_in(&beside) == before, "{moment:?}: {:?}", all_in(&beside).keys());
        assert!(place % 2 == 0 || !out.exists(), "{moment:?}");
        in_the_making += u32::from(matches!(moment, Moment::Writing(_) | Moment::Listed(_)));
        // Files that are being flushed to the disk are waited for.
        if !matches!(moment, Moment::Listed(_)) {
            assert!(took < SOON, "{moment:?}: {took:?}");
            slowest = slowest.max(took);
        }
    }
    println!(
        "{in_the_making} stopped in the making of a set, {too_late} too late, the slowest took {slowest:?}"
    );
    assert!(in_the_making >= 3 && too_late <= 4, "the signals met no build where it matters");
}

/// A build that waits for another can be stopped too.
#[test]
fn a_build_that_waits_can_be_stopped() {
    let root = scratch("interrupting-waiting");
    let design = written(&root, "small.ifs", &example_text("lattice"));
    let out = root.join("out");
    let held = ifs_cli::folder::OutputFolder::stage(&out).unwrap();
    let mut child = start(&design, &out);
    let mut said = std::io::BufReader::new(child.stderr.take().unwrap());
    let mut line = String::new();
    std::io::BufRead::read_line(&mut said, &mut line).unwrap();
    assert!(line.starts_with("waiting for another build of "), "{line}");
    kill_process(Pid::from_child(&child), Signal::INT).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(130));
    drop(held);
    run(program().arg("build").arg(&design).arg("-o").arg(&out)).good();
}

#[test]
fn a_line_of_progress_on_a_terminal_and_nowhere_else() {
    let root = scratch("interrupting-progress");
    let design = written(&root, "smooth.ifs", &planarized());
    let ifs = program_path(is_release());
    let out = root.join("out");
    // Narrower than the line of the programs, which is cut, not broken.
    let on_a_terminal = |more: &[&str]| {
        let mut arguments = vec![Path::new("60"), ifs, Path::new("build"), &design, Path::new("-o"), &out];
        arguments.extend(more.iter().map(Path::new));
        let seen = python_referee("terminal.py", &arguments).counts;
        assert_eq!(seen["code"], 0, "{seen}");
        assert_eq!(seen["strange"].as_array().unwrap().len(), 0, "{seen}");
        assert_eq!(seen["screen"].as_array().unwrap().as_slice(), [""], "{seen}");
        let states = seen["states"].as_array().unwrap().iter();
        let states: Vec<String> = states.map(|line| line.as_str().unwrap().to_owned()).collect();
        (states, seen["stdout"].as_str().unwrap().to_owned())
    };
    let (states, data) = on_a_terminal(&[]);
    assert!(states.iter().any(|line| line.starts_with('[')), "{states:?}");
    // What is done in less than a tick is never drawn; what is drawn is one of these.
    let stages = [
        "working the design out, ",
        "planarizing shell, step ",
        "making boards of shell, ",
        "programs made and read back, ",
        "sheets made and read back, ",
        "nesting, ",
        "making lists and drawings, ",
        "making the report, ",
        "files written, ",
        "putting the files in place, ",
    ];
    let known = |line: &String| line.is_empty() || stages.iter().any(|stage| line.contains(stage));
    assert!(states.iter().all(known), "{states:?}");
    let longest = states.iter().map(|line| line.chars().count()).max();
    assert!(longest <= Some(59), "{states:?}");
    assert!(data.contains("1024 boards"), "{data}");
    assert_eq!(on_a_terminal(&["--quiet", "--emit", "csv"]), (Vec::new(), String::new()));
    let piped = run(program().arg("build").arg(&design).args(["--emit", "csv", "-o"]).arg(&out)).good();
    assert!(piped.contains("1024 boards"), "{piped}");
}
