//! The header says what the job says: address, alias, design and its hash, stock, origin, Z zero, face up, notes.

use crate::fabricate::machine::ZZero;
use crate::readback::header::Entry;
use crate::readback::{Expected, Fault, FaultKind};

pub(super) fn check(entries: &[Entry], expected: &Expected, faults: &mut Vec<Fault>) {
    let job = expected.job;
    let stock = format!("{:.3} x {:.3} x {:.3}", expected.stock.x, expected.stock.y, job.thickness);
    let zero = match expected.machine.spec().z_zero {
        ZZero::TopOfStock => "top of stock",
        ZZero::Table => "table",
    };
    let said: [(&str, &str); 7] = [
        ("address", &job.address),
        ("alias", &job.alias),
        ("design", &job.design),
        ("design hash", &job.design_hash),
        ("origin", "lower left of stock"),
        ("z zero", zero),
        ("face up", &job.face_up),
    ];
    for (key, value) in said {
        match entries.iter().find(|entry| entry.key == key) {
            Some(entry) if entry.value == value => {}
            Some(entry) => push(faults, entry.line, format!("says {key} {:?}, not {value:?}", entry.value)),
            None => push(faults, 1, format!("does not say {key}")),
        }
    }
    match entries.iter().find(|entry| entry.key == "stock") {
        Some(entry) if near(&entry.value, &stock) => {}
        Some(entry) => push(faults, entry.line, format!("says stock {}, not {stock}", entry.value)),
        None => push(faults, 1, "does not say stock".to_owned()),
    }
    let notes: Vec<&str> = entries.iter().filter(|e| e.key == "note").map(|e| e.value.as_str()).collect();
    if notes != job.notes.iter().map(String::as_str).collect::<Vec<_>>() {
        push(faults, 1, "does not repeat the job's notes".to_owned());
    }
}

/// Whether two sizes, `a x b x c`, are the same to the third decimal, whichever way a half was rounded.
fn near(said: &str, wanted: &str) -> bool {
    let sizes = |text: &str| text.split(" x ").map(str::parse::<f64>).collect::<Result<Vec<f64>, _>>();
    match (sizes(said), sizes(wanted)) {
        (Ok(a), Ok(b)) => a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 0.0015),
        _ => false,
    }
}

fn push(faults: &mut Vec<Fault>, line: usize, what: String) {
    faults.push(Fault::new(FaultKind::Header, line, format!("the header {what}")));
}
