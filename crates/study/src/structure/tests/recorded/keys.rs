//! Parameters that choose the unit, step, column and component of a record.

use crate::{Input, Study};
use slipgap_system::system::loads::STANDARD_GRAVITY;

/// One acceleration a line; t and three columns; two blocks of a format that has its step, unit and components.
const FILES: [(&str, &str); 4] = [
    ("g.txt", "0\n1\n-3\n0\n"),
    ("gal.txt", "0\n50\n25\n0\n"),
    ("columns.csv", "t,x,y,z\n0,0,0,0\n0.5,1,2,3\n1,0,0,0\n"),
    (
        "blocks.txt",
        "x\nCOMPONENT= 90\nSAMPLES/SEC=2 FILTER TYPE=X JULIAN DAY=1 DATA TYPE=AC\nNO OF POINTS= 3, UNITS=CM/SEC**2\n0 100 0\n\
         x\nCOMPONENT= 180\nSAMPLES/SEC=2 FILTER TYPE=X JULIAN DAY=1 DATA TYPE=AC\nNO OF POINTS= 3, UNITS=CM/SEC**2\n0 700 0\n",
    ),
];

/// A mass on a ground with these parameters and zips, or blocks.
fn study(parameters: &str, ground: &str) -> Result<Study, String> {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in FILES {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    let text = format!(
        r#"{{"problem": "structure", {parameters},
"structure": {{"units": "t, kN, m, s", "masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], "mass": 1, "period": 1}}],
"ground": {{{ground}}}}}, "metrics": ["peak(m)"]}}"#
    );
    let file = folder.path().join("s.json").display().to_string();
    let study = Input::new(&file, &text).study(1000);
    study.map_err(|error| error.to_string())
}

/// The acceleration of the ground in each case at a time.
fn at(study: &Study, t: f64) -> Vec<f64> {
    let problem = study.problem.as_structure().unwrap();
    let case = |number| {
        let motion = problem.ground_motion(&study.case(number).unwrap());
        motion.unwrap().acceleration.at(t)
    };
    (0..study.len()).map(case).collect()
}

const G: f64 = STANDARD_GRAVITY;

#[test]
fn files_with_steps_and_units_of_their_own_are_an_axis() {
    let parameters = r#""parameters": {"motion": ["g.txt", "gal.txt"], "unit": ["g", "cm/s2"], "step": [0.5, 0.25], "dt": 0.01, "duration": 2},
        "zip": [["motion", "unit", "step"]]"#;
    let both = study(
        parameters,
        r#""record": "motion", "unit": "unit", "dt": "step""#,
    )
    .unwrap();
    // g.txt has its second number at 0.5 s and its third one at 1 s, gal.txt at 0.25 s and at 0.5 s.
    for (t, expected) in [
        (0.25, [0.5 * G, 0.5]),
        (0.5, [G, 0.25]),
        (1.0, [-3.0 * G, 0.0]),
    ] {
        assert_eq!(at(&both, t), expected, "{t}");
    }
    // The same file with two steps, each with both units.
    let parameters =
        r#""parameters": {"unit": ["g", "cm/s2"], "step": [0.5, 0.25], "dt": 0.01, "duration": 2}"#;
    let signals = study(
        parameters,
        r#""record": "g.txt", "unit": "unit", "dt": "step""#,
    )
    .unwrap();
    assert_eq!(at(&signals, 0.5), [G, -3.0 * G, 0.01, -0.03]);
    // Each block has its own values.
    let blocks = r#""blocks": [{"parameters": {"unit": "g", "step": 0.5, "dt": 0.01, "duration": 2}},
        {"parameters": {"unit": "mm/s2", "step": 0.25, "dt": 0.01, "duration": 2}}]"#;
    let two = study(blocks, r#""record": "g.txt", "unit": "unit", "dt": "step""#).unwrap();
    assert_eq!(at(&two, 0.5), [G, -0.003]);
}

#[test]
fn columns_and_components_are_an_axis() {
    let parameters = r#""parameters": {"n": [2, 3, 4], "dt": 0.01, "duration": 2}"#;
    let columns = study(
        parameters,
        r#""record": "columns.csv", "unit": "m/s2", "column": "n""#,
    );
    assert_eq!(at(&columns.unwrap(), 0.5), [1.0, 2.0, 3.0]);
    let parameters = r#""parameters": {"n": [2, 1], "dt": 0.01, "duration": 2}"#;
    let components = study(parameters, r#""record": "blocks.txt", "component": "n""#);
    assert_eq!(at(&components.unwrap(), 0.5), [7.0, 1.0]);
    // A file that needs a column next to one that has its own.
    let parameters = r#""parameters": {"motion": ["columns.csv", "g.txt"], "n": [4, 1], "dt": 0.01, "duration": 2}, "zip": [["motion", "n"]]"#;
    let ground = r#""record": "motion", "unit": "m/s2", "column": "n", "dt": 0.5"#;
    assert_eq!(at(&study(parameters, ground).unwrap(), 0.5), [3.0, 1.0]);
}

#[test]
fn a_value_that_a_file_contradicts_is_named_with_its_parameter() {
    let numbers = r#""dt": 0.01, "duration": 2"#;
    for (parameters, ground, fault) in [
        (
            r#""parameters": {"n": [2, 5], "#,
            r#""record": "columns.csv", "unit": "g", "column": "n""#,
            r#"structure.ground.column: "columns.csv", n = 5: line 2: a row needs 5 numbers or more, got 4"#,
        ),
        (
            r#""parameters": {"n": [2, 2.5], "#,
            r#""record": "columns.csv", "unit": "g", "column": "n""#,
            r#"structure.ground.column: "columns.csv", n = 2.5: must be a whole number from 1 to 1000000, got 2.5"#,
        ),
        (
            r#""parameters": {"n": [1, 3], "#,
            r#""record": "blocks.txt", "component": "n""#,
            r#"structure.ground.component: "blocks.txt", n = 3: line 1: "component" must be the number of one of the file's components, 1 "90", 2 "180", got 3"#,
        ),
        (
            r#""parameters": {"step": [0.5, -1], "#,
            r#""record": "g.txt", "unit": "g", "dt": "step""#,
            r#"structure.ground.dt: "g.txt", step = -1: must be > 0, got -1"#,
        ),
        (
            r#""parameters": {"unit": ["g", "cm/s2"], "#,
            r#""record": "blocks.txt", "component": 1, "unit": "unit""#,
            r#"structure.ground.unit: "blocks.txt", unit = g: the unit is g, but the file is in cm/s2; give cm/s2 or no unit"#,
        ),
        (
            r#""parameters": {"unit": ["g", "gal"], "#,
            r#""record": "columns.csv", "column": 2, "unit": "unit""#,
            r#"unknown unit "gal"; allowed: g, m/s2, cm/s2, mm/s2"#,
        ),
        (
            r#""parameters": {"step": {"from": 0.1, "to": 0.5, "count": 3}, "#,
            r#""record": "g.txt", "unit": "g", "dt": "step""#,
            r#"structure.ground.record: "step" must be a list of values, so that the motions are known"#,
        ),
        (
            r#""parameters": {"#,
            r#""record": "g.txt", "unit": "furlong", "dt": 0.5"#,
            r#"structure.ground.unit: unknown unit "furlong"; allowed: g, m/s2, cm/s2, mm/s2"#,
        ),
    ] {
        let parameters = format!("{parameters}{numbers}}}");
        let told = study(&parameters, ground).map(|_| ()).unwrap_err();
        assert!(told.contains(fault), "{told}");
    }
}
