//! Combinations of points, placed or control: sums that are points, vectors, or on the way.

use super::Writer;
use super::scope::Kind;

impl Writer<'_> {
    /// A control point of the ifs around.
    pub(super) fn control_point(&mut self) -> String {
        if self.scope.points.is_empty() {
            return "lost_point".to_owned();
        }
        let place = self.choices.below(self.scope.points.len());
        self.scope.points[place].clone()
    }

    /// A point, a vector or a combination out of others.
    pub(super) fn geometric(&mut self, kind: &Kind) -> String {
        let size = match kind {
            Kind::Point(size) | Kind::Vector(size) => *size,
            _ => 0,
        };
        if matches!(kind, Kind::Vector(_)) {
            return self.vector(size);
        }
        let (a, b) = (self.expression(kind), self.expression(kind));
        match self.choices.below(9) {
            0 => format!("lerp({a}, {b}, {})", self.expression(&Kind::Number)),
            1 => format!("({a} + {b}) / 2"),
            2 => {
                let weight = self.expression(&Kind::Number);
                format!("((1 - {weight}) * {a} + {weight} * {b})")
            }
            3 => format!("({a} + {} * ({b} - {}))", self.expression(&Kind::Number), self.expression(kind)),
            4 => {
                let (u, v, w) = (self.choices.below(5), self.choices.below(5), self.choices.below(5));
                format!("({u} * {a} + {v} * {b} + {w} * {}) / {}", self.expression(kind), u + v + w)
            }
            5 => {
                let list = self.expression(&Kind::list_of(kind.clone()));
                format!("sum({list}) / len({list})")
            }
            6 if size > 0 => format!("{a} + {}", self.vector(size)),
            7 => {
                let list = self.expression(&Kind::list_of(kind.clone()));
                format!("{list}[{}]", self.expression(&Kind::Int))
            }
            // A sum that may be anything.
            _ => format!("({} * {a} - {b} / {})", self.expression(&Kind::Number), self.leaf_divisor()),
        }
    }

    fn leaf_divisor(&mut self) -> String {
        self.choices.pick(&["2", "3", "0", "(1/3)", "-4"]).to_owned()
    }

    fn vector(&mut self, size: usize) -> String {
        let point = Kind::Point(size);
        match self.choices.below(5) {
            0 => format!("({} - {})", self.expression(&point), self.expression(&point)),
            1 => format!("{} * {}", self.expression(&Kind::Number), self.expression(&Kind::Vector(size))),
            2 => format!(
                "({} + {})",
                self.expression(&Kind::Vector(size)),
                self.expression(&Kind::Vector(size))
            ),
            3 => {
                let length = self.expression(&Kind::Length);
                format!("with_length({}, {length})", self.expression(&Kind::Vector(size)))
            }
            _ => format!("-{}", self.expression(&Kind::Vector(size))),
        }
    }

    /// An affine map, for `in plane` (2) and `in space` (3).
    pub(super) fn map(&mut self, size: usize) -> String {
        let number = self.expression(&Kind::Number);
        match (self.choices.below(6), size) {
            (0, _) => format!("scale({number})"),
            (1, _) => {
                format!("translate({})", self.list(size, |writer| writer.expression(&Kind::Length)))
            }
            (2, 2) => format!("rotate({})", self.expression(&Kind::Angle)),
            (2, _) => {
                format!("turn({}, {})", self.choices.pick(&["z", "x", "y"]), self.expression(&Kind::Angle))
            }
            (3, 2) => {
                format!("affine({})", self.list(4, |writer| writer.expression(&Kind::Number)))
            }
            (4, _) => format!("{} * {}", self.map(size), self.map(size)),
            _ => format!("scale({number}, {})", self.expression(&Kind::Number)),
        }
    }
}
