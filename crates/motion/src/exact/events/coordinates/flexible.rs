//! Contacts at nodes without mass.
//!
//! The rows s of K without mass hold at every instant: K_ss u_s = p_s - B_s S - K_sr u_r. So r = B^T u_r + G p - F S + D u_p, with B, G
//! of the condensed structure, the compliance F = B_s^T K_ss^-1 B_s, and u_p of plates: nodes that only contacts hold, where D^T S
//! = p_p. Contacts that share such nodes have coupled forces: those that are linear in r in their phases come from one small system,
//! those at their limit are known.

use crate::exact::events::numerics::bernstein::{Polynomial, TERMS};
use crate::exact::events::numerics::least::Singular;
use crate::exact::events::phases::contact_state::{ContactState, Force};
use crate::system::structure::Contact;
use nalgebra::{DMatrix, DVector, Dyn, LU};

/// What nodes without mass add to contacts.
#[derive(Debug, Clone, Default)]
pub struct Flexible {
    /// The contacts at such nodes.
    pub contacts: Vec<usize>,
    /// F, by rows of all contacts.
    pub compliance: DMatrix<f64>,
    /// D, contacts by plates.
    pub plates: DMatrix<f64>,
    /// G, contacts by loads.
    pub gaps: DMatrix<f64>,
    /// The loads of plates, plates by loads.
    pub plate_loads: DMatrix<f64>,
    /// u of the plates at t = 0.
    pub start: Vec<f64>,
}

impl Flexible {
    /// The stiffness of a contact in series with its nodes.
    pub fn stiffness_of(&self, contact: usize, k: f64) -> f64 {
        1.0 / (1.0 / k + self.compliance[(contact, contact)])
    }

    /// Whether the force of a contact at a node without mass moves others at once.
    pub fn is_shared(&self, contact: usize) -> bool {
        let others = self.contacts.iter().filter(|other| **other != contact);
        self.contacts.contains(&contact)
            && (others
                .map(|other| self.compliance[(contact, *other)])
                .any(|f| f != 0.0)
                || self.plates.row(contact).iter().any(|x| *x != 0.0))
    }

    /// The contacts in these phases whose force is linear in r, and the matrix of the equations for their forces and the plates.
    fn equations(
        &self,
        contacts: &[Contact],
        states: &[ContactState],
    ) -> (Vec<usize>, DMatrix<f64>) {
        let linear = |i: &usize| matches!(states[*i].law(&contacts[*i].law), Force::Spring { .. });
        let closed: Vec<usize> = self.contacts.iter().copied().filter(linear).collect();
        let (m, plates) = (closed.len(), self.plates.ncols());
        let mut matrix = DMatrix::zeros(m + plates, m + plates);
        for (row, i) in closed.iter().enumerate() {
            for (column, j) in closed.iter().enumerate() {
                matrix[(row, column)] = self.compliance[(*i, *j)];
            }
            if let Force::Spring { k, .. } = states[*i].law(&contacts[*i].law) {
                matrix[(row, row)] += 1.0 / k;
            }
            for plate in 0..plates {
                matrix[(row, m + plate)] = -self.plates[(*i, plate)];
                matrix[(m + plate, row)] = self.plates[(*i, plate)];
            }
        }
        (closed, matrix)
    }

    /// A bound of what these contacts add to the largest eigenvalue of K, from |b_i^T b_j| of all contacts: the trace of B P B^T,
    /// where forces are P r.
    pub fn bound(&self, contacts: &[Contact], states: &[ContactState], couplings: &[f64]) -> f64 {
        let (closed, matrix) = self.equations(contacts, states);
        if closed.is_empty() {
            return 0.0;
        }
        let Some(inverse) = matrix.try_inverse() else {
            return f64::INFINITY;
        };
        let mut sum = 0.0;
        for (row, i) in closed.iter().enumerate() {
            for (column, j) in closed.iter().enumerate() {
                sum += inverse[(row, column)].abs() * couplings[i * contacts.len() + j];
            }
        }
        sum
    }

