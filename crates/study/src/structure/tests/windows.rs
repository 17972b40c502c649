//! Reductions of a part of the motion, and means over time.

use super::{faults, solved, study};

/// The metrics of the only case of a study.
fn metrics(text: &str) -> Vec<f64> {
    let solution = solved(&study(text));
    solution.metrics.iter().map(|x| x.unwrap()).collect()
}

/// A free mass that moves with u = t for 2 with dt = 0.25, with these metrics, and T = 1.5.
fn moving(metrics: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.25, "duration": 2, "T": 1.5}},
            "structure": {{"units": "t, kN, m, s", "masses": {{"m": "2*T"}}, "start": {{"m": {{"v": 1}}}}, "contacts_reference": "softened"}},
            "metrics": [{metrics}]}}"#
    )
}

#[test]
fn a_window_has_the_steps_between_its_limits() {
    // The steps at 0.5, 0.75 and 1 are from 0.3 to 1.1; all numbers are exact.
    let found = metrics(&moving(
        r#""peak(m, from=0.3, to=1.1)", "min(m, from=0.3,to=1.1)", "max( m , to = 1.1 )", "last(m, to=1.1)",
           "time_of_peak(m, from=0.3, to=1.1)", "mean(m, from=0.3, to=1.1)", "rms(m, from=0.3, to=1.1)",
           "min(m, from=T/2, to=max(T, 1.5))", "mean(m)", "residual(m, from=1)", "peak(m, from=0.3, to=1.1)/min(m, from=0.5)",
           "last_error(m, to=1)""#,
    ));
    let rms = f64::sqrt((0.25 + 0.5625 + 1.0) / 3.0);
    let expected = [
        1.0, 0.5, 1.0, 1.0, 1.0, 0.75, rms, 0.75, 1.0, 1.75, 0.5, 0.0,
    ];
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-15, "{found} {expected}");
    }
}

#[test]
fn a_window_is_in_titles_in_words() {
    let study = study(&moving(
        r#""peak(m, from=0.5, to=1)", "rms(m, from=T)", "mean(m, to=1)""#,
    ));
    let titles: Vec<String> = (0..3).map(|row| study.title(row)).collect();
    assert_eq!(
        titles,
        [
            "Peak displacement of m from 0.5 to 1 s, m",
            "Rms displacement of m from T, m",
            "Mean displacement of m to 1 s, m"
        ]
    );
}

#[test]
fn a_window_outside_of_the_motion_is_a_fault() {
    for (metric, part) in [
        ("peak(m, from=1, to=1)", "from = 1 is not before to = 1"),
        (
            "peak(m, from=T, to=1)",
            "from = T = 1.5 is not before to = 1",
        ),
        (
            "peak(m, from=2)",
            "from = 2 is not before the end of the motion, duration = 2",
        ),
        (
            "peak(m, to=2.5)",
            "to = 2.5 is after the end of the motion, duration = 2",
        ),
        ("peak(m, to=2*T)", "to = 2*T = 3 is after the end"),
        (
            "peak(m, from=0.3, to=0.4)",
            "no step is between from = 0.3 and to = 0.4, dt = 0.25",
        ),
        ("peak(m, from=-1)", "must be >= 0"),
        ("peak(m, from=1, from=1.5)", "from= is given twice"),
        ("peak(m, from=)", "from= needs a time"),
        (
            "peak(m, form=1)",
            "no 'form='; a window is from=TIME, to=TIME",
        ),
        ("peak(from=1, m)", "stand last in the brackets"),
        ("peak(from=1)", "needs a channel"),
        ("peak(m, from=x)", "x"),
        (
            "energy_error(from=1)",
            "takes no from= and to=; these do: peak, last",
        ),
        ("divergence(m, 0.01, from=1)", "takes no from="),
    ] {
        let found = faults(&moving(&format!("\"{metric}\"")));
        assert!(found.contains(part), "{metric}: {found}");
        assert!(found.contains("metrics[0]"), "{metric}: {found}");
    }
}

