//! The order in which bodies are painted, the hidden ones first. Where two overlap on paper, the face of either that parts
//! them best says which is behind (as in Newell, Newell and Sancha 1972, "A solution to the hidden surface problem");
//! the distance of middles would put long planks before each other at random.

use std::collections::BTreeSet;

use glam::{DVec2, DVec3};

use super::view::View;

/// What is known of a body: its corners and the planes of its faces, as unit normal and distance from the origin.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::export::html) struct Hull {
    /// Its corners, mm.
    pub(in crate::export::html) corners: Vec<DVec3>,
    /// Its planes; of an open face one side is as good as the other.
    pub(in crate::export::html) planes: Vec<(DVec3, f64)>,
}

/// Pairs of bodies looked at, at most; above, the distances of middles alone decide.
const MOST_PAIRS: usize = 400_000;

/// A face seen at a smaller slope than this parts two bodies side by side: neither hides the other.
const EDGE_ON: f64 = 1e-6;

/// The bodies from back to front.
pub(in crate::export::html) fn back_to_front(view: View, hulls: &[Hull]) -> Vec<usize> {
    let mut by_depth: Vec<(f64, usize)> =
        hulls.iter().enumerate().map(|(place, hull)| (middle(view, hull), place)).collect();
    by_depth.sort_by(|(first, _), (second, _)| first.total_cmp(second));
    let order: Vec<usize> = by_depth.into_iter().map(|(_, place)| place).collect();
    let Some(pairs) = overlapping(view, hulls, &order) else { return order };
    // From here on a body is its rank by depth.
    let mut behind: Vec<usize> = vec![0; order.len()];
    let mut before: Vec<Vec<usize>> = vec![Vec::new(); order.len()];
    for (first, second) in pairs {
        let (back, front) = match compare(view, &hulls[order[first]], &hulls[order[second]]) {
            Relation::Apart => continue,
            Relation::Behind => (first, second),
            Relation::Before => (second, first),
        };
        before[back].push(front);
        behind[front] += 1;
    }
    sorted(&before, behind).into_iter().map(|rank| order[rank]).collect()
}

/// Ranks in an order that keeps all relations; where they run in a circle the farthest goes first.
fn sorted(before: &[Vec<usize>], mut behind: Vec<usize>) -> Vec<usize> {
    let mut ready: BTreeSet<usize> = (0..before.len()).filter(|&rank| behind[rank] == 0).collect();
    let mut waiting: BTreeSet<usize> = (0..before.len()).filter(|&rank| behind[rank] > 0).collect();
    let mut out = Vec::with_capacity(before.len());
    while let Some(rank) = ready.pop_first().or_else(|| waiting.pop_first()) {
        out.push(rank);
        for &front in &before[rank] {
            behind[front] = behind[front].saturating_sub(1);
            if behind[front] == 0 && waiting.remove(&front) {
                ready.insert(front);
            }
        }
    }
    out
}

fn middle(view: View, hull: &Hull) -> f64 {
    let sum: f64 = hull.corners.iter().map(|corner| view.nearness(*corner)).sum();
    sum / hull.corners.len().max(1) as f64
}

/// Pairs of ranks whose boxes on paper overlap; none where there are too many.
fn overlapping(view: View, hulls: &[Hull], order: &[usize]) -> Option<Vec<(usize, usize)>> {
    let boxes: Vec<(DVec2, DVec2)> = order
        .iter()
        .map(|&place| {
            super::view::bounds(view, hulls[place].corners.iter().copied())
                .unwrap_or((DVec2::ZERO, DVec2::ZERO))
        })
        .collect();
    let mut by_left: Vec<usize> = (0..boxes.len()).collect();
    by_left
        .sort_by(|&first, &second| boxes[first].0.x.total_cmp(&boxes[second].0.x).then(first.cmp(&second)));
    let mut pairs = Vec::new();
    let mut looked = 0;
    for (place, &first) in by_left.iter().enumerate() {
        for &second in &by_left[place + 1..] {
            looked += 1;
            if boxes[second].0.x >= boxes[first].1.x {
                break;
            }
            if looked > 40 * MOST_PAIRS || pairs.len() > MOST_PAIRS {
                return None;
            }
            if boxes[second].0.y < boxes[first].1.y && boxes[first].0.y < boxes[second].1.y {
                pairs.push((first.min(second), first.max(second)));
            }
        }
    }
    Some(pairs)
}

enum Relation {
    Behind,
    Before,
    Apart,
}

