//! The contacts of a structure with a law that is not a clipped line.
//!
//! Every law answers alone, r' = y - a S ([`CurvedForces`]). Within a step rdot' is affine in r', so an answer with
//! the flexibilities a for r' and `pace` a for rdot' is that of a structure with one contact. In an explicit method r' does not depend on
//! the forces: there y and a are those of rdot' = y - a S.

use super::curved_group::{Group, Groups, grouped, groups, of_masses};
use super::curved_plane::{self, Plane};
use super::curved_step::{Motion, ROUND_OFF, Scale, explicit_line, line, trial};
use super::static_friction::Bound;
use crate::contact::coupled::curved::CurvedForces;
use crate::contact::plane::{PlaneLaw, PlaneMemory};
use crate::contact::{AnyRunningLaw, ContactKind, ContactLaw, ContactResponse, Trial, Unsolved};
use crate::lane::Lane;
use crate::system::structure::{Chain, PlaneRow, Structure, StructureLaw};

/// The contacts of one structure.
#[derive(Debug)]
pub(super) struct Curved {
    forces: CurvedForces,
    contacts: Vec<Contact>,
    /// Contacts in series answer together.
    groups: Vec<Group>,
    /// Of the groups: a, and the numbers of a step.
    own: Vec<f64>,
    d: Vec<f64>,
    size: Vec<f64>,
    together: Vec<f64>,
    /// Of the contacts.
    force: Vec<f64>,
}

/// A contact.
#[derive(Debug)]
pub(super) struct Contact {
    relation: StructureLaw,
    /// The law with its memory: the answer with the flexibility a, and the law itself, without flexibility.
    law: AnyRunningLaw<1>,
    /// Its numbers, with the present limit.
    now: ContactLaw,
    /// a.
    pub(super) own: f64,
    pub(super) scale: Scale,
    /// 1/f' of a clipped line.
    line: Option<f64>,
    pub(super) bounds: [f64; 2],
    /// Whether they are those of Coulomb friction with two limits, and not those of the law.
    two_limits: bool,
    /// The motion over the step without the forces at its end.
    pub(super) motion: Motion,
    /// The largest sizes of the terms of r and rdot so far.
    pub(super) terms: [f64; 2],
    /// r at the end of the step.
    pub(super) displacement: f64,
    /// The law of both directions of a contact in a plane, beside the first one.
    pub(super) plane: Option<Plane>,
}

/// What the law of a contact remembers, also of a contact in a plane.
pub(super) type Memory = (AnyRunningLaw<1>, Option<PlaneMemory>);

/// A flexibility beside which every law is stiff.
const SOFT: f64 = 1e200;

impl Curved {
    /// The contacts of a structure with this H, by rows; `None` if all its laws are clipped lines.
    pub(super) fn new(
        structure: &Structure,
        flexibility: &[f64],
        pace: f64,
        dt: f64,
    ) -> Option<Curved> {
        let mut contacts = structure.contacts.iter();
        let chains = structure.chains();
        let any = !chains.is_empty() || contacts.any(|contact| contact.law.is_curved());
        any.then(|| Curved::of_all(structure, &chains, flexibility, pace, dt))
    }

