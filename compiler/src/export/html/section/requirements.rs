//! The sizes of elements against what the design requires: a histogram with the limits, and the worst elements.

use crate::export::html::draw::histogram::{Histogram, LimitLine, histogram};
use crate::export::html::markup::Markup;
use crate::export::html::number::{count_figure, shown};
use crate::export::html::section::opening::decimals;
use crate::export::html::table::{Cell, Column, table};
use crate::export::number::Fixed;
use crate::export::report::{LimitReport, Requirement};

/// Worst elements shown of one that holds, and of one that fails.
const WORST: [usize; 2] = [3, 20];

/// Writes all requirements of a fabrication.
pub(in crate::export::html) fn requirements(page: &mut Markup, all: &[Requirement], noun: &str, at: &str) {
    for (place, requirement) in all.iter().enumerate() {
        let at = format!("{at}/requirements/{place}");
        page.element("div", &[("class", "together")], |page| one(page, requirement, noun, &at));
    }
}

fn one(page: &mut Markup, requirement: &Requirement, noun: &str, at: &str) {
    page.element("h3", &[], |page| page.texts("code", &[], requirement.text.trim_start_matches("require ")));
    page.element("p", &[], |page| {
        if requirement.holds {
            page.texts("span", &[("class", "holds")], "Holds");
            page.text(" for all of ");
        } else {
            page.texts("span", &[("class", "not")], "Fails");
            page.text(" for ");
            count_figure(page, requirement.failing, &format!("{at}/failing"));
            page.text(" of ");
        }
        count_figure(page, requirement.total, &format!("{at}/total"));
        page.text(if requirement.total == 1 { " measurement" } else { " measurements" });
        if let Some((least, most)) = requirement.least.zip(requirement.most) {
            page.text("; from ");
            crate::export::html::number::figure(
                page,
                Some(least),
                measured_decimals(requirement, least),
                &format!("{at}/least"),
            );
            page.text(" to ");
            crate::export::html::number::figure(
                page,
                Some(most),
                measured_decimals(requirement, most),
                &format!("{at}/most"),
            );
            page.text(unit(requirement));
        }
        page.text(".");
    });
    if let Some(distribution) = &requirement.distribution {
        let mut limits: Vec<LimitLine> =
            requirement.limits.iter().map(|limit| line(limit, requirement)).collect();
        // Which bound holds depends on the board where there are several of one side: below all of them it surely fails.
        let least = limits
            .iter()
            .filter(|limit| limit.fails_below)
            .map(|limit| limit.value)
            .fold(f64::INFINITY, f64::min);
        limits.iter_mut().for_each(|limit| limit.fails_below &= limit.value <= least);
        let (log, unit) =
            (if distribution.logarithmic { ", logarithmic" } else { "" }, unit(requirement).trim());
        let axis_title = match unit {
            "" => format!("without unit{log}"),
            "°" => format!("degrees{log}"),
            unit => format!("{unit}{log}"),
        };
        page.element("figure", &[], |page| {
            histogram(
                page,
                &Histogram {
                    title: "How the measured values are spread, with the limits",
                    distribution,
                    at: &format!("{at}/distribution/counts"),
                    axis_title: &axis_title,
                    noun: "measurement",
                    limits: &limits,
                    most: None,
                    size: (176.0, 36.0),
                },
            );
        });
    }
    worst(page, requirement, noun, at);
}

fn worst(page: &mut Markup, requirement: &Requirement, noun: &str, at: &str) {
    let most = if requirement.holds { WORST[0] } else { WORST[1] };
    let rows: Vec<_> = requirement.worst.iter().take(most).enumerate().collect();
    if rows.is_empty() {
        return;
    }
    let placed = rows.iter().any(|(_, worst)| !worst.place.is_empty());
    let title = if requirement.holds { "Nearest to a limit" } else { "Worst" };
    let mut columns = vec![Column::text(title, "alias"), Column::text("Address", "address")];
    columns.extend(
        placed.then_some(Column::text(if noun == "plank" { "Where" } else { "Where on it" }, "place")),
    );
    columns.push(Column::number("Measured", "", "value"));
    table(page, "dense", &format!("{at}/worst"), &columns, |table| {
        for (place, worst) in rows {
            let mut cells = vec![Cell::Name(&worst.alias), Cell::Text(&worst.address)];
            cells.extend(placed.then_some(Cell::Text(&worst.place)));
            cells.push(Cell::Number(Some(worst.value), measured_decimals(requirement, worst.value)));
            table.row_of(place, cells);
        }
    });
}

fn unit(requirement: &Requirement) -> &'static str {
    match requirement.unit {
        Some("mm") => " mm",
        Some("deg") => "°",
        Some("m2") => " m²",
        Some("kg") => " kg",
        Some(other) => other,
        None => "",
    }
}

/// Decimals of a measured value, as many as say something.
fn measured_decimals(requirement: &Requirement, value: Fixed) -> usize {
    match requirement.unit {
        Some("mm") => usize::from(value.value < 10_000.0),
        Some("deg") => 2,
        Some(_) => decimals(value, value.decimals),
        None => value.decimals.min(7),
    }
}

fn line(limit: &LimitReport, requirement: &Requirement) -> LimitLine {
    let text = limit_text(limit.value, requirement);
    let words = limit.words;
    let equal = words.starts_with("equal");
    LimitLine {
        value: limit.value.value,
        text: match words.split_once(", ") {
            Some((bound, grain)) => format!("{bound} {text} {grain}"),
            None => format!("{words} {text}"),
        },
        fails_below: !requirement.holds && (equal || words.starts_with("at least") || words == "above"),
        fails_above: !requirement.holds && (equal || words.starts_with("at most") || words == "below"),
    }
}

/// The limit as short as it goes.
fn limit_text(value: Fixed, requirement: &Requirement) -> String {
    let text = shown(value.value, value.decimals);
    let short = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    format!("{short}{}", unit(requirement))
}
