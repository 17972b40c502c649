//! Contact laws: the force S of an element from its relative displacement r and velocity rdot.
//!
//! S *resists*: it has the sign of the motion it opposes ([F (1)] and [F (6)] disagree on it; this sign
//! agrees with [F (9), (16), (19)]). A step of the method leaves r = r* - h S and rdot = rdot* - h_rate S, with
//! r*, rdot* the response without this step's force. Each law here gives the one root of that pair in closed form:
//! what the papers' iteration converges to where it converges. Newton's iteration on these clipped laws can cycle.

use crate::lane::Lane;

/// What a step leaves open: the response without the element's force, and what a unit of force takes from it.
#[derive(Debug, Clone, Copy)]
pub struct Trial<const L: usize> {
    /// r*, relative displacement without the force of this step.
    pub displacement: Lane<L>,
    /// rdot*, relative velocity without the force of this step.
    pub velocity: Lane<L>,
    /// h = b^T Khat^-1 b, displacement taken by a unit force; > 0.
    pub h: Lane<L>,
    /// 2 h/dt, velocity taken by a unit force.
    pub h_rate: Lane<L>,
}

/// A law for one contact.
pub trait Law<const L: usize> {
    /// The force S at the end of the step; the law's own state moves on.
    fn respond(&mut self, trial: &Trial<L>) -> Lane<L>;
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
    /// 1/k^C; alpha in dimensionless units.
    pub compliance: Lane<L>,
    /// `nu |N| <N>`, >= 0; may change from step to step.
    pub limit: Lane<L>,
    /// Slip r^S.
    pub slip: Lane<L>,
}

impl<const L: usize> Law<L> for DisplacementControl<L> {
    #[inline(always)]
    fn respond(&mut self, trial: &Trial<L>) -> Lane<L> {
        // Stick: S = k^C (r - r^S) [F (9)] with r = r* - h S.
        let stiffness = (self.compliance + trial.h).map(|c| 1.0 / c);
        let stick = (trial.displacement - self.slip) * stiffness;
        let force = stick.cut(self.limit);
        // Return mapping, which [F] does not print: past the limit the slip follows, r^S = r -+ r^E. At N >= 0 the
        // limit is zero, so S = 0 and r^S = r: a contact that opens forgets where it slid.
        let slid = trial.displacement - trial.h * force - self.compliance * force;
        self.slip = stick.where_beyond(self.limit, slid, self.slip);
        force
    }
}

/// Velocity-control model [F (16)]: viscous up to rdot^E = nu |N|/c^C, then at the friction limit.
#[derive(Debug, Clone, Copy)]
pub struct VelocityControl<const L: usize> {
    /// 1/c^C; beta in dimensionless units.
    pub compliance: Lane<L>,
    /// `nu |N| <N>`, >= 0; may change from step to step.
    pub limit: Lane<L>,
}

impl<const L: usize> Law<L> for VelocityControl<L> {
    #[inline(always)]
    fn respond(&mut self, trial: &Trial<L>) -> Lane<L> {
        let damping = (self.compliance + trial.h_rate).map(|c| 1.0 / c);
        (trial.velocity * damping).cut(self.limit)
    }
}

/// Impact spring `[I (7), (8)]`, `S = k_I <r> r`, which pushes while r < 0 and never pulls (the print lacks the last r).
#[derive(Debug, Clone, Copy)]
pub struct ImpactSpring<const L: usize> {
    /// 1/k_I.
    pub compliance: Lane<L>,
}

impl<const L: usize> Law<L> for ImpactSpring<L> {
    #[inline(always)]
    fn respond(&mut self, trial: &Trial<L>) -> Lane<L> {
        let stiffness = (self.compliance + trial.h).map(|c| 1.0 / c);
        // r has the sign of r*, since h > 0.
        (trial.displacement * stiffness).map(|s| if s < 0.0 { s } else { 0.0 })
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

    fn trial(displacement: f64, velocity: f64, h: f64, dt: f64) -> Trial<1> {
        Trial {
            displacement: Lane([displacement]),
            velocity: Lane([velocity]),
            h: Lane([h]),
            h_rate: Lane([2.0 * h / dt]),
        }
    }

    fn displacement(compliance: f64, limit: f64, slip: f64, trial: &Trial<1>) -> (f64, f64) {
        let mut law = DisplacementControl {
            compliance: Lane([compliance]),
            limit: Lane([limit]),
            slip: Lane([slip]),
        };
        let Lane([force]) = law.respond(trial);
        (force, law.slip.0[0])
    }

    fn velocity(compliance: f64, limit: f64, trial: &Trial<1>) -> f64 {
        let mut law = VelocityControl {
            compliance: Lane([compliance]),
            limit: Lane([limit]),
        };
        law.respond(trial).0[0]
    }

    fn impact(compliance: f64, trial: &Trial<1>) -> f64 {
        let mut law = ImpactSpring {
            compliance: Lane([compliance]),
        };
        law.respond(trial).0[0]
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn every_law_gives_the_one_root_and_rises(
            r in -3.0..3.0_f64,
            v in -3.0..3.0_f64,
            slip in -1.0..1.0_f64,
            compliance in 1e-3..5.0_f64,
            h in 1e-3..5.0_f64,
            dt in 0.1..2.0_f64,
            limit in 0.0..2.0_f64,
            more in 0.0..1.0_f64,
        ) {
            let now = trial(r, v, h, dt);
            let further = trial(r + more, v + more, h, dt);
            // The inputs are rounded to eps of some 4, which the steepest law, 1/(compliance + h), turns into this much.
            let near = |a: f64, b: f64| (a - b).abs() < 32.0 * f64::EPSILON * (1.0 + 1.0 / (compliance + h));

            let (force, moved) = displacement(compliance, limit, slip, &now);
            let by_law = |s: f64| s - ((r - h * s - slip) / compliance).clamp(-limit, limit);
            let root = bisection(by_law, limit);
            prop_assert!(near(force, root), "displacement-control {force} {root}");
            let elastic = if force.abs() < limit { slip } else { r - h * force - compliance * force };
            prop_assert!((moved - elastic).abs() < 1e-14, "slip {moved} {elastic}");
            prop_assert!(displacement(compliance, limit, slip, &further).0 >= force);

            let force = velocity(compliance, limit, &now);
            let by_law = |s: f64| s - ((v - 2.0 * h / dt * s) / compliance).clamp(-limit, limit);
            let root = bisection(by_law, limit);
            prop_assert!(near(force, root), "velocity-control {force} {root}");
            prop_assert!(velocity(compliance, limit, &further) >= force);

            let force = impact(compliance, &now);
            let by_law = |s: f64| s - (r - h * s).min(0.0) / compliance;
            let root = bisection(by_law, 3.0 / compliance);
            // Here the bisection itself starts from up to 3000.
            prop_assert!((force - root).abs() < 1e-12, "impact spring {force} {root}");
            prop_assert!(impact(compliance, &further) >= force);
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
        assert_eq!(
            displacement(0.1, 0.0, 5.0, &trial(2.0, 0.0, 0.3, 0.1)),
            (0.0, 2.0)
        );
        assert_eq!(velocity(0.1, 0.0, &trial(2.0, 1.0, 0.3, 0.1)), 0.0);
    }
}
