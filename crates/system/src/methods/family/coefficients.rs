//! The coefficients of Newmark's family of methods, and what follows from them.

use super::lanes::{Lanes, ModeState};
use crate::methods::amplification::{Amplification, of_three};
use crate::methods::lanes::ModeCount;
use crate::methods::{Method, Scheme, SubStep};
use nalgebra::Matrix3;

/// Coefficients of Newmark's family in the generalised-alpha form (Chung and Hulbert 1993).
///
/// The equation of motion holds between both ends of a step; the contact's force is weighted as K u is:
///
/// ```text
/// M ((1 - alpha_m) a' + alpha_m a) + K ((1 - alpha_f) u' + alpha_f u) + B ((1 - alpha_f) S' + alpha_f S) = 0
/// u' = u + dt v + dt^2 ((1/2 - beta) a + beta a'),   v' = v + dt ((1 - gamma) a + gamma a')
/// ```
///
/// ```
/// use slipgap_system::methods::{Coefficients, Scheme};
///
/// // Without dissipation at high frequencies, rho_inf = 1, the mean of both ends; Newmark's method is at the end.
/// let Coefficients { alpha_m, alpha_f, beta, gamma } = Coefficients::generalized_alpha(1.0);
/// assert_eq!([alpha_m, alpha_f, beta, gamma], [0.5, 0.5, 0.25, 0.5]);
/// assert_eq!(Coefficients::hht(0.0), Coefficients::newmark(0.25, 0.5));
/// // Central differences are stable up to omega dt = 2.
/// assert_eq!(Coefficients::central_difference().stability_limit(), 2.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coefficients {
    /// Weight of the acceleration at the start of a step.
    pub alpha_m: f64,
    /// Weight of K u and of the contact's force at the start of a step.
    pub alpha_f: f64,
    /// Weight of the last acceleration in u.
    pub beta: f64,
    /// Weight of the last acceleration in v.
    pub gamma: f64,
}

