//! The contacts of a structure with a law that is not a clipped line.
//!
//! Every law answers alone, r' = y - a S ([`CurvedForces`]). Within a step rdot' is affine in r', so an answer with
//! the flexibilities a for r' and `pace` a for rdot' is that of a structure with one contact. In an explicit method r' does not depend on
//! the forces: there y and a are those of rdot' = y - a S.

use super::curved_plane::{self, Plane};
use super::curved_step::{Motion, Scale, explicit_line, line, trial};
use crate::contact::coupled::curved::{CurvedForces, Directions, Laws};
use crate::contact::plane::{Pair, PlaneLaw, PlaneMemory};
use crate::contact::{AnyRunningLaw, ContactKind, ContactLaw, ContactResponse, Trial, Unsolved};
use crate::lane::Lane;
use crate::system::structure::{PlaneRow, Structure, StructureLaw};

/// The contacts of one structure.
#[derive(Debug)]
pub(super) struct Curved {
    forces: CurvedForces,
    contacts: Vec<Contact>,
    d: Vec<f64>,
    size: Vec<f64>,
    force: Vec<f64>,
}

/// A contact.
#[derive(Debug)]
struct Contact {
    relation: StructureLaw,
    /// The law with its memory: the answer with the flexibility a, and the law itself, without flexibility.
    law: AnyRunningLaw<1>,
    /// Its numbers, with the present limit.
    now: ContactLaw,
    /// a.
    own: f64,
    scale: Scale,
    /// 1/f' of a clipped line.
    line: Option<f64>,
    bounds: [f64; 2],
    /// The motion over the step without the forces at its end.
    motion: Motion,
    /// The law of both directions of a contact in a plane, beside the first one.
    plane: Option<Plane>,
}

impl Curved {
    /// The contacts of a structure with this H, by rows; `None` if all its laws are clipped lines.
    pub(super) fn new(
        structure: &Structure,
        flexibility: &[f64],
        pace: f64,
        dt: f64,
    ) -> Option<Curved> {
        let mut contacts = structure.contacts.iter();
        let any = contacts.any(|contact| contact.law.is_curved());
        any.then(|| Curved::of_all(structure, flexibility, pace, dt))
    }

