//! The number format, escaping, wrapping, and the golden text of one small board.

use super::header;
use super::number::{number, per_minute, thousandths};
use crate::fabricate::machine::{Dialect, Machine};
use crate::fabricate::toolpath::Program;
use crate::fabricate::toolpath::program;
use crate::fabricate::toolpath::tests::{machine, panel, shaped};

fn comment(text: &str) -> String {
    header::comment(text, Dialect::LinuxCnc.profile())
}

fn write(program: &Program, machine: &Machine) -> String {
    let files = super::write(program, machine);
    assert_eq!((files.len(), files[0].tool), (1, None));
    files[0].text.clone()
}

#[test]
fn numbers_have_three_decimals_and_no_minus_zero() {
    let text = |value: f64| number(thousandths(value));
    assert_eq!(text(0.0), "0.000");
    assert_eq!(text(-0.0004), "0.000");
    assert_eq!(text(-0.0005), "-0.001");
    assert_eq!(text(-12.3456), "-12.346");
    assert_eq!(text(99_999.999_9), "100000.000");
    assert_eq!(text(1e-300), "0.000");
    assert_eq!(per_minute(4000.0 / 60.0), "4000.000");
}

#[test]
fn names_cannot_end_or_steer_a_comment() {
    assert_eq!(comment("design: a) G0 Z-50 (b"), "(design: a{29} G0 Z-50 {28}b)\n");
    assert_eq!(comment("design: Hüttchen\n%"), "(design: H{fc}ttchen{a}{25})\n");
    assert_eq!(comment(""), "()\n");
}

#[test]
fn long_comments_go_on_and_join_to_the_same_text() {
    for text in ["word ".repeat(60), "x".repeat(500), format!("{} y", "x".repeat(66)), "z".repeat(66)] {
        let lines = comment(&text);
        assert!(lines.lines().all(|l| l.len() < 70));
        let inner = lines.lines().enumerate().map(|(i, l)| &l[if i == 0 { 1 } else { 3 }..l.len() - 1]);
        assert_eq!(inner.collect::<String>(), text);
    }
}

#[test]
fn golden_text_of_a_small_board() {
    let mut job = shaped(&[(0.0, 0.0), (60.0, 0.0), (55.0, 40.0), (5.0, 40.0)]);
    job.alias = "a-1".to_owned();
    job.thickness = 4.0;
    let made = program(&job, &machine()).unwrap();
    assert_eq!(write(&made, &machine()), include_str!("golden.nc"));
}

#[test]
fn the_same_job_gives_the_same_bytes() {
    let text = || write(&program(&panel(), &machine()).unwrap(), &machine());
    assert_eq!(text(), text());
}
