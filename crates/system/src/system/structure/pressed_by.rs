//! The forces that press a friction contact: those of contacts that push, and of springs in compression.

use super::{Spring, Structure};

/// The normal force of a friction contact by other parts: the sum of max(-S, 0) over them, with S at the end of a step.
#[derive(Debug, Clone, Default)]
pub struct PressedBy {
    /// The coefficient of friction, by which the force is multiplied.
    pub nu: f64,
    /// The contacts, by their places in the list.
    pub contacts: Vec<usize>,
    /// The springs.
    pub springs: Vec<PressingSpring>,
}

/// A spring that presses.
#[derive(Debug, Clone)]
pub struct PressingSpring {
    /// The spring, between nodes and the ground.
    pub spring: Spring,
    /// Its compression force at t = 0.
    pub at_start: f64,
}

impl Spring {
    /// max(-S, 0) of S = k e + c e' for u and u' of the nodes.
    #[inline(always)]
    pub fn compression(&self, motion: impl Fn(usize) -> [f64; 2]) -> f64 {
        let mut force = 0.0;
        for (node, factor) in &self.along {
            let [u, v] = motion(*node);
            force += factor * (self.k * u + self.c * v);
        }
        (-force).max(0.0)
    }
}

impl PressedBy {
    /// nu N for the forces of contacts and of springs.
    pub fn limit(
        &self,
        contact: impl Fn(usize) -> f64,
        spring: impl Fn(&PressingSpring) -> f64,
    ) -> f64 {
        let of_contacts = self.contacts.iter().map(|c| (-contact(*c)).max(0.0));
        let of_springs = self.springs.iter().map(spring);
        self.nu * of_contacts.chain(of_springs).fold(0.0, |sum, n| sum + n)
    }
}

impl Structure {
    /// Gives the springs that press contacts their forces in the start of the structure.
    pub fn press_at_start(&mut self) {
        let (u, v) = (&self.displacement, &self.velocity);
        let limits = self
            .contacts
            .iter_mut()
            .filter_map(|contact| contact.law.limit_mut());
        for pressed in limits.filter_map(|limit| limit.pressed_by.as_mut()) {
            for pressing in &mut pressed.springs {
                pressing.at_start = pressing.spring.compression(|node| [u[node], v[node]]);
            }
        }
    }
}
