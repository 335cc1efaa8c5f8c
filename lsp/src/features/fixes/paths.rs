//! A path that leads to no file: the file of the project that was surely meant. What files there are is the caller's to
//! find.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Code, Diagnostic, Edit, closest};

use super::Mend;
use crate::features::completion::relative;
use crate::features::words::written;

/// The paths of files of that name elsewhere, else the one that is written most like it; `paths` gives those of the project,
/// from its root.
pub(crate) fn nearest(analysis: &Analysis, found: &Diagnostic, paths: &dyn Fn() -> Vec<String>) -> Vec<Mend> {
    let text = written(analysis, found.span).strip_prefix('"').and_then(|text| text.strip_suffix('"'));
    let (Code::E0306, Some(text), Some(source)) = (found.code, text, analysis.sources.get(found.span.file))
    else {
        return Vec::new();
    };
    let ending = name(text).rsplit_once('.').map_or(".ifs".to_owned(), |(_, ending)| format!(".{ending}"));
    let paths = paths();
    let others = paths.iter().filter(|path| **path != source.path && path.ends_with(&ending));
    let others: Vec<String> = others.map(|path| relative(&source.path, path)).collect();
    let mut meant: Vec<&str> =
        others.iter().map(String::as_str).filter(|path| name(path) == name(text)).collect();
    if meant.is_empty() {
        meant.extend(closest(text, others.iter().map(String::as_str)));
    }
    let preferred = meant.len() == 1;
    let mend = |meant: &str| Mend {
        title: format!("replace `{text}` with `{meant}`"),
        edits: vec![Edit { span: found.span, replacement: format!("\"{meant}\"") }],
        preferred,
        safe: false,
    };
    meant.into_iter().map(mend).collect()
}

fn name(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or(path)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::features::fixture::fixture;

    #[test]
    fn the_file_of_that_name_or_the_one_most_like_it() {
        let meant = |text: &str, paths: &[&str]| {
            let design = fixture(text);
            let paths: Vec<String> = paths.iter().map(|path| (*path).to_owned()).collect();
            let found = design.analysis.diagnostics.iter();
            let mends = found.flat_map(|found| nearest(&design.analysis, found, &|| paths.clone()));
            mends.map(|mend| mend.title).collect::<Vec<_>>()
        };
        let paths = ["design.ifs", "parts/ribs.ifs", "parts/roof.ifs", "node.glb"];
        let title = |from: &str, to: &str| vec![format!("replace `{from}` with `{to}`")];
        assert_eq!(meant("use \"./ribs.ifs\" (rib)", &paths), title("./ribs.ifs", "./parts/ribs.ifs"));
        assert_eq!(
            meant("use \"./parts/rib.ifs\" (a)", &paths),
            title("./parts/rib.ifs", "./parts/ribs.ifs")
        );
        assert_eq!(meant("use \"./parts/ribs\" (a)", &paths), title("./parts/ribs", "./parts/ribs.ifs"));
        let import =
            "ifs node on (a, b) {\n    transform t = self on (a, b)\n    germ import(\"./nod.glb\")\n}";
        assert_eq!(meant(import, &paths), title("./nod.glb", "./node.glb"));
        assert_eq!(meant("use \"./something/else.ifs\" (a)", &paths), Vec::<String>::new());
        assert_eq!(
            meant("use \"./ribs.ifs\" (a)", &["a/ribs.ifs", "b/ribs.ifs"]).len(),
            2,
            "which of the two?"
        );
    }
}
