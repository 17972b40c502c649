//! The equilibrium of a structure under its static loads: K u + B S = p.
//!
//! Contacts alone may hold a part, so that K may be singular. The equilibrium is therefore the limit of the steps
//!
//! ```text
//! (K + q M) (u' - u) + B S' = p - K u,   r' = r + B^T (u' - u)
//! ```
//!
//! (the proximal point method, Rockafellar 1976). The laws give S' as in a time step, but of a motion that takes so long that it has
//! no velocity. What is left out of the equilibrium is q M (u' - u), which tells when the steps may end. Where they converge slowly,
//! q is made smaller; with a regular K it is 0 from the beginning.

use super::curved::Curved;
use super::curved_step::Motion;
use crate::contact::{ContactKind, ContactLaw};
use crate::solve::Unsolvable;
use crate::system::import::negative_pivot;
use crate::system::structure::factor::Factor;
use crate::system::structure::{Limit, Structure, StructureLaw, Symmetric};

/// Pivots of K below this part of the diagonal are round-off: contacts hold something.
const SINGULAR: f64 = 1e-10;

/// Smallest entry of K with the elastic contacts over that of q M, for the first q. Larger numbers need fewer steps, but each one
/// leaves their round-off in u where contacts alone hold it.
const LARGE: f64 = 100.0;

/// Part of q at slow convergence, and what slow is: the part of the residual that a step leaves.
const LESS: f64 = 0.01;
const SLOW: f64 = 0.1;

/// Most doublings of q until K + q M/2 is positive definite.
const DOUBLINGS: usize = 200;

/// Most steps for a load where a negative stiffness keeps q above a number.
const STEPS_OF_NEGATIVE: usize = 2000;

/// Change of forces and displacements, over the largest ones, from which on one step more leaves round-off only.
const TARGET: f64 = 1e-11;

/// Round-off of a solution and of its contact forces, some fifty times the unit round-off.
const ROUND_OFF: f64 = 1e-14;

/// Most steps for a load. With q 100 times smaller after each slow one, a dozen reach round-off.
const STEPS: usize = 100;

/// The load is applied in so many parts where the forces of curved laws depend on the way: their memory is exact for lines only.
const PARTS: usize = 50;

/// Time of a step: dashpots have no force in it.
const LONG: f64 = 1e15;

/// Puts a structure with static loads in equilibrium with them, with its contacts. The velocities stay.
///
/// # Errors
/// Nothing holds a node, or the contacts have no forces.
pub fn settle(structure: &mut Structure) -> Result<(), Unsolvable> {
    if structure.preload.load.is_empty() {
        return Ok(());
    }
    let remembers = |law: ContactKind| law != ContactKind::Impact;
    let mut contacts = structure.contacts.iter();
    let parts = match contacts.any(|own| own.law.is_curved() && remembers(own.law.kind())) {
        true => PARTS,
        false => 1,
    };
    let still = without_dampers(structure);
    let mut equilibrium = Equilibrium::new(still.as_ref().unwrap_or(structure))?;
    for part in 1..=parts {
        equilibrium.find(part as f64 / parts as f64)?;
    }
    equilibrium.refuse_loose()?;
    let Equilibrium {
        u, forces, curved, ..
    } = equilibrium;
    let laws = structure.contacts.iter().enumerate();
    let laws = laws.map(|(i, own)| {
        let loaded = own.law.is_curved() && remembers(own.law.kind());
        (loaded && at_rest(&own.law).is_none()).then(|| curved.law(i))
    });
    structure.preload.laws = laws.collect();
    let contacts = 0..structure.contacts.len();
    structure.preload.planes = contacts.map(|i| curved.plane(i)).collect();
    structure.preload.forces = forces.into_iter().map(Some).collect();
    structure.displacement = u;
    Ok(())
}

