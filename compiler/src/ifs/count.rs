//! How many elements a state has at a level: powers of the automaton's adjacency matrix applied to ones, cut off at a
//! limit, so that no level is expensive to refuse. With what is kept on the way, the sum of the powers.

use super::automaton::{Automaton, State, StateId};

/// Additions after which counting stops and answers [`Count::Exceeds`].
const ADDITION_BUDGET: u64 = 50_000_000;

/// The number of elements at a level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Count {
    /// Exactly so many.
    Exactly(u64),
    /// More than the limit; or a level so high that counting it takes more than 5·10^7 additions, which no evaluation
    /// could follow either.
    Exceeds,
}

/// The number of elements of `state` at `level`, up to `limit`.
pub fn count(automaton: &Automaton, state: StateId, level: u32, limit: u64) -> Count {
    Counter::new(automaton, state, limit, |_| (1, 0)).at(level)
}

/// What is drawn of separate pieces: the germ at the last level, and what is kept at every level before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drawn {
    /// Germs, kept ones among them.
    pub elements: u64,
    /// Their vertices, none of them shared.
    pub vertices: u64,
}

/// What is drawn of `state` at `level`; `None` where [`count`] would say [`Count::Exceeds`] without a limit.
pub fn drawn(automaton: &Automaton, state: StateId, level: u32) -> Option<Drawn> {
    let exact = |weigh: fn(&State) -> (usize, usize)| {
        let counter = Counter::new(automaton, state, u64::MAX, |state| {
            let (germ, kept) = weigh(state);
            (germ as u128, kept as u128)
        });
        match counter.at(level) {
            Count::Exactly(sum) => Some(sum),
            Count::Exceeds => None,
        }
    };
    let elements = exact(|state| (1, state.keep.len()))?;
    let vertices = exact(|state| {
        let kept = state.keep.iter().map(|germ| germ.vertices.len());
        (state.germ.vertices.len(), kept.sum())
    })?;
    Some(Drawn { elements, vertices })
}

enum Step {
    Grown,
    Settled,
    Exceeded,
}

/// Counts of all states reachable from one, level by level. Every state has a transform, so counts of elements never
/// fall.
struct Counter {
    targets: Vec<Vec<usize>>,
    /// What each state adds at every level on the way.
    kept: Vec<u128>,
    counts: Vec<u128>,
    start: usize,
    limit: u64,
    additions_left: u64,
}

impl Counter {
    /// `weigh` says what a state counts at the last level, and at every level on the way.
    fn new(
        automaton: &Automaton,
        state: StateId,
        limit: u64,
        weigh: impl Fn(&State) -> (u128, u128),
    ) -> Counter {
        let states: Vec<StateId> = automaton.reachable(state).into_iter().collect();
        let place = |id: &StateId| states.binary_search(id).unwrap_or_default();
        let targets = states
            .iter()
            .map(|id| {
                automaton.state(*id).transforms.iter().map(|transform| place(&transform.target)).collect()
            })
            .collect();
        let (counts, kept) = states.iter().map(|id| weigh(automaton.state(*id))).unzip();
        Counter { targets, kept, counts, start: place(&state), limit, additions_left: ADDITION_BUDGET }
    }

    /// The count of the first state at a level.
    fn at(mut self, level: u32) -> Count {
        for _ in 0..level {
            match self.step() {
                Step::Grown => {}
                Step::Settled => break,
                Step::Exceeded => return Count::Exceeds,
            }
        }
        match u64::try_from(self.current()) {
            Ok(elements) if elements <= self.limit => Count::Exactly(elements),
            _ => Count::Exceeds,
        }
    }

    fn current(&self) -> u128 {
        self.counts[self.start]
    }

    /// One level deeper.
    fn step(&mut self) -> Step {
        let additions: usize = self.targets.iter().map(Vec::len).sum();
        let Some(left) = self.additions_left.checked_sub(additions as u64) else { return Step::Exceeded };
        self.additions_left = left;
        let sum = |(targets, kept): (&Vec<usize>, &u128)| {
            targets.iter().fold(*kept, |total, target| total.saturating_add(self.counts[*target]))
        };
        let next: Vec<u128> = self.targets.iter().zip(&self.kept).map(sum).collect();
        if next == self.counts {
            return Step::Settled;
        }
        self.counts = next;
        if self.current() > u128::from(self.limit) { Step::Exceeded } else { Step::Grown }
    }
}
