//! The thickness of boards at which they bend, or are light enough; the density at which they are.

use super::{Remedies, Remedy};
use crate::analysis::fabrication::{Elements, Fabrication};
use crate::analysis::requirements::{LimitValue, RequirementResult, evaluate_limit};
use crate::analysis::{measures, settings, value_words};
use crate::diagnostic::Fix;
use crate::fabricate::checks::Limit;
use crate::hir::dimension::Dimension;
use crate::hir::evaluate::{Evaluator, quantity_words};
use crate::hir::scalar::Scalar;
use crate::hir::schema::Measure;
use crate::hir::tree::{Expr, ExprKind, Fabricate, Hir, ItemKind, is_literal};
use crate::hir::types::Type;

/// Thicknesses are tried in steps of so many tenths of a millimetre.
const TENTHS: i64 = 5;

/// At most so many of them.
const MOST_TRIES: i64 = 120;

/// At most so many boards are looked at for all of them together.
const MOST_BOARDS: usize = 400_000;

/// A thickness that was tried.
struct Tried {
    /// mm
    thickness: f64,
    /// What the requirement then gives.
    requirement: RequirementResult,
}

impl Remedies<'_> {
    /// The largest thickness below the present one at which the requirement at `place` holds, with all else as it is;
    /// where there is none, what the thinnest board gives that the material comes in.
    pub(super) fn thinner(&self, fabrication: &Fabrication, place: usize) -> Option<Remedy> {
        let Elements::Panels(made) = &fabrication.elements else { return None };
        let block = self
            .hir
            .fabricates
            .iter()
            .find(|block| self.hir.item(block.figure).name == fabrication.figure)?;
        let asked = fabrication.requirements.get(place)?;
        if asked.measure == Measure::Mass && asked.result.below > 0 {
            return None;
        }
        let given = block.settings.iter().find(|setting| setting.name == "material")?;
        let (call, thickness_at) = call_with_thickness(self.hir, &given.value)?;
        let now = made.settings.material.thickness?;
        let tries = MOST_TRIES.min((MOST_BOARDS / made.panels.len().max(1)) as i64);
        let start = (now * 10.0 / TENTHS as f64 - 1e-6).ceil() as i64 - 1;
        let mut thinnest: Option<Tried> = None;
        for step in (1..=start).rev().take(usize::try_from(tries).ok()?) {
            let thickness = Scalar::integer(step * TENTHS).over(&Scalar::integer(10)).ok()?;
            let Some(tried) =
                self.with_thickness(fabrication, block, place, (&call, thickness_at), thickness)
            else {
                break;
            };
            if tried.requirement.result.holds() {
                let then = quantity_words(tried.thickness, Dimension::LENGTH);
                let title = format!(
                    "make the boards {then} thick instead of {}",
                    quantity_words(now, Dimension::LENGTH)
                );
                let place = argument(&given.value, thickness_at).map(|place| place.span);
                let fix = place.map(|place| Fix::titled(title).with(place, then));
                let words = call_words(self.hir, &call, tried.thickness);
                return Some(Remedy::mends(format!("thinner boards do: `{words}`")).with(fix));
            }
            thinnest = Some(tried);
        }
        // A limit that does not ask for the material's own is missed by as much at every thickness.
        let tried = thinnest?;
        let requirement = &fabrication.requirements[place];
        let changes =
            tried.requirement.result != requirement.result || tried.requirement.limit != requirement.limit;
        changes.then(|| {
            let worst = tried.requirement.result.measured.first();
            let worst = worst.map_or_else(String::new, |worst| {
                let value = value_words(requirement.measure, worst.value);
                let place = if worst.place.is_empty() { String::new() } else { format!(", {}", worst.place) };
                format!(" ({} has {value}{place})", worst.alias)
            });
            Remedy::falls_short(format!(
                "thinner boards are not enough: with {} {} of {} still fail{worst}",
                quantity_words(tried.thickness, Dimension::LENGTH),
                tried.requirement.result.failing,
                tried.requirement.result.total
            ))
        })
    }

    fn with_thickness(
        &self,
        fabrication: &Fabrication,
        block: &Fabricate,
        place: usize,
        (call, thickness_at): (&Expr, usize),
        thickness: Scalar,
    ) -> Option<Tried> {
        let millimetres = thickness.to_f64()?;
        let mut evaluator = Evaluator::new(self.hir, self.overrides);
        let call = with_argument(call, thickness_at, thickness);
        let material = evaluator.in_block(&call, block.slots, None).ok()?;
        let requirement = block.requirements.get(place)?;
        let limit =
            evaluate_limit(self.hir, &mut evaluator, block, requirement, Some(&material), &mut Vec::new())?;
        let result = match (&fabrication.elements, requirement.measure) {
            // The bend of a board does not depend on its thickness, its mass does.
            (Elements::Panels(made), Measure::Mass) => {
                let mut made = made.clone();
                let material = settings::material(self.hir, &material);
                for panel in &mut made.panels {
                    panel.mass = material
                        .density
                        .map(|density| density * panel.volume / panel.thickness * millimetres);
                }
                measures::measure(&Elements::Panels(made), requirement.measure, &limit)
            }
            (elements, measure) => measures::measure(elements, measure, &limit),
        };
        let requirement =
            RequirementResult { measure: requirement.measure, span: requirement.span, limit, result };
        Some(Tried { thickness: millimetres, requirement })
    }
}

