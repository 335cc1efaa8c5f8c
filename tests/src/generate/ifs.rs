//! Random ifs: chains of copies that meet, graphs of several, copies anywhere, and maps of plane and space.

use super::Writer;
use super::scope::{IfsName, Kind, Space};

impl Writer<'_> {
    pub(super) fn ifs(&mut self) -> String {
        let (written, known) = self.parameters(2, true);
        let brackets = if written.is_empty() { String::new() } else { format!("({written})") };
        let name = self.name("c");
        let outside = self.scope.values.len();
        self.scope.values.extend(known.iter().cloned());
        let space = match self.choices.below(6) {
            4 => Space::Coordinates(2),
            5 => Space::Coordinates(3),
            other => Space::Points(2 + other % 3),
        };
        let curve = !self.choices.chance(4);
        let made = IfsName { name: name.clone(), parameters: known, space, curve };
        let (place, members) = match space {
            Space::Points(count) => {
                let points: Vec<String> = (0..count).map(|place| format!("p{place}")).collect();
                self.scope.points.clone_from(&points);
                (format!("on ({})", points.join(", ")), self.members(&made, count))
            }
            Space::Coordinates(2) => ("in plane".to_owned(), self.maps(2)),
            Space::Coordinates(_) => ("in space".to_owned(), self.maps(3)),
        };
        self.scope.points.clear();
        self.scope.values.truncate(outside);
        self.scope.ifs.push(made);
        format!("ifs {name}{brackets} {place} {{\n{members}}}")
    }

    fn members(&mut self, ifs: &IfsName, count: usize) -> String {
        let mut lines = Vec::new();
        for _ in 0..self.choices.below(4) {
            let name = self.name("q");
            let kind = if self.choices.chance(4) { Kind::list_of(Kind::Control) } else { Kind::Control };
            lines.push(format!("let {name} = {}", self.expression(&kind)));
            self.scope.values.push((name, kind));
        }
        lines.extend(if ifs.curve { self.chain(ifs, count) } else { self.anywhere(ifs, count) });
        lines.push(self.germ(count));
        if self.choices.chance(8) {
            lines.push(format!("keep segment({}, {})", self.control_point(), self.control_point()));
        }
        if self.choices.chance(8) {
            lines.extend(self.boundaries());
        }
        lines.iter().map(|line| format!("  {line}\n")).collect()
    }

    fn germ(&mut self, count: usize) -> String {
        let last = count - 1;
        match self.choices.below(8) {
            5 => format!("germ polygon({})", self.list(count, Self::control_point)),
            6 => format!("germ quad({})", self.list(4, Self::control_point)),
            7 => format!(
                "germ segment({}, {})",
                self.expression(&Kind::Control),
                self.expression(&Kind::Control)
            ),
            _ => format!("germ segment(p0, p{last})"),
        }
    }

    /// Copies from the first point to the last, each beginning where the one before ends.
    fn chain(&mut self, ifs: &IfsName, count: usize) -> Vec<String> {
        let copies = 1 + self.choices.below(4);
        let mut knots = vec!["p0".to_owned()];
        for place in 1..copies {
            let weight = format!("{place}/{copies}");
            knots.push(if self.choices.chance(2) {
                self.expression(&Kind::Control)
            } else {
                format!("lerp(p0, p{}, {weight})", count - 1)
            });
        }
        knots.push(format!("p{}", count - 1));
        let mut lines = Vec::new();
        for pair in knots.windows(2) {
            let middle: Vec<String> = (2..count)
                .map(|_| match self.choices.below(3) {
                    0 => format!("lerp({}, {}, 1/2)", pair[0], pair[1]),
                    1 => format!("lerp({}, {}, 1/2)", pair[0], self.control_point()),
                    _ => self.expression(&Kind::Control),
                })
                .collect();
            let images = [&pair[..1], &middle, &pair[1..]].concat().join(", ");
            let (name, target) = (self.name("t"), self.target(ifs, count));
            lines.push(format!("transform {name} = {target} on ({images})"));
        }
        lines
    }

    /// Copies anywhere, in a family now and then.
    fn anywhere(&mut self, ifs: &IfsName, count: usize) -> Vec<String> {
        let mut lines = Vec::new();
        for _ in 0..=self.choices.below(3) {
            let family = self.choices.chance(4);
            let name = self.name("t");
            let index = if family { format!("[i in 0..{}]", self.choices.below(5)) } else { String::new() };
            if family {
                self.scope.values.push(("i".to_owned(), Kind::Int));
            }
            let wrong = usize::from(self.choices.rarely());
            let images = self.list(count + wrong, |writer| writer.expression(&Kind::Control));
            let target = self.target(ifs, count);
            lines.push(format!("transform {name}{index} = {target} on ({images})"));
            if family {
                self.scope.values.pop();
            }
        }
        lines
    }

    /// What a copy continues with: the ifs itself, with other arguments, or another ifs.
    fn target(&mut self, ifs: &IfsName, count: usize) -> String {
        let others: Vec<IfsName> =
            self.scope.ifs.iter().filter(|other| other.space == Space::Points(count)).cloned().collect();
        match self.choices.below(8) {
            5 if !ifs.parameters.is_empty() => format!("self({})", self.arguments(&ifs.parameters)),
            6 if !others.is_empty() => {
                let other = &others[self.choices.below(others.len())];
                let arguments = self.arguments(&other.parameters);
                if arguments.is_empty() { other.name.clone() } else { format!("{}({arguments})", other.name) }
            }
            7 => ifs.name.clone(),
            _ => "self".to_owned(),
        }
    }

    fn boundaries(&mut self) -> Vec<String> {
        let names: Vec<String> = (0..2).map(|_| self.control_point()).collect();
        let other = self.scope.ifs.last().map_or("bezier2".to_owned(), |ifs| ifs.name.clone());
        vec![
            format!("boundary start = {other} on ({})", names.join(", ")),
            format!("boundary end = {other} on ({})", names.join(", ")),
            format!("join {} = {}", self.join_end(), self.join_end()),
        ]
    }

    fn join_end(&mut self) -> String {
        self.choices.pick(&["start", "t1.end", "t2.start", "left.end", "end", "t3.end"]).to_owned()
    }

    /// The members of an ifs in the plane or in space.
    fn maps(&mut self, size: usize) -> String {
        let mut lines = Vec::new();
        for _ in 0..=self.choices.below(4) {
            let name = self.name("t");
            let index = if self.choices.chance(4) {
                format!("[i in 0..{}]", self.choices.below(4))
            } else {
                String::new()
            };
            lines.push(format!("transform {name}{index} = {} * self", self.map(size)));
        }
        let point = Kind::Point(size);
        let (a, b) = (self.expression(&point), self.expression(&point));
        lines.push(match self.choices.below(4) {
            0 | 1 => format!("germ segment({a}, {b})"),
            2 => format!("germ point({a})"),
            _ => format!("germ polygon({a}, {b}, {})", self.expression(&point)),
        });
        if self.choices.chance(3) {
            lines.push(format!("keep strut({a}, {b}, width: {})", self.expression(&Kind::Length)));
        }
        lines.iter().map(|line| format!("  {line}\n")).collect()
    }
}
