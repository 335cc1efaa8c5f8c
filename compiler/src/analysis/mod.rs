//! What one revision of a design means: its sources, tree, typed tree, plan, boards and diagnostics. Command line,
//! language server and preview read this one analysis; there is no second.

mod cascades;
mod earlier;
mod fabrication;
mod load;
mod machine;
mod measures;
mod mend;
pub mod parameters;
mod placed;
mod planarizing;
pub mod project;
mod requirements;
mod reread;
mod settings;
mod single;
mod testing;
mod watch;

pub use earlier::Earlier;
pub use fabrication::{
    Elements, Fabrication, Nest, PanelFigure, PanelsMade, PlankFigure, PlanksMade, Programs,
};
pub(crate) use fabrication::{nested_panel, nested_plank};
pub use load::{Library, MOST_BYTES, MOST_FILES, MeshFile, ProjectFile};
pub use placed::{FigureGeometry, figure_geometry, piece_labels};
pub use requirements::{LimitValue, RequirementResult, value_words};
pub use reread::with_item_changed;
pub(crate) use settings::{field, number, text};
pub use single::{SingleText, single};
pub use testing::{TestResult, Verdict, run_tests};
pub use watch::{Unwatched, Watch};

use crate::diagnostic::{Code, Diagnostic, Diagnostics, Severity, did_you_mean};
use crate::hir::evaluate::{Evaluator, MachineName, Overrides, ParameterValue};
use crate::hir::index::Index;
use crate::hir::tree::{Hir, Item, ItemKind};
use crate::hir::{Checked, ModuleSource, check, check_indexed};
use crate::plan::lower::{Lowered, lower};
use crate::source::{FileId, Files, SourceMap, Span};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Everything that is known of a design. A copy shares what was read: texts, trees and index.
#[derive(Clone, Debug)]
pub struct Analysis {
    /// The texts: the design's own first, then the library's, then those of the files it uses.
    pub sources: Arc<SourceMap>,
    /// The design's own file.
    pub root: FileId,
    /// The files of the project that the design is made of: its own first, then those it uses as they are met.
    pub files: Arc<Vec<ProjectFile>>,
    /// The meshes that they import, as they are met.
    pub meshes: Arc<Vec<MeshFile>>,
    /// Its typed tree.
    pub hir: Arc<Hir>,
    /// What every name stands for and every expression is; empty unless it was read for an editor.
    pub index: Arc<Index>,
    /// Its parameters as they are used.
    pub parameters: Vec<ParameterValue>,
    /// The names of those that were set from outside.
    pub set_parameters: BTreeSet<String>,
    /// The machine that is named from outside, its file by the path from the root of the project.
    pub machine: Option<MachineName>,
    /// Its plan; none where it has errors.
    pub plan: Option<Lowered>,
    /// What its fabricate blocks make; empty where it has errors.
    pub fabrications: Vec<Fabrication>,
    /// What is wrong or worth knowing, by place.
    pub diagnostics: Vec<Diagnostic>,
}

impl Analysis {
    /// Whether anything is wrong.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|diagnostic| diagnostic.severity() == Severity::Error)
    }

    /// The name of the design: that of its file without ending; `stdin` for the standard input, `design` for a file
    /// whose name is all ending or full stops.
    pub fn design_name(&self) -> String {
        let path = self.sources.get(self.root).map_or("", |source| source.path.as_str());
        let file = path.rsplit('/').next().unwrap_or(path);
        match file.strip_suffix(".ifs").unwrap_or(file) {
            "-" => "stdin".to_owned(),
            // Such names would make the output folder the one it should lie in.
            "" | "." | ".." => "design".to_owned(),
            name => name.to_owned(),
        }
    }
}

/// Analyses a design: the file `root`, with parameters set from outside.
pub fn analyse(files: &dyn Files, root: &str, overrides: &Overrides) -> Analysis {
    analyse_watched(files, root, overrides, &mut Unwatched)
}

/// The same, telling how far it is where it takes long.
pub fn analyse_watched(
    files: &dyn Files,
    root: &str,
    overrides: &Overrides,
    watch: &mut dyn Watch,
) -> Analysis {
    work_out_watched(read(files, root, overrides), overrides, watch)
}

/// What has been read, worked out to its boards.
pub fn work_out(analysis: Analysis, overrides: &Overrides) -> Analysis {
    work_out_watched(analysis, overrides, &mut Unwatched)
}

/// The same, telling how far it is where it takes long.
pub fn work_out_watched(analysis: Analysis, overrides: &Overrides, watch: &mut dyn Watch) -> Analysis {
    let mut analysis = measure_watched(analysis, overrides, watch);
    analysis.diagnostics = mended(&analysis, overrides, watch);
    analysis
}

