//! The sections of a DXF file, tag by tag, as Autodesk's DXF Reference for AutoCAD 2000 has them. Handles are numbers in
//! hexadecimal that name every object once: the fixed ones are given below, entities follow from [`FIRST_FREE`].

use std::io::{self, Write};

use glam::DVec2;

use super::text::escaped;
use super::{Drawing, Entity, Vertex};
use crate::export::number::fixed;

/// Decimals of every number: a coordinate in mm comes back to 1e-9.
const DECIMALS: usize = 9;

/// Handles of what every drawing has.
mod handle {
    pub(super) const VPORT_TABLE: u64 = 0x1;
    pub(super) const LTYPE_TABLE: u64 = 0x2;
    pub(super) const LAYER_TABLE: u64 = 0x3;
    pub(super) const STYLE_TABLE: u64 = 0x4;
    pub(super) const VIEW_TABLE: u64 = 0x5;
    pub(super) const UCS_TABLE: u64 = 0x6;
    pub(super) const APPID_TABLE: u64 = 0x7;
    pub(super) const DIMSTYLE_TABLE: u64 = 0x8;
    pub(super) const BLOCK_TABLE: u64 = 0x9;
    pub(super) const VPORT: u64 = 0x10;
    pub(super) const LTYPES: [u64; 3] = [0x11, 0x12, 0x13];
    pub(super) const LAYER_0: u64 = 0x14;
    pub(super) const STYLE: u64 = 0x15;
    pub(super) const APPID: u64 = 0x16;
    pub(super) const DIMSTYLE: u64 = 0x17;
    pub(super) const MODEL: u64 = 0x18;
    pub(super) const PAPER: u64 = 0x19;
    pub(super) const MODEL_BLOCK: u64 = 0x1A;
    pub(super) const MODEL_END: u64 = 0x1B;
    pub(super) const PAPER_BLOCK: u64 = 0x1C;
    pub(super) const PAPER_END: u64 = 0x1D;
    pub(super) const ROOT: u64 = 0x20;
    pub(super) const GROUPS: u64 = 0x21;
    pub(super) const PLOT_STYLES: u64 = 0x22;
    pub(super) const PLOT_STYLE: u64 = 0x23;
}

/// The first handle that is free for layers and entities.
const FIRST_FREE: u64 = 0x100;

/// Writes tags: a code on one line, its value on the next.
struct Tags<'a> {
    out: &'a mut dyn Write,
}

impl Tags<'_> {
    fn tag(&mut self, code: u16, value: impl std::fmt::Display) -> io::Result<()> {
        write!(self.out, "{code:>3}\n{value}\n")
    }

    fn tags(&mut self, tags: &[(u16, &str)]) -> io::Result<()> {
        tags.iter().try_for_each(|(code, value)| self.tag(*code, value))
    }

    fn handle(&mut self, code: u16, handle: u64) -> io::Result<()> {
        self.tag(code, format_args!("{handle:X}"))
    }

    fn real(&mut self, code: u16, value: f64) -> io::Result<()> {
        let text = fixed(value, DECIMALS)
            .ok_or_else(|| io::Error::other("a drawing has a coordinate that is not finite"))?;
        let short = text.trim_end_matches('0');
        // A number keeps one decimal, so that it is seen to be a real one.
        self.tag(code, if short.ends_with('.') { &text[..=short.len()] } else { short })
    }

    /// A point: x under `code`, y under `code` + 10, z = 0 under `code` + 20.
    fn point(&mut self, code: u16, at: DVec2) -> io::Result<()> {
        self.real(code, at.x)?;
        self.real(code + 10, at.y)?;
        self.real(code + 20, 0.0)
    }

    fn section(&mut self, name: &str, fill: impl FnOnce(&mut Self) -> io::Result<()>) -> io::Result<()> {
        self.tags(&[(0, "SECTION"), (2, name)])?;
        fill(self)?;
        self.tag(0, "ENDSEC")
    }

    /// A table of `count` records.
    fn table(
        &mut self,
        name: &str,
        handle: u64,
        count: usize,
        fill: impl FnOnce(&mut Self) -> io::Result<()>,
    ) -> io::Result<()> {
        self.tags(&[(0, "TABLE"), (2, name)])?;
        self.handle(5, handle)?;
        self.handle(330, 0)?;
        self.tag(100, "AcDbSymbolTable")?;
        self.tag(70, count)?;
        if name == "DIMSTYLE" {
            self.tags(&[(100, "AcDbDimStyleTable"), (71, "0")])?;
        }
        fill(self)?;
        self.tag(0, "ENDTAB")
    }

    /// The beginning of a record of a table.
    fn record(&mut self, kind: &str, handle: u64, table: u64, class: &str, name: &str) -> io::Result<()> {
        self.tag(0, kind)?;
        self.handle(if kind == "DIMSTYLE" { 105 } else { 5 }, handle)?;
        self.handle(330, table)?;
        self.tags(&[(100, "AcDbSymbolTableRecord"), (100, class), (2, name)])
    }

    /// The beginning of an entity.
    fn entity(&mut self, kind: &str, handle: u64, layer: &str, class: &str) -> io::Result<()> {
        self.tag(0, kind)?;
        self.handle(5, handle)?;
        self.handle(330, handle::MODEL)?;
        self.tags(&[(100, "AcDbEntity"), (8, layer), (100, class)])
    }
}

