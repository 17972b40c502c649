//! The matrices of a structure in the displacements that a reduction consists of.

use super::ReductionFault;
use super::fixed_interface_modes::lowest;
use super::held::Held;
use super::mode::Mode;
use super::rayleigh::rayleigh;
use super::vectors::dot;
use crate::system::import::Imported;
use crate::system::structure::{Direction, Symmetric};
use nalgebra::DMatrix;

/// The matrices in these displacements: Y = [held rows, loose rows, modes].
///
/// The displacement of a held row is 1 there and what follows it statically; that of a loose row is by a force of 1 on it.
#[derive(Debug)]
pub(super) struct Basis {
    /// Squares of the circular frequencies of the modes, rising.
    pub(super) omega2: Vec<f64>,
    /// Number of all modes of the structure.
    pub(super) all: usize,
    /// Rows held, and loose rows.
    pub(super) held: Vec<usize>,
    /// See `held`.
    pub(super) loose: Vec<usize>,
    /// Y^T M Y without the loose rows: the columns of the held rows. In the modes it is 1.
    pub(super) mass: DMatrix<f64>,
    /// Y^T K Y of the held rows. In the modes it is omega^2; between both it is 0.
    pub(super) stiffness: DMatrix<f64>,
    /// C, if there is one.
    pub(super) damping: Option<Damping>,
    /// Displacements of the loose rows in Y.
    pub(super) loose_displacement: DMatrix<f64>,
    /// Phi^T M of the free rows times the displacements of the held rows.
    pub(super) coupling: DMatrix<f64>,
    /// What belongs to each direction of the rows.
    pub(super) directions: Vec<OfDirection>,
}

/// Damping of the matrices.
#[derive(Debug)]
pub(super) enum Damping {
    /// Factors of M and K.
    Rayleigh([f64; 2]),
    /// Y^T C Y.
    Full(DMatrix<f64>),
}

/// Vectors of a direction: 1 in its rows, 0 in the others.
#[derive(Debug)]
pub(super) struct OfDirection {
    /// The direction.
    pub(super) direction: Direction,
    /// Y^T of a force 1 on each row, and on each tie.
    pub(super) unit: Vec<f64>,
    /// Y^T M 1.
    pub(super) inertia: Vec<f64>,
    /// Phi^T M of the free rows times 1.
    pub(super) modal: Vec<f64>,
}

impl Basis {
    /// That of matrices with so many modes.
    pub(super) fn new(
        imported: &Imported,
        of: &Held,
        modes: usize,
    ) -> Result<Basis, ReductionFault> {
        let modes = lowest(of, modes)?;
        let columns = columns(of, &modes);
        let (held, loose) = (of.held.len(), of.loose.len());
        let with_mass: Vec<&[f64]> = columns
            .iter()
            .enumerate()
            .filter(|(row, _)| !(held..held + loose).contains(row))
            .map(|(_, column)| &column[..])
            .collect();
        let vectors: Vec<&[f64]> = columns.iter().map(|column| &column[..]).collect();
        let mass = projected(&imported.mass, &with_mass, &with_mass[..held]);
        let stiffness = projected(&imported.stiffness, &vectors[..held], &vectors[..held]);
        let damping = imported.damping.as_ref().map(|c| {
            match rayleigh(c, &imported.mass, &imported.stiffness) {
                Some(factors) => Damping::Rayleigh(factors),
                None => Damping::Full(projected(c, &vectors, &vectors)),
            }
        });
        let shapes: Vec<&[f64]> = modes.iter().map(|mode| &mode.shape[..]).collect();
        let constrained: Vec<&[f64]> = of.constrained.iter().map(|column| &column[..]).collect();
        let coupling = projected(&of.mass, &shapes, &constrained);
        let loose_displacement = DMatrix::from_fn(loose, columns.len(), |row, column| {
            columns[column][of.free[of.loose[row]]]
        });
        let directions = Direction::ALL.into_iter().filter_map(|direction| {
            let rows = imported.dofs.rows().iter();
            let one: Vec<f64> = rows
                .map(|dof| f64::from(u8::from(dof.direction == direction)))
                .collect();
            let free: Vec<f64> = of.free.iter().map(|row| one[*row]).collect();
            let mut inertia = vec![0.0; of.size];
            imported.mass.add_product(&one, &mut inertia);
            let mut of_free = vec![0.0; free.len()];
            of.mass.add_product(&free, &mut of_free);
            let products =
                |of: &[&[f64]], with: &[f64]| of.iter().map(|vector| dot(vector, with)).collect();
            let forces = imported.dofs.forces(direction);
            let is_there = forces.iter().any(|force| *force != 0.0);
            is_there.then(|| OfDirection {
                direction,
                unit: products(&vectors, &forces),
                inertia: products(&vectors, &inertia),
                modal: products(&shapes, &of_free),
            })
        });
        Ok(Basis {
            directions: directions.collect(),
            omega2: modes.iter().map(|mode| mode.omega2).collect(),
            all: of.massive.len(),
            held: of.held.clone(),
            loose: of.loose.iter().map(|row| of.free[*row]).collect(),
            mass,
            stiffness,
            damping,
            loose_displacement,
            coupling,
        })
    }
}

/// The columns of Y over all rows.
fn columns(of: &Held, modes: &[Mode]) -> Vec<Vec<f64>> {
    let whole = |free_values: &[f64]| {
        let mut column = vec![0.0; of.size];
        for (row, x) in of.free.iter().zip(free_values) {
            column[*row] = *x;
        }
        column
    };
    let held = of
        .held
        .iter()
        .zip(&of.constrained)
        .map(|(row, free_shape)| {
            let mut column = whole(free_shape);
            column[*row] = 1.0;
            column
        });
    let attached = of.attached.iter().map(|free_shape| whole(free_shape));
    let modes = modes.iter().map(|mode| whole(&mode.shape));
    held.chain(attached).chain(modes).collect()
}

/// rows^T matrix columns.
fn projected(matrix: &Symmetric, rows: &[&[f64]], columns: &[&[f64]]) -> DMatrix<f64> {
    let mut projected = DMatrix::zeros(rows.len(), columns.len());
    for (j, column) in columns.iter().enumerate() {
        let mut product = vec![0.0; matrix.size()];
        matrix.add_product(column, &mut product);
        for (i, row) in rows.iter().enumerate() {
            projected[(i, j)] = dot(row, &product);
        }
    }
    projected
}
