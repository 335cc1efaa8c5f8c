//! What a build writes: from one analysis to named outputs. The folder they go to, and when, is the caller's business.

mod assembly;
mod diagnostics;
mod drawings;
mod failures;
mod html;
mod labels;
mod machines;
mod model;
pub mod names;
pub mod nests;
mod parts;
mod place;
mod programs;
mod refits;
mod report;
mod selection;
mod sheet_drawings;
mod sheet_programs;
mod sheets;
mod timber;
mod workshop;

pub use diagnostics::{DIAGNOSTICS, diagnostics_json};
pub use selection::{Format, LeftOut, Selection};
use workshop::small_boards;
pub use workshop::workshop_faults;

use crate::analysis::{Analysis, Elements};
use crate::diagnostic::{Code, Diagnostic};
use crate::export::assembly::assembly as assembly_list;
use crate::export::btlx::Project;
use crate::export::dxf::Drawing;
use crate::export::labels::Sheet;
use crate::export::part::Part;
use crate::export::planarity_csv::{Surface, planarity_csv};
use crate::export::{cut_list, glb::GlbError};
use crate::hir::tree::ItemKind;
use crate::source::Span;
use model::OwnedModel;
use nests::Nests;
use sha2::{Digest, Sha256};
use std::io;

/// One file of a build.
#[derive(Debug)]
pub struct Output {
    /// Its place in the output folder, with `/`.
    pub path: String,
    /// What it is, for the manifest: `model`, `report`, `list`, `program`, `drawing`,
    /// `labels`, `diagnostics`.
    pub kind: &'static str,
    /// The address of the board it is for.
    pub address: Option<String>,
    /// What it holds.
    content: Content,
}

#[derive(Debug)]
enum Content {
    Bytes(Vec<u8>),
    Drawing(Drawing),
    Labels(Sheet),
    Timber(Project),
    Model(Box<OwnedModel>),
}

impl Output {
    fn new(path: &str, kind: &'static str, text: String) -> Self {
        Output { path: path.to_owned(), kind, address: None, content: Content::Bytes(text.into_bytes()) }
    }

    /// A file of the whole design that is written piece by piece.
    fn of_design(path: &str, kind: &'static str, content: Content) -> Self {
        Output { path: path.to_owned(), kind, address: None, content }
    }

    /// A file for one board.
    fn of_board(path: &str, kind: &'static str, address: &str, bytes: Vec<u8>) -> Self {
        let address = Some(address.to_owned());
        Output { path: path.to_owned(), kind, address, content: Content::Bytes(bytes) }
    }

    /// Writes the bytes of the file.
    ///
    /// # Errors
    /// Those of `out`; a model that its format cannot hold.
    pub fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        match &self.content {
            Content::Bytes(bytes) => out.write_all(bytes),
            Content::Drawing(drawing) => drawing.write(out),
            Content::Labels(sheet) => sheet.write(out),
            Content::Timber(project) => project.write(out),
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
    /// The files, in order; empty where there are errors.
    pub files: Vec<Output>,
    /// What is nested, and where.
    pub nests: Nests,
    /// Boards that cannot be made by the machine they are for, and warnings about those that can.
    pub diagnostics: Vec<Diagnostic>,
}

impl Outputs {
    fn failed(diagnostics: Vec<Diagnostic>) -> Self {
        Outputs { files: Vec::new(), nests: Nests::default(), diagnostics }
    }
}

/// How far the outputs are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Making {
    /// So many boards of a block of `of` boards have their programs, each read back.
    Programs {
        /// Boards with programs.
        done: usize,
        /// All of the block.
        of: usize,
    },
    /// Boards are being nested.
    Nests,
    /// So many sheets have their programs, each read back.
    Sheets {
        /// Sheets with programs.
        done: usize,
        /// All of the nest.
        of: usize,
    },
    /// Lists and drawings are being made.
    Lists,
    /// The reports are being made.
    Reports,
}

/// That there is nothing to build: no figure is declared, or each is a list without elements.
fn no_figures(analysis: &Analysis) -> Diagnostic {
    let figures = analysis
        .hir
        .items
        .iter()
        .filter(|item| item.name_span.file == analysis.root && matches!(item.kind, ItemKind::Figure(_)));
    let mut empty = figures.map(|item| (&item.name, item.name_span));
    let Some((name, span)) = empty.next() else {
        let message = "there is nothing to build: the design has no figures";
        let diagnostic = Diagnostic::new(Code::E0807, Span::new(analysis.root, 0, 0), message);
        return diagnostic.hint("declare one: `figure line = … on (…) at level 3`");
    };
    let message = format!("there is nothing to build: `{name}` is an empty list of figures");
    let diagnostic = Diagnostic::new(Code::E0807, span, message).label("has no elements");
    let diagnostic = empty
        .fold(diagnostic, |told, (name, span)| told.also(span, format!("`{name}` is an empty list too")));
    diagnostic.hint("let the range it is made of have elements: `0..n` has n of them, and none where n is 0")
}

/// Makes the outputs of a design without errors.
pub fn outputs(analysis: &Analysis, selection: &Selection) -> Outputs {
    outputs_watched(analysis, selection, &mut |_| ())
}

