//! Trees as short texts with all brackets, for tests.

use crate::syntax::ast::*;

/// An expression: `(a + b)`, `f<a, b: c>`, `e on {a | b} at 4`.
pub(super) fn expr(e: &Expr) -> String {
    match &e.kind {
        ExprKind::Number { digits, unit } => format!("{digits}{}", unit.map_or("", Unit::suffix)),
        ExprKind::Text(text) => format!("{text:?}"),
        ExprKind::Bool(value) => value.to_string(),
        ExprKind::Name(name) => name.clone(),
        ExprKind::Group(inner) => format!("group<{}>", expr(inner)),
        ExprKind::Tuple(parts) => format!("tuple<{}>", all(parts)),
        ExprKind::List(parts) => format!("[{}]", all(parts)),
        ExprKind::Comprehension { body, clauses } => {
            let clauses: Vec<String> = clauses.iter().map(clause).collect();
            format!("[{} {}]", expr(body), clauses.join(" "))
        }
        ExprKind::Fields(fields) => format!("{{{}}}", arguments(fields)),
        ExprKind::Call { callee, arguments: given } => format!("{}<{}>", expr(callee), arguments(given)),
        ExprKind::Field(left, name) => format!("{}.{}", expr(left), name.text),
        ExprKind::Index(left, indices) => format!("{}[{}]", expr(left), all(indices)),
        ExprKind::Unary(UnaryOperator::Negate, inner) => format!("(-{})", expr(inner)),
        ExprKind::Unary(UnaryOperator::Not, inner) => format!("(not {})", expr(inner)),
        ExprKind::Binary(operator, _, left, right) => {
            format!("({} {} {})", expr(left), binary(*operator), expr(right))
        }
        ExprKind::Range(it) => range(it),
        ExprKind::If(condition, yes, no) => format!("(if {} {} {})", expr(condition), expr(yes), expr(no)),
        ExprKind::On(left, Placement::Points(points, _)) => {
            format!("({} on {{{}}})", expr(left), all(points))
        }
        ExprKind::On(left, Placement::Value(value)) => format!("({} on {})", expr(left), expr(value)),
        ExprKind::At(left, level) => format!("({} {})", expr(left), self::level(level)),
        ExprKind::Error => "ERROR".to_owned(),
    }
}

fn all(parts: &[Expr]) -> String {
    parts.iter().map(expr).collect::<Vec<_>>().join(", ")
}

fn arguments(given: &[Argument]) -> String {
    let one = |argument: &Argument| match &argument.name {
        Some(name) => format!("{}: {}", name.text, expr(&argument.value)),
        None => expr(&argument.value),
    };
    given.iter().map(one).collect::<Vec<_>>().join(", ")
}

fn clause(clause: &Clause) -> String {
    match clause {
        Clause::For(name, over) => format!("for {} in {}", name.text, expr(over)),
        Clause::If(condition) => format!("if {}", expr(condition)),
    }
}

fn range(it: &RangeExpr) -> String {
    format!("({} .. {})", expr(&it.from), expr(&it.to))
}

fn binary(operator: BinaryOperator) -> &'static str {
    match operator {
        BinaryOperator::Add => "+",
        BinaryOperator::Subtract => "-",
        BinaryOperator::Multiply => "*",
        BinaryOperator::Divide => "/",
        BinaryOperator::By => "by",
        BinaryOperator::And => "and",
        BinaryOperator::Or => "or",
        BinaryOperator::Compare(it) => comparison(it),
    }
}

fn comparison(it: Comparison) -> &'static str {
    match it {
        Comparison::Equal => "==",
        Comparison::NotEqual => "!=",
        Comparison::Less => "<",
        Comparison::AtMost => "<=",
        Comparison::Greater => ">",
        Comparison::AtLeast => ">=",
    }
}

pub(super) fn limit(limit: &Limit) -> String {
    match limit {
        Limit::Compare(it, value) => format!("{} {}", comparison(*it), expr(value)),
        Limit::Within(it) => format!("in {}", range(it)),
    }
}

fn level(level: &Level) -> String {
    match level {
        Level::Uniform(value) => format!("at {}", expr(value)),
        Level::Pair(u, v) => format!("at {} x {}", expr(u), expr(v)),
        Level::Until { each, measure, limit: it } => {
            format!("{}until {} {}", if *each { "each " } else { "" }, measure.text, limit(it))
        }
    }
}

/// A type: `[Length]`.
pub(super) fn ty(it: &TypeExpr) -> String {
    match &it.kind {
        TypeExprKind::Name(name) => name.clone(),
        TypeExprKind::List(inner) => format!("[{}]", ty(inner)),
        TypeExprKind::Error => "ERROR".to_owned(),
    }
}

/// A field: `a: Length = 3m`.
pub(super) fn field(it: &Field) -> String {
    let default = it.default.as_ref().map_or(String::new(), |value| format!(" = {}", expr(value)));
    format!("{}: {}{default}", it.name.text, ty(&it.ty))
}

/// A member of an ifs.
pub(super) fn member(it: &Member) -> String {
    let part = |part: &JoinPart| {
        let member = part.member.as_ref().map_or(String::new(), |member| format!("[{}]", expr(member)));
        format!("{}{member}", part.name.text)
    };
    let path = |path: &[JoinPart]| path.iter().map(part).collect::<Vec<_>>().join(".");
    match &it.kind {
        MemberKind::Let(it) => format!("let {} = {}", it.name.text, expr(&it.value)),
        MemberKind::Transform(it) => {
            let family = it.family.as_ref().map(|(name, over)| format!("[{} in {}]", name.text, expr(over)));
            format!("transform {}{} = {}", it.name.text, family.unwrap_or_default(), expr(&it.value))
        }
        MemberKind::Germ(value) => format!("germ {}", expr(value)),
        MemberKind::Keep(value) => format!("keep {}", expr(value)),
        MemberKind::Boundary(name, value) => format!("boundary {} = {}", name.text, expr(value)),
        MemberKind::Join(left, right) => format!("join {} = {}", path(left), path(right)),
        MemberKind::Error => "ERROR".to_owned(),
    }
}

/// An entry of a fabricate block.
pub(super) fn entry(it: &Entry) -> String {
    match &it.kind {
        EntryKind::Setting(name, value) => format!("{}: {}", name.text, expr(value)),
        EntryKind::Require(it) => format!("require {} {}", it.measure.text, limit(&it.limit)),
        EntryKind::Error => "ERROR".to_owned(),
    }
}
