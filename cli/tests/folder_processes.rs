//! The output folder among processes: builds killed at any moment, builds that wait for one another, full disks.
//!
//! Called as `writer TARGET exchange|journal FIRST COUNT` the program builds generations of a set, one after the
//! other, and prints the number of each when it is committed; otherwise it runs the tests.
#![allow(clippy::disallowed_methods, reason = "the tests start processes and look at the files")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

use ifs_cli::folder::{Exchange, FolderError, Making, Manifest, OutputFolder, Provenance, verify};
use libtest_mimic::{Arguments, Failed, Trial};

/// Kills per way of replacing.
const KILLS: u32 = 60;
/// Boards of a set.
const BOARDS: u32 = 40;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    if arguments.get(1).is_some_and(|a| a == "writer") {
        return writer(&arguments[2..]);
    }
    let trials = vec![
        Trial::test("a_killed_build_leaves_the_old_set_or_the_new_one", || killed(Exchange::System)),
        Trial::test("a_killed_build_by_journal_is_finished_by_the_next_command", || {
            killed(Exchange::Journal)
        }),
        Trial::test("a_second_build_waits", a_second_build_waits),
        Trial::test("a_disk_that_takes_no_more_keeps_the_old_set", a_disk_that_takes_no_more),
        Trial::test("a_full_file_system_keeps_the_old_set", a_full_file_system),
    ];
    libtest_mimic::run(&Arguments::from_args(), trials).exit_code()
}

/// Builds generation after generation until all are done or it is killed.
fn writer(arguments: &[String]) -> ExitCode {
    let [target, exchange, first, count] = arguments else { return ExitCode::from(2) };
    let exchange = if exchange == "journal" { Exchange::Journal } else { Exchange::System };
    let (first, count): (u32, u32) = (first.parse().unwrap(), count.parse().unwrap());
    for generation in first..first + count {
        if let Err(error) = build(Path::new(target), exchange, generation) {
            eprintln!("{error}");
            return ExitCode::from(3);
        }
        println!("{generation}");
    }
    ExitCode::SUCCESS
}

/// One set: every byte of it says which generation it is of, and some names do.
fn build(target: &Path, exchange: Exchange, generation: u32) -> Result<(), FolderError> {
    let mut staging = OutputFolder::stage_with(target, Making { exchange, ..Making::default() }, &mut || ())?;
    for board in 0..BOARDS {
        let name = format!("boards/{board}-{}.nc", generation % 3);
        staging.write_with(&name, "nc", Some("vault.left"), |out| writeln!(out, "{generation}"))?;
    }
    staging.write_with("model.glb", "glb", None, |out| {
        (0..50_000).try_for_each(|_| writeln!(out, "{generation}"))
    })?;
    let parameters = BTreeMap::from([("generation".to_owned(), generation.to_string())]);
    let done = staging.commit(&Provenance { sources: Vec::new(), parameters, ..Provenance::default() })?;
    done.leftover.map_or(Ok(()), Err)
}

/// An empty folder of a test's own.
fn scratch(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("processes").join(test);
    if folder.exists() {
        fs::remove_dir_all(&folder).unwrap();
    }
    fs::create_dir_all(&folder).unwrap();
    folder.canonicalize().unwrap()
}

