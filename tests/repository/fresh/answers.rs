//! Numbers of docs/answers.md, compared with the tables of the studies that it names.

use std::collections::BTreeMap;
use std::fs;

const PAGE: &str = include_str!("../../../docs/answers.md");

pub type Row = BTreeMap<String, String>;

/// The rows of a table; none of its cells has a comma.
pub fn table(path: &str) -> Vec<Row> {
    let path = crate::results().join(path);
    let text = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let mut lines = text.lines();
    let columns: Vec<&str> = lines.next().unwrap().split(',').collect();
    let cells = |line: &str| {
        let cells = columns.iter().zip(line.split(','));
        cells.map(|(c, x)| (c.to_string(), x.to_owned())).collect()
    };
    lines.map(cells).collect()
}

/// Whether two cells are equal, numbers by their value: a table has `1.0` where a person writes 1.
pub(super) fn same(cell: &str, value: &str) -> bool {
    match (cell.parse::<f64>(), value.parse::<f64>()) {
        (Ok(cell), Ok(value)) => cell == value,
        (Ok(_) | Err(_), _) => cell == value,
    }
}

pub(super) fn number(row: &Row, column: &str) -> f64 {
    let cell = &row[column];
    cell.parse()
        .unwrap_or_else(|e| panic!("{column}: {cell}: {e}"))
}

/// The finite numbers of a column in rows with these values.
fn numbers(rows: &[Row], column: &str, with: &[(&str, &str)]) -> Vec<f64> {
    let is_chosen = |row: &&Row| with.iter().all(|(name, value)| same(&row[*name], value));
    let chosen = rows.iter().filter(is_chosen);
    let numbers: Vec<f64> = chosen.filter_map(|row| row[column].parse().ok()).collect();
    assert!(!numbers.is_empty(), "{column} {with:?}");
    numbers
}

fn ends(numbers: &[f64]) -> [f64; 2] {
    let least = numbers.iter().copied().fold(f64::INFINITY, f64::min);
    [
        least,
        numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max),
    ]
}

