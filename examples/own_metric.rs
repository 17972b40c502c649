//! An own metric: the path that the mass slides until it rests, for narrower and narrower friction models.
//!
//! Run with `cargo run --example own_metric`.

use slipgap::history::History;
use slipgap::study::parse;

/// The length of the path: the sum of |X(i+1) - X(i)|.
fn path(motion: &History) -> f64 {
    let pairs = motion.displacement().windows(2);
    pairs.map(|x| (x[1] - x[0]).abs()).sum()
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let study = parse(
        "path.json",
        r#"{ "problem": "friction-oscillator",
             "parameters": { "law": "velocity-control", "beta": [1, 0.1, 0.01], "dT": 0.005, "duration": "8*pi" } }"#,
    )?;
    println!("{:>8} {:>10} {:>10}", "beta", "path", "exact");
    let mut errors = Vec::new();
    for case in study.cases() {
        let solution = study.problem.solve(&case, &[])?;
        let (own, exact) = (path(&solution.computed), path(&solution.exact));
        let beta = case.number("beta").ok_or("no beta")?;
        println!("{beta:8} {own:10.4} {exact:10.4}");
        // Coulomb's motion from 12 has the turning points -10, 8, -6, 4, -2, 0: 22 + 18 + 14 + 10 + 6 + 2 = 72.
        assert!((exact - 72.0).abs() < 0.01);
        errors.push((own - 72.0).abs());
    }
    assert!(errors.is_sorted_by(|wider, narrower| wider > narrower));
    Ok(())
}