/// The steps to equilibrium.
struct Equilibrium<'a> {
    structure: &'a Structure,
    massless: Vec<bool>,
    /// M, and a weight of nodes without mass beside it, which contacts alone may hold, too.
    mass: Symmetric,
    q: f64,
    /// Whether K has a negative pivot.
    is_negative: bool,
    factor: Factor,
    /// (K + q M)^-1 B by columns.
    columns: Vec<Vec<f64>>,
    curved: Curved,
    u: Vec<f64>,
    forces: Vec<f64>,
    /// Largest change of u in a step without the contact forces, of whose round-off no change tells anything.
    free: f64,
}

impl<'a> Equilibrium<'a> {
    fn new(structure: &'a Structure) -> Result<Equilibrium<'a>, Unsolvable> {
        let mut mass = structure.mass();
        let massless = structure.massless();
        let stiffened = stiffened(structure);
        let mut q = match holds(&structure.stiffness, &stiffened) {
            true => 0.0,
            false => first_q(structure, &stiffened),
        };
        // A negative stiffness needs more of M beside it: as little as possible, since more needs more steps.
        let is_negative = negative_pivot(&structure.stiffness).is_some();
        if is_negative {
            let is_positive = |q: f64| {
                let shifted = shifted(structure, &mass, q);
                Factor::new(&shifted, &vec![false; structure.len()]).is_ok()
            };
            let mut all = std::iter::successors(Some(q), |q| Some(2.0 * q)).take(DOUBLINGS);
            q = all.find(|q| is_positive(0.5 * q)).unwrap_or(q);
        }
        for node in (0..structure.len()).filter(|node| massless[*node]) {
            let k = diagonal(&stiffened)[node];
            mass.add(node, node, if q > 0.0 { k / (LARGE * q) } else { 0.0 });
        }
        let (factor, columns) = linear(structure, &mass, q)?;
        let curved = curved(structure, &columns);
        Ok(Equilibrium {
            structure,
            massless,
            mass,
            q,
            is_negative,
            factor,
            columns,
            curved,
            u: structure.displacement.clone(),
            forces: vec![0.0; structure.contacts.len()],
            free: 0.0,
        })
    }

    /// Finds the equilibrium with a part of the load.
    fn find(&mut self, part: f64) -> Result<(), Unsolvable> {
        let load: Vec<f64> = self
            .structure
            .preload
            .load
            .iter()
            .map(|p| part * p)
            .collect();
        let mut before = f64::INFINITY;
        let mut last = Vec::new();
        let mut near = false;
        let steps = match self.is_negative {
            true => STEPS_OF_NEGATIVE,
            false => STEPS,
        };
        for _ in 0..steps {
            let forces = self.forces.clone();
            let change = self.step(&load)?;
            let mut left = vec![0.0; load.len()];
            self.mass.add_product(&change, &mut left);
            let size = largest(&load).max(largest(&self.forces));
            let residual = self.q * largest(&left);
            let differences = forces.iter().zip(&self.forces).map(|(a, b)| (a - b).abs());
            let moved = differences.fold(0.0, f64::max);
            let round_off = ROUND_OFF * self.free;
            // Nodes without mass have a place of their own only where contacts press; `balance` finds it.
            let of_masses = change.iter().zip(&self.massless);
            let changes = of_masses.filter(|(_, massless)| !**massless);
            let largest_change = changes.fold(0.0, |most: f64, (x, _)| most.max(x.abs()));
            let still = largest_change <= (TARGET * largest(&self.u)).max(round_off);
            let reached = still && moved <= TARGET * size;
            if reached && near {
                return Ok(());
            }
            near = reached;
            if !reached && residual > SLOW * before {
                let less = LESS * self.q;
                let linear = linear(self.structure, &self.mass, less);
                // A negative stiffness keeps q above a number.
                if linear.is_ok() || !self.is_negative {
                    self.q = less;
                    (self.factor, self.columns) = linear?;
                    let new = curved(self.structure, &self.columns);
                    let before = std::mem::replace(&mut self.curved, new);
                    self.curved.remember(&before);
                }
            }
            (before, last) = (residual, change);
        }
        let moved = last.iter().enumerate();
        let node = moved.max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()));
        let node = node.map_or(String::new(), |(node, _)| {
            self.structure.nodes[node].name.clone()
        });
        Err(Unsolvable::NoEquilibrium { node })
    }

    /// Refuses a contact that the load breaks loose: where it comes to rest depends on the motion.
    fn refuse_loose(&self) -> Result<(), Unsolvable> {
        for (contact, force) in self.structure.contacts.iter().zip(&self.forces) {
            let ratio = contact.law.static_ratio();
            let limit = contact.law.limit().map_or(0.0, |limit| {
                let at_rest = |node: usize| [self.u[node], 0.0];
                limit.pressed_in(0.0, |other| self.forces[other], at_rest)
            });
            if ratio > 1.0 && force.abs() >= ratio * limit * (1.0 - TARGET) {
                let name = &contact.name;
                return Err(Unsolvable::BrokenRules(format!(
                    "the static loads break contact '{name}' loose: where it comes to rest depends on the motion; apply them as loads in time, or choose static_ratio 1"
                )));
            }
        }
        Ok(())
    }

    /// One step; returns u' - u.
    fn step(&mut self, load: &[f64]) -> Result<Vec<f64>, Unsolvable> {
        let mut inner = vec![0.0; load.len()];
        self.structure.stiffness.add_product(&self.u, &mut inner);
        let mut change: Vec<f64> = load
            .iter()
            .zip(&inner)
            .map(|(p, inner)| p - inner)
            .collect();
        self.factor.solve(&mut change);
        self.free = self.free.max(largest(&change));
        for (c, contact) in self.structure.contacts.iter().enumerate() {
            let changes = |own: &&Limit| own.pressed_by.is_some() || own.static_ratio > 1.0;
            if let Some(limit) = contact.law.limit().filter(changes) {
                let at_rest = |node: usize| [self.u[node], 0.0];
                let limit = limit.pressed_in(0.0, |other| self.forces[other], at_rest);
                let held = contact.law.static_ratio() * limit;
                self.curved.limit(c, held);
            }
        }
        let (structure, u, forces) = (self.structure, &self.u, &self.forces);
        let motion = |c: usize| {
            let displacement = structure.relative(c, u) + structure.contacts[c].gap;
            let change = structure.relative(c, &change);
            Motion {
                displacement,
                velocity: 0.0,
                force: forces[c],
                change,
                rate: change / LONG,
                size: displacement.abs() + change.abs(),
            }
        };
        let solved = self.curved.solve(motion);
        let solved = solved.map_err(|why| Unsolvable::NoForces { step: 0, why })?;
        self.forces.copy_from_slice(solved);
        for (column, force) in self.columns.iter().zip(&self.forces) {
            for (change, x) in change.iter_mut().zip(column) {
                *change -= x * force;
            }
        }
        for (u, change) in self.u.iter_mut().zip(&change) {
            *u += change;
        }
        Ok(change)
    }
}

