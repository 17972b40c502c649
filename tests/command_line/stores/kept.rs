//! Stores: they have exactly the rows of their study, and results are used again only if nothing has changed.

use crate::{Bench, ONE, bars, friction};
use slipgap::batch::store;
use std::fs;
use std::process::Stdio;

/// The text of a run of `s.json` on stderr.
#[track_caller]
fn run(bench: &Bench) -> String {
    bench.expect(0, &["run", "s.json"]).err
}

/// The rows of the store and of results.csv, as sorted text.
fn rows(bench: &Bench) -> [Vec<String>; 2] {
    let stored_table = store::rows(&bench.path("figures/s")).unwrap();
    let stored = stored_table.rows.iter().map(|row| row.join(","));
    let csv_text = bench.text("figures/s/results.csv");
    let csv = csv_text.lines().skip(1).map(String::from);
    let sorted = |mut rows: Vec<String>| {
        rows.sort();
        rows
    };
    [sorted(stored.collect()), sorted(csv.collect())]
}

#[track_caller]
fn same_rows(bench: &Bench, cases: usize) {
    let [stored, csv] = rows(bench);
    assert_eq!((stored.len(), csv.len()), (cases, cases));
    assert!(stored == csv);
}

fn parts(bench: &Bench) -> Vec<String> {
    let names = bench.everything("figures/s/store").into_iter();
    names.filter(|name| name.ends_with(".parquet")).collect()
}

/// 50 000 cases in four chunks, slowest by beta from 0.02 to 1.
fn sweep(more: &str) -> String {
    let parameters = r#""law": "velocity-control", "beta": {"range": [0.02, 1, 0.02]}, "dT": 1, "duration": 4,
        "x0": {"linspace": [1, 20, 1000]}"#;
    friction(parameters, more)
}

