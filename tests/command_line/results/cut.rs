//! Motions of which a case computes a part only: their measures, and the warning.

use crate::Bench;
use crate::warnings::body;
use std::f64::consts::PI;

/// Whether study `s` has the warning, and what it is of.
fn cut(bench: &Bench, study: &str) -> Option<String> {
    bench.file("s.json", study);
    let done = bench.expect(0, &["run", "s.json"]);
    let line = done.err.lines().find(|line| line.contains("motion-cut"))?;
    let detail = line.rsplit_once("; ")?.1.trim_end_matches(')');
    // `explain` says the same.
    let explained = bench.expect(0, &["explain", "s.json"]);
    assert!(explained.out.contains(detail), "{explained:?}");
    Some(detail.to_owned())
}

/// A record of 10 s: 1 from the second `from` to the second `to`, else 0.01.
fn record(bench: &Bench, from: u32, to: u32) {
    let value = |i: u32| {
        if (100 * from..=100 * to).contains(&i) {
            1.0
        } else {
            0.01
        }
    };
    let rows = (0..=1000).map(|i| format!("{},{}\n", f64::from(i) / 100.0, value(i)));
    bench.file("quake.csv", format!("t,a\n{}", rows.collect::<String>()));
}

const SPRING: &str =
    r#""law": "displacement-control", "limit": 9, "between": ["ground", "a"], "k": 1"#;

#[test]
fn a_motion_that_is_cut_acts_no_longer() {
    let bench = Bench::new();
    // 1 from 0 to 10 s, of which 0.3 s are computed. An oscillator of 1 s without damping then swings by 2 sin(0.3 pi)/omega^2; a motion
    // that goes on would give 2/omega^2.
    record(&bench, 0, 10);
    let ground = r#", "ground": {"record": "quake.csv", "unit": "m/s2"}"#;
    let study = body(
        r#""dt": 0.01, "duration": 0.3"#,
        SPRING,
        ground,
        r#""ground.Sa(1, 0)""#,
    );
    assert!(cut(&bench, &study).is_some());
    let table = bench.text("figures/s/results.csv");
    let last = table
        .lines()
        .last()
        .and_then(|line| line.rsplit(',').next());
    let value: f64 = last.unwrap().parse().unwrap();
    // Round-off of 30 steps.
    assert!((value - 2.0 * (0.3 * PI).sin()).abs() < 1e-12, "{value}");
}

#[test]
fn what_moves_supports_and_presses_contacts_is_looked_at() {
    let bench = Bench::new();
    record(&bench, 6, 7);
    let record = r#"{"record": "quake.csv", "unit": "m/s2"}"#;
    let parameters = |duration: f64| format!(r#""dt": 0.01, "duration": {duration}"#);
    // A support that moves later: after 8 s, its motion of 6 to 7 s has not come.
    let support = |duration: f64, delay: f64| {
        let more = format!(
            r#", "supports": {{"s": {{"record": "quake.csv", "unit": "m/s2", "delay": {delay}, "baseline": "none"}}}}"#
        );
        body(&parameters(duration), SPRING, &more, "\"peak(a)\"")
            .replace(r#"["ground", "a"]"#, r#"["s", "a"]"#)
    };
    assert_eq!(cut(&bench, &support(8.0, 0.0)), None);
    let found = cut(&bench, &support(8.0, 3.0)).unwrap();
    assert!(found.starts_with("support s.x: pga 0.01 of 1"), "{found}");
    // The vertical motion under a bearing.
    let bearing = |duration: f64| {
        let contact = format!(
            r#""law": "displacement-control", "between": ["ground", "a"], "k": 1, "nu": 0.1, "N": {{"weight": 10, "vertical": {record}}}"#
        );
        body(&parameters(duration), &contact, "", "\"peak(a)\"")
    };
    assert_eq!(cut(&bench, &bearing(8.0)), None);
    let found = cut(&bench, &bearing(5.0)).unwrap();
    assert!(
        found.starts_with("N of contact c: pga 0.01 of 1"),
        "{found}"
    );
    // A measured displacement.
    bench.file("moved.csv", "t,u\n0,0\n4,0.1\n6,0.5\n7,0\n");
    let displaced = |duration: f64| {
        let more = r#", "supports": {"s": {"displacement": {"file": "moved.csv", "time": "t", "column": "u"}}}"#;
        body(&parameters(duration), SPRING, more, "\"peak(a)\"")
            .replace(r#"["ground", "a"]"#, r#"["s", "a"]"#)
    };
    assert_eq!(cut(&bench, &displaced(7.0)), None);
    let found = cut(&bench, &displaced(5.0)).unwrap();
    // A smooth curve through the points.
    assert!(
        found.starts_with("support s.x: largest displacement 0.3"),
        "{found}"
    );
    assert!(found.ends_with(" of 0.5"), "{found}");
}

#[test]
fn a_motion_that_loses_its_target_spectrum_is_cut() {
    let bench = Bench::new();
    // A shock with the largest acceleration, and then a slow wave that oscillators of some seconds feel: 9 % of the Arias intensity would
    // be too much to lose, 3 % are not.
    let value = |t: f64| {
        if t < 2.0 {
            (40.0 * t).sin()
        } else {
            0.1 * (PI * (t - 2.0) / 2.0).sin()
        }
    };
    let rows: String = (0..=1200)
        .map(|i| f64::from(i) / 100.0)
        .map(|t| format!("{t},{}\n", if t < 10.0 { value(t) } else { 0.0 }))
        .collect();
    bench.file("quake.csv", format!("t,a\n{rows}"));
    let study = |goal: &str, duration: f64| {
        let ground =
            format!(r#", "ground": {{"record": "quake.csv", "unit": "m/s2", "scale_to": {goal}}}"#);
        let parameters = format!(r#""dt": 0.01, "duration": {duration}"#);
        body(&parameters, SPRING, &ground, "\"peak(a)\"")
    };
    let spectrum = r#"{"spectrum": {"T": [0.1, 10], "Sa": [1, 1]}, "from": 3.9, "to": 4.1}"#;
    for (goal, is_cut) in [
        (r#"{"pga": 1}"#, false),
        (r#"{"Sa": 1, "T": 4}"#, true),
        (spectrum, true),
    ] {
        let found = cut(&bench, &study(goal, 4.0));
        assert_eq!(found.is_some(), is_cut, "{goal} {found:?}");
        assert!(
            found.is_none_or(|found| found.starts_with("ground in x: Sa ")),
            "{goal}"
        );
        assert_eq!(cut(&bench, &study(goal, 12.0)), None, "{goal}");
    }
}
