//! The report of designs that mean harm, of those that fail, and of those too large to be drawn one by one.

use glam::{DVec2, DVec3};
use proptest::prelude::*;

use super::*;
use crate::export::number::Fixed;
use crate::export::part::Part;
use crate::export::report::tests::report;
use crate::export::report::{Report, SheetReport, SheetsReport, UnplacedReport};
use crate::fabricate::label::Label;
use crate::fabricate::material::Material;
use crate::fabricate::panel::{Edges, Grain, PanelSettings, Panels, Side, panels};
use crate::geometry::{QuadMesh, samples};

/// A waved surface of boards in rows and columns, with these figures' names.
fn waved(rows: usize, columns: usize, name: &str) -> (QuadMesh, Vec<Label>, Panels) {
    let mesh = samples::mesh(rows + 1, columns + 1, |i, j| {
        DVec3::new(i * 300.0, j * 300.0, 90.0 * libm::sin(i * 0.7) * libm::cos(j * 0.4))
    });
    let places = (0..rows as u32).flat_map(|row| (0..columns as u32).map(move |column| (row, column)));
    let labels: Vec<Label> = places
        .map(|(row, column)| Label {
            address: format!("{name}.{row}-{column}"),
            alias: format!("{name}-{row:02}-{column:02}"),
            row: Some(row),
            column: Some(column),
        })
        .collect();
    let material =
        Material { name: name.to_owned(), thickness: Some(12.0), density: None, least_bend_radius: None };
    let settings = PanelSettings {
        material,
        board: (2500.0, 1250.0),
        side: Side::Centred,
        grain: Grain::U,
        edges: Edges::Square,
    };
    let made = panels(&mesh, &mesh, &labels, &settings).unwrap();
    (mesh, labels, made)
}

/// The page of such a surface, with its names everywhere a design can put them.
fn page(rows: usize, columns: usize, name: &str) -> String {
    let (mesh, labels, made) = waved(rows, columns, name);
    let mut report: Report = report();
    for text in
        [&mut report.design, &mut report.summary, &mut report.design_hash, &mut report.parameters[0].value]
    {
        *text = name.to_owned();
    }
    let fabrication = &mut report.fabrications[0];
    fabrication.figure = name.to_owned();
    fabrication.material.name = name.to_owned();
    fabrication.requirements[0].text = name.to_owned();
    fabrication.requirements[0].worst[0].place = name.to_owned();
    fabrication.parts = made.panels.iter().map(|panel| Part::of_panel(panel, name, name, Grain::U)).collect();
    fabrication.parts.push(Part::refused(&labels[0], name, name, name));
    fabrication.counts.refused = 1;
    let surface = SurfaceShape { name: name.to_owned(), designed: &mesh, built: &mesh, labels: &labels };
    let shapes = PanelShapes { surfaces: vec![surface], panels: &made.panels, required: 0.9998 };
    html(&Document {
        report: &report,
        made: vec![Made::Panels(shapes)],
        plain: Vec::new(),
        sheets: Vec::new(),
    })
}

/// The tags of a page in order; text between them must have nothing of a tag left.
fn tags(page: &str) -> Vec<String> {
    let mut tags = Vec::new();
    let (_, page) = page.split_once("</style>").unwrap();
    for part in page.split('<').skip(1) {
        let (tag, text) = part.split_once('>').unwrap();
        assert!(!text.contains('>'), "a lone > in {text:?}");
        tags.push(tag.split([' ', '/']).find(|word| !word.is_empty()).unwrap_or_default().to_owned());
    }
    tags
}

#[test]
fn what_fails_and_what_is_refused_is_said_first() {
    let page = page(3, 4, "shell");
    let place = |text: &str| page.find(text).unwrap_or_else(|| panic!("no {text:?}"));
    assert!(place("Cannot be built as it is") < place("Design and materials"));
    assert!(page.contains("1 is refused") && page.contains("1 of 1 requirement fails"), "{page}");
    assert!(place("shell: refused") < place("shell: assembly"));
    assert!(page.contains("class=\"bar out\""), "what is beyond the limit is marked");
}

