//! The impact of two bars: identities of every step, and parameters without effect on results.

use crate::common;
use common::case;
use serde_json::{Value as Json, json};
use slipgap::history::History;
use slipgap::lane::Lane;
use slipgap::metrics::impact::{Energy, Track};
use slipgap::problem::impact::case::{ImpactCase, system};
use slipgap::problem::impact::scaled::Scaled;
use slipgap::problem::{Case, Problem, Snapshot, Solution, find};
use slipgap::solve;
use slipgap::solve::ToSystem;
use std::sync::Arc;

fn problem() -> Arc<dyn Problem> {
    find("bar-impact").unwrap()
}

fn bars(given: &Json) -> Case {
    case(&*problem(), given)
}

fn solve(given: &Json) -> Solution {
    problem().solve(&bars(given), &[]).unwrap()
}

/// Both mass matrices, equal and different bars, a wall, gaps that close within a step.
fn mixed() -> [Json; 5] {
    [
        json!({"k_I": 1000.0, "n": 10, "dt": 0.001, "duration": 1.5}),
        json!({"gamma": 3.0, "n": 5, "dt": 0.05, "duration": 2.0, "mass": "consistent", "gap": 0.0537}),
        json!({"gamma": 2.0, "n": 10, "dt": 0.005, "duration": 2.5, "gap": 0.3,
               "right": {"L": 14.0, "A": 2.0, "n": 7, "V0": 0.03}}),
        json!({"gamma": 1.0, "n": 20, "dt": 0.01, "duration": 1.5, "right": "wall"}),
        json!({"k_I": 1e5, "n": 10, "dt": 0.5, "duration": 40.0}),
    ]
}

#[test]
fn energy_by_the_work_of_the_contact_is_that_of_all_modes() {
    for given in mixed() {
        let case = ImpactCase::new(&bars(&given)).unwrap();
        let system = case.system();
        let mut sums = Vec::new();
        let mut touching = Vec::new();
        solve::visit(&system, |_, stepper| {
            let contact = stepper.contact();
            let (Lane([r]), Lane([s])) = (contact.displacement, contact.force);
            let modes = (0..).zip(stepper.modes());
            let energy: f64 = modes
                .map(|(j, [x, v])| case.scaled.pair.mode(j).energy(x, v))
                .sum();
            sums.push(energy + 0.5 * s * r);
            touching.push(r < 0.0);
        });
        let track = solve::run::<Track<1>>(&system).unwrap().track;
        let mut worst: f64 = 0.0;
        for (step, sum) in sums.iter().enumerate() {
            let Energy {
                last: Lane([momentum]),
                ..
            } = Energy::of_case(&track, &system, step + 1);
            worst = worst.max((momentum - sum).abs() / sums[0]);
        }
        // Round-off of r in each step, of order 1, times the force; sums over up to 42 modes.
        let steps = sums.len() as f64;
        assert!(
            worst < 2e-16 * (20.0 + steps),
            "{given}: {worst:e} in {steps}"
        );
        let changes = touching
            .windows(2)
            .filter(|pair| pair[0] != pair[1])
            .count();
        assert!(changes >= 2, "{given}: the contact must open and close");
    }
}

#[test]
fn momentum_of_two_bars_is_conserved() {
    for given in mixed().iter().filter(|given| given["right"] != "wall") {
        let case = bars(given);
        let scaled = Scaled::new(&case).unwrap();
        let masses = [scaled.pair.left.mass, scaled.pair.right.unwrap().mass];
        let end = case.number("duration").unwrap();
        let times: Vec<f64> = (0..=40).map(|i| f64::from(i) * end / 40.0).collect();
        let momentum = |snapshot: &Snapshot| -> f64 {
            let lines = &snapshot.profiles[0].computed;
            let mean = |line: &[[f64; 2]]| {
                // Trapezoids: the rows of either mass matrix add to the lumped masses.
                let sum: f64 = line
                    .windows(2)
                    .map(|pair| 0.5 * (pair[0][1] + pair[1][1]))
                    .sum();
                sum / (line.len() - 1) as f64
            };
            masses[0] * mean(&lines[0]) + masses[1] * mean(&lines[1])
        };
        let found: Vec<f64> = problem()
            .as_textbook()
            .unwrap()
            .snapshots(&case, &times)
            .iter()
            .map(momentum)
            .collect();
        let worst = found
            .iter()
            .map(|p| (p - found[0]).abs())
            .fold(0.0, f64::max);
        // Means over 11 nodes of sums over as many modes.
        assert!(
            worst < 1e-14 * (masses[0] + masses[1]),
            "{given}: {worst:e}"
        );
    }
}

