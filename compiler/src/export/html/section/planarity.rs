//! Planarity before and after: maps on one scale, histograms, convergence, how far vertices moved, and the figures.

use super::surface_map::Maps;
use crate::export::glb::colour::Scale;
use crate::export::html::document::{PanelShapes, SurfaceShape};
use crate::export::html::draw::colour::distance;
use crate::export::html::draw::convergence::convergence;
use crate::export::html::draw::histogram::{Histogram, LimitLine, histogram};
use crate::export::html::draw::legend::{Mark, legend};
use crate::export::html::markup::Markup;
use crate::export::html::number::{count_figure, figure, shown};
use crate::export::number::Fixed;
use crate::export::report::{At, PlanarityReport, SurfaceSummary};
use crate::geometry::QuadMeasure;

/// Writes it.
pub(in crate::export::html) fn planarity(
    page: &mut Markup,
    report: &PlanarityReport,
    panels: &PanelShapes<'_>,
    at: &str,
) {
    words(page, report, at);
    let maps = Maps::of(panels);
    planarity_maps(page, &maps, panels.required, report.moved.count > 0);
    histograms(page, report, panels.required, at);
    if let Some(planarize) = &report.planarize {
        page.element("div", &[("class", "together")], |page| {
            page.texts("h3", &[], "Convergence");
            page.element("figure", &[], |page| {
                convergence(
                    page,
                    planarize,
                    panels.required,
                    (176.0, 48.0),
                    &format!("{at}/planarize/history"),
                );
                let options: Vec<String> = planarize
                    .options
                    .iter()
                    .map(|option| format!("{} {}", option.name, option.value))
                    .collect();
                let caption = format!("Method: {}; {}.", planarize.method, options.join(", "));
                page.texts("figcaption", &[], &caption);
            });
        });
    }
    if report.moved.count > 0 {
        moved(page, report, &maps, at);
    }
    page.element("div", &[("class", "together")], |page| {
        page.texts("h3", &[], "The surface in figures");
        summary(page, report, at);
    });
}

fn words(page: &mut Markup, report: &PlanarityReport, at: &str) {
    page.element("p", &[], |page| {
        page.text("The planarity of a quad is the cosine of its fold, the larger over its two diagonals: 1 is flat. ");
        match &report.planarize {
            Some(planarize) => {
                page.text("Planarizing ended after ");
                count_figure(page, planarize.iterations as usize, &format!("{at}/planarize/iterations"));
                page.text(" iterations (");
                page.text(&planarize.stop);
                page.text("); the result is that of iteration ");
                count_figure(page, planarize.best_iteration as usize, &format!("{at}/planarize/best_iteration"));
                page.text(". It moved ");
                count_figure(page, report.moved.count, &format!("{at}/moved/count"));
                page.text(" vertices, by ");
                figure(page, Some(report.moved.max_mm), 1, &format!("{at}/moved/max_mm"));
                page.text(" mm at most and ");
                figure(page, Some(report.moved.mean_mm), 1, &format!("{at}/moved/mean_mm"));
                page.text(" mm in the mean over all.");
            }
            None => page.text("The surface is built as it was designed: nothing was planarized."),
        }
    });
}

