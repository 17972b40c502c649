//! The motion on a piece: u_(k+2) = M^-1 (p_k - K u_k - (k+1) C u_(k+1) - B S_k)/((k+1)(k+2)) for the Taylor coefficients of u.
//!
//! Coefficients belong to powers of s, the time from the start over the length h, so that they neither overflow nor underflow.

use super::contact_series::{ContactSeries, terms};
use super::gaps::Gaps;
use super::pressing::PressingSpring;
use crate::exact::events::coordinates::flexible::FlexibleSeries;
use crate::exact::events::coordinates::model::Model;
use crate::exact::events::numerics::bernstein::{ORDERS, Polynomial, TERMS};
use crate::exact::events::numerics::factor::Factor;
use crate::exact::events::numerics::kernel::{self, Order};
use crate::exact::events::numerics::matrix::Matrix;
use crate::exact::events::numerics::row::{LANES, Row};
use crate::exact::events::numerics::signals::{self, add_signal};
use crate::exact::events::phases::contact_state::{ContactState, Force};

/// The polynomials of a piece.
#[derive(Debug, Clone)]
pub struct Series {
    /// Time of its start.
    pub start: f64,
    /// Its length h.
    pub length: f64,
    /// Bound of the frequencies times the length.
    pub phase: f64,
    /// Number of nodes.
    nodes: usize,
    /// Number of terms of u; the others are 0.
    orders: usize,
    /// u, the coefficients of one power for all nodes together.
    pub(super) u: Vec<f64>,
    /// The polynomials of the contacts.
    pub contacts: Vec<ContactSeries>,
    /// The signals of the loads.
    pub loads: Vec<Polynomial>,
    pub(super) acceleration: Vec<f64>,
    /// Contacts at nodes without mass.
    pub flexible: Option<FlexibleSeries>,
    /// The order of this acceleration.
    order: usize,
    /// What supports move the gaps.
    pub gaps: Gaps,
    /// The springs that press friction contacts, by these contacts.
    pub springs: Vec<Vec<PressingSpring>>,
}

impl Series {
    /// StateBuffers for the motion of a structure.
    pub fn new(model: &Model) -> Series {
        let nodes = model.len();
        let contact = ContactSeries {
            r: [0.0; ORDERS],
            force: [0.0; TERMS],
            limit: [0.0; TERMS],
        };
        Series {
            start: 0.0,
            length: 0.0,
            phase: 0.0,
            nodes,
            orders: ORDERS,
            u: vec![0.0; ORDERS * nodes],
            contacts: vec![contact; model.contacts.len()],
            loads: vec![[0.0; TERMS]; model.structure.loads.len()],
            acceleration: vec![0.0; nodes],
            flexible: model
                .flexible
                .as_ref()
                .map(|f| FlexibleSeries::new(f, model.contacts.len())),
            order: 0,
            gaps: Gaps::default(),
            springs: model.pressed.iter().map(PressingSpring::of).collect(),
        }
    }

    /// Starts a piece at the time `start`: loads, limits, and the terms of order 0 and 1.
    ///
    /// `phase` is the bound of the frequencies times the length.
    pub fn begin(&mut self, model: &Model, [start, length, phase]: [f64; 3], [u, v]: [&[f64]; 2]) {
        (self.start, self.length, self.phase) = (start, length, phase);
        self.orders = terms(phase);
        let (first, second) = self.u.split_at_mut(self.nodes);
        first.copy_from_slice(u);
        for (to, v) in second.iter_mut().zip(v) {
            *to = length * v;
        }
        for (load, to) in model.structure.loads.iter().zip(&mut self.loads) {
            *to = [0.0; TERMS];
            add_signal(&load.signal, 1.0, [start, length], to);
        }
        for (i, contact) in model.contacts.iter().enumerate() {
            let limit = contact.law.limit();
            let series = &mut self.contacts[i];
            (series.r, series.force) = ([0.0; ORDERS], [0.0; TERMS]);
            series.limit =
                limit.map_or([0.0; TERMS], |limit| signals::limit(limit, [start, length]));
            series.r[0] = model.relative(i, u) + contact.gap;
            series.r[1] = length * model.relative(i, v);
        }
        self.gaps.begin(model.structure, [start, length]);
        for k in 0..2 {
            let contacts = &mut self.contacts;
            self.gaps.add_order(k, |i, term| contacts[i].r[k] += term);
        }
        self.begin_flexible(model);
    }

