//! What the motions of supports add to those of nodes and contacts.

use super::Structure;

impl Structure {
    /// rdot of a contact at t = 0, with the velocities of the supports.
    pub fn rate_at_start(&self, contact: usize) -> f64 {
        let supports = self.supports.iter();
        let terms = supports.map(|support| support.gaps[contact] * support.motion.at(0.0)[1]);
        self.relative(contact, &self.velocity) + terms.sum::<f64>()
    }

    /// The acceleration by which supports move the gap of a contact at t = 0.
    pub fn gap_acceleration(&self, contact: usize) -> f64 {
        let supports = self.supports.iter();
        let terms = supports.map(|support| support.gaps[contact] * support.motion.at(0.0)[2]);
        terms.sum()
    }

    /// u (`which` = 0) or v (1) at time t of a node with the rest `w`, or of a support, whose numbers follow those of the nodes.
    pub fn total(&self, node: usize, t: f64, which: usize, w: &[f64]) -> f64 {
        if let Some(support) = node.checked_sub(self.len()) {
            return self.supports[support].motion.at(t)[which];
        }
        let supports = self.supports.iter();
        let carried = supports.map(|support| support.motion.at(t)[which] * support.carried[node]);
        carried.fold(w[node], |sum, x| sum + x)
    }
}
