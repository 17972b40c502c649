//! The list of methods, and a method with its numbers.

use super::amplification::Amplification;
use super::lanes::{ModeCount, Recursion};
use super::{
    AverageAcceleration, Bathe, Coefficients, ContactStabilized, Description, MoreauJean, SubStep,
    average_acceleration, bathe, contact_stabilized, family, moreau_jean,
};

/// All methods, in the order of the schema.
pub static METHODS: &[Description] = &[
    average_acceleration::DESCRIPTION,
    family::linear_acceleration::DESCRIPTION,
    family::newmark::DESCRIPTION,
    family::hht::DESCRIPTION,
    family::generalized_alpha::DESCRIPTION,
    bathe::DESCRIPTION,
    family::central_difference::DESCRIPTION,
    moreau_jean::DESCRIPTION,
    contact_stabilized::DESCRIPTION,
];

/// A method with its numbers: one of the schemes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// Constant average acceleration [F section 4, I section 3].
    AverageAcceleration(AverageAcceleration),
    /// A method of Newmark's family or one of its alpha methods.
    Family(Coefficients),
    /// Bathe's method of two sub-steps.
    Bathe(Bathe),
    /// Moreau and Jean's method with impulses.
    MoreauJean(MoreauJean),
    /// Newmark's method with contacts stabilised.
    ContactStabilized(ContactStabilized),
}

/// An expression with the scheme of a method, whatever its type is.
#[macro_export]
#[doc(hidden)]
macro_rules! each_method {
    ($method:expr, $chosen:ident => $result:expr) => {
        match $method {
            $crate::methods::Method::AverageAcceleration($chosen) => $result,
            $crate::methods::Method::Family($chosen) => $result,
            $crate::methods::Method::Bathe($chosen) => $result,
            $crate::methods::Method::MoreauJean($chosen) => $result,
            $crate::methods::Method::ContactStabilized($chosen) => $result,
        }
    };
}

/// What a method is: a step with its coefficients, and what follows from them.
pub trait Scheme: Copy + Into<Method> {
    /// Number of sub-steps of a step.
    const SUB_STEPS: u64 = 1;

    /// Whether dt S' is an impulse on the contact. Only then rigid contacts have a restitution.
    const HAS_IMPULSES: bool = false;

    /// Whether S' acts over the whole step, so that its work is dt S' (rdot + rdot')/2.
    const FORCE_AT_END: bool = false;

    /// Whether rigid contacts correct displacements before a step, see [`ContactStabilized`].
    const CORRECTS: bool = false;

    /// Whether the work of the contact is always the energy that the modes lose.
    const CONSERVES: bool = false;

    /// The recursion of the modes of L structures with one contact each.
    type Lanes<const L: usize, N: ModeCount>: Recursion<L>;

    /// The sub-steps of a step of `dt`.
    fn sub_steps(&self, dt: f64) -> Vec<SubStep>;

    /// Weights of the loads at the start of a step, after a jump there, and at the ends of its sub-steps, before a jump there, in the
    /// impulse that they give a free mass, in this step and in those after it. From v' and a' of a sub-step for K = C = 0.
    fn load_weights(&self) -> Vec<f64> {
        let sub_steps = self.sub_steps(1.0);
        let weights = sub_steps.iter().flat_map(|sub_step| {
            let [[w0, w1], [m0, m1]] = [sub_step.weights, sub_step.inertia];
            [w0 - m0 + sub_step.v_a, w1 - m1 + sub_step.d1]
        });
        weights.collect()
    }

    /// The order of its errors in dt without a contact.
    fn order(&self) -> u32;

    /// Largest omega dt for which a free mode does not grow: infinite for a method that is always stable, zero for one that never is.
    fn stability_limit(&self) -> f64 {
        f64::INFINITY
    }

    /// The amplification of a free mode with this `omega_dt` > 0, from the method's amplification matrix.
    fn amplification(&self, omega_dt: f64) -> Amplification;
}

impl Method {
    /// Number of its scheme in the order of [`Method`]. Cases with the same scheme share a loop over steps.
    pub fn scheme(&self) -> u8 {
        match self {
            Method::AverageAcceleration(_) => 0,
            Method::Family(_) => 1,
            Method::Bathe(_) => 2,
            Method::MoreauJean(_) => 3,
            Method::ContactStabilized(_) => 4,
        }
    }

    /// See [`Scheme::SUB_STEPS`].
    pub fn count_of_sub_steps(&self) -> u64 {
        fn of<S: Scheme>(_: &S) -> u64 {
            S::SUB_STEPS
        }
        each_method!(self, chosen => of(chosen))
    }

    /// See [`Scheme::load_weights`].
    pub fn load_weights(&self) -> Vec<f64> {
        each_method!(self, chosen => chosen.load_weights())
    }

    /// See [`Scheme::HAS_IMPULSES`].
    pub fn has_impulses(&self) -> bool {
        fn of<S: Scheme>(_: &S) -> bool {
            S::HAS_IMPULSES
        }
        each_method!(self, chosen => of(chosen))
    }

    /// See [`Scheme::FORCE_AT_END`].
    pub fn has_force_at_end(&self) -> bool {
        fn of<S: Scheme>(_: &S) -> bool {
            S::FORCE_AT_END
        }
        each_method!(self, chosen => of(chosen))
    }

    /// See [`Scheme::CORRECTS`].
    pub fn corrects(&self) -> bool {
        fn of<S: Scheme>(_: &S) -> bool {
            S::CORRECTS
        }
        each_method!(self, chosen => of(chosen))
    }

    /// See [`Scheme::CONSERVES`].
    pub fn conserves(&self) -> bool {
        fn of<S: Scheme>(_: &S) -> bool {
            S::CONSERVES
        }
        each_method!(self, chosen => of(chosen))
    }

    /// See [`Scheme::sub_steps`].
    pub fn sub_steps(&self, dt: f64) -> Vec<SubStep> {
        each_method!(self, chosen => chosen.sub_steps(dt))
    }

    /// See [`Scheme::order`].
    pub fn order(&self) -> u32 {
        each_method!(self, chosen => chosen.order())
    }

    /// See [`Scheme::stability_limit`].
    pub fn stability_limit(&self) -> f64 {
        each_method!(self, chosen => chosen.stability_limit())
    }

    /// Whether free modes grow at steps above a critical one.
    pub fn has_critical_step(&self) -> bool {
        self.stability_limit() < f64::INFINITY
    }

    /// See [`Scheme::amplification`].
    ///
    /// ```
    /// use slipgap_system::methods::{AverageAcceleration, Method};
    ///
    /// // The trapezoidal rule keeps the amplitude; at omega dt = 2 a step has the phase 2 atan(1).
    /// let step = Method::from(AverageAcceleration).amplification(2.0);
    /// let phase = step.principal.expect("an oscillation").phase;
    /// assert!((phase - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    /// assert!((step.spectral_radius - 1.0).abs() < 1e-15);
    /// ```
    pub fn amplification(&self, omega_dt: f64) -> Amplification {
        each_method!(self, chosen => chosen.amplification(omega_dt))
    }
}
