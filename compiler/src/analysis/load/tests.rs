//! Loading: which files a design is made of, and what is said of those it cannot be made of.

use super::{MOST_BYTES, MOST_FILES, load};
use crate::analysis::read;
use crate::diagnostic::Code;
use crate::hir::evaluate::Overrides;
use crate::source::{Files, MemoryFiles, ReadError};
use std::cell::RefCell;

fn loaded(files: &MemoryFiles) -> (Vec<String>, Vec<(Code, String)>) {
    let loaded = load(files, "a.ifs", None, None);
    let paths = loaded.files.iter().map(|file| file.path.clone()).collect();
    (paths, loaded.diagnostics.into_iter().map(|found| (found.code, found.message)).collect())
}

#[test]
fn one_file_by_many_spellings_is_read_once() {
    /// Counts what is read; `link` is a folder that leads to `parts`.
    struct Counting(MemoryFiles, RefCell<Vec<String>>);
    impl Files for Counting {
        fn read(&self, path: &str) -> Result<Vec<u8>, ReadError> {
            self.1.borrow_mut().push(path.to_owned());
            self.0.read(path)
        }
        fn resolve(&self, path: &str) -> Result<String, ReadError> {
            Ok(path.replace("link/", "parts/"))
        }
    }
    let design = r#"
        use "./parts/b.ifs" (x)
        use "parts/../parts//b.ifs" (y)
        use "./link/b.ifs" (z)
        use "./parts/c.ifs" (w)
    "#;
    let files = MemoryFiles::single("a.ifs", design)
        .with("parts/b.ifs", "use \"./c.ifs\" (w)")
        .with("parts/c.ifs", "");
    let files = Counting(files, RefCell::default());
    let loaded = load(&files, "a.ifs", None, None);
    assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
    assert_eq!(*files.1.borrow(), ["a.ifs", "parts/b.ifs", "parts/c.ifs"]);
    assert_eq!(loaded.files[0].uses.len(), 4);
    assert_eq!(loaded.files[1].uses.len(), 1);
}

#[test]
fn every_circle_is_said_once_with_its_way() {
    let files = MemoryFiles::single("a.ifs", "use \"b.ifs\" (x)\nuse \"c.ifs\" (x)\nuse \"a.ifs\" (x)")
        .with("b.ifs", "use \"c.ifs\" (x)")
        .with("c.ifs", "use \"b.ifs\" (x)");
    let (paths, said) = loaded(&files);
    assert_eq!(paths, ["a.ifs", "b.ifs", "c.ifs"]);
    let messages: Vec<&str> = said.iter().map(|(_, message)| message.as_str()).collect();
    assert_eq!(
        messages,
        ["files use each other in a circle: `b.ifs` → `c.ifs` → `b.ifs`", "`a.ifs` uses itself"]
    );
    assert!(said.iter().all(|(code, _)| *code == Code::E0311));
}

#[test]
fn a_file_of_another_kind_is_told_as_that() {
    for (line, hint) in [
        ("use \"c.glb\" (x)", "a mesh is imported as a germ: `germ import(\"c.glb\")`"),
        ("use \"c.scad\" (x)", "designs have the ending `.ifs`, not `.scad`"),
        ("use \"./c\" (x)", "the name of a file has its ending: `./c.ifs`"),
        ("import(\"c.ifs\")", "a design is no mesh: take an ifs of it with `use \"c.ifs\" (…)`"),
        ("import(\"b.ifs\")", "a design is no mesh: take an ifs of it with `use \"b.ifs\" (…)`"),
        ("import(\"c.obj\")", "meshes are read as glTF binary, `.glb`, not `.obj`"),
    ] {
        let text = match line.starts_with("import") {
            true => {
                format!("ifs joint in space {{\n    transform a = scale(1/2) * self\n    germ {line}\n}}")
            }
            false => line.to_owned(),
        };
        let files = MemoryFiles::single("a.ifs", &text).with("b.ifs", "pub let x = 1m");
        let mut found = read(&files, "a.ifs", &Overrides::default()).diagnostics;
        found.retain(|found| matches!(found.code, Code::E0306 | Code::E0556));
        let hints: Vec<&str> =
            found.iter().flat_map(|found| &found.hints).map(|hint| hint.text.as_str()).collect();
        assert_eq!(hints, [hint], "{line}");
    }
}

#[test]
fn every_use_of_a_missing_file_is_said_and_a_limit_once() {
    let (_, said) = loaded(&MemoryFiles::single("a.ifs", "use \"b.ifs\" (x)\nuse \"./b.ifs\" (y)"));
    assert_eq!(said.len(), 2);
    assert!(said.iter().all(|(code, message)| *code == Code::E0306 && message.contains("no such file")));

    let uses: String = (0..MOST_FILES + 5).map(|n| format!("use \"f{n}.ifs\" (x)\n")).collect();
    let mut files = MemoryFiles::single("a.ifs", &uses);
    for n in 0..MOST_FILES + 5 {
        files = files.with(&format!("f{n}.ifs"), "");
    }
    let (paths, said) = loaded(&files);
    assert_eq!(paths.len(), MOST_FILES);
    assert_eq!(said.len(), 1);
    assert_eq!(said[0].0, Code::E0312);
}

#[test]
fn too_many_bytes_are_not_read() {
    let part = vec![b' '; 12 << 20];
    let mut files = MemoryFiles::single("a.ifs", "use \"0.ifs\" (x)\nuse \"1.ifs\" (x)\nuse \"2.ifs\" (x)");
    for n in 0..3 {
        files = files.with(&format!("{n}.ifs"), part.clone());
    }
    let (paths, said) = loaded(&files);
    assert!(paths.len() * part.len() <= MOST_BYTES + part.len());
    assert_eq!((paths.len(), said.len(), said[0].0), (3, 1, Code::E0312));
}
