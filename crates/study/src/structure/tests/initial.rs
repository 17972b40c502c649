//! Damping with the elastic contacts at their initial stiffness, and the periods that `explain` prints.

use crate::{Study, parse};
use std::f64::consts::PI;

fn study(structure: &str, metrics: &str, duration: f64) -> Study {
    let text = format!(
        r#"{{"problem": "structure", "parameters": {{"method": ["average-acceleration", "hht", "generalized-alpha"],
             "dt": 0.0005, "duration": {duration}}}, "metrics": [{metrics}], "structure": {{{structure}}}}}"#
    );
    parse("s", &text).unwrap_or_else(|why| panic!("{why}"))
}

/// u of a free oscillator with u(0) = 0, u'(0) = 10: the contacts have no force at the start, wherever that is.
fn free(omega: f64, ratio: f64, t: f64) -> f64 {
    let damped = omega * (1.0 - ratio * ratio).sqrt();
    let s = (damped * t).sin();
    10.0 * (-ratio * omega * t).exp() * s / damped
}

/// One mass on an elastic-plastic contact, with this damping.
fn one(damping: &str) -> String {
    format!(
        r#""masses": {{"m": 2}}, "contacts": {{"c": {{"law": "displacement-control", "between": ["ground", "m"], "k": 200, "limit": 1e6}}}},
           "start": {{"m": {{"v": 10}}}}, {damping}"#
    )
}

/// Two masses of 1 in a row: an elastic contact of 300 to the ground, a spring of 200 between them; omega^2 = 100 with the shape
/// (1, 2) and 600 with (2, -1). They start with the sum of both shapes.
fn two(damping: &str) -> String {
    format!(
        r#""masses": {{"a": 1, "b": 1}}, "springs": [{{"between": ["a", "b"], "k": 200}}],
           "contacts": {{"c": {{"law": "displacement-control", "between": ["ground", "a"], "k": 300, "limit": 1e6}}}},
           "start": {{"a": {{"v": 30}}, "b": {{"v": 10}}}}, {damping}"#
    )
}

