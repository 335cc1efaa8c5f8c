//! The material of a block: whether its figures can be those of a material.

use super::Work;
use crate::analysis::settings;
use crate::fabricate::material::Material;
use crate::hir::dimension::Dimension;
use crate::hir::evaluate::quantity_words;
use crate::hir::schema::SchemaKind;

/// The greatest density, kg/mm³. The densest matter, osmium, has 22 590 kg/m³.
const MOST_DENSITY: f64 = 25_000e-9;

impl Work<'_> {
    /// `None` after a report of a figure that no material has.
    pub(super) fn check_material(&mut self) -> Option<()> {
        let Some((_, value, _)) = self.setting("material") else { return Some(()) };
        let material = settings::material(self.hir, value);
        let Some(why) = wrong(&material, self.block.kind) else { return Some(()) };
        self.refuse("material", &why);
        None
    }
}

/// Why there is no such material.
fn wrong(material: &Material, kind: SchemaKind) -> Option<String> {
    let name = &material.name;
    if let Some(density) = material.density.filter(|density| !(*density > 0.0 && *density <= MOST_DENSITY)) {
        let most = quantity_words(MOST_DENSITY, Dimension::DENSITY);
        let found = quantity_words(density, Dimension::DENSITY);
        return Some(format!("the density of {name} is {found}, must be above 0kg/m3 and at most {most}"));
    }
    // Boards need one, and say so themselves.
    let planks = kind == SchemaKind::Planks;
    if let Some(thickness) = material.thickness.filter(|thickness| planks && !above_zero(*thickness)) {
        let found = quantity_words(thickness, Dimension::LENGTH);
        return Some(format!("the thickness of {name} is {found}, must be above 0mm"));
    }
    let radius = material.least_bend_radius?;
    let (which, radius) = [("across", radius.across), ("along", radius.along)]
        .into_iter()
        .find(|(_, radius)| !(*radius >= 0.0 && radius.is_finite()))?;
    let found = quantity_words(radius, Dimension::LENGTH);
    Some(format!("the least bend radius of {name} {which} the grain is {found}, must be 0mm or more"))
}

fn above_zero(length: f64) -> bool {
    length > 0.0 && length.is_finite()
}
