//! Metrics against what was measured, compared with sums over the histories of the same cases.

use crate::{Input, Study};
use slipgap_problem::problem::table::cases::Cases;
use slipgap_problem::problem::{Case, MeasuredChannel, Solution};
use std::path::PathBuf;

/// A folder of its own for a test.
fn folder(name: &str) -> PathBuf {
    let name = format!("slipgap-measured-{name}-{}", std::process::id());
    let folder = std::env::temp_dir().join(name);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn read(folder: &std::path::Path, text: &str) -> Result<Study, String> {
    let file = folder.join("s.json").display().to_string();
    let study = Input::new(&file, text).study(1000);
    study.map_err(|error| error.to_string())
}

fn study(folder: &std::path::Path, text: &str) -> Study {
    read(folder, text).unwrap_or_else(|why| panic!("{why}"))
}

/// A table with a header and rows.
fn write(folder: &std::path::Path, name: &str, header: &str, columns: &[&[f64]]) {
    let mut text = format!("{header}\n");
    for i in 0..columns[0].len() {
        let row: Vec<String> = columns
            .iter()
            .map(|column| format!("{:e}", column[i]))
            .collect();
        text += &row.join(",");
        text.push('\n');
    }
    std::fs::write(folder.join(name), text).unwrap();
}

/// A mass that strikes another one, with these parameters, this `measured` and these metrics.
fn pounding(parameters: &str, measured: &str, metrics: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 4, {parameters}}},
            "structure": {{"units": "t, kN, m, s", "masses": {{"deck": 1, "wall": 2}},
              "springs": [{{"between": ["ground", "deck"], "k": "k", "c": 0.2}}, {{"between": ["ground", "wall"], "k": 60}}],
              "contacts": {{"gap": {{"law": "hunt-crossley", "between": ["deck", "wall"], "k_h": 3000, "restitution": 0.6, "gap": 0.05}}}},
              "start": {{"deck": {{"v": 1}}}}}},
            {measured} "metrics": [{metrics}]}}"#
    )
}

fn solved(study: &Study, case: &Case) -> Solution {
    study.problem.solve(case, &[]).unwrap()
}

/// The computed channel at the compared times of a measured one, by lines between the two steps beside each time.
fn at(solution: &Solution, measured: &MeasuredChannel, dt: f64) -> Vec<f64> {
    let u = solution.computed.channel(measured.column);
    let value = |t: &f64| {
        let after = (1..u.len() - 1)
            .find(|i| *i as f64 * dt > *t)
            .unwrap_or(u.len() - 1);
        let share = t / dt - (after - 1) as f64;
        u[after - 1] * (1.0 - share) + u[after] * share
    };
    measured.time[measured.compared.clone()]
        .iter()
        .map(value)
        .collect()
}

const KEY: &str = r#""measured": {"file": "a.csv", "time": {"column": "ms", "unit": "ms"},
    "columns": {"deck.u": {"column": "disp", "unit": "mm"}, "gap.S": {"column": "F", "unit": "N"}, "wall.a": {"column": "acc", "unit": "g"}},
    "delay": "lag"},"#;

