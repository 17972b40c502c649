//! A step of a method as sub-steps of one form.

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
pub struct SubStep {
    /// Its length.
    pub length: f64,
    /// m0, m1.
    pub inertia: [f64; 2],
    /// w0, w1.
    pub weights: [f64; 2],
    /// s0, s1.
    pub forces: [f64; 2],
    /// d1: what a' adds to v'.
    pub d1: f64,
    /// d2: what a' adds to u'.
    pub d2: f64,
    /// u_v.
    pub u_v: f64,
    /// u_a.
    pub u_a: f64,
    /// u_u and u_d; none in the first sub-step.
    pub u_before: Option<[f64; 2]>,
    /// v_a.
    pub v_a: f64,
    /// v_d.
    pub v_d: f64,
}

impl SubStep {
    /// d2/d1, by which a relation of velocities becomes one of displacements. Both relations are ones of velocities where the
    /// displacement does not depend on the force.
    pub fn of_velocity(&self) -> f64 {
        if self.is_explicit() {
            1.0
        } else {
            self.d2 / self.d1
        }
    }

    /// Whether the displacement at the end does not depend on the force there.
    pub fn is_explicit(&self) -> bool {
        self.d2 == 0.0
    }

    /// How much of S' enters the relation of a contact, besides B^T (..)^-1 B.
    pub fn flexibility(&self) -> f64 {
        let of = if self.is_explicit() { self.d1 } else { self.d2 };
        of * self.forces[1]
    }
}
