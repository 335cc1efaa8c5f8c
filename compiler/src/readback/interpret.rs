//! The modal state machine: what a machine of the dialect does with the words of each line. It judges only what keeps it
//! from understanding; whether the motion is safe and right is judged in `checks`.

use super::fault::{Fault, FaultKind};
use super::geometry::Piece;
use super::lines::{Line, Word};
use crate::fabricate::machine::{DwellUnit, Profile};
use glam::{DVec2, DVec3};

/// How a move is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motion {
    /// G0.
    Rapid,
    /// G1.
    Straight,
    /// G2 or G3.
    Arc {
        /// Centre, mm.
        centre: DVec2,
        /// G2.
        clockwise: bool,
    },
}

/// One motion and the machine's state in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Move {
    /// Line of the program, from 1.
    pub line: usize,
    /// How.
    pub motion: Motion,
    /// Start per axis, mm; `None` where the machine's position is not known: at the start and after a tool change.
    pub from: [Option<f64>; 3],
    /// End per axis, mm.
    pub to: [Option<f64>; 3],
    /// Feed, mm/min.
    pub feed: Option<f64>,
    /// Loaded tool.
    pub tool: Option<u32>,
    /// Active length offset.
    pub offset: Option<u32>,
    /// Spindle speed in rpm while it turns.
    pub spindle: Option<f64>,
    /// Seconds waited since the spindle was started.
    pub waited: f64,
}

impl Move {
    /// The path of a feed motion between known positions.
    #[must_use]
    pub fn piece(&self) -> Option<Piece> {
        let point = |axes: [Option<f64>; 3]| Some(DVec3::new(axes[0]?, axes[1]?, axes[2]?));
        let (from, to) = (point(self.from)?, point(self.to)?);
        match self.motion {
            Motion::Rapid => None,
            Motion::Straight => Some(Piece::straight(from, to)),
            Motion::Arc { centre, clockwise } => Some(Piece::arc(from, to, centre, clockwise)),
        }
    }
}

/// What happens, in order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// A motion.
    Move(Move),
    /// M6, with whether the spindle was turning and the height then, if known.
    ToolChange {
        /// Line of the program.
        line: usize,
        /// Whether the spindle was turning.
        turning: bool,
        /// Height, mm.
        z: Option<f64>,
    },
    /// M2 or M30.
    End {
        /// Line of the program.
        line: usize,
    },
}

/// A program as it happens.
#[derive(Clone, Debug, Default)]
pub(super) struct Trace {
    pub(super) events: Vec<Event>,
    /// The G codes said before the first motion.
    pub(super) modes: Vec<i64>,
    /// Mode codes said after it, each with its line.
    pub(super) late_modes: Vec<(usize, i64)>,
    /// The spindle's speed at the end, if it still turns.
    pub(super) turning_at_end: Option<f64>,
    /// Height at the end.
    pub(super) last_z: Option<f64>,
}

impl Trace {
    pub(super) fn moves(&self) -> impl Iterator<Item = &Move> {
        self.events.iter().filter_map(|event| if let Event::Move(m) = event { Some(m) } else { None })
    }
}

struct State {
    /// The M code that ends a program.
    end: i64,
    /// Seconds in one count of a dwell.
    dwell: f64,
    at: [Option<f64>; 3],
    motion: Option<i64>,
    feed: Option<f64>,
    selected: Option<u32>,
    tool: Option<u32>,
    offset: Option<u32>,
    speed: Option<f64>,
    turning: bool,
    waited: f64,
}

/// Runs the lines from a machine whose position is not known, with `tool` in where tools are put in by hand.
pub(super) fn interpret(
    lines: &[Line],
    profile: &Profile,
    tool: Option<u32>,
    faults: &mut Vec<Fault>,
) -> Trace {
    let mut state = State {
        end: i64::from(profile.end),
        dwell: match profile.dwell {
            DwellUnit::Seconds => 1.0,
            DwellUnit::Milliseconds => 0.001,
        },
        at: [None; 3],
        motion: None,
        feed: None,
        selected: None,
        tool,
        offset: None,
        speed: None,
        turning: false,
        waited: 0.0,
    };
    let mut trace = Trace::default();
    // A program's number is judged with its frame.
    let number = |line: &Line| profile.numbered && line.words.iter().all(|word| word.letter == b'O');
    for line in lines.iter().filter(|line| line.comment.is_none() && !line.percent && !number(line)) {
        let allowed = dialect_words(line, profile, faults);
        state.run(line.number, &Words(allowed), &mut trace, faults);
    }
    trace.turning_at_end = state.speed.filter(|_| state.turning);
    trace.last_z = state.at[2];
    trace
}

/// The words of a line.
struct Words(Vec<Word>);

impl Words {
    fn get(&self, letter: u8) -> Option<Word> {
        self.0.iter().copied().find(|w| w.letter == letter)
    }

    fn codes(&self, letter: u8) -> impl Iterator<Item = i64> {
        self.0.iter().filter(move |w| w.letter == letter).filter_map(|w| w.whole())
    }
}

