//! What a build writes: from one analysis to named outputs. The folder they go to, and when, is the caller's business.

mod html;
mod model;
pub mod names;
mod parts;
mod programs;
mod report;

use crate::analysis::{Analysis, Elements};
use crate::diagnostic::{Code, Diagnostic};
use crate::export::planarity_csv::{Surface, planarity_csv};
use crate::export::{cut_list, glb::GlbError};
use crate::source::Span;
use model::OwnedModel;
use sha2::{Digest, Sha256};
use std::io;

/// Which outputs are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Selection {
    /// `model.glb`
    pub glb: bool,
    /// `boards/*.nc`
    pub nc: bool,
    /// `cutlist.csv`, `planarity.csv`
    pub csv: bool,
    /// `report.json`
    pub json: bool,
    /// `report.html`
    pub html: bool,
}

impl Selection {
    /// Everything.
    pub const ALL: Selection = Selection { glb: true, nc: true, csv: true, json: true, html: true };

    /// Whether nothing is wanted.
    pub fn is_empty(self) -> bool {
        !(self.glb || self.nc || self.csv || self.json || self.html)
    }
}

/// One file of a build.
#[derive(Debug)]
pub struct Output {
    /// Its place in the output folder, with `/`.
    pub path: String,
    /// What it is, for the manifest: `model`, `report`, `list`, `program`.
    pub kind: &'static str,
    /// The address of the board it is for.
    pub address: Option<String>,
    /// What it holds.
    content: Content,
}

#[derive(Debug)]
enum Content {
    Bytes(Vec<u8>),
    Model(Box<OwnedModel>),
}

impl Output {
    fn new(path: &str, kind: &'static str, text: String) -> Self {
        Output { path: path.to_owned(), kind, address: None, content: Content::Bytes(text.into_bytes()) }
    }

    /// Writes the bytes of the file.
    ///
    /// # Errors
    /// Those of `out`; a model that its format cannot hold.
    pub fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        match &self.content {
            Content::Bytes(bytes) => out.write_all(bytes),
            Content::Model(model) => model.write(out).map_err(|error| match error {
                GlbError::Write(error) => error,
                other => io::Error::other(other.to_string()),
            }),
        }
    }
}

/// The outputs of a design, or why some cannot be made.
#[derive(Debug)]
pub struct Outputs {
    /// The files, in order; empty where there are diagnostics.
    pub files: Vec<Output>,
    /// Boards that cannot be made by the machine they are for.
    pub diagnostics: Vec<Diagnostic>,
}

/// Makes the outputs of a design without errors.
pub fn outputs(analysis: &Analysis, selection: Selection) -> Outputs {
    let mut files = Vec::new();
    if analysis.plan.as_ref().is_none_or(|lowered| lowered.plan.figures().is_empty()) {
        let message = "there is nothing to build: the design has no figures";
        let diagnostic = Diagnostic::new(Code::E0807, Span::new(analysis.root, 0, 0), message);
        let diagnostic = diagnostic.hint("declare one: `figure line = … on (…) at level 3`");
        return Outputs { files, diagnostics: vec![diagnostic] };
    }
    if selection.glb {
        let model = Box::new(OwnedModel::of(analysis));
        files.push(Output {
            path: "model.glb".to_owned(),
            kind: "model",
            address: None,
            content: Content::Model(model),
        });
    }
    if selection.nc {
        let (programs, diagnostics) = programs::programs(analysis);
        if !diagnostics.is_empty() {
            return Outputs { files: Vec::new(), diagnostics };
        }
        files.extend(programs);
    }
    let parts = parts::parts(analysis, selection.nc);
    if selection.csv && !analysis.fabrications.is_empty() {
        let all: Vec<_> = parts.iter().flatten().cloned().collect();
        files.push(Output::new("cutlist.csv", "list", cut_list::cut_list(&all)));
        let surfaces = surfaces(analysis);
        if !surfaces.is_empty() {
            files.push(Output::new("planarity.csv", "list", planarity_csv(&surfaces)));
        }
    }
    if selection.json || selection.html {
        let report = report::report(analysis, parts);
        if selection.html {
            files.push(Output::new("report.html", "report", html::html(analysis, &report)));
        }
        if selection.json
            && let Ok(text) = report.to_json()
        {
            files.push(Output::new("report.json", "report", text));
        }
    }
    Outputs { files, diagnostics: Vec::new() }
}

fn surfaces(analysis: &Analysis) -> Vec<Surface<'_>> {
    let panels = analysis.fabrications.iter().filter_map(|made| match &made.elements {
        Elements::Panels(panels) => Some(panels),
        Elements::Planks(_) => None,
    });
    panels
        .flat_map(|panels| &panels.figures)
        .map(|figure| Surface {
            designed: &figure.designed,
            planarized: &figure.built,
            labels: &figure.labels,
        })
        .collect()
}

/// What a build is made of, as 16 hexadecimal digits: the design's text, those of the files it uses and the meshes it
/// imports with their paths in the project, and its parameters. Two builds with the same one by the same version of the program are the same.
pub fn design_hash(analysis: &Analysis) -> String {
    let mut hasher = Sha256::new();
    let mut sources = project_sources(analysis);
    if !sources.is_empty() {
        hasher.update(sources.remove(0).1);
    }
    sources.sort_unstable();
    for (path, bytes) in sources {
        hasher.update([1]);
        hasher.update(path.as_bytes());
        hasher.update([0]);
        hasher.update(bytes);
    }
    for (name, value) in parameter_texts(analysis) {
        hasher.update([0]);
        hasher.update(name.as_bytes());
        hasher.update([0]);
        hasher.update(value.as_bytes());
    }
    names::hex(&hasher.finalize())[..16].to_owned()
}

/// The files a build is made of, the design's own first, meshes last: their paths from the root of the project, and their
/// bytes.
pub fn project_sources(analysis: &Analysis) -> Vec<(String, &[u8])> {
    let files = analysis.files.iter().enumerate();
    let meshes = analysis.meshes.iter().map(|mesh| (mesh.path.clone(), mesh.bytes.as_slice()));
    files
        .filter_map(|(place, file)| {
            let text = analysis.sources.get(file.file)?.text.as_bytes();
            let stdin = place == 0 && file.path.rsplit('/').next() == Some("-");
            let path = if stdin { format!("{}.ifs", analysis.design_name()) } else { file.path.clone() };
            Some((path, text))
        })
        .chain(meshes)
        .collect()
}

/// The parameters as the language writes them, in the order of the design.
pub fn parameter_texts(analysis: &Analysis) -> Vec<(String, String)> {
    use crate::hir::evaluate::words;
    use crate::hir::value::Value;
    let text = |value: &Value, ty: &crate::hir::types::Type| match value {
        Value::Scalar(scalar) => words(scalar, ty),
        Value::Bool(truth) => truth.to_string(),
        Value::Text(text) => text.to_string(),
        _ => String::new(),
    };
    let parameters = analysis.parameters.iter();
    parameters.map(|parameter| (parameter.name.clone(), text(&parameter.value, &parameter.ty))).collect()
}
