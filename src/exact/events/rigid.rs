//! Constraints of rigid contacts that stick or are shut, and impulses.
//!
//! Impulses minimise 1/2 J^T A J - J^T d, J <= 0, A = B^T M^-1 B, with d = (1 + e) rdot of contacts that close. A finite friction
//! limit has no impulse.

use super::book::Book;
use super::cholesky::{Cholesky, regular};
use super::model::Model;
use super::phase::{ContactState, Phase, is_rigid};
use super::scales::Scales;
use super::series::Series;
use crate::contact::CoupledForces;
use crate::system::structure::Relation;

/// Impacts with a smaller |rdot|, over the largest velocity, accumulate: the contact shuts.
const SHUT: f64 = 1e-9;

/// The system cannot be solved: the contacts that stick depend on each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Singular;

/// The contacts with constraints, and the factor of their A.
#[derive(Debug, Clone, Default)]
pub struct Constraints {
    contacts: Vec<usize>,
    factor: Cholesky,
}

impl Constraints {
    /// The constraints of these phases.
    pub fn new(model: &Model, states: &[ContactState]) -> Result<Constraints, Singular> {
        let contacts = model.structure.contacts.iter().zip(states).enumerate();
        let closed = contacts
            .filter(|(_, (contact, state))| is_rigid(&contact.law) && state.phase == Phase::Closed);
        let contacts: Vec<usize> = closed.map(|(i, _)| i).collect();
        let factor =
            Cholesky::of_any(model.flexibility(&contacts), contacts.len()).ok_or(Singular)?;
        Ok(Constraints { contacts, factor })
    }

    /// The contacts and the factor.
    pub fn parts(&self) -> (&[usize], &Cholesky) {
        (&self.contacts, &self.factor)
    }
}

/// Solves the problem of a box; whether the forces are unique. Where they are not, the motion is, and equal contacts have equal
/// forces as far as their bounds allow.
pub fn solve_box(
    matrix: Vec<f64>,
    d: &[f64],
    [low, high]: &[Vec<f64>; 2],
    size: &[f64],
    force: &mut [f64],
) -> Result<bool, Singular> {
    let m = d.len();
    let unique = Cholesky::new(matrix.clone(), m).is_some();
    let other = if unique {
        matrix.clone()
    } else {
        regular(&matrix, m)
    };
    let mut problem = CoupledForces::new(other, m);
    problem
        .solve(d, low, high, size, force)
        .map_err(|_| Singular)?;
    if !unique {
        let free: Vec<usize> = (0..m).filter(|i| problem.is_free(*i)).collect();
        balance(&matrix, &free, d, force)?;
    }
    Ok(unique)
}

/// Computes the free forces again, with the matrix itself.
fn balance(matrix: &[f64], free: &[usize], d: &[f64], force: &mut [f64]) -> Result<(), Singular> {
    let m = d.len();
    let rows = free.iter().map(|i| &matrix[i * m..(i + 1) * m]);
    let block = rows.clone().flat_map(|row| free.iter().map(|j| row[*j]));
    let factor = Cholesky::of_any(block.collect(), free.len()).ok_or(Singular)?;
    let residuals = free.iter().zip(rows);
    let mut change: Vec<f64> = residuals
        .map(|(i, row)| d[*i] - row.iter().zip(&*force).map(|(a, s)| a * s).sum::<f64>())
        .collect();
    factor.solve(&mut change);
    for (i, change) in free.iter().zip(change) {
        force[*i] += change;
    }
    Ok(())
}

/// The rate of each contact that had an impact.
pub type Impacts = Vec<(usize, f64)>;

/// Changes the velocities by the impulses of rigid stops that close. `series` has begun.
pub fn impacts(
    model: &Model,
    series: &Series,
    scales: &Scales,
    book: &mut Book,
    v: &mut [f64],
) -> Result<Impacts, Singular> {
    let mut touching = Vec::new();
    let (mut d, mut before) = (Vec::new(), Vec::new());
    for (i, contact) in model.structure.contacts.iter().enumerate() {
        let Relation::RigidStop { restitution } = contact.law else {
            continue;
        };
        if series.contacts[i].r[0] <= scales.r(model, i) {
            let rate = model.relative(i, v);
            let e = if rate < -SHUT * scales.velocity {
                restitution
            } else {
                0.0
            };
            touching.push(i);
            before.push(rate);
            d.push(rate + e * rate.min(0.0));
        }
    }
    let tolerance = scales.rate(series.length);
    if before.iter().all(|rate| *rate >= -tolerance) {
        return Ok(Vec::new());
    }
    let m = touching.len();
    let size: Vec<f64> = before.iter().map(|rate| rate.abs() + tolerance).collect();
    let mut impulses = vec![0.0; m];
    let bounds = [vec![f64::NEG_INFINITY; m], vec![0.0; m]];
    solve_box(
        model.flexibility(&touching),
        &d,
        &bounds,
        &size,
        &mut impulses,
    )?;
    for (i, impulse) in touching.iter().zip(&impulses) {
        model.subtract_force(*i, *impulse, v);
    }
    for ((i, impulse), before) in touching.iter().zip(&impulses).zip(&before) {
        book.dissipate(0.5 * impulse * (before + model.relative(*i, v)));
    }
    let closing = touching.into_iter().zip(before);
    Ok(closing.filter(|(_, rate)| *rate < -tolerance).collect())
}
