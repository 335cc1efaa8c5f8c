//! What the report is of: parameters, materials, figures, sources and their hashes.

use crate::export::html::markup::Markup;
use crate::export::html::section::opening::{decimals, scale_ratio};
use crate::export::html::table::{Cell, Column, table};
use crate::export::number::{KILOGRAMS, SQUARE_METRES};
use crate::export::report::Report;

/// Writes it.
pub(in crate::export::html) fn provenance(page: &mut Markup, report: &Report) {
    page.element("section", &[], |page| {
        page.texts("h2", &[], "Design and materials");
        parameters(page, report);
        materials(page, report);
        figures(page, report);
        page.texts("h3", &[], "Provenance");
        page.element("p", &[], |page| {
            page.text("Compiled by ifs ");
            page.texts("data", &[("value", &report.compiler), ("data-at", "/compiler")], &report.compiler);
            page.text("; design hash ");
            page.element("code", &[], |page| {
                let hash = report.design_hash.as_str();
                page.texts("data", &[("value", hash), ("data-at", "/design_hash")], hash);
            });
            if let Some(machine) = &report.machine {
                page.text("; machine ");
                page.element("code", &[], |page| {
                    page.texts("data", &[("value", machine), ("data-at", "/machine")], machine);
                });
            }
            page.text(". The same sources and parameters give the same report, byte by byte.");
        });
        let columns = [Column::text("Source", "path"), Column::text("SHA-256", "sha256")];
        table(page, "dense", "/sources", &columns, |rows| {
            for (place, source) in report.sources.iter().enumerate() {
                rows.row_of(place, [Cell::Text(&source.path), Cell::Text(&source.sha256)]);
            }
        });
    });
}

fn parameters(page: &mut Markup, report: &Report) {
    if report.parameters.is_empty() {
        return;
    }
    page.element("div", &[("class", "together")], |page| {
        page.texts("h3", &[], "Parameters");
        let columns =
            [Column::text("Parameter", "name"), Column::text("Value", "value"), Column::text("Origin", "")];
        table(page, "narrow", "/parameters", &columns, |rows| {
            for (place, parameter) in report.parameters.iter().enumerate() {
                let origin = if parameter.set { "set for this build" } else { "as in the design" };
                rows.row_of(
                    place,
                    [Cell::Text(&parameter.name), Cell::Text(&parameter.value), Cell::Text(origin)],
                );
            }
        });
    });
}

fn materials(page: &mut Markup, report: &Report) {
    if report.fabrications.is_empty() {
        return;
    }
    page.element("div", &[("class", "together")], |page| {
        page.texts("h3", &[], "Materials");
        // Parts of several fabrications may lie on one board.
        let nested = report.nested_pieces().filter(|_| report.fabrications.len() == 1);
        let columns = [
            Column::text("Figure", ""),
            Column::text("Material", ""),
            Column::number("Parts", "", ""),
            Column::number("Area", "m²", ""),
            Column::number("Mass", "kg", ""),
            Column::text("Raw material", ""),
            Column::number(if nested.is_some() { "Pieces" } else { "At least" }, "", ""),
        ];
        table(page, "", "", &columns, |rows| {
            for made in &report.fabrications {
                let material = &made.material;
                let thickness =
                    material.thickness_mm.map(|thickness| format!(", {} mm", short(thickness.value)));
                let name = format!("{}{}", material.name, thickness.unwrap_or_default());
                let raw = match (material.board_mm, material.bar_mm) {
                    (Some([length, width]), _) => {
                        format!("boards {} × {} mm", short(length.value), short(width.value))
                    }
                    (_, Some(bar)) => format!("bars of {} mm", short(bar.value)),
                    _ => String::new(),
                };
                let figure = match made.scale.value == 1.0 {
                    true => made.figure.clone(),
                    false => format!("{}, at {}", made.figure, scale_ratio(made.scale.value)),
                };
                let parts = crate::export::html::number::count(made.counts.made);
                let least = usize::try_from(material.raw_at_least).unwrap_or(usize::MAX);
                let raw_count = crate::export::html::number::count(nested.unwrap_or(least));
                rows.row([
                    Cell::Text(&figure),
                    Cell::Text(&name),
                    Cell::Text(&parts),
                    Cell::Number(Some(material.area_m2), decimals(material.area_m2, SQUARE_METRES)),
                    Cell::Number(
                        material.mass_kg,
                        material.mass_kg.map_or(0, |mass| decimals(mass, KILOGRAMS)),
                    ),
                    Cell::Text(&raw),
                    Cell::Text(&raw_count),
                ]);
            }
        });
        if nested.is_none() {
            page.texts(
                "p",
                &[("class", "small")],
                "At least so many raw pieces are as much as all parts together, without saw cuts and offcuts.",
            );
        }
    });
}

/// `12`, or `0.8`
fn short(value: f64) -> String {
    let text = crate::export::html::number::shown(value, 1);
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

fn figures(page: &mut Markup, report: &Report) {
    let made = |name: &str| {
        report.fabrications.iter().any(|made| {
            name == made.figure || name.strip_prefix(&made.figure).is_some_and(|rest| rest.starts_with('['))
        })
    };
    let plain: Vec<(usize, _)> =
        report.figures.iter().enumerate().filter(|(_, figure)| !made(&figure.name)).collect();
    if plain.is_empty() {
        return;
    }
    page.element("div", &[("class", "together")], |page| {
        page.texts("h3", &[], "Figures that nothing is made of");
        let columns = [
            Column::text("Figure", "name"),
            Column::text("Kind", "kind"),
            Column::text("Level", "level"),
            Column::number("Elements", "", "elements"),
        ];
        table(page, "narrow", "/figures", &columns, |rows| {
            for (place, figure) in plain {
                let elements = crate::export::html::number::shown(figure.elements as f64, 0);
                rows.row_of(
                    place,
                    [
                        Cell::Text(&figure.name),
                        Cell::Text(&figure.kind),
                        Cell::Text(&figure.level),
                        Cell::Text(&elements),
                    ],
                );
            }
        });
    });
}
