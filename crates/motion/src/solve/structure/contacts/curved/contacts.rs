//! The contacts of a structure with a law that is not a clipped line.
//!
//! Every law answers alone, r' = y - a S ([`CurvedForces`]). Within a step rdot' is affine in r', so an answer with
//! the flexibilities a for r' and `pace` a for rdot' is that of a structure with one contact. In an explicit method r' does not depend on
//! the forces: there y and a are those of rdot' = y - a S.

use super::blocks::CurvedBlocks;
use super::contact::{Contact, Memory, has_curved};
use super::group::{Group, Groups, LastShares, grouped, groups, of_masses};
use super::open::OpenImpacts;
use super::plane::{self};
use super::step::{Motion, Scale, explicit_line, line};
use crate::contact::plane::PlaneMemory;
use crate::contact::{AnyRunningLaw, ContactLaw, Unsolved};
use crate::solve::structure::contacts::static_in_plane::{Admissible, Admit};
use crate::solve::structure::linear_part::block_matrix::BlockMatrix;
use crate::system::structure::{Chain, PlaneRow, Structure};

/// The contacts of one structure.
#[derive(Debug, Clone)]
pub(crate) struct Curved {
    forces: CurvedBlocks,
    pub(super) contacts: Vec<Contact>,
    /// Contacts in series answer together.
    pub(super) groups: Vec<Group>,
    /// The last answer of each group that is a chain, in this step.
    shares: Vec<LastShares>,
    /// Of the groups: a, and the numbers of a step.
    own: Vec<f64>,
    d: Vec<f64>,
    size: Vec<f64>,
    together: Vec<f64>,
    /// Of the contacts.
    pub(super) force: Vec<f64>,
    pub(super) open_impacts: Option<OpenImpacts>,
}

impl Curved {
    /// The contacts of a structure with this H; `None` if all its laws are clipped lines.
    pub(crate) fn new(
        structure: &Structure,
        flexibility: &BlockMatrix,
        pace: f64,
        dt: f64,
    ) -> Option<Curved> {
        let lists = || Curved::of_all(structure, &structure.chains(), flexibility, pace, dt);
        has_curved(structure).then(lists)
    }

    /// The contacts of a structure with this H, also if all its laws are clipped lines. Those in `chains` answer together.
    pub(crate) fn of_all(
        structure: &Structure,
        chains: &[Chain],
        flexibility: &BlockMatrix,
        pace: f64,
        dt: f64,
    ) -> Curved {
        let contacts = &structure.contacts;
        let m = contacts.len();
        let groups = groups(m, chains);
        let is_first = |group: &Group| {
            group
                .contacts()
                .any(|i| contacts[i].law.row() == Some(PlaneRow::First))
        };
        // Both directions are alone in their groups, which follow each other.
        let planes: Vec<usize> = (0..groups.len())
            .filter(|g| is_first(&groups[*g]))
            .collect();
        let forces = CurvedBlocks::new(grouped(flexibility, &groups), &planes);
        let mut flexibilities = vec![0.0; m];
        for (g, group) in groups.iter().enumerate() {
            let flexibility = match forces.flexibility(g) {
                0.0 if group.is_chain() => of_masses(structure, group, dt),
                flexibility => flexibility,
            };
            group
                .contacts()
                .for_each(|i| flexibilities[i] = flexibility);
        }
        let massless = structure.massless();
        let contact = |(i, contact): (usize, &crate::system::structure::Contact)| {
            let relation = contact.law.clone();
            let limit = relation.limit().map_or(0.0, |limit| limit.at(0.0));
            let flexibility = flexibilities[i];
            // Both directions of a plane have one rate.
            let mut nodes = structure
                .directions_of(i)
                .flat_map(|i| &structure.contacts[i].along);
            let is_massless = nodes.any(|(node, _)| massless[*node]);
            let scale = Scale {
                pace: if is_massless { 1.0 / dt } else { pace },
                dt,
                is_massless,
            };
            let law = relation.law(limit);
            let steps = scale.steps(flexibility);
            let running = match structure.preload.laws.get(i) {
                Some(Some(remembers)) => {
                    let mut running = *remembers;
                    running.change(&law, &steps);
                    running
                }
                _ => ContactLaw::running(&[law], &steps),
            };
            Contact {
                law: running,
                now: law,
                own: flexibility,
                line: match scale.is_explicit() {
                    true => explicit_line(&relation),
                    false => line(&relation, scale.pace),
                },
                scale,
                bounds: law.properties().bounds(),
                two_limits: false,
                plane: plane::first(structure, i, limit, scale, flexibility),
                before: None,
                relation,
                motion: Motion::default(),
                terms: [0.0; 2],
                displacement: 0.0,
                change: 0.0,
                answered: 0.0,
            }
        };
        Curved {
            contacts: contacts.iter().enumerate().map(contact).collect(),
            open_impacts: OpenImpacts::new(structure, pace),
            d: vec![0.0; groups.len()],
            size: vec![0.0; groups.len()],
            together: vec![0.0; groups.len()],
            own: (0..groups.len()).map(|g| forces.flexibility(g)).collect(),
            forces,
            force: vec![0.0; m],
            shares: groups.iter().map(|_| LastShares::default()).collect(),
            groups,
        }
    }

    /// r of a contact at the end of the last step, as its law has it.
    pub(crate) fn displacement(&self, contact: usize) -> f64 {
        self.contacts[contact].displacement
    }

