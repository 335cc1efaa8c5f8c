//! The nearest values of parameters, inside their ranges, at which what fails holds.

use super::levels::found;
use super::variants::{Block, Change, Confirmed, Variant};
use super::{Asked, Remedies, Remedy, Worth};
use crate::analysis::requirements::{LimitValue, RequirementResult};
use crate::hir::evaluate::{Evaluator, words};
use crate::hir::scalar::Scalar;
use crate::hir::tree::{ItemKind, Param};
use crate::hir::types::Type;

/// Into about how many steps a range is cut where the parameter names none.
const STEPS: f64 = 40.0;

/// The most values of a parameter that are tried one after another, each way.
const MOST_IN_TURN: i64 = 60;

/// How many steps beyond the nearest value are tried where planarizing makes that fail.
const FURTHER: [i64; 4] = [0, 1, 2, 4];

/// A parameter that may be moved.
#[derive(Clone)]
struct Movable {
    name: String,
    ty: Type,
    now: Scalar,
    step: Scalar,
    /// How many steps there are to the ends of the range, down and up.
    reach: [i64; 2],
}

impl Movable {
    fn value(&self, steps: i64) -> Option<Scalar> {
        self.now.plus(&self.step.times(&Scalar::integer(steps)).ok()?).ok()
    }

    fn words(&self, steps: i64) -> Option<String> {
        Some(words(&self.value(steps)?, &self.ty))
    }
}

/// What values of a parameter are tried for.
struct Scan<'a> {
    parameter: &'a Movable,
    /// What the block gives now.
    now: &'a Block,
    asked: Asked,
    /// Whether each value is planarized as it is tried.
    planarized: bool,
    /// How many values can be tried each way.
    tries: u64,
}

impl Scan<'_> {
    fn holds(&self, variant: &Variant) -> bool {
        variant.block(&self.now.figure).is_some_and(|block| block.holds(self.asked))
    }
}

