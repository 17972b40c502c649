//! Bearings whose normal forces are not the weight on them.

use super::doubt::Doubt;
use crate::contact::ContactKind;
use crate::problem::Case;
use crate::problem::numbers::short::short;
use crate::problem::structure::parts::contact::{Contact as Given, Normal};
use crate::problem::structure::parts::contact_law::law_named;
use crate::problem::structure::parts::template::Template;
use crate::solve::Warning;
use crate::system::loads::STANDARD_GRAVITY;
use crate::system::structure::{Contact, Direction, Structure};
use std::collections::BTreeMap;

/// Factor by which N together is far from the weight; t for kN is 9.81, and one bearing of a continuous girder has its own share.
const FAR: f64 = 4.0;

/// K times a displacement as a whole, over the largest entry of K: below it no spring holds the part.
const FREE: f64 = 1e-6;

/// Most of gravity in m/s2 that is not all of it: a part of it may act along a slope.
const WHOLE: f64 = 9.0;

/// A part of a structure in one direction, which no spring holds there.
struct Body<'a> {
    mass: f64,
    /// The sum of N of its contacts, and the name of the first one.
    normal: f64,
    first: &'a str,
}

/// A part that rests on contacts with N alone.
pub fn far(template: &Template, case: &Case, structure: &Structure) -> Option<Doubt> {
    let has_normal = |contact: &Given| contact.normal.is_some();
    if template.units.is_empty() || !template.contacts.iter().any(has_normal) {
        return None;
    }
    let gravity = STANDARD_GRAVITY / template.metre;
    let part = structure.parts();
    let parts = (0..structure.len()).filter(|node| part[*node] == *node);
    let bodies =
        parts.flat_map(|node| [Direction::X, Direction::Y, Direction::Z].map(|d| (node, d)));
    let of = Parts::new(template, case, structure, &part);
    bodies.filter_map(|key| of.body(key)).find_map(|body| {
        let weight = body.mass * gravity;
        let fits = (weight / FAR..=weight * FAR).contains(&body.normal);
        let text = || {
            format!(
                "N is {} in all, of contact {} and those beside it, under a mass with the weight {}",
                short(body.normal),
                body.first,
                short(weight)
            )
        };
        (!fits).then(|| (Warning::NormalWeight, text()))
    })
}

/// Gravity along the contacts of a part that friction alone holds in its direction.
pub fn along_friction(template: &Template, case: &Case, structure: &Structure) -> Option<Doubt> {
    let (direction, amount) = template.gravities().next()?;
    let is_whole = amount.value(case).ok()?.abs() * template.metre > WHOLE;
    if template.units.is_empty() || !is_whole {
        return None;
    }
    let part = structure.parts();
    let of = Parts::new(template, case, structure, &part);
    let mut parts = (0..structure.len()).filter(|node| part[*node] == *node);
    let contact = parts.find_map(|node| {
        let key = (node, direction);
        of.free_mass(key)?;
        let mut contacts = structure
            .contacts
            .iter()
            .filter(|contact| of.touches(contact, key))
            .peekable();
        let first = contacts.peek()?.name.clone();
        let is_friction = |contact: &Contact| contact.law.kind() == ContactKind::Friction;
        contacts.all(is_friction).then_some(first)
    })?;
    let text = format!(
        "in {} friction alone holds a part, contact {contact} first",
        direction.name()
    );
    Some((Warning::IdleGravity, text))
}

/// A structure by its parts.
struct Parts<'a> {
    template: &'a Template,
    case: &'a Case,
    structure: &'a Structure,
    /// The part of each node.
    part: &'a [usize],
    free_masses: BTreeMap<(usize, Direction), f64>,
}

impl<'a> Parts<'a> {
    fn new(
        template: &'a Template,
        case: &'a Case,
        structure: &'a Structure,
        part: &'a [usize],
    ) -> Self {
        Parts {
            template,
            case,
            structure,
            part,
            free_masses: free_masses(structure, part),
        }
    }

    /// A part that contacts with N hold in a direction, and nothing else.
    fn body(&self, key: (usize, Direction)) -> Option<Body<'_>> {
        let mass = self.free_mass(key)?;
        let mut body = Body {
            mass,
            normal: 0.0,
            first: "",
        };
        let contacts = self.template.contacts.iter().zip(&self.structure.contacts);
        for (given, contact) in contacts {
            if !self.touches(contact, key) {
                continue;
            }
            match contact.law.kind() {
                ContactKind::Impact => continue,
                // A bearing without N carries weight, a damper does not.
                ContactKind::Link if contact.initial_stiffness() > 0.0 => return None,
                ContactKind::Link => continue,
                ContactKind::Friction => {}
            }
            let nodes = contact.along.iter().map(|(node, _)| *node);
            let mut others = nodes.filter(|node| self.part[*node] != key.0);
            // What lies on another part may have others on itself.
            if others.any(|node| self.free_mass((self.part[node], key.1)).is_some()) {
                return None;
            }
            body.normal += self.normal(given)?;
            if body.first.is_empty() {
                body.first = &given.name;
            }
        }
        (!body.first.is_empty()).then_some(body)
    }

    /// N at rest, if it is a number.
    fn normal(&self, contact: &Given) -> Option<f64> {
        law_named(contact.law.name(self.case)).filter(|law| law.has("nu"))?;
        match contact.normal.as_ref()? {
            Normal::Constant(normal) => normal.value(self.case).ok(),
            Normal::Weight { weight, .. } => weight.value(self.case).ok(),
            Normal::Table(_) | Normal::Parts(_) => None,
        }
    }

    fn touches(&self, contact: &Contact, key: (usize, Direction)) -> bool {
        contact.along.iter().any(|(node, _)| self.is_in(*node, key))
    }

    fn is_in(&self, node: usize, (part, direction): (usize, Direction)) -> bool {
        self.part[node] == part && self.structure.nodes[node].direction == direction
    }

    /// The mass of a part in a direction, > 0, if no spring holds it there.
    fn free_mass(&self, key: (usize, Direction)) -> Option<f64> {
        self.free_masses.get(&key).copied()
    }
}

/// The masses, > 0, of parts in directions in which no spring holds them.
fn free_masses(structure: &Structure, part: &[usize]) -> BTreeMap<(usize, Direction), f64> {
    let key = |node: usize| (part[node], structure.nodes[node].direction);
    let mut masses = BTreeMap::new();
    for (node, given) in structure.nodes.iter().enumerate() {
        *masses.entry(key(node)).or_insert(0.0) += given.mass;
    }
    for ((i, j), m) in structure.coupled_mass.entries() {
        let both = if i == j { m } else { 2.0 * m };
        if key(i) == key(j) {
            masses.entry(key(i)).and_modify(|mass| *mass += both);
        }
    }
    let most = FREE * structure.stiffness.largest();
    for (held, force) in structure.holding(key) {
        if force > most {
            masses.remove(&held);
        }
    }
    masses.retain(|_, mass| *mass > 0.0);
    masses
}