    /// The law of a contact with its memory.
    pub(crate) fn law(&self, contact: usize) -> AnyRunningLaw<1> {
        self.contacts[contact].law
    }

    /// What the law of a contact in a plane remembers; `None` of others and of second directions.
    pub(crate) fn plane(&self, contact: usize) -> Option<PlaneMemory> {
        self.contacts[contact].plane.map(|plane| plane.memory)
    }

    /// S of a contact whose r changes by this in the present step.
    pub(crate) fn follow(&self, contact: usize, change: f64) -> f64 {
        self.contacts[contact].follow(change)
    }

    /// The same; the law remembers it.
    pub(crate) fn lead(&mut self, contact: usize, change: f64) -> f64 {
        self.contacts[contact].lead(change)
    }

    /// The bounds of S of a contact.
    pub(crate) fn bounds(&self, contact: usize) -> [f64; 2] {
        self.contacts[contact].bounds
    }

    /// Changes the friction limit of a contact.
    pub(crate) fn limit(&mut self, contact: usize, limit: f64) {
        let contact = &mut self.contacts[contact];
        let law = contact.relation.law(limit);
        contact.law.change(&law, &contact.scale.steps(contact.own));
        contact.now = law;
        contact.bounds = law.properties().bounds();
        if let Some(plane) = &mut contact.plane {
            let step = plane::step(contact.scale, contact.own);
            plane.law = law.in_plane(&step).unwrap_or(plane.law);
        }
    }

    /// What the laws remember.
    pub(crate) fn memory(&self) -> Vec<Memory> {
        self.contacts.iter().map(Contact::memory).collect()
    }

    /// Lets the laws remember this, with their present limits and flexibilities.
    pub(crate) fn recall(&mut self, memories: impl Iterator<Item = Memory>) {
        for (contact, (law, memory, before)) in self.contacts.iter_mut().zip(memories) {
            contact.follow_from(before);
            contact.law = law;
            if let (Some(plane), Some(memory)) = (&mut contact.plane, memory) {
                plane.memory = memory;
            }
            let steps = contact.scale.steps(contact.own);
            contact.law.change(&contact.now, &steps);
        }
    }

    /// Changes the bounds of Coulomb friction with two limits.
    pub(crate) fn bound(&mut self, contact: usize, to: Admissible) {
        self.contacts[contact].admit(to);
    }

    /// Takes over what the laws remember from the sub-step before.
    pub(crate) fn remember(&mut self, before: &Curved) {
        self.recall(before.contacts.iter().map(Contact::memory));
    }

    /// The forces at the end of the step with these motions.
    pub(crate) fn solve(&mut self, motion: impl Fn(usize) -> Motion) -> Result<&[f64], Unsolved> {
        self.solve_until(motion, |_, _| false)
    }

    /// The same; `breaks` changes where forces may be as long as contacts break loose.
    pub(crate) fn solve_until(
        &mut self,
        motion: impl Fn(usize) -> Motion,
        mut breaks: impl FnMut(&[f64], &mut Admit) -> bool,
    ) -> Result<&[f64], Unsolved> {
        for (g, group) in self.groups.iter().enumerate() {
            for i in group.contacts() {
                self.contacts[i].move_by(motion(i));
            }
            if group.is_chain() {
                group.begin(&mut self.contacts);
            }
            for i in group.contacts() {
                let contact = &mut self.contacts[i];
                if contact.scale.is_massless {
                    let change = contact.motion.change;
                    contact.motion.rate = contact.scale.massless_rate(change, contact.before);
                }
                if !group.is_chain() {
                    contact.begin();
                }
            }
            self.shares[g] = LastShares::default();
            self.d[g] = group.sum(&self.contacts, |contact| {
                contact.scale.free(&contact.motion)
            });
            self.size[g] = group.size(&self.contacts);
            self.together[g] = group.force(&self.contacts);
        }
        loop {
            let groups = Groups {
                contacts: &self.contacts,
                groups: &self.groups,
                own: &self.own,
                shares: &self.shares,
            };
            let solved = self
                .forces
                .solve(&self.d, &self.size, &groups, &mut self.together);
            if let Err(why) = solved {
                return Err(self.own_fault(false).unwrap_or(why));
            }
            for (g, group) in self.groups.iter().enumerate() {
                group.write(self.together[g], &mut self.force);
            }
            let contacts = &mut self.contacts;
            if !breaks(&self.force, &mut |c, to| contacts[c].admit(to)) {
                break;
            }
        }
        for (g, group) in self.groups.iter().enumerate() {
            let y = self.forces.argument(g);
            match group.row(&self.contacts) {
                None => {
                    let force = self.together[g];
                    let shares = group
                        .is_chain()
                        .then(|| group.share(y, self.own[g], &self.contacts, &self.shares[g]));
                    group.end((y, force, shares), &mut self.contacts, &mut self.force);
                }
                Some(PlaneRow::First) => {
                    let y = [y, self.forces.argument(g + 1)];
                    group.end_plane(y, &mut self.contacts);
                }
                Some(PlaneRow::Second) => {}
            }
        }
        match self.own_fault(true) {
            None => Ok(&self.force),
            Some(why) => Err(why),
        }
    }

    /// Energy that the contacts store.
    pub(crate) fn stored_energy(&self, states: impl Iterator<Item = [f64; 2]>) -> f64 {
        let energy = |(contact, [r, s]): (&Contact, [f64; 2])| contact.stored_energy(r, s);
        self.contacts.iter().zip(states).map(energy).sum()
    }
}
