//! Friction of one mass.

use super::*;
use crate::contact::ClippedLine;
use crate::exact::coulomb::Coulomb;
use crate::exact::regularised::Regularised;
use libm::tan;
use std::f64::consts::PI;

/// X'' + X + S = cos(rho T).
fn den_hartog(rho: f64, law: StructureLaw) -> Structure {
    one()
        .spring([None, Some(0)], 1.0)
        .load(&[(0, 1.0)], sine(1.0, rho, 0.5 * PI))
        .contact([None, Some(0)], 0.0, law)
}

/// x'' + S = sin T.
fn block(law: StructureLaw) -> Structure {
    one()
        .load(&[(0, 1.0)], sine(1.0, 1.0, 0.0))
        .contact([None, Some(0)], 0.0, law)
}

/// r at the events of the last `periods` of `count` periods.
fn reversals(structure: &Structure, period: f64, count: usize, periods: usize) -> Vec<f64> {
    let end = period * count as f64;
    let (_, summary) = first(structure, &[end]);
    let times = summary.events.iter().map(|event| event.time);
    let late: Vec<f64> = times
        .filter(|time| *time > end - periods as f64 * period)
        .collect();
    let (states, _) = first(structure, &late);
    states.iter().map(|state| state.r).collect()
}

#[test]
fn amplitudes_are_those_of_den_hartog() {
    for (rho, f, printed) in [
        (0.8, 0.3, 2.6261048757),
        (0.9, 0.5, 4.2159037168),
        (1.25, 0.4, 1.4800496969),
        (1.5, 0.3, 0.7211102551),
        (2.0, 0.2, 0.3179797338),
    ] {
        let (v, u) = (1.0 / (1.0 - rho * rho), tan(0.5 * PI / rho) / rho);
        let amplitude = f64::sqrt(v * v - f * u * f * u);
        let r = reversals(&den_hartog(rho, coulomb(f)), 2.0 * PI / rho, 400, 3);
        assert!(r.len() >= 6);
        for r in r {
            // Round-off of 1600 pieces near resonance.
            assert!((r.abs() - amplitude).abs() < 1e-11, "{rho} {f}: {r}");
            // 10 decimals.
            assert!((r.abs() - printed).abs() < 1e-10, "{rho} {f}: {r}");
        }
    }
}

#[test]
fn stops_a_cycle_are_those_of_den_hartog() {
    for (rho, f, stops) in [
        (0.1, 0.1, 2),
        (0.1, 0.3, 4),
        (0.2, 0.3, 4),
        (0.4, 0.1, 0),
        (0.5, 0.3, 1),
        (0.7, 0.6, 0),
        (0.7, 0.8, 2),
    ] {
        let period = 2.0 * PI / rho;
        let (_, summary) = first(&den_hartog(rho, coulomb(f)), &[120.0 * period]);
        let late = summary.events.iter().filter(|event| {
            event.time > 100.0 * period && event.kind == EventKind::Phase(Phase::Closed)
        });
        assert_eq!(late.count(), 20 * stops, "{rho} {f}");
    }
}

#[test]
fn at_half_the_frequency_stops_become_short_as_one_over_their_number() {
    // V = 4/3 and U = 0, so that the amplitude of the formula is 4/3: it is half the distance of the peaks. They are not
    // symmetric. There is one stop a cycle; the peak with it approaches 4/3 - 2 f/3 = 6/5.
    let peaks = |count| {
        let r = reversals(&den_hartog(0.5, coulomb(0.2)), 4.0 * PI, count, 2);
        [1.0, -1.0].map(|sign| r.iter().map(|r| sign * r).fold(f64::MIN, f64::max))
    };
    let [early, late] = [peaks(400), peaks(1600)];
    assert!((0.5 * (late[0] + late[1]) - 4.0 / 3.0).abs() < 1e-6);
    let ratio = (1.2 - early[0]) / (1.2 - late[0]);
    assert!((ratio - 4.0).abs() < 0.05, "{ratio}");
}

#[test]
fn amplitudes_of_softened_laws_approach_it_with_their_orders() {
    let period = 2.0 * PI / 0.8;
    let in_period: Vec<f64> = steps(period / 4000.0, 4000);
    let times: Vec<f64> = in_period.iter().map(|t| 100.0 * period + t).collect();
    let change = |law| {
        let (states, _) = first(&den_hartog(0.8, law), &times);
        let inner = 1..states.len() - 1;
        let i = inner
            .max_by(|i, j| states[*i].r.total_cmp(&states[*j].r))
            .unwrap();
        let [a, b, c] = [i - 1, i, i + 1].map(|i| states[i].r);
        let peak = b + (a - c) * (a - c) / (8.0 * (2.0 * b - a - c));
        peak / 2.6261048757 - 1.0
    };
    for (width, elastic, viscous, decimals) in [
        (1e-1, -0.10339, -1.89e-3, 1e-5),
        (1e-2, -0.03187, -1.96e-4, 1e-6),
        (1e-3, -0.00996, -2.0e-5, 1e-6),
    ] {
        let limit = Limit::constant(0.3);
        let law = StructureLaw::new(
            ClippedLine::Elastic {
                stiffness: 0.3 / width,
            },
            limit.clone(),
        );
        // The printed numbers are of a sampled motion: 0.6e-5 below these.
        assert!((change(law) - elastic).abs() < 1e-5, "{width}");
        let law = StructureLaw::new(
            ClippedLine::Viscous {
                viscosity: 0.3 / width,
            },
            limit,
        );
        assert!((change(law) - viscous).abs() < decimals, "{width}");
    }
}

