//! Steps that are long for a structure itself, ends before `duration`, and motions that begin before t = 0.

use crate::Bench;
use crate::warnings::some;

/// Two masses of 1 one above the other on springs of k, with periods 2 pi/(0.618 sqrt k) and 2 pi/(1.618 sqrt k).
fn storeys(dt: &str, more: &str, metric: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"dt": {dt}, "duration": 10}},
          "structure": {{"masses": {{"a|b": 1}},
            "springs": [{{"between": ["ground", "a"], "k": 40}}, {{"between": ["a", "b"], "k": 40}}]{more}}},
          "metrics": ["{metric}"]}}"#
    )
}

const SHAKEN: &str = r#", "ground": {"synthetic": 1}"#;

/// The only kinds that matter here.
fn long(bench: &Bench, study: &str) -> Vec<(String, u64, u64)> {
    let kinds = bench.kinds(study).into_iter();
    kinds
        .filter(|kind| ["long-step", "ends-early", "time-before"].contains(&&*kind.0))
        .collect()
}

#[test]
fn a_mode_of_a_metric_needs_twelve_steps() {
    let bench = Bench::new();
    let golden = (1.0 + f64::sqrt(5.0)) / 2.0;
    let period = |factor: f64| std::f64::consts::TAU / (factor * f64::sqrt(40.0));
    let [first, second] = [period(golden - 1.0), period(golden)];
    let steps = |period: f64, counts: [f64; 2]| {
        let [few, enough] = counts.map(|count| format!("{:.9}", period / count));
        format!("[{few}, {enough}]")
    };
    let found = some(&[("long-step", 1, 0)]);
    let near = |period: f64| steps(period, [11.9, 12.1]);
    let of = |study: String| {
        let kinds = long(&bench, &study).into_iter();
        kinds
            .filter(|kind| kind.0 == "long-step")
            .collect::<Vec<_>>()
    };
    // The second mode has 9 % of the accelerations of the roof, and (0.382/2.618)^2 of that in displacements.
    assert_eq!(of(storeys(&near(second), SHAKEN, "peak(b.a_abs)")), found);
    let told = bench.text("figures/s/manifest.json");
    assert!(told.contains("a period of 0.614 has 11.9 steps"), "{told}");
    assert_eq!(of(storeys(&near(second), SHAKEN, "peak(b)")), []);
    assert_eq!(of(storeys(&near(first), SHAKEN, "peak(b)")), found);
    // A load drives it in both masses, a start velocity of its shape does nothing else.
    let load = r#", "loads": [{"at": "a", "table": {"t": [0], "f": [1]}}]"#;
    assert_eq!(of(storeys(&near(second), load, "peak(a)")), found);
    let start = format!(r#", "start": {{"a": {{"v": {golden}}}, "b": {{"v": -1}}}}"#);
    assert_eq!(of(storeys(&near(second), &start, "peak(b)")), found);
    let at_rest = r#", "static": {"a": 1}"#;
    assert_eq!(of(storeys(&near(second), at_rest, "peak(a)")), []);
    // Both modes follow a slow sine; its own start drives the first one only.
    let slow = r#", "ground": {"sine": {"amplitude": 1, "omega": 0.5}}"#;
    assert_eq!(of(storeys(&near(second), slow, "peak(b.a)")), []);
}

#[test]
fn links_are_elastic_friction_slides_and_energies_have_no_period() {
    let bench = Bench::new();
    let body = |law: &str, metric: &str| {
        format!(
            r#"{{"problem": "structure", "parameters": {{"dt": [0.05, 0.1], "duration": 10}},
              "structure": {{"masses": {{"a": 1}}, "ground": {{"synthetic": 1}},
                "contacts": {{"c": {{"between": ["ground", "a"], {law}}}}}}}, "metrics": ["{metric}"]}}"#
        )
    };
    // A period of 1 s: 20 and 10 steps.
    let k = std::f64::consts::TAU.powi(2);
    let link = format!(r#""law": "bilinear", "k1": {k}, "Fy": 1, "k2": 1"#);
    let found = some(&[("long-step", 1, 1)]);
    assert_eq!(long(&bench, &body(&link, "peak(a)")), found);
    assert_eq!(long(&bench, &body(&link, "peak(c.S)")), found);
    assert_eq!(long(&bench, &body(&link, "energy_error")), []);
    let friction = format!(r#""law": "displacement-control", "k": {k}, "limit": 1"#);
    assert_eq!(long(&bench, &body(&friction, "peak(a)")), []);
}

/// The peak of a case by the step; what twelve steps in a period cost.
#[test]
fn peaks_with_twelve_steps_err_by_some_percent() {
    let bench = Bench::new();
    let study = |dt: f64| {
        format!(
            r#"{{"problem": "structure", "parameters": {{"seed": {{"range": [1, 40, 1]}}, "dt": {dt}, "duration": 30}},
              "structure": {{"units": "t, kN, m, s", "masses": {{"a": 100}},
                "springs": [{{"between": ["ground", "a"], "mass": 100, "period": 0.5, "ratio": 0.05}}],
                "ground": {{"synthetic": "seed"}}}}, "metrics": ["peak(a)"]}}"#
        )
    };
    let peaks = |count: f64| -> Vec<f64> {
        bench.file("s.json", study(0.5 / count));
        bench.expect(0, &["run", "s.json"]);
        let table = bench.text("figures/s/results.csv");
        let rows = table.lines().skip(1);
        rows.map(|row| row.rsplit(',').next().unwrap().parse().unwrap())
            .collect()
    };
    let right = peaks(500.0);
    let errors = |count: f64| {
        let found = peaks(count);
        let mut errors: Vec<f64> = found
            .iter()
            .zip(&right)
            .map(|(x, right)| (x / right - 1.0).abs())
            .collect();
        errors.sort_by(f64::total_cmp);
        errors
    };
    let [few, enough] = [5.0, 12.0].map(errors);
    // Medians: 3.4 and 14.8 %.
    assert!(enough[20] < 0.05 && few[20] > 0.1);
}

