//! Several parts on one sheet: good ones pass in every dialect, and a part that is not where it should be is found.

use super::*;
use crate::fabricate::cut_job::{Placed, Rotation, Sheet};
use crate::fabricate::toolpath::sheet;

const ROTATIONS: [Rotation; 4] = [Rotation::None, Rotation::Quarter, Rotation::Half, Rotation::ThreeQuarters];

fn jobs() -> Vec<CutJob> {
    let shapes: [&[(f64, f64)]; 4] = [
        &[(0.0, 0.0), (250.0, 10.0), (240.0, 235.0), (-12.0, 228.0)],
        &[(0.0, 0.0), (400.0, 0.0), (380.0, 120.0), (15.0, 120.0)],
        &[(0.0, 0.0), (200.0, 0.0), (180.0, 150.0), (10.0, 140.0)],
        &[(0.0, 0.0), (260.0, 20.0), (230.0, 130.0), (30.0, 160.0)],
    ];
    let job = |(i, corners): (usize, &&[(f64, f64)])| {
        let mut job = shaped(corners);
        (job.address, job.alias) = (format!("shell.{i}"), format!("shell-{i}"));
        job
    };
    shapes.iter().enumerate().map(job).collect()
}

/// The jobs beside each other, turned in all ways, `gap` apart.
fn laid(jobs: &[CutJob], gap: f64) -> Sheet<'_> {
    let mut parts = Vec::new();
    let mut x = 20.0;
    for (job, rotation) in jobs.iter().zip(ROTATIONS) {
        let turned: Vec<DVec2> = job.outline.iter().map(|&p| rotation.turn(p)).collect();
        let wide = turned.iter().fold((f64::MAX, f64::MIN), |(low, high), p| (low.min(p.x), high.max(p.x)));
        parts.push(Placed { job, rotation, low: DVec2::new(x, 20.0) });
        x += wide.1 - wide.0 + gap;
    }
    Sheet { name: "plywood.1".to_owned(), number: 7, stock: DVec2::new(x + 20.0, 460.0), parts }
}

#[test]
fn a_sheet_reads_back_as_its_parts() {
    let jobs = jobs();
    for dialect in Dialect::ALL {
        for (gap, fixing) in [
            (6.0, Fixing::Held),
            (12.0, Fixing::Tabs { count: 4, width: 8.0, height: 3.0 }),
            (6.0, Fixing::OnionSkin { thickness: 0.4 }),
        ] {
            let machine = Machine::try_new(MachineSpec { dialect, fixing, ..router() }).unwrap();
            let sheet_of_four = laid(&jobs, gap);
            let made = sheet(&sheet_of_four, &machine).unwrap();
            let files = nc::write(&made, &machine);
            let read = read_back_set(&texts(&files), &Expected::of_sheet(&sheet_of_four, &machine));
            let read = read.unwrap_or_else(|faults| panic!("{dialect:?} {fixing:?}: {faults:?}"));
            let engraved: Vec<&str> = read.parts.iter().map(|part| part.engraved.as_str()).collect();
            assert_eq!(engraved, ["shell-0", "shell-1", "shell-2", "shell-3"]);
            assert!(read.parts.iter().all(|part| part.deviation < 0.005));
        }
    }
}

#[test]
fn all_engraving_comes_before_all_contours() {
    let (jobs, machine) = (jobs(), Machine::try_new(router()).unwrap());
    let made = sheet(&laid(&jobs, 10.0), &machine).unwrap();
    let text = nc::write(&made, &machine).remove(0).text;
    assert_eq!(text.matches("(engraving").count(), 4);
    assert_eq!(text.matches("M6").count(), 2);
    assert!(text.rfind("(engraving").unwrap() < text.find("(outer contour").unwrap());
}

