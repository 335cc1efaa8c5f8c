//! Why a part gets no program. Plain data with one sentence each; diagnostics are made elsewhere.

use crate::fabricate::cut_job::MAX_PARTS;
use std::fmt;

/// Why a part of a sheet cannot be cut, and which.
#[derive(Clone, Debug, PartialEq)]
pub struct PartRefusal {
    /// Its place among the sheet's parts, from 0.
    pub part: usize,
    /// Why.
    pub refusal: Refusal,
}

impl fmt::Display for PartRefusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "part {}: {}", self.part, self.refusal)
    }
}

impl std::error::Error for PartRefusal {}

/// Why a part cannot be cut on a machine. Lengths in mm.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs, reason = "each field is a figure of the sentence its variant is displayed as")]
pub enum Refusal {
    /// The outline is no simple anticlockwise polygon.
    Outline { reason: String },
    /// The thickness is no sensible length.
    Thickness { thickness: f64 },
    /// Parts of one sheet have different thicknesses.
    OtherThickness { thickness: f64, stock: f64 },
    /// Too few or too many parts on a sheet.
    PartCount { count: usize },
    /// The part lies too near to the edge of its sheet, or beyond it.
    OutsideStock { room: f64, needed: f64 },
    /// Two parts lie too near to each other for the cutter.
    PartsTooClose { other: usize, gap: f64, needed: f64 },
    /// The onion skin would be more than half of the thickness.
    SkinTooThick { skin: f64, thickness: f64 },
    /// Tabs would be higher than the part is thick.
    TabsTooHigh { height: f64, thickness: f64 },
    /// The edge has too few straight stretches for the tabs.
    TabsDoNotFit { asked: u32, fitting: u32, width: f64, raised: f64 },
    /// A tool would touch a clamp.
    Clamped { clamp: usize, x: f64, y: f64 },
    /// Engraving would take more than half of the thickness.
    EngravingTooDeep { depth: f64, thickness: f64 },
    /// The cut is deeper than the cutter's flutes.
    FluteTooShort { tool: u32, needed: f64, length: f64 },
    /// The cutter's centre would leave the machine's travel.
    Envelope { axis: char, needed: f64, travel: f64 },
    /// A round tool cannot cut this inner corner sharp.
    ConcaveCorner { corner: usize, left: f64, radius: f64 },
    /// The cutter, kept off one edge, would cut into another.
    ToolDoesNotFit { edge: usize, diameter: f64 },
    /// The contour has too many sides and passes, or is too short to ramp along.
    TooManyPasses { passes: f64, sides: usize },
    /// The alias is empty, or begins or ends with a space.
    NothingToEngrave,
    /// The font has no such character.
    UnknownCharacter { character: char },
    /// Heights or clearance are no sensible lengths.
    EngravingFigures { height: f64, least: f64, clearance: f64 },
    /// Even at the least height the text does not fit inside the part.
    TextDoesNotFit { text: String, asked: f64, least: f64 },
    /// Text of this height would run together under the engraver.
    TextTooFine { asked: f64, legible: f64, diameter: f64 },
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::Outline { reason } => write!(f, "the cut outline {reason}"),
            Refusal::Thickness { thickness } => {
                write!(f, "a thickness of {thickness} mm, must be from 0.1 mm to 1000 mm")
            }
            Refusal::OtherThickness { thickness, stock } => {
                write!(f, "is {thickness} mm thick, the first part of its sheet {stock} mm")
            }
            Refusal::PartCount { count } => {
                write!(f, "a sheet with {count} parts, must have from 1 to {MAX_PARTS}")
            }
            Refusal::OutsideStock { room, needed } => {
                write!(f, "lies {room:.3} mm from the edge of its sheet, the cutter needs {needed:.3} mm")
            }
            Refusal::PartsTooClose { other, gap, needed } => {
                write!(f, "lies {gap:.3} mm from part {other} of its sheet, the cutter needs {needed:.3} mm")
            }
            Refusal::SkinTooThick { skin, thickness } => {
                write!(f, "an onion skin of {skin} mm is more than half of {thickness} mm")
            }
            Refusal::TabsTooHigh { height, thickness } => {
                write!(f, "tabs {height} mm high are higher than the board of {thickness} mm is thick")
            }
            Refusal::TabsDoNotFit { asked, fitting, width, raised } => write!(
                f,
                "{asked} tabs do not fit: one {width} mm wide takes {raised} mm of a straight edge, clear of corners \
                 and of where the cutter enters, and there is room for {fitting}"
            ),
            Refusal::Clamped { clamp, x, y } => {
                write!(f, "at X {x:.3} Y {y:.3} a tool would touch clamp {clamp}")
            }
            Refusal::EngravingTooDeep { depth, thickness } => {
                write!(f, "engraving {depth} mm deep takes more than half of {thickness} mm")
            }
            Refusal::FluteTooShort { tool, needed, length } => {
                write!(f, "tool {tool} would cut {needed:.3} mm deep, its flutes are {length:.3} mm long")
            }
            Refusal::Envelope { axis, needed, travel } => {
                write!(f, "needs {needed:.3} mm of travel in {axis}, the machine has {travel:.3} mm")
            }
            Refusal::ConcaveCorner { corner, left, radius } => write!(
                f,
                "a tool of radius {radius:.3} mm would leave {left:.3} mm in the inner corner {corner}"
            ),
            Refusal::ToolDoesNotFit { edge, diameter } => {
                write!(
                    f,
                    "a tool of {diameter:.3} mm does not fit beside edge {edge} without cutting another edge"
                )
            }
            Refusal::TooManyPasses { passes, sides } => {
                write!(
                    f,
                    "{passes:.0} passes around {sides} sides are too many: take a longer cutter step or fewer corners"
                )
            }
            Refusal::NothingToEngrave => write!(f, "the alias is empty or has a space at its end"),
            Refusal::UnknownCharacter { character } => {
                write!(f, "the engraving font has no character {:?}", character)
            }
            Refusal::EngravingFigures { height, least, clearance } => write!(
                f,
                "engraving height {height} mm, least {least} mm, clearance {clearance} mm: \
                 must be 0 < least <= height and clearance >= 0"
            ),
            Refusal::TextDoesNotFit { text, asked, least } => write!(
                f,
                "\"{text}\" does not fit inside the part, neither {asked:.3} mm high as asked nor {least:.3} mm \
                 as least allowed"
            ),
            Refusal::TextTooFine { asked, legible, diameter } => write!(
                f,
                "text {asked:.3} mm high runs together under an engraver of {diameter:.3} mm, which needs {legible:.3} mm"
            ),
        }
    }
}

