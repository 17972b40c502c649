//! Ensembles: from the study file to the tables.

use crate::Bench;

const STUDY: &str = r#"{"problem": "friction-oscillator", "parameters": {"law": "displacement-control", "alpha": [0.1, 1],
    "x0": {"linspace": [8, 12, 9]}, "dT": "pi/10", "duration": "8*pi"}, "ensemble": "x0",
    "figures": [{"name": "d", "kind": "distribution", "y": "rms_error"}]}"#;

/// The rows of a table as cells.
fn rows(table: &str) -> Vec<Vec<&str>> {
    let lines = table.lines();
    lines.map(|line| line.split(',').collect()).collect()
}

#[test]
fn the_tables_of_an_ensemble_are_those_of_its_cases() {
    let bench = Bench::new();
    bench.file("s.json", STUDY);
    bench.expect(0, &["run", "s.json"]);
    let quantiles = bench.text("figures/s/quantiles.csv");
    let two_samples = bench.text("figures/s/two_samples.csv");
    let table = bench.text("figures/s/results.csv");
    let results = rows(&table);
    let at = |name: &str| results[0].iter().position(|cell| *cell == name).unwrap();
    let (alpha, error) = (at("alpha"), at("rms_error"));
    for row in rows(&quantiles).iter().filter(|row| row[0] == "rms_error") {
        let of_alpha = results.iter().filter(|result| result[alpha] == row[1]);
        let mut values: Vec<f64> = of_alpha
            .map(|result| result[error].parse().unwrap())
            .collect();
        values.sort_by(f64::total_cmp);
        assert_eq!(row[2..4], ["9", "0"]);
        let number = |column: usize| row[column].parse::<f64>().unwrap();
        // Of nine values the 5th is the median, the 3rd a quarter, the 2nd and 8th the ends of its interval.
        let found = [
            number(4),
            number(7),
            number(8),
            number(12),
            number(15),
            number(16),
        ];
        assert_eq!(
            found,
            [
                values[0], values[2], values[4], values[8], values[1], values[7]
            ]
        );
    }
    assert!(
        rows(&two_samples)[1..]
            .iter()
            .all(|row| row[1..4] == ["alpha", "0.1", "1.0"])
    );
    let manifest = bench.text("figures/s/manifest.json");
    assert!(manifest.contains("quantiles.csv") && manifest.contains("two_samples.csv"));
    // The same bytes from the store, on one thread, and without results.csv.
    for options in [&["--jobs", "1"][..], &["--format", "parquet"]] {
        bench.expect(0, &[&["run", "s.json"], options].concat());
        assert_eq!(bench.text("figures/s/quantiles.csv"), quantiles);
        assert_eq!(bench.text("figures/s/two_samples.csv"), two_samples);
    }
}

#[test]
fn outdated_tables_are_removed() {
    let bench = Bench::new();
    bench.file("s.json", STUDY);
    bench.expect(0, &["run", "s.json"]);
    let exists = |name: &str| bench.path(&format!("figures/s/{name}")).is_file();
    assert!(exists("quantiles.csv") && exists("two_samples.csv"));
    // One ensemble alone has nothing to compare with.
    let one = STUDY.replace("\"ensemble\": \"x0\"", "\"ensemble\": [\"x0\", \"alpha\"]");
    bench.file("s.json", &one);
    bench.expect(0, &["run", "s.json"]);
    assert!(exists("quantiles.csv") && !exists("two_samples.csv"));
    let none = STUDY
        .replace("\"ensemble\": \"x0\",", "")
        .replace("distribution\"", "metric\", \"x\": \"x0\"");
    bench.file("s.json", &none);
    bench.expect(0, &["run", "s.json"]);
    assert!(!exists("quantiles.csv") && exists("d.png"));
}

