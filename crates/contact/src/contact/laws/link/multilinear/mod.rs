//! A yielding part with a table of deflection and force.

use crate::contact::prelude::*;
mod described;
mod shared;
mod table;

use std::ops::Deref;

/// Most bends of a table, both sides together where they are not the same.
pub(super) const MOST: usize = 6;

/// A yielding part whose first loading follows a table of r and S, straight between its points and beyond the last one.
///
/// It is a spring beside elastic parts that yield one after the other (Iwan 1966): at every bend of the table a part k_j yields, and
/// the slope falls by k_j. So the slope must not rise away from r = 0. Unloading follows the first loading in twice its size
/// (Masing 1926), and small loops close. A table that is not symmetric has parts that yield at another force in each direction; both
/// sides begin with one slope. OpenSees has the symmetric law as `MultiLinear`.
///
/// With the stretch x_j of each part, S = k r + sum k_j x_j, and x_j follows r between -d_j and e_j, the bends. The parts are in the order of
/// their bends, and yield in this order from any state. A step with r' = y - h S' is the line of all parts that do not yield: with the
/// first j of them yielding, dr (1 + h K_j) = y - r - h (S + sum of those k_i u_i), u_i the way to the bend, K_j the sum of k
/// and the others. The first j for which dr is below u_j is the root, because both sides rise.
///
/// The part stores k r^2/2 + sum k_j x_j^2/2. r and S alone tell the least of it, k r^2/2 + (S - k r)^2/(2 sum k_j): the rest counts as
/// dissipated until it is given back. While x_j is at its bend the part j dissipates k_j x_j dr.
///
/// Its numbers live as long as the program, and equal laws share them: a law of every kind is copied for each case, and these are four
/// times as many as those of any other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Multilinear(&'static Parts);

/// The numbers of the law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parts {
    /// k >= 0 of the spring: the slope beyond the last bend.
    pub stiffness: f64,
    /// k_j; 0 beyond the last part.
    pub parts: [f64; MOST],
    /// -d_j and e_j, rising in size; infinite where a part does not yield.
    pub bends: [[f64; MOST]; 2],
}

/// The law over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    laws: [Multilinear; L],
    /// Flexibilities for S(i) and S(i+1).
    h: [Lane<L>; 2],
}

/// The stretch of each part, from the first step on.
#[derive(Debug, Clone, Copy, Default)]
pub struct Stretches<const L: usize> {
    parts: [Lane<L>; MOST],
    begun: bool,
}

impl Deref for Multilinear {
    type Target = Parts;

    fn deref(&self) -> &Parts {
        self.0
    }
}

impl Multilinear {
    /// The law of a table, with rising r.
    ///
    /// # Errors
    /// The table is none of a yielding part.
    pub fn new(table: &[[f64; 2]]) -> Result<Multilinear, LawFault> {
        Ok(Multilinear(shared::shared(table::parts_of(table)?)))
    }

    /// Sum of all k_j.
    fn yielding(&self) -> f64 {
        self.parts.iter().sum()
    }

    /// S for these stretches.
    pub fn force(&self, r: f64, stretch: &[f64; MOST]) -> f64 {
        let parts = self.parts.iter().zip(stretch);
        self.stiffness * r + parts.map(|(k, x)| k * x).sum::<f64>()
    }

    /// The stretches of a first loading to r.
    pub fn first(&self, r: f64) -> [f64; MOST] {
        let [low, high] = self.bends;
        std::array::from_fn(|j| r.clamp(low[j], high[j]))
    }

    /// r(i+1) - r(i) from these stretches, for y - r, with the flexibility for S(i+1).
    fn change(&self, r: f64, stretch: &[f64; MOST], free: f64, h: f64) -> f64 {
        let rest = free - h * self.force(r, stretch);
        let up = rest > 0.0;
        let [low, high] = self.bends;
        let mut slope = self.stiffness + self.yielding();
        let mut yielded = 0.0;
        for (j, k) in self.parts.iter().enumerate() {
            let way = if up { high[j] } else { low[j] } - stretch[j];
            let change = (rest - h * yielded) / (1.0 + h * slope);
            if if up { change <= way } else { change >= way } {
                return change;
            }
            yielded += k * way;
            slope -= k;
        }
        (rest - h * yielded) / (1.0 + h * self.stiffness)
    }
}

impl StoredEnergy for Multilinear {
    fn stored_energy(&self, r: f64, s: f64) -> f64 {
        let (k, yielding) = (self.stiffness, self.yielding());
        let rest = s - k * r;
        // A straight table has no parts.
        let parts = match yielding > 0.0 {
            true => rest * rest / yielding,
            false => 0.0,
        };
        0.5 * (k * r * r + parts)
    }
}

impl Law for Multilinear {
    type Step<const L: usize> = Step<L>;

    #[inline(always)]
    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        Step {
            laws: *laws,
            h: [on.start.h, on.end.h],
        }
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = Stretches<L>;

    #[inline(always)]
    fn force(&self, trial: &Trial<L>, stretches: &mut Stretches<L>) -> Lane<L> {
        let free = trial.change - trial.force * self.h[0];
        let mut force = free;
        for (l, law) in self.laws.iter().enumerate() {
            let r = trial.displacement.0[l];
            let mut part_forces = stretches.parts.map(|part| part.0[l]);
            if !stretches.begun {
                part_forces = law.first(r);
            }
            let change = law.change(r, &part_forces, free.0[l], self.h[1].0[l]);
            let [low, high] = law.bends;
            for (j, part) in stretches.parts.iter_mut().enumerate() {
                part_forces[j] = (part_forces[j] + change).clamp(low[j], high[j]);
                part.0[l] = part_forces[j];
            }
            force.0[l] = law.force(r + change, &part_forces);
        }
        stretches.begun = true;
        force
    }
}
