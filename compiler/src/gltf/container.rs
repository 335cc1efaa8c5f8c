//! The container of a GLB file: its header and its two chunks (glTF 2.0, section 4.4).

use super::{Fault, MOST_JSON_BYTES};

/// `glTF`
const MAGIC: &[u8; 4] = b"glTF";
const JSON: &[u8; 4] = b"JSON";
const BIN: &[u8; 4] = b"BIN\0";

const HEADER_BYTES: usize = 12;
const CHUNK_HEADER_BYTES: usize = 8;

/// The two chunks.
#[derive(Debug)]
pub(super) struct Container<'a> {
    /// The description of the scene.
    pub(super) json: &'a [u8],
    /// Where the description starts in the file.
    pub(super) json_start: usize,
    /// The data, empty where there are none.
    pub(super) data: &'a [u8],
}

pub(super) fn open(bytes: &[u8]) -> Result<Container<'_>, Fault> {
    if !bytes.starts_with(MAGIC) {
        return Err(no_container(bytes));
    }
    let version = word(bytes, 4)?;
    if version != 2 {
        let mend = "export it as glTF 2.0 binary (.glb)";
        return Err(Fault::unsupported("byte 4", format!("it is glTF {version}, and 2 is read"), mend));
    }
    let length = word(bytes, 8)? as usize;
    if length > bytes.len() {
        let what = format!("the file is cut off: it says it has {length} bytes, and has {}", bytes.len());
        return Err(Fault::malformed("byte 8", what));
    }
    let bytes = &bytes[..length.max(HEADER_BYTES)];
    let (json, next) = chunk(bytes, HEADER_BYTES)?;
    if json.kind != *JSON {
        return Err(Fault::malformed("byte 16", "the first chunk is not the description of the scene"));
    }
    if json.content.len() > MOST_JSON_BYTES {
        let what = format!("the description of the scene has more than {} MiB", MOST_JSON_BYTES >> 20);
        return Err(Fault::too_large("byte 12", what, "export only the part that is drawn"));
    }
    let data = match chunk(bytes, next) {
        Ok((data, _)) if data.kind == *BIN => data.content,
        Err(fault) if next < bytes.len() => return Err(fault),
        _ => &[],
    };
    Ok(Container { json: json.content, json_start: HEADER_BYTES + CHUNK_HEADER_BYTES, data })
}

struct Chunk<'a> {
    kind: [u8; 4],
    content: &'a [u8],
}

/// The chunk that starts at a byte, and where the next one does.
fn chunk(bytes: &[u8], start: usize) -> Result<(Chunk<'_>, usize), Fault> {
    let length = word(bytes, start)? as usize;
    let kind = word(bytes, start + 4)?.to_le_bytes();
    let content = start + CHUNK_HEADER_BYTES;
    let end = content.saturating_add(length);
    match bytes.get(content..end) {
        Some(content) => Ok((Chunk { kind, content }, end)),
        None => {
            let what = format!("a chunk of {length} bytes reaches beyond the end at byte {}", bytes.len());
            Err(Fault::malformed(format!("byte {start}"), what))
        }
    }
}

fn word(bytes: &[u8], at: usize) -> Result<u32, Fault> {
    match bytes.get(at..at.saturating_add(4)) {
        Some(&[a, b, c, d]) => Ok(u32::from_le_bytes([a, b, c, d])),
        _ => {
            let what = format!("the file is cut off after {} bytes", bytes.len());
            Err(Fault::malformed(format!("byte {at}"), what))
        }
    }
}

/// A file that does not begin as a GLB file does, with a word on what it may be.
fn no_container(bytes: &[u8]) -> Fault {
    if bytes.is_empty() {
        return Fault::malformed("byte 0", "the file is empty");
    }
    let first = bytes.iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(0);
    let begins = |with: &[u8]| bytes[first..].starts_with(with);
    let (what, mend) = if begins(b"{") {
        ("it is text, as glTF in several files (.gltf) is", "export it as glTF binary (.glb), in one file")
    } else if begins(b"solid") || begins(b"v ") || begins(b"#") || begins(b"ply") || begins(b"o ") {
        ("it is no glTF: such files of text are STL, OBJ or PLY", "convert it to glTF binary (.glb)")
    } else {
        ("it is no binary glTF: that begins with the letters `glTF`", "export it as glTF binary (.glb)")
    };
    Fault::unsupported("byte 0", what, mend)
}
