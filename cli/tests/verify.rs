//! Verifying: every example as it was built is found good; of 100 random corruptions of output folders, half of them
//! with a manifest that was made true again, at least 95 are found.
#![allow(clippy::disallowed_methods, reason = "the test starts the program and reads what it writes")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use ifs_compiler::verify::{Folder, verify};
use sha2::{Digest, Sha256};

/// A set of outputs in memory.
#[derive(Clone)]
struct Memory(BTreeMap<String, Vec<u8>>);

impl Folder for Memory {
    fn names(&self) -> Vec<String> {
        self.0.keys().cloned().collect()
    }

    fn bytes(&self, name: &str, _most: u64) -> Result<Vec<u8>, String> {
        self.0.get(name).cloned().ok_or_else(|| "it is not there".to_owned())
    }
}

/// Numbers that look random (Steele, Lea and Flood, SplitMix64, 2014).
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % limit as u64) as usize
    }
}

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples")
}

fn ifs(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ifs")).args(arguments).output().unwrap()
}

fn built(name: &str) -> PathBuf {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("verify").join(name);
    let source = examples().join(format!("{name}.ifs"));
    let done = ifs(&["build", source.to_str().unwrap(), "-o", out.to_str().unwrap()]);
    assert!(done.status.success(), "{name}: {}", String::from_utf8_lossy(&done.stderr));
    out
}

fn set(folder: &Path) -> Memory {
    let mut files = BTreeMap::new();
    let folders = ["", "boards", "sheets"].map(|name| folder.join(name));
    for name in
        folders.iter().filter(|folder| folder.is_dir()).flat_map(|folder| fs::read_dir(folder).unwrap())
    {
        let path = name.unwrap().path();
        if path.is_file() {
            let name = path.strip_prefix(folder).unwrap().to_string_lossy().replace('\\', "/");
            files.insert(name, fs::read(&path).unwrap());
        }
    }
    Memory(files)
}

#[test]
fn a_set_whose_last_build_failed_says_so() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("verify-failed");
    fs::create_dir_all(&folder).unwrap();
    let (design, out) = (folder.join("design.ifs"), folder.join("out"));
    let text = fs::read_to_string(examples().join("vault.ifs")).unwrap();
    let build = |text: &str| {
        fs::write(&design, text).unwrap();
        ifs(&["build", design.to_str().unwrap(), "-o", out.to_str().unwrap()]).status.code()
    };
    let said = || {
        let found = ifs(&["verify", out.to_str().unwrap()]);
        assert_eq!(found.status.code(), Some(0));
        String::from_utf8(found.stdout).unwrap()
    };
    assert_eq!(build(&text), Some(0));
    assert!(said().ends_with("all of it is as it was built\n"), "{}", said());
    assert_eq!(build(&text.replace("require", "require count <= 1\n    require")), Some(1));
    assert!(said().contains("but not by the last build"), "{}", said());
}

#[test]
fn every_example_as_built_is_good() {
    for entry in fs::read_dir(examples()).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "ifs") {
            let out = built(path.file_stem().unwrap().to_str().unwrap());
            let done = ifs(&["verify", out.to_str().unwrap(), "--message-format", "short"]);
            let said = String::from_utf8_lossy(&done.stdout).into_owned();
            assert_eq!((done.status.code(), said.as_str()), (Some(0), ""), "{}", path.display());
        }
    }
}

#[test]
fn what_a_build_warned_of_is_no_fault_of_its_files() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("verify-warned");
    fs::create_dir_all(&folder).unwrap();
    let (source, out) = (folder.join("line.ifs"), folder.join("out"));
    let text = "use std.curves (bezier2, bezier3, bspline3)\n\
        figure line = bezier3 on ((0m, 0m), (1m, 1m), (2m, 1m), (3m, 0m)) at level 2\n";
    fs::write(&source, text).unwrap();
    let done = ifs(&["build", source.to_str().unwrap(), "-o", out.to_str().unwrap()]);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let said = fs::read_to_string(out.join("diagnostics.json")).unwrap();
    assert!(said.contains("\"warnings\": 2"), "{said}");
    assert_eq!(findings(&out), "");
    // The same list laid out otherwise is not what was written.
    let mut set = set(&out);
    let loose = said.replace("\"severity\":", "\"severity\": ");
    set.0.insert("diagnostics.json".to_owned(), loose.into_bytes());
    rehash(&mut set);
    let findings = verify(&set).unwrap().findings;
    assert!(findings.iter().any(|finding| finding.what == "layout"), "{findings:?}");
}

