//! The JSON part and where each piece of the binary part lies. What is modelled is `nodes`'s.

use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;

use glam::DVec3;
use gltf_json as json;
use json::Index;
use json::accessor::{ComponentType, GenericComponentType, Type};
use json::buffer::{Stride, Target, View};
use json::extras::RawValue;
use json::material::{PbrBaseColorFactor, PbrMetallicRoughness, StrengthFactor};
use json::mesh::{Mode, Primitive, Semantic};
use json::validation::{Checked::Valid, USize64};
use serde::Serialize;

use super::GlbError;
use super::piece::{Piece, position};

/// How something looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Look {
    /// Curves and edges.
    Line,
    /// Surfaces without boards.
    Surface,
    /// Surfaces coloured by their vertices.
    Map,
    /// Boards and planks.
    Timber,
    /// Every other board or plank, so that joints show.
    PaleTimber,
}

/// A model being laid out.
pub(super) struct Layout<'a> {
    /// The JSON part, but for the length of the buffer.
    pub(super) root: json::Root,
    pieces: Vec<Piece<'a>>,
    length: u64,
    names: BTreeSet<String>,
    looks: BTreeMap<Look, Index<json::Material>>,
}

impl<'a> Layout<'a> {
    /// A model of nothing yet.
    pub(super) fn new() -> Self {
        let asset = json::Asset {
            generator: Some(concat!("ifs ", env!("CARGO_PKG_VERSION")).to_owned()),
            ..json::Asset::default()
        };
        Self {
            root: json::Root { asset, ..json::Root::default() },
            pieces: Vec::new(),
            length: 0,
            names: BTreeSet::new(),
            looks: BTreeMap::new(),
        }
    }

    /// Adds a piece and the view of it. `stride` where several accessors share it.
    pub(super) fn view(&mut self, piece: Piece<'a>, target: Target, stride: Option<usize>) -> Index<View> {
        let length = piece.length();
        let view = View {
            buffer: Index::new(0),
            byte_length: USize64(length),
            byte_offset: Some(USize64(self.length)),
            byte_stride: stride.map(Stride),
            name: None,
            target: Some(Valid(target)),
            extensions: None,
            extras: None,
        };
        self.length += length;
        self.pieces.push(piece);
        self.root.push(view)
    }

