//! Boards and planks as parts of BTLx: planks cut off at both ends, boards cut around with the bevel of each edge. The
//! bevels are those of the design also where the program of a three-axis machine leaves them to the saw.

use glam::{DVec2, DVec3};
use sha2::{Digest, Sha256};

use super::place::Frame;
use super::programs::Block;
use crate::analysis::{Analysis, Elements, PanelsMade, PlanksMade};
use crate::export::btlx::{Cut, Part, Project};
use crate::fabricate::cut_job::CutJob;
use crate::fabricate::fit;
use crate::fabricate::panel::Panel;
use crate::fabricate::plank::Plank;

/// All parts that are wanted.
pub(super) fn project(analysis: &Analysis, blocks: &[Block<'_>]) -> Project {
    let name = analysis.design_name();
    let mut parts = Vec::new();
    for block in blocks {
        let figure = block.made.figure.as_str();
        let mut jobs = block.jobs().map(|(_, job)| job).peekable();
        // Jobs are in the order of the elements, which may be more.
        let mut job_of = |address: &str| jobs.next_if(|job| job.address == address);
        match &block.made.elements {
            Elements::Panels(made) => parts.extend(made.panels.iter().filter_map(|panel| {
                let job = job_of(&panel.label.address)?;
                Some(board(panel, made, job, figure))
            })),
            Elements::Planks(made) => parts.extend(made.planks.iter().filter_map(|plank| {
                let job = job_of(&plank.label.address)?;
                Some(beam(plank, made, job, figure))
            })),
        }
    }
    Project { name, parts }
}

/// A board: reference side 1 is its outer face.
fn board(panel: &Panel, made: &PanelsMade, job: &CutJob, figure: &str) -> Part {
    let thickness = panel.thickness;
    let (inside, outside) = made.settings.side.faces(thickness);
    let bevels = panel.bevels.map(|bevel| bevel.unwrap_or(0.0));
    let face = |height: f64| moved_out(&panel.design_outline, bevels.map(|bevel| height * libm::tan(bevel)));
    let (top, bottom) = (face(outside), face(inside));
    let (low, high) = fit::bounds(&[top, bottom].concat());
    let frame = Frame::of_panel(panel);
    let corners: Vec<DVec2> = face(outside).iter().map(|&corner| corner - low).collect();
    Part {
        address: panel.label.address.clone(),
        alias: panel.label.alias.clone(),
        group: figure.to_owned(),
        material: made.settings.material.name.clone(),
        guid: guid(&job.design, &panel.label.address),
        size: (high - low).extend(thickness),
        mass: panel.mass,
        origin: frame.at(low) + frame.normal * outside,
        x: frame.x,
        normal: frame.normal,
        text_at: corners.iter().sum::<DVec2>() / corners.len() as f64,
        cut: Cut::Contour { corners, inclinations: bevels.to_vec() },
        text_height: job.engraving.height,
    }
}

/// A plank: reference side 1 is its face towards the normal of the curve's plane.
fn beam(plank: &Plank, made: &PlanksMade, job: &CutJob, figure: &str) -> Part {
    let frame = Frame::of_plank(plank);
    let (low, high) = fit::bounds(&plank.outline);
    // Of the upper face: start right, end right, end left, start left.
    let corner = |index: usize| {
        let from = plank.solid.vertices[4 + index] - frame.origin;
        DVec2::new(from.dot(frame.x), from.dot(frame.y)) - low
    };
    let angle = |right: usize, left: usize| (corner(left) - corner(right)).to_angle();
    Part {
        address: plank.label.address.clone(),
        alias: plank.label.alias.clone(),
        group: figure.to_owned(),
        material: made.settings.material.name.clone(),
        guid: guid(&job.design, &plank.label.address),
        size: DVec3::new(high.x - low.x, high.y - low.y, plank.width),
        mass: plank.mass,
        origin: frame.at(low) + frame.normal * (plank.width / 2.0),
        x: frame.x,
        normal: frame.normal,
        cut: Cut::Ends {
            at: [corner(0).x, corner(1).x],
            angles: [angle(0, 3), angle(1, 2)],
            leans: plank.bevels,
        },
        text_at: (high - low) / 2.0,
        text_height: job.engraving.height.min(plank.depth / 2.0),
    }
}

/// A convex outline with each side moved out by its distance, mm: its corners are where neighbouring sides cross.
fn moved_out(outline: &[DVec2], distances: [f64; 4]) -> Vec<DVec2> {
    let count = outline.len();
    let side = |index: usize| {
        let (from, to) = (outline[index], outline[(index + 1) % count]);
        let along = (to - from).normalize_or_zero();
        (from - along.perp() * distances[index % 4], along)
    };
    let corner = |index: usize| {
        let ((p, u), (q, v)) = (side((index + count - 1) % count), side(index));
        let cross = u.perp_dot(v);
        // Sides that go on straight have no crossing; the corner of a board has one, or the board is refused.
        if cross.abs() < 1e-9 { q } else { p + u * ((q - p).perp_dot(v) / cross) }
    };
    (0..count).map(corner).collect()
}

/// The identity of a part: a UUID of version 8 out of the names of the design and the part.
fn guid(design: &str, address: &str) -> [u8; 16] {
    let mut hasher = Sha256::new();
    for name in [design, address] {
        hasher.update(name.as_bytes());
        hasher.update([0]);
    }
    let digest = hasher.finalize();
    let mut bytes = [0; 16];
    bytes.copy_from_slice(&digest[..16]);
    bytes[6] = bytes[6] & 0x0f | 0x80;
    bytes[8] = bytes[8] & 0x3f | 0x80;
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_move_out_and_corners_follow() {
        let square = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)].map(DVec2::from);
        let moved = moved_out(&square, [1.0, 2.0, -3.0, 0.0]);
        let expected = [(0.0, -1.0), (12.0, -1.0), (12.0, 7.0), (0.0, 7.0)].map(DVec2::from);
        for (corner, expected) in moved.iter().zip(expected) {
            assert!(corner.distance(expected) < 1e-12, "{moved:?}");
        }
    }

    #[test]
    fn identities_are_apart_and_of_version_8() {
        let (a, b) = (guid("shell", "shell.0"), guid("shel", "lshell.0"));
        assert_ne!(a, b);
        assert_eq!(a, guid("shell", "shell.0"));
        assert_eq!((a[6] >> 4, a[8] >> 6), (8, 2));
    }
}
