//! What supports that move do to the gaps of contacts on a piece.

use crate::exact::events::numerics::bernstein::{ORDERS, Polynomial, TERMS};
use crate::system::structure::Structure;

/// The change of each gap since rest as a polynomial of a piece; nothing without supports that move.
#[derive(Debug, Clone, Default)]
pub struct Gaps {
    length: f64,
    polynomials: Vec<[f64; ORDERS]>,
}

impl Gaps {
    /// Those of a piece.
    pub fn begin(&mut self, structure: &Structure, [start, length]: [f64; 2]) {
        if structure.supports.is_empty() {
            return;
        }
        self.length = length;
        self.polynomials = vec![[0.0; ORDERS]; structure.contacts.len()];
        for support in &structure.supports {
            let u: [f64; ORDERS] = support.motion.taylor([start, length]);
            for (polynomial, factor) in self.polynomials.iter_mut().zip(&support.gaps) {
                for (to, u) in polynomial.iter_mut().zip(u) {
                    *to += factor * u;
                }
            }
        }
    }

    /// Adds the term of order k of each contact; `to` gives the number of a contact.
    pub fn add_order(&self, k: usize, mut to: impl FnMut(usize, f64)) {
        for (contact, polynomial) in self.polynomials.iter().enumerate() {
            to(contact, polynomial[k]);
        }
    }

    /// The change of a gap at s and its rate; `None` without supports that move.
    pub fn at(&self, contact: usize, s: f64) -> Option<[f64; 2]> {
        let polynomial = self.polynomials.get(contact)?;
        let [mut gap, mut rate] = [0.0; 2];
        for (k, term) in polynomial.iter().enumerate().rev() {
            gap = gap * s + term;
            if k > 0 {
                rate = rate * s + k as f64 * term / self.length;
            }
        }
        Some([gap, rate])
    }

    /// The term of order k of the second derivative of a gap; `None` without supports that move.
    pub fn acceleration(&self, contact: usize, k: usize) -> Option<f64> {
        let term = self.polynomials.get(contact)?.get(k + 2)?;
        Some(((k + 1) * (k + 2)) as f64 * term / (self.length * self.length))
    }

    /// The change of a gap for the energy book; `None` without supports that move.
    pub fn polynomial(&self, contact: usize) -> Option<Polynomial> {
        let polynomial = self.polynomials.get(contact)?;
        Some(std::array::from_fn::<f64, TERMS, _>(|k| polynomial[k]))
    }
}
