//! Observed orders of convergence, with exact motions that do not come from a method.

use super::*;
use nalgebra::{DMatrix, SymmetricEigen};

/// Largest error of r and rdot over all steps up to `end`.
struct Errors<'a, F> {
    law: F,
    exact: &'a dyn Fn(f64) -> [f64; 2],
    dt: f64,
    steps: u32,
}

impl<F: Fn(f64) -> f64> WithMethod for Errors<'_, F> {
    type Output = f64;
    fn run<N: Recursion<1>>(self, mut method: N) -> f64 {
        let mut law = Elastic {
            on: method.flexibilities(),
            law: self.law,
        };
        let mut sum = 0.0;
        for i in 1..=self.steps {
            let contact = method.step(&mut law);
            let [r, v] = (self.exact)(f64::from(i) * self.dt);
            let [r, v] = [contact.displacement.0[0] - r, contact.velocity.0[0] - v];
            sum += r * r + v * v;
        }
        (sum / f64::from(self.steps)).sqrt()
    }
}

/// A motion with a contact law S = f(r), and its exact solution.
struct Problem<'a> {
    modes: &'a [ModeStart<1>],
    law: fn(f64) -> f64,
    exact: &'a dyn Fn(f64) -> [f64; 2],
    end: f64,
}

impl Problem<'_> {
    fn error(&self, choice: Method, steps: u32) -> f64 {
        let dt = self.end / f64::from(steps);
        let r: f64 = self.modes.iter().map(|m| m.displacement.0[0]).sum();
        let errors = Errors {
            law: self.law,
            exact: self.exact,
            dt,
            steps,
        };
        with(&start(choice, dt, 0.0, (self.law)(r)), self.modes, errors)
    }

    /// Slope of the errors from `steps` to 16 times as many.
    fn order(&self, choice: Method, steps: u32) -> f64 {
        0.25 * libm::log2(self.error(choice, steps) / self.error(choice, 16 * steps))
    }

    /// Checks the order of each method; those with the force at the end of a step are of first order once the contact acts.
    fn check(&self, steps: u32, tolerance: f64, contact: bool) {
        for (choice, _) in all() {
            let expected = match contact && choice.has_force_at_end() {
                true => 1.0,
                false => f64::from(choice.order()),
            };
            let order = self.order(choice, steps);
            // Errors of first order are large, and so are their terms of second order.
            let tolerance = if expected == 1.0 { 0.08 } else { tolerance };
            assert!((order - expected).abs() < tolerance, "{choice:?}: {order}");
        }
    }
}

#[test]
fn free_modes_converge_at_the_order_of_the_method() {
    let modes = [mode(4.0, 0.7, 0.3, 1.0), mode(0.25, 0.2, 0.5, -0.4)];
    let exact = |t: f64| {
        let of = |omega: f64, x: f64, v: f64| {
            let (sin, cos) = libm::sincos(omega * t);
            [x * cos + v / omega * sin, v * cos - x * omega * sin]
        };
        let ([x, v], [y, w]) = (of(2.0, 0.3, 1.0), of(0.5, 0.5, -0.4));
        [x + y, v + w]
    };
    let problem = Problem {
        modes: &modes,
        law: |_| 0.0,
        exact: &exact,
        end: 8.0,
    };
    problem.check(256, 0.02, false);
}