/// The allow-list: G and M codes by number, other letters once in a line, with or without a point as they must be.
fn dialect_words(line: &Line, profile: &Profile, faults: &mut Vec<Fault>) -> Vec<Word> {
    let listed = |codes: &[u8], word: Word| {
        !word.point && word.whole().is_some_and(|n| codes.iter().any(|&code| i64::from(code) == n))
    };
    let mut out: Vec<Word> = Vec::new();
    for &word in &line.words {
        let pause = profile.dwell == DwellUnit::Seconds;
        let known = match word.letter {
            b'G' => listed(profile.g_codes, word),
            b'M' => listed(profile.m_codes, word),
            letter if !profile.letters.as_bytes().contains(&letter) => false,
            b'T' | b'H' => !word.point && word.whole().is_some_and(|n| n > 0),
            b'X' | b'Y' | b'Z' | b'I' | b'J' => word.point,
            b'F' => word.point && word.thousandths >= 0,
            b'S' => word.point != profile.whole_spindle_speed && word.thousandths >= 0,
            b'P' => word.point == pause && word.thousandths >= 0,
            _ => false,
        };
        let letter = char::from(word.letter);
        let repeated = out.iter().any(|w| {
            w.letter == word.letter
                && (!matches!(word.letter, b'G' | b'M') || w.thousandths == word.thousandths)
        });
        if !known || repeated {
            let what = if known { "repeats" } else { "has, unknown to the dialect," };
            let message = format!("{what} {letter}{}", word.value());
            faults.push(Fault::measured(FaultKind::Word, line.number, word.value(), message));
        } else {
            out.push(word);
        }
    }
    let conflicting =
        |codes: &[i64]| Words(out.clone()).codes(b'G').filter(|c| codes.contains(c)).count() > 1;
    if conflicting(&[0, 1, 2, 3, 4]) {
        faults.push(Fault::new(FaultKind::Word, line.number, "has two motions"));
    }
    out
}

impl State {
    /// In LinuxCNC's order of execution: feed, speed, tool, spindle, dwell, modes, motion, end.
    fn run(&mut self, line: usize, words: &Words, trace: &mut Trace, faults: &mut Vec<Fault>) {
        self.feed = words.get(b'F').map(Word::value).or(self.feed);
        self.speed = words.get(b'S').map(Word::value).or(self.speed);
        let whole = |letter: u8| words.get(letter).and_then(Word::whole).and_then(|n| u32::try_from(n).ok());
        self.selected = whole(b'T').or(self.selected);
        for code in words.codes(b'M') {
            match code {
                6 => {
                    trace.events.push(Event::ToolChange { line, turning: self.turning, z: self.at[2] });
                    (self.tool, self.offset, self.at, self.turning) = (self.selected, None, [None; 3], false);
                }
                3 => (self.turning, self.waited) = (true, 0.0),
                5 => self.turning = false,
                _ => {}
            }
        }
        let mut dwell = false;
        for code in words.codes(b'G') {
            match code {
                0..=3 => self.motion = Some(code),
                4 => dwell = true,
                43 => self.offset = whole(b'H'),
                49 => self.offset = None,
                80 => self.motion = None,
                _ => {}
            }
            if trace.moves().next().is_none() {
                trace.modes.push(code);
            } else if !matches!(code, 0..=4 | 43) {
                trace.late_modes.push((line, code));
            }
        }
        if dwell {
            self.waited += words.get(b'P').map_or(0.0, Word::value) * self.dwell;
        } else if [b'X', b'Y', b'Z'].into_iter().any(|axis| words.get(axis).is_some()) {
            self.go(line, words, trace, faults);
        }
        if words.codes(b'M').any(|code| code == self.end) {
            trace.events.push(Event::End { line });
        }
    }

    fn go(&mut self, line: usize, words: &Words, trace: &mut Trace, faults: &mut Vec<Fault>) {
        let from = self.at;
        for (axis, letter) in [b'X', b'Y', b'Z'].into_iter().enumerate() {
            self.at[axis] = words.get(letter).map(Word::value).or(self.at[axis]);
        }
        let motion = match (self.motion, from) {
            (Some(0), _) => Motion::Rapid,
            (Some(1), _) => Motion::Straight,
            (Some(code), [Some(x), Some(y), _]) => {
                let offset = |letter: u8| words.get(letter).map_or(0.0, Word::value);
                let centre = DVec2::new(x + offset(b'I'), y + offset(b'J'));
                Motion::Arc { centre, clockwise: code == 2 }
            }
            _ => {
                faults.push(Fault::new(
                    FaultKind::UnknownPosition,
                    line,
                    "moves without a motion or a position",
                ));
                return;
            }
        };
        let spindle = self.speed.filter(|_| self.turning);
        let (feed, tool, offset, waited) = (self.feed, self.tool, self.offset, self.waited);
        trace.events.push(Event::Move(Move {
            line,
            motion,
            from,
            to: self.at,
            feed,
            tool,
            offset,
            spindle,
            waited,
        }));
    }
}
