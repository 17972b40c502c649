//! The store: reused, extended, damaged and locked, and after a killed run.

use crate::{Bench, Done, ONE, TWO, bars, friction};
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// 400 cases for each beta, in parts of 16 384, and a figure of some of them. beta varies slowest.
fn sweep(betas: u32, last: &str) -> String {
    let parameters = format!(
        r#""law": "velocity-control", "beta": {{"range": [0.01, {}, 0.01]}}, "dT": "pi/8", "duration": "8*pi",
        "x0": {{"linspace": [1, {last}, 400]}}"#,
        f64::from(betas) / 100.0
    );
    let figures = r#", "figures": [{"name": "error", "kind": "metric", "x": "x0", "y": "rms_error", "where": {"beta": 0.5}}]"#;
    friction(&parameters, figures)
}

/// The text of a run of `s.json` on stderr.
fn run(bench: &Bench) -> String {
    bench.expect(0, &["run", "s.json"]).err
}

/// The bytes of all files except the manifest, which depends on the path of the study.
fn bytes(bench: &Bench, folder: &str) -> Vec<(String, Vec<u8>)> {
    let names = bench
        .everything(folder)
        .into_iter()
        .filter(|name| !name.ends_with("manifest.json"));
    names
        .map(|name| {
            (
                name.clone(),
                fs::read(bench.path(folder).join(name)).unwrap(),
            )
        })
        .collect()
}

/// The results of a study in an empty folder.
fn undisturbed(study: &str) -> Vec<(String, Vec<u8>)> {
    let bench = Bench::new();
    bench.file("s.json", study);
    run(&bench);
    bytes(&bench, "figures/s")
}

fn parts(bench: &Bench) -> Vec<String> {
    let names = bench.everything("figures/s/store").into_iter();
    names.filter(|name| name.ends_with(".parquet")).collect()
}

#[test]
fn a_rerun_and_an_extended_study_compute_what_is_missing() {
    let bench = Bench::new();
    bench.file("s.json", sweep(100, "20"));
    assert_eq!(run(&bench), "s: 40000 cases run\n");
    assert_eq!(run(&bench), "s: 40000 of 40000 cases from the store\n");
    // The last part was not full: its cases are read from the former one. Two parts are new.
    bench.file("s.json", sweep(200, "20"));
    assert_eq!(
        run(&bench),
        "s: 40000 of 80000 cases from the store, 40000 cases run: different parameters, not in the store yet (2 parts)\n"
    );
    assert_eq!(bytes(&bench, "figures/s"), undisturbed(&sweep(200, "20")));
    // Fewer cases again: the last parts are removed.
    bench.file("s.json", sweep(100, "20"));
    assert_eq!(run(&bench), "s: 40000 of 40000 cases from the store\n");
    assert_eq!(bytes(&bench, "figures/s"), undisturbed(&sweep(100, "20")));
    // Another range of the fastest parameter changes most cases.
    let cases = || -> Vec<String> {
        let table = bench.text("figures/s/results.csv");
        let end = table.split(',').position(|name| name == "rms_error");
        let rows = table.lines().skip(1).enumerate();
        let case = |(number, row): (usize, &str)| {
            let cells: Vec<&str> = row.split(',').take(end.unwrap()).skip(1).collect();
            format!("{} {}", number / 16_384, cells.join(","))
        };
        rows.map(case).collect()
    };
    let former: BTreeSet<String> = cases().into_iter().collect();
    bench.file("s.json", sweep(100, "21"));
    let output = run(&bench);
    let kept = cases().iter().filter(|case| former.contains(*case)).count();
    // The first value of the range is the same for each beta.
    assert!((100..4000).contains(&kept), "{kept}");
    assert_eq!(
        output,
        format!(
            "s: {kept} of 40000 cases from the store, {} cases run: different parameters (3 parts)\n",
            40_000 - kept
        )
    );
    assert_eq!(bytes(&bench, "figures/s"), undisturbed(&sweep(100, "21")));
    let columns = sweep(100, "21").replace(
        ", \"figures\"",
        ", \"metrics\": [\"step_error\"], \"figures\"",
    );
    bench.file("s.json", columns);
    assert_eq!(
        run(&bench),
        "s: 40000 cases run: different columns (3 parts)\n"
    );
}

