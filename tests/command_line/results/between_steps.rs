//! Loads and supports that change between the steps.

use crate::Bench;

/// The column of a metric in the table of study `s`.
fn column(bench: &Bench, name: &str) -> Vec<f64> {
    let table = bench.text("figures/s/results.csv");
    let mut lines = table.lines();
    let column = lines
        .next()
        .unwrap()
        .split(',')
        .position(|cell| cell == name);
    let of = |line: &str| {
        line.split(',')
            .nth(column.unwrap())
            .unwrap()
            .parse()
            .unwrap()
    };
    lines.map(of).collect()
}

/// How many cases of study `s` have the warning.
fn warned(bench: &Bench, study: &str) -> bool {
    bench.file("s.json", study);
    let done = bench.expect(0, &["run", "s.json"]);
    let explained = bench.expect(0, &["explain", "s.json"]);
    let warned = done.err.contains("motion-cut");
    assert_eq!(
        explained.out.contains("motion-cut"),
        warned,
        "{explained:?}"
    );
    warned
}

#[test]
fn a_support_that_moves_within_a_step_pulls_by_its_displacement() {
    let bench = Bench::new();
    // By scipy: peaks of the mass 0.1859 for ramps up to 5 ms, 0.1858 at 20 ms; the last value at 1 ms is 0.0738.
    for (ramp, dt, peak, limit, warns) in [
        (0.001, 0.01, 0.1859, 6e-4, true),
        (0.0001, 0.01, 0.1859, 6e-4, true),
        (0.001, 0.001, 0.1859, 1e-4, true),
        (0.02, 0.001, 0.1858, 1e-4, false),
    ] {
        let study = format!(
            r#"{{"problem": "structure", "parameters": {{"dt": {dt}, "duration": 2}}, "structure": {{
            "units": "t, kN, m, s", "masses": {{"m": 1}},
            "springs": [{{"between": ["s", "m"], "mass": 1, "period": 0.7, "ratio": 0.05}}],
            "supports": {{"s": {{"displacement": {{"t": [0, {ramp}], "u": [0, 0.1]}}}}}}}},
            "metrics": ["peak(m)", "last(m)", "step_error(m)", "energy_error"]}}"#
        );
        assert_eq!(warned(&bench, &study), warns, "{ramp} {dt}");
        let found = column(&bench, "peak(m)")[0];
        // Four digits are given; the period is 70 long steps.
        assert!((found - peak).abs() < limit, "{ramp} {dt}: {found}");
        assert!(column(&bench, "energy_error")[0] < 1e-12);
    }
}

#[test]
fn a_blow_between_steps_gives_its_impulse() {
    let bench = Bench::new();
    for (dt, warns) in [
        (0.01, true),
        (0.005, true),
        (0.0025, false),
        (0.0001, false),
    ] {
        let study = format!(
            r#"{{"problem": "structure", "parameters": {{"dt": {dt}, "duration": 1}}, "structure": {{
            "units": "kg, N, m, s", "masses": {{"m": 1}},
            "springs": [{{"between": ["ground", "m"], "mass": 1, "period": 1, "ratio": 0}}],
            "loads": [{{"at": "m", "table": {{"t": [0.0021, 0.0021, 0.0029, 0.0029], "f": [0, 1000, 1000, 0]}}}}]}},
            "metrics": ["peak(m.v)"]}}"#
        );
        assert_eq!(warned(&bench, &study), warns, "{dt}");
        // 0.8 N s on 1 kg; during the blow and the step the spring takes up to (omega t)^2/2 of it.
        let found = column(&bench, "peak(m.v)")[0];
        let time = f64::max(dt, 8e-4);
        assert!(
            (found - 0.8).abs() < 0.8 * 20.0 * time * time,
            "{dt}: {found}"
        );
    }
}

#[test]
fn a_sine_needs_eight_steps() {
    let bench = Bench::new();
    for (omega, warns) in [(70, false), (90, true), (628, true), (2000, true)] {
        let study = format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1}}, "structure": {{
            "units": "kg, N, m, s", "masses": {{"m": 1}},
            "springs": [{{"between": ["ground", "m"], "mass": 1, "period": 1, "ratio": 0.05}}],
            "loads": [{{"at": "m", "sine": {{"amplitude": 1, "omega": {omega}}}}}]}},
            "metrics": ["peak(m)"]}}"#
        );
        assert_eq!(warned(&bench, &study), warns, "{omega}");
    }
}
