//! Masses that are coupled, and nodes without mass.

use super::stages::General;
use crate::lane::Lane;
use crate::solve::structure::linear_part::between::Between;

impl<const L: usize> General<'_, L> {
    /// Adds a factor times M a at the start of a sub-step, without the diagonal of M.
    #[cold]
    pub(super) fn add_coupled_inertia(&mut self, part: usize, factor: f64) {
        let nodes = &self.stages[part].nodes;
        for (i, j, mass) in &self.prepared.coupled_mass {
            let mass = factor * mass;
            self.work[*i] = self.work[*i] + nodes[*j][2] * mass;
            self.work[*j] = self.work[*j] + nodes[*i][2] * mass;
        }
    }

    /// Replaces forces by accelerations, in the list of right sides; 0 for nodes without mass.
    #[cold]
    pub(super) fn divide_by_mass(&mut self) {
        let prepared = self.prepared;
        let Some(inertia) = &prepared.inertia_factor else {
            for (x, mass) in self.work.iter_mut().zip(&prepared.mass) {
                *x = match mass {
                    0.0 => Lane::splat(0.0),
                    mass => x.map(|x| x / mass),
                };
            }
            return;
        };
        let mut forces = vec![0.0; prepared.nodes()];
        for l in 0..L {
            for (force, row) in forces.iter_mut().zip(&prepared.place) {
                *force = self.work[*row].0[l];
            }
            inertia.divide(&mut forces);
            for (force, row) in forces.iter().zip(&prepared.place) {
                self.work[*row].0[l] = *force;
            }
        }
    }

    /// The right sides of the nodes without mass, so that K u + B S = p holds at the end of the sub-step: w1 p' + (1 - w1) K u, of
    /// which the springs take K u_e. They are moved by the solution alone.
    #[cold]
    pub(super) fn prescribe_massless(&mut self, part: usize, end: usize) {
        let zero = Lane::splat(0.0);
        let prepared = self.prepared;
        let w1 = prepared.sub_steps[part].sub_step.weights[1];
        let nodes = &self.stages[part].nodes;
        let mut loads = vec![zero; self.work.len()];
        self.inputs.add_ends(end, &mut loads);
        for node in &prepared.massless {
            let mut sum = zero;
            for (at, k) in &node.row {
                sum = sum + nodes[*at][0] * *k;
            }
            self.work[node.place] = loads[node.place] * w1 + sum * (1.0 - w1);
            self.predicted[node.place] = [zero; 2];
            self.weighted[node.place] = [nodes[node.place][0], zero];
        }
    }

    /// Moves the nodes between contacts in series to where the laws have them after a sub-step.
    #[cold]
    pub(super) fn move_between(&mut self, part: usize) {
        let rate = 1.0 / self.prepared.sub_steps[part].sub_step.length;
        let stage = &mut self.stages[part + 1];
        for Between {
            place,
            first: (first, factor),
            contacts,
        } in &self.prepared.between
        {
            let first = *first;
            let mut change = Lane::splat(0.0);
            for (l, curved) in self.curved[part].iter().enumerate() {
                if let Some(curved) = curved {
                    change.0[l] =
                        factor * (curved.displacement(first) - stage.contacts[first][0].0[l]);
                }
            }
            let [u, v, _] = &mut stage.nodes[*place];
            (*u, *v) = (*u + change, change * rate);
            for (contact, factor) in contacts {
                let [r, rdot, _] = &mut stage.contacts[*contact];
                (*r, *rdot) = (*r + change * *factor, *rdot + change * (rate * *factor));
            }
        }
    }
}
