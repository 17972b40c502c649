//! The reduced matrices with the modes of a case.

use super::ReductionFault;
use super::basis::{Basis, Damping, OfDirection};
use crate::system::structure::{Direction, Symmetric};
use nalgebra::{DMatrix, DMatrixView};
use std::f64::consts::PI;
use std::sync::Arc;

/// Reduced matrices: the kept rows, then the modes.
#[derive(Debug, Clone)]
pub struct Reduced {
    basis: Arc<Basis>,
    kept: Arc<[usize]>,
    modes: usize,
    loose: Option<Loose>,
}

/// The forces on loose rows, f = stiffness displacement q.
#[derive(Debug, Clone)]
struct Loose {
    /// What a loose row is displaced beyond the held rows and the modes, for each coordinate q.
    displacement: DMatrix<f64>,
    /// The force that displaces it, the inverse of the flexibility that the modes leave, times `displacement`.
    force: DMatrix<f64>,
}

impl Reduced {
    pub(super) fn new(
        basis: Arc<Basis>,
        kept: &Arc<[usize]>,
        modes: usize,
    ) -> Result<Reduced, ReductionFault> {
        let mut reduced = Reduced {
            basis,
            kept: kept.clone(),
            modes,
            loose: None,
        };
        if !reduced.basis.loose.is_empty() {
            reduced.loose = Some(reduced.loose().ok_or(ReductionFault::Mass)?);
        }
        Ok(reduced)
    }

    /// The rows that stay.
    pub fn kept(&self) -> &Arc<[usize]> {
        &self.kept
    }

    /// Number of modes.
    pub fn modes(&self) -> usize {
        self.modes
    }

    /// Number of kept rows and modes.
    pub fn len(&self) -> usize {
        self.kept.len() + self.modes
    }

    /// Whether nothing is left.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Frequencies in cycles per unit of time: of the last mode, and of the first that is left out.
    pub fn frequencies(&self) -> [Option<f64>; 2] {
        let frequency = |mode: usize| {
            let omega2 = self.basis.omega2.get(mode)?;
            Some(omega2.sqrt() / (2.0 * PI))
        };
        [
            self.modes.checked_sub(1).and_then(frequency),
            frequency(self.modes),
        ]
    }

    /// Number of all modes of the structure with the kept rows held.
    pub fn all_modes(&self) -> usize {
        self.basis.all
    }

    /// M. Kept rows without mass have none.
    pub fn mass(&self) -> Symmetric {
        let mut mass = Symmetric::zeros(self.len());
        let held = self.places(&self.basis.held);
        for (i, row) in held.iter().enumerate() {
            for (j, column) in held[..=i].iter().enumerate() {
                mass.add(*row, *column, self.basis.mass[(i, j)]);
            }
            for mode in 0..self.modes {
                let m = self.basis.mass[(held.len() + mode, i)];
                mass.add(self.kept.len() + mode, *row, m);
            }
        }
        for mode in self.kept.len()..self.len() {
            mass.add(mode, mode, 1.0);
        }
        mass
    }

    /// K.
    pub fn stiffness(&self) -> Symmetric {
        let mut stiffness = Symmetric::zeros(self.len());
        let held = self.places(&self.basis.held);
        for (i, row) in held.iter().enumerate() {
            for (j, column) in held[..=i].iter().enumerate() {
                stiffness.add(*row, *column, self.basis.stiffness[(i, j)]);
            }
        }
        for (mode, omega2) in self.basis.omega2.iter().take(self.modes).enumerate() {
            stiffness.add(self.kept.len() + mode, self.kept.len() + mode, *omega2);
        }
        if let Some(Loose {
            displacement,
            force,
        }) = &self.loose
        {
            let of_held = displacement.transpose() * force;
            add_lower(of_held.as_view(), &mut stiffness);
        }
        stiffness
    }

    /// C, if there is one.
    pub fn damping(&self) -> Option<Symmetric> {
        let mut damping = Symmetric::zeros(self.len());
        match self.basis.damping.as_ref()? {
            Damping::Rayleigh([mass, stiffness]) => {
                damping.add_matrix(&self.mass(), *mass);
                damping.add_matrix(&self.stiffness(), *stiffness);
            }
            Damping::Full(matrix) => {
                let square = matrix.view((0, 0), (self.len(), self.len()));
                match self.loose {
                    None => add_lower(square, &mut damping),
                    Some(_) => {
                        let transformation = self.transformation();
                        let product = transformation.transpose() * square * &transformation;
                        add_lower(product.as_view(), &mut damping);
                    }
                }
            }
        }
        Some(damping)
    }

    /// T^T 1: forces of 1 on all rows of a direction.
    pub fn forces(&self, direction: Direction) -> Vec<f64> {
        self.reduced(direction, |of| &of.unit)
    }

