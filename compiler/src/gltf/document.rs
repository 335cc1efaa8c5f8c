//! The description of a scene as JSON (glTF 2.0, section 5): what of it says where surfaces are, and what would have to be
//! understood to read it right.

use super::container::Container;
use super::{Fault, FaultKind};
use serde::Deserialize;
use serde::de::IgnoredAny;
use std::collections::BTreeMap;

#[derive(Debug, Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Document {
    pub(super) scene: Option<u32>,
    pub(super) scenes: Vec<Scene>,
    pub(super) nodes: Vec<Node>,
    pub(super) meshes: Vec<Mesh>,
    pub(super) accessors: Vec<Accessor>,
    pub(super) buffer_views: Vec<BufferView>,
    pub(super) buffers: Vec<Buffer>,
    extensions_required: Vec<String>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Scene {
    pub(super) nodes: Vec<u32>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Node {
    pub(super) children: Vec<u32>,
    pub(super) mesh: Option<u32>,
    pub(super) skin: Option<u32>,
    pub(super) weights: Vec<f64>,
    pub(super) matrix: Option<Box<[f64; 16]>>,
    pub(super) translation: Option<[f64; 3]>,
    pub(super) rotation: Option<[f64; 4]>,
    pub(super) scale: Option<[f64; 3]>,
    pub(super) extensions: BTreeMap<String, IgnoredAny>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Mesh {
    pub(super) primitives: Vec<Primitive>,
    pub(super) weights: Vec<f64>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Primitive {
    pub(super) attributes: Attributes,
    pub(super) indices: Option<u32>,
    pub(super) mode: Option<u32>,
    pub(super) targets: Vec<IgnoredAny>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Attributes {
    #[serde(rename = "POSITION")]
    pub(super) position: Option<u32>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Accessor {
    pub(super) buffer_view: Option<u32>,
    #[serde(default)]
    pub(super) byte_offset: u64,
    pub(super) component_type: u32,
    pub(super) count: u64,
    #[serde(rename = "type")]
    pub(super) shape: String,
    pub(super) sparse: Option<IgnoredAny>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct BufferView {
    pub(super) buffer: u32,
    #[serde(default)]
    pub(super) byte_offset: u64,
    pub(super) byte_length: u64,
    pub(super) byte_stride: Option<u64>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Buffer {
    pub(super) byte_length: u64,
    pub(super) uri: Option<IgnoredAny>,
}

/// Extensions that change how a surface looks and not where it is.
const LOOKS: [&str; 4] = ["KHR_materials_", "KHR_texture_", "KHR_lights_", "EXT_texture_"];

pub(super) fn parse(container: &Container<'_>) -> Result<Document, Fault> {
    let document: Document = serde_json::from_slice(container.json).map_err(|error| {
        let (line, column) = (error.line(), error.column());
        // The words without the place, which is counted from the start of the description.
        let text = error.to_string();
        let what = text.split(" at line ").next().unwrap_or(&text);
        let place = match line {
            1 => format!("byte {}", container.json_start + column.saturating_sub(1)),
            line => format!("line {line}, column {column} of its JSON"),
        };
        Fault::malformed(place, format!("its description of the scene cannot be read: {what}"))
    })?;
    let unknown = document
        .extensions_required
        .iter()
        .enumerate()
        .find(|(_, name)| !LOOKS.iter().any(|look| name.starts_with(look)));
    match unknown {
        None => Ok(document),
        Some((place, name)) => Err(Fault {
            kind: FaultKind::Unsupported,
            what: format!("it needs the extension {}, which is not read", shown(name)),
            place: format!("extensionsRequired[{place}]"),
            mend: "export it without compression and without extensions",
        }),
    }
}

/// A name from the file, fit to be shown: short and without control characters.
pub(super) fn shown(name: &str) -> String {
    let short: String = name.chars().take(60).map(|c| if c.is_control() { '?' } else { c }).collect();
    format!("`{short}`")
}
