//! Designs: from the study file to the table of indices.

use crate::Bench;

#[test]
fn indices_of_a_saltelli_design_are_a_table_and_a_figure() {
    // With large n and small steps the peak force depends only on gamma, which then has the whole total index.
    let bench = Bench::new();
    let study = r#"{"problem": "bar-impact", "parameters": {"gamma": {"uniform": [0.5, 2]}, "n": {"uniform": [12, 20]},
        "E": {"uniform": [50, 200]}, "dt": "0.02/n", "duration": 0.5},
        "design": {"kind": "saltelli", "n": 64, "seed": 3},
        "figures": [{"name": "bars", "kind": "sobol", "y": ["peak_force", "max_overlap"]}]}"#;
    bench.file("s.json", study);
    let done = bench.expect(0, &["run", "s.json"]);
    assert!(done.err.contains("320 cases run"), "{}", done.err);
    let first = bench.text("figures/s/sobol.csv");
    let rows: Vec<Vec<&str>> = first
        .lines()
        .map(|line| line.split(',').collect())
        .collect();
    assert_eq!(
        rows[0].join(","),
        "block,metric,parameter,first_order,first_order_low,first_order_high,total,total_low,total_high,empty_cases"
    );
    let row = |metric: &str, parameter: &str| -> Vec<f64> {
        let row = rows
            .iter()
            .find(|row| row[1] == metric && row[2] == parameter)
            .unwrap();
        row[3..].iter().map(|cell| cell.parse().unwrap()).collect()
    };
    let gamma = row("peak_force", "gamma");
    assert!(
        gamma[3] > 0.9 && gamma[1] < gamma[0] && gamma[0] < gamma[2],
        "{gamma:?}"
    );
    assert!(row("peak_force", "n")[3] < 1e-3);
    // Scaled results do not depend on the material, apart from round-off.
    for metric in ["peak_force", "max_overlap", "rms_error_r"] {
        assert!(row(metric, "E")[3].abs() < 1e-12, "{metric}");
    }
    // An undefined metric has no indices: the exact bars have not parted at the end.
    let empty = rows.iter().find(|row| row[1] == "impulse_error").unwrap();
    assert!(empty[3..9].iter().all(|cell| cell.is_empty()));
    assert_eq!(empty[9], "320");
    let named = "no Sobol' indices: impulse_error of block 0 is empty in 320 of 320 cases";
    assert!(done.err.contains(named), "{}", done.err);
    assert_eq!(row("peak_force", "gamma")[6], 0.0);
    assert!(bench.path("figures/s/bars.png").is_file());
    // The same from the store and on one thread; other points with another seed.
    bench.expect(0, &["run", "s.json", "--jobs", "1"]);
    assert_eq!(bench.text("figures/s/sobol.csv"), first);
    bench.file("s.json", study.replace("\"seed\": 3", "\"seed\": 4"));
    bench.expect(0, &["run", "s.json"]);
    assert_ne!(bench.text("figures/s/sobol.csv"), first);
    let narrowed = study.replace("\"y\"", "\"where\": {\"E\": 100}, \"y\"");
    bench.file("s.json", narrowed);
    bench.expect(2, &["run", "s.json"]);
    bench.file("s.json", study.replace("saltelli", "sobol"));
    let done = bench.expect(2, &["run", "s.json"]);
    assert!(
        done.err
            .contains("all cases of one block with a saltelli design"),
        "{}",
        done.err
    );
}
