//! What is said about files: measured values in another unit, times before t = 0, steps against the header, and the order of files.

use crate::Bench;

/// A free oscillation sin t, compared with a file by a metric, with more keys of `measured`.
fn oscillation(more: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 4}},
          "structure": {{"units": "t, kN, m, s", "masses": {{"a": 1}}, "springs": [{{"between": ["ground", "a"], "k": 1}}],
            "start": {{"a": {{"v": 1}}}}}},
          "measured": {{"file": "u.csv", "time": "t", "columns": {{"a.u": "u"}}{more}}}, "metrics": ["rms_error(a, measured)"]}}"#
    )
}

/// A file with sin(t - `late`) times a factor, from `from` on.
fn sine(factor: f64, from: f64, late: f64) -> String {
    let row = |i: u32| {
        let t = from + f64::from(i) / 10.0;
        format!("{t},{}\n", factor * (t - late).sin())
    };
    format!("t,u\n{}", (0..40).map(row).collect::<String>())
}

#[test]
fn measured_values_in_another_unit_are_found() {
    let bench = Bench::new();
    for (factor, is_found) in [
        (1000.0, true),
        (100.0, true),
        (0.001, true),
        (10.0, false),
        (1.0, false),
    ] {
        bench.file("u.csv", sine(factor, 0.0, 0.0));
        let kinds = bench.kinds(&oscillation(""));
        assert_eq!(
            kinds.iter().any(|kind| kind.0 == "measured-scale"),
            is_found,
            "{factor} {kinds:?}"
        );
    }
    bench.file("u.csv", sine(1000.0, 0.0, 0.0));
    let millimetres = oscillation("").replace(
        r#"{"a.u": "u"}"#,
        r#"{"a.u": {"column": "u", "unit": "mm"}}"#,
    );
    assert!(bench.kinds(&millimetres).is_empty());
}

#[test]
fn times_before_the_start_are_a_note() {
    let bench = Bench::new();
    bench.file("u.csv", sine(1.0, -1.0, 0.0));
    let note = "\"u.csv\" begins at t = -1, and its points before t = 0 are not compared: \"delay\": -1 makes its first point t = 0";
    for (more, is_noted) in [
        ("", true),
        (r#", "delay": 0"#, false),
        (r#", "delay": -1"#, false),
    ] {
        bench.file("s.json", oscillation(more));
        for verb in ["run", "explain"] {
            let done = bench.expect(0, &[verb, "s.json"]);
            let said = done.err.contains(note) || done.out.contains(note);
            assert_eq!(said, is_noted, "{verb} {more} {done:?}");
        }
    }
    // What is before t = 0 is not used, and "start" says that this is meant.
    bench.file("g.csv", "t,a\n-2,0\n-1,5\n0,0\n1,3\n2,0\n");
    let study = |more: &str| {
        format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 4}},
              "structure": {{"units": "t, kN, m, s", "masses": {{"a": 1}}, "springs": [{{"between": ["ground", "a"], "k": 1}}],
                "ground": {{"record": "g.csv", "unit": "m/s2"{more}}}}}, "metrics": ["ground.pga"]}}"#
        )
    };
    for (more, is_noted) in [("", true), (r#", "start": 0"#, false)] {
        bench.file("s.json", study(more));
        let done = bench.expect(0, &["run", "s.json"]);
        let note = "\"g.csv\" begins at t = -2, and what is before t = 0 is not used";
        assert_eq!(done.err.contains(note), is_noted, "{done:?}");
        let row = bench.text("figures/s/results.csv");
        assert!(
            row.lines().nth(1).unwrap().ends_with(",3.0") || row.ends_with(",3\n"),
            "{row}"
        );
    }
}

/// A mass on a record with more keys of the ground.
fn shaken(record: &str, more: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1}},
"structure": {{"units": "t, kN, m, s", "masses": {{"a": 1}}, "springs": [{{"between": ["ground", "a"], "k": 1}}],
"ground": {{"record": {record}{more}}}}}, "metrics": ["ground.pga"]}}"#
    )
}

#[test]
fn a_step_against_the_header_is_refused_at_its_key() {
    let bench = Bench::new();
    bench.file(
        "a.AT2",
        "x\nx\nUNITS OF G\nNPTS= 6, DT= .01 SEC\n0 .1 .2\n.1 0 0\n",
    );
    bench.file(
        "s.json",
        shaken(r#""a.AT2""#, r#", "dt": 0.005, "column": 1"#),
    );
    let done = bench.expect(2, &["run", "s.json"]);
    let message = "s.json:3:37: structure.ground.dt: \"a.AT2\": line 4: dt is 0.005, but 0.01 by DT of line 4; give 0.01";
    assert!(done.err.contains(message), "{done:?}");
    bench.file(
        "s.json",
        shaken(r#""a.AT2""#, r#", "dt": 0.01, "column": 1, "unit": "m/s2""#),
    );
    let done = bench.expect(2, &["run", "s.json"]);
    assert!(
        done.err.contains("the unit is m/s2, but the file is in g"),
        "{done:?}"
    );
    bench.file(
        "s.json",
        shaken(r#""a.AT2""#, r#", "dt": 0.01, "column": 1"#),
    );
    bench.expect(0, &["run", "s.json"]);
    let row = bench.text("figures/s/results.csv");
    assert!(row.lines().nth(1).unwrap().ends_with(",1.96133"), "{row}");
}

#[test]
fn files_are_in_the_order_of_their_numbers() {
    let bench = Bench::new();
    for number in [1, 2, 10, 100] {
        bench.file(
            &format!("r_{number}.csv"),
            format!("t,a\n0,0\n0.5,{number}\n1,0\n"),
        );
    }
    bench.file(
        "s.json",
        shaken(r#"{"files": "r_*.csv"}"#, r#", "unit": "m/s2""#),
    );
    bench.expect(0, &["run", "s.json"]);
    let table = bench.text("figures/s/results.csv");
    let peaks: Vec<f64> = table
        .lines()
        .skip(1)
        .map(|row| row.rsplit(',').next().unwrap().parse().unwrap())
        .collect();
    assert_eq!(peaks, [1.0, 2.0, 10.0, 100.0]);
}
