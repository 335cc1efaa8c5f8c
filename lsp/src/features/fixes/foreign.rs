//! Types by the names that other languages have for them.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Fix};

use crate::features::words::written;

/// The name that the type has here.
pub(super) fn named(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let foreign = written(analysis, found.span);
    let ours = match foreign.to_ascii_lowercase().as_str() {
        "float" | "double" | "real" | "f32" | "f64" | "num" => "Number",
        "integer" | "i32" | "i64" | "u32" | "u64" | "usize" | "uint" | "nat" => "Int",
        "boolean" => "Bool",
        "string" | "str" => "Text",
        "metre" | "meter" | "millimetre" | "millimeter" | "mm" | "distance" => "Length",
        "degree" | "degrees" | "radian" | "radians" => "Angle",
        "vec" | "vec2" | "vec3" => "Vector",
        "point2" | "point3" | "point2d" | "point3d" => "Point",
        "transform" | "matrix" => "Map",
        _ => return Vec::new(),
    };
    vec![Fix::replacing(found.span, ours)]
}
