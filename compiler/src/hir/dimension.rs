//! Dimensions of quantities and the closed table of units.

use crate::exact::Rational;
use crate::syntax::ast::Unit;

/// The exponents of length, mass, time and angle. All zero: a plain number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Dimension {
    /// Exponent of length.
    pub length: i8,
    /// Exponent of mass.
    pub mass: i8,
    /// Exponent of time.
    pub time: i8,
    /// Exponent of angle.
    pub angle: i8,
}

const fn dimension(length: i8, mass: i8, time: i8, angle: i8) -> Dimension {
    Dimension { length, mass, time, angle }
}

/// Every dimension that has a name in the language.
const NAMED: &[(&str, Dimension)] = &[
    ("Number", Dimension::NUMBER),
    ("Length", Dimension::LENGTH),
    ("Area", Dimension::AREA),
    ("Volume", dimension(3, 0, 0, 0)),
    ("Angle", Dimension::ANGLE),
    ("Time", dimension(0, 0, 1, 0)),
    ("Speed", Dimension::SPEED),
    ("Frequency", Dimension::FREQUENCY),
    ("Mass", Dimension::MASS),
    ("Density", Dimension::DENSITY),
];

impl Dimension {
    /// A plain number.
    pub const NUMBER: Dimension = dimension(0, 0, 0, 0);
    /// A length.
    pub const LENGTH: Dimension = dimension(1, 0, 0, 0);
    /// An angle.
    pub const ANGLE: Dimension = dimension(0, 0, 0, 1);
    /// An area.
    pub const AREA: Dimension = dimension(2, 0, 0, 0);
    /// A mass.
    pub const MASS: Dimension = dimension(0, 1, 0, 0);
    /// A mass by volume.
    pub const DENSITY: Dimension = dimension(-3, 1, 0, 0);
    /// Length by time: a feed.
    pub const SPEED: Dimension = dimension(1, 0, -1, 0);
    /// Turns by time: a spindle's speed.
    pub const FREQUENCY: Dimension = dimension(0, 0, -1, 0);

    /// The dimension of this name.
    pub fn named(name: &str) -> Option<Dimension> {
        NAMED.iter().find(|(known, _)| *known == name).map(|(_, dimension)| *dimension)
    }

    /// The names of all dimensions.
    pub fn names() -> impl Iterator<Item = &'static str> {
        NAMED.iter().map(|(name, _)| *name)
    }

    /// Whether it has a name of its own, such as `Area`.
    pub fn is_named(self) -> bool {
        NAMED.iter().any(|(_, known)| *known == self)
    }

    /// Its name, or its exponents (`mm^2/s`) where it has none.
    pub fn name(self) -> String {
        if let Some((name, _)) = NAMED.iter().find(|(_, known)| *known == self) {
            return (*name).to_owned();
        }
        let parts = [(self.length, "mm"), (self.mass, "kg"), (self.time, "s"), (self.angle, "rad")];
        let side = |sign: i8| {
            let part = parts.iter().filter(|(exponent, _)| exponent.signum() == sign);
            let words: Vec<String> = part
                .map(|(exponent, unit)| match exponent.unsigned_abs() {
                    1 => (*unit).to_owned(),
                    n => format!("{unit}^{n}"),
                })
                .collect();
            words.join(" ")
        };
        match (side(1), side(-1)) {
            (over, under) if under.is_empty() => over,
            (over, under) => {
                let over = if over.is_empty() { "1" } else { &over };
                let single = !under.contains(' ');
                if single { format!("{over}/{under}") } else { format!("{over}/({under})") }
            }
        }
    }

    /// The dimension of a product; `None` beyond what a design could mean.
    pub fn times(self, other: Dimension) -> Option<Dimension> {
        self.combine(other, i8::checked_add)
    }

    /// The dimension of a quotient; `None` beyond what a design could mean.
    pub fn over(self, other: Dimension) -> Option<Dimension> {
        self.combine(other, i8::checked_sub)
    }

    /// The dimension of a square root, where the exponents are even.
    pub fn root(self) -> Option<Dimension> {
        let exponents = [self.length, self.mass, self.time, self.angle];
        exponents
            .iter()
            .all(|exponent| exponent % 2 == 0)
            .then(|| dimension(self.length / 2, self.mass / 2, self.time / 2, self.angle / 2))
    }

    fn combine(self, other: Dimension, op: fn(i8, i8) -> Option<i8>) -> Option<Dimension> {
        Some(Dimension {
            length: op(self.length, other.length)?,
            mass: op(self.mass, other.mass)?,
            time: op(self.time, other.time)?,
            angle: op(self.angle, other.angle)?,
        })
    }

    /// The unit messages use for it: its suffix and how many inner units (mm, rad, s, kg) it is worth.
    pub fn display_unit(self) -> (&'static str, f64) {
        match self {
            Dimension::NUMBER => ("", 1.0),
            Dimension::LENGTH => ("mm", 1.0),
            Dimension::ANGLE => ("deg", core::f64::consts::PI / 180.0),
            Dimension::SPEED => ("m/min", 1000.0 / 60.0),
            Dimension::FREQUENCY => ("rpm", 1.0 / 60.0),
            Dimension { length: 2, mass: 0, time: 0, angle: 0 } => ("m2", 1e6),
            Dimension { length: 3, mass: 0, time: 0, angle: 0 } => ("m3", 1e9),
            Dimension::DENSITY => ("kg/m3", 1e-9),
            Dimension { length: 0, mass: 1, time: 0, angle: 0 } => ("kg", 1.0),
            Dimension { length: 0, mass: 0, time: 1, angle: 0 } => ("s", 1.0),
            _ => ("", 1.0),
        }
    }
}