#[test]
fn density_and_common_velocity_have_no_effect() {
    // [I] prints rho = 0.1, but its T_I needs 0.01. Scaled results are the same, bit for bit.
    for given in mixed() {
        let mut heavy = given.clone();
        heavy["rho"] = json!(0.1);
        let wall = given["right"] == "wall";
        let (a, b) = (solve(&given), solve(&heavy));
        assert_eq!(a.computed, b.computed, "{given}");
        assert_eq!(a.exact, b.exact, "{given}");
        assert_eq!(a.metrics, b.metrics, "{given}");
        let mut fast = given.clone();
        fast["V0"] = json!(0.1 + 3.7);
        if !wall {
            let right = given["right"]["V0"].as_f64().unwrap_or(-0.1);
            fast["right"] = given.get("right").cloned().unwrap_or(json!({}));
            fast["right"]["V0"] = json!(right + 3.7);
        }
        let c = solve(&fast);
        assert_eq!(a.computed, c.computed, "{given}");
        assert_eq!(a.metrics, c.metrics, "{given}");
    }
}

/// Largest difference of two histories' r, rdot and force, the second from row `from` on and with r times `length`.
fn difference(a: &History, b: &History, from: usize, length: f64) -> f64 {
    let columns = [
        (a.displacement(), b.displacement(), length),
        (a.velocity(), b.velocity(), 1.0),
        (a.force(), b.force(), 1.0),
    ];
    let mut largest: f64 = 0.0;
    for (a, b, scale) in columns {
        for (a, b) in a.iter().zip(&b[from..]) {
            largest = largest.max((a - scale * b).abs());
        }
    }
    largest
}

/// Round-off: sums over up to 29 modes over up to 300 steps, in runs with little amplification (measured: 1e-14).
const ROUND_OFF: f64 = 5e-14;

#[test]
fn left_and_right_can_change_places() {
    // gamma, times and lengths refer to the left bar: after the exchange the same k_I and step have other scaled numbers.
    let short = json!({"k_I": 100.0, "n": 10, "dt": 0.01, "duration": 2.5, "A": 2.0, "gap": 0.1003,
                       "V0": 0.07, "right": {"L": 20.0, "A": 1.0, "n": 17, "V0": -0.05}});
    let long = json!({"k_I": 100.0, "n": 17, "dt": 0.005, "duration": 1.25, "L": 20.0, "gap": 0.05015,
                      "V0": 0.05, "right": {"L": 10.0, "A": 2.0, "n": 10, "V0": -0.07}});
    let (a, b) = (solve(&short), solve(&long));
    // r is over c T_I/2, twice as long there.
    let computed = difference(&a.computed, &b.computed, 0, 2.0);
    assert!(computed < ROUND_OFF, "{computed:e}");
    let exact = difference(&a.exact, &b.exact, 0, 2.0);
    assert!(exact < ROUND_OFF, "{exact:e}");
}

#[test]
fn a_gap_that_closes_at_a_step_shifts_the_history() {
    // Powers of two: 16 steps of 1/128 T_I close a gap of 1/4, and r is 0 there to the last bit.
    let touching = json!({"k_I": 100.0, "n": 10, "dt": 0.0078125, "duration": 1.5});
    let mut apart = touching.clone();
    apart["gap"] = json!(0.25);
    apart["duration"] = json!(1.625);
    let (a, b) = (solve(&touching).computed, solve(&apart).computed);
    assert_eq!(b.displacement()[16], 0.0);
    assert_eq!(a.len() + 16, b.len());
    let shifted = difference(&a, &b, 16, 1.0);
    assert!(shifted < ROUND_OFF, "{shifted:e}");
}

#[test]
fn a_wall_is_a_mirror() {
    // By symmetry the middle of two equal bars is at rest like a wall, with half of the spring on each side.
    for mass in ["lumped", "consistent"] {
        let wall = json!({"k_I": 200.0, "n": 10, "dt": 0.005, "duration": 1.5, "gap": 0.0511, "mass": mass, "right": "wall"});
        let pair = json!({"k_I": 100.0, "n": 10, "dt": 0.005, "duration": 1.5, "gap": 0.0511, "mass": mass});
        let (a, b) = (solve(&wall), solve(&pair));
        let computed = difference(&a.computed, &b.computed, 0, 1.0);
        assert!(computed < ROUND_OFF, "{computed:e}");
        assert_eq!(a.exact, b.exact);
    }
}

#[test]
fn only_stiff_springs_amplify_a_disturbance() {
    // r(0) moved by 1 to 8 times 1e-13: at k_I = 1e5 (gamma = 1000) and dt = 0.001 T_I the restitution, one curve of
    // many, moves in its second digit; up to 1e3 it moves no more than r(0) did, give or take the round-off of 1500 steps.
    let spread = |k_i: f64| {
        let case = bars(&json!({"k_I": k_i, "n": 10, "dt": 0.001, "duration": 1.5}));
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for i in 0..=8 {
            let mut scaled = Scaled::new(&case).unwrap();
            scaled.bars.gap = f64::from(i) * 1e-13;
            let motion = solve::run::<Track<1>>(&system(&scaled, 0.001, 1500)).unwrap();
            let restitution = 0.5 * motion.first_mode.0[0];
            (least, most) = (restitution.min(least), restitution.max(most));
        }
        most - least
    };
    for k_i in [10.0, 100.0, 1e3] {
        assert!(spread(k_i) < 5e-12, "k_I = {k_i}");
    }
    assert!(spread(1e5) > 0.01);
}
