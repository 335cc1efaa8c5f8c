//! What the levels beside this one give.

use super::variants::{Block, Change, Confirmed, Purse, Variant};
use super::{Asked, Remedies, Remedy, Worth};
use crate::analysis::requirements::found_words;
use crate::hir::schema::Measure;

/// By how much levels are changed. Lower ones cost little, and come first.
const SHIFTS: [i32; 6] = [-1, -2, -3, 1, 2, 3];

/// A level that was tried.
struct Tried {
    shift: i32,
    /// `level 3`, or `one level higher` where the figure's parts differ in level.
    words: String,
    /// What is measured there.
    found: Option<String>,
    holds: bool,
    /// What held and no longer does.
    broken: Option<String>,
}

impl Remedies<'_> {
    pub(super) fn levels(&mut self, figure: &str, asked: Asked) -> Option<Remedy> {
        let now = self.now(figure)?.clone();
        let planarized = self.needs_planarizing(&now, asked);
        let mut tried: Vec<Tried> = Vec::new();
        for shift in SHIFTS {
            let nearer = tried.iter().any(|other| other.holds && other.shift.signum() == shift.signum());
            if nearer || !self.is_level_affordable(&now, shift, planarized) {
                continue;
            }
            tried.extend(self.level(asked, &now, shift, planarized));
        }
        let sentence = mended(&tried, now.level.as_deref());
        if sentence.is_some() {
            let clean = tried.iter().any(|tried| tried.holds && tried.broken.is_none());
            let worth = if clean { Worth::Mends } else { Worth::Breaks };
            let mut holding: Vec<&Tried> = tried.iter().filter(|tried| tried.holds).collect();
            holding.sort_by_key(|tried| (tried.broken.is_some(), tried.shift.abs()));
            let clean_ones = holding.iter().filter(|tried| tried.broken.is_none());
            let fixes = clean_ones
                .filter_map(|tried| self.level_put(figure, tried.shift, tried.found.as_deref()))
                .collect();
            return sentence.map(|sentence| Remedy { sentence, fixes, worth });
        }
        none_mends(&mut tried, &now, asked).map(Remedy::falls_short)
    }

    /// Whether a level may be tried: higher ones have about four times as many quads, or twice as many segments.
    fn is_level_affordable(&self, now: &Block, shift: i32, planarized: bool) -> bool {
        let factor = 4u64.saturating_pow(shift.max(0).unsigned_abs());
        let elements = (now.elements as u64).max(1).saturating_mul(factor);
        self.variants.affordable(Purse::Levels, elements, planarized) > 0
    }

    /// Whether what is asked can be judged only on quads as flat as they will be built: where it is about that, and where
    /// it is planarizing that makes it fail.
    pub(super) fn needs_planarizing(&mut self, now: &Block, asked: Asked) -> bool {
        if let Asked::Requirement(place) = asked
            && now.requirements.get(place).is_some_and(|requirement| requirement.measure.is_flatness())
        {
            return true;
        }
        if !self.variants.planarizes() {
            return false;
        }
        let as_it_is = Change::Level(now.figure.clone(), 0);
        let designed = self.variants.with(&as_it_is, None, false);
        designed.and_then(|designed| designed.block(&now.figure)).is_some_and(|block| block.holds(asked))
    }

    fn level(&mut self, asked: Asked, now: &Block, shift: i32, planarized: bool) -> Option<Tried> {
        let change = Change::Level(now.figure.clone(), shift);
        let variant = self.variants.with(&change, None, planarized)?.clone();
        let block = variant.block(&now.figure)?;
        // A figure without levels is the same at each.
        if block.level == now.level && block.elements == now.elements {
            return None;
        }
        let tried = self.tried(&variant, asked, now, shift)?;
        if !tried.holds || variant.planarized {
            return Some(tried);
        }
        match self.variants.confirmed(&change, None, block.elements as u64) {
            Confirmed::Planarized(variant) => self.tried(&variant, asked, now, shift),
            Confirmed::Faulty => None,
            Confirmed::TooLong => Some(tried),
        }
    }

    fn tried(&self, variant: &Variant, asked: Asked, now: &Block, shift: i32) -> Option<Tried> {
        let block = variant.block(&now.figure)?;
        let beside = match shift {
            -1 => "one level lower".to_owned(),
            1 => "one level higher".to_owned(),
            ..=-2 => format!("{} levels lower", -shift),
            _ => format!("{shift} levels higher"),
        };
        Some(Tried {
            shift,
            words: block.level.clone().unwrap_or(beside),
            found: found(block, asked).map(|found| format!("{found}{}", variant.said_before())),
            holds: block.holds(asked),
            broken: self.broken(variant),
        })
    }

    /// What holds now and fails in a variant, in words.
    pub(super) fn broken(&self, variant: &Variant) -> Option<String> {
        let pairs = self.now.iter().zip(&variant.blocks);
        pairs.into_iter().find_map(|(now, then)| {
            if now.too_large == 0 && then.too_large > 0 {
                return Some(format!("{} no longer fit what they are cut from", then.too_large));
            }
            let requirements = now.requirements.iter().zip(&then.requirements);
            let mut judged = requirements.filter(|(now, _)| variant.planarized || !now.measure.is_flatness());
            let (_, broken) = judged.find(|(now, then)| now.result.holds() && !then.result.holds())?;
            let value =
                broken.result.extremes.map(|extremes| found_words(broken.measure, &broken.limit, extremes));
            let value = value.map_or_else(String::new, |value| format!(": {value}"));
            Some(format!("{} fails{value}", broken.limit.line(broken.measure)))
        })
    }
}

