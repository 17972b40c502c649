//! Normal forces, radii, yield forces, slacks, gravity and damping that are allowed and unlikely.

use crate::Bench;
use crate::warnings::some;

/// A body of 100 t on contacts, shaken; `more` follows the ground.
fn body(contacts: &str, more: &str, metric: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"x": [1, 10], "dt": 0.005, "duration": "10 + 0*x"}},
          "structure": {{"units": "t, kN, m, s", "masses": {{"a": 100}}, "contacts": {{{contacts}}},
            "ground": {{"synthetic": 1}}{more}}}, "metrics": ["{metric}"]}}"#
    )
}

/// A sliding bearing under the body with this N and R.
fn bearing(name: &str, normal: &str, radius: &str) -> String {
    format!(
        r#""{name}": {{"law": "pendulum", "between": ["ground", "a"], "R": {radius}, "N": {normal}, "nu": 0.05, "rE": 0.001}}"#
    )
}

/// A spring that holds the body.
const SPRING: &str =
    r#", "springs": [{"between": ["ground", "a"], "mass": 100, "period": 1, "ratio": 0.05}]"#;

#[test]
fn normal_forces_together_are_the_weight_of_what_rests_on_them() {
    let bench = Bench::new();
    // The weight is 981 kN: a quarter of it is 245, four times are 3923.
    let pressed = |normal: &str| bearing("p", normal, "2");
    let far = some(&[("normal-weight", 1, 0)]);
    assert_eq!(
        bench.kinds(&body(&pressed("\"100*x\""), "", "peak(a)")),
        far
    );
    let told = bench.text("figures/s/manifest.json");
    assert!(
        told.contains("under a mass with the weight 980.665"),
        "{told}"
    );
    for (normal, expected) in [
        ("\"23*x + 220\"", far.clone()),
        ("\"x + 245\"", vec![]),
        ("\"391*x\"", vec![]),
        ("\"393*x\"", some(&[("normal-weight", 1, 1)])),
    ] {
        assert_eq!(
            bench.kinds(&body(&pressed(normal), "", "peak(a)")),
            expected,
            "{normal}"
        );
    }
    // Two bearings share it; what a spring or a bearing without N holds rests elsewhere.
    let two = format!("{}, {}", bearing("p", "130", "2"), bearing("q", "130", "2"));
    assert_eq!(bench.kinds(&body(&two, "", "peak(a)")), []);
    assert_eq!(
        bench.kinds(&body(&pressed("\"100*x\""), SPRING, "peak(a)")),
        []
    );
    let rubber = format!(
        r#"{}, "r": {{"law": "bilinear", "between": ["ground", "a"], "k1": 1e4, "Fy": 50, "k2": 1e3}}"#,
        pressed("\"100*x\"")
    );
    assert_eq!(bench.kinds(&body(&rubber, "", "peak(a)")), []);
    let without =
        body(&pressed("\"100*x\""), "", "peak(a)").replace("\"units\": \"t, kN, m, s\", ", "");
    assert_eq!(bench.kinds(&without), []);
}

#[test]
fn a_radius_in_millimetres_is_found() {
    let bench = Bench::new();
    let study = body(&bearing("p", "981", "\"30*x\""), "", "peak(a)");
    assert_eq!(bench.kinds(&study), some(&[("large-radius", 1, 1)]));
}

#[test]
fn what_never_yields_or_pulls_in_any_case_is_found() {
    let bench = Bench::new();
    let with = |contact: &str| {
        body(
            &format!(r#""c": {{"between": ["ground", "a"], {contact}}}"#),
            SPRING,
            "peak(a)",
        )
    };
    let lead = |fy: &str| {
        with(&format!(
            r#""law": "bilinear", "k1": 1e4, "Fy": {fy}, "k2": 1e3"#
        ))
    };
    assert_eq!(
        bench.kinds(&lead("\"2e4*x\"")),
        some(&[("never-yields", 2, 0)])
    );
    assert_eq!(bench.kinds(&lead("\"20*x^4\"")), []);
    let cable = |slack: &str, fy: &str| {
        with(&format!(
            r#""law": "restrainer", "slack": {slack}, "k": 1e4, "Fy": {fy}"#
        ))
    };
    assert_eq!(
        bench.kinds(&cable("\"2*x\"", "10")),
        some(&[("never-pulls", 2, 0)])
    );
    assert_eq!(bench.kinds(&cable("\"0.01*x^2\"", "10")), []);
    assert_eq!(
        bench.kinds(&cable("0.01", "1e6")),
        some(&[("never-yields", 2, 0)])
    );
}

#[test]
fn springs_press_friction_in_compression_only() {
    let bench = Bench::new();
    let study = |more: &str| {
        format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.005, "duration": 10}},
              "structure": {{"units": "t, kN, m, s", "masses": {{"a": 100, "b": {{"mass": 100, "direction": "y"}}}},
                "springs": [{{"name": "pad", "between": ["ground", "b"], "k": 1e5, "c": 100}}, {{"between": ["ground", "a"], "k": 1e3}}],
                "contacts": {{"p": {{"law": "coulomb", "between": ["ground", "a"], "nu": 0.1, "N": {{"contact": "pad"}}}}}},
                "ground": {{"x": {{"synthetic": 1}}, "y": {{"synthetic": 2, "scale": 0.1}}}}{more}}}, "metrics": ["peak(a)"]}}"#
        )
    };
    assert_eq!(bench.kinds(&study("")), some(&[("normal-tension", 1, 0)]));
    let weight = r#", "static": {"gravity": -9.81}"#;
    assert_eq!(bench.kinds(&study(weight)), []);
    let lifted = r#", "static": {"gravity": 9.81}"#;
    assert_eq!(
        bench.kinds(&study(lifted)),
        some(&[("normal-tension", 1, 0)])
    );
}

