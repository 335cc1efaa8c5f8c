//! Documents by their URIs and by their paths.

use std::path::{Path, PathBuf};

use tower_lsp::ls_types::Uri;

/// The path of a document, without links where it lies on disk. One that lies nowhere (`untitled:`) goes by the text of
/// its URI.
pub(crate) fn path_of(uri: &Uri) -> PathBuf {
    let scheme = uri.scheme().as_str();
    let file = scheme.eq_ignore_ascii_case("file").then(|| uri.to_file_path()).flatten();
    let Some(path) = file.filter(|path| path.is_absolute()) else {
        return PathBuf::from(uri.as_str());
    };
    without_links(&path)
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

/// The URI of a path.
pub(crate) fn uri_of(path: &Path) -> Option<Uri> {
    if path.is_absolute() { Uri::from_file_path(path) } else { path.to_str()?.parse().ok() }
}
