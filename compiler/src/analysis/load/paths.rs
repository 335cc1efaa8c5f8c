//! Paths as `use` writes them: from the file they stand in to the root of the project, by the letters alone.

/// Why a written path leads to no file of the project.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum PathFault {
    /// Nothing is written, or it ends with `/`.
    NoFile,
    /// Folders are parted by `\`.
    Backslash,
    /// It starts at the root of the system, or of a drive.
    Absolute,
    /// It holds a control character.
    Control,
    /// More `..` than there are folders in the project.
    Outside,
}

/// The path from the root of the project that `written` in the file `from` leads to, without `.` and `..`.
pub(super) fn path(from: &str, written: &str) -> Result<String, PathFault> {
    if written.contains('\\') {
        return Err(PathFault::Backslash);
    }
    if written.chars().any(char::is_control) {
        return Err(PathFault::Control);
    }
    if written.starts_with('/') || written.chars().nth(1) == Some(':') {
        return Err(PathFault::Absolute);
    }
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    let mut last = "";
    for part in written.split('/') {
        last = part;
        match part {
            "" | "." => {}
            ".." => {
                parts.pop().ok_or(PathFault::Outside)?;
            }
            name => parts.push(name),
        }
    }
    if matches!(last, "" | "." | "..") {
        return Err(PathFault::NoFile);
    }
    Ok(parts.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_start_at_the_file_they_stand_in() {
        for (from, written, found) in [
            ("vault.ifs", "./ribs.ifs", "ribs.ifs"),
            ("vault.ifs", "ribs.ifs", "ribs.ifs"),
            ("vault.ifs", "parts//ribs.ifs", "parts/ribs.ifs"),
            ("a/b/vault.ifs", "../ribs.ifs", "a/ribs.ifs"),
            ("a/b/vault.ifs", "./c/../../ribs.ifs", "a/ribs.ifs"),
            ("a/vault.ifs", "../b.ifs", "b.ifs"),
        ] {
            assert_eq!(path(from, written).as_deref(), Ok(found), "{written} in {from}");
        }
    }

    #[test]
    fn paths_that_lead_nowhere() {
        for (written, fault) in [
            ("", PathFault::NoFile),
            ("./", PathFault::NoFile),
            ("parts/..", PathFault::NoFile),
            ("..", PathFault::Outside),
            ("../ribs.ifs", PathFault::Outside),
            ("a/../../ribs.ifs", PathFault::Outside),
            ("/etc/ribs.ifs", PathFault::Absolute),
            ("c:/ribs.ifs", PathFault::Absolute),
            (".\\ribs.ifs", PathFault::Backslash),
            ("ribs\0.ifs", PathFault::Control),
        ] {
            assert_eq!(path("vault.ifs", written), Err(fault), "{written:?}");
        }
    }
}
