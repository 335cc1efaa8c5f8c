//! Which planks share a bar: two ways of filling, of which the one with fewer bars is taken.

use super::row::{alone, row};
use super::{Bar, Plank, Sawn, Stock, TooLong};

/// How many sums of lengths are looked at for a bar.
const SUMS: usize = 4000;

/// How many of the bars that fit best are tried for a plank.
const TRIED: usize = 6;

pub(super) fn saw(planks: &[Plank], stock: &Stock) -> Sawn {
    let room = stock.length - 2.0 * stock.trim;
    let mut sawn = Sawn::default();
    let mut waiting: Vec<usize> = Vec::new();
    for (plank, length) in planks.iter().map(|plank| alone(plank, stock)).enumerate() {
        if length <= room {
            waiting.push(plank);
        } else {
            sawn.too_long.push(TooLong { plank, needed: length, room });
        }
    }
    waiting.sort_by(|&a, &b| planks[b].length.total_cmp(&planks[a].length).then(a.cmp(&b)));
    let filler = Filler { planks, stock, room: room + stock.kerf };
    let (full, decreasing) = (filler.fullest(&waiting), filler.best_fit(&waiting));
    let bars = if decreasing.len() < full.len() { decreasing } else { full };
    sawn.bars = bars.iter().filter_map(|chosen| row(planks, chosen, stock)).collect();
    sawn.bars.sort_by(|a: &Bar, b| {
        let first = |bar: &Bar| bar.planks.iter().map(|placed| placed.plank).min();
        a.offcut.total_cmp(&b.offcut).then(first(a).cmp(&first(b)))
    });
    sawn
}

struct Filler<'a> {
    planks: &'a [Plank],
    stock: &'a Stock,
    /// Between the trims and a kerf more, as each plank counts with a kerf.
    room: f64,
}

impl Filler<'_> {
    /// What a plank takes at least.
    fn least(&self, plank: usize) -> f64 {
        self.planks[plank].length + self.stock.kerf
    }

    fn fits(&self, chosen: &[usize]) -> bool {
        row(self.planks, chosen, self.stock).is_some()
    }

    /// The longest that waits, on the bar that it fills best: best fit decreasing.
    fn best_fit(&self, waiting: &[usize]) -> Vec<Vec<usize>> {
        let mut bars: Vec<(f64, Vec<usize>)> = Vec::new();
        for &plank in waiting {
            let mut open: Vec<usize> =
                (0..bars.len()).filter(|&bar| bars[bar].0 + self.least(plank) <= self.room).collect();
            open.sort_by(|&a, &b| bars[b].0.total_cmp(&bars[a].0).then(a.cmp(&b)));
            let found = open.into_iter().take(TRIED).find(|&bar| {
                let with: Vec<usize> = bars[bar].1.iter().copied().chain([plank]).collect();
                self.fits(&with)
            });
            match found {
                Some(bar) => {
                    bars[bar].0 += self.least(plank);
                    bars[bar].1.push(plank);
                }
                None => bars.push((self.least(plank), vec![plank])),
            }
        }
        bars.into_iter().map(|(_, chosen)| chosen).collect()
    }

    /// Bar after bar: the longest that waits, and of the others those that fill the bar best.
    fn fullest(&self, waiting: &[usize]) -> Vec<Vec<usize>> {
        let mut left = waiting.to_vec();
        let mut bars = Vec::new();
        while let Some(&first) = left.first() {
            let mut search = Search { filler: self, left: &left, best: 0.0, chosen: vec![first], sums: 0 };
            search.go(&mut vec![first], self.least(first), 1);
            let chosen = search.chosen;
            left.retain(|plank| !chosen.contains(plank));
            bars.push(chosen);
        }
        bars
    }
}

struct Search<'a> {
    filler: &'a Filler<'a>,
    left: &'a [usize],
    best: f64,
    chosen: Vec<usize>,
    sums: usize,
}

impl Search<'_> {
    fn go(&mut self, taken: &mut Vec<usize>, sum: f64, next: usize) {
        if sum > self.best {
            if !self.filler.fits(taken) {
                return;
            }
            self.best = sum;
            self.chosen.clone_from(taken);
        }
        let room = self.filler.room - sum;
        let first = next + self.left[next..].partition_point(|&plank| self.filler.least(plank) > room);
        let mut before = f64::NAN;
        for place in first..self.left.len() {
            if self.sums >= SUMS || self.filler.room - self.best < 1e-6 {
                return;
            }
            let length = self.filler.least(self.left[place]);
            // One of equals is enough.
            if (length - before).abs() < 1e-9 {
                continue;
            }
            before = length;
            self.sums += 1;
            taken.push(self.left[place]);
            self.go(taken, sum + length, place + 1);
            taken.pop();
        }
    }
}
