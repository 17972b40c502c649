//! Reduction of matrices by Craig and Bampton (1968): the named degrees of freedom are kept, the others follow them statically and
//! vibrate in the lowest modes of the structure with the kept ones held.
//!
//! u = T q, q = (u_b, eta), T = [I 0; -K_ii^-1 K_ib, Phi]. M, C, K and loads become T^T M T, T^T C T, T^T K T, T^T p. K is
//! K_bb - K_bi K_ii^-1 K_ib in b and omega^2 in the modes. A static load on b gives the same u_b with any number of modes.
//!
//! A kept degree of freedom without mass is not held in the modes, since T would give it a mass and M would be singular with all
//! modes. It gets the flexibility that the modes leave, without mass (MacNeal 1971).

mod basis;
mod dense;
mod fixed_interface_modes;
mod held;
mod lanczos;
mod mode;
mod rayleigh;
mod reduced;
#[cfg(test)]
mod tests;
mod vectors;

pub use fixed_interface_modes::MOST_MODES;
pub use reduced::Reduced;

use crate::system::import::Imported;
use basis::Basis;
use fixed_interface_modes::stage;
use held::Held;
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::fmt;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Which modes are kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Wanted {
    /// So many of the lowest frequencies; all if there are fewer.
    Modes(usize),
    /// Those up to this frequency, in cycles per unit of time.
    UpTo(f64),
}

/// Why there is no reduction.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ReductionFault {
    /// Nothing holds this row while the kept ones are held.
    Unheld {
        /// Name of the row.
        row: String,
    },
    /// M is not positive definite among the rows with mass.
    Mass,
    /// The modes of a large structure were not found.
    NotConverged,
    /// More modes of a large structure than [`MOST_MODES`].
    TooMany,
}

impl fmt::Display for ReductionFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ReductionFault::Unheld { row } => write!(
                f,
                "nothing holds {row} while the named dofs are held; name a dof with mass in its part, for instance as a channel"
            ),
            ReductionFault::Mass => {
                f.write_str("M is not positive definite among the dofs with mass")
            }
            ReductionFault::NotConverged => f.write_str("the modes were not found"),
            ReductionFault::TooMany => {
                write!(f, "gives too many modes, at most {MOST_MODES} are allowed")
            }
        }
    }
}

impl std::error::Error for ReductionFault {}

/// A result that one of the cases which need it makes, while the others wait for it.
type Cell<T> = OnceLock<Result<T, ReductionFault>>;

/// Matrices with the rows that stay. What the cases of a study need of it is computed once.
#[derive(Debug)]
pub struct Reduction {
    imported: Arc<Imported>,
    kept: Arc<[usize]>,
    held: Cell<Held>,
    /// By the number of modes that are computed at once.
    stages: Mutex<BTreeMap<usize, Arc<Cell<Arc<Basis>>>>>,
}

impl Reduction {
    /// The reduction that keeps these rows, which rise.
    pub fn new(imported: Arc<Imported>, kept: Vec<usize>) -> Reduction {
        Reduction {
            imported,
            kept: kept.into(),
            held: OnceLock::new(),
            stages: Mutex::default(),
        }
    }

    /// The rows that stay.
    pub fn kept(&self) -> &Arc<[usize]> {
        &self.kept
    }

    /// The reduced matrices with these modes. They do not depend on what was computed before.
    ///
    /// # Errors
    /// There is no such reduction.
    pub fn reduced(&self, wanted: Wanted) -> Result<Reduced, ReductionFault> {
        let held = self
            .held
            .get_or_init(|| Held::new(&self.imported, &self.kept))
            .as_ref()
            .map_err(Clone::clone)?;
        let most_modes = held.massive.len();
        let (basis, modes) = match wanted {
            Wanted::Modes(modes) => {
                let modes = modes.min(most_modes);
                if modes > MOST_MODES {
                    return Err(ReductionFault::TooMany);
                }
                (self.basis(held, stage(modes, most_modes))?, modes)
            }
            Wanted::UpTo(frequency) => {
                let most = (2.0 * PI * frequency) * (2.0 * PI * frequency);
                let mut size = stage(0, most_modes);
                loop {
                    let basis = self.basis(held, size)?;
                    let modes = basis
                        .omega2
                        .iter()
                        .filter(|omega2| **omega2 <= most)
                        .count();
                    if modes < basis.omega2.len() || modes == most_modes {
                        break (basis, modes);
                    }
                    if modes > MOST_MODES {
                        return Err(ReductionFault::TooMany);
                    }
                    size = stage(size, most_modes);
                }
            }
        };
        Reduced::new(basis, &self.kept, modes)
    }

    fn basis(&self, held: &Held, stage: usize) -> Result<Arc<Basis>, ReductionFault> {
        let cell = {
            let mut stages = self.stages.lock().unwrap_or_else(PoisonError::into_inner);
            stages.entry(stage).or_default().clone()
        };
        let make = || Basis::new(&self.imported, held, stage).map(Arc::new);
        cell.get_or_init(make).clone()
    }
}
