//! The meaning of an `ifs.toml`: what it sets for the designs of its folder, and what is wrong with it. Finding and
//! reading the file is the caller's work.

use crate::diagnostic::{Code, Diagnostic, closest};
use crate::hir::evaluate::MachineName;
use crate::hir::tree::{Hir, ItemKind};
use crate::source::{FileId, Span};
use std::collections::BTreeMap;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The keys there are.
const KEYS: &[&str] = &["out", "machine", "params"];

/// What an `ifs.toml` sets. Each value comes with its place.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ProjectSettings {
    /// The folder, relative to that of the `ifs.toml`, in which each design has its output folder. It stays inside.
    pub out: Option<(String, Span)>,
    /// The machine that cuts all designs, with its file relative to the folder of the `ifs.toml`.
    pub machine: Option<(MachineName, Span)>,
    /// Values of parameters by name, as the language writes them. A design takes those it has.
    pub parameters: BTreeMap<String, (String, Span)>,
}

/// Reads the text of an `ifs.toml`. Never fails: what is wrong is said, and left out.
pub fn read_project(file: FileId, text: &str) -> (ProjectSettings, Vec<Diagnostic>) {
    let mut reader = Reader { file, settings: ProjectSettings::default(), diagnostics: Vec::new() };
    let (table, errors) = DeTable::parse_recoverable(text);
    match errors.first() {
        // The first is what has to be mended; the others may follow from it.
        Some(error) => {
            let at = reader.at(error.span().unwrap_or(0..0));
            let message = format!("this is no TOML: {}", error.message().trim());
            let diagnostic = Diagnostic::new(Code::E0313, at, message).label("not understood");
            reader.diagnostics.push(diagnostic.hint("a line is a key, `=` and a value: `out = \"made\"`"));
        }
        None => reader.table(table.get_ref()),
    }
    // The table has its keys in the order of the alphabet.
    reader.diagnostics.sort_by_key(|found| found.span);
    (reader.settings, reader.diagnostics)
}

/// What is said of an `ifs.toml` that the system does not give, or that is no text.
pub fn unreadable_project(file: FileId, why: &str) -> Diagnostic {
    let message = format!("`ifs.toml` cannot be read: {why}");
    Diagnostic::new(Code::E0313, Span::new(file, 0, 0), message).hint("an empty file would do")
}

/// A warning for each parameter that is set under a name the design does not have, but nearly: another may have been
/// meant. Names that are like none of the design's are those of other designs of the project.
pub fn misspelt_parameters(settings: &ProjectSettings, hir: &Hir) -> Vec<Diagnostic> {
    let known: Vec<&str> = hir
        .own_items()
        .filter(|(_, item)| matches!(item.kind, ItemKind::Param(_)))
        .map(|(_, item)| item.name.as_str())
        .collect();
    let unknown = settings.parameters.iter().filter(|(name, _)| !known.contains(&name.as_str()));
    unknown
        .filter_map(|(name, (_, at))| {
            // One that is set under its own name is not meant by another.
            let unset = known.iter().copied().filter(|known| !settings.parameters.contains_key(*known));
            let meant = closest(name, unset)?;
            let message = format!("the design has no parameter `{name}`");
            let diagnostic = Diagnostic::new(Code::W0316, *at, message).label("not used by this design");
            Some(diagnostic.fix(format!("did you mean `{meant}`?"), *at, meant))
        })
        .collect()
}

struct Reader {
    file: FileId,
    settings: ProjectSettings,
    diagnostics: Vec<Diagnostic>,
}

impl Reader {
    fn at(&self, range: Range<usize>) -> Span {
        let byte = |at: usize| u32::try_from(at).unwrap_or(u32::MAX);
        Span::new(self.file, byte(range.start), byte(range.end))
    }

    fn table(&mut self, table: &DeTable<'_>) {
        for (key, value) in table {
            let at = self.at(key.span());
            match key.get_ref().as_ref() {
                "out" => self.out(value),
                "params" => self.parameters(value),
                "machine" => self.machine(value),
                other => self.unknown(other, at),
            }
        }
    }

    fn unknown(&mut self, key: &str, at: Span) {
        let message = format!("`ifs.toml` has no key `{}`", key.escape_debug());
        let diagnostic = Diagnostic::new(Code::E0314, at, message).label("not known");
        self.diagnostics.push(match closest(key, KEYS.iter().copied()) {
            Some(meant) => diagnostic.fix(format!("did you mean `{meant}`?"), at, meant),
            None => diagnostic
                .note(format!("the keys are {}", KEYS.join(", ")))
                .hint("a value of a parameter stands below the line `[params]`"),
        });
    }

    fn refuse(&mut self, at: Span, message: String, hint: &str) {
        let diagnostic = Diagnostic::new(Code::E0315, at, message).label("cannot be used");
        self.diagnostics.push(diagnostic.hint(hint));
    }

    fn out(&mut self, value: &Spanned<DeValue<'_>>) {
        let at = self.at(value.span());
        let hint = "name a folder of the project: `out = \"made\"`";
        let DeValue::String(text) = value.get_ref() else {
            self.refuse(at, "`out` is the name of a folder, a text".to_owned(), hint);
            return;
        };
        let drive = text.chars().nth(1) == Some(':');
        let leaves = text.split('/').any(|part| part == "..");
        let why = if text.trim().is_empty() {
            "is no name of a folder"
        } else if text.starts_with('/') || drive || leaves {
            "lies outside of the project"
        } else if text.contains('\\') {
            "parts its folders with `\\`: a path has `/` on every system"
        } else if text.chars().any(char::is_control) {
            "has a control character in it"
        } else {
            self.settings.out = Some((text.clone().into_owned(), at));
            return;
        };
        self.refuse(at, format!("the folder `{}` {why}", text.escape_debug()), hint);
    }

