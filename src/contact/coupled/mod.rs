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

mod factor;
mod pattern;

use pattern::{At, Pattern, Step};
use std::fmt;

/// Rounds that change all wrong contacts although these have not become fewer.
const TRIES: usize = 3;

/// Why a step has no forces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unsolved {
    /// Contacts without a stiffness or damping depend on each other, so that their forces are not unique.
    Singular,
    /// No pattern is right: a number is not finite, or the matrix is not positive semidefinite.
    TooManyRounds,
}

impl fmt::Display for Unsolved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Unsolved::Singular => {
                "the contact forces are not unique: contacts that stick or are shut at the same time depend on each other"
            }
            Unsolved::TooManyRounds => "no contact forces satisfy all laws",
        })
    }
}

impl std::error::Error for Unsolved {}

/// Minimises 1/2 S^T A S - S^T d over low <= S <= high, step after step.
///
/// ```
/// use slipgap::contact::CoupledForces;
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
/// # Ok::<(), slipgap::contact::Unsolved>(())
/// ```
#[derive(Debug, Clone)]
pub struct CoupledForces {
    /// A of the one contact, if there is one.
    single: Option<f64>,
    contacts: usize,
    pattern: Pattern,
    rounds: usize,
}

impl CoupledForces {
    /// `matrix`: A = H + diag(g), row-major, symmetric positive semidefinite.
    pub fn new(matrix: Vec<f64>, contacts: usize) -> CoupledForces {
        CoupledForces {
            single: (contacts == 1).then(|| matrix[0]),
            contacts,
            pattern: Pattern::new(matrix, contacts),
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
        // The same code with a known number of contacts is up to three times as fast.
        match self.contacts {
            2 => self.pivot(2, step, force),
            3 => self.pivot(3, step, force),
            4 => self.pivot(4, step, force),
            5 => self.pivot(5, step, force),
            6 => self.pivot(6, step, force),
            contacts => self.pivot(contacts, step, force),
        }
    }

    #[inline(always)]
    fn pivot(&mut self, contacts: usize, step: Step, force: &mut [f64]) -> Result<(), Unsolved> {
        let Step { d, low, high, size } = step;
        let [d, low, high, size] = [d, low, high, size].map(|x| &x[..contacts]);
        let step = Step { d, low, high, size };
        let force = &mut force[..contacts];
        self.pattern.adapt(contacts, step);
        let [mut least, mut left] = [self.contacts + 1, TRIES];
        for round in 1..=self.most_rounds() {
            self.rounds = round;
            if !self.pattern.factor() {
                return Err(Unsolved::Singular);
            }
            if !self.pattern.follow(contacts, step, force) {
                return Err(Unsolved::TooManyRounds);
            }
            let mut last = None;
            let mut wrong = 0;
            for i in 0..contacts {
                if let Some(at) = self.pattern.better_place(i, step, force) {
                    last = Some((i, at));
                    wrong += 1;
                }
            }
            let Some((i, at)) = last else {
                let unique = self.pattern.is_unique(step, force);
                return unique.then_some(()).ok_or(Unsolved::Singular);
            };
            if wrong < least {
                [least, left] = [wrong, TRIES];
            } else if left > 0 {
                left -= 1;
            } else {
                self.pattern.put(i, at);
                continue;
            }
            self.change_all(step, force);
        }
        Err(Unsolved::TooManyRounds)
    }

    /// Changes the places of all wrong contacts.
    fn change_all(&mut self, step: Step, force: &[f64]) {
        for i in 0..self.contacts {
            if let Some(at) = self.pattern.better_place(i, step, force) {
                self.pattern.put(i, at);
            }
        }
    }

    /// S = clip(d/A, low, high).
    fn solve_single(
        &mut self,
        a: f64,
        d: f64,
        [low, high]: [f64; 2],
        force: &mut f64,
    ) -> Result<(), Unsolved> {
        let s = if low == high { low } else { d / a };
        let (at, s) = match s {
            s if s < low => (At::Low, low),
            s if s > high => (At::High, high),
            s => (At::Free, s),
        };
        self.pattern.put(0, at);
        *force = s;
        if s.is_nan() {
            Err(Unsolved::TooManyRounds)
        } else if a > 0.0 || low == high {
            Ok(())
        } else {
            Err(Unsolved::Singular)
        }
    }

    /// Far more than a step has ever needed; the rule of Murty has no small bound.
    fn most_rounds(&self) -> usize {
        1000 + 100 * self.contacts
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
