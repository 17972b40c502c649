//! The motions of a case that its metrics, histories and figures need, each computed once.

use super::channel::Number;
use super::judge::Recorded;
use crate::solve::Unsolvable;
use crate::system::structure::{Relation, Structure};

/// STUB
pub fn exact(
    _structure: &Structure,
    _times: &[f64],
    _numbers: &[Number],
) -> Result<Recorded, Unsolvable> {
    Err(Unsolvable::NoModes)
}

/// STUB
pub fn computed(
    _structure: &Structure,
    _dt: f64,
    _last: u64,
    _numbers: &[Number],
    _energy: bool,
) -> Result<(Recorded, Option<f64>), Unsolvable> {
    Err(Unsolvable::NoModes)
}

/// The same structure with rigid laws: impacts without compliance and with the restitution of a spring, which is 1, and Coulomb
/// friction.
pub fn rigid(structure: &Structure) -> Structure {
    let mut rigid = structure.clone();
    for contact in &mut rigid.contacts {
        contact.law = match contact.law.clone() {
            Relation::ImpactSpring { .. } => Relation::RigidStop { restitution: 1.0 },
            Relation::DisplacementControl { limit, .. }
            | Relation::VelocityControl { limit, .. } => Relation::Coulomb { limit },
            law @ (Relation::RigidStop { .. } | Relation::Coulomb { .. }) => law,
        };
    }
    rigid
}

/// The relative difference of start and loads for `divergence`.
const DIFFERENCE: f64 = 1e-10;

/// The same structure with start and loads that are 1e-10 larger.
pub fn perturbed(structure: &Structure) -> Structure {
    let mut other = structure.clone();
    let larger = |x: &mut f64| *x *= 1.0 + DIFFERENCE;
    other.displacement.iter_mut().for_each(larger);
    other.velocity.iter_mut().for_each(larger);
    for load in &mut other.loads {
        load.pattern.iter_mut().for_each(|(_, x)| larger(x));
    }
    other
}
