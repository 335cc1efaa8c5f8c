//! The index of a design: what every name in its text stands for, what is declared where and can be seen from where, and
//! the type of every expression, broken items too. The checker fills it while it resolves names, so that an editor never
//! resolves a second time. What an editor makes of it lives in its features.

mod names;

pub use names::{Known, ModuleNames, Origin, Parameter, Visible};

use super::native::Native;
use super::schema::{ChoiceKind, Measure, SchemaKind};
use super::size::SizeMeasure;
use super::tree::{ItemId, Made};
use super::types::Type;
use crate::source::{FileId, Span};
use std::collections::BTreeSet;

/// What is known of the names and expressions of a design.
#[derive(Clone, Debug, Default)]
pub struct Index {
    /// Every use of a name, by file and place after [`Index::sort`].
    pub references: Vec<Reference>,
    /// Every declaration, by file and place after [`Index::sort`].
    pub declarations: Vec<Declaration>,
    /// Every expression with its type, by file and start, outer before inner, after [`Index::sort`].
    pub types: Vec<(Span, Type)>,
    /// Every expression of which its place would like a type, with that type, in the order they were checked.
    pub expected: Vec<(Span, Type)>,
    /// The names of each file: those of the project first.
    pub modules: Vec<ModuleNames>,
    /// The records that say what a board is made of.
    pub materials: BTreeSet<ItemId>,
}

/// A name in the text, and what it stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reference {
    /// Where the name stands.
    pub span: Span,
    /// What it stands for.
    pub target: Target,
}

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Target {
    /// What is declared by the name that stands there.
    Declared(Span),
    /// A file of the project or the library.
    Module(FileId),
    /// A function of the program.
    Native(Native),
    /// A parameter of a function of the program, by its place.
    NativeParameter(Native, usize),
    /// A setting of a block.
    Setting(SchemaKind, &'static str),
    /// A measure of a requirement.
    Measure(Measure),
    /// What a level is found by.
    Size(SizeMeasure),
    /// What a test asks of a figure.
    Made(Made),
    /// A word of a choice, by its place.
    Choice(ChoiceKind, usize),
}

/// Something declared.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// Its name.
    pub name: String,
    /// Where the name stands: the identity of what is declared.
    pub span: Span,
    /// What it is.
    pub kind: DeclarationKind,
    /// Its type, where it has one.
    pub ty: Type,
    /// Where it can be named without saying what it belongs to; `None` for items, fields and transforms.
    pub scope: Option<Span>,
}

/// What is declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum DeclarationKind {
    /// An item of a file.
    Item(ItemId),
    /// A parameter of a function or an ifs, or a field of a record, by its place.
    Field(ItemId, usize),
    /// A control point of an ifs, or a list of them.
    ControlPoint,
    /// A `let` inside of an ifs or a test.
    Local,
    /// What a comprehension or a family runs through.
    Running,
    /// A transform of an ifs.
    Transform(ItemId),
    /// A boundary of an ifs.
    Boundary(ItemId),
}

impl Index {
    /// Puts everything in the order of files and places; what was recorded twice stays once.
    pub fn sort(&mut self) {
        let place = |span: &Span| (span.file, span.start, span.end);
        self.references.sort_by_key(|reference| (place(&reference.span), reference.target));
        self.references.dedup();
        self.declarations.sort_by_key(|declaration| place(&declaration.span));
        // An item is declared before its type is known, a parameter before what it can be named in.
        self.declarations.dedup_by(|later, earlier| {
            let same = later.span == earlier.span;
            if same {
                earlier.kind = later.kind;
                earlier.scope = later.scope.or(earlier.scope);
                if later.ty != Type::Error {
                    earlier.ty = later.ty.clone();
                }
            }
            same
        });
        self.types.sort_by_key(|(span, _)| (span.file, span.start, std::cmp::Reverse(span.end)));
        // A group and what is in it, or an expression and its conversion: the last one recorded is the outer one.
        self.types.dedup_by(|later, earlier| {
            let same = later.0 == earlier.0;
            if same {
                earlier.1 = later.1.clone();
            }
            same
        });
    }

    /// The name at a place: a use, or the declaration itself. A place right behind a name counts.
    pub fn name_at(&self, file: FileId, offset: u32) -> Option<Reference> {
        let here = |span: Span| span.file == file && span.start <= offset && offset <= span.end;
        let used = self.references.iter().filter(|reference| here(reference.span));
        // Of two names that touch, the one that starts here.
        if let Some(found) = used.max_by_key(|reference| reference.span.start) {
            return Some(*found);
        }
        let declared = self.declarations.iter().find(|declaration| here(declaration.span))?;
        Some(Reference { span: declared.span, target: Target::Declared(declared.span) })
    }

    /// What is declared by the name at `span`.
    pub fn declaration(&self, span: Span) -> Option<&Declaration> {
        // They are in the order of files and places.
        let found = self.declarations.binary_search_by_key(&span, |declaration| declaration.span).ok()?;
        self.declarations.get(found)
    }

    /// Every use of a target, in the order of the files; a declaration is no use.
    pub fn uses(&self, target: Target) -> impl Iterator<Item = Span> + '_ {
        self.references.iter().filter(move |reference| reference.target == target).map(|found| found.span)
    }

    /// The innermost expression around a place, and its type.
    pub fn type_at(&self, file: FileId, offset: u32) -> Option<(Span, &Type)> {
        let around = |span: &Span| span.file == file && span.start <= offset && offset <= span.end;
        let found = self.types.iter().filter(|(span, _)| around(span));
        found.min_by_key(|(span, _)| span.end - span.start).map(|(span, ty)| (*span, ty))
    }

    /// The declarations that can be named at a place by their name alone, innermost first; items are not among them.
    pub fn visible(&self, file: FileId, offset: u32) -> Vec<&Declaration> {
        let seen = |scope: &Span| scope.file == file && scope.start <= offset && offset <= scope.end;
        let mut found: Vec<&Declaration> = self
            .declarations
            .iter()
            .filter(|declaration| declaration.scope.as_ref().is_some_and(seen))
            .collect();
        found.sort_by_key(|declaration| std::cmp::Reverse(declaration.span.start));
        found
    }
}
