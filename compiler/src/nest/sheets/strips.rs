//! Strips: parts of nearly one height side by side, each pushed against the ones before it as its sides allow.

use std::collections::VecDeque;

use glam::DVec2;

use super::layout::{Item, SLACK, Shapes};

/// How many parts that follow in height are looked at when a strip goes on. Each is tried, the fullest strip taken.
const WINDOWS: [usize; 4] = [4, 10, 24, 60];

/// How strips are made.
#[derive(Debug, Clone, Copy)]
pub(super) struct Manner {
    /// Along which axis strips run: 0 for x, 1 for y.
    pub(super) axis: usize,
    /// Whether parts stand, their longer extent across the strip, or lie.
    pub(super) standing: bool,
}

/// A strip from 0 along its axis, 0 to `height` across it.
#[derive(Debug, Clone)]
pub(super) struct Strip {
    pub(super) items: Vec<Item>,
    pub(super) height: f64,
    pub(super) area: f64,
}

/// A part that waits for its strip, at the strip's start in each orientation that the manner wants.
struct Waiting {
    part: usize,
    poses: Vec<Item>,
    /// Across the strip.
    height: f64,
    /// Along it.
    length: f64,
}

impl Waiting {
    /// Where none of the orientations that the manner wants fits the room, those of the first that does.
    fn of(shapes: &Shapes, part: usize, manner: Manner, room: DVec2) -> Option<Self> {
        let across = 1 - manner.axis;
        let all = &shapes.all[part];
        let height = |turn: usize| all[turn].size()[across];
        let fitting: Vec<usize> = (0..all.len()).filter(|&turn| all[turn].size().cmple(room).all()).collect();
        let by_height = |a: &&usize, b: &&usize| height(**a).total_cmp(&height(**b));
        let wanted = match manner.standing {
            true => fitting.iter().max_by(by_height),
            false => fitting.iter().min_by(by_height),
        };
        let first = *wanted?;
        let like = fitting.iter().filter(|&&turn| (height(turn) - height(first)).abs() < 1e-6);
        let poses = like.map(|&turn| Item { part, turn, at: -all[turn].low }).collect();
        Some(Self { part, poses, height: height(first), length: all[first].size()[manner.axis] })
    }
}

/// All parts in strips no longer than the room, the tallest first.
pub(super) fn strips(shapes: &Shapes, parts: &[usize], manner: Manner, room: DVec2) -> Vec<Strip> {
    let waiting = parts.iter().filter_map(|&part| Waiting::of(shapes, part, manner, room));
    let mut waiting: Vec<Waiting> = waiting.collect();
    waiting.sort_by(|a, b| b.height.total_cmp(&a.height).then(a.part.cmp(&b.part)));
    let mut waiting = VecDeque::from(waiting);
    let mut strips = Vec::new();
    while !waiting.is_empty() {
        let tried = WINDOWS.into_iter().filter(|&window| window == WINDOWS[0] || window < 2 * waiting.len());
        let filled = tried.map(|window| fill(shapes, &waiting, window, manner.axis, room[manner.axis]));
        let best = filled.reduce(|best, next| if next.0.area > best.0.area { next } else { best });
        let Some((strip, mut used)) = best else { break };
        used.sort_unstable();
        for place in used.into_iter().rev() {
            waiting.remove(place);
        }
        strips.push(strip);
    }
    strips
}

/// A part in one pose that a strip may go on with, pushed against what the strip holds.
struct Candidate {
    /// Among those that wait.
    place: usize,
    item: Item,
}

/// A strip as high as the first part that waits, which goes on with whatever wastes least; and which were used.
fn fill(
    shapes: &Shapes,
    waiting: &VecDeque<Waiting>,
    window: usize,
    axis: usize,
    end: f64,
) -> (Strip, Vec<usize>) {
    let height = waiting[0].height;
    let mut strip = Strip { items: Vec::new(), height, area: 0.0 };
    let mut used: Vec<usize> = Vec::new();
    let mut reach: Vec<f64> = Vec::new();
    let mut candidates = poses(waiting, 0, |pose| *pose).collect::<Vec<Candidate>>();
    let (mut open, mut next) = (1, 1);
    // The area taken up so far: what lies before the last part's far side.
    let mut front = 0.0;
    loop {
        let lengths = candidates.iter().map(|candidate| waiting[candidate.place].length);
        let shortest = lengths.fold(f64::INFINITY, f64::min);
        let mut best: Option<(f64, usize, f64)> = None;
        for (index, Candidate { place, item }) in candidates.iter().enumerate() {
            let shape = shapes.of(item);
            let right = item.at[axis] + shape.high[axis];
            if right > end {
                continue;
            }
            let waits = &waiting[*place];
            let mean = item.at[axis] + shape.along(axis).mean_right();
            // What lies beyond is lost where nothing else fits in.
            let taken = match end - right < shortest {
                true => end * height,
                false => mean * waits.height + right * (height - waits.height),
            };
            let score = (taken - front) / shape.area;
            if best.is_none_or(|(least, ..)| score < least) {
                best = Some((score, index, taken));
            }
        }
        let Some((_, index, taken)) = best else { return (strip, used) };
        let Candidate { place, item } = candidates[index];
        strip.area += shapes.of(&item).area;
        strip.items.push(item);
        let before = reach.last().copied().unwrap_or(f64::NEG_INFINITY);
        reach.push(before.max(item.at[axis] + shapes.of(&item).along(axis).farthest_right()));
        front = taken;
        used.push(place);
        candidates.retain(|other| other.place != place);
        open -= 1;
        for candidate in &mut candidates {
            push(shapes, &item, &mut candidate.item, axis);
        }
        while open < window && next < waiting.len() {
            candidates.extend(poses(waiting, next, |pose| pushed(shapes, &strip.items, &reach, pose, axis)));
            open += 1;
            next += 1;
        }
    }
}

fn poses(
    waiting: &VecDeque<Waiting>,
    place: usize,
    put: impl Fn(&Item) -> Item,
) -> impl Iterator<Item = Candidate> {
    waiting[place].poses.iter().map(move |pose| Candidate { place, item: put(pose) })
}

/// A part at the start of a strip, pushed along until it is past all that is there. `reach` says of each item how far
/// it and those before it reach.
fn pushed(shapes: &Shapes, items: &[Item], reach: &[f64], pose: &Item, axis: usize) -> Item {
    let mut item = *pose;
    let start = shapes.of(pose).along(axis).farthest_left();
    for (fixed, &reach) in items.iter().zip(reach).rev() {
        if reach - start <= item.at[axis] {
            break;
        }
        push(shapes, fixed, &mut item, axis);
    }
    item
}

/// Pushes an item along an axis until it is past another.
fn push(shapes: &Shapes, fixed: &Item, item: &mut Item, axis: usize) {
    let (still, moving) = (shapes.of(fixed).along(axis), shapes.of(item).along(axis));
    if fixed.at[axis] + still.farthest_right() - moving.farthest_left() <= item.at[axis] {
        return;
    }
    let raised = item.at[1 - axis] - fixed.at[1 - axis];
    if let Some(past) = still.past(moving, raised) {
        item.at[axis] = item.at[axis].max(past + fixed.at[axis] + SLACK);
    }
}
