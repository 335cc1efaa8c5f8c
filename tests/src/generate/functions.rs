//! Named values, parameters, functions, records and tests.

use super::Writer;
use super::scope::{Function, Kind};

impl Writer<'_> {
    /// Some kind of value outside of an ifs.
    fn kind(&mut self) -> Kind {
        let single = match self.choices.below(12) {
            0 => Kind::Number,
            1 | 2 => Kind::Length,
            3 => Kind::Int,
            4 => Kind::Angle,
            5 => Kind::Bool,
            6 => Kind::Text,
            7 | 8 => Kind::Point(3),
            9 => Kind::Point(2),
            10 => Kind::Vector(3),
            _ if self.scope.records.is_empty() => Kind::Number,
            _ => Kind::Record(self.choices.below(self.scope.records.len())),
        };
        if self.choices.chance(4) { Kind::list_of(single) } else { single }
    }

    pub(super) fn named_value(&mut self) -> String {
        let kind = self.kind();
        let name = self.name("value");
        let ty =
            if self.choices.chance(4) { format!(": {}", kind.written(&self.scope)) } else { String::new() };
        let value = self.expression(&kind);
        self.scope.values.push((name.clone(), kind));
        format!("let {name}{ty} = {value}")
    }

    pub(super) fn parameter(&mut self) -> String {
        let (kind, line) = match self.choices.below(5) {
            0 => (Kind::Length, "Length = 2m in 1m .. 4m step 500mm"),
            1 => (Kind::Number, "Number = 0.5 in 0 .. 1"),
            2 => (Kind::Int, "Int = 3 in 1 .. 5"),
            3 => (Kind::Angle, "Angle = 30deg in 0deg .. 90deg step 7deg"),
            _ => (Kind::Bool, "Bool = true"),
        };
        let name = self.name("param");
        let line = if self.choices.chance(8) {
            let (ty, value) = (kind.written(&self.scope), self.expression(&kind));
            format!("{ty} = {value} in {} .. {}", self.expression(&kind), self.expression(&kind))
        } else {
            line.to_owned()
        };
        self.scope.values.push((name.clone(), kind));
        format!("param {name}: {line}")
    }

    /// Parameters of a function or an ifs, as they are written and as they are known.
    pub(super) fn parameters(&mut self, most: usize, defaults: bool) -> (String, Vec<(String, Kind)>) {
        let count = self.choices.below(most + 1);
        let (mut written, mut known) = (Vec::new(), Vec::new());
        for _ in 0..count {
            let kind = if defaults {
                let kinds = [Kind::Number, Kind::Int, Kind::Number, Kind::Bool];
                kinds[self.choices.below(4)].clone()
            } else {
                self.kind()
            };
            let (name, ty) = (self.name("a"), kind.written(&self.scope));
            let default = if defaults { format!(" = {}", self.expression(&kind)) } else { String::new() };
            written.push(format!("{name}: {ty}{default}"));
            known.push((name, kind));
        }
        (written.join(", "), known)
    }

    pub(super) fn function(&mut self) -> String {
        let (written, known) = self.parameters(3, false);
        let result = self.kind();
        let name = self.name("f");
        let outside = self.scope.values.len();
        self.scope.values.extend(known.iter().cloned());
        let recursive = self.choices.chance(12);
        let function = Function { name: name.clone(), parameters: known, result: result.clone() };
        if recursive {
            self.scope.functions.push(function.clone());
        }
        let body = self.expression(&result);
        self.scope.values.truncate(outside);
        if !recursive {
            self.scope.functions.push(function);
        }
        let arrow = if self.choices.rarely() {
            String::new()
        } else {
            format!(" -> {}", result.written(&self.scope))
        };
        format!("fn {name}({written}){arrow} = {body}")
    }

    pub(super) fn record(&mut self) -> String {
        let fresh = self.scope.records.len();
        let name = format!("Record{fresh}");
        let count = 1 + self.choices.below(3);
        let mut fields = Vec::new();
        let mut known = Vec::new();
        for place in 0..count {
            let kind = if self.choices.chance(32) { Kind::Record(fresh) } else { self.kind() };
            let field = format!("field{place}");
            let ty = if kind == Kind::Record(fresh) { name.clone() } else { kind.written(&self.scope) };
            fields.push(format!("{field}: {ty}"));
            // Values of a record inside itself would never end.
            if kind != Kind::Record(fresh) {
                known.push((field, kind));
            }
        }
        let made = Function { name: name.clone(), parameters: known, result: Kind::Record(fresh) };
        self.scope.records.push(made);
        format!("record {name} {{ {} }}", fields.join(", "))
    }

    pub(super) fn test(&mut self) -> String {
        let condition = self.expression(&Kind::Bool);
        let value = self.expression(&Kind::Length);
        match self.choices.below(3) {
            0 => format!("test \"it holds\" {{ assert {condition} }}"),
            1 => format!("test \"a length\" {{ let n = {value} assert n == {value} }}"),
            _ => {
                let figure = self.scope.figures.last().map_or("lost", |figure| figure.name.as_str());
                format!("test \"boards\" {{ assert len({figure}.boards) >= 1 assert {condition} }}")
            }
        }
    }
}
