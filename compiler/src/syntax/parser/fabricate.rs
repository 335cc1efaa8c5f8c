//! A fabricate block: settings and requirements, whose measures come from a closed list.

use super::Rule;
use super::expected::Expected;
use super::expression::Expressions;
use super::items::item_token;
use super::level::{limit, measure};
use super::names::{field_name, name};
use super::primitive::{lexeme, token, word};
use super::recovery::Stop;
use super::sequence::block;
use crate::diagnostic::{Code, Diagnostic, closest};
use crate::syntax::ast::{Entry, EntryKind, Fabricate, Name, Requirement};
use crate::syntax::token::TokenKind;
use chumsky::prelude::*;

/// What can be required of a figure's elements.
pub const MEASURES: &[&str] = &[
    "planarity",
    "fold",
    "diagonal ratio",
    "edge",
    "length",
    "width",
    "area",
    "angle",
    "mitre",
    "bevel",
    "bend radius",
    "overlap",
    "mass",
    "count",
];

/// `fabricate shell as panels { … }`
pub(super) fn fabricate<'s>(expressions: &Expressions<'s>) -> Rule<'s, Fabricate> {
    let failed = |span| Entry { span, kind: EntryKind::Error };
    item_token(TokenKind::Fabricate)
        .ignore_then(name())
        .then_ignore(word("as", Expected::As))
        .then(name())
        .then(block(entry(expressions), Stop::Entry, failed, Expected::OpenBrace))
        .map(|((figure, kind), entries)| Fabricate { figure, kind, entries })
        .boxed()
}

fn entry<'s>(expressions: &Expressions<'s>) -> Rule<'s, Entry> {
    let setting = field_name()
        .then_ignore(token(TokenKind::Colon))
        .then(expressions.finished(Stop::Entry))
        .map(|(name, value)| EntryKind::Setting(name, value));
    let require = lexeme(Expected::NextEntry, |found, _| found.is_word("require").then_some(()));
    let requirement = require.ignore_then(measure()).then(limit(expressions.operand.clone())).map_with(
        |(measure, limit), e| {
            if let Some(found) = unknown_measure(&measure) {
                e.state().said.push(found);
            }
            EntryKind::Require(Requirement { measure, limit: limit.limit })
        },
    );
    setting.or(requirement).map_with(|kind, e| Entry { span: e.span(), kind }).boxed()
}

/// What people call some of the measures.
const OTHER_NAMES: &[(&str, &str)] = &[
    ("flatness", "planarity"),
    ("dihedral", "fold"),
    ("dihedral angle", "fold"),
    ("edge length", "edge"),
    ("edges", "edge"),
    ("weight", "mass"),
    ("fold angle", "fold"),
    ("corner", "angle"),
    ("corner angle", "angle"),
    ("interior angle", "angle"),
    ("bevel angle", "bevel"),
    ("board width", "width"),
    ("board length", "length"),
    ("curvature", "bend radius"),
    ("bend", "bend radius"),
    ("joint distance", "overlap"),
    ("joint spacing", "overlap"),
    ("number", "count"),
    ("number of boards", "count"),
    ("number of planks", "count"),
    ("elements", "count"),
    ("planks", "count"),
    ("miter", "mitre"),
    ("miter angle", "mitre"),
    ("mitre angle", "mitre"),
    ("radius", "bend radius"),
    ("bending radius", "bend radius"),
    ("boards", "count"),
    ("diagonal", "diagonal ratio"),
];

fn unknown_measure(measure: &Name) -> Option<Diagnostic> {
    let text = measure.text.as_str();
    if MEASURES.contains(&text) {
        return None;
    }
    let found =
        Diagnostic::new(Code::E0206, measure.span, format!("`{text}` is not a measure that can be required"));
    let other = OTHER_NAMES.iter().find(|(name, _)| *name == text).map(|(_, measure)| *measure);
    let meant = other.or_else(|| closest(text, MEASURES.iter().copied()));
    let found = match meant {
        Some(meant) => found.fix(format!("did you mean `{meant}`?"), measure.span, meant),
        None => found,
    };
    Some(found.hint(format!("the measures are {}", MEASURES.join(", "))))
}
