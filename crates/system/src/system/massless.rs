//! A bar whose contact node has no mass: its mass is moved to its neighbour.
//!
//! After H. B. Khenous, P. Laborde and Y. Renard, Mass redistribution method for finite element contact problems in elastodynamics, European
//! Journal of Mechanics A/Solids 27 (2008) 918-932. Their redistribution also keeps the centre of mass, which is here L/(2 n^2) farther
//! from the contact.
//!
//! The bar has n elements with the mass m and the stiffness k each. Node 0 is at the contact, and node n is free. Node 0 has no
//! mass, so it follows its neighbour: u_0 = u_1 - S/k, where a displacement is positive if it opens the gap. This element is a
//! spring in series with the contact. The lumped masses are 3 m/2 at node 1, m at inner nodes and m/2 at node n. For n = 1
//! all of the mass is at node 1.
//!
//! Inner nodes and the free end have the modes u_i = cos(theta (n - i)) with omega^2 = 4 (k/m) s^2, s = sin(theta/2). With N = n - 1,
//! the balance of node 1 is 3 (1 - cos theta) cos(N theta) = cos(N theta) - cos((N - 1) theta), and for s > 0 this is
//!
//! ```text
//! 2 s cos(N theta) + cos(theta/2) sin(N theta) = 0,   sin(N theta + phi) = 0,   phi = atan(2 tan(theta/2))
//! N theta + phi(theta) = j pi,   j = 0..n-1
//! ```
//!
//! The left side of the last line rises from 0 at theta = 0 to N pi + pi/2 at theta = pi. So it has exactly one root for each j, and these
//! are the n modes of n masses; j = 0 is the rigid-body mode. The masses weigh the square of the mode as trapezoids do, and by m more at
//! node 1. With t = tan(theta/2) and cos^2(N theta) = 1/(1 + 4 t^2) this gives the modal mass
//!
//! ```text
//! M = (m/2) (N + phi'(theta)) = (m/2) (N + (1 + t^2)/(1 + 4 t^2)),   divided by cos^2(N theta) if the mode is 1 at node 1:
//! M = (m/2) (N (1 + 3 s^2) + 1)/(1 - s^2)
//! ```
//!
//! A closed contact has no mode that is localised there, for any stiffness, also a rigid contact. Above the cut-off of a long bar such a
//! mode would be u_i = (-q)^i with 0 < q < 1 and omega^2 = (k/m) (1 + q)^2/q. Of two bars, take the one with the larger |u_1|. The
//! contact with both elements is at most as stiff as its element, so the contact force on node 1 is at most 2 k |u_1|. Then the balance
//! needs 3/2 (1 + q)^2/q <= 2 + 1 + q. The left side is above 6, and the right side is below 4.

use libm::{atan, cos, sin, sqrt, tan};
use std::f64::consts::PI;

/// A mode of a bar of n elements.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MasslessMode {
    elements: u32,
    mode: u32,
    /// theta/2
    half: f64,
    /// The mode at the free end over the mode at node 1, 1/cos(N theta).
    free_end: f64,
}

impl MasslessMode {
    /// Mode `mode` < n of a bar of n `elements`.
    ///
    /// With x = theta/2 and x_0 = j pi/(2 n), the equation is G(d) = 2 N d + phi(x_0 + d) - 2 x_0 = 0. Here are no large numbers with
    /// small differences. G rises, and it is concave, because phi' = 2 (1 + t^2)/(1 + 4 t^2) falls with x; so its tangents are above it.
    /// phi <= 2 x for the same reason, so G(0) <= 0. Newton's method from d = 0 rises to the root and never passes it. With
    /// |phi''| < 2.2 and G' >= 2 N + 1/2, an error e becomes at most 0.44 e^2. It is at most 0.63 at d = 0, so that five steps
    /// are enough; the last error is below round-off if the last step was below 1e-9.
    pub fn new(mode: u32, elements: u32) -> MasslessMode {
        let inner = 2.0 * (f64::from(elements) - 1.0);
        let start = f64::from(mode) * PI / (2.0 * f64::from(elements));
        let mut d = 0.0;
        for _ in 0..5 {
            let t = tan(start + d);
            let slope = inner + 2.0 * (1.0 + t * t) / (1.0 + 4.0 * t * t);
            let step = (2.0 * start - inner * d - atan(2.0 * t)) / slope;
            d += step;
            if step < 1e-9 {
                break;
            }
        }
        let half = start + d;
        let t = tan(half);
        // N theta = j pi - phi, so the cosine has the sign of (-1)^j.
        let sign = if mode.is_multiple_of(2) { 1.0 } else { -1.0 };
        MasslessMode {
            elements,
            mode,
            half,
            free_end: sign * sqrt(1.0 + 4.0 * t * t),
        }
    }

    /// sin^2(theta/2).
    pub(super) fn sine_squared(&self) -> f64 {
        let s = sin(self.half);
        s * s
    }

