//! Every branch on its own: a word ends where its germ's image is small enough (LANGUAGE 6).

use std::fmt;

use crate::ifs::{Drawn, StateId, Word};

use super::super::super::budget::MAX_LEVEL;
use super::super::super::figure::Each;
use super::super::super::size::{SizeBound, SizeRange};
use super::{PiecesEvaluator, Tile, Walk};

/// Words looked at for each element that is allowed, at most.
const WORDS_AN_ELEMENT: u64 = 8;

/// Why the branches of a figure cannot be followed to their ends.
#[derive(Clone, Debug, PartialEq)]
pub enum EachError {
    /// A branch that is not small enough after [`MAX_LEVEL`] letters.
    TooDeep {
        /// The branch.
        word: Word,
        /// Its size there.
        size: f64,
        /// Its size halfway there.
        halfway: f64,
    },
    /// More elements than the limit, or eight times as many words.
    TooMany {
        /// The branch that was to be followed next.
        word: Word,
        /// Its size there.
        size: f64,
    },
    /// A germ that has no such measure.
    NoMeasure {
        /// The state that draws it.
        state: StateId,
    },
}

impl fmt::Display for EachError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EachError::TooDeep { size, .. } => {
                write!(f, "a branch is still {size} mm large after {MAX_LEVEL} letters")
            }
            EachError::TooMany { .. } => f.write_str("more elements than the limit"),
            EachError::NoMeasure { state } => write!(f, "the germ of state {} has no such measure", state.0),
        }
    }
}

impl std::error::Error for EachError {}

impl PiecesEvaluator {
    /// What the figure comes to when every branch stops at the bound, with the letters of its longest word.
    ///
    /// # Errors
    /// [`EachError`]; it ends after a few times `limit` steps.
    pub fn count_each(&self, bound: SizeBound, limit: u64) -> Result<(Drawn, u32), EachError> {
        let mut drawn = Drawn { elements: 0, vertices: 0 };
        let (mut deepest, mut words) = (0, 0_u64);
        // The size of the branch at hand after each letter.
        let mut sizes: Vec<f64> = Vec::new();
        let mut walk = Walk::new(self.root, &self.points);
        let mut tile = self.coordinates();
        let mut vertices = Vec::new();
        while let Some(at) = walk.state() {
            let (state, length) = (&self.states[at], walk.letters.len());
            let word = |walk: &Walk| self.word(walk);
            if walk.is_fresh() {
                let germ = tile.filled(&state.germ, &walk, self);
                let Some(size) = size(&germ, bound, &mut vertices) else {
                    return Err(EachError::NoMeasure { state: StateId(at as u32) });
                };
                let ends = bound.holds(size.most);
                let added = if ends { &state.germ } else { &state.kept };
                drawn.elements += added.elements.len() as u64;
                drawn.vertices += added.rows as u64;
                words += 1;
                if drawn.elements > limit || words > limit.saturating_mul(WORDS_AN_ELEMENT) {
                    return Err(EachError::TooMany { word: word(&walk), size: size.most });
                }
                if ends {
                    deepest = deepest.max(length as u32);
                    walk.leave();
                    continue;
                }
                sizes.truncate(length);
                sizes.push(size.most);
                if length >= MAX_LEVEL as usize {
                    let halfway = sizes[length / 2];
                    return Err(EachError::TooDeep { word: word(&walk), size: size.most, halfway });
                }
            }
            if !walk.enter(&self.states) {
                walk.leave();
            }
        }
        Ok((drawn, deepest))
    }

    pub(super) fn stream_each<E>(
        &self,
        each: &Each,
        mut write: impl FnMut(&Tile<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut walk = Walk::new(self.root, &self.points);
        let mut tile = self.coordinates();
        let mut vertices = Vec::new();
        while let Some(at) = walk.state() {
            let state = &self.states[at];
            if walk.is_fresh() {
                let germ = tile.filled(&state.germ, &walk, self);
                let ends =
                    size(&germ, each.bound, &mut vertices).is_none_or(|size| each.bound.holds(size.most));
                if ends || walk.letters.len() >= each.deepest as usize {
                    write(&germ)?;
                    walk.leave();
                    continue;
                }
                if !state.kept.elements.is_empty() {
                    write(&tile.filled(&state.kept, &walk, self))?;
                }
            }
            if !walk.enter(&self.states) {
                walk.leave();
            }
        }
        Ok(())
    }

    fn word(&self, walk: &Walk) -> Word {
        let letters = walk.letters.iter().map(|letter| *letter as usize).collect();
        Word { start: StateId(self.root as u32), letters }
    }
}

/// The size of the one germ of a tile.
fn size(germ: &Tile<'_>, bound: SizeBound, vertices: &mut Vec<[f64; 3]>) -> Option<SizeRange> {
    let element = germ.elements().next()?;
    germ.copy_vertices(&element, vertices);
    bound.measure.of(&element.drawn.shape, vertices)
}
