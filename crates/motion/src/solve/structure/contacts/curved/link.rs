//! A link of a chain: a contact, or several side by side, as one contact.
//!
//! Contacts side by side have one change, from which the force of each follows; their sum is the force of the link. Contacts without
//! compliance have the rest of it while they hold, and share it alike as far as they can.

use super::contact::Contact;
use super::step::{Motion, ROUND_OFF};
use crate::contact::ClippedLine;
use crate::solve::structure::contacts::series_root::filled;

/// Contacts with their signs, as [`crate::system::structure::Member`].
pub(crate) type Link = Vec<(usize, f64)>;

/// The first contact of a link, which has the motion of the link.
pub(crate) fn leader(link: &[(usize, f64)]) -> (usize, f64) {
    link[0]
}

/// Bounds of a force in the signs of the link.
fn turned([low, high]: [f64; 2], sign: f64) -> [f64; 2] {
    if sign < 0.0 {
        [-high, -low]
    } else {
        [low, high]
    }
}

/// Bounds of the force of a link.
pub(crate) fn bounds(link: &[(usize, f64)], contacts: &[Contact]) -> [f64; 2] {
    let bounds = link
        .iter()
        .map(|(i, sign)| turned(contacts[*i].bounds, *sign));
    let sum = bounds.reduce(|[low, high], [l, h]| [low + l, high + h]);
    sum.unwrap_or([0.0; 2])
}

/// The flexibility with which a link answers.
pub(crate) fn own(link: &[(usize, f64)], contacts: &[Contact]) -> f64 {
    match *link {
        [(i, _)] => contacts[i].own,
        _ => 0.0,
    }
}

/// The change of a link in the step before.
pub(crate) fn change(link: &[(usize, f64)], contacts: &[Contact]) -> f64 {
    let (i, sign) = leader(link);
    sign * contacts[i].change
}

/// The change of a link under a force, and how it changes with the force; `None` where a search finds it.
pub(crate) fn change_under(
    link: &[(usize, f64)],
    force: f64,
    contacts: &[Contact],
) -> Option<[f64; 2]> {
    let [(i, sign)] = *link else {
        return None;
    };
    let [change, slope] = change_of(&contacts[i], sign * force)?;
    Some([sign * change, slope])
}

/// The change of r under a force within its bounds, and how it changes with the force; `None` where a search finds it.
fn change_of(contact: &Contact, force: f64) -> Option<[f64; 2]> {
    let [low, high] = contact.bounds;
    if !(low < force && force < high) || contact.two_limits {
        return None;
    }
    let Motion { change, rate, .. } = contact.motion;
    let [under, slope] = match contact.relation.line() {
        Some(ClippedLine::Elastic { stiffness }) => {
            return Some([(force - contact.motion.force) / stiffness, 1.0 / stiffness]);
        }
        Some(ClippedLine::Spring { stiffness }) => {
            let change = force / stiffness - contact.motion.displacement;
            return Some([change, 1.0 / stiffness]);
        }
        Some(ClippedLine::Viscous { viscosity }) => [force / viscosity, 1.0 / viscosity],
        Some(ClippedLine::Stop { .. } | ClippedLine::Coulomb) | None => {
            contact.now.properties().rate_under(force)?
        }
    };
    let pace = contact.scale.pace;
    let change = change + (under - rate) / pace;
    (!contact.scale.is_explicit()).then_some([change, slope / pace])
}

/// S of a link at the start of the step.
pub(crate) fn force(link: &[(usize, f64)], contacts: &[Contact]) -> f64 {
    let terms = link
        .iter()
        .map(|(i, sign)| sign * contacts[*i].motion.force);
    terms.reduce(|sum, term| sum + term).unwrap_or(0.0)
}

/// The gap that a link has to close until all its contacts push: none where others than impacts are among them.
pub(crate) fn open(link: &[(usize, f64)], contacts: &[Contact]) -> f64 {
    let gaps = link.iter().map(|(i, _)| contacts[*i].open());
    gaps.fold(f64::INFINITY, f64::min)
}

/// S of a link under y, of several contacts where they change by y.
pub(crate) fn answer(link: &[(usize, f64)], y: f64, contacts: &[Contact]) -> f64 {
    if let [(i, sign)] = *link {
        return sign * contacts[i].answer(sign * y);
    }
    let forces = link
        .iter()
        .map(|(i, sign)| sign * contacts[*i].follow(sign * y));
    forces.sum()
}

/// The forces of several contacts that change by this under a force, in the signs of the link.
pub(crate) fn forces(
    link: &[(usize, f64)],
    change: f64,
    force: f64,
    contacts: &[Contact],
) -> Vec<f64> {
    let free: Vec<Option<[f64; 2]>> = link
        .iter()
        .map(|(i, sign)| {
            let contact = &contacts[*i];
            let bounds = contact.free_force(sign * change, ROUND_OFF * contact.motion.size);
            bounds.map(|bounds| turned(bounds, *sign))
        })
        .collect();
    let mut forces: Vec<f64> = link
        .iter()
        .zip(&free)
        .map(|((i, sign), free)| match free {
            Some(_) => 0.0,
            None => sign * contacts[*i].follow(sign * change),
        })
        .collect();
    let intervals: Vec<[f64; 2]> = free.iter().flatten().copied().collect();
    if !intervals.is_empty() {
        let rest = filled(&intervals, force - forces.iter().sum::<f64>());
        let holds = forces
            .iter_mut()
            .zip(&free)
            .filter(|(_, free)| free.is_some());
        for ((to, _), rest) in holds.zip(rest) {
            *to = rest;
        }
    }
    forces
}

/// 1/f' of a link that changes by this under a force.
pub(crate) fn compliance(
    link: &[(usize, f64)],
    change: f64,
    force: f64,
    width: f64,
    contacts: &[Contact],
) -> f64 {
    let of = |(i, sign): (usize, f64), force: f64| {
        let contact = &contacts[i];
        let force = sign * force;
        let g = contact.compliance(sign * change + contact.own * force, force, width);
        if g >= 0.0 { g } else { f64::INFINITY }
    };
    if let [member] = *link {
        return of(member, force);
    }
    let forces = forces(link, change, force, contacts);
    let stiffness = link
        .iter()
        .zip(forces)
        .map(|(member, s)| 1.0 / of(*member, s));
    1.0 / stiffness.sum::<f64>()
}
