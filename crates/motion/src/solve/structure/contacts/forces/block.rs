//! The contact forces of a block, of all lanes together while the patterns stand.
//!
//! A contact is at its low bound, free, or at its high bound. While this pattern stands, the forces of a lane are a solution with
//! a known factor, and the pattern is right if the free forces are within their bounds and q = d - A S presses the others against
//! theirs. The lanes where it is not right solve the whole problem ([`CoupledForces`]) and keep the new pattern.

use super::lane_forces::{Contact, Scratch};
use crate::contact::{CoupledForces, Unsolved};
use crate::lane::Lane;
use crate::solve::structure::linear_part::block_matrix::MatrixBlock;

/// The forces of contacts of L structures with the same flexibility.
#[derive(Debug, Clone)]
pub(super) struct Block<const L: usize> {
    /// The contacts among all.
    pub(super) of_all: Vec<usize>,
    /// H by rows.
    flexibility: Vec<f64>,
    contacts: Vec<Contact<L>>,
    /// L of A_FF = L D L^T, by rows: row i has i entries.
    factor: Vec<Lane<L>>,
    problems: Vec<CoupledForces>,
    /// Numbers of one lane.
    scratch: Scratch,
}

impl<const L: usize> Block<L> {
    /// The contacts with H, and g and the bounds of each.
    pub(super) fn new(
        block: &MatrixBlock,
        contacts: impl Iterator<Item = (Lane<L>, [Lane<L>; 2])>,
    ) -> Self {
        let flexibility = &block.entries;
        let zero = Lane::splat(0.0);
        let contact = |(compliance, [low, high]): (Lane<L>, [Lane<L>; 2])| Contact {
            compliance,
            low,
            high,
            side: Lane::splat(1.0),
            fixed: high,
            held: zero,
            reciprocal: zero,
            free: zero,
            rest: zero,
        };
        let contacts: Vec<Contact<L>> = contacts.map(contact).collect();
        let m = contacts.len();
        let problem = |l: usize| {
            let mut matrix = flexibility.clone();
            for (i, contact) in contacts.iter().enumerate() {
                matrix[i * m + i] += contact.compliance.0[l];
            }
            CoupledForces::new(matrix, m)
        };
        let mut forces = Block {
            of_all: block.contacts.clone(),
            problems: (0..L).map(problem).collect(),
            flexibility: flexibility.clone(),
            factor: vec![zero; m * m.saturating_sub(1) / 2],
            contacts,
            scratch: Scratch(std::array::from_fn(|_| vec![0.0; m])),
        };
        forces.hold();
        forces
    }

    /// Changes the bounds of a contact; [`Block::hold`] must follow.
    #[inline(always)]
    pub(super) fn bound(&mut self, contact: usize, [low, high]: [Lane<L>; 2]) {
        let contact = &mut self.contacts[contact];
        (contact.low, contact.high) = (low, high);
    }

    /// Changes the bounds of a contact in a lane; [`Block::hold`] must follow, or [`Block::solve_lane`].
    pub(super) fn bound_lane(&mut self, [contact, l]: [usize; 2], [low, high]: [f64; 2]) {
        let contact = &mut self.contacts[contact];
        (contact.low.0[l], contact.high.0[l]) = (low, high);
    }

    /// Changes the bounds of a contact, also from finite to infinite ones; [`Block::hold`] must follow.
    #[inline(always)]
    pub(super) fn rebound(&mut self, contact: usize, bounds: [Lane<L>; 2]) {
        self.bound(contact, bounds);
        let contact = &mut self.contacts[contact];
        for l in 0..L {
            if contact.side.0[l] < 0.0 && contact.low.0[l] == f64::NEG_INFINITY {
                contact.side.0[l] = 1.0;
            }
        }
    }

    /// The bounds of a contact.
    #[inline(always)]
    pub(super) fn bounds(&self, contact: usize) -> [Lane<L>; 2] {
        let contact = &self.contacts[contact];
        [contact.low, contact.high]
    }

    /// Computes the forces at the bounds and their effect.
    #[inline(always)]
    pub(super) fn hold(&mut self) {
        let m = self.contacts.len();
        for contact in &mut self.contacts {
            for l in 0..L {
                let (low, high) = (contact.low.0[l], contact.high.0[l]);
                let side = contact.side.0[l];
                let bound = if side < 0.0 { low } else { high };
                contact.fixed.0[l] = if side == 0.0 { 0.0 } else { bound };
            }
        }
        for i in 0..m {
            let row = &self.flexibility[i * m..(i + 1) * m];
            let contact = &self.contacts[i];
            let mut held = contact.compliance * contact.fixed;
            for (h, other) in row.iter().zip(&self.contacts) {
                held = held + other.fixed * *h;
            }
            self.contacts[i].held = held;
        }
    }