fn start(target: &Path, exchange: &str, first: u32, count: u32) -> Child {
    Command::new(std::env::current_exe().unwrap())
        .arg("writer")
        .arg(target)
        .args([exchange, &first.to_string(), &count.to_string()])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// The generation of a whole set, every byte of which was compared with the manifest.
fn generation(target: &Path) -> Result<u32, Failed> {
    let differences = verify(target)?;
    if !differences.is_empty() {
        return Err(format!("{} is neither set: {differences:?}", target.display()).into());
    }
    let manifest = Manifest::read(target)?.ok_or("no manifest")?;
    let text = manifest.parameters.get("generation").ok_or("no generation")?;
    let number: u32 = text.parse()?;
    let boards = fs::read_dir(target.join("boards"))?.count();
    if boards != BOARDS as usize || fs::read(target.join("model.glb"))?.len() != (text.len() + 1) * 50_000 {
        return Err(format!("generation {number} has {boards} boards").into());
    }
    Ok(number)
}

fn names_beside(root: &Path) -> Vec<String> {
    fs::read_dir(root).unwrap().map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect()
}

fn killed(exchange: Exchange) -> Result<(), Failed> {
    let word = if exchange == Exchange::Journal { "journal" } else { "exchange" };
    let root = scratch(word);
    let target = root.join("vault");
    build(&target, exchange, 0)?;
    fs::write(target.join("notes.txt"), "mine")?;
    fs::create_dir(target.join("ours"))?;
    fs::write(target.join("ours/photo.jpg"), "mine")?;
    let whole = time_of_builds(&target, word)?;
    let mut last = generation(&target)?;
    let (mut in_the_middle, mut new_and_untold, mut without_target) = (0, 0, 0);
    for kill in 0..KILLS {
        let mut child = start(&target, word, last + 1, 1_000_000);
        wait_for_the_moment(&root, kill, whole);
        let kill_sent = child.kill();
        child.wait()?;
        kill_sent?;
        let mut printed = String::new();
        child.stdout.take().ok_or("no output")?.read_to_string(&mut printed)?;
        let told = printed.lines().last().map_or(Ok(last), str::parse)?;
        in_the_middle += u32::from(names_beside(&root).iter().any(|n| n != "vault" && !n.ends_with("lock")));
        if exchange == Exchange::Journal {
            without_target += u32::from(!target.exists());
            OutputFolder::recover(&target)?;
        }
        let found = generation(&target)?;
        if found != told && found != told + 1 {
            return Err(format!("generation {found} after {told} was committed").into());
        }
        if fs::read(target.join("notes.txt"))? != b"mine"
            || fs::read(target.join("ours/photo.jpg"))? != b"mine"
        {
            return Err("a foreign file was lost".into());
        }
        new_and_untold += u32::from(found == told + 1);
        last = found;
    }
    println!(
        "{word}: {KILLS} kills in {last} builds, {in_the_middle} in the middle of one, {new_and_untold} after the \
         new set was in place and before that was told, {without_target} between two renames"
    );
    if in_the_middle < KILLS / 4 || new_and_untold == 0 {
        return Err("the kills met no build where it matters".into());
    }
    build(&target, exchange, last + 1)?;
    if generation(&target)? != last + 1 || names_beside(&root) != ["vault"] {
        return Err(format!("left behind: {:?}", names_beside(&root)).into());
    }
    Ok(())
}

/// Waits until a kill: every second one at any time within three builds, the others around the one step in which the
/// new set takes the old one's place. Both are spread evenly, in an order that looks random.
fn wait_for_the_moment(root: &Path, kill: u32, whole: Duration) {
    let part = f64::from(kill * 37 % KILLS) / f64::from(KILLS);
    if kill.is_multiple_of(2) {
        return std::thread::sleep(whole.mul_f64(part));
    }
    let begun = Instant::now();
    while !root.join(".vault.ifs-staging/manifest.json").exists() && begun.elapsed() < whole * 10 {
        std::hint::spin_loop();
    }
    let after = Instant::now();
    while after.elapsed() < Duration::from_millis(5).mul_f64(part) {
        std::hint::spin_loop();
    }
}

/// The time a process takes for three builds, its start included.
fn time_of_builds(target: &Path, word: &str) -> Result<Duration, Failed> {
    let begun = Instant::now();
    let done = start(target, word, 1, 3).wait_with_output()?;
    if done.status.code() != Some(0) {
        return Err(String::from_utf8_lossy(&done.stderr).into_owned().into());
    }
    Ok(begun.elapsed())
}

fn a_second_build_waits() -> Result<(), Failed> {
    let root = scratch("waits");
    let target = root.join("vault");
    let mut held = OutputFolder::stage(&target)?;
    let mut second = start(&target, "exchange", 7, 1);
    std::thread::sleep(Duration::from_millis(300));
    if second.try_wait()?.is_some() {
        return Err("the second build did not wait".into());
    }
    held.write("a.csv", "csv", None, b"first")?;
    held.commit(&Provenance::default())?;
    let mut line = String::new();
    BufReader::new(second.stdout.take().ok_or("no output")?).read_line(&mut line)?;
    if !second.wait()?.success() || line != "7\n" || generation(&target)? != 7 {
        return Err(format!("the second build printed {line:?}").into());
    }
    // Four at once: each waits for the others, and whole sets come out.
    let many: Vec<Child> = (0..4).map(|n| start(&target, "exchange", 10 * n, 5)).collect();
    for child in many {
        let done = child.wait_with_output()?;
        if !done.status.success() || done.stdout.split(|b| *b == b'\n').count() != 6 {
            return Err(format!("{done:?}").into());
        }
    }
    generation(&target)?;
    if names_beside(&root) != ["vault"] {
        return Err(format!("left behind: {:?}", names_beside(&root)).into());
    }
    Ok(())
}

/// A limit on the size of files stands for a disk that takes part of a file and no more: writing fails half-way, for
/// any user and on any machine.
fn a_disk_that_takes_no_more() -> Result<(), Failed> {
    let root = scratch("limit");
    let target = root.join("vault");
    build(&target, Exchange::System, 1)?;
    let failed = Command::new("sh")
        .args(["-c", "trap '' XFSZ; ulimit -f 32; exec \"$0\" writer \"$1\" exchange 2 1"])
        .arg(std::env::current_exe()?)
        .arg(&target)
        .output()?;
    keeps_the_old_set(&root, &target, &failed)
}

/// A real full disk, where the machine lets this process mount one. Where it does not, the limit above stands for it
/// and this test checks that `StorageFull` is told as what it is.
fn a_full_file_system() -> Result<(), Failed> {
    let root = scratch("full");
    let mounted = Command::new("mount")
        .args(["-t", "tmpfs", "-o", "size=600k", "ifs-test"])
        .arg(&root)
        .output()
        .is_ok_and(|done| done.status.success());
    if !mounted {
        let full = fs::OpenOptions::new().write(true).open("/dev/full")?.write(b"x").unwrap_err();
        let error = FolderError::Io { doing: "write", path: root.join("vault/model.glb"), source: full };
        let text = error.to_string();
        if !text.starts_with("could not write ") || !text.contains("the earlier outputs are untouched") {
            return Err(text.into());
        }
        return Ok(());
    }
    let result = on_a_full_file_system(&root);
    let unmounted = Command::new("umount").arg(&root).status()?;
    result?;
    if unmounted.success() { Ok(()) } else { Err("could not unmount".into()) }
}

fn on_a_full_file_system(root: &Path) -> Result<(), Failed> {
    let target = root.join("vault");
    build(&target, Exchange::System, 1)?;
    fs::write(root.join("ballast"), vec![0; 300 * 1024])?;
    let failed = start(&target, "exchange", 2, 1).wait_with_output()?;
    fs::remove_file(root.join("ballast"))?;
    if !String::from_utf8_lossy(&failed.stderr).contains("the earlier outputs are untouched") {
        return Err(format!("{failed:?}").into());
    }
    keeps_the_old_set(root, &target, &failed)
}

fn keeps_the_old_set(root: &Path, target: &Path, failed: &std::process::Output) -> Result<(), Failed> {
    let message = String::from_utf8_lossy(&failed.stderr);
    let expected = format!("could not write {}/", target.display());
    if failed.status.code() != Some(3) || !message.starts_with(&expected) {
        return Err(format!("{failed:?}").into());
    }
    if generation(target)? != 1 || names_beside(root) != ["vault"] {
        return Err(format!("left behind: {:?}", names_beside(root)).into());
    }
    build(target, Exchange::System, 2)?;
    generation(target)?;
    Ok(())
}