fn planarity_maps(page: &mut Markup, maps: &Maps<'_>, required: f64, changed: bool) {
    let allowed = libm::acos(required.clamp(-1.0, 1.0));
    let scale = Scale::around(required);
    let colour = |fold: Option<f64>| scale.srgb(fold);
    let words = |fold: Option<f64>| {
        fold.map_or("not a quad that can be flat".to_owned(), |fold| {
            format!("fold {}°", shown(fold.to_degrees(), 2))
        })
    };
    let fold = |mesh: fn(&SurfaceShape<'_>, usize) -> QuadMeasure| {
        move |surface: &SurfaceShape<'_>, quad: usize| mesh(surface, quad).larger_fold()
    };
    let before = fold(|surface, quad| QuadMeasure::of(surface.designed.corners_of(quad)));
    let after = fold(|surface, quad| QuadMeasure::of(surface.built.corners_of(quad)));
    page.element("figure", &[], |page| {
        if changed {
            page.element("div", &[("class", "pair")], |page| {
                page.element("div", &[], |page| {
                    page.texts("p", &[("class", "over")], "As designed");
                    maps.draw(
                        page,
                        ("Planarity as designed", (83.0, 70.0)),
                        |surface| surface.designed,
                        &before,
                        (&colour, &words),
                    );
                });
                page.element("div", &[], |page| {
                    page.texts("p", &[("class", "over")], "As built");
                    maps.draw(
                        page,
                        ("Planarity as built", (83.0, 70.0)),
                        |surface| surface.built,
                        &after,
                        (&colour, &words),
                    );
                });
            });
        } else {
            maps.draw(page, ("Planarity", (176.0, 95.0)), |surface| surface.built, &after, (&colour, &words));
        }
        let degrees =
            |fold: f64| format!("{}°", shown(fold.to_degrees(), if allowed < 0.02 { 2 } else { 1 }));
        let marks = [
            Mark { place: 0.0, text: "0° flat".to_owned() },
            Mark {
                place: 0.5,
                text: format!("{} allowed (planarity {})", degrees(allowed), short(required)),
            },
            Mark { place: 1.0, text: format!("{} and more", degrees(2.0 * allowed)) },
        ];
        legend(page, "Fold of a quad", |place| scale.srgb(Some(place * 2.0 * allowed.max(1e-6))), &marks);
        let notes = maps.notes();
        if !notes.is_empty() {
            page.texts("figcaption", &[], &notes);
        }
    });
}

/// A planarity without zeros at its end.
fn short(planarity: f64) -> String {
    let text = shown(planarity, 9);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn histograms(page: &mut Markup, report: &PlanarityReport, required: f64, at: &str) {
    let Some(folds) = &report.folds_deg else { return };
    let allowed = libm::acos(required.clamp(-1.0, 1.0)).to_degrees();
    let limits =
        [LimitLine { value: allowed, text: "allowed".to_owned(), fails_below: false, fails_above: true }];
    let most = folds.iter().flat_map(|distribution| &distribution.counts).copied().max();
    let plot = |page: &mut Markup, place: usize, title: &str, width: f64, most| {
        histogram(
            page,
            &Histogram {
                title,
                distribution: &folds[place],
                at: &format!("{at}/folds_deg/{place}/counts"),
                axis_title: "fold, degrees",
                noun: "quad",
                limits: &limits,
                most,
                size: (width, 42.0),
            },
        );
    };
    page.element("figure", &[], |page| {
        if report.moved.count == 0 {
            plot(page, 1, "How many quads have which fold", 176.0, None);
            return;
        }
        page.element("div", &[("class", "pair")], |page| {
            for (place, title) in
                ["How many quads had which fold", "How many quads have which fold"].into_iter().enumerate()
            {
                page.element("div", &[], |page| plot(page, place, title, 83.0, most));
            }
        });
        page.texts(
            "figcaption",
            &[],
            "Quads by their fold, as designed and as built; both plots have the same axes.",
        );
    });
}

fn moved(page: &mut Markup, report: &PlanarityReport, maps: &Maps<'_>, at: &str) {
    let farthest = |surface: &SurfaceShape<'_>, quad: usize| {
        let corners = surface.designed.corners_of(quad).into_iter().zip(surface.built.corners_of(quad));
        Some(corners.map(|(from, to)| from.distance(to)).fold(0.0, f64::max))
    };
    let largest = maps.largest(&farthest);
    if largest <= 0.0 {
        return;
    }
    let colour = |moved: Option<f64>| distance(moved.unwrap_or(0.0) / largest);
    let words = |moved: Option<f64>| format!("{} mm", shown(moved.unwrap_or(0.0), 1));
    page.element("div", &[("class", "together")], |page| {
        page.texts("h3", &[], "How far the surface moved");
        page.element("figure", &[], |page| {
            maps.draw(
                page,
                ("How far the corners of each quad moved", (176.0, 88.0)),
                |surface| surface.built,
                &farthest,
                (&colour, &words),
            );
            let marks = [0.0, 0.25, 0.5, 0.75, 1.0].map(|place| Mark {
                place,
                text: format!(
                    "{}{}",
                    shown(place * largest, if largest < 10.0 { 2 } else { 1 }),
                    if place == 1.0 { " mm" } else { "" }
                ),
            });
            legend(page, "The corner that moved most", distance, &marks);
            if let Some(distances) = &report.moved.distances_mm {
                histogram(
                    page,
                    &Histogram {
                        title: "How many vertices moved how far",
                        distribution: distances,
                        at: &format!("{at}/moved/distances_mm/counts"),
                        axis_title: if distances.logarithmic {
                            "vertices that moved, mm, logarithmic"
                        } else {
                            "vertices that moved, mm"
                        },
                        noun: "vertex",
                        limits: &[],
                        most: None,
                        size: (176.0, 34.0),
                    },
                );
            }
            let notes = maps.notes();
            if !notes.is_empty() {
                page.texts("figcaption", &[], &notes);
            }
        });
    });
}

