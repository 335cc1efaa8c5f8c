//! The part of the report on one fabrication.

use super::{assembly_boards, assembly_planks, cut_list, planarity, refused, requirements, views};
use crate::export::html::document::Made;
use crate::export::html::markup::Markup;
use crate::export::html::number::counted;
use crate::export::html::section::opening::scale_ratio;
use crate::export::report::Fabrication;

/// Writes the part on the fabrication at a place of the report.
pub(in crate::export::html) fn fabrication(
    page: &mut Markup,
    (place, fabrication): (usize, &Fabrication),
    made: &Made<'_>,
) {
    let noun = if fabrication.kind == "planks" { "plank" } else { "board" };
    let count = counted(fabrication.counts.made, noun);
    let scale = match fabrication.scale.value == 1.0 {
        true => String::new(),
        false => format!(" at {}", scale_ratio(fabrication.scale.value)),
    };
    let at = format!("/fabrications/{place}");
    let title = |what: &str| format!("{}: {what}", fabrication.figure);
    page.element("section", &[], |page| {
        page.texts("h2", &[], &title(&format!("{count} of {}{scale}", fabrication.material.name)));
        views::views(page, made);
    });
    if let (Some(planarity), Made::Panels(panels)) = (&fabrication.planarity, made) {
        page.element("section", &[("class", "page")], |page| {
            page.texts("h2", &[], &title("planarity"));
            planarity::planarity(page, planarity, panels, &format!("{at}/planarity"));
        });
    }
    if !fabrication.requirements.is_empty() {
        page.element("section", &[], |page| {
            page.texts("h2", &[], &title("what is required"));
            requirements::requirements(page, &fabrication.requirements, noun, &at);
        });
    }
    if fabrication.counts.refused > 0 {
        page.element("section", &[], |page| {
            page.texts("h2", &[], &title("refused"));
            refused::refused(page, fabrication, &at);
        });
    }
    page.element("section", &[], |page| {
        page.texts("h2", &[], &title("assembly"));
        match made {
            Made::Panels(panels) => assembly_boards::assembly(page, panels),
            Made::Planks(planks) => assembly_planks::assembly(page, planks),
        }
    });
    page.element("section", &[], |page| {
        page.texts("h2", &[], &title("cut list"));
        cut_list::cut_list(page, fabrication, &at);
    });
}
