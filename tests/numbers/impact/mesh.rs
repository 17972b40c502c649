//! The mesh in continuous time, compared with all degrees of freedom by another program, with continuous bars for n to
//! infinity, and with a dense grid of times for short touches.

use serde_json::Value as Json;
use slipgap::exact::mesh::Mesh;
use slipgap::exact::spring::Spring;
use slipgap::system::bar::{Bar, Mass};

fn bar(n: u32, kind: Mass) -> Bar {
    Bar {
        elements: n,
        mass: 0.5,
        travel_time: 1.0,
        kind,
    }
}

fn lumped(gamma: f64, n: u32) -> Mesh {
    Mesh::new(&bar(n, Mass::Lumped), 2.0 * gamma * f64::from(n), 0.0).unwrap()
}

#[test]
fn agrees_with_all_degrees_of_freedom() {
    // tests/reference/impact/mesh.py; its eigensolver and root finder have errors of 1e-13, and each event passes them on, at gamma = 10
    // over 27 events.
    let cases: Json = serde_json::from_str(include_str!("../../data/mesh.json")).unwrap();
    let mut events = 0;
    for case in cases.as_array().unwrap() {
        let number = |name: &str| case[name].as_f64().unwrap();
        let (gamma, n, gap) = (number("gamma"), number("n") as u32, number("gap"));
        let kind = match case["mass"].as_str().unwrap() {
            "lumped" => Mass::Lumped,
            "consistent" => Mass::Consistent,
            other => panic!("{other}"),
        };
        let mut mesh = Mesh::new(&bar(n, kind), 2.0 * gamma * f64::from(n), gap).unwrap();
        let times: Vec<f64> = values(&case["events"]);
        let tolerance = 1e-11 * 1.6_f64.powi(times.len() as i32);
        for row in case["rows"].as_array().unwrap() {
            let [t, r, rdot] = values(row)[..] else {
                panic!()
            };
            let state = mesh.at(t).unwrap();
            assert!(
                (state.displacement - r).abs() < tolerance,
                "{gamma} {n} r at {t}: {} {r}",
                state.displacement
            );
            assert!(
                (state.velocity - rdot).abs() < 100.0 * tolerance,
                "{gamma} {n} rdot at {t}: {} {rdot}",
                state.velocity
            );
        }
        mesh.at(0.5 * gap + 1.5).unwrap();
        let events_found = mesh.events();
        assert_eq!(events_found.len(), times.len(), "{gamma} {n}");
        for (a, b) in events_found.iter().zip(&times) {
            assert!((a - b).abs() < tolerance, "{gamma} {n}: {a}, not {b}");
        }
        events += times.len();
    }
    assert!(events > 70);
}

fn values(list: &Json) -> Vec<f64> {
    list.as_array()
        .unwrap()
        .iter()
        .map(|x| x.as_f64().unwrap())
        .collect()
}

#[test]
fn misses_no_touch_however_short() {
    // Near gamma = 2.0346, from which on the first valley of the force separates the ends: there are as many changes of sign on
    // a dense grid. Every touch is longer than three points of the grid.
    for gamma in [
        2.03, 2.034, 2.0345, 2.0347, 2.035, 2.04, 2.1, 2.13, 3.0, 7.0,
    ] {
        let mut mesh = lumped(gamma, 20);
        let (mut before, mut changes) = (true, 0);
        for i in 1..=200_000 {
            let closed = mesh
                .at(1.2 * f64::from(i) / 200_000.0)
                .unwrap()
                .displacement
                < 0.0;
            changes += usize::from(closed != before);
            before = closed;
        }
        assert_eq!(mesh.events().len(), changes, "{gamma}");
    }
}

