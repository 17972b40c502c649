//! Modes of the pair of bars, free and with the spring between them.
//!
//! Free, the normal coordinates q_k move r = sum a_k q_k. The spring joins them by K r^2/2, so the modes in contact are
//! the eigenvectors of diag(omega_k^2) + K a a^T: their lambda are the roots of
//!
//! ```text
//! 1 = K sum a_k^2/(lambda - omega_k^2)
//! ```
//!
//! one above each omega_k^2, and mode i has in q_k the component K psi_i a_k/(lambda_i - omega_k^2), psi_i its share in r.

use crate::system::Mode;
use libm::sqrt;

/// Normal coordinates with frequency omega_k and share in r.
#[derive(Debug, Clone)]
pub(super) struct Basis {
    pub omega: Vec<f64>,
    /// a_k > 0 in r = sum a_k q_k.
    pub share: Vec<f64>,
}

impl Basis {
    pub fn free(modes: &[Mode]) -> Basis {
        Basis {
            omega: modes.iter().map(|mode| sqrt(mode.omega2)).collect(),
            share: modes.iter().map(|mode| sqrt(mode.phi2)).collect(),
        }
    }
}

/// The modes in contact, and the way there and back.
#[derive(Debug, Clone)]
pub(super) struct Contact {
    pub basis: Basis,
    /// Row by row, the components of each mode in the free coordinates.
    shapes: Vec<Vec<f64>>,
}

/// Displacements and rates of normal coordinates.
pub(super) type Coordinates = (Vec<f64>, Vec<f64>);

impl Contact {
    pub fn new(modes: &[Mode], spring: f64) -> Contact {
        let mut basis = Basis {
            omega: Vec::new(),
            share: Vec::new(),
        };
        let mut shapes = Vec::new();
        for i in 0..modes.len() {
            // lambda - omega_k^2 for every k: from the pole below, so that it keeps its digits beside it.
            let rise = rise(modes, spring, i);
            let apart = |k: &Mode| k_apart(modes, i, k) + rise;
            let sum: f64 = modes.iter().map(|k| k.phi2 / (apart(k) * apart(k))).sum();
            let share = 1.0 / (spring * sqrt(sum));
            let component = |k: &Mode| spring * share * sqrt(k.phi2) / apart(k);
            shapes.push(modes.iter().map(component).collect());
            basis.omega.push(sqrt(modes[i].omega2 + rise));
            basis.share.push(share);
        }
        Contact { basis, shapes }
    }

    /// From free coordinates to those in contact.
    pub fn enter(&self, place: &[f64], rate: &[f64]) -> Coordinates {
        let along = |q: &[f64]| {
            let project = |shape: &Vec<f64>| shape.iter().zip(q).map(|(s, q)| s * q).sum();
            self.shapes.iter().map(project).collect()
        };
        (along(place), along(rate))
    }

    /// Back to the free ones.
    pub fn leave(&self, place: &[f64], rate: &[f64]) -> Coordinates {
        let along = |y: &[f64]| {
            let mut q = vec![0.0; y.len()];
            for (shape, y) in self.shapes.iter().zip(y) {
                for (q, s) in q.iter_mut().zip(shape) {
                    *q += s * y;
                }
            }
            q
        };
        (along(place), along(rate))
    }
}

fn k_apart(modes: &[Mode], i: usize, k: &Mode) -> f64 {
    modes[i].omega2 - k.omega2
}

/// How far root `i` of the frequency equation lies above omega_i^2.
fn rise(modes: &[Mode], spring: f64, i: usize) -> f64 {
    let excess = |rise: f64| {
        let terms = modes.iter().map(|k| k.phi2 / (k_apart(modes, i, k) + rise));
        spring * terms.sum::<f64>() - 1.0
    };
    // The last root lies below omega^2 + K a^T a, with room for round-off.
    let top = 2.0 * spring * modes.iter().map(|k| k.phi2).sum::<f64>();
    let next = modes.get(i + 1).map(|next| k_apart(modes, i, next).abs());
    let (mut low, mut high) = (0.0, next.unwrap_or(top));
    loop {
        let middle = 0.5 * (low + high);
        if !(low < middle && middle < high) {
            return middle;
        }
        if excess(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
}