#[test]
fn the_oscillator_needs_six_steps_and_whole_durations() {
    let bench = Bench::new();
    let study = |dt: &str, duration: &str| {
        format!(
            r#"{{"problem": "friction-oscillator", "parameters": {{"law": "displacement-control",
              "alpha": [0.1, 1], "dT": {dt}, "x0": 10, "duration": "{duration}"}}}}"#
        )
    };
    let kinds = long(&bench, &study("[0.5, 1, 1.25]", "10"));
    assert_eq!(kinds, some(&[("long-step", 2, 2)]));
    let kinds = long(&bench, &study("[0.5, 0.3, \"pi/20\"]", "2*pi"));
    assert_eq!(kinds, some(&[("ends-early", 4, 0)]));
    let bars = |duration: &str| {
        format!(
            r#"{{"problem": "bar-impact", "parameters": {{"gamma": [1, 2], "n": 4, "dt": 0.03, "duration": {duration}}}}}"#
        )
    };
    assert_eq!(long(&bench, &bars("2")), some(&[("ends-early", 2, 0)]));
    assert_eq!(long(&bench, &bars("2.1")), []);
    let of_structure = storeys("[0.01, 0.03]", SHAKEN, "peak(b)");
    assert_eq!(long(&bench, &of_structure), some(&[("ends-early", 1, 1)]));
    let told = bench.text("figures/s/manifest.json");
    assert!(told.contains("the last step is at 9.99"), "{told}");
}

#[test]
fn what_is_before_the_start_is_named() {
    let bench = Bench::new();
    let found = some(&[("time-before", 1, 0)]);
    let table = r#"{"table": {"t": [T, 0, 1, 2], "f": [0, 0, 1, 0]}}"#;
    for template in [
        format!(r#", "ground": {table}"#),
        format!(
            r#", "loads": [{{"at": "a", {}}}]"#,
            &table[1..table.len() - 1]
        ),
        r#", "supports": {"s": {"displacement": {"t": [T, 0, 1, 2], "u": [0, 0, 0.01, 0]}}}"#
            .to_owned(),
    ] {
        let study = |t: &str| {
            let body = storeys("0.01", &template.replace('T', t), "peak(b)");
            match template.contains("supports") {
                true => body.replace(r#"["ground", "a"]"#, r#"["s", "a"]"#),
                false => body,
            }
        };
        assert_eq!(long(&bench, &study("-1")), found, "{template}");
        assert_eq!(
            long(&bench, &study("-1e-9").replace("-1e-9, 0,", "-0.0, 0.5,")),
            [],
            "{template}"
        );
    }
}
