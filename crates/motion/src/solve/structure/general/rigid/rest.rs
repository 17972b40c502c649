//! Contacts at rest after a step with impulses: stops that stay shut, and friction that sticks.

use crate::solve::structure::general::stages::General;

impl<const L: usize> General<'_, L> {
    /// Gives nodes between which there are contacts at rest the same velocity, so that rdot is 0 and not round-off: that of their
    /// common momentum, or 0 on the ground. Returns whether anything changed.
    pub(crate) fn join(&mut self, part: usize, l: usize) -> bool {
        let prepared = self.prepared;
        let Some(impacts) = &mut self.impacts else {
            return false;
        };
        let (before, after) = self.stages.split_at_mut(part + 1);
        let (start, end) = (&before[part], &mut after[0]);
        let ground = prepared.nodes();
        let mut any = false;
        for (c, contact) in self.contacts.iter().enumerate() {
            let [_, rdot, _] = start.contacts[c];
            let bounce = rdot.0[l] * self.lines[part][c].by_bounce.0[l];
            let s = self.force[c].0[l];
            let [low, high] = contact.bounds.map(|bound| bound.0[l]);
            let rests = contact.by_impulse[l]
                && low < s
                && s < high
                && (!contact.stop[l] || impacts.is_active(c, l) && bounce == 0.0);
            // Nodes at a gap that moves have different velocities.
            let moves = self
                .moving
                .as_ref()
                .is_some_and(|moving| moving.moves(c, l));
            if !rests || moves {
                continue;
            }
            // Nodes with other factors do not have equal velocities.
            let Some(pair) = pair(prepared.along.list(c), ground) else {
                continue;
            };
            any |= end.contacts[c][1].0[l] != 0.0;
            let [i, j] = pair.map(|row| root(&impacts.with, row));
            // The ground is the last place.
            impacts.with[i.min(j)] = i.max(j);
        }
        let sub_step = &prepared.sub_steps[part].sub_step;
        for head in 0..=ground {
            if !any {
                break;
            }
            let members = || (0..ground).filter(|row| root(&impacts.with, *row) == head);
            if members().all(|row| row == head) {
                continue;
            }
            let sum = |of: &dyn Fn(usize) -> f64| members().map(of).sum::<f64>();
            let v = if head == ground {
                0.0
            } else {
                let momentum = sum(&|row| prepared.mass[row] * end.nodes[row][1].0[l]);
                momentum / sum(&|row| prepared.mass[row])
            };
            for row in members() {
                let [u0, v0, _] = start.nodes[row].map(|x| x.0[l]);
                let a = (v - v0) / sub_step.d1;
                let du = self.predicted[row][0].0[l];
                let u = u0 + (du + sub_step.d2 * a);
                for (x, new) in end.nodes[row].iter_mut().zip([u, v, a]) {
                    x.0[l] = new;
                }
            }
        }
        for (row, with) in impacts.with.iter_mut().enumerate() {
            *with = row;
        }
        any
    }
}

/// The two places of a contact whose r is the difference of their u, or the place and the ground.
fn pair(along: &[(usize, f64)], ground: usize) -> Option<[usize; 2]> {
    match *along {
        [(i, a)] if f64::abs(a) == 1.0 => Some([i, ground]),
        [(i, a), (j, b)] if f64::abs(a) == 1.0 && a + b == 0.0 => Some([i, j]),
        _ => None,
    }
}

/// The place at the end of the chain of a place.
fn root(with: &[usize], mut row: usize) -> usize {
    while with[row] != row {
        row = with[row];
    }
    row
}