/// What has been read, worked out to its boards and measured: of what fails it is not said what would mend it.
pub fn measure_watched(mut analysis: Analysis, overrides: &Overrides, watch: &mut dyn Watch) -> Analysis {
    let mut diagnostics = Diagnostics::default();
    diagnostics.extend(std::mem::take(&mut analysis.diagnostics));
    // A design with errors is not worked out: what it means is not known. But each ifs stands for itself.
    if diagnostics.has_errors() {
        diagnostics.extend(check_weights(&analysis.hir, overrides));
    } else {
        let evaluated = evaluate(&analysis.hir, overrides, watch);
        diagnostics.extend(evaluated.diagnostics);
        let failed = evaluated.fabrications.iter().flat_map(|made| requirements::diagnostics(made, None));
        diagnostics.extend(failed);
        analysis.parameters = evaluated.parameters;
        analysis.plan = evaluated.plan;
        analysis.fabrications = evaluated.fabrications;
    }
    analysis.diagnostics = diagnostics.finish();
    analysis
}

/// The diagnostics of a design that was measured, with what would mend what fails: the design is worked out again and again
/// with something changed, which may take longer than measuring it did.
pub fn mended(analysis: &Analysis, overrides: &Overrides, watch: &mut dyn Watch) -> Vec<Diagnostic> {
    let made = (analysis.plan.as_ref(), analysis.fabrications.as_slice());
    let mut remedies = mend::Remedies::new(&analysis.hir, overrides, made, watch);
    let mut diagnostics = analysis.diagnostics.clone();
    for fabrication in &analysis.fabrications {
        let failed = requirements::diagnostics(fabrication, None);
        let with_remedies = requirements::diagnostics(fabrication, Some(&mut remedies));
        for (failed, mended) in failed.into_iter().zip(with_remedies) {
            diagnostics
                .iter_mut()
                .filter(|found| **found == failed)
                .for_each(|found| *found = mended.clone());
        }
    }
    diagnostics
}

/// A design as far as its typed tree: nothing is worked out.
pub fn read(files: &dyn Files, root: &str, overrides: &Overrides) -> Analysis {
    read_by(check, files, root, overrides, None)
}

/// The same with its index of names and types, for an editor.
pub fn read_indexed(files: &dyn Files, root: &str, overrides: &Overrides) -> Analysis {
    read_by(check_indexed, files, root, overrides, None)
}

/// The same, quicker where most of the files are as they were before.
pub fn read_indexed_again(files: &dyn Files, root: &str, overrides: &Overrides, before: Earlier) -> Analysis {
    read_by(check_indexed, files, root, overrides, Some(before))
}