#[test]
fn friction_carries_no_weight() {
    let bench = Bench::new();
    let study = |gravity: &str, more: &str| {
        format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.005, "duration": 5}},
              "structure": {{"units": "t, kN, m, s", "masses": {{"a": 100, "b": {{"mass": 100, "direction": "y"}}}},
                "contacts": {{"p": {{"law": "pendulum", "plane": [["ground", "a"], ["ground", "b"]], "R": 2, "N": 981, "nu": 0.05, "rE": 0.001}}}},
                "static": {{"gravity": {gravity}}}, "ground": {{"x": {{"synthetic": 1}}}}{more}}}, "metrics": ["peak(a)"]}}"#
        )
    };
    let found = some(&[("idle-gravity", 1, 0)]);
    assert_eq!(bench.kinds(&study("-9.81", "")), found);
    // A part of gravity acts along a slope; a spring carries all of it.
    assert_eq!(bench.kinds(&study("-0.4", "")), []);
    let spring = r#", "springs": [{"between": ["ground", "b"], "k": 1e4, "c": 10}]"#;
    assert_eq!(bench.kinds(&study("-9.81", spring)), []);
}

#[test]
fn damping_acts_once_and_impacts_need_some() {
    let bench = Bench::new();
    let impact = r#""c": {"law": "impact", "between": ["ground", "a"], "gap": 0.02, "k": 1e5}"#;
    let study = |more: &str| body(impact, more, "peak(a)");
    let bare = SPRING.replace(r#", "ratio": 0.05"#, "");
    assert_eq!(bench.kinds(&study(SPRING)), []);
    assert_eq!(bench.kinds(&study(&bare)), some(&[("undamped", 2, 0)]));
    for twice in [
        format!(r#"{SPRING}, "modal_damping": 0.05"#),
        format!(r#"{SPRING}, "rayleigh": {{"stiffness": 0.01}}"#),
        format!(r#"{bare}, "rayleigh": {{"mass": 0.1}}, "modal_damping": 0.05"#),
    ] {
        assert_eq!(
            bench.kinds(&study(&twice)),
            some(&[("damped-twice", 2, 0)]),
            "{twice}"
        );
    }
    for once in [
        format!(r#"{SPRING}, "modal_damping": 0"#),
        format!(r#"{bare}, "rayleigh": {{"stiffness": 0.01}}"#),
    ] {
        assert_eq!(bench.kinds(&study(&once)), [], "{once}");
    }
    // Without an earthquake it is a textbook case.
    let start = study(&bare).replace(
        r#""ground": {"synthetic": 1}"#,
        r#""start": {"a": {"v": 1}}"#,
    );
    assert_eq!(bench.kinds(&start), []);
}

#[test]
fn a_sine_acceleration_of_a_support_drifts() {
    let bench = Bench::new();
    let study = |more: &str, duration: &str| {
        format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.002, "duration": {duration}}},
              "structure": {{"masses": {{"a": 1}}, "springs": [{{"between": ["s", "a"], "k": 4000, "c": 6}}],
                "supports": {{"s": {{"sine": {{"amplitude": 1, "omega": 10{more}}}}}}}}}, "metrics": ["peak(s)"]}}"#
        )
    };
    let found = some(&[("support-drift", 1, 0)]);
    assert_eq!(bench.kinds(&study("", "1")), found);
    assert_eq!(bench.kinds(&study("", "0.09")), []);
    assert_eq!(bench.kinds(&study(r#", "phase": "pi/2""#, "1")), []);
}