impl Remedies<'_> {
    /// One remedy for each parameter that mends it; where none does, how near the best of them comes.
    pub(super) fn parameters(&mut self, figure: &str, asked: Asked) -> Vec<Remedy> {
        let Some(now) = self.now(figure).cloned() else { return Vec::new() };
        let planarized = self.needs_planarizing(&now, asked);
        let movable = self.movable();
        let mut remedies = Vec::new();
        let mut nearest: Option<(f64, String)> = None;
        // The same values for everything that fails: each variant is worked out once.
        let tries = self.variants.share(movable.len(), planarized);
        for parameter in &movable {
            let scan = Scan { parameter, now: &now, asked, planarized, tries };
            let holding: Vec<(i64, Variant)> =
                [1, -1].into_iter().filter_map(|way| self.nearest(&scan, way)).collect();
            remedies.extend(self.moving(parameter, &holding));
            if holding.is_empty() && tries > 0 {
                let best = self.best_tried(&scan);
                nearest = match (nearest, best) {
                    (Some(known), Some(best)) if best.0 >= known.0 => Some(known),
                    (known, best) => best.or(known),
                };
            }
        }
        if remedies.is_empty() {
            remedies.extend(nearest.map(|(_, sentence)| Remedy::falls_short(sentence)));
        }
        remedies
    }

    /// The remedy of moving a parameter by some numbers of steps, at which it holds.
    fn moving(&self, parameter: &Movable, holding: &[(i64, Variant)]) -> Option<Remedy> {
        let name = &parameter.name;
        let now = parameter.words(0)?;
        let (mut words, mut fixes) = (Vec::new(), Vec::new());
        for (steps, variant) in holding {
            let value = parameter.words(*steps)?;
            let broken = self.broken(variant);
            if broken.is_none() {
                fixes.extend(self.default_put(name, &now, &value));
            }
            let broken = broken.map_or_else(String::new, |broken| format!(" (but then {broken})"));
            words.push(format!("{value}{}{broken}", variant.said_before()));
        }
        let clean = holding.iter().any(|(_, variant)| self.broken(variant).is_none());
        let worth = if clean { Worth::Mends } else { Worth::Breaks };
        let sentence = format!("it holds with {name} = {}; now it is {now}", words.join(" or "));
        (!words.is_empty()).then_some(Remedy { sentence, fixes, worth })
    }

    /// Parameters of the design whose values are no numbers in a range, and so are not tried.
    pub(super) fn parameters_without_range(&self) -> Vec<String> {
        let items = self.hir.own_items().filter_map(|(_, item)| match &item.kind {
            ItemKind::Param(param) if param.range.is_none() && param.ty.dimension().is_some() => {
                Some(item.name.clone())
            }
            _ => None,
        });
        items.collect()
    }

    fn movable(&self) -> Vec<Movable> {
        let items = self.hir.own_items();
        items
            .filter_map(|(id, item)| match &item.kind {
                ItemKind::Param(param) if param.ty.dimension().is_some() => {
                    let mut evaluator = Evaluator::new(self.hir, self.overrides);
                    let now = evaluator.global(id).ok()?.scalar()?.clone();
                    movable(&mut evaluator, &item.name, param, now)
                }
                _ => None,
            })
            .collect()
    }

    fn moved(&mut self, parameter: &Movable, steps: i64, planarized: bool) -> Option<Variant> {
        let change = Change::Parameter(parameter.name.clone(), steps);
        let value = parameter.value(steps)?;
        self.variants.with(&change, Some(&value), planarized).cloned()
    }

    fn holds(&mut self, scan: &Scan<'_>, steps: i64) -> bool {
        let variant = self.moved(scan.parameter, steps, scan.planarized);
        variant.is_some_and(|variant| scan.holds(&variant))
    }

    /// The smallest number of steps that way at which it holds: step by step where that can be afforded, else in
    /// strides to the end of the range and then by halving, which finds the nearest value where it fails on one side
    /// and holds on the other. What holds on quads as they are designed is planarized, and where it fails then, some
    /// more steps are tried.
    fn nearest(&mut self, scan: &Scan<'_>, way: i64) -> Option<(i64, Variant)> {
        let reach = scan.parameter.reach[usize::from(way > 0)];
        let most = i64::try_from(scan.tries).unwrap_or(MOST_IN_TURN).min(MOST_IN_TURN);
        let mut failed = 0;
        for steps in strides(reach, most) {
            if !self.holds(scan, way * steps) {
                failed = steps;
                continue;
            }
            let mut holds = steps;
            while holds - failed > 1 {
                let between = failed + (holds - failed) / 2;
                match self.holds(scan, way * between) {
                    true => holds = between,
                    false => failed = between,
                }
            }
            let further = FURTHER.into_iter().map(|further| holds + further).filter(|steps| *steps <= reach);
            return further.into_iter().find_map(|steps| self.confirmed(scan, way * steps));
        }
        None
    }

    /// A number of steps at which it holds, with the design as it would be built where that can be afforded; `None` where
    /// it fails.
    fn confirmed(&mut self, scan: &Scan<'_>, steps: i64) -> Option<(i64, Variant)> {
        let variant = self.moved(scan.parameter, steps, scan.planarized)?;
        if variant.planarized {
            return scan.holds(&variant).then_some((steps, variant));
        }
        let change = Change::Parameter(scan.parameter.name.clone(), steps);
        let elements = variant.blocks.iter().map(|block| block.elements as u64).sum();
        match self.variants.confirmed(&change, Some(&scan.parameter.value(steps)?), elements) {
            Confirmed::Planarized(variant) => scan.holds(&variant).then_some((steps, variant)),
            Confirmed::Faulty => None,
            Confirmed::TooLong => scan.holds(&variant).then_some((steps, variant)),
        }
    }

    /// How near the best comes of what was tried of a parameter: how far it is beyond the limit, and a sentence. `None`
    /// where it is no better than now.
    fn best_tried(&mut self, scan: &Scan<'_>) -> Option<(f64, String)> {
        let Asked::Requirement(place) = scan.asked else { return None };
        for end in [-scan.parameter.reach[0], scan.parameter.reach[1]].into_iter().filter(|end| *end != 0) {
            self.moved(scan.parameter, end, scan.planarized);
        }
        let now = shortfall(scan.now.requirements.get(place)?)?;
        let mut best: Option<(f64, i64, &Variant, &Block)> = None;
        for (steps, variant) in self.variants.tried_of(&scan.parameter.name, scan.planarized) {
            let Some(block) = variant.block(&scan.now.figure) else { continue };
            let Some(beyond) = block.requirements.get(place).and_then(shortfall) else { continue };
            if beyond < best.as_ref().map_or(now - now.abs() * 0.01, |(best, ..)| *best) {
                best = Some((beyond, steps, variant, block));
            }
        }
        let (beyond, steps, variant, block) = best?;
        let (value, found) = (scan.parameter.words(steps)?, found(block, scan.asked)?);
        let sentence = format!(
            "moving {} inside its range is not enough: {value}, the best that was tried, gives {found}{}",
            scan.parameter.name,
            variant.said_before()
        );
        Some((beyond, sentence))
    }
}

