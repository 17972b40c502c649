//! Nodes without mass at dashpots at t = 0: C_ss v_s = p_s - K_s u - B_s S - C_sr v_r holds at every instant.
//!
//! Their place is a state, their velocity is not. A step finds the mean of both ends: a start with another velocity would alternate
//! around the motion for ever.

use super::initial;
use crate::system::structure::Structure;
use crate::system::structure::sparse::factor::Factor;

/// A pivot below this part of the diagonal is round-off: such dashpots move together, and only springs say where.
const SINGULAR: f64 = 1e-12;

/// Most rounds in which contacts follow the velocities, the part of the forces after which what is left is round-off, and the part that
/// may be left.
const ROUNDS: usize = 50;
const LEFT: f64 = 1e-15;
const NEAR: f64 = 1e-9;

/// Gives the nodes without mass that have damping the velocity of their equilibrium, and leaves them as they are where dashpots and
/// contacts have none.
pub(super) fn move_damped(structure: &mut Structure) {
    if structure.has_mass_everywhere() {
        return;
    }
    let coupled = structure.coupled_mass.nonzero_rows();
    let damped = structure.damping.nonzero_rows();
    let is_own = |i: &usize| structure.nodes[*i].mass == 0.0 && !coupled[*i] && damped[*i];
    let nodes: Vec<usize> = (0..structure.len()).filter(is_own).collect();
    if nodes.is_empty() {
        return;
    }
    let Ok(factor) = Factor::regular(&structure.damping.block(&nodes), SINGULAR) else {
        return;
    };
    let before = structure.velocity.clone();
    let mut least = f64::INFINITY;
    for _ in 0..ROUNDS {
        let Ok(forces) = initial::forces(structure) else {
            break;
        };
        let [load, inner] = structure.forces_at_start(&forces);
        let mut rest: Vec<f64> = nodes.iter().map(|i| load[*i] - inner[*i]).collect();
        let most = |sum: f64, x: &f64| sum.max(x.abs());
        let (left, size) = (
            rest.iter().fold(0.0, most),
            load.iter().chain(&inner).fold(0.0, most),
        );
        let left = if left == 0.0 { 0.0 } else { left / size };
        if left >= least {
            break;
        }
        least = left;
        if left <= LEFT {
            return;
        }
        factor.solve(&mut rest);
        for (i, change) in nodes.iter().zip(rest) {
            structure.velocity[*i] += change;
        }
    }
    // Contacts that follow the velocity more than the dashpots do have no answer of this kind.
    if least > NEAR {
        structure.velocity = before;
    }
}