/// What a block gives of what is asked.
pub(super) fn found(block: &Block, asked: Asked) -> Option<String> {
    let Asked::Requirement(place) = asked else {
        return Some(match block.too_large {
            0 => format!("all {} fit", block.elements),
            some => format!("{some} of {} are too large", block.elements),
        });
    };
    let requirement = block.requirements.get(place)?;
    let words = found_words(requirement.measure, &requirement.limit, requirement.result.extremes?);
    let counted = if requirement.measure == Measure::Count { " elements" } else { "" };
    Some(format!("{words}{counted}"))
}

/// `it holds at level 2 (310mm .. 340mm); now it is level 3`
fn mended(tried: &[Tried], now: Option<&str>) -> Option<String> {
    let mut found: Vec<&Tried> = tried.iter().filter(|tried| tried.holds).collect();
    // What breaks nothing else comes first.
    found.sort_by_key(|tried| (tried.broken.is_some(), tried.shift.abs()));
    let words: Vec<String> = found
        .into_iter()
        .map(|tried| {
            let at = if tried.words.starts_with("level") { "at " } else { "" };
            let value = tried.found.as_ref().map_or_else(String::new, |found| format!(" ({found})"));
            let broken =
                tried.broken.as_ref().map_or_else(String::new, |broken| format!(", but then {broken}"));
            format!("{at}{}{value}{broken}", tried.words)
        })
        .collect();
    let now = now.map_or_else(String::new, |now| format!("; now it is {now}"));
    (!words.is_empty()).then(|| format!("it holds {}{now}", words.join("; or ")))
}

/// `no level does it: level 2 gives 480mm .. 520mm, level 3, as now, 240mm .. 260mm`
fn none_mends(tried: &mut Vec<Tried>, now: &Block, asked: Asked) -> Option<String> {
    let here = found(now, asked)?;
    let words = now.level.clone().unwrap_or_else(|| "the level".to_owned());
    tried.push(Tried {
        shift: 0,
        words: format!("{words} as it is now"),
        found: Some(here.clone()),
        holds: false,
        broken: None,
    });
    tried.sort_by_key(|tried| tried.shift);
    let list: Vec<String> = tried
        .iter()
        .filter(|tried| tried.shift.abs() <= 1)
        .filter_map(|tried| Some(format!("{} {}", tried.words, tried.found.as_ref()?)))
        .collect();
    let differ = tried.iter().any(|tried| tried.found.as_ref().is_some_and(|found| *found != here));
    (list.len() > 1 && differ).then(|| format!("no level near this one does it: {}", list.join(", ")))
}
