//! The steps to the equilibrium K u + B S = p of a structure with its contacts.
//!
//! Contacts alone may hold a part, so that K may be singular. The equilibrium is therefore the limit of the steps
//!
//! ```text
//! (K + W) (u' - u) + B (S' - S) = p - K u - B S,   r' = r + B^T (u' - u),   W = q M + sum of k_c B_c B_c^T
//! ```
//!
//! (the proximal point method, Rockafellar 1976). The laws give S' as in one long step from the start of the load, whatever the steps
//! to it, and without velocity. What is left out of the equilibrium is W (u' - u), which tells when the steps may end. k_c is a small
//! part of the stiffness of a contact, so that neither the units nor the masses change the number of steps. Where they converge
//! slowly, W is made smaller: that of a contact which yields follows its present stiffness. With a regular K, W is 0.

mod check;
mod falls;
mod idle;
mod newton;
mod proximal_step;
mod weights;

use crate::contact::Unsolved;
use crate::contact::plane::length;
use crate::solve::Unsolvable;
use crate::solve::structure::contacts::curved::contact::Memory;
use crate::solve::structure::contacts::curved::contacts::Curved;
use crate::system::structure::sparse::factor::negative_pivot;
use crate::system::structure::{PlaneRow, Structure, Symmetric};
use weights::{
    LARGE, Linear, Weights, curved, diagonal, first_q, holds, largest, linear, softens, stiffened,
    stiffnesses,
};

/// Part of W at slow convergence, and what slow is: the part of the residual that a step leaves.
const LESS: f64 = 0.01;
const SLOW: f64 = 0.1;

/// Smallest part of the first W.
const LEAST: f64 = 1e-12;

/// Change of forces and displacements, over the largest ones, from which on one step more leaves round-off only.
const TARGET: f64 = 1e-11;

/// Round-off of a solution and of its contact forces, some fifty times the unit round-off.
const ROUND_OFF: f64 = 1e-14;

/// Part of the largest force that may be left at nodes and in laws that carry next to nothing, where the steps leave no less.
const LOOSE: f64 = 1e-9;

/// Steps after which Newton's are tried, and again after twice as many.
const FIRST: usize = 8;

/// Steps in balance after which what still moves is round-off.
const STEADY: usize = 3;

/// Most steps for a load. With W 100 times smaller after each slow one, a dozen reach round-off.
const STEPS: usize = 100;

/// Most steps where a negative stiffness keeps W above a number.
const STEPS_OF_NEGATIVE: usize = 2000;

/// The steps to equilibrium.
pub(crate) struct Equilibrium<'a> {
    structure: &'a Structure,
    massless: Vec<bool>,
    /// M, and a weight of nodes without mass beside it, which contacts alone may hold, too.
    mass: Symmetric,
    /// Whether K has a negative pivot.
    is_negative: bool,
    weights: Weights,
    linear: Linear,
    pub(crate) curved: Curved,
    pub(crate) u: Vec<f64>,
    pub(crate) forces: Vec<f64>,
    /// u, S and the memory of the laws at the start of the load.
    start: (Vec<f64>, Vec<f64>, Vec<Memory>),
    /// Largest u of a step without contact forces, of whose round-off no change tells anything.
    free: f64,
    /// The first of these.
    reach: f64,
    /// The largest stiffness, with which forces have the round-off of u.
    stiffest: f64,
}

