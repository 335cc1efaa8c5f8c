//! The order in which the boards of a surface or the planks of a curve are put up.
//!
//! The rule: ring 0 are the elements on the supports, that is, those with a free corner as low as the lowest free
//! corner of their piece, to within a hundredth of the height of the piece; where nothing is free, the lowest element.
//! Ring n + 1 are the neighbours of ring n that are not placed yet. Within a ring the lower one comes first, on a tie
//! the one that comes first in the figure. So every element stands on a support or touches one that is already up.
//! Pieces that do not touch each other come one after the other.

use std::collections::VecDeque;

/// Free corners this close to the lowest one, as a share of the height of the piece, stand on the support.
const SUPPORT_SHARE: f64 = 0.01;

/// Heights that differ by less than this are the same, mm: rounding does not choose.
const SAME_HEIGHT: f64 = 1e-6;

/// A board or plank as its order needs it.
#[derive(Debug, Clone, Default)]
pub struct Element {
    /// The height of its middle, mm.
    pub height: f64,
    /// The heights of its corners which lie on the border of the figure, mm.
    pub free_corners: Vec<f64>,
    /// The elements that touch it.
    pub neighbours: Vec<usize>,
}

/// When an element is put up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Place {
    /// Its ring, from 0.
    pub ring: u32,
    /// Its place in the order, from 0.
    pub order: u32,
}

/// The place of each element. Neighbours beyond the list are left aside.
#[must_use]
pub fn order(elements: &[Element]) -> Vec<Place> {
    let mut rings: Vec<Option<u32>> = vec![None; elements.len()];
    let mut order = Vec::with_capacity(elements.len());
    for first in 0..elements.len() {
        if rings[first].is_none() {
            let mut piece = piece(elements, first);
            rise(elements, &piece, &mut rings);
            let height = |element: usize| libm::round(elements[element].height / SAME_HEIGHT);
            piece.sort_by(|&a, &b| {
                rings[a].cmp(&rings[b]).then(height(a).total_cmp(&height(b))).then(a.cmp(&b))
            });
            order.extend(piece);
        }
    }
    let mut places = vec![Place::default(); elements.len()];
    for (place, element) in (0u32..).zip(order) {
        places[element] = Place { ring: rings[element].unwrap_or(0), order: place };
    }
    places
}

/// The elements that hang together with `first`.
fn piece(elements: &[Element], first: usize) -> Vec<usize> {
    let mut seen = std::collections::BTreeSet::from([first]);
    let mut found = vec![first];
    let mut next = 0;
    while let Some(&element) = found.get(next) {
        next += 1;
        for &neighbour in &elements[element].neighbours {
            if neighbour < elements.len() && seen.insert(neighbour) {
                found.push(neighbour);
            }
        }
    }
    found
}

/// Gives every element of a piece its ring.
fn rise(elements: &[Element], piece: &[usize], rings: &mut [Option<u32>]) {
    let lowest = |heights: &mut dyn Iterator<Item = f64>| heights.fold(f64::INFINITY, f64::min);
    let middle = lowest(&mut piece.iter().map(|&element| elements[element].height));
    let highest = piece.iter().map(|&element| elements[element].height).fold(middle, f64::max);
    let free = || piece.iter().flat_map(|&element| elements[element].free_corners.iter().copied());
    let ground = lowest(&mut free());
    let top = free().fold(highest, f64::max);
    let room = SUPPORT_SHARE * (top - ground.min(middle)) + SAME_HEIGHT;
    let stands = |element: &Element| match ground.is_finite() {
        true => element.free_corners.iter().any(|corner| *corner <= ground + room),
        false => element.height <= middle + SAME_HEIGHT,
    };
    let mut queue = VecDeque::new();
    for &element in piece.iter().filter(|&&element| stands(&elements[element])) {
        rings[element] = Some(0);
        queue.push_back((element, 0));
    }
    while let Some((element, ring)) = queue.pop_front() {
        for &neighbour in &elements[element].neighbours {
            if let Some(place @ None) = rings.get_mut(neighbour) {
                *place = Some(ring + 1);
                queue.push_back((neighbour, ring + 1));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// An arch of so many planks: its ends are free and at the ground.
    fn arch(count: usize) -> Vec<Element> {
        let height = |place: usize| place.min(count - 1 - place) as f64 * 100.0;
        (0..count)
            .map(|place| Element {
                height: height(place),
                free_corners: if place == 0 || place == count - 1 { vec![0.0] } else { Vec::new() },
                neighbours: [place.checked_sub(1), Some(place + 1)].into_iter().flatten().collect(),
            })
            .collect()
    }

    #[test]
    fn an_arch_rises_from_both_feet() {
        let places: Vec<(u32, u32)> = order(&arch(5)).iter().map(|place| (place.ring, place.order)).collect();
        assert_eq!(places, [(0, 0), (1, 2), (2, 4), (1, 3), (0, 1)]);
    }

    #[test]
    fn pieces_follow_each_other_and_what_is_closed_begins_at_its_lowest() {
        let mut elements = arch(3);
        elements.extend([3, 4, 5].map(|place| Element {
            height: if place == 4 { -50.0 } else { 10.0 },
            free_corners: Vec::new(),
            neighbours: [3, 4, 5].into_iter().filter(|other| *other != place).collect(),
        }));
        elements[2].neighbours.clear();
        let places: Vec<u32> = order(&elements).iter().map(|place| place.order).collect();
        assert_eq!(places, [0, 2, 1, 4, 3, 5]);
        assert!(order(&[]).is_empty());
    }

    proptest! {
        #[test]
        fn each_touches_what_is_up(
            heights in proptest::collection::vec(0.0f64..1000.0, 20),
            links in proptest::collection::vec((0usize..20, 0usize..20), 0..60),
        ) {
            let mut elements: Vec<Element> =
                heights.iter().map(|height| Element { height: *height, ..Element::default() }).collect();
            for (a, b) in links {
                elements[a].neighbours.push(b);
                elements[b].neighbours.push(a);
            }
            let places = order(&elements);
            let mut orders: Vec<u32> = places.iter().map(|place| place.order).collect();
            orders.sort_unstable();
            prop_assert_eq!(orders, (0u32..20).collect::<Vec<_>>());
            for (element, place) in elements.iter().zip(&places) {
                let touches = element.neighbours.iter().any(|other| places[*other].order < place.order);
                prop_assert!(place.ring == 0 || touches);
            }
        }
    }
}