    /// All terms from order 0 on. `contacts` are those with [`Force::Constraint`], with the factor of their equations.
    pub fn complete(
        &mut self,
        model: &Model,
        states: &[ContactState],
        (contacts, factor): (&[usize], &Factor),
    ) {
        if contacts.is_empty() && self.complete_modes(model, states) {
            return;
        }
        let mut forces = vec![0.0; contacts.len()];
        for k in 0..self.orders - 2 {
            self.free_acceleration(k, model, states);
            if !contacts.is_empty() {
                for (force, i) in forces.iter_mut().zip(contacts) {
                    *force = self.relative_acceleration(*i, model);
                }
                factor.solve(&mut forces);
                for (force, i) in forces.iter().zip(contacts) {
                    self.apply(k, *i, *force, model);
                }
                if !model.pressed.is_empty() {
                    let place = |contact| contacts.iter().position(|i| *i == contact);
                    let force = |contact| place(contact).map(|i| forces[i]);
                    self.press_by_constraints(k, model, states, force);
                }
            }
            self.advance(k, model);
        }
    }

    /// All terms of modes without constraints and with damping by modes, in one pass for each order; false for others.
    fn complete_modes(&mut self, model: &Model, states: &[ContactState]) -> bool {
        let (Matrix::Diagonal(squares), Some(_)) = (&model.stiffness, &model.modes) else {
            return false;
        };
        let damping = match &model.damping {
            Matrix::Diagonal(damping) => Some(&damping[..]),
            Matrix::Sparse(rows) if rows.is_zero() => None,
            Matrix::Sparse(_) | Matrix::Dense(_) => return false,
        };
        let mut r = vec![[0.0; LANES]; self.contacts.len()];
        for k in 0..self.orders - 2 {
            self.forces(k, model, states);
            let loads: Vec<(f64, &[f64])> = (model.patterns.iter().zip(&self.loads))
                .filter(|(_, signal)| signal[k] != 0.0)
                .map(|(pattern, signal)| (signal[k], pattern.dense()))
                .collect();
            let contacts: Vec<(f64, &[f64])> = (model.columns.iter().zip(&self.contacts))
                .map(|(column, contact)| (contact.force[k], column.dense()))
                .collect();
            let n = self.nodes;
            let (before, next) = self.u.split_at_mut((k + 2) * n);
            let of = Order {
                squares,
                damping,
                rate: (k + 1) as f64 / self.length,
                factor: self.length * self.length / ((k + 1) * (k + 2)) as f64,
                u: [&before[k * n..(k + 1) * n], &before[(k + 1) * n..]],
                loads: &loads,
                contacts: &contacts,
            };
            kernel::order(&of, &mut next[..n], &mut r);
            for (series, r) in self.contacts.iter_mut().zip(&r) {
                series.r[k + 2] = r.iter().sum();
            }
            let contacts = &mut self.contacts;
            self.gaps
                .add_order(k + 2, |i, term| contacts[i].r[k + 2] += term);
            self.advance_flexible(k, model);
        }
        true
    }

    /// The acceleration of order k without the forces of constraints.
    pub fn free_acceleration(&mut self, k: usize, model: &Model, states: &[ContactState]) {
        self.order = k;
        self.forces(k, model, states);
        let n = self.nodes;
        let a = &mut self.acceleration;
        a.fill(0.0);
        for (pattern, signal) in model.patterns.iter().zip(&self.loads) {
            if signal[k] != 0.0 {
                pattern.add(signal[k], a);
            }
        }
        let at = |k: usize| &self.u[k * n..(k + 1) * n];
        model.stiffness.subtract_product(1.0, at(k), a);
        if !model.damping.is_zero() {
            let rate = (k + 1) as f64 / self.length;
            model.damping.subtract_product(rate, at(k + 1), a);
        }
        for (series, column) in self.contacts.iter().zip(&model.columns) {
            if series.force[k] != 0.0 {
                column.add(-series.force[k], a);
            }
        }
        for (a, w) in a.iter_mut().zip(&model.inverse_masses) {
            *a *= w;
        }
    }

