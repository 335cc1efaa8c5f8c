//! Imports go one way: which room of a crate may use which, and how the sources are read for it.

use std::collections::BTreeSet;
use std::path::Path;

/// The rooms of the compiler, each with those it may import. A room stands below all that it imports.
pub const ROOMS: &[(&str, &[&str])] = &[
    ("exact", &[]),
    ("source", &[]),
    ("geometry", &[]),
    ("gltf", &[]),
    ("nest", &[]),
    ("diagnostic", &["source"]),
    ("syntax", &["source", "diagnostic", "exact"]),
    ("ifs", &["exact"]),
    ("hir", &["syntax", "ifs", "exact", "diagnostic", "source"]),
    ("plan", &["hir", "ifs", "geometry", "exact", "diagnostic", "source"]),
    ("planarize", &["geometry"]),
    ("fabricate", &["geometry", "planarize", "plan", "diagnostic", "source", "exact"]),
    ("export", &["fabricate", "geometry", "nest", "planarize", "plan"]),
    ("readback", &["fabricate"]),
    ("verify", &["readback", "fabricate"]),
    (
        "analysis",
        &[
            "exact",
            "source",
            "geometry",
            "gltf",
            "diagnostic",
            "syntax",
            "ifs",
            "hir",
            "plan",
            "planarize",
            "fabricate",
            "nest",
        ],
    ),
    (
        "outputs",
        &[
            "analysis",
            "diagnostic",
            "export",
            "fabricate",
            "geometry",
            "hir",
            "nest",
            "plan",
            "planarize",
            "readback",
            "source",
            "syntax",
        ],
    ),
];

/// The rooms of the language server, as those of the compiler.
pub const SERVER_ROOMS: &[(&str, &[&str])] = &[
    ("features", &[]),
    ("world", &[]),
    ("protocol", &["world"]),
    ("transport", &["protocol"]),
    ("server", &["protocol", "features", "world"]),
];

/// A crate and what its sources are held to.
#[derive(Clone, Copy, Debug)]
pub struct House {
    /// Its sources, from the root of the tree.
    pub sources: &'static str,
    /// Its rooms, each with those it may import. A room stands below all that it imports.
    pub rooms: &'static [(&'static str, &'static [&'static str])],
    /// Crates behind a seam, each with the rooms that may know it.
    pub seams: &'static [(&'static str, &'static [&'static str])],
}

/// The compiler.
pub const COMPILER: House = House {
    sources: "compiler/src",
    rooms: ROOMS,
    seams: &[
        ("logos", &["syntax"]),
        ("chumsky", &["syntax"]),
        ("ariadne", &["diagnostic"]),
        ("gltf_json", &["export"]),
        ("qrcode", &["export"]),
        ("toml", &["analysis"]),
    ],
};

/// The language server: what an editor can ask knows neither the protocol nor the documents, and the documents know no
/// protocol.
pub const SERVER: House = House {
    sources: "lsp/src",
    rooms: SERVER_ROOMS,
    seams: &[
        ("tower_lsp", &["protocol", "server", "transport"]),
        ("serde_json", &["protocol", "server", "transport"]),
        ("tokio", &["world", "server", "transport"]),
        ("tower_service", &["transport"]),
        ("futures_util", &["transport"]),
        ("rustix", &["server"]),
    ],
};

/// What a source file imports that it may not; `path` is relative to the sources of its crate. Code of tests is not looked
/// at, and the crate's root belongs to no room.
pub fn faults(house: House, path: &Path, text: &str) -> Vec<String> {
    let parts: Vec<String> = path.iter().map(|part| part.to_string_lossy().into_owned()).collect();
    if parts == ["lib.rs"] || parts.iter().any(|part| part == "tests" || part == "tests.rs") {
        return Vec::new();
    }
    let room = parts[0].trim_end_matches(".rs").to_owned();
    let Some((_, allowed)) = house.rooms.iter().find(|(name, _)| *name == room) else {
        return vec![format!("the room {room} is not in the table of rooms")];
    };
    let file = parts.last().is_some_and(|name| name == "mod.rs");
    let depth = parts.len() - usize::from(file);
    let code = code_of(text);
    let mut faults = Vec::new();
    for used in rooms_used(&code, depth) {
        if used != room && !allowed.contains(&used.as_str()) {
            faults.push(format!("{room} imports {used}"));
        }
    }
    for (name, homes) in house.seams {
        if !homes.contains(&room.as_str()) && words(&code).windows(2).any(|pair| pair == [*name, "::"]) {
            faults.push(format!("{room} uses {name}, which only {} knows", homes.join(" or ")));
        }
    }
    faults
}

/// The text without comments and without the modules of tests.
fn code_of(text: &str) -> String {
    let mut code = String::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if line.trim() == "#[cfg(test)]" {
            // The item that follows, to the line that closes it at the same indentation.
            let indent = line.len() - line.trim_start().len();
            for line in lines.by_ref() {
                let closes = line.len() - line.trim_start().len() == indent && !line.trim().starts_with("#[");
                let ends = line.trim_end().ends_with([';', '}']);
                if closes && ends {
                    break;
                }
            }
            continue;
        }
        code.push_str(line.split("//").next().unwrap_or_default());
        code.push('\n');
    }
    code
}

