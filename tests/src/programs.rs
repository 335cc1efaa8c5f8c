//! What the referee of NC programs is told that a program must cut.

use std::fs;
use std::path::Path;

use glam::DVec2;
use serde_json::{Value, json};

/// What the program of a board in a folder must cut: its outline, mm, moved to where the program's header says it lies,
/// by the first tool of the header.
///
/// # Panics
/// The program is not there, or its header does not say these.
pub fn expected_program(folder: &Path, address: &str, outline: &[DVec2], thickness: f64) -> Value {
    let file = format!("{address}.nc");
    let text = fs::read_to_string(folder.join(&file)).unwrap();
    let after = |start: &str| text.lines().find_map(|line| line.strip_prefix(start)).unwrap();
    let diameter: f64 = after("(tool: 1 diameter ").split(' ').next().unwrap().parse().unwrap();
    let mut at = after("(at: ").split(' ').filter_map(|word| word.parse::<f64>().ok());
    let corner = DVec2::new(at.next().unwrap(), at.next().unwrap());
    let points: Vec<[f64; 2]> = outline.iter().map(|point| (*point + corner).to_array()).collect();
    json!({ "file": file, "outline": points, "tool_diameter": diameter, "thickness": thickness })
}
