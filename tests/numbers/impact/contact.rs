//! Metrics of contact: its duration, the exact values, and bars that never touch.

use crate::common;
use common::case;
use serde_json::{Value as Json, json};
use slipgap::problem::{Problem, cases_without_contact, find};
use slipgap::solve::{MetricTable, Unsolvable};
use slipgap::study::parse;
use std::sync::Arc;

fn problem() -> Arc<dyn Problem> {
    find("bar-impact").unwrap()
}

/// Metrics by name, including the optional exact ones.
fn metrics(given: &Json) -> impl Fn(&str) -> Option<f64> + use<> {
    let row = |name: &str| {
        let row = problem().metrics().iter().position(|m| m.name == name);
        row.unwrap_or_else(|| panic!("{name}"))
    };
    let wanted = [
        "contact_duration_exact",
        "peak_force_exact",
        "restitution_exact",
    ]
    .map(row);
    let found = problem().solve(&case(&*problem(), given), &wanted).unwrap();
    move |name| found.metrics[row(name)]
}

#[test]
fn contact_lasts_for_less_than_its_whole_steps() {
    // With steps of T_I/2 an exact contact of 1 T_I has 1.5 or 1 T_I in whole steps; r linear between steps gives 0.92, 0.78, 0.74.
    // Two digits, computed in tests/reference.
    for (gap, lasts, steps) in [
        (0.1, 1.22, 2.0),
        (0.15, 1.17, 2.0),
        (0.2, 1.06, 1.5),
        (0.253, 0.92, 1.5),
        (0.507, 0.78, 1.5),
        (0.741, 0.74, 1.5),
    ] {
        let metric =
            metrics(&json!({"k_I": 100.0, "n": 10, "dt": 0.5, "duration": 4.0, "gap": gap}));
        let found = metric("contact_duration").unwrap();
        assert!((found - lasts).abs() < 0.005, "gap {gap}: {found}");
        assert_eq!(metric("contact_steps"), Some(steps));
    }
}

#[test]
fn mirrored_bars_have_one_contact() {
    // The same two bars, named left and right in turn: times in the other one's T_I, theta times as long. Lengths that
    // are no binary fractions, so that round-off differs.
    for (theta, gamma, area, gap) in [
        (2.0, 6.0, 1.0, 0.0),
        (2.0, 6.0, 1.0, 0.137),
        (3.0, 1.0, 0.4, 0.0),
        (3.0, 4.0, 2.5, 0.2013),
        (5.0, 8.0, 1.0, 0.31),
    ] {
        let n = 10 * theta as u32;
        let common = |dt: f64| json!({"dt": dt, "duration": 2.4 * theta * dt / 0.004});
        let mut one = common(0.004);
        one.as_object_mut().unwrap().extend([
            ("gamma".into(), json!(gamma)),
            ("n".into(), json!(10)),
            ("gap".into(), json!(gap)),
            (
                "right".into(),
                json!({"L": 10.0 * theta, "n": n, "A": area}),
            ),
        ]);
        // gamma is over the stiffness of the other bar's elements, gap over the other c T_I/2.
        let mut other = common(0.004 / theta);
        other.as_object_mut().unwrap().extend([
            ("gamma".into(), json!(gamma / area)),
            ("n".into(), json!(n)),
            ("gap".into(), json!(gap / theta)),
            ("L".into(), json!(10.0 * theta)),
            ("A".into(), json!(area)),
            ("right".into(), json!({"L": 10.0, "n": 10, "A": 1.0})),
        ]);
        let (a, b) = (metrics(&one), metrics(&other));
        for (name, scale) in [
            ("separations", 1.0),
            ("rdot_oscillation", 1.0),
            ("contact_duration", theta),
            ("contact_steps", theta),
            ("contact_duration_exact", theta),
            ("peak_force_exact", 1.0),
            ("restitution_exact", 1.0),
            ("restitution", 1.0),
        ] {
            let (a, b) = (a(name).unwrap(), scale * b(name).unwrap());
            // Round-off, grown by some separations on springs of gamma up to 8.
            assert!((a - b).abs() < 1e-9, "{one}: {name} {a}, mirrored {b}");
        }
        // The window is within the exact contact, where the exact rdot is 0.
        assert!(a("contact_duration_exact").unwrap() > 0.999);
    }
}