/// The first segments after the crate's root in all paths: after `crate::`, in `crate::{…}`, and after as many
/// `super::` as lead out of the room.
fn rooms_used(code: &str, depth: usize) -> BTreeSet<String> {
    let words = words(code);
    let mut used = BTreeSet::new();
    for (index, word) in words.iter().enumerate() {
        let begins = index == 0 || words[index - 1] != "::";
        let after = match *word {
            "crate" if words.get(index + 1) == Some(&"::") => index + 2,
            "super" if begins => {
                let run = words[index..].chunks(2).take_while(|pair| *pair == ["super", "::"]).count();
                if run < depth {
                    continue;
                }
                index + 2 * depth
            }
            _ => continue,
        };
        match words.get(after) {
            Some(&"{") => used.extend(heads_of_group(&words[after + 1..])),
            Some(room) => {
                used.insert((*room).to_owned());
            }
            None => {}
        }
    }
    used
}

/// The first segment of each path in `{a::b, c::{d, e}, f}`, given what follows the first brace.
fn heads_of_group(words: &[&str]) -> Vec<String> {
    let (mut heads, mut nesting, mut begins) = (Vec::new(), 0, true);
    for word in words {
        match *word {
            "{" => nesting += 1,
            "}" if nesting == 0 => break,
            "}" => nesting -= 1,
            "," if nesting == 0 => {
                begins = true;
                continue;
            }
            name if begins && nesting == 0 => heads.push(name.to_owned()),
            _ => {}
        }
        begins = false;
    }
    heads
}

/// The words and signs of a text; `::` is one sign.
fn words(code: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let mut rest = code.trim_start();
    while let Some(first) = rest.chars().next() {
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        let length = if rest.starts_with("::") {
            2
        } else if is_word(first) {
            rest.find(|c| !is_word(c)).unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        words.push(&rest[..length]);
        rest = rest[length..].trim_start();
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(path: &str, text: &str) -> Vec<String> {
        faults(COMPILER, Path::new(path), text)
    }

    #[test]
    fn a_room_is_below_all_it_imports() {
        for rooms in [COMPILER.rooms, SERVER.rooms] {
            for (index, (room, imports)) in rooms.iter().enumerate() {
                for import in *imports {
                    assert!(rooms[..index].iter().any(|(name, _)| name == import), "{room} imports {import}");
                }
            }
        }
    }

    #[test]
    fn features_know_no_protocol() {
        let found = |text| faults(SERVER, Path::new("features/hover.rs"), text);
        assert_eq!(
            found("use tower_lsp::ls_types::Hover;"),
            ["features uses tower_lsp, which only protocol or server or transport knows"]
        );
        assert_eq!(found("use crate::world::Snapshot;"), ["features imports world"]);
        assert!(found("use super::words::written;\nuse ifs_compiler::analysis::Analysis;").is_empty());
    }

    #[test]
    fn imports_are_found_however_they_are_written() {
        for text in [
            "use crate::hir::Module;",
            "use crate::{exact::Rational, hir::{Module, Type}};",
            "fn f(x: crate::hir::Type) {}",
            "use crate :: hir;",
            "pub use super::super::hir;",
            "use crate::{\n    exact,\n    hir,\n};",
        ] {
            assert_eq!(found("syntax/parser.rs", text), ["syntax imports hir"], "{text}");
        }
        assert_eq!(found("syntax/mod.rs", "use super::hir;"), ["syntax imports hir"]);
        assert_eq!(found("syntax/items/mod.rs", "use super::super::hir;"), ["syntax imports hir"]);
        assert_eq!(found("new/mod.rs", ""), ["the room new is not in the table of rooms"]);
        assert_eq!(
            found("hir/mod.rs", "use chumsky::Parser;"),
            ["hir uses chumsky, which only syntax knows"]
        );
    }

    #[test]
    fn what_is_allowed_is_not_a_fault() {
        for text in [
            "use crate::{exact::{hir, plan}, source};",
            "use super::hir;",
            "use self::hir::x;",
            "//! See [`crate::hir`].\n/// Or crate::hir.\nfn f() {} // crate::hir",
            "use crate::syntax::hir;",
            "#[cfg(test)]\nmod tests {\n    use crate::hir::x;\n}\n",
            "#[cfg(test)]\nmod tests;\n",
            "#[cfg(test)]\n#[allow(x)]\nmod tests {\n    fn f() {\n    }\n    use crate::hir;\n}\n",
        ] {
            assert_eq!(found("syntax/parser.rs", text), Vec::<String>::new(), "{text}");
        }
        assert!(found("syntax/tests.rs", "use crate::hir;").is_empty());
        assert!(found("outputs.rs", "use crate::{hir, export};").is_empty());
        let after = "#[cfg(test)]\nmod tests {\n}\nuse crate::hir;";
        assert_eq!(found("syntax/parser.rs", after), ["syntax imports hir"]);
    }
}
