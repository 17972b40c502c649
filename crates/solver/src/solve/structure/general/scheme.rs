//! The methods as sub-steps of one form.

use crate::methods::{Coefficients, MethodChoice};

/// A sub-step. Its unknown is one acceleration a':
///
/// ```text
/// (m1 M + w1 d1 C + w1 d2 K) a' = w0 p + w1 p' - B (s0 S + s1 S') - m0 M a - C v_e - K u_e
/// u' = u* + d2 a',   u_e = u + w1 (u* - u),   u* - u = u_v v + u_a a + u_u (u - u0) + u_d (v - v0)
/// v' = v* + d1 a',   v_e = v + w1 (v* - v),   v* - v = v_a a + v_d (v - v0)
/// ```
///
/// u, v, a, S and p are at its start, u0 and v0 at the start of the step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::solve::structure) struct SubStep {
    /// Its length.
    pub(super) length: f64,
    /// m0, m1.
    pub(super) inertia: [f64; 2],
    /// w0, w1.
    pub(super) weights: [f64; 2],
    /// s0, s1.
    pub(super) forces: [f64; 2],
    pub(super) d1: f64,
    pub(super) d2: f64,
    pub(super) u_v: f64,
    pub(super) u_a: f64,
    /// u_u and u_d; none in the first sub-step.
    pub(super) u_before: Option<[f64; 2]>,
    pub(super) v_a: f64,
    pub(super) v_d: f64,
}

impl SubStep {
    /// d2/d1, by which a relation of velocities becomes one of displacements. Both relations are ones of velocities where the
    /// displacement does not depend on the force.
    pub(super) fn of_velocity(&self) -> f64 {
        if self.is_explicit() {
            1.0
        } else {
            self.d2 / self.d1
        }
    }

    /// Whether the displacement at the end does not depend on the force there.
    pub(super) fn is_explicit(&self) -> bool {
        self.d2 == 0.0
    }

    /// How much of S' enters the relation of a contact, besides B^T (..)^-1 B.
    pub(super) fn flexibility(&self) -> f64 {
        let of = if self.is_explicit() { self.d1 } else { self.d2 };
        of * self.forces[1]
    }
}

/// The sub-steps of a step of `dt`: one or two.
pub(in crate::solve::structure) fn sub_steps(method: &MethodChoice, dt: f64) -> Vec<SubStep> {
    match method {
        // As a member of the family; the stepper for constant average acceleration has its own form.
        MethodChoice::AverageAcceleration => vec![trapezoidal(dt)],
        MethodChoice::Family(coefficients) => vec![family(coefficients, dt)],
        MethodChoice::Bathe => vec![trapezoidal(0.5 * dt), backward_difference(dt)],
        MethodChoice::MoreauJean { theta } => vec![impulses(*theta, dt)],
    }
}

/// Newmark's family in the form of Chung and Hulbert (1993).
fn family(coefficients: &Coefficients, dt: f64) -> SubStep {
    let Coefficients {
        alpha_m,
        alpha_f,
        beta,
        gamma,
    } = *coefficients;
    SubStep {
        length: dt,
        inertia: [alpha_m, 1.0 - alpha_m],
        weights: [alpha_f, 1.0 - alpha_f],
        forces: [alpha_f, 1.0 - alpha_f],
        d1: gamma * dt,
        d2: beta * dt * dt,
        u_v: dt,
        u_a: (0.5 - beta) * dt * dt,
        u_before: None,
        v_a: (1.0 - gamma) * dt,
        v_d: 0.0,
    }
}

fn trapezoidal(length: f64) -> SubStep {
    let coefficients = Coefficients {
        alpha_m: 0.0,
        alpha_f: 0.0,
        beta: 0.25,
        gamma: 0.5,
    };
    family(&coefficients, length)
}

/// The second sub-step of Bathe and Baig (2005): v' = (u0 - 4 u + 3 u')/dt and a' = (v0 - 4 v + 3 v')/dt.
fn backward_difference(dt: f64) -> SubStep {
    SubStep {
        length: 0.5 * dt,
        inertia: [0.0, 1.0],
        weights: [0.0, 1.0],
        forces: [0.0, 1.0],
        d1: dt / 3.0,
        d2: dt * dt / 9.0,
        u_v: dt / 3.0,
        u_a: 0.0,
        u_before: Some([1.0 / 3.0, dt / 9.0]),
        v_a: 0.0,
        v_d: 1.0 / 3.0,
    }
}

/// Moreau and Jean: a' = (v' - v)/dt, and dt S' is the impulse of a contact. Jean (1999), section 5.
fn impulses(theta: f64, dt: f64) -> SubStep {
    SubStep {
        length: dt,
        inertia: [0.0, 1.0],
        weights: [1.0 - theta, theta],
        forces: [0.0, 1.0],
        d1: dt,
        d2: theta * dt * dt,
        u_v: dt,
        u_a: 0.0,
        u_before: None,
        v_a: 0.0,
        v_d: 0.0,
    }
}
