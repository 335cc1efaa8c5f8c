//! `model.btlx`: parts of timber with their processings, as BTLx 2.0.0 has them (design2machine's schema and manual).
//! Lengths in mm, angles in degrees. Which parts there are, and what is done to them, is said by `outputs`.
//!
//! Reference side 1 of a part is its face that lies up: its x axis is the reference edge, its y axis lies in the face,
//! its z axis points out of the material. The y axis of the part's own frame is the opposite of that z axis.

use std::f64::consts::{FRAC_PI_2, PI};
use std::io::{self, Write};

use glam::{DVec2, DVec3};

use super::number::fixed;
use super::xml::Escaped;

/// Decimals of lengths in mm and of angles in degrees.
const DECIMALS: usize = 6;
/// Decimals of the components of a unit vector.
const UNIT_DECIMALS: usize = 12;

/// All parts of a design.
#[derive(Debug, Clone, PartialEq)]
pub struct Project {
    /// The name of the design.
    pub name: String,
    /// The parts, in order.
    pub parts: Vec<Part>,
}

/// A part: the box it is cut out of, where that lies, and what is done to it.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Its full address: the annotation.
    pub address: String,
    /// Its short name: the designation, and the text that is marked on it.
    pub alias: String,
    /// The figure it belongs to.
    pub group: String,
    /// What it is made of.
    pub material: String,
    /// Identifies the part in all builds of the design.
    pub guid: [u8; 16],
    /// Length along x, width along y of reference side 1, and height square to it, mm.
    pub size: DVec3,
    /// kg, where it is known.
    pub mass: Option<f64>,
    /// Where the corner of reference side 1 lies in the building, mm.
    pub origin: DVec3,
    /// Unit vector along the part.
    pub x: DVec3,
    /// Unit normal of reference side 1, out of the material.
    pub normal: DVec3,
    /// What is cut.
    pub cut: Cut,
    /// Where the alias is marked on reference side 1: its middle, mm.
    pub text_at: DVec2,
    /// Height of the text, mm.
    pub text_height: f64,
}

/// How the part is cut out of its box, on reference side 1.
#[derive(Debug, Clone, PartialEq)]
pub enum Cut {
    /// Around a contour, anticlockwise, through all of the height.
    Contour {
        /// Its corners, mm.
        corners: Vec<DVec2>,
        /// Of each side, from its corner to the next, the angle between the cut and the normal of the face, rad: positive
        /// where the cut runs inwards on its way down.
        inclinations: Vec<f64>,
    },
    /// At both ends.
    Ends {
        /// Where each cut meets the reference edge, mm.
        at: [f64; 2],
        /// The angle of each cut's line with the reference edge, rad, anticlockwise, 0 to π.
        angles: [f64; 2],
        /// How much each cut leans out of square to reference side 1, rad: positive where its normal, taken along x,
        /// leans out of the material there.
        leans: [f64; 2],
    },
}

impl Project {
    /// Writes the file.
    ///
    /// # Errors
    /// Those of `out`; a number that is not finite.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        out.write_all(
            b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
            <BTLx xmlns=\"https://www.design2machine.com\" \
            xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
            xsi:schemaLocation=\"https://www.design2machine.com https://www.design2machine.com/btlx/btlx_2_0_0.xsd\" \
            Version=\"2.0.0\" Language=\"en\">\n",
        )?;
        // Neither date nor computer: the same design is the same file.
        let version = env!("CARGO_PKG_VERSION");
        writeln!(out, "  <FileHistory>")?;
        writeln!(out, "    <InitialExportProgram ProgramName=\"ifs\" ProgramVersion=\"{version}\"/>")?;
        writeln!(out, "  </FileHistory>")?;
        writeln!(out, "  <Project Name=\"{}\">", Escaped(&self.name))?;
        if !self.parts.is_empty() {
            writeln!(out, "    <Parts>")?;
            for (part, number) in self.parts.iter().zip(1..) {
                part.write(out, number)?;
            }
            writeln!(out, "    </Parts>")?;
        }
        writeln!(out, "  </Project>\n</BTLx>")
    }
}

impl Part {
    fn write(&self, out: &mut dyn Write, number: u64) -> io::Result<()> {
        write!(
            out,
            "      <Part SingleMemberNumber=\"{number}\" OrderNumber=\"{number}\" Designation=\"{}\" Annotation=\"{}\" \
            Group=\"{}\" Material=\"{}\" Count=\"1\" Length=\"{}\" Height=\"{}\" Width=\"{}\"",
            Escaped(&self.alias),
            Escaped(&self.address),
            Escaped(&self.group),
            Escaped(&self.material),
            real(self.size.x)?,
            real(self.size.z)?,
            real(self.size.y)?
        )?;
        if let Some(mass) = self.mass {
            write!(out, " Weight=\"{}\"", real(mass)?)?;
        }
        let (origin, x, y) = (self.origin, self.x, -self.normal);
        writeln!(out, ">\n        <Transformations>")?;
        writeln!(
            out,
            "          <Transformation GUID=\"{{{}}}\">\n            <Position>",
            guid(&self.guid)
        )?;
        for (name, vector, decimals) in [
            ("ReferencePoint", origin, DECIMALS),
            ("XVector", x, UNIT_DECIMALS),
            ("YVector", y, UNIT_DECIMALS),
        ] {
            writeln!(out, "              <{name} {}/>", components(vector, decimals)?)?;
        }
        writeln!(out, "            </Position>\n          </Transformation>\n        </Transformations>")?;
        writeln!(out, "        <GrainDirection X=\"1\" Y=\"0\" Z=\"0\" Align=\"no\"/>")?;
        writeln!(out, "        <ReferenceSide Side=\"1\" Align=\"no\"/>\n        <Processings>")?;
        match &self.cut {
            Cut::Contour { corners, inclinations } => self.contour(out, corners, inclinations)?,
            Cut::Ends { at, angles, leans } => ends(out, at, angles, leans)?,
        }
        self.text(out)?;
        writeln!(out, "        </Processings>\n      </Part>")
    }

