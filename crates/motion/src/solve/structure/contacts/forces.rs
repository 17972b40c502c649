//! The contact forces of a step, of all lanes together while the patterns stand.
//!
//! A contact is at its low bound, free, or at its high bound. While this pattern stands, the forces of a lane are a solution with
//! a known factor, and the pattern is right if the free forces are within their bounds and q = d - A S presses the others against
//! theirs. The lanes where it is not right solve the whole problem ([`CoupledForces`]) and keep the new pattern.

use super::lane_forces::{Contact, Scratch};
use crate::contact::{CoupledForces, Unsolved};
use crate::lane::Lane;

/// The forces of the contacts of L structures with the same flexibility.
#[derive(Debug, Clone)]
pub(crate) struct Forces<const L: usize> {
    /// H by rows.
    flexibility: Vec<f64>,
    contacts: Vec<Contact<L>>,
    /// L of A_FF = L D L^T, by rows: row i has i entries.
    factor: Vec<Lane<L>>,
    problems: Vec<CoupledForces>,
    /// The first step at which a lane has no forces, and why.
    failures: [Option<(usize, Unsolved)>; L],
    /// Lanes whose forces are found elsewhere.
    others: Option<[bool; L]>,
    /// Numbers of one lane.
    scratch: Scratch,
}

impl<const L: usize> Forces<L> {
    /// The contacts with H, by rows, and g and the bounds of each.
    pub(crate) fn new(
        flexibility: &[f64],
        contacts: impl Iterator<Item = (Lane<L>, [Lane<L>; 2])>,
    ) -> Self {
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
            let mut matrix = flexibility.to_vec();
            for (i, contact) in contacts.iter().enumerate() {
                matrix[i * m + i] += contact.compliance.0[l];
            }
            CoupledForces::new(matrix, m)
        };
        let mut forces = Forces {
            problems: (0..L).map(problem).collect(),
            flexibility: flexibility.to_vec(),
            factor: vec![zero; m * m.saturating_sub(1) / 2],
            contacts,
            failures: [None; L],
            others: None,
            scratch: Scratch(std::array::from_fn(|_| vec![0.0; m])),
        };
        forces.hold();
        forces
    }

    /// Changes the bounds of a contact; [`Forces::hold`] must follow.
    #[inline(always)]
    pub(crate) fn bound(&mut self, contact: usize, [low, high]: [Lane<L>; 2]) {
        let contact = &mut self.contacts[contact];
        (contact.low, contact.high) = (low, high);
    }

    /// Changes the bounds of a contact in a lane; [`Forces::hold`] must follow, or [`Forces::solve_lane`].
    pub(crate) fn bound_lane(&mut self, [contact, l]: [usize; 2], [low, high]: [f64; 2]) {
        let contact = &mut self.contacts[contact];
        (contact.low.0[l], contact.high.0[l]) = (low, high);
    }

    /// Changes the bounds of a contact, also from finite to infinite ones; [`Forces::hold`] must follow.
    #[inline(always)]
    pub(crate) fn rebound(&mut self, contact: usize, bounds: [Lane<L>; 2]) {
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
    pub(crate) fn bounds(&self, contact: usize) -> [Lane<L>; 2] {
        let contact = &self.contacts[contact];
        [contact.low, contact.high]
    }

    /// Computes the forces at the bounds and their effect.
    #[inline(always)]
    pub(crate) fn hold(&mut self) {
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
            let own = &self.contacts[i];
            let mut held = own.compliance * own.fixed;
            for (h, other) in row.iter().zip(&self.contacts) {
                held = held + other.fixed * *h;
            }
            self.contacts[i].held = held;
        }
    }

    /// The first step at which a lane has no forces, and why.
    pub(crate) fn failures(&self) -> [Option<(usize, Unsolved)>; L] {
        self.failures
    }

    /// Leaves these lanes out.
    pub(crate) fn leave(&mut self, lanes: [bool; L]) {
        self.others = lanes.contains(&true).then_some(lanes);
    }

    /// H of a contact with itself.
    pub(crate) fn own(&self, contact: usize) -> f64 {
        self.flexibility[contact * (self.contacts.len() + 1)]
    }

    /// Records that a lane has no forces at a step.
    pub(crate) fn fail(&mut self, lane: usize, step: usize, why: Unsolved) {
        self.failures[lane].get_or_insert((step, why));
    }

    /// Writes the forces of a step for d = r* - c; `size` gives the size of the terms of d of a contact in a lane.
    #[inline(always)]
    pub(crate) fn solve(
        &mut self,
        step: usize,
        d: &[Lane<L>],
        size: impl Fn(usize, usize) -> f64,
        force: &mut [Lane<L>],
    ) {
        let mut excess = self.follow(d, force);
        if let Some(others) = self.others {
            for (excess, other) in excess.0.iter_mut().zip(others) {
                *excess = if other { 0.0 } else { *excess };
            }
        }
        let mut stands = true;
        for excess in excess.0 {
            stands &= excess <= 0.0;
        }
        if !stands {
            for l in 0..L {
                if excess.0[l] > 0.0 {
                    self.solve_lane([l, step], d, &size, force);
                }
            }
        }
    }

    /// Writes the forces if the patterns stand. Returns the largest contradiction of each lane, above zero if its pattern is not
    /// right.
    #[inline(always)]
    fn follow(&mut self, d: &[Lane<L>], force: &mut [Lane<L>]) -> Lane<L> {
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
            let own = &contacts[i];
            let mut q = own.rest - own.compliance * own.free;
            let of = &self.flexibility[i * m..(i + 1) * m];
            for (h, other) in of.iter().zip(&*contacts) {
                q = q - other.free * *h;
            }
            let mut excess = Lane::splat(0.0);
            for l in 0..L {
                let (s, side) = (own.free.0[l], own.side.0[l]);
                let (low, high) = (own.low.0[l], own.high.0[l]);
                let (below, above) = (low - s, s - high);
                let outside = if below > above { below } else { above };
                let pulled = if high > low { -side * q.0[l] } else { 0.0 };
                excess.0[l] = if side == 0.0 { outside } else { pulled };
            }
            worst = worst.larger(excess);
            force[i] = own.fixed + own.free;
        }
        worst
    }

    /// Solves the whole problem of lane `l` and keeps its pattern.
    #[cold]
    #[inline(never)]
    pub(crate) fn solve_lane(
        &mut self,
        [l, step]: [usize; 2],
        d: &[Lane<L>],
        size: &dyn Fn(usize, usize) -> f64,
        force: &mut [Lane<L>],
    ) {
        let Scratch([ds, lows, highs, sizes, forces]) = &mut self.scratch;
        for (i, contact) in self.contacts.iter().enumerate() {
            (ds[i], lows[i]) = (d[i].0[l], contact.low.0[l]);
            (highs[i], sizes[i]) = (contact.high.0[l], size(i, l));
        }
        // A motion that is not finite is not a fault of the contacts.
        let finite = ds.iter().all(|d| d.is_finite());
        let solved = self.problems[l].solve(ds, lows, highs, sizes, forces);
        if !finite || solved.is_err() {
            if let (true, Err(why)) = (finite, solved) {
                self.fail(l, step, why);
            }
            for force in force {
                force.0[l] = f64::NAN;
            }
            return;
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