pub(super) fn write(drawing: &Drawing, out: &mut dyn Write) -> io::Result<()> {
    let mut tags = Tags { out };
    tags.section("HEADER", |tags| header(tags, drawing))?;
    tags.section("CLASSES", |_| Ok(()))?;
    tags.section("TABLES", |tags| tables(tags, drawing))?;
    tags.section("BLOCKS", blocks)?;
    tags.section("ENTITIES", |tags| entities(tags, drawing))?;
    tags.section("OBJECTS", objects)?;
    tags.tag(0, "EOF")
}

fn header(tags: &mut Tags<'_>, drawing: &Drawing) -> io::Result<()> {
    let (low, high) = extent(drawing);
    tags.tags(&[(9, "$ACADVER"), (1, "AC1015"), (9, "$DWGCODEPAGE"), (3, "ANSI_1252")])?;
    for (name, at) in [("$INSBASE", DVec2::ZERO), ("$EXTMIN", low), ("$EXTMAX", high)] {
        tags.tag(9, name)?;
        tags.point(10, at)?;
    }
    // Millimetres, a metric drawing, decimal numbers; $INSUNITS and $MEASUREMENT as the reference has them.
    tags.tags(&[(9, "$INSUNITS"), (70, "4"), (9, "$MEASUREMENT"), (70, "1"), (9, "$LUNITS"), (70, "2")])?;
    let free = FIRST_FREE + (drawing.layers.len() + drawing.entities.len()) as u64;
    tags.tag(9, "$HANDSEED")?;
    tags.handle(5, free)
}

/// The box of what is drawn, texts by their beginning and arcs by their corners; a point for an empty drawing.
fn extent(drawing: &Drawing) -> (DVec2, DVec2) {
    let mut points = Vec::new();
    for (_, entity) in &drawing.entities {
        match entity {
            Entity::Polyline { vertices, .. } => points.extend(vertices.iter().map(|vertex| vertex.at)),
            Entity::Line { from, to } => points.extend([*from, *to]),
            Entity::Circle { centre, radius } => {
                points.extend([*centre - DVec2::splat(*radius), *centre + DVec2::splat(*radius)]);
            }
            Entity::Text { at, .. } => points.push(*at),
        }
    }
    let first = points.first().copied().unwrap_or_default();
    points.iter().fold((first, first), |(low, high), &point| (low.min(point), high.max(point)))
}

