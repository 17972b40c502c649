//! Which rigid contacts stick or stay shut.
//!
//! Their forces minimise 1/2 S^T A S - S^T d within their bounds, A = B^T M^-1 B, where d is r'' without them. A contact at its
//! limit with r'' = 0 is decided by r''', and so on: then the derivatives of its force have the bound.

use super::least::{Singular, least};
use super::model::Model;
use super::phase::{ContactState, Phase};

use super::scales::Scales;
use super::series::Series;
use crate::system::structure::Relation;

/// Orders of derivatives that decide. A friction contact undecided after them stays at its limit, because the loads do not change.
/// Where forces are not unique, the first order decides: a contact at its limit stays there, and others change.
const ORDERS: usize = 6;

/// Part of a force, or of an acceleration over its flexibility, that is taken as 0. If this decides wrongly, the next event
/// comes after a time of the same order.
const ZERO: f64 = 1e-9;

/// The same part of the largest force on a node.
const ROUND_OFF: f64 = 1e-14;

/// A contact that may stick or stay shut.
struct Candidate {
    contact: usize,
    /// Whether all orders of the force so far are at the lower bound, and at the upper one.
    at: [bool; 2],
    friction: bool,
}

impl Candidate {
    /// The contact slides, or is open; its force stays at the upper bound or at the lower one.
    fn leave(&self, upper: bool, states: &mut [ContactState]) {
        states[self.contact].phase = match self.friction {
            true => Phase::Sliding(if upper { 1.0 } else { -1.0 }),
            false => Phase::Open,
        };
    }
}

/// Decides the phases of rigid contacts; takes the round-off from the motion of those that do not move. `series` has begun.
pub fn decide(
    model: &Model,
    series: &mut Series,
    scales: &Scales,
    states: &mut [ContactState],
    [u, v]: [&mut [f64]; 2],
) -> Result<(), Singular> {
    let mut candidates = candidates(model, series, scales, states);
    if candidates.is_empty() {
        return Ok(());
    }
    stop(model, &candidates, u, v);
    series.begin(model, [series.start, series.length, series.phase], [u, v]);
    for order in 0..ORDERS {
        series.free_acceleration(order, model, states);
        decide_order(model, series, order, scales, states, &mut candidates)?;
        series.advance(order, model);
        if candidates
            .iter()
            .all(|candidate| candidate.at == [false; 2])
        {
            break;
        }
    }
    for candidate in &candidates {
        if candidate.at[0] != candidate.at[1] && candidate.friction {
            candidate.leave(candidate.at[1], states);
        }
    }
    Ok(())
}

/// Contacts with rdot = 0, and r = 0 if they are stops, in phase closed; the others slide or are open.
fn candidates(
    model: &Model,
    series: &Series,
    scales: &Scales,
    states: &mut [ContactState],
) -> Vec<Candidate> {
    let tolerance = scales.rate(series.length) * series.length;
    let mut candidates = Vec::new();
    for (contact, state) in states.iter_mut().enumerate() {
        let [r, change] = [0, 1].map(|k| series.contacts[contact].r[k]);
        match model.structure.contacts[contact].law {
            Relation::RigidStop { .. } => {
                if r > scales.r(model, contact) || change > tolerance {
                    state.phase = Phase::Open;
                    continue;
                }
            }
            Relation::Coulomb { .. } if state.phase == Phase::Open => continue,
            Relation::Coulomb { .. } => {
                if change.abs() > tolerance {
                    state.phase = Phase::Sliding(1.0_f64.copysign(change));
                    continue;
                }
            }
            _ => continue,
        }
        state.phase = Phase::Closed;
        let friction = model.structure.contacts[contact].law.limit().is_some();
        candidates.push(Candidate {
            contact,
            at: [friction, true],
            friction,
        });
    }
    candidates
}

/// Sets rdot of the candidates to 0, and r of stops. They are round-off, so that two passes over the contacts suffice.
fn stop(model: &Model, candidates: &[Candidate], u: &mut [f64], v: &mut [f64]) {
    for Candidate {
        contact, friction, ..
    } in candidates.iter().chain(candidates)
    {
        let flexibility = model.flexibility(&[*contact])[0];
        if flexibility > 0.0 {
            let rate = model.relative(*contact, v);
            model.subtract_force(*contact, rate / flexibility, v);
            if !friction {
                let r = model.relative(*contact, u) + model.structure.contacts[*contact].gap;
                model.subtract_force(*contact, r / flexibility, u);
            }
        }
    }
}

/// The forces of one order, and the contacts that they decide.
fn decide_order(
    model: &Model,
    series: &mut Series,
    order: usize,
    scales: &Scales,
    states: &mut [ContactState],
    candidates: &mut Vec<Candidate>,
) -> Result<(), Singular> {
    let contacts: Vec<usize> = candidates
        .iter()
        .map(|candidate| candidate.contact)
        .collect();
    let m = contacts.len();
    let flexibility = model.flexibility(&contacts);
    let [mut d, mut low, mut high, mut force] = [(); 4].map(|()| vec![0.0; m]);
    for (i, candidate) in candidates.iter().enumerate() {
        d[i] = series.relative_acceleration(candidate.contact, model);
        let limit = if candidate.friction {
            series.contacts[candidate.contact].limit[order]
        } else {
            0.0
        };
        // Below 0 by round-off.
        let limit = if candidate.at == [true; 2] {
            limit.max(0.0)
        } else {
            limit
        };
        low[i] = if candidate.at[0] {
            -limit
        } else {
            f64::NEG_INFINITY
        };
        high[i] = if candidate.at[1] {
            limit
        } else {
            f64::INFINITY
        };
    }
    let size: Vec<f64> = d.iter().map(|d| d.abs()).collect();
    let bounds = [low, high];
    let unique = least(flexibility.clone(), &d, &bounds, &size, &mut force)?;
    let [low, high] = bounds;
    for (contact, force) in contacts.iter().zip(&force) {
        series.apply(order, *contact, *force, model);
    }
    let largest = (0..m).map(|i| force[i].abs().max(d[i].abs() / flexibility[i * m + i]));
    let zero = ZERO * largest.fold(0.0, f64::max) + ROUND_OFF * scales.force();
    let mut i = 0..m;
    candidates.retain_mut(|candidate| {
        let i = i.next().unwrap_or_default();
        let left = series.relative_acceleration(candidate.contact, model) / flexibility[i * m + i];
        let [over, under] = [force[i] - low[i], high[i] - force[i]];
        if left.abs() > zero && candidate.at[usize::from(left > 0.0)] {
            candidate.leave(left > 0.0, states);
            return false;
        }
        let both = candidate.at == [true; 2] && order > 0;
        candidate.at[0] &= over <= zero;
        candidate.at[1] &= under <= zero;
        let one = candidate.at[0] != candidate.at[1];
        // The second case is a limit that starts at 0.
        if !unique && (one || both) {
            let upper = if one {
                candidate.at[1]
            } else {
                force[i] >= 0.0
            };
            candidate.leave(upper, states);
            return false;
        }
        true
    });
    Ok(())
}