#[test]
fn errors_of_a_window_are_those_of_a_frequency_that_is_too_low() {
    // u = cos t; average acceleration has cos(w t) with tan(w dt/2) = dt/2 at the steps.
    let found = metrics(
        r#"{"problem": "structure", "parameters": {"dt": 0.5, "duration": 20, "begin": 10},
            "structure": {"masses": {"m": 1}, "start": {"m": {"u": 1}}, "springs": [{"between": ["ground", "m"], "k": 1}],
                "contacts_reference": "softened"},
            "metrics": ["rms_error(m, from=begin)", "peak_error(m, from=12, to=14)", "last_error(m, to=15.2)", "step_error(m, from=begin)",
                "difference(m, from=begin)", "rms(m, to=2*begin)"]}"#,
    );
    let w = 2.0 / 0.5 * f64::atan(0.25);
    let computed = |i: usize| libm::cos(w * 0.5 * i as f64);
    let exact = |i: usize| libm::cos(0.5 * i as f64);
    let squares: f64 = (20..=40).map(|i| (computed(i) - exact(i)).powi(2)).sum();
    let peak =
        |of: &dyn Fn(usize) -> f64| (24..=28).fold(0.0, |most: f64, i| most.max(of(i).abs()));
    let rms = (squares / 21.0).sqrt();
    let all: f64 = (0..=40).map(|i| computed(i).powi(2)).sum();
    let expected = [
        rms,
        (peak(&computed) - peak(&exact)).abs(),
        (computed(30) - exact(30)).abs(),
        rms,
        1e-10,
        (all / 41.0).sqrt(),
    ];
    for (found, expected) in found.iter().zip(expected) {
        // The round-off of 40 steps, and of the exact motion.
        assert!((found - expected).abs() < 1e-13, "{found} {expected}");
    }
}

#[test]
fn the_exact_motion_has_means_and_windows() {
    // u = 1 - cos t from rest under a load of 1: the mean from pi to 2 pi is 1, the residual 1.
    let study = study(
        r#"{"problem": "structure", "parameters": {"dt": ["pi/200", "pi/100"], "duration": "12*pi"},
            "structure": {"masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 1}],
                "loads": [{"at": "m", "table": {"t": [0, 40], "f": [1, 1]}}], "contacts_reference": "softened"},
            "metrics": ["mean(m, from=pi, to=2*pi)", "residual(m)", "max(m, from=0.5*pi, to=0.75*pi)"],
            "recommend": {"over": ["dt"], "within": {"mean(m, from=pi, to=2*pi)": 0.01, "residual(m)": 0.01}}}"#,
    );
    let case = study.case(0).unwrap();
    let problem = study.problem.as_structure().unwrap();
    let exact = problem.exact_metrics(&case, &[0, 1, 2]);
    let expected = [1.0, 1.0, 1.0 + 0.5 * f64::sqrt(2.0)];
    for (found, expected) in exact.iter().zip(expected) {
        let found = found.unwrap();
        // The trapezoids are symmetric about the middle of each half wave.
        assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    }
}

/// A slider of mass 1 with v = 1 and friction 0.8 under a light oscillator with omega = 2 pi and the damping ratio 0.03, for 8.
fn slider(dt: f64) -> Vec<f64> {
    metrics(&format!(
        r#"{{"problem": "structure", "parameters": {{"dt": {dt}, "duration": 8}},
            "structure": {{"masses": {{"slider": 1, "light": 1e-9}}, "start": {{"slider": {{"v": 1}}, "light": {{"v": 1}}}},
                "springs": [{{"between": ["slider", "light"], "mass": 1e-9, "period": 1, "ratio": 0.03}}],
                "contacts": {{"base": {{"law": "coulomb", "between": ["ground", "slider"], "limit": 0.8}}}}}},
            "metrics": ["peak(light)", "residual(light)", "residual(light, from=2)", "mean(light, from=2, to=8)", "last(light)"]}}"#
    ))
}

