//! [`Word`]: a path through an automaton, the letters of an address.

use std::fmt;

use super::automaton::{Automaton, StateId};

/// A word of transforms, read from a first state on: each letter is the place of a transform in its state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word {
    /// The state the first letter belongs to.
    pub start: StateId,
    /// Places of the transforms, first applied first.
    pub letters: Vec<usize>,
}

impl Word {
    /// The names of the letters. Letters which are not of the automaton end the list.
    pub fn names<'a>(&self, automaton: &'a Automaton) -> Vec<&'a str> {
        let mut names = Vec::with_capacity(self.letters.len());
        let mut state = automaton.get(self.start);
        for letter in &self.letters {
            let Some(transform) = state.and_then(|state| state.transforms.get(*letter)) else { break };
            names.push(transform.name.as_str());
            state = automaton.get(transform.target);
        }
        names
    }

    /// The word as text, `left.right`, with the names of an automaton.
    pub fn display(&self, automaton: &Automaton) -> impl fmt::Display {
        self.names(automaton).join(".")
    }
}