#[test]
fn initial_stiffness_damps_one_mass_and_two_masses_as_the_closed_form() {
    let t = 1.0;
    let (w1, w2) = (10.0, 600f64.sqrt());
    let modal = r#""modal_damping": 0.05, "damping_stiffness": "initial""#;
    let rayleigh =
        r#""rayleigh": {"mass": 0.3, "stiffness": 0.004}, "damping_stiffness": "initial""#;
    let without = r#""rayleigh": {"mass": 0.3, "stiffness": 0.004}"#;
    // Ratios of C = 0.3 M + 0.004 K: (0.3/omega + 0.004 omega)/2.
    let ratio = |omega: f64| 0.5 * (0.3 / omega + 0.004 * omega);
    let sum = |r1: f64, r2: f64| {
        [
            free(w1, r1, t) + 2.0 * free(w2, r2, t),
            2.0 * free(w1, r1, t) - free(w2, r2, t),
        ]
    };
    // Two ratios by three ways, and one alone, from the lowest frequency on.
    let by = |damping: &str| two(&format!(r#"{damping}, "damping_stiffness": "initial""#));
    let two_ratios = || {
        let [a, b] = sum(0.05, 0.03);
        vec![("a", a), ("b", b)]
    };
    let first = sum(0.05, 0.0);
    let (t1, t2) = (2.0 * PI / w1, 2.0 * PI / w2);
    let cases = [
        (by(r#""modal_damping": [0.05, 0.03]"#), two_ratios()),
        (
            by(r#""rayleigh": {"ratios": [0.05, 0.03], "modes": [1, 2]}"#),
            two_ratios(),
        ),
        (
            by(r#""rayleigh": {"ratios": [0.03, 0.05], "modes": [2, 1]}"#),
            two_ratios(),
        ),
        (
            by(&format!(
                r#""rayleigh": {{"ratios": [0.05, 0.03], "periods": [{t1}, {t2}]}}"#
            )),
            two_ratios(),
        ),
        (
            by(r#""modal_damping": [0.05]"#),
            vec![("a", first[0]), ("b", first[1])],
        ),
        (one(modal), vec![("m", free(w1, 0.05, t))]),
        (one(rayleigh), vec![("m", free(w1, ratio(w1), t))]),
        // Without the contact there is no stiffness: 0.3 M alone.
        (one(without), vec![("m", free(w1, 0.015, t))]),
        (
            two(modal),
            vec![("a", sum(0.05, 0.05)[0]), ("b", sum(0.05, 0.05)[1])],
        ),
        (
            two(rayleigh),
            vec![
                ("a", sum(ratio(w1), ratio(w2))[0]),
                ("b", sum(ratio(w1), ratio(w2))[1]),
            ],
        ),
    ];
    for (structure, expected) in cases {
        let metrics: Vec<String> = expected
            .iter()
            .map(|(node, _)| format!("\"last({node})\", \"last_error({node})\""))
            .collect();
        let study = study(
            &format!("{structure}, \"contacts_reference\": \"softened\""),
            &format!("{}, \"energy_error\"", metrics.join(", ")),
            t,
        );
        for case in study.cases() {
            let found = study.problem.solve(&case, &[]).unwrap().metrics;
            for (i, (node, u)) in expected.iter().enumerate() {
                // The error has no sign.
                let (last, error) = (found[2 * i].unwrap(), found[2 * i + 1].unwrap());
                let exact = last - error.copysign(last - u);
                // Second order: the period of omega = 24.5 is wrong by (omega dt)^2/12 = 1.3e-5, after 24.5 rad 3e-4 of 2; the
                // dissipative methods add as much.
                assert!((last - u).abs() < 2e-3, "{structure} {node} {last} {u}");
                // The exact motion: round-off of series and eigenvectors.
                assert!((exact - u).abs() < 1e-11, "{structure} {node} {exact} {u}");
            }
            // The books of all work, in 2000 steps.
            assert!(
                found[2 * expected.len()].unwrap().abs() < 1e-11,
                "{found:?}"
            );
        }
    }
}

#[test]
fn explain_prints_the_periods_with_elastic_contacts() {
    let text = |structure: &str| {
        let study = study(structure, "\"energy_error\"", 1.0);
        study
            .problem
            .as_structure()
            .unwrap()
            .description(&study.case(0).unwrap())
            .unwrap()
    };
    let both = text(&two(r#""modal_damping": 0"#));
    // Free: two masses of 1 on 200, omega^2 = 400; six digits of 2 pi/20, and of 2 pi/10 and 2 pi/sqrt 600.
    for line in [
        "natural periods without contacts: 0.314159\n",
        "natural periods with the elastic contacts at their initial stiffness: 0.628319, 0.25651\n",
    ] {
        assert!(both.contains(line), "{both}");
    }
    assert!(
        !both.contains("nothing holds") && !both.contains("ratios"),
        "{both}"
    );
    // Without contacts there is a rigid-body mode, which is none of the modes: the ratio is that of 20.
    let damped = text(&two(
        r#""rayleigh": {"ratios": [0.05, 0.05], "periods": [0.2, 0.4]}"#,
    ));
    // Ratio of 0.3142 s between 0.2 and 0.4 s: 0.05 (w1 w2/w + w)/(w1 + w2).
    let [w1, w2] = [10.0 * PI, 5.0 * PI];
    let ratio = 0.05 * (w1 * w2 / 20.0 + 20.0) / (w1 + w2);
    let line = format!("damping ratios of these modes without contacts: {ratio:.7}\n");
    assert!(damped.contains(&line[..line.len() - 2]), "{damped} {line}");
    // An open gap holds nothing.
    let gap = two(r#""modal_damping": 0"#).replace(
        r#""law": "displacement-control", "between": ["ground", "a"], "k": 300, "limit": 1e6"#,
        r#""law": "impact", "between": ["ground", "a"], "gap": 5, "k": 300"#,
    );
    let open = text(&gap);
    assert!(open.contains("nothing holds a to b"), "{open}");
    assert!(!open.contains("initial stiffness"), "{open}");
}

#[test]
fn ratios_that_no_damping_has_are_refused() {
    let fault = |damping: &str| {
        let structure = two(&format!(r#"{damping}, "damping_stiffness": "initial""#));
        let text = format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.1, "duration": 1}}, "metrics": ["energy_error"], "structure": {{{structure}}}}}"#
        );
        match parse("s", &text) {
            Err(fault) => fault.to_string(),
            Ok(study) => {
                let solved = study.solve(&study.case(0).unwrap());
                solved.unwrap_err().to_string()
            }
        }
    };
    for (damping, message) in [
        (
            r#""modal_damping": [0.05, 0.05, 0.05]"#,
            "structure.modal_damping[2]: is the ratio of mode 3, the structure has 2 with a stiffness",
        ),
        (
            r#""rayleigh": {"ratios": [0.05, 0.05], "modes": [1, 3]}"#,
            "structure.rayleigh.modes[1]: must be a whole number from 1 to 2, got 3",
        ),
        (
            r#""rayleigh": {"ratios": [0.05, 0.05], "modes": [2, 2]}"#,
            "structure.rayleigh.modes[1]: must not have the frequency of the other mode",
        ),
        (
            r#""rayleigh": {"ratios": [0.05, 0.05]}"#,
            "structure.rayleigh: needs modes or periods beside ratios, one of them",
        ),
        (
            r#""rayleigh": {"periods": [0.5, 0.2]}"#,
            "structure.rayleigh.periods: needs \"ratios\"",
        ),
        (
            r#""rayleigh": {"ratios": [0.05, 0.05], "periods": [0.5, 0.2], "mass": 1}"#,
            "structure.rayleigh: has ratios or the factors mass and stiffness, not both",
        ),
        (
            r#""rayleigh": {"ratios": [0.05, 0.05], "periods": [0.5]}"#,
            "structure.rayleigh.periods: must be two numbers, got 1",
        ),
        // 24.5 over 10.
        (
            r#""rayleigh": {"ratios": [0.05, 0.2], "modes": [1, 2]}"#,
            "structure.rayleigh.ratios[1]: the factor of M would be ",
        ),
        (
            r#""rayleigh": {"ratios": [0.05, 0.01], "modes": [1, 2]}"#,
            "the second ratio over the first must be from 0.408248 to 2.44949",
        ),
    ] {
        let found = fault(damping);
        assert!(found.contains(message), "{damping}: {found}");
    }
}

#[test]
fn explain_prints_the_masses_that_take_part_in_the_modes() {
    let matrix = |entries: &str| {
        format!("%%MatrixMarket matrix coordinate real symmetric\\n3 3 {entries}\\n")
    };
    // Two floors of 2 on storeys of 50, with a mass of 3 in y on a spring.
    let (mass, stiffness) = (
        matrix("3\\n1 1 2\\n2 2 2\\n3 3 3"),
        matrix("4\\n1 1 100\\n2 1 -50\\n2 2 50\\n3 3 900"),
    );
    let text = |reduce: &str| {
        let text = format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1}}, "metrics": ["peak(t.1.x)", "peak(t.1.y)"],
                "structure": {{"matrices": {{"t": {{"M": "{mass}", "K": "{stiffness}", "dofs": [["1", "x"], ["2", "x"], ["1", "y"]]{reduce}}}}},
                    "ground": {{"sine": {{"amplitude": 1, "omega": 8}}}}}}}}"#
        );
        let study = super::study(&text);
        let case = study.case(0).unwrap();
        study
            .problem
            .as_structure()
            .unwrap()
            .description(&case)
            .unwrap()
    };
    // With g = (1 + sqrt 5)/2 of (1, g) and (1, 1 - g): (1 + g)^2/(1 + g^2)/2 and 1 less it; periods 2 pi sqrt(2/50)/(g - 1), 2 pi/sqrt 300
    // and 2 pi sqrt(2/50)/g.
    let whole = "participating part of the mass:\n  2.03328: x 0.9472, mostly t.2.x\n  0.776644: x 0.0528, mostly t.1.x\n  \
        0.36276: y 1.0000, mostly t.1.y\n  sum: x 1.0000, y 1.0000\n";
    assert!(text("").contains(whole), "{}", text(""));
    let reduced = text(r#", "reduce": {"modes": 1}"#);
    for line in ["\n  2.03328: x 0.9472\n", "\n  sum: x 1.0000, y 1.0000\n"] {
        assert!(reduced.contains(line), "{reduced}");
    }
}

#[test]
fn the_name_of_the_stiffness_is_checked() {
    let text = format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.1, "duration": 1}}, "metrics": ["energy_error"], "structure": {{{}}}}}"#,
        one(r#""damping_stiffness": "tangent""#)
    );
    let fault = parse("s", &text).unwrap_err().to_string();
    assert!(
        fault.contains("allowed: without-contacts, initial"),
        "{fault}"
    );
}