fn read_by(
    check: fn(&[ModuleSource<'_>]) -> Checked,
    files: &dyn Files,
    root: &str,
    overrides: &Overrides,
    before: Option<Earlier>,
) -> Analysis {
    let loaded = load::load(files, root, overrides.machine.as_ref(), before);
    let root = loaded.files.first().map_or(FileId(0), |file| file.file);
    let mut diagnostics = Diagnostics::default();
    diagnostics.extend(loaded.diagnostics);
    // Of a text that could not be read to its end nothing more is said: it would speak of what is missing.
    for file in loaded.files.iter().filter(|file| file.readable) {
        diagnostics.extend(file.parse.diagnostics.iter().cloned());
    }
    let machine = overrides.machine.as_ref().map(|named| {
        let found = loaded.files.iter().find(|file| Some(file.file) == loaded.machine);
        let file = found.map_or_else(|| named.file.clone(), |file| file.path.clone());
        MachineName { file, ..named.clone() }
    });
    let Checked { mut hir, diagnostics: found, index } = check(&modules(&loaded.files, loaded.library));
    diagnostics.extend(cascades::without(found, &loaded.files, &loaded.sources));
    if !diagnostics.has_errors() {
        diagnostics.extend(unknown_parameters(&hir, &loaded.sources, overrides));
        hir.machine_file = loaded.machine;
        diagnostics.extend(machine::name_faults(&hir, overrides));
    }
    Analysis {
        sources: Arc::new(loaded.sources),
        root,
        files: Arc::new(loaded.files),
        meshes: Arc::new(loaded.meshes),
        hir: Arc::new(hir),
        index: Arc::new(index),
        parameters: Vec::new(),
        machine,
        set_parameters: overrides.parameters.keys().chain(overrides.defaults.keys()).cloned().collect(),
        plan: None,
        fabrications: Vec::new(),
        diagnostics: diagnostics.finish(),
    }
}

/// The files of the project and the modules of the library, as the checker takes them.
fn modules<'a>(files: &'a [ProjectFile], library: &'a Library) -> Vec<ModuleSource<'a>> {
    let own = files.iter().map(|file| ModuleSource {
        name: "",
        path: &file.path,
        file: file.file,
        ast: &file.parse.ast,
        uses: &file.uses,
        imports: &file.imports,
        complete: file.readable && !file.parse.diagnostics.iter().any(cascades::breaks),
    });
    let library = library.modules().map(|(name, file, ast)| ModuleSource {
        name,
        path: "",
        file,
        ast,
        uses: &[],
        imports: &[],
        complete: true,
    });
    own.chain(library).collect()
}

/// A typed design worked out once.
struct Evaluated {
    parameters: Vec<ParameterValue>,
    plan: Option<Lowered>,
    fabrications: Vec<Fabrication>,
    diagnostics: Vec<Diagnostic>,
}

/// Works a typed design out.
fn evaluate(hir: &Hir, overrides: &Overrides, watch: &mut dyn Watch) -> Evaluated {
    let mut evaluator = Evaluator::new(hir, overrides);
    evaluator.report_untyped();
    let mut diagnostics = Diagnostics::default();
    let (plan, found) = lower(hir, &mut evaluator, overrides);
    diagnostics.extend(found);
    let parameters = parameters(hir, &mut evaluator);
    let mut fabrications = Vec::new();
    let machine = match machine::machine(hir, &mut evaluator, overrides) {
        Ok(machine) => machine,
        Err(found) => {
            diagnostics.extend(found);
            None
        }
    };
    if let Some(plan) = &plan {
        for block in &hir.fabricates {
            if watch.step().is_break() {
                break;
            }
            let (made, found) =
                fabrication::fabricate(hir, &mut evaluator, plan, (block, machine.as_ref()), watch);
            diagnostics.extend(found);
            fabrications.extend(made);
        }
    }
    if let Some(plan) = &plan {
        diagnostics.extend(placed::too_large(hir, plan));
    }
    let mut evaluated = Evaluated { parameters, plan, fabrications, diagnostics: evaluator.finish() };
    evaluated.diagnostics.extend(diagnostics.finish());
    evaluated
}

/// Checks the weights of every ifs of the design for all values of its parameters.
fn check_weights(hir: &Hir, overrides: &Overrides) -> Vec<Diagnostic> {
    let mut evaluator = Evaluator::new(hir, overrides);
    for (id, _) in hir.project_items() {
        evaluator.check_symbolically(id);
    }
    evaluator.finish()
}

fn parameters(hir: &Hir, evaluator: &mut Evaluator<'_>) -> Vec<ParameterValue> {
    let params = hir.own_items().filter_map(|(id, item)| match &item.kind {
        ItemKind::Param(param) => Some((id, item.name.clone(), param.ty.clone())),
        _ => None,
    });
    params
        .filter_map(|(id, name, ty)| {
            let value = evaluator.global(id).ok()?;
            Some(ParameterValue { name, value, ty })
        })
        .collect()
}

fn unknown_parameters(hir: &Hir, sources: &SourceMap, overrides: &Overrides) -> Vec<Diagnostic> {
    let is_param = |item: &&Item| matches!(item.kind, ItemKind::Param(_));
    let known: Vec<&str> =
        hir.own_items().map(|(_, item)| item).filter(is_param).map(|item| item.name.as_str()).collect();
    let unknown = overrides.parameters.keys().filter(|name| !known.contains(&name.as_str()));
    unknown
        .map(|name| {
            let message = format!("the design has no parameter `{name}`");
            let diagnostic = Diagnostic::new(Code::E0605, Span::new(hir.root, 0, 0), message);
            let elsewhere = hir.project_items().map(|(_, item)| item).filter(is_param);
            if let Some(other) = elsewhere.into_iter().find(|item| item.name == *name) {
                let path = sources.get(other.name_span.file).map_or("", |source| source.path.as_str());
                return diagnostic
                    .also(other.name_span, "not the design's own")
                    .note(format!("`{name}` is a parameter of `{path}`: where another file uses that one, it keeps its default"))
                    .hint(format!("declare a parameter in the design, and give it to what `{path}` offers as an argument"));
            }
            match did_you_mean(name, known.iter().copied()) {
                Some(suggestion) => diagnostic.hint(suggestion),
                None if known.is_empty() => diagnostic.hint("it has no parameters at all"),
                None => diagnostic.note(format!("it has {}", known.join(", "))),
            }
        })
        .collect()
}
