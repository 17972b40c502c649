//! The elastic contacts of a structure at rest, with their initial stiffness.

use super::sparse::factor::negative_pivot;
use super::{Contact, Structure, Symmetric};
use crate::contact::{ClippedLine, ContactKind};
use std::collections::BTreeMap;

/// Stiffness of a contact that touches, over the largest entry of K: below the inverse of what is round-off of a pivot.
const RIGID: f64 = 1e4;

impl Contact {
    /// Initial stiffness dS/dr at S = 0; 0 for a contact that is not elastic at t = 0.
    ///
    /// Friction with an elastic part has the stiffness of this part, k of displacement-control `[F (9)]`, Bouc-Wen and Dahl, sigma0 of
    /// LuGre, if its limit at t = 0 is positive. Viscous and rigid laws have none. An impact contact is elastic at rest if it is pressed
    /// there, gap < 0: then k, or (3/2) k_h (-gap)^(1/2) of k_h delta^(3/2). One that is open or only touches has no force at rest, and
    /// no stiffness against opening.
    pub fn initial_stiffness(&self) -> f64 {
        let overlap = (-self.gap).max(0.0);
        let limit = self.law.limit().map_or(0.0, |limit| limit.at(0.0));
        match self.law.line() {
            // Without the round-off of 1/(1/k).
            Some(ClippedLine::Elastic { stiffness }) if limit > 0.0 => stiffness,
            _ => self.law.law(limit).properties().initial_stiffness(overlap),
        }
    }

    /// Whether it holds its nodes together at rest: it is elastic, or friction, which resists every motion. Friction that another
    /// contact presses has a limit at rest, too.
    pub(super) fn holds(&self) -> bool {
        let resists = |limit: &super::Limit| limit.at(0.0) > 0.0 || limit.pressed_by.is_some();
        self.initial_stiffness() > 0.0 || self.law.limit().is_some_and(resists)
    }
}

impl Structure {
    /// K with the elastic contacts at their initial stiffness ([`Contact::initial_stiffness`]).
    pub fn initial_stiffness(&self) -> Symmetric {
        let mut stiffness = self.stiffness.clone();
        for contact in &self.contacts {
            let k = contact.initial_stiffness();
            if k > 0.0 {
                stiffness.add_along(&contact.along, k);
            }
        }
        stiffness
    }

    /// A node that a negative stiffness pulls away although all contacts stick or touch: K with the contacts is not positive
    /// semidefinite. Elastic contacts have their initial stiffness, others that hold their nodes are rigid; dashpots do not hold.
    pub fn pulled_node(&self) -> Option<usize> {
        let mut stiffness = self.stiffness.clone();
        let rigid = RIGID * stiffness.largest();
        for contact in &self.contacts {
            let initial = contact.initial_stiffness();
            let square: f64 = contact
                .along
                .iter()
                .map(|(_, factor)| factor * factor)
                .sum();
            let holds = match contact.law.kind() {
                ContactKind::Link => false,
                ContactKind::Impact => true,
                // Whatever is stuck where another part presses it.
                ContactKind::Friction => {
                    let pressed = |limit: &super::Limit| limit.pressed_by.is_some();
                    let sticks = !contact.law.law(1.0).of_velocity();
                    let pressed = contact.law.limit().is_some_and(pressed) && sticks;
                    contact.holds() && (contact.law.is_rigid() || pressed)
                }
            };
            if initial > 0.0 {
                stiffness.add_along(&contact.along, initial);
            } else if holds && square > 0.0 {
                stiffness.add_along(&contact.along, rigid / square);
            }
        }
        negative_pivot(&stiffness)
    }

    /// The largest force of K at a node where all nodes of a group move by 1, of each group that has entries of K.
    pub fn holding<G: Ord + Copy>(&self, group: impl Fn(usize) -> G) -> BTreeMap<G, f64> {
        let mut forces = BTreeMap::new();
        for ((i, j), k) in self.stiffness.entries() {
            *forces.entry((group(j), i)).or_insert(0.0) += k;
            if i != j {
                *forces.entry((group(i), j)).or_insert(0.0) += k;
            }
        }
        let mut holding = BTreeMap::new();
        for ((part, _), force) in forces {
            let most = holding.entry(part).or_insert(0.0);
            *most = f64::max(*most, f64::abs(force));
        }
        holding
    }

    /// The part of each node, by a node of it: the nodes that K connects.
    pub fn parts(&self) -> Vec<usize> {
        let mut part: Vec<usize> = (0..self.len()).collect();
        for ((i, j), _) in self.stiffness.entries() {
            join(&mut part, i, j);
        }
        for i in 0..part.len() {
            part[i] = root(&part, i);
        }
        part
    }
}

/// The first node of the part of a node.
pub(super) fn root(part: &[usize], mut i: usize) -> usize {
    while part[i] != i {
        i = part[i];
    }
    i
}

