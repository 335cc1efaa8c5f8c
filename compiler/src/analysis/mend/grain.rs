//! Boards whose grain runs another way.

use super::{Remedies, Remedy, Worth};
use crate::analysis::fabrication::{Elements, Fabrication, PanelsMade};
use crate::analysis::measures;
use crate::analysis::requirements::{LimitValue, RequirementResult};
use crate::fabricate::panel::{Grain, PanelSettings, Panels, panels};

/// At most so many boards are made once more.
const MOST_BOARDS: usize = 20_000;

/// The other directions of the grain, with the words for them.
pub(super) fn others(made: &PanelsMade) -> impl Iterator<Item = (Grain, &'static str)> {
    let now = made.settings.grain;
    [(Grain::U, "u"), (Grain::V, "v"), (Grain::Free, "free")]
        .into_iter()
        .filter(move |(grain, _)| *grain != now)
}

/// The same boards with their grain in another direction; `None` where there are too many of them.
pub(super) fn with_grain(made: &PanelsMade, grain: Grain) -> Option<Panels> {
    if made.panels.len() + made.refused.len() > MOST_BOARDS {
        return None;
    }
    let settings = PanelSettings { grain, ..made.settings.clone() };
    let mut all = Panels::default();
    for figure in &made.figures {
        let done = panels(&figure.designed, &figure.built, &figure.labels, &settings).ok()?;
        all.panels.extend(done.panels);
        all.refused.extend(done.refused);
    }
    Some(all)
}

impl Remedies<'_> {
    /// The grain with which boards bend as far as they must.
    pub(super) fn grain_turned(
        &self,
        fabrication: &Fabrication,
        requirement: &RequirementResult,
    ) -> Option<Remedy> {
        let (name, remedy) = turned(fabrication, requirement)?;
        let fix = self.setting_put(fabrication, "grain", name);
        Some(if remedy.worth == Worth::Mends { remedy.with(fix) } else { remedy })
    }
}

fn turned(fabrication: &Fabrication, requirement: &RequirementResult) -> Option<(&'static str, Remedy)> {
    let Elements::Panels(made) = &fabrication.elements else { return None };
    if !matches!(requirement.limit, LimitValue::Grain(_)) {
        return None;
    }
    let mut best: Option<(usize, &'static str, usize)> = None;
    for (grain, name) in others(made).filter(|(grain, _)| *grain != Grain::Free) {
        let Some(turned) = with_grain(made, grain) else { continue };
        let turned = PanelsMade { panels: turned.panels, ..made.clone() };
        let result = measures::measure(&Elements::Panels(turned), requirement.measure, &requirement.limit);
        if best.is_none_or(|(failing, _, _)| result.failing < failing) {
            best = Some((result.failing, name, result.total));
        }
    }
    let (failing, name, total) = best?;
    if failing == 0 {
        let sentence = format!("with `grain: {name}` all {total} boards bend as far as they must");
        return Some((name, Remedy::mends(sentence)));
    }
    let fewer = failing < requirement.result.failing;
    let sentence = format!("with `grain: {name}` {failing} of {total} would fail");
    fewer.then(|| (name, Remedy::falls_short(sentence)))
}
