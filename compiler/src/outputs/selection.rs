//! Which outputs of which boards are wanted.

use crate::analysis::{Analysis, Elements};
use crate::fabricate::label::Label;

/// A kind of output that can be asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Format {
    /// `model.glb`
    Glb,
    /// `boards/*.nc`, `sheets/*.nc`
    Nc,
    /// `boards/*.dxf`, `sheets/*.dxf`
    Dxf,
    /// `model.btlx`
    Btlx,
    /// `cutlist.csv`, `assembly.csv`, `planarity.csv`
    Csv,
    /// `labels.svg`
    Svg,
    /// `report.html`
    Html,
    /// `report.json`
    Json,
}

impl Format {
    /// All of them, in the order in which they are made.
    pub const ALL: [Format; 8] = [
        Format::Glb,
        Format::Nc,
        Format::Dxf,
        Format::Btlx,
        Format::Csv,
        Format::Svg,
        Format::Html,
        Format::Json,
    ];

    /// As it is asked for.
    pub fn name(self) -> &'static str {
        match self {
            Format::Glb => "glb",
            Format::Nc => "nc",
            Format::Dxf => "dxf",
            Format::Btlx => "btlx",
            Format::Csv => "csv",
            Format::Svg => "svg",
            Format::Html => "html",
            Format::Json => "json",
        }
    }
}

/// Which outputs of which boards are wanted. What is made for each board, the lists and the labels are limited to the
/// boards that are wanted; the model, the report and the planarity of a surface are always of the whole design.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Selection {
    /// The outputs that are made.
    pub formats: Vec<Format>,
    /// Patterns of which one must match the address or the alias of a board; all boards where there are none. `*` stands
    /// for any characters, `?` for one.
    pub only: Vec<String>,
}

impl Selection {
    /// Everything.
    pub fn all() -> Selection {
        Selection { formats: Format::ALL.to_vec(), only: Vec::new() }
    }

    /// Only these outputs, of all boards.
    pub fn of(formats: &[Format]) -> Selection {
        Selection { formats: formats.to_vec(), only: Vec::new() }
    }

    /// Whether an output is wanted.
    pub fn makes(&self, format: Format) -> bool {
        self.formats.contains(&format)
    }

    /// Whether a board is wanted.
    pub fn takes(&self, address: &str, alias: &str) -> bool {
        let fits = |pattern: &String| matches(pattern, address) || matches(pattern, alias);
        self.only.is_empty() || self.only.iter().any(fits)
    }

    /// The first pattern that no board of the design matches.
    pub fn without_boards(&self, analysis: &Analysis) -> Option<&str> {
        let labels = labels(analysis);
        let unmatched = |pattern: &&String| {
            !labels.iter().any(|label| matches(pattern, &label.address) || matches(pattern, &label.alias))
        };
        self.only.iter().find(unmatched).map(String::as_str)
    }

    /// What a build with this selection leaves out.
    pub fn left_out(&self, analysis: &Analysis) -> LeftOut {
        let formats = Format::ALL.into_iter().filter(|format| !self.makes(*format));
        let labels = labels(analysis);
        let boards = labels.iter().filter(|label| !self.takes(&label.address, &label.alias)).count();
        LeftOut { formats: formats.map(Format::name).collect(), only: self.only.clone(), boards }
    }
}

/// What a build did not make though the design has it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LeftOut {
    /// The outputs, by their names.
    pub formats: Vec<&'static str>,
    /// The patterns that boards had to match; none where all were taken.
    pub only: Vec<String>,
    /// How many boards and planks matched none.
    pub boards: usize,
}

/// The names of all boards and planks, also of those that cannot be made.
pub(super) fn labels(analysis: &Analysis) -> Vec<&Label> {
    let mut labels = Vec::new();
    for made in &analysis.fabrications {
        match &made.elements {
            Elements::Panels(panels) => {
                labels.extend(panels.panels.iter().map(|panel| &panel.label));
                labels.extend(panels.refused.iter().map(|refused| &refused.label));
            }
            Elements::Planks(planks) => {
                labels.extend(planks.planks.iter().map(|plank| &plank.label));
                labels.extend(planks.refused.iter().map(|refused| &refused.label));
            }
        }
    }
    labels
}

/// Whether a pattern fits a whole name. Where it does not fit on, the last `*` takes one more character, so it takes at
/// most the product of both lengths of steps.
fn matches(pattern: &str, name: &str) -> bool {
    let (pattern, name): (Vec<char>, Vec<char>) = (pattern.chars().collect(), name.chars().collect());
    let (mut p, mut n) = (0, 0);
    let mut star: Option<(usize, usize)> = None;
    while n < name.len() {
        match pattern.get(p) {
            Some('*') => {
                star = Some((p, n));
                p += 1;
            }
            Some(&c) if c == '?' || c == name[n] => (p, n) = (p + 1, n + 1),
            _ => match star {
                Some((at, taken)) => {
                    star = Some((at, taken + 1));
                    (p, n) = (at + 1, taken + 1);
                }
                None => return false,
            },
        }
    }
    pattern[p..].iter().all(|&c| c == '*')
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn patterns_fit_whole_names() {
        for (pattern, name, fits) in [
            ("shell.0.left", "shell.0.left", true),
            ("shell.0", "shell.0.left", false),
            ("shell.*", "shell.0.left", true),
            ("*left", "shell.0.left", true),
            ("*.?.*", "shell.0.left", true),
            ("s*l*t", "shell.0.left", true),
            ("*", "", true),
            ("", "", true),
            ("", "a", false),
            ("?", "", false),
            ("a*b*c", "abcbd", false),
            ("?", "ü", true),
        ] {
            assert_eq!(matches(pattern, name), fits, "{pattern} {name}");
        }
    }

    /// The definition, word for word.
    fn slow(pattern: &[char], name: &[char]) -> bool {
        match pattern.split_first() {
            None => name.is_empty(),
            Some(('*', rest)) => (0..=name.len()).any(|taken| slow(rest, &name[taken..])),
            Some((c, rest)) => {
                name.split_first().is_some_and(|(first, name)| (*c == '?' || c == first) && slow(rest, name))
            }
        }
    }

    proptest! {
        #[test]
        fn as_the_definition_says(pattern in "[ab*?]{0,8}", name in "[ab]{0,8}") {
            let chars = |text: &str| text.chars().collect::<Vec<_>>();
            prop_assert_eq!(matches(&pattern, &name), slow(&chars(&pattern), &chars(&name)));
        }
    }
}