    /// T^T M 1: the inertia of all rows of a direction for an acceleration of 1.
    pub fn inertia(&self, direction: Direction) -> Vec<f64> {
        self.reduced(direction, |of| &of.inertia)
    }

    /// The modal coordinates of a displacement, the nearest in the product with M: `kept` in the kept rows, in the others the numbers
    /// of their directions.
    pub fn modal(&self, kept: &[f64], of_directions: &[(Direction, f64)]) -> Vec<f64> {
        let held = self.places(&self.basis.held);
        let coordinate = |mode: usize| {
            let followed = held
                .iter()
                .enumerate()
                .map(|(i, column)| self.basis.coupling[(mode, i)] * kept[*column]);
            let others = of_directions.iter().filter_map(|(direction, u)| {
                let of = self
                    .basis
                    .directions
                    .iter()
                    .find(|inertia| inertia.direction == *direction);
                Some(of?.modal[mode] * u)
            });
            others.sum::<f64>() - followed.sum::<f64>()
        };
        (0..self.modes).map(coordinate).collect()
    }

    /// A vector of the basis in the coordinates of the case.
    fn reduced(&self, direction: Direction, which: impl Fn(&OfDirection) -> &Vec<f64>) -> Vec<f64> {
        let of_direction = self
            .basis
            .directions
            .iter()
            .find(|known| known.direction == direction);
        let Some(inertia) = of_direction.map(which) else {
            return vec![0.0; self.len()];
        };
        // Without loose rows the coordinates are those of the basis.
        if self.loose.is_none() {
            return inertia[..self.len()].to_vec();
        }
        let transformation = self.transformation();
        let column = |column: usize| {
            let terms = transformation.column(column);
            terms.iter().zip(inertia).map(|(a, b)| a * b).sum()
        };
        (0..self.len()).map(column).collect()
    }

    /// Places of rows among the kept ones.
    fn places(&self, rows: &[usize]) -> Vec<usize> {
        let column = |row: &usize| self.kept.binary_search(row).ok();
        rows.iter().filter_map(column).collect()
    }

    /// The displacements of the basis as combinations for each coordinate.
    fn transformation(&self) -> DMatrix<f64> {
        let (held, loose) = (self.basis.held.len(), self.basis.loose.len());
        let mut transformation = DMatrix::zeros(held + loose + self.modes, self.len());
        for (row, column) in self.places(&self.basis.held).into_iter().enumerate() {
            transformation[(row, column)] = 1.0;
        }
        for mode in 0..self.modes {
            transformation[(held + loose + mode, self.kept.len() + mode)] = 1.0;
        }
        if let Some(Loose { force, .. }) = &self.loose {
            transformation
                .view_mut((held, 0), (loose, self.len()))
                .copy_from(force);
            // What the modes have of the displacement by the forces.
            for mode in 0..self.modes {
                for column in 0..self.len() {
                    let terms = (0..loose).map(|i| self.shape(i, mode) * force[(i, column)]);
                    let sum: f64 = terms.sum();
                    transformation[(held + loose + mode, column)] -= sum / self.basis.omega2[mode];
                }
            }
        }
        transformation
    }

    /// Displacement of a loose row in a mode.
    fn shape(&self, loose: usize, mode: usize) -> f64 {
        let first = self.basis.held.len() + self.basis.loose.len();
        self.basis.loose_displacement[(loose, first + mode)]
    }

    /// The loose rows; `None` if the modes leave them no flexibility.
    fn loose(&self) -> Option<Loose> {
        let (held, loose) = (self.basis.held.len(), self.basis.loose.len());
        let of = &self.basis.loose_displacement;
        let mut displacement = DMatrix::zeros(loose, self.len());
        for (column, kept) in self.places(&self.basis.held).into_iter().enumerate() {
            for i in 0..loose {
                displacement[(i, kept)] = -of[(i, column)];
            }
        }
        for (i, column) in self.places(&self.basis.loose).into_iter().enumerate() {
            displacement[(i, column)] = 1.0;
        }
        for mode in 0..self.modes {
            for i in 0..loose {
                displacement[(i, self.kept.len() + mode)] = -self.shape(i, mode);
            }
        }
        let flexibility = DMatrix::from_fn(loose, loose, |i, j| {
            let mode =
                |mode: usize| self.shape(i, mode) * self.shape(j, mode) / self.basis.omega2[mode];
            let of_modes: f64 = (0..self.modes).map(mode).sum();
            0.5 * (of[(i, held + j)] + of[(j, held + i)]) - of_modes
        });
        let force = flexibility.cholesky()?.solve(&displacement);
        Some(Loose {
            displacement,
            force,
        })
    }
}

/// Adds the entries on and below the diagonal.
fn add_lower(from: DMatrixView<f64>, to: &mut Symmetric) {
    for j in 0..from.ncols() {
        for i in j..from.nrows() {
            if from[(i, j)] != 0.0 {
                to.add(i, j, from[(i, j)]);
            }
        }
    }
}
