//! How a method amplifies a free mode in a step: spectral radius, period and damping, from the amplification matrix of the
//! textbooks (Hughes, The Finite Element Method, chapter 9). Independent of the recursions that solve systems.
//!
//! A step maps (u, dt v, dt^2 a) of an undamped mode, or (u, dt v), by a matrix A(omega dt). Its principal eigenvalues are
//! rho exp(+-i phi). The computed period is 2 pi dt/phi instead of 2 pi/omega, and the motion decays as that of an oscillator
//! with the damping ratio -ln(rho)/phi (Hilber, Hughes and Taylor 1977).

use nalgebra::{Matrix2, Matrix3};

/// What a step makes of a free mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Amplification {
    /// Largest absolute value of the eigenvalues; above 1 the motion grows.
    pub spectral_radius: f64,
    /// phi, rho and their meaning; `None` if no eigenvalue is complex: there is no oscillation.
    pub principal: Option<Principal>,
}

/// The principal eigenvalues rho exp(+-i phi).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Principal {
    /// phi, in radians.
    pub phase: f64,
    /// (T - T0)/T0 of the computed period T and the exact one T0: omega dt/phi - 1.
    pub period_elongation: f64,
    /// -ln(rho)/phi.
    pub damping_ratio: f64,
}

/// From A - I for (u, dt v).
pub(super) fn of_two(change: &Matrix2<f64>, omega_dt: f64) -> Amplification {
    of_pair(-change.trace(), change.determinant(), 0.0, omega_dt)
}

/// From A - I for (u, dt v, dt^2 a).
pub(super) fn of_three(change: &Matrix3<f64>, omega_dt: f64) -> Amplification {
    // Eigenvalues d of A - I: d^3 - trace d^2 + minors d - determinant = 0. At d = 0 it is > 0, so one root is negative.
    let trace = change.trace();
    let minors = [(0, 1), (0, 2), (1, 2)]
        .map(|(i, j)| change[(i, i)] * change[(j, j)] - change[(i, j)] * change[(j, i)])
        .iter()
        .sum::<f64>();
    let determinant = change.determinant();
    let cubic = |d: f64| ((d - trace) * d + minors) * d - determinant;
    let mut low = -(1.0 + trace.abs() + minors.abs() + determinant.abs());
    let mut high = 0.0;
    loop {
        let middle = 0.5 * (low + high);
        if !(low < middle && middle < high) {
            break;
        }
        if cubic(middle) > 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    // The others are the roots of d^2 + b d + c.
    let c = determinant / low;
    of_pair((c - minors) / low, c, (1.0 + low).abs(), omega_dt)
}

/// From the eigenvalues 1 + d, d^2 + b d + c = 0, and the absolute value of another one.
fn of_pair(b: f64, c: f64, other: f64, omega_dt: f64) -> Amplification {
    let real = 1.0 - 0.5 * b;
    let square = c - 0.25 * b * b;
    if square > 0.0 {
        // |1 + d|^2 = 1 + (c - b)
        let growth = 0.5 * libm::log1p(c - b);
        let phase = libm::atan2(square.sqrt(), real);
        Amplification {
            spectral_radius: libm::exp(growth).max(other),
            principal: Some(Principal {
                phase,
                period_elongation: omega_dt / phase - 1.0,
                damping_ratio: -growth / phase,
            }),
        }
    } else {
        Amplification {
            spectral_radius: (real.abs() + (-square).sqrt()).max(other),
            principal: None,
        }
    }
}
