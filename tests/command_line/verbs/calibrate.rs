//! `slipgap calibrate`: parameters of self-made measurements are found, files are complete and the same for any number of threads.

use crate::{Bench, Done};

/// A mass that hits the ground; `law`, `k`, `k_h` and `v0` as given, and more keys.
fn study(parameters: &str, more: &str) -> String {
    format!(
        r#"{{ "problem": "structure", "title": "A mass hits the ground",
  "parameters": {{ "dt": 0.002, "duration": 0.6, {parameters} }},
  "structure": {{ "units": "t, kN, m, s", "masses": {{ "m": 1 }},
    "springs": [{{ "between": ["ground", "m"], "k": 100, "c": 0.5 }}],
    "contacts": {{ "gap": {{ "law": "law", "between": ["ground", "m"], "gap": 0.02, "k": "k", "k_h": "k_h" }} }},
    "start": {{ "m": {{ "v": "-v0" }} }} }}{more} }}"#
    )
}

/// The parameters from which measurements are made.
const TRUTH: &str = r#""law": "hertz", "k": 1, "k_h": 20000, "v0": 1"#;

/// A normal number: the sum of twelve uniform ones of a linear congruential generator.
fn normal(state: &mut u64) -> f64 {
    let mut uniform = || {
        *state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (*state >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..12).map(|_| uniform()).sum::<f64>() - 6.0
}

/// Solves a study and writes its motion in mm with noise of this standard deviation, in m, as a measurement.
fn measure(bench: &Bench, parameters: &str, file: &str, noise: f64, seed: u64) {
    bench.file("truth.json", study(parameters, ""));
    bench.expect(0, &["run", "truth.json", "--out", "truth", "--histories"]);
    let history = bench.text("truth/truth/histories/0.csv");
    let mut lines = history.lines();
    let column = lines
        .next()
        .unwrap()
        .split(',')
        .position(|name| name == "m.u")
        .unwrap();
    let (mut text, mut state) = ("t,disp\n".to_owned(), seed);
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        let u = cells[column].parse::<f64>().unwrap() + noise * normal(&mut state);
        text += &format!("{},{}\n", cells[0], 1e3 * u);
    }
    bench.file(file, text);
}

/// The measurement of a file.
fn measured(file: &str) -> String {
    format!(
        r#", "measured": {{ "file": {file}, "time": "t", "columns": {{ "m.u": {{ "column": "disp", "unit": "mm" }} }} }}"#
    )
}

/// The cells of a table by the names of its columns, for the row that begins with these cells.
fn cell(table: &str, row: &[&str], column: &str) -> String {
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let at = names.iter().position(|name| *name == column).unwrap();
    let begins = |line: &&str| {
        line.split(',')
            .zip(row)
            .all(|(cell, wanted)| cell == *wanted)
    };
    let line = lines
        .find(begins)
        .unwrap_or_else(|| panic!("{row:?} in {table}"));
    line.split(',').nth(at).unwrap().to_owned()
}

fn number(table: &str, row: &[&str], column: &str) -> f64 {
    cell(table, row, column).parse().unwrap()
}

const FREE: &str = r#", "calibrate": { "k": {"log": [100, 1e5]}, "k_h": {"log": [1e3, 1e6]}, "v0": [0.5, 2],
    "minimise": "rms_error(m.u, measured)", "cases": 3000 }"#;

/// Two laws with a measurement of the second.
fn two_laws(bench: &Bench, file: &str) {
    let more = format!(
        r#"{}{FREE}, "metrics": ["peak(gap.S)"], "checks": [{{ "metric": "peak(gap.S)", "min": 0 }}], "figures": [
      {{ "name": "u", "kind": "history", "y": "m.u" }}, {{ "name": "both", "kind": "history", "y": "m.u", "where": {{ "law": ["impact", "hertz"] }} }}]"#,
        measured(file)
    );
    let parameters = r#""law": ["impact", "hertz"], "k": 1000, "k_h": 5000, "v0": 1.2"#;
    bench.file("studies/two.json", study(parameters, &more));
}

