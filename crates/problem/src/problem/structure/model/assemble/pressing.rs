//! The parts that press a contact under construction.

use super::Draft;
use crate::contact::ContactKind;
use crate::problem::Violation;
use crate::problem::structure::parts::contact::{Contact, Normal, Pressing, PressingPart};
use crate::problem::structure::parts::contact_law::{law_named, pressing_laws};
use crate::system::structure::{PressedBy, PressingSpring, Spring};

impl Draft<'_> {
    /// What the normal force of a contact names, without nu.
    pub(super) fn pressed_by(&mut self, contact: &Contact) -> PressedBy {
        let mut pressing = PressedBy::default();
        let Some(Normal::Parts(parts)) = &contact.normal else {
            return pressing;
        };
        for part in parts {
            match part.part {
                Pressing::Contact(number) => {
                    self.check_presses(part, number);
                    pressing.contacts.push(number);
                }
                Pressing::Spring(number) => {
                    let spring = self.spring(number);
                    let nodes = self.numbering.nodes();
                    if spring.along.iter().any(|(node, _)| *node >= nodes) {
                        let message = format!(
                            "spring {} is at a support that moves and cannot be a normal force; give a spring between nodes, or an impact contact",
                            part.name
                        );
                        self.violations.push(violation(part, message));
                    }
                    let at_start = 0.0;
                    pressing.springs.push(PressingSpring { spring, at_start });
                }
            }
        }
        pressing
    }

    /// Only contacts that push have a normal force.
    fn check_presses(&mut self, part: &PressingPart, number: usize) {
        let other = self.template.contacts.get(number);
        let law = other.map_or("", |other| other.law.name(self.case));
        if law_named(law).is_some_and(|law| law.kind != ContactKind::Impact) {
            let laws: Vec<&str> = pressing_laws().collect();
            let message = format!(
                "contact {} with law {law} does not press; N may name springs, and contacts with law {}",
                part.name,
                laws.join(", ")
            );
            self.violations.push(violation(part, message));
        }
    }

    /// A spring of the list.
    pub(super) fn spring(&mut self, number: usize) -> Spring {
        let template = self.template;
        let spring = &template.springs[number];
        let along = self.along(&spring.along);
        let [k, c] = self.stiffness_and_dashpot(&spring.numbers);
        Spring { along, k, c }
    }
}

fn violation(part: &PressingPart, message: String) -> Violation {
    Violation {
        parameter: part.place.1.clone().into(),
        message,
        at: Some(part.place.0),
    }
}
