//! Rigid contacts that do not move.

use crate::contact::{ClippedLine, ContactKind};
use crate::exact::events::coordinates::model::Model;
use crate::exact::events::phases::contact_phase::Phase;
use crate::exact::events::phases::contact_state::ContactState;
use crate::exact::events::pieces::gaps::Gaps;
use crate::exact::events::pieces::scales::Scales;
use crate::exact::events::pieces::series::Series;

/// A contact that may stick or stay shut.
#[derive(Clone, Copy)]
pub struct RestingContact {
    /// The contact.
    pub contact: usize,
    /// Whether all orders of the force so far are at the lower bound, and at the upper one.
    pub at: [bool; 2],
    /// Whether it is a friction contact, or a stop.
    pub friction: bool,
    /// Of a friction contact: the limits that the lower bound and the upper one of its force are, over that of sliding.
    pub ratios: [f64; 2],
}

impl RestingContact {
    /// The contact slides, or is open; its force stays at the upper bound or at the lower one.
    pub fn leave(&self, upper: bool, states: &mut [ContactState]) {
        states[self.contact].phase = match self.friction {
            true => Phase::Sliding(if upper { 1.0 } else { -1.0 }),
            false => Phase::Open,
        };
    }
}

/// Contacts with rdot = 0, and r = 0 if they are stops, in phase closed; the others slide or are open. `loose` says which bounds of
/// friction forces are those of sliding, because the contacts have broken loose.
pub fn candidates(
    model: &Model,
    series: &Series,
    scales: &Scales,
    states: &mut [ContactState],
    loose: &[[bool; 2]],
) -> Vec<RestingContact> {
    let tolerance = scales.rate(series.length) * series.length;
    let mut candidates = Vec::new();
    for (contact, state) in states.iter_mut().enumerate() {
        let [r, change] = [0, 1].map(|k| series.contacts[contact].r[k]);
        match model.contacts[contact].law.line() {
            Some(ClippedLine::Stop { .. }) => {
                if r > scales.r(model, contact, series.length) || change > tolerance {
                    state.phase = Phase::Open;
                    continue;
                }
            }
            Some(ClippedLine::Coulomb) if state.phase == Phase::Open => continue,
            Some(ClippedLine::Coulomb) => {
                if change.abs() > tolerance {
                    state.phase = Phase::Sliding(1.0_f64.copysign(change));
                    continue;
                }
            }
            _ => continue,
        }
        state.phase = Phase::Closed;
        let law = &model.contacts[contact].law;
        let friction = law.kind() == ContactKind::Friction;
        candidates.push(RestingContact {
            contact,
            at: [friction, true],
            friction,
            ratios: loose[contact].map(|loose| if loose { 1.0 } else { law.static_ratio() }),
        });
    }
    candidates
}

/// Sets rdot of the candidates to 0, and r of stops. They are round-off, so that two passes over the contacts suffice.
pub fn stop(
    model: &Model,
    gaps: &Gaps,
    candidates: &[RestingContact],
    u: &mut [f64],
    v: &mut [f64],
) {
    for RestingContact {
        contact, friction, ..
    } in candidates.iter().chain(candidates)
    {
        let flexibility = model.flexibility(&[*contact])[0];
        if flexibility > 0.0 {
            let [moved, moving] = gaps.at(*contact, 0.0).unwrap_or_default();
            let rate = model.relative(*contact, v) + moving;
            model.subtract_force(*contact, rate / flexibility, v);
            if !friction {
                let r = model.relative(*contact, u) + (model.contacts[*contact].gap + moved);
                model.subtract_force(*contact, r / flexibility, u);
            }
        }
    }
}
