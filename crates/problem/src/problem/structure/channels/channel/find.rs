//! Terms of channels by their names.

use super::number::Energy;
use super::term::Term;
use super::{ALL, QUANTITIES, describe};
use crate::problem::numbers::unit::Dimension;
use crate::problem::structure::channels::names::Names;
use crate::problem::structure::given::node::{GROUND, NodeRef};
use crate::system::import::ForceKind;
use crate::system::structure::{Direction, Quantity as OfMotion};

pub(super) fn of_contact(contact: usize, quantity: &str) -> Result<Term, String> {
    let found = QUANTITIES.iter().position(|known| known.0 == quantity);
    let allowed = QUANTITIES.map(|known| known.0).join(", ");
    let unknown = || format!("a contact has the channels {allowed}, got '{quantity}'");
    let row = found.ok_or_else(unknown)?;
    Ok(match ALL.get(row) {
        Some(quantity) => Term::Contact(contact, *quantity),
        None => Term::Energy(Energy::Contact(contact)),
    })
}

/// A quantity of a contact in a plane: its length, `disc.r`, that of a direction, `disc.r.1`, or what both dissipated.
pub(super) fn in_plane(word: &str, names: &Names) -> Option<Result<Vec<(f64, Term)>, String>> {
    let alone = |term| Ok(vec![(1.0, term)]);
    let of = |first: usize, quantity: &str| of_contact(first, quantity);
    let (rest, last) = word.rsplit_once('.')?;
    if let (Some(first), false) = (names.plane(rest), ["1", "2"].contains(&last)) {
        return Some(of(first, last).and_then(|term| {
            if let Term::Contact(contact, quantity) = term {
                return alone(Term::Contact(contact, quantity.in_plane()));
            }
            let Term::Energy(Energy::Contact(contact)) = term else {
                return alone(term);
            };
            let energy = |contact| (1.0, Term::Energy(Energy::Contact(contact)));
            Ok(vec![energy(contact), energy(contact + 1)])
        }));
    }
    let direction = ["1", "2"].iter().position(|digit| *digit == last)?;
    let (contact, quantity) = rest.rsplit_once('.')?;
    let first = names.plane(contact)?;
    Some(of(first + direction, quantity).and_then(alone))
}

/// u, v or an acceleration of a node or support; of a tied dof the sum of those of its rows.
pub(super) fn of_node(word: &str, names: &Names) -> Option<Vec<(f64, Term)>> {
    let of_all = |nodes: Vec<(f64, NodeRef)>, quantity: fn(NodeRef) -> Term| {
        nodes
            .into_iter()
            .map(|(factor, node)| (factor, quantity(node)))
            .collect()
    };
    if let Some(nodes) = names.nodes(word) {
        return Some(of_all(nodes, Term::Displacement));
    }
    let (name, quantity) = word.rsplit_once('.')?;
    let quantity = match quantity {
        "u" => Term::Displacement,
        "v" => Term::Velocity,
        "a" => Term::Acceleration,
        "a_abs" => Term::Absolute,
        _ => return None,
    };
    Some(of_all(names.nodes(name)?, quantity))
}

/// A force of members of matrices, such as `tower.base_shear`.
pub(super) fn of_members(word: &str, names: &Names) -> Option<Vec<(f64, Term)>> {
    let (matrices, force) = names.member_force(word)?;
    let dimension = match force.kind {
        ForceKind::Force => Dimension::Force,
        ForceKind::Moment => Dimension::Energy,
    };
    let terms = force.along.iter().map(|(row, factor)| {
        let node = NodeRef::Dof(matrices, *row);
        (*factor, Term::Member(node, dimension))
    });
    Some(terms.collect())
}

/// The motion of the ground: `ground`, `ground.v`, `ground.y.a`.
pub(super) fn ground(word: &str, names: &Names) -> Found {
    let rest = word.strip_prefix(GROUND)?;
    let mut parts: Vec<&str> = rest.split('.').collect();
    // Another name that begins so.
    if !parts.remove(0).is_empty() {
        return None;
    }
    let direction = parts.first().and_then(|name| Direction::named(name));
    if direction.is_some() {
        parts.remove(0);
    }
    let named = match parts[..] {
        [] => Some(OfMotion::Acceleration),
        [name] => OF_MOTION.iter().find(|row| row.0 == name).map(|row| row.1),
        _ => None,
    };
    let Some(quantity) = named else {
        return Some(Err(format!(
            "the ground has the channels ground (its acceleration), ground.a, ground.v and ground.u, got '{word}'"
        )));
    };
    let chosen = match (direction, &names.ground[..]) {
        (_, []) => Err("the study has no \"ground\"; a support has a motion of its own".to_owned()),
        (None, [one]) => Ok(*one),
        (None, several) => Err(format!(
            "the ground moves in several directions; name one: {}",
            describe::each("ground", several, ".a")
        )),
        (Some(asked), moving) if moving.contains(&asked) => Ok(asked),
        (Some(asked), moving) => Err(format!(
            "the ground does not move in {}; allowed: {}",
            asked.name(),
            describe::each("ground", moving, ".a")
        )),
    };
    Some(chosen.map(|direction| Term::Ground(direction, quantity)))
}