#[test]
fn a_part_that_is_not_where_it_should_be_is_found() {
    let (jobs, machine) = (jobs(), Machine::try_new(router()).unwrap());
    let good = laid(&jobs, 10.0);
    let text = nc::write(&sheet(&good, &machine).unwrap(), &machine).remove(0).text;
    let kinds = |other: &Sheet| -> Vec<FaultKind> {
        let faults = read_back(&text, &Expected::of_sheet(other, &machine)).unwrap_err();
        faults.iter().map(|fault| fault.kind).collect()
    };
    let mut moved = good.clone();
    moved.parts[2].low.y += 0.02;
    let found = kinds(&moved);
    assert!(found.contains(&FaultKind::Gouge) && found.contains(&FaultKind::Uncut), "{found:?}");
    let mut turned = good.clone();
    turned.parts[0].rotation = Rotation::Half;
    assert!(kinds(&turned).contains(&FaultKind::Uncut));
    let mut swapped = good.clone();
    (swapped.parts[0].job, swapped.parts[1].job) = (swapped.parts[1].job, swapped.parts[0].job);
    assert!(kinds(&swapped).contains(&FaultKind::Header));
    let mut fewer = good.clone();
    fewer.parts.pop();
    assert!(kinds(&fewer).contains(&FaultKind::Header));
}

/// What becomes of a place.
type Change = fn(f64, f64) -> (f64, f64);

/// The program with the X and Y of the contour of one part changed, counted from 0; or without that contour.
fn contour_changed(text: &str, part: usize, change: Option<Change>) -> String {
    let mut contours = 0;
    let mut out = String::new();
    for line in text.lines() {
        contours += usize::from(line.starts_with("(outer contour"));
        let ends = line.starts_with('M');
        if contours != part + 1 || ends {
            out += &format!("{line}\n");
            continue;
        }
        let Some(change) = change else { continue };
        let number = |letter: char| -> Option<f64> {
            line.split(' ').find_map(|word| word.strip_prefix(letter)).and_then(|value| value.parse().ok())
        };
        let moved = number('X').zip(number('Y')).map(|(x, y)| change(x, y));
        let words = line.split(' ').map(|word| match (word.as_bytes()[0], moved) {
            (b'X', Some((x, _))) => format!("X{x:.3}"),
            (b'Y', Some((_, y))) => format!("Y{y:.3}"),
            _ => word.to_owned(),
        });
        out += &format!("{}\n", words.collect::<Vec<_>>().join(" "));
    }
    out
}

#[test]
fn a_program_that_cuts_a_part_elsewhere_is_found() {
    let (jobs, machine) = (jobs(), Machine::try_new(router()).unwrap());
    let good = laid(&jobs, 10.0);
    let text = nc::write(&sheet(&good, &machine).unwrap(), &machine).remove(0).text;
    let expected = Expected::of_sheet(&good, &machine);
    assert!(read_back(&contour_changed(&text, 1, Some(|x, y| (x, y))), &expected).is_ok());
    let kinds = |text: &str| -> Vec<FaultKind> {
        read_back(text, &expected).unwrap_err().iter().map(|fault| fault.kind).collect()
    };
    let moved = kinds(&contour_changed(&text, 1, Some(|x, y| (x + 0.05, y))));
    assert!(moved.contains(&FaultKind::Gouge) && moved.contains(&FaultKind::Uncut), "moved: {moved:?}");
    let overlapped = kinds(&contour_changed(&text, 1, Some(|x, y| (x - 40.0, y))));
    assert!(overlapped.contains(&FaultKind::Gouge), "overlapped: {overlapped:?}");
    let missing = kinds(&contour_changed(&text, 1, None));
    assert!(missing.contains(&FaultKind::Uncut), "missing: {missing:?}");
    // Whole programs of sheets that lie otherwise, with the header of the good one.
    let mut turned = good.clone();
    turned.parts[0].rotation = Rotation::Half;
    let other = nc::write(&sheet(&turned, &machine).unwrap(), &machine).remove(0).text;
    let other = other.replacen("turned 180", "turned 0", 1);
    let found = kinds(&other);
    assert!(found.contains(&FaultKind::Gouge) || found.contains(&FaultKind::Uncut), "turned: {found:?}");
}