#[track_caller]
fn says(piece: &str) {
    assert!(PAGE.contains(piece), "not on the page: {piece}");
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn steps_in_a_contact() {
    says(r#""dt": "pi*sqrt(50/k)/20""#);
    let rows = table("methods/lumped-step/results.csv");
    // 0.675 is what the law gives (L4).
    says(
        "With 20 steps in a contact `kelvin-voigt` varies by −0.01 to 0.02, with 40 by less than 0.01",
    );
    let given = |steps| {
        let with = [("law", "kelvin-voigt"), ("steps", steps)];
        ends(&numbers(&rows, "restitution(joint)", &with)).map(|x| x - 0.675)
    };
    let [least, largest] = given("20");
    assert!((least + 0.01).abs() < 0.005 && (largest - 0.02).abs() < 0.005);
    assert!(given("40").iter().all(|x| x.abs() < 0.01));
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn medians_of_samples() {
    let rows = table("samples/ensemble-size/reductions.csv");
    for (name, column, sigma, ranges) in [
        ("opening", "opening", 0.19, "−19…24 % | −14…8 % | −4…3 %"),
        (
            "peak slip",
            "peak_slip",
            0.44,
            "−33…71 % | −11…19 % | −4…4 %",
        ),
        (
            "residual slip",
            "residual_slip",
            1.2,
            "−73…129 % | −35…51 % | −7…17 %",
        ),
    ] {
        says(&format!("| {name} | {sigma} | {ranges} |"));
        let reduction = format!("median {column} over member");
        let of = |n| numbers(&rows, "value", &[("reduction", &reduction), ("n", n)]);
        let finest = of("320")[0];
        for (n, range) in ["7", "20", "80"].into_iter().zip(ranges.split(" | ")) {
            let percent = range.trim_end_matches(" %").replace('−', "-");
            let (low, high) = percent.split_once('…').unwrap();
            let found = ends(&of(n)).map(|x| 100.0 * (x / finest - 1.0));
            for (found, page) in found.iter().zip([low, high]) {
                let page: f64 = page.parse().unwrap();
                assert!(
                    (found - page).abs() <= 0.5,
                    "{name}, {n}: {found}, not {page}"
                );
            }
        }
        let motions = table("samples/ensemble-size/results.csv");
        let responses: Vec<f64> = numbers(&motions, column, &[("n", "320")]);
        let logs: Vec<f64> = responses.iter().map(|x| x.ln()).collect();
        let count = logs.len() as f64;
        let mean = logs.iter().sum::<f64>() / count;
        let squares: f64 = logs.iter().map(|x| (x - mean).powi(2)).sum();
        let found = (squares / (count - 1.0)).sqrt();
        assert!(
            (found / sigma - 1.0).abs() < 0.03,
            "{name}: {found}, not {sigma}"
        );
    }
    // 1.96 1.2533 sigma/sqrt(n) = a, and 1.96 sqrt(1/4/n).
    says(
        "n = 6 (σ/a)²,** σ the standard deviation of the logarithms: for 10 % 24 at σ = 0.2, 120 at 0.45",
    );
    let factor: f64 = (1.96 * 1.2533_f64).powi(2);
    assert!((factor - 6.0).abs() < 0.05 && (factor * 4.0 - 24.0).abs() < 0.5);
    assert!((factor * 20.25 - 120.0).abs() < 5.0);
    says("±0.37, ±0.22, ±0.11");
    for (n, half) in [(7.0_f64, 0.37), (20.0, 0.22), (80.0, 0.11)] {
        assert!((1.96 * (0.25 / n).sqrt() - half).abs() < 0.005);
    }
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn intervals_of_fragilities() {
    says("0.62…2.5 of it with 6 capacities, 0.78…1.4 with 24, 0.85…1.2 with 60");
    says("jackknives of 6 contain it in 35 of 40 (");
    let rows = table("samples/fragility-size/fragility.csv");
    let of = |n, column| numbers(&rows, column, &[("figure", "samples"), ("n", n)]);
    // sqrt((n - 1)/chi2) at 0.975 and 0.025 from printed tables, for every sample.
    for (n, free, chi_square, page) in [
        ("6", 5.0, [12.833, 0.831], [0.62, 2.5]),
        ("24", 23.0, [38.076, 11.689], [0.78, 1.4]),
        ("60", 59.0, [82.117, 39.662], [0.85, 1.2]),
    ] {
        let ends = chi_square.map(|x: f64| (free / x).sqrt());
        let dispersions = of(n, "dispersion");
        for (i, column) in ["dispersion_low", "dispersion_high"].iter().enumerate() {
            // Half of the last digit of the page, and of the tables.
            let digit = if i == 0 { 0.005 } else { 0.05 };
            assert!((ends[i] - page[i]).abs() < digit, "{n}: {}", ends[i]);
            for (end, dispersion) in of(n, column).iter().zip(&dispersions) {
                assert!((end / dispersion / ends[i] - 1.0).abs() < 1e-3);
            }
        }
    }
    let dispersion = of("240", "dispersion")[0];
    let contain = |low, high| {
        // A row for each capacity, six of each sample.
        let pairs = of("6", low).into_iter().zip(of("6", high)).step_by(6);
        let ends: Vec<(f64, f64)> = pairs.collect();
        assert_eq!(ends.len(), 40);
        let inside = ends
            .iter()
            .filter(|(low, high)| *low <= dispersion && dispersion <= *high);
        inside.count()
    };
    assert_eq!(
        contain("dispersion_low_jackknife", "dispersion_high_jackknife"),
        35
    );
    assert_eq!(contain("dispersion_low", "dispersion_high"), 38);
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn restitution_of_laws() {
    says(
        "For 0.5 `kelvin-voigt` gives 0.55, `hertz-damp` 0.73; from 0.05 to 0.95 `jankowski` misses by at most 0.009, `ye` by 0.045",
    );
    let rows = table("laws/laws-restitution/results.csv");
    for (law, given) in [("kelvin-voigt", 0.55), ("hertz-damp", 0.73)] {
        let found = numbers(
            &rows,
            "last(gap.rdot)",
            &[("law", law), ("restitution", "0.5"), ("k", "1")],
        );
        assert!((found[0] - given).abs() < 0.005, "{law}: {found:?}");
    }
    let rows = table("claims/literature-restitution/results.csv");
    for (law, most) in [("jankowski", 0.009), ("ye", 0.045)] {
        let missed = numbers(&rows, "last(gap.rdot - target.v)", &[("law", law)]);
        let largest = missed.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        assert!(
            largest <= most + 0.0005 && largest > 0.9 * most,
            "{law}: {largest}"
        );
    }
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn creep_of_softened_friction() {
    says("computed drifts are 0.96 to 1.02 of that, in earthquakes, too");
    let rows = table("friction/friction-creep/results.csv");
    let mut found = Vec::new();
    for load in ["0.2", "0.5", "0.8"] {
        let law = [("law", "velocity-control"), ("k", "0"), ("load", load)];
        found.extend(numbers(
            &rows,
            "drift_over_W",
            &[&law[..], &[("scale", "0")]].concat(),
        ));
        for scale in ["0.2", "1"].iter().filter(|_| load != "0.8") {
            let with = [&law[..], &[("scale", *scale), ("dt", "0.0025")]].concat();
            found.extend(numbers(&rows, "drift_over_W", &with));
        }
    }
    let [least, largest] = ends(&found);
    assert!(
        (least - 0.96).abs() < 0.005 && (largest - 1.02).abs() < 0.005,
        "{least} {largest}"
    );
}
