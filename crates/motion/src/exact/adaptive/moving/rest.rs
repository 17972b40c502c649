//! Contacts in a plane without compliance: which of them stick, begin to slide and slide.

use super::rigid_planes::{self, Accelerations};
use super::structure::{Moving, moved_gap};
use crate::contact::RigidForces;
use crate::contact::plane::length;
use crate::exact::adaptive::plane::{Phase, PlaneContact};
use crate::exact::adaptive::watched::LimitAt;
use crate::system::structure::Structure;

/// Part of its limit that a force which begins to slide may miss by round-off: shares of contacts that hold a body together have 1e-10.
const ROUND_OFF: f64 = 1e-9;

/// Part of its terms from which on the acceleration of a contact at its limit is none of round-off.
const MOVES: f64 = 1e-11;

/// A limit of a contact.
type LimitOf = fn(&PlaneContact, Option<LimitAt>) -> f64;

impl Moving<'_> {
    /// Both rows of these contacts, by their first ones.
    fn rows(firsts: &[usize]) -> Vec<usize> {
        firsts
            .iter()
            .flat_map(|first| [*first, *first + 1])
            .collect()
    }

    /// The limits of both rows of these contacts up to which they stick.
    fn static_limits(&self, firsts: &[usize], t: f64, y: &[f64]) -> Vec<f64> {
        self.limits(firsts, t, y, PlaneContact::static_limit)
    }

    /// Those with which they slide.
    fn kinetic_limits(&self, firsts: &[usize], t: f64, y: &[f64]) -> Vec<f64> {
        self.limits(firsts, t, y, PlaneContact::limit)
    }

    fn limits(&self, firsts: &[usize], t: f64, y: &[f64], limit: LimitOf) -> Vec<f64> {
        let of = |first: usize| {
            let plane = self.planes[first].as_ref();
            plane.map_or(0.0, |plane| limit(plane, self.limit(first, t, y)))
        };
        let limits: Vec<f64> = firsts.iter().map(|first| of(*first)).collect();
        limits.iter().flat_map(|limit| [*limit; 2]).collect()
    }

    /// Writes the forces of rigid contacts in a plane: those that act, and those that would hold them. `a` is M a without contacts.
    pub(crate) fn hold(&self, t: f64, y: &[f64], a: &[f64], [forces, held]: [&mut Vec<f64>; 2]) {
        let mut sums = a.to_vec();
        for (i, force) in forces.iter().enumerate() {
            if *force != 0.0 {
                self.model.columns[i].add(-force, &mut sums);
            }
        }
        let [mut slides, mut begins, mut sticks] = [const { Vec::new() }; 3];
        for (first, plane) in self.planes() {
            match plane.phase {
                None => {}
                Some(_) if plane.has_direction(t) => slides.push(first),
                Some(Phase::Begins { .. }) => begins.push(first),
                Some(_) => sticks.push(first),
            }
        }
        let act = |firsts: &[usize], sums: &mut Vec<f64>, held: &[f64], forces: &mut Vec<f64>| {
            for first in firsts {
                if let Some(plane) = &self.planes[*first] {
                    let state = self.in_plane(*first, t, y, [held[*first], held[first + 1]]);
                    let plane_forces = plane.force(&state, self.limit(*first, t, y));
                    for (row, force) in [*first, first + 1].into_iter().zip(plane_forces) {
                        forces[row] = force;
                        self.model.columns[row].add(-force, sums);
                    }
                }
            }
        };
        let gaps = |row: usize| gap_acceleration(self.model.structure, row, t);
        let find = |firsts: &[usize], sums: &[f64], held: &mut Vec<f64>| {
            let rows = Self::rows(firsts);
            let of = Accelerations { sums, gaps: &gaps };
            let found =
                rigid_planes::held(&self.model, &rows, &of, &self.static_limits(firsts, t, y));
            for (row, force) in rows.iter().zip(found) {
                held[*row] = force;
            }
        };
        act(&slides, &mut sums, held, forces);
        if !begins.is_empty() {
            let both: Vec<usize> = begins.iter().chain(&sticks).copied().collect();
            find(&both, &sums, held);
            act(&begins, &mut sums, held, forces);
        }
        if !sticks.is_empty() {
            find(&sticks, &sums, held);
            act(&sticks, &mut sums, held, forces);
        }
    }

    /// Takes the states of contacts in a plane as their last ones, and finds which of those without compliance rest.
    pub(crate) fn commit_planes(&mut self, t: f64, y: &mut [f64]) {
        let (mut rests, mut stopped) = (Vec::new(), false);
        for first in 0..self.planes.len() {
            if self.planes[first].is_none() {
                continue;
            }
            let state = self.in_plane(first, t, y, [0.0; 2]);
            let motions = [first, first + 1].map(|row| self.motion(row, t, y));
            let size = |which: usize| length(motions.map(|motion| motion.sizes[which]));
            let sizes = [size(0), size(1).max(self.acceleration_terms * t)];
            let limit = self.moving_limit(first, t, y);
            let Some(plane) = &mut self.planes[first] else {
                continue;
            };
            let z = plane.commit(&state, sizes, limit);
            if let Some(index) = self.places[first] {
                y[index..index + 2].copy_from_slice(&z);
            }
            if plane.stops(&state, limit) {
                plane.phase = Some(Phase::Sticks);
                stopped = true;
            }
            match plane.phase {
                Some(Phase::Sticks) => rests.push(first),
                Some(Phase::Begins { .. }) if plane.is_fast => plane.phase = Some(Phase::Slides),
                _ => {}
            }
            plane.follow_line(&state, sizes[0]);
        }
        if !rests.is_empty() && (self.begin_from(&rests, t, y) || stopped) {
            self.stop(&rests, t, y);
        }
    }

    /// Whether contacts that rest begin to slide: the forces within the discs that leave the least accelerations are at their limits.
    /// Those at static limits break loose together: their limits become the kinetic ones, and the forces are found again.
    fn begin_from(&mut self, rests: &[usize], t: f64, y: &[f64]) -> bool {
        let [_, held] = self.sums(t, y, &mut vec![0.0; self.model.len()]);
        let rows = Self::rows(rests);
        let mut limits = self.static_limits(rests, t, y);
        let held_size = |i: usize| length([held[rows[2 * i]], held[rows[2 * i + 1]]]);
        let m = rows.len();
        if (0..rests.len()).all(|i| held_size(i) < limits[2 * i]) {
            return false;
        }
        let kinetic = self.kinetic_limits(rests, t, y);
        let matrix = self.model.flexibility(&rows);
        let held: Vec<f64> = rows.iter().map(|row| held[*row]).collect();
        let product = |size: fn(f64) -> f64| -> Vec<f64> {
            let row = |i: usize| (0..m).map(|j| size(matrix[i * m + j] * held[j])).sum();
            (0..m).map(row).collect()
        };
        let [d, sizes] = [product(|x| x), product(f64::abs)];
        let firsts = (0..m).map(|i| i % 2 == 0).collect();
        let mut problem = RigidForces::new(matrix.clone(), firsts);
        let beginning = loop {
            let low: Vec<f64> = limits.iter().map(|limit| -limit).collect();
            let mut forces: Vec<f64> = (0..m)
                .map(|i| held[i] * (limits[i] / held_size(i / 2)).min(1.0))
                .collect();
            // Forces that are not unique move the bodies alike.
            let _ = problem.solve(&d, [&low, &limits], &sizes, &mut forces);
            let moves = |row: usize| {
                let taken = (0..m).map(|j| matrix[row * m + j] * forces[j]);
                (d[row] - taken.sum::<f64>()).abs() > MOVES * sizes[row]
            };
            let begins = |i: &usize| {
                let size = length([forces[2 * i], forces[2 * i + 1]]);
                let at_limit = size >= (1.0 - ROUND_OFF) * limits[2 * i];
                at_limit && (moves(2 * i) || moves(2 * i + 1))
            };
            let beginning: Vec<usize> = (0..rests.len()).filter(begins).collect();
            let sticks = |i: &&usize| limits[2 * **i] > kinetic[2 * **i];
            let loose: Vec<usize> = beginning.iter().filter(sticks).copied().collect();
            if loose.is_empty() {
                break beginning;
            }
            for row in loose.iter().flat_map(|i| [2 * i, 2 * i + 1]) {
                limits[row] = kinetic[row];
            }
        };
        for i in &beginning {
            if let Some(plane) = &mut self.planes[rests[*i]] {
                plane.phase = Some(match limits[2 * i] > 0.0 {
                    true => Phase::Begins { since: t },
                    // Without friction it has no direction.
                    false => Phase::Slides,
                });
            }
        }
        !beginning.is_empty()
    }

    /// An impulse that takes the rest of the velocity: B^T (v - M^-1 B p) + G' = 0.
    fn stop(&self, rests: &[usize], t: f64, y: &mut [f64]) {
        let n = self.model.len();
        let limits = self.static_limits(rests, t, y);
        let velocities = &mut y[n..2 * n];
        let weights = &self.model.inverse_masses;
        let sums: Vec<f64> = velocities.iter().zip(weights).map(|(v, w)| v / w).collect();
        let gaps = |row: usize| moved_gap(self.model.structure, row, t)[1];
        let of = Accelerations {
            sums: &sums,
            gaps: &gaps,
        };
        let rows = Self::rows(rests);
        let impulses = rigid_planes::held(&self.model, &rows, &of, &limits);
        let mut changes = vec![0.0; n];
        for (row, impulse) in rows.iter().zip(impulses) {
            self.model.columns[*row].add(-impulse, &mut changes);
        }
        for ((v, change), w) in velocities.iter_mut().zip(changes).zip(weights) {
            *v += change * w;
        }
    }
}

/// What supports that move add to the acceleration of a gap.
fn gap_acceleration(structure: &Structure, contact: usize, t: f64) -> f64 {
    let supports = structure.supports.iter();
    supports.fold(0.0, |sum, support| {
        sum + support.gaps[contact] * support.motion.at(t)[2]
    })
}
