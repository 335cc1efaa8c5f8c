//! Documents by their URIs and by their paths.

use std::path::{Path, PathBuf};

use tower_lsp::ls_types::Uri;

use crate::world::names::Names;

/// The path of a document: the one it was opened with, else without links where it lies on disk. One that lies nowhere
/// (`untitled:`) goes by the text of its URI.
pub(crate) fn path_of(names: &Names, uri: &Uri) -> PathBuf {
    names.path(uri.as_str()).unwrap_or_else(|| path_on_disk(uri))
}

/// The same for a document that is just opened.
pub(crate) fn path_on_disk(uri: &Uri) -> PathBuf {
    let file = is_local_file(uri.as_str()).then(|| uri.to_file_path()).flatten();
    let Some(path) = file.filter(|path| path.is_absolute()) else {
        return PathBuf::from(uri.as_str());
    };
    without_links(&path)
}

/// Whether a URI names a file of this machine; `file://host/…` does not.
fn is_local_file(uri: &str) -> bool {
    let Some((scheme, rest)) = uri.split_once(':') else { return false };
    let here = !rest.starts_with("//") || rest.starts_with("///") || rest.starts_with("//localhost/");
    scheme.eq_ignore_ascii_case("file") && here
}

/// The path without links in it, as far as it exists.
fn without_links(path: &Path) -> PathBuf {
    if let Ok(real) = path.canonicalize() {
        return real;
    }
    match (path.parent().and_then(|parent| parent.canonicalize().ok()), path.file_name()) {
        (Some(parent), Some(name)) => parent.join(name),
        _ => path.to_owned(),
    }
}

/// The URI of a path, as the client calls it where it does.
pub(crate) fn uri_of(names: &Names, path: &Path) -> Option<Uri> {
    if let Some(name) = names.name(path).and_then(|name| name.parse().ok()) {
        return Some(name);
    }
    if path.is_absolute() { Uri::from_file_path(path) } else { path.to_str()?.parse().ok() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_and_uris_lead_to_each_other() {
        let names = Names::default();
        for (uri, path) in [
            ("file:///no/where/a%20b%25/dach%C3%BC.ifs", "/no/where/a b%/dachü.ifs"),
            ("file:///no/where/%F0%9F%8F%A0.ifs", "/no/where/🏠.ifs"),
            ("untitled:Untitled-1", "untitled:Untitled-1"),
            ("file://host/a.ifs", "file://host/a.ifs"),
        ] {
            let parsed: Uri = uri.parse().unwrap();
            assert_eq!(path_of(&names, &parsed), Path::new(path));
            let back = uri_of(&names, Path::new(path)).unwrap();
            assert_eq!(path_of(&names, &back), Path::new(path), "{back:?}");
        }
    }

    #[test]
    fn a_client_gets_its_own_name_back() {
        let names = Names::default();
        let uri: Uri = "file:///no/where/d%61ch.ifs".parse().unwrap();
        let path = path_on_disk(&uri);
        names.opened(uri.as_str(), &path);
        assert_eq!(path, Path::new("/no/where/dach.ifs"));
        assert_eq!(uri_of(&names, &path).unwrap().as_str(), uri.as_str());
        names.closed(uri.as_str());
        assert_eq!(uri_of(&names, &path).unwrap().as_str(), uri.as_str(), "it is told that nothing is wrong");
    }
}