#[test]
fn a_damaged_part_is_reported_and_computed_again() {
    let bench = Bench::new();
    let study = sweep(100, "20");
    bench.file("s.json", &study);
    run(&bench);
    let whole = bytes(&bench, "figures/s");
    let name = format!("figures/s/store/{}", parts(&bench)[1]);
    let mut damaged = fs::read(bench.path(&name)).unwrap();
    let middle = damaged.len() / 2;
    damaged[middle] ^= 1;
    let cut = damaged[..middle].to_vec();
    for bytes_left in [damaged, cut, Vec::new()] {
        fs::write(bench.path(&name), bytes_left).unwrap();
        assert_eq!(
            run(&bench),
            format!("s: 23616 of 40000 cases from the store, 16384 cases run: {name} is damaged\n")
        );
        assert_eq!(bytes(&bench, "figures/s"), whole);
    }
    // The part is missing.
    fs::remove_file(bench.path(&name)).unwrap();
    assert_eq!(
        run(&bench),
        "s: 23616 of 40000 cases from the store, 16384 cases run: not in the store yet\n"
    );
    assert_eq!(bytes(&bench, "figures/s"), whole);
}

#[test]
fn after_a_killed_run_the_next_gives_the_same_bytes() {
    // Three parts of 16 384 cases of 640 steps. The run is killed when it has written two.
    let parameters = r#""law": "velocity-control", "beta": {"geomspace": [0.01, 1, 400]}, "dT": "pi/80", "duration": "8*pi",
        "x0": {"linspace": [1, 20, 120]}"#;
    let study = friction(parameters, "");
    let bench = Bench::new();
    bench.file("s.json", &study);
    let mut child = bench
        .command()
        .args(["run", "s.json", "--jobs", "1"])
        .stderr(Stdio::null())
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    while !bench.path("figures/s/store").exists() || parts(&bench).len() < 2 {
        sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(!bench.path("figures/s/results.csv").exists());
    let output = run(&bench);
    // The third part may be finished before the signal.
    let from_store: u64 = output.split_whitespace().nth(1).unwrap().parse().unwrap();
    assert!(from_store >= 2 * 16_384, "{output}");
    assert_eq!(bytes(&bench, "figures/s"), undisturbed(&study));
}

#[test]
fn a_second_run_on_one_store_is_an_error() {
    let bench = Bench::new();
    bench.file("s.json", sweep(100, "20"));
    run(&bench);
    let lock = File::open(bench.path("figures/s/store/.lock")).unwrap();
    lock.lock().unwrap();
    let done = bench.expect(1, &["run", "s.json"]);
    assert_eq!(
        done.err,
        "slipgap: figures/s/store is in use by another run; wait for it, or give another folder with --out\n"
    );
    bench.expect(0, &["run", "s.json", "--out", "other"]);
    lock.unlock().unwrap();
    bench.expect(0, &["run", "s.json"]);
}

#[test]
fn a_report_of_a_changed_study_waits_for_the_store() {
    let bench = Bench::new();
    bench.file("s.json", friction(TWO, ""));
    bench.expect(0, &["run", "s.json"]);
    bench.file("s.json", friction(ONE, ""));
    let lock = File::open(bench.path("figures/s/store/.lock")).unwrap();
    lock.lock().unwrap();
    let mut command = bench.command();
    command.args(["report", "s.json"]);
    let quiet = command.stdout(Stdio::null()).stderr(Stdio::piped());
    let mut child = quiet.spawn().unwrap();
    // Time for an attempt to lock the store. The test passes for any time.
    sleep(Duration::from_millis(500));
    assert_eq!(child.try_wait().unwrap(), None);
    lock.unlock().unwrap();
    let done = Done::from(child.wait_with_output().unwrap());
    assert_eq!(done.code, Some(0), "{done:?}");
    let results = bench.text("figures/s/results.csv");
    assert_eq!(results.lines().count(), 1 + 1, "{done:?}");
}

#[test]
fn formats_by_number_of_cases_and_by_option() {
    let bench = Bench::new();
    bench.file("s.json", sweep(100, "20"));
    let done = bench.expect(0, &["run", "s.json", "--format", "parquet", "--verbose"]);
    assert!(done.out.starts_with("figures/s/store\n"), "{}", done.out);
    assert!(!done.err.contains("no results.csv"), "{}", done.err);
    assert!(!bench.path("figures/s/results.csv").exists());
    bench.expect(0, &["run", "s.json"]);
    assert!(bench.path("figures/s/results.csv").exists());
    // Files that the new run does not write are removed.
    bench.expect(0, &["run", "s.json", "--format", "parquet"]);
    assert!(!bench.path("figures/s/results.csv").exists());
    bench.file("s.json", sweep(251, "20"));
    let done = bench.expect(0, &["run", "s.json", "--verbose"]);
    let why = "s.json: no results.csv, because there are more than 100000 cases; the store has them, and --format csv writes the table, too";
    assert!(done.out.starts_with("figures/s/store\n"), "{}", done.out);
    assert!(done.err.ends_with(&format!("\n{why}\n")), "{}", done.err);
    assert!(!bench.path("figures/s/results.csv").exists());
    bench.expect(0, &["run", "s.json", "--format", "csv"]);
    assert_eq!(bench.text("figures/s/results.csv").lines().count(), 100_401);
}

#[test]
fn with_fail_fast_the_first_unsolved_case_ends_the_run() {
    let bench = Bench::new();
    // A step of 10^300 takes the velocity beyond the largest double.
    let block = |steps: &str| {
        format!(
            r#"{{"parameters": {{"law": "displacement-control", "alpha": 1, "dT": {steps}, "duration": "10*dT"}}}}"#
        )
    };
    let study = |steps: &str| {
        format!(
            r#"{{"problem": "friction-oscillator", "blocks": [{}]}}"#,
            block(steps)
        )
    };
    bench.file("s.json", study("[0.1, 1e300, 2e300, 0.2]"));
    let done = bench.expect(3, &["run", "s.json", "--fail-fast"]);
    assert!(
        done.err.contains("s.json: case 1 could not be solved: "),
        "{}",
        done.err
    );
    assert!(!bench.path("figures/s/results.csv").exists());
    bench.expect(3, &["run", "s.json"]);
    let failures = bench.text("figures/s/failures.csv");
    let rows: Vec<&str> = failures.lines().collect();
    assert_eq!(rows.len(), 3);
    assert!(rows[0].starts_with("case,law,") && rows[0].ends_with(",reason"));
    assert!(rows[1].starts_with("1,displacement-control,") && rows[2].starts_with("2,"));
    // The store has them too, and they are reported again.
    let done = bench.expect(3, &["run", "s.json"]);
    assert!(
        done.err.contains("4 of 4 cases from the store"),
        "{}",
        done.err
    );
    assert!(
        done.err.contains("case 2 could not be solved: "),
        "{}",
        done.err
    );
    bench.file("s.json", study("[0.1, 0.2]"));
    bench.expect(0, &["run", "s.json"]);
    assert!(!bench.path("figures/s/failures.csv").exists());
}

#[cfg(unix)]
#[test]
fn a_full_disk_is_reported_and_complete_files_remain() {
    let bench = Bench::new();
    bench.file("s.json", sweep(100, "20"));
    run(&bench);
    let before = bytes(&bench, "figures/s");
    bench.file("s.json", sweep(300, "20"));
    // With a limit of 64 KiB for files, writing fails in the same place as on a full disk.
    let command = format!(
        "trap '' XFSZ; ulimit -f 128; exec {} run s.json --format csv",
        env!("CARGO_BIN_EXE_slipgap-tested")
    );
    let shell = Command::new("bash")
        .args(["-c", &command])
        .current_dir(bench.path(""))
        .output()
        .unwrap();
    assert_eq!(shell.status.code(), Some(1), "{shell:?}");
    let err = String::from_utf8_lossy(&shell.stderr);
    assert!(err.contains("slipgap: cannot write figures/s/"), "{err}");
    let names: Vec<String> = before.iter().map(|(name, _)| name.clone()).collect();
    let left = bytes(&bench, "figures/s");
    // Incomplete files are removed.
    assert!(
        left.iter().all(|(name, _)| !name.ends_with(".partial")),
        "{:?}",
        left.iter().map(|l| &l.0).collect::<Vec<_>>()
    );
    let results =
        |files: &[(String, Vec<u8>)]| files.iter().find(|(n, _)| n == "results.csv").cloned();
    assert_eq!(results(&left), results(&before));
    assert!(
        names
            .iter()
            .filter(|n| n.starts_with("store/part-"))
            .count()
            > 2
    );
    run(&bench);
    assert_eq!(bytes(&bench, "figures/s"), undisturbed(&sweep(300, "20")));
}

/// Python programs that read a column of the store and print it as JSON, their packages, and whether they read the folder
/// while a file in it is being written.
const READERS: [(&[&str], &str, bool); 5] = [
    (
        &["pandas", "pyarrow"],
        "t = pandas.read_parquet(store).sort_values('case')
assert (t['mass'] == 'lumped').all() and t['right.L'].isna().all()
column = t['rms_error_r'].tolist()",
        true,
    ),
    (
        &["pyarrow"],
        "import pyarrow.parquet
t = pyarrow.parquet.read_table(store).sort_by('case')
column = t['rms_error_r'].to_pylist()",
        true,
    ),
    (
        &["polars"],
        "t = polars.read_parquet(store).sort('case')
column = t['rms_error_r'].to_list()",
        false,
    ),
    (
        &["polars"],
        "t = polars.read_parquet(store + '/*.parquet').sort('case')
column = t['rms_error_r'].to_list()",
        true,
    ),
    (
        &["duckdb"],
        r#"parts = store + '/*.parquet'
q = duckdb.sql(f"""select rms_error_r from '{parts}' where mass = 'lumped' and "right" = 'wall' and "right.L" is null
    and n >= 4 order by "case" """).fetchall()
column = [r[0] for r in q]
m = duckdb.sql(f"""select decode(value) from parquet_kv_metadata('{parts}')
    where decode(key) = 'slipgap.description'""").fetchall()[0][0]
assert json.loads(m)['duration']['unit'] and json.loads(m)['gamma']['description'], m"#,
        true,
    ),
];

/// Tested if Python has these packages.
#[test]
fn other_programs_read_the_store() {
    let bench = Bench::new();
    let parameters =
        r#""gamma": [0.5, 1], "n": [4, 8, 16], "dt": 0.01, "duration": 1.5, "right": "wall""#;
    bench.file("s.json", bars(parameters, ""));
    // The lock of an earlier version, which these programs cannot read, is removed.
    bench.file("figures/s/store/lock", "");
    bench.expect(0, &["run", "s.json"]);
    let csv = bench.text("figures/s/results.csv");
    let number = csv
        .lines()
        .next()
        .unwrap()
        .split(',')
        .position(|c| c == "rms_error_r")
        .unwrap();
    let column: Vec<f64> = csv
        .lines()
        .skip(1)
        .map(|row| row.split(',').nth(number).unwrap().parse().unwrap())
        .collect();
    let python = std::env::var("SLIPGAP_PYTHON").unwrap_or("python3".into());
    let partial = "figures/s/store/.slipgap-0123456789aB.partial";
    for written in [false, true] {
        if written {
            bench.file(partial, "PAR1 and a beginning");
        }
        for (tools, program, while_written) in READERS {
            let names = tools.join(", ");
            let there = Command::new(&python)
                .args(["-c", &format!("import {names}")])
                .output();
            if !there.is_ok_and(|output| output.status.success()) {
                eprintln!("{names}: not installed for {python}, not looked at");
                continue;
            }
            if written && !while_written {
                continue;
            }
            let program = format!(
                "import json, {names}\nstore = 'figures/s/store'\n{program}\nprint(json.dumps(column))"
            );
            let output = Command::new(&python)
                .args(["-c", &program])
                .current_dir(bench.path(""))
                .output()
                .unwrap();
            assert!(
                output.status.success(),
                "{program}: {}",
                String::from_utf8_lossy(&output.stderr)
            );
            let read: Vec<f64> = serde_json::from_slice(&output.stdout).unwrap();
            assert_eq!(read, column, "{program}");
        }
    }
}

/// Programs that read a folder as one table find no file except parts and hidden files.
#[test]
fn a_store_has_only_parts_and_hidden_files() {
    let bench = Bench::new();
    let parameters = r#""law": "velocity-control", "beta": [0.1, 1], "dT": 0.5, "duration": 3"#;
    bench.file("s.json", friction(parameters, ""));
    // A file with content is the user's.
    bench.file("figures/s/store/lock", "mine");
    run(&bench);
    assert_eq!(bench.text("figures/s/store/lock"), "mine");
    fs::write(bench.path("figures/s/store/lock"), "").unwrap();
    // Locked by a run of an earlier version.
    let held = File::open(bench.path("figures/s/store/lock")).unwrap();
    held.lock().unwrap();
    run(&bench);
    assert!(bench.path("figures/s/store/lock").exists());
    held.unlock().unwrap();
    run(&bench);
    let names = bench.everything("figures/s/store");
    let shown = names
        .iter()
        .filter(|name| !name.starts_with('.'))
        .collect::<Vec<_>>();
    assert_eq!(shown.len(), 1);
    assert!(shown[0].starts_with("part-") && shown[0].ends_with(".parquet"));
}

#[test]
fn a_folder_that_cannot_be_written_is_reported_before_computing() {
    let bench = Bench::new();
    bench.file("s.json", sweep(100, "20"));
    // A file has the name of the folder.
    let done = bench.expect(1, &["run", "s.json", "--out", "s.json/out"]);
    assert!(
        done.err
            .contains("slipgap: cannot make folder s.json/out/s: "),
        "{}",
        done.err
    );
    bench.file("out/s/store", "");
    let done = bench.expect(1, &["run", "s.json", "--out", "out"]);
    assert!(
        done.err
            .contains("slipgap: cannot make folder out/s/store: "),
        "{}",
        done.err
    );
    let locked = bench.path("locked");
    fs::create_dir(&locked).unwrap();
    let mut rights = fs::metadata(&locked).unwrap().permissions();
    rights.set_readonly(true);
    fs::set_permissions(&locked, rights).unwrap();
    if fs::write(locked.join("probe"), "").is_ok() {
        eprintln!("this user may write in read-only folders: not looked at");
        return;
    }
    let done = bench.expect(1, &["run", "s.json", "--out", "locked"]);
    assert!(
        done.err.contains("slipgap: cannot make folder locked/s: "),
        "{}",
        done.err
    );
}