    /// S^T F S.
    pub fn stored(&self, states: &[ContactState]) -> f64 {
        let force = DVector::from_iterator(states.len(), states.iter().map(|state| state.force));
        force.dot(&(&self.compliance * &force))
    }

    /// A row of loads as a polynomial.
    pub fn combine(factors: nalgebra::DMatrixView<f64>, loads: &[Polynomial]) -> Polynomial {
        let mut sum = [0.0; TERMS];
        for (factor, load) in factors.iter().zip(loads) {
            for (sum, load) in sum.iter_mut().zip(load) {
                *sum += factor * load;
            }
        }
        sum
    }
}

/// The forces of such contacts and the motion of the plates on a piece.
#[derive(Debug, Clone, Default)]
pub struct FlexibleSeries {
    /// r without the parts of forces and plates, of each contact.
    pub free: Vec<[f64; TERMS + 2]>,
    /// r of each contact at the start of the piece, from the piece before.
    pub known: Vec<f64>,
    /// u of the plates.
    pub plates: Vec<Polynomial>,
    /// p of the plates.
    pub loads: Vec<Polynomial>,
    /// Contacts whose force is linear in r.
    closed: Vec<usize>,
    factor: Option<LU<f64, Dyn, Dyn>>,
}

impl FlexibleSeries {
    /// Nothing has moved.
    pub fn new(flexible: &Flexible, contacts: usize) -> FlexibleSeries {
        let plates = flexible.plates.ncols();
        FlexibleSeries {
            free: vec![[0.0; TERMS + 2]; contacts],
            plates: vec![[0.0; TERMS]; plates],
            loads: vec![[0.0; TERMS]; plates],
            ..FlexibleSeries::default()
        }
    }

    /// Prepares the forces of contacts in these phases.
    pub fn couple(
        &mut self,
        flexible: &Flexible,
        contacts: &[Contact],
        states: &[ContactState],
    ) -> Result<(), Singular> {
        let matrix;
        (self.closed, matrix) = flexible.equations(contacts, states);
        self.factor = None;
        if !matrix.is_empty() {
            let factor = matrix.lu();
            if !factor.is_invertible() {
                return Err(Singular);
            }
            self.factor = Some(factor);
        }
        Ok(())
    }

    /// The forces and r of order k; `force` and `r` have a number for each contact, and forces at their limits are known.
    pub fn solve(
        &mut self,
        k: usize,
        flexible: &Flexible,
        origins: impl Fn(usize) -> f64,
        force: &mut [f64],
        r: &mut [f64],
    ) {
        let m = self.closed.len();
        let plates = self.plates.len();
        for i in &self.closed {
            force[*i] = 0.0;
        }
        let known = |i: usize, force: &[f64]| -> f64 {
            let others = flexible.contacts.iter();
            others
                .map(|j| flexible.compliance[(i, *j)] * force[*j])
                .sum()
        };
        let mut x = DVector::zeros(m + plates);
        for (row, i) in self.closed.iter().enumerate() {
            let origin = if k == 0 { origins(*i) } else { 0.0 };
            x[row] = self.free[*i][k] - origin - known(*i, force);
        }
        for plate in 0..plates {
            let limits = flexible
                .contacts
                .iter()
                .map(|i| flexible.plates[(*i, plate)] * force[*i]);
            x[m + plate] = self.loads[plate][k] - limits.sum::<f64>();
        }
        if let Some(factor) = &self.factor {
            factor.solve_mut(&mut x);
        }
        for (row, i) in self.closed.iter().enumerate() {
            force[*i] = x[row];
        }
        for (plate, u) in self.plates.iter_mut().enumerate() {
            u[k] = x[m + plate];
        }
        for i in &flexible.contacts {
            let moved = (self.plates.iter().enumerate())
                .map(|(plate, u)| flexible.plates[(*i, plate)] * u[k]);
            r[*i] = self.free[*i][k] + moved.sum::<f64>() - known(*i, force);
        }
    }
}
