//! Pairs of motions that get one factor, and sets with the factor of a code, compared with an independent program
//! (tests/reference/structures/pairs.py).

use serde_json::Value as Json;
use slipgap::study::{self, Study};
use std::path::Path;

/// The files of both pairs.
const PAIRS: [[&str; 2]; 2] = [
    [
        "lomaprieta-1989-redwoodcity-apeel2-043.smc",
        "lomaprieta-1989-redwoodcity-apeel2-133.smc",
    ],
    [
        "lomaprieta-1989-sanfrancisco-shafter-360.smc",
        "lomaprieta-1989-sanfrancisco-shafter-270.smc",
    ],
];
const UP: &str = "lomaprieta-1989-sanfrancisco-shafter-up.smc";
const COMPONENTS: [&str; 4] = ["geometric-mean", "srss", "rotd50", "rotd100"];
const TARGET: &str =
    r#""spectrum": {"EN 1998-1": {"ag": 0.3, "S": 1.2, "TB": 0.15, "TC": 0.5, "TD": 2}}"#;
const RANGE: &str = r#""from": 0.2, "to": 2, "unit": "g""#;

fn parse(text: &str) -> Result<Study, String> {
    // In this folder, ../records has the records.
    let file = Path::new(env!("SLIPGAP_ROOT")).join("studies/recorded/s.json");
    study::parse(&file.to_string_lossy(), text).map_err(|why| why.to_string())
}

/// A mass that moves in x and y on this ground, with both pairs as zipped axes `rx` and `ry`.
fn text(more: &str, zip: &str, ground: &str, metrics: &str) -> String {
    let files = |i: usize| {
        format!(
            r#"["../records/{}", "../records/{}"]"#,
            PAIRS[0][i], PAIRS[1][i]
        )
    };
    format!(
        r#"{{"problem": "structure", "parameters": {{"rx": {}, "ry": {}, {more} "dt": 0.01, "duration": 1}}, "zip": [["rx", "ry"{zip}]],
          "metrics": [{metrics}],
          "structure": {{"units": "kg, N, m, s", "masses": {{"m": {{"mass": 1, "direction": ["x", "y"]}}}},
            "springs": [{{"between": ["ground", "m"], "directions": ["x", "y"], "k": 1}}], "ground": {ground}}}}}"#,
        files(0),
        files(1)
    )
}

/// The metrics of each case.
fn solved(text: &str) -> Vec<Vec<f64>> {
    let study = parse(text).unwrap_or_else(|why| panic!("{why}"));
    let solve = |case| {
        let solution = study.problem.solve(&study.case(case).unwrap(), &[]);
        let metrics = solution.unwrap().metrics;
        metrics.into_iter().map(Option::unwrap).collect()
    };
    (0..study.len()).map(solve).collect()
}

/// The pair with this strength together.
fn together(scale_to: &str) -> String {
    format!(r#"{{"x": {{"record": "rx"}}, "y": {{"record": "ry"}}, "scale_to": {{{scale_to}}}}}"#)
}

const FACTORS: &str = r#""ground.x.factor", "ground.y.factor""#;
const SET: &str =
    r#""ground.x.factor", "ground.set_factor", "ground.set_ratio", "ground.y.factor""#;

fn reference() -> Json {
    serde_json::from_str(include_str!("../../data/pairs.json")).unwrap()
}

fn number(json: &Json) -> f64 {
    json.as_f64().unwrap()
}

/// The parabolas of the independent program miss a peak by (omega h)^3/16 of it, h 1/16 of 0.005 s: 6e-8 at the shortest period.
fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-7 * b.abs(), "{a} {b}");
}