/// The force of a spring, or of an element of a bar.
pub(super) fn force(word: &str, names: &Names) -> Found {
    let name = word.strip_suffix(".S")?;
    if let Some(spring) = names.spring(name) {
        return Some(Ok(Term::Spring(spring)));
    }
    let (bar, element) = name.split_once('.')?;
    let bar = names.bar(bar)?;
    let digits = element.bytes().all(|c| c.is_ascii_digit()) && !element.starts_with('0');
    let element = element.parse().ok().filter(|_| digits);
    Some(
        element
            .map(|element| Term::Element(bar, element))
            .ok_or_else(|| {
                format!(
                    "'{word}': the elements of a bar have the numbers 1, 2, .. from its left end on"
                )
            }),
    )
}

pub(super) fn energy(word: &str) -> Found {
    let name = word.strip_prefix("energy.")?;
    let found = ENERGIES.iter().find(|row| row.0 == name);
    let allowed = ENERGIES.map(|row| format!("energy.{}", row.0)).join(", ");
    Some(match found {
        Some((_, energy)) => Ok(Term::Energy(*energy)),
        None => Err(format!(
            "no energy '{word}'; allowed: {allowed}, and dissipated of a contact"
        )),
    })
}

/// The force of the ground and of all supports, or of one support: `base`, `base.y`, `base.left`, `base.left.y`.
pub(super) fn base(word: &str, names: &Names) -> Found {
    let rest = word.strip_prefix("base")?;
    let directions = &names.directions;
    let Some(rest) = rest.strip_prefix('.') else {
        if !rest.is_empty() {
            return None;
        }
        return Some(match directions[..] {
            [one] => Ok(Term::Base(one)),
            _ => Err(format!(
                "the structure moves in several directions; name one: {}",
                describe::each("base", directions, "")
            )),
        });
    };
    if let Some(direction) = Direction::named(rest) {
        return Some(match directions.contains(&direction) {
            true => Ok(Term::Base(direction)),
            false => Err(format!(
                "no node moves in {rest}; allowed: {}",
                describe::each("base", directions, "")
            )),
        });
    }
    let (support, direction) = match rest.split_once('.') {
        Some((support, direction)) => (support, Direction::named(direction)?),
        None => (rest, Direction::X),
    };
    if !names.is_support(support) {
        return None;
    }
    let motion = names.motion(support, direction);
    Some(motion.map(Term::Reaction).ok_or_else(|| {
        let axis = direction.name();
        format!("support {support} does not move in {axis}; its force there is part of base.{axis}")
    }))
}

/// Names of the quantities of a motion.
pub(super) const OF_MOTION: [(&str, OfMotion); 3] = [
    ("u", OfMotion::Displacement),
    ("v", OfMotion::Velocity),
    ("a", OfMotion::Acceleration),
];

/// Names of the energies of the structure.
pub(super) const ENERGIES: [(&str, Energy); 6] = [
    ("kinetic", Energy::Kinetic),
    ("elastic", Energy::Elastic),
    ("damping", Energy::Damping),
    ("contacts", Energy::Contacts),
    ("method", Energy::Method),
    ("input", Energy::Input),
];

/// What the name of a channel that is not of a part may be; `None` if it is no such name.
pub(super) type Found = Option<Result<Term, String>>;

impl Term {
    /// The quantities of which the one with this name is the sum, with their factors: one, or several of a tied dof.
    pub(super) fn parse(word: &str, names: &Names) -> Result<Vec<(f64, Term)>, String> {
        let alone = |term| vec![(1.0, term)];
        if let Some((contact, quantity)) = word.rsplit_once('.')
            && let Some(contact) = names.contact(contact)
        {
            return of_contact(contact, quantity).map(alone);
        }
        if let Some(found) = in_plane(word, names) {
            return found;
        }
        if names.contact(word).is_some() || names.plane(word).is_some() {
            return Err(format!(
                "'{word}' is a contact; name one of its channels, such as {word}.S"
            ));
        }
        if let Some(found) = ground(word, names) {
            return found.map(alone);
        }
        if let Some(found) = of_node(word, names) {
            return Ok(found);
        }
        if let Some(found) = of_members(word, names) {
            return Ok(found);
        }
        if let Some(why) = names.why_no_dof(word) {
            return Err(format!("no channel '{word}': {why}"));
        }
        let found = force(word, names)
            .or_else(|| energy(word))
            .or_else(|| base(word, names))
            .unwrap_or_else(|| Err(describe::unknown(word, names)));
        found.map(alone)
    }
}
