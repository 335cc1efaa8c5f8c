//! `planarity.csv`: each quad of the panelled surfaces before and after planarizing.

use super::csv::{Cell, Table};
use super::number::Fixed;
use crate::fabricate::label::Label;
use crate::geometry::{QuadMeasure, QuadMesh, Verdict};

/// The columns.
pub const HEADERS: [&str; 12] = [
    "address",
    "alias",
    "planarity_before",
    "planarity_after",
    "fold_before_deg",
    "fold_after_deg",
    "diagonal_ratio_before",
    "diagonal_ratio_after",
    "area_before_m2",
    "area_after_m2",
    "moved_mm",
    "verdict",
];

/// A panelled surface. `labels` has one entry for each quad, and both meshes have the same quads.
#[derive(Debug, Clone, Copy)]
pub struct Surface<'a> {
    /// As designed.
    pub designed: &'a QuadMesh,
    /// With its vertices moved; the designed mesh itself where nothing was planarized.
    pub planarized: &'a QuadMesh,
    /// The names of the quads.
    pub labels: &'a [Label],
}

/// The quads of all surfaces in their order. The verdict is that on the planarized quad; `moved` is the corner that
/// moved most.
#[must_use]
pub fn planarity_csv(surfaces: &[Surface<'_>]) -> String {
    let mut table = Table::new(&HEADERS);
    for surface in surfaces {
        let quads = surface.designed.quads.len().min(surface.planarized.quads.len());
        for (quad, label) in surface.labels.iter().enumerate().take(quads) {
            let corners = [surface.designed.corners_of(quad), surface.planarized.corners_of(quad)];
            let measures = corners.map(QuadMeasure::of);
            let both = |figure: fn(&QuadMeasure) -> Option<Fixed>| {
                [Cell::from(figure(&measures[0])), Cell::from(figure(&measures[1]))]
            };
            let moved = corners[0].iter().zip(corners[1]).map(|(from, to)| from.distance(to));
            let mut cells = vec![Cell::Text(&label.address), Cell::Text(&label.alias)];
            cells.extend(both(|measure| measure.planarity.map(Fixed::planarity)));
            cells.extend(both(|measure| measure.fold().map(Fixed::degrees)));
            cells.extend(both(|measure| measure.diagonal_ratio.map(Fixed::ratio)));
            cells.extend(both(|measure| Some(Fixed::square_metres(measure.area))));
            cells.push(Cell::Number(Fixed::mm(moved.fold(0.0, f64::max))));
            cells.push(Cell::Text(verdict_name(measures[1].verdict)));
            table.row(cells);
        }
    }
    table.finish()
}

/// The name of a verdict in lists and reports.
#[must_use]
pub const fn verdict_name(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Convex => "convex",
        Verdict::Dart => "dart",
        Verdict::CollinearCorner => "collinear corner",
        Verdict::FoldedOver => "folded over",
        Verdict::Degenerate => "degenerate",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::samples;

    #[test]
    fn before_and_after() {
        let planarized = samples::flat_grid(2, 3, 250.0);
        let mut designed = planarized.clone();
        designed.vertices[0].z += 10.0;
        let labels: Vec<Label> = ["shell.ll-ll", "=shell"]
            .into_iter()
            .map(|address| Label { address: address.into(), alias: "s-0".into(), ..Label::default() })
            .collect();
        let surface = Surface { designed: &designed, planarized: &planarized, labels: &labels };
        assert_eq!(
            planarity_csv(&[surface]),
            "address,alias,planarity_before,planarity_after,fold_before_deg,fold_after_deg,\
             diagonal_ratio_before,diagonal_ratio_after,area_before_m2,area_after_m2,moved_mm,verdict\n\
             shell.ll-ll,s-0,0.998402556,1.000000000,3.2377,0.0000,0.014134,0.000000,0.062550,0.062500,10.000,convex\n\
             '=shell,s-0,1.000000000,1.000000000,0.0000,0.0000,0.000000,0.000000,0.062500,0.062500,0.000,convex\n"
        );
    }
}
