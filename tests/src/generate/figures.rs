//! Figures: an ifs placed on points at a level, lists of them, sheets and tensors.

use super::Writer;
use super::scope::{FigureName, IfsName, Kind, Space};

/// The curves of the library with their numbers of control points.
const LIBRARY: &[(&str, usize)] = &[("bezier3", 4), ("bspline3", 4), ("bezier2", 3), ("bspline2", 3)];

impl Writer<'_> {
    pub(super) fn figure(&mut self) -> String {
        let name = self.name("figure");
        let surface = self.choices.chance(3);
        let value = if surface {
            self.surface()
        } else if self.choices.chance(4) {
            self.several()
        } else {
            self.curve()
        };
        self.scope.figures.push(FigureName { name: name.clone(), surface });
        format!("figure {name} = {value}\n")
    }

    /// How deep it goes.
    fn level(&mut self) -> String {
        let number = self.choices.below(5);
        match self.choices.below(12) {
            7 => format!("at level ({number}, {})", self.choices.below(4)),
            8 => format!("until edge <= {}", self.expression(&Kind::Length)),
            9 => format!("each until size <= {}", self.expression(&Kind::Length)),
            10 => format!("at level {}", self.expression(&Kind::Int)),
            11 => String::new(),
            _ => format!("at level {number}"),
        }
    }

    /// The name of an ifs, with arguments where it has parameters, and where it lives.
    fn some_ifs(&mut self) -> (String, Space) {
        let own = self.scope.ifs.len();
        let place = self.choices.below(own + LIBRARY.len());
        let Some(ifs) = self.scope.ifs.get(own.wrapping_sub(1 + place)).cloned() else {
            let (name, points) = LIBRARY[place.saturating_sub(own)];
            return (name.to_owned(), Space::Points(points));
        };
        (self.with_arguments(&ifs), ifs.space)
    }

    fn with_arguments(&mut self, ifs: &IfsName) -> String {
        if ifs.parameters.is_empty() || self.choices.chance(2) {
            return ifs.name.clone();
        }
        format!("{}({})", ifs.name, self.arguments(&ifs.parameters))
    }

    fn curve(&mut self) -> String {
        let (ifs, space) = self.some_ifs();
        let level = self.level();
        match space {
            Space::Coordinates(_) => format!("{ifs} {level}"),
            Space::Points(count) => {
                let size = if self.choices.chance(3) { 2 } else { 3 };
                let points = self.points(count, size);
                format!("{ifs} on {points} {level}")
            }
        }
    }

    /// Placed points: along a line with some height, or anywhere.
    fn points(&mut self, count: usize, size: usize) -> String {
        let count = count + usize::from(self.choices.rarely());
        let mut pieces = Vec::new();
        for place in 0..count {
            pieces.push(match self.choices.below(6) {
                4 => self.expression(&Kind::Point(size)),
                5 => format!(
                    "weighted({}, w: {})",
                    self.expression(&Kind::Point(size)),
                    self.expression(&Kind::Number)
                ),
                height if size == 2 => format!("({place}m, {height} * 300mm)"),
                height => format!("({place}m, 0m, {height} * 300mm)"),
            });
        }
        format!("({})", pieces.join(", "))
    }

    fn several(&mut self) -> String {
        let (ifs, space) = self.some_ifs();
        let count = match space {
            Space::Points(count) => count,
            Space::Coordinates(count) => count + 1,
        };
        let (many, level) = (1 + self.choices.below(4), self.choices.below(4));
        let step = self.choices.pick(&["27mm", "1m", "0m", "-3cm"]);
        let points: Vec<String> = (0..count)
            .map(|place| format!("({place}m, i * {step}, {} * 250mm)", self.choices.below(5)))
            .collect();
        format!("[{ifs} on ({}) at level {level} for i in 0..{many}]", points.join(", "))
    }

    fn surface(&mut self) -> String {
        let own: Vec<(String, usize)> = self
            .scope
            .ifs
            .iter()
            .filter_map(|ifs| match ifs.space {
                Space::Points(count) => Some((ifs.name.clone(), count)),
                Space::Coordinates(_) => None,
            })
            .collect();
        let (u, v) = (self.factor(&own), self.factor(&own));
        let level = self.level();
        let (more_u, more_v) = (self.choices.below(4), self.choices.below(4));
        match self.choices.below(8) {
            0 | 1 => format!("tensor({}, {}) on {} {level}", u.0, v.0, self.net(u.1, v.1)),
            2..=5 => format!("sheet({}, {}, {}) {level}", u.0, v.0, self.net(u.1 + more_u, v.1 + more_v)),
            6 => format!("sheet({}, {}, {}, closed: u) {level}", u.0, v.0, self.net(u.1 + more_u, v.1)),
            _ => {
                let names: Vec<String> =
                    self.scope.figures.iter().map(|figure| figure.name.clone()).collect();
                let name = |place: usize| names.get(place).map_or("lost", String::as_str).to_owned();
                format!("translation({}, {})", name(self.choices.below(4)), name(self.choices.below(4)))
            }
        }
    }

    fn factor(&mut self, own: &[(String, usize)]) -> (String, usize) {
        let place = self.choices.below(own.len() + LIBRARY.len());
        let library = |place: usize| (LIBRARY[place].0.to_owned(), LIBRARY[place].1);
        place.checked_sub(LIBRARY.len()).map_or_else(|| library(place), |place| own[place].clone())
    }

    /// A grid of points in space.
    fn net(&mut self, rows: usize, columns: usize) -> String {
        let height = match self.choices.below(4) {
            0 => "0.3m * sin(40deg * i) * sin(30deg * j)".to_owned(),
            1 => "i * j * 50mm".to_owned(),
            2 => "0m".to_owned(),
            _ => self.expression(&Kind::Length),
        };
        let (x, y) = (self.choices.pick(&["1m", "300mm", "0m"]), self.choices.pick(&["1m", "250mm", "-1m"]));
        format!("[[(i * {x}, j * {y}, {height}) for j in 0..{columns}] for i in 0..{rows}]")
    }
}
