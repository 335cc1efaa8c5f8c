//! Output folders that cannot be written, full disks, and readers that go away: exit code, message, and the old outputs
//! untouched; and after the matter is mended the next build is good.
#![allow(clippy::disallowed_methods, reason = "the tests start programs and look at files")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::collections::BTreeMap;
use std::fs::{self, OpenOptions, Permissions};
use std::io::Write;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use ifs_tests::designs::{assert_same, contents, example_path};
use ifs_tests::outcome::{Outcome, run};
use ifs_tests::{program, scratch};

/// The arguments that build the shell into a folder.
fn shell_into(command: &mut Command, out: &Path) -> Outcome {
    run(command.arg("build").arg(example_path("shell")).arg("-o").arg(out))
}

/// The folder `out` below `root`, with the outputs of the vault.
fn vault_below(root: &Path) -> (PathBuf, BTreeMap<String, Vec<u8>>) {
    let out = root.join("out");
    run(program().arg("build").arg(example_path("vault")).arg("-o").arg(&out)).good();
    let before = contents(&out);
    (out, before)
}

/// Nothing of a build lies beside the folder, and the next build is good.
fn mended(root: &Path, out: &Path) {
    let beside =
        |entry: std::io::Result<fs::DirEntry>| entry.unwrap().file_name().to_string_lossy().into_owned();
    let names: Vec<String> =
        fs::read_dir(root).unwrap().map(beside).filter(|name| name.contains(".ifs-")).collect();
    assert_eq!(names, Vec::<String>::new(), "left behind");
    shell_into(&mut program(), out).good();
    assert!(contents(out).contains_key("planarity.csv"));
}

/// The program as somebody whom permissions bind: root without the right to pass over them, or oneself.
fn bound_program() -> Command {
    let is_root = run(Command::new("id").arg("-u")).good().trim() == "0";
    if !is_root {
        return program();
    }
    let mut command = Command::new("setpriv");
    command.args(["--bounding-set=-dac_override", "--inh-caps=-dac_override"]).arg(program().get_program());
    command
}

#[test]
fn a_folder_that_may_not_be_written() {
    let root = scratch("folder-read-only");
    let (out, before) = vault_below(&root);
    // The folder itself, and the one it lies in.
    for closed in [&out, &root] {
        fs::set_permissions(closed, Permissions::from_mode(0o555)).unwrap();
        let done = shell_into(&mut bound_program(), &out);
        fs::set_permissions(closed, Permissions::from_mode(0o755)).unwrap();
        done.failed(3, &["error: could not", "Permission denied"]);
        assert_same(&before, &contents(&out), "a read-only folder");
    }
    mended(&root, &out);
}

#[test]
fn a_path_that_is_no_folder() {
    let root = scratch("folder-none");
    let file = root.join("file");
    fs::write(&file, "mine").unwrap();
    shell_into(&mut program(), &file).failed(3, &["exists and is not a folder"]);
    shell_into(&mut program(), &file.join("out")).failed(3, &["Not a directory"]);
    assert_eq!(fs::read(&file).unwrap(), b"mine");
    shell_into(program().current_dir(&root), Path::new(".")).failed(3, &["holds the working folder"]);
    shell_into(program().current_dir(&root), Path::new("/")).failed(3, &["holds the working folder"]);
    // A file of the user's where an output goes, and a manifest that no build wrote.
    let out = root.join("out");
    fs::create_dir(&out).unwrap();
    fs::write(out.join("cutlist.csv"), "mine").unwrap();
    shell_into(&mut program(), &out)
        .failed(3, &["was not written by an earlier build and would be overwritten"]);
    fs::rename(out.join("cutlist.csv"), out.join("manifest.json")).unwrap();
    shell_into(&mut program(), &out).failed(3, &["is not the manifest of an earlier build"]);
    assert_eq!(contents(&out), BTreeMap::from([("manifest.json".to_owned(), b"mine".to_vec())]));
    fs::remove_file(out.join("manifest.json")).unwrap();
    mended(&root, &out);
}

/// A limit on the size of files stands for a disk that takes part of a file and no more.
#[test]
fn a_disk_that_takes_no_more() {
    let root = scratch("folder-limit");
    let (out, before) = vault_below(&root);
    let mut limited = Command::new("sh");
    // Units are 512 or 1024 bytes: 32 or 64 KiB, and the model of the shell has more than 200.
    limited.args(["-c", "trap '' XFSZ; ulimit -f 64; exec \"$0\" \"$@\""]).arg(program().get_program());
    shell_into(&mut limited, &out).failed(3, &["error: could not write", "model.glb"]);
    assert_same(&before, &contents(&out), "a disk that takes no more");
    mended(&root, &out);
}

