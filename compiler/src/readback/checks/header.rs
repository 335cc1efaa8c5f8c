//! The header says what was asked for: design and its hash, stock, origin, Z zero, fixing, tools; and of each part in
//! order its address, alias, place, face up and notes.

use crate::fabricate::machine::{Fixing, Tool, ZZero};
use crate::readback::header::Entry;
use crate::readback::{Expected, ExpectedPart, Fault, FaultKind};

/// `tools`: those that the file uses. `first_line`: where what is missing is said to be missing.
pub(super) fn check(
    entries: &[Entry],
    tools: &[&Tool],
    first_line: usize,
    expected: &Expected,
    faults: &mut Vec<Fault>,
) {
    let mut reader =
        Reader { faults, line: first_line, fold: expected.machine.spec().dialect.profile().comment.capitals };
    let parts = entries.iter().position(|entry| entry.key == "address").unwrap_or(entries.len());
    let (whole, rest) = entries.split_at(parts);
    reader.whole(whole, expected);
    let mut said: Vec<&[Entry]> = Vec::new();
    let mut from = 0;
    for i in 1..=rest.len() {
        if i == rest.len() || rest[i].key == "address" {
            said.push(&rest[from..i]);
            from = i;
        }
    }
    if said.len() != expected.parts.len() {
        let what = format!("has {} parts, not {}", said.len(), expected.parts.len());
        reader.fault(first_line, what);
    }
    for (entries, part) in said.iter().zip(&expected.parts) {
        reader.part(entries, part);
    }
    reader.tools(rest, tools);
}

struct Reader<'f> {
    faults: &'f mut Vec<Fault>,
    line: usize,
    /// Whether capitals stand for small letters too.
    fold: bool,
}

impl Reader<'_> {
    fn fault(&mut self, line: usize, what: String) {
        self.faults.push(Fault::new(FaultKind::Header, line, format!("the header {what}")));
    }

    fn same(&self, said: &str, wanted: &str) -> bool {
        if self.fold { said.eq_ignore_ascii_case(wanted) } else { said == wanted }
    }

    /// Whether the entry is there and as wanted, by the words or by the numbers in them.
    fn says(&mut self, entries: &[Entry], key: &str, wanted: &str, numbers: bool) {
        match entries.iter().find(|entry| entry.key == key) {
            Some(entry) if self.same(&entry.value, wanted) => {}
            Some(entry) if numbers && near(&entry.value, wanted, self.fold) => {}
            Some(entry) => self.fault(entry.line, format!("says {key} {:?}, not {wanted:?}", entry.value)),
            None => self.fault(self.line, format!("does not say {key}")),
        }
    }

    fn whole(&mut self, entries: &[Entry], expected: &Expected) {
        let zero = match expected.machine.spec().z_zero {
            ZZero::TopOfStock => "top of stock",
            ZZero::Table => "table",
        };
        let fixing = match expected.machine.spec().fixing {
            Fixing::Held => "held by the table".to_owned(),
            Fixing::Tabs { count, width, height } => {
                format!("tabs {count} width {width:.3} height {height:.3}")
            }
            Fixing::OnionSkin { thickness } => format!("onion skin {thickness:.3}"),
        };
        let (design, hash) =
            expected.parts.first().map_or(("", ""), |part| (&part.job.design, &part.job.design_hash));
        let stock = format!("{:.3} x {:.3} x {:.3}", expected.stock.x, expected.stock.y, expected.thickness);
        if !expected.sheet.is_empty() {
            self.says(entries, "sheet", &expected.sheet, false);
        }
        self.says(entries, "design", design, false);
        self.says(entries, "design hash", hash, false);
        self.says(entries, "machine", &expected.machine.spec().name, false);
        self.says(entries, "stock", &stock, true);
        self.says(entries, "origin", "lower left of stock", false);
        self.says(entries, "z zero", zero, false);
        self.says(entries, "fixing", &fixing, true);
    }

    fn part(&mut self, entries: &[Entry], part: &ExpectedPart) {
        let (low, job) = (part.bounds().0, part.job);
        self.says(entries, "address", &job.address, false);
        self.says(entries, "alias", &job.alias, false);
        self.says(entries, "at", &format!("{:.3} x {:.3} turned {}", low.x, low.y, part.turned), true);
        self.says(entries, "face up", &job.face_up, false);
        let notes: Vec<&Entry> = entries.iter().filter(|e| e.key == "note").collect();
        let same = notes.iter().zip(&job.notes).all(|(entry, wanted)| self.same(&entry.value, wanted));
        if notes.len() != job.notes.len() || !same {
            let line = entries.first().map_or(self.line, |entry| entry.line);
            self.fault(line, format!("does not repeat the notes of {}", job.address));
        }
    }

    fn tools(&mut self, entries: &[Entry], tools: &[&Tool]) {
        let said: Vec<&Entry> = entries.iter().filter(|entry| entry.key == "tool").collect();
        if said.len() != tools.len() {
            self.fault(self.line, format!("names {} tools, {} are used", said.len(), tools.len()));
        }
        for (entry, tool) in said.iter().zip(tools) {
            let wanted = format!("{} diameter {:.3} name {}", tool.number, tool.diameter, tool.name);
            if !self.same(&entry.value, &wanted) && !near(&entry.value, &wanted, self.fold) {
                self.fault(entry.line, format!("says tool {:?}, not {wanted:?}", entry.value));
            }
        }
    }
}

/// Whether two texts are the same word by word, numbers to the third decimal whichever way a half was rounded.
fn near(said: &str, wanted: &str, fold: bool) -> bool {
    let same = |(a, b): (&str, &str)| match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) => (a - b).abs() < 0.0015,
        _ if fold => a.eq_ignore_ascii_case(b),
        _ => a == b,
    };
    let (said, wanted): (Vec<&str>, Vec<&str>) = (said.split(' ').collect(), wanted.split(' ').collect());
    said.len() == wanted.len() && said.into_iter().zip(wanted).all(same)
}
