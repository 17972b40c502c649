//! Impacts of one mass.

use super::*;
use crate::contact::ClippedLine;
use libm::acos;
use std::f64::consts::{PI, SQRT_2};

fn stop(restitution: f64) -> StructureLaw {
    StructureLaw::new(ClippedLine::Stop { restitution }, None)
}

/// Times of impacts, and |rdot| before them.
fn impacts(summary: &Summary) -> Vec<[f64; 2]> {
    let impacts = summary.events.iter().filter_map(|event| match event.kind {
        EventKind::Impact { rate } => Some([event.time, -rate]),
        EventKind::Phase(_) => None,
    });
    impacts.collect()
}

/// u'' + u = 0 from -1, with a stop at 0.3.
fn oscillator(law: StructureLaw) -> Structure {
    one()
        .spring([None, Some(0)], 1.0)
        .moving(&[-1.0], &[0.0])
        .contact([Some(0), None], 0.3, law)
}

#[test]
fn an_elastic_stop_is_hit_at_odd_multiples_of_one_time() {
    let (_, summary) = first(&oscillator(stop(1.0)), &[60.0]);
    let impacts = impacts(&summary);
    assert_eq!(impacts.len(), 16);
    for (k, [time, rate]) in impacts.into_iter().enumerate() {
        // Round-off of 60.
        assert!((time - (2 * k + 1) as f64 * acos(-0.3)).abs() < 1e-13);
        assert!((rate - f64::sqrt(0.91)).abs() < 1e-14);
    }
}

#[test]
fn stiff_springs_approach_the_elastic_stop_with_order_half() {
    let times = steps(1e-3, 9000);
    let (rigid, _) = first(&oscillator(stop(1.0)), &times);
    for (k, printed, decimals) in [
        (1e2, 0.283, 5e-4),
        (1e3, 0.0978, 5e-5),
        (1e4, 0.0317, 5e-5),
        (1e5, 0.0101, 5e-5),
        (1e6, 0.0032, 5e-5),
    ] {
        let law = StructureLaw::new(ClippedLine::Spring { stiffness: k }, None);
        let (spring, _) = first(&oscillator(law), &times);
        let squares = rigid
            .iter()
            .zip(&spring)
            .map(|(a, b)| (a.u - b.u) * (a.u - b.u));
        let rms = f64::sqrt(squares.sum::<f64>() / times.len() as f64);
        // Last decimal, and the sampling.
        assert!((rms - printed).abs() < 2.0 * decimals, "{k}: {rms}");
        // Energy: k x^2 + (0.3 + x)^2 = 1 at the largest x = -r; 0.9539 sqrt k for stiff springs.
        let largest = (-0.3 + f64::sqrt(0.09 + 0.91 * (k + 1.0))) / (k + 1.0);
        let time = spring.iter().position(|state| state.force < 0.0).unwrap();
        let half = steps(1e-5, 40_000);
        let near: Vec<f64> = half.iter().map(|t| times[time - 1] + t).collect();
        let (near, _) = first(
            &oscillator(StructureLaw::new(
                ClippedLine::Spring { stiffness: k },
                None,
            )),
            &near,
        );
        let peak = near.iter().map(|state| -state.force).fold(0.0, f64::max);
        // Sampling: omega^2 dt^2/8.
        assert!((peak / (k * largest) - 1.0).abs() < 2e-5, "{k}: {peak}");
        assert!((peak / k.sqrt() - 0.9539).abs() < 0.4 / k.sqrt());
    }
}

#[test]
fn an_oscillator_hits_its_stop_once_a_period_as_shaw_and_holmes_computed() {
    let (omega, v, phase) = (2.6, 0.5054399709, 3.0293829358);
    let from = |u: f64, rate: f64, phase: f64| {
        one()
            .spring([None, Some(0)], 1.0)
            .load(&[(0, 1.0)], sine(1.0, omega, 0.5 * PI + phase))
            .moving(&[u], &[rate])
            .contact([Some(0), None], 0.0, stop(0.8))
    };
    let period = 2.0 * PI / omega;
    let (_, summary) = first(&from(0.0, -0.8 * v, phase), &[20.5 * period]);
    let on_the_orbit = impacts(&summary);
    assert_eq!(on_the_orbit.len(), 20);
    for (k, [time, rate]) in on_the_orbit.into_iter().enumerate() {
        // 10 decimals.
        assert!((time - (k + 1) as f64 * period).abs() < 2e-10);
        assert!((rate - v).abs() < 1e-10);
    }
    // The orbit attracts.
    let (_, summary) = first(&from(-0.5, 0.0, 0.0), &[400.0 * period]);
    for [time, rate] in impacts(&summary).into_iter().rev().take(20) {
        assert!((time * omega % (2.0 * PI) - phase).abs() < 1e-9);
        assert!((rate - v).abs() < 1e-10);
    }
}

#[test]
fn a_bouncing_ball_comes_to_rest() {
    for e in [0.0, 0.3, 0.5, 0.8, 0.9] {
        let ball = one()
            .load(&[(0, -1.0)], table(&[[0.0, 1.0]]))
            .moving(&[1.0], &[0.0])
            .contact([None, Some(0)], 0.0, stop(e));
        let (states, summary) = first(&ball, &[1000.0]);
        let shut = summary.events.last().unwrap();
        assert_eq!(shut.kind, EventKind::Phase(Phase::Closed));
        // Impacts below 1e-9 of the largest velocity are left out, and their times.
        let rest = SQRT_2 * (1.0 + e) / (1.0 - e);
        assert!((shut.time - rest).abs() < 2.0 * SQRT_2 * 1e-9 / (1.0 - e));
        assert_eq!(
            (states[0].r, states[0].rate, states[0].force),
            (0.0, 0.0, -1.0)
        );
        for (k, [time, rate]) in impacts(&summary).into_iter().enumerate() {
            let power = libm::pow(e, k as f64);
            assert!((rate - SQRT_2 * power).abs() < 1e-14);
            let sum = if k == 0 {
                1.0
            } else {
                1.0 + 2.0 * (e - power * e) / (1.0 - e)
            };
            assert!((time - SQRT_2 * sum).abs() < 1e-13, "{e} {k}");
        }
    }
}

#[test]
fn a_shut_stop_opens_when_its_force_ends() {
    // Pushed by -cos t; the mass leaves at pi/2 with u = t - pi/2 + cos t... from rest: u'' = -cos t.
    let mass =
        one()
            .load(&[(0, -1.0)], sine(1.0, 1.0, 0.5 * PI))
            .contact([None, Some(0)], 0.0, stop(0.5));
    let (states, summary) = first(&mass, &[1.0, 3.0]);
    assert_eq!(states[0].r, 0.0);
    // Round-off.
    assert!((states[0].force + libm::cos(1.0)).abs() < 1e-15);
    let opening = summary.events.last().unwrap();
    assert!((opening.time - 0.5 * PI).abs() < 1e-12);
    let s: f64 = 3.0 - 0.5 * PI;
    assert!((states[1].u - (s - libm::sin(s))).abs() < 1e-12);
}

#[test]
fn a_stop_that_overlaps_at_the_start_is_refused() {
    let mass = one()
        .moving(&[-0.1], &[0.0])
        .contact([None, Some(0)], 0.0, stop(0.5));
    let fault = run(&mass, &[1.0], |_, _| ()).unwrap_err();
    let message = "the rigid stop c0 overlaps at the start: r must be >= 0, got -0.1";
    assert_eq!(fault.to_string(), message);
}