#[test]
fn a_new_condition_removes_rows_of_the_former_study() {
    let bench = Bench::new();
    bench.file("s.json", sweep(""));
    run(&bench);
    same_rows(&bench, 50_000);
    // The chunk from beta 0.34 to 0.66 loses all its cases, and its neighbours some.
    bench.file(
        "s.json",
        sweep(r#", "when": "beta <= 0.31 or beta >= 0.89""#),
    );
    run(&bench);
    // 15 and 6 values of beta.
    same_rows(&bench, 21_000);
    assert_eq!(parts(&bench).len(), 3);
}

#[test]
fn copied_parts_are_removed_and_files_of_the_user_remain() {
    let bench = Bench::new();
    bench.file("s.json", sweep(""));
    run(&bench);
    let names = parts(&bench);
    let bytes = fs::read(bench.path(&format!("figures/s/store/{}", names[1]))).unwrap();
    // Further parts of a chunk: one from a killed run, one undamaged with another start, and one damaged.
    let sum = |name: &str| name.rsplit('-').next().unwrap().to_owned();
    let zeros = "0".repeat(32);
    for name in [
        format!("part-000000049152-{}", sum(&names[0])),
        format!("part-000000000000-{}", sum(&names[1])),
        format!("part-000000016384-{zeros}.parquet"),
        format!("part-00000003-{zeros}.parquet"),
        format!("part-000099999999-{zeros}.parquet"),
        // Copies of a user. Programs that read part-*.parquet would read them.
        "part-000000000000-mine.parquet".into(),
        "part-copy.parquet".into(),
    ] {
        bench.file(&format!("figures/s/store/{name}"), &bytes);
    }
    for name in ["mine.parquet", "notes.txt", "x.partial"] {
        bench.file(&format!("figures/s/store/{name}"), "mine");
    }
    assert_eq!(run(&bench), "s: 50000 of 50000 cases from the store\n");
    let mut kept = names;
    kept.push("mine.parquet".into());
    kept.sort();
    assert_eq!(parts(&bench), kept);
    same_rows(&bench, 50_000);
    for name in ["notes.txt", "x.partial"] {
        assert_eq!(bench.text(&format!("figures/s/store/{name}")), "mine");
    }
}

#[test]
fn after_a_report_the_store_and_the_table_have_the_same_rows() {
    let bench = Bench::new();
    let study = |betas: &str| friction(&format!("{ONE}, \"x0\": [{betas}]"), "");
    bench.file("s.json", study("10, 11, 12"));
    run(&bench);
    bench.file("s.json", study("10, 11"));
    let done = bench.expect(0, &["report", "s.json"]);
    assert!(
        done.err.contains("an earlier version of the study"),
        "{}",
        done.err
    );
    same_rows(&bench, 2);
    let done = bench.expect(0, &["report", "s.json"]);
    assert!(!done.err.contains("earlier version"), "{}", done.err);
}

#[test]
fn reports_of_one_study_wait_for_each_other() {
    let bench = Bench::new();
    bench.file("s.json", friction(ONE, ""));
    let begin = |_| {
        let mut command = bench.command();
        command
            .args(["report", "s.json"])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap()
    };
    let runs: Vec<_> = (0..6).map(begin).collect();
    for mut one in runs {
        assert!(one.wait().unwrap().success());
    }
    assert!(bench.text("figures/report.html").ends_with("</html>\n"));
}

#[cfg(unix)]
#[test]
fn a_part_that_cannot_be_removed_is_reported() {
    use std::os::unix::fs::PermissionsExt;
    let bench = Bench::new();
    bench.file("s.json", sweep(""));
    run(&bench);
    let extra = format!(
        "figures/s/store/part-000099999999-{}.parquet",
        "0".repeat(32)
    );
    bench.file(&extra, "no part of this study");
    // Files in such a folder can be read but not removed.
    let folder = bench.path("figures/s/store");
    fs::set_permissions(&folder, fs::Permissions::from_mode(0o555)).unwrap();
    let root = fs::write(folder.join("probe"), "").is_ok();
    if !root {
        let done = bench.expect(1, &["run", "s.json"]);
        assert!(
            done.err
                .contains(&format!("slipgap: cannot remove {extra}: ")),
            "{}",
            done.err
        );
    }
    fs::set_permissions(&folder, fs::Permissions::from_mode(0o755)).unwrap();
    if root {
        eprintln!("this user may remove from read-only folders: not looked at");
    }
}

#[test]
fn a_small_study_with_more_values_computes_only_the_new_cases() {
    let study = |gamma: &str, n: &str| {
        let parameters = format!(
            r#""gamma": {gamma}, "n": {n}, "mass": ["lumped", "consistent"], "dt": 0.01, "duration": 1.5"#
        );
        let metrics = r#", "metrics": ["peak_force", "mesh_error_r"],
            "figures": [{"name": "history", "kind": "history", "where": {"n": 4, "mass": "lumped"}, "by": "gamma"}]"#;
        bars(&parameters, metrics)
    };
    // 42, 63 and 84 cases: a new last value of gamma, a new first value of n, and a new middle value of each.
    let steps = [
        (study("[0.3, 0.5, 1]", "[2, 3, 4, 5, 6, 7, 8]"), 0, 42),
        (study("[0.3, 0.5, 1, 2]", "[2, 3, 4, 5, 6, 7, 8]"), 42, 56),
        (
            study("[0.3, 0.5, 1, 2]", "[1, 2, 3, 4, 5, 6, 7, 8]"),
            56,
            64,
        ),
        (
            study("[0.3, 0.4, 0.5, 1, 2]", "[1, 2, 4, 5, 6, 7, 8]"),
            56,
            70,
        ),
    ];
    let bench = Bench::new();
    for (text, kept, cases) in steps {
        bench.file("s.json", &text);
        let output = run(&bench);
        let expected = format!(
            "s: {kept} of {cases} cases from the store, {} cases run: different parameters\n",
            cases - kept
        );
        // A warning of bars that still touch may follow.
        assert!(kept == 0 || output.starts_with(&expected), "{output}");
        let new = Bench::new();
        new.file("s.json", &text);
        run(&new);
        for name in bench.everything("figures/s") {
            let read = |bench: &Bench| fs::read(bench.path(&format!("figures/s/{name}"))).unwrap();
            assert!(
                name == "manifest.json" || read(&bench) == read(&new),
                "{name}"
            );
        }
        same_rows(&bench, cases);
    }
    // The same cases in another order have other numbers. None is computed.
    bench.file(
        "s.json",
        study("[2, 1, 0.3, 0.4, 0.5]", "[8, 1, 2, 4, 5, 6, 7]"),
    );
    assert!(run(&bench).starts_with("s: 70 of 70 cases from the store\n"));
    same_rows(&bench, 70);
    // The cases of a damaged part are not used.
    let [name] = &parts(&bench)[..] else {
        panic!("one part");
    };
    let path = bench.path(&format!("figures/s/store/{name}"));
    let mut damaged = fs::read(&path).unwrap();
    damaged[100] ^= 1;
    fs::write(&path, damaged).unwrap();
    let output = run(&bench);
    assert!(
        output.starts_with("s: 70 cases run: ") && output.contains(" is damaged\n"),
        "{output}"
    );
}

#[test]
fn converged_results_are_not_used_for_a_study_without_iteration() {
    let bench = Bench::new();
    let parameters =
        r#""law": "displacement-control", "alpha": [0.1, 1], "dT": 0.5, "duration": 30"#;
    let once = r#", "iteration": "once""#;
    bench.file("s.json", friction(parameters, ""));
    run(&bench);
    let converged = bench.text("figures/s/results.csv");
    bench.file("s.json", friction(parameters, once));
    assert_eq!(run(&bench), "s: 2 cases run: different columns\n");
    let served = bench.text("figures/s/results.csv");
    assert_ne!(served, converged);
    let new = Bench::new();
    new.file("s.json", friction(parameters, once));
    run(&new);
    assert_eq!(served, new.text("figures/s/results.csv"));
}

#[test]
fn cases_after_a_longer_block_have_new_numbers() {
    // The first block fills the first chunk, so that the raw combinations of the second block are the same. With a weaker
    // condition its cases have other numbers.
    let bench = Bench::new();
    let study = |when: &str| {
        format!(
            r#"{{"problem": "friction-oscillator", "blocks": [
            {{"parameters": {{"law": "velocity-control", "beta": {{"linspace": [1, 16384, 16384]}}, "dT": 1, "duration": 2}},
              "when": "{when}"}},
            {{"parameters": {{"law": "displacement-control", "alpha": [0.1, 0.2, 0.3], "dT": 1, "duration": 2}}}}]}}"#
        )
    };
    bench.file("s.json", study("beta <= 10"));
    run(&bench);
    same_rows(&bench, 13);
    bench.file("s.json", study("beta <= 20"));
    let output = "s: 13 of 23 cases from the store, 10 cases run: different parameters (2 parts)\n";
    assert_eq!(run(&bench), output);
    same_rows(&bench, 23);
    let [stored, _] = rows(&bench);
    let second = stored
        .iter()
        .filter(|row| row.contains("displacement-control"));
    let mut numbers: Vec<u64> = second
        .map(|row| row.split(',').next().unwrap().parse().unwrap())
        .collect();
    numbers.sort_unstable();
    assert_eq!(numbers, [20, 21, 22]);
}

