//! What is said of files that cannot be read.

use super::paths::PathFault;
use super::{MOST_BYTES, MOST_FILES};
use crate::diagnostic::{Code, Diagnostic};
use crate::gltf::{Fault, FaultKind};
use crate::source::{FileId, ReadError, Span};
use crate::syntax::ast::TextLiteral;

/// The design's own file cannot be read.
pub(in crate::analysis) fn unreadable_design(path: &str, error: &ReadError, file: FileId) -> Diagnostic {
    let message = format!("`{path}` cannot be read: {}", why(error));
    Diagnostic::new(Code::E0306, Span::new(file, 0, 0), message).hint("is the path right?")
}

/// A file that is used cannot be read; `path` is where it was looked for.
/// `ending` is that of such files.
pub(super) fn unreadable(written: &TextLiteral, path: &str, error: &ReadError, ending: &str) -> Diagnostic {
    let message = format!("`{path}` cannot be read: {}", why(error));
    let diagnostic = Diagnostic::new(Code::E0306, written.span, message);
    match error {
        ReadError::NotFound => diagnostic.label("no such file").hint(where_to_look(&written.value, ending)),
        ReadError::OutsideRoot => diagnostic.label("outside of the project").hint(INSIDE),
        ReadError::Other(_) => diagnostic.label("cannot be read"),
    }
}

/// What helps where there is no file at a path whose ending should be this one.
fn where_to_look(path: &str, ending: &str) -> String {
    let name = path.rsplit('/').next().unwrap_or(path);
    match (name.rsplit_once('.').map(|(_, is)| is), ending) {
        (Some(is), _) if is == ending => {
            "is the path right? It starts at the file in which it stands".to_owned()
        }
        (Some("ifs"), "glb") => used_not_imported(path),
        (Some("glb"), "ifs") => format!("a mesh is imported as a germ: `germ import(\"{path}\")`"),
        (Some(is), "glb") => format!("meshes are read as glTF binary, `.glb`, not `.{is}`"),
        (Some(is), _) => format!("designs have the ending `.{ending}`, not `.{is}`"),
        (None, _) => format!("the name of a file has its ending: `{path}.{ending}`"),
    }
}

fn used_not_imported(path: &str) -> String {
    format!("a design is no mesh: take an ifs of it with `use \"{path}\" (…)`")
}

const INSIDE: &str = "move the file into the project's folder; a project is the folder of the nearest `ifs.toml`, \
                      else the folder of the design";

pub(in crate::analysis) fn why(error: &ReadError) -> String {
    match error {
        ReadError::NotFound => "there is no such file".to_owned(),
        ReadError::OutsideRoot => "it lies outside of the project".to_owned(),
        ReadError::Other(why) => why.clone(),
    }
}

/// A path that leads to no file of the project; `example` is a path as it should be.
pub(super) fn no_path(written: &TextLiteral, fault: &PathFault, example: &str) -> Diagnostic {
    let shown: String = written
        .value
        .chars()
        .flat_map(|c| if c.is_control() { c.escape_debug().collect() } else { vec![c] })
        .collect();
    let refused = |why: &str| {
        let message = format!("`{shown}` {why}");
        Diagnostic::new(Code::E0310, written.span, message).label("not a path of the project")
    };
    match fault {
        PathFault::NoFile => refused("names no file").hint(format!("name one: `\"{example}\"`")),
        PathFault::Control => refused("has a control character in it").hint("remove it"),
        PathFault::Absolute => {
            let diagnostic = refused("starts at the root of the system, not in the project");
            diagnostic.hint(format!("write the path from the file in which it stands: `\"{example}\"`"))
        }
        PathFault::Backslash => {
            let path = written.value.replace('\\', "/");
            let diagnostic = refused("parts its folders with `\\`: a path has `/` on every system");
            diagnostic.fix(format!("write `\"{path}\"`"), written.span, format!("\"{path}\""))
        }
        PathFault::Outside => {
            let message = format!("`{shown}` cannot be read: it lies outside of the project");
            let diagnostic = Diagnostic::new(Code::E0306, written.span, message);
            diagnostic.label("outside of the project").hint(INSIDE)
        }
    }
}

/// A file that is not UTF-8 from the byte `at` on.
pub(in crate::analysis) fn no_text(file: FileId, at: usize, byte: u8) -> Diagnostic {
    let place = u32::try_from(at).unwrap_or(u32::MAX);
    let message = format!("the file is not UTF-8 text: byte {at} is 0x{byte:02x}");
    Diagnostic::new(Code::E0101, Span::new(file, place, place), message)
        .label("up to here it is text")
        .hint("save it as UTF-8; is it really a design?")
}

/// More files than the limit.
pub(super) fn too_many_files(written: &TextLiteral) -> Diagnostic {
    let message = format!("the design is made of more than {MOST_FILES} files");
    Diagnostic::new(Code::E0312, written.span, message)
        .label("one too many")
        .hint("put some of them together")
}

/// More bytes than the limit.
pub(super) fn too_many_bytes(written: &TextLiteral) -> Diagnostic {
    let limit = MOST_BYTES >> 20;
    let message = format!("the files of the design have more than {limit} MiB together");
    let hint = "a design is a text of some pages: leave out what it does not need";
    Diagnostic::new(Code::E0312, written.span, message).label("too much with this one").hint(hint)
}

/// A file that gives no mesh; `path` is where it lies.
pub(super) fn no_mesh(written: &TextLiteral, path: &str, fault: &Fault) -> Diagnostic {
    let (code, label) = match fault.kind {
        FaultKind::Malformed => (Code::E0556, "no mesh that can be read"),
        FaultKind::Unsupported => (Code::E0556, "not read"),
        FaultKind::Empty => (Code::E0556, "nothing to draw"),
        FaultKind::TooLarge => (Code::E0558, "too large"),
    };
    let message = format!("`{path}` at {}: {}", fault.place, fault.what);
    let diagnostic = Diagnostic::new(code, written.span, message).label(label);
    if path.ends_with(".ifs") {
        return diagnostic.hint(used_not_imported(&written.value));
    }
    diagnostic.hint(fault.mend)
}