    fn machine(&mut self, value: &Spanned<DeValue<'_>>) {
        let at = self.at(value.span());
        let hint = "name a file of the project and a machine in it: `machine = \"machines.ifs:router\"`";
        let DeValue::String(text) = value.get_ref() else {
            self.refuse(at, "`machine` is the name of a machine, a text".to_owned(), hint);
            return;
        };
        match MachineName::split(text) {
            Some((file, name)) => {
                let whence = "`ifs.toml`".to_owned();
                let (file, name) = (file.to_owned(), name.to_owned());
                self.settings.machine = Some((MachineName { file, name, whence }, at));
            }
            None => {
                let message = format!("`{}` is no file and name", text.escape_debug());
                self.refuse(at, message, hint);
            }
        }
    }

    fn parameters(&mut self, value: &Spanned<DeValue<'_>>) {
        let hint = "write `[params]` on a line, and below it `span = \"7m\"`";
        let DeValue::Table(table) = value.get_ref() else {
            let at = self.at(value.span());
            self.refuse(at, "`params` is a table of parameters".to_owned(), hint);
            return;
        };
        for (name, value) in table {
            let text = match value.get_ref() {
                DeValue::String(text) => text.clone().into_owned(),
                DeValue::Integer(number) if number.radix() == 10 => number.as_str().to_owned(),
                DeValue::Float(number) => number.as_str().to_owned(),
                DeValue::Boolean(truth) => truth.to_string(),
                _ => {
                    let at = self.at(value.span());
                    let message =
                        format!("this is no value of a parameter `{}`", name.get_ref().escape_debug());
                    self.refuse(at, message, "write it as the language does, in quotes: `span = \"7m\"`");
                    continue;
                }
            };
            let at = self.at(name.span());
            self.settings.parameters.insert(name.get_ref().clone().into_owned(), (text, at));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> (ProjectSettings, Vec<(Code, String)>) {
        let (settings, found) = read_project(FileId(0), text);
        let said = found
            .into_iter()
            .map(|found| (found.code, text.get(found.span.range()).unwrap_or("").to_owned()))
            .collect();
        (settings, said)
    }

    #[test]
    fn what_a_project_sets() {
        let (settings, said) =
            read("out = \"made/here\"\n[params]\nspan = \"7m\"\ncount = 3\nt = 0.46\nclosed = true\n");
        assert!(said.is_empty(), "{said:?}");
        assert_eq!(settings.out.unwrap().0, "made/here");
        let values: Vec<(&str, &str)> =
            settings.parameters.iter().map(|(name, (value, _))| (name.as_str(), value.as_str())).collect();
        assert_eq!(values, [("closed", "true"), ("count", "3"), ("span", "7m"), ("t", "0.46")]);
        assert_eq!(read(""), (ProjectSettings::default(), Vec::new()));
    }

    #[test]
    fn a_text_that_is_no_toml() {
        for text in
            ["out = ", "out = \"made\nx", "[params\n", "out = \"a\"\nout = \"b\"\n", "\u{1}", "a = [[[["]
        {
            let (_, said) = read(text);
            assert_eq!(said.len(), 1, "{text:?}: {said:?}");
            assert_eq!(said[0].0, Code::E0313);
        }
        let deep = format!("a = {}", "[".repeat(1_000_000));
        assert_eq!(read(&deep).1[0].0, Code::E0313);
    }

    #[test]
    fn an_unknown_key_stands_where_it_is_written() {
        let (_, found) = read_project(FileId(0), "span = \"7m\"\noutt = \"made\"\n");
        assert_eq!(found.len(), 2);
        assert!(found.iter().all(|found| found.code == Code::E0314));
        assert_eq!((found[0].span.start, found[0].span.end), (0, 4));
        assert_eq!(found[1].hints[0].text, "did you mean `out`?");
    }

    #[test]
    fn a_machine_is_a_file_and_a_name() {
        let (settings, said) = read("machine = \"shop/machines.ifs:router\"\n");
        assert!(said.is_empty(), "{said:?}");
        let (machine, _) = settings.machine.unwrap();
        assert_eq!((machine.file.as_str(), machine.name.as_str()), ("shop/machines.ifs", "router"));
        for machine in ["3", "\"router3\"", "\":router\"", "\"machines.ifs:\""] {
            let (settings, said) = read(&format!("machine = {machine}\n"));
            assert_eq!((settings.machine, said.as_slice()), (None, &[(Code::E0315, machine.to_owned())][..]));
        }
    }

    #[test]
    fn a_value_that_cannot_be_used() {
        for out in ["3", "\"\"", "\"/etc\"", "\"../up\"", "\"a/../..\"", "'c:/x'", "'a\\b'"] {
            let (settings, said) = read(&format!("out = {out}\n"));
            assert_eq!((settings.out, said.as_slice()), (None, &[(Code::E0315, out.to_owned())][..]));
        }
        assert_eq!(read("params = 3\n").1, [(Code::E0315, "3".to_owned())]);
        assert_eq!(read("[params]\nspan = [1]\n").1, [(Code::E0315, "[1]".to_owned())]);
        assert_eq!(read("[params]\nday = 2026-01-01\n").1, [(Code::E0315, "2026-01-01".to_owned())]);
    }
}
