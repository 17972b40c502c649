//! The critical step of conditionally stable methods.

use super::*;
use crate::methods::highest_frequency;
use crate::system::bar::{Bar, Mass};
use nalgebra::{DMatrix, SymmetricEigen};

/// omega_max of q'' + (diag(omega2) + k phi phi^T) q = 0 by a dense eigensolver.
fn dense(modes: &[Mode], k: f64) -> f64 {
    let matrix = DMatrix::from_fn(modes.len(), modes.len(), |i, j| {
        let modal = if i == j { modes[i].omega2 } else { 0.0 };
        modal + k * (modes[i].phi2 * modes[j].phi2).sqrt()
    });
    SymmetricEigen::new(matrix).eigenvalues.max().sqrt()
}

#[test]
fn the_highest_frequency_is_that_of_a_dense_eigensolver() {
    for elements in [1, 2, 10, 40] {
        let bar = Bar {
            elements,
            mass: 2.0,
            travel_time: 0.5,
            kind: Mass::Lumped,
        };
        let modes: Vec<Mode> = bar.modes().collect();
        for k in [0.0, 1e-6, 1.0, 300.0, 1e7] {
            let ours = highest_frequency(modes.iter().copied(), k);
            // Eigenvalues of a symmetric matrix are exact to the round-off of the largest.
            assert!(
                (ours / dense(&modes, k) - 1.0).abs() < 1e-13,
                "{elements} {k}"
            );
        }
    }
    // The top mode is not moved by the contact: it counts, and the spring does not change it.
    let modes = [Mode::new(4.0, 1.0), Mode::new(9.0, 0.0)];
    assert_eq!(highest_frequency(modes.into_iter(), 1.0), 3.0);
    assert_eq!(highest_frequency(modes.into_iter(), 12.0), 4.0);
    assert_eq!(
        highest_frequency(modes.into_iter(), f64::INFINITY),
        f64::INFINITY
    );
    assert_eq!(highest_frequency([].into_iter(), 1.0), 0.0);
}

/// Largest |r| of a structure on a closed spring over 2000 steps.
struct Growth(f64);

impl WithMethod for Growth {
    type Output = f64;
    fn run<N: Recursion<1>>(self, mut method: N) -> f64 {
        let k = self.0;
        let mut law = Elastic {
            on: method.flexibilities(),
            law: |r| k * r,
        };
        let mut largest: f64 = 0.0;
        for _ in 0..2000 {
            largest = largest.max(method.step(&mut law).displacement.0[0].abs());
        }
        largest
    }
}

#[test]
fn motions_grow_just_above_the_critical_step_only() {
    let bar = Bar {
        elements: 6,
        mass: 2.0,
        travel_time: 0.5,
        kind: Mass::Lumped,
    };
    for k in [0.0, 50.0, 1000.0] {
        let modes: Vec<Mode> = bar.modes().collect();
        for coefficients in [
            Coefficients::central_difference(),
            Coefficients::linear_acceleration(),
            Coefficients::newmark(0.1, 0.55),
            Coefficients::hht(-0.6),
        ] {
            let critical = Method::from(coefficients).critical_step(modes.iter().copied(), k);
            let growth = |dt: f64| {
                let modes: Vec<_> = modes
                    .iter()
                    .enumerate()
                    .map(|(j, m)| mode(m.omega2, m.phi2, if j > 0 { 0.01 } else { 0.0 }, 0.0))
                    .collect();
                let at = start(Method::Family(coefficients), dt, 0.0, k * 0.06);
                with(&at, &modes, Growth(k))
            };
            assert!(growth(0.999 * critical) < 10.0, "{coefficients:?} {k}");
            assert!(growth(1.01 * critical) > 1e3, "{coefficients:?} {k}");
        }
        let always = Method::from(Coefficients::hht(-0.1));
        assert_eq!(
            always.critical_step(modes.iter().copied(), k),
            f64::INFINITY
        );
    }
}
