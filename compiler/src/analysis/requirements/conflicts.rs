//! Limits that nothing can be within, whatever the figure: beyond what the measure can be, or two that exclude each other.

use super::LimitValue;
use super::words::value_words;
use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::checks::Limit;
use crate::hir::schema::Measure;
use crate::hir::tree::Requirement;

/// The ends of an interval, and whether they are in it.
type Ends = [(f64, bool); 2];

/// What no figure can hold.
pub(in crate::analysis) fn conflicts(requirements: &[Requirement], limits: &[LimitValue]) -> Vec<Diagnostic> {
    let asked: Vec<(&Requirement, Limit)> = requirements
        .iter()
        .zip(limits)
        .filter_map(|(requirement, limit)| match limit {
            LimitValue::Plain(limit) => Some((requirement, *limit)),
            LimitValue::Grain(_) => None,
        })
        .collect();
    let mut found: Vec<Diagnostic> = Vec::new();
    for (place, (requirement, limit)) in asked.iter().enumerate() {
        if let Some(diagnostic) = impossible(requirement, *limit) {
            found.push(diagnostic);
            continue;
        }
        let earlier = asked[..place].iter().find(|(other, bounds)| {
            other.measure == requirement.measure && is_empty(bounds.ends(), limit.ends())
        });
        if let Some((other, bounds)) = earlier
            && impossible(other, *bounds).is_none()
        {
            found.push(excluded(requirement, *limit, other, *bounds));
        }
    }
    found
}

fn impossible(requirement: &Requirement, limit: Limit) -> Option<Diagnostic> {
    let measure = requirement.measure;
    let (least, most) = measure.possible();
    let possible = [(least, true), (most, true)];
    if !is_empty(possible, limit.ends()) {
        return None;
    }
    let words = LimitValue::Plain(limit).words(measure);
    let message = format!("no element has a {} of {words}", measure.words());
    let range = if most.is_finite() {
        format!("between {} and {}", value_words(measure, least), value_words(measure, most))
    } else {
        format!("{} or more", value_words(measure, least))
    };
    let diagnostic = Diagnostic::new(Code::E0836, requirement.span, message).label("never holds");
    let diagnostic = diagnostic.note(format!("{} is {range}", measure.words()));
    Some(match measure {
        Measure::Planarity => {
            let hint = "1 is flat: `require planarity >= 0.9998` allows a fold of 1.1 degrees";
            diagnostic.fix(hint, requirement.span, "require planarity >= 0.9998")
        }
        _ => diagnostic.hint("write a limit inside of that"),
    })
}

fn excluded(requirement: &Requirement, limit: Limit, other: &Requirement, bounds: Limit) -> Diagnostic {
    let measure = requirement.measure;
    let [first, second] = [bounds, limit].map(|limit| LimitValue::Plain(limit).words(measure));
    let message = format!("{} cannot be both {first} and {second}", measure.words());
    Diagnostic::new(Code::E0835, requirement.span, message)
        .label("excludes the other")
        .also(other.span, "asked for here")
        .hint(format!("change one of the two, or write one line: `require {} in … .. …`", measure.words()))
}

/// Whether no value lies in both intervals.
fn is_empty(first: Ends, second: Ends) -> bool {
    let low = if second[0].0 > first[0].0 { second[0] } else { first[0] };
    let high = if second[1].0 < first[1].0 { second[1] } else { first[1] };
    let touches = [first, second]
        .iter()
        .all(|[least, most]| (least.1 || least.0 < low.0) && (most.1 || most.0 > high.0));
    low.0 > high.0 || (low.0 == high.0 && !touches)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_that_have_nothing_in_common() {
        let empty = |first: Limit, second: Limit| is_empty(first.ends(), second.ends());
        assert!(empty(Limit::AtLeast(5.0), Limit::AtMost(4.0)));
        assert!(!empty(Limit::AtLeast(5.0), Limit::AtMost(5.0)));
        assert!(empty(Limit::Above(5.0), Limit::AtMost(5.0)));
        assert!(empty(Limit::AtLeast(5.0), Limit::Below(5.0)));
        assert!(empty(Limit::Within(1.0, 2.0), Limit::Within(3.0, 4.0)));
        assert!(!empty(Limit::Within(1.0, 3.0), Limit::Within(3.0, 4.0)));
        assert!(empty(Limit::Equal(2.0), Limit::Equal(3.0)));
        assert!(!empty(Limit::Equal(2.0), Limit::Within(1.0, 3.0)));
        assert!(!empty(Limit::AtLeast(5.0), Limit::Above(5.0)));
        assert!(!empty(Limit::Below(5.0), Limit::AtMost(5.0)));
    }
}