    /// Positions from the byte `offset` of a view on, as many as `points` has.
    pub(super) fn positions<'p>(
        &mut self,
        view: Index<View>,
        offset: u64,
        points: impl IntoIterator<Item = &'p DVec3>,
    ) -> Result<Index<json::Accessor>, GlbError> {
        let (mut count, mut low, mut high) = (0u64, [f32::MAX; 3], [f32::MIN; 3]);
        for &point in points {
            for (axis, value) in position(point).into_iter().enumerate() {
                if !value.is_finite() {
                    return Err(GlbError::OutOfRange);
                }
                low[axis] = low[axis].min(value);
                high[axis] = high[axis].max(value);
            }
            count += 1;
        }
        if count >= u64::from(u32::MAX) {
            return Err(GlbError::TooLarge);
        }
        Ok(self.bounded(view, offset, count, low, high))
    }

    /// So many positions from the byte `offset` of a view on, within a box that is known.
    pub(super) fn bounded(
        &mut self,
        view: Index<View>,
        offset: u64,
        count: u64,
        low: [f32; 3],
        high: [f32; 3],
    ) -> Index<json::Accessor> {
        let mut accessor = accessor(view, offset, count, ComponentType::F32, Type::Vec3);
        accessor.min = Some(json::Value::from(low.to_vec()));
        accessor.max = Some(json::Value::from(high.to_vec()));
        self.root.push(accessor)
    }

    /// A view of its own for `count` indices.
    pub(super) fn indices(&mut self, piece: Piece<'a>, count: usize) -> Index<json::Accessor> {
        let view = self.view(piece, Target::ElementArrayBuffer, None);
        self.root.push(accessor(view, 0, count as u64, ComponentType::U32, Type::Scalar))
    }

    /// A view of its own for `count` colours.
    pub(super) fn colours(&mut self, piece: Piece<'a>, count: usize) -> Index<json::Accessor> {
        let view = self.view(piece, Target::ArrayBuffer, None);
        let mut colours = accessor(view, 0, count as u64, ComponentType::U16, Type::Vec4);
        colours.normalized = true;
        self.root.push(colours)
    }

    /// A primitive of these positions, and indices where it has them.
    pub(super) fn primitive(
        &mut self,
        mode: Mode,
        look: Look,
        positions: Index<json::Accessor>,
        indices: Option<Index<json::Accessor>>,
    ) -> Primitive {
        Primitive {
            attributes: BTreeMap::from([(Valid(Semantic::Positions), positions)]),
            extensions: None,
            extras: None,
            indices,
            material: Some(self.look(look)),
            mode: Valid(mode),
            targets: None,
        }
    }

    /// A node, with a mesh of these primitives where there are any.
    pub(super) fn node(&mut self, name: &str, primitives: Vec<Primitive>) -> Index<json::Node> {
        let name = self.unique(name);
        let mesh = (!primitives.is_empty()).then(|| {
            self.root.push(json::Mesh {
                extensions: None,
                extras: None,
                name: Some(name.clone()),
                primitives,
                weights: None,
            })
        });
        self.root.push(json::Node { mesh, name: Some(name), ..json::Node::default() })
    }

    /// The node itself, to change it.
    pub(super) fn node_mut(&mut self, node: Index<json::Node>) -> Option<&mut json::Node> {
        self.root.nodes.get_mut(node.value())
    }

    /// Everything before the bytes of the binary part.
    pub(super) fn header(&self) -> Result<Vec<u8>, GlbError> {
        let mut root = self.root.clone();
        if self.length > 0 {
            root.buffers = vec![json::Buffer {
                byte_length: USize64(self.length),
                name: None,
                uri: None,
                extensions: None,
                extras: None,
            }];
        }
        let mut text = root.to_vec().map_err(std::io::Error::from)?;
        text.resize(text.len().next_multiple_of(4), b' ');
        let binary = if self.length > 0 { 8 + self.length } else { 0 };
        let total = u32::try_from(20 + text.len() as u64 + binary).map_err(|_| GlbError::TooLarge)?;
        let mut bytes = Vec::with_capacity(text.len() + 28);
        bytes.extend_from_slice(b"glTF");
        bytes.extend_from_slice(&2u32.to_le_bytes());
        bytes.extend_from_slice(&total.to_le_bytes());
        bytes.extend_from_slice(&(text.len() as u32).to_le_bytes());
        bytes.extend_from_slice(b"JSON");
        bytes.append(&mut text);
        if self.length > 0 {
            bytes.extend_from_slice(&(self.length as u32).to_le_bytes());
            bytes.extend_from_slice(b"BIN\0");
        }
        Ok(bytes)
    }

    /// How many bytes [`Layout::write_binary`] writes.
    pub(super) fn binary_length(&self) -> u64 {
        self.length
    }

    /// Writes the bytes of the binary part.
    pub(super) fn write_binary(&self, out: &mut impl Write) -> Result<(), GlbError> {
        for piece in &self.pieces {
            piece.write(out)?;
        }
        Ok(())
    }

    fn unique(&mut self, name: &str) -> String {
        let mut unique = name.to_owned();
        let mut count = 1;
        while !self.names.insert(unique.clone()) {
            count += 1;
            unique = format!("{name}~{count}");
        }
        unique
    }

    fn look(&mut self, look: Look) -> Index<json::Material> {
        if let Some(&found) = self.looks.get(&look) {
            return found;
        }
        let (name, colour, double_sided) = match look {
            Look::Line => ("line", [0.02, 0.02, 0.02], false),
            Look::Surface => ("surface", [0.55, 0.57, 0.60], true),
            Look::Map => ("planarity", [1.0, 1.0, 1.0], true),
            Look::Timber => ("timber", [0.60, 0.37, 0.16], false),
            Look::PaleTimber => ("timber, pale", [0.76, 0.52, 0.27], false),
        };
        let [red, green, blue] = colour;
        let material = json::Material {
            name: Some(name.to_owned()),
            double_sided,
            pbr_metallic_roughness: PbrMetallicRoughness {
                base_color_factor: PbrBaseColorFactor([red, green, blue, 1.0]),
                metallic_factor: StrengthFactor(0.0),
                roughness_factor: StrengthFactor(0.9),
                ..PbrMetallicRoughness::default()
            },
            ..json::Material::default()
        };
        let index = self.root.push(material);
        self.looks.insert(look, index);
        index
    }
}

/// Extras as glTF keeps them.
pub(super) fn extras(value: &impl Serialize) -> Result<json::Extras, GlbError> {
    let text = serde_json::to_string(value).map_err(std::io::Error::from)?;
    Ok(Some(RawValue::from_string(text).map_err(std::io::Error::from)?))
}

fn accessor(
    view: Index<View>,
    offset: u64,
    count: u64,
    component: ComponentType,
    type_: Type,
) -> json::Accessor {
    json::Accessor {
        buffer_view: Some(view),
        byte_offset: Some(USize64(offset)),
        count: USize64(count),
        component_type: Valid(GenericComponentType(component)),
        extensions: None,
        extras: None,
        type_: Valid(type_),
        min: None,
        max: None,
        name: None,
        normalized: false,
        sparse: None,
    }
}
