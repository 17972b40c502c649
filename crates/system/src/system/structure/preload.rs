//! Loads that act before t = 0, and the contacts in equilibrium at t = 0.

use crate::contact::AnyRunningLaw;
use crate::contact::plane::PlaneMemory;

/// Static loads, and the contacts in equilibrium with them.
#[derive(Debug, Clone, Default)]
pub struct Preload {
    /// The static load on each node; empty without static loads. It is among the loads, too: it acts on.
    pub load: Vec<f64>,
    /// S of each contact in equilibrium; `None` without static loads, but for contacts at nodes without mass. Empty before it is found.
    pub forces: Vec<Option<f64>>,
    /// What the law of each contact remembers from the way to equilibrium; `None` for laws that remember nothing.
    pub laws: Vec<Option<AnyRunningLaw<1>>>,
    /// The same of contacts in a plane, by their first direction.
    pub planes: Vec<Option<PlaneMemory>>,
}

impl Preload {
    /// S of a contact in equilibrium; `None` without static loads, but for a contact at a node without mass.
    pub fn force(&self, contact: usize) -> Option<f64> {
        self.forces.get(contact).copied().flatten()
    }
}
