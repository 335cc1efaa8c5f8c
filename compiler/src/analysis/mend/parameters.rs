//! The nearest values of parameters, inside their ranges, at which what fails holds.

use super::levels::found;
use super::variants::{Change, Variant};
use super::{Asked, Remedies, Remedy, Worth};
use crate::hir::evaluate::{Evaluator, words};
use crate::hir::scalar::Scalar;
use crate::hir::tree::{ItemKind, Param};
use crate::hir::types::Type;

/// Into about how many steps a range is cut where the parameter names none.
const STEPS: f64 = 40.0;

/// The most values of a parameter that are tried one after another, each way.
const MOST_IN_TURN: i64 = 60;

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
            let mut clean: Vec<String> = Vec::new();
            let found: Vec<String> = [1, -1]
                .into_iter()
                .filter_map(|way| {
                    let steps = self.nearest(parameter, way, figure, asked, planarized, tries)?;
                    let variant = self.moved(parameter, steps, planarized)?;
                    let broken = self.broken(&variant);
                    if broken.is_none() {
                        clean.extend(parameter.words(steps));
                    }
                    let broken = broken.map_or_else(String::new, |broken| format!(" (but then {broken})"));
                    Some(format!("{}{broken}", parameter.words(steps)?))
                })
                .collect();
            if found.is_empty() && tries > 0 {
                let end = self.best_end(parameter, figure, asked, planarized);
                nearest = match (nearest, end) {
                    (Some(best), Some(end)) if end.0 >= best.0 => Some(best),
                    (best, end) => end.or(best),
                };
            } else if let Some(now) = parameter.words(0).filter(|_| !found.is_empty()) {
                let name = &parameter.name;
                let sentence = format!("it holds with {name} = {}; now it is {now}", found.join(" or "));
                let worth = if clean.is_empty() { Worth::Breaks } else { Worth::Mends };
                let fixes = clean.iter().filter_map(|then| self.default_put(name, &now, then)).collect();
                remedies.push(Remedy { sentence, fixes, worth });
            }
        }
        if remedies.is_empty() {
            remedies.extend(nearest.map(|(_, sentence)| Remedy::falls_short(sentence)));
        }
        remedies
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

    fn holds(
        &mut self,
        parameter: &Movable,
        steps: i64,
        figure: &str,
        asked: Asked,
        planarized: bool,
    ) -> bool {
        let variant = self.moved(parameter, steps, planarized);
        let blocks = variant.into_iter().flat_map(|variant| variant.blocks);
        blocks.into_iter().any(|block| block.figure == figure && block.holds(asked))
    }

    /// The smallest number of steps that way at which it holds: step by step where that can be afforded, else in
    /// strides to the end of the range and then by halving, which finds the nearest value where it fails on one side
    /// and holds on the other.
    fn nearest(
        &mut self,
        parameter: &Movable,
        way: i64,
        figure: &str,
        asked: Asked,
        planarized: bool,
        tries: u64,
    ) -> Option<i64> {
        let reach = parameter.reach[usize::from(way > 0)];
        let most = i64::try_from(tries).unwrap_or(MOST_IN_TURN).min(MOST_IN_TURN);
        let mut failed = 0;
        for steps in strides(reach, most) {
            if !self.holds(parameter, way * steps, figure, asked, planarized) {
                failed = steps;
                continue;
            }
            let mut holds = steps;
            while holds - failed > 1 {
                let between = failed + (holds - failed) / 2;
                match self.holds(parameter, way * between, figure, asked, planarized) {
                    true => holds = between,
                    false => failed = between,
                }
            }
            return Some(way * holds);
        }
        None
    }

    /// How near the better end of a range comes: how far it is beyond the limit, and a sentence. `None` where it is no
    /// better than now.
    fn best_end(
        &mut self,
        parameter: &Movable,
        figure: &str,
        asked: Asked,
        planarized: bool,
    ) -> Option<(f64, String)> {
        let Asked::Requirement(place) = asked else { return None };
        let shortfall = |requirement: &crate::analysis::RequirementResult| {
            let (least, most) = requirement.result.extremes?;
            match requirement.limit {
                crate::analysis::LimitValue::Plain(limit) => {
                    Some(limit.shortfall(least).max(limit.shortfall(most)))
                }
                crate::analysis::LimitValue::Grain(_) => Some(-least),
            }
        };
        let now = shortfall(self.now(figure)?.requirements.get(place)?)?;
        let mut best: Option<(f64, String)> = None;
        for steps in [-parameter.reach[0], parameter.reach[1]].into_iter().filter(|steps| *steps != 0) {
            let Some(variant) = self.moved(parameter, steps, planarized) else { continue };
            let Some(block) = variant.blocks.iter().find(|block| block.figure == figure) else { continue };
            let Some(beyond) = block.requirements.get(place).and_then(shortfall) else { continue };
            if beyond < best.as_ref().map_or(now - now.abs() * 0.01, |(best, _)| *best) {
                let (value, found) = (parameter.words(steps)?, found(block, asked)?);
                let sentence = format!(
                    "moving {} inside its range is not enough: {value}, the best that was tried, gives {found}",
                    parameter.name
                );
                best = Some((beyond, sentence));
            }
        }
        best
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
