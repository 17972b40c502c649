//! The equations of a structure: M u'' + C u' + K u + B S = p(t), in the coordinates of a model.

use super::Flow;
use super::contact::{Contact, LimitAt, Motion, Watched};
use crate::exact::events::{Model, State, StateBuffers};
use crate::system::structure::{Limit, Structure, StructureLaw};

/// Part of the time between two points of tables over which the rate of a limit is a difference.
const DIFFERENCE: f64 = 1e-4;

/// Round-off of the change of velocities in a step over its terms and the tolerance, some five times the unit round-off: a body that
/// hardly moves under forces in equilibrium has no better velocity.
const ROUND_OFF_OF_STEP: f64 = 1e-3;

/// A structure with its contacts.
pub struct Moving<'a> {
    model: Model<'a>,
    contacts: Vec<Contact>,
    /// Place of z of each contact; `None` without a state.
    places: Vec<Option<usize>>,
    groups: Vec<usize>,
    /// Start and end of the present smooth part of all signals.
    part: [f64; 2],
    watched: Vec<Watched>,
    /// The time of the last end of a step.
    t: f64,
    /// The largest sum of the sizes of the terms of an acceleration there, whose round-off it has.
    acceleration_terms: f64,
    work: f64,
}

impl<'a> Moving<'a> {
    /// The equations, and the state at t = 0.
    pub fn new(model: Model<'a>) -> (Moving<'a>, Vec<f64>) {
        let structure = model.structure;
        let n = model.len();
        let [u, v] = &model.start;
        let mut y: Vec<f64> = u.iter().chain(v).copied().collect();
        let mut groups: Vec<usize> = (0..2 * n).map(|i| i / n.max(1)).collect();
        let (mut contacts, mut places) = (Vec::new(), Vec::new());
        for (i, own) in structure.contacts.iter().enumerate() {
            let limit = own.law.limit().map_or(0.0, |limit| limit.at(0.0));
            let law = own.law.law(limit);
            let [gap, of_gap] = moved_gap(structure, i, 0.0);
            let r = model.columns[i].dot(u) + own.gap + gap;
            let rdot = model.columns[i].dot(v) + of_gap;
            let memory = structure.preload.laws.get(i).copied().flatten();
            let at_rest = structure.preload.force(i);
            let contact = Contact::new(law, 0.0, [r, rdot], (at_rest, memory));
            places.push(contact.state().map(|z| {
                y.push(z);
                groups.push(2 + i);
                y.len() - 1
            }));
            contacts.push(contact);
        }
        // Products of matrices and vectors, and about 50 of them for the answer of a law.
        let entries = model.stiffness.entries() + model.damping.entries() + 8 * n;
        let columns: usize = model.columns.iter().map(|row| row.entries()).sum();
        let signals = model.patterns.iter().map(|row| 20 + row.entries());
        let once = entries + 3 * columns + 50 * contacts.len() + signals.sum::<usize>();
        let moving = Moving {
            contacts,
            places,
            groups,
            part: [0.0, f64::INFINITY],
            watched: Vec::new(),
            t: 0.0,
            acceleration_terms: 0.0,
            work: 12.0 * once as f64,
            model,
        };
        (moving, y)
    }

    /// Times at which the equations are not smooth.
    pub fn points(&self) -> &[f64] {
        &self.model.points
    }

    /// A time of the present part: at its end, the one before.
    fn inside(&self, t: f64) -> f64 {
        match t >= self.part[1] {
            true => self.part[1].next_down(),
            false => t,
        }
    }

    fn limit(&self, contact: usize, t: f64) -> Option<LimitAt> {
        let limit = self.model.structure.contacts[contact].law.limit()?;
        limit.varying.as_ref()?;
        let t = self.inside(t);
        Some(LimitAt {
            value: limit.at(t),
            rate: self.limit_rate(limit, t),
        })
    }

    /// The rate of a limit. Where a state leaves its bound, it differs from that of the bound by nothing, so that an error of the rate
    /// changes S only by its square.
    fn limit_rate(&self, limit: &Limit, t: f64) -> f64 {
        let [start, end] = self.part;
        let h = DIFFERENCE * (end - start).min(1.0);
        let [before, after] = [(t - h).max(start), (t + h).min(end.next_down())];
        (limit.at(after) - limit.at(before)) / (after - before)
    }

    /// r and rdot of a contact.
    fn relative(&self, contact: usize, t: f64, y: &[f64]) -> [f64; 2] {
        let n = self.model.len();
        let column = &self.model.columns[contact];
        let structure = self.model.structure;
        let [gap, of_gap] = moved_gap(structure, contact, t);
        [
            column.dot(&y[..n]) + structure.contacts[contact].gap + gap,
            column.dot(&y[n..2 * n]) + of_gap,
        ]
    }

    /// The same with the sizes of their terms.
    fn motion(&self, contact: usize, t: f64, y: &[f64]) -> Motion {
        let n = self.model.len();
        let column = &self.model.columns[contact];
        let structure = self.model.structure;
        let of_supports = structure.supports.iter();
        let [mut u, mut v] = [column.size(&y[..n]), column.size(&y[n..2 * n])];
        for support in of_supports {
            let motion = support.motion.at(t);
            u += (support.gaps[contact] * motion[0]).abs();
            v += (support.gaps[contact] * motion[1]).abs();
        }
        Motion {
            values: self.relative(contact, t, y),
            sizes: [u + structure.contacts[contact].gap.abs(), v],
        }
    }

