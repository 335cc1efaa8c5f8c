//! The closed table of units (`LANGUAGE.md` 8, 10): their names and how they are written. What they are worth is in
//! `hir::dimension`.

/// A unit of the closed table (`LANGUAGE.md` 8).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[allow(missing_docs, reason = "the names are the units")]
pub enum Unit {
    Millimetre,
    Centimetre,
    Metre,
    Inch,
    Foot,
    SquareMetre,
    SquareMillimetre,
    CubicMetre,
    CubicMillimetre,
    Degree,
    Radian,
    Second,
    Minute,
    RevolutionsPerMinute,
    MillimetrePerMinute,
    MetrePerMinute,
    MillimetrePerSecond,
    MetrePerSecond,
    Kilogram,
    KilogramPerCubicMetre,
    Percent,
}

impl Unit {
    /// Every unit.
    pub const ALL: &[Unit] = &[
        Unit::Millimetre,
        Unit::Centimetre,
        Unit::Metre,
        Unit::Inch,
        Unit::Foot,
        Unit::SquareMetre,
        Unit::SquareMillimetre,
        Unit::CubicMetre,
        Unit::CubicMillimetre,
        Unit::Degree,
        Unit::Radian,
        Unit::Second,
        Unit::Minute,
        Unit::RevolutionsPerMinute,
        Unit::MillimetrePerMinute,
        Unit::MetrePerMinute,
        Unit::MillimetrePerSecond,
        Unit::MetrePerSecond,
        Unit::Kilogram,
        Unit::KilogramPerCubicMetre,
        Unit::Percent,
    ];

    /// The suffix as written.
    pub fn suffix(self) -> &'static str {
        match self {
            Unit::Millimetre => "mm",
            Unit::Centimetre => "cm",
            Unit::Metre => "m",
            Unit::Inch => "in",
            Unit::Foot => "ft",
            Unit::SquareMetre => "m2",
            Unit::SquareMillimetre => "mm2",
            Unit::CubicMetre => "m3",
            Unit::CubicMillimetre => "mm3",
            Unit::Degree => "deg",
            Unit::Radian => "rad",
            Unit::Second => "s",
            Unit::Minute => "min",
            Unit::RevolutionsPerMinute => "rpm",
            Unit::MillimetrePerMinute => "mm/min",
            Unit::MetrePerMinute => "m/min",
            Unit::MillimetrePerSecond => "mm/s",
            Unit::MetrePerSecond => "m/s",
            Unit::Kilogram => "kg",
            Unit::KilogramPerCubicMetre => "kg/m3",
            Unit::Percent => "%",
        }
    }
}