#[test]
fn a_block_on_a_shaking_base_slides_as_westermo_and_udwadia_computed() {
    for (eta, printed) in [(0.2, 1.89874059), (0.4, 1.55591237), (0.5, 1.23798178)] {
        let r = reversals(&block(coulomb(eta)), 2.0 * PI, 300, 2);
        let path = (r[2] - r[1]).abs();
        let formula = 2.0 * f64::sqrt(1.0 - 0.25 * (PI * eta) * (PI * eta));
        // Round-off of 1200 pieces.
        assert!((path - formula).abs() < 2e-13, "{eta}: {path}");
        assert!((path - printed).abs() < 5.1e-9);
    }
    for (eta, printed) in [
        (0.6, 0.7883721087),
        (0.7, 0.4324939397),
        (0.8, 0.1877945226),
        (0.9, 0.0459351761),
    ] {
        // Between the events of a cycle it stops twice.
        let r = reversals(&block(coulomb(eta)), 2.0 * PI, 20, 3);
        let changes = r.windows(2).map(|r| (r[1] - r[0]).abs());
        let slips: Vec<f64> = changes.filter(|slip| *slip > 1e-9).collect();
        assert!(slips.len() >= 5);
        for slip in slips {
            // 10 decimals.
            assert!((slip - printed).abs() < 5.1e-11, "{eta}: {slip}");
        }
    }
}

#[test]
fn a_pulse_moves_a_block_as_newmark_computed() {
    for (a, slip) in [(2.0, 0.25), (5.0, 2.5), (10.0, 11.25)] {
        let pulse = table(&[[0.0, a], [0.5, a], [0.5, 0.0]]);
        let block = one()
            .load(&[(0, 1.0)], pulse)
            .contact([None, Some(0)], 0.0, coulomb(1.0));
        let (states, summary) = first(&block, &[100.0]);
        // V^2/2N (1 - N/A), V = A t0; all work is dissipated.
        assert!((states[0].u - slip).abs() < 1e-14 * slip);
        assert_eq!((states[0].v, states[0].force), (0.0, 0.0));
        assert!((summary.book.dissipated - slip).abs() < 1e-14 * slip);
    }
}

/// Release from 12.3 with the limit 1.
fn released(law: StructureLaw) -> (Vec<f64>, Vec<First>, Summary) {
    let oscillator = one()
        .spring([None, Some(0)], 1.0)
        .moving(&[12.3], &[0.0])
        .contact([None, Some(0)], 0.0, law);
    let times = steps(0.1, 400);
    let (states, summary) = first(&oscillator, &times);
    assert!(summary.book.residual < 1e-14 * summary.book.largest);
    (times, states, summary)
}

#[test]
fn free_vibration_with_coulomb_friction_is_the_closed_form() {
    let exact = Coulomb::new(12.3);
    let (times, states, _) = released(coulomb(1.0));
    for (t, state) in times.iter().zip(&states).skip(1) {
        let expected = exact.at(*t);
        // Round-off of 12.3.
        assert!((state.r - expected.displacement).abs() < 1e-14);
        assert!((state.rate - expected.velocity).abs() < 1e-14);
        assert!((state.force - expected.force).abs() < 1e-14);
    }
}

#[test]
fn free_vibration_with_softened_laws_is_the_closed_form() {
    for width in [10.0, 1.0, 0.1, 1e-3] {
        let limit = Limit::constant(1.0);
        let elastic = StructureLaw::new(
            ClippedLine::Elastic {
                stiffness: 1.0 / width,
            },
            limit.clone(),
        );
        let viscous = StructureLaw::new(
            ClippedLine::Viscous {
                viscosity: 1.0 / width,
            },
            limit,
        );
        for (law, mut exact) in [
            (elastic, Regularised::displacement(12.3, width, 0.0)),
            (viscous, Regularised::velocity(12.3, width)),
        ] {
            let (times, states, _) = released(law);
            for (t, state) in times.iter().zip(&states) {
                let expected = exact.at(*t);
                // Round-off of 12.3 at each event, and of r times the stiffness.
                assert!((state.r - expected.displacement).abs() < 2e-13);
                assert!((state.force - expected.force).abs() < 1e-14 / width.min(0.1));
            }
        }
    }
}
