//! The dialects of NC text as data: which words there are, and how a program is framed, timed and commented. Nothing is
//! written or read here; `export::nc` writes by these profiles, `readback` judges by them.
//!
//! Sources: LinuxCNC's G-code reference; the interfacing and supported-codes pages of Grbl 1.1; FANUC's operator's
//! manuals of the machining-centre series (0i, 30i).

/// The dialect of NC text a machine reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialect {
    /// LinuxCNC's RS274/NGC.
    LinuxCnc,
    /// Grbl 1.1: no tool change, so one program a tool.
    Grbl,
    /// FANUC machining centres: numbered programs between percent signs.
    Fanuc,
}

/// How a tool's length is taken into account.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LengthOffset {
    /// Not by the program: the operator sets Z zero with each tool.
    ByHand,
    /// `G43 H1` in a line of its own.
    OwnLine,
    /// In the line of the first motion: a G43 alone would move the axis by the offset.
    WithMotion,
}

/// What the number of a dwell counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DwellUnit {
    /// `G4 P3.000`
    Seconds,
    /// `G4 P3000`
    Milliseconds,
}

/// What may stand between the parentheses of a comment.
#[derive(Debug, PartialEq, Eq)]
pub struct CommentRule {
    /// Whether letters are capitals only.
    pub capitals: bool,
    /// Printable characters that would end or steer the comment, or the machine: they are written as their code points.
    pub forbidden: &'static str,
    /// What stands before and after a code point in hexadecimal digits.
    pub escape: (char, char),
}

/// What sets a dialect apart.
#[derive(Debug, PartialEq, Eq)]
pub struct Profile {
    /// As the language says it.
    pub name: &'static str,
    /// The G codes there are.
    pub g_codes: &'static [u8],
    /// The M codes there are.
    pub m_codes: &'static [u8],
    /// All other letters of words.
    pub letters: &'static str,
    /// The G codes that are set before the first motion, beside the work offset.
    pub modes: &'static [u8],
    /// Whether a program changes tools (`T1 M6`); else there is one program a tool.
    pub changes_tools: bool,
    /// How lengths of tools are taken into account.
    pub length_offset: LengthOffset,
    /// The M code that ends a program.
    pub end: u8,
    /// Whether a program lies between lines `%` and begins with its number, `O0001`.
    pub numbered: bool,
    /// What a dwell counts.
    pub dwell: DwellUnit,
    /// Whether spindle speeds are whole numbers.
    pub whole_spindle_speed: bool,
    /// Comments.
    pub comment: CommentRule,
}

/// The greatest program number; those above are commonly kept for the machine's maker.
pub const LAST_PROGRAM_NUMBER: u32 = 7999;

static LINUXCNC: Profile = Profile {
    name: "linuxcnc",
    g_codes: &[0, 1, 2, 3, 4, 17, 21, 40, 43, 49, 54, 55, 56, 57, 58, 59, 80, 90, 94],
    m_codes: &[2, 3, 5, 6],
    letters: "XYZIJFSPTH",
    modes: &[21, 17, 90, 94, 40, 49, 80],
    changes_tools: true,
    length_offset: LengthOffset::OwnLine,
    end: 2,
    numbered: false,
    dwell: DwellUnit::Seconds,
    whole_spindle_speed: false,
    comment: CommentRule { capitals: false, forbidden: "(){}%;\\", escape: ('{', '}') },
};

static GRBL: Profile = Profile {
    name: "grbl",
    g_codes: &[0, 1, 2, 3, 4, 17, 21, 40, 49, 54, 55, 56, 57, 58, 59, 80, 90, 94],
    m_codes: &[2, 3, 5],
    letters: "XYZIJFSP",
    modes: &[21, 17, 90, 94, 40, 49, 80],
    changes_tools: false,
    length_offset: LengthOffset::ByHand,
    end: 2,
    numbered: false,
    dwell: DwellUnit::Seconds,
    whole_spindle_speed: false,
    // The last four are commands in real time: Grbl takes them out of the stream wherever they stand.
    comment: CommentRule { capitals: false, forbidden: "(){}%;\\$?~!", escape: ('{', '}') },
};

static FANUC: Profile = Profile {
    name: "fanuc",
    g_codes: &[0, 1, 2, 3, 4, 17, 21, 40, 43, 49, 54, 55, 56, 57, 58, 59, 80, 90, 94],
    m_codes: &[3, 5, 6, 30],
    letters: "XYZIJFSPTH",
    modes: &[21, 17, 90, 94, 40, 49, 80],
    changes_tools: true,
    length_offset: LengthOffset::WithMotion,
    end: 30,
    numbered: true,
    dwell: DwellUnit::Milliseconds,
    whole_spindle_speed: true,
    // Beyond capitals, figures and these signs, a control may have no character.
    comment: CommentRule { capitals: true, forbidden: "()[]{}%;\\^`|~!_", escape: ('[', ']') },
};

impl Dialect {
    /// All of them.
    pub const ALL: [Dialect; 3] = [Dialect::LinuxCnc, Dialect::Grbl, Dialect::Fanuc];

    /// Its rules.
    #[must_use]
    pub fn profile(self) -> &'static Profile {
        match self {
            Dialect::LinuxCnc => &LINUXCNC,
            Dialect::Grbl => &GRBL,
            Dialect::Fanuc => &FANUC,
        }
    }

    /// The dialect of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Dialect> {
        Dialect::ALL.into_iter().find(|dialect| dialect.profile().name == name)
    }
}
