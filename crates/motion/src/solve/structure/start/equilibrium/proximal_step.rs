//! One proximal step to the equilibrium.

use super::Equilibrium;
use super::weights::{LONG, add, largest};
use crate::contact::Unsolved;
use crate::solve::structure::contacts::curved::step::Motion;
use crate::system::structure::Limit;

impl Equilibrium<'_> {
    /// One step; returns u' - u.
    pub(super) fn step(&mut self, load: &[f64]) -> Result<Vec<f64>, Unsolved> {
        let structure = self.structure;
        let mut inner = vec![0.0; load.len()];
        structure.stiffness.add_product(&self.u, &mut inner);
        for (c, force) in self.forces.iter().enumerate() {
            for (node, factor) in structure.column(c) {
                inner[node] += factor * force;
            }
        }
        let left = load.iter().zip(&inner).map(|(p, inner)| p - inner);
        let mut change: Vec<f64> = left.collect();
        self.linear.factor.solve(&mut change);
        // From the start of the load, without the contact forces of the end.
        let (u, forces, laws) = &self.start;
        let mut whole: Vec<f64> = change.iter().zip(&self.u).map(|(x, u)| u + x).collect();
        for (column, force) in self.linear.columns.iter().zip(&self.forces) {
            add(&mut whole, column, *force);
        }
        whole.iter_mut().zip(u).for_each(|(x, start)| *x -= start);
        self.free = self.free.max(largest(&whole));
        if self.reach == 0.0 {
            self.reach = self.free;
        }
        self.curved.recall(laws.iter().copied());
        for (c, contact) in structure.contacts.iter().enumerate() {
            let changes = |limit: &&Limit| limit.pressed_by.is_some() || limit.static_ratio > 1.0;
            if let Some(limit) = contact.law.limit().filter(changes) {
                let held = contact.law.static_ratio() * self.pressed(limit);
                self.curved.limit(c, held);
            }
        }
        let motion = |c: usize| {
            let displacement = structure.relative(c, u) + structure.contacts[c].gap;
            let change = structure.relative(c, &whole);
            Motion {
                displacement,
                velocity: 0.0,
                force: forces[c],
                change,
                rate: change / LONG,
                size: displacement.abs() + change.abs(),
                terms: [0.0; 2],
            }
        };
        let solved = self.curved.solve(motion)?;
        for ((column, force), new) in self.linear.columns.iter().zip(&mut self.forces).zip(solved) {
            add(&mut change, column, *force - new);
            *force = *new;
        }
        add(&mut self.u, &change, 1.0);
        Ok(change)
    }

    /// The limit with the present forces.
    pub(super) fn pressed(&self, limit: &Limit) -> f64 {
        let at_rest = |node: usize| [self.u[node], 0.0];
        limit.pressed_in(0.0, |other| self.forces[other], at_rest)
    }
}
