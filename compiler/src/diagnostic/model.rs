//! The diagnostic itself, owned by us and known to no protocol.

use super::{Code, Fix, Severity};
use crate::source::Span;

/// A place and what is said of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Where.
    pub span: Span,
    /// What is said there.
    pub text: String,
}

/// A line of help, with the changes of the text that would do it, where they are known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hint {
    /// The sentence.
    pub text: String,
    /// The changes, each of which is enough; empty where the sentence is all there is.
    pub fixes: Vec<Fix>,
}

/// One thing that is wrong, or worth knowing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Which of the table's.
    pub code: Code,
    /// One sentence: what, with numbers.
    pub message: String,
    /// Where.
    pub span: Span,
    /// What is said at that place; may be empty.
    pub label: String,
    /// Other places that matter.
    pub labels: Vec<Label>,
    /// Why, a sentence each.
    pub notes: Vec<String>,
    /// How to mend it, a sentence each.
    pub hints: Vec<Hint>,
}

impl Diagnostic {
    /// A diagnostic at a place.
    pub fn new(code: Code, span: Span, message: impl Into<String>) -> Self {
        Diagnostic {
            code,
            message: message.into(),
            span,
            label: String::new(),
            labels: Vec::new(),
            notes: Vec::new(),
            hints: Vec::new(),
        }
    }

    /// What is said at the place itself.
    #[must_use]
    pub fn label(mut self, text: impl Into<String>) -> Self {
        self.label = text.into();
        self
    }

    /// Another place that matters.
    #[must_use]
    pub fn also(mut self, span: Span, text: impl Into<String>) -> Self {
        self.labels.push(Label { span, text: text.into() });
        self
    }

    /// A reason.
    #[must_use]
    pub fn note(mut self, text: impl Into<String>) -> Self {
        self.notes.push(text.into());
        self
    }

    /// A way to mend it.
    #[must_use]
    pub fn hint(self, text: impl Into<String>) -> Self {
        self.ways(text, Vec::new())
    }

    /// A way to mend it, as a change of the text.
    #[must_use]
    pub fn fix(self, text: impl Into<String>, span: Span, replacement: impl Into<String>) -> Self {
        self.ways(text, vec![Fix::replacing(span, replacement)])
    }

    /// A way to mend it with the changes of the text that do it, each of which is enough.
    #[must_use]
    pub fn ways(mut self, text: impl Into<String>, fixes: Vec<Fix>) -> Self {
        self.hints.push(Hint { text: text.into(), fixes });
        self
    }

    /// The changes of the text that would mend it, of all its hints in order.
    pub fn fixes(&self) -> impl Iterator<Item = &Fix> {
        self.hints.iter().flat_map(|hint| &hint.fixes)
    }

    /// How grave it is, as the table says.
    pub fn severity(&self) -> Severity {
        self.code.severity()
    }
}