fn findings(folder: &Path) -> String {
    let done = ifs(&["verify", folder.to_str().unwrap(), "--message-format", "short"]);
    String::from_utf8_lossy(&done.stdout).into_owned()
}

/// Boards on sheets, with programs of both, by a machine with these arguments that holds boards like this.
fn built_roof(name: &str, machine: &str, fixing: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("verify-{name}"));
    let (source, out) = (folder.join("roof.ifs"), folder.join("out"));
    fs::create_dir_all(&folder).unwrap();
    let text = format!(
        "use std.curves (bspline3)\nuse std.surfaces (sheet)\nuse std.materials (birch_plywood)\n\
        use std.machines (onion_skin, router3, tabs, vacuum)\n\
        let net = [[(i * 500mm, j * 500mm, 0.1m * sin(30deg * i)) for j in 0..5] for i in 0..5]\n\
        figure roof = sheet(bspline3, bspline3, net) at level 1\n\
        fabricate roof as panels {{\n    material: birch_plywood(12mm)\n    board: 1250mm by 1250mm\n    \
        machine: router3({machine})\n    fixing: {fixing}\n    nest: {{ programs: both }}\n}}\n"
    );
    fs::write(&source, text).unwrap();
    let done = ifs(&["build", source.to_str().unwrap(), "-o", out.to_str().unwrap()]);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    out
}

fn built_nested() -> PathBuf {
    let out = built_roof("nested", "tool: 6mm", "vacuum()");
    let names = set(&out).0;
    for name in ["sheets/1.nc", "sheets/1.dxf", "sheets/1.svg", "nest.csv", "boards/roof.0-0.left-left.nc"] {
        assert!(names.contains_key(name), "{name}");
    }
    out
}

fn built_with_tabs() -> PathBuf {
    built_roof("tabs", "tool: 6mm, dialect: grbl", "tabs(count: 4)")
}

fn built_with_skin() -> PathBuf {
    built_roof(
        "skin",
        "tool: 6mm, dialect: fanuc, direction: conventional, allowance: 0.3mm",
        "onion_skin(0.4mm)",
    )
}

#[test]
fn every_program_is_read_again_whatever_its_dialect_and_fixing() {
    for out in [built_nested(), built_with_tabs(), built_with_skin()] {
        let good = set(&out);
        let verdict = verify(&good).unwrap();
        assert_eq!(verdict.findings, [], "{}", out.display());
        assert_eq!((verdict.by_hash.len(), verdict.read), (0, verdict.files), "{}", out.display());
        for name in good.0.keys().filter(|name| name.ends_with(".nc")) {
            let mut wrong = good.clone();
            let text = String::from_utf8(good.0[name].clone()).unwrap();
            let (at, line) =
                text.lines().enumerate().filter(|(_, line)| line.starts_with("G1 X")).last().unwrap();
            let lines = text.lines().enumerate().map(|(place, line)| match place == at {
                true => "G1 X17.500\n".to_owned(),
                false => format!("{line}\n"),
            });
            wrong.0.insert(name.clone(), lines.collect::<String>().into_bytes());
            rehash(&mut wrong);
            let findings = verify(&wrong).unwrap().findings;
            assert!(findings.iter().any(|finding| finding.path == *name), "{name}: {line}");
        }
    }
}

#[test]
fn a_plank_sawn_otherwise_is_found() {
    let good = set(&built("vault"));
    let text = String::from_utf8(good.0["stock.csv"].clone()).unwrap();
    assert_eq!(verify(&good).unwrap().by_hash, Vec::<String>::new());
    for (from, to) in [
        (",shared,890.818,", ",shared,888.818,"),
        (",890.818,-4.6337,", ",890.818,-4.6347,"),
        (",shared,886.805", ",own,886.805"),
        (",turned over,", ",as drawn,"),
        ("2984.169,placed", "2984.269,placed"),
        (
            "bar-01,sawn spruce,120.000,27.000,4000.000,4.000,3",
            "bar-02,sawn spruce,120.000,27.000,4000.000,4.000,3",
        ),
    ] {
        assert!(text.contains(from), "the list has no {from}");
        let mut wrong = good.clone();
        wrong.0.insert("stock.csv".to_owned(), text.replacen(from, to, 1).into_bytes());
        rehash(&mut wrong);
        assert!(!verify(&wrong).unwrap().findings.is_empty(), "{from} to {to}");
    }
}