#[test]
fn the_points_of_fragility_figures_are_a_table() {
    let bench = Bench::new();
    let figure = r#""kind": "fragility", "x": "x0", "y": "rms_error""#;
    let study = format!(
        r#"{{"problem": "friction-oscillator", "parameters": {{"law": "displacement-control", "alpha": [0.01, 0.02, 0.5, 0.6],
            "dT": 0.1, "x0": [8, 12], "duration": "8*pi"}}, "ensemble": "alpha",
            "figures": [{{"name": "none", {figure}, "limit": 1e9}}, {{"name": "half", {figure}, "limit": 0.05}},
              {{"name": "one", {figure}, "limit": 0.05, "where": {{"x0": 8, "alpha": [0.01, 0.5, 0.6]}}}}]}}"#
    );
    bench.file("s.json", study);
    bench.expect(0, &["run", "s.json"]);
    let errors: Vec<f64> = {
        let text = bench.text("figures/s/results.csv");
        let table = rows(&text);
        let index = table[0].iter().position(|name| *name == "rms_error");
        let column = table[1..].iter().map(|row| row[index.unwrap()].parse());
        column.map(Result::unwrap).collect()
    };
    // Narrow laws are near the exact motion, wide ones are not: two of four exceed at each x0.
    assert_eq!(errors.iter().filter(|x| **x > 0.05).count(), 4);
    let table = bench.text("figures/s/fragility.csv");
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(
        lines[0],
        "figure,metric,limit,x0,cases,empty,exceeded,probability,probability_low,probability_high,median,dispersion,no_fit,\
         median_low,median_high,dispersion_low,dispersion_high,median_low_jackknife,median_high_jackknife,dispersion_low_jackknife,\
         dispersion_high_jackknife"
    );
    let starts = [
        "none,rms_error,1000000000.0,8.0,4,0,0,0.0,0.0,0.602",
        "none,rms_error,1000000000.0,12.0,4,0,0,0.0,0.0,0.602",
        "half,rms_error,0.05,8.0,4,0,2,0.5,0.067",
        "half,rms_error,0.05,12.0,4,0,2,0.5,0.067",
        "one,rms_error,0.05,8.0,3,0,2,0.6666666666666666,0.094",
    ];
    assert_eq!(lines.len(), 1 + starts.len(), "{table}");
    // 0 of 4: 1 - 0.025^(1/4); 2 of 4 and 2 of 3: the tables of Clopper and Pearson.
    for (line, start) in lines[1..].iter().zip(starts) {
        assert!(line.starts_with(start), "{line}");
    }
    assert!(lines[1].ends_with(",,,no case exceeds the limit,,,,,,,,"));
    assert!(lines[3].ends_with(",,,the probability does not rise,,,,,,,,"));
    let manifest = bench.text("figures/s/manifest.json");
    assert!(manifest.contains("\"fragility.csv\""));
    // The place of a point has a column even if it is the only one.
    let study = bench.text("s.json");
    bench.file("one.json", study.replace("[8, 12]", "8"));
    bench.expect(0, &["run", "one.json"]);
    let table = bench.text("figures/one/fragility.csv");
    assert!(
        table.starts_with("figure,metric,limit,x0,cases,"),
        "{table}"
    );
    assert!(
        table.contains("\nhalf,rms_error,0.05,8.0,4,0,2,0.5,"),
        "{table}"
    );
    // A study without such a figure has no table, and the old one goes.
    let study = bench.text("s.json");
    let without = study.split(", \"ensemble\"").next().unwrap();
    bench.file("s.json", format!("{without}, \"ensemble\": \"alpha\"}}"));
    bench.expect(0, &["run", "s.json"]);
    assert!(!bench.path("figures/s/fragility.csv").exists());
}

/// The measures of the records of the Loma Prieta earthquake by an independent program: pga, and the spectral displacement at 1 s.
fn measures() -> Vec<[f64; 2]> {
    let reference: serde_json::Value =
        serde_json::from_str(include_str!("../../data/records.json")).unwrap();
    let records = reference["records"].as_array().unwrap().iter();
    let of_event =
        records.filter(|record| record["file"].as_str().unwrap().starts_with("lomaprieta"));
    of_event
        .map(|record| [&record["pga"], &record["sd"][2]].map(|x| x.as_f64().unwrap()))
        .collect()
}

