//! The highest frequency of a structure with its contact closed, and the critical time step of a method.

use super::{Method, Mode};

/// The highest circular frequency of a structure whose contact is closed by a spring of this `stiffness` k >= 0.
///
/// lambda = omega^2 is the largest root of 1 = k sum phi2_j/(lambda - omega2_j) above all omega2_j. The right side falls from
/// infinity there, and the root is at most k sum phi2_j above the highest omega2_j, so bisection finds it. An infinite
/// stiffness gives an infinite frequency; without modes it is zero.
pub(super) fn highest_frequency(modes: impl Iterator<Item = Mode> + Clone, stiffness: f64) -> f64 {
    let highest =
        |modes: &mut dyn Iterator<Item = Mode>| modes.map(|m| m.omega2).fold(0.0, f64::max);
    // The spring does not change a mode that the contact does not move.
    let moved = modes.clone().filter(|mode| mode.phi2 > 0.0);
    let top = highest(&mut moved.clone());
    let most: f64 = stiffness * moved.clone().map(|mode| mode.phi2).sum::<f64>();
    if !most.is_finite() {
        return f64::INFINITY;
    }
    // Above the pole at the highest omega2, as a distance from it: no cancellation.
    let below = |rise: f64| {
        let terms = moved.clone().map(|m| m.phi2 / (rise + (top - m.omega2)));
        stiffness * terms.sum::<f64>() >= 1.0
    };
    let (mut low, mut high) = (0.0, most);
    loop {
        let middle = 0.5 * (low + high);
        if !(low < middle && middle < high) {
            break;
        }
        if below(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    (top + high).max(highest(&mut modes.clone())).sqrt()
}

/// A step for messages: six digits, not above `step`.
///
/// ```
/// assert_eq!(slipgap_system::methods::six_digits_below(0.039_307_992), 0.039_307_9);
/// ```
pub fn six_digits_below(step: f64) -> f64 {
    let scale = libm::pow(10.0, 5.0 - libm::floor(libm::log10(step)));
    // Products of decimal fractions are rounded: one more division gives the nearest number.
    (step * scale).floor() / scale
}

impl Method {
    /// The largest stable time step for a structure whose contact may be closed by a spring of this `stiffness`, 2/omega for
    /// central differences with the highest frequency omega; infinite for a method that is always stable.
    ///
    /// ```
    /// use slipgap_system::methods::{Coefficients, Method};
    /// use slipgap_system::system::Mode;
    ///
    /// // A mass of 1 on a spring of 9, and 16 more in contact: omega = 5.
    /// let mode = [Mode::new(9.0, 1.0)];
    /// let method = Method::from(Coefficients::central_difference());
    /// assert_eq!(method.critical_step(mode.into_iter(), 16.0), 2.0 / 5.0);
    /// ```
    pub fn critical_step(&self, modes: impl Iterator<Item = Mode> + Clone, stiffness: f64) -> f64 {
        let limit = self.stability_limit();
        if limit == f64::INFINITY {
            return limit;
        }
        limit / highest_frequency(modes, stiffness)
    }
}
