//! Contacts in series as one contact: a chain has one force, and its motion is the sum of those of its members.

use super::contact::Contact;
use super::link::{self as link, Link, leader};
use super::step::{ROUND_OFF, SHORT};
use crate::contact::coupled::curved::{Directions, Laws};
use crate::contact::plane::{Pair, PlaneMemory};
use crate::solve::structure::contacts::in_series::{Part, Series, Shares};
use crate::solve::structure::linear_part::block_matrix::BlockMatrix;
use crate::system::structure::{Chain, PlaneRow, Structure};
use std::cell::RefCell;

/// A contact, or a chain of links.
#[derive(Debug, Clone)]
pub(crate) struct Group(Vec<Link>);

/// The groups of all contacts: each chain where its first contact is.
pub(crate) fn groups(contacts: usize, chains: &[Chain]) -> Vec<Group> {
    let mut of_contact: Vec<Option<Vec<Link>>> =
        (0..contacts).map(|i| Some(vec![vec![(i, 1.0)]])).collect();
    for chain in chains {
        let links = chain.links.iter().map(|link| {
            let members = link.iter().map(|member| (member.contact, member.sign));
            members.collect()
        });
        for member in chain.members() {
            of_contact[member.contact] = None;
        }
        of_contact[chain.links[0][0].contact] = Some(links.collect());
    }
    of_contact.into_iter().flatten().map(Group).collect()
}

/// H of the groups, from that of the contacts.
pub(crate) fn grouped(flexibility: &BlockMatrix, groups: &[Group]) -> BlockMatrix {
    if groups.len() == flexibility.places.len() {
        return flexibility.clone();
    }
    // The contacts of a group are in one block.
    let mut blocks = vec![Vec::new(); flexibility.blocks.len()];
    for (g, group) in groups.iter().enumerate() {
        blocks[flexibility.places[group.first()][0]].push(g);
    }
    BlockMatrix::new(blocks, |a, b| {
        let others = || groups[b].leaders();
        let pairs = groups[a]
            .leaders()
            .flat_map(|a| others().map(move |b| (a, b)));
        let terms = pairs.map(|((i, one), (j, other))| one * other * flexibility.entry(i, j));
        let h: f64 = terms.sum();
        // What the nodes between the contacts leave is round-off.
        if a == b { h.max(0.0) } else { h }
    })
}

/// A flexibility for the contacts of a chain whose ends do not move, as at t = 0: that of their masses in a step of the motion.
pub(crate) fn of_masses(structure: &Structure, group: &Group, dt: f64) -> f64 {
    let dt = dt / SHORT;
    let nodes = group.leaders().flat_map(|(i, _)| structure.column(i));
    let terms = nodes
        .map(|(node, factor)| (structure.nodes[node].mass, factor))
        .filter(|(mass, _)| *mass > 0.0);
    let sum: f64 = terms.map(|(mass, factor)| factor * factor / mass).sum();
    if sum > 0.0 { dt * dt * sum } else { 1.0 }
}

impl Group {
    pub(crate) fn is_chain(&self) -> bool {
        self.0.len() > 1
    }

