//! Random designs out of bytes: grammatical, mostly well-typed, and of every form the language has. For property tests
//! and for the fuzz targets, whose bytes are the source of the choices; no bytes give the simplest design.

mod choices;
mod expressions;
mod fabricate;
mod figures;
mod functions;
mod ifs;
mod points;
mod scope;
mod words;

use choices::Choices;
use scope::Scope;

/// The most items of a design; beside them stand the imports.
const MOST_ITEMS: usize = 12;

/// A design made of these bytes.
pub fn design(bytes: &[u8]) -> String {
    let mut writer = Writer { choices: Choices::new(bytes), scope: Scope::default(), fresh: 0, deep: 0 };
    let mut text = words::IMPORTS.concat();
    for _ in 0..=writer.choices.below(MOST_ITEMS) {
        text.push_str(&writer.item());
        text.push('\n');
        if writer.choices.is_empty() {
            break;
        }
    }
    text.push_str(&writer.figure());
    if writer.choices.chance(3) {
        text.push_str(&writer.fabricate());
    }
    text
}

/// Writes one design.
struct Writer<'a> {
    choices: Choices<'a>,
    scope: Scope,
    /// How many names were made up.
    fresh: usize,
    /// How deep the expression is in others.
    deep: usize,
}

impl Writer<'_> {
    fn item(&mut self) -> String {
        match self.choices.below(12) {
            0 | 1 => self.named_value(),
            2 => self.parameter(),
            3 => self.function(),
            4 => self.record(),
            5..=7 => self.ifs(),
            8 | 9 => self.figure(),
            10 => self.fabricate(),
            _ => self.test(),
        }
    }

    /// A name of its own, most of the time.
    fn name(&mut self, stem: &str) -> String {
        self.fresh += 1;
        if self.choices.rarely() { stem.to_owned() } else { format!("{stem}{}", self.fresh) }
    }

    /// Some pieces with commas between.
    fn list(&mut self, count: usize, mut piece: impl FnMut(&mut Self) -> String) -> String {
        let pieces: Vec<String> = (0..count).map(|_| piece(self)).collect();
        pieces.join(", ")
    }
}