#[test]
fn errors_are_sums_over_the_measured_times_in_the_units_of_the_study() {
    let folder = folder("sums");
    // Uneven times from -0.1 to 5 s, in ms.
    let times: Vec<f64> = (0..300)
        .map(|i| -100.0 + f64::from(i * 17 + i * i % 7))
        .collect();
    let wave = |size: f64, omega: f64| -> Vec<f64> {
        times
            .iter()
            .map(|t| size * (omega * t / 1000.0).cos())
            .collect()
    };
    let (disp, force, acc) = (wave(90.0, 5.0), wave(700.0, 3.0), wave(0.8, 6.0));
    write(
        &folder,
        "a.csv",
        "ms,disp,F,acc",
        &[&times, &disp, &force, &acc],
    );
    let metrics = r#""rms_error(deck, measured)", "peak_error(gap.S,measured)", "last_error(wall.a, measured)", "rms_error(deck,measured)/2",
        "rms_error(gap.S , measured)", "rms_error(deck, measured, from=1+lag, to=3)", "peak_error(gap.S, measured, to=2)""#;
    let text = pounding(r#""k": [100, 140], "lag": [0.25, 0]"#, KEY, metrics);
    let study = study(&folder, &text);
    assert_eq!(study.len(), 4);
    for case in study.cases() {
        let solution = solved(&study, &case);
        let measured = study.problem.as_structure().unwrap().measured(&case);
        let names: Vec<&str> = measured
            .iter()
            .map(|channel| channel.name.as_str())
            .collect();
        assert_eq!(names, ["deck.u", "gap.S", "wall.a"]);
        let lag = case.number("lag").unwrap();
        let deck = &measured[0];
        // Within the motion, 0 to 4, for both delays: from 0.25 to 4 in the time of the file.
        let inside = |t: &f64| (250.0..=4000.0).contains(t);
        assert_eq!(deck.compared.start, times.iter().position(inside).unwrap());
        assert_eq!(
            deck.compared.len(),
            times.iter().filter(|t| inside(t)).count()
        );
        let sizes = [(&disp, 1e-3), (&force, 1e-3), (&acc, 9.80665)];
        for (channel, (column, size)) in measured.iter().zip(sizes) {
            for i in 0..times.len() {
                assert!((channel.time[i] - (times[i] / 1000.0 - lag)).abs() < 1e-14);
                assert!((channel.values[i] - column[i] * size).abs() < 1e-15 * size * 1000.0);
            }
        }
        let [u, s, a] = [0, 1, 2].map(|i| at(&solution, &measured[i], 0.01));
        let m = |i: usize| &measured[i].values[measured[i].compared.clone()];
        let rms = |c: &[f64], m: &[f64]| {
            let squares = c.iter().zip(m).map(|(c, m)| (c - m) * (c - m));
            (squares.sum::<f64>() / c.len() as f64).sqrt()
        };
        let peak = |x: &[f64]| x.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let window = |from: f64, to: f64| {
            let compared = measured[0].time[measured[0].compared.clone()].iter();
            let inside: Vec<usize> = (0..)
                .zip(compared)
                .filter(|(_, t)| (from..=to).contains(*t))
                .map(|(i, _)| i)
                .collect();
            inside[0]..inside[inside.len() - 1] + 1
        };
        let expected = [
            rms(&u, m(0)),
            (peak(&s) - peak(m(1))).abs(),
            (a.last().unwrap() - m(2).last().unwrap()).abs(),
            rms(&u, m(0)),
            rms(&s, m(1)),
            {
                let part = window(1.0 + lag, 3.0);
                rms(&u[part.clone()], &m(0)[part])
            },
            {
                let part = window(0.0, 2.0);
                (peak(&s[part.clone()]) - peak(&m(1)[part])).abs()
            },
        ];
        // Both have the round-off of a place between two steps, 400 times 1e-16, times a step of the force of some 10.
        for (value, expected) in solution.metrics.iter().zip(expected) {
            let error = (value.unwrap() - expected).abs();
            assert!(
                error < 1e-12 * (1.0 + expected),
                "{value:?}, not {expected}"
            );
        }
    }
}

#[test]
fn cases_side_by_side_have_the_metrics_of_each() {
    let folder = folder("lanes");
    let times: Vec<f64> = (0..200).map(|i| f64::from(i) * 21.3).collect();
    let sine: Vec<f64> = times.iter().map(|t| 80.0 * (t / 90.0).sin()).collect();
    write(
        &folder,
        "a.csv",
        "ms,disp,F,acc",
        &[&times, &sine, &sine, &sine],
    );
    let metrics = r#""rms_error(deck, measured)", "sprague_geers_combined(wall.a, measured)", "sprague_geers_phase(gap.S, measured)""#;
    let text = pounding(
        r#""k": [100, 140], "lag": {"linspace": [0, 0.3, 21]}"#,
        KEY,
        metrics,
    );
    let study = study(&folder, &text);
    let listed: Vec<Case> = study.cases().collect();
    let mut cases = Cases::new(study.problem.schema());
    listed.iter().for_each(|case| cases.push(case));
    let rows: Vec<u32> = (0..listed.len() as u32).collect();
    let table = study.problem.sweep(&cases, &rows);
    for (i, case) in listed.iter().enumerate() {
        let alone = solved(&study, case).metrics;
        let row: Vec<Option<f64>> = table.row(i).collect();
        assert_eq!(row, alone, "{i}");
        assert!(alone.iter().all(Option::is_some));
    }
}

#[test]
fn a_file_of_the_motion_itself_has_no_error() {
    let folder = folder("itself");
    let rows: Vec<f64> = (0..20).map(|i| f64::from(i) * 0.1).collect();
    write(&folder, "a.csv", "t,u,S,r", &[&rows, &rows, &rows, &rows]);
    let key = |more: &str| {
        format!(
            r#""measured": {{"file": "a.csv", "time": "t", "columns": {{"deck": "u", "gap.S": "S", "gap.r": "r"}}{more}}},"#
        )
    };
    let metrics = r#""rms_error(deck.u, measured)", "sprague_geers_magnitude(deck, measured)", "sprague_geers_phase(deck, measured)",
        "sprague_geers_combined(deck, measured)", "loop_distance(gap.r, gap.S, measured)", "energy_per_cycle(gap, measured)",
        "energy_per_cycle(gap)", "peak_error(gap.S, measured)""#;
    let text = |more: &str| pounding(r#""k": 100"#, &key(more), metrics);
    let first = study(&folder, &text(""));
    let case = first.case(0).unwrap();
    let solution = solved(&first, &case);
    let columns: Vec<usize> = first
        .problem
        .as_structure()
        .unwrap()
        .measured(&case)
        .iter()
        .map(|channel| channel.column)
        .collect();
    let [u, s, r] = [0, 1, 2].map(|i| solution.computed.channel(columns[i]));
    // The file begins 0.7 s before the motion; forces and displacements are 1.25 times as large.
    let larger = |x: &[f64]| -> Vec<f64> { x.iter().map(|x| 1.25 * x).collect() };
    let shifted: Vec<f64> = solution.computed.time.iter().map(|t| t + 0.7).collect();
    write(&folder, "a.csv", "t,u,S,r", &[&shifted, u, s, r]);
    let same = study(&folder, &text(r#", "delay": 0.7"#));
    let values = solved(&same, &same.case(0).unwrap()).metrics;
    let energy = values[6].unwrap();
    for (index, value) in values.iter().enumerate().filter(|(index, _)| *index != 6) {
        // A time has a round-off of 1e-16 times 4.7/0.01 steps, times a step of the force of some 10; a distance is of points along
        // a line.
        assert!(value.unwrap().abs() < 1e-9, "{index}: {value:?}");
    }
    assert!(energy > 0.0);
    write(
        &folder,
        "a.csv",
        "t,u,S,r",
        &[&shifted, &larger(u), &larger(s), r],
    );
    let other = study(&folder, &text(r#", "delay": 0.7"#));
    let values = solved(&other, &other.case(0).unwrap()).metrics;
    let squares = u.iter().map(|u| u * u / 16.0).sum::<f64>() / u.len() as f64;
    let peak = s.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    let expected = [
        squares.sqrt(),
        1.0 / 1.25 - 1.0,
        0.0,
        0.2,
        f64::NAN,
        0.2,
        energy,
        0.25 * peak,
    ];
    for (index, (value, expected)) in values.iter().zip(expected).enumerate() {
        let error = (value.unwrap() - expected).abs();
        assert!(
            error < 1e-9 || index == 4,
            "{index}: {value:?}, not {expected}"
        );
    }
    // The forces over their half range are the same but for the factor 1/1.25.
    assert!(values[4].unwrap() > 0.001, "{:?}", values[4]);
}

#[test]
fn an_elastic_plastic_slider_takes_the_energy_of_its_parallelogram() {
    // r = 0.75 (1 - cos 2 t) has the half range X = 0.75, the force 5 is reached at x_y = 5/40: W = 4 * 5 (X - x_y) = 12.5.
    let text = r#"{"problem": "structure", "parameters": {"dt": "pi/2000", "duration": "12*pi"},
        "structure": {"masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 1}],
          "supports": {"s": {"sine": {"amplitude": 3, "omega": 2, "phase": "pi/2"}}},
          "contacts": {"slider": {"law": "displacement-control", "between": ["ground", "s"], "k": 40, "limit": 5}}},
        "metrics": ["energy_per_cycle(slider)", "energy_per_cycle(slider, from=pi)", "energy_per_cycle(slider, from = pi, to=1.5*pi)"]}"#;
    let study = study(&folder("slider"), text);
    let case = study.case(0).unwrap();
    let computed = solved(&study, &case).metrics;
    let problem = study.problem.as_structure().unwrap();
    let exact = problem.exact_metrics(&case, &[0, 1, 2]);
    for energies in [computed, exact] {
        for energy in &energies[..2] {
            // Twice in a cycle the force bends within a step, which cuts a triangle of k (1.5 dt)^2/2 = 1.1e-4 at most.
            let energy = energy.unwrap();
            assert!((energy - 12.5).abs() < 2.2e-4, "{energy}");
        }
        // Half a cycle is none.
        assert_eq!(energies[2], None);
    }
}

#[test]
fn the_points_are_the_same_for_every_delay_of_a_study() {
    let folder = folder("delays");
    let times: Vec<f64> = (0..600).map(|i| f64::from(i) * 10.0).collect();
    write(
        &folder,
        "a.csv",
        "ms,disp,F,acc",
        &[&times, &times, &times, &times],
    );
    let compared = |parameters: &str| {
        let text = pounding(parameters, KEY, "\"rms_error(deck, measured)\"");
        let study = study(&folder, &text);
        let compared = study.cases().map(|case| {
            study.problem.as_structure().unwrap().measured(&case)[0]
                .compared
                .clone()
        });
        let mut ranges: Vec<_> = compared.collect();
        ranges.dedup();
        assert_eq!(ranges.len(), 1, "{parameters}");
        ranges.remove(0)
    };
    assert_eq!(compared(r#""k": 100, "lag": 0"#), 0..401);
    assert_eq!(compared(r#""k": 100, "lag": 0.5"#), 50..451);
    assert_eq!(compared(r#""k": 100, "lag": [0.5, 1, 0.2]"#), 100..421);
    assert_eq!(compared(r#""k": [1, 20], "lag": "k/20""#), 100..406);
    assert_eq!(
        compared(r#""k": [1, 20], "shift": {"range": [1, 3, 1]}, "lag": "shift/k""#),
        300..406
    );
}

#[test]
fn several_files_are_an_axis() {
    let folder = folder("files");
    let times: Vec<f64> = (0..50).map(|i| f64::from(i) * 0.05).collect();
    for (name, size) in [("run-b.csv", 2.0), ("run-a.csv", 1.0), ("other.csv", 9.0)] {
        let u: Vec<f64> = times.iter().map(|t| size * t).collect();
        write(&folder, name, "t,u", &[&times, &u]);
    }
    let columns = r#""time": "t", "columns": {"deck.u": "u"}"#;
    let axis = format!(r#""measured": {{"file": {{"files": "run-*.csv"}}, {columns}}},"#);
    let metrics = "\"rms_error(deck, measured)\"";
    let by_files = study(&folder, &pounding(r#""k": [100, 120]"#, &axis, metrics));
    let files: Vec<&str> = by_files
        .cases()
        .map(|case| case.choice("measured"))
        .collect();
    assert_eq!(files, ["run-a.csv", "run-b.csv", "run-a.csv", "run-b.csv"]);
    for case in by_files.cases() {
        let file = case.choice("measured");
        let one = format!(r#""measured": {{"file": "{file}", {columns}}},"#);
        let k = format!("\"k\": {}", case.number("k").unwrap());
        let one = study(&folder, &pounding(&k, &one, metrics));
        let alone = solved(&one, &one.case(0).unwrap());
        assert_eq!(solved(&by_files, &case).metrics, alone.metrics);
    }
    // A parameter of any name.
    let block = format!(r#""measured": {{"file": "test", {columns}}},"#);
    let text = pounding(
        r#""k": 100, "test": ["run-b.csv", "other.csv"]"#,
        &block,
        metrics,
    );
    let named = study(&folder, &text);
    let values =
        |study: &Study, case| study.problem.as_structure().unwrap().measured(&case)[0].values[40];
    assert_eq!(values(&named, named.case(0).unwrap()), 4.0);
    assert_eq!(values(&named, named.case(1).unwrap()), 18.0);
    let none = axis.replace("run-*", "walk-*");
    let fault = read(&folder, &pounding(r#""k": 100"#, &none, metrics)).unwrap_err();
    assert!(
        fault.contains("measured.file.files: \"walk-*.csv\": no file in"),
        "{fault}"
    );
}

#[test]
fn measurements_need_no_exact_motion_and_change_only_their_own_identity() {
    let folder = folder("identity");
    let times: Vec<f64> = (0..50).map(|i| f64::from(i) * 0.1).collect();
    let zero = vec![0.0; 50];
    write(&folder, "a.csv", "t,u", &[&times, &zero]);
    let identity = |more: &str| {
        let text = format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.1, "duration": 3}}, "structure": {{"masses": {{"m": 1}}}}{more}}}"#
        );
        let study = study(&folder, &text);
        study.problem.as_structure().unwrap().identity().to_owned()
    };
    // SHA-256 of {"masses":{"m":1}} and of nothing, by another program.
    let plain = "58b6fd2908f50ba7561fb16fa6ad80dc1d7a2d39546320fc3bda8a392d10afff.e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
    assert_eq!(identity(""), plain);
    let measured = |columns: &str, more: &str| {
        format!(
            r#", "measured": {{"file": "a.csv", "time": "t", "columns": {{{columns}}}{more}}}, "metrics": ["rms_error(m, measured)"]"#
        )
    };
    let first = identity(&measured(r#""m.u": "u""#, ""));
    let mut identities = vec![plain.to_owned(), first.clone()];
    identities.push(identity(&measured(r#""m.u": "t""#, "")));
    identities.push(identity(&measured(r#""m.u": "u""#, r#", "delay": 0.1"#)));
    write(&folder, "a.csv", "t,u", &[&times, &times]);
    identities.push(identity(&measured(r#""m.u": "u""#, "")));
    let count = identities.len();
    identities.sort();
    identities.dedup();
    assert_eq!(identities.len(), count);
    // The exact motion of the metric would be at work.
    let text = pounding(
        r#""k": 100"#,
        r#""measured": {"file": "a.csv", "time": "t", "columns": {"deck": "u"}},"#,
        r#""rms_error(deck, measured)""#,
    );
    let compared = study(&folder, &text);
    assert_eq!(
        compared
            .problem
            .work(&compared.case(0).unwrap(), &[])
            .references,
        0
    );
    assert!(compared.problem.schema().budgets.is_empty());
    assert_eq!(compared.problem.metrics()[0].unit, "m");
    assert_eq!(
        compared.problem.metrics()[0].symbol,
        "rms error of displacement of deck against what was measured, m"
    );
}
