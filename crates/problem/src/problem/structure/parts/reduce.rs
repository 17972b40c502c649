//! Reductions of matrices in a study: what is kept, with which modes, and what of it a case has.

use crate::problem::structure::given::amount::Amount;
use crate::problem::{Case, Violation};
use crate::system::import::Imported;
use crate::system::reduction::{Reduced, Reduction, Wanted};
use crate::system::structure::Direction;
use std::sync::Arc;

/// The reduction of matrices.
#[derive(Debug, Clone)]
pub struct Reduce {
    modes: Modes,
    reduction: Arc<Reduction>,
}

/// How a study says which modes are kept.
#[derive(Debug, Clone)]
pub enum Modes {
    /// Number of the lowest modes, >= 0.
    Number(Amount),
    /// Largest frequency in cycles per unit of time, > 0.
    UpTo(Amount),
}

impl Reduce {
    /// The reduction of matrices to these rows, which rise, and these modes.
    pub fn new(imported: Arc<Imported>, kept: Vec<usize>, modes: Modes) -> Reduce {
        let reduction = Arc::new(Reduction::new(imported, kept));
        Reduce { modes, reduction }
    }

    /// The reduced matrices in a case. Cases share what they have in common.
    ///
    /// # Errors
    /// A number is out of its range, or there is no such reduction.
    pub fn reduced(&self, case: &Case) -> Result<Reduced, Violation> {
        let (amount, wanted) = match &self.modes {
            Modes::Number(amount) => {
                let modes = amount.whole(case, 0, u32::MAX)?;
                (amount, Wanted::Modes(modes as usize))
            }
            Modes::UpTo(amount) => (amount, Wanted::UpTo(amount.value(case)?)),
        };
        let reduced = self.reduction.reduced(wanted);
        reduced.map_err(|why| amount.violation(why.to_string()))
    }
}

/// The displacements and velocities at t = 0 that all rows of a direction of matrices have.
#[derive(Debug, Clone, Default)]
pub struct Start {
    directions: [Vec<(Direction, f64)>; 2],
}

impl Start {
    /// Replaces what rows of a direction have by what is given of u and v.
    pub fn set(&mut self, direction: Direction, given: [Option<f64>; 2]) {
        for (list, value) in self.directions.iter_mut().zip(given) {
            if let Some(value) = value {
                list.retain(|(known, _)| *known != direction);
                list.push((direction, value));
            }
        }
    }

    /// Sets the coordinates of the modes in u and v. `nodes` are those of the kept rows and the modes; supports are at rest.
    pub fn project(&self, reduced: &Reduced, nodes: &[Option<usize>], motion: [&mut [f64]; 2]) {
        let (kept, modes) = nodes.split_at(reduced.kept().len());
        for (start, values) in self.directions.iter().zip(motion) {
            let kept = kept
                .iter()
                .map(|node| node.map_or(0.0, |node| values[node]));
            let modal = reduced.modal(&kept.collect::<Vec<_>>(), start);
            for (node, x) in modes.iter().zip(modal) {
                if let Some(node) = node {
                    values[*node] = x;
                }
            }
        }
    }
}
