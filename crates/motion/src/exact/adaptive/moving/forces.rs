//! Forces, accelerations and their terms in the motion of a structure.

use super::damper::Creep;
use super::structure::{DIFFERENCE, Moving};
use crate::contact::ClippedLine;
use crate::exact::events::{State, StateBuffers};
use crate::system::structure::Limit;

impl Moving<'_> {
    /// u'' of the coordinates.
    pub(crate) fn accelerations(&self, t: f64, y: &[f64], a: &mut [f64]) {
        let [forces, _] = self.sums(t, y, a);
        for (i, force) in forces.into_iter().enumerate() {
            if force != 0.0 {
                self.model.columns[i].add(-force, a);
            }
        }
        for (a, w) in a.iter_mut().zip(&self.model.inverse_masses) {
            *a *= w;
        }
    }

    /// The largest sum of the sizes of the terms of an acceleration.
    pub(crate) fn terms(&self, t: f64, y: &[f64]) -> f64 {
        let n = self.model.len();
        let mut sums = vec![0.0; n];
        self.model.stiffness.add_terms(&y[..n], &mut sums);
        self.model.damping.add_terms(&y[n..2 * n], &mut sums);
        let loads = self.model.structure.loads.iter();
        for (load, pattern) in loads.zip(&self.model.patterns) {
            pattern.add_sizes(load.signal.at(self.inside(t)), &mut sums);
        }
        // Scalar contacts have their forces below.
        let forces = match self.planes().next() {
            Some(_) => self.sums(t, y, &mut vec![0.0; n])[0].clone(),
            None => Vec::new(),
        };
        for (i, contact) in self.contacts.iter().enumerate() {
            if self.model.structure.contacts[i].law.row().is_some() {
                self.model.columns[i].add_sizes(forces[i], &mut sums);
                continue;
            }
            let follows = || {
                let motion = self.motion(i, t, y);
                contact.force_terms(motion, self.state_of(i, y), self.limit(i, t, y))
            };
            let size = self.own_force(i).map_or_else(follows, f64::abs);
            self.model.columns[i].add_sizes(size, &mut sums);
        }
        let accelerations = sums.iter().zip(&self.model.inverse_masses);
        accelerations.fold(0.0, |most, (sum, w)| most.max(sum * w))
    }

    pub(crate) fn state_of(&self, contact: usize, y: &[f64]) -> Option<f64> {
        self.places[contact].map(|index| y[index])
    }

    /// S of a damper that creeps, where S is an unknown of its own.
    pub(crate) fn own_force(&self, contact: usize) -> Option<f64> {
        self.creeps[contact].as_ref().and_then(Creep::force)
    }

    pub(crate) fn force(&self, contact: usize, t: f64, y: &[f64]) -> f64 {
        if let Some(force) = self.own_force(contact) {
            return force;
        }
        let contact_law = &self.contacts[contact];
        let motion = self.relative(contact, t, y);
        contact_law.force(motion, self.state_of(contact, y), self.limit(contact, t, y))
    }

    pub(crate) fn limit_value(&self, limit: &Limit, t: f64, y: &[f64]) -> f64 {
        let n = self.model.len();
        let motion = |node: usize| match &self.model.modes {
            None => [y[node], y[n + node]],
            Some(modes) => {
                let of = |part: &[f64]| modes.at(node, part, [&[], &[], &[]]);
                [of(&y[..n]), of(&y[n..2 * n])]
            }
        };
        limit.pressed_in(t, |other| self.force(other, t, y), motion)
    }

    /// The rate of a limit. Where a state leaves its bound, it differs from that of the bound by nothing, so that an error of the rate
    /// changes S only by its square.
    pub(crate) fn limit_rate(&self, contact: usize, t: f64, y: &[f64]) -> f64 {
        let Some(limit) = self.model.structure.contacts[contact].law.limit() else {
            return 0.0;
        };
        let [start, end] = self.part;
        let h = DIFFERENCE * (end - start).min(1.0);
        let [before, after] = [(t - h).max(start), (t + h).min(end.next_down())];
        if limit.pressed_by.is_none() {
            return (limit.at(after) - limit.at(before)) / (after - before);
        }
        // The parts that press move on as their accelerations say.
        let n = self.model.len();
        let mut a = vec![0.0; n];
        self.accelerations(t, y, &mut a);
        let at = |time: f64| {
            let by = time - t;
            let mut moved = y.to_vec();
            for i in 0..n {
                moved[i] += by * (y[n + i] + 0.5 * by * a[i]);
                moved[n + i] += by * a[i];
            }
            self.limit_value(limit, time, &moved)
        };
        (at(after) - at(before)) / (after - before)
    }
}

impl Moving<'_> {
    /// The state at a time, which is an end of a step; of modes, u and u' of these nodes only.
    pub fn record<'b>(&self, y: &[f64], nodes: &[usize], room: &'b mut StateBuffers) -> State<'b> {
        let t = self.t;
        let n = self.model.len();
        let mut a = vec![0.0; n];
        let [forces, _] = self.sums(t, y, &mut a);
        let mut force_rates = vec![0.0; forces.len()];
        for (i, given_contact) in self.model.structure.contacts.iter().enumerate() {
            [room.r[i], room.rate[i]] = self.relative(i, t, y);
            room.force[i] = forces[i];
            if let Some(compliance) = self.braces[i].filter(|_| given_contact.law.row().is_some()) {
                if let Some(plane) = &self.planes[i] {
                    let state = self.in_plane(i, t, y, [0.0; 2]);
                    let both = plane.rate(&state, self.moving_limit(i, t, y));
                    force_rates[i..i + 2].copy_from_slice(&both);
                }
                room.r[i] -= compliance * forces[i];
                room.rate[i] -= compliance * force_rates[i];
            } else if let (Some(compliance), Some(force)) = (self.braces[i], self.state_of(i, y)) {
                let limit = self.moving_limit(i, t, y);
                force_rates[i] = self.contacts[i].rate(force, room.rate[i], limit);
                room.r[i] -= compliance * force;
                room.rate[i] -= compliance * force_rates[i];
            }
            room.slip[i] = room.r[i];
            if let Some(ClippedLine::Elastic { stiffness }) = given_contact.law.line() {
                room.slip[i] -= room.force[i] / stiffness;
            }
        }
        match &self.model.modes {
            None => {
                room.u.copy_from_slice(&y[..n]);
                room.v.copy_from_slice(&y[n..2 * n]);
            }
            Some(modes) => {
                // Nodes without mass follow the modes, the loads and the contacts behind them.
                let signals = self.model.structure.loads.iter();
                let at: Vec<f64> = signals.map(|load| load.signal.at(t)).collect();
                for node in nodes {
                    room.u[*node] = modes.at(*node, &y[..n], [&at, &room.force, &[]]);
                    room.v[*node] = modes.at(*node, &y[n..2 * n], [&[], &force_rates, &[]]);
                }
            }
        }
        room.state()
    }
}
