//! The model of a design: every figure in space with what is made of it.

use crate::analysis::LimitValue;
use crate::analysis::{
    Analysis, Elements, Fabrication, FigureGeometry, PanelsMade, figure_geometry, piece_labels,
};
use crate::export::glb::{
    Curve, Figure, GlbError, MAX_PART_NODES, Model, Panelled, Part, Pieces, Surface, write_glb,
};
use crate::fabricate::checks::Limit;
use crate::fabricate::label::Label;
use crate::geometry::QuadMesh;
use crate::hir::schema::Measure;
use crate::hir::tree::ItemId;
use crate::plan::evaluate::PiecesEvaluator;
use crate::planarize::Perturbation;
use glam::DVec3;
use std::io;

/// A model with everything it shows.
#[derive(Debug)]
pub(super) struct OwnedModel {
    design: String,
    figures: Vec<OwnedFigure>,
}

#[derive(Debug)]
struct OwnedFigure {
    name: String,
    source: Option<String>,
    curves: Vec<(String, Vec<DVec3>)>,
    surfaces: Vec<OwnedSurface>,
    pieces: Vec<OwnedPieces>,
    made: Option<Fabrication>,
}

#[derive(Debug)]
struct OwnedSurface {
    address: String,
    designed: QuadMesh,
    built: Option<(QuadMesh, f64)>,
}

#[derive(Debug)]
struct OwnedPieces {
    address: String,
    evaluator: Box<PiecesEvaluator>,
    labels: Vec<Label>,
}

impl OwnedModel {
    pub(super) fn of(analysis: &Analysis) -> Self {
        let design = analysis.design_name();
        let Some(lowered) = &analysis.plan else { return OwnedModel { design, figures: Vec::new() } };
        let mut items: Vec<ItemId> = lowered.sources.iter().map(|source| source.item).collect();
        items.dedup();
        let figures = items.into_iter().map(|item| figure(analysis, item)).collect();
        OwnedModel { design, figures }
    }

    pub(super) fn write(&self, mut out: &mut dyn io::Write) -> Result<(), GlbError> {
        let figures = self.figures.iter().map(OwnedFigure::borrowed).collect();
        write_glb(&Model { design: &self.design, figures }, &mut out)
    }
}

fn figure(analysis: &Analysis, item: ItemId) -> OwnedFigure {
    let declared = analysis.hir.item(item);
    let made = analysis.fabrications.iter().find(|made| made.figure == declared.name).cloned();
    let mut out = OwnedFigure {
        name: declared.name.clone(),
        source: source_line(analysis, item),
        curves: Vec::new(),
        surfaces: Vec::new(),
        pieces: Vec::new(),
        made,
    };
    let Some(lowered) = &analysis.plan else { return out };
    for (place, source) in lowered.sources.iter().enumerate().filter(|(_, source)| source.item == item) {
        let address = match source.index {
            Some(index) => format!("{}.{index}", declared.name),
            None => declared.name.clone(),
        };
        let built = out.made.as_ref().and_then(|made| built(made, place));
        if let Some((designed, built)) = built {
            out.surfaces.push(OwnedSurface { address, designed, built: Some(built) });
            continue;
        }
        if let Some(points) = out.made.as_ref().and_then(|made| made_curve(made, place)) {
            out.curves.push((address, points.to_vec()));
            continue;
        }
        match figure_geometry(&lowered.plan, &lowered.plan.figures()[place]) {
            Some(FigureGeometry::Curve(points)) => out.curves.push((address, points)),
            Some(FigureGeometry::Surface(designed)) => {
                out.surfaces.push(OwnedSurface { address, designed, built: None });
            }
            Some(FigureGeometry::Pieces(evaluator)) => {
                let most = MAX_PART_NODES as u64;
                let few = lowered.counts.get(place).is_some_and(|count| count.elements <= most);
                let figure = &lowered.plan.figures()[place];
                let labels = if few { piece_labels(&lowered.plan, figure, &evaluator) } else { Vec::new() };
                out.pieces.push(OwnedPieces { address, evaluator, labels });
            }
            None => {}
        }
    }
    out
}

/// The surface of a block at a place of the plan: as designed, as built, and what planarity it needs.
fn built(made: &Fabrication, place: usize) -> Option<(QuadMesh, (QuadMesh, f64))> {
    let Elements::Panels(panels) = &made.elements else { return None };
    let figure = panels.figures.iter().find(|figure| figure.figure == place)?;
    Some((figure.designed.clone(), (figure.built.clone(), built_planarity(made, panels))))
}

/// The curve of a block at a place of the plan, at the block's scale.
fn made_curve(made: &Fabrication, place: usize) -> Option<&[DVec3]> {
    let Elements::Planks(planks) = &made.elements else { return None };
    let figure = planks.figures.iter().find(|figure| figure.figure == place)?;
    Some(&figure.points)
}

/// The places in the plan of figures nothing is made of.
pub(super) fn plain_figures(analysis: &Analysis) -> impl Iterator<Item = usize> + '_ {
    let sources = analysis.plan.iter().flat_map(|lowered| lowered.sources.iter().enumerate());
    let made =
        |item: ItemId| analysis.fabrications.iter().any(|made| made.figure == analysis.hir.item(item).name);
    sources.filter(move |(_, source)| !made(source.item)).map(|(place, _)| place)
}

/// The planarity in the middle of the colour scale: what the block requires, else what planarizing aims at.
pub(super) fn built_planarity(made: &Fabrication, panels: &PanelsMade) -> f64 {
    let mut limits = made.requirements.iter().filter(|requirement| requirement.measure == Measure::Planarity);
    let least = limits.find_map(|requirement| match requirement.limit {
        LimitValue::Plain(Limit::AtLeast(least) | Limit::Within(least, _) | Limit::Above(least)) => {
            Some(least)
        }
        _ => None,
    });
    let aim = panels.perturbation.as_ref().map(|options| options.threshold);
    least.or(aim).unwrap_or_else(|| Perturbation::default().threshold)
}

/// `shell.ifs:12`
fn source_line(analysis: &Analysis, item: ItemId) -> Option<String> {
    let span = analysis.hir.item(item).name_span;
    let source = analysis.sources.get(span.file)?;
    let line = source.lines.bytes(span.start).line + 1;
    match span.file == analysis.root {
        true => Some(format!("{}.ifs:{line}", analysis.design_name())),
        false => Some(format!("{}:{line}", source.path)),
    }
}

impl OwnedFigure {
    fn borrowed(&self) -> Figure<'_> {
        let curves = self.curves.iter().map(|(address, points)| Curve { address, points });
        let surfaces = self.surfaces.iter().map(|surface| Surface {
            address: &surface.address,
            designed: &surface.designed,
            panelled: surface
                .built
                .as_ref()
                .map(|(planarized, required)| Panelled { planarized, required: *required }),
        });
        let pieces = self.pieces.iter().map(|pieces| Pieces {
            address: &pieces.address,
            evaluator: &pieces.evaluator,
            labels: &pieces.labels,
        });
        let parts: Vec<Part<'_>> = match self.made.as_ref().map(|made| &made.elements) {
            Some(Elements::Panels(made)) => made.panels.iter().map(Part::from).collect(),
            Some(Elements::Planks(made)) => made.planks.iter().map(Part::from).collect(),
            None => Vec::new(),
        };
        Figure {
            name: &self.name,
            source: self.source.as_deref(),
            curves: curves.collect(),
            surfaces: surfaces.collect(),
            pieces: pieces.collect(),
            parts,
        }
    }
}
