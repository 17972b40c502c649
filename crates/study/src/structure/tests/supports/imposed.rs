//! Displacements of supports by files, compared with the same points in lists.

use crate::{Input, Study};
use slipgap_problem::problem::Solution;
use std::path::{Path, PathBuf};

const T: [f64; 6] = [0.0, 0.3, 0.5, 1.25, 1.5, 2.0];
const U: [f64; 6] = [0.0, 0.25, 0.375, -0.5, 0.125, 0.0];

/// A folder of its own for a test.
fn folder(name: &str) -> PathBuf {
    let name = format!("slipgap-imposed-{name}-{}", std::process::id());
    let folder = std::env::temp_dir().join(name);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// The points with a factor and an offset of u.
fn write(folder: &Path, name: &str, factor: f64, offset: f64) {
    let points = T.iter().zip(U);
    let rows = points.map(|(t, u)| format!("{t:?};{:?}\n", factor * (u + offset)));
    let text = format!("t;stroke\n{}", rows.collect::<String>());
    std::fs::write(folder.join(name), text).unwrap();
}

fn read(folder: &Path, parameters: &str, course: &str) -> Result<Study, String> {
    let text = format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 2.5{parameters}}},
            "structure": {{"units": "t, kN, m, s", "masses": {{"m": 1}}, "supports": {{"jack": {{{course}}}}},
              "springs": [{{"between": ["jack", "m"], "k": 800, "c": 1}}, {{"between": ["ground", "m"], "k": 50}}],
              "contacts": {{"damper": {{"law": "displacement-control", "between": ["ground", "jack"], "limit": 3, "rE": 0.01}}}}}},
            "metrics": ["peak(damper.S)", "energy_per_cycle(damper)"]}}"#
    );
    let file = folder.join("s.json").display().to_string();
    let study = Input::new(&file, &text).study(1000);
    study.map_err(|error| error.to_string())
}

fn solved(study: &Study, case: u64) -> Solution {
    study
        .problem
        .solve(&study.case(case).unwrap(), &[])
        .unwrap()
}

fn list(factor: f64) -> String {
    format!(
        r#""displacement": {{"t": {T:?}, "u": {:?}}}"#,
        U.map(|u| factor * u)
    )
}

const FILE: &str = r#""displacement": {"file": "a.csv", "time": "t", "column": "stroke"}"#;

#[test]
fn a_file_moves_a_support_as_the_same_points_in_lists() {
    let folder = folder("same");
    let by_list = solved(&read(&folder, "", &list(1.0)).unwrap(), 0);
    assert!(by_list.metrics[0] == Some(3.0), "{:?}", by_list.metrics);
    // The offset is a power of two, so that nothing rounds.
    for offset in [0.0, 0.25] {
        write(&folder, "a.csv", 1.0, offset);
        for course in [FILE.to_owned(), format!(r#""x": {{{FILE}}}"#)] {
            let by_file = solved(&read(&folder, "", &course).unwrap(), 0);
            assert_eq!(by_file.computed, by_list.computed, "{offset} {course}");
        }
    }
    // A later start is that of a list, too.
    let later = |course: &str| format!(r#"{course}, "delay": 0.2"#);
    let by_list = solved(&read(&folder, "", &later(&list(1.0))).unwrap(), 0);
    let by_file = solved(&read(&folder, "", &later(FILE)).unwrap(), 0);
    assert_eq!(by_file.computed, by_list.computed);
}

#[test]
fn a_column_has_a_unit() {
    let folder = folder("unit");
    write(&folder, "a.csv", 1000.0, 0.0);
    let course = r#""displacement": {"file": "a.csv", "time": {"column": "t", "unit": "s"}, "column": {"column": "stroke", "unit": "mm"}}"#;
    let by_file = solved(&read(&folder, "", course).unwrap(), 0);
    let by_list = solved(&read(&folder, "", &list(1.0)).unwrap(), 0);
    for (a, b) in by_file
        .computed
        .channels
        .iter()
        .zip(&by_list.computed.channels)
    {
        let peak = b.iter().fold(0.0, |peak: f64, x| peak.max(x.abs()));
        // A factor of 1e-3 rounds once; friction that turns a step later would differ by far more.
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-12 * peak));
    }
}

#[test]
fn a_parameter_chooses_the_file() {
    let folder = folder("axis");
    write(&folder, "a.csv", 1.0, 0.0);
    write(&folder, "b.csv", 0.5, 0.0);
    let course = FILE.replace("a.csv", "test");
    let study = read(&folder, r#", "test": ["a.csv", "b.csv"]"#, &course).unwrap();
    for (case, factor) in [(0, 1.0), (1, 0.5)] {
        let by_list = solved(&read(&folder, "", &list(factor)).unwrap(), 0);
        assert_eq!(solved(&study, case).computed, by_list.computed);
    }
    // Results belong to the content of the file.
    let before = study.problem.as_structure().unwrap().identity().to_owned();
    write(&folder, "b.csv", 0.75, 0.0);
    let study = read(&folder, r#", "test": ["a.csv", "b.csv"]"#, &course).unwrap();
    assert_ne!(study.problem.as_structure().unwrap().identity(), before);
}

#[test]
fn faults_name_the_place_and_what_is_allowed() {
    let folder = folder("faults");
    write(&folder, "a.csv", 1.0, 0.0);
    std::fs::write(folder.join("b.csv"), "t,stroke\n0,0\n1,nan\n").unwrap();
    for (course, wanted) in [
        (
            r#""file": "a.csv", "time": "t", "column": "strike""#,
            r#"did you mean "stroke"?"#,
        ),
        (r#""file": "a.csv", "time": "t""#, "column"),
        (
            r#""file": "c.csv", "time": "t", "column": "stroke""#,
            "c.csv",
        ),
        (
            r#""file": "b.csv", "time": "t", "column": "stroke""#,
            "line 3: column \"stroke\": not a finite number: \"nan\"",
        ),
        (
            r#""file": "a.csv", "time": "t", "column": {"column": "stroke", "unit": "kN"}"#,
            "must be a unit of",
        ),
        (
            r#""file": "a.csv", "time": "t", "column": "stroke", "u": [0]"#,
            "u",
        ),
    ] {
        let course = format!(r#""displacement": {{{course}}}"#);
        let why = read(&folder, "", &course).unwrap_err();
        assert!(
            why.contains("structure.supports.jack.displacement"),
            "{why}"
        );
        assert!(why.contains(wanted), "{course}: {why}");
    }
}
