//! Plan and elevations at a round scale, in first-angle projection, with overall dimensions and a scale bar.

use glam::DVec2;

use super::scene::Scene;
use crate::export::html::document::Made;
use crate::export::html::draw::colour::Srgb;
use crate::export::html::draw::dimension;
use crate::export::html::draw::paper::{Anchor, group, letters, svg};
use crate::export::html::draw::scale_bar::{round_denominator, scale_bar, scale_words};
use crate::export::html::draw::view::{Frame, View, bounds};
use crate::export::html::markup::Markup;

/// Paper, nearly: lines matter here.
const PAPER: Srgb = [1.0, 0.985, 0.955];

/// The room on a page, mm.
const ROOM: DVec2 = DVec2::new(178.0, 205.0);

/// Room around the views: at the left and below for dimensions, between them, above for titles.
const LEFT: f64 = 12.0;
const BETWEEN: DVec2 = DVec2::new(16.0, 22.0);
const HEAD: f64 = 6.0;
const FOOT: f64 = 18.0;

/// Writes them.
pub(in crate::export::html) fn views(page: &mut Markup, made: &Made<'_>) {
    let scene = Scene::of_made(made, PAPER);
    let sizes = [View::FRONT, View::SIDE, View::PLAN]
        .map(|view| bounds(view, scene.points()).map_or(DVec2::ZERO, |(low, high)| high - low));
    let [front, side, plan] = sizes;
    let across = (front.x + side.x) / (ROOM.x - LEFT - BETWEEN.x - 4.0);
    let down = (front.y + plan.y) / (ROOM.y - HEAD - BETWEEN.y - FOOT);
    if across.max(down) <= 0.0 {
        return;
    }
    let denominator = round_denominator(across.max(down));
    let scale = 1.0 / denominator;
    let layout = Layout { scale, sizes: sizes.map(|size| size * scale) };
    page.element("figure", &[("class", "sheet")], |page| {
        svg(page, (ROOM.x, layout.height()), "Plan and elevations", |page| layout.draw(page, &scene, sizes));
        let caption = format!(
            "Front elevation, side elevation, and plan below (first-angle projection). {} when printed on A4 without scaling; dimensions in mm. {}",
            scale_words(denominator),
            scene.notes()
        );
        page.texts("figcaption", &[], caption.trim());
    });
}

struct Layout {
    scale: f64,
    /// Of the front, the side and the plan, on paper.
    sizes: [DVec2; 3],
}

impl Layout {
    fn height(&self) -> f64 {
        HEAD + self.sizes[0].y + BETWEEN.y + self.sizes[2].y + FOOT
    }

    /// The upper left corners of the front, the side and the plan.
    fn corners(&self) -> [DVec2; 3] {
        let [front, side, _] = self.sizes;
        let width = front.x + BETWEEN.x + side.x;
        let left = LEFT + ((ROOM.x - LEFT - width) / 2.0).max(0.0);
        let corner = DVec2::new(left, HEAD);
        [corner, corner + DVec2::X * (front.x + BETWEEN.x), corner + DVec2::Y * (front.y + BETWEEN.y)]
    }

    fn draw(&self, page: &mut Markup, scene: &Scene, real: [DVec2; 3]) {
        let corners = self.corners();
        let views = [(View::FRONT, "Front"), (View::SIDE, "Side"), (View::PLAN, "Plan")];
        for (place, (view, title)) in views.into_iter().enumerate() {
            let Some(frame) = Frame::scaled(view, scene.points(), self.scale) else { continue };
            group(page, "flat", |page| scene.paint(page, &frame.moved_to(corners[place])));
            letters(page, corners[place] - DVec2::Y * 2.2, 2.9, Anchor::Start, "note", title);
        }
        let low = |place: usize| corners[place] + DVec2::Y * self.sizes[place].y;
        let under = |page: &mut Markup, place: usize| {
            let (from, size) = (low(place) + DVec2::Y * 6.0, self.sizes[place]);
            dimension::below(page, from, from + DVec2::X * size.x, real[place].x);
        };
        under(page, 1);
        under(page, 2);
        for place in [0, 2] {
            let from = low(place) - DVec2::X * 6.0;
            dimension::beside(page, from, from - DVec2::Y * self.sizes[place].y, real[place].y);
        }
        let bar = DVec2::new(corners[2].x, low(2).y + 11.0);
        scale_bar(page, bar, self.scale);
    }
}