#[test]
fn too_many_boards_are_drawn_in_blocks_and_listed_in_part() {
    let small = page(20, 20, "shell");
    assert!(small.contains("data-fields=\"400\"") && !small.contains("Drawn coarser"));
    assert!(small.contains(">19-19<"));
    let large = page(110, 100, "shell");
    assert!(large.contains("each field stands for 3 by 3 boards"));
    assert!(large.contains("data-fields=\"1258\""), "37 rows of 34 blocks");
    assert!(large.contains("too many to name one by one") && large.contains(">shell-109-99<"));
    assert_eq!(large.matches("<td class=\"name\">shell-").count(), 2000 + 1, "and the refused one");
    assert!(large.contains("The first 2000 of 11\u{202f}000; all are in cutlist.csv."));
    assert!(large.len() < 3_000_000, "{}", large.len());
}

#[test]
fn sheets_are_drawn_where_there_are_any() {
    let sheets = |report: &Report, shapes: &[SheetShape]| {
        let mut page = Markup::default();
        section::sheets::sheets(&mut page, report, shapes);
        page.finish()
    };
    let mut report = report();
    assert_eq!(sheets(&report, &[]), "");
    let outline = [(0.0, 0.0), (1250.0, 0.0), (1250.0, 625.0), (0.0, 625.0)].map(|(x, y)| DVec2::new(x, y));
    let shapes = ["1", "2", "3"].map(|name| SheetShape {
        name: name.to_owned(),
        size: DVec2::new(2500.0, 1250.0),
        used: 0.25,
        parts: vec![("shell-00-01".to_owned(), outline.to_vec())],
    });
    let of = |name: &str| SheetReport {
        name: name.to_owned(),
        boards: 1,
        part_of_area: Fixed::ratio(0.25),
        files: vec![format!("sheets/{name}.nc"), format!("sheets/{name}.dxf")],
    };
    report.sheets.push(SheetsReport {
        material: "birch plywood".to_owned(),
        thickness_mm: Fixed::mm(12.0),
        length_mm: Fixed::mm(2500.0),
        width_mm: Fixed::mm(1250.0),
        gap_mm: Fixed::mm(10.0),
        margin_mm: Fixed::mm(15.0),
        least_sheets: 1,
        part_of_area: Some(Fixed::ratio(0.25)),
        sheets: ["1", "2", "3"].map(of).to_vec(),
        unplaced: vec![UnplacedReport { address: "shell.9".to_owned(), reason: "too large".to_owned() }],
    });
    let text = sheets(&report, &shapes);
    assert!(text.contains("3 sheets of 2500 × 1250 mm") && text.contains(">25.0 %</data>"), "{text}");
    assert!(text.contains("1 part not placed") && text.contains("too large"), "{text}");
    assert_eq!((text.matches("<svg").count(), text.matches(">shell-00-01<").count()), (3, 3));
    // A quarter of the sheet, at its lower left.
    assert!(text.contains("d=\"M0 41.5L41.5 41.5L41.5 20.75L0 20.75Z\""), "{text}");
}

#[test]
fn the_same_bytes_each_time() {
    assert_eq!(page(5, 4, "shell"), page(5, 4, "shell"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn names_of_a_design_change_no_tag(
        name in "(<script>alert\\(1\\)</script>|</style>|</title>|\"|'|&lt;|--|]]>|\u{202e}|\u{5d0}\u{5d1}|\\PC|[\u{0}-\u{1f}]){1,8}",
    ) {
        prop_assume!(!name.contains('-'));
        let (plain, nasty) = (page(2, 2, "shell"), page(2, 2, &name));
        prop_assert_eq!(tags(&plain), tags(&nasty));
        let turned = nasty.contains('\u{202e}');
        prop_assert!(!turned);
        prop_assert!(nasty.chars().all(|character| character == '\n' || !character.is_control()));
    }
}
