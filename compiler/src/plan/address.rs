//! Addresses: the word of each element, and its short alias (OUTPUTS 2).
//!
//! An address is `figure[.index][.row-column of its window].word`; letters of a product are pairs `left-right`, u first,
//! with the side left empty that has fewer levels. An alias is `shell-07-12`, `vault-2-05`, `curve-05`.

use std::collections::BTreeMap;
use std::fmt;

use crate::ifs::{Automaton, StateId, Word};

use super::budget::figure_count;
use super::evaluate::PieceElement;
use super::figure::{FigurePlan, Shape, SheetPlan};

/// Where an element stands in its figure, independent of evaluation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Address {
    /// The figure's name.
    pub figure: String,
    /// Its place in a list of figures.
    pub index: Option<u32>,
    /// Row and column of the window, for a sheet of windows.
    pub window: Option<(u64, u64)>,
    /// The letters: `left`, `branch.0`, or pairs `left-right`.
    pub word: Vec<String>,
    /// The short name, unique in the design, that is engraved.
    pub alias: String,
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.figure)?;
        if let Some(index) = self.index {
            write!(f, ".{index}")?;
        }
        if let Some((row, column)) = self.window {
            write!(f, ".{row}-{column}")?;
        }
        self.word.iter().try_for_each(|letter| write!(f, ".{letter}"))
    }
}

/// The words of a chain's elements in chain order, from the counts of its pieces.
pub struct ChainWords<'a> {
    automaton: &'a Automaton,
    state: StateId,
    /// Elements by level and state, for the states reachable.
    counts: Vec<BTreeMap<StateId, u64>>,
}

impl<'a> ChainWords<'a> {
    /// Counts the pieces of `state` down from `level`, which must be within a budget ([`super::budget`]).
    ///
    /// # Panics
    /// When the state is not of this automaton.
    pub fn new(automaton: &'a Automaton, state: StateId, level: u32) -> ChainWords<'a> {
        let reachable = automaton.reachable(state);
        let mut counts: Vec<BTreeMap<StateId, u64>> = vec![reachable.iter().map(|id| (*id, 1)).collect()];
        for below in 0..level as usize {
            let count = |id: &StateId| {
                let targets = automaton.state(*id).transforms.iter().map(|transform| transform.target);
                (*id, targets.fold(0_u64, |total, target| total.saturating_add(counts[below][&target])))
            };
            let next = reachable.iter().map(count).collect();
            counts.push(next);
        }
        ChainWords { automaton, state, counts }
    }

    /// Elements of the chain.
    pub fn elements(&self) -> u64 {
        self.counts.last().map_or(0, |counts| counts[&self.state])
    }

    /// The word of element `element`; `None` beyond the last.
    pub fn word(&self, element: u64) -> Option<Word> {
        if element >= self.elements() {
            return None;
        }
        let (mut state, mut rest) = (self.state, element);
        let mut letters = Vec::with_capacity(self.counts.len() - 1);
        for counts in self.counts.iter().rev().skip(1) {
            let transforms = &self.automaton.state(state).transforms;
            let letter = transforms.iter().position(|transform| {
                let inside = rest < counts[&transform.target];
                if !inside {
                    rest -= counts[&transform.target];
                }
                inside
            })?;
            letters.push(letter);
            state = transforms[letter].target;
        }
        Some(Word { start: self.state, letters })
    }

    /// The names of the letters of element `element`, as `["left", "right"]`.
    pub fn names(&self, element: u64) -> Option<Vec<&'a str>> {
        Some(self.word(element)?.names(self.automaton))
    }
}

/// The addresses of one figure's elements.
pub struct FigureAddresses<'a> {
    figure: &'a FigurePlan,
    u: ChainWords<'a>,
    v: Option<(ChainWords<'a>, &'a SheetPlan)>,
    windows: (u64, u64),
    /// Elements of a figure of pieces.
    pieces: u64,
}