#[test]
fn a_pair_reaches_the_strength_of_an_independent_program() {
    let reference = reference();
    for component in COMPONENTS {
        for (goal_text, period) in [
            (0, "0"),
            (1, "0.2"),
            (2, "0.5"),
            (3, "1"),
            (4, "2"),
            (5, "3"),
        ] {
            let goal = match goal_text {
                0 => r#""pga": 2"#.to_owned(),
                _ => format!(r#""Sa": 2, "T": {period}"#),
            };
            let ground = together(&format!(r#"{goal}, "component": "{component}""#));
            for (case, values) in solved(&text("", "", &ground, FACTORS)).iter().enumerate() {
                assert_eq!(values[0], values[1]);
                let strengths = &reference["pairs"][case]["strengths"][period];
                near(2.0 / values[0], number(&strengths[component]));
            }
        }
    }
}

#[test]
fn a_pair_is_nearest_to_a_target_by_both_squares() {
    let reference = reference();
    for component in COMPONENTS {
        for fit in ["linear", "logarithmic"] {
            let goal = format!(r#"{TARGET}, {RANGE}, "component": "{component}", "fit": "{fit}""#);
            let found = solved(&text("", "", &together(&goal), FACTORS));
            for (case, values) in found.iter().enumerate() {
                assert_eq!(values[0], values[1]);
                near(
                    values[0],
                    number(&reference["pairs"][case]["factors"][component][fit]),
                );
            }
        }
    }
}

#[test]
fn the_vertical_motion_gets_the_factor_of_its_pair() {
    let ground = format!(
        r#"{{"x": {{"record": "rx"}}, "y": {{"record": "ry"}}, "z": {{"record": "../records/{UP}", "scale": 2}},
            "scale_to": {{"pga": 2, "component": "srss"}}}}"#
    );
    let metrics = r#""ground.x.factor", "ground.z.factor", "ground.z.pga""#;
    let apart = ground.replace(r#", "scale": 2"#, "");
    let (both, plain) = (
        text("", "", &ground, metrics),
        text("", "", &apart, metrics),
    );
    for (values, plain) in solved(&both).iter().zip(solved(&plain)) {
        assert_eq!(values[0], values[1]);
        assert_eq!(values[2], 2.0 * plain[2]);
    }
    // The vertical acceleration of a friction force, too.
    let slider = format!(
        r#""contacts": {{"c": {{"law": "coulomb", "between": ["ground", "m"], "directions": ["x", "y"], "nu": 0.1,
            "N": {{"weight": 10, "vertical": {{"record": "../records/{UP}", "scale_to": "ground"}}}}}}}},"#
    );
    let with = |text: String| text.replace(r#""springs""#, &format!(r#"{slider} "springs""#));
    let metrics = r#""max(c.limit)", "ground.z.pga", "min(c.limit)""#;
    let scaled = format!(
        r#"{{"x": {{"record": "rx"}}, "y": {{"record": "ry"}}, "z": {{"record": "../records/{UP}"}},
            "scale_to": {{"Sa": 9, "T": 0.5, "component": "rotd50"}}}}"#
    );
    for values in solved(&with(text("", "", &scaled, metrics))) {
        // N = 10 (1 + a/g): the larger side has the peak.
        let side = (values[0] - 1.0).max(1.0 - values[2]);
        assert!((side - values[1] / 9.80665).abs() < 1e-12, "{values:?}");
    }
}

#[test]
fn a_set_gets_the_factor_of_its_rule() {
    let reference = reference();
    let pair = |component: &str, fit: &str, set: &str| {
        together(&format!(
            r#"{TARGET}, {RANGE}, "component": "{component}", "fit": "{fit}", "set": {{{set}}}"#
        ))
    };
    let rule = |name: &str| format!(r#""rule": "{name}", "period": 1"#);
    let en_1 = format!(r#"{}, "component": "geometric-mean""#, rule("EN 1998-1"));
    for (name, ground) in [
        ("EN 1998-1", pair("geometric-mean", "linear", &en_1)),
        (
            "EN 1998-2",
            pair("rotd50", "logarithmic", &rule("EN 1998-2")),
        ),
        (
            "ASCE 7-16",
            pair("rotd50", "logarithmic", &rule("ASCE 7-16")),
        ),
        // With the upper and the lower bound properties.
        (
            "ASCE 7-16 isolation",
            pair(
                "rotd50",
                "logarithmic",
                r#""rule": "ASCE 7-16 isolation", "period": [1.2, 0.8]"#,
            ),
        ),
        (
            "envelope",
            together(&format!(
                r#""factor": 1, "unit": "g", "set": {{"statistic": "envelope", "component": "rotd50", "least": 1, "from": 0.2, "to": 2,
                   {TARGET}}}"#
            )),
        ),
    ] {
        let found = solved(&text("", "", &ground, SET));
        let wanted = number(&reference["sets"][name]["factor"]);
        for values in &found {
            near(values[1], wanted);
            assert_eq!(values[0], values[3]);
            // The rule holds, and with the least factor: only round-off is above.
            assert!(
                (1.0..1.0 + 1e-15).contains(&values[2]),
                "{name}: {}",
                values[2]
            );
        }
        // On top of those of the pairs.
        if name == "EN 1998-2" {
            for (case, values) in found.iter().enumerate() {
                let pair = &reference["pairs"][case]["factors"]["rotd50"]["logarithmic"];
                near(values[0], number(pair) * wanted);
            }
        }
    }
}

