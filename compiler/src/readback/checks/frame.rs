//! Where a dialect numbers programs, a line `%` comes first and last, and `O` with the program's number second; elsewhere
//! there is neither.

use crate::fabricate::machine::LAST_PROGRAM_NUMBER;
use crate::readback::lines::Line;
use crate::readback::{Expected, Fault, FaultKind};

pub(super) fn check(lines: &[Line], expected: &Expected, faults: &mut Vec<Fault>) {
    let mut fault = |line: usize, message: String| {
        faults.push(Fault::new(FaultKind::ProgramFrame, line, message));
    };
    let numbers = |line: &Line| line.words.iter().any(|word| word.letter == b'O');
    if !expected.machine.spec().dialect.profile().numbered {
        // There a number is an unknown word, and a percent sign none at all: both are reported as such.
        return;
    }
    let (first, last) = (lines.first().map_or(0, |l| l.number), lines.last().map_or(0, |l| l.number));
    let percents: Vec<usize> = lines.iter().filter(|line| line.percent).map(|line| line.number).collect();
    if percents != [first, last] || first == last {
        fault(first, format!("has lines % at {percents:?}, not one first and one last"));
    }
    let wanted = (expected.number.max(1) - 1) % LAST_PROGRAM_NUMBER + 1;
    let said = lines.get(1).filter(|line| line.words.len() == 1).and_then(|line| line.words.first());
    match said.filter(|word| word.letter == b'O' && !word.point) {
        Some(word) if word.whole() == Some(i64::from(wanted)) => {}
        Some(word) => fault(first + 1, format!("has the number {}, not {wanted}", word.value())),
        None => fault(first + 1, format!("does not say its number, O{wanted:04}")),
    }
    for line in lines.iter().skip(2).filter(|line| numbers(line)) {
        fault(line.number, "says a program's number again".to_owned());
    }
}