#[test]
fn fragility_by_incremental_scaling_and_of_a_cloud_has_intervals() {
    // A linear oscillator of 1 s with 5 % damping, whose peak is the spectral displacement times the scale.
    let bench = Bench::new();
    let records = concat!(env!("SLIPGAP_ROOT"), "/studies/records/lomaprieta-*.smc");
    let omega = 2.0 * std::f64::consts::PI;
    let scales = [0.1, 1.0, 10.0];
    bench.file(
        "s.json",
        format!(
            r#"{{"problem": "structure", "parameters": {{"record": {{"files": "{records}"}}, "scale": {scales:?}, "T1": 1,
               "dt": 0.005, "duration": 36}},
             "structure": {{"units": "kg, N, m, s", "masses": {{"m": 1}},
               "springs": [{{"between": ["ground", "m"], "k": {k}, "c": {c}}}], "ground": {{"record": "record", "scale": "scale"}}}},
             "metrics": ["peak(m)", "ground.pga", "ground.Sa(T1)"], "ensemble": "record",
             "figures": [{{"name": "i", "kind": "fragility", "x": "scale", "y": "peak(m)", "limit": 0.1, "fit": "incremental"}},
                         {{"name": "c", "kind": "fragility", "x": "ground.pga", "y": "peak(m)", "limit": 0.1, "fit": "cloud", "x_scale": "log"}},
                         {{"name": "e", "kind": "fragility", "x": "ground.Sa(T1)", "y": "peak(m)", "limit": 9, "fit": "incremental"}}]}}"#,
            k = omega * omega,
            c = 2.0 * 0.05 * omega,
        ),
    );
    bench.expect(0, &["run", "s.json"]);
    let table = bench.text("figures/s/fragility.csv");
    let rows = rows(&table);
    assert_eq!(
        rows[0].join(","),
        "figure,metric,limit,scale,ground.pga,ground.Sa(T1),cases,empty,exceeded,probability,probability_low,probability_high,median,\
         dispersion,no_fit,median_low,median_high,dispersion_low,dispersion_high,median_low_jackknife,median_high_jackknife,\
         dispersion_low_jackknife,dispersion_high_jackknife,beyond,before,slope,deviation"
    );
    let number = |row: &[&str], column: usize| row[column].parse::<f64>().unwrap();
    let of = |figure: &str| -> Vec<Vec<&str>> {
        rows.iter()
            .filter(|row| row[0] == figure)
            .cloned()
            .collect()
    };
    // Steps of 1/200 of the period: (omega dt)^2/12 = 8e-5 of the period, which a resonant peak shows some times over.
    let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 2e-3, "{a} {b}");
    let mut capacities: Vec<f64> = measures().iter().map(|measure| 0.1 / measure[1]).collect();
    capacities.sort_by(f64::total_cmp);
    let incremental = of("i");
    assert_eq!(incremental.len(), 5);
    for (i, (row, capacity)) in incremental.iter().zip(&capacities).enumerate() {
        near(number(row, 3), *capacity);
        assert_eq!((row[4], row[6], number(row, 8)), ("", "5", i as f64 + 1.0));
    }
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let logs: Vec<f64> = capacities.iter().map(|x| x.ln()).collect();
    let median = mean(&logs);
    let deviation = (logs.iter().map(|z| (z - median).powi(2)).sum::<f64>() / 4.0).sqrt();
    near(number(&incremental[0], 12), median.exp());
    near(number(&incremental[0], 13), deviation);
    // Student's t for 4, and chi-square for 4 at 0.975 and 0.025, from printed tables.
    let half = 2.7764 * deviation / 5f64.sqrt();
    near(number(&incremental[0], 15), (median - half).exp());
    near(number(&incremental[0], 16), (median + half).exp());
    near(
        number(&incremental[0], 17),
        deviation * (4.0f64 / 11.1433).sqrt(),
    );
    near(
        number(&incremental[0], 18),
        deviation * (4.0f64 / 0.484419).sqrt(),
    );
    // A line through the logarithms of all cases.
    let cloud: Vec<[f64; 2]> = measures()
        .iter()
        .flat_map(|measure| scales.map(|scale| measure.map(|x| (x * scale).ln())))
        .collect();
    let column = |j: usize| cloud.iter().map(|point| point[j]).collect::<Vec<f64>>();
    let [x, y] = [mean(&column(0)), mean(&column(1))];
    let sxx: f64 = cloud.iter().map(|p| (p[0] - x).powi(2)).sum();
    let slope = cloud.iter().map(|p| (p[0] - x) * (p[1] - y)).sum::<f64>() / sxx;
    let residual = |p: &[f64; 2]| (p[1] - y - slope * (p[0] - x)).powi(2);
    let deviation = (cloud.iter().map(residual).sum::<f64>() / 13.0).sqrt();
    let cloud_rows = of("c");
    assert_eq!((cloud_rows.len(), cloud_rows[0][3]), (15, ""));
    near(
        number(&cloud_rows[0], 12),
        (x + (0.1f64.ln() - y) / slope).exp(),
    );
    near(number(&cloud_rows[0], 13), deviation / slope);
    let [low, high] = [15, 16].map(|column| number(&cloud_rows[0], column));
    assert!(low < number(&cloud_rows[0], 12) && number(&cloud_rows[0], 12) < high);
    // The limit of 9 m is beyond all of them: one row says so.
    let truncated = of("e");
    assert_eq!(
        (truncated.len(), &truncated[0][3..9]),
        (1, &["", "", "", "5", "0", "0"][..])
    );
    assert_eq!(
        truncated[0][14],
        "5 of the ensemble do not exceed the limit at the largest value"
    );
    assert_eq!([truncated[0][23], truncated[0][24]], ["5", "0"]);
    let picture = bench.text("figures/s/i.svg");
    assert!(picture.contains("dispersion") && picture.contains('['));
}

