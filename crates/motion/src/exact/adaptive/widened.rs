//! Friction without compliance in one direction, as a contact in a plane.
//!
//! Its second direction is that of a mass of its own on which nothing else acts, so that it never moves: of the disc of the limit,
//! the diameter along the first direction is left.

use crate::exact::events::State;
use crate::system::structure::{Contact, Node, Structure, StructureLaw, Symmetric};

/// The contacts of a structure with such friction in planes.
#[derive(Debug)]
pub struct Widened {
    /// How many nodes were given.
    nodes: usize,
    /// The place of each contact that was given.
    places: Vec<usize>,
    /// r, rdot, S and the slip of the contacts that were given.
    values: [Vec<f64>; 4],
}

/// Both directions of friction without compliance in one; `None` of another law.
fn in_plane(law: &StructureLaw) -> Option<[StructureLaw; 2]> {
    let is_friction = law.row().is_none() && law.is_rigid() && law.limit().is_some();
    is_friction.then(|| law.clone().in_plane())?
}

impl Widened {
    /// With the structure; `None` without such friction.
    pub fn new(given: &Structure) -> Option<(Structure, Widened)> {
        let mut contacts = Vec::new();
        // Of each contact, the one that was given; none of second directions.
        let mut of = Vec::new();
        let mut nodes = given.nodes.clone();
        for (i, contact) in given.contacts.iter().enumerate() {
            of.push(Some(i));
            let Some([first, second]) = in_plane(&contact.law) else {
                contacts.push(contact.clone());
                continue;
            };
            let first_way = Contact {
                law: first,
                ..contact.clone()
            };
            let second_way = Contact {
                along: vec![(nodes.len(), 1.0)],
                gap: 0.0,
                law: second,
                ..contact.clone()
            };
            contacts.extend([first_way, second_way]);
            of.push(None);
            let masses = contact
                .along
                .iter()
                .map(|(node, by)| (by, given.nodes[*node].mass));
            let moved = masses.filter(|(_, mass)| *mass > 0.0);
            let flexibility: f64 = moved.map(|(by, mass)| by * by / mass).sum();
            nodes.push(Node {
                name: contact.name.clone(),
                // As flexible as the first direction, whatever the units.
                mass: if flexibility > 0.0 {
                    1.0 / flexibility
                } else {
                    1.0
                },
                direction: Default::default(),
            });
        }
        if nodes.len() == given.len() {
            return None;
        }
        let places: Vec<usize> = (0..of.len()).filter(|index| of[*index].is_some()).collect();
        let pressed = contacts
            .iter_mut()
            .filter_map(|contact| contact.law.limit_mut());
        for pressed in pressed.filter_map(|limit| limit.pressed_by.as_mut()) {
            pressed.contacts.iter_mut().for_each(|c| *c = places[*c]);
        }
        let mut structure = Structure::new(nodes);
        let size = structure.len();
        let grown = |matrix: &Symmetric| {
            let mut widened = Symmetric::zeros(size);
            let entries = matrix.entries();
            entries.for_each(|((i, j), value)| widened.add(i, j, value));
            widened
        };
        structure.coupled_mass = grown(&given.coupled_mass);
        structure.stiffness = grown(&given.stiffness);
        structure.damping = grown(&given.damping);
        structure.contacts = contacts;
        structure.loads.clone_from(&given.loads);
        structure.displacement[..given.len()].copy_from_slice(&given.displacement);
        structure.velocity[..given.len()].copy_from_slice(&given.velocity);
        structure.supports.clone_from(&given.supports);
        for support in &mut structure.supports {
            let gap = |given_contact: &Option<usize>| {
                given_contact.map_or(0.0, |given_contact| support.gaps[given_contact])
            };
            support.gaps = of.iter().map(gap).collect();
            support.carried.resize(size, 0.0);
        }
        let preload = &given.preload;
        if !preload.forces.is_empty() {
            // A second direction is at rest as its first one is.
            let force = |(index, given_contact): (usize, &Option<usize>)| match given_contact {
                Some(given_contact) => preload.force(*given_contact),
                None => of[index - 1]
                    .and_then(|first| preload.force(first))
                    .map(|_| 0.0),
            };
            structure.preload.forces = of.iter().enumerate().map(force).collect();
        }
        let law =
            |given_contact: &Option<usize>| preload.laws.get((*given_contact)?).copied().flatten();
        structure.preload.laws = of.iter().map(law).collect();
        let values = [(); 4].map(|()| vec![0.0; places.len()]);
        Some((
            structure,
            Widened {
                nodes: given.len(),
                places,
                values,
            },
        ))
    }

    /// A state with the nodes and contacts that were given.
    pub fn given<'a>(&'a mut self, state: &'a State) -> State<'a> {
        let quantities = [state.r, state.rate, state.force, state.slip];
        for (values, quantity) in self.values.iter_mut().zip(quantities) {
            for (value, index) in values.iter_mut().zip(&self.places) {
                *value = quantity[*index];
            }
        }
        let [r, rate, force, slip] = &self.values;
        State {
            u: &state.u[..self.nodes],
            v: &state.v[..self.nodes],
            r,
            rate,
            force,
            slip,
        }
    }
}
