//! The impact of two bars: printed numbers, and comparisons with exact solutions.

use crate::common;
use common::case;
use serde_json::{Value as Json, json};
use slipgap::exact::wave::Bars;
use slipgap::problem::{Case, Problem, Solution, find};
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

fn metric(solution: &Solution, name: &str) -> f64 {
    let column = problem().metrics().iter().position(|m| m.name == name);
    solution.metrics[column.unwrap()].unwrap()
}

#[test]
fn third_figure_has_its_numbers() {
    // Numbers of [I] Fig. 3, to half a unit of the last digit.
    for (k_i, contact, overlap, peak, digit) in [
        (10.0, 1.421, 0.4862, 0.972, 0.001),
        (100.0, 1.057, 0.0723, 1.445, 0.001),
        (1e3, 1.018, 0.0220, 4.40, 0.01),
        (1e4, 1.012, 0.0068, 13.52, 0.01),
    ] {
        let solution = solve(&json!({"k_I": k_i, "n": 10, "dt": 0.001, "duration": 1.5}));
        for (name, printed, digit) in [
            ("contact_steps", contact, 0.001),
            ("max_overlap", overlap, 0.0001),
            ("peak_force", peak, digit),
        ] {
            let found = metric(&solution, name);
            assert!(
                (found - printed).abs() <= 0.5 * digit * 1.000001,
                "k_I = {k_i}: {name} {found}"
            );
        }
    }
}

#[test]
fn contact_of_continuous_bars_lasts_longer_by_the_time_constant_of_the_spring() {
    // At fixed k_I, n -> infinity: contact T_I + 1.67835 tau, tau = T_I/(4 gamma n) (reference, section 5). A mesh
    // disperses the returning front, so the ends separate later; from n = 160 on sometimes a little earlier, in its ripple.
    let dt = 0.0001;
    let excess = |n: u32| {
        let solution = solve(&json!({"k_I": 100.0, "n": n, "dt": dt, "duration": 1.2}));
        metric(&solution, "contact_duration") - (1.0 + 1.67835 / 40.0)
    };
    let [coarse, middle, fine] = [10, 80, 640].map(excess);
    assert!(
        0.02 > coarse && coarse > 4.0 * middle && middle > 0.0,
        "{coarse} {middle}"
    );
    assert!(fine.abs() < 2.0 * dt, "{fine}");
}

#[test]
fn force_of_fine_meshes_converges_to_the_closed_form() {
    // The two lines of the reference, section 5, with gamma n = 10. Meshes converge to them.
    let tau: f64 = 1.0 / 40.0;
    let exact = |t: f64| {
        let s = (t - 1.0) / tau;
        let force = if t <= 1.0 {
            1.0 - libm::exp(-t / tau)
        } else {
            -1.0 + (2.0 * s + 2.0 - libm::exp(-1.0 / tau)) * libm::exp(-s)
        };
        force.max(0.0)
    };
    let distance = |n: u32| {
        let c = solve(&json!({"k_I": 100.0, "n": n, "dt": 0.0005, "duration": 1.2})).computed;
        let squares = c
            .time
            .iter()
            .zip(c.force())
            .map(|(&t, f)| (f - exact(t)) * (f - exact(t)));
        (squares.sum::<f64>() / c.len() as f64).sqrt()
    };
    let distances = [10, 40, 160, 640].map(distance);
    // The last difference, measured 0.0013, is due to the finite width of a front.
    assert!(
        distances.windows(2).all(|pair| pair[1] < pair[0] / 4.0),
        "{distances:?}"
    );
    assert!(distances[3] < 0.003, "{distances:?}");
}

/// Velocities of both mass centres at the end over c, positive to the right, in the frame of the mean of the two V0.
fn centres(given: &Json) -> [f64; 2] {
    let case = bars(given);
    let end = case.number("duration").unwrap();
    let snapshot = problem()
        .as_textbook()
        .unwrap()
        .snapshots(&case, &[end])
        .remove(0);
    // Nodes at the ends have half of the mass of an element; velocities are in c/2.
    let centre = |line: &Vec<[f64; 2]>| {
        let [first, inner @ .., last] = &line[..] else {
            panic!("no bar");
        };
        let sum = 0.5 * (first[1] + last[1]) + inner.iter().map(|node| node[1]).sum::<f64>();
        0.5 * sum / (line.len() - 1) as f64
    };
    [0, 1].map(|bar| centre(&snapshot.profiles[0].computed[bar]))
}