/// The structure without the dampers of its contacts, if they have any: they have no static force, however slowly the equilibrium is
/// reached.
fn without_dampers(structure: &Structure) -> Option<Structure> {
    let mut contacts = structure.contacts.iter();
    contacts.any(|own| at_rest(&own.law).is_some()).then(|| {
        let mut still = structure.clone();
        for contact in &mut still.contacts {
            if let Some(law) = at_rest(&contact.law) {
                contact.law = law;
            }
        }
        still
    })
}

/// The law without its damper; `None` if it has none.
fn at_rest(law: &StructureLaw) -> Option<StructureLaw> {
    let law = match law {
        StructureLaw::VelocityControl { .. }
        | StructureLaw::CurvedFriction { .. }
        | StructureLaw::CurvedImpact { .. }
        | StructureLaw::Link { .. } => law.law(1.0).without_damper()?,
        _ => return None,
    };
    Some(match law {
        ContactLaw::ImpactSpring(law) => StructureLaw::ImpactSpring {
            stiffness: law.stiffness,
        },
        ContactLaw::Hertz(_) => StructureLaw::CurvedImpact {
            law,
            restitution: 1.0,
        },
        law => StructureLaw::Link { law },
    })
}

/// K with the contacts at their largest stiffness, as far as that is finite: what their forces are compared with.
fn stiffened(structure: &Structure) -> Symmetric {
    let mut stiffness = structure.initial_stiffness();
    for contact in &structure.contacts {
        let limit = contact.law.limit().map_or(0.0, |limit| limit.at(0.0));
        let overlap = contact.gap.abs();
        let law = contact.law.law(limit);
        let k = law.properties().largest_stiffness(overlap);
        if k > 0.0 && k.is_finite() {
            stiffness.add_along(&contact.along, k);
        }
    }
    stiffness
}

