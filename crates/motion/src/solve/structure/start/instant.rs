//! The contacts at nodes without mass at t = 0.
//!
//! A node without mass is in equilibrium at every instant, K_ss u_s + B_s S = p_s - K_sr u_r, also at the first one. Contacts that follow
//! the displacement move it there at once; contacts that follow the velocity hold its place and move it at the rate of their force. Both
//! are the answers of the laws to a step of the nodes without mass alone whose time is far shorter than that of the motion.

use super::damped::move_damped;
use crate::contact::ContactKind;
use crate::solve::Unsolvable;
use crate::solve::structure::contacts::curved::contacts::Curved;
use crate::solve::structure::contacts::curved::step::{Motion, SHORT};
use crate::solve::structure::linear_part::between;
use crate::solve::structure::linear_part::block_matrix::BlockMatrix;
use crate::system::structure::sparse::factor::Factor;
use crate::system::structure::{Chain, Structure};

/// Most rounds in which limits follow the forces of the contacts that press them.
const ROUNDS: usize = 20;

/// Moves the nodes without mass to their equilibrium with the contacts, and keeps the forces of these contacts and what their laws
/// remember. Nodes without mass at dashpots get the velocity of their equilibrium. The state of all others stays.
///
/// # Errors
/// The contacts have no forces.
pub fn balance(structure: &mut Structure, dt: f64) -> Result<(), Unsolvable> {
    meet(structure, dt)?;
    move_damped(structure);
    Ok(())
}

fn meet(structure: &mut Structure, dt: f64) -> Result<(), Unsolvable> {
    let massless = structure.massless();
    let touches = |contact: &usize| {
        // Both directions of a plane go together.
        let contacts = structure.directions_of(*contact);
        let mut nodes = contacts.flat_map(|contact| &structure.contacts[contact].along);
        nodes.any(|(node, _)| massless.get(*node) == Some(&true))
    };
    let touching: Vec<usize> = (0..structure.contacts.len()).filter(touches).collect();
    if touching.is_empty() {
        return Ok(());
    }
    let nodes: Vec<usize> = (0..structure.len())
        .filter(|node| massless[*node])
        .collect();
    let mut stiffness = structure.stiffness.clone();
    between::hold(structure, &mut stiffness);
    let block = stiffness.block(&nodes);
    let Ok(factor) = Factor::new(&block, &vec![false; nodes.len()]) else {
        // The rules of nodes without mass name it.
        return Ok(());
    };
    let free = free_change(structure, &nodes, &factor);
    let column = |contact: &usize| {
        let mut column = vec![0.0; nodes.len()];
        for (node, factor) in structure.column(*contact) {
            if let Ok(row) = nodes.binary_search(&node) {
                column[row] += factor;
            }
        }
        factor.solve(&mut column);
        column
    };
    let columns: Vec<Vec<f64>> = touching.iter().map(column).collect();
    let along = |contact: usize, x: &[f64]| -> f64 {
        let terms = structure.column(contact).filter_map(|(node, factor)| {
            let row = nodes.binary_search(&node).ok()?;
            Some(factor * x[row])
        });
        terms.sum()
    };
    let m = touching.len();
    let mut flexibility = vec![0.0; m * m];
    for (i, contact) in touching.iter().enumerate() {
        for j in 0..=i {
            let h = along(*contact, &columns[j]);
            (flexibility[i * m + j], flexibility[j * m + i]) = (h, h);
        }
    }
    let short = SHORT * dt;
    let among = among_themselves(structure, &touching);
    let chains = structure.chains();
    let among_chains = numbered(&chains, &touching);
    let flexibility = BlockMatrix::dense(flexibility, m);
    let start = || Curved::of_all(&among, &among_chains, &flexibility, 1.0 / short, short);
    let mut curved = start();
    let mut forces: Vec<f64> = touching
        .iter()
        .map(|c| structure.preload.force(*c).unwrap_or(0.0))
        .collect();
    for _ in 0..ROUNDS {
        let pressed = |other: usize| match touching.binary_search(&other) {
            Ok(row) => forces[row],
            Err(_) => structure.preload.force(other).unwrap_or(0.0),
        };
        curved = start();
        let mut follows = false;
        for (row, contact) in touching.iter().enumerate() {
            let limit = structure.contacts[*contact].law.limit();
            if let Some(limit) = limit.filter(|limit| limit.pressed_by.is_some()) {
                follows = true;
                curved.limit(row, limit.pressed(0.0, pressed));
            }
        }
        let motion = |row: usize| {
            let contact = touching[row];
            let change = along(contact, &free);
            let displacement = structure.relative(contact, &structure.displacement)
                + structure.contacts[contact].gap;
            let velocity = structure.rate_at_start(contact);
            Motion {
                displacement,
                velocity,
                force: structure.preload.force(contact).unwrap_or(0.0),
                change,
                rate: velocity + change / short,
                size: displacement.abs() + change.abs(),
                terms: [0.0; 2],
            }
        };
        let solved = curved
            .solve(motion)
            .map_err(|why| Unsolvable::NoForces { step: 0, why })?;
        let same = forces == solved;
        forces.copy_from_slice(solved);
        if same || !follows {
            break;
        }
    }
    let mut u = free;
    for (column, force) in columns.iter().zip(&forces) {
        u.iter_mut().zip(column).for_each(|(u, x)| *u -= x * force);
    }
    for (node, change) in nodes.iter().zip(u) {
        structure.displacement[*node] += change;
    }
    for chain in &chains {
        for (member, inner) in chain.leaders().zip(&chain.nodes) {
            let Ok(row) = touching.binary_search(&member.contact) else {
                continue;
            };
            let r = structure.relative(member.contact, &structure.displacement)
                + structure.contacts[member.contact].gap;
            let change = curved.displacement(row) - r;
            structure.displacement[inner.node] += inner.factor * change;
        }
    }
    let preload = &mut structure.preload;
    preload.forces.resize(structure.contacts.len(), None);
    preload.laws.resize(structure.contacts.len(), None);
    preload.planes.resize(structure.contacts.len(), None);
    for (row, contact) in touching.into_iter().enumerate() {
        preload.forces[contact] = Some(forces[row]);
        let law = &structure.contacts[contact].law;
        if law.is_curved() && law.kind() != ContactKind::Impact {
            preload.laws[contact] = Some(curved.law(row));
            preload.planes[contact] = curved.plane(row);
        }
    }
    Ok(())
}