#[test]
fn a_board_that_lies_elsewhere_is_found_in_every_file_of_its_sheet() {
    let good = set(&built_nested());
    let changed = |name: &str, from: &str, to: &str| {
        let mut set = good.clone();
        let text = String::from_utf8(set.0[name].clone()).unwrap();
        assert!(text.contains(from), "{name} has no {from}");
        set.0.insert(name.to_owned(), text.replacen(from, to, 1).into_bytes());
        rehash(&mut set);
        let findings = verify(&set).unwrap().findings;
        assert!(!findings.is_empty(), "{from} to {to} in {name}");
    };
    changed("nest.csv", ",0,placed", ",180,placed");
    changed("nest.csv", ",placed", ",refused");
    let line = |name: &str, start: &str| {
        let text = String::from_utf8(good.0[name].clone()).unwrap();
        text.lines().find(|line| line.starts_with(start)).unwrap().to_owned()
    };
    let at = line("sheets/1.nc", "(at: ");
    changed("sheets/1.nc", &at, &at.replace("turned", "turnt"));
    changed("sheets/1.nc", "\nG1 X", "\nG1 X1");
    let corner = line("sheets/1.svg", "<polygon");
    changed("sheets/1.svg", &corner, &corner.replacen("points=\"", "points=\"1", 1));
    changed("sheets/1.dxf", "roof.0-0", "roof.1-0");
}

#[test]
fn at_least_95_of_100_random_corruptions_are_found() {
    let folders = [built("wall"), built("vault"), built_nested(), built_with_tabs(), built_with_skin()];
    let sets = folders.map(|folder| set(&folder));
    for set in &sets {
        assert_eq!(verify(set).unwrap().findings, []);
    }
    let mut random = Random(2026);
    let (mut found, mut missed) = (0, Vec::new());
    for number in 0..100 {
        let mut corrupted = sets[number % 5].clone();
        let rehashed = number % 4 < 2;
        let what = corrupt(&mut corrupted, rehashed, &mut random);
        match verify(&corrupted) {
            Ok(verdict) if verdict.findings.is_empty() => {
                missed.push(format!("{what}, re-hashed: {rehashed}"))
            }
            _ => found += 1,
        }
    }
    println!("{found} of 100 corruptions found; missed: {missed:#?}");
    assert!(found >= 95, "{found} of 100 found; missed: {missed:#?}");
}

/// Does one damage that changes something, and says which.
fn corrupt(set: &mut Memory, rehashed: bool, random: &mut Random) -> String {
    let before = set.0.clone();
    loop {
        let names: Vec<String> =
            set.0.keys().filter(|name| !rehashed || *name != "manifest.json").cloned().collect();
        let name = names[random.below(names.len())].clone();
        let bytes = set.0[&name].clone();
        let what = match random.below(6) {
            0 => {
                let (at, bit) = (random.below(bytes.len()), random.below(8));
                set.0.get_mut(&name).unwrap()[at] ^= 1 << bit;
                format!("bit {bit} of byte {at} of {name}")
            }
            1 => {
                let length = random.below(bytes.len());
                set.0.get_mut(&name).unwrap().truncate(length);
                format!("{name} cut off after {length} bytes")
            }
            2 => swap_lines(set, &name, random),
            3 => edit_number(set, &name, random),
            4 => {
                let other = names[random.below(names.len())].clone();
                let theirs = set.0[&other].clone();
                set.0.insert(name.clone(), theirs);
                set.0.insert(other.clone(), bytes);
                format!("{name} and {other} exchanged")
            }
            _ => {
                set.0.remove(&name);
                format!("{name} deleted")
            }
        };
        if set.0 != before {
            if rehashed {
                rehash(set);
            }
            return what;
        }
    }
}

fn swap_lines(set: &mut Memory, name: &str, random: &mut Random) -> String {
    let bytes = set.0[name].clone();
    let mut lines: Vec<&[u8]> = bytes.split(|byte| *byte == b'\n').collect();
    let (one, other) = (random.below(lines.len()), random.below(lines.len()));
    lines.swap(one, other);
    set.0.insert(name.to_owned(), lines.join(&b'\n'));
    format!("lines {one} and {other} of {name} exchanged")
}