/// Makes one part of the parts of two nodes.
pub(super) fn join(part: &mut [usize], i: usize, j: usize) {
    let (a, b) = (root(part, i), root(part, j));
    part[a.max(b)] = a.min(b);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{BoucWen, ContactLaw, Hertz, KelvinVoigt, Lugre, Tanh};
    use crate::system::structure::{Limit, Node, StructureLaw};

    fn contact(between: [Option<usize>; 2], gap: f64, law: StructureLaw) -> Contact {
        Contact {
            name: "c".into(),
            along: super::super::between(between),
            gap,
            law,
        }
    }

    fn limit(force: f64) -> Limit {
        Limit::constant(force)
    }

    #[test]
    fn the_initial_stiffness_is_the_slope_of_the_law() {
        let elastic = |k: f64, force: f64| {
            StructureLaw::new(ClippedLine::Elastic { stiffness: k }, limit(force))
        };
        let friction = |law: ContactLaw| StructureLaw::new(law, limit(2.0)).from_its_answer();
        let impact = |law: ContactLaw| StructureLaw::new(law, None).from_its_answer();
        let compliance = 1.0 / 64.0;
        let lugre = Lugre {
            sigma0: 80.0,
            sigma1: 1.0,
            sigma2: 1.0,
            limit: 2.0,
            static_limit: 2.0,
            stribeck_velocity: 1.0,
        };
        let boucwen = BoucWen {
            compliance,
            limit: 2.0,
            exponent: 2.0,
            beta: 0.5,
        };
        let tanh = Tanh {
            compliance,
            limit: 2.0,
            ratio: 1.0,
            rate: 0.0,
        };
        let spring = StructureLaw::new(ClippedLine::Spring { stiffness: 90.0 }, None);
        let hertz = impact(ContactLaw::Hertz(Hertz { stiffness: 100.0 }));
        let kelvin = impact(ContactLaw::KelvinVoigt(KelvinVoigt::new(70.0, 0.5, 1.0)));
        for (law, gap, k) in [
            (elastic(50.0, 2.0), 0.0, 50.0),
            (elastic(50.0, 2.0), 0.3, 50.0),
            (elastic(50.0, 0.0), 0.0, 0.0),
            (friction(ContactLaw::BoucWen(boucwen)), 0.0, 64.0),
            (friction(ContactLaw::Lugre(lugre)), 0.0, 80.0),
            (friction(ContactLaw::Tanh(tanh)), 0.0, 0.0),
            (
                StructureLaw::new(ClippedLine::Coulomb, limit(2.0)),
                0.0,
                0.0,
            ),
            (spring.clone(), 0.01, 0.0),
            (spring.clone(), 0.0, 0.0),
            (spring, -0.01, 90.0),
            (kelvin, -0.01, 70.0),
            // d/dr of 100 (0.04 - r)^1.5 at r = 0.
            (hertz, -0.04, 30.0),
        ] {
            let stiffness = contact([None, Some(0)], gap, law).initial_stiffness();
            // Round-off of a square root.
            assert!((stiffness - k).abs() <= 1e-14 * k, "{stiffness} {k}");
        }
    }

    #[test]
    fn elastic_contacts_and_coulomb_friction_hold_and_open_gaps_do_not() {
        let elastic = StructureLaw::new(ClippedLine::Elastic { stiffness: 50.0 }, limit(2.0));
        let coulomb = StructureLaw::new(ClippedLine::Coulomb, limit(2.0));
        let gap = StructureLaw::new(ClippedLine::Spring { stiffness: 1e4 }, None);
        let structure = |contacts: Vec<Contact>| {
            let mut stiffness = Symmetric::zeros(4);
            stiffness.add_spring([Some(1), Some(2)], 10.0);
            Structure {
                nodes: ["a", "b", "c", "d"]
                    .map(|name| Node {
                        name: name.into(),
                        mass: 1.0,
                        direction: Default::default(),
                    })
                    .to_vec(),
                coupled_mass: Symmetric::zeros(4),
                stiffness,
                damping: Symmetric::zeros(4),
                contacts,
                loads: Vec::new(),
                displacement: vec![0.0; 4],
                velocity: vec![0.0; 4],
                supports: Vec::new(),
                preload: Default::default(),
                observed: None,
            }
        };
        let names = ["a", "b to c", "d"];
        assert_eq!(structure(Vec::new()).unheld_parts(), names);
        let open = contact([None, Some(0)], 0.01, gap);
        assert_eq!(structure(vec![open.clone()]).unheld_parts(), names);
        // d holds on to c by friction, and b to the ground.
        let held = vec![
            open,
            contact([Some(1), None], 0.0, elastic),
            contact([Some(3), Some(2)], 0.0, coulomb),
        ];
        assert_eq!(structure(held).unheld_parts(), ["a"]);
        assert_eq!(structure(Vec::new()).parts(), [0, 1, 1, 3]);
    }
}
