//! What warnings need of a run: how far each contact was closed, its force and its work, and the largest energy.

use super::runaway::Runaway;
use super::step_view::Kind;
use crate::lane::Lane;
use crate::solve::structure::State;
use crate::system::structure::{PlaneRow, Structure, StructureLaw};

/// The contacts of L structures over a run.
#[derive(Debug, Clone)]
pub struct Watch<const L: usize> {
    /// Those that may make energy, by their places.
    contacts: Vec<(usize, Contact<L>)>,
    /// The friction contacts by their places, each with the largest abs(S) over its limit, and its smallest limit.
    friction: Vec<(usize, [Lane<L>; 2])>,
    /// Those of them that have both directions of a contact in a plane.
    planes: Vec<usize>,
    /// Work of the last step, for methods whose state has both ends of it.
    works: Vec<Lane<L>>,
    /// Energy that the contacts store at t = 0.
    stored: Lane<L>,
    /// Largest energy at the steps that are looked at.
    energy: Lane<L>,
    /// Of structures that may run away.
    runaway: Option<Runaway<L>>,
    /// Steps from one look at the energy to the next.
    every: usize,
    step: usize,
}

/// A contact over a run.
#[derive(Debug, Clone, Copy)]
struct Contact<const L: usize> {
    /// r and S after the last step.
    last: [Lane<L>; 2],
    /// Smallest r and S.
    smallest: [Lane<L>; 2],
    /// Largest r and S.
    largest: [Lane<L>; 2],
    /// Work up to the last step, and the smallest work up to any step.
    work: [Lane<L>; 2],
}

/// What a run of one structure shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Watched {
    /// Of each contact.
    pub contacts: Vec<WatchedContact>,
    /// Energy that the contacts store at t = 0.
    pub stored: f64,
    /// Largest energy: kinetic, strain, and stored in contacts, at the steps that were looked at, as the energy error has it.
    pub energy: f64,
    /// Whether the structure has lost its stability and moves away at the last step.
    pub runs_away: bool,
}

/// What a run shows of a contact; but for `of_limit`, zeros for one that cannot make energy.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WatchedContact {
    /// Smallest relative displacement r.
    pub displacement: f64,
    /// Largest relative displacement r.
    pub opening: f64,
    /// Smallest force S; below 0 if an impact touches.
    pub force: f64,
    /// Largest force S.
    pub pull: f64,
    /// Smallest work of the structure on the contact, the integral of S dr, up to any step.
    pub work: f64,
    /// Largest abs(S) of a friction contact over its limit; 1 or more also where the limit is 0, without N.
    pub of_limit: f64,
    /// Smallest limit of a friction contact at the steps after t = 0.
    pub limit: f64,
}

impl<const L: usize> Watch<L> {
    /// From the state of these structures at t = 0 on; the energy is looked at every so many steps, since it takes as long as a step.
    pub fn new(structures: &[&Structure; L], start: &State<L>, every: usize) -> Self {
        let zero = Lane::splat(0.0);
        let by_average = matches!(start.0, Kind::Average(_));
        let passive = |c: usize, of: &Structure| by_average && is_passive(&of.contacts[c].law);
        let numbers = 0..start.contacts();
        let watched = numbers.filter(|c| !structures.iter().all(|of| passive(*c, of)));
        let contacts = watched.map(|c| {
            let at_start = start.contact(c);
            let now = [at_start.displacement, at_start.force];
            let contact = Contact {
                last: now,
                smallest: now,
                largest: now,
                work: [zero; 2],
            };
            (c, contact)
        });
        let stored = start.stored_energy();
        let row = |c: usize| structures.first().and_then(|of| of.contacts[c].law.row());
        let is_friction = |c: &usize| {
            row(*c) != Some(PlaneRow::Second)
                && structures
                    .iter()
                    .any(|of| of.contacts[*c].law.limit().is_some())
        };
        let friction = (0..start.contacts()).filter(is_friction);
        let planes = (0..start.contacts()).filter(|c| row(*c) == Some(PlaneRow::First));
        Watch {
            contacts: contacts.collect(),
            friction: friction
                .map(|c| (c, [zero, Lane::splat(f64::INFINITY)]))
                .collect(),
            planes: planes.collect(),
            works: vec![zero; start.contacts()],
            stored,
            energy: start.energy() + stored,
            runaway: Runaway::new(structures, start),
            every,
            step: 0,
        }
    }

