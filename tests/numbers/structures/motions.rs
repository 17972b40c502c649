//! What a study does to a motion: a part of it, its baseline, its strength and its delay; files as an axis. Compared with the records
//! that an independent program read (tests/reference/records.py).

use serde_json::Value as Json;
use slipgap::study::{self, Study};
use slipgap_system::system::loads::measures::Measure;
use slipgap_system::system::loads::spectrum;
use slipgap_system::system::structure::Table;
use std::path::Path;

const G: f64 = 9.80665;

/// The record of most tests.
const APEEL: &str = "lomaprieta-1989-redwoodcity-apeel2-043.smc";

fn parse(text: &str) -> Result<Study, String> {
    // In this folder, ../records has the records.
    let file = Path::new(env!("SLIPGAP_ROOT")).join("studies/recorded/s.json");
    study::parse(&file.to_string_lossy(), text).map_err(|why| why.to_string())
}

/// An oscillator with these parameters on this ground.
fn text(parameters: &str, ground: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{{parameters} "dt": 0.01, "duration": 1}}, "metrics": ["peak(m)"],
          "structure": {{"units": "kg, N, m, s", "masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], "k": 1}}],
            "ground": {ground}}}}}"#
    )
}

fn study(parameters: &str, ground: &str) -> Study {
    parse(&text(parameters, ground)).unwrap_or_else(|why| panic!("{why}"))
}

fn faults(parameters: &str, ground: &str) -> String {
    parse(&text(parameters, ground)).unwrap_err()
}

/// The motion of the record with these keys.
fn motion(keys: &str) -> Table {
    let study = study("", &format!(r#"{{"record": "../records/{APEEL}"{keys}}}"#));
    of_case(&study, 0)
}

fn of_case(study: &Study, case: u64) -> Table {
    let case = study.case(case).unwrap();
    study
        .problem
        .as_structure()
        .unwrap()
        .ground_motion(&case)
        .unwrap()
        .acceleration
}

fn peak(table: &Table) -> f64 {
    table
        .values()
        .iter()
        .fold(0.0, |peak: f64, a| peak.max(a.abs()))
}

fn velocity(table: &Table) -> f64 {
    let (t, a) = (table.times(), table.values());
    (1..t.len())
        .map(|i| (t[i] - t[i - 1]) * (a[i] + a[i - 1]) / 2.0)
        .sum()
}

fn spectral(table: &Table, period: f64, ratio: f64) -> f64 {
    spectrum::spectrum(table, &[period], ratio).unwrap()[0].pseudo_acceleration()
}

fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance * b.abs(), "{a} {b}");
}

/// The row of the record in the data of the independent program.
fn reference() -> Json {
    let reference: Json = serde_json::from_str(include_str!("../../data/records.json")).unwrap();
    let mut records = reference["records"].as_array().unwrap().iter();
    records
        .find(|record| record["file"] == APEEL)
        .unwrap()
        .clone()
}