/// How far what was measured is beyond the limit, at worst.
pub(super) fn shortfall(requirement: &RequirementResult) -> Option<f64> {
    let (least, most) = requirement.result.extremes?;
    match requirement.limit {
        LimitValue::Plain(limit) => Some(limit.shortfall(least).max(limit.shortfall(most))),
        LimitValue::Grain(_) => Some(-least),
    }
}

fn movable(evaluator: &mut Evaluator<'_>, name: &str, param: &Param, now: Scalar) -> Option<Movable> {
    let (from, to) = param.range.as_ref()?;
    let least = evaluator.body(from).ok()?.scalar()?.clone();
    let most = evaluator.body(to).ok()?.scalar()?.clone();
    let step = match &param.step {
        Some(step) => evaluator.body(step).ok()?.scalar()?.clone(),
        None if param.ty == Type::Int => Scalar::one(),
        None => round_step(&least, &most, param)?,
    };
    let step = if param.ty == Type::Int && step.to_integer().is_none() { Scalar::one() } else { step };
    let size = step.to_f64().filter(|size| *size > 0.0)?;
    let movable = |reach| Movable {
        name: name.to_owned(),
        ty: param.ty.clone(),
        now: now.clone(),
        step: step.clone(),
        reach,
    };
    let steps = |length: f64| if length > 0.0 { (length / size + 1e-9).floor().min(1e6) as i64 } else { 0 };
    let value = now.to_f64()?;
    let mut reach = [steps(value - least.to_f64()?), steps(most.to_f64()? - value)];
    // Rounding must not lead out of the range.
    let inside = |value: &Scalar| {
        least.compare(value).is_ok_and(std::cmp::Ordering::is_le)
            && value.compare(&most).is_ok_and(std::cmp::Ordering::is_le)
    };
    for (side, sign) in [(0, -1), (1, 1)] {
        if reach[side] > 0 && !movable(reach).value(sign * reach[side]).is_some_and(|value| inside(&value)) {
            reach[side] -= 1;
        }
    }
    (reach != [0, 0]).then(|| movable(reach))
}

/// A step of one, two or five of a power of ten, in the unit the parameter is shown in, that cuts a range into about
/// [`STEPS`].
fn round_step(least: &Scalar, most: &Scalar, param: &Param) -> Option<Scalar> {
    let (_, unit) = param.ty.dimension()?.display_unit();
    let about = (most.to_f64()? - least.to_f64()?) / unit / STEPS;
    if !(1e-9..1e9).contains(&about) {
        return most.minus(least).ok()?.over(&Scalar::integer(STEPS as i64)).ok();
    }
    let mut power = Scalar::one();
    let ten = Scalar::integer(10);
    let mut size = 1.0;
    while size > about {
        (power, size) = (power.over(&ten).ok()?, size / 10.0);
    }
    while size * 10.0 <= about {
        (power, size) = (power.times(&ten).ok()?, size * 10.0);
    }
    let times = if about >= size * 5.0 {
        5
    } else if about >= size * 2.0 {
        2
    } else {
        1
    };
    let step = power.times(&Scalar::integer(times)).ok()?;
    match unit == 1.0 {
        true => Some(step),
        false => Scalar::real(step.to_f64()? * unit).ok(),
    }
}

/// How many steps away values are tried: each, or `most` of them evenly apart, the last one too.
fn strides(reach: i64, most: i64) -> Vec<i64> {
    let count = reach.min(most).max(0);
    (1..=count).map(|place| ((i128::from(reach) * i128::from(place)) / i128::from(count)) as i64).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strides_reach_the_end() {
        assert_eq!(strides(4, 60), [1, 2, 3, 4]);
        assert_eq!(strides(20, 3), [6, 13, 20]);
        assert_eq!(strides(1_000_000, 1), [1_000_000]);
        assert!(strides(0, 60).is_empty() && strides(5, 0).is_empty());
    }
}
