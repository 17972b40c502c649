//! Forces of many contacts at the end of a step, or at an instant of the exact motion.
//!
//! Without the forces of the step the structure leaves r*; with them r = r* - H S. A law over a step is a clipped line,
//! S_i = clip((r_i - c_i)/g_i, low_i, high_i), with g = 0 for a rigid law. With A = H + diag(g) and d = r* - c, the forces minimise
//! 1/2 S^T A S - S^T d over the box low <= S <= high. They are unique if A is positive definite, so always for g > 0.
//!
//! A contact is at its low limit, free, or at its high limit. The pattern of these gives the free forces by
//! A_FF S_F = d_F - A_FB S_B. It is right if these are in the box and q = d - A S presses the others against their limits. If not,
//! the wrong contacts change their places: all of them while they become fewer, else one at a time. This is the block principal
//! pivoting of Judice and Pires (1992), with the rule of Murty, which ends for every positive definite A.

mod active_set;
pub mod curved;
mod factor;
mod matrix;
mod pivoting;
mod rigid;
mod step;
#[cfg(test)]
pub(super) mod tests;

use crate::contact::OwnFault;
use active_set::{ActiveSet, At};
use matrix::Matrix;
pub use rigid::RigidForces;
use std::fmt;
use step::Step;

/// Part of A_ii that is added to it where A is singular; see `solve_singular`.
const SOFTENING: f64 = 1e-6;

/// Steps of the proximal point method.
const PROXIMAL_STEPS: usize = 4;

/// Why a step has no forces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unsolved {
    /// Contacts without a stiffness or damping depend on each other, so that their forces are not unique.
    Singular,
    /// No pattern is right: a number is not finite, or the matrix is not positive semidefinite.
    TooManyRounds,
    /// A force falls with velocity or displacement so fast that a step may have several answers.
    Falling,
    /// Friction limits do not settle at the forces that press, which friction raises.
    Unsettled,
    /// A law of a user's program has no answer that can be taken.
    Own {
        /// The contact, from 0.
        contact: usize,
        /// Why.
        why: OwnFault,
    },
}

impl fmt::Display for Unsolved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = match self {
            Unsolved::Own { contact, why } => {
                return write!(f, "the law of contact {contact} {why}");
            }
            Unsolved::Singular => {
                "the contact forces are not unique: contacts that stick or are shut at the same time depend on each other"
            }
            Unsolved::Unsettled => {
                "friction raises the force that presses it by more than itself, so that a step may have several answers; take a smaller dt"
            }
            Unsolved::TooManyRounds => "no contact forces satisfy all laws",
            Unsolved::Falling => {
                "a force falls with velocity or displacement so fast that a step may have several answers; take a smaller dt"
            }
        };
        f.write_str(text)
    }
}

impl std::error::Error for Unsolved {}

/// Minimises 1/2 S^T A S - S^T d over low <= S <= high, step after step.
///
/// ```
/// use slipgap_contact::contact::CoupledForces;
///
/// // A sliding contact that cannot slip here, and an impact, S <= 0.
/// let mut forces = CoupledForces::new(vec![2.0, 1.0, 1.0, 2.0], 2);
/// let [low, high] = [[-9.0, f64::NEG_INFINITY], [9.0, 0.0]];
/// let mut force = [0.0; 2];
/// forces.solve(&[1.0, -1.0], &low, &high, &[1.0, 1.0], &mut force)?;
/// assert_eq!(force, [1.0, -1.0]);
/// // The impact opens.
/// forces.solve(&[1.0, 1.0], &low, &high, &[1.0, 1.0], &mut force)?;
/// assert_eq!(force, [0.5, 0.0]);
/// # Ok::<(), slipgap_contact::contact::Unsolved>(())
/// ```
#[derive(Debug, Clone)]
pub struct CoupledForces {
    /// A of the one contact, if there is one.
    single: Option<f64>,
    pattern: ActiveSet,
    /// If A is singular: for A + SOFTENING diag(A).
    softened: Option<Box<ActiveSet>>,
    rounds: usize,
}

