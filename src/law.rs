//! Contact laws: the force S of an element from its relative displacement r and velocity rdot.
//!
//! S *resists*: it has the sign of the motion it opposes ([F (1)] and [F (6)] disagree on it; this sign
//! agrees with [F (9), (16), (19)]). From S(i) to S(i+1) a step of the method leaves
//!
//! ```text
//! r(i+1) = r(i) + change - h (S(i) + S(i+1)),   rdot(i+1) = free rate - h_rate (S(i) + S(i+1))
//! ```
//!
//! with what the structure would do free of the contact. Each law here gives the one root of that in closed form: what
//! the papers' iteration converges to where it converges. Newton's iteration on these clipped laws can cycle.

use crate::lane::Lane;

/// What a step leaves open: the contact at its start, and the motion that the structure would make free of it.
#[derive(Debug, Clone, Copy)]
pub struct Trial<const L: usize> {
    /// r at the start of the step.
    pub displacement: Lane<L>,
    /// S at the start of the step.
    pub force: Lane<L>,
    /// By how much r would change with neither S(i) nor S(i+1).
    pub change: Lane<L>,
    /// rdot at the end with neither.
    pub rate: Lane<L>,
}

/// What a unit of force at one end of a step takes from the contact's motion.
#[derive(Debug, Clone, Copy)]
pub struct Flexibility<const L: usize> {
    /// h = b^T Khat^-1 b, taken from the displacement; > 0.
    pub h: Lane<L>,
    /// 2 h/dt, taken from the velocity.
    pub h_rate: Lane<L>,
}

/// A law for one contact. What it remembers is in S: a slip is r - S/k^C.
pub trait Law<const L: usize> {
    /// The force S at the end of the step.
    fn respond(&self, trial: &Trial<L>) -> Lane<L>;
}

/// Friction limit `nu |N| <N>`: zero where the contact is open, N >= 0 [F (1), (3)].
pub fn friction_limit(nu: f64, normal_force: f64) -> f64 {
    if normal_force < 0.0 {
        nu * normal_force.abs()
    } else {
        0.0
    }
}

/// Displacement-control model [F (9)]: elastic up to r^E = nu |N|/k^C about the slip, then sliding.
#[derive(Debug, Clone, Copy)]
pub struct DisplacementControl<const L: usize> {
    /// `nu |N| <N>`, >= 0; may change from step to step.
    pub limit: Lane<L>,
    /// S(i+1) of the elastic element for a unit of change, and for a unit of S(i).
    by_change: Lane<L>,
    by_force: Lane<L>,
}

impl<const L: usize> DisplacementControl<L> {
    /// With 1/k^C (alpha in dimensionless units) on a structure of this flexibility.
    #[inline(always)]
    pub fn new(compliance: Lane<L>, limit: Lane<L>, on: Flexibility<L>) -> Self {
        let by_change = (compliance + on.h).map(|c| 1.0 / c);
        DisplacementControl {
            limit,
            by_change,
            by_force: (compliance - on.h) * by_change,
        }
    }
}

impl<const L: usize> Law<L> for DisplacementControl<L> {
    #[inline(always)]
    fn respond(&self, trial: &Trial<L>) -> Lane<L> {
        // Stick: S = k^C (r - r^S) [F (9)] at both ends of the step, so S(i+1) = S(i) + k^C (r(i+1) - r(i)). The cut is
        // the return mapping that [F] does not print: past the limit the slip follows, r^S = r -+ r^E, since it is
        // r - S/k^C whatever S is. At N >= 0 the limit is zero: a contact that opens forgets where it slid.
        (trial.change * self.by_change + trial.force * self.by_force).cut(self.limit)
    }
}

/// Velocity-control model [F (16)]: viscous up to rdot^E = nu |N|/c^C, then at the friction limit.
#[derive(Debug, Clone, Copy)]
pub struct VelocityControl<const L: usize> {
    /// `nu |N| <N>`, >= 0; may change from step to step.
    pub limit: Lane<L>,
    by_rate: Lane<L>,
    by_force: Lane<L>,
}

impl<const L: usize> VelocityControl<L> {
    /// With 1/c^C (beta in dimensionless units) on a structure of this flexibility.
    #[inline(always)]
    pub fn new(compliance: Lane<L>, limit: Lane<L>, on: Flexibility<L>) -> Self {
        let by_rate = (compliance + on.h_rate).map(|c| 1.0 / c);
        VelocityControl {
            limit,
            by_rate,
            by_force: on.h_rate * by_rate,
        }
    }
}

impl<const L: usize> Law<L> for VelocityControl<L> {
    #[inline(always)]
    fn respond(&self, trial: &Trial<L>) -> Lane<L> {
        (trial.rate * self.by_rate - trial.force * self.by_force).cut(self.limit)
    }
}

/// Impact spring `[I (7), (8)]`, `S = k_I <r> r`, which pushes while r < 0 and never pulls (the print lacks the last r).
#[derive(Debug, Clone, Copy)]
pub struct ImpactSpring<const L: usize> {
    h: Lane<L>,
    stiffness: Lane<L>,
}

