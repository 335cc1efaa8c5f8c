//! Why a part gets no program. Plain data with one sentence each; diagnostics are made elsewhere.

use std::fmt;

/// Why a part cannot be cut on a machine. Lengths in mm.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs, reason = "each field is a figure of the sentence its variant is displayed as")]
pub enum Refusal {
    /// The outline is no simple anticlockwise polygon.
    Outline { reason: String },
    /// The thickness is no sensible length.
    Thickness { thickness: f64 },
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