impl CoupledForces {
    /// `matrix`: A = H + diag(g), row-major, symmetric positive semidefinite.
    pub fn new(matrix: Vec<f64>, contacts: usize) -> CoupledForces {
        let single = (contacts == 1).then(|| matrix[0]);
        let matrix = Matrix::new(matrix, contacts);
        let pattern = ActiveSet::new(matrix.clone());
        let softened = || Box::new(ActiveSet::new(matrix.softened(SOFTENING)));
        CoupledForces {
            single,
            softened: pattern.is_singular().then(softened),
            pattern,
            rounds: 0,
        }
    }

    /// Forces of a step; the slices have one number for each contact.
    ///
    /// The limits, `low` <= `high`, may be infinite, and equal, as of an open contact. `size[i]` = |r*_i| + |c_i|, the size of the
    /// numbers that `d[i]` is the difference of; it gives the round-off. The search starts from the pattern of the last step.
    pub fn solve(
        &mut self,
        d: &[f64],
        low: &[f64],
        high: &[f64],
        size: &[f64],
        force: &mut [f64],
    ) -> Result<(), Unsolved> {
        if let Some(a) = self.single {
            self.rounds = 1;
            return self.solve_single(a, d[0], [low[0], high[0]], &mut force[0]);
        }
        let step = Step { d, low, high, size };
        self.rounds = match self.pattern.pivot(step, force) {
            Err(Unsolved::Singular) => self.solve_singular(step, force)?,
            rounds => rounds?,
        };
        Ok(())
    }

    /// Changes A_ii of one of several contacts, to another positive number.
    fn set_diagonal(&mut self, contact: usize, value: f64) {
        self.pattern.set_diagonal(contact, value);
    }

    /// Changes A_ii, A_ij and A_jj of two neighbouring contacts, j = i + 1.
    fn set_pair(&mut self, contact: usize, entries: [f64; 3]) {
        self.pattern.set_pair(contact, entries);
    }

    /// S = clip(d/A, low, high).
    fn solve_single(
        &mut self,
        a: f64,
        d: f64,
        [low, high]: [f64; 2],
        force: &mut f64,
    ) -> Result<(), Unsolved> {
        let s = d / a;
        let regular = a > 0.0 || low == high;
        let (at, s) = match s {
            _ if !regular => return Err(Unsolved::Singular),
            s if s < low || low == high => (At::Low, low),
            s if s > high => (At::High, high),
            s if s.is_nan() => return Err(Unsolved::TooManyRounds),
            s => (At::Free, s),
        };
        self.pattern.put(0, at);
        *force = s;
        Ok(())
    }

    /// The search met free contacts that are singular; the right pattern may be another one.
    ///
    /// The proximal point method finds it: S(k+1) minimises the function plus 1/2 e (S - S(k))^T diag(A) (S - S(k)), which is
    /// strictly convex; S(k) tends to a minimum of the function itself. If its free contacts are singular, too, it is not the only
    /// one.
    fn solve_singular(&mut self, step: Step, force: &mut [f64]) -> Result<usize, Unsolved> {
        let mut d = step.d.to_vec();
        let mut last = Err(Unsolved::Singular);
        for _ in 0..PROXIMAL_STEPS {
            let Some(softened) = &mut self.softened else {
                break;
            };
            let rounds = softened.pivot(Step { d: &d, ..step }, force)?;
            for (i, s) in force.iter().enumerate() {
                d[i] = step.d[i] + SOFTENING * self.pattern.diagonal(i) * s;
                self.pattern.put(i, softened.place(i));
            }
            last = self.pattern.pivot(step, force).map(|more| rounds + more);
            if last != Err(Unsolved::Singular) {
                break;
            }
        }
        last
    }

    /// Whether the force of a contact was not at a limit in the last answer.
    pub fn is_free(&self, contact: usize) -> bool {
        self.pattern.place(contact) == At::Free
    }

    /// Number of patterns that the last answer took.
    pub fn rounds(&self) -> usize {
        self.rounds
    }
}
