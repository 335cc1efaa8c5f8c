//! `report.html`: what a build made of a design, for people, in one file that needs no other and no network. It is
//! well-formed XML too, has no script, and prints on A4. All figures are those of report.json; the shapes are those of the
//! model. Nothing is measured here.

mod cells;
mod document;
mod draw;
mod markup;
mod number;
mod section;
mod table;

pub use document::{CurveShape, Document, Made, PanelShapes, Plain, PlankShapes, SurfaceShape};

use markup::Markup;

/// What a browser may load: the style sheet in the file, and nothing else.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'";

/// The bytes of `report.html`.
#[must_use]
pub fn html(document: &Document<'_>) -> String {
    let mut page = Markup::html();
    let attributes = [("xmlns", "http://www.w3.org/1999/xhtml"), ("lang", "en")];
    page.element("html", &attributes, |page| {
        page.element("head", &[], |page| {
            page.empty("meta", &[("charset", "utf-8")]);
            page.empty("meta", &[("http-equiv", "Content-Security-Policy"), ("content", POLICY)]);
            page.empty("meta", &[("name", "viewport"), ("content", "width=device-width, initial-scale=1")]);
            page.texts("title", &[], &format!("{} – report", document.report.design));
            page.style(include_str!("style.css"));
        });
        page.element("body", &[], |page| body(page, document));
    });
    page.finish()
}

fn body(page: &mut Markup, document: &Document<'_>) {
    section::opening::opening(page, document);
    section::provenance::provenance(page, document.report);
    for (place, made) in document.made.iter().enumerate() {
        if let Some(fabrication) = document.report.fabrications.get(place) {
            section::fabrication::fabrication(page, (place, fabrication), made);
        }
    }
    page.element("footer", &[], |page| {
        page.text("Lengths in millimetres, angles in degrees, unless another unit is given. Figures are rounded; report.json has all digits.");
    });
}

#[cfg(test)]
mod tests;