/// What the nodes without mass move without contact forces: K_ss^-1 (p_s - K u).
fn free_change(structure: &Structure, nodes: &[usize], factor: &Factor) -> Vec<f64> {
    let mut loads = vec![0.0; structure.len()];
    structure.add_loads(0.0, &mut loads);
    let mut inner = vec![0.0; structure.len()];
    structure
        .stiffness
        .add_product(&structure.displacement, &mut inner);
    let mut change: Vec<f64> = nodes
        .iter()
        .map(|node| loads[*node] - inner[*node])
        .collect();
    factor.solve(&mut change);
    change
}

/// The chains with the numbers that their contacts have among these.
fn numbered(chains: &[Chain], contacts: &[usize]) -> Vec<Chain> {
    let mut chains = chains.to_vec();
    let links = chains.iter_mut().flat_map(|chain| &mut chain.links);
    for member in links.flatten() {
        member.contact = contacts.binary_search(&member.contact).unwrap_or_default();
    }
    chains
}

/// The structure with these contacts only. Their rates follow from the short step, as between masses.
fn among_themselves(structure: &Structure, contacts: &[usize]) -> Structure {
    let mut among = structure.clone();
    among.contacts = contacts
        .iter()
        .map(|c| structure.contacts[*c].clone())
        .collect();
    among.preload.laws = contacts
        .iter()
        .map(|c| structure.preload.laws.get(*c).copied().flatten())
        .collect();
    among.preload.planes = contacts
        .iter()
        .map(|c| structure.preload.planes.get(*c).copied().flatten())
        .collect();
    among
        .nodes
        .iter_mut()
        .filter(|node| node.mass == 0.0)
        .for_each(|node| node.mass = 1.0);
    among
}
