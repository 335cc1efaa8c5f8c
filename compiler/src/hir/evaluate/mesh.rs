//! Germs that are meshes: points, and faces which name them by their places. Not here: how they are drawn.

use super::{Evaluator, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::tree::{Expr, ExprKind};
use crate::hir::value::{Combination, Germ, GermShape, Value};
use crate::source::Span;
use std::sync::Arc;

impl Evaluator<'_> {
    /// `mesh(points, faces)`.
    pub(super) fn mesh_germ(&mut self, values: &[Value], arguments: &[Expr]) -> Outcome<Value> {
        let ([Value::List(points), Value::List(listed)], [_, given]) = (values, arguments) else {
            return Err(Stop::Reported);
        };
        let vertices: Vec<Arc<Combination>> = points
            .iter()
            .filter_map(|point| match point {
                Value::Combination(point) => Some(point.clone()),
                _ => None,
            })
            .collect();
        if listed.is_empty() {
            return Err(self.face_fault(given.span, "a mesh needs one face or more", "no face".to_owned()));
        }
        let mut faces = Vec::new();
        for (at, face) in listed.iter().enumerate() {
            let Value::List(corners) = face else { return Err(Stop::Reported) };
            self.spend(corners.len() as u64, given.span)?;
            faces.push(self.face(at, corners, vertices.len(), given)?);
        }
        Ok(Value::Germ(Arc::new(Germ { shape: GermShape::Mesh { faces: Arc::new(faces) }, vertices })))
    }

    /// The corners of one face as places of points.
    fn face(&mut self, at: usize, corners: &[Value], points: usize, given: &Expr) -> Outcome<Vec<u32>> {
        let span = face_span(given, at);
        if corners.len() < 3 {
            let message = "a face of a mesh has three corners or more";
            return Err(self.face_fault(span, message, format!("face {at} has {}", corners.len())));
        }
        let mut places: Vec<u32> = Vec::with_capacity(corners.len());
        for corner in corners {
            let Some(corner) = corner.scalar() else { return Err(Stop::Reported) };
            // A place that depends on a parameter is checked where the parameter has its value.
            let place = corner.to_integer().ok_or(Stop::Undetermined)?;
            match u32::try_from(place).ok().filter(|place| (*place as usize) < points) {
                Some(place) => places.push(place),
                None => {
                    let message =
                        format!("a face of a mesh names point {place}, which the mesh does not have");
                    let label = match points {
                        0 => "there are no points".to_owned(),
                        points => format!("face {at}; the {points} points are numbered 0 to {}", points - 1),
                    };
                    return Err(self.face_fault(span, &message, label));
                }
            }
        }
        let mut sorted = places.clone();
        sorted.sort_unstable();
        if let Some(twice) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            let message = format!("a face of a mesh names point {} twice", twice[0]);
            return Err(self.face_fault(span, &message, format!("face {at}")));
        }
        Ok(places)
    }

    fn face_fault(&mut self, at: Span, message: &str, label: String) -> Stop {
        let diagnostic = Diagnostic::new(Code::E0555, at, message).label(label);
        self.report(diagnostic.hint("a face lists the places of its corners, counted from 0: `[0, 1, 2]`"))
    }
}

/// Where a face is written, if the faces are.
fn face_span(faces: &Expr, at: usize) -> Span {
    match &faces.kind {
        ExprKind::List(faces) => faces.get(at).map(|face| face.span),
        _ => None,
    }
    .unwrap_or(faces.span)
}
