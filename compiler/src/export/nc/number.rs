//! The one number format of NC programs: a sign where needed, an integer part, exactly three decimals; never an
//! exponent, never `-0.000`.

/// A value in thousandths, rounded half away from zero. Values are bounded by the machine's checks.
pub(super) fn thousandths(value: f64) -> i64 {
    (value * 1000.0).round() as i64
}

/// `-12345` as `-12.345`.
pub(super) fn number(thousandths: i64) -> String {
    let sign = if thousandths < 0 { "-" } else { "" };
    let size = thousandths.unsigned_abs();
    format!("{sign}{}.{:03}", size / 1000, size % 1000)
}

/// A speed per second as text per minute: feeds in mm/min, spindle speeds in rpm.
pub(super) fn per_minute(per_second: f64) -> String {
    number(thousandths(per_second * 60.0))
}

/// A spindle speed per second as a whole number of rpm.
pub(super) fn whole_per_minute(per_second: f64) -> i64 {
    (per_second * 60.0).round() as i64
}
