//! Names of files: which are portable, and how an address becomes one.

use std::fmt::Write as _;

use sha2::{Digest, Sha256};

/// The greatest length of one segment of a name, in bytes.
const LONGEST: usize = 120;

/// The name of the file for an address: the address itself and the extension where that is a portable name, else a
/// readable prefix of it and the first 16 hexadecimal digits of its SHA-256. The same address always gives the same
/// name; the total is at most 120 bytes for extensions of up to 60.
///
/// Replaced are: addresses with characters outside `[a-z0-9._-]`, with a full stop at either end, device names of
/// Windows (`con`, `nul.left`, `lpt1`: they count with any extension), and what is too long.
pub fn safe_file_name(address: &str, extension: &str) -> String {
    let plain = format!("{address}.{extension}");
    if !address.is_empty() && !address.ends_with('.') && check_segment(&plain).is_ok() {
        return plain;
    }
    let digest = hex(&Sha256::digest(address.as_bytes()));
    let room = LONGEST.saturating_sub(16 + 2 + extension.len());
    let prefix: String = address
        .chars()
        .map(|c| if c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_' { c } else { '-' })
        .take(room)
        .collect();
    format!("{prefix}-{}.{extension}", &digest[..16])
}

/// Checks one segment of a relative name and says which rule it breaks.
///
/// # Errors
/// The rule, in words.
pub fn check_segment(segment: &str) -> Result<(), &'static str> {
    if segment.is_empty() {
        return Err("a segment is empty, or the name is absolute");
    }
    if !segment.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b"._-".contains(&b)) {
        return Err("only a-z, 0-9, full stop, underscore and hyphen may stand in it");
    }
    if segment.starts_with('.') || segment.ends_with('.') {
        return Err("a segment may not begin or end with a full stop");
    }
    if segment.len() > LONGEST {
        return Err("a segment is longer than 120 bytes");
    }
    if is_device(segment) {
        return Err("it is the name of a device on Windows");
    }
    Ok(())
}

/// Whether Windows takes the name for a device: by what stands before the first full stop.
fn is_device(segment: &str) -> bool {
    let stem = segment.split('.').next().unwrap_or(segment);
    match stem {
        "con" | "prn" | "aux" | "nul" => true,
        _ => {
            let digit = stem.strip_prefix("com").or_else(|| stem.strip_prefix("lpt"));
            digit.is_some_and(|d| d.len() == 1 && d.bytes().all(|b| b.is_ascii_digit()))
        }
    }
}

/// Bytes as lower-case hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len() * 2);
    for byte in bytes {
        // Writing to a String cannot fail.
        let _ = write!(text, "{byte:02x}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_that_are_portable_names_stay() {
        assert_eq!(safe_file_name("vault.0.left.right", "nc"), "vault.0.left.right.nc");
        assert_eq!(safe_file_name("shell.3-4.left-right", "dxf"), "shell.3-4.left-right.dxf");
        let longest = "a".repeat(117);
        assert_eq!(safe_file_name(&longest, "nc"), format!("{longest}.nc"));
    }

    #[test]
    fn other_addresses_become_a_prefix_and_a_hash() {
        for address in
            ["con", "nul.left", "com7", "lpt0.x", "", ".", "..", "a/b", "A", "ü", ".a", "a.", "a b", "x\0"]
        {
            let name = safe_file_name(address, "nc");
            assert_eq!(check_segment(&name), Ok(()), "{address:?} gave {name:?}");
            assert_ne!(name, format!("{address}.nc"));
        }
        assert!(safe_file_name("con.left", "nc").starts_with("con-left-"));
        assert_ne!(safe_file_name("A", "nc"), safe_file_name("B", "nc"));
    }

    #[test]
    fn long_addresses_keep_their_difference() {
        let stem = "left.".repeat(40);
        let (a, b) = (safe_file_name(&format!("{stem}a"), "nc"), safe_file_name(&format!("{stem}b"), "nc"));
        assert_ne!(a, b);
        assert_eq!(a.len(), LONGEST);
        assert_eq!(safe_file_name(&"a".repeat(118), "nc").len(), LONGEST);
    }
}
