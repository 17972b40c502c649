//! The contacts of a structure under construction.

use super::{Detail, Draft};
use crate::problem::structure::contacts;
use crate::system::structure::{Contact, StructureLaw};

impl Draft<'_> {
    pub(super) fn contacts(&mut self) {
        for contact in &self.template.contacts {
            let along = self.along(&contact.along);
            let nodes = self.numbering.nodes();
            if along.is_empty() && self.violations.is_empty() {
                let message = "a contact needs two different nodes";
                self.violations.push(contacts::violation(contact, message));
            }
            let is_driven = along.iter().all(|(node, _)| *node >= nodes);
            let gap = self.optional(&contact.gap);
            let law = contacts::relation(
                contact,
                self.case,
                self.template.metre,
                self.detail == Detail::Whole,
            );
            if let Some(law) = self.checked(law) {
                if is_driven && self.violations.is_empty() && law.is_rigid() {
                    let message = "a contact between supports, or of a support and the ground, needs a law with a stiffness or a damper";
                    self.violations.push(contacts::violation(contact, message));
                }
                self.structure.contacts.push(Contact {
                    name: contact.name.clone(),
                    along,
                    gap,
                    law,
                });
            }
        }
    }

    /// A rigid contact must not overlap at t = 0: it would part at a speed of overlap over time step.
    pub(super) fn overlaps(&mut self) {
        if !self.violations.is_empty() {
            return;
        }
        for (c, contact) in self.template.contacts.iter().enumerate() {
            let own = &self.structure.contacts[c];
            let r = self.structure.relative(c, &self.structure.displacement) + own.gap;
            if matches!(own.law, StructureLaw::RigidStop { .. }) && r < 0.0 {
                let message = format!("a rigid contact must start with r >= 0, got {r}");
                self.violations.push(contacts::violation(contact, message));
            }
        }
    }
}