/// Fills the disk with one file, up to some bytes.
fn fill(path: &Path, spare: u64) {
    let mut file = fs::File::create(path).unwrap();
    while file.write_all(&[0; 4096]).is_ok() {}
    let length = file.metadata().unwrap().len();
    file.set_len(length - spare).unwrap();
}

/// A real full disk, where this process may mount one; elsewhere the limit above has to do, and here is checked that the
/// limit holds at every size, down to none.
#[test]
fn a_full_disk() {
    let root = scratch("folder-full");
    let mut mount = Command::new("mount");
    mount.args(["-t", "tmpfs", "-o", "size=8m", "ifs-test"]).arg(&root);
    if !mount.output().is_ok_and(|done| done.status.success()) {
        let (out, before) = vault_below(&root);
        for blocks in ["0", "1", "100"] {
            let mut limited = Command::new("sh");
            limited.args(["-c", &format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$0\" \"$@\"")]);
            shell_into(limited.arg(program().get_program()), &out).failed(3, &["error: could not write"]);
            assert_same(&before, &contents(&out), "a disk that takes no more");
        }
        return mended(&root, &out);
    }
    let result = std::panic::catch_unwind(|| {
        let (out, before) = vault_below(&root);
        fill(&root.join("ballast"), 64 * 1024);
        let done = shell_into(&mut program(), &out);
        done.failed(3, &["error: could not write", "No space left", "the earlier outputs are untouched"]);
        assert_same(&before, &contents(&out), "a full disk");
    });
    assert!(Command::new("umount").arg(&root).status().unwrap().success());
    if let Err(failure) = result {
        std::panic::resume_unwind(failure);
    }
}

/// Whoever reads the table may go away: the outputs are there all the same. A full disk under stdout is told.
#[test]
fn nobody_reads_what_is_printed() {
    let root = scratch("folder-pipes");
    let whole =
        |out: &Path| assert!(contents(out).contains_key("manifest.json"), "{} is not whole", out.display());
    for more in [&[][..], &["--emit", "plan,glb"], &["--message-format", "json"]] {
        let out = root.join("piped");
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let mut command = program();
        command.arg("build").arg(example_path("vault")).arg("-o").arg(&out).args(more);
        let done = command.stdout(writer).stderr(Stdio::piped()).output().unwrap();
        assert_eq!((done.status.code(), done.stderr.as_slice()), (Some(0), &b""[..]), "{more:?}");
        whole(&out);
        fs::remove_dir_all(&out).unwrap();
    }
    let full = OpenOptions::new().write(true).open("/dev/full").unwrap();
    let mut command = program();
    command.arg("build").arg(example_path("vault")).arg("-o").arg(root.join("full"));
    let done = command.stdout(full).stderr(Stdio::piped()).output().unwrap();
    assert_eq!(done.status.code(), Some(3));
    assert!(
        String::from_utf8(done.stderr)
            .unwrap()
            .starts_with("error: could not write to the standard output: ")
    );
    whole(&root.join("full"));
    // Streams that were closed before the program began.
    fs::write(root.join("bad.ifs"), "let a = b\n").unwrap();
    for (line, code) in [
        ("\"$0\" build \"$1\" -o closed >&- 2>&- <&-", 0),
        ("\"$0\" build bad.ifs -o never 2>&-", 1),
        ("\"$0\" check bad.ifs --message-format json >&-", 1),
        ("\"$0\" build bad.ifs -o never 2>/dev/full", 1),
        ("\"$0\" build \"$1\" -o head | head -c 0", 0),
    ] {
        let mut command = Command::new("sh");
        command.args(["-c", line]).arg(program().get_program()).arg(example_path("vault")).current_dir(&root);
        let done = run(&mut command);
        assert_eq!(done.code, Some(code), "{line}: {done:?}");
        assert!(!done.stderr.contains("panicked"), "{line}: {}", done.stderr);
    }
    whole(&root.join("closed"));
    whole(&root.join("head"));
    // What a failed build said is all that it leaves.
    let left: Vec<String> = contents(&root.join("never")).into_keys().collect();
    assert_eq!(left, ["diagnostics.json", "manifest.json"]);
}