#[test]
fn a_fragility_figure_over_a_metric_needs_a_fit() {
    let bench = Bench::new();
    let figure = |keys: &str| STUDY.replace(r#""kind": "distribution", "y": "rms_error""#, keys);
    let keys = r#""kind": "fragility", "x": "peak_error", "y": "rms_error", "limit": 1"#;
    bench.file("s.json", figure(keys));
    let found = bench.expect(2, &["run", "s.json"]).err;
    assert!(
        found.contains("is a metric; give \"fit\": incremental or cloud"),
        "{found}"
    );
    bench.file("s.json", figure(&format!(r#"{keys}, "fit": "best""#)));
    let found = bench.expect(2, &["run", "s.json"]).err;
    assert!(
        found.contains("unknown fit \"best\"; allowed: likelihood, incremental, cloud"),
        "{found}"
    );
}

/// The numbers of a fragility figure of `studies/recorded/recorded-fragility.json` by the independent program, and of its members.
fn independent(figure: &str) -> (Vec<f64>, serde_json::Value) {
    let reference: serde_json::Value =
        serde_json::from_str(include_str!("../../data/fragility.json")).unwrap();
    let of_figure = reference[figure]["curve"].as_array().unwrap().iter();
    let curve = of_figure.map(|x| x.as_f64().unwrap()).collect();
    (curve, reference[figure]["members"].clone())
}

#[test]
fn fragilities_agree_with_an_independent_program() {
    let bench = Bench::new();
    let study = concat!(
        env!("SLIPGAP_ROOT"),
        "/studies/recorded/recorded-fragility.json"
    );
    bench.expect(0, &["run", study, "--jobs", "1"]);
    let table = bench.text("figures/recorded-fragility/fragility.csv");
    let members = bench.text("figures/recorded-fragility/fragility_members.csv");
    bench.expect(0, &["run", study, "--jobs", "3", "--out", "again"]);
    assert_eq!(bench.text("again/recorded-fragility/fragility.csv"), table);
    let (table, members) = (rows(&table), rows(&members));
    let column_of = |name: &str| table[0].iter().position(|cell| *cell == name).unwrap();
    let numbers = [
        "median",
        "dispersion",
        "median_low",
        "median_high",
        "dispersion_low",
        "dispersion_high",
        "slope",
        "deviation",
        "residual_slope(magnitude)",
        "residual_p(magnitude)",
        "residual_slope(ground.Tm)",
        "residual_p(ground.Tm)",
        "frequency",
        "frequency_outside",
        "frequency_closed_form",
    ];
    // The capacities are differences of results, which are the same; then rounding, most of it in an exponent of 30.
    let near =
        |found: f64, other: f64| assert!((found / other - 1.0).abs() < 1e-11, "{found} {other}");
    for (figure, bounds) in [
        ("pga", ["0", "0", ""]),
        ("sa", ["0", "0", ""]),
        ("cloud", ["", "", "9"]),
        ("truncated", ["1", "0", ""]),
        ("stripes", ["", "", "9"]),
    ] {
        let (expected, shares) = independent(figure);
        let function_row = table.iter().find(|row| row[0] == figure).unwrap();
        let cells = numbers.map(|name| function_row[column_of(name)]);
        let found: Vec<f64> = cells.iter().filter_map(|x| x.parse().ok()).collect();
        assert_eq!(found.len(), expected.len(), "{figure}");
        found.iter().zip(expected).for_each(|(x, y)| near(*x, y));
        let counts = ["beyond", "before", "collapsed"].map(|name| function_row[column_of(name)]);
        assert_eq!(counts, bounds, "{figure}");
        let mut sum = 0.0;
        for row in members.iter().filter(|row| row[0] == figure) {
            let record = row[4].rsplit('/').next().unwrap();
            let number = |i: usize| row[i].parse::<f64>().unwrap();
            near(number(7), shares[record][0].as_f64().unwrap());
            near(number(8), shares[record][1].as_f64().unwrap());
            sum += number(8);
        }
        near(sum, 1.0);
    }
    let (function, _) = independent("truncated");
    let legend = format!(
        "median {:.1} [{:.0}, {:.1}], dispersion {:.3} [{:.3}, {:.3}]",
        function[0], function[2], function[3], function[1], function[4], function[5]
    );
    let picture = bench.text("figures/recorded-fragility/truncated.svg");
    assert!(picture.contains(&legend), "{legend}");
}