    /// Modal mass over the mass of an element, the mode being 1 at node 1.
    pub fn mass(&self) -> f64 {
        let n = f64::from(self.elements);
        if self.mode == 0 {
            return n;
        }
        let c = cos(self.half);
        0.5 * ((n - 1.0) * (1.0 + 3.0 * self.sine_squared()) + 1.0) / (c * c)
    }

    /// The mode at node `i`, 1 at node 1. Node 0 moves with node 1 if there is no contact force.
    pub fn shape(&self, i: u32) -> f64 {
        let from_end = self.elements.saturating_sub(i.max(1));
        self.free_end * cos(2.0 * self.half * f64::from(from_end))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mass and stiffness of an element, omega^2 and the inverse modal masses of all modes.
    fn modes(n: u32) -> Vec<[f64; 2]> {
        let modes = (0..n).map(|j| MasslessMode::new(j, n));
        modes
            .map(|mode| [4.0 * mode.sine_squared(), 1.0 / mode.mass()])
            .collect()
    }

    #[test]
    fn all_modes_together_have_the_sums_of_the_matrices() {
        // With m = k = 1: node 1 has the mass 3/2 and the stiffness 1, so b^T M^-1 b = 2/3 and b^T M^-1 K M^-1 b = 4/9. The trace of M^-1 K
        // is 2/3 + 2 (n - 2) + 2. Under a unit force at node 1 the element p from the free end carries the share (p - 1/2)/n of it,
        // because the masses behind it need this share; the sum of the squares is the compliance of all elastic modes. A mode
        // that is missing or counted twice changes each of the sums.
        for n in [2, 3, 4, 9, 50, 1000, 100_000] {
            let modes = modes(n);
            let sum = |of: &dyn Fn(f64, f64) -> f64| -> f64 {
                modes[1..]
                    .iter()
                    .map(|[omega2, phi2]| of(*omega2, *phi2))
                    .sum()
            };
            let inner = f64::from(n - 1);
            let n = f64::from(n);
            for (found, expected) in [
                (sum(&|_, phi2| phi2) + modes[0][1], 2.0 / 3.0),
                (sum(&|omega2, phi2| omega2 * phi2), 4.0 / 9.0),
                (sum(&|omega2, _| omega2), 2.0 / 3.0 + 2.0 * (n - 2.0) + 2.0),
                (
                    sum(&|omega2, phi2| phi2 / omega2),
                    inner * (4.0 * inner * inner - 1.0) / (12.0 * n * n),
                ),
            ] {
                // Sums of n terms with round-off of some units each, which mostly cancels.
                let tolerance = 4.0 * f64::EPSILON * (4.0 + n.sqrt());
                let off = (found / expected - 1.0).abs();
                assert!(off < tolerance, "n = {n}: {found} {expected}");
            }
            assert_eq!(modes[0], [0.0, 1.0 / n]);
        }
        assert_eq!(modes(1), [[0.0, 1.0]]);
    }

    #[test]
    fn every_mode_satisfies_the_balance_of_node_1() {
        for n in [2_u32, 3, 10, 1000] {
            let mut before = -1.0;
            for j in 0..n {
                let mode = MasslessMode::new(j, n);
                let [u, next] = [mode.shape(1), mode.shape(2)];
                let residual = 6.0 * mode.sine_squared() * u - (u - next);
                // Angles up to n pi in the cosines, over the cosine at node 1.
                let tolerance = 16.0 * f64::EPSILON * f64::from(n) * mode.free_end.abs();
                assert!(residual.abs() < tolerance, "{j} of {n}: {residual:e}");
                assert!((u - 1.0).abs() < tolerance && mode.shape(0) == u);
                assert!(mode.half > before && mode.half < 0.5 * PI);
                before = mode.half;
            }
        }
    }

    #[test]
    fn low_modes_tend_to_those_of_a_continuous_bar() {
        // theta = x + x^3/(4 n) + ... with x = j pi/n, so 2 sin(theta/2)/x = 1 - x^2/24 + x^2/(4 n); the modal mass tends to half of the
        // bar's.
        for n in [10, 100, 10_000, 1_000_000] {
            for j in 1..=3 {
                let mode = MasslessMode::new(j, n);
                let n = f64::from(n);
                let x = f64::from(j) * PI / n;
                let ratio = 2.0 * sqrt(mode.sine_squared()) / x - 1.0;
                let expected = x * x * (0.25 / n - 1.0 / 24.0);
                assert!(
                    (ratio - expected).abs() < x * x * x * x + 4.0 * f64::EPSILON,
                    "{j} of {n}: {ratio} {expected}"
                );
                let mass = mode.mass() / (0.5 * n) - 1.0;
                assert!(
                    mass > 0.0 && mass < 1.5 * x * x + 1e-15,
                    "{j} of {n}: {mass}"
                );
            }
        }
    }
}
