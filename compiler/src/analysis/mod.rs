//! What one revision of a design means: its sources, tree, typed tree, plan, boards and diagnostics. Command line,
//! language server and preview read this one analysis; there is no second.

mod cascades;
mod fabrication;
mod load;
mod measures;
mod mend;
mod placed;
mod requirements;
mod settings;

pub use fabrication::{Elements, Fabrication, PanelFigure, PanelsMade, PlankFigure, PlanksMade};
pub use load::Library;
pub use placed::{FigureGeometry, figure_geometry};
pub use requirements::{LimitValue, RequirementResult};
pub(crate) use settings::{field, number, text};

use crate::diagnostic::{Code, Diagnostic, Diagnostics, Severity, did_you_mean};
use crate::hir::evaluate::{Evaluator, Overrides, ParameterValue};
use crate::hir::tree::{Hir, ItemKind};
use crate::hir::{Checked, ModuleSource, check};
use crate::plan::lower::{Lowered, lower};
use crate::source::{FileId, Files, SourceMap, Span};
use crate::syntax::Parse;
use std::collections::BTreeSet;

/// Everything that is known of a design.
#[derive(Debug)]
pub struct Analysis {
    /// The texts: the design's own first, then the library's.
    pub sources: SourceMap,
    /// The design's own file.
    pub root: FileId,
    /// Its tree and tokens.
    pub parse: Parse,
    /// Its typed tree.
    pub hir: Hir,
    /// Its parameters as they are used.
    pub parameters: Vec<ParameterValue>,
    /// The names of those that were set from outside.
    pub set_parameters: BTreeSet<String>,
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
            "-" if path == "-" => "stdin".to_owned(),
            // Such names would make the output folder the one it should lie in.
            "" | "." | ".." => "design".to_owned(),
            name => name.to_owned(),
        }
    }
}

/// Analyses a design: the file `root`, with parameters set from outside.
pub fn analyse(files: &dyn Files, root: &str, overrides: &Overrides) -> Analysis {
    let mut loaded = load::load(files, root);
    let mut diagnostics = Diagnostics::default();
    diagnostics.extend(std::mem::take(&mut loaded.diagnostics));
    // Of a text that could not be read to its end nothing more is said: it would speak of what is missing.
    let readable = diagnostics.is_empty();
    if readable {
        diagnostics.extend(loaded.parse.diagnostics.iter().cloned());
    }
    let Checked { hir, diagnostics: found } = {
        let mut modules = vec![ModuleSource { name: "", file: loaded.root, ast: &loaded.parse.ast }];
        modules.extend(loaded.library.modules().map(|(name, file, ast)| ModuleSource { name, file, ast }));
        check(&modules)
    };
    if readable {
        let text = loaded.sources.get(loaded.root).map_or("", |source| source.text.as_str());
        let found = cascades::without(found, text, &loaded.parse);
        // An import is not unused whose use could not be read.
        let broken = !loaded.parse.diagnostics.is_empty();
        diagnostics.extend(found.into_iter().filter(|found| !(broken && found.code == Code::W0307)));
    }
    if !diagnostics.has_errors() {
        diagnostics.extend(unknown_parameters(&hir, overrides));
    }
    let mut analysis = Analysis {
        sources: loaded.sources,
        root: loaded.root,
        parse: loaded.parse,
        hir,
        parameters: Vec::new(),
        set_parameters: overrides.parameters.keys().cloned().collect(),
        plan: None,
        fabrications: Vec::new(),
        diagnostics: Vec::new(),
    };
    // A design with errors is not worked out: what it means is not known. But each ifs stands for itself.
    if diagnostics.has_errors() {
        diagnostics.extend(check_weights(&analysis.hir, overrides));
    } else {
        let evaluated = evaluate(&analysis.hir, overrides, true);
        diagnostics.extend(evaluated.diagnostics);
        analysis.parameters = evaluated.parameters;
        analysis.plan = evaluated.plan;
        analysis.fabrications = evaluated.fabrications;
    }
    analysis.diagnostics = diagnostics.finish();
    analysis
}

/// A typed design worked out once.
struct Evaluated {
    parameters: Vec<ParameterValue>,
    plan: Option<Lowered>,
    fabrications: Vec<Fabrication>,
    diagnostics: Vec<Diagnostic>,
}

/// Works a typed design out; `mend` says whether remedies are looked for where requirements fail.
fn evaluate(hir: &Hir, overrides: &Overrides, mend: bool) -> Evaluated {
    let mut evaluator = Evaluator::new(hir, overrides);
    evaluator.report_untyped();
    let mut diagnostics = Diagnostics::default();
    let (plan, found) = lower(hir, &mut evaluator, overrides);
    diagnostics.extend(found);
    let parameters = parameters(hir, &mut evaluator);
    let mut fabrications = Vec::new();
    if let Some(plan) = &plan {
        for block in &hir.fabricates {
            let (made, found) = fabrication::fabricate(hir, &mut evaluator, plan, block);
            diagnostics.extend(found);
            fabrications.extend(made);
        }
    }
    let mut evaluated = Evaluated { parameters, plan, fabrications, diagnostics: evaluator.finish() };
    if mend {
        let remedies = mend::Remedies::new(hir, overrides, &evaluated);
        let failed: Vec<Diagnostic> = evaluated
            .fabrications
            .iter()
            .flat_map(|fabrication| requirements::diagnostics(fabrication, &remedies))
            .collect();
        diagnostics.extend(failed);
    }
    evaluated.diagnostics.extend(diagnostics.finish());
    evaluated
}

/// Checks the weights of every ifs of the design for all values of its parameters.
fn check_weights(hir: &Hir, overrides: &Overrides) -> Vec<Diagnostic> {
    let mut evaluator = Evaluator::new(hir, overrides);
    for (id, _) in hir.own_items() {
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

fn unknown_parameters(hir: &Hir, overrides: &Overrides) -> Vec<Diagnostic> {
    let known: Vec<&str> = hir
        .own_items()
        .filter(|(_, item)| matches!(item.kind, ItemKind::Param(_)))
        .map(|(_, item)| item.name.as_str())
        .collect();
    let unknown = overrides.parameters.keys().filter(|name| !known.contains(&name.as_str()));
    unknown
        .map(|name| {
            let message = format!("the design has no parameter `{name}`");
            let diagnostic = Diagnostic::new(Code::E0605, Span::new(hir.root, 0, 0), message);
            match did_you_mean(name, known.iter().copied()) {
                Some(suggestion) => diagnostic.hint(suggestion),
                None if known.is_empty() => diagnostic.hint("it has no parameters at all"),
                None => diagnostic.note(format!("it has {}", known.join(", "))),
            }
        })
        .collect()
}
