//! Impacts that are closed at t = 0.

use super::doubt::Doubt;
use crate::contact::{ClippedLine, ContactKind};
use crate::problem::numbers::short::short;
use crate::solve::Warning;
use crate::solve::structure::forces_at_start;
use crate::system::structure::{Contact, Structure};

/// Smaller overlaps, as a share of the largest gap or displacement, are round-off.
const ROUND_OFF: f64 = 1e-9;

/// The impact with the largest overlap at t = 0, if no static equilibrium was found for it.
pub fn closed(structure: &Structure) -> Option<Doubt> {
    // Static loads put all contacts in equilibrium.
    if !structure.preload.load.is_empty() {
        return None;
    }
    let largest = largest_length(structure);
    let numbered = structure.contacts.iter().enumerate();
    let impacts = numbered.filter(|(_, contact)| contact.law.kind() == ContactKind::Impact);
    let displacements = impacts.map(|(index, contact)| {
        (
            index,
            contact,
            structure.relative(index, &structure.displacement),
        )
    });
    let overlaps = displacements.map(|(index, contact, r)| (index, contact, -(r + contact.gap)));
    let (index, contact, overlap) = overlaps
        .filter(|(.., overlap)| *overlap > ROUND_OFF * largest)
        .max_by(|a, b| a.2.total_cmp(&b.2))?;
    let pressing = forces_at_start(structure).map_or(0.0, |forces| -forces[index]);
    let force = match contact.law.is_rigid() {
        true => String::new(),
        false => format!(" and presses with {}", short(pressing)),
    };
    let text = format!(
        "contact {} overlaps by {} at t = 0{force}",
        contact.name,
        short(overlap)
    );
    Some((Warning::ClosedAtStart, text))
}

/// A rigid impact that touches at t = 0 and shares a body with another one, if one of both bounces.
pub fn at_once(structure: &Structure) -> Option<Doubt> {
    let restitution = |contact: &Contact| {
        let Some(ClippedLine::Stop { restitution }) = contact.law.line() else {
            return None;
        };
        Some(restitution)
    };
    let numbered = structure.contacts.iter().enumerate();
    let stops: Vec<(usize, &Contact, f64)> = numbered
        .filter_map(|(index, contact)| Some((index, contact, restitution(contact)?)))
        .collect();
    if stops.len() < 2 {
        return None;
    }
    let largest = largest_length(structure);
    let touches = |index: usize, contact: &Contact| {
        structure.relative(index, &structure.displacement) + contact.gap <= ROUND_OFF * largest
    };
    let part = structure.parts();
    let share = |a: &Contact, b: &Contact| {
        let mut nodes = a.along.iter();
        nodes.any(|(i, _)| b.along.iter().any(|(j, _)| part[*i] == part[*j]))
    };
    stops.iter().find_map(|(index, contact, e)| {
        let mut others = stops.iter().filter(|(other, ..)| other != index);
        let (_, other, _) = others.find(|(_, other, also)| {
            touches(*index, contact) && e.max(*also) > 0.0 && share(contact, other)
        })?;
        let text = format!("contacts {} and {}", contact.name, other.name);
        Some((Warning::ImpactsAtOnce, text))
    })
}

/// The largest gap or displacement at t = 0.
fn largest_length(structure: &Structure) -> f64 {
    let gaps = structure.contacts.iter().map(|contact| contact.gap);
    let lengths = gaps.chain(structure.displacement.iter().copied());
    lengths.fold(0.0, |largest: f64, x| largest.max(x.abs()))
}