/// The figures of the surface, before and after, each with the element that has it.
fn summary(page: &mut Markup, report: &PlanarityReport, at: &str) {
    page.element("table", &[("class", "dense")], |page| {
        page.element("thead", &[], |page| {
            page.element("tr", &[], |page| {
                let heads = [("", "t"), ("As designed", "n"), ("at", "t"), ("As built", "n"), ("at", "t")];
                for (text, class) in heads {
                    page.texts("th", &[("scope", "col"), ("class", class)], text);
                }
            });
        });
        page.element("tbody", &[], |page| {
            for row in ROWS {
                page.element("tr", &[], |page| {
                    page.texts("td", &[], row.title);
                    for (when, surface) in [("before", &report.before), ("after", &report.after)] {
                        let (number, address) = (row.of)(surface);
                        page.element("td", &[("class", "n")], |page| {
                            figure(page, number, row.decimals, &format!("{at}/{when}/{}", row.field));
                        });
                        page.element("td", &[], |page| page.texts("code", &[], address.unwrap_or_default()));
                    }
                });
            }
            for (title, field, of) in COUNTS {
                if of(&report.before) + of(&report.after) == 0 {
                    continue;
                }
                page.element("tr", &[], |page| {
                    page.texts("td", &[], title);
                    for (when, surface) in [("before", &report.before), ("after", &report.after)] {
                        page.element("td", &[("class", "n")], |page| {
                            count_figure(page, of(surface), &format!("{at}/{when}/{field}"))
                        });
                        page.texts("td", &[], "");
                    }
                });
            }
        });
    });
}

struct Row {
    title: &'static str,
    field: &'static str,
    decimals: usize,
    of: for<'s> fn(&'s SurfaceSummary) -> (Option<Fixed>, Option<&'s str>),
}

fn extreme(at: &Option<At>) -> (Option<Fixed>, Option<&str>) {
    (at.as_ref().map(|at| at.value), at.as_ref().map(|at| at.address.as_str()))
}

const ROWS: [Row; 8] = [
    Row {
        title: "Worst planarity",
        field: "worst_planarity/value",
        decimals: 6,
        of: |surface| extreme(&surface.worst_planarity),
    },
    Row {
        title: "Mean planarity",
        field: "mean_planarity",
        decimals: 6,
        of: |surface| (surface.mean_planarity, None),
    },
    Row {
        title: "Largest bend over the flatter diagonal, °",
        field: "largest_fold_deg/value",
        decimals: 3,
        of: |surface| extreme(&surface.largest_fold_deg),
    },
    Row {
        title: "Mean bend, °",
        field: "mean_fold_deg",
        decimals: 3,
        of: |surface| (surface.mean_fold_deg, None),
    },
    Row {
        title: "Largest diagonal ratio",
        field: "largest_diagonal_ratio/value",
        decimals: 5,
        of: |surface| extreme(&surface.largest_diagonal_ratio),
    },
    Row {
        title: "Shortest edge, mm",
        field: "shortest_edge_mm/value",
        decimals: 1,
        of: |surface| extreme(&surface.shortest_edge_mm),
    },
    Row {
        title: "Longest edge, mm",
        field: "longest_edge_mm/value",
        decimals: 1,
        of: |surface| extreme(&surface.longest_edge_mm),
    },
    Row { title: "Area, m²", field: "area_m2", decimals: 3, of: |surface| (Some(surface.area_m2), None) },
];

/// A count of quads: its title, its field, and where it is.
type CountRow = (&'static str, &'static str, fn(&SurfaceSummary) -> usize);

const COUNTS: [CountRow; 5] = [
    ("Convex quads", "convex", |surface| surface.convex),
    ("Quads with a reflex corner", "darts", |surface| surface.darts),
    ("Quads with three corners on a line", "collinear", |surface| surface.collinear),
    ("Quads folded over", "folded_over", |surface| surface.folded_over),
    ("Quads without area", "degenerate", |surface| surface.degenerate),
];
