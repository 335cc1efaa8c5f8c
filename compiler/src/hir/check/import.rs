//! `import("joint.glb")`: the mesh of a file as a germ. The file was read before; here it is put where it is named.

use super::{Checker, Frame, error_expr};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::native::Native;
use crate::hir::tree::{Expr, ExprKind};
use crate::hir::types::{PointSpace, Type};
use crate::source::Span;
use crate::syntax::ast;

impl Checker<'_> {
    pub(super) fn import_mesh(
        &mut self,
        frame: &mut Frame,
        arguments: &[ast::Argument],
        at: Span,
        span: Span,
    ) -> Expr {
        // As any other function: one text.
        let checked = self.native_by_parameters(frame, Native::Import, arguments, at, span);
        let ([argument], ExprKind::Native(..)) = (arguments, &checked.kind) else { return error_expr(span) };
        if !matches!(argument.value.kind, ast::ExprKind::Text(_)) {
            return self.path_worked_out(argument.value.span, span);
        }
        let meshes = self.modules[frame.module].meshes;
        // In the order of the text.
        let named = meshes.binary_search_by_key(&argument.value.span.start, |(path, _)| path.start);
        let mesh = match named.ok().and_then(|place| meshes.get(place)).map(|(_, mesh)| mesh) {
            Some(Ok(mesh)) => mesh.clone(),
            Some(Err(diagnostic)) => {
                self.report((**diagnostic).clone());
                return error_expr(span);
            }
            // The text of the path has a mistake in it, which has been said.
            None => return error_expr(span),
        };
        match self.own_space(frame) {
            None | Some(PointSpace::Space) => Expr { kind: ExprKind::Imported(mesh), ty: Type::Germ, span },
            Some(own) => self.mesh_elsewhere(own, span),
        }
    }

    fn path_worked_out(&mut self, path: Span, span: Span) -> Expr {
        let message =
            "the path in `import` is written out: the files of a design are known before it is worked out";
        let diagnostic = Diagnostic::new(Code::E0557, path, message).label("not a path in quotes");
        self.report(diagnostic.hint("write it here: `import(\"joint.glb\")`"));
        error_expr(span)
    }

    fn mesh_elsewhere(&mut self, own: PointSpace, span: Span) -> Expr {
        let lives = match own {
            PointSpace::Control => "on control points".to_owned(),
            own => own.words().to_owned(),
        };
        let message = format!("a mesh that is imported lies in space, but the ifs lives {lives}");
        let diagnostic = Diagnostic::new(Code::E0532, span, message).label("has three coordinates");
        self.report(diagnostic.hint(match own {
            PointSpace::Control => {
                "let the ifs live `in space`; a mesh over control points is `mesh([p, q, r], [[0, 1, 2]])`"
            }
            _ => "let the ifs live `in space`",
        }));
        error_expr(span)
    }
}