#[test]
fn the_law_and_the_parameters_of_a_self_made_measurement_are_found() {
    let bench = Bench::new();
    // 1 % of about the rms of u, 0.03 m.
    measure(&bench, TRUTH, "studies/test.csv", 3e-4, 1);
    two_laws(&bench, "\"test.csv\"");
    let calibrate = |jobs: &str| -> Done {
        bench.expect(
            0,
            &[
                "calibrate",
                "studies/two.json",
                "--out",
                jobs,
                "--jobs",
                jobs,
            ],
        )
    };
    let done = calibrate("1");
    let table = bench.text("1/two/calibration.csv");
    for (parameter, truth) in [("k_h", 20_000.0), ("v0", 1.0)] {
        let row = ["hertz", parameter];
        let [best, from, to] = ["best", "from", "to"].map(|name| number(&table, &row, name));
        assert!(from < best && best < to, "{table}");
        // Of this noise, the truth is within twice the interval; the chance of more is below 1e-4.
        let half = f64::max(to - best, best - from);
        assert!((best - truth).abs() < 2.0 * half, "{parameter}: {table}");
        assert!((to - from) / best < 0.2, "{parameter}: {table}");
        assert_eq!(cell(&table, &row, "state"), "determined");
    }
    assert_eq!(cell(&table, &["hertz", "k"], "state"), "not used");
    assert_eq!(cell(&table, &["impact", "k_h"], "state"), "not used");
    let alternatives = bench.text("1/two/alternatives.csv");
    assert_eq!(cell(&alternatives, &["hertz"], "verdict"), "best");
    assert_eq!(cell(&alternatives, &["impact"], "verdict"), "worse");
    assert_eq!(
        cell(&alternatives, &["hertz"], "numerical_from"),
        "step_error"
    );
    // The noise has this standard deviation, of 301 points to 5 %.
    let misfit = number(&alternatives, &["hertz"], "misfit");
    assert!((misfit / 3e-4 - 1.0).abs() < 0.2, "{alternatives}");
    assert!(
        done.out
            .contains("hertz is nearer to the measurement than impact"),
        "{}",
        done.out
    );
    // The same bytes with two threads.
    let again = calibrate("2");
    assert_eq!(done.out.replace("1/two", "2/two"), again.out);
    let files = bench.tree("1");
    let expected = [
        "alternatives.csv",
        "best-hertz.json",
        "best-impact.json",
        "calibration.csv",
        "correlation.csv",
        "measured.pdf",
        "measured.png",
        "measured.svg",
        "misfit.pdf",
        "misfit.png",
        "misfit.svg",
        "profiles.csv",
    ];
    assert_eq!(files, expected.map(|name| format!("two/{name}")));
    for file in &files {
        let read = |jobs: &str| std::fs::read(bench.path(jobs).join(file)).unwrap();
        assert!(read("1") == read("2"), "{file}");
    }
    // The study with the best values runs and has the same misfit.
    for law in ["hertz", "impact"] {
        bench.expect(
            0,
            &["run", &format!("1/two/best-{law}.json"), "--out", "best"],
        );
        let results = bench.text(&format!("best/best-{law}/results.csv"));
        let misfit = cell(
            &results
                .replace("m.u, measured", "m.u measured")
                .replace('"', ""),
            &["0"],
            "rms_error(m.u measured)",
        );
        assert_eq!(misfit, cell(&alternatives, &[law], "misfit"));
        // The other figure needs both laws.
        assert!(bench.path(&format!("best/best-{law}/u.png")).exists());
        assert!(!bench.path(&format!("best/best-{law}/both.png")).exists());
    }
}

