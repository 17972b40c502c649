//! The phases after an event or a point of a table.

use super::motion::Motion;
use super::{Event, EventKind, EventsFault};
use crate::contact::ContactKind;
use crate::exact::events::coordinates::pressed::Pressed;
use crate::exact::events::numerics::least::Singular;
use crate::exact::events::phases::contact_phase::Phase;
use crate::exact::events::phases::contact_state::ContactState;
use crate::exact::events::phases::lines::End;
use crate::exact::events::pieces::watch::{Crossing, Found};
use crate::exact::events::transitions::rigid::{Constraints, impacts};
use crate::exact::events::transitions::rigid_phases::determine_rigid_phases;
use crate::exact::events::transitions::softened_phases::SoftenedPhases;

impl Motion<'_> {
    /// What changes the phases of softened contacts.
    pub fn review(&mut self) -> (SoftenedPhases<'_>, &mut [ContactState]) {
        let review = SoftenedPhases {
            model: &self.model,
            series: &self.series,
            scales: &self.scales,
            book: &mut self.book,
        };
        (review, &mut self.states)
    }

    /// The phases from t on.
    pub fn settle(&mut self, found: Option<Found>) -> Result<(), EventsFault> {
        let before: Vec<Phase> = self.states.iter().map(|state| state.phase).collect();
        self.begin();
        if let Some(found) = found {
            self.cross(&found);
        }
        self.turn_springs(found);
        let (mut review, states) = self.review();
        review.friction(true, states);
        let time = self.t;
        let singular = |Singular| EventsFault::Singular { time };
        self.series
            .couple(&self.model, &self.states)
            .map_err(singular)?;
        let mut contacts = self.model.contacts.iter();
        if contacts.any(|contact| contact.law.is_rigid()) {
            self.settle_rigid().map_err(singular)?;
        }
        self.length = self.model.piece_length(&self.states);
        for (contact, before) in before.into_iter().enumerate() {
            let phase = self.states[contact].phase;
            if phase != before {
                self.record(contact, EventKind::Phase(phase));
            }
        }
        Ok(())
    }

    /// Impulses first: they change who may stick.
    fn settle_rigid(&mut self) -> Result<(), Singular> {
        let Motion { model, v, .. } = self;
        let impacts = impacts(model, &self.series, &self.scales, &mut self.book, v)?;
        if !impacts.is_empty() {
            for (contact, rate) in impacts {
                self.close(rate);
                self.record(contact, EventKind::Impact { rate });
            }
            // Softened friction whose rdot has jumped beyond its phase has the next event, at the same time.
            self.begin();
        }
        let Motion {
            model,
            series,
            u,
            v,
            ..
        } = self;
        determine_rigid_phases(model, series, &self.scales, &mut self.states, [u, v])?;
        if !self.model.pressed.is_empty() {
            // Stops have their forces.
            let (mut review, states) = self.review();
            review.friction(false, states);
        }
        self.constraints = Constraints::new(&self.model, &self.states)?;
        Ok(())
    }

    /// The new phase of the contact of an event, if it is softened.
    fn cross(&mut self, found: &Found) {
        let contact = found.contact;
        let ratio = self.model.contacts[contact].law.static_ratio();
        if let (Crossing::Limit(direction), true) = (found.crossing, ratio > 1.0)
            && self.fall(contact, direction)
        {
            return;
        }
        let law = &self.model.contacts[contact].law;
        let closes = match found.crossing {
            Crossing::Touch => !law.is_rigid(),
            // A line without force of an impact.
            Crossing::Line(End::Low) => {
                self.states[contact].phase == Phase::Open && law.kind() == ContactKind::Impact
            }
            Crossing::Release
            | Crossing::Limit(_)
            | Crossing::Stop
            | Crossing::Normal
            | Crossing::Press(_)
            | Crossing::Line(_) => false,
        };
        if closes {
            self.close(self.series.contacts[contact].r[1] / self.series.length);
        }
        let (review, states) = self.review();
        review.cross(found, states);
    }

    /// A contact at a node without mass breaks loose in this direction: S falls by twice the difference of its limits at once, as with
    /// a small mass, and it sticks; false for another contact.
    fn fall(&mut self, contact: usize, direction: f64) -> bool {
        let Some(flexible) = &self.model.flexible else {
            return false;
        };
        if !flexible.contacts.contains(&contact) {
            return false;
        }
        let (ratio, state) = (
            self.model.contacts[contact].law.static_ratio(),
            &mut self.states[contact],
        );
        let after = direction * (2.0 - ratio) * self.series.contacts[contact].limit[0];
        let compliance = flexible.compliance[(contact, contact)];
        let moved = compliance * (state.force - after);
        self.book.dissipate(0.5 * moved * (state.force + after));
        state.origin = self.series.contacts[contact].r[0] + moved;
        state.force = after;
        self.series.known(contact, state.origin);
        self.begin();
        true
    }

    /// Springs that begin or end to press, and the limits of the contacts that they press.
    fn turn_springs(&mut self, found: Option<Found>) {
        let Motion {
            model,
            series,
            scales,
            states,
            ..
        } = self;
        if model.pressed.is_empty() {
            return;
        }
        let turned = found.and_then(|found| match found.crossing {
            Crossing::Press(spring) => {
                let of = |pressed: &Pressed| pressed.contact == found.contact;
                Some([model.pressed.iter().position(of)?, spring])
            }
            Crossing::Touch
            | Crossing::Release
            | Crossing::Limit(_)
            | Crossing::Stop
            | Crossing::Normal
            | Crossing::Line(_) => None,
        });
        let length = series.length;
        series.turn_springs(turned, |i, j| {
            let spring = &model.pressed[i].springs[j];
            scales.spring([spring.k, spring.c], length)
        });
        series.press(model, states);
    }

    /// A contact closes with rdot = `rate`.
    fn close(&mut self, rate: f64) {
        let least = self.least_impact_rate.unwrap_or(f64::INFINITY);
        self.least_impact_rate = Some(least.min(rate.abs()));
    }

    fn record(&mut self, contact: usize, kind: EventKind) {
        self.events.push(Event {
            time: self.t,
            contact,
            kind,
        });
    }
}
