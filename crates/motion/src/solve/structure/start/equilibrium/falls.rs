//! Equilibrium with laws that fall (soften).
//!
//! Such a law has one answer in small steps only, which may be too many. So its first branch, a line, stands for it first; this
//! equilibrium is the right one if the law itself has the same force there.

use super::Equilibrium;
use super::weights::{largest, softens};
use crate::contact::ContactKind;
use crate::solve::Unsolvable;
use crate::system::structure::{Contact, Structure};

/// Most times that W becomes larger until laws that fall have one answer.
const SMALLER: usize = 4;

/// Part of the range of a law that shows its first branch.
const FIRST: f64 = 1e-6;

/// Part of a force by which it may be beside that branch, and of the largest one by which a force that is none may be.
const STRAIGHT: f64 = 1e-9;
const ROUND_OFF: f64 = 1e-11;

impl<'a> Equilibrium<'a> {
    /// The equilibrium with the load, which is applied in so many parts.
    ///
    /// # Errors
    /// Nothing holds a node, a law that falls carries too little, or contacts have no forces.
    pub(crate) fn of(
        structure: &'a Structure,
        parts: usize,
    ) -> Result<Equilibrium<'a>, Unsolvable> {
        let mut equilibrium = Equilibrium::with(structure, 0)?;
        match equilibrium.leaves_idle(parts) {
            true => Ok(equilibrium),
            false => equilibrium.settle(parts),
        }
    }

    /// The same without a look at bodies that nothing moves.
    pub(super) fn settle(mut self, parts: usize) -> Result<Equilibrium<'a>, Unsolvable> {
        let structure = self.structure;
        let falls = structure.contacts.iter().any(falls);
        if falls && self.is_elastic(parts) {
            return Ok(self);
        }
        if softens(&self.curved) {
            self = Equilibrium::with(structure, SMALLER)?;
        }
        match self.apply(parts) {
            Err(_) if falls => Err(softened(structure)),
            other => other.map(|()| self),
        }
    }

    /// Applies the load in so many parts.
    fn apply(&mut self, parts: usize) -> Result<(), Unsolvable> {
        (1..=parts).try_for_each(|part| self.find(part as f64 / parts as f64))
    }

    /// Takes over the equilibrium with the first branches of the laws that fall, if none of them leaves it.
    fn is_elastic(&mut self, parts: usize) -> bool {
        let start = &self.structure.displacement;
        let mut lines = self.structure.clone();
        let mut falling = Vec::new();
        for (c, contact) in self.structure.contacts.iter().enumerate() {
            if !falls(contact) {
                continue;
            }
            if self.structure.relative(c, start) != 0.0 {
                return false;
            }
            let small = FIRST * contact.law.law(0.0).properties().reach();
            let stiffness = self.curved.follow(c, small) / small;
            lines.stiffness.add_along(&contact.along, stiffness);
            // It has no force beside the spring.
            lines.contacts[c].along.clear();
            falling.push((c, stiffness));
        }
        let Ok(mut found) = Equilibrium::with(&lines, 0) else {
            return false;
        };
        if found.apply(parts).is_err() {
            return false;
        }
        for (c, stiffness) in &falling {
            found.forces[*c] = stiffness * self.structure.relative(*c, &found.u);
        }
        let mut memory = found.curved.memory();
        let found_memory = self.curved.memory();
        for (c, _) in &falling {
            memory[*c] = found_memory[*c];
        }
        self.curved.recall(memory.into_iter());
        let sizes = [&found.forces, &self.structure.preload.load].map(|values| largest(values));
        let round_off = ROUND_OFF * sizes[0].max(sizes[1]);
        let is_on_line = |(c, _): &(usize, f64)| {
            let force = self.curved.lead(*c, self.structure.relative(*c, &found.u));
            (force - found.forces[*c]).abs() <= STRAIGHT * force.abs() + round_off
        };
        let is_elastic = falling.iter().all(is_on_line);
        if is_elastic {
            (self.u, self.forces) = (found.u, found.forces);
        }
        is_elastic
    }
}

/// Whether the force of a link falls beyond its limit.
fn falls(contact: &Contact) -> bool {
    let is_link = contact.law.kind() == ContactKind::Link;
    is_link && contact.law.law(0.0).properties().falls()
}

/// No equilibrium because of a law that falls.
fn softened(structure: &Structure) -> Unsolvable {
    let contact = structure.contacts.iter().find(|contact| falls(contact));
    let name = contact.map_or("", |contact| &contact.name);
    Unsolvable::BrokenRules(format!(
        "no equilibrium with the static loads was found: the force of contact '{name}' falls (softens) beyond its limit and may carry less than the loads; apply them as loads in time, or choose smaller ones"
    ))
}
