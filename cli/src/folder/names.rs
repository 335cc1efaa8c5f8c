//! Names in the output folder: which are allowed.

use ifs_compiler::outputs::names::check_segment;

use super::FolderError;

/// The list of files, written last and never by a caller.
pub(super) const MANIFEST: &str = "manifest.json";

/// Checks a relative name: segments of `[a-z0-9._-]` joined by `/`.
pub(super) fn check_relative(name: &str) -> Result<(), FolderError> {
    let refuse = |reason| Err(FolderError::BadName { name: name.to_owned(), reason });
    if name == MANIFEST {
        return refuse("it is written by the folder itself");
    }
    for segment in name.split('/') {
        if let Err(reason) = check_segment(segment) {
            return refuse(reason);
        }
    }
    Ok(())
}

/// Checks the name of a source as it stands in the manifest: relative, with `/`, and without a way out.
pub(super) fn check_source(name: &str) -> Result<(), FolderError> {
    let refuse = |reason| Err(FolderError::BadName { name: name.to_owned(), reason });
    if name.starts_with('/') || name.contains('\\') || name.as_bytes().get(1) == Some(&b':') {
        return refuse("a source is named relative to the project, with `/`");
    }
    if name.split('/').any(|segment| segment.is_empty() || segment == "." || segment == "..") {
        return refuse("a source lies inside the project");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ways_out_are_refused() {
        for name in [
            "",
            "/",
            "/etc/passwd",
            "..",
            "../x",
            "a/../b",
            "a//b",
            "a/",
            "./a",
            "a\\b",
            "c:/x",
            "A",
            "é",
            "a\n",
            "manifest.json",
            "aux.csv",
            "boards/com1.nc",
            ".hidden",
            "x.",
        ] {
            assert!(check_relative(name).is_err(), "{name:?}");
        }
        for name in ["a", "boards/shell.0-1.left.nc", "model.glb", "con1", "com10", "auxiliary.csv"] {
            assert!(check_relative(name).is_ok(), "{name:?}");
        }
    }

    #[test]
    fn sources_are_relative() {
        for name in ["/a.ifs", "../a.ifs", "c:\\a.ifs", "c:/a.ifs", "", "a//b", "./a.ifs"] {
            assert!(check_source(name).is_err(), "{name:?}");
        }
        for name in ["Schale.ifs", "ribs/é rib.ifs", "std/curves.ifs"] {
            assert!(check_source(name).is_ok(), "{name:?}");
        }
    }
}
