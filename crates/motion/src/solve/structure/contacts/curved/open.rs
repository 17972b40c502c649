//! Steps in which all impacts with laws that are not clipped lines stay open.
//!
//! Such an impact has no force while it is open, and at most steps all are. The other contacts are clipped lines, whose forces are found
//! in lanes. There the impact is a rigid stop: if it stays open, so does the impact with its law, since one set of forces solves both.

use super::contact::Contact;
use crate::contact::{ContactKind, WhichLaw};
use crate::system::structure::{Contact as GivenContact, Structure};

/// The impacts with laws that are not clipped lines, of a structure in which all else is.
#[derive(Debug, Clone)]
pub(crate) struct OpenImpacts(Vec<usize>);

impl OpenImpacts {
    /// `None` if a step with all of them open is not one of clipped lines.
    pub(super) fn new(structure: &Structure, pace: f64) -> Option<OpenImpacts> {
        let massless = structure.massless();
        let has_mass = |i: usize| structure.column(i).all(|(node, _)| !massless[node]);
        let contacts = &structure.contacts;
        let are_simple = contacts.iter().enumerate().all(|(i, contact)| {
            contact.law.row().is_none() && contact.law.static_ratio() <= 1.0 && has_mass(i)
        });
        let curved = contacts
            .iter()
            .enumerate()
            .filter(|(_, c)| c.law.is_curved());
        let impacts: Vec<(usize, &GivenContact)> = curved.collect();
        let have_no_force = impacts.iter().all(|(_, contact)| {
            let law = &contact.law;
            law.kind() == ContactKind::Impact && law.as_given().which() != WhichLaw::Own
        });
        let of_lines =
            pace.is_finite() && structure.chains().is_empty() && are_simple && have_no_force;
        of_lines.then(|| OpenImpacts(impacts.into_iter().map(|(i, _)| i).collect()))
    }

    /// Whether all are open without a force at the start of a step with these r and S.
    #[inline(always)]
    pub(super) fn begin_open(&self, start: impl Fn(usize) -> [f64; 2]) -> bool {
        self.0.iter().all(|i| {
            let [r, s] = start(*i);
            r > 0.0 && s == 0.0
        })
    }

    /// Ends a step with these forces, if all stay open in it; false if not. `terms` are the sizes of the terms of r and rdot. Nothing
    /// else changes that a law remembers.
    pub(super) fn end_open(
        &self,
        contacts: &mut [Contact],
        force: impl Fn(usize) -> f64,
        terms: impl Fn(usize) -> [f64; 2],
    ) -> bool {
        let stay_open = self.0.iter().all(|i| force(*i) == 0.0);
        for i in self.0.iter().filter(|_| stay_open) {
            let contact = &mut contacts[*i];
            if contact.now.properties().divides_by_closing_speed() {
                contact.take_terms(terms(*i));
            }
        }
        stay_open
    }
}
