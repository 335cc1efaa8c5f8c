//! How many elements a state has at a level: powers of the automaton's adjacency matrix applied to ones, cut off at a
//! limit, so that no level is expensive to refuse.

use super::automaton::{Automaton, StateId};

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
    let mut counter = Counter::new(automaton, state, limit);
    for _ in 0..level {
        match counter.step() {
            Step::Grown => {}
            Step::Settled => break,
            Step::Exceeded => return Count::Exceeds,
        }
    }
    match u64::try_from(counter.current()) {
        Ok(elements) if elements <= limit => Count::Exactly(elements),
        _ => Count::Exceeds,
    }
}

enum Step {
    Grown,
    Settled,
    Exceeded,
}

/// Counts of all states reachable from one, level by level. Every state has a transform, so counts never fall.
struct Counter {
    targets: Vec<Vec<usize>>,
    counts: Vec<u128>,
    start: usize,
    limit: u64,
    additions_left: u64,
}

impl Counter {
    fn new(automaton: &Automaton, state: StateId, limit: u64) -> Counter {
        let states: Vec<StateId> = automaton.reachable(state).into_iter().collect();
        let place = |id: &StateId| states.binary_search(id).unwrap_or_default();
        let targets = states
            .iter()
            .map(|id| {
                automaton.state(*id).transforms.iter().map(|transform| place(&transform.target)).collect()
            })
            .collect();
        let counts = vec![1; states.len()];
        Counter { targets, counts, start: place(&state), limit, additions_left: ADDITION_BUDGET }
    }

    fn current(&self) -> u128 {
        self.counts[self.start]
    }

    /// One level deeper.
    fn step(&mut self) -> Step {
        let additions: usize = self.targets.iter().map(Vec::len).sum();
        let Some(left) = self.additions_left.checked_sub(additions as u64) else { return Step::Exceeded };
        self.additions_left = left;
        let sum = |targets: &Vec<usize>| {
            targets.iter().fold(0_u128, |total, target| total.saturating_add(self.counts[*target]))
        };
        let next: Vec<u128> = self.targets.iter().map(sum).collect();
        if next == self.counts {
            return Step::Settled;
        }
        self.counts = next;
        if self.current() > u128::from(self.limit) { Step::Exceeded } else { Step::Grown }
    }
}