#[test]
fn exact_columns_agree_with_waves_by_hand() {
    let exact = |given: Json| {
        let mut given = given;
        let fields = given.as_object_mut().unwrap();
        fields.extend([("gamma".into(), json!(1.0)), ("dt".into(), json!(0.05))]);
        fields.entry("n").or_insert(json!(2));
        let metric = metrics(&given);
        [
            "contact_duration_exact",
            "peak_force_exact",
            "restitution_exact",
        ]
        .map(metric)
    };
    let near = |found: [Option<f64>; 3], wanted: [f64; 3], what: &str| {
        for (found, wanted) in found.iter().zip(wanted) {
            let found = found.unwrap_or(f64::NAN);
            // Sums of a few travel times and impulses.
            assert!(
                (found - wanted).abs() < 1e-12,
                "{what}: {found}, not {wanted}"
            );
        }
    };
    // Equal bars with any gap exchange their velocities in T_I; a bar at a wall reverses its velocity.
    for gap in [0.0, 0.37] {
        near(
            exact(json!({"duration": 1.5, "gap": gap})),
            [1.0; 3],
            "like bars",
        );
        near(
            exact(json!({"duration": 1.5, "gap": gap, "right": "wall"})),
            [1.0; 3],
            "wall",
        );
    }
    // Equal lengths: the force F0 ends after T_I, when both fronts are back, whatever the areas; both bars move as
    // wholes then, and no energy is left in waves.
    near(
        exact(json!({"duration": 1.5, "A": 2.0})),
        [1.0; 3],
        "areas 2 : 1",
    );
    // Equal impedances, lengths 1 : theta: the pulse of the short bar moves into the long one, F0 for the short bar's
    // T_I. The short bar gets the long one's velocity, whose centre gets 1/theta of the difference: e = 1/theta. Ends
    // stay together, without force, until the pulse is back in the long bar.
    for theta in [1.5, 2.0, 3.0] {
        let long = json!({"duration": 4.0, "right": {"L": 10.0 * theta}});
        near(
            exact(long),
            [theta, 1.0, 1.0 / theta],
            "the left bar is the shorter",
        );
        let short = json!({"duration": 4.0, "L": 10.0 * theta, "right": {"L": 10.0}});
        near(
            exact(short),
            [1.0, 1.0, 1.0 / theta],
            "the left bar is the longer",
        );
    }
    // Z1 = 3 Z2, lengths 1 : m. Each round trip in the left bar leaves q = (Z1 - Z2)/(Z1 + Z2) = 1/2 of the force, until
    // the right bar's front is back after m. With J = 1 + q + ... the left centre gets -2 J/4 c, the right one
    // 2 J (3/4)/m c: e = -1 + 2 J (1/4 + 3/(4 m)).
    for (m, impulse) in [(2.0, 1.5), (3.0, 1.75), (4.0, 1.875)] {
        let given = json!({"duration": 6.0, "A": 3.0, "right": {"A": 1.0, "L": 10.0 * m}});
        let restitution = 2.0 * impulse * (0.25 + 0.75 / m) - 1.0;
        near(
            exact(given),
            [m, 1.0, restitution],
            "a heavy bar on a long light one",
        );
    }
    // Z2 = 3 Z1: after one round trip the left bar would pull, so it separates at T_I with J = 1.
    let given = json!({"duration": 6.0, "A": 1.0, "right": {"A": 3.0, "L": 40.0}});
    near(
        exact(given),
        [1.0, 1.0, 2.0 * (0.75 + 0.25 / 4.0) - 1.0],
        "a light bar on a heavy one",
    );
    // In contact J is the time since the touch; the duration is not yet known.
    let [lasts, peak, restitution] = exact(json!({"duration": 0.75, "gap": 0.5}));
    assert_eq!((lasts, peak), (None, Some(1.0)));
    assert!(
        (restitution.unwrap() - 0.0).abs() < 1e-14,
        "{restitution:?}"
    );
    // Before and at the touch none of them is defined.
    for duration in [0.2, 0.25] {
        assert_eq!(exact(json!({"duration": duration, "gap": 0.5})), [None; 3]);
    }
}

