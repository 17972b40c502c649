//! A sweep: two bars strike each other with a hundred stiffnesses of the impact spring, solved side by side.
//!
//! Run with `cargo run --example sweep`.

use slipgap::study::parse;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let study = parse(
        "sweep.json",
        r#"{ "problem": "bar-impact",
             "parameters": { "gamma": {"geomspace": [0.1, 10, 100]}, "n": 20, "dt": 0.001, "duration": 1.5 } }"#,
    )?;
    // All combinations of the study, as columns of parameters, and the numbers of the cases to be solved.
    let (_, cases) = study.columns(0, study.raw_len());
    let rows: Vec<u32> = (0..cases.len() as u32).collect();
    let table = study.problem.sweep(&cases, &rows);

    let metrics = study.problem.metrics();
    let row = |name: &str| metrics.iter().position(|metric| metric.name == name);
    let overlap = row("max_overlap").ok_or("no such metric")?;
    let error = row("rms_error_rdot").ok_or("no such metric")?;
    let mut shown = cases.shown();
    println!(
        "{:>8} {:>12} {:>14}",
        "gamma", "max_overlap", "rms_error_rdot"
    );
    for (i, (overlap, error)) in table.column(overlap).zip(table.column(error)).enumerate() {
        if let (0, Some(overlap), Some(error)) = (i % 11, overlap, error) {
            let gamma = shown.at(i).number("gamma").unwrap_or(f64::NAN);
            println!("{gamma:8.3} {overlap:12.6} {error:14.6}");
        }
    }

    // A stiffer spring lets the bars overlap less.
    let column: Option<Vec<f64>> = table.column(overlap).collect();
    let overlaps = column.ok_or("a case has no contact")?;
    assert!(overlaps.is_sorted_by(|softer, stiffer| softer > stiffer));
    Ok(())
}
