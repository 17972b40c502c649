//! Numbers of a study that become numbers of a structure.

use super::{solved, study};
use std::f64::consts::PI;

/// The metrics of the only case of a study.
fn metrics(text: &str) -> Vec<f64> {
    let solution = solved(&study(text));
    solution.metrics.iter().map(|x| x.unwrap()).collect()
}

/// Free vibration with omega = 1 from u = 1, with this damping ratio, after the time 2 pi.
fn decayed(ratio: f64) -> f64 {
    let damped = f64::sqrt(1.0 - ratio * ratio);
    let (sin, cos) = (2.0 * PI * damped).sin_cos();
    libm::exp(-2.0 * PI * ratio) * (cos + ratio / damped * sin)
}

#[test]
fn a_spring_by_its_period_has_the_damping_ratio_of_its_mass() {
    let found = metrics(
        r#"{"problem": "structure", "parameters": {"dt": "2*pi/20000", "duration": "2*pi"},
            "structure": {"masses": {"m": 3}, "start": {"m": {"u": 1}},
                "springs": [{"between": ["ground", "m"], "mass": 3, "period": "2*pi", "ratio": 0.1}]},
            "metrics": ["last(m)"]}"#,
    );
    // The period of the method is longer by the part (omega dt)^2/12 = 8e-9.
    assert!((found[0] - decayed(0.1)).abs() < 1e-7, "{found:?}");
}

#[test]
fn stiffness_damping_of_a_bar_does_not_depend_on_its_elements() {
    // Two elements of stiffness 2 EA/L, ends of mass m/4, in the mode (1, 0, -1): omega^2 = 8 EA/(L m) = 1. Four elements with the
    // masses (1/2, 1, 1, 1, 1/2) m/4 in the mode cos(i pi/4): omega^2 = 64 EA/(L m) sin^2(pi/8).
    let c = 0.5 * f64::sqrt(2.0);
    let starts = [
        (
            2,
            8.0,
            r#""b.left": {"u": 1}, "b.right": {"u": -1}"#.to_owned(),
        ),
        (
            4,
            32.0 * (1.0 - c),
            format!(
                r#""b.left": {{"u": 1}}, "b.1": {{"u": {c}}}, "b.3": {{"u": -{c}}}, "b.right": {{"u": -1}}"#
            ),
        ),
    ];
    for (n, mass, start) in starts {
        let found = metrics(&format!(
            r#"{{"problem": "structure", "parameters": {{"dt": "2*pi/20000", "duration": "2*pi"}},
                "structure": {{"bars": {{"b": {{"L": 1, "EA": 1, "mass": {mass}, "n": {n}, "stiffness_damping": 0.2}}}},
                    "start": {{{start}}}}},
                "metrics": ["last(b.left)"]}}"#
        ));
        // C = 0.2 K gives the ratio 0.2 omega/2. The period of the method is longer by the part 8e-9.
        assert!((found[0] - decayed(0.1)).abs() < 1e-7, "{n} {found:?}");
    }
}

#[test]
fn a_vertical_motion_changes_the_weight_in_any_unit_of_length() {
    for (units, unit) in [("t, kN, m, s", 1.0), ("t, N, mm, s", 1000.0)] {
        let up = 0.1 * 9.80665 * unit;
        let found = metrics(&format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.1, "duration": 1}},
                "structure": {{"units": "{units}", "masses": {{"m": 1}}, "contacts": {{"c": {{"law": "coulomb",
                    "between": ["ground", "m"], "nu": 0.3,
                    "N": {{"weight": 20, "vertical": {{"table": {{"t": [0, 1], "f": [{up}, {up}]}}}}}}}}}}}},
                "metrics": ["min(c.limit)", "max(c.limit)"]}}"#
        ));
        // nu W (1 + a/g), with three roundings.
        for limit in found {
            assert!((limit / 6.6 - 1.0).abs() < 4.0 * f64::EPSILON, "{limit}");
        }
    }
}