#[test]
fn histories_are_written_also_if_the_store_has_the_results() {
    let bench = Bench::new();
    let parameters =
        r#""law": "displacement-control", "alpha": [0.1, 1], "dT": 0.5, "duration": 3"#;
    bench.file("s.json", friction(parameters, ""));
    run(&bench);
    bench.expect(0, &["run", "s.json", "--histories"]);
    for case in [0, 1] {
        // The header and steps 0 to 6.
        assert_eq!(
            bench
                .text(&format!("figures/s/histories/{case}.csv"))
                .lines()
                .count(),
            8
        );
    }
}

#[test]
fn other_blocks_do_not_change_the_indices_of_a_saltelli_design() {
    let bench = Bench::new();
    let block = r#"{"parameters": {"law": "velocity-control", "beta": {"uniform": [0.5, 2]}, "x0": {"uniform": [5, 15]},
        "dT": 0.5, "duration": 10}, "design": {"kind": "saltelli", "n": 32}}"#;
    let other = r#"{"parameters": {"law": "displacement-control", "alpha": [0.1, 0.5, 1], "dT": 0.5, "duration": 10}}"#;
    let mut tables = Vec::new();
    for (number, blocks) in [
        (0, vec![block]),
        (0, vec![block, other]),
        (1, vec![other, block, other]),
    ] {
        let blocks = blocks.join(",");
        bench.file(
            "s.json",
            format!(r#"{{"problem": "friction-oscillator", "blocks": [{blocks}]}}"#),
        );
        run(&bench);
        let table = bench.text("figures/s/sobol.csv");
        let pairs = table
            .lines()
            .skip(1)
            .map(|row| row.split_once(',').unwrap());
        let rows: Vec<String> = pairs
            .map(|(block, rest)| {
                assert_eq!(block, number.to_string());
                rest.to_owned()
            })
            .collect();
        assert!(
            rows.iter()
                .any(|row| row.starts_with("rms_error,beta,") && !row.ends_with(',')),
            "{table}"
        );
        tables.push(rows);
    }
    assert_eq!(tables[0], tables[1]);
    assert_eq!(tables[0], tables[2]);
}

#[test]
fn the_estimate_of_many_indices_is_announced() {
    // 10^5 cases of one step. The indices take longer.
    let bench = Bench::new();
    let study = r#"{"problem": "friction-oscillator", "parameters": {"law": "velocity-control",
        "beta": {"uniform": [0.5, 2]}, "x0": {"uniform": [5, 15]}, "dT": 1, "duration": 1},
        "design": {"kind": "saltelli", "n": 25000}}"#;
    bench.file("s.json", study);
    let announced = "s: 100000 cases run\ns: estimating Sobol' indices\n";
    assert!(run(&bench).starts_with(announced));
    // With a thousand cases there is no line.
    bench.file("s.json", study.replace("25000", "250"));
    assert!(!run(&bench).contains("estimating"));
}

#[test]
fn a_changed_record_is_no_change_of_columns() {
    let bench = Bench::new();
    let study = |k: u32, metrics: &str| {
        format!(
            r#"{{ "problem": "structure", "parameters": {{ "dt": 0.01, "duration": 0.1 }},
            "structure": {{ "units": "t, kN, m, s", "masses": {{ "m": 1 }}, "springs": [{{ "between": ["ground", "m"], "k": {k} }}],
                "ground": {{ "record": "a.csv", "unit": "m/s2" }} }}, "metrics": [{metrics}] }}"#
        )
    };
    let peak = "\"peak(m)\"";
    bench.file("a.csv", "t,a\n0,0\n0.05,1\n0.1,0\n");
    bench.file("s.json", study(100, peak));
    assert_eq!(run(&bench), "s: 1 case run\n");
    bench.file("a.csv", "t,a\n0,0\n0.05,2\n0.1,0\n");
    assert_eq!(run(&bench), "s: 1 case run: the records have changed\n");
    bench.file("s.json", study(200, peak));
    assert_eq!(run(&bench), "s: 1 case run: the structure has changed\n");
    bench.file("s.json", study(200, "\"max(m)\""));
    assert_eq!(run(&bench), "s: 1 case run: different columns\n");
}
