//! Friction contacts whose normal force other contacts and springs give.

use crate::exact::events::numerics::row::Row;
use crate::exact::events::phases::contact_state::Force;
use crate::system::structure::{Along, Structure};

/// A friction contact that others press.
#[derive(Debug)]
pub struct Pressed {
    /// The contact.
    pub contact: usize,
    /// Its coefficient of friction.
    pub nu: f64,
    /// The contacts that press it.
    pub contacts: Vec<usize>,
    /// The springs that press it.
    pub springs: Vec<PressingRow>,
}

/// A spring that presses: its extension in the coordinates of a model, k and c.
#[derive(Debug)]
pub struct PressingRow {
    pub row: Row,
    pub k: f64,
    pub c: f64,
}

impl Pressed {
    /// The contacts of a structure that others press; `row` gives a combination of the nodes in the coordinates of the model.
    pub fn of(structure: &Structure, row: impl Fn(&Along) -> Row) -> Vec<Pressed> {
        let contacts = structure.contacts.iter().enumerate();
        let pressed = contacts.filter_map(|(contact, given)| {
            let by = given.law.limit()?.pressed_by.as_ref()?;
            let springs = by.springs.iter().map(|pressing| PressingRow {
                row: row(&pressing.spring.along),
                k: pressing.spring.k,
                c: pressing.spring.c,
            });
            Some(Pressed {
                contact,
                nu: by.nu,
                contacts: by.contacts.clone(),
                springs: springs.collect(),
            })
        });
        pressed.collect()
    }

    /// nu k and nu c of what presses together, if the contact slides: its force changes by no more with the motion.
    pub fn slopes(&self, law: impl Fn(usize) -> Force) -> [f64; 2] {
        if !matches!(law(self.contact), Force::Limit(_)) {
            return [0.0; 2];
        }
        let springs = self.springs.iter().map(|spring| [spring.k.abs(), spring.c]);
        let pressing = self.contacts.iter().map(|contact| match law(*contact) {
            Force::Spring { k, .. } | Force::Line { slope: k, .. } => [k.abs(), 0.0],
            Force::Dashpot { c } => [0.0, c],
            Force::None | Force::Limit(_) | Force::Constraint => [0.0; 2],
        });
        let both = springs.chain(pressing);
        both.fold([0.0; 2], |sum, [k, c]| {
            [sum[0] + self.nu * k, sum[1] + self.nu * c]
        })
    }

    /// What constraints with these forces add to the limit.
    pub fn limit_by(&self, force: impl Fn(usize) -> Option<f64>) -> f64 {
        let forces = self.contacts.iter().filter_map(|contact| force(*contact));
        -self.nu * forces.sum::<f64>()
    }
}
