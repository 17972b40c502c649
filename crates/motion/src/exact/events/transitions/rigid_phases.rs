//! Which rigid contacts stick or stay shut.
//!
//! Their forces minimise 1/2 S^T A S - S^T d within their bounds, A = B^T M^-1 B, where d is r'' without them. A contact at its
//! limit with r'' = 0 is decided by r''', and so on: then the derivatives of its force have the bound.
//!
//! A contact that leaves its static limit breaks loose: its force falls to the limit of sliding. All that do so at one time break loose
//! together, and the forces are found again, as in a step (`solve/structure/static_friction.rs`).

use super::resting_contact::{RestingContact, candidates, stop};
use super::rigid::{SAME, rounds};
use crate::exact::events::coordinates::model::Model;
use crate::exact::events::numerics::least::{Singular, least};
use crate::exact::events::phases::contact_state::{ContactState, Force};
use crate::exact::events::pieces::scales::Scales;
use crate::exact::events::pieces::series::Series;

/// Orders of derivatives that decide. A friction contact undecided after them stays at its limit, because the loads do not change.
/// Where forces are not unique, the first order decides: a contact at its limit stays there, and others change.
const ORDERS: usize = 6;

/// Part of a force, or of an acceleration over its flexibility, that is taken as 0. If this decides wrongly, the next event
/// comes after a time of the same order.
const ZERO: f64 = 1e-9;

/// The same part of the largest force on a node. It is larger than the tolerance of events.
const ROUND_OFF: f64 = 1e-11;

/// Decides the phases of rigid contacts; takes the round-off from the motion of those that do not move. `series` has begun.
pub fn determine_rigid_phases(
    model: &Model,
    series: &mut Series,
    scales: &Scales,
    states: &mut [ContactState],
    [u, v]: [&mut [f64]; 2],
) -> Result<(), Singular> {
    let mut loose = vec![[false; 2]; states.len()];
    while determine(
        model,
        series,
        scales,
        states,
        [&mut *u, &mut *v],
        &mut loose,
    )? {}
    Ok(())
}

/// The phases with these bounds of friction; returns whether more contacts break loose, which changes the bounds.
fn determine(
    model: &Model,
    series: &mut Series,
    scales: &Scales,
    states: &mut [ContactState],
    [u, v]: [&mut [f64]; 2],
    loose: &mut [[bool; 2]],
) -> Result<bool, Singular> {
    let mut candidates = candidates(model, series, scales, states, loose);
    if candidates.is_empty() {
        return Ok(false);
    }
    let mut breaks = false;
    stop(model, &series.gaps, &candidates, u, v);
    series.begin(model, [series.start, series.length, series.phase], [u, v]);
    series.press(model, states);
    for order in 0..ORDERS {
        series.free_acceleration(order, model, states);
        let left = decide_order(model, series, order, scales, states, &mut candidates)?;
        for (candidate, upper) in left {
            let end = usize::from(upper);
            if candidate.ratios[end] > 1.0 {
                loose[candidate.contact][end] = true;
                breaks = true;
            }
        }
        if breaks {
            return Ok(true);
        }
        series.advance(order, model);
        if candidates
            .iter()
            .all(|candidate| candidate.at == [false; 2])
        {
            break;
        }
    }
    for candidate in &candidates {
        let end = usize::from(candidate.at[1]);
        // At its static limit a contact sticks.
        let slides = candidate.friction && candidate.ratios[end] == 1.0;
        if candidate.at[0] != candidate.at[1] && slides {
            candidate.leave(candidate.at[1], states);
        }
    }
    Ok(false)
}