#[test]
fn the_first_valley_separates_the_ends_from_gamma_2_0346() {
    // By bisection; at the limit the gap lasts for no time. Reference: from 2.035 on, at 3.41 h/C0.
    let separates = |gamma: f64| {
        let mut mesh = lumped(gamma, 20);
        mesh.at(0.5).unwrap();
        mesh.events().first().is_some_and(|t| *t < 0.1)
    };
    let (mut low, mut high) = (2.0, 2.1);
    while high - low > 1e-9 {
        let middle = 0.5 * (low + high);
        if separates(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    assert!((high - 2.0346).abs() < 5e-4, "{high}");
    let mut mesh = lumped(high, 20);
    mesh.at(0.5).unwrap();
    let touch = [mesh.events()[0], mesh.events()[1]];
    // h/C0 = T_I/(2 n); the gap lasts about 1e-5 at 1e-9 above the limit.
    assert!(
        (touch[0] * 40.0 - 3.41).abs() < 0.01 && touch[1] - touch[0] < 1e-4,
        "{touch:?}"
    );
}

#[test]
fn converges_to_continuous_bars() {
    // At fixed k_I the spring smooths the front, so rdot converges with the first order; measured: 0.9 to 1.3, and 1.3 to 1.8
    // for r. Without the spring a front has a width of n^(1/3) elements, so an order below 2/3 would be a fault.
    let gamma_n = 5.0;
    let spring = Spring::new(gamma_n, 0.0).unwrap();
    let errors = |n: u32| {
        let mut mesh = lumped(gamma_n / f64::from(n), n);
        let mut sums = [0.0, 0.0];
        for i in 0..1500 {
            let t = 0.001 * f64::from(i);
            let (a, b) = (mesh.at(t).unwrap(), spring.at(t));
            sums[0] += (a.displacement - b.displacement).powi(2);
            sums[1] += (a.velocity - b.velocity).powi(2);
        }
        sums.map(|s: f64| (s / 1500.0).sqrt())
    };
    let by_mesh: Vec<[f64; 2]> = [10, 20, 40, 80, 160].map(errors).to_vec();
    for pair in by_mesh.windows(2) {
        let order = [0, 1].map(|i| (pair[0][i] / pair[1][i]).log2());
        assert!(order[0] > 1.0 && order[1] > 0.67, "{order:?}");
    }
}

#[test]
fn a_gap_only_delays_the_contact() {
    // r' = -2 in c T_I/2 over T_I. The peak of the force at gamma = 1 is 1.445 (reference, section 6).
    let (gap, mut touching) = (0.3, lumped(1.0, 40));
    let mut mesh = Mesh::new(&bar(40, Mass::Lumped), 80.0, gap).unwrap();
    for (t, r) in [(0.0, 0.3), (0.05, 0.2), (0.15, 0.0)] {
        let state = mesh.at(t).unwrap();
        assert!((state.displacement - r).abs() < 1e-16, "{t}: {state:?}");
        // The rate is a sum over 41 modes once the ends touch.
        assert!(
            (state.velocity + 1.0).abs() < 1e-14 && state.force.abs() < 1e-14,
            "{t}"
        );
    }
    let mut peak = 0.0_f64;
    for i in 0..12_000 {
        let t = 1e-4 * f64::from(i);
        let (late, early) = (mesh.at(0.15 + t).unwrap(), touching.at(t).unwrap());
        // Round-off of 0.15 + t; rdot changes by at most 100 in a T_I.
        assert!((late.displacement - early.displacement).abs() < 1e-14);
        assert!((late.velocity - early.velocity).abs() < 1e-12);
        assert!((early.force - (-80.0 * early.displacement).max(0.0)).abs() < 1e-13);
        peak = peak.max(early.force);
    }
    assert!((peak - 1.445).abs() < 5e-4, "{peak}");
    assert_eq!(mesh.events().len(), touching.events().len());
    for (late, early) in mesh.events().iter().zip(touching.events()) {
        assert!((late - early - 0.15).abs() < 1e-12);
    }
}

#[test]
fn stiff_springs_converge_to_a_rigid_contact() {
    // n = 1: half of the mass of a bar at each end; a rigid contact reverses its velocity at once. So rdot = cos(4 t) and
    // r = sin(4 t)/2 with 4/T_I, until the ends meet again at 4 t = pi and rebound: then rdot = 1. The difference falls with the
    // period of the spring, as gamma^(-1/2), to the error of 1e-13 T_I in the time of an event times the frequency.
    let difference = |gamma: f64| {
        let mut mesh = lumped(gamma, 1);
        let mut worst = 0.0_f64;
        for i in 1..=150 {
            let t = 0.01 * f64::from(i);
            let state = mesh.at(t).unwrap();
            let meet = 0.25 * std::f64::consts::PI;
            let (r, rdot) = if t < meet {
                (0.5 * (4.0 * t).sin(), (4.0 * t).cos())
            } else {
                (2.0 * (t - meet), 1.0)
            };
            let off = (state.displacement - r)
                .abs()
                .max((state.velocity - rdot).abs());
            worst = worst.max(off);
        }
        assert_eq!(mesh.events().len(), 3);
        worst
    };
    for gamma in [1e6, 1e10, 1e14, 1e18, 1e20] {
        let off = difference(gamma);
        assert!(
            off < 4.0 / f64::sqrt(gamma) + 1e-10 * f64::sqrt(gamma / 1e20) + 1e-13,
            "{gamma}: {off:e}"
        );
    }
}

#[test]
fn springs_that_are_too_stiff_are_refused() {
    let new =
        |gamma: f64, n: u32| Mesh::new(&bar(n, Mass::Lumped), 2.0 * gamma * f64::from(n), 0.0);
    assert!(new(0.9e20, 1).is_some() && new(1.1e20, 1).is_none());
    assert!(new(0.9e18, 10).is_some() && new(1.1e18, 10).is_none());
    for gamma in [1e26, 1e200, 1e300] {
        assert!(new(gamma, 1).is_none() && new(gamma, 10).is_none());
    }
    // At the limit of the range the bars separate before 1.4 T_I, after a limited number of events.
    for (gamma, n) in [(1e18, 10), (2.7e16, 60)] {
        let mut mesh = lumped(gamma, n);
        let late = [1.4, 1.5].map(|t| mesh.at(t).unwrap().displacement);
        assert!(late[0] > 0.0 && late[1] > 0.0, "{gamma}: {late:?}");
        let events = mesh.events();
        // About three for each element, because each node of the front rebounds.
        assert!(events.len() < 4 * n as usize, "{gamma}: {}", events.len());
        let mut same = lumped(0.25 * gamma, n);
        for i in 1..=30 {
            let t = 0.05 * f64::from(i);
            let mut again = lumped(gamma, n);
            let [a, b] = [again.at(t).unwrap(), same.at(t).unwrap()];
            assert!(
                (a.displacement - b.displacement).abs() < 1e-5,
                "{gamma} {t}: {a:?} {b:?}"
            );
        }
    }
}

#[test]
fn separated_bars_fly_for_any_time() {
    // At a distance larger than all vibrations the search ends, and r/(2 t) is the velocity of the mass centres over c within
    // 1/t. Without this limit the search would not end.
    for gamma in [0.25, 3.0, 1e4] {
        let (mut mesh, spring) = (lumped(gamma, 4), Spring::new(4.0 * gamma, 0.0).unwrap());
        for of in [
            [1e6, 1e9, 1e300].map(|t| mesh.at(t).unwrap().displacement / (2.0 * t)),
            [1e6, 1e9, 1e300].map(|t| spring.at(t).displacement / (2.0 * t)),
        ] {
            assert!(of[0] > 0.1 && of[0] <= 1.0, "{gamma}: {of:?}");
            assert!((of[1] - of[0]).abs() < 1e-5, "{gamma}: {of:?}");
            assert!((of[2] - of[1]).abs() < 1e-8, "{gamma}: {of:?}");
        }
    }
}
