//! Newton's steps to the equilibrium of contacts without memory, where the weights W leave too much round-off.
//!
//! No mass enters: K du + B dS = p - K u - B S at the nodes, and for each contact one of
//!
//! ```text
//! B^T du - e dS = -r          without compliance, closed
//! f' B^T du - dS = S - f(r)   with compliance
//! dS = -S                     open, or at its limit
//! ```
//!
//! A small e keeps the matrix regular where more contacts hold a part than are needed; it is in no result, since steps go on until
//! they change nothing. Which contacts without compliance are closed follows from S and r (Hintermueller, Ito and Kunisch 2002).

use super::Equilibrium;
use super::weights::largest;
use crate::contact::ContactKind;
use nalgebra::{DMatrix, DVector};

/// Most steps.
const STEPS: usize = 60;

/// Most unknowns of the full matrix.
const LARGEST: usize = 600;

/// e, and half the width of the chord for f', as part of the displacement over the force.
const SMALL: f64 = 1e-10;

/// Part of r that is half the width of a chord.
const WIDTH: f64 = 1e-6;

/// Change of u and S over the largest ones at which the steps end.
const TARGET: f64 = 1e-15;

impl Equilibrium<'_> {
    /// Whether the present forces follow from displacements alone.
    pub(super) fn has_no_memory(&self) -> bool {
        let mut contacts = self.structure.contacts.iter();
        contacts.all(|contact| {
            let law = &contact.law;
            let is_impact = law.kind() == ContactKind::Impact;
            let limit = law.limit();
            let is_fixed =
                limit.is_none_or(|limit| limit.pressed_by.is_none() && limit.static_ratio == 1.0);
            law.row().is_none() && is_fixed && (is_impact || !law.is_curved())
        })
    }

    /// Goes from the present state to the equilibrium with this load; the state stays if that fails.
    pub(super) fn refine(&mut self, load: &[f64]) -> bool {
        let size = self.u.len() + self.forces.len();
        if size > LARGEST || !self.has_no_memory() {
            return false;
        }
        let before = (self.u.clone(), self.forces.clone());
        for step in 0..STEPS {
            let Some(change) = self.newton(load, step == 0) else {
                break;
            };
            let (du, ds) = change.as_slice().split_at(self.u.len());
            self.u.iter_mut().zip(du).for_each(|(u, x)| *u += x);
            self.forces.iter_mut().zip(ds).for_each(|(s, x)| *s += x);
            let is_small =
                |change: &[f64], values: &[f64]| largest(change) <= TARGET * largest(values);
            if is_small(du, &self.u) && is_small(ds, &self.forces) {
                break;
            }
        }
        let found = self.fault(load, 0.0).is_none();
        if !found {
            (self.u, self.forces) = before;
        }
        found
    }

    /// du and dS of one step. In the first one, what presses is closed: r may still be round-off of W.
    fn newton(&self, load: &[f64], is_first: bool) -> Option<DVector<f64>> {
        let (structure, n) = (self.structure, self.u.len());
        let size = n + self.forces.len();
        let force = largest(load);
        let soft = self.reach / force;
        let mut matrix = DMatrix::zeros(size, size);
        let mut right = DVector::zeros(size);
        right.rows_mut(0, n).copy_from_slice(load);
        for ((i, j), k) in structure.stiffness.entries() {
            matrix[(i, j)] = k;
            matrix[(j, i)] = k;
            right[i] -= k * self.u[j];
            if i != j {
                right[j] -= k * self.u[i];
            }
        }
        for (c, contact) in structure.contacts.iter().enumerate() {
            let (row, s) = (n + c, self.forces[c]);
            let change = structure.relative(c, &self.u) - structure.relative(c, &self.start.0);
            for (node, factor) in structure.column(c) {
                matrix[(node, row)] += factor;
                right[node] -= factor * s;
            }
            // What must be 0 for the contact to hold, the slope of its force, and what dS is without one.
            let (slope, rest) = if contact.law.is_rigid() {
                let is_impact = contact.law.kind() == ContactKind::Impact;
                let r = match is_impact {
                    true => structure.relative(c, &self.u) + contact.gap,
                    false => change,
                };
                let [low, high] = self.curved.bounds(c);
                let held = if is_first { s } else { s + r / soft };
                match low < held && held < high {
                    true => (f64::INFINITY, -r),
                    false => (0.0, held.clamp(low, high) - s),
                }
            } else {
                let width = WIDTH * change.abs() + SMALL * SMALL * self.reach;
                let [below, at, above] =
                    [-width, 0.0, width].map(|x| self.curved.follow(c, change + x));
                ((above - below) / (2.0 * width), at - s)
            };
            // The row is divided by the slope where that is large.
            let [by_r, by_s, rest] = match slope * soft > 1.0 {
                true if slope == f64::INFINITY => [1.0, -SMALL * soft, rest],
                true => [1.0, -1.0 / slope, -rest / slope],
                false => [slope, -1.0, -rest],
            };
            for (node, factor) in structure.column(c) {
                matrix[(row, node)] += by_r * factor;
            }
            matrix[(row, row)] = by_s;
            right[row] = rest;
        }
        // A body that nothing touches and no load moves stays.
        for i in 0..n {
            if right[i] == 0.0 && matrix.row(i).iter().all(|x| *x == 0.0) {
                matrix[(i, i)] = 1.0;
            }
        }
        let change = matrix.lu().solve(&right)?;
        change.iter().all(|x| x.is_finite()).then_some(change)
    }
}
