//! Names of the project by some of their letters.

use ifs_compiler::syntax::ast;

use super::symbols::{Symbol, SymbolKind, symbols};

/// A symbol, what it is a part of, and how well its name fits: the less the better.
pub(crate) struct Found {
    pub(crate) symbol: Symbol,
    pub(crate) container: Option<String>,
    pub(crate) rank: usize,
}

/// The symbols of a file whose names have the letters of the query in their order.
pub(crate) fn search(file: &ast::File, query: &str) -> Vec<Found> {
    let mut found = Vec::new();
    for symbol in symbols(file) {
        // Words of the language that every block has are no names of the project.
        let named = |part: &&Symbol| !matches!(part.kind, SymbolKind::Setting | SymbolKind::Requirement);
        for part in symbol.parts.iter().filter(named) {
            if let Some(rank) = rank(&part.name, query) {
                let container = Some(symbol.name.clone());
                // What belongs to something comes after what stands for itself.
                found.push(Found { symbol: part.clone(), container, rank: rank + 1 });
            }
        }
        if let Some(rank) = rank(&symbol.name, query) {
            found.push(Found { symbol, container: None, rank });
        }
    }
    found
}

/// How well a name fits: whole, at its start, inside, scattered; `None` where it has not all letters.
fn rank(name: &str, query: &str) -> Option<usize> {
    let (name, query) = (name.to_lowercase(), query.to_lowercase());
    if name == query {
        return Some(0);
    }
    match name.find(&query) {
        Some(0) => return Some(2),
        Some(_) => return Some(4),
        None => {}
    }
    has_letters(&name, &query).then_some(6)
}

/// Whether a name has these letters in their order, large or small, as clients look for them.
pub(crate) fn has_letters(name: &str, query: &str) -> bool {
    let mut letters = name.chars().flat_map(char::to_lowercase);
    query.chars().flat_map(char::to_lowercase).all(|wanted| letters.any(|letter| letter == wanted))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::features::fixture::fixture;

    #[test]
    fn letters_in_their_order() {
        let design = fixture(
            "let shell_width = 1\nifs shell on (a, b) {\n    transform left = self on (a, b)\n    germ segment(a, b)\n}\nfabricate shell as panels {\n    material: birch\n}\nfigure = ",
        );
        let names = |query: &str| {
            let mut found = search(&design.analysis.files[0].parse.ast, query);
            found.sort_by_key(|found| found.rank);
            found.into_iter().map(|found| found.symbol.name).collect::<Vec<_>>().join(" ")
        };
        assert_eq!(names("shell"), "shell shell_width fabricate shell");
        assert_eq!(names("material"), "");
        assert_eq!(names("shw"), "shell_width");
        assert_eq!(names("LEFT"), "left");
        assert_eq!(names("xyz"), "");
        assert_eq!(names(""), "shell_width shell fabricate shell left");
    }
}