fn tables(tags: &mut Tags<'_>, drawing: &Drawing) -> io::Result<()> {
    use handle as h;
    tags.table("VPORT", h::VPORT_TABLE, 1, |tags| viewport(tags, drawing))?;
    tags.table("LTYPE", h::LTYPE_TABLE, 3, |tags| {
        for (handle, name) in h::LTYPES.into_iter().zip(["ByBlock", "ByLayer", "Continuous"]) {
            tags.record("LTYPE", handle, h::LTYPE_TABLE, "AcDbLinetypeTableRecord", name)?;
            tags.tags(&[(70, "0"), (3, ""), (72, "65"), (73, "0"), (40, "0.0")])?;
        }
        Ok(())
    })?;
    tags.table("LAYER", h::LAYER_TABLE, drawing.layers.len() + 1, |tags| layers(tags, drawing))?;
    tags.table("STYLE", h::STYLE_TABLE, 1, |tags| {
        tags.record("STYLE", h::STYLE, h::STYLE_TABLE, "AcDbTextStyleTableRecord", "Standard")?;
        tags.tags(&[(70, "0"), (40, "0.0"), (41, "1.0"), (50, "0.0"), (71, "0"), (42, "2.5")])?;
        tags.tags(&[(3, "txt"), (4, "")])
    })?;
    tags.table("VIEW", h::VIEW_TABLE, 0, |_| Ok(()))?;
    tags.table("UCS", h::UCS_TABLE, 0, |_| Ok(()))?;
    tags.table("APPID", h::APPID_TABLE, 1, |tags| {
        tags.record("APPID", h::APPID, h::APPID_TABLE, "AcDbRegAppTableRecord", "ACAD")?;
        tags.tag(70, 0)
    })?;
    tags.table("DIMSTYLE", h::DIMSTYLE_TABLE, 1, |tags| {
        tags.record("DIMSTYLE", h::DIMSTYLE, h::DIMSTYLE_TABLE, "AcDbDimStyleTableRecord", "Standard")?;
        tags.tag(70, 0)
    })?;
    tags.table("BLOCK_RECORD", h::BLOCK_TABLE, 2, |tags| {
        for (handle, name) in [(h::MODEL, "*Model_Space"), (h::PAPER, "*Paper_Space")] {
            tags.record("BLOCK_RECORD", handle, h::BLOCK_TABLE, "AcDbBlockTableRecord", name)?;
        }
        Ok(())
    })
}

/// The view a program opens with: all of the drawing.
fn viewport(tags: &mut Tags<'_>, drawing: &Drawing) -> io::Result<()> {
    let (low, high) = extent(drawing);
    let (middle, size) = ((low + high) / 2.0, (high - low).max(DVec2::ONE));
    tags.record("VPORT", handle::VPORT, handle::VPORT_TABLE, "AcDbViewportTableRecord", "*Active")?;
    tags.tag(70, 0)?;
    for (code, x, y) in [
        (10, 0.0, 0.0),
        (11, 1.0, 1.0),
        (12, middle.x, middle.y),
        (13, 0.0, 0.0),
        (14, 10.0, 10.0),
        (15, 10.0, 10.0),
    ] {
        tags.real(code, x)?;
        tags.real(code + 10, y)?;
    }
    for (code, x, y, z) in [(16, 0.0, 0.0, 1.0), (17, 0.0, 0.0, 0.0)] {
        tags.real(code, x)?;
        tags.real(code + 10, y)?;
        tags.real(code + 20, z)?;
    }
    // Height of the view and its ratio of width to height, then the lens and what is off.
    tags.real(40, 1.1 * size.y.max(size.x / 1.5))?;
    tags.real(41, 1.5)?;
    tags.tags(&[(42, "50.0"), (43, "0.0"), (44, "0.0"), (50, "0.0"), (51, "0.0")])?;
    tags.tags(&[(71, "0"), (72, "100"), (73, "1"), (74, "3"), (75, "0"), (76, "0"), (77, "0"), (78, "0")])
}

fn layers(tags: &mut Tags<'_>, drawing: &Drawing) -> io::Result<()> {
    let own = drawing.layers.iter().zip(FIRST_FREE..);
    let own = own.map(|(layer, handle)| (layer.name.as_str(), layer.colour.index(), handle));
    for (name, colour, handle) in std::iter::once(("0", 7, handle::LAYER_0)).chain(own) {
        tags.record("LAYER", handle, handle::LAYER_TABLE, "AcDbLayerTableRecord", name)?;
        tags.tag(70, 0)?;
        tags.tag(62, colour)?;
        tags.tag(6, "Continuous")?;
        tags.handle(390, handle::PLOT_STYLE)?;
    }
    Ok(())
}

