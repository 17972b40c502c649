//! The critical step of methods that have one.

use crate::methods::{Method, six_digits_below};
use crate::system::structure::sparse::factor::Factor;
use crate::system::structure::{Structure, Symmetric};
use std::fmt;

/// Part by which a step may be above the critical one: round-off of both.
const ROUND_OFF: f64 = 1e-10;

/// Halvings of the range of omega^2.
const HALVINGS: usize = 60;

/// Why a method has no stable step for a structure.
#[derive(Debug, Clone, PartialEq)]
pub enum CriticalFault {
    /// A contact without compliance, with this name.
    Rigid(String),
    /// A node without mass, with this name.
    Massless(String),
    /// No step is stable with the coefficients of the method.
    Never,
    /// The step is above the critical one.
    Above {
        /// Critical step.
        critical: f64,
        /// Step.
        dt: f64,
    },
}

impl CriticalFault {
    /// The parameter that is at fault.
    pub fn parameter(&self) -> &'static str {
        match self {
            CriticalFault::Rigid(_) | CriticalFault::Massless(_) | CriticalFault::Never => "method",
            CriticalFault::Above { .. } => "dt",
        }
    }
}

impl fmt::Display for CriticalFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CriticalFault::Rigid(contact) => write!(
                f,
                "has no stable step with rigid contact, such as '{contact}'; allowed: a law with compliance, or moreau-jean"
            ),
            CriticalFault::Massless(node) => write!(
                f,
                "has no stable step with a node without mass, such as '{node}'; allowed: the other methods"
            ),
            CriticalFault::Never => f.write_str(
                "has no stable step with these coefficients, however short; newmark needs newmark_gamma >= 1/2",
            ),
            CriticalFault::Above { critical, dt } => write!(
                f,
                "must be at most {}, the critical step of this method with all contacts closed, got {dt}",
                six_digits_below(*critical)
            ),
        }
    }
}

/// The critical step of a method: its limit of omega dt over the largest omega of the structure with the springs of all contacts.
/// `None` if every step is stable.
///
/// Damping does not count. It never makes the step shorter (Hughes, The Finite Element Method, section 9.1).
pub fn critical_step(structure: &Structure, method: &Method) -> Option<f64> {
    let limit = method.stability_limit();
    if limit == f64::INFINITY {
        return None;
    }
    let stiffness = with_contacts(structure);
    let mut rows = vec![0.0; structure.len()];
    for ((i, j), value) in stiffness.entries() {
        rows[i] += value.abs();
        if i != j {
            rows[j] += value.abs();
        }
    }
    // No eigenvalue is above the largest sum of a row.
    let sums = rows.iter().zip(&structure.nodes);
    let bound = sums.map(|(sum, node)| sum / node.mass).fold(0.0, f64::max);
    if bound <= 0.0 {
        return None;
    }
    // Above it by round-off of the sums.
    let [mut low, mut high] = [0.0, bound * (1.0 + 1e-12)];
    // The sums bound the eigenvalues of lumped masses only.
    for _ in 0..if structure.coupled_mass.is_empty() {
        0
    } else {
        HALVINGS
    } {
        if is_above(structure, &stiffness, high) {
            break;
        }
        high *= 2.0;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if is_above(structure, &stiffness, middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    Some(limit / high.sqrt())
}

/// Why a structure cannot be stepped by a method; `None` if it can.
pub fn critical_fault(structure: &Structure, method: &Method, dt: f64) -> Option<CriticalFault> {
    let limit = method.stability_limit();
    if limit == f64::INFINITY {
        return None;
    }
    if limit == 0.0 {
        return Some(CriticalFault::Never);
    }
    if let Some(stop) = structure.contacts.iter().find(|c| c.law.is_stop()) {
        return Some(CriticalFault::Rigid(stop.name.clone()));
    }
    if let Some(node) = structure.nodes.iter().find(|node| node.mass == 0.0) {
        return Some(CriticalFault::Massless(node.name.clone()));
    }
    // Stable if no omega is above limit/dt: one factor instead of a search.
    let omega2 = (1.0 + ROUND_OFF) * (limit / dt) * (limit / dt);
    if is_above(structure, &with_contacts(structure), omega2) {
        return None;
    }
    let critical = critical_step(structure, method)?;
    Some(CriticalFault::Above { critical, dt })
}

/// K with the springs of the contacts.
fn with_contacts(structure: &Structure) -> Symmetric {
    let mut stiffness = structure.stiffness.clone();
    for contact in &structure.contacts {
        let k = match contact.law.line() {
            Some(line) => line.stiffness().unwrap_or(0.0),
            // The stiffness of delta^1.5 grows with an overlap that is not known: only an unstable step without it is certain.
            None => contact.law.as_given().properties().largest_stiffness(0.0),
        };
        if k > 0.0 {
            stiffness.add_along(&contact.along, k);
        }
    }
    stiffness
}

/// Whether a number is above all omega^2: omega^2 M - K is positive definite.
fn is_above(structure: &Structure, stiffness: &Symmetric, omega2: f64) -> bool {
    let n = structure.len();
    let mut matrix = Symmetric::zeros(n);
    structure.add_mass(omega2, &mut matrix);
    matrix.add_matrix(stiffness, -1.0);
    Factor::new(&matrix, &vec![false; n]).is_ok()
}
