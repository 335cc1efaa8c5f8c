//! Why a file gives no mesh.

/// What sort of a fault it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaultKind {
    /// The file is not what it says it is, or contradicts itself.
    Malformed,
    /// The file may be right, but it uses what is not read here.
    Unsupported,
    /// More than a limit.
    TooLarge,
    /// There is no surface in it.
    Empty,
}

/// Why a file gives no mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The sort.
    pub kind: FaultKind,
    /// What is wrong.
    pub what: String,
    /// Where in the file: a byte, or what of its description.
    pub place: String,
    /// How to mend it.
    pub mend: &'static str,
}

const EXPORT_AGAIN: &str = "export it again as glTF 2.0 binary (.glb)";

impl Fault {
    pub(super) fn malformed(place: impl Into<String>, what: impl Into<String>) -> Fault {
        Fault { kind: FaultKind::Malformed, what: what.into(), place: place.into(), mend: EXPORT_AGAIN }
    }

    pub(super) fn unsupported(
        place: impl Into<String>,
        what: impl Into<String>,
        mend: &'static str,
    ) -> Fault {
        Fault { kind: FaultKind::Unsupported, what: what.into(), place: place.into(), mend }
    }

    pub(super) fn too_large(place: impl Into<String>, what: impl Into<String>, mend: &'static str) -> Fault {
        Fault { kind: FaultKind::TooLarge, what: what.into(), place: place.into(), mend }
    }

    pub(super) fn empty(place: impl Into<String>, what: impl Into<String>) -> Fault {
        let mend = "export a mesh with faces; curves and points have no surface";
        Fault { kind: FaultKind::Empty, what: what.into(), place: place.into(), mend }
    }
}