#[test]
fn several_tests_have_one_misfit() {
    let bench = Bench::new();
    let truth = |v0: &str| TRUTH.replace("\"v0\": 1", &format!("\"v0\": {v0}"));
    measure(&bench, &truth("1"), "studies/tests/a.csv", 3e-4, 1);
    measure(&bench, &truth("1.3"), "studies/tests/b.csv", 1e-3, 2);
    let more = format!(
        r#"{}, "zip": [["measured", "v0"]], "calibrate": {{ "k_h": {{"log": [1e3, 1e6]}}, "minimise": "rms_error(m.u, measured)" }}"#,
        measured(r#"{"files": "tests/*.csv"}"#)
    );
    let parameters = r#""law": "hertz", "k": 1, "k_h": 5000, "v0": [1, 1.3]"#;
    bench.file("studies/two.json", study(parameters, &more));
    let done = bench.expect(0, &["calibrate", "studies/two.json", "--out", "out"]);
    assert!(done.out.contains("of 2 tests together"), "{}", done.out);
    bench.expect(0, &["run", "out/two/best.json", "--out", "best"]);
    let results = bench
        .text("best/best/results.csv")
        .replace("m.u, measured", "m.u measured")
        .replace('"', "");
    let each = ["0", "1"].map(|case| number(&results, &[case], "rms_error(m.u measured)"));
    let pooled = ((each[0] * each[0] + each[1] * each[1]) / 2.0).sqrt();
    let misfit = number(
        &bench.text("out/two/alternatives.csv"),
        &["study"],
        "misfit",
    );
    // Both tests have the same number of points; the sums are in another order.
    assert!((pooled / misfit - 1.0).abs() < 1e-12, "{pooled} {misfit}");
    let best = number(
        &bench.text("out/two/calibration.csv"),
        &["study", "k_h"],
        "best",
    );
    assert!((best / 2e4 - 1.0).abs() < 0.1, "{best}");
}

#[test]
fn a_parameter_that_the_measurement_does_not_contain_is_not_determined() {
    let bench = Bench::new();
    measure(
        &bench,
        &TRUTH.replace("\"v0\": 1", "\"v0\": 0.1"),
        "test.csv",
        1e-5,
        1,
    );
    // The mass never reaches the ground.
    let more = format!("{}{FREE}", measured("\"test.csv\"")).replace("[0.5, 2]", "[0.05, 0.15]");
    bench.file(
        "s.json",
        study(r#""law": "hertz", "k": 1, "k_h": 5000, "v0": 0.1"#, &more),
    );
    let done = bench.expect(0, &["calibrate", "s.json", "--out", "out"]);
    let expected = "k_h is not determined: all values from 1e3 to 1e6 are in its 95 % interval";
    assert!(done.out.contains(expected), "{}", done.out);
    let table = bench.text("out/s/calibration.csv");
    assert_eq!(cell(&table, &["study", "k_h"], "state"), "not determined");
    assert_eq!(cell(&table, &["study", "v0"], "state"), "determined");
}

#[test]
fn other_verbs_say_that_the_values_are_those_of_the_study() {
    let bench = Bench::new();
    measure(&bench, TRUTH, "studies/test.csv", 3e-4, 1);
    two_laws(&bench, "\"test.csv\"");
    let note =
        "k, k_h, v0: the values are those of the study; `slipgap calibrate` finds the best ones";
    for verb in ["run", "check"] {
        let done = bench.expect(0, &[verb, "studies/two.json"]);
        assert!(done.err.contains(note), "{verb}: {}", done.err);
    }
    let done = bench.expect(0, &["explain", "studies/two.json"]);
    for line in [
        note,
        "calibrate: minimises rms_error(m.u, measured); free: k from 100 to 1e5 by its logarithm, k_h from 1e3 to 1e6 by its logarithm, v0 from 0.5 to 2\n",
        "calibrate: 2 alternatives, each with a search of up to 2250 cases, then profiles\n",
        "calibrate: impact: does not use k_h\n",
        "calibrate: hertz: does not use k\n",
    ] {
        assert!(done.out.contains(line), "{line}: {}", done.out);
    }
    assert!(!done.out.contains("one by one"), "{}", done.out);
}

#[test]
fn explain_says_which_parameters_prevent_lanes() {
    let bench = Bench::new();
    measure(&bench, TRUTH, "test.csv", 3e-4, 1);
    let more = format!("{}{FREE}", measured("\"test.csv\""))
        .replace("\"v0\": [", "\"c\": [0.1, 1], \"v0\": [");
    let text = study(
        r#""law": "hertz", "k": 1, "k_h": 5000, "v0": 1, "c": 0.5"#,
        &more,
    );
    bench.file("s.json", text.replace("\"c\": 0.5 }]", "\"c\": \"c\" }]"));
    let done = bench.expect(0, &["explain", "s.json"]);
    let line =
        "calibrate: masses, stiffnesses or dashpots follow from c: cases are solved one by one";
    assert!(done.out.contains(line), "{}", done.out);
}

#[test]
fn derived_parameters_and_arithmetic_follow_the_free_ones() {
    let bench = Bench::new();
    // The peak of the motion without contact is v0/10 without damping; 0.01/h is its target over the height h = 2 v0.
    let calibrate =
        r#", "calibrate": { "x": [0.01, 0.15], "minimise": "abs(peak(m.u)/h - 0.004)" }"#;
    let parameters = r#""law": "hertz", "k": 1, "k_h": 5000, "x": 0.1, "v0": "2*x", "h": "1 + v0""#;
    bench.file("s.json", study(parameters, calibrate));
    let done = bench.expect(0, &["calibrate", "s.json", "--out", "out"]);
    assert!(
        done.out.contains("there are no 95 % intervals"),
        "{}",
        done.out
    );
    let table = bench.text("out/s/calibration.csv");
    let best = number(&table, &["study", "x"], "best");
    bench.expect(0, &["run", "out/s/best.json", "--out", "best"]);
    let results = bench.text("best/best/results.csv");
    assert_eq!(number(&results, &["0"], "x"), best);
    assert_eq!(number(&results, &["0"], "v0"), 2.0 * best);
    let misfit = number(&bench.text("out/s/alternatives.csv"), &["study"], "misfit");
    assert!(misfit < 1e-6, "{misfit}");
    assert_eq!(
        cell(
            &bench.text("out/s/alternatives.csv"),
            &["study"],
            "numerical_from"
        ),
        "change with dt/2"
    );
}

#[test]
fn without_a_solution_the_exit_code_is_3_and_without_the_key_2() {
    let bench = Bench::new();
    let parameters = r#""law": "hertz", "k": 1, "k_h": 5000, "v0": 0.01"#;
    let calibrate =
        r#", "calibrate": { "k_h": [1e3, 1e4], "minimise": "1/impacts(gap)", "cases": 100 }"#;
    bench.file("s.json", study(parameters, calibrate));
    let done = bench.expect(3, &["calibrate", "s.json", "--out", "out"]);
    assert!(
        done.out.contains("no case has a solution with a misfit"),
        "{}",
        done.out
    );
    bench.file("t.json", study(parameters, ""));
    let done = bench.expect(2, &["calibrate", "t.json", "--out", "out"]);
    assert!(
        done.err
            .contains("t.json: the study has no key \"calibrate\""),
        "{}",
        done.err
    );
    assert!(!bench.path("out/t/calibration.csv").exists());
}

#[test]
fn intervals_are_those_of_the_residuals_at_the_best_point() {
    let bench = Bench::new();
    measure(&bench, TRUTH, "studies/test.csv", 3e-4, 1);
    // 100 cases end the search far from the best point, where residuals are correlated; the profiles find it.
    let interval = |name: &str, cases: &str| {
        let more = format!(
            "{}{}",
            measured("\"test.csv\""),
            FREE.replace("\"k\": {\"log\": [100, 1e5]}, ", "")
                .replace("3000", cases)
        );
        let parameters = r#""law": "hertz", "k": 1, "k_h": 5000, "v0": 1.2"#;
        bench.file(&format!("studies/{name}.json"), study(parameters, &more));
        bench.expect(0, &["calibrate", &format!("studies/{name}.json")]);
        let table = bench.text(&format!("figures/{name}/calibration.csv"));
        ["from", "to"].map(|end| number(&table, &["study", "k_h"], end))
    };
    let [few, many] =
        [("few", "100"), ("many", "20000")].map(|(name, cases)| interval(name, cases));
    let width = many[1] - many[0];
    for (few, many) in few.iter().zip(many) {
        assert!((few - many).abs() < 0.02 * width, "{few} {many}");
    }
}

#[test]
fn a_range_with_forbidden_values_hides_no_unused_parameter() {
    let bench = Bench::new();
    measure(&bench, TRUTH, "studies/test.csv", 3e-4, 1);
    // The middle of the range of m is no mass; k is a stiffness of other laws.
    let more = format!(
        r#"{}, "calibrate": {{ "k": {{"log": [100, 1e5]}}, "mass": [-1.5, 1.2], "minimise": "rms_error(m.u, measured)" }}"#,
        measured("\"test.csv\"")
    );
    let text = study(
        r#""law": "hertz", "k": 1000, "k_h": 20000, "v0": 1, "mass": 1"#,
        &more,
    )
    .replace(r#""m": 1 }"#, r#""m": "mass" }"#);
    bench.file("studies/one.json", text);
    let done = bench.expect(0, &["explain", "studies/one.json"]);
    assert!(
        done.out.contains("calibrate: does not use k\n"),
        "{}",
        done.out
    );
    assert!(done.out.contains("follow from mass"), "{}", done.out);
}

#[test]
fn a_search_without_a_used_parameter_says_so() {
    let bench = Bench::new();
    measure(&bench, TRUTH, "studies/test.csv", 3e-4, 1);
    let more = format!(
        r#"{}, "calibrate": {{ "k": {{"log": [100, 1e5]}}, "minimise": "rms_error(m.u, measured)" }}"#,
        measured("\"test.csv\"")
    );
    let parameters = r#""law": "hertz", "k": 1000, "k_h": 20000, "v0": 1"#;
    bench.file("studies/one.json", study(parameters, &more));
    let done = bench.expect(0, &["calibrate", "studies/one.json"]);
    assert!(done.out.contains("nothing was searched"), "{}", done.out);
}

#[test]
fn a_window_leaves_out_what_was_measured_before_it() {
    let bench = Bench::new();
    measure(&bench, TRUTH, "good.csv", 3e-4, 1);
    // The displacements before t = 0.1 are 50 mm too large.
    let text = bench.text("good.csv");
    let shifted = |line: &str| match line.split_once(',') {
        Some((t, u)) if t.parse().is_ok_and(|t: f64| t < 0.0999) => {
            format!("{t},{}\n", u.parse::<f64>().unwrap() + 50.0)
        }
        _ => format!("{line}\n"),
    };
    bench.file("test.csv", text.lines().map(shifted).collect::<String>());
    let window = FREE.replace("measured)", "measured,from = 0.1)");
    let more = format!("{}{window}", measured("\"test.csv\""));
    bench.file(
        "s.json",
        study(r#""law": "hertz", "k": 1, "k_h": 5000, "v0": 1.2"#, &more),
    );
    bench.expect(0, &["calibrate", "s.json", "--out", "out"]);
    // Steps of 0.002 from 0.1 to 0.6.
    let alternatives = bench.text("out/s/alternatives.csv");
    assert_eq!(
        number(&alternatives, &["study"], "residuals"),
        251.0,
        "{alternatives}"
    );
    let table = bench.text("out/s/calibration.csv");
    for (parameter, truth) in [("k_h", 20_000.0), ("v0", 1.0)] {
        let row = ["study", parameter];
        let [best, from, to] = ["best", "from", "to"].map(|name| number(&table, &row, name));
        // As without a window: of this noise, the truth is within twice the interval.
        let half = f64::max(to - best, best - from);
        assert!(from < best && best < to, "{table}");
        assert!((best - truth).abs() < 2.0 * half, "{parameter}: {table}");
    }
}