#[test]
fn the_residual_is_where_friction_stops_a_vibrating_mass() {
    // The slider stops after v^2/(2 a) = 0.625 at t = 1.25; the light mass, 1e-9 of it, vibrates about it from then on.
    let offset = 0.625;
    for dt in [0.02, 0.01, 0.005] {
        let found = slider(dt);
        let most = 0.003 * found[0];
        assert!((found[1] - offset).abs() < most, "{dt} {found:?}");
        assert!((found[2] - offset).abs() < most, "{dt} {found:?}");
        assert!((found[4] - offset).abs() > most, "{dt} {found:?}");
    }
}

#[test]
fn reductions_of_contacts_have_windows() {
    // A ball of mass 2 between two stops at -0.5 and 0.5, from 0 with v = 1: it strikes at some 0.5, 1.5, 2.5, .. in turn.
    let found = metrics(
        r#"{"problem": "structure", "parameters": {"dt": 0.001, "duration": 6},
            "structure": {"masses": {"m": 2}, "start": {"m": {"v": 1}},
                "contacts": {"right": {"law": "impact", "between": ["m", "ground"], "gap": 0.5, "k": 2e4},
                             "left": {"law": "impact", "between": ["ground", "m"], "gap": 0.5, "k": 2e4}}},
            "metrics": ["impacts(right)", "impacts(right, from=1, to=5)", "impacts(left, to=2)", "impacts(left, from=2, to=3)",
                        "impulse(right, from=1, to=3.5)", "contact_time(right, from=1)", "impacts(right, from=0.51)", "work(right, to=0.516)"]}"#,
    );
    assert_eq!(found[..4], [3.0, 2.0, 1.0, 0.0], "{found:?}");
    // At 0.51 the ball is at the stop: its impact began before.
    assert_eq!(found[6], 2.0);
    let half_period = std::f64::consts::PI / 100.0;
    // The impulse 2 m v and the time of a half wave: an impact begins and ends within steps of 1/30 of it.
    assert!((found[4] - 4.0).abs() < 0.02, "{found:?}");
    assert!((found[5] - 2.0 * half_period).abs() < 0.003, "{found:?}");
    // The stop has the whole energy m v^2/2 at half of the impact, 0.5157; trapezoids err by the first step, of up to 1/30.
    assert!((found[7] - 1.0).abs() < 0.005, "{found:?}");
}

#[test]
fn the_energy_of_a_cycle_counts_from_a_time_on() {
    // Imposed displacements of amplitude 1 up to t = 7, then of 2: 4 F (X - x_y), F = 1 and x_y = 1/1000. They rise through 0 at t = 4,
    // 7.67, 12, 16 and 20.6.
    let study = study(
        r#"{"problem": "structure", "parameters": {"dt": 0.0005, "duration": 21},
            "structure": {"masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 1}],
                "supports": {"s": {"displacement": {"t": [0, 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21],
                    "u": [0, 1, -1, 1, -1, 2, -2, 2, -2, 2, -2, 0.5], "between": "straight"}}},
                "contacts": {"slider": {"law": "displacement-control", "between": ["ground", "s"], "k": 1000, "limit": 1}}},
            "metrics": ["energy_per_cycle(slider)", "energy_per_cycle(slider, from=7.5)", "energy_per_cycle(slider, from = 10)",
                "energy_per_cycle(slider,to=9)", "energy_per_cycle(slider, from=18)"]}"#,
    );
    let problem = study.problem.as_structure().unwrap();
    let exact = problem.exact_metrics(&study.case(0).unwrap(), &[0, 1, 2, 3, 4]);
    // Up to 9 the cycles rise through the middle of -1 and 2; from 18 on there is no whole one.
    let expected = [Some(7.0), Some(8.0), Some(8.0), Some(4.0), None];
    for energies in [solved(&study).metrics, exact] {
        for (energy, expected) in energies.iter().zip(expected) {
            // Each bend of the force cuts a triangle of at most k (2 dt)^2/2 = 5e-4, four of them in a cycle.
            let near = |(energy, expected): (f64, f64)| (energy - expected + 0.004).abs() < 2e-3;
            assert_eq!(energy.is_some(), expected.is_some(), "{energies:?}");
            assert!(energy.zip(expected).is_none_or(near), "{energies:?}");
        }
    }
}
