//! Accessors: numbers in the data of a file, found by offset, stride and count (glTF 2.0, section 3.6.2).

use super::Fault;
use super::document::{Accessor, Document, shown};

const UNSIGNED_BYTE: u32 = 5121;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;

/// A file whose accessors can be read.
pub(super) struct Reader<'a> {
    pub(super) document: &'a Document,
    pub(super) data: &'a [u8],
}

/// Values of one kind in the data, one every `stride` bytes.
pub(super) struct Values<'a> {
    bytes: &'a [u8],
    stride: usize,
    size: usize,
    /// How many there are.
    pub(super) count: usize,
    /// The accessor, for messages.
    pub(super) place: String,
}

impl<'a> Reader<'a> {
    /// The points of an accessor of positions.
    pub(super) fn positions(&self, index: u32) -> Result<Values<'a>, Fault> {
        let (accessor, place) = self.accessor(index)?;
        if accessor.shape != "VEC3" {
            let what = format!("positions are of the type `VEC3`, not {}", shown(&accessor.shape));
            return Err(Fault::malformed(place, what));
        }
        if accessor.component_type != FLOAT {
            let what = format!("its positions are whole numbers (type {})", accessor.component_type);
            return Err(Fault::unsupported(place, what, "export it without quantization"));
        }
        self.values(accessor, 12, place)
    }

    /// The places of corners in an accessor of indices.
    pub(super) fn indices(&self, index: u32) -> Result<Values<'a>, Fault> {
        let (accessor, place) = self.accessor(index)?;
        let size = match accessor.component_type {
            UNSIGNED_BYTE => 1,
            UNSIGNED_SHORT => 2,
            UNSIGNED_INT => 4,
            other => {
                let what = format!("indices are whole numbers of 1, 2 or 4 bytes, not of the type {other}");
                return Err(Fault::malformed(place, what));
            }
        };
        if accessor.shape != "SCALAR" {
            let what = format!("indices are of the type `SCALAR`, not {}", shown(&accessor.shape));
            return Err(Fault::malformed(place, what));
        }
        self.values(accessor, size, place)
    }

    fn accessor(&self, index: u32) -> Result<(&'a Accessor, String), Fault> {
        let place = format!("accessors[{index}]");
        match self.document.accessors.get(index as usize) {
            Some(accessor) => Ok((accessor, place)),
            None => Err(missing(place, self.document.accessors.len())),
        }
    }

    /// The bytes that an accessor tells of, all of which are there.
    fn values(&self, accessor: &Accessor, size: usize, place: String) -> Result<Values<'a>, Fault> {
        if accessor.sparse.is_some() {
            let mend = "export it without sparse accessors";
            return Err(Fault::unsupported(place, "its data are sparse, which is not read", mend));
        }
        let Some(index) = accessor.buffer_view else {
            return Err(Fault::malformed(place, "it has no data"));
        };
        let (view, stride) = self.view(index)?;
        let stride = stride.unwrap_or(size as u64);
        if stride < size as u64 {
            let what = format!("values of {size} bytes every {stride} bytes overlap");
            return Err(Fault::malformed(format!("bufferViews[{index}]"), what));
        }
        let end = accessor.count.checked_sub(1).map_or(Some(0), |last| {
            let last = last.checked_mul(stride)?.checked_add(size as u64)?;
            last.checked_add(accessor.byte_offset)
        });
        let (start, stride, count) =
            (usize::try_from(accessor.byte_offset), usize::try_from(stride), usize::try_from(accessor.count));
        let bytes = end
            .and_then(|end| usize::try_from(end).ok())
            .zip(start.ok())
            .and_then(|(end, start)| if accessor.count == 0 { Some(&[][..]) } else { view.get(start..end) });
        match (bytes, stride, count) {
            (Some(bytes), Ok(stride), Ok(count)) => Ok(Values { bytes, stride, size, count, place }),
            _ => {
                let what = format!(
                    "its {} values reach beyond the {} bytes of bufferViews[{index}]",
                    accessor.count,
                    view.len()
                );
                Err(Fault::malformed(place, what))
            }
        }
    }

    /// The bytes of a view, and its stride.
    fn view(&self, index: u32) -> Result<(&'a [u8], Option<u64>), Fault> {
        let place = format!("bufferViews[{index}]");
        let views = &self.document.buffer_views;
        let Some(view) = views.get(index as usize) else { return Err(missing(place, views.len())) };
        let buffers = &self.document.buffers;
        let Some(buffer) = buffers.get(view.buffer as usize) else {
            return Err(missing(format!("buffers[{}]", view.buffer), buffers.len()));
        };
        if buffer.uri.is_some() || view.buffer != 0 {
            let mend = "export it as glTF binary (.glb) with its data inside";
            let what = "its data are not in the file itself";
            return Err(Fault::unsupported(format!("buffers[{}]", view.buffer), what, mend));
        }
        // The data may be followed by up to three bytes that fill them up.
        let length = buffer.byte_length.min(self.data.len() as u64);
        let end = view.byte_offset.checked_add(view.byte_length).filter(|end| *end <= length);
        let bytes = end
            .and_then(|end| Some((usize::try_from(view.byte_offset).ok()?, usize::try_from(end).ok()?)))
            .and_then(|(start, end)| self.data.get(start..end));
        match bytes {
            Some(bytes) => Ok((bytes, view.byte_stride)),
            None => {
                let what = format!(
                    "bytes {} to {} of the data, which have {length}",
                    view.byte_offset,
                    view.byte_offset.saturating_add(view.byte_length)
                );
                Err(Fault::malformed(place, what))
            }
        }
    }
}

impl Values<'_> {
    /// The bytes of one value.
    fn value(&self, at: usize) -> Option<&[u8]> {
        let start = at.checked_mul(self.stride)?;
        self.bytes.get(start..start.checked_add(self.size)?)
    }

    /// A whole number.
    pub(super) fn whole(&self, at: usize) -> Option<u32> {
        match *self.value(at)? {
            [a] => Some(u32::from(a)),
            [a, b] => Some(u32::from(u16::from_le_bytes([a, b]))),
            [a, b, c, d] => Some(u32::from_le_bytes([a, b, c, d])),
            _ => None,
        }
    }

    /// Three numbers.
    pub(super) fn point(&self, at: usize) -> Option<[f64; 3]> {
        let value = self.value(at)?;
        let mut point = [0.0; 3];
        for (coordinate, bytes) in point.iter_mut().zip(value.chunks_exact(4)) {
            *coordinate = f64::from(f32::from_le_bytes(bytes.try_into().ok()?));
        }
        Some(point)
    }
}

/// A place that is named and not there.
pub(super) fn missing(place: impl Into<String>, count: usize) -> Fault {
    let what = match count {
        0 => "named in the file, but there are none".to_owned(),
        1 => "named in the file, but there is only number 0".to_owned(),
        count => format!("named in the file, but they are numbered 0 to {}", count - 1),
    };
    Fault::malformed(place, what)
}