#[test]
fn a_set_of_one_direction_and_own_factors_is_checked() {
    let reference = number(&reference()["sets"]["alone"]["factor"]);
    let metrics = r#""ground.set_factor", "ground.set_ratio", "ground.factor""#;
    let ground = |factor: &str, set: &str| {
        format!(
            r#"{{"record": "rx", "scale_to": {{"factor": {factor}, "unit": "g",
                "set": {{"least": 0.9, "from": 0.2, "to": 2, {TARGET}{set}}}}}}}"#
        )
    };
    let alone = |factors: &str, zip: &str, ground: &str| {
        let files = format!(
            r#"["../records/{}", "../records/{}"]"#,
            PAIRS[0][0], PAIRS[1][0]
        );
        solved(&format!(
            r#"{{"problem": "structure", "parameters": {{"rx": {files}, {factors} "dt": 0.01, "duration": 1}}, {zip} "metrics": [{metrics}],
              "structure": {{"units": "kg, N, m, s", "masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], "k": 1}}],
                "ground": {ground}}}}}"#
        ))
    };
    for values in alone("", "", &ground("1", "")) {
        near(values[0], reference);
        assert!((1.0..1.0 + 1e-15).contains(&values[1]));
    }
    // With a factor of the study, the ratio says how far the rule is from it.
    for values in alone("", "", &ground("1", r#", "factor": 2"#)) {
        near(values[1], 2.0 / reference);
        assert_eq!(values[2], 2.0);
    }
    // Numbers replace those of a rule, whose range is from 0.2 of the least to 2 times the largest period.
    let by_rule = |set: &str| {
        let set = format!(r#""rule": "EN 1998-1", "least_at_zero": 1e-9, {TARGET}, {set}"#);
        let ground = format!(
            r#"{{"record": "rx", "scale_to": {{"factor": 1, "unit": "g", "set": {{{set}}}}}}}"#
        );
        alone("", "", &ground)[0][0]
    };
    near(by_rule(r#""period": 1"#), reference);
    near(by_rule(r#""period": 1, "least": 1.8"#), 2.0 * reference);
    let by_keys = by_rule(r#""from": 0.16, "to": 2.4"#);
    assert!((by_rule(r#""period": [0.8, 1.2]"#) / by_keys - 1.0).abs() < 1e-14);
    // Own factors of the motions in a zip with them.
    let by_motion = alone(
        r#""f": [3, 3], "#,
        r#""zip": [["rx", "f"]],"#,
        &ground(r#""f""#, ""),
    );
    near(by_motion[0][0], reference / 3.0);
    near(by_motion[1][2], reference);
    // Of different ones, each motion keeps its own.
    let by_motion = alone(
        r#""f": [2, 3], "#,
        r#""zip": [["rx", "f"]],"#,
        &ground(r#""f""#, ""),
    );
    assert_eq!(by_motion[0][0], by_motion[1][0]);
    assert!((by_motion[0][2] / by_motion[1][2] - 2.0 / 3.0).abs() < 1e-15);
}

#[test]
fn pairs_and_sets_refuse_what_has_no_meaning() {
    let of = |ground: &str| parse(&text("", "", ground, r#""peak(m.x)""#)).unwrap_err();
    let pair = |scale_to: &str| of(&together(scale_to));
    for (found, part) in [
        (
            pair(r#""pga": 1"#),
            "structure.ground.scale_to.component: missing: geometric-mean",
        ),
        (
            pair(r#""pga": 1, "component": "each""#),
            "unknown component \"each\"; allowed: geometric-mean, srss, rotd50, rotd100",
        ),
        (
            pair(r#""pga": 1, "component": "srss", "fit": "linear""#),
            "structure.ground.scale_to.fit: does not apply to pga",
        ),
        (
            pair(r#""factor": 1"#),
            "structure.ground.scale_to.factor: needs a \"set\"",
        ),
        (
            pair(&format!(
                r#""factor": 1, "set": {{"rule": "EN 1998-1", "period": 1, {TARGET}}}"#
            )),
            "structure.ground.scale_to: missing \"component\"",
        ),
        (
            pair(r#""factor": 1, "set": {"rule": "EN 1998-2", "period": 1}"#),
            "structure.ground.scale_to.set.spectrum: missing: target spectrum",
        ),
        (
            pair(&format!(
                r#""factor": 1, "set": {{"rule": "EN 1998-2", {TARGET}}}"#
            )),
            "structure.ground.scale_to.set.period: missing: period of the structure",
        ),
        (
            pair(&format!(
                r#""factor": 1, "set": {{"from": 1, "to": 2, {TARGET}}}"#
            )),
            "structure.ground.scale_to.set.least: missing: least ratio",
        ),
        (
            of(
                r#"{"x": {"record": "rx", "scale_to": {"pga": 1}}, "y": {"record": "ry"}, "scale_to": {"pga": 1, "component": "srss"}}"#,
            ),
            "structure.ground.scale_to: give it for the ground or for its directions, not both: x has one",
        ),
        (
            of(
                r#"{"x": {"record": "rx"}, "z": {"record": "ry"}, "scale_to": {"pga": 1, "component": "srss"}}"#,
            ),
            "structure.ground.scale_to: needs a motion in x and one in y",
        ),
        (
            of(&format!(
                r#"{{"x": {{"record": "rx", "scale_to": {{"factor": 1, "set": {{"rule": "EN 1998-2", "period": 1, {TARGET}}}}}}}, "y": {{"record": "ry"}}}}"#
            )),
            "a set of motions in one direction has no component",
        ),
    ] {
        assert!(found.contains(part), "{found}");
    }
    // Without a zip, each motion in x goes with each one in y.
    let set = together(&format!(
        r#""factor": 1, "set": {{"rule": "EN 1998-2", "period": 1, {TARGET}}}"#
    ));
    let apart = text("", "", &set, SET).replace(r#""zip": [["rx", "ry"]],"#, "");
    assert!(
        parse(&apart)
            .unwrap_err()
            .contains("must be in one \"zip\"")
    );
    let later = set.replace(r#""record": "rx""#, r#""record": "rx", "start": "later""#);
    let follows = text(r#""n": [0, 1], "later": "n + 1","#, r#", "n""#, &later, SET);
    assert!(
        parse(&follows)
            .unwrap_err()
            .contains("later follows from a parameter that changes with the motion")
    );
}

#[test]
fn a_note_says_that_x_and_y_get_factors_of_their_own() {
    let apart = |more: &str| {
        let one = |name: &str| format!(r#"{{"record": "{name}", "scale_to": {{"pga": 1{more}}}}}"#);
        let ground = format!(r#"{{"x": {}, "y": {}}}"#, one("rx"), one("ry"));
        let study = parse(&text("", "", &ground, FACTORS)).unwrap();
        study.problem.as_structure().unwrap().notes().join("\n")
    };
    assert!(apart("").contains("ground: x and y get each a factor of its own"));
    assert_eq!(apart(r#", "component": "each""#), "");
    let set = r#""pga": 1, "component": "srss", "set": {"rule": "ASCE 7-16", "period": 1, "spectrum": {"T": [1], "Sa": [1]}}"#;
    let study = parse(&text("", "", &together(set), SET)).unwrap();
    let notes = study.problem.as_structure().unwrap().notes().join("\n");
    assert_eq!(notes, "ASCE 7-16 needs at least 11 motions, the set has 2");
}