    /// The largest sum of the sizes of the terms of an acceleration.
    fn terms(&self, t: f64, y: &[f64]) -> f64 {
        let n = self.model.len();
        let mut sums = vec![0.0; n];
        self.model.stiffness.add_terms(&y[..n], &mut sums);
        self.model.damping.add_terms(&y[n..2 * n], &mut sums);
        let loads = self.model.structure.loads.iter();
        for (load, pattern) in loads.zip(&self.model.patterns) {
            pattern.add_sizes(load.signal.at(self.inside(t)), &mut sums);
        }
        for i in 0..self.contacts.len() {
            let size = self.contacts[i].force_terms(
                self.motion(i, t, y),
                self.state_of(i, y),
                self.limit(i, t),
            );
            self.model.columns[i].add_sizes(size, &mut sums);
        }
        let accelerations = sums.iter().zip(&self.model.inverse_masses);
        accelerations.fold(0.0, |most, (sum, w)| most.max(sum * w))
    }

    fn state_of(&self, contact: usize, y: &[f64]) -> Option<f64> {
        self.places[contact].map(|place| y[place])
    }

    fn force(&self, contact: usize, t: f64, y: &[f64]) -> f64 {
        let own = &self.contacts[contact];
        let motion = self.relative(contact, t, y);
        own.force(motion, self.state_of(contact, y), self.limit(contact, t))
    }

    /// The state at a time, which is an end of a step; of modes, u and u' of these nodes only.
    pub fn record<'b>(&self, y: &[f64], nodes: &[usize], room: &'b mut StateBuffers) -> State<'b> {
        let t = self.t;
        let n = self.model.len();
        for (i, own) in self.model.structure.contacts.iter().enumerate() {
            [room.r[i], room.rate[i]] = self.relative(i, t, y);
            room.force[i] = self.force(i, t, y);
            room.slip[i] = room.r[i];
            if let StructureLaw::DisplacementControl { stiffness, .. } = own.law {
                room.slip[i] -= room.force[i] / stiffness;
            }
        }
        match &self.model.modes {
            None => {
                room.u.copy_from_slice(&y[..n]);
                room.v.copy_from_slice(&y[n..2 * n]);
            }
            Some(modes) => {
                // Without contacts at them, nodes without mass follow the modes and the loads.
                let signals = self.model.structure.loads.iter();
                let at: Vec<f64> = signals.map(|load| load.signal.at(t)).collect();
                for node in nodes {
                    room.u[*node] = modes.at(*node, &y[..n], [&at, &room.force, &[]]);
                    room.v[*node] = modes.at(*node, &y[n..2 * n], [&[], &[], &[]]);
                }
            }
        }
        room.state()
    }
}

/// What supports that move add to a gap and to its rate.
fn moved_gap(structure: &Structure, contact: usize, t: f64) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for support in &structure.supports {
        let [u, v, _] = support.motion.at(t);
        sum[0] += support.gaps[contact] * u;
        sum[1] += support.gaps[contact] * v;
    }
    sum
}

impl Flow for Moving<'_> {
    fn groups(&self) -> &[usize] {
        &self.groups
    }

    fn work(&self) -> f64 {
        self.work
    }

    fn raise(&self, h: f64, largest: &mut [f64]) {
        largest[1] = largest[1].max(ROUND_OFF_OF_STEP * h * self.acceleration_terms);
        for (contact, place) in self.contacts.iter().zip(&self.places) {
            if let Some(place) = *place {
                let largest = &mut largest[self.groups[place]];
                *largest = largest.max(contact.least_state());
            }
        }
    }

    fn enter(&mut self, part: [f64; 2]) {
        self.part = part;
    }

    fn rates(&mut self, t: f64, y: &[f64], to: &mut [f64]) {
        let n = self.model.len();
        let (u, v) = (&y[..n], &y[n..2 * n]);
        let (rates, rest) = to.split_at_mut(n);
        let a = &mut rest[..n];
        rates.copy_from_slice(v);
        a.fill(0.0);
        self.model.stiffness.subtract_product(1.0, u, a);
        self.model.damping.subtract_product(1.0, v, a);
        let loads = self.model.structure.loads.iter();
        for (load, pattern) in loads.zip(&self.model.patterns) {
            pattern.add(load.signal.at(self.inside(t)), a);
        }
        for i in 0..self.contacts.len() {
            let force = self.force(i, t, y);
            if force != 0.0 {
                self.model.columns[i].add(-force, a);
            }
        }
        for (a, w) in a.iter_mut().zip(&self.model.inverse_masses) {
            *a *= w;
        }
        for (i, place) in self.places.iter().enumerate() {
            if let Some(place) = *place {
                let [_, rdot] = self.relative(i, t, y);
                to[place] = self.contacts[i].rate(y[place], rdot, self.limit(i, t));
            }
        }
    }

    fn watch(&mut self, t: f64, y: &[f64]) -> &[Watched] {
        let mut watched = std::mem::take(&mut self.watched);
        watched.clear();
        for (i, contact) in self.contacts.iter().enumerate() {
            let motion = self.relative(i, t, y);
            contact.watch(motion, self.state_of(i, y), self.limit(i, t), &mut watched);
        }
        self.watched = watched;
        &self.watched
    }

    fn commit(&mut self, t: f64, y: &mut [f64]) {
        self.t = t;
        self.acceleration_terms = self.terms(t, y);
        for i in 0..self.contacts.len() {
            let mut motion = self.motion(i, t, y);
            // A velocity has the round-off of the accelerations of which it is the integral.
            motion.sizes[1] = motion.sizes[1].max(self.acceleration_terms * t);
            let (z, limit) = (self.state_of(i, y), self.limit(i, t));
            let z = self.contacts[i].commit(motion, z, limit);
            if let (Some(place), Some(z)) = (self.places[i], z) {
                y[place] = z;
            }
        }
    }
}
