//! A structure with its kept degrees of freedom held: what its other degrees of freedom do.

use super::ReductionFault;
use crate::system::import::Imported;
use crate::system::structure::Symmetric;
use crate::system::structure::sparse::factor::Factor;

/// A pivot below this part of its diagonal is round-off: the matrix is singular.
const SINGULAR: f64 = 1e-13;

/// The rows of matrices by what a reduction does with them.
///
/// K_ff is the stiffness of the rows that are not held. A kept row without mass is free, too: held, it would get a mass from the
/// rows that follow it.
#[derive(Debug)]
pub(super) struct Held {
    /// Number of rows.
    pub(super) size: usize,
    /// Kept rows with mass, and rows of supports.
    pub(super) held: Vec<usize>,
    /// The other rows.
    pub(super) free: Vec<usize>,
    /// Kept rows without mass, by their places among the free ones.
    pub(super) loose: Vec<usize>,
    /// Free rows with mass, by their places.
    pub(super) massive: Vec<usize>,
    /// Free rows without mass, by their places.
    pub(super) massless: Vec<usize>,
    /// M of the free rows.
    pub(super) mass: Symmetric,
    /// K of the free rows.
    pub(super) stiffness: Symmetric,
    /// The factor of K of the free rows.
    pub(super) factor: Factor,
    /// Displacements of the free rows for a displacement of 1 of each held row: -K_ff^-1 K_fh.
    pub(super) constrained: Vec<Vec<f64>>,
    /// Displacements of the free rows for a force of 1 on each loose row: columns of K_ff^-1.
    pub(super) attached: Vec<Vec<f64>>,
}

impl Held {
    /// The rows of these matrices, of which `kept` are named.
    ///
    /// # Errors
    /// Something that nothing holds is left free.
    pub(super) fn new(imported: &Imported, kept: &[usize]) -> Result<Held, ReductionFault> {
        let size = imported.len();
        let has_mass = imported.mass.nonzero_rows();
        let rows = imported.dofs.rows();
        let is_kept = |row: &usize| kept.binary_search(row).is_ok();
        let is_held =
            |row: &usize| is_kept(row) && (has_mass[*row] || rows[*row].support.is_some());
        let (held, free): (Vec<usize>, Vec<usize>) = (0..size).partition(is_held);
        let places_where = |is: &dyn Fn(&usize) -> bool| -> Vec<usize> {
            let places = free.iter().enumerate().filter(|(_, row)| is(row));
            places.map(|(index, _)| index).collect()
        };
        let stiffness = imported.stiffness.block(&free);
        let factor = Factor::regular(&stiffness, SINGULAR).map_err(|why| {
            let row = imported.dofs.name(free[why.row]);
            ReductionFault::Unheld { row }
        })?;
        let mut constrained = vec![vec![0.0; free.len()]; held.len()];
        for ((i, j), k) in imported.stiffness.entries() {
            for (row, column) in [(i, j), (j, i)] {
                if let (Ok(row), Ok(column)) =
                    (free.binary_search(&row), held.binary_search(&column))
                {
                    constrained[column][row] -= k;
                }
            }
        }
        constrained
            .iter_mut()
            .for_each(|column| factor.solve(column));
        let loose = places_where(&is_kept);
        let attached = loose.iter().map(|index| {
            let mut force = vec![0.0; free.len()];
            force[*index] = 1.0;
            factor.solve(&mut force);
            force
        });
        Ok(Held {
            size,
            attached: attached.collect(),
            massive: places_where(&|row| has_mass[*row]),
            massless: places_where(&|row| !has_mass[*row]),
            mass: imported.mass.block(&free),
            stiffness,
            factor,
            constrained,
            loose,
            held,
            free,
        })
    }
}