#[test]
fn a_closed_contact_does_not_change_the_order() {
    // Three modes on a spring k: q'' + (diag(omega2) + k phi phi^T) q = 0 by a symmetric eigensolver.
    let modes = [
        mode(0.0, 0.5, 0.1, -0.7),
        mode(2.0, 0.8, 0.4, 0.3),
        mode(7.0, 0.6, -0.2, 0.5),
    ];
    let phi: Vec<f64> = modes.iter().map(|m| m.mode[0].phi2.sqrt()).collect();
    let k = 3.0;
    let matrix = DMatrix::from_fn(3, 3, |i, j| {
        let modal = if i == j { modes[i].mode[0].omega2 } else { 0.0 };
        modal + k * phi[i] * phi[j]
    });
    let eigen = SymmetricEigen::new(matrix);
    let exact = |t: f64| {
        let mut sum = [0.0; 2];
        for e in 0..3 {
            let shape = eigen.eigenvectors.column(e);
            let omega = eigen.eigenvalues[e].sqrt();
            let of = |number: fn(&ModeStart<1>) -> f64| -> f64 {
                (0..3).map(|i| shape[i] * number(&modes[i]) / phi[i]).sum()
            };
            let (q, p) = (of(|m| m.displacement.0[0]), of(|m| m.velocity.0[0]));
            let (sin, cos) = libm::sincos(omega * t);
            let seen: f64 = (0..3).map(|i| shape[i] * phi[i]).sum();
            sum[0] += seen * (q * cos + p / omega * sin);
            sum[1] += seen * (p * cos - q * omega * sin);
        }
        sum
    };
    let problem = Problem {
        modes: &modes,
        law: |r| 3.0 * r,
        exact: &exact,
        end: 6.0,
    };
    problem.check(256, 0.03, true);
}

#[test]
fn a_nonlinear_contact_does_not_change_the_order() {
    // x'' + x + x^3 = 0: x = a cn(w t | m), w^2 = 1 + a^2, m = a^2/(2 w^2), by Jacobi's functions with Landen's descent.
    let amplitude = 1.5;
    let omega = f64::sqrt(1.0 + amplitude * amplitude);
    let m = amplitude * amplitude / (2.0 * omega * omega);
    let exact = |t: f64| {
        let [sn, cn, dn] = jacobi(omega * t, m);
        [amplitude * cn, -amplitude * omega * sn * dn]
    };
    let problem = Problem {
        modes: &[mode(1.0, 1.0, amplitude, 0.0)],
        law: |r| r * r * r,
        exact: &exact,
        end: 10.0,
    };
    problem.check(1024, 0.03, true);
}

/// sn, cn, dn by the arithmetic-geometric mean (Abramowitz and Stegun 16.4).
fn jacobi(u: f64, m: f64) -> [f64; 3] {
    let (mut a, mut c) = (vec![1.0], vec![m.sqrt()]);
    let mut b = (1.0 - m).sqrt();
    while c[c.len() - 1].abs() > 1e-17 {
        let last = a[a.len() - 1];
        a.push(0.5 * (last + b));
        c.push(0.5 * (last - b));
        b = (last * b).sqrt();
    }
    let n = a.len() - 1;
    let mut phi = libm::pow(2.0, n as f64) * a[n] * u;
    for i in (1..=n).rev() {
        phi = 0.5 * (phi + libm::asin(c[i] / a[i] * libm::sin(phi)));
    }
    let (sin, cos) = libm::sincos(phi);
    [sin, cos, (1.0 - m * sin * sin).sqrt()]
}

#[test]
fn a_contact_that_opens_and_closes_does_not_change_the_order() {
    // x'' + x = -8 x where x < 0, from x = 1 at rest: half a period of frequency 1, half of frequency 3 with velocity 1.
    let half = [std::f64::consts::PI, std::f64::consts::PI / 3.0];
    let exact = |t: f64| {
        let mut t = (t + 0.5 * half[0]) % (half[0] + half[1]);
        if t < half[0] {
            let (sin, cos) = libm::sincos(t);
            return [sin, cos];
        }
        t -= half[0];
        let (sin, cos) = libm::sincos(3.0 * t);
        [-sin / 3.0, -cos]
    };
    let problem = Problem {
        modes: &[mode(1.0, 1.0, 1.0, 0.0)],
        law: |r| (8.0 * r).min(0.0),
        exact: &exact,
        end: 12.0,
    };
    // Where in a step the contact opens or closes changes the errors of single runs.
    problem.check(1024, 0.1, true);
}
