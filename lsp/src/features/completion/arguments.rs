//! Names of arguments in a call: those not given yet.

use ifs_compiler::hir::index::Target;
use ifs_compiler::hir::native_parameter;
use ifs_compiler::hir::type_names::type_name;
use ifs_compiler::hir::types::Type;
use ifs_compiler::source::Span;
use ifs_compiler::syntax::TokenKind;

use super::{Kind, Known, Offer, needed};

/// The parameters of what is called by the name at `callee` that have no argument yet.
pub(super) fn labels(known: &Known<'_>, callee: Span) -> Vec<Offer> {
    let Some(called) = known.index().name_at(callee.file, callee.start) else { return Vec::new() };
    let parameters: Vec<(String, Option<Type>, String, bool)> = match called.target {
        Target::Native(native) => {
            let declared = native.declaration().parameters.iter();
            declared
                .map(|parameter| {
                    (parameter.name.to_owned(), None, native_parameter(parameter), parameter.required)
                })
                .collect()
        }
        target => {
            let parameters = known.index().parameters(target).unwrap_or_default().iter();
            let ty = |ty| type_name(&known.hir().items, ty);
            parameters
                .map(|parameter| {
                    let known = Some(parameter.ty.clone());
                    (parameter.name.clone(), known, ty(&parameter.ty), parameter.required)
                })
                .collect()
        }
    };
    let by_place_mostly = matches!(called.target, Target::Native(_));
    let (named, commas) = known.before.given();
    let by_place = commas.saturating_sub(named.len());
    let open: Vec<_> = parameters
        .into_iter()
        .enumerate()
        .filter(|(place, (name, ..))| *place >= by_place && !named.contains(&name.as_str()))
        .collect();
    let labelled = known.before.next.is_some_and(|next| next.text() == Some(":"));
    let must = open.iter().filter(|(_, (.., required))| *required);
    let must: Vec<_> = must.map(|(_, (name, ty, ..))| (name.as_str(), ty.as_ref())).collect();
    // Before an argument that stands there already it would need a comma.
    let last = known.before.next.is_none_or(|next| next == TokenKind::CloseParenthesis);
    let whole = needed::named(&must).filter(|_| last).map(|offer| offer.rank(4));
    // The first argument of a function of the program is most often given by its place.
    let first = by_place_mostly && commas == 0;
    let each = open.iter().map(|(_, (name, _, ty, required))| {
        let what = if *required { "" } else { " (may be left out)" };
        let snippet = if labelled { name.clone() } else { format!("{name}: $0") };
        Offer::new(&format!("{name}:"), Kind::Field)
            .detail(format!("{ty}{what}"))
            .snippet(snippet)
            .rank(if first { 13 } else { 5 } + u8::from(!*required))
    });
    whole.into_iter().chain(each).collect()
}