/// Whether K holds all nodes beside the contacts: no pivot is round-off of the stiffness with them.
fn holds(stiffness: &Symmetric, stiffened: &Symmetric) -> bool {
    let size = stiffness.size();
    let Ok(factor) = Factor::new(stiffness, &vec![false; size]) else {
        return false;
    };
    let diagonal = diagonal(stiffened);
    let mut pivots = factor.order().iter().zip(factor.reciprocals());
    pivots.all(|(row, reciprocal)| 1.0 >= SINGULAR * diagonal[*row] * *reciprocal)
}

fn diagonal(matrix: &Symmetric) -> Vec<f64> {
    let mut diagonal = vec![0.0; matrix.size()];
    for ((i, _), x) in matrix.entries().filter(|((i, j), _)| i == j) {
        diagonal[i] += x;
    }
    diagonal
}

/// q for which q M is a small part of K with the contacts.
fn first_q(structure: &Structure, stiffened: &Symmetric) -> f64 {
    let ratios = diagonal(stiffened)
        .into_iter()
        .zip(diagonal(&structure.mass()));
    let ratios = ratios
        .filter(|(k, m)| *k > 0.0 && *m > 0.0)
        .map(|(k, m)| k / m);
    let least = ratios.fold(f64::INFINITY, f64::min);
    match least.is_finite() {
        true => least / LARGE,
        false => 1.0,
    }
}

/// K + q M.
fn shifted(structure: &Structure, mass: &Symmetric, q: f64) -> Symmetric {
    let mut matrix = structure.stiffness.clone();
    matrix.add_matrix(mass, q);
    matrix
}

/// The factor of K + q M, and (K + q M)^-1 B by columns.
fn linear(
    structure: &Structure,
    mass: &Symmetric,
    q: f64,
) -> Result<(Factor, Vec<Vec<f64>>), Unsolvable> {
    let matrix = shifted(structure, mass, q);
    let factor = Factor::new(&matrix, &vec![false; structure.len()]);
    let factor = factor.map_err(|why| Unsolvable::NoEquilibrium {
        node: structure.nodes[why.row].name.clone(),
    })?;
    let column = |contact: usize| {
        let mut column = vec![0.0; structure.len()];
        for (node, x) in structure.column(contact) {
            column[node] += x;
        }
        factor.solve(&mut column);
        column
    };
    let columns = (0..structure.contacts.len()).map(column).collect();
    Ok((factor, columns))
}

/// The laws of the contacts with H = B^T (K + q M)^-1 B.
fn curved(structure: &Structure, columns: &[Vec<f64>]) -> Curved {
    let m = columns.len();
    let mut flexibility = vec![0.0; m * m];
    for i in 0..m {
        for j in 0..=i {
            let h = structure.relative(i, &columns[j]);
            (flexibility[i * m + j], flexibility[j * m + i]) = (h, h);
        }
    }
    Curved::of_all(structure, &[], &flexibility, 1.0 / LONG, LONG)
}

fn largest(all: &[f64]) -> f64 {
    all.iter().fold(0.0, |a, x| f64::max(a, x.abs()))
}