impl std::error::Error for Refusal {}

impl Refusal {
    /// What would mend it, with figures; nothing where only another outline would.
    #[must_use]
    pub fn remedy(&self) -> Option<String> {
        Some(match self {
            Refusal::Outline { .. } | Refusal::PartCount { .. } | Refusal::OtherThickness { .. } => return None,
            Refusal::Thickness { .. } => "choose a board from 0.1 mm to 1000 mm thick".to_owned(),
            Refusal::EngravingTooDeep { thickness, .. } => {
                format!("engrave at most {} mm deep: `engrave_depth` of the machine", thickness / 2.0)
            }
            Refusal::FluteTooShort { needed, .. } => {
                format!("use a cutter with flutes of at least {needed:.1} mm, or a thinner board")
            }
            Refusal::Envelope { axis, needed, .. } => {
                format!("use a machine with at least {needed:.0} mm of travel in {axis}, or smaller boards")
            }
            Refusal::ConcaveCorner { .. } => {
                "round the corner, or cut it by hand: no cutter leaves a sharp inner corner".to_owned()
            }
            Refusal::ToolDoesNotFit { diameter, .. } => {
                format!("use a cutter narrower than {diameter:.1} mm, or widen the recess")
            }
            Refusal::TooManyPasses { .. } => "let the cutter take more at once: its `step_down`".to_owned(),
            Refusal::OutsideStock { needed, .. } => format!("leave {needed:.1} mm to the edge of the sheet"),
            Refusal::PartsTooClose { needed, .. } => format!("leave {needed:.1} mm between parts"),
            Refusal::SkinTooThick { thickness, .. } => {
                format!("leave at most {} mm: `onion_skin({}mm)`", thickness / 2.0, thickness / 2.0)
            }
            Refusal::TabsTooHigh { thickness, .. } => format!("make the tabs lower than {thickness} mm"),
            Refusal::TabsDoNotFit { fitting: 0, .. } => {
                "make the tabs narrower, use a thinner cutter, or hold the board by `vacuum()` or `onion_skin(…)`"
                    .to_owned()
            }
            Refusal::TabsDoNotFit { fitting, .. } => {
                format!("ask for {fitting} tabs or fewer, make them narrower, or use a thinner cutter")
            }
            Refusal::Clamped { .. } => "move the clamp, or leave more stock: `margin` of the machine".to_owned(),
            Refusal::NothingToEngrave | Refusal::UnknownCharacter { .. } => {
                "give the figure a name of printable ASCII characters".to_owned()
            }
            Refusal::EngravingFigures { .. } => "set `address: engraved(height: 12mm, least: 5mm)`".to_owned(),
            Refusal::TextDoesNotFit { least, .. } => format!(
                "let it shrink below {least:.1} mm with `address: engraved(least: …)` and a finer engraver, or make \
                 the board larger"
            ),
            Refusal::TextTooFine { legible, .. } => {
                format!("engrave at least {legible:.1} mm high, or use a finer engraver")
            }
        })
    }
}