/// The density at which every element is light enough.
pub(super) fn lighter(fabrication: &Fabrication, requirement: &RequirementResult) -> Option<Remedy> {
    let density = match &fabrication.elements {
        Elements::Panels(made) => made.settings.material.density?,
        Elements::Planks(made) => made.settings.material.density?,
    };
    let (
        LimitValue::Plain(Limit::AtMost(most) | Limit::Within(_, most) | Limit::Below(most)),
        Some((_, heaviest)),
    ) = (requirement.limit, requirement.result.extremes)
    else {
        return None;
    };
    if requirement.result.below > 0 || heaviest <= 0.0 || most <= 0.0 {
        return None;
    }
    // Whole kilograms by cubic metre, the next lower one.
    let enough = (density * 1e9 * most / heaviest + 1e-6).floor();
    let now = (density * 1e9).round();
    (enough >= 50.0).then(|| {
        Remedy::mends(format!(
            "a material of {enough}kg/m3 is light enough at the same size; now it is {now}kg/m3"
        ))
    })
}

/// The call that makes a material, and the place of its argument for the thickness.
fn call_with_thickness(hir: &Hir, material: &Expr) -> Option<(Expr, usize)> {
    let (fields, arguments) = match &material.kind {
        ExprKind::Call(item, arguments) => match &hir.item(*item).kind {
            ItemKind::Function(function) => (&function.parameters, arguments),
            _ => return None,
        },
        ExprKind::Record(item, arguments) => match &hir.item(*item).kind {
            ItemKind::Record(fields) => (fields, arguments),
            _ => return None,
        },
        ExprKind::Global(item) => match &hir.item(*item).kind {
            ItemKind::Let(body) => return call_with_thickness(hir, &body.value),
            _ => return None,
        },
        _ => return None,
    };
    let place = fields.iter().position(|field| field.name == "thickness" && field.ty == Type::LENGTH)?;
    // A thickness that follows from parameters is theirs to move.
    let given = arguments.get(place)?;
    matches!(given.kind, ExprKind::Scalar(_)).then(|| (material.clone(), place))
}

/// The number given for the thickness where the material is called in the block itself.
fn argument(call: &Expr, place: usize) -> Option<&Expr> {
    let (ExprKind::Call(_, arguments) | ExprKind::Record(_, arguments)) = &call.kind else { return None };
    arguments.get(place).filter(|argument| is_literal(argument))
}

fn with_argument(call: &Expr, place: usize, value: Scalar) -> Expr {
    let mut call = call.clone();
    if let ExprKind::Call(_, arguments) | ExprKind::Record(_, arguments) = &mut call.kind
        && let Some(argument) = arguments.get_mut(place)
    {
        argument.kind = ExprKind::Scalar(value);
    }
    call
}

/// `birch_plywood(6.5mm)`, or the name and its thickness where there are more arguments.
fn call_words(hir: &Hir, call: &Expr, thickness: f64) -> String {
    let length = quantity_words(thickness, Dimension::LENGTH);
    match &call.kind {
        ExprKind::Call(item, arguments) if arguments.len() == 1 => {
            format!("{}({length})", hir.item(*item).name)
        }
        ExprKind::Call(item, _) | ExprKind::Record(item, _) => {
            format!("{}(thickness: {length}, …)", hir.item(*item).name)
        }
        _ => length,
    }
}
