//! The names that each file can use: its own, those it imports, those of the prelude, and those of the library that a `use`
//! would bring. Local names are declarations with a scope.

use super::{Index, Target};
use crate::hir::types::{PointSpace, Type};
use crate::source::{FileId, Span};
use std::collections::BTreeSet;

/// What a function, record or ifs takes in one place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// Whether it must be given.
    pub required: bool,
    /// Where its name is declared.
    pub span: Span,
    /// Where the value stands that it has when it is left out.
    pub default: Option<Span>,
}

/// A name of a file and what it stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Known {
    /// The name.
    pub name: String,
    /// What it stands for.
    pub target: Target,
    /// The type of the value, or of what a call gives; [`Type::Error`] where that is not known by itself.
    pub ty: Type,
    /// What it takes, for an item that is called; a function of the program has its own table.
    pub parameters: Option<Vec<Parameter>>,
    /// Where it lives, for an ifs that is declared.
    pub space: Option<PointSpace>,
}

/// The names of one file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ModuleNames {
    /// The file.
    pub file: FileId,
    /// As `use` names it: `std.curves`, `parts/ribs.ifs`.
    pub title: String,
    /// Whether it is one of the library.
    pub library: bool,
    /// What it declares.
    pub own: Vec<Known>,
    /// What others can use of it.
    pub public: Vec<Known>,
    /// What it imports.
    pub imported: Vec<Known>,
}

impl ModuleNames {
    /// Whether every file knows its names without `use`.
    pub fn is_prelude(&self) -> bool {
        self.title == "std.prelude"
    }
}

/// Where a name that can be written comes from, nearest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Origin<'a> {
    /// The item around.
    Local,
    /// The file itself.
    Own,
    /// An import of the file.
    Imported,
    /// The prelude.
    Prelude,
    /// A module of the library that must be named in a `use`: its title.
    Library(&'a str),
}

/// A name that can be written at a place.
#[derive(Clone, Copy, Debug)]
pub struct Visible<'a> {
    /// The name.
    pub name: &'a str,
    /// What it stands for.
    pub target: Target,
    /// The type of the value, or of what a call gives.
    pub ty: &'a Type,
    /// What it takes, for an item that is called.
    pub parameters: Option<&'a [Parameter]>,
    /// Where it lives, for an ifs that is declared.
    pub space: Option<PointSpace>,
    /// Where it comes from.
    pub origin: Origin<'a>,
}

impl<'a> Visible<'a> {
    fn known(known: &'a Known, origin: Origin<'a>) -> Visible<'a> {
        Visible {
            name: &known.name,
            target: known.target,
            ty: &known.ty,
            parameters: known.parameters.as_deref(),
            space: known.space,
            origin,
        }
    }
}

impl Index {
    /// The names of a file.
    pub fn module(&self, file: FileId) -> Option<&ModuleNames> {
        self.modules.iter().find(|module| module.file == file)
    }

    /// What an item that is called takes.
    pub fn parameters(&self, target: Target) -> Option<&[Parameter]> {
        let known = self.modules.iter().flat_map(|module| module.own.iter());
        known.filter(|known| known.target == target).find_map(|known| known.parameters.as_deref())
    }

    /// Every name that can be written at a place, nearest first; of two that are the same, only the one it stands for.
    pub fn names(&self, file: FileId, offset: u32) -> Vec<Visible<'_>> {
        let locals = self.visible(file, offset).into_iter().map(|declared| Visible {
            name: &declared.name,
            target: Target::Declared(declared.span),
            ty: &declared.ty,
            parameters: None,
            space: None,
            origin: Origin::Local,
        });
        let here = self.module(file);
        let own = here.into_iter().flat_map(|module| &module.own);
        let own = own.map(|known| Visible::known(known, Origin::Own));
        let imported = here.into_iter().flat_map(|module| &module.imported);
        let imported = imported.map(|known| Visible::known(known, Origin::Imported));
        let library = self.modules.iter().filter(|module| module.library && module.file != file);
        let library = library.flat_map(|module| {
            let origin = if module.is_prelude() { Origin::Prelude } else { Origin::Library(&module.title) };
            module.public.iter().map(move |known| Visible::known(known, origin))
        });
        let mut found: Vec<Visible<'_>> = locals.chain(own).chain(imported).chain(library).collect();
        let mut seen = BTreeSet::new();
        found.retain(|visible| seen.insert(visible.name));
        found.sort_by_key(|visible| visible.origin);
        found
    }

    /// The type that the place of an expression would like.
    pub fn expected_at(&self, span: Span) -> Option<&Type> {
        self.expected.iter().rev().find(|(place, _)| *place == span).map(|(_, ty)| ty)
    }
}