impl<'a> FigureAddresses<'a> {
    /// Prepares the addresses of a figure of a [`super::Plan`] on this automaton, within a budget.
    ///
    /// # Panics
    /// When its states are not of this automaton.
    pub fn new(automaton: &'a Automaton, figure: &'a FigurePlan) -> FigureAddresses<'a> {
        match &figure.shape {
            Shape::Curve { state, level, .. } => {
                let u = ChainWords::new(automaton, *state, *level);
                FigureAddresses { figure, u, v: None, windows: (1, 1), pieces: 0 }
            }
            Shape::Pieces(plan) => {
                let u = ChainWords::new(automaton, plan.state, 0);
                let pieces = figure_count(automaton, figure, u32::MAX).map_or(0, |count| count.elements);
                FigureAddresses { figure, u, v: None, windows: (1, 1), pieces }
            }
            Shape::Patchwork(patchwork) => {
                let u = ChainWords::new(automaton, patchwork.state, patchwork.level);
                FigureAddresses { figure, u, v: None, windows: (1, 1), pieces: 0 }
            }
            Shape::Sheet(sheet) => {
                let windows = |points: usize, state: StateId| {
                    (points + 1).saturating_sub(automaton.state(state).control_points) as u64
                };
                FigureAddresses {
                    figure,
                    u: ChainWords::new(automaton, sheet.u, sheet.levels.0),
                    v: Some((ChainWords::new(automaton, sheet.v, sheet.levels.1), sheet)),
                    windows: (windows(sheet.net_rows, sheet.u), windows(sheet.net_columns, sheet.v)),
                    pieces: 0,
                }
            }
        }
    }

    /// The address of a curve's segment, by its place along the chain, or of a patchwork's polygon, by its place in the
    /// order of words; `None` for a sheet or beyond the end.
    pub fn segment(&self, element: u64) -> Option<Address> {
        if !matches!(self.figure.shape, Shape::Curve { .. } | Shape::Patchwork(_)) {
            return None;
        }
        let word = self.u.names(element)?.into_iter().map(str::to_owned).collect();
        let width = digits(self.u.elements() - 1);
        Some(self.address(None, word, format!("-{element:0width$}")))
    }

    /// The address of a sheet's quad, by its row (along u) and column (along v) over the whole sheet; `None` for a curve
    /// or beyond the edges.
    pub fn quad(&self, row: u64, column: u64) -> Option<Address> {
        let (v, sheet) = self.v.as_ref()?;
        let size = (self.u.elements(), v.elements());
        let window = (row / size.0, column / size.1);
        if window.0 >= self.windows.0 || window.1 >= self.windows.1 {
            return None;
        }
        let word = pairs(&self.u.names(row % size.0)?, &v.names(column % size.1)?);
        let width = digits((self.windows.0 * size.0).max(self.windows.1 * size.1) - 1);
        let alias = format!("-{row:0width$}-{column:0width$}");
        Some(self.address(sheet.windows.then_some(window), word, alias))
    }

    /// The address of an element of separate pieces, as evaluation gives it, with its place in their order; `None` for
    /// other figures. Where a state keeps several germs, the second and further ones have a letter of their own:
    /// `keep-2`.
    pub fn piece(&self, place: u64, element: &PieceElement<'_>) -> Option<Address> {
        let Shape::Pieces(plan) = &self.figure.shape else { return None };
        let letters = Word { start: plan.state, letters: element.letters().collect() };
        let mut word: Vec<String> = letters.names(self.u.automaton).into_iter().map(str::to_owned).collect();
        word.extend(element.drawn.kept.filter(|kept| *kept > 0).map(|kept| format!("keep-{}", kept + 1)));
        let width = digits(self.pieces.saturating_sub(1));
        Some(self.address(None, word, format!("-{place:0width$}")))
    }

    fn address(&self, window: Option<(u64, u64)>, word: Vec<String>, place: String) -> Address {
        let (figure, index) = (self.figure.name.clone(), self.figure.index);
        let list = index.map_or(String::new(), |index| format!("-{index}"));
        let alias = format!("{figure}{list}{place}");
        Address { figure, index, window, word, alias }
    }
}

/// Digits of the largest number, at least 2.
fn digits(largest: u64) -> usize {
    largest.checked_ilog10().map_or(1, |log| log as usize + 1).max(2)
}

/// Letters of a product, u first; where one word is shorter its side stays empty.
fn pairs(u: &[&str], v: &[&str]) -> Vec<String> {
    let letter = |word: &[&str], place: usize| word.get(place).copied().unwrap_or("").to_owned();
    (0..u.len().max(v.len())).map(|place| format!("{}-{}", letter(u, place), letter(v, place))).collect()
}