    /// Adds the step to `state`.
    #[inline(always)]
    pub fn add(&mut self, state: &State<L>) {
        self.step += 1;
        match &state.0 {
            Kind::Average(state) => {
                for (c, contact) in &mut self.contacts {
                    let motion = &state.contacts[*c];
                    let now = [motion.p - motion.w * 0.5, motion.force];
                    let [r, s] = contact.last;
                    let mean = state.mean_force(*c, [s, now[1]]);
                    contact.add(now, mean * (now[0] - r));
                }
                for (c, [most, least]) in &mut self.friction {
                    let limit = state.limit(*c);
                    *least = least.smaller(limit);
                    let force = size(self.planes.contains(c), |of| state.contacts[*c + of].force);
                    let mut share = of_limit(force, limit);
                    if let Some(friction) = &state.two_limits {
                        friction.show_share(*c, &mut share);
                    }
                    *most = most.larger(share);
                }
            }
            Kind::General(general) => {
                self.works.fill(Lane::splat(0.0));
                general.add_contact_work(&mut self.works);
                for (c, contact) in &mut self.contacts {
                    let now = state.contact(*c);
                    contact.add([now.displacement, now.force], self.works[*c]);
                }
                for (c, [most, least]) in &mut self.friction {
                    let limit = state.contact(*c).limit;
                    *least = least.smaller(limit);
                    let force = size(self.planes.contains(c), |of| state.contact(*c + of).force);
                    let mut share = of_limit(force, limit);
                    if let Some(friction) = general.two_limits() {
                        friction.show_share(*c, &mut share);
                    }
                    *most = most.larger(share);
                }
            }
        }
        if let Some(runaway) = &mut self.runaway {
            runaway.add(state);
        }
        if self.step.is_multiple_of(self.every) {
            let energy = state.energy() + state.stored_energy();
            self.energy = self.energy.larger(energy).larger(state.least_energy());
        }
    }

    /// What the run of a lane shows.
    pub fn of_lane(&self, l: usize) -> Watched {
        let mut contacts = vec![WatchedContact::default(); self.works.len()];
        for (c, contact) in &self.contacts {
            contacts[*c] = WatchedContact {
                displacement: contact.smallest[0].0[l],
                opening: contact.largest[0].0[l],
                force: contact.smallest[1].0[l],
                pull: contact.largest[1].0[l],
                work: contact.work[1].0[l],
                of_limit: 0.0,
                limit: 0.0,
            };
        }
        for (c, [most, least]) in &self.friction {
            let second = *c + usize::from(self.planes.contains(c));
            for contact in &mut contacts[*c..=second] {
                contact.of_limit = most.0[l];
                contact.limit = least.0[l];
            }
        }
        Watched {
            contacts,
            stored: self.stored.0[l],
            energy: self.energy.0[l],
            runs_away: self
                .runaway
                .as_ref()
                .is_some_and(|runaway| runaway.of_lane(l)),
        }
    }
}

/// S of a contact, or |S| of one in a plane.
#[inline(always)]
fn size<const L: usize>(in_plane: bool, force: impl Fn(usize) -> Lane<L>) -> Lane<L> {
    match in_plane {
        true => force(0).zip(force(1), libm::hypot),
        false => force(0),
    }
}

/// abs(S) over the limit; 1 without a limit.
#[inline(always)]
fn of_limit<const L: usize>(force: Lane<L>, limit: Lane<L>) -> Lane<L> {
    force.zip(limit, |s, limit| match limit > 0.0 {
        true => s.abs() / limit,
        false => 1.0,
    })
}

/// Whether no step of constant average acceleration has negative dissipation. For a force f(rdot) that rises and is odd,
/// (f(a) + f(b))(a + b) >= 0. For an elastic force up to a constant limit the slip of a step has the sign of the limit that it reaches, and
/// then the mean of both forces has it, too.
fn is_passive(law: &StructureLaw) -> bool {
    law.line().is_some()
        && law
            .limit()
            .is_some_and(|limit| limit.varying.is_none() && limit.pressed_by.is_none())
}

impl<const L: usize> Contact<L> {
    /// Adds a step to r and S with this work.
    #[inline(always)]
    fn add(&mut self, now: [Lane<L>; 2], work: Lane<L>) {
        let [sum, least] = self.work;
        let sum = sum + work;
        self.work = [sum, least.smaller(sum)];
        let [r, s] = self.smallest;
        self.smallest = [r.smaller(now[0]), s.smaller(now[1])];
        let [r, s] = self.largest;
        self.largest = [r.larger(now[0]), s.larger(now[1])];
        self.last = now;
    }
}
