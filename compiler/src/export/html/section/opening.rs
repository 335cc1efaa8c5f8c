//! The first page: what it is, whether it can be built, the figures that matter, and a picture.

use super::scene::Scene;
use crate::export::html::document::Document;
use crate::export::html::markup::Markup;
use crate::export::html::number::{count, count_figure, counted, figure, shown};
use crate::export::number::{Fixed, KILOGRAMS, SQUARE_METRES};
use crate::export::report::{Fabrication, Report};

/// Writes it.
pub(in crate::export::html) fn opening(page: &mut Markup, document: &Document<'_>) {
    let report = document.report;
    page.element("header", &[], |page| {
        page.texts("p", &[("class", "kicker")], "Fabrication report");
        page.texts("h1", &[], &report.design);
        if !report.summary.is_empty() {
            page.texts("p", &[("class", "summary")], &report.summary);
        }
        verdict(page, report);
    });
    // Several fabrications have a row each in the table of materials.
    if let [made] = &report.fabrications[..] {
        facts(page, made, report.nested_pieces());
    }
    let mut scales: Vec<f64> = report.fabrications.iter().map(|made| made.scale.value).collect();
    if scales.is_empty() || !document.plain.is_empty() {
        scales.push(1.0);
    }
    scales.sort_by(f64::total_cmp);
    scales.dedup();
    for scale in scales.into_iter().rev() {
        let caption = match (scale == 1.0, report.fabrications.is_empty()) {
            (true, true) => "The design.".to_owned(),
            (true, false) => "What is built, in axonometric view.".to_owned(),
            (false, _) => format!("The model at {}, in axonometric view.", scale_ratio(scale)),
        };
        Scene::at_scale(document, scale).picture(page, (178.0, 98.0), "The design in space", &caption);
    }
}

/// `1:20`
pub(in crate::export::html) fn scale_ratio(scale: f64) -> String {
    crate::export::html::draw::scale_bar::scale_words(1.0 / scale)
}

fn verdict(page: &mut Markup, report: &Report) {
    let made = &report.fabrications;
    let required: usize = made.iter().map(|made| made.requirements.len()).sum();
    let failing: usize =
        made.iter().flat_map(|made| &made.requirements).filter(|requirement| !requirement.holds).count();
    let refused: usize = made.iter().map(|made| made.counts.refused).sum();
    let elements: usize = made.iter().map(|made| made.counts.made).sum();
    let holds = made.iter().all(Fabrication::holds);
    let class = if holds { "verdict" } else { "verdict fails" };
    page.element("div", &[("class", class), ("data-holds", if holds { "true" } else { "false" })], |page| {
        if made.is_empty() {
            page.texts("p", &[("class", "word")], "Drawn, not fabricated");
            page.texts("p", &[], "The design asks for no boards or planks: there is nothing to cut.");
            return;
        }
        page.texts(
            "p",
            &[("class", "word")],
            if holds { "Can be built" } else { "Cannot be built as it is" },
        );
        let requirements = match (required, failing) {
            (0, _) => "The design requires nothing of them.".to_owned(),
            (1, 0) => "The one requirement of the design holds.".to_owned(),
            (_, 0) => format!("All {} of the design hold.", counted(required, "requirement")),
            (_, 1) => format!("1 of {} fails.", counted(required, "requirement")),
            _ => format!("{failing} of {} fail.", counted(required, "requirement")),
        };
        let noun = noun(made);
        let parts = match refused {
            0 if elements == 1 => format!("The one {noun} can be made."),
            0 => format!("All {} can be made.", counted(elements, noun)),
            _ => format!("{} can be made, {} refused.", counted(elements, noun), refused_words(refused)),
        };
        page.texts("p", &[], &format!("{parts} {requirements}"));
    });
}

fn refused_words(refused: usize) -> String {
    if refused == 1 {
        "1 is".to_owned()
    } else {
        format!("{} are", crate::export::html::number::count(refused))
    }
}

/// `board`, `plank`, or `part` where there are both.
fn noun(made: &[Fabrication]) -> &'static str {
    let all = |kind: &str| made.iter().all(|made| made.kind == kind);
    match (all("panels"), all("planks")) {
        (true, _) => "board",
        (_, true) => "plank",
        _ => "part",
    }
}

/// The figures of the only fabrication in one row; `nested`: the raw boards or bars it takes, where they are known.
fn facts(page: &mut Markup, made: &Fabrication, nested: Option<usize>) {
    let at = |field: &str| format!("/fabrications/0/{field}");
    let planks = made.kind == "planks";
    let material = &made.material;
    page.element("dl", &[("class", "facts")], |page| {
        fact(page, if planks { "planks" } else { "boards" }, "", |page| {
            count_figure(page, made.counts.made, &at("counts/made"));
        });
        match material.length_mm {
            // Metres of plank; the figure of the report is in mm.
            Some(length) => {
                fact(page, "along their axes", "m", |page| page.text(&shown(length.value / 1000.0, 1)))
            }
            None => fact(page, "area", "m²", |page| {
                let area = material.area_m2;
                figure(page, Some(area), decimals(area, SQUARE_METRES), &at("material/area_m2"));
            }),
        }
        if let Some(mass) = material.mass_kg {
            fact(page, "mass", "kg", |page| {
                figure(page, Some(mass), decimals(mass, KILOGRAMS), &at("material/mass_kg"));
            });
        }
        let raw = if planks { "raw bars" } else { "raw boards" };
        if let Some(sheets) = nested {
            fact(page, raw, "", |page| page.text(&count(sheets)));
            return;
        }
        fact(page, &format!("{raw} at least"), "", |page| {
            let least = usize::try_from(material.raw_at_least).unwrap_or(usize::MAX);
            count_figure(page, least, &at("material/raw_at_least"));
        });
    });
}

fn fact(page: &mut Markup, name: &str, unit: &str, inside: impl FnOnce(&mut Markup)) {
    page.element("div", &[], |page| {
        page.texts("dt", &[], name);
        page.element("dd", &[], |page| {
            inside(page);
            if !unit.is_empty() {
                page.text(" ");
                page.texts("span", &[("class", "unit")], unit);
            }
        });
    });
}

/// Decimals that leave three or four digits to read.
pub(in crate::export::html) fn decimals(number: Fixed, most: usize) -> usize {
    match number.value.abs() {
        size if size >= 100.0 => 0,
        size if size >= 10.0 => 1,
        size if size >= 1.0 => 2,
        _ => most.min(3),
    }
}
