//! How a method amplifies a free mode in a step: spectral radius, period and damping, from the amplification matrix of the
//! textbooks (Hughes, The Finite Element Method, chapter 9). Independent of the recursions that solve systems.
//!
//! A step maps (u, dt v, dt^2 a) of an undamped mode, or (u, dt v), by a matrix A(omega dt). Its principal eigenvalues are
//! rho exp(+-i phi). The computed period is 2 pi dt/phi instead of 2 pi/omega, and the motion decays as that of an oscillator
//! with the damping ratio -ln(rho)/phi (Hilber, Hughes and Taylor 1977).

use super::{Coefficients, MethodChoice};
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

impl MethodChoice {
    /// The amplification of a free mode with this `omega_dt` > 0.
    ///
    /// ```
    /// use slipgap_solver::methods::MethodChoice;
    ///
    /// // The trapezoidal rule keeps the amplitude; at omega dt = 2 a step has the phase 2 atan(1).
    /// let step = MethodChoice::AverageAcceleration.amplification(2.0);
    /// let phase = step.principal.expect("an oscillation").phase;
    /// assert!((phase - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    /// assert!((step.spectral_radius - 1.0).abs() < 1e-15);
    /// ```
    pub fn amplification(&self, omega_dt: f64) -> Amplification {
        match self {
            MethodChoice::AverageAcceleration => {
                of_three(&Coefficients::newmark(0.25, 0.5).change(omega_dt), omega_dt)
            }
            MethodChoice::Family(own) => of_three(&own.change(omega_dt), omega_dt),
            MethodChoice::Bathe => of_two(&bathe_change(omega_dt), omega_dt),
            MethodChoice::MoreauJean { theta } => {
                of_two(&moreau_jean_change(*theta, omega_dt), omega_dt)
            }
        }
    }
}

impl Coefficients {
    /// A - I for (u, dt v, dt^2 a), with D = 1 - alpha_m + (1 - alpha_f) beta (omega dt)^2 (Chung and Hulbert 1993, (10); for
    /// alpha_m = 0 Hughes (9.3.12)).
    pub fn change(&self, omega_dt: f64) -> Matrix3<f64> {
        let Coefficients {
            alpha_m,
            alpha_f,
            beta,
            gamma,
        } = *self;
        let w2 = omega_dt * omega_dt;
        let d = 1.0 - alpha_m + (1.0 - alpha_f) * beta * w2;
        let u = -w2 / d;
        let v = (1.0 - alpha_f) * u;
        let a = (0.5 - beta) * v - alpha_m / d;
        Matrix3::new(
            beta * u,
            1.0 + beta * v,
            0.5 - beta + beta * a,
            gamma * u,
            gamma * v,
            1.0 - gamma + gamma * a,
            u,
            v,
            a - 1.0,
        )
    }
}

/// A - I for (u, dt v) of Bathe's method (Bathe and Baig 2005).
pub fn bathe_change(omega_dt: f64) -> Matrix2<f64> {
    let w2 = omega_dt * omega_dt;
    let d = (9.0 + w2) * (16.0 + w2);
    let same = -w2 * (72.0 + w2) / d;
    let other = (144.0 - 5.0 * w2) / d;
    Matrix2::new(same, other, -w2 * other, same)
}

/// A - I for (u, dt v) of Moreau and Jean's method without contact.
pub fn moreau_jean_change(theta: f64, omega_dt: f64) -> Matrix2<f64> {
    let w2 = omega_dt * omega_dt;
    let k = w2 / (1.0 + theta * theta * w2);
    Matrix2::new(-theta * k, 1.0 - theta * theta * k, -k, -theta * k)
}

fn of_two(change: &Matrix2<f64>, omega_dt: f64) -> Amplification {
    of_pair(-change.trace(), change.determinant(), 0.0, omega_dt)
}

fn of_three(change: &Matrix3<f64>, omega_dt: f64) -> Amplification {
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