/// What one of a unit is worth inside the program (mm, kg, s, rad).
#[derive(Clone, Debug, PartialEq)]
pub enum Worth {
    /// So many inner units, exactly.
    Exact(Rational),
    /// So many times π inner units: degrees.
    TimesPi(Rational),
}

/// The dimension of a unit and its worth.
pub fn unit_worth(unit: Unit) -> (Dimension, Worth) {
    let exact = |n: i64, d: i64| Worth::Exact(ratio(n, d));
    let length = Dimension::LENGTH;
    match unit {
        Unit::Millimetre => (length, exact(1, 1)),
        Unit::Centimetre => (length, exact(10, 1)),
        Unit::Metre => (length, exact(1000, 1)),
        Unit::Inch => (length, exact(127, 5)),
        Unit::Foot => (length, exact(1524, 5)),
        Unit::SquareMillimetre => (dimension(2, 0, 0, 0), exact(1, 1)),
        Unit::SquareMetre => (dimension(2, 0, 0, 0), exact(1_000_000, 1)),
        Unit::CubicMillimetre => (dimension(3, 0, 0, 0), exact(1, 1)),
        Unit::CubicMetre => (dimension(3, 0, 0, 0), exact(1_000_000_000, 1)),
        Unit::Degree => (Dimension::ANGLE, Worth::TimesPi(ratio(1, 180))),
        Unit::Radian => (Dimension::ANGLE, exact(1, 1)),
        Unit::Second => (dimension(0, 0, 1, 0), exact(1, 1)),
        Unit::Minute => (dimension(0, 0, 1, 0), exact(60, 1)),
        Unit::RevolutionsPerMinute => (Dimension::FREQUENCY, exact(1, 60)),
        Unit::MillimetrePerMinute => (Dimension::SPEED, exact(1, 60)),
        Unit::MetrePerMinute => (Dimension::SPEED, exact(50, 3)),
        Unit::MillimetrePerSecond => (Dimension::SPEED, exact(1, 1)),
        Unit::MetrePerSecond => (Dimension::SPEED, exact(1000, 1)),
        Unit::Kilogram => (dimension(0, 1, 0, 0), exact(1, 1)),
        Unit::KilogramPerCubicMetre => (dimension(-3, 1, 0, 0), exact(1, 1_000_000_000)),
        Unit::Percent => (Dimension::NUMBER, exact(1, 100)),
    }
}

fn ratio(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator, denominator).unwrap_or_else(|| Rational::from(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_exponents() {
        assert_eq!(Dimension::LENGTH.times(Dimension::LENGTH).unwrap().name(), "Area");
        assert_eq!(Dimension::LENGTH.over(dimension(0, 0, 1, 0)).unwrap().name(), "Speed");
        assert_eq!(dimension(1, 1, -2, 0).name(), "mm kg/s^2");
        assert_eq!(dimension(-1, 0, 0, 0).name(), "1/mm");
        assert_eq!(dimension(0, 1, -2, -1).name(), "kg/(s^2 rad)");
        assert_eq!(dimension(2, 0, 0, 0).root(), Some(Dimension::LENGTH));
        assert_eq!(Dimension::LENGTH.root(), None);
    }
}
