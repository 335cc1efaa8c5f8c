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
    // The parts that are looked at, by their place among those that wait.
    let mut open: Vec<usize> = vec![0];
    let mut next = 1;
    // The area taken up so far: what lies before the last part's far side.
    let mut front = 0.0;
    loop {
        let shortest = open.iter().map(|&place| waiting[place].length).fold(f64::INFINITY, f64::min);
        let mut best: Option<(f64, usize, Item, f64)> = None;
        for &place in &open {
            let waits = &waiting[place];
            for pose in &waits.poses {
                let shape = shapes.of(pose);
                let mut item = *pose;
                item.at[axis] = pushed(shapes, &strip.items, pose, axis);
                let right = item.at[axis] + shape.high[axis];
                if right > end {
                    continue;
                }
                let mean = item.at[axis] + shape.along(axis).mean_right();
                // What lies beyond is lost where nothing else fits in.
                let taken = match end - right < shortest {
                    true => end * height,
                    false => mean * waits.height + right * (height - waits.height),
                };
                let score = (taken - front) / shape.area;
                if best.as_ref().is_none_or(|(least, ..)| score < *least) {
                    best = Some((score, place, item, taken));
                }
            }
        }
        let Some((_, place, item, taken)) = best else { return (strip, used) };
        strip.area += shapes.of(&item).area;
        strip.items.push(item);
        front = taken;
        used.push(place);
        open.retain(|&other| other != place);
        while open.len() < window && next < waiting.len() {
            open.push(next);
            next += 1;
        }
    }
}

/// How far along a strip a part goes when it is pushed against what is there.
fn pushed(shapes: &Shapes, items: &[Item], pose: &Item, axis: usize) -> f64 {
    let moving = shapes.of(pose).along(axis);
    let mut least = pose.at[axis];
    for item in items.iter().rev() {
        let fixed = shapes.of(item).along(axis);
        if item.at[axis] + fixed.farthest_right() - moving.farthest_left() <= least {
            continue;
        }
        let raised = pose.at[1 - axis] - item.at[1 - axis];
        if let Some((_, past)) = fixed.forbidden(moving, raised) {
            least = least.max(past + item.at[axis] + SLACK);
        }
    }
    least
}
