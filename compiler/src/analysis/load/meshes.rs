//! The meshes that files name by `import`: each is read once, and becomes a germ or the reason why it does not.

use super::{Failure, Loader, is_whole, paths, problems};
use crate::diagnostic::{Code, Diagnostic};
use crate::exact::Rational;
use crate::gltf::{Fault, FaultKind, TriangleMesh, read_glb};
use crate::hir::ImportedMesh;
use crate::hir::scalar::Scalar;
use crate::hir::value::{Combination, Germ, GermShape, Terms};
use crate::syntax::ast::{Item, ItemKind, TextLiteral};
use crate::syntax::{imported_paths, limits::MAX_BYTES};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A file that a design reads a mesh from.
#[derive(Debug)]
pub struct MeshFile {
    /// Its path from the root of the project.
    pub path: String,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

/// The meshes met so far.
#[derive(Default)]
pub(super) struct Meshes {
    pub(super) files: Vec<MeshFile>,
    /// What each path leads to.
    known: BTreeMap<String, Result<Arc<Germ>, MeshFailure>>,
}

#[derive(Clone)]
enum MeshFailure {
    NotRead(Failure),
    NoMesh(Fault),
}

impl Loader<'_> {
    /// Reads the meshes that a file names.
    pub(super) fn import(&mut self, place: usize) {
        let file = &self.found[place];
        // There `import` is a function of its own.
        if file.parse.ast.items.iter().any(is_named_import) {
            return;
        }
        let Some(source) = self.sources.get(file.file) else { return };
        let named: Vec<TextLiteral> = imported_paths(source, &file.parse)
            .into_iter()
            .filter(|path| is_whole(path, &file.parse))
            .collect();
        let from = file.path.clone();
        for written in named {
            let mesh = self.imported(&from, &written);
            if let Some(path) = self.there(&from, &written) {
                self.found[place].meshes.push((written.span, path));
            }
            self.found[place].imports.push((written.span, mesh));
        }
    }

    /// The path of a mesh that could be read.
    fn there(&self, from: &str, written: &TextLiteral) -> Option<String> {
        let path = paths::path(from, &written.value).ok()?;
        let missing = matches!(self.meshes.known.get(&path)?, Err(MeshFailure::NotRead(_)));
        (!missing).then_some(path)
    }

    fn imported(&mut self, from: &str, written: &TextLiteral) -> ImportedMesh {
        let path = paths::path(from, &written.value);
        let path = path.map_err(|fault| Box::new(problems::no_path(written, &fault, "./joint.glb")))?;
        let outcome = match self.meshes.known.get(&path) {
            Some(known) => known.clone(),
            None => {
                let outcome = self.mesh(&path);
                self.meshes.known.insert(path.clone(), outcome.clone());
                outcome
            }
        };
        outcome.map_err(|failure| Box::new(self.no_mesh(written, &path, &failure)))
    }

    fn no_mesh(&mut self, written: &TextLiteral, path: &str, failure: &MeshFailure) -> Diagnostic {
        let diagnostic = match failure {
            MeshFailure::NoMesh(fault) => problems::no_mesh(written, path, fault),
            MeshFailure::NotRead(Failure::Unreadable(error)) => {
                problems::unreadable(written, path, error, "glb")
            }
            MeshFailure::NotRead(Failure::TooManyFiles) => problems::too_many_files(written),
            MeshFailure::NotRead(Failure::TooManyBytes) => problems::too_many_bytes(written),
        };
        self.full |= diagnostic.code == Code::E0312;
        diagnostic
    }

    /// Reads a mesh that no path has led to yet.
    fn mesh(&mut self, path: &str) -> Result<Arc<Germ>, MeshFailure> {
        let resolved = self.files.resolve(path).map_err(Failure::Unreadable).map_err(MeshFailure::NotRead)?;
        if let Some(known) = self.meshes.known.get(&resolved) {
            return known.clone();
        }
        let bytes = self.bytes_of(&resolved).map_err(MeshFailure::NotRead)?;
        if bytes.len() > MAX_BYTES {
            return Err(MeshFailure::NoMesh(too_many_bytes()));
        }
        self.bytes = self.bytes.saturating_add(bytes.len());
        let outcome = read_glb(&bytes).map_err(MeshFailure::NoMesh).map(|mesh| Arc::new(germ(&mesh)));
        self.meshes.files.push(MeshFile { path: resolved.clone(), bytes });
        self.meshes.known.insert(resolved, outcome.clone());
        outcome
    }
}

fn is_named_import(item: &Item) -> bool {
    let name = match &item.kind {
        ItemKind::Let(value) => &value.name,
        ItemKind::Function(function) => &function.name,
        ItemKind::Ifs(ifs) => &ifs.name,
        _ => return false,
    };
    name.text == "import"
}

fn too_many_bytes() -> Fault {
    Fault {
        kind: FaultKind::TooLarge,
        what: format!("the file has more than {} MiB", MAX_BYTES >> 20),
        place: "its end".to_owned(),
        mend: "export it without textures, or reduce the mesh (decimate it)",
    }
}

/// A mesh as a germ: points in space, mm.
fn germ(mesh: &TriangleMesh) -> Germ {
    let scalar = |value: &f64| Scalar::Exact(Rational::from_f64(*value).unwrap_or_else(|| Rational::from(0)));
    let point = |vertex: &[f64; 3]| {
        let terms = Terms::Coordinates(vertex.iter().map(scalar).collect());
        Arc::new(Combination { terms, weight: Scalar::one(), made: None })
    };
    let faces = mesh.triangles.iter().map(|corners| corners.to_vec()).collect();
    Germ {
        shape: GermShape::Mesh { faces: Arc::new(faces) },
        vertices: mesh.vertices.iter().map(point).collect(),
    }
}