#[test]
fn a_model_in_inches_feet_and_kips_has_the_numbers_of_the_same_model_in_si() {
    // One building under a synthetic motion of a given peak: masses, stiffnesses, forces and lengths in each system.
    let pound = 0.45359237 * 9.80665;
    let in_units = |units: &str, mass: f64, force: f64, length: f64| {
        let [m, k, fy, limit, gap] = [
            150e3 / mass,
            3e7 / (force / length),
            4e5 / force,
            4e4 / force,
            0.02 / length,
        ];
        let found = metrics(&format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.005, "duration": 8}},
                "structure": {{"units": "{units}", "masses": {{"a|b": {m}}},
                    "springs": [{{"between": ["a", "b"], "k": {k}, "c": {}}}],
                    "contacts": {{"storey": {{"law": "bilinear", "between": ["ground", "a"], "k1": {k}, "Fy": {fy}, "ratio": 0.05}},
                        "pad": {{"law": "coulomb", "between": ["ground", "b"], "limit": {limit}}},
                        "stop": {{"law": "impact", "between": ["b", "ground"], "gap": {gap}, "k": {}}}}},
                    "ground": {{"synthetic": 3, "scale_to": {{"pga": 0.3, "unit": "g"}}}}}},
                "metrics": ["peak(a)", "rms(b)", "peak(b.v)", "peak(b.a_abs)", "peak(storey.S)", "peak(stop.S)", "work(pad)", "ground.pga"]}}"#,
            k / 100.0,
            10.0 * k,
        ));
        let sizes = [
            length,
            length,
            length,
            length,
            force,
            force,
            force * length,
            length,
        ];
        let in_si = found.iter().zip(sizes).map(|(value, size)| value * size);
        in_si.collect::<Vec<f64>>()
    };
    let si = in_units("kg, N, m, s", 1.0, 1.0, 1.0);
    assert!(si.iter().all(|value| *value > 0.0), "{si:?}");
    // 1 g by definition: peak of the motion, 0.3 g.
    assert!((si[7] / (0.3 * 9.80665) - 1.0).abs() < 1e-14);
    for (units, mass, force, length) in [
        (
            "kip s2/in, kip, in, s",
            1e3 * pound / 0.0254,
            1e3 * pound,
            0.0254,
        ),
        ("slug, lbf, ft, s", pound / 0.3048, pound, 0.3048),
        ("lbf s2/in, lbf, in, s", pound / 0.0254, pound, 0.0254),
    ] {
        let own_units = in_units(units, mass, force, length);
        for (value, exact) in own_units.iter().zip(&si) {
            // Round-off of 1600 steps with sliding, yielding and blows.
            assert!(
                (value / exact - 1.0).abs() < 1e-9,
                "{units}: {own_units:?} {si:?}"
            );
        }
    }
}

/// A mass of 1 with v = 1 on friction with this N, for 2 with dt = 0.25.
fn sliding(normal: &str, law: &str) -> Vec<f64> {
    metrics(&format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.25, "duration": 2}},
            "structure": {{"masses": {{"m": 1}}, "start": {{"m": {{"v": 1}}}},
                "contacts": {{"c": {{{law}, "between": ["ground", "m"], "nu": 0.125, "N": {normal}}}}}}},
            "metrics": ["open_time(c)", "max(c.limit)", "min(c.limit)", "last(m)"]}}"#
    ))
}

#[test]
fn friction_is_open_where_n_is_not_positive() {
    let law = r#""law": "velocity-control", "c": 1e6"#;
    // N = 3.6 - 4 t is positive up to t = 0.9: the steps that end at 1, 1.25, .., 2 are open.
    let falling = sliding(r#"{"t": [0, 2], "N": [3.6, -4.4]}"#, law);
    assert_eq!(falling[0], 1.25);
    assert!((falling[1] - 0.45).abs() < 1e-15 && falling[2] == 0.0);
    // N = 0 at both ends of the steps between 0.5 and 1.
    let zero = sliding(r#"{"t": [0, 0.5, 1, 2], "N": [8, 0, 0, 8]}"#, law);
    assert_eq!(zero[0], 0.75);
    // A constant N that pulls has no friction with any law: the mass moves on with v = 1.
    for law in [
        r#""law": "coulomb""#,
        law,
        r#""law": "displacement-control", "k": 1e6"#,
        r#""law": "bouc-wen", "k": 1e6"#,
        r#""law": "tanh", "c": 1e6"#,
        r#""law": "lugre", "sigma0": 1e6"#,
    ] {
        for normal in ["-8", r#"{"t": [0, 2], "N": [-8, -8]}"#] {
            assert_eq!(sliding(normal, law), [2.0, 0.0, 0.0, 2.0], "{law}");
        }
    }
}