fn blocks(tags: &mut Tags<'_>) -> io::Result<()> {
    use handle as h;
    for (record, begin, end, name) in [
        (h::MODEL, h::MODEL_BLOCK, h::MODEL_END, "*Model_Space"),
        (h::PAPER, h::PAPER_BLOCK, h::PAPER_END, "*Paper_Space"),
    ] {
        tags.tag(0, "BLOCK")?;
        tags.handle(5, begin)?;
        tags.handle(330, record)?;
        tags.tags(&[(100, "AcDbEntity"), (8, "0"), (100, "AcDbBlockBegin"), (2, name), (70, "0")])?;
        tags.point(10, DVec2::ZERO)?;
        tags.tags(&[(3, name), (1, ""), (0, "ENDBLK")])?;
        tags.handle(5, end)?;
        tags.handle(330, record)?;
        tags.tags(&[(100, "AcDbEntity"), (8, "0"), (100, "AcDbBlockEnd")])?;
    }
    Ok(())
}

fn entities(tags: &mut Tags<'_>, drawing: &Drawing) -> io::Result<()> {
    let first = FIRST_FREE + drawing.layers.len() as u64;
    for ((layer, entity), handle) in drawing.entities.iter().zip(first..) {
        let layer = drawing.layers.get(layer.0).map_or("0", |layer| layer.name.as_str());
        match entity {
            Entity::Polyline { vertices, closed } => {
                tags.entity("LWPOLYLINE", handle, layer, "AcDbPolyline")?;
                tags.tag(90, vertices.len())?;
                tags.tag(70, u8::from(*closed))?;
                tags.real(43, 0.0)?;
                for Vertex { at, bulge } in vertices {
                    tags.real(10, at.x)?;
                    tags.real(20, at.y)?;
                    if *bulge != 0.0 {
                        tags.real(42, *bulge)?;
                    }
                }
            }
            Entity::Line { from, to } => {
                tags.entity("LINE", handle, layer, "AcDbLine")?;
                tags.point(10, *from)?;
                tags.point(11, *to)?;
            }
            Entity::Circle { centre, radius } => {
                tags.entity("CIRCLE", handle, layer, "AcDbCircle")?;
                tags.point(10, *centre)?;
                tags.real(40, *radius)?;
            }
            Entity::Text { at, height, turn, text } => {
                tags.entity("TEXT", handle, layer, "AcDbText")?;
                tags.point(10, *at)?;
                tags.real(40, *height)?;
                tags.tag(1, escaped(text))?;
                tags.real(50, turn.to_degrees())?;
                tags.tags(&[(7, "Standard"), (100, "AcDbText")])?;
            }
        }
    }
    Ok(())
}

/// The root dictionary, the empty one of groups, and the plot style that layers name.
fn objects(tags: &mut Tags<'_>) -> io::Result<()> {
    use handle as h;
    let mut dictionary = |kind: &str, handle: u64, owner: u64, entries: &[(&str, u64)]| {
        tags.tag(0, kind)?;
        tags.handle(5, handle)?;
        tags.handle(330, owner)?;
        tags.tags(&[(100, "AcDbDictionary"), (281, "1")])?;
        for (name, entry) in entries {
            tags.tag(3, name)?;
            tags.handle(350, *entry)?;
        }
        if kind == "ACDBDICTIONARYWDFLT" {
            tags.tag(100, "AcDbDictionaryWithDefault")?;
            tags.handle(340, h::PLOT_STYLE)?;
        }
        Ok::<(), io::Error>(())
    };
    let root = [("ACAD_GROUP", h::GROUPS), ("ACAD_PLOTSTYLENAME", h::PLOT_STYLES)];
    dictionary("DICTIONARY", h::ROOT, 0, &root)?;
    dictionary("DICTIONARY", h::GROUPS, h::ROOT, &[])?;
    dictionary("ACDBDICTIONARYWDFLT", h::PLOT_STYLES, h::ROOT, &[("Normal", h::PLOT_STYLE)])?;
    tags.tag(0, "ACDBPLACEHOLDER")?;
    tags.handle(5, h::PLOT_STYLE)?;
    tags.handle(330, h::PLOT_STYLES)
}