/// Another digit in the place of one.
fn edit_number(set: &mut Memory, name: &str, random: &mut Random) -> String {
    let bytes = set.0.get_mut(name).unwrap();
    let digits: Vec<usize> = (0..bytes.len()).filter(|at| bytes[*at].is_ascii_digit()).collect();
    let at = digits[random.below(digits.len())];
    bytes[at] = b'0' + (bytes[at] - b'0' + 1 + random.below(9) as u8) % 10;
    format!("a digit at byte {at} of {name}")
}

/// Makes the manifest true again by hand.
fn rehash(set: &mut Memory) {
    let mut manifest: serde_json::Value = serde_json::from_slice(&set.0["manifest.json"]).unwrap();
    let files = manifest["files"].as_array_mut().unwrap();
    files.retain(|file| set.0.contains_key(file["path"].as_str().unwrap()));
    for file in files {
        let bytes = &set.0[file["path"].as_str().unwrap()];
        let hash: String = Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect();
        file["bytes"] = bytes.len().into();
        file["sha256"] = hash.into();
    }
    set.0.insert("manifest.json".to_owned(), serde_json::to_vec_pretty(&manifest).unwrap());
}

#[test]
fn no_manifest_and_ways_out_are_told() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("verify-odd");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let code = |folder: &Path| ifs(&["verify", folder.to_str().unwrap()]).status.code();
    assert_eq!(code(&folder.join("none")), Some(3));
    assert_eq!(code(&folder), Some(3));
    assert_eq!(ifs(&["verify"]).status.code(), Some(2));
    let listed = |path: &str| {
        format!(
            "{{\"schema\":1,\"program\":\"ifs\",\"version\":\"0\",\"sources\":[],\"parameters\":{{}},\"files\":[{{\
            \"path\":\"{path}\",\"bytes\":18446744073709551615,\"sha256\":\"\",\"kind\":\"list\"}}]}}"
        )
    };
    for (manifest, part) in [
        ("\u{1}\u{2}".to_owned(), "is not the list"),
        ("[".repeat(100_000), "is not the list"),
        (listed("../outside"), "leads out"),
        (listed("/etc/passwd"), "leads out"),
        (listed("cutlist.csv"), "cannot be read, found No such file"),
    ] {
        fs::write(folder.join("manifest.json"), manifest).unwrap();
        let done = ifs(&["verify", folder.to_str().unwrap(), "--message-format", "short"]);
        let said = String::from_utf8_lossy(&done.stdout).into_owned();
        assert_eq!(done.status.code(), Some(1), "{said}");
        assert!(said.contains(part) || part.starts_with("cannot") && said.contains("No such file"), "{said}");
    }
}

#[test]
fn a_design_built_again_gives_the_same_bytes_or_says_where_not() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("verify-source");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let source = folder.join("vault.ifs");
    let text = fs::read_to_string(examples().join("vault.ifs")).unwrap();
    fs::write(&source, &text).unwrap();
    fs::write(folder.join("shop.ifs"), "use std.machines (router3)\nlet own = router3(dialect: grbl)\n")
        .unwrap();
    let machine = format!("{}:own", folder.join("shop.ifs").display());
    let (source, out) = (source.to_str().unwrap(), folder.join("out"));
    let out = out.to_str().unwrap();
    let verified = || {
        let done = ifs(&["verify", out, "--source", source, "--message-format", "short"]);
        (done.status.code(), String::from_utf8_lossy(&done.stdout).into_owned())
    };
    for arguments in [
        vec![],
        vec!["--set", "span=6.5m", "--machine", &machine, "--emit", "nc,csv,html", "--only", "*left"],
    ] {
        let built = ifs(&[vec!["build", source, "-o", out], arguments].concat());
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        assert_eq!(verified(), (Some(0), String::new()));
    }
    // Another program for a board, with a manifest that is made true again.
    let mut set = set(Path::new(out));
    let name = set.0.keys().find(|name| name.ends_with(".nc")).unwrap().clone();
    let changed = String::from_utf8(set.0[&name].clone()).unwrap().replacen("(design: ", "(design:  ", 1);
    set.0.insert(name.clone(), changed.into_bytes());
    rehash(&mut set);
    for file in [name.as_str(), "manifest.json"] {
        fs::write(Path::new(out).join(file), &set.0[file]).unwrap();
    }
    let (code, said) = verified();
    assert!(code == Some(1) && said.contains(&format!("{name}: the bytes")), "{said}");
    fs::write(source, format!("{text}// a word\n")).unwrap();
    let (code, said) = verified();
    assert!(code == Some(1) && said.contains("vault.ifs: the source"), "{said}");
}