    /// The forces of order k without those of constraints.
    fn forces(&mut self, k: usize, model: &Model, states: &[ContactState]) {
        for (i, state) in states.iter().enumerate() {
            let law = state.law(&model.contacts[i].law);
            self.contacts[i].force[k] = self.own_force(i, k, law);
        }
        if !model.pressed.is_empty() {
            self.press_order(k, true, model);
            for contact in model.pressed.iter().map(|pressed| pressed.contact) {
                let law = states[contact].law(&model.contacts[contact].law);
                self.contacts[contact].force[k] = self.own_force(contact, k, law);
            }
        }
        self.flexible_forces(k, model, states);
    }

    /// The force of order k that a contact has by its own motion and limit.
    pub(super) fn own_force(&self, contact: usize, k: usize, law: Force) -> f64 {
        let series = &self.contacts[contact];
        match law {
            Force::None | Force::Constraint => 0.0,
            Force::Spring {
                k: stiffness,
                origin,
            } if k == 0 => stiffness * (series.r[0] - origin),
            Force::Spring { k: stiffness, .. } => stiffness * series.r[k],
            Force::Line { slope, at, force } if k == 0 => force + slope * (series.r[0] - at),
            Force::Line { slope, .. } => slope * series.r[k],
            Force::Dashpot { c } => c * ((k + 1) as f64 / self.length) * series.r[k + 1],
            Force::Limit(direction) => direction * series.limit[k],
        }
    }

    /// r'' of a contact, of the present order.
    pub fn relative_acceleration(&self, contact: usize, model: &Model) -> f64 {
        let of_nodes = model.relative(contact, &self.acceleration);
        match self.gaps.acceleration(contact, self.order) {
            None => of_nodes,
            Some(of_gap) => of_nodes + of_gap,
        }
    }

    /// Applies the force of a constraint, of order k.
    pub fn apply(&mut self, k: usize, contact: usize, force: f64, model: &Model) {
        self.contacts[contact].force[k] = force;
        model.subtract_force(contact, force, &mut self.acceleration);
    }

    /// The terms of order k + 2 from the acceleration of order k.
    pub fn advance(&mut self, k: usize, model: &Model) {
        let factor = self.length * self.length / ((k + 1) * (k + 2)) as f64;
        let next = &mut self.u[(k + 2) * self.nodes..(k + 3) * self.nodes];
        for (next, a) in next.iter_mut().zip(&self.acceleration) {
            *next = factor * a;
        }
        for (i, series) in self.contacts.iter_mut().enumerate() {
            series.r[k + 2] = model.relative(i, next);
        }
        let contacts = &mut self.contacts;
        self.gaps
            .add_order(k + 2, |i, term| contacts[i].r[k + 2] += term);
        self.advance_flexible(k, model);
    }

    /// u and u' of all nodes at s.
    pub fn motion_at(&self, s: f64, u: &mut [f64], v: &mut [f64]) {
        kernel::motion(
            &self.u[..self.orders * self.nodes],
            [s, self.length],
            [u, v],
        );
    }

    /// A combination of u.
    pub fn combine(&self, pattern: &Row) -> Polynomial {
        std::array::from_fn(|k| {
            if k >= self.orders {
                return 0.0;
            }
            pattern.dot(&self.u[k * self.nodes..(k + 1) * self.nodes])
        })
    }

    /// The polynomial of rdot of a contact.
    pub fn rate(&self, contact: usize) -> Polynomial {
        let r = &self.contacts[contact].r;
        std::array::from_fn(|k| (k + 1) as f64 * r[k + 1] / self.length)
    }
}
