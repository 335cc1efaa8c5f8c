//! What can be wrong with a program. Plain data with stable codes.

use std::fmt;

/// What a fault is about. [`FaultKind::code`] is stable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[allow(missing_docs, reason = "each kind is documented by its sentence in `TABLE`")]
pub enum FaultKind {
    NotAscii,
    LineLength,
    Syntax,
    Word,
    Comment,
    ProgramFrame,
    FileSet,
    Modes,
    FirstMotion,
    UnknownPosition,
    RapidBelowSafe,
    RapidMixesAxes,
    FeedMissing,
    FeedRange,
    PlungeRange,
    SpindleOff,
    SpindleRange,
    SpindleSpinUp,
    ToolNotLoaded,
    ToolChange,
    ToolLength,
    Envelope,
    Clamp,
    TooDeep,
    FluteLength,
    StepDown,
    ArcRadii,
    Gouge,
    Uncut,
    OutlineOpen,
    Tabs,
    EngravingOutside,
    EngravingDepth,
    EngravingText,
    EngravingMark,
    EngravingOrder,
    EndHeight,
    SpindleOnAtEnd,
    ProgramEnd,
    Header,
    Extents,
}

/// Every kind, its code, and the property it means is broken.
pub const TABLE: [(FaultKind, &str, &str); 41] = [
    (FaultKind::NotAscii, "nc-not-ascii", "lines are printable ASCII and end in LF"),
    (FaultKind::LineLength, "nc-line-length", "lines are under 70 characters"),
    (FaultKind::Syntax, "nc-syntax", "lines are words with plain numbers, or one comment"),
    (FaultKind::Word, "nc-word", "only words of the dialect appear, each once in a line"),
    (
        FaultKind::Comment,
        "nc-comment",
        "comments have only characters that neither end them nor steer the machine",
    ),
    (
        FaultKind::ProgramFrame,
        "nc-program-frame",
        "the program begins and ends as its dialect asks, with its number",
    ),
    (
        FaultKind::FileSet,
        "nc-file-set",
        "there is one file, or one for each tool in order where tools are put in by hand",
    ),
    (FaultKind::Modes, "nc-modes", "all modes are set before the first motion"),
    (FaultKind::FirstMotion, "nc-first-motion", "the first motion with a tool is Z to the safe height"),
    (FaultKind::UnknownPosition, "nc-unknown-position", "feed motion starts from a known position"),
    (
        FaultKind::RapidBelowSafe,
        "nc-rapid-below-safe",
        "rapids stay at or above the safe height, or go straight up to it",
    ),
    (FaultKind::RapidMixesAxes, "nc-rapid-mixes-axes", "no rapid moves Z together with X or Y"),
    (FaultKind::FeedMissing, "nc-feed-missing", "a feed is set before feed motion"),
    (FaultKind::FeedRange, "nc-feed-range", "the feed is within the tool's"),
    (
        FaultKind::PlungeRange,
        "nc-plunge-range",
        "the tool goes down in material no faster than its plunge feed",
    ),
    (FaultKind::SpindleOff, "nc-spindle-off", "the spindle turns in feed motion"),
    (FaultKind::SpindleRange, "nc-spindle-range", "the spindle speed is within the machine's range"),
    (FaultKind::SpindleSpinUp, "nc-spindle-spin-up", "the spindle has had time to reach its speed"),
    (FaultKind::ToolNotLoaded, "nc-tool-not-loaded", "a tool of the machine that the job needs is loaded"),
    (FaultKind::ToolChange, "nc-tool-change", "tools are changed with the spindle off, at the safe height"),
    (FaultKind::ToolLength, "nc-tool-length", "the loaded tool's own length offset is active"),
    (FaultKind::Envelope, "nc-envelope", "all motion stays in the machine's travel"),
    (FaultKind::Clamp, "nc-clamp", "no tool touches a clamp"),
    (
        FaultKind::TooDeep,
        "nc-too-deep",
        "no cut is deeper than thickness and cut-through, or than the onion skin allows",
    ),
    (FaultKind::FluteLength, "nc-flute-length", "no cut is deeper than the tool's flutes"),
    (FaultKind::StepDown, "nc-step-down", "no pass takes more than the tool's step-down"),
    (FaultKind::ArcRadii, "nc-arc-radii", "both radii of an arc agree within 0.002 mm"),
    (FaultKind::Gouge, "nc-gouge", "the cutter does not cut into the part"),
    (FaultKind::Uncut, "nc-uncut", "the cutter reaches all of the outline at full depth"),
    (FaultKind::OutlineOpen, "nc-outline-open", "the full-depth path closes around the part"),
    (FaultKind::Tabs, "nc-tabs", "tabs are as many, as wide and as high as asked, on straight edges"),
    (
        FaultKind::EngravingOutside,
        "nc-engraving-outside",
        "engraving lies inside the part with its clearance",
    ),
    (FaultKind::EngravingDepth, "nc-engraving-depth", "engraving is as deep as asked"),
    (FaultKind::EngravingText, "nc-engraving-text", "the engraved strokes spell the alias"),
    (FaultKind::EngravingMark, "nc-engraving-mark", "the tick stands at right angles to edge 0, beside it"),
    (FaultKind::EngravingOrder, "nc-engraving-order", "engraving comes before the contour"),
    (FaultKind::EndHeight, "nc-end-height", "the program ends at the safe height"),
    (FaultKind::SpindleOnAtEnd, "nc-spindle-on-at-end", "the program ends with the spindle off"),
    (FaultKind::ProgramEnd, "nc-program-end", "there is exactly one program end, last"),
    (FaultKind::Header, "nc-header", "the header says what the job says"),
    (FaultKind::Extents, "nc-extents", "the header's extents are those swept"),
];

impl FaultKind {
    /// The stable code, such as `nc-gouge`.
    #[must_use]
    pub fn code(self) -> &'static str {
        TABLE.iter().find(|row| row.0 == self).map_or("", |row| row.1)
    }

    /// The property that is broken, as a statement of what should hold.
    #[must_use]
    pub fn property(self) -> &'static str {
        TABLE.iter().find(|row| row.0 == self).map_or("", |row| row.2)
    }
}

/// One broken property.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Which property.
    pub kind: FaultKind,
    /// Line of the file, from 1; 0 if the fault is of the whole program.
    pub line: usize,
    /// The tool whose file it is, where there is a file for each tool.
    pub tool: Option<u32>,
    /// What was found, for people.
    pub message: String,
    /// The figure found, in the unit the message names.
    pub measured: Option<f64>,
}

impl Fault {
    /// A fault without a figure.
    pub(super) fn new(kind: FaultKind, line: usize, message: impl Into<String>) -> Fault {
        Fault { kind, line, tool: None, message: message.into(), measured: None }
    }

    /// A fault with the figure that was measured.
    pub(super) fn measured(kind: FaultKind, line: usize, measured: f64, message: impl Into<String>) -> Fault {
        Fault { kind, line, tool: None, message: message.into(), measured: Some(measured) }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(tool) = self.tool {
            write!(f, "file of tool {tool}, ")?;
        }
        write!(f, "line {}: {} [{}]", self.line, self.message, self.kind.code())
    }
}