#[test]
fn impedances_two_to_one_exchange_two_thirds_and_four_thirds() {
    // Exactly: F0 = 2/3 of Z1 V0 acts for T_I, which reduces the velocity of the left bar by 2/3 V0 and adds 4/3 V0 to the right one.
    let exact = Bars {
        impedance_ratio: 2.0,
        time_ratio: 1.0,
        gap: 0.0,
    }
    .solve(2.0);
    assert!((exact.impulse(2.0) - 1.0).abs() < 1e-15);
    let off_by = |n: u32| {
        let given = json!({
            "k_I": 100.0 * f64::from(n) / 10.0, "n": n, "dt": 0.0005, "duration": 1.5,
            "A": 2.0, "right": {"A": 1.0, "V0": 0.0},
        });
        let [left, right] = centres(&given).map(|v| v + 0.5);
        (left - 1.0 / 3.0).abs().max((right - 4.0 / 3.0).abs())
    };
    // The difference is vibration of the meshes; with four times the elements it is half as large.
    let off = [10, 40, 160].map(off_by);
    assert!(
        off[0] < 0.03 && off[1] < off[0] / 1.7 && off[2] < off[1] / 1.7,
        "{off:?}"
    );
}

#[test]
fn unequal_lengths_end_force_and_touch_at_different_times() {
    let exact = Bars {
        impedance_ratio: 1.0,
        time_ratio: 2.0,
        gap: 0.0,
    }
    .solve(3.0);
    assert_eq!(exact.durations(), [Some(1.0), Some(2.0)]);
    let c = solve(&json!({
        "gamma": 0.25, "n": 100, "dt": 0.001, "duration": 2.5, "right": {"L": 20.0, "n": 200},
    }))
    .computed;
    let mean = |values: &[f64], from: f64, to: f64| {
        let (a, b) = ((from * 1000.0) as usize, (to * 1000.0) as usize);
        values[a..b].iter().sum::<f64>() / (b - a) as f64
    };
    let force = mean(c.force(), 0.1, 0.9);
    let still = mean(c.force(), 1.2, 1.9);
    let apart = mean(c.velocity(), 2.2, 2.5);
    let furthest = c.displacement()[1200..1900]
        .iter()
        .fold(0.0, |a: f64, r| a.max(r.abs()));
    // Between T_I and 2 T_I both ends move with -c/2; then the left bar's end stays at that and the right one's, which the
    // front has reached, turns to +c/2: rdot = c. Means over windows of 100 to 800 steps, what is left is ringing.
    assert!((force - 1.0).abs() < 0.001, "{force}");
    assert!(still.abs() < 0.001, "{still}");
    // The spring adds a small part of its overlap F0/k_I, 1/(2 gamma n) = 0.02.
    assert!(furthest < 0.005, "{furthest}");
    assert!((apart - 1.0).abs() < 0.003, "{apart}");
}

#[test]
fn finer_meshes_approach_dalembert_away_from_fronts() {
    // gamma = 1 and dt/h fixed, so the spring stiffens with the mesh. r lags by the spring's overlap 1/(2 gamma n) and by
    // the spread of the returning front, n^(-2/3). Velocity and stress behind a front ring like the integral of an Airy
    // function, the tail of which falls as (distance/(h (L/h)^(1/3)))^(-3/4): as n^(-1/2) at a fixed place. So four times
    // the elements reduce the error of r by a factor of at least 2.5 and those of the profiles by about 2.
    let compare = |n: u32| {
        let given = json!({"gamma": 1.0, "n": n, "dt": 0.05 / f64::from(n), "duration": 1.5});
        let case = bars(&given);
        let solution = problem().solve(&case, &[]).unwrap();
        let (c, e) = (&solution.computed, &solution.exact);
        let r = (0..c.len())
            .filter(|&i| (c.time[i] - 1.0).abs() > 0.2)
            .map(|i| (c.displacement()[i] - e.displacement()[i]).abs())
            .fold(0.0, f64::max);
        // At 0.375 T_I the front is at three quarters of the length of each bar.
        let wave = Bars {
            impedance_ratio: 1.0,
            time_ratio: 1.0,
            gap: 0.0,
        }
        .solve(0.375);
        let snapshot = problem()
            .as_textbook()
            .unwrap()
            .snapshots(&case, &[0.375])
            .remove(0);
        let mut worst = [0.0_f64; 2];
        for (of, lines) in snapshot.profiles.iter().enumerate() {
            for (bar, points) in lines.computed.iter().enumerate() {
                for [x, value] in points.iter().filter(|p| (0.2..0.5).contains(&p[0].abs())) {
                    let [v, sigma] = wave.inside(bar, x.abs(), 0.375);
                    worst[of] = worst[of].max((value - [2.0 * v, sigma][of]).abs());
                }
            }
        }
        [r, worst[0], worst[1]]
    };
    let ladder = [40, 160, 640].map(compare);
    for pair in ladder.windows(2) {
        for ((coarse, fine), factor) in pair[0].iter().zip(pair[1]).zip([2.5, 1.6, 1.6]) {
            assert!(fine < coarse / factor, "{ladder:?}");
        }
    }
}
