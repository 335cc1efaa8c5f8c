//! Records that contain themselves: no value of them could ever be made.

use super::Checker;
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::tree::ItemId;
use crate::hir::types::Type;
use crate::source::Span;
use crate::syntax::ast;
use std::collections::{BTreeMap, BTreeSet};

/// A record that a record has as a field, and where the field's type stands.
type Part = (ItemId, Span);

impl Checker<'_> {
    /// Reports every circle of records of the design, once. Through a list there is an end: the empty one.
    pub(super) fn check_records(&mut self) {
        let mut parts: BTreeMap<ItemId, Vec<Part>> = BTreeMap::new();
        for index in 0..self.declared.len() {
            let declared = &self.declared[index];
            if let (0, ast::ItemKind::Record(record)) = (declared.module, &declared.item.kind) {
                let id = ItemId(index as u32);
                let types = self.signature(id).parameters.into_iter().map(|parameter| parameter.ty);
                let fields = record.fields.iter().zip(types);
                let of_records = fields.filter_map(|(field, ty)| match ty {
                    Type::Record(part) => Some((part, field.ty.span)),
                    _ => None,
                });
                parts.insert(id, of_records.collect());
            }
        }
        let mut told = BTreeSet::new();
        for id in parts.keys() {
            if told.contains(id) {
                continue;
            }
            let Some(circle) = circle(&parts, *id) else { continue };
            told.extend(circle.iter().map(|(part, _)| *part));
            self.contains_itself(*id, &circle);
        }
    }

    fn contains_itself(&mut self, id: ItemId, circle: &[Part]) {
        let Some((first, rest)) = circle.split_first() else { return };
        let name = self.items[id.0 as usize].name.clone();
        let message = format!("every `{name}` would contain another `{name}`, without end");
        let mut diagnostic = Diagnostic::new(Code::E0305, first.1, message).label("part of it");
        for (_, span) in rest {
            diagnostic = diagnostic.also(*span, "and part of that");
        }
        self.report(diagnostic.hint(format!("make it a list, which may be empty: `[{name}]`")));
    }
}

/// The fields that lead from a record back to itself: the shortest way.
fn circle(parts: &BTreeMap<ItemId, Vec<Part>>, from: ItemId) -> Option<Vec<Part>> {
    let mut came: BTreeMap<ItemId, (ItemId, Span)> = BTreeMap::new();
    let mut open = std::collections::VecDeque::from([from]);
    while let Some(at) = open.pop_front() {
        for (part, span) in parts.get(&at).into_iter().flatten() {
            if *part == from {
                let mut way = vec![(from, *span)];
                let mut here = at;
                while let Some((before, span)) = came.get(&here).filter(|_| here != from) {
                    way.push((here, *span));
                    here = *before;
                }
                way.reverse();
                return Some(way);
            }
            if !came.contains_key(part) {
                came.insert(*part, (at, *span));
                open.push_back(*part);
            }
        }
    }
    None
}