    /// H of a contact with itself.
    pub(super) fn own(&self, contact: usize) -> f64 {
        self.flexibility[contact * (self.contacts.len() + 1)]
    }

    /// Writes the forces if the patterns stand. Returns the largest contradiction of each lane, above zero if its pattern is not
    /// right.
    #[inline(always)]
    pub(super) fn follow(&mut self, d: &[Lane<L>], force: &mut [Lane<L>]) -> Lane<L> {
        let m = self.contacts.len();
        let contacts = &mut self.contacts[..];
        // L y = d - A S of the fixed contacts, in the free ones; the factor has zeros in the others.
        let mut row = 0;
        for i in 0..m {
            let rest = d[i] - contacts[i].held;
            let mut y = rest;
            for (l, before) in self.factor[row..row + i].iter().zip(&contacts[..i]) {
                y = y - *l * before.free;
            }
            (contacts[i].rest, contacts[i].free) = (rest, y);
            row += i;
        }
        // L^T S = D^-1 y.
        for contact in contacts.iter_mut() {
            contact.free = contact.free * contact.reciprocal;
        }
        for i in (0..m).rev() {
            row -= i;
            let s = contacts[i].free;
            for (l, before) in self.factor[row..row + i].iter().zip(&mut contacts[..i]) {
                before.free = before.free - *l * s;
            }
        }
        let mut worst = Lane::splat(0.0);
        for i in 0..m {
            let contact = &contacts[i];
            let mut q = contact.rest - contact.compliance * contact.free;
            let of = &self.flexibility[i * m..(i + 1) * m];
            for (h, other) in of.iter().zip(&*contacts) {
                q = q - other.free * *h;
            }
            let mut excess = Lane::splat(0.0);
            for l in 0..L {
                let (s, side) = (contact.free.0[l], contact.side.0[l]);
                let (low, high) = (contact.low.0[l], contact.high.0[l]);
                let (below, above) = (low - s, s - high);
                let outside = if below > above { below } else { above };
                let pulled = if high > low { -side * q.0[l] } else { 0.0 };
                excess.0[l] = if side == 0.0 { outside } else { pulled };
            }
            worst = worst.larger(excess);
            force[i] = contact.fixed + contact.free;
        }
        worst
    }

    /// Solves the whole problem of lane `l` and keeps its pattern; without forces they are NaN.
    ///
    /// # Errors
    /// Why there are none. A motion that is not finite is not a fault of the contacts.
    #[cold]
    #[inline(never)]
    pub(super) fn solve_lane(
        &mut self,
        l: usize,
        d: &[Lane<L>],
        size: &dyn Fn(usize, usize) -> f64,
        force: &mut [Lane<L>],
    ) -> Result<(), Unsolved> {
        let Scratch([ds, lows, highs, sizes, forces]) = &mut self.scratch;
        for (i, contact) in self.contacts.iter().enumerate() {
            (ds[i], lows[i]) = (d[i].0[l], contact.low.0[l]);
            (highs[i], sizes[i]) = (contact.high.0[l], size(self.of_all[i], l));
        }
        let finite = ds.iter().all(|d| d.is_finite());
        let solved = self.problems[l].solve(ds, lows, highs, sizes, forces);
        if !finite || solved.is_err() {
            for force in force {
                force.0[l] = f64::NAN;
            }
            return if finite { solved } else { Ok(()) };
        }
        for (i, contact) in self.contacts.iter_mut().enumerate() {
            force[i].0[l] = forces[i];
            let (low, high) = (contact.low.0[l], contact.high.0[l]);
            contact.side.0[l] = match forces[i] {
                s if s <= low => -1.0,
                s if s >= high => 1.0,
                _ => 0.0,
            };
        }
        self.refactor(l);
        self.hold();
        Ok(())
    }

    /// A_FF = L D L^T of lane `l`.
    fn refactor(&mut self, l: usize) {
        let m = self.contacts.len();
        let mut start = 0;
        for i in 0..m {
            let free = self.contacts[i].side.0[l] == 0.0;
            let mut pivot = self.flexibility[i * m + i] + self.contacts[i].compliance.0[l];
            let mut before = 0;
            for j in 0..i {
                let mut a = self.flexibility[i * m + j];
                for k in 0..j {
                    a -= self.factor[start + k].0[l] * self.factor[before + k].0[l];
                }
                // L D until the row is complete; no entry where one of both contacts is not free.
                let both = free && self.contacts[j].side.0[l] == 0.0;
                self.factor[start + j].0[l] = if both { a } else { 0.0 };
                before += j;
            }
            for j in 0..i {
                let ld = self.factor[start + j].0[l];
                let entry = ld * self.contacts[j].reciprocal.0[l];
                pivot -= ld * entry;
                self.factor[start + j].0[l] = entry;
            }
            self.contacts[i].reciprocal.0[l] = if free { 1.0 / pivot } else { 0.0 };
            start += i;
        }
    }
}