impl<const L: usize> ImpactSpring<L> {
    /// With 1/k_I on a structure of this flexibility.
    #[inline(always)]
    pub fn new(compliance: Lane<L>, on: Flexibility<L>) -> Self {
        ImpactSpring {
            h: on.h,
            stiffness: (compliance + on.h).map(|c| 1.0 / c),
        }
    }
}

impl<const L: usize> Law<L> for ImpactSpring<L> {
    #[inline(always)]
    fn respond(&self, trial: &Trial<L>) -> Lane<L> {
        // r has the sign of what it would be without S(i+1), since h > 0.
        let alone = trial.displacement + (trial.change - trial.force * self.h);
        (alone * self.stiffness).smaller(Lane::splat(0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The root of S = law(r* - h S): `rest` = S - law(r* - h S) rises with S, so halving finds it.
    fn bisection(rest: impl Fn(f64) -> f64, reach: f64) -> f64 {
        let (mut low, mut high) = (-reach, reach);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if rest(middle) > 0.0 {
                high = middle
            } else {
                low = middle
            }
        }
        0.5 * (low + high)
    }

    fn on(h: f64, dt: f64) -> Flexibility<1> {
        Flexibility {
            h: Lane([h]),
            h_rate: Lane([2.0 * h / dt]),
        }
    }

    fn trial(displacement: f64, force: f64, change: f64, rate: f64) -> Trial<1> {
        Trial {
            displacement: Lane([displacement]),
            force: Lane([force]),
            change: Lane([change]),
            rate: Lane([rate]),
        }
    }

    fn answer(law: impl Law<1>, trial: &Trial<1>) -> f64 {
        law.respond(trial).0[0]
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn every_law_gives_the_one_root_and_rises(
            r in -3.0..3.0_f64,
            before in -2.0..2.0_f64,
            change in -3.0..3.0_f64,
            rate in -3.0..3.0_f64,
            compliance in 1e-3..5.0_f64,
            h in 1e-3..5.0_f64,
            dt in 0.1..2.0_f64,
            limit in 0.0..2.0_f64,
            more in 0.0..1.0_f64,
        ) {
            let now = trial(r, before, change, rate);
            let further = trial(r, before, change + more, rate + more);
            let on = on(h, dt);
            let (soft, bound) = (Lane([compliance]), Lane([limit]));
            // The inputs are rounded to eps of some 8, which the steepest law, 1/(compliance + h), turns into this much.
            let near = |a: f64, b: f64| (a - b).abs() < 64.0 * f64::EPSILON * (1.0 + 1.0 / (compliance + h));
            // What this step's force leaves of the motion.
            let displacement = |s: f64| r + change - h * (before + s);
            let velocity = |s: f64| rate - 2.0 * h / dt * (before + s);

            let law = DisplacementControl::new(soft, bound, on);
            let force = answer(law, &now);
            let slip = r - compliance * before;
            let root = bisection(|s| s - ((displacement(s) - slip) / compliance).clamp(-limit, limit), limit);
            prop_assert!(near(force, root), "displacement-control {force} {root}");
            prop_assert!(answer(law, &further) >= force);

            let law = VelocityControl::new(soft, bound, on);
            let force = answer(law, &now);
            let root = bisection(|s| s - (velocity(s) / compliance).clamp(-limit, limit), limit);
            prop_assert!(near(force, root), "velocity-control {force} {root}");
            prop_assert!(answer(law, &further) >= force);

            let law = ImpactSpring::new(soft, on);
            let force = answer(law, &now);
            let root = bisection(|s| s - displacement(s).min(0.0) / compliance, 20.0 / compliance);
            // Here the bisection itself starts from up to 20000.
            prop_assert!((force - root).abs() < 1e-11, "impact spring {force} {root}");
            prop_assert!(answer(law, &further) >= force);
        }
    }

    #[test]
    fn an_open_contact_has_no_friction_and_forgets_where_it_slid() {
        for (nu, normal, limit) in [
            (0.5, -2.0, 1.0),
            (0.3, -10.0, 3.0),
            (0.5, 0.0, 0.0),
            (0.5, 2.0, 0.0),
        ] {
            assert_eq!(friction_limit(nu, normal), limit);
        }
        let (soft, open) = (Lane([0.1]), Lane([0.0]));
        let mut law = DisplacementControl::new(soft, open, on(0.3, 0.1));
        assert_eq!(answer(law, &trial(2.0, 0.7, 0.5, 0.0)), 0.0);
        // Pressed again, with S = 0 at its start: the slip is where the contact is then.
        law.limit = Lane([1.0]);
        let force = answer(law, &trial(2.0, 0.0, 0.2, 0.0));
        assert!((force - 0.2 / (0.1 + 0.3)).abs() < 1e-15);
        let law = VelocityControl::new(soft, open, on(0.3, 0.1));
        assert_eq!(answer(law, &trial(2.0, 0.0, 1.0, 0.0)), 0.0);
    }
}
