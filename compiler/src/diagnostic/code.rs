//! The table of codes: every diagnostic there is, declared once, with its page of documentation.

/// How grave a diagnostic is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// The design cannot be built.
    Error,
    /// The design can be built, but it may not be what was meant.
    Warning,
}

macro_rules! codes {
    ($($code:ident $severity:ident $title:literal,)*) => {
        /// The code of a diagnostic; stable for ever.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Code {
            $(#[doc = $title] $code,)*
        }

        impl Code {
            /// Every code, in order.
            pub const ALL: &[Code] = &[$(Code::$code,)*];

            /// The code as it is printed.
            pub fn name(self) -> &'static str {
                match self { $(Code::$code => stringify!($code),)* }
            }

            /// How grave it is.
            pub fn severity(self) -> Severity {
                match self { $(Code::$code => Severity::$severity,)* }
            }

            /// What it says, in one line.
            pub fn title(self) -> &'static str {
                match self { $(Code::$code => $title,)* }
            }

            /// Its page of documentation, Markdown.
            pub fn page(self) -> &'static str {
                match self {
                    $(Code::$code => include_str!(concat!("../../../docs/diagnostics/", stringify!($code), ".md")),)*
                }
            }
        }
    };
}

codes! {
    // Not in the language yet.
    E0001 Error "this part of the language is not available yet",

    // Text and tokens.
    E0101 Error "the file is not UTF-8 text",
    E0102 Error "a character that the language does not use",
    E0103 Error "a text without its closing quote",
    E0104 Error "a number that is too large or too long",
    E0105 Error "an unknown unit",
    E0106 Error "a bidirectional control character",
    E0107 Error "brackets nested too deeply",
    E0108 Error "the file is too large",

    // Grammar.
    E0201 Error "something else was expected here",
    E0202 Error "a bracket that is never closed",
    E0203 Error "a closing bracket that opens nothing",
    E0204 Error "`//!` after the first item",
    E0205 Error "a name in the wrong case",
    E0206 Error "an unknown measure in a requirement",

    // Names and modules.
    E0301 Error "an unknown name",
    E0302 Error "a name that is declared twice",
    E0303 Error "an unknown module",
    E0304 Error "a module has no such public item",
    E0305 Error "a definition that depends on itself",
    E0306 Error "a file that cannot be read",
    W0307 Warning "an import that is never used",
    W0308 Warning "a name of the library that is not imported",
    E0310 Error "a path that names no file of the project",
    E0311 Error "files that use each other in a circle",
    E0312 Error "more files than the limit",
    E0313 Error "an `ifs.toml` that cannot be read",
    E0314 Error "an unknown key in `ifs.toml`",
    E0315 Error "a value in `ifs.toml` that cannot be used",
    W0316 Warning "a parameter in `ifs.toml` that the design does not have",

    // Types and dimensions.
    E0401 Error "a value of another type is needed here",
    E0402 Error "an operator does not fit its operands",
    E0403 Error "a missing argument or field",
    E0404 Error "an argument or field that does not exist",
    E0405 Error "an argument or field given twice",
    E0406 Error "too many arguments",
    E0407 Error "there is no such field",
    E0408 Error "something that cannot be called",
    E0409 Error "an unknown type",
    E0410 Error "the elements of a list differ in type",
    E0411 Error "an unknown choice",

    // Affine weights and iterated function systems.
    E0501 Error "weights that do not sum to 1",
    E0502 Error "weights that do not sum to 0 where a vector is needed",
    E0503 Error "a transform lists the wrong number of control points",
    E0504 Error "an ifs is placed on the wrong number of control points",
    E0505 Error "the pieces of a curve or a surface do not meet",
    E0506 Error "neighbouring windows of a sheet do not meet",
    E0507 Error "an ifs without germ or without transforms",
    W0508 Warning "the transforms do not contract: there is no limit figure",
    W0509 Warning "the contraction could not be proved",
    E0510 Error "a control net of the wrong shape",
    E0520 Error "a weight that is not above 0",
    E0521 Error "scales that do not fit the rail",
    E0522 Error "a profile that cannot be turned round its axis",
    E0523 Error "a vertex at infinity",
    E0524 Error "a closed figure of fewer than three elements",
    W0525 Warning "planarizing what is planar by construction",
    E0530 Error "plane and space do not mix in a map",
    E0531 Error "an ifs used in a way that is not that of its space",
    E0532 Error "a germ that does not lie in the space of its ifs",
    E0533 Error "an ifs without the germ it is to find itself",
    E0534 Error "a family of transforms that cannot be counted out",
    E0535 Error "a germ whose shape or measure is impossible",
    E0536 Error "arguments that make no map",
    E0537 Error "a transform of the plane or of space that continues with nothing",
    E0538 Error "a list of control points that cannot be counted out",
    E0550 Error "an unknown measure after `until`",
    E0551 Error "`until` without a largest size",
    E0552 Error "no level fits between the smallest and the largest size",
    E0553 Error "`each until` where elements are joined",
    E0554 Error "elements that have no such size",
    E0555 Error "a mesh whose faces do not fit its points",
    E0556 Error "a file that gives no mesh",
    E0557 Error "the path of a mesh that is not written out",
    E0558 Error "a mesh beyond a limit",

    // Boundaries and stated joins.
    E0540 Error "a join names what is not there",
    E0541 Error "a boundary on the wrong points",
    E0542 Error "a stated join does not hold",
    E0543 Error "a join of things that cannot be compared",
    E0544 Error "a stated join could not be proved",
    E0545 Error "a join leaves open which piece is meant",
    W0546 Warning "a join holds only to within rounding",

    // Values.
    E0601 Error "a parameter out of its range",
    E0602 Error "an index out of range",
    E0603 Error "a division by zero",
    E0604 Error "a value outside the domain of a function",
    E0605 Error "an unknown parameter is set",
    E0606 Error "a text that is no value of the parameter's type",
    E0607 Error "a range that is empty or has no end",
    W0608 Warning "a requirement that measures nothing",

    // Limits.
    E0701 Error "more elements than the limit",
    E0702 Error "more states than the limit",
    E0703 Error "an evaluation longer than the limit",
    E0704 Error "a list longer than the limit",
    E0705 Error "a size that is not reached within the limit",
    E0706 Error "a branch that does not get small enough",
    E0707 Error "a figure too large to be built",

    // Figures and fabrication.
    E0801 Error "a figure without a level",
    E0802 Error "a figure that cannot be made of these elements",
    E0803 Error "a figure that is fabricated twice",
    E0804 Error "a setting that cannot be used",
    E0805 Error "a board that cannot be made",
    E0806 Error "a requirement that does not apply to these elements",
    E0807 Error "a design without figures is built",
    E0810 Error "`require planarity` fails",
    E0811 Error "`require edge` fails",
    E0812 Error "`require length` fails",
    E0813 Error "`require mitre` fails",
    E0814 Error "`require overlap` fails",
    E0815 Error "`require bend radius` fails",
    E0816 Error "`require fold` fails",
    E0817 Error "`require diagonal ratio` fails",
    E0818 Error "`require width` fails",
    E0819 Error "`require area` fails",
    E0820 Error "a setting of the other method of planarizing",
    W0826 Warning "planarizing moved vertices far",
    W0827 Warning "planarizing did not reach its aim",
    E0830 Error "`require angle` fails",
    E0831 Error "`require bevel` fails",
    E0832 Error "`require mass` fails",
    E0833 Error "`require count` fails",
    E0834 Error "elements larger than the raw board or bar",
    E0835 Error "two requirements that exclude each other",
    E0836 Error "a requirement that nothing can hold",

    // End cuts and edges.
    E0850 Error "an end cut that the machine cannot make",

    // A machine that is named from outside.
    E0860 Error "a machine whose file cannot be read",
    E0861 Error "a machine that its file does not have",
    E0862 Error "something other than a machine",

    // NC programs.
    E0901 Error "an NC program that cannot be made",
    E0902 Error "an NC program that its read-back refuses",
    W0903 Warning "a program for a larger piece than the raw board",

    // Nesting.
    E0930 Error "margins that leave no room",
    E0931 Error "a nest too tight for its tool",
    W0932 Warning "a part that is too large to be nested",
    E0933 Error "planks nested without a length of stock",
    E0934 Error "a nest that its check refuses",
    E0935 Error "a sheet that its machine cannot cut",
    E0936 Error "the program of a sheet that its read-back refuses",

    // Tests.
    E1001 Error "an assertion that fails",
    E1002 Error "something that cannot be asked of a figure here",
}

impl Code {
    /// The code of this name, in either case.
    pub fn parse(name: &str) -> Option<Code> {
        Code::ALL.iter().copied().find(|code| code.name().eq_ignore_ascii_case(name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_page_names_its_code_and_shows_a_mend() {
        for code in Code::ALL {
            let page = code.page();
            let heading = format!("# {}: {}", code.name(), code.title());
            assert!(page.starts_with(&heading), "the page of {} starts with `{heading}`", code.name());
            assert!(page.contains("## How to mend it"), "the page of {} says how to mend it", code.name());
        }
    }
}
