//! Addresses: the word of each element, and its short alias (OUTPUTS 2).
//!
//! An address is `figure[.index][.window].word`: the window of a chain is its number, that of a sheet its row and column;
//! letters of a product are pairs `left-right`, u first, with the side left empty that has fewer levels. Where a path
//! goes in plain steps (a revolution) the row is the step, and the letters are those of the profile alone. An alias is
//! `shell-07-12`, `vault-2-05`, `curve-05`.

use std::collections::BTreeMap;
use std::fmt;

use crate::ifs::{Automaton, StateId, Word};

use super::budget::figure_count;
use super::evaluate::PieceElement;
use super::figure::{FigurePlan, Shape};
use super::uses::StateUse;

/// Where an element stands in its figure, independent of evaluation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Address {
    /// The figure's name.
    pub figure: String,
    /// Its place in a list of figures.
    pub index: Option<u32>,
    /// The window, for a chain or a sheet of windows.
    pub window: Option<Window>,
    /// The letters: `left`, `branch.0`, or pairs `left-right`.
    pub word: Vec<String>,
    /// The short name, unique in the design, that is engraved.
    pub alias: String,
}

/// The window of the control points that an element belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Window {
    /// Its place along a chain.
    Place(u64),
    /// Its row and column on a net; the row may be a plain step of a path.
    RowColumn(u64, u64),
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.figure)?;
        if let Some(index) = self.index {
            write!(f, ".{index}")?;
        }
        match self.window {
            Some(Window::Place(place)) => write!(f, ".{place}")?,
            Some(Window::RowColumn(row, column)) => write!(f, ".{row}-{column}")?,
            None => {}
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
    automaton: &'a Automaton,
    figure: &'a FigurePlan,
    u: Direction<'a>,
    v: Option<Direction<'a>>,
    /// Whether addresses name windows.
    windows: bool,
    /// Elements of a figure of pieces.
    pieces: u64,
}

/// The elements along one direction: so many windows of the words of a chain, or plain steps.
struct Direction<'a> {
    windows: u64,
    words: Option<ChainWords<'a>>,
}

impl<'a> Direction<'a> {
    fn of(automaton: &'a Automaton, used: StateUse) -> Direction<'a> {
        let words = ChainWords::new(automaton, used.state, used.level);
        Direction { windows: used.windows(automaton) as u64, words: Some(words) }
    }

    fn steps(count: u32) -> Direction<'a> {
        Direction { windows: u64::from(count), words: None }
    }

    fn elements(&self) -> u64 {
        self.windows * self.words.as_ref().map_or(1, ChainWords::elements)
    }

    /// The window of an element and its letters there; `None` beyond the last.
    fn place(&self, element: u64) -> Option<(u64, Vec<&'a str>)> {
        let size = self.words.as_ref().map_or(1, ChainWords::elements);
        let (window, rest) = (element.checked_div(size)?, element.checked_rem(size)?);
        let letters = match &self.words {
            Some(words) => words.names(rest)?,
            None => Vec::new(),
        };
        (window < self.windows).then_some((window, letters))
    }
}

impl<'a> FigureAddresses<'a> {
    /// Prepares the addresses of a figure of a [`super::Plan`] on this automaton, within a budget.
    ///
    /// # Panics
    /// When its states are not of this automaton.
    pub fn new(automaton: &'a Automaton, figure: &'a FigurePlan) -> FigureAddresses<'a> {
        let mut uses = figure.shape.uses().into_iter().map(|used| Direction::of(automaton, used));
        let steps = match &figure.shape {
            Shape::Swept(swept) => swept.steps().map(Direction::steps),
            _ => None,
        };
        let windows = match &figure.shape {
            Shape::Curve { .. } | Shape::Pieces(_) | Shape::Patchwork(_) => false,
            Shape::Sheet(sheet) => sheet.windows,
            Shape::Chain(chain) => chain.windows,
            Shape::Net(net) => net.sheet.windows,
            Shape::Swept(swept) => steps.is_some() || swept.curves().any(|curve| curve.windows),
        };
        let u = steps.or_else(|| uses.next()).unwrap_or(Direction { windows: 0, words: None });
        let pieces = match &figure.shape {
            Shape::Pieces(_) => figure_count(automaton, figure, u32::MAX).map_or(0, |count| count.elements),
            _ => 0,
        };
        FigureAddresses { figure, u, v: uses.next(), windows, pieces, automaton }
    }

    /// The address of a curve's segment, by its place along the chain, or of a patchwork's polygon, by its place in the
    /// order of words; `None` for other figures or beyond the end.
    pub fn segment(&self, element: u64) -> Option<Address> {
        if self.v.is_some() || matches!(self.figure.shape, Shape::Pieces(_)) {
            return None;
        }
        let (window, letters) = self.u.place(element)?;
        let word = letters.into_iter().map(str::to_owned).collect();
        let width = digits(self.u.elements() - 1);
        Some(self.address(Window::Place(window), word, format!("-{element:0width$}")))
    }

    /// The address of a surface's quad, by its row (along u) and column (along v) over the whole surface; `None` for a
    /// curve or beyond the edges.
    pub fn quad(&self, row: u64, column: u64) -> Option<Address> {
        let v = self.v.as_ref()?;
        let ((u_window, u_letters), (v_window, v_letters)) = (self.u.place(row)?, v.place(column)?);
        let word = match self.u.words {
            Some(_) => pairs(&u_letters, &v_letters),
            None => v_letters.into_iter().map(str::to_owned).collect(),
        };
        let width = digits(self.u.elements().max(v.elements()) - 1);
        let alias = format!("-{row:0width$}-{column:0width$}");
        Some(self.address(Window::RowColumn(u_window, v_window), word, alias))
    }

    /// The address of an element of separate pieces, as evaluation gives it, with its place in their order; `None` for
    /// other figures. Where a state keeps several germs, the second and further ones have a letter of their own:
    /// `keep-2`.
    pub fn piece(&self, place: u64, element: &PieceElement<'_>) -> Option<Address> {
        let Shape::Pieces(plan) = &self.figure.shape else { return None };
        let letters = Word { start: plan.state, letters: element.letters().collect() };
        let mut word: Vec<String> = letters.names(self.automaton).into_iter().map(str::to_owned).collect();
        word.extend(element.drawn.kept.filter(|kept| *kept > 0).map(|kept| format!("keep-{}", kept + 1)));
        let width = digits(self.pieces.saturating_sub(1));
        Some(self.address(Window::Place(0), word, format!("-{place:0width$}")))
    }

    fn address(&self, window: Window, word: Vec<String>, place: String) -> Address {
        let (figure, index) = (self.figure.name.clone(), self.figure.index);
        let list = index.map_or(String::new(), |index| format!("-{index}"));
        let alias = format!("{figure}{list}{place}");
        Address { figure, index, window: self.windows.then_some(window), word, alias }
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