/// The forces of one order, and the contacts that they decide; those that leave their bounds, and whether it is the upper one.
fn decide_order(
    model: &Model,
    series: &mut Series,
    order: usize,
    scales: &Scales,
    states: &mut [ContactState],
    candidates: &mut Vec<RestingContact>,
) -> Result<Vec<(RestingContact, bool)>, Singular> {
    let contacts: Vec<usize> = candidates
        .iter()
        .map(|candidate| candidate.contact)
        .collect();
    let m = contacts.len();
    let flexibility = model.flexibility(&contacts);
    let [mut d, low, high, mut force] = [(); 4].map(|()| vec![0.0; m]);
    let mut limits = vec![0.0; m];
    for (i, candidate) in candidates.iter().enumerate() {
        d[i] = series.relative_acceleration(candidate.contact, model);
        if candidate.friction {
            limits[i] = series.contacts[candidate.contact].limit[order];
        }
    }
    let size: Vec<f64> = d.iter().map(|d| d.abs()).collect();
    let place = |contact: usize| contacts.iter().position(|i| *i == contact);
    let mut unique = true;
    // What stops among the candidates add to each limit.
    let mut added = vec![0.0; model.pressed.len()];
    let mut bounds = [low, high];
    rounds(|| {
        for (i, candidate) in candidates.iter().enumerate() {
            let [low, high] = &mut bounds;
            // Below 0 by round-off.
            let limit = match candidate.at {
                [true, true] => limits[i].max(0.0),
                _ => limits[i],
            };
            let [least, most] = candidate.ratios.map(|ratio| ratio * limit);
            low[i] = if candidate.at[0] {
                -least
            } else {
                f64::NEG_INFINITY
            };
            high[i] = if candidate.at[1] { most } else { f64::INFINITY };
        }
        unique = least(flexibility.clone(), &d, &bounds, &size, &mut force)?;
        let mut changes = false;
        for (pressed, added) in model.pressed.iter().zip(&mut added) {
            let more = pressed.limit_by(|contact| Some(force[place(contact)?]));
            let change = more - *added;
            if change.abs() <= SAME * more.abs() {
                continue;
            }
            (*added, changes) = (more, true);
            if let Some(i) = place(pressed.contact) {
                limits[i] += change;
            } else if let Force::Limit(direction) =
                states[pressed.contact].law(&model.contacts[pressed.contact].law)
            {
                for (d, contact) in d.iter_mut().zip(&contacts) {
                    let coupling = model.flexibility(&[*contact, pressed.contact])[1];
                    *d -= coupling * direction * change;
                }
            }
        }
        Ok(changes)
    })?;
    let [low, high] = bounds;
    for (contact, force) in contacts.iter().zip(&force) {
        series.apply(order, *contact, *force, model);
    }
    if !model.pressed.is_empty() {
        series.press_by_constraints(order, model, states, |contact| Some(force[place(contact)?]));
    }
    let largest = (0..m)
        .map(|i| force[i].abs().max(d[i].abs() / flexibility[i * m + i]))
        .fold(0.0, f64::max);
    // A force changes by this part over the round-off of t.
    let instant = 4.0 * f64::EPSILON * series.start / series.length;
    let round_off = (ROUND_OFF + instant) * scales.force();
    let zero = ZERO * largest + round_off;
    let mut i = 0..m;
    let mut gone = Vec::new();
    candidates.retain_mut(|candidate| {
        let i = i.next().unwrap_or_default();
        let left = series.relative_acceleration(candidate.contact, model) / flexibility[i * m + i];
        let [over, under] = [force[i] - low[i], high[i] - force[i]];
        if left.abs() > zero && candidate.at[usize::from(left > 0.0)] {
            candidate.leave(left > 0.0, states);
            gone.push((*candidate, left > 0.0));
            return false;
        }
        let both = candidate.at == [true; 2] && order > 0;
        candidate.at[0] &= over <= zero;
        candidate.at[1] &= under <= zero;
        let one = candidate.at[0] != candidate.at[1];
        // The second case is a limit that starts at 0. Without any force, the next order decides.
        let loaded = order > 0 || largest > round_off;
        if !unique && loaded && (one || both) {
            let upper = if one {
                candidate.at[1]
            } else {
                force[i] >= 0.0
            };
            candidate.leave(upper, states);
            gone.push((*candidate, upper));
            return false;
        }
        true
    });
    Ok(gone)
}
