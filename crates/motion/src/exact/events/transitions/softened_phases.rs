//! Phases after an event, a point of a table or an impact: limits that become positive, 0 or jump, and softened laws.

use crate::contact::{ClippedLine, ContactKind};
use crate::exact::events::coordinates::model::Model;
use crate::exact::events::coordinates::pressed::Pressed;
use crate::exact::events::phases::contact_phase::Phase;
use crate::exact::events::phases::contact_state::ContactState;
use crate::exact::events::phases::lines;
use crate::exact::events::pieces::book::Book;
use crate::exact::events::pieces::scales::Scales;
use crate::exact::events::pieces::series::Series;
use crate::exact::events::pieces::watch::{Crossing, Found};

/// What a review works on: a piece that has begun, and the phases.
pub struct SoftenedPhases<'a> {
    pub model: &'a Model<'a>,
    pub series: &'a Series,
    pub scales: &'a Scales,
    pub book: &'a mut Book,
}

impl SoftenedPhases<'_> {
    /// The phases of softened contacts at t = 0.
    pub fn start(&self, states: &mut [ContactState]) {
        for (i, state) in states.iter_mut().enumerate() {
            let r = self.series.contacts[i].r[0];
            if let Some(lines) = lines::of(&self.model.contacts[i].law) {
                let force = self.model.structure.preload.force(i);
                *state = ContactState::on(lines.start(r, force), r);
                continue;
            }
            state.origin = r;
            let at_rest = self.model.structure.preload.force(i);
            let line = self.model.contacts[i].law.line();
            if let (Some(ClippedLine::Elastic { stiffness }), Some(force)) = (line, at_rest) {
                state.phase = Phase::Closed;
                state.origin = r - force / stiffness;
                state.force = force;
            }
            if let Some(ClippedLine::Spring { stiffness }) = line
                && r < 0.0
            {
                state.phase = Phase::Closed;
                // Nodes without mass move at once: their forces come with the first piece.
                state.force = if stiffness.is_finite() {
                    stiffness * r
                } else {
                    0.0
                };
            }
        }
    }

    /// The new phase of the contact of an event. Rigid contacts and limits that change their sign are left to the other steps.
    pub fn cross(&self, found: &Found, states: &mut [ContactState]) {
        let i = found.contact;
        let (series, state) = (&self.series.contacts[i], &mut states[i]);
        if let (Crossing::Line(end), Some(line), Some(lines)) = (
            found.crossing,
            state.line,
            lines::of(&self.model.contacts[i].law),
        ) {
            *state = ContactState::on(lines.next(&line, end, series.r[0]), series.r[0]);
            return;
        }
        let Some(line) = self.model.contacts[i].law.line() else {
            return;
        };
        use ClippedLine::{Elastic, Spring, Viscous};
        match (line, found.crossing) {
            (Spring { .. }, Crossing::Touch) => state.phase = Phase::Closed,
            (Spring { .. }, Crossing::Release) => state.phase = Phase::Open,
            (Elastic { .. } | Viscous { .. }, Crossing::Limit(direction)) => {
                state.phase = Phase::Sliding(direction);
            }
            (Elastic { stiffness }, Crossing::Stop) => {
                state.origin = series.r[0] - state.force / stiffness;
                state.phase = Phase::Closed;
            }
            (Viscous { .. }, Crossing::Stop) => state.phase = Phase::Closed,
            _ => {}
        }
    }

    /// Friction contacts that open or close, or whose limit or rdot has jumped. Before impacts, stops that touch may press.
    pub fn friction(&mut self, before_impacts: bool, states: &mut [ContactState]) {
        let presses: Vec<bool> = (0..states.len())
            .map(|i| self.presses(i, before_impacts, states))
            .collect();
        for (i, state) in states.iter_mut().enumerate() {
            let law = &self.model.contacts[i].law;
            if law.kind() != ContactKind::Friction || state.line.is_some() {
                continue;
            }
            if !presses[i] {
                self.drop_force(i, state, 0.0);
                state.phase = Phase::Open;
                continue;
            }
            match law.line() {
                Some(ClippedLine::Elastic { stiffness }) => {
                    self.displacement_control(i, stiffness, state);
                }
                Some(ClippedLine::Viscous { viscosity }) => {
                    self.velocity_control(i, viscosity, state);
                }
                _ if state.phase == Phase::Open => {
                    state.phase = Phase::Sliding(1.0_f64.copysign(self.series.contacts[i].r[1]));
                }
                _ => {}
            }
        }
    }

    /// Whether the limit is positive or becomes so.
    fn presses(&self, contact: usize, before_impacts: bool, states: &[ContactState]) -> bool {
        let of = |pressed: &Pressed| pressed.contact == contact;
        if let Some(i) = self.model.pressed.iter().position(of) {
            let mut springs = self.series.springs[i].iter();
            let contacts = &self.model.pressed[i].contacts;
            return springs.any(|spring| spring.presses)
                || contacts.iter().any(|i| {
                    let is_stop = self.model.contacts[*i].law.is_stop();
                    states[*i].phase != Phase::Open || before_impacts && is_stop && self.touches(*i)
                });
        }
        let tolerance = self.scales.limit(contact);
        let limit = self.series.contacts[contact].limit.iter();
        limit
            .into_iter()
            .find(|l| l.abs() > tolerance)
            .is_some_and(|l| *l > 0.0)
    }

    fn touches(&self, contact: usize) -> bool {
        let tolerance = self.scales.r(self.model, contact, self.series.length);
        self.series.contacts[contact].r[0] <= tolerance
    }

    fn displacement_control(&mut self, i: usize, k: f64, state: &mut ContactState) {
        let series = &self.series.contacts[i];
        let [r, change] = [series.r[0], k * series.r[1]];
        // Above 1 only at nodes without mass, where the contact always sticks.
        let ratio = self.model.contacts[i].law.static_ratio();
        let limit = ratio * series.limit[0].max(0.0);
        let tolerance = self.scales.contact_force(self.model, i, self.series.length);
        match state.phase {
            Phase::Open => {
                state.origin = r;
                state.phase = Phase::Closed;
                if limit <= self.scales.limit(i) && change.abs() > series.limit[1].max(0.0) {
                    state.phase = Phase::Sliding(1.0_f64.copysign(change));
                }
            }
            Phase::Closed | Phase::Sliding(_) => {
                if state.force.abs() > limit + tolerance {
                    self.drop_force(i, state, limit);
                    state.phase = Phase::Sliding(1.0_f64.copysign(state.force));
                } else if state.force.abs() < limit - tolerance && state.phase != Phase::Closed {
                    state.origin = r - state.force / k;
                    state.phase = Phase::Closed;
                }
            }
        }
    }

    /// The friction spring relaxes to a smaller force; S^2/2k falls by the work of the slip.
    fn drop_force(&mut self, i: usize, state: &mut ContactState, limit: f64) {
        if let Some(ClippedLine::Elastic { stiffness }) = self.model.contacts[i].law.line() {
            let force = state.force;
            self.book.dissipate(
                0.5 * (force - limit) * (force + limit) / self.model.stiffness_of(i, stiffness),
            );
            state.force = limit.copysign(force);
        }
    }

    fn velocity_control(&self, i: usize, c: f64, state: &mut ContactState) {
        let series = &self.series.contacts[i];
        let force = c * series.r[1] / self.series.length;
        let limit = series.limit[0].max(0.0);
        let tolerance = self.scales.contact_force(self.model, i, self.series.length);
        let closed = if force.abs() > limit + tolerance {
            Phase::Sliding(1.0_f64.copysign(force))
        } else {
            Phase::Closed
        };
        match state.phase {
            Phase::Sliding(direction) if direction * force >= limit - tolerance => {}
            Phase::Open | Phase::Closed | Phase::Sliding(_) => state.phase = closed,
        }
    }
}