    /// The contacts of a structure with this H, by rows, also if all its laws are clipped lines.
    pub(super) fn of_all(structure: &Structure, flexibility: &[f64], pace: f64, dt: f64) -> Curved {
        let contacts = &structure.contacts;
        let m = contacts.len();
        let first = |i: &usize| contacts[*i].law.row() == Some(PlaneRow::First);
        let planes: Vec<usize> = (0..m).filter(first).collect();
        let forces = CurvedForces::with_planes(flexibility.to_vec(), m, &planes);
        let massless = structure.massless();
        let contact = |(i, contact): (usize, &crate::system::structure::Contact)| {
            let relation = contact.law.clone();
            let limit = relation.limit().map_or(0.0, |limit| limit.at(0.0));
            let own = forces.flexibility(i);
            // Both directions of a plane have one rate.
            let partner = match relation.row() {
                Some(PlaneRow::First) => i + 1,
                Some(PlaneRow::Second) => i - 1,
                None => i,
            };
            let nodes = contact.along.iter().chain(&contacts[partner].along);
            let is_massless = nodes.into_iter().any(|(node, _)| massless[*node]);
            let scale = Scale {
                pace: if is_massless { 1.0 / dt } else { pace },
                dt,
                is_massless,
            };
            let law = relation.law(limit);
            let steps = scale.steps(own);
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
                own,
                line: match scale.is_explicit() {
                    true => explicit_line(&relation),
                    false => line(&relation, scale.pace),
                },
                scale,
                bounds: law.properties().bounds(),
                plane: curved_plane::first(structure, i, limit, scale, own),
                relation,
                motion: Motion::default(),
            }
        };
        let contacts = contacts.iter().enumerate().map(contact).collect();
        Curved {
            forces,
            contacts,
            d: vec![0.0; m],
            size: vec![0.0; m],
            force: vec![0.0; m],
        }
    }

    /// The law of a contact with its memory.
    pub(super) fn law(&self, contact: usize) -> AnyRunningLaw<1> {
        self.contacts[contact].law
    }

    /// What the law of a contact in a plane remembers; `None` of others and of second directions.
    pub(super) fn plane(&self, contact: usize) -> Option<PlaneMemory> {
        self.contacts[contact].plane.map(|plane| plane.memory)
    }

    /// Whether a contact's law may have several answers in a step.
    pub(super) fn is_ambiguous(&self) -> bool {
        let has_one = |contact: &Contact| {
            let limit = contact.relation.limit().map_or(0.0, |limit| limit.at(0.0));
            let law = contact.relation.law(limit);
            law.properties()
                .has_one_root(&contact.scale.steps(contact.own)[0])
        };
        !self.contacts.iter().all(has_one)
    }

    /// Changes the friction limit of a contact.
    pub(super) fn limit(&mut self, contact: usize, limit: f64) {
        let contact = &mut self.contacts[contact];
        let law = contact.relation.law(limit);
        contact.law.change(&law, &contact.scale.steps(contact.own));
        contact.now = law;
        contact.bounds = law.properties().bounds();
        if let Some(plane) = &mut contact.plane {
            let step = curved_plane::step(contact.scale, contact.own);
            plane.law = PlaneLaw::new(&law, step).unwrap_or(plane.law);
        }
    }

    /// Takes over what the laws remember from the sub-step before.
    pub(super) fn remember(&mut self, before: &Curved) {
        for (contact, before) in self.contacts.iter_mut().zip(&before.contacts) {
            contact.law = before.law;
            if let (Some(plane), Some(before)) = (&mut contact.plane, &before.plane) {
                plane.memory = before.memory;
            }
            contact
                .law
                .change(&contact.now, &contact.scale.steps(contact.own));
        }
    }

    /// The forces at the end of the step with these motions.
    pub(super) fn solve(&mut self, motion: impl Fn(usize) -> Motion) -> Result<&[f64], Unsolved> {
        for (i, contact) in self.contacts.iter_mut().enumerate() {
            contact.motion = motion(i);
            if contact.scale.is_massless {
                contact.motion.rate = contact.motion.change / contact.scale.dt;
            }
            self.d[i] = contact.scale.free(&contact.motion);
            self.size[i] = contact.motion.size;
            self.force[i] = contact.motion.force;
            contact.begin();
        }
        let laws = Contacts(&self.contacts);
        self.forces
            .solve(&self.d, &self.size, &laws, &mut self.force)?;
        for i in 0..self.contacts.len() {
            let y = self.forces.argument(i);
            match self.contacts[i].relation.row() {
                None => {
                    let contact = &mut self.contacts[i];
                    let trial = contact.trial(y);
                    ContactResponse::force(&mut contact.law, 0, &trial);
                }
                Some(PlaneRow::First) => {
                    let y = [y, self.forces.argument(i + 1)];
                    let after = Contacts(&self.contacts).in_plane(i, y).map(|own| own.1);
                    if let (Some(plane), Some(after)) = (&mut self.contacts[i].plane, after) {
                        plane.memory = after;
                    }
                }
                Some(PlaneRow::Second) => {}
            }
        }
        Ok(&self.force)
    }

    /// Energy that the contacts store.
    pub(super) fn stored_energy(&self, states: impl Iterator<Item = [f64; 2]>) -> f64 {
        let energy = |(contact, [r, s]): (&Contact, [f64; 2])| contact.stored_energy(r, s);
        self.contacts.iter().zip(states).map(energy).sum()
    }
}

impl Contact {
    /// The trial with this y.
    fn trial(&self, y: f64) -> Trial<1> {
        let motion = &self.motion;
        if self.scale.is_explicit() {
            return trial(motion, motion.change, y);
        }
        let rate = motion.rate + self.scale.pace * (y - motion.change);
        trial(motion, y, rate)
    }

    /// Sets the closing speed of an impact that may begin in this step.
    ///
    /// The law takes it from a trial that overlaps. Where other contacts push this one together, the trial without forces does not
    /// overlap: then it is the present closing speed, or the mean one that closes the gap in the step. So it does not depend on the
    /// forces, and the law rises.
    fn begin(&mut self) {
        if self.relation.kind() != ContactKind::Impact {
            return;
        }
        let motion = self.motion;
        let r = motion.displacement;
        let free = self.trial(self.scale.free(&motion));
        let touching = match r + motion.change < 0.0 {
            true => free,
            false => {
                let just = if r > 0.0 { -r * (1.0 + 1e-12) } else { 0.0 };
                let just = if r == 0.0 { -f64::MIN_POSITIVE } else { just };
                let rate = f64::min(motion.velocity, -r.max(0.0) / self.scale.dt);
                trial(&motion, just, rate)
            }
        };
        ContactResponse::force(&mut self.law, 0, &touching);
    }

