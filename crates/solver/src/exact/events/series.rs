//! The motion on a piece: u_(k+2) = M^-1 (p_k - K u_k - (k+1) C u_(k+1) - B S_k)/((k+1)(k+2)) for the Taylor coefficients of u.
//!
//! Coefficients belong to powers of s, the time from the start over the length h, so that they neither overflow nor underflow.

use super::bernstein::{Polynomial, TERMS};
use super::cholesky::Cholesky;
use super::gaps::Gaps;
use super::model::Model;
use super::phase::{ContactState, Force};
use super::signals::{self, add_signal};

/// Most terms of u.
pub const ORDERS: usize = TERMS + 2;

/// Terms of a motion without stiffness: a load that is straight in time gives a cubic.
const FEWEST: usize = 6;

/// Size of the terms left out, over the motion with the highest frequency: the round-off of double precision is larger.
const LEFT_OUT: f64 = 4e-18;

/// The polynomials of a contact.
#[derive(Debug, Clone)]
pub struct ContactSeries {
    /// r.
    pub r: [f64; ORDERS],
    /// S.
    pub force: Polynomial,
    /// The friction limit where it is positive.
    pub limit: Polynomial,
}

/// Number of terms of u for a bound of the frequencies times the length: forces have two terms less.
fn terms(phase: f64) -> usize {
    let (mut term, mut count) = (1.0, 0);
    while term > LEFT_OUT && count < TERMS {
        count += 1;
        term *= phase / count as f64;
    }
    (count + 2).max(FEWEST)
}

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
    u: Vec<f64>,
    /// The polynomials of the contacts.
    pub contacts: Vec<ContactSeries>,
    /// The signals of the loads.
    pub loads: Vec<Polynomial>,
    acceleration: Vec<f64>,
    /// The order of this acceleration.
    order: usize,
    /// What supports move the gaps.
    pub gaps: Gaps,
}

impl Series {
    /// StateBuffers for the motion of a structure.
    pub fn new(model: &Model) -> Series {
        let nodes = model.structure.len();
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
            contacts: vec![contact; model.structure.contacts.len()],
            loads: vec![[0.0; TERMS]; model.structure.loads.len()],
            acceleration: vec![0.0; nodes],
            order: 0,
            gaps: Gaps::default(),
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
        for (i, contact) in model.structure.contacts.iter().enumerate() {
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
    }

    /// All terms from order 0 on. `constraints` are the contacts with [`Force::Constraint`] and the factor of their B^T M^-1 B.
    pub fn complete(
        &mut self,
        model: &Model,
        states: &[ContactState],
        (constraints, factor): (&[usize], &Cholesky),
    ) {
        let mut forces = vec![0.0; constraints.len()];
        for k in 0..self.orders - 2 {
            self.free_acceleration(k, model, states);
            if !constraints.is_empty() {
                for (force, i) in forces.iter_mut().zip(constraints) {
                    *force = self.relative_acceleration(*i, model);
                }
                factor.solve(&mut forces);
                for (force, i) in forces.iter().zip(constraints) {
                    self.apply(k, *i, *force, model);
                }
            }
            self.advance(k, model);
        }
    }

    /// The acceleration of order k without the forces of constraints.
    pub fn free_acceleration(&mut self, k: usize, model: &Model, states: &[ContactState]) {
        let (n, structure) = (self.nodes, model.structure);
        self.order = k;
        let a = &mut self.acceleration;
        a.fill(0.0);
        for (load, signal) in structure.loads.iter().zip(&self.loads) {
            if signal[k] != 0.0 {
                for (node, factor) in &load.pattern {
                    a[*node] += factor * signal[k];
                }
            }
        }
        let at = |k: usize| &self.u[k * n..(k + 1) * n];
        let rate = (k + 1) as f64 / self.length;
        model.stiffness.subtract_product(1.0, at(k), a);
        if !model.damping.is_zero() {
            model.damping.subtract_product(rate, at(k + 1), a);
        }
        for (i, state) in states.iter().enumerate() {
            let series = &mut self.contacts[i];
            let force = match state.law(&structure.contacts[i].law) {
                Force::None | Force::Constraint => 0.0,
                Force::Spring {
                    k: stiffness,
                    origin,
                } if k == 0 => stiffness * (series.r[0] - origin),
                Force::Spring { k: stiffness, .. } => stiffness * series.r[k],
                Force::Dashpot { c } => c * rate * series.r[k + 1],
                Force::Limit(direction) => direction * series.limit[k],
            };
            series.force[k] = force;
            if force != 0.0 {
                for (node, sign) in structure.column(i) {
                    a[node] -= sign * force;
                }
            }
        }
        for (a, w) in a.iter_mut().zip(&model.inverse_masses) {
            *a *= w;
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
    }

    /// u and u' of all nodes at s.
    pub fn motion_at(&self, s: f64, u: &mut [f64], v: &mut [f64]) {
        u.fill(0.0);
        v.fill(0.0);
        for k in (1..self.orders).rev() {
            let terms = &self.u[k * self.nodes..(k + 1) * self.nodes];
            let factor = k as f64 / self.length;
            for ((u, v), term) in u.iter_mut().zip(v.iter_mut()).zip(terms) {
                *u = (*u + term) * s;
                *v = *v * s + factor * term;
            }
        }
        for (u, term) in u.iter_mut().zip(&self.u) {
            *u += term;
        }
    }

    /// A combination of u.
    pub fn combine(&self, pattern: &[(usize, f64)]) -> Polynomial {
        std::array::from_fn(|k| {
            if k >= self.orders {
                return 0.0;
            }
            let row = &self.u[k * self.nodes..];
            pattern
                .iter()
                .map(|(node, factor)| factor * row[*node])
                .sum()
        })
    }

    /// The polynomial of rdot of a contact.
    pub fn rate(&self, contact: usize) -> Polynomial {
        let r = &self.contacts[contact].r;
        std::array::from_fn(|k| (k + 1) as f64 * r[k + 1] / self.length)
    }
}
