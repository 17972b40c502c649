//! The contact forces at t = 0.

use super::first_force::first_force;
use crate::contact::plane::length;
use crate::contact::{ClippedLine, RigidForces, Unsolved};
use crate::solve::structure::contacts::curved::plane::first_forces;
use crate::solve::structure::contacts::laws::{bounds, friction};
use crate::solve::structure::contacts::static_in_plane::ROUND_OFF;
use crate::system::structure::{Inertia, PlaneRow, Structure};

/// S(0) of every contact.
///
/// Softened laws give it. The force of a contact that sticks or is shut follows from the accelerations: r'' = d - A S with
/// A = B^T M^-1 B and d = B^T M^-1 (p - K u - C v - B S) of the other forces, in the bounds of the law.
pub(crate) fn forces(structure: &Structure) -> Result<Vec<f64>, Unsolved> {
    let u = &structure.displacement;
    let mut forces = vec![0.0; structure.contacts.len()];
    let mut active = Vec::new();
    let massless = structure.massless();
    for (c, contact) in structure.contacts.iter().enumerate() {
        let r = structure.relative(c, u) + contact.gap;
        let rdot = structure.rate_at_start(c);
        let [low, high] = bounds_at_start(structure, c);
        let at_rest = structure.preload.force(c);
        // Nodes without mass are in equilibrium under the forces of their contacts.
        let mut nodes = structure.column(c);
        if let (Some(force), true) = (at_rest, nodes.any(|(node, _)| massless[node])) {
            forces[c] = force;
            continue;
        }
        // Round-off of the equilibrium opens no contact that presses.
        let is_open = r > 0.0 && at_rest.is_none_or(|force| force == 0.0);
        forces[c] = match (contact.law.line(), contact.law.row()) {
            (Some(ClippedLine::Spring { stiffness }), _) => stiffness * r.min(0.0),
            (Some(ClippedLine::Elastic { .. }), _) => at_rest.unwrap_or_default(),
            // Its first direction has found both.
            (None, Some(PlaneRow::Second)) => forces[c],
            (None, Some(PlaneRow::First)) => {
                let other = structure.relative(c + 1, u) + structure.contacts[c + 1].gap;
                let other_rate = structure.rate_at_start(c + 1);
                let is_held = contact.law.is_rigid() && rdot == 0.0 && other_rate == 0.0;
                let has_mass = |c: usize| {
                    let mut nodes = structure.column(c);
                    nodes.all(|(node, _)| structure.nodes[node].mass > 0.0)
                };
                if is_held {
                    if has_mass(c) && has_mass(c + 1) {
                        active.extend([c, c + 1]);
                    }
                    continue;
                }
                let pair = first_forces(structure, c, [r, other], [rdot, other_rate], high);
                let [first, second] = pair.map_or([0.0; 2], |(force, _)| force);
                forces[c + 1] = second;
                first
            }
            (None, None) => first_force(structure, c, r, rdot)?,
            (Some(ClippedLine::Viscous { viscosity }), _) => (viscosity * rdot).clamp(low, high),
            (Some(ClippedLine::Coulomb), _) if rdot > 0.0 => high,
            (Some(ClippedLine::Coulomb), _) if rdot < 0.0 => low,
            (Some(ClippedLine::Stop { .. }), _) if is_open || rdot != 0.0 => 0.0,
            // Where a node without mass gives way, nothing presses at rest.
            (Some(ClippedLine::Coulomb | ClippedLine::Stop { .. }), _) => {
                let mut nodes = structure.column(c);
                if nodes.all(|(node, _)| structure.nodes[node].mass > 0.0) {
                    active.push(c);
                }
                0.0
            }
        };
    }
    if !active.is_empty() {
        hold(structure, &active, &mut forces)?;
    }
    Ok(forces)
}

/// The bounds of a contact's force at t = 0, where static loads may press it.
pub(crate) fn bounds_at_start(structure: &Structure, contact: usize) -> [f64; 2] {
    let contact_of_start = &structure.contacts[contact];
    match contact_of_start
        .law
        .limit()
        .filter(|limit| limit.pressed_by.is_some())
    {
        Some(limit) => {
            let force = |other| structure.preload.force(other).unwrap_or_default();
            friction(limit.pressed(0.0, force))
        }
        None => bounds(contact_of_start, 0.0),
    }
}

/// Writes the forces of the contacts that stick or are shut; the others are given.
fn hold(structure: &Structure, active: &[usize], forces: &mut [f64]) -> Result<(), Unsolved> {
    let n = structure.len();
    let inertia = Inertia::new(structure).map_err(|_| Unsolved::Singular)?;
    let [load, inner] = structure.forces_at_start(forces);
    let difference = load.iter().zip(&inner);
    let mut acceleration: Vec<f64> = difference.map(|(load, inner)| load - inner).collect();
    inertia.divide(&mut acceleration);
    // M^-1 B by columns.
    let columns: Vec<Vec<f64>> = active
        .iter()
        .map(|i| {
            let mut column = vec![0.0; n];
            for (node, factor) in structure.column(*i) {
                column[node] += factor;
            }
            inertia.divide(&mut column);
            column
        })
        .collect();
    let size = |(i, column): (&usize, &Vec<f64>)| -> f64 {
        let terms = structure.column(*i);
        terms
            .map(|(node, _)| (load[node].abs() + inner[node].abs()) * column[node].abs())
            .sum()
    };
    let rows = active
        .iter()
        .flat_map(|i| columns.iter().map(|column| structure.relative(*i, column)));
    let rows_of_laws = active.iter().map(|i| structure.contacts[*i].law.row());
    let firsts = rows_of_laws.map(|row| row == Some(PlaneRow::First));
    let mut problem = RigidForces::new(rows.collect(), firsts.collect());
    let d: Vec<f64> = active
        .iter()
        .map(|i| structure.relative(*i, &acceleration) + structure.gap_acceleration(*i))
        .collect();
    let mut bounds: Vec<[f64; 2]> = active
        .iter()
        .map(|i| {
            let ratio = structure.contacts[*i].law.static_ratio();
            bounds_at_start(structure, *i).map(|bound| ratio * bound)
        })
        .collect();
    let sizes: Vec<f64> = active.iter().zip(&columns).map(size).collect();
    let mut held = vec![0.0; active.len()];
    loop {
        let [low, high] = [0, 1].map(|k| bounds.iter().map(|pair| pair[k]).collect::<Vec<f64>>());
        problem.solve(&d, [&low, &high], &sizes, &mut held)?;
        // Those at their static limit break loose together, as in a step.
        let mut breaks = false;
        for (at, (contact, bounds)) in active.iter().zip(&mut bounds).enumerate() {
            let kinetic = bounds_at_start(structure, *contact);
            let force = &held[at];
            if let Some(row) = structure.contacts[*contact].law.row() {
                let first = match row {
                    PlaneRow::First => at,
                    PlaneRow::Second => at - 1,
                };
                let rim = bounds[1] * (1.0 - ROUND_OFF);
                let is_at_rim = length([held[first], held[first + 1]]) >= rim;
                if is_at_rim && *bounds != kinetic {
                    *bounds = kinetic;
                    breaks = true;
                }
                continue;
            }
            for end in 0..2 {
                if *force == bounds[end] && bounds[end] != kinetic[end] {
                    bounds[end] = kinetic[end];
                    breaks = true;
                }
            }
        }
        if !breaks {
            break;
        }
    }
    for (contact, force) in active.iter().zip(held) {
        forces[*contact] = force;
    }
    Ok(())
}
