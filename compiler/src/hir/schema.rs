//! The closed sets of words and the settings blocks that the program itself knows: what a fabricate block may say.
//!
//! The meaning of each setting is in `fabricate`; here are names, types and which of them must be given.

mod measure;

pub use measure::Measure;

use super::dimension::Dimension;
use super::types::Type;

/// A closed set of words that stand for themselves where one of them is needed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ChoiceKind {
    /// Where the design surface lies in the thickness.
    Side,
    /// Along which direction of the surface the grain runs.
    Grain,
    /// How the edges of panels are cut.
    Edges,
    /// How the ends of planks are cut.
    Ends,
    /// Which vertices planarizing leaves in place.
    Pin,
    /// Which directions of a net are closed.
    Closed,
    /// How planarizing goes about it.
    PlanarizeMethod,
    /// The language of a machine's programs.
    Dialect,
    /// On which side of the cutter the part lies.
    CutDirection,
    /// Where a program's Z is zero.
    ZZero,
    /// What of nested boards gets a program.
    Programs,
}

/// One word of a choice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// As written.
    pub name: &'static str,
    /// What it says.
    pub doc: &'static str,
}

const fn word(name: &'static str, doc: &'static str) -> Word {
    Word { name, doc }
}

impl ChoiceKind {
    /// Its words in order; a value of the choice is an index into them.
    pub fn words(self) -> &'static [Word] {
        const SIDE: &[Word] = &[
            word("inner", "the design surface is the inner face of the boards"),
            word("centred", "the design surface lies in the middle of the thickness"),
            word("outer", "the design surface is the outer face of the boards"),
        ];
        const GRAIN: &[Word] = &[
            word("u", "the grain runs along the first direction of the surface"),
            word("v", "the grain runs along the second direction of the surface"),
            word("free", "the grain may run in any direction: boards lie as they fit best"),
        ];
        const EDGES: &[Word] = &[
            word("square", "cut square to the face of the board"),
            word("bevelled", "cut to the plane that halves the angle to the neighbour"),
            word("stepped", "bevels in steps, as a mill with three axes can cut them"),
        ];
        const ENDS: &[Word] = &[
            word("square", "joints are cut square to the plank"),
            word("mitred", "joints are cut to half the angle that the curve turns by"),
        ];
        const PIN: &[Word] = &[
            word("boundary", "vertices on the border of the surface stay in place"),
            word("none", "every vertex may move"),
            word("corners", "the corners of the surface stay in place"),
        ];
        const CLOSED: &[Word] = &[
            word("u", "round in the first direction"),
            word("v", "round in the second direction"),
            word("uv", "round in both directions"),
        ];
        const METHOD: &[Word] = &[
            word(
                "perturbation",
                "the method of the paper: vertices are moved where that makes the quads flatter",
            ),
            word("projection", "the fast one: each quad is projected to a plane, and vertices go between"),
        ];
        const DIALECT: &[Word] = &[
            word("linuxcnc", "programs for LinuxCNC"),
            word("grbl", "programs for Grbl, one for each tool, since it changes none"),
            word("fanuc", "programs for Fanuc, with line numbers"),
        ];
        const CUT_DIRECTION: &[Word] = &[
            word("climb", "the cutter turns with its way along the edge"),
            word("conventional", "the cutter turns against its way along the edge"),
        ];
        const Z_ZERO: &[Word] = &[
            word("top_of_stock", "Z is zero at the top of the raw board"),
            word("table", "Z is zero at the table below the raw board"),
        ];
        const PROGRAMS: &[Word] = &[
            word("both", "each board alone gets a program, and each sheet"),
            word("boards", "each board alone gets a program"),
            word("sheets", "each sheet gets a program for all of its boards"),
        ];
        match self {
            ChoiceKind::Programs => PROGRAMS,
            ChoiceKind::Dialect => DIALECT,
            ChoiceKind::CutDirection => CUT_DIRECTION,
            ChoiceKind::ZZero => Z_ZERO,
            ChoiceKind::Side => SIDE,
            ChoiceKind::Grain => GRAIN,
            ChoiceKind::Edges => EDGES,
            ChoiceKind::Ends => ENDS,
            ChoiceKind::Pin => PIN,
            ChoiceKind::Closed => CLOSED,
            ChoiceKind::PlanarizeMethod => METHOD,
        }
    }

    /// The place of a word in the choice.
    pub fn position(self, name: &str) -> Option<usize> {
        self.words().iter().position(|word| word.name == name)
    }
}

/// A block of settings the program knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SchemaKind {
    /// `fabricate … as panels`
    Panels,
    /// `fabricate … as planks`
    Planks,
    /// `planarize: { … }`
    Planarize,
    /// `nest: { … }` of panels
    Sheets,
    /// `nest: { … }` of planks
    Bars,
}

/// What a setting takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SettingType {
    /// A value of this type.
    Of(Type),
    /// A record of the library by its name.
    Library(&'static str),
}

