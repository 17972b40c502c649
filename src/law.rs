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
