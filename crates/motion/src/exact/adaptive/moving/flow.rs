//! The motion of a structure as a flow.

use super::structure::{Moving, ROUND_OFF_OF_STEP};
use crate::exact::adaptive::Flow;
use crate::exact::adaptive::plane::PlaneContact;
use crate::exact::adaptive::watched::Watched;

impl Flow for Moving<'_> {
    fn groups(&self) -> &[usize] {
        &self.groups
    }

    fn work(&self) -> f64 {
        self.work
    }

    fn raise(&self, h: f64, largest: &mut [f64]) {
        let terms = match &self.last {
            Some(y) => self.acceleration_terms.max(self.terms(self.t + h, y)),
            None => self.acceleration_terms,
        };
        largest[1] = largest[1].max(ROUND_OFF_OF_STEP * h * terms);
        for (largest, least) in largest.iter_mut().zip(self.least) {
            *largest = largest.max(least);
        }
        if self.last.is_some() {
            largest[0] = largest[0].max(h * largest[1]);
        }
        for (i, (contact, index)) in self.contacts.iter().zip(&self.places).enumerate() {
            if let Some(index) = *index {
                let least = match &self.planes[i] {
                    // From rest, a state may have the same shape at all times, as u and u'.
                    Some(plane) => plane.least_state(self.least[0]),
                    None => contact.least_state(self.least[0]),
                };
                let largest = &mut largest[self.groups[index]];
                *largest = largest.max(least);
            }
        }
    }

    fn enter(&mut self, part: [f64; 2]) {
        self.part = part;
    }

    fn begins(&self) -> bool {
        !self.beginning().is_empty() || !self.creeping().is_empty()
    }

    fn begin(&mut self, t: f64, h: f64, y: &[f64], ends: [&mut [f64]; 2]) -> [f64; 2] {
        match self.creeping().is_empty() {
            true => self.begin_to_slide(t, h, y, ends),
            false => self.creep([t, h], y, ends),
        }
    }

    fn rates(&mut self, t: f64, y: &[f64], to: &mut [f64]) {
        let n = self.model.len();
        let (rates, rest) = to.split_at_mut(n);
        let a = &mut rest[..n];
        rates.copy_from_slice(&y[n..2 * n]);
        self.accelerations(t, y, a);
        for (i, index) in self.places.iter().enumerate() {
            let Some(index) = *index else {
                continue;
            };
            if let Some(plane) = &self.planes[i] {
                let state = self.in_plane(i, t, y, [0.0; 2]);
                let rate = plane.rate(&state, self.moving_limit(i, t, y));
                to[index..index + 2].copy_from_slice(&rate);
            } else {
                let [_, rdot] = self.relative(i, t, y);
                to[index] = self.contacts[i].rate(y[index], rdot, self.moving_limit(i, t, y));
            }
        }
    }

    fn watch(&mut self, t: f64, y: &[f64]) -> &[Watched] {
        let mut watched = std::mem::take(&mut self.watched);
        watched.clear();
        let is_rigid = |plane: &PlaneContact| plane.phase.is_some();
        let held = match self.planes().any(|(_, plane)| is_rigid(plane)) {
            true => {
                let [_, held] = self.sums(t, y, &mut vec![0.0; self.model.len()]);
                held
            }
            false => vec![0.0; self.contacts.len()],
        };
        for (first, plane) in self.planes() {
            let state = self.in_plane(first, t, y, [held[first], held[first + 1]]);
            plane.watch(&state, self.moving_limit(first, t, y), &mut watched);
        }
        for (i, contact) in self.contacts.iter().enumerate() {
            if self.model.structure.contacts[i].law.row().is_some() {
                continue;
            }
            let [r, rdot] = self.relative(i, t, y);
            // Where S is an unknown, rdot may be next to nothing, and changes its sign with S.
            let rdot = self.own_force(i).unwrap_or(rdot);
            contact.watch(
                [r, rdot],
                self.state_of(i, y),
                self.moving_limit(i, t, y),
                &mut watched,
            );
        }
        self.watched = watched;
        &self.watched
    }

    fn commit(&mut self, t: f64, y: &mut [f64]) {
        self.commit_creeps(t, y);
        self.t = t;
        self.acceleration_terms = self.terms(t, y);
        self.commit_planes(t, y);
        let is_rigid = self.planes().any(|(_, plane)| plane.phase.is_some());
        self.last = is_rigid.then(|| y.to_vec());
        for i in 0..self.contacts.len() {
            if self.model.structure.contacts[i].law.row().is_some() {
                continue;
            }
            let mut motion = self.motion(i, t, y);
            // A velocity has the round-off of the accelerations of which it is the integral.
            motion.sizes[1] = motion.sizes[1].max(self.acceleration_terms * t);
            let (z, limit) = (self.state_of(i, y), self.moving_limit(i, t, y));
            let z = self.contacts[i].commit(motion, z, limit);
            if let (Some(index), Some(z)) = (self.places[i], z) {
                y[index] = z;
            }
        }
    }
}
