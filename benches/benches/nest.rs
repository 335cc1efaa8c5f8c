use ifs_benches::boards;
use ifs_benches::processes::{median, millis};
use ifs_compiler::nest::{
    check::faults,
    sheets::{Part, Sheet, area, least_sheets, nest},
};
fn main() {
    let sheet = Sheet { length: 2500., width: 1250., margin: 10., gap: 8. };
    for (name, parts) in boards::all(1000) {
        let n = nest(&parts, &sheet);
        let f = faults(&parts, &sheet, &n);
        let t = median(3, || {
            std::hint::black_box(nest(&parts, &sheet));
        });
        let tc = median(3, || {
            std::hint::black_box(faults(&parts, &sheet, &n));
        });
        let a: f64 = parts.iter().map(|p| area(&p.outline)).sum();
        println!(
            "{name:12} {} sheets bound {} yield {:.3} {:.1}ms check {:.1}ms faults {} unplaced {}",
            n.sheets,
            least_sheets(&parts, &sheet),
            a / (n.sheets as f64 * sheet.area()),
            millis(t),
            millis(tc),
            f.len(),
            n.unplaced.len()
        );
        if let Some(f) = f.first() {
            println!("{f}");
        }
    }
}