/// One setting.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setting {
    /// As written.
    pub name: &'static str,
    /// What it takes.
    pub ty: SettingType,
    /// Whether it must be given.
    pub required: bool,
    /// One line for people.
    pub doc: &'static str,
}

fn setting(name: &'static str, ty: Type, required: bool, doc: &'static str) -> Setting {
    Setting { name, ty: SettingType::Of(ty), required, doc }
}

fn library(name: &'static str, record: &'static str, required: bool, doc: &'static str) -> Setting {
    Setting { name, ty: SettingType::Library(record), required, doc }
}

impl SchemaKind {
    /// What the block is called in messages.
    pub fn name(self) -> &'static str {
        match self {
            SchemaKind::Panels => "panels",
            SchemaKind::Planks => "planks",
            SchemaKind::Planarize => "planarize",
            SchemaKind::Sheets => "nests of panels",
            SchemaKind::Bars => "nests of planks",
        }
    }

    /// The settings of the block in order.
    pub fn settings(self) -> Vec<Setting> {
        match self {
            SchemaKind::Panels => panels(),
            SchemaKind::Planks => planks(),
            SchemaKind::Planarize => planarize(),
            SchemaKind::Sheets => sheets(),
            SchemaKind::Bars => bars(),
        }
    }

    /// The settings of the block, those of the machine shop last.
    pub fn setting(self, name: &str) -> Option<Setting> {
        self.settings().into_iter().find(|setting| setting.name == name)
    }
}

fn panels() -> Vec<Setting> {
    let mut settings = vec![
        setting("material", Type::Material, true, "what the boards are cut from; it gives the thickness"),
        setting("board", Type::Size, true, "the size of a raw board, length by width"),
        setting(
            "side",
            Type::Choice(ChoiceKind::Side),
            false,
            "where the design surface lies in the thickness",
        ),
        setting("grain", Type::Choice(ChoiceKind::Grain), false, "the direction the grain runs"),
        setting("edges", Type::Choice(ChoiceKind::Edges), false, "how the edges are cut"),
        setting("planarize", Type::Settings(SchemaKind::Planarize), false, "make the quads flat first"),
        setting("nest", Type::Settings(SchemaKind::Sheets), false, "lay the boards out on raw boards"),
    ];
    settings.extend(shop());
    settings
}

fn planks() -> Vec<Setting> {
    let mut settings = vec![
        setting("material", Type::Material, true, "what the planks are cut from"),
        setting("section", Type::Size, true, "depth, in the plane of the curve, by width"),
        setting("stock", Type::LENGTH, false, "the length of a raw bar"),
        setting("ends", Type::Choice(ChoiceKind::Ends), false, "how the ends at joints are cut"),
        setting(
            "first",
            Type::Cut,
            false,
            "where the first plank of a curve begins: square, or cut to a plane",
        ),
        setting("last", Type::Cut, false, "where the last plank of a curve ends: square, or cut to a plane"),
        setting("gap", Type::LENGTH, false, "how much each side of a joint is shortened"),
        setting("nest", Type::Settings(SchemaKind::Bars), false, "cut the planks out of raw bars"),
    ];
    settings.extend(shop());
    settings
}

fn shop() -> Vec<Setting> {
    vec![
        library("address", "Engraving", false, "how the alias is engraved"),
        library("machine", "Machine", false, "the machine that cuts; without it no NC program is written"),
        library("fixing", "Fixing", false, "what holds a board while it is cut; else as the machine says"),
        setting(
            "scale",
            Type::Quantity(Dimension::NUMBER),
            false,
            "makes a model: the geometry is that much smaller, thickness and tools are not",
        ),
    ]
}

fn planarize() -> Vec<Setting> {
    let number = || Type::Quantity(Dimension::NUMBER);
    vec![
        setting("method", Type::Choice(ChoiceKind::PlanarizeMethod), false, "how to go about it"),
        setting("worst", number(), false, "the weight of the worst planarity (alpha)"),
        setting("average", number(), false, "the weight of the average planarity (beta)"),
        setting("select", number(), false, "quads below this planarity are worked on"),
        setting("threshold", number(), false, "the goal; else the block's `require planarity`"),
        setting("step", Type::LENGTH, false, "the finite-difference step of the gradient"),
        setting("move", Type::LENGTH, false, "the length of the first move"),
        setting("iterations", Type::Int, false, "how many iterations at most"),
        setting("pin", Type::Choice(ChoiceKind::Pin), false, "which vertices stay in place"),
    ]
}

fn sheets() -> Vec<Setting> {
    vec![
        setting("gap", Type::LENGTH, false, "the least distance between boards"),
        setting("margin", Type::LENGTH, false, "the least distance from the edge of the raw board"),
        setting(
            "programs",
            Type::Choice(ChoiceKind::Programs),
            false,
            "what gets a program: boards, sheets or both",
        ),
    ]
}

fn bars() -> Vec<Setting> {
    vec![
        setting("kerf", Type::LENGTH, false, "what the saw blade takes"),
        setting("trim", Type::LENGTH, false, "what is left aside at each end of a raw bar"),
    ]
}
