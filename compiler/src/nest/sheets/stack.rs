//! Strips on sheets: which strips share one, so that their heights fill it.

use glam::DVec2;

use super::layout::{Layout, SLACK};
use super::strips::{Manner, Strip};

/// How many sums of heights are looked at for a sheet.
const SUMS: usize = 4000;

/// Sheet after sheet: the highest strip that is left, and of the others those that fill what remains best.
pub(super) fn stack(mut strips: Vec<Strip>, manner: Manner, room: DVec2) -> Vec<Layout> {
    let across = 1 - manner.axis;
    strips.sort_by(|a, b| b.height.total_cmp(&a.height));
    let mut sheets = Vec::new();
    while !strips.is_empty() {
        let heights: Vec<f64> = strips.iter().map(|strip| strip.height + SLACK).collect();
        let chosen = fullest(&heights, room[across] + SLACK);
        let mut layout = Layout { size: room, items: Vec::new() };
        let mut foot = 0.0;
        for &place in &chosen {
            let strip = &strips[place];
            layout.items.extend(strip.items.iter().map(|item| {
                let mut item = *item;
                item.at[across] += foot;
                item
            }));
            foot += strip.height + SLACK;
        }
        sheets.push(layout);
        let mut place = 0;
        strips.retain(|_| {
            place += 1;
            !chosen.contains(&(place - 1))
        });
    }
    sheets
}

/// Of numbers from the greatest down, the first and those whose sum with it comes nearest to `most` from below.
fn fullest(heights: &[f64], most: f64) -> Vec<usize> {
    let mut search = Search { heights, most, best: 0.0, chosen: vec![0], sums: 0 };
    search.go(&mut vec![0], heights[0], 1);
    search.chosen
}

struct Search<'a> {
    heights: &'a [f64],
    most: f64,
    best: f64,
    chosen: Vec<usize>,
    sums: usize,
}

impl Search<'_> {
    fn go(&mut self, taken: &mut Vec<usize>, sum: f64, next: usize) {
        if sum > self.best {
            self.best = sum;
            self.chosen.clone_from(taken);
        }
        let room = self.most - sum;
        // The first that fits.
        let first = next + self.heights[next..].partition_point(|height| *height > room);
        for place in first..self.heights.len() {
            if self.sums >= SUMS {
                return;
            }
            self.sums += 1;
            taken.push(place);
            self.go(taken, sum + self.heights[place], place + 1);
            taken.pop();
        }
    }
}