    pub(crate) fn contacts(&self) -> impl Iterator<Item = usize> + '_ {
        self.0.iter().flatten().map(|(contact, _)| *contact)
    }

    /// The first contact of each link with its sign.
    fn leaders(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.0.iter().map(|link| leader(link))
    }

    /// A relative motion of the group from those of its links.
    pub(crate) fn sum(&self, contacts: &[Contact], of: impl Fn(&Contact) -> f64) -> f64 {
        let terms = self.leaders().map(|(i, sign)| sign * of(&contacts[i]));
        // Without a first term of 0, which would change the sign of a negative zero.
        terms.reduce(|sum, term| sum + term).unwrap_or(0.0)
    }

    /// The size of the numbers that the motion is the difference of.
    pub(crate) fn size(&self, contacts: &[Contact]) -> f64 {
        let sizes = self.leaders().map(|(i, _)| contacts[i].motion.size);
        sizes.reduce(|sum, size| sum + size).unwrap_or(0.0)
    }

    /// S at the start of the step.
    pub(crate) fn force(&self, contacts: &[Contact]) -> f64 {
        link::force(&self.0[0], contacts)
    }

    /// Sets the closing speed of impacts that may begin in this step: that of the ends of the chain, when its gaps are closed. The laws
    /// are those of collisions of the bodies at the ends; how fast each contact closes follows from them.
    pub(crate) fn begin(&self, contacts: &mut [Contact]) {
        let gap: f64 = self.0.iter().map(|link| link::open(link, contacts)).sum();
        let change = self.sum(contacts, |contact| contact.motion.change);
        let start = self.sum(contacts, |contact| contact.motion.velocity);
        let terms: f64 = self.contacts().map(|i| contacts[i].terms[1]).sum();
        let start = if start.abs() <= ROUND_OFF * terms {
            0.0
        } else {
            start
        };
        let end = self.sum(contacts, |contact| contact.motion.rate);
        for (i, sign) in self.0.iter().flatten() {
            let contact = &mut contacts[*i];
            let [change, start, end] = [change, start, end].map(|x| sign * x);
            // Without forces the gap closes in this step, or other contacts close it.
            let rate = match gap + change < 0.0 {
                true if gap > 0.0 => start + gap / -change * (end - start),
                true => start,
                false => start.min(-gap / contact.scale.dt),
            };
            contact.begin_at(rate);
        }
    }

    /// The end of the step with this y and force, and of a chain with its shares; the forces of its contacts are that of the group, or
    /// written to `forces`.
    pub(crate) fn end(
        &self,
        (y, force, shares): (f64, f64, Option<Shares>),
        contacts: &mut [Contact],
        forces: &mut [f64],
    ) {
        let Some(Shares { force, changes }) = shares else {
            contacts[self.first()].end(y, force);
            return;
        };
        let terms: f64 = self.contacts().map(|i| contacts[i].terms[0]).sum();
        let round_off = ROUND_OFF * self.size(contacts).max(terms);
        for (members, change) in self.0.iter().zip(changes) {
            if let [(i, sign)] = members[..] {
                contacts[i].end_in_chain(sign * change, sign * force, round_off);
                continue;
            }
            let member_forces = link::forces(members, change, force, contacts);
            for ((i, sign), force) in members.iter().zip(member_forces) {
                contacts[*i].end_in_chain(sign * change, sign * force, round_off);
                forces[*i] = sign * force;
            }
        }
    }

    /// Writes the forces of its contacts, of which this is the sum.
    pub(crate) fn write(&self, force: f64, forces: &mut [f64]) {
        for (i, sign) in self.0.iter().flatten() {
            forces[*i] = sign * force;
        }
    }

    fn first(&self) -> usize {
        self.0[0][0].0
    }

    /// The direction of a contact in a plane, which is in no chain.
    pub(crate) fn row(&self, contacts: &[Contact]) -> Option<PlaneRow> {
        contacts[self.first()].row()
    }

    /// The end of the step of both directions of a contact in a plane, of which this is the first one.
    pub(crate) fn end_plane(&self, y: Pair, contacts: &mut [Contact]) {
        let first = self.first();
        let after = in_plane(contacts, first, y).map(|force| force.1);
        if let (Some(plane), Some(after)) = (&mut contacts[first].plane, after) {
            plane.memory = after;
        }
    }

    /// The force of a chain and the changes of its links, in its own signs. `last` has the last ones of the same step.
    pub(crate) fn share(
        &self,
        y: f64,
        flexibility: f64,
        contacts: &[Contact],
        last: &LastShares,
    ) -> Shares {
        let mut last = last.0.borrow_mut();
        match &*last {
            Some((of, shares)) if *of == y => shares.clone(),
            _ => {
                let shares = self.find(y, flexibility, contacts);
                *last = Some((y, shares.clone()));
                shares
            }
        }
    }

    fn find(&self, y: f64, flexibility: f64, contacts: &[Contact]) -> Shares {
        let part = |members: &Link| Part {
            own: link::own(members, contacts),
            bounds: link::bounds(members, contacts),
            change: link::change(members, contacts),
        };
        let parts: Vec<Part> = self.0.iter().map(part).collect();
        let answer = |part: usize, y: f64| link::answer(&self.0[part], y, contacts);
        let change = |part: usize, force: f64| link::change_under(&self.0[part], force, contacts);
        let series = Series {
            parts: &parts,
            answer: &answer,
            change: &change,
            own: flexibility,
            size: self.size(contacts),
        };
        series.share(y, self.force(contacts))
    }
}

/// The last y of a chain in a step and its answer, for which the search asks more than once.
#[derive(Debug, Clone, Default)]
pub(crate) struct LastShares(RefCell<Option<(f64, Shares)>>);

/// The groups over a step.
pub(crate) struct Groups<'a> {
    pub(crate) contacts: &'a [Contact],
    pub(crate) groups: &'a [Group],
    /// a of each.
    pub(crate) own: &'a [f64],
    /// The last answer of each.
    pub(crate) shares: &'a [LastShares],
}

impl Groups<'_> {
    fn share(&self, group: usize, y: f64) -> Shares {
        let (flexibility, last) = (self.own[group], &self.shares[group]);
        self.groups[group].share(y, flexibility, self.contacts, last)
    }
}

/// J(y) of a contact in a plane by its first direction, and what its law remembers then.
fn in_plane(contacts: &[Contact], first: usize, y: Pair) -> Option<(Pair, PlaneMemory)> {
    let plane = contacts[first].plane.as_ref()?;
    let motions = [first, first + 1].map(|i| &contacts[i].motion);
    Some(plane.answer(motions, y))
}

impl Laws for Groups<'_> {
    fn is_plane(&self, group: usize) -> bool {
        self.groups[group].row(self.contacts) == Some(PlaneRow::First)
    }

    fn answer_plane(&self, group: usize, y: Pair) -> Pair {
        let first = self.groups[group].first();
        in_plane(self.contacts, first, y).map_or([f64::NAN; 2], |(force, _)| force)
    }

    fn directions(&self, group: usize, y: Pair, force: Pair) -> Directions {
        let first = self.groups[group].first();
        let motions = [first, first + 1].map(|i| &self.contacts[i].motion);
        match &self.contacts[first].plane {
            Some(plane) => plane.directions(motions, y, force),
            None => Directions {
                along: [1.0, 0.0],
                slopes: [f64::INFINITY; 2],
            },
        }
    }

    fn answer(&self, group: usize, y: f64) -> f64 {
        let members = &self.groups[group];
        match members.is_chain() {
            false => self.contacts[members.first()].answer(y),
            true => self.share(group, y).force,
        }
    }

    fn compliance(&self, group: usize, y: f64, force: f64, width: f64) -> f64 {
        let members = &self.groups[group];
        if !members.is_chain() {
            return self.contacts[members.first()].compliance(y, force, width);
        }
        let Shares { force, changes } = self.share(group, y);
        let links = members.0.iter().zip(changes);
        links
            .map(|(link, change)| link::compliance(link, change, force, width, self.contacts))
            .sum()
    }

    fn bounds(&self, group: usize) -> [f64; 2] {
        let links = self.groups[group].0.iter();
        links.fold([f64::NEG_INFINITY, f64::INFINITY], |[low, high], link| {
            let [l, h] = link::bounds(link, self.contacts);
            [low.max(l), high.min(h)]
        })
    }
}