    fn contour(&self, out: &mut dyn Write, corners: &[DVec2], inclinations: &[f64]) -> io::Result<()> {
        let Some(first) = corners.first() else { return Ok(()) };
        writeln!(
            out,
            "          <FreeContour Name=\"FreeContour\" Process=\"yes\" ProcessID=\"1\" ReferencePlaneID=\"1\" \
            CounterSink=\"no\" ToolPosition=\"right\">"
        )?;
        writeln!(out, "            <Contour DepthBounded=\"no\" Depth=\"{}\">", real(self.size.z)?)?;
        writeln!(out, "              <StartPoint {}/>", components(first.extend(0.0), DECIMALS)?)?;
        let ends = corners.iter().cycle().skip(1);
        for (end, inclination) in ends.zip(inclinations) {
            let (angle, at) = (degrees(*inclination)?, components(end.extend(0.0), DECIMALS)?);
            writeln!(out, "              <Line Inclination=\"{angle}\"><EndPoint {at}/></Line>")?;
        }
        writeln!(out, "            </Contour>\n          </FreeContour>")
    }

    fn text(&self, out: &mut dyn Write) -> io::Result<()> {
        writeln!(
            out,
            "          <Text Name=\"Text\" Process=\"yes\" ProcessID=\"3\" ReferencePlaneID=\"1\">"
        )?;
        writeln!(out, "            <StartX>{}</StartX>", real(self.text_at.x)?)?;
        writeln!(out, "            <StartY>{}</StartY>", real(self.text_at.y)?)?;
        for (name, value) in [
            ("Angle", "0"),
            ("AlignmentVertical", "center"),
            ("AlignmentHorizontal", "center"),
            ("AlignmentMultiline", "left"),
            ("StackedMarking", "no"),
            ("TextHeightAuto", "no"),
        ] {
            writeln!(out, "            <{name}>{value}</{name}>")?;
        }
        writeln!(out, "            <TextHeight>{}</TextHeight>", real(self.text_height)?)?;
        writeln!(out, "            <Text>{}</Text>\n          </Text>", Escaped(&self.alias))
    }
}

/// The cuts at both ends. The angles of BTLx open towards the part: those of an end cut are measured from the other side.
fn ends(out: &mut dyn Write, at: &[f64; 2], angles: &[f64; 2], leans: &[f64; 2]) -> io::Result<()> {
    let angles = [angles[0], PI - angles[1]];
    let inclinations = [FRAC_PI_2 - leans[0], FRAC_PI_2 + leans[1]];
    for (end, orientation) in ["start", "end"].into_iter().enumerate() {
        let id = end + 1;
        writeln!(
            out,
            "          <JackRafterCut Name=\"JackRafterCut\" Process=\"yes\" ProcessID=\"{id}\" ReferencePlaneID=\"1\">"
        )?;
        writeln!(out, "            <Orientation>{orientation}</Orientation>")?;
        writeln!(out, "            <StartX>{}</StartX>", real(at[end])?)?;
        writeln!(out, "            <StartY>0</StartY>\n            <StartDepth>0</StartDepth>")?;
        writeln!(out, "            <Angle>{}</Angle>", degrees(angles[end])?)?;
        writeln!(out, "            <Inclination>{}</Inclination>", degrees(inclinations[end])?)?;
        writeln!(out, "          </JackRafterCut>")?;
    }
    Ok(())
}

fn number(value: f64, decimals: usize) -> io::Result<String> {
    fixed(value, decimals).ok_or_else(|| io::Error::other("a part has a number that is not finite"))
}

fn real(value: f64) -> io::Result<String> {
    number(value, DECIMALS)
}

fn degrees(angle: f64) -> io::Result<String> {
    number(angle.to_degrees(), DECIMALS)
}

fn components(vector: DVec3, decimals: usize) -> io::Result<String> {
    let [x, y, z] = vector.to_array();
    let (x, y, z) = (number(x, decimals)?, number(y, decimals)?, number(z, decimals)?);
    Ok(format!("X=\"{x}\" Y=\"{y}\" Z=\"{z}\""))
}

/// As 8-4-4-4-12 hexadecimal digits.
fn guid(bytes: &[u8; 16]) -> String {
    let mut text = String::with_capacity(36);
    for (place, byte) in bytes.iter().enumerate() {
        if [4, 6, 8, 10].contains(&place) {
            text.push('-');
        }
        text.push_str(&format!("{byte:02X}"));
    }
    text
}
