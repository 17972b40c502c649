//! Laws of users' programs.

use super::contact::Contact;
use crate::contact::{ContactResponse, OwnFault, WhichLaw};

/// Largest difference between the force of a step and the answer of a law of a user's program to it: the search for the forces of many
/// contacts ends at 1e-12 of their sum.
const SAME: f64 = 1e-8;

impl Contact {
    /// Why the force of a law of a user's program is not taken, after a step with this force; without one, why its answer to the motion
    /// without forces is not.
    pub(crate) fn own_fault(&mut self, force: Option<f64>) -> Option<OwnFault> {
        if self.now.which() != WhichLaw::Own {
            return None;
        }
        let Some(force) = force else {
            let mut law = self.law;
            ContactResponse::force(&mut law, 0, &self.trial(self.motion.change));
            return law.own_fault();
        };
        let differs = (self.answered - force).abs() > SAME * force.abs().max(self.answered.abs());
        self.law
            .own_fault()
            .or(differs.then_some(OwnFault::NoAnswer))
    }
}
