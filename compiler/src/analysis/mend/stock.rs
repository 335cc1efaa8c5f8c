//! The raw board or bar that is large enough, and the grain with which boards fit.

use super::grain::{others, with_grain};
use super::{Remedies, Remedy};
use crate::analysis::fabrication::{Elements, Fabrication, PanelsMade};
use crate::fabricate::panel::{Grain, PanelRefusal};
use crate::fabricate::plank::PlankRefusal;
use crate::hir::dimension::Dimension;
use crate::hir::evaluate::quantity_words;

impl Remedies<'_> {
    /// What would let every element be cut from the raw boards or bars, with the change of the setting.
    pub(super) fn larger_stock(&self, fabrication: &Fabrication) -> Vec<Remedy> {
        let found = remedies(fabrication);
        let with = |(name, value, remedy): (&str, String, Remedy)| {
            remedy.with(self.setting_put(fabrication, name, &value))
        };
        found.into_iter().map(with).collect()
    }
}

/// The setting that would change, its value, and the sentence.
fn remedies(fabrication: &Fabrication) -> Vec<(&'static str, String, Remedy)> {
    let mut remedies = Vec::new();
    match &fabrication.elements {
        Elements::Panels(made) => {
            remedies.extend(larger_board(made));
            remedies.extend(turned(made));
        }
        Elements::Planks(made) => {
            let needed = made.refused.iter().filter_map(|refused| match refused.reason {
                PlankRefusal::TooLong { needed, .. } => Some(needed),
                _ => None,
            });
            let needed = quantity_words(whole(needed.fold(0.0, f64::max)), Dimension::LENGTH);
            let sentence = format!("bars of {needed} are long enough for all of them");
            remedies.push(("stock", needed, Remedy::mends(sentence)));
        }
    }
    remedies
}

/// The next whole millimetre above, but for rounding.
fn whole(length: f64) -> f64 {
    (length - 1e-6).ceil()
}

/// A raw board that holds all of them as they lie, in whole millimetres.
fn larger_board(made: &PanelsMade) -> Option<(&'static str, String, Remedy)> {
    let (mut length, mut width) = made.settings.board;
    for refused in &made.refused {
        let PanelRefusal::TooLarge { size, .. } = refused.reason else { continue };
        // Where the grain is free a board may lie across.
        let (x, y) = match made.settings.grain {
            Grain::Free if (size.x < size.y) != (length < width) => (size.y, size.x),
            _ => (size.x, size.y),
        };
        (length, width) = (length.max(whole(x)), width.max(whole(y)));
    }
    let [length, width] = [length, width].map(|size| quantity_words(size, Dimension::LENGTH));
    let grain = match made.settings.grain {
        Grain::Free => "",
        Grain::U | Grain::V => ", its grain along the first of the two",
    };
    let board = format!("{length} by {width}");
    let sentence = format!("a raw board of {board} is large enough for all of them{grain}");
    Some(("board", board, Remedy::mends(sentence)))
}

/// The grain with which all of them fit the raw boards there are.
fn turned(made: &PanelsMade) -> Option<(&'static str, String, Remedy)> {
    let too_large = |refused: &crate::fabricate::panel::RefusedPanel| {
        matches!(refused.reason, PanelRefusal::TooLarge { .. })
    };
    others(made)
        .find(|(grain, _)| {
            with_grain(made, *grain).is_some_and(|turned| !turned.refused.iter().any(too_large))
        })
        .map(|(_, name)| {
            let sentence = format!("with `grain: {name}` they fit the raw boards there are");
            ("grain", name.to_owned(), Remedy::mends(sentence))
        })
}
