//! Every expression of a tree, without recursion: texts may be deep.

use ifs_compiler::syntax::ast::{
    Clause, EntryKind, Expr, ExprKind, File, Item, ItemKind, Level, Limit, MemberKind, Placement, Space,
    TestStep,
};

/// Every expression of a file, outer before inner.
pub(crate) fn expressions<'a>(file: &'a File, mut visit: impl FnMut(&'a Expr)) {
    for item in &file.items {
        of_item(item, &mut visit);
    }
}

/// Every expression of an item.
pub(crate) fn of_item<'a>(item: &'a Item, visit: &mut impl FnMut(&'a Expr)) {
    let mut open: Vec<&'a Expr> = roots(item);
    open.reverse();
    while let Some(expr) = open.pop() {
        visit(expr);
        let mut parts = Vec::new();
        children(expr, &mut parts);
        open.extend(parts.into_iter().rev());
    }
}

fn roots(item: &Item) -> Vec<&Expr> {
    match &item.kind {
        ItemKind::Param(param) => {
            let range = param.range.iter().flat_map(|range| [&range.from, &range.to]);
            std::iter::once(&param.default).chain(range).chain(&param.step).collect()
        }
        ItemKind::Let(value) => vec![&value.value],
        ItemKind::Figure(figure) => vec![&figure.value],
        ItemKind::Function(function) => {
            let defaults = function.parameters.iter().filter_map(|field| field.default.as_ref());
            defaults.chain([&function.body]).collect()
        }
        ItemKind::Record(record) => record.fields.iter().filter_map(|field| field.default.as_ref()).collect(),
        ItemKind::Ifs(ifs) => {
            let mut roots: Vec<&Expr> =
                ifs.parameters.iter().filter_map(|field| field.default.as_ref()).collect();
            if let Space::On(points, _) = &ifs.space {
                roots.extend(points.iter().filter_map(|point| point.count.as_ref()));
            }
            for member in &ifs.members {
                match &member.kind {
                    MemberKind::Let(value) => roots.push(&value.value),
                    MemberKind::Transform(transform) => {
                        roots.extend(transform.family.iter().map(|(_, through)| through));
                        roots.push(&transform.value);
                    }
                    MemberKind::Germ(value) | MemberKind::Keep(value) | MemberKind::Boundary(_, value) => {
                        roots.push(value);
                    }
                    MemberKind::Join(left, right) => {
                        roots.extend(left.iter().chain(right).filter_map(|part| part.member.as_ref()));
                    }
                    MemberKind::Error => {}
                }
            }
            roots
        }
        ItemKind::Fabricate(block) => {
            let mut roots = Vec::new();
            for entry in &block.entries {
                match &entry.kind {
                    EntryKind::Setting(_, value) => roots.push(value),
                    EntryKind::Require(requirement) => limit(&requirement.limit, &mut roots),
                    EntryKind::Error => {}
                }
            }
            roots
        }
        ItemKind::Test(test) => {
            let values = test.steps.iter().filter_map(|step| match step {
                TestStep::Let(value) => Some(&value.value),
                TestStep::Assert(value, _) => Some(value),
                TestStep::Error(_) => None,
            });
            values.collect()
        }
        ItemKind::Use(_) | ItemKind::Error => Vec::new(),
    }
}

fn limit<'a>(limit: &'a Limit, into: &mut Vec<&'a Expr>) {
    match limit {
        Limit::Compare(_, value) => into.push(value),
        Limit::Within(range) => into.extend([&range.from, &range.to]),
    }
}

/// The parts of an expression, in the order of the text.
fn children<'a>(expr: &'a Expr, into: &mut Vec<&'a Expr>) {
    match &expr.kind {
        ExprKind::Group(inner) | ExprKind::Field(inner, _) | ExprKind::Unary(_, inner) => into.push(inner),
        ExprKind::Tuple(parts) | ExprKind::List(parts) => into.extend(parts),
        ExprKind::Comprehension { body, clauses } => {
            into.push(body);
            into.extend(clauses.iter().map(|clause| match clause {
                Clause::For(_, through) => through,
                Clause::If(condition) => condition,
            }));
        }
        ExprKind::Fields(fields) => into.extend(fields.iter().map(|field| &field.value)),
        ExprKind::Call { callee, arguments } => {
            into.push(callee);
            into.extend(arguments.iter().map(|argument| &argument.value));
        }
        ExprKind::Index(base, indices) => {
            into.push(base);
            into.extend(indices);
        }
        ExprKind::Binary(_, _, left, right) => into.extend([&**left, &**right]),
        ExprKind::Range(range) => into.extend([&range.from, &range.to]),
        ExprKind::If(condition, yes, no) => into.extend([&**condition, &**yes, &**no]),
        ExprKind::On(ifs, placement) => {
            into.push(ifs);
            match placement {
                Placement::Points(points, _) => into.extend(points),
                Placement::Value(value) => into.push(value),
            }
        }
        ExprKind::At(figure, level) => {
            into.push(figure);
            match level {
                Level::Uniform(level) => into.push(level),
                Level::Pair(u, v) => into.extend([&**u, &**v]),
                Level::Until { limit: bound, .. } => limit(bound, into),
            }
        }
        ExprKind::Number { .. }
        | ExprKind::Text(_)
        | ExprKind::Bool(_)
        | ExprKind::Name(_)
        | ExprKind::Error => {}
    }
}
