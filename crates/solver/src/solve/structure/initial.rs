//! The contact forces at t = 0.

use super::curved::first_force;
use super::laws::bounds;
use crate::contact::{CoupledForces, Unsolved};
use crate::system::structure::{Structure, StructureLaw};

/// S(0) of every contact.
///
/// Softened laws give it. The force of a contact that sticks or is shut follows from the accelerations: r'' = d - A S with
/// A = B^T M^-1 B and d = B^T M^-1 (p - K u - C v - B S) of the other forces, in the bounds of the law.
pub(super) fn forces(structure: &Structure) -> Result<Vec<f64>, Unsolved> {
    let (u, v) = (&structure.displacement, &structure.velocity);
    let mut forces = vec![0.0; structure.contacts.len()];
    let mut active = Vec::new();
    for (c, contact) in structure.contacts.iter().enumerate() {
        let r = structure.relative(c, u) + contact.gap;
        let rdot = structure.relative(c, v);
        let [low, high] = bounds(contact, 0.0);
        forces[c] = match contact.law {
            StructureLaw::ImpactSpring { stiffness } => stiffness * r.min(0.0),
            StructureLaw::DisplacementControl { .. } => 0.0,
            StructureLaw::CurvedImpact { .. }
            | StructureLaw::CurvedFriction { .. }
            | StructureLaw::Link { .. } => first_force(&contact.law, r, rdot),
            StructureLaw::VelocityControl { viscosity, .. } => (viscosity * rdot).clamp(low, high),
            StructureLaw::Coulomb { .. } if rdot > 0.0 => high,
            StructureLaw::Coulomb { .. } if rdot < 0.0 => low,
            StructureLaw::RigidStop { .. } if r > 0.0 || rdot != 0.0 => 0.0,
            StructureLaw::Coulomb { .. } | StructureLaw::RigidStop { .. } => {
                active.push(c);
                0.0
            }
        };
    }
    if !active.is_empty() {
        hold(structure, &active, &mut forces)?;
    }
    Ok(forces)
}

/// Writes the forces of the contacts that stick or are shut; the others are given.
fn hold(structure: &Structure, active: &[usize], forces: &mut [f64]) -> Result<(), Unsolved> {
    let n = structure.len();
    let (mut load, mut inner) = (vec![0.0; n], vec![0.0; n]);
    structure.add_loads(0.0, &mut load);
    let (k, c) = (&structure.stiffness, &structure.damping);
    k.add_product(&structure.displacement, &mut inner);
    c.add_product(&structure.velocity, &mut inner);
    for (contact, force) in forces.iter().enumerate() {
        for (node, sign) in structure.column(contact) {
            inner[node] += sign * force;
        }
    }
    let mass = |node: usize| structure.nodes[node].mass;
    let acceleration: Vec<f64> = (0..n).map(|i| (load[i] - inner[i]) / mass(i)).collect();
    let size = |i: &usize| -> f64 {
        let terms = structure.column(*i);
        terms
            .map(|(node, _)| (load[node].abs() + inner[node].abs()) / mass(node))
            .sum()
    };
    let entry = |i: usize, j: usize| -> f64 {
        let pairs = structure
            .column(i)
            .flat_map(|a| structure.column(j).map(move |b| (a, b)));
        let common = pairs.filter(|(a, b)| a.0 == b.0);
        common.map(|(a, b)| a.1 * b.1 / mass(a.0)).sum()
    };
    let rows = active
        .iter()
        .flat_map(|i| active.iter().map(|j| entry(*i, *j)));
    let mut problem = CoupledForces::new(rows.collect(), active.len());
    let d: Vec<f64> = active
        .iter()
        .map(|i| structure.relative(*i, &acceleration))
        .collect();
    let bound = |k: usize| -> Vec<f64> {
        let bounds = active
            .iter()
            .map(|i| bounds(&structure.contacts[*i], 0.0)[k]);
        bounds.collect()
    };
    let sizes: Vec<f64> = active.iter().map(size).collect();
    let mut held = vec![0.0; active.len()];
    problem.solve(&d, &bound(0), &bound(1), &sizes, &mut held)?;
    for (contact, force) in active.iter().zip(held) {
        forces[*contact] = force;
    }
    Ok(())
}