#[test]
fn cases_without_contact_are_counted_in_any_sweep() {
    // gap/2 < duration touches: 0.5 does at 0.25, 1 exactly at the end, 3 never.
    let study = |gaps: &str| {
        let text = format!(
            r#"{{"problem": "bar-impact", "parameters": {{"gamma": 1, "n": 1, "dt": 0.1, "duration": 0.5, "gap": {gaps}}}}}"#
        );
        parse("s.json", &text).unwrap()
    };
    for (gaps, wanted) in [
        ("[0.5]", 0),
        ("[1]", 1),
        ("[0.5, 3, 0.9, 1, 7, 0]", 3),
        (r#"{"linspace": [0, 4, 4001]}"#, 3001),
    ] {
        let study = study(gaps);
        let (_, cases) = study.columns(0, study.raw_len());
        let rows: Vec<u32> = (0..cases.len() as u32).collect();
        let found = study.problem.sweep(&cases, &rows);
        assert_eq!(
            cases_without_contact(&*study.problem, &found),
            wanted,
            "{gaps}"
        );
    }
    // A case without a solution does not count as one without contact, and friction has no such cases.
    let mut failed = MetricTable::new(2, 12);
    failed.fail(1, Unsolvable::OutOfRange);
    assert_eq!(cases_without_contact(&*problem(), &failed), 1);
    assert_eq!(
        cases_without_contact(&*find("friction-oscillator").unwrap(), &failed),
        0
    );
}

#[test]
fn profiles_of_unequal_lengths_are_at_the_bars() {
    // In lengths of the left bar: it ends at -1, the right one at L_R/L; at t in T_I fronts are at 2 t C0_i/C0.
    for (right, length, speed) in [
        (json!({"L": 20.0, "n": 5}), 2.0, 1.0),
        (json!({"L": 5.0, "n": 5}), 0.5, 1.0),
        (json!({"L": 15.0, "n": 5, "E": 400.0}), 1.5, 2.0),
    ] {
        let t = 0.12;
        let given = json!({"gamma": 1.0, "n": 4, "dt": 0.01, "duration": t, "right": right});
        let snapshot = problem()
            .as_textbook()
            .unwrap()
            .snapshots(&case(&*problem(), &given), &[t])
            .remove(0);
        let places = |line: &[[f64; 2]]| -> Vec<f64> { line.iter().map(|p| p[0]).collect() };
        let even = |n: u32, from: f64, to: f64| -> Vec<f64> {
            let share = |i: u32| from + (to - from) * f64::from(i) / f64::from(n);
            (0..=n).map(share).collect()
        };
        let near = |found: Vec<f64>, wanted: Vec<f64>| {
            assert_eq!(found.len(), wanted.len());
            let off = found.iter().zip(&wanted).map(|(a, b)| (a - b).abs());
            assert!(off.fold(0.0, f64::max) < 1e-14, "{found:?}, not {wanted:?}");
        };
        // Nodes for velocity, the middles of elements for stress, from the contact on.
        let [velocity, stress] = &snapshot.profiles[..] else {
            panic!("two profiles");
        };
        near(places(&velocity.computed[0]), even(4, 0.0, -1.0));
        near(places(&velocity.computed[1]), even(5, 0.0, length));
        near(places(&stress.computed[0]), even(3, -0.125, -0.875));
        near(
            places(&stress.computed[1]),
            even(4, 0.1 * length, 0.9 * length),
        );
        // The exact lines end at the ends of the bars and jump only at the front.
        let jumps = |line: &[[f64; 2]]| -> Vec<f64> {
            let ends = [line[0][0], line[line.len() - 1][0]];
            let jumps = line
                .windows(2)
                .filter(|pair| (pair[0][1] - pair[1][1]).abs() > 1e-9);
            jumps.map(|pair| pair[0][0]).chain(ends).collect()
        };
        for profile in [velocity, stress] {
            let front = 2.0 * t;
            near(jumps(&profile.exact[0]), vec![-front, 0.0, -1.0]);
            near(jumps(&profile.exact[1]), vec![front * speed, 0.0, length]);
        }
    }
}
