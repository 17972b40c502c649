//! The coefficients of Newmark's family of methods.

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
/// use slipgap_solver::methods::Coefficients;
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
    /// Newmark's method (1959). Second order for gamma = 1/2; stable for every step if 2 beta >= gamma >= 1/2.
    pub const fn newmark(beta: f64, gamma: f64) -> Self {
        Coefficients {
            alpha_m: 0.0,
            alpha_f: 0.0,
            beta,
            gamma,
        }
    }

    /// The linear acceleration method (Newmark 1959): beta = 1/6, gamma = 1/2, stable up to omega dt = sqrt(12).
    pub const fn linear_acceleration() -> Self {
        Self::newmark(1.0 / 6.0, 0.5)
    }

    /// The central difference method in Newmark's form: beta = 0, gamma = 1/2. r at the end of a step does not depend on the
    /// contact's force there.
    pub const fn central_difference() -> Self {
        Self::newmark(0.0, 0.5)
    }

    /// The method of Hilber, Hughes and Taylor (1977), for alpha from -1/3 (most dissipation) to 0 (none): alpha_f = -alpha,
    /// beta = (1 - alpha)^2/4, gamma = 1/2 - alpha.
    pub const fn hht(alpha: f64) -> Self {
        Coefficients {
            alpha_m: 0.0,
            alpha_f: -alpha,
            beta: 0.25 * (1.0 - alpha) * (1.0 - alpha),
            gamma: 0.5 - alpha,
        }
    }

    /// The generalised-alpha method of Chung and Hulbert (1993), with the spectral radius `rho_inf` in [0, 1] at infinite
    /// frequency: alpha_m = (2 rho - 1)/(rho + 1), alpha_f = rho/(rho + 1), beta = (1 - alpha_m + alpha_f)^2/4,
    /// gamma = 1/2 - alpha_m + alpha_f.
    pub const fn generalized_alpha(rho_inf: f64) -> Self {
        let alpha_m = (2.0 * rho_inf - 1.0) / (rho_inf + 1.0);
        let alpha_f = rho_inf / (rho_inf + 1.0);
        let shift = 1.0 - alpha_m + alpha_f;
        Coefficients {
            alpha_m,
            alpha_f,
            beta: 0.25 * shift * shift,
            gamma: shift - 0.5,
        }
    }

    /// Largest omega dt for which a free mode does not grow: infinite for methods that are always stable, zero for methods that
    /// never are (gamma < 1/2 of Newmark's).
    ///
    /// With z = (1 + s)/(1 - s), W2 = (omega dt)^2 and kappa = 3/2 + gamma - alpha_f the characteristic polynomial of a step is
    /// c3 s^3 + c2 s^2 + W2 (2 kappa - 3) s + W2, c3 and c2 being linear in W2. Routh and Hurwitz ask for
    /// 2 kappa - 3 >= 0, c3 >= 0 and c2 (2 kappa - 3) >= c3: each is linear in W2.
    pub fn stability_limit(&self) -> f64 {
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
}

#[cfg(test)]
mod tests {
    use super::super::MethodChoice;
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
                        let own = Coefficients {
                            alpha_m,
                            alpha_f,
                            beta,
                            gamma,
                        };
                        let radius = |w| MethodChoice::Family(own).amplification(w).spectral_radius;
                        let limit = own.stability_limit();
                        let largest = limit.min(1e3);
                        // Near the limit roots can be double: round-off of 1e-8.
                        for share in [0.001, 0.01, 0.1, 0.5, 0.9, 0.999] {
                            assert!(radius(share * largest) < 1.0 + 1e-7, "{own:?} {share}");
                        }
                        if limit == 0.0 {
                            assert!([1e-3, 0.1, 1.0].iter().any(|w| radius(*w) > 1.0), "{own:?}");
                        } else if limit < f64::INFINITY {
                            finite += 1;
                            assert!(radius(1.001 * limit) > 1.0 + 1e-7, "{own:?} {limit}");
                        }
                    }
                }
            }
        }
        assert!(finite > 20, "{finite}");
    }
}
