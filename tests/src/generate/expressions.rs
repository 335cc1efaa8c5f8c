//! Expressions of a wanted kind; now and then one of another kind.

use super::Writer;
use super::scope::Kind;
use super::words::{ANGLES, INTS, LENGTHS, NUMBERS, TEXTS};

/// How deep expressions are nested.
const DEEPEST: usize = 4;

impl Writer<'_> {
    /// An expression of a kind.
    pub(super) fn expression(&mut self, kind: &Kind) -> String {
        if self.choices.chance(128) {
            return self.stray();
        }
        if self.deep >= DEEPEST || self.choices.is_empty() {
            return self.leaf(kind);
        }
        self.deep += 1;
        let made = match self.choices.below(8) {
            0..=2 => self.leaf(kind),
            3..=5 => self.operation(kind),
            6 => self.call(kind),
            _ => self.choice(kind),
        };
        self.deep -= 1;
        made
    }

    /// What is of no certain kind.
    fn stray(&mut self) -> String {
        let words =
            ["lost", "self", "[]", "(1m, 2)", "u", "z", "{ a: 1 }", "3kg", "sin", "1..2", "len", "true"];
        self.choices.pick(&words).to_owned()
    }

    /// A name or a literal.
    fn leaf(&mut self, kind: &Kind) -> String {
        let names = self.scope.of(kind);
        if !names.is_empty() {
            let place = self.choices.below(names.len() + 2);
            if let Some(name) = names.get(place) {
                return (*name).to_owned();
            }
        }
        match kind {
            Kind::Int => self.choices.pick(INTS).to_owned(),
            Kind::Number => self.choices.pick(NUMBERS).to_owned(),
            Kind::Length => self.choices.pick(LENGTHS).to_owned(),
            Kind::Angle => self.choices.pick(ANGLES).to_owned(),
            Kind::Bool => self.choices.pick(&["true", "false"]).to_owned(),
            Kind::Text => self.choices.pick(TEXTS).to_owned(),
            Kind::Point(size) | Kind::Vector(size) => {
                let size = *size;
                format!("({})", self.list(size, |writer| writer.leaf(&Kind::Length)))
            }
            Kind::Control => self.control_point(),
            Kind::Record(place) => self.made_record(*place),
            Kind::List(element) => {
                let count = self.choices.below(5);
                format!("[{}]", self.list(count, |writer| writer.leaf(element)))
            }
        }
    }

    fn operation(&mut self, kind: &Kind) -> String {
        match kind {
            Kind::Int => self.whole(),
            Kind::Number => self.number(),
            Kind::Length => self.quantity(kind, "1mm"),
            Kind::Angle => self.quantity(kind, "1deg"),
            Kind::Bool => self.truth(),
            Kind::Text => {
                format!("({} + text({}))", self.expression(&Kind::Text), self.expression(&Kind::Number))
            }
            Kind::Point(_) | Kind::Vector(_) | Kind::Control => self.geometric(kind),
            Kind::Record(_) => self.leaf(kind),
            Kind::List(element) => self.listed(element),
        }
    }

    fn whole(&mut self) -> String {
        let (a, b) = (self.expression(&Kind::Int), self.expression(&Kind::Int));
        match self.choices.below(6) {
            0 => format!("({a} + {b})"),
            1 => format!("{a} * {b}"),
            2 => format!("({a} - {b})"),
            3 => format!("floor({})", self.expression(&Kind::Number)),
            4 => format!("len({})", self.expression(&Kind::list_of(Kind::Length))),
            _ => format!("mod({a}, {b})"),
        }
    }

    fn number(&mut self) -> String {
        let (a, b) = (self.expression(&Kind::Number), self.expression(&Kind::Number));
        match self.choices.below(9) {
            0 => format!("({a} + {b})"),
            1 => format!("{a} * {b}"),
            2 => format!("{a} / {b}"),
            3 => format!("(1 - {a})"),
            4 => format!("sin({})", self.expression(&Kind::Angle)),
            5 => format!("{} / {}", self.expression(&Kind::Length), self.expression(&Kind::Length)),
            6 => format!("pow({a}, {})", self.expression(&Kind::Int)),
            7 => format!("{}({a})", self.choices.pick(&["sqrt", "abs", "exp", "ln"])),
            _ => format!("sum({})", self.expression(&Kind::list_of(Kind::Number))),
        }
    }

    fn quantity(&mut self, kind: &Kind, unit: &str) -> String {
        let (a, b) = (self.expression(kind), self.expression(kind));
        match self.choices.below(6) {
            0 => format!("({a} + {b})"),
            1 => format!("{} * {a}", self.expression(&Kind::Number)),
            2 => format!("-{a}"),
            3 => format!("max({a}, {b})"),
            4 => format!("{a} / {}", self.expression(&Kind::Number)),
            _ => format!("{} * {unit}", self.expression(&Kind::Int)),
        }
    }

    fn truth(&mut self) -> String {
        let operator = self.choices.pick(&["<", "==", ">=", "!=", "<=", ">"]);
        match self.choices.below(4) {
            0 => format!("({} {operator} {})", self.expression(&Kind::Int), self.expression(&Kind::Int)),
            1 => {
                format!("({} {operator} {})", self.expression(&Kind::Length), self.expression(&Kind::Length))
            }
            2 => format!("({} and not {})", self.expression(&Kind::Bool), self.expression(&Kind::Bool)),
            _ => format!("({} or {})", self.expression(&Kind::Bool), self.expression(&Kind::Bool)),
        }
    }

    fn choice(&mut self, kind: &Kind) -> String {
        let condition = self.expression(&Kind::Bool);
        format!("(if {condition} then {} else {})", self.expression(kind), self.expression(kind))
    }

    fn listed(&mut self, element: &Kind) -> String {
        let list = Kind::list_of(element.clone());
        match self.choices.below(5) {
            0 => self.comprehension(element),
            1 => {
                let (from, to) = (self.leaf(&Kind::Int), self.leaf(&Kind::Int));
                format!("{}[{from}..{to}]", self.leaf(&list))
            }
            2 => format!("reverse({})", self.expression(&list)),
            3 => format!("concat([{}, {}])", self.expression(&list), self.expression(&list)),
            _ => self.leaf(&list),
        }
    }

    fn comprehension(&mut self, element: &Kind) -> String {
        let name = self.name("i");
        let count = self.choices.below(6);
        self.scope.values.push((name.clone(), Kind::Int));
        let body = self.expression(element);
        let condition = if self.choices.chance(4) {
            format!(" if {}", self.expression(&Kind::Bool))
        } else {
            String::new()
        };
        self.scope.values.pop();
        format!("[{body} for {name} in 0..{count}{condition}]")
    }

    /// A call of a function of the design that gives the kind.
    fn call(&mut self, kind: &Kind) -> String {
        let fitting: Vec<_> =
            self.scope.functions.iter().filter(|function| function.result == *kind).cloned().collect();
        if fitting.is_empty() {
            return self.operation(kind);
        }
        let function = &fitting[self.choices.below(fitting.len())];
        format!("{}({})", function.name, self.arguments(&function.parameters.clone()))
    }

    /// Arguments for parameters, by position or by name; now and then one is missing.
    pub(super) fn arguments(&mut self, parameters: &[(String, Kind)]) -> String {
        let named = self.choices.chance(3);
        let mut pieces = Vec::new();
        for (name, kind) in parameters {
            if self.choices.rarely() {
                continue;
            }
            let value = self.expression(kind);
            pieces.push(if named { format!("{name}: {value}") } else { value });
        }
        pieces.join(", ")
    }

    fn made_record(&mut self, place: usize) -> String {
        match self.scope.records.get(place).cloned() {
            None => "lost".to_owned(),
            Some(record) => {
                let fields: Vec<String> = record
                    .parameters
                    .iter()
                    .map(|(name, kind)| format!("{name}: {}", self.expression(kind)))
                    .collect();
                format!("{}({})", record.name, fields.join(", "))
            }
        }
    }
}
