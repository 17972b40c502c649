//! Bars of finite elements with impact springs.

use super::*;
use crate::contact::ClippedLine;
use crate::exact::mesh::Mesh;
use crate::exact::spring::Spring;
use crate::system::bar::{Bar, Mass};

/// Bars of `n` elements in a row with springs of `stiffness` between them, in the units of [`Mesh`]: mass 0.5, C0/h = 2 n.
fn row(rates: &[f64], n: usize, stiffness: f64) -> Structure {
    let (m, k) = (0.5 / n as f64, 2.0 * n as f64);
    let end = |i: usize| if i == 0 || i == n { 0.5 * m } else { m };
    let element_masses: Vec<f64> = rates.iter().flat_map(|_| (0..=n).map(end)).collect();
    let v: Vec<f64> = rates.iter().flat_map(|v| vec![*v; n + 1]).collect();
    let mut s = masses(&element_masses).moving(&vec![0.0; element_masses.len()], &v);
    for bar in 0..rates.len() {
        let first = bar * (n + 1);
        for i in first..first + n {
            s = s.spring([Some(i), Some(i + 1)], k);
        }
        if bar > 0 {
            let law = StructureLaw::new(ClippedLine::Spring { stiffness }, None);
            s = s.contact([Some(first - 1), Some(first)], 0.0, law);
        }
    }
    s
}

#[test]
fn two_bars_move_as_by_their_modes() {
    // The number of events of the last one has no meaning beyond these; its errors are those of r times the stiffness 1000.
    for (gamma, n, digits) in [
        (0.25, 20, 1e-13),
        (2.12, 20, 1e-13),
        (10.0, 10, 5e-12),
        (100.0, 5, 2e-11),
    ] {
        let bar = Bar {
            elements: n as u32,
            mass: 0.5,
            travel_time: 1.0,
            kind: Mass::Lumped,
        };
        let stiffness = 2.0 * gamma * n as f64;
        let mut mesh = Mesh::new(&bar, stiffness, 0.0).unwrap();
        let times = steps(0.0015, 1000);
        let (states, summary) = first(&row(&[1.0, -1.0], n, stiffness), &times);
        for (t, state) in times.iter().zip(&states) {
            let expected = mesh.at(*t).unwrap();
            assert!(
                (state.r - expected.displacement).abs() < digits,
                "{gamma} {t}"
            );
            assert!((0.5 * state.rate - expected.velocity).abs() < digits);
            assert!((-state.force - expected.force).abs() < digits);
        }
        // The first event is the first touch, at t = 0.
        assert_eq!(summary.events.len(), mesh.events().len() + 1);
        for (event, time) in summary.events[1..].iter().zip(mesh.events()) {
            // The resolution of the events of modes.
            assert!((event.time - time).abs() < 1e-12);
        }
        assert!(summary.book.residual < 1e-14 * summary.book.largest);
    }
}

#[test]
fn fine_bars_approach_continuous_ones() {
    let exact = Spring::new(4.0, 0.0).unwrap();
    let times = steps(0.01, 200);
    let error = |n: usize| {
        let (states, _) = first(&row(&[1.0, -1.0], n, 8.0), &times);
        let errors = times
            .iter()
            .zip(&states)
            .map(|(t, state)| (exact.at(*t).displacement - state.r).abs());
        errors.fold(0.0, f64::max)
    };
    let [coarse, fine, finest] = [20, 40, 80].map(error);
    assert!(finest < 4e-3, "{finest}");
    // Order 1, because of the waves.
    assert!((coarse / fine - 2.0).abs() < 0.5 && (fine / finest - 2.0).abs() < 0.5);
}

#[test]
fn of_three_bars_in_a_row_only_the_third_leaves() {
    // d'Alembert: contacts last from 0 to 2 and from 1 to 3 L/c, L/c = 1/2, with the force Z V/2 = 1/2.
    let last = |n: usize| {
        let mut means = [0.0; 3];
        let mut forces = [0.0; 2];
        let times = steps(0.005, 700);
        run(
            &row(&[1.0, 0.0, 0.0], n, 4.0 * n as f64),
            &times,
            |i, state| {
                for (contact, at) in [(0, 20..180), (1, 120..280)] {
                    if at.contains(&i) {
                        forces[contact] += state.force[contact] / 160.0;
                    }
                }
                if i == 700 {
                    for (mean, v) in means.iter_mut().zip(state.v.chunks(n + 1)) {
                        *mean = (v.iter().sum::<f64>() - 0.5 * (v[0] + v[n])) / n as f64;
                    }
                }
            },
        )
        .unwrap();
        (means, forces)
    };
    let [coarse, fine] = [20, 80].map(last);
    for force in fine.1 {
        assert!((force + 0.5).abs() < 2e-3, "{force}");
    }
    for (bar, v) in [0.0, 0.0, 1.0].into_iter().enumerate() {
        let [coarse, fine] = [coarse.0[bar], fine.0[bar]].map(|mean| (mean - v).abs());
        assert!(
            fine < 0.013 && fine < 0.5 * coarse,
            "{bar}: {coarse} {fine}"
        );
    }
}