impl Coefficients {
    /// A step of `dt` (Chung and Hulbert 1993).
    pub fn sub_step(&self, dt: f64) -> SubStep {
        let Coefficients {
            alpha_m,
            alpha_f,
            beta,
            gamma,
        } = *self;
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

    /// A - I for (u, dt v, dt^2 a) of a free mode, with D = 1 - alpha_m + (1 - alpha_f) beta (omega dt)^2 (Chung and Hulbert 1993, (10);
    /// for alpha_m = 0 Hughes (9.3.12)).
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

impl From<Coefficients> for Method {
    #[inline(always)]
    fn from(coefficients: Coefficients) -> Method {
        Method::Family(coefficients)
    }
}

impl Scheme for Coefficients {
    type Lanes<const L: usize, N: ModeCount> = Lanes<L, N::Of<ModeState<L>>>;

    fn sub_steps(&self, dt: f64) -> Vec<SubStep> {
        vec![self.sub_step(dt)]
    }

    /// Second order for gamma = 1/2 - alpha_m + alpha_f (Chung and Hulbert 1993, (17)), but for round-off of the coefficients.
    fn order(&self) -> u32 {
        let off = 0.5 - self.alpha_m + self.alpha_f - self.gamma;
        if off.abs() < 1e-15 { 2 } else { 1 }
    }

    /// Zero for methods that never are stable: gamma < 1/2 of Newmark's.
    ///
    /// With z = (1 + s)/(1 - s), W2 = (omega dt)^2 and kappa = 3/2 + gamma - alpha_f the characteristic polynomial of a step is
    /// c3 s^3 + c2 s^2 + W2 (2 kappa - 3) s + W2, c3 and c2 being linear in W2. Routh and Hurwitz ask for
    /// 2 kappa - 3 >= 0, c3 >= 0 and c2 (2 kappa - 3) >= c3: each is linear in W2.
    fn stability_limit(&self) -> f64 {
        let Coefficients {
            alpha_m,
            alpha_f,
            beta,
            gamma,
        } = *self;
        let damping = 2.0 * (gamma - alpha_f);
        let spread = 4.0 * (beta + (1.0 - alpha_f) * (0.5 + gamma));
        let kappa2 = 3.0 + damping;
        let c2 = [4.0, spread + 3.0 - 2.0 * kappa2];
        let c3 = [
            4.0 - 8.0 * alpha_m,
            8.0 * (1.0 - alpha_f) * beta - spread + kappa2 - 1.0,
        ];
        let least = [
            [damping, 0.0],
            c3,
            [damping * c2[0] - c3[0], damping * c2[1] - c3[1]],
        ];
        // Round-off of coefficients that cancel.
        let noise = 16.0 * f64::EPSILON;
        let limits = least.map(|[constant, slope]| {
            if constant < -noise {
                0.0
            } else if slope < -noise {
                if constant > noise {
                    constant / -slope
                } else {
                    0.0
                }
            } else {
                f64::INFINITY
            }
        });
        limits.into_iter().fold(f64::INFINITY, f64::min).sqrt()
    }

    fn amplification(&self, omega_dt: f64) -> Amplification {
        of_three(&self.change(omega_dt), omega_dt)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn newmarks_limit_is_that_of_the_textbook() {
        // Hughes, The Finite Element Method (9.1.17): omega dt <= 1/sqrt(gamma/2 - beta) without physical damping.
        for (beta, gamma) in [
            (0.0, 0.5),
            (1.0 / 6.0, 0.5),
            (0.2, 0.5),
            (0.1, 0.6),
            (0.0, 0.9),
        ] {
            let limit = Coefficients::newmark(beta, gamma).stability_limit();
            let textbook = 1.0 / f64::sqrt(0.5 * gamma - beta);
            assert!((limit / textbook - 1.0).abs() < 1e-14, "{beta} {gamma}");
        }
        for (beta, gamma) in [(0.25, 0.5), (0.3, 0.6), (1.0, 0.5), (0.5, 1.0)] {
            assert_eq!(
                Coefficients::newmark(beta, gamma).stability_limit(),
                f64::INFINITY
            );
        }
        assert_eq!(Coefficients::newmark(0.25, 0.49).stability_limit(), 0.0);
    }

    #[test]
    fn alpha_methods_are_always_stable_in_their_range() {
        for i in 0..=100 {
            let share = f64::from(i) / 100.0;
            for method in [
                Coefficients::hht(-share / 3.0),
                Coefficients::generalized_alpha(share),
            ] {
                assert_eq!(method.stability_limit(), f64::INFINITY, "{method:?}");
                // Second order (Chung and Hulbert 1993, (17)).
                let order = 0.5 - method.alpha_m + method.alpha_f - method.gamma;
                assert!(order.abs() < 1e-15, "{method:?}");
            }
        }
        // Beyond its range HHT has alpha_f > 1/2 and is not.
        assert!(Coefficients::hht(-0.6).stability_limit() < f64::INFINITY);
    }

    #[test]
    fn the_limit_is_where_the_spectral_radius_passes_one() {
        let mut finite = 0;
        for alpha_m in [-0.5, 0.0, 0.3] {
            for alpha_f in [0.0, 0.2, 0.45, 0.6] {
                for beta in [0.0, 0.1, 0.3, 0.7] {
                    for gamma in [0.35, 0.55, 0.8, 1.3] {
                        let coefficients = Coefficients {
                            alpha_m,
                            alpha_f,
                            beta,
                            gamma,
                        };
                        let radius = |w| coefficients.amplification(w).spectral_radius;
                        let limit = coefficients.stability_limit();
                        let largest = limit.min(1e3);
                        // Near the limit roots can be double: round-off of 1e-8.
                        for share in [0.001, 0.01, 0.1, 0.5, 0.9, 0.999] {
                            assert!(
                                radius(share * largest) < 1.0 + 1e-7,
                                "{coefficients:?} {share}"
                            );
                        }
                        if limit == 0.0 {
                            assert!(
                                [1e-3, 0.1, 1.0].iter().any(|w| radius(*w) > 1.0),
                                "{coefficients:?}"
                            );
                        } else if limit < f64::INFINITY {
                            finite += 1;
                            assert!(
                                radius(1.001 * limit) > 1.0 + 1e-7,
                                "{coefficients:?} {limit}"
                            );
                        }
                    }
                }
            }
        }
        assert!(finite > 20, "{finite}");
    }
}
