//! Peaks compared with closed forms, another program and a time step method.

use super::*;
use crate::system::loads::synthetic::{FIRM_GROUND, synthetic};
use proptest::prelude::*;

fn table(points: &[[f64; 2]]) -> Table {
    let column = |j: usize| points.iter().map(|point| point[j]).collect();
    Table::new(column(0), column(1)).unwrap()
}

fn one(table: &Table, period: f64, ratio: f64) -> Ordinate {
    spectrum(table, &[period], ratio).unwrap()[0]
}

fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance * b.abs(), "{a} {b}");
}

#[test]
fn a_step_overshoots_as_in_textbooks() {
    // Largest |u| = a/omega^2 (1 + exp(-pi zeta/sqrt(1 - zeta^2))) at pi/omega_d. Round-off of some ten pieces.
    for (period, ratio) in [(2.0, 0.0), (0.7, 0.05), (3.0, 0.4), (0.02, 0.7)] {
        let step = table(&[[1.0, 3.0], [1.01, 3.0]]);
        let peak = one(&step, period, ratio);
        let omega = 2.0 * PI / period;
        let damped = (1.0 - ratio * ratio).sqrt();
        let expected = 3.0 / (omega * omega) * (1.0 + (-PI * ratio / damped).exp());
        near(peak.displacement, expected, 1e-14);
        // v has a simple root there.
        near(peak.time, 1.0 + PI / (omega * damped), 1e-13);
        near(peak.pseudo_velocity(), omega * expected, 1e-14);
        near(peak.pseudo_acceleration(), omega * omega * expected, 1e-14);
    }
}

#[test]
fn a_motion_without_an_overshoot_ends_at_its_rest_position() {
    // The overshoot is exp(-222); 80 radians after the step (1 + 80) exp(-80) is left to the rest position.
    let step = table(&[[0.0, -3.0], [0.1, -3.0]]);
    near(one(&step, 2.0 * PI, 0.9999).displacement, 3.0, 1e-13);
}

#[test]
fn a_ramp_to_a_constant_has_its_closed_form() {
    // A ramp of the duration r to a: undamped peak a/omega^2 (1 + |sin(omega r/2)|/(omega r/2)), after the ramp.
    for r in [0.01, 0.3, 1.7, 40.3] {
        let peak = one(&table(&[[0.0, 0.0], [r, -2.0]]), 1.3, 0.0);
        let omega = 2.0 * PI / 1.3;
        let x: f64 = omega * r / 2.0;
        // 200 pieces of round-off for the longest ramp.
        near(
            peak.displacement,
            2.0 / (omega * omega) * (1.0 + x.sin().abs() / x),
            1e-13,
        );
    }
}

#[test]
fn a_rectangular_pulse_has_its_peak_in_or_after_it() {
    // Undamped, a for r, then 0: peak 2 a/omega^2 from r = T/2 on, 2 a/omega^2 sin(pi r/T) below.
    for r in [0.05, 0.2, 0.5, 0.9, 7.3] {
        let pulse = table(&[[0.0, 1.0], [r, 1.0], [r, 0.0]]);
        let expected = 2.0 / (4.0 * PI * PI) * if r < 0.5 { (PI * r).sin() } else { 1.0 };
        near(one(&pulse, 1.0, 0.0).displacement, expected, 1e-14);
    }
}

#[test]
fn the_second_extreme_after_the_last_point_may_be_the_largest() {
    // omega = 1: pushed to the other side for 0.4, then free about u = 3 with the amplitude from u and u' there.
    let pushed = table(&[[0.0, 1.0], [0.4, 1.0], [0.4, -3.0]]);
    let [u, v] = [0.4f64.cos() - 1.0, -(0.4f64.sin())];
    let expected = 3.0 + (u - 3.0).hypot(v);
    near(one(&pushed, 2.0 * PI, 0.0).displacement, expected, 1e-14);
}

#[test]
fn a_still_ground_has_no_response() {
    let still = one(&table(&[[0.0, 0.0], [5.0, 0.0]]), 1.0, 0.05);
    assert_eq!((still.displacement, still.time), (0.0, 0.0));
    assert_eq!(one(&table(&[[0.0, 0.0]]), 1.0, 0.05).displacement, 0.0);
}

#[test]
fn the_peaks_of_the_synthetic_record_are_those_of_another_program() {
    // numpy: matrix exponentials of the 4 x 4 system, sampled 1000 times in each step, so up to (1e-5 s)^2/8 |u''| below the peak;
    // |u''| is about omega^2 times the peak. Half a printed digit is 1.2e-9 of the smallest one.
    let record = synthetic(1, FIRM_GROUND).unwrap();
    for (period, ratio, peak, time) in [
        (0.5, 0.05, 0.048384866357, 11.50564),
        (1.0, 0.05, 0.095284412375, 8.29986),
        (2.0, 0.05, 0.227233998554, 6.97173),
        (0.05, 0.02, 0.000420127472, 6.33693),
        (0.2, 0.2, 0.004026852208, 9.06799),
        (6.0, 0.0, 0.356068949287, 9.33752),
    ] {
        let ordinate = one(&record, period, ratio);
        let sampled = 4.0 * PI * PI / (period * period) * 1.25e-11;
        near(ordinate.displacement, peak, sampled + 2e-9);
        // Half a sample and half a printed digit.
        assert!((ordinate.time - time).abs() < 2e-5, "{ordinate:?}");
    }
}