    fn stored_energy(&self, r: f64, s: f64) -> f64 {
        use crate::contact::StoredEnergy;
        self.relation.law(1.0).stored_energy(r, s)
    }
}

/// The contacts over a step.
struct Contacts<'a>(&'a [Contact]);

impl Contacts<'_> {
    /// J(y) of a contact in a plane, and what its law remembers then.
    fn in_plane(&self, contact: usize, y: Pair) -> Option<(Pair, PlaneMemory)> {
        let [first, second] = [contact, contact + 1].map(|i| &self.0[i]);
        let plane = first.plane.as_ref()?;
        Some(plane.answer([&first.motion, &second.motion], y))
    }
}

impl Laws for Contacts<'_> {
    fn is_plane(&self, contact: usize) -> bool {
        self.0[contact].plane.is_some()
    }

    fn answer_plane(&self, contact: usize, y: Pair) -> Pair {
        self.in_plane(contact, y)
            .map_or([f64::NAN; 2], |(force, _)| force)
    }

    fn directions(&self, contact: usize, y: Pair, force: Pair) -> Directions {
        let [first, second] = [contact, contact + 1].map(|i| &self.0[i]);
        match &first.plane {
            Some(plane) => plane.directions([&first.motion, &second.motion], y, force),
            None => Directions {
                along: [1.0, 0.0],
                slopes: [f64::INFINITY; 2],
            },
        }
    }

    fn answer(&self, contact: usize, y: f64) -> f64 {
        let contact = &self.0[contact];
        // The memory changes when the step is done.
        let mut law = contact.law;
        let Lane([force]) = ContactResponse::force(&mut law, 0, &contact.trial(y));
        force
    }

    fn compliance(&self, contact: usize, y: f64, force: f64, width: f64) -> f64 {
        let contact = &self.0[contact];
        if let Some(line) = contact.line {
            let [low, high] = contact.bounds;
            let inside = low < force && force < high;
            return if inside { line } else { f64::INFINITY };
        }
        let change = y - contact.own * force;
        let at = |change: f64| {
            let mut law = contact.law;
            let Lane([force]) = ContactResponse::force(&mut law, 1, &contact.trial(change));
            force
        };
        2.0 * width / (at(change + width) - at(change - width))
    }

    fn bounds(&self, contact: usize) -> [f64; 2] {
        self.0[contact].bounds
    }
}

/// S(0) of a contact with a law that is not a clipped line: it follows from r and rdot, or from its state, which is unbent without static
/// loads.
pub(super) fn first_force(structure: &Structure, contact: usize, r: f64, rdot: f64) -> f64 {
    let relation = &structure.contacts[contact].law;
    let limit = relation.limit().map_or(0.0, |limit| limit.at(0.0));
    let law = relation.law(limit);
    let scale = Scale {
        pace: 0.0,
        dt: 1.0,
        is_massless: false,
    };
    let remembers = structure.preload.laws.get(contact).copied().flatten();
    if let (Some(force), None) = (law.properties().unbent_force(rdot), remembers) {
        return force;
    }
    // A contact that leaves its equilibrium with a velocity has the state of the equilibrium.
    let at_rest = structure.preload.force(contact);
    if let (Some(own), Some(_), true) = (law.evolution(), at_rest, rdot != 0.0) {
        return own.force(own.at_start(at_rest, r), r, rdot);
    }
    let running = || ContactLaw::running(&[law], &scale.steps(0.0));
    let mut law: AnyRunningLaw<1> = remembers.unwrap_or_else(running);
    let motion = Motion {
        displacement: r,
        velocity: rdot,
        force: at_rest.unwrap_or_default(),
        ..Motion::default()
    };
    let Lane([force]) = ContactResponse::force(&mut law, 1, &trial(&motion, 0.0, rdot));
    force
}
