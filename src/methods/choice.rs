//! The choice of a method with its parameters.

/// A method and its parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MethodChoice {
    /// Constant average acceleration [F section 4, I section 3].
    AverageAcceleration,
    /// A method of Newmark's family or one of its alpha methods.
    Family(Coefficients),
    /// Bathe's method of two sub-steps.
    Bathe,
    /// Moreau and Jean's method with impulses.
    MoreauJean {
        /// theta, from 1/2 to 1.
        theta: f64,
    },
}

/// The kinds of methods, which share a loop over steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum MethodKind {
    /// See [`MethodChoice::AverageAcceleration`].
    AverageAcceleration,
    /// See [`MethodChoice::Family`].
    Family,
    /// See [`MethodChoice::Bathe`].
    Bathe,
    /// See [`MethodChoice::MoreauJean`].
    MoreauJean,
}

/// The coefficients of the generalized-alpha form of Newmark's family.
///
/// ```text
/// M ((1 - alpha_m) a(i+1) + alpha_m a(i)) + K ((1 - alpha_f) u(i+1) + alpha_f u(i)) + b ((1 - alpha_f) S(i+1) + alpha_f S(i)) = 0
/// u(i+1) = u + dt v + dt^2 ((1/2 - beta) a + beta a(i+1)),   v(i+1) = v + dt ((1 - gamma) a + gamma a(i+1))
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coefficients {
    /// Weight of a(i).
    pub alpha_m: f64,
    /// Weight of u(i) and S(i).
    pub alpha_f: f64,
    /// Newmark's beta.
    pub beta: f64,
    /// Newmark's gamma.
    pub gamma: f64,
}

impl MethodChoice {
    /// The work of the contact over a step is (w0 S(i) + w1 S(i+1)) (r(i+1) - r(i)) with these w0, w1.
    pub fn work_weights(&self) -> [f64; 2] {
        match self {
            MethodChoice::AverageAcceleration | MethodChoice::Bathe => [0.5, 0.5],
            MethodChoice::Family(own) => [own.alpha_f, 1.0 - own.alpha_f],
            MethodChoice::MoreauJean { .. } => [0.0, 1.0],
        }
    }

    /// Number of sub-steps of a step.
    pub fn sub_steps(&self) -> u64 {
        match self {
            MethodChoice::Bathe => 2,
            _ => 1,
        }
    }

    /// Its kind.
    pub fn kind(&self) -> MethodKind {
        match self {
            MethodChoice::AverageAcceleration => MethodKind::AverageAcceleration,
            MethodChoice::Family(_) => MethodKind::Family,
            MethodChoice::Bathe => MethodKind::Bathe,
            MethodChoice::MoreauJean { .. } => MethodKind::MoreauJean,
        }
    }
}

impl Coefficients {
    /// Newmark's method (Newmark 1959).
    pub const fn newmark(beta: f64, gamma: f64) -> Coefficients {
        Coefficients {
            alpha_m: 0.0,
            alpha_f: 0.0,
            beta,
            gamma,
        }
    }

    /// Linear acceleration: beta = 1/6, gamma = 1/2.
    pub const fn linear_acceleration() -> Coefficients {
        Coefficients::newmark(1.0 / 6.0, 0.5)
    }

    /// Central differences in the form with velocities: beta = 0, gamma = 1/2.
    pub const fn central_difference() -> Coefficients {
        Coefficients::newmark(0.0, 0.5)
    }

    /// The alpha method (Hilber, Hughes and Taylor 1977), alpha from -1/3 to 0.
    pub const fn hht(alpha: f64) -> Coefficients {
        Coefficients {
            alpha_m: 0.0,
            alpha_f: -alpha,
            beta: 0.25 * (1.0 - alpha) * (1.0 - alpha),
            gamma: 0.5 - alpha,
        }
    }

    /// The generalized-alpha method (Chung and Hulbert 1993), with this spectral radius at infinite frequency.
    pub const fn generalized_alpha(rho_inf: f64) -> Coefficients {
        let (alpha_m, alpha_f) = (
            (2.0 * rho_inf - 1.0) / (rho_inf + 1.0),
            rho_inf / (rho_inf + 1.0),
        );
        let gamma = 0.5 - alpha_m + alpha_f;
        Coefficients {
            alpha_m,
            alpha_f,
            beta: 0.25 * (0.5 + gamma) * (0.5 + gamma),
            gamma,
        }
    }
}