    /// The contacts of a structure with this H, by rows, also if all its laws are clipped lines. Those in `chains` answer together.
    pub(super) fn of_all(
        structure: &Structure,
        chains: &[Chain],
        flexibility: &[f64],
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
        let planes = (0..groups.len()).filter(|g| is_first(&groups[*g]));
        let planes: Vec<usize> = planes.collect();
        let flexibility = grouped(flexibility, &groups, m);
        let forces = CurvedForces::with_planes(flexibility, groups.len(), &planes);
        let mut own = vec![0.0; m];
        for (g, group) in groups.iter().enumerate() {
            let flexibility = match forces.flexibility(g) {
                0.0 if group.is_chain() => of_masses(structure, group, dt),
                flexibility => flexibility,
            };
            group.contacts().for_each(|i| own[i] = flexibility);
        }
        let massless = structure.massless();
        let contact = |(i, contact): (usize, &crate::system::structure::Contact)| {
            let relation = contact.law.clone();
            let limit = relation.limit().map_or(0.0, |limit| limit.at(0.0));
            let own = own[i];
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
                two_limits: false,
                plane: curved_plane::first(structure, i, limit, scale, own),
                relation,
                motion: Motion::default(),
                terms: [0.0; 2],
                displacement: 0.0,
            }
        };
        let contacts = contacts.iter().enumerate().map(contact).collect();
        Curved {
            contacts,
            d: vec![0.0; groups.len()],
            size: vec![0.0; groups.len()],
            together: vec![0.0; groups.len()],
            own: (0..groups.len()).map(|g| forces.flexibility(g)).collect(),
            forces,
            force: vec![0.0; m],
            groups,
        }
    }

    /// r of a contact at the end of the last step, as its law has it.
    pub(super) fn displacement(&self, contact: usize) -> f64 {
        self.contacts[contact].displacement
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
        self.is_ambiguous_in(|_| true)
    }

    /// Whether the law of a contact of such kinds may.
    pub(super) fn is_ambiguous_in(&self, kinds: impl Fn(ContactKind) -> bool) -> bool {
        let has_one = |group: &Group, contact: &Contact| {
            if !kinds(contact.relation.kind()) {
                return true;
            }
            let limit = contact.relation.limit().map_or(0.0, |limit| limit.at(0.0));
            let law = contact.relation.law(limit);
            // Another contact in series may be as soft as it likes.
            let own = if group.is_chain() { SOFT } else { contact.own };
            law.properties().has_one_root(&contact.scale.steps(own)[0])
        };
        let mut groups = self.groups.iter();
        !groups.all(|group| group.contacts().all(|i| has_one(group, &self.contacts[i])))
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

    /// What the laws remember.
    pub(super) fn memory(&self) -> Vec<Memory> {
        self.contacts.iter().map(Contact::memory).collect()
    }

    /// Lets the laws remember this, with their present limits and flexibilities.
    pub(super) fn recall(&mut self, all: impl Iterator<Item = Memory>) {
        for (contact, (law, memory)) in self.contacts.iter_mut().zip(all) {
            contact.law = law;
            if let (Some(plane), Some(memory)) = (&mut contact.plane, memory) {
                plane.memory = memory;
            }
            let steps = contact.scale.steps(contact.own);
            contact.law.change(&contact.now, &steps);
        }
    }

    /// Changes the bounds of Coulomb friction with two limits.
    pub(super) fn bound(&mut self, contact: usize, bounds: [f64; 2]) {
        let contact = &mut self.contacts[contact];
        (contact.bounds, contact.two_limits) = (bounds, true);
    }

    /// Takes over what the laws remember from the sub-step before.
    pub(super) fn remember(&mut self, before: &Curved) {
        self.recall(before.contacts.iter().map(Contact::memory));
    }

    /// The forces at the end of the step with these motions.
    pub(super) fn solve(&mut self, motion: impl Fn(usize) -> Motion) -> Result<&[f64], Unsolved> {
        self.solve_until(motion, |_, _| false)
    }

    /// The same; `breaks` changes bounds as long as contacts break loose.
    pub(super) fn solve_until(
        &mut self,
        motion: impl Fn(usize) -> Motion,
        mut breaks: impl FnMut(&[f64], &mut Bound) -> bool,
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
                    contact.motion.rate = contact.motion.change / contact.scale.dt;
                }
                if !group.is_chain() {
                    contact.begin();
                }
            }
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
            };
            self.forces
                .solve(&self.d, &self.size, &groups, &mut self.together)?;
            for (g, group) in self.groups.iter().enumerate() {
                group.write(self.together[g], &mut self.force);
            }
            let contacts = &mut self.contacts;
            if !breaks(&self.force, &mut |c, bounds| contacts[c].bounds = bounds) {
                break;
            }
        }
        for (g, group) in self.groups.iter().enumerate() {
            let y = self.forces.argument(g);
            match group.row(&self.contacts) {
                None => {
                    let force = self.together[g];
                    group.end((y, self.own[g], force), &mut self.contacts, &mut self.force);
                }
                Some(PlaneRow::First) => {
                    let y = [y, self.forces.argument(g + 1)];
                    group.end_plane(y, &mut self.contacts);
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
    fn memory(&self) -> Memory {
        (self.law, self.plane.map(|plane| plane.memory))
    }

    /// Takes the motion of a step.
    fn move_by(&mut self, motion: Motion) {
        self.terms = [0, 1].map(|i| self.terms[i].max(motion.terms[i]));
        self.motion = motion;
    }

    /// The trial with this y.
    fn trial(&self, y: f64) -> Trial<1> {
        self.trial_of(&self.motion, y)
    }

    fn trial_of(&self, motion: &Motion, y: f64) -> Trial<1> {
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
        let motion = match self.now.properties().divides_by_closing_speed() {
            true => self.motion.without_round_off(self.terms),
            false => self.motion,
        };
        let r = motion.displacement;
        if r + motion.change < 0.0 {
            let free = self.trial_of(&motion, self.scale.free(&motion));
            ContactResponse::force(&mut self.law, 0, &free);
        } else {
            let rate = f64::min(motion.velocity, -r.max(0.0) / self.scale.dt);
            self.touch(motion, rate);
        }
    }

    /// Lets the law take its closing speed from a motion that just closes the contact at this rate.
    fn touch(&mut self, motion: Motion, rate: f64) {
        let r = motion.displacement;
        let just = if r > 0.0 { -r * (1.0 + 1e-12) } else { 0.0 };
        let just = if r == 0.0 { -f64::MIN_POSITIVE } else { just };
        ContactResponse::force(&mut self.law, 0, &trial(&motion, just, rate));
    }

    /// The same for a contact of a chain that closes at this rate.
    pub(super) fn begin_at(&mut self, rate: f64) {
        if self.relation.kind() == ContactKind::Impact {
            let motion = Motion {
                velocity: rate,
                ..self.motion
            };
            self.touch(motion, rate);
        }
    }

    /// The end of the step of a contact of a chain.
    pub(super) fn end_in_chain(&mut self, change: f64, force: f64, round_off: f64) {
        let change = self.without_round_off(change, force, round_off);
        self.displacement = self.motion.displacement + change;
        self.end(change + self.own * force, force);
    }

    /// A change without force, of an impact that overlaps by round-off only: it has not begun.
    fn without_round_off(&self, change: f64, force: f64, round_off: f64) -> f64 {
        let r = self.motion.displacement;
        let is_impact = self.relation.kind() == ContactKind::Impact;
        match is_impact && force == 0.0 && (r + change).abs() <= round_off {
            true => -r,
            false => change,
        }
    }

    /// The direction of a contact in a plane.
    pub(super) fn row(&self) -> Option<PlaneRow> {
        self.relation.row()
    }

    /// The gap that an impact has to close.
    pub(super) fn open(&self) -> f64 {
        match self.relation.kind() {
            ContactKind::Impact => self.motion.displacement.max(0.0),
            ContactKind::Friction | ContactKind::Link => 0.0,
        }
    }

    /// S of the trial with this y. The memory changes when the step is done.
    pub(super) fn answer(&self, y: f64) -> f64 {
        if self.two_limits {
            // What keeps rdot' = 0, within the bounds.
            let [low, high] = self.bounds;
            let rate = self.motion.rate + self.scale.pace * (y - self.motion.change);
            return (rate / (self.scale.pace * self.own)).clamp(low, high);
        }
        let mut law = self.law;
        let Lane([force]) = ContactResponse::force(&mut law, 0, &self.trial(y));
        force
    }

    /// 1/f' where the answer to y is `force`: of the line, or of a chord over `width` to both sides of r'.
    pub(super) fn compliance(&self, y: f64, force: f64, width: f64) -> f64 {
        if let Some(line) = self.line {
            let [low, high] = self.bounds;
            let inside = low < force && force < high;
            return if inside { line } else { f64::INFINITY };
        }
        let change = y - self.own * force;
        2.0 * width / (self.follow(change + width) - self.follow(change - width))
    }

    /// S of the trial in which r changes by this; of a contact without compliance on the side of the jump.
    pub(super) fn follow(&self, change: f64) -> f64 {
        let trial = self.trial(change);
        if self.relation.is_rigid() {
            let [low, high] = self.bounds;
            let is_impact = self.relation.kind() == ContactKind::Impact;
            let motion = match is_impact {
                true => self.motion.displacement + change,
                false => trial.rate.0[0],
            };
            return match motion.partial_cmp(&0.0) {
                Some(std::cmp::Ordering::Less) => low,
                Some(std::cmp::Ordering::Greater) => high,
                _ => 0.0,
            };
        }
        let mut law = self.law;
        let Lane([force]) = ContactResponse::force(&mut law, 1, &trial);
        force
    }

    /// Bounds of S of a contact without compliance whose r changes by this; `None` of others, whose force follows the change.
    pub(super) fn free_force(&self, change: f64, round_off: f64) -> Option<[f64; 2]> {
        let is_open = self.relation.kind() == ContactKind::Impact
            && self.motion.displacement + change > round_off;
        let bounds = if is_open { [0.0; 2] } else { self.bounds };
        self.relation.is_rigid().then_some(bounds)
    }

    /// The end of the step with this y, where S' is `force`.
    pub(super) fn end(&mut self, y: f64, force: f64) {
        let mut trial = self.trial(y);
        if self.has_not_begun(y, force) {
            trial.change = Lane([-self.motion.displacement]);
        }
        ContactResponse::force(&mut self.law, 0, &trial);
    }

    /// Whether this is the end of an impact that overlaps by round-off only. Its closing speed would be round-off, too, and a law
    /// that divides by it would hold the contact from then on.
    fn has_not_begun(&self, y: f64, force: f64) -> bool {
        let [change, by_force] = match self.scale.is_explicit() {
            true => [self.motion.change, 0.0],
            false => [y - self.own * force, self.own * force],
        };
        let least = ROUND_OFF * self.terms[0];
        self.now.properties().divides_by_closing_speed()
            && by_force.abs() <= least
            && (self.motion.displacement + change).abs() <= least
    }

    fn stored_energy(&self, r: f64, s: f64) -> f64 {
        use crate::contact::StoredEnergy;
        self.relation.law(1.0).stored_energy(r, s)
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
