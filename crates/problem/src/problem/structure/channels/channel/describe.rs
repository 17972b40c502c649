//! The names of channels, for messages and pages.

use super::QUANTITIES;
use crate::problem::structure::channels::names::Names;
use crate::system::structure::Direction;

/// Most names in a message.
const MOST_NAMES: usize = 50;

/// Channels of nodes, each with its meaning.
pub const OF_NODES: [(&str, &str); 4] = [
    (
        "u",
        "displacement: relative to the ground, absolute with supports that move; NODE alone is the same",
    ),
    ("v", "velocity, relative as u"),
    (
        "a",
        "acceleration, relative as u, by the equation of motion: M a = p - C v - K u - B S; not of a node without mass",
    ),
    (
        "a_abs",
        "absolute acceleration: that of u and of the ground in the direction of the node",
    ),
];

/// Channels of springs, bars and members of matrices.
pub const OF_SPRINGS: [(&str, &str); 3] = [
    (
        "SPRING.S",
        "force k e + c e' of a spring with a name, positive where its extension e is; without Rayleigh and modal damping",
    ),
    (
        "BAR.3.S",
        "force of an element of a bar, from 1 at the left end on, positive in tension",
    ),
    (
        "MATRICES.FORCE",
        "force or moment of members, a line of \"forces\": the sum of factor times displacement",
    ),
];

/// Channels of the ground and the supports that move.
pub const OF_GROUND: [(&str, &str); 2] = [
    (
        "ground",
        "acceleration of the ground; the same as ground.a; of several directions ground.y.a",
    ),
    (
        "ground.v",
        "its velocity, and ground.u its displacement, from rest at t = 0",
    ),
];

/// Channels of the forces on the structure from outside.
pub const OF_BASE: [(&str, &str); 2] = [
    (
        "base",
        "force of the ground and of all supports on the structure, by springs, dashpots and contacts: masses times absolute accelerations less the loads; of several directions base.y",
    ),
    (
        "base.SUPPORT",
        "the same of one support that moves; in y base.SUPPORT.y",
    ),
];

/// Channels of energies; they are of the motion relative to the ground, or beside what supports carry.
pub const OF_ENERGY: [(&str, &str); 6] = [
    ("energy.kinetic", "energy of the masses"),
    (
        "energy.elastic",
        "energy of springs, bars, matrices and contacts that store some",
    ),
    ("energy.damping", "energy that C dissipated since t = 0"),
    (
        "energy.contacts",
        "energy that all contacts dissipated since t = 0; CONTACT.dissipated is that of one",
    ),
    (
        "energy.method",
        "energy that the method of integration took; round-off for average-acceleration",
    ),
    (
        "energy.input",
        "energy at t = 0 and the work of loads, ground and supports since; the sum of the five others",
    ),
];

/// Names such as `ground.x.a or ground.y.a`.
pub(super) fn each(what: &str, directions: &[Direction], end: &str) -> String {
    let names = directions
        .iter()
        .map(|direction| format!("{what}.{}{end}", direction.name()));
    names.collect::<Vec<_>>().join(" or ")
}

/// How the message of a name that is no channel begins; the name and a quotation mark follow.
pub const UNKNOWN: &str = "no node or contact '";

/// The message of a name that is no channel.
pub(super) fn unknown(word: &str, names: &Names) -> String {
    let known: Vec<String> = names.channels().take(MOST_NAMES).collect();
    format!(
        "{UNKNOWN}{word}'; channels are u, v, a and a_abs of nodes, S of named springs and of elements of bars, {} of contacts, forces of members, base, ground and energies: {}",
        joined(&QUANTITIES),
        known.join(", ")
    )
}

/// The names of a table.
pub fn joined(table: &[(&str, &str)]) -> String {
    let names: Vec<&str> = table.iter().map(|row| row.0).collect();
    names.join(", ")
}

impl Names {
    /// The names of channels, without those of inner nodes and all dofs, and without the suffixes of each node.
    pub fn channels(&self) -> impl Iterator<Item = String> + '_ {
        let bar_names = self.bars.iter();
        let bars = bar_names.flat_map(|bar| [format!("{bar}.left"), format!("{bar}.right")]);
        let masses = self.masses.iter().cloned();
        let dofs = self.matrices.iter().flat_map(|(name, imported)| {
            let first = imported.dofs.name(0);
            let dofs = format!("{name}.{first} and the other dofs of {name}");
            let members = imported.dofs.member_forces().iter();
            let forces = members.map(move |force| format!("{name}.{}", force.name));
            std::iter::once(dofs).chain(forces)
        });
        let contacts = self.contacts.iter().map(|contact| format!("{contact}.S"));
        let supports = self.supports.iter().map(|(name, _)| format!("{name}.u"));
        let springs = self.springs().map(|spring| format!("{spring}.S"));
        let ground = (!self.ground.is_empty()).then(|| "ground".to_owned());
        let of_parts = masses.chain(bars).chain(dofs).chain(supports);
        let known = of_parts.chain(contacts).chain(springs).chain(ground);
        let base = ["base".to_owned()].into_iter();
        known
            .chain(base)
            .chain(OF_ENERGY.map(|row| row.0.to_owned()))
    }
}