/// Where the first body is to the second, of which the middle is not farther.
fn compare(view: View, first: &Hull, second: &Hull) -> Relation {
    let parting = |own: &Hull, other: &Hull| -> Option<(f64, f64)> {
        let sides = own.planes.iter().flat_map(|&(normal, offset)| {
            let distances = || other.corners.iter().map(move |corner| corner.dot(normal) - offset);
            let nearest = distances().fold(f64::INFINITY, f64::min);
            let open = own.planes.len() == 1;
            let behind = distances().map(|distance| -distance).fold(f64::INFINITY, f64::min);
            let slope = normal.dot(view.toward);
            std::iter::once((nearest, slope)).chain(open.then_some((behind, -slope)))
        });
        sides.reduce(|best, found| if found.0 > best.0 { found } else { best })
    };
    let (own, other) = (parting(first, second), parting(second, first));
    let slope = match (own, other) {
        (Some((own, slope)), Some((other, _))) if own >= other => slope,
        (_, Some((_, slope))) => -slope,
        (Some((_, slope)), None) => slope,
        (None, None) => return Relation::Behind,
    };
    match slope {
        slope if slope > EDGE_ON => Relation::Behind,
        slope if slope < -EDGE_ON => Relation::Before,
        _ => Relation::Apart,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box between two corners.
    fn cuboid(low: DVec3, high: DVec3) -> Hull {
        let corner = |n: usize| [0, 1, 2].map(|axis| if n >> axis & 1 == 1 { high[axis] } else { low[axis] });
        let corners = (0..8).map(|n| DVec3::from_array(corner(n))).collect();
        let planes = [DVec3::X, DVec3::Y, DVec3::Z]
            .into_iter()
            .flat_map(|axis| [(axis, axis.dot(high)), (-axis, -axis.dot(low))])
            .collect();
        Hull { corners, planes }
    }

    fn order_of(hulls: &[Hull]) -> Vec<usize> {
        back_to_front(View::axonometric(), hulls)
    }

    #[test]
    fn long_planks_side_by_side() {
        // The front one is long and its middle is far away; middles alone would paint it first.
        let back = cuboid(DVec3::ZERO, DVec3::new(500.0, 27.0, 120.0));
        let front = cuboid(DVec3::new(-6000.0, -27.0, 0.0), DVec3::new(500.0, 0.0, 120.0));
        let view = View::axonometric();
        assert!(middle(view, &front) < middle(view, &back));
        assert_eq!(order_of(&[back.clone(), front.clone()]), [0, 1]);
        assert_eq!(order_of(&[front, back]), [1, 0]);
    }

    #[test]
    fn a_wall_of_bricks_from_any_start() {
        let brick = |x: i32, y: i32, z: i32| {
            let low = DVec3::new(f64::from(x) * 200.0, f64::from(y) * 50.0, f64::from(z) * 30.0);
            cuboid(low, low + DVec3::new(200.0, 50.0, 30.0))
        };
        let places: Vec<(i32, i32, i32)> =
            (0..4).flat_map(|x| (0..4).flat_map(move |y| (0..4).map(move |z| (x, y, z)))).collect();
        for turned in [0, 7, 31] {
            let mut places = places.clone();
            places.rotate_left(turned);
            let hulls: Vec<Hull> = places.iter().map(|&(x, y, z)| brick(x, y, z)).collect();
            let order = order_of(&hulls);
            let rank = |place| order.iter().position(|&found| places[found] == place).unwrap();
            for &(x, y, z) in &places {
                // Seen from the front, the right and above.
                for behind in [(x - 1, y, z), (x, y + 1, z), (x, y, z - 1)] {
                    if places.contains(&behind) {
                        assert!(rank(behind) < rank((x, y, z)), "{behind:?} hides {:?}", (x, y, z));
                    }
                }
            }
        }
    }

    #[test]
    fn open_faces_and_circles_come_once_each() {
        let face = |z: f64| {
            let corners = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0)].map(|(x, y)| DVec3::new(x, y, z));
            Hull { corners: corners.to_vec(), planes: vec![(DVec3::NEG_Z, -z)] }
        };
        assert_eq!(order_of(&[face(3.0), face(1.0), face(2.0)]), [1, 2, 0]);
        // Three bars, each over the next: no order is right, all are painted.
        let bars = [
            cuboid(DVec3::new(0.0, 0.0, 0.0), DVec3::new(10.0, 2.0, 5.0)),
            cuboid(DVec3::new(0.0, 0.0, 4.0), DVec3::new(2.0, 10.0, 6.0)),
            cuboid(DVec3::new(0.0, 0.0, 3.0), DVec3::new(10.0, 10.0, 4.5)),
        ];
        let mut order = order_of(&bars);
        order.sort_unstable();
        assert_eq!(order, [0, 1, 2]);
        assert_eq!(order_of(&[]), Vec::<usize>::new());
    }
}
