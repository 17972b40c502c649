//! A contact in series with a compliance: the motion of the contact from the motion behind the compliance.

use super::Deflection;

/// r, rdot and S of the contact, if a compliance c0 without mass is between it and a structure that moves by r_m and rdot_m.
///
/// The motion of the structure is r_m = r + c0 S. A closed contact has r = r(S) with the slope C = dr/dS, so
/// dS/dt = rdot_m/(C + c0) and rdot = rdot_m C/(C + c0). An open contact has the motion of the structure. `deflection` gives r(S) and C,
/// see [`super::StoredEnergy::deflection`]; without it, and for c0 = 0, nothing changes.
///
/// A spring with 1/k = 1 and c0 = 3 has a quarter of the motion:
///
/// ```
/// use slipgap_contact::contact::{ImpactSpring, StoredEnergy, in_series};
///
/// let spring = ImpactSpring { stiffness: 1.0 };
/// let contact = in_series(|s| spring.deflection(s), 3.0, [-4.0, 2.0, -1.0]);
/// assert_eq!(contact, [-1.0, 0.5, -1.0]);
/// assert_eq!(in_series(|s| spring.deflection(s), 3.0, [4.0, 2.0, 0.0]), [4.0, 2.0, 0.0]);
/// ```
#[inline(always)]
pub fn in_series(
    deflection: impl Fn(f64) -> Option<Deflection>,
    compliance: f64,
    [r, rdot, s]: [f64; 3],
) -> [f64; 3] {
    match deflection(s) {
        Some(Deflection { r: closed, slope }) if s != 0.0 && compliance > 0.0 => {
            // A rigid contact has C = 0, and one that only begins to close may have an infinite C.
            [closed, rdot / (1.0 + compliance / slope), s]
        }
        Some(_) | None => [r, rdot, s],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_of_the_slope_and_of_the_compliance() {
        let state = [-0.3, 0.7, -2.0];
        let slope = |slope: f64| move |_: f64| Some(Deflection { r: -0.1, slope });
        // A rigid contact stands still.
        assert_eq!(in_series(slope(0.0), 0.5, state), [-0.1, 0.0, -2.0]);
        assert_eq!(
            in_series(slope(f64::INFINITY), 0.5, state),
            [-0.1, 0.7, -2.0]
        );
        assert_eq!(in_series(slope(0.5), 0.0, state), state);
        assert_eq!(in_series(|_| None, 0.5, state), state);
    }
}