#[test]
fn a_part_of_a_record_begins_at_its_start() {
    let whole = motion("");
    let part = motion(r#", "start": 5, "end": "2*10""#);
    for t in [0.0, 0.0123, 4.2, 14.9] {
        // Round-off of the time, with a slope of some 100 m/s3.
        assert!((part.at(t) - whole.at(t + 5.0)).abs() < 1e-10);
    }
    assert_eq!([part.at(15.0), part.at(20.0)], [0.0; 2]);
    let late = motion(r#", "start": 5, "end": 20, "delay": 2.5"#);
    assert_eq!([late.at(0.0), late.at(2.4)], [0.0; 2]);
    assert!((late.at(6.7) - part.at(4.2)).abs() < 1e-10);
}

#[test]
fn baselines_remove_the_mean_of_the_points_or_the_velocity_at_the_end() {
    let count = reference()["count"].as_f64().unwrap();
    let mean = motion(r#", "baseline": "mean""#);
    let ordinates = mean.own_points().1;
    // The last point is at the jump to 0. Round-off of 7184 sums of numbers up to 3.
    assert_eq!(ordinates.len() as f64, count);
    assert!((ordinates.iter().sum::<f64>() / count).abs() < 1e-15);
    let linear = motion(r#", "baseline": "linear""#);
    assert!(velocity(&linear).abs() < 1e-12, "{}", velocity(&linear));
    assert!(velocity(&motion("")).abs() > 1e-3);
    assert_eq!(motion(r#", "baseline": "none""#), motion(""));
    // The part has a baseline of its own.
    let part = motion(r#", "start": 5, "end": 20, "baseline": "linear""#);
    assert!(velocity(&part).abs() < 1e-12);
}

#[test]
fn a_motion_is_scaled_to_a_strength() {
    let pga = motion(r#", "scale_to": {"pga": 0.3, "unit": "g"}"#);
    near(peak(&pga), 0.3 * G, 1e-14);
    // The spectral displacement of the independent program gives the factor.
    let sd = reference()["sd"][2].as_f64().unwrap();
    let size_squared = (2.0 * std::f64::consts::PI).powi(2) * sd;
    let scaled = motion(r#", "scale_to": {"Sa": 4, "T": 1}"#);
    near(
        peak(&scaled),
        4.0 / size_squared * reference()["pga"].as_f64().unwrap(),
        1e-9,
    );
    near(spectral(&scaled, 1.0, 0.05), 4.0, 1e-12);
    // The factor is that of the part without its baseline; the scale comes on top.
    let part = motion(
        r#", "start": 5, "end": 20, "baseline": "mean", "delay": 1, "scale": 2, "scale_to": {"Sa": 4, "T": 0.5, "ratio": 0.02}"#,
    );
    near(spectral(&part, 0.5, 0.02), 8.0, 1e-12);
}

#[test]
fn a_target_spectrum_is_met_by_least_squares() {
    let en = r#"{"EN 1998-1": {"ag": 0.3, "S": 1.2, "TB": 0.15, "TC": 0.5, "TD": 2}}"#;
    let keys = |target: &str| {
        format!(r#", "scale_to": {{"spectrum": {target}, "from": 0.2, "to": 2, "unit": "g"}}"#)
    };
    let periods: Vec<f64> = (0..=100)
        .map(|i| 0.2 + 1.8 * f64::from(i) / 100.0)
        .collect();
    let spectrum_of = |table: &Table| -> Vec<f64> {
        let ordinates = spectrum::spectrum(table, &periods, 0.05).unwrap();
        ordinates
            .iter()
            .map(|ordinate| ordinate.pseudo_acceleration())
            .collect()
    };
    let design = |period: f64| {
        0.3 * G
            * 1.2
            * if period <= 0.5 {
                2.5
            } else {
                2.5 * 0.5 / period
            }
    };
    let wanted: Vec<f64> = periods.iter().map(|t| design(*t)).collect();
    let ordinates = spectrum_of(&motion(&keys(en)));
    // At the least, the derivative of the squares by the factor is 0.
    let slope: f64 = ordinates
        .iter()
        .zip(&wanted)
        .map(|(ordinate, wanted)| ordinate * (ordinate - wanted))
        .sum();
    let size: f64 = ordinates.iter().map(|ordinate| ordinate * ordinate).sum();
    assert!(slope.abs() < 1e-12 * size, "{slope} {size}");
    // The same spectrum as a table, but for the chords of its curved part.
    let list = |f: &dyn Fn(usize) -> f64| {
        let values = (0..periods.len()).map(f).map(|x| x.to_string());
        values.collect::<Vec<_>>().join(", ")
    };
    let table = format!(
        r#"{{"T": [{}], "Sa": [{}]}}"#,
        list(&|i| periods[i]),
        list(&|i| wanted[i] / G)
    );
    for (a, b) in spectrum_of(&motion(&keys(&table))).iter().zip(&ordinates) {
        near(*a, *b, 1e-12);
    }
    let asce = motion(&keys(r#"{"ASCE 7": {"SDS": 1, "SD1": 0.6, "TL": 8}}"#));
    let wanted = |t: f64| G * if t <= 0.6 { 1.0 } else { 0.6 / t };
    let ordinates = spectrum_of(&asce);
    let both = || {
        ordinates
            .iter()
            .zip(&periods)
            .map(|(ordinate, t)| (ordinate, wanted(*t)))
    };
    let slope: f64 = both()
        .map(|(ordinate, wanted)| ordinate * (ordinate - wanted))
        .sum();
    let size: f64 = both().map(|(ordinate, _)| ordinate * ordinate).sum();
    assert!(slope.abs() < 1e-12 * size, "{slope} {size}");
}

#[test]
fn strengths_and_parts_may_be_axes() {
    let study = study(
        r#""sa": [1, 3], "from": [0, 5],"#,
        &format!(
            r#"{{"record": "../records/{APEEL}", "start": "from", "scale_to": {{"Sa": "sa", "T": 1}}}}"#
        ),
    );
    let strengths: Vec<f64> = (0..4)
        .map(|case| spectral(&of_case(&study, case), 1.0, 0.05))
        .collect();
    for (strength, wanted) in strengths.iter().zip([1.0, 1.0, 3.0, 3.0]) {
        near(*strength, wanted, 1e-12);
    }
    assert_ne!(of_case(&study, 0), of_case(&study, 1));
}

#[test]
fn the_baseline_and_delay_of_a_support_are_those_of_its_motion() {
    // One support with the record; its acceleration is that of the ground with the same keys.
    let keys = r#""start": 5, "end": 8, "baseline": "mean", "delay": 0.5, "scale_to": {"pga": 2}"#;
    let support = format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 4}}, "metrics": ["max(base.a)", "peak(base.v)"],
          "structure": {{"units": "kg, N, m, s", "masses": {{"m": 1}}, "springs": [{{"between": ["base", "m"], "k": 1}}],
            "supports": {{"base": {{"record": "../records/{APEEL}", {keys}}}}}}}}}"#
    );
    let solve = |text: &str| {
        let study = parse(text).unwrap_or_else(|why| panic!("{why}"));
        study
            .problem
            .solve(&study.case(0).unwrap(), &[])
            .unwrap()
            .metrics
    };
    let found = solve(&support);
    let table = motion(&format!(", {keys}"));
    let at_steps = (0..=400).map(|i| table.at(f64::from(i) * 0.01));
    let largest = at_steps.fold(0.0, |a: f64, b| a.max(b));
    near(found[0].unwrap(), largest, 1e-9);
    let by_direction = support
        .replace(r#""base": {"#, r#""base": {"x": {"#)
        .replace(r#""pga": 2}}"#, r#""pga": 2}}}"#);
    assert_eq!(solve(&by_direction), found);
}

#[test]
fn faulty_keys_of_a_motion_name_what_is_allowed() {
    let record = |keys: &str| format!(r#"{{"record": "../records/{APEEL}", {keys}}}"#);
    for (ground, part) in [
        (
            record(r#""start": -1"#),
            "structure.ground.start: must be >= 0, got -1",
        ),
        (
            record(r#""start": 3, "end": 2"#),
            "structure.ground.end: must be later than the start",
        ),
        (
            record(r#""start": 99"#),
            "structure.ground: has no points from start to end",
        ),
        (
            record(r#""baseline": "cubic""#),
            "structure.ground.baseline: unknown baseline \"cubic\"; allowed: none, mean, linear",
        ),
        (
            record(r#""scale_to": {}"#),
            "structure.ground.scale_to: must have exactly one of pga, Sa, spectrum",
        ),
        (
            record(r#""scale_to": {"pga": 1, "T": 1}"#),
            "structure.ground.scale_to.T: does not apply to pga",
        ),
        (
            record(r#""scale_to": {"pga": 0}"#),
            "structure.ground.scale_to.pga: must be > 0, got 0",
        ),
        (
            record(r#""scale_to": {"Sa": 1}"#),
            "structure.ground.scale_to.T: missing: period of the oscillator",
        ),
        (
            record(
                r#""scale_to": {"spectrum": {"T": [1, 0.5], "Sa": [1, 1]}, "from": 0.1, "to": 1}"#,
            ),
            "structure.ground.scale_to.spectrum.T[1]: the periods must rise",
        ),
        (
            record(
                r#""scale_to": {"spectrum": {"ASCE 7": {"SDS": 1, "SD1": 1}}, "from": 1, "to": 1}"#,
            ),
            "structure.ground.scale_to.spectrum.ASCE 7.TL: missing: long-period transition",
        ),
        (
            record(r#""scale_to": {"spectrum": {"T": [1], "Sa": [1]}, "from": 1, "to": 1}"#),
            "structure.ground.scale_to.to: must be larger than from",
        ),
        (record(r#""column": 2"#), "structure.ground.column:"),
        (
            record(r#""component": 1.5"#),
            "structure.ground.component: must be a whole number from 1 to 1000000, got 1.5",
        ),
        (
            r#"{"sine": {"amplitude": 1, "omega": 1}, "delay": 1}"#.into(),
            "structure.ground: start, end, baseline, scale_to and delay need a function with points; a sine has none",
        ),
        (
            r#"{"table": {"t": [0], "f": [1]}, "dt": 1}"#.into(),
            "structure.ground.dt: only a record has a time step",
        ),
    ] {
        let found = faults("", &ground);
        assert!(found.contains(part), "{ground}: {found}");
    }
}

/// The values of the parameter of each case.
fn values(study: &Study, name: &str) -> Vec<String> {
    let table = study.problem.parameters();
    let row = table
        .iter()
        .position(|parameter| parameter.name == name)
        .unwrap();
    let cases = 0..study.len();
    cases
        .map(|case| study.case(case).unwrap().name_at(row).to_owned())
        .collect()
}

#[test]
fn the_files_of_a_pattern_are_an_axis_in_the_order_of_their_names() {
    let expected = ["270", "360", "up"]
        .map(|end| format!("../records/lomaprieta-1989-sanfrancisco-shafter-{end}.smc"));
    let pattern = r#"{"files": "../records/lomaprieta-1989-sanfrancisco-*.smc"}"#;
    let by_parameter = study(
        &format!(r#""motion": {pattern},"#),
        r#"{"record": "motion"}"#,
    );
    assert_eq!(values(&by_parameter, "motion"), expected);
    // Without a parameter, the axis has the name of the key.
    let direct = study("", &format!(r#"{{"record": {pattern}}}"#));
    assert_eq!(values(&direct, "record"), expected);
    for case in 0..3 {
        assert_eq!(of_case(&direct, case), of_case(&by_parameter, case));
    }
    // The page beside the records is none of them.
    let folder = study(
        r#""record": {"files": "../records"},"#,
        r#"{"record": "record"}"#,
    );
    let names = values(&folder, "record");
    assert_eq!(names.len(), 8);
    assert!(names.is_sorted() && names.contains(&format!("../records/{APEEL}")));
}

#[test]
fn components_of_a_station_go_together() {
    let of = |x: &str, y: &str| {
        let files = |pattern: &str| format!(r#"{{"record": {{"files": "../records/{pattern}"}}}}"#);
        format!(r#"{{"x": {}, "y": {}}}"#, files(x), files(y))
    };
    let both = study("", &of("*-043.smc", "*-133.smc"));
    let stem = "../records/lomaprieta-1989-redwoodcity-apeel2";
    assert_eq!(values(&both, "record_x"), [format!("{stem}-043.smc")]);
    assert_eq!(values(&both, "record_y"), [format!("{stem}-133.smc")]);
    let same = study("", &of("*.v2a", "*.v2a"));
    assert_eq!(same.len(), 3);
    assert_eq!(values(&same, "record_x"), values(&same, "record_y"));
    let found = faults("", &of("*-360.smc", "*-043.smc"));
    assert!(found.contains("has no partner in record_x"), "{found}");
    assert!(
        found.contains("files of several parameters go together"),
        "{found}"
    );
    for (pattern, part) in [
        ("*-nothing.smc", "no file in"),
        ("*.*", "with one * in the name of the files"),
        ("a.smc", "must be a folder, or a pattern"),
        ("no/such/*.smc", "cannot read the folder"),
        (
            "*/a*.smc",
            "must have its * in the name of the files, not in that of a folder",
        ),
    ] {
        let found = faults(
            "",
            &format!(r#"{{"record": {{"files": "../records/{pattern}"}}}}"#),
        );
        assert!(found.contains(part), "{pattern}: {found}");
    }
    let found = faults("", r#"{"record": {"files": 3}}"#);
    assert!(
        found.contains("structure.ground.record.files: must be a string, got 3"),
        "{found}"
    );
    let found = faults(r#""record": {"files": "no/*"},"#, r#"{"record": "record"}"#);
    assert!(
        found.contains("parameters.record.files: \"no/*\""),
        "{found}"
    );
}

#[test]
fn measures_of_the_ground_are_those_of_an_independent_program() {
    let names = [
        "pga",
        "pgv",
        "pgd",
        "arias",
        "d5_95",
        "Tm",
        "Sa(0.2)",
        "Sa(T1, 0.05)",
    ];
    let metrics: Vec<String> = names
        .iter()
        .map(|name| format!("\"ground.{name}\""))
        .collect();
    let reference: Json = serde_json::from_str(include_str!("../../data/records.json")).unwrap();
    let records = reference["records"].as_array().unwrap();
    let pattern = r#"{"files": "../records"}"#;
    let text = text(r#""T1": 1,"#, &format!(r#"{{"record": {pattern}}}"#));
    let study = parse(&text.replace(r#""peak(m)""#, &metrics.join(", ")))
        .unwrap_or_else(|why| panic!("{why}"));
    assert_eq!(study.len() as usize, records.len());
    for (case, expected) in records.iter().enumerate() {
        let number = |key: &str| expected[key].as_f64().unwrap();
        // Steps at the points of the record, up to its end.
        let duration = number("dt") * (number("count") - 1.0);
        let steps = format!("\"dt\": {}, \"duration\": {duration}", number("dt"));
        let whole = text.replace(r#""dt": 0.01, "duration": 1"#, &steps);
        let study = parse(&whole.replace(r#""peak(m)""#, &metrics.join(", ")))
            .unwrap_or_else(|why| panic!("{why}"));
        let metrics = study
            .problem
            .solve(&study.case(case as u64).unwrap(), &[])
            .unwrap()
            .metrics;
        // The measures of all points, and with 1e-4 those at the steps, which are beside the points of some records.
        let whole = of_case(&study, case as u64);
        let measures = [
            Measure::PeakAcceleration,
            Measure::PeakVelocity,
            Measure::PeakDisplacement,
            Measure::Arias,
            Measure::Duration,
            Measure::MeanPeriod,
            Measure::Spectral {
                period: 0.2,
                ratio: 0.05,
            },
            Measure::Spectral {
                period: 1.0,
                ratio: 0.05,
            },
        ];
        let values_of_points = measures.map(|measure| measure.of(&whole, G));
        for (metric, of_points) in metrics.iter().zip(values_of_points) {
            near(metric.unwrap(), of_points.unwrap(), 1e-4);
        }
        let measured = values_of_points;
        let sa = |direction: usize, period: f64| {
            let omega = 2.0 * std::f64::consts::PI / period;
            omega * omega * expected["sd"][direction].as_f64().unwrap()
        };
        // Sums of some thousand numbers; the displacement is a double sum of accelerations that nearly cancel.
        for (found, expected, tolerance) in [
            (measured[0], number("pga"), 1e-14),
            (measured[1], number("pgv"), 1e-10),
            (measured[2], number("pgd"), 1e-8),
            (measured[3], number("arias"), 1e-12),
            (measured[4], number("d5_95"), 1e-10),
            (measured[5], number("tm"), 1e-9),
            (measured[6], sa(0, 0.2), 1e-9),
            (measured[7], sa(2, 1.0), 1e-9),
        ] {
            near(found.unwrap(), expected, tolerance);
        }
    }
}

#[test]
fn measures_are_those_of_the_motion_that_the_structure_gets() {
    let ground = format!(
        r#"{{"x": {{"record": "../records/{APEEL}", "scale": -2, "start": 5, "baseline": "linear", "scale_to": {{"Sa": 4, "T": 0.5}}}},
             "y": {{"synthetic": 1}}}}"#
    );
    let text = text("", &ground);
    let with = |metrics: &str| parse(&text.replace(r#""peak(m)""#, metrics));
    // With the steps of each motion, up to its end.
    let measured = |dt: f64, duration: f64| {
        let metrics = r#""ground.x.Sa(0.5)", "ground.x.pga", "ground.y.pga", "ground.y.arias""#;
        let text = text.replace(r#""peak(m)""#, metrics);
        let steps = format!(r#""dt": {dt}, "duration": {duration}"#);
        let study = parse(&text.replace(r#""dt": 0.01, "duration": 1"#, &steps))
            .unwrap_or_else(|why| panic!("{why}"));
        let case = study.case(0).unwrap();
        study.problem.solve(&case, &[]).unwrap().metrics
    };
    let [x, y] = [measured(0.005, 35.0), measured(0.01, 30.0)];
    let last_values = [x[0], x[1], y[2], y[3]];
    // The round-off of the times of the part.
    near(last_values[0].unwrap(), 8.0, 1e-9);
    near(
        last_values[1].unwrap(),
        peak(&motion(
            r#", "scale": -2, "start": 5, "baseline": "linear", "scale_to": {"Sa": 4, "T": 0.5}"#,
        )),
        1e-9,
    );
    near(last_values[2].unwrap(), 0.3 * G, 1e-14);
    // Printed with the rule of synthetic motions.
    assert!((last_values[3].unwrap() - 1.8006723669).abs() < 5e-11);
    for (metric, part) in [
        (
            r#""ground.pga""#,
            "the ground has several directions; begin with ground.x. or ground.y.",
        ),
        (
            r#""ground.z.pga""#,
            "the ground does not move in this direction; begin with",
        ),
        (r#""ground.x.Sa(0)""#, "must be > 0"),
        (r#""ground.x.Sa(T9)""#, "T9"),
        (r#""ground.x.pgx""#, "no metric 'ground.pgx'"),
    ] {
        let found = with(metric).map(|_| ()).unwrap_err();
        assert!(found.contains(part), "{metric}: {found}");
    }
    let sine = text
        .replace(&ground, r#"{"sine": {"amplitude": 1, "omega": 1}}"#)
        .replace("peak(m)", "ground.pga");
    let found = parse(&sine).map(|_| ()).unwrap_err();
    assert!(found.contains("a sine has no end"), "{found}");
}
