//! Laws of parts of bridges and buildings in studies.

use super::{faults, study};

/// A mass that a sine drives on a spring and this contact with the ground.
fn driven(contact: &str, parameters: &str, metrics: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"duration": 3, {parameters}}},
            "structure": {{"masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], "k": 9}}],
                "contacts": {{"c": {{"between": ["ground", "m"], {contact}}}}},
                "loads": [{{"at": "m", "sine": {{"amplitude": 12, "omega": 5}}}}], "start": {{"m": {{"v": 1}}}}}},
            "metrics": [{metrics}]}}"#
    )
}

/// Every law; the first six are straight lines between events.
const LAWS: [&str; 8] = [
    r#""law": "bilinear", "k1": 60, "Fy": 4, "ratio": 0.1"#,
    r#""law": "multilinear", "table": {"r": [0.05, "0.2*1", 0.5], "S": [3, 4.5, 5]}"#,
    r#""law": "restrainer", "gap": 0.01, "slack": 0.03, "k": 80, "Fy": 4"#,
    r#""law": "gap-yield", "gap": 0.02, "k": 80, "Fy": 4, "damage": 0"#,
    r#""law": "impact-yield", "gap": 0.02, "k1": 80, "k2": 30, "delta_y": 0.05"#,
    r#""law": "pendulum", "nu": 0.1, "N": 12, "R": 1.5, "k": 200"#,
    r#""law": "hyperbolic-gap", "gap": 0.02, "k": 60, "Fult": 5, "k_unloading": 90"#,
    r#""law": "viscous", "c": 3, "a": 0.5"#,
];

#[test]
fn every_method_moves_a_mass_with_each_law_alike() {
    let methods = [
        "average-acceleration",
        "linear-acceleration",
        "newmark",
        "hht",
        "generalized-alpha",
        "bathe",
        "central-difference",
        "moreau-jean",
    ];
    for law in LAWS {
        let named: Vec<String> = methods.iter().map(|name| format!("{name:?}")).collect();
        let parameters = format!(r#""dt": 0.001, "method": [{}]"#, named.join(", "));
        let study = study(&driven(
            law,
            &parameters,
            r#""last(m)", "peak(m)", "peak(c.S)", "energy_error""#,
        ));
        let mut first = None;
        for (i, method) in methods.iter().enumerate() {
            let case = study.case(i as u64).unwrap();
            let found = study.problem.solve(&case, &[]).unwrap();
            let metrics: Vec<f64> = found.metrics.iter().map(|m| m.unwrap()).collect();
            let first = first.get_or_insert(metrics.clone());
            assert!(
                metrics[2] > 1.0 && metrics[3] < 1e-11,
                "{law} {method} {metrics:?}"
            );
            for k in 0..3 {
                // Corners within steps, and a damper that is steep at rest, cost the first order.
                let difference = (metrics[k] - first[k]).abs();
                assert!(
                    difference < 1e-2 * first[k.max(1)],
                    "{law} {method} {metrics:?} {first:?}"
                );
            }
        }
    }
}

#[test]
fn steps_tend_to_the_exact_motion() {
    for law in LAWS {
        let error = |dt: &str| {
            let text = driven(
                law,
                &format!(r#""dt": {dt}"#),
                r#""rms_error(m)", "step_error(c.r)""#,
            );
            let study = study(&text);
            let case = study.case(0).unwrap();
            let solution = study.problem.solve(&case, &[]);
            solution.map(|found| {
                found
                    .metrics
                    .iter()
                    .map(|m| m.unwrap())
                    .collect::<Vec<f64>>()
            })
        };
        let (coarse, fine) = (error("0.004").unwrap(), error("0.001").unwrap());
        for (coarse, fine) in coarse.iter().zip(&fine) {
            assert!(
                *coarse < 1e-3 && *fine < 0.15 * coarse,
                "{law} {coarse} {fine}"
            );
        }
    }
}

#[test]
fn integrated_motions_tell_their_error() {
    for (i, law) in LAWS.iter().enumerate() {
        let text = driven(
            law,
            r#""dt": 0.01"#,
            r#""reference_error(m)", "step_error(m)""#,
        );
        let study = study(&text);
        let solution = study.problem.solve(&study.case(0).unwrap(), &[]).unwrap();
        let (error, of_step) = (solution.metrics[0], solution.metrics[1].unwrap());
        match i < 6 {
            // By events.
            true => assert_eq!(error, None, "{law}"),
            false => assert!(error.unwrap() < 1e-4 * of_step, "{law} {error:?} {of_step}"),
        }
    }
}

#[test]
fn an_axis_may_be_a_number_of_a_table() {
    let table = r#""law": "multilinear", "table": {"r": [0.05, 0.5], "S": [3, "top"]}"#;
    let text = driven(table, r#""dt": 0.01, "top": [3, 5]"#, r#""peak(c.S)""#);
    let study = study(&text);
    let peaks = [0, 1].map(|i| {
        let case = study.case(i).unwrap();
        study.problem.solve(&case, &[]).unwrap().metrics[0].unwrap()
    });
    // Perfectly plastic with 3; with 5 it hardens.
    assert!(
        (peaks[0] - 3.0).abs() < 1e-14 && peaks[1] > 3.1,
        "{peaks:?}"
    );
}

#[test]
fn numbers_that_make_no_part_are_faults_with_their_place() {
    for (contact, part) in [
        (
            r#""law": "bilinear", "Fy": 4, "ratio": 0.1"#,
            "bilinear needs k1",
        ),
        (
            r#""law": "bilinear", "k1": 5, "Fy": 4"#,
            "bilinear needs k2 or ratio",
        ),
        (
            r#""law": "bilinear", "k1": 5, "Fy": 4, "k2": 6"#,
            "k2 must be at most k1 = 5, got 6",
        ),
        (
            r#""law": "bilinear", "k1": 5, "Fy": 4, "k2": 1, "ratio": 0.1"#,
            "give k2 or ratio, not both",
        ),
        (
            r#""law": "gap-yield", "k": 5, "Fy": 4, "damage": 0.5"#,
            "0 or 1",
        ),
        (
            r#""law": "restrainer", "k": 5, "Fy": 4, "slack": -1"#,
            ">= 0",
        ),
        (r#""law": "viscous", "c": 5, "a": 0.05"#, "from 0.1 to 2"),
        (
            r#""law": "hyperbolic-gap", "k": 5, "Fult": 4, "k_unloading": 3"#,
            "k must be at most k_unloading = 3, got 5",
        ),
        (
            r#""law": "impact-yield", "k1": 5, "k2": 0, "delta_y": 1"#,
            "k2 must be > 0",
        ),
        (
            r#""law": "pendulum", "limit": 5, "R": 1, "k": 9"#,
            "pendulum needs nu and N",
        ),
        (
            r#""law": "multilinear""#,
            "table: it needs a point with r > 0",
        ),
        (
            r#""law": "multilinear", "table": {"r": [1, 2], "S": [1, 3]}"#,
            "its slope must not rise",
        ),
        (
            r#""law": "multilinear", "table": {"r": [1, 2], "S": [1]}"#,
            "as many numbers in r as in S",
        ),
        (
            r#""law": "multilinear", "table": {"r": [1]}"#,
            "table.S: missing",
        ),
        (
            r#""law": "viscous", "c": 5, "a": 1, "k": 3"#,
            "a contact with law viscous has no k; it has c, a",
        ),
    ] {
        let found = faults(&driven(contact, r#""dt": 0.01"#, r#""peak(m)""#));
        assert!(
            found.contains(part) && found.contains("contacts.c"),
            "{contact}: {found}"
        );
    }
}
