//! zbar as referee of the labels: each QR code, printed is read as the address of its board.
#![allow(clippy::disallowed_methods, reason = "the tests run foreign programs")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail anywhere")]

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use glam::DVec2;
use ifs_compiler::export::labels::{Label, Sheet};
use ifs_compiler::outputs::{Format, Selection, board_names, outputs};
use ifs_tests::designs::{analysis_of, example_text};
use ifs_tests::scratch;

/// What zbar reads on a sheet.
fn read(folder: &Path, name: &str, svg: &[u8], dots_an_inch: u32) -> BTreeSet<String> {
    let (drawn, seen) = (folder.join(name), folder.join(name).with_extension("png"));
    fs::write(&drawn, svg).unwrap();
    let mut convert = Command::new("rsvg-convert");
    let resolution = ["x", "y"].map(|axis| format!("--dpi-{axis}={dots_an_inch}"));
    let converted = convert.args(resolution).arg("-o").arg(&seen).arg(&drawn).output();
    let converted = converted.expect("rsvg-convert is missing: run tests/setup.sh");
    assert!(converted.status.success(), "{}", String::from_utf8_lossy(&converted.stderr));
    let mut zbar = Command::new("zbarimg");
    let said = zbar.args(["--quiet", "--raw", "-Sdisable", "-Sqrcode.enable"]).arg(&seen).output();
    let said = said.expect("zbarimg is missing: run tests/setup.sh");
    String::from_utf8(said.stdout).unwrap().lines().map(str::to_owned).collect()
}

#[test]
fn zbar_reads_every_address() {
    let folder = scratch("labels");
    let mut sheets = 0;
    // Of the shell the first and the last rows: reading a sheet takes the referee two seconds.
    for (name, only) in [("shell", &["shell-00-*", "shell-01-*", "shell-15-*"][..]), ("vault", &[])] {
        let analysis = analysis_of(&example_text(name));
        let only = only.iter().map(|pattern| (*pattern).to_owned()).collect();
        let selection = Selection { formats: vec![Format::Svg], only };
        let made = outputs(&analysis, &selection);
        let mut found = BTreeSet::new();
        for file in made.files.iter().filter(|file| file.kind == "labels") {
            let mut svg = Vec::new();
            file.write(&mut svg).unwrap();
            found.extend(read(&folder, &format!("{name}-{}", file.path), &svg, 300));
            sheets += 1;
        }
        let addresses: BTreeSet<String> = board_names(&analysis)
            .iter()
            .filter(|(address, alias)| selection.takes(address, alias))
            .map(|(address, _)| (*address).to_owned())
            .collect();
        assert_eq!(found, addresses, "{name}");
    }
    assert!(sheets > 2, "some need more than one sheet");
}

#[test]
fn long_and_strange_addresses_are_read() {
    let folder = scratch("labels-strange");
    let long = format!("shell.0-0.{}", "left-right.".repeat(20));
    // Addresses are ASCII; readers of QR codes do not agree on what other characters are.
    let addresses = [long.trim_end_matches('.'), "a", "<&\"'>", "UPPER 123", "0123456789"];
    let outline = [(0.0, 0.0), (300.0, 5.0), (290.0, 120.0), (-4.0, 110.0)].map(DVec2::from).to_vec();
    let label = |address: &&str| Label {
        address: (*address).to_owned(),
        alias: "shell-00-00".to_owned(),
        about: "plywood & \"glue\" 300.0 x 120.0 x 12.0 mm".to_owned(),
        outline: outline.clone(),
    };
    let labels: Vec<Label> = addresses.iter().cycle().take(9).map(label).collect();
    let mut svg = Vec::new();
    Sheet { title: "strange".to_owned(), labels }.write(&mut svg).unwrap();
    let expected: BTreeSet<String> = addresses.iter().map(|address| (*address).to_owned()).collect();
    assert_eq!(read(&folder, "strange.svg", &svg, 300), expected);
}
