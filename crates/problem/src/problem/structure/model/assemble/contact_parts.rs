//! The contacts of a structure under construction.

use super::{Detail, Draft};
use crate::contact::{ClippedLine, plane};
use crate::problem::Violation;
use crate::problem::structure::parts::contact_law::{relation, violation};
use crate::system::structure::{Contact, Limit, PlaneRow, StructureLaw};

impl Draft<'_> {
    pub(super) fn contacts(&mut self) {
        let contacts = &self.template.contacts;
        for (i, contact) in contacts.iter().enumerate() {
            let along = self.along(&contact.along);
            let nodes = self.numbering.nodes();
            let is_held = along.is_empty() && contact.row.is_some();
            if along.is_empty() && !is_held && self.violations.is_empty() {
                let message = "a contact needs two different nodes";
                self.violations.push(violation(contact, message));
            }
            let is_driven = along.iter().all(|(node, _)| *node >= nodes);
            let gap = self.optional(&contact.gap);
            let pressed_by = self.pressed_by(contact);
            let law = relation(
                contact,
                self.case,
                self.template.metre,
                (pressed_by, self.detail == Detail::Whole),
            );
            let law_in_plane = law.and_then(|law| self.in_plane(law, i, is_held));
            if let Some(law) = self.checked(law_in_plane) {
                if is_driven && !is_held && self.violations.is_empty() && law.is_rigid() {
                    let message = "a contact between supports, or of a support and the ground, needs a law with a stiffness or a damper";
                    self.violations.push(violation(contact, message));
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

    /// The law of a direction of a contact in a plane; of another contact the law itself. Where one direction is held, the other one has the
    /// scalar law, and this one no force.
    fn in_plane(
        &mut self,
        law: StructureLaw,
        i: usize,
        is_held: bool,
    ) -> Result<StructureLaw, Violation> {
        let contacts = &self.template.contacts;
        let contact = &contacts[i];
        let Some(row) = contact.row else {
            return Ok(law);
        };
        let name = contact.law.name(self.case);
        let Some([first, second]) = law.clone().in_plane() else {
            let names = plane::names().collect::<Vec<_>>().join(", ");
            let message = format!("{name} does not act in a plane; allowed: {names}");
            return Err(violation(contact, message));
        };
        if is_held {
            let line = ClippedLine::Elastic { stiffness: 1.0 };
            return Ok(StructureLaw::new(line, Limit::constant(0.0)));
        }
        let other = match row {
            PlaneRow::First => i + 1,
            PlaneRow::Second => i - 1,
        };
        if self.along(&contacts[other].along).is_empty() {
            return Ok(law);
        }
        Ok(match row {
            PlaneRow::First => first,
            PlaneRow::Second => second,
        })
    }

    /// A rigid contact must not overlap at t = 0: it would part at a speed of overlap over time step.
    pub(super) fn overlaps(&mut self) {
        if !self.violations.is_empty() {
            return;
        }
        for (c, contact) in self.template.contacts.iter().enumerate() {
            let placed = &self.structure.contacts[c];
            let r = self.structure.relative(c, &self.structure.displacement) + placed.gap;
            if placed.law.is_stop() && r < 0.0 {
                let message = format!("a rigid contact must start with r >= 0, got {r}");
                self.violations.push(violation(contact, message));
            }
        }
    }
}
