//! A text as the path of a QR code.

use std::fmt::Write as _;

use qrcode::{Color, EcLevel, QrCode};

/// A QR code as a path in modules, without the white around it.
pub(super) struct Code {
    /// Of each side.
    pub(super) modules: usize,
    /// One rectangle for each run of dark modules in a row.
    pub(super) path: String,
}

/// The code of a text, with room for one damaged module in seven, or in fourteen for a long text; none for a text longer
/// than a code can hold (2,953 bytes).
pub(super) fn path(text: &str) -> Option<Code> {
    let levels = [EcLevel::M, EcLevel::L].into_iter();
    let code = levels.filter_map(|level| QrCode::with_error_correction_level(text, level).ok()).next()?;
    let (modules, colors) = (code.width(), code.to_colors());
    let mut path = String::new();
    for (y, row) in colors.chunks(modules).enumerate() {
        let mut x = 0;
        for run in row.chunk_by(|a, b| a == b) {
            if run[0] == Color::Dark {
                // Writing to a String cannot fail.
                let _ = write!(path, "M{x} {y}h{}v1h-{}z", run.len(), run.len());
            }
            x += run.len();
        }
    }
    Some(Code { modules, path })
}