/// The same, telling how far it is: before each stage, and before each board and each sheet of the programs.
pub fn outputs_watched(analysis: &Analysis, selection: &Selection, watch: &mut dyn FnMut(Making)) -> Outputs {
    let mut files = Vec::new();
    if analysis.plan.as_ref().is_none_or(|lowered| lowered.plan.figures().is_empty()) {
        return Outputs::failed(vec![no_figures(analysis)]);
    }
    if selection.makes(Format::Glb) {
        let content = Content::Model(Box::new(OwnedModel::of(analysis)));
        files.push(Output::of_design("model.glb", "model", content));
    }
    watch(Making::Nests);
    let nests = match nests::nests(analysis) {
        Ok(nests) => nests,
        Err(diagnostics) => return Outputs::failed(diagnostics),
    };
    if [Format::Nc, Format::Dxf, Format::Btlx].iter().any(|format| selection.makes(*format)) {
        let diagnostics = cut_files(analysis, selection, &nests, &mut files, watch);
        if !diagnostics.is_empty() {
            return Outputs::failed(diagnostics);
        }
    }
    watch(Making::Lists);
    let mut parts = parts::parts(analysis, &files);
    sheets::mark(&nests, &mut parts);
    if selection.makes(Format::Csv) && !analysis.fabrications.is_empty() {
        lists(analysis, selection, &nests, &parts, &mut files);
    }
    if selection.makes(Format::Svg) {
        let pictures = sheets::pictures(&nests).into_iter();
        files.extend(pictures.map(|(path, text)| Output::new(&path, "drawing", text)));
        let labels = labels::sheets(analysis, selection).into_iter();
        files.extend(labels.map(|(name, sheet)| Output::of_design(&name, "labels", Content::Labels(sheet))));
    }
    if selection.makes(Format::Html) || selection.makes(Format::Json) {
        watch(Making::Reports);
        let report = report::report(analysis, parts, &nests, &sheets::files_of(&files));
        if selection.makes(Format::Html) {
            files.push(Output::new("report.html", "report", html::html(analysis, &report, &nests)));
        }
        if selection.makes(Format::Json)
            && let Ok(text) = report.to_json()
        {
            files.push(Output::new("report.json", "report", text));
        }
    }
    let warnings = if selection.makes(Format::Nc) { small_boards(analysis) } else { Vec::new() };
    let all: Vec<Diagnostic> = analysis.diagnostics.iter().chain(&warnings).cloned().collect();
    let said = diagnostics_json(&all, &analysis.sources, false);
    files.push(Output::new(DIAGNOSTICS, "diagnostics", said));
    Outputs { files, nests, diagnostics: warnings }
}

/// Programs and drawings of boards and sheets, or what speaks against them.
fn cut_files(
    analysis: &Analysis,
    selection: &Selection,
    nests: &Nests,
    files: &mut Vec<Output>,
    watch: &mut dyn FnMut(Making),
) -> Vec<Diagnostic> {
    let (blocks, mut diagnostics) = programs::blocks(analysis, selection);
    if !diagnostics.is_empty() {
        return diagnostics;
    }
    if selection.makes(Format::Nc) {
        let (programs, found) = programs::programs(analysis, &blocks, nests, watch);
        diagnostics.extend(found);
        let (of_sheets, found) = sheet_programs::programs(&blocks, nests, programs.len(), watch);
        diagnostics.extend(found);
        files.extend(programs.into_iter().chain(of_sheets));
    }
    if selection.makes(Format::Dxf) {
        files.extend(drawings::drawings(&blocks));
        files.extend(sheet_drawings::drawings(&blocks, nests));
    }
    if selection.makes(Format::Btlx) && !blocks.is_empty() {
        let content = Content::Timber(timber::project(analysis, &blocks));
        files.push(Output::of_design("model.btlx", "model", content));
    }
    diagnostics
}

/// The lists of the boards that are wanted.
fn lists(
    analysis: &Analysis,
    selection: &Selection,
    nests: &Nests,
    parts: &[Vec<Part>],
    files: &mut Vec<Output>,
) {
    let wanted = |part: &&Part| selection.takes(&part.address, &part.alias);
    let all: Vec<Part> = parts.iter().flatten().filter(wanted).cloned().collect();
    files.push(Output::new("cutlist.csv", "list", cut_list::cut_list(&all)));
    let rows = assembly::rows(analysis, selection);
    files.push(Output::new("assembly.csv", "list", assembly_list(&rows)));
    let nested = [("nest.csv", sheets::nest_list(nests)), ("stock.csv", sheets::stock_list(nests))];
    files.extend(nested.into_iter().filter_map(|(path, text)| Some(Output::new(path, "list", text?))));
    let surfaces = surfaces(analysis);
    if !surfaces.is_empty() {
        files.push(Output::new("planarity.csv", "list", planarity_csv(&surfaces)));
    }
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

/// Address and alias of every board and plank of a design, in order, also of those that cannot be made.
pub fn board_names(analysis: &Analysis) -> Vec<(&str, &str)> {
    let labels = selection::labels(analysis);
    labels.into_iter().map(|label| (label.address.as_str(), label.alias.as_str())).collect()
}

/// What a build is made of, as 16 hexadecimal digits: the design's text, those of the files it uses and the meshes it
/// imports with their paths in the project, its parameters, and the machine that is named from outside. Two builds with the same one by the same version of the program are the same.
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
    if let Some(machine) = machine_text(analysis) {
        hasher.update([2]);
        hasher.update(machine.as_bytes());
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

/// The machine that is named from outside, as it can be named again: `machines.ifs:router`, the path from the root of
/// the project.
pub fn machine_text(analysis: &Analysis) -> Option<String> {
    analysis.machine.as_ref().map(|machine| format!("{}:{}", machine.file, machine.name))
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