/// Largest |u| at the steps of average acceleration.
fn average_acceleration(record: &Table, period: f64, ratio: f64, dt: f64) -> f64 {
    let omega = 2.0 * PI / period;
    let steps = (30.0 / dt).round() as usize;
    let (mut u, mut v, mut a, mut peak) = (0.0, 0.0, -record.at(0.0), 0.0f64);
    for i in 1..=steps {
        let u_star = u + dt * v + dt * dt / 4.0 * a;
        let v_star = v + dt / 2.0 * a;
        let load = -record.at(i as f64 * dt);
        a = (load - 2.0 * ratio * omega * v_star - omega * omega * u_star)
            / (1.0 + ratio * omega * dt + omega * omega * dt * dt / 4.0);
        u = u_star + dt * dt / 4.0 * a;
        v = v_star + dt / 2.0 * a;
        peak = peak.max(u.abs());
    }
    peak
}

#[test]
fn average_acceleration_has_the_printed_displacements_and_converges_to_the_exact_ones() {
    let record = synthetic(1, FIRM_GROUND).unwrap();
    for (period, printed) in [(0.5, 0.048366), (1.0, 0.095253), (2.0, 0.227229)] {
        let step = |dt| average_acceleration(&record, period, 0.05, dt);
        // The printed displacements are those of dt = 0.005 s; half a unit of the last digit.
        assert!((step(0.005) - printed).abs() < 5e-7);
        let exact = one(&record, period, 0.05).displacement;
        let errors = [0.005, 0.001, 0.0002].map(|dt| (step(dt) / exact - 1.0).abs());
        // Order 2: a factor of 25; the sample at the peak moves, which has order 2, too.
        let order = |i: usize| (errors[i] / errors[i + 1]).ln() / 5f64.ln();
        assert!(
            (1.8..2.2).contains(&order(0)) && (1.8..2.2).contains(&order(1)),
            "{errors:?}"
        );
    }
}

#[test]
fn arias_intensity_of_a_constant_and_of_a_jump() {
    // pi/(2 g) a^2 t; a jump has no duration.
    let pulse = table(&[[1.0, 3.0], [3.0, 3.0], [3.0, 0.0], [9.0, 0.0]]);
    near(arias(&pulse, 9.80665), PI / (2.0 * 9.80665) * 18.0, 1e-15);
}

#[test]
fn periods_and_ratios_without_an_oscillator_are_refused() {
    let pulse = table(&[[0.0, 1.0], [1.0, 0.0]]);
    for period in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-9] {
        assert_eq!(spectrum(&pulse, &[1.0, period], 0.05), None);
    }
    for ratio in [-0.1, 1.0, f64::NAN] {
        assert_eq!(spectrum(&pulse, &[1.0], ratio), None);
    }
    assert_eq!(spectrum(&pulse, &[], 0.05), Some(vec![]));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// The peak is not below any value of the motion, whose closed form is a sum of ramps.
    #[test]
    fn no_value_of_the_closed_form_is_above_the_peak(
        gaps in proptest::collection::vec(0.01f64..2.0, 1..6),
        values in proptest::collection::vec(-1.0f64..1.0, 6),
        period in 0.1f64..5.0,
        ratio in 0.0f64..0.9,
    ) {
        let mut points = vec![[0.0, 0.0]];
        for (gap, a) in gaps.iter().zip(&values) {
            points.push([points[points.len() - 1][0] + gap, *a]);
        }
        points.push([points[points.len() - 1][0] + 0.1, 0.0]);
        let peak = one(&table(&points), period, ratio).displacement;
        let mut largest = 0.0f64;
        let end = points[points.len() - 1][0] + 2.0 * period;
        for i in 0..4000 {
            largest = largest.max(ramps(&points, period, ratio, end * f64::from(i) / 4000.0).abs());
        }
        // Cancellation of the ramps' terms a/omega^3/h. The samples miss the peak by about (omega end/4000)^2/8 of it, at most 0.4 %.
        let omega = 2.0 * PI / period;
        let cancelled = 1e-12 * (1.0 + 1.0 / omega.powi(3));
        prop_assert!(largest <= peak + cancelled, "{} {}", largest, peak);
        prop_assert!(largest >= 0.99 * peak - cancelled, "{} {}", largest, peak);
    }
}

/// u at time t: each point adds a ramp of acceleration with the change of the slope there.
fn ramps(points: &[[f64; 2]], period: f64, ratio: f64, t: f64) -> f64 {
    let omega = 2.0 * PI / period;
    let damped = omega * (1.0 - ratio * ratio).sqrt();
    // The response to -tau: u_p = -(tau - 2 zeta/omega)/omega^2 and a free vibration from u(0) = u'(0) = 0.
    let ramp = |tau: f64| {
        let o2 = omega * omega;
        let c = -2.0 * ratio / (omega * o2);
        let s = (1.0 / o2 + ratio * omega * c) / damped;
        let free =
            (-ratio * omega * tau).exp() * (c * (damped * tau).cos() + s * (damped * tau).sin());
        -(tau - 2.0 * ratio / omega) / o2 + free
    };
    let slope = |i: usize| {
        let [a, b] = [points[i], points[i + 1]];
        (b[1] - a[1]) / (b[0] - a[0])
    };
    let mut sum = 0.0;
    let mut before = 0.0;
    for (i, [time, _]) in points.iter().enumerate() {
        let after = if i + 1 < points.len() { slope(i) } else { 0.0 };
        if t > *time {
            sum += (after - before) * ramp(t - time);
        }
        before = after;
    }
    sum
}
