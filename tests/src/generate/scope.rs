//! What a design has declared so far, by kind.

/// What a value is, as far as the generator knows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Int,
    Number,
    Length,
    Angle,
    Bool,
    Text,
    /// A point with so many coordinates.
    Point(usize),
    /// A vector with so many coordinates.
    Vector(usize),
    /// A combination of the control points of the ifs around.
    Control,
    /// A number of one of the records, by its place.
    Record(usize),
    List(Box<Kind>),
}

impl Kind {
    pub(super) fn list_of(kind: Kind) -> Kind {
        Kind::List(Box::new(kind))
    }

    /// The type as it is written.
    pub(super) fn written(&self, scope: &Scope) -> String {
        match self {
            Kind::Int => "Int".to_owned(),
            Kind::Number => "Number".to_owned(),
            Kind::Length => "Length".to_owned(),
            Kind::Angle => "Angle".to_owned(),
            Kind::Bool => "Bool".to_owned(),
            Kind::Text => "Text".to_owned(),
            Kind::Point(_) | Kind::Control => "Point".to_owned(),
            Kind::Vector(_) => "Vector".to_owned(),
            Kind::Record(place) => scope.records.get(*place).map_or("Lost".to_owned(), |it| it.name.clone()),
            Kind::List(element) => format!("[{}]", element.written(scope)),
        }
    }
}

/// A function, or a record as the function that makes it.
#[derive(Clone, Debug)]
pub(super) struct Function {
    pub(super) name: String,
    pub(super) parameters: Vec<(String, Kind)>,
    pub(super) result: Kind,
}

/// An ifs.
#[derive(Clone, Debug)]
pub(super) struct IfsName {
    pub(super) name: String,
    pub(super) parameters: Vec<(String, Kind)>,
    pub(super) space: Space,
    /// Whether it is a curve, or draws something else.
    pub(super) curve: bool,
}

/// Where an ifs lives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Space {
    /// On so many control points.
    Points(usize),
    /// In the plane (2) or in space (3).
    Coordinates(usize),
}

/// A figure.
#[derive(Clone, Debug)]
pub(super) struct FigureName {
    pub(super) name: String,
    pub(super) surface: bool,
}

/// Everything declared.
#[derive(Clone, Debug, Default)]
pub(super) struct Scope {
    pub(super) values: Vec<(String, Kind)>,
    pub(super) functions: Vec<Function>,
    pub(super) records: Vec<Function>,
    pub(super) ifs: Vec<IfsName>,
    pub(super) figures: Vec<FigureName>,
    /// The control points of the ifs around.
    pub(super) points: Vec<String>,
}

impl Scope {
    /// The values of a kind.
    pub(super) fn of(&self, kind: &Kind) -> Vec<&str> {
        self.values.iter().filter(|(_, other)| other == kind).map(|(name, _)| name.as_str()).collect()
    }
}