impl<'a> Equilibrium<'a> {
    /// `smaller`: how often W becomes larger at most, until laws that fall have one answer.
    fn with(structure: &'a Structure, smaller: usize) -> Result<Equilibrium<'a>, Unsolvable> {
        let mut mass = structure.mass();
        let massless = structure.massless();
        let contact_stiffnesses = stiffnesses(structure);
        let stiffened = stiffened(structure, &contact_stiffnesses);
        let m = structure.contacts.len();
        let mut weights = Weights {
            q: 0.0,
            contacts: vec![0.0; m],
            part: 1.0,
        };
        if !holds(&structure.stiffness, &stiffened) {
            weights.q = first_q(structure, &stiffened);
            weights.contacts = contact_stiffnesses.iter().map(|k| k / LARGE).collect();
        }
        let is_negative = negative_pivot(&structure.stiffness).is_some();
        if is_negative {
            weights.enlarge(structure, &mass);
        }
        for (node, k) in diagonal(&stiffened).into_iter().enumerate() {
            if massless[node] && weights.q > 0.0 {
                mass.add(node, node, k / (LARGE * weights.q));
            }
        }
        let begin = |weights: &Weights| -> Result<_, Unsolvable> {
            let linear = linear(structure, &mass, weights)?;
            let curved = curved(structure, &linear.columns);
            Ok((linear, curved))
        };
        let (mut linear, mut curved) = begin(&weights)?;
        for _ in 0..smaller {
            if !softens(&curved) {
                break;
            }
            weights.q = match weights.q > 0.0 {
                true => weights.q / LESS,
                false => first_q(structure, &stiffened),
            };
            (linear, curved) = begin(&weights)?;
        }
        let (u, forces) = (structure.displacement.clone(), vec![0.0; m]);
        Ok(Equilibrium {
            structure,
            massless,
            mass,
            is_negative,
            weights,
            linear,
            start: (u.clone(), forces.clone(), curved.memory()),
            curved,
            u,
            forces,
            free: 0.0,
            reach: 0.0,
            stiffest: largest(&diagonal(&stiffened)),
        })
    }

    /// Finds the equilibrium with a part of the load.
    fn find(&mut self, part: f64) -> Result<(), Unsolvable> {
        let scaled = self.structure.preload.load.iter().map(|p| part * p);
        let load: Vec<f64> = scaled.collect();
        self.start = (self.u.clone(), self.forces.clone(), self.curved.memory());
        match self.search(&load) {
            Err(_) if self.refine(&load) => Ok(()),
            other => other,
        }
    }

    /// The steps to it.
    fn search(&mut self, load: &[f64]) -> Result<(), Unsolvable> {
        let first = self.weights.clone();
        let (mut before, mut near, mut least) = (f64::INFINITY, false, false);
        let mut steady = 0;
        let mut last = vec![0.0; load.len()];
        let steps = match self.is_negative {
            true => STEPS_OF_NEGATIVE,
            false => STEPS,
        };
        for number in 1..=steps {
            let forces = self.forces.clone();
            let change = match self.step(load) {
                Ok(change) => change,
                // Round-off of a W that is too small.
                Err(Unsolved::Singular) if !least && self.weights.part < first.part => {
                    least = true;
                    self.weights = first.clone();
                    self.renew()?;
                    near = false;
                    continue;
                }
                Err(why) => return Err(Unsolvable::NoForces { step: 0, why }),
            };
            let size = largest(load).max(largest(&self.forces));
            let residual = self.left_out(&change);
            let differences = forces.iter().zip(&self.forces).map(|(a, b)| (a - b).abs());
            let moved = differences.fold(0.0, f64::max);
            // Nodes without mass have a place of their own only where contacts press; `balance` finds it.
            let of_masses = change.iter().zip(&self.massless);
            let changes = of_masses.filter(|(_, massless)| !**massless);
            let largest_change = changes.fold(0.0, |most: f64, (x, _)| most.max(x.abs()));
            let round_off = ROUND_OFF * self.free;
            let still = largest_change <= (TARGET * largest(&self.u)).max(round_off);
            let of_forces = (TARGET * size).max(self.stiffest * 0.1 * round_off);
            let balanced = moved <= of_forces && residual <= of_forces;
            let reached = still && balanced;
            steady = if balanced { steady + 1 } else { 0 };
            let is_due = reached && near || steady > STEADY;
            near = reached;
            if is_due && self.fault(load, 0.0).is_none() {
                return Ok(());
            }
            if number >= FIRST && number.is_power_of_two() && self.refine(load) {
                return Ok(());
            }
            if is_due && !self.has_no_memory() && self.fault(load, LOOSE).is_none() {
                return Ok(());
            }
            if !balanced && !least && residual > SLOW * before {
                self.soften(&forces, &change)?;
            }
            (before, last) = (residual, change);
        }
        let moved = last.iter().enumerate();
        let node = moved.max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()));
        let name = |(node, _): (usize, &f64)| self.structure.nodes[node].name.clone();
        let node = node.map_or(String::new(), name);
        Err(Unsolvable::NoEquilibrium { node })
    }

    /// The largest force of W (u' - u).
    fn left_out(&self, change: &[f64]) -> f64 {
        let mut left = vec![0.0; change.len()];
        self.mass.add_product(change, &mut left);
        left.iter_mut().for_each(|x| *x *= self.weights.q);
        for (c, k) in self.weights.contacts.iter().enumerate() {
            let force = k * self.structure.relative(c, change);
            for (node, factor) in self.structure.column(c) {
                left[node] += factor * force;
            }
        }
        largest(&left)
    }

    /// Makes W smaller, of contacts down to a part of the stiffness that they had in the last step.
    fn soften(&mut self, before: &[f64], change: &[f64]) -> Result<(), Unsolvable> {
        let weights = &mut self.weights;
        if weights.q == 0.0 || weights.part <= LEAST {
            return Ok(());
        }
        let larger = weights.clone();
        weights.part *= LESS;
        weights.q *= LESS;
        for (c, k) in stiffnesses(self.structure).into_iter().enumerate() {
            let moved = self.structure.relative(c, change).abs();
            let secant = (self.forces[c] - before[c]).abs() / moved;
            let present = if secant.is_nan() { k } else { secant };
            let weight = &mut weights.contacts[c];
            *weight = weight.min(present.max(weights.part * k) / LARGE);
        }
        match self.renew() {
            Ok(true) => {}
            Err(why) if !self.is_negative => return Err(why),
            // A negative stiffness and laws that fall keep W above a number.
            Ok(false) | Err(_) => self.weights = larger,
        }
        Ok(())
    }

    /// Refuses a contact that the load breaks loose: where it comes to rest depends on the motion.
    pub(crate) fn refuse_loose(&self) -> Result<(), Unsolvable> {
        let size = |c: usize, row: Option<PlaneRow>| match row {
            None => self.forces[c].abs(),
            Some(PlaneRow::First) => length([self.forces[c], self.forces[c + 1]]),
            Some(PlaneRow::Second) => length([self.forces[c - 1], self.forces[c]]),
        };
        for (c, contact) in self.structure.contacts.iter().enumerate() {
            let ratio = contact.law.static_ratio();
            let limit = contact.law.limit().map_or(0.0, |limit| self.pressed(limit));
            if ratio > 1.0 && size(c, contact.law.row()) >= ratio * limit * (1.0 - TARGET) {
                let name = &contact.name;
                return Err(Unsolvable::BrokenRules(format!(
                    "the static loads break contact '{name}' loose: where it comes to rest depends on the motion; apply them as loads in time, or choose static_ratio 1"
                )));
            }
        }
        Ok(())
    }

    /// Takes over a new W, if steps have one answer with it; returns whether they have.
    fn renew(&mut self) -> Result<bool, Unsolvable> {
        let linear = linear(self.structure, &self.mass, &self.weights)?;
        let curved = curved(self.structure, &linear.columns);
        let has_one = !softens(&curved);
        if has_one {
            (self.linear, self.curved) = (linear, curved);
        }
        Ok(has_one)
    }
}
