//! A sub-step whose friction limits follow the forces of other parts at its end.

use super::stages::General;
use crate::contact::Unsolved;
use crate::lane::Lane;
use crate::solve::structure::inputs::pressing::Pressing;

impl<const L: usize> General<'_, L> {
    /// Does a sub-step until the limits are those of its end.
    #[cold]
    pub(super) fn repeat(&mut self, part: usize, end: usize, mut pressing: Pressing<L>) {
        let mut start = std::mem::take(&mut self.start);
        start.stage.clone_from(&self.stages[part]);
        start.force.clone_from(&self.force);
        if let Some(curved) = self.curved.get(part) {
            start.curved.clone_from(curved);
        }
        start.two_limits.clone_from(&self.two_limits);
        start.impacts.clone_from(&self.impacts);
        start.corrections.clone_from(&self.corrections);
        // A force that acts over the whole step is that of the time at which springs have theirs.
        let sub_step = &self.prepared.sub_steps[part].sub_step;
        let acts_at = match sub_step.forces {
            [0.0, _] => sub_step.weights[1],
            [_, _] => 1.0,
        };
        pressing.begin(|number| self.pressed_limit(number, [part, end], 0.0));
        let unsettled = loop {
            self.pressing = Some(pressing);
            self.sub_step(part, end);
            let Some(rounds) = self.pressing.take() else {
                return;
            };
            pressing = rounds;
            let at_end = |number: usize| self.pressed_limit(number, [part, end], acts_at);
            if let Some(unsettled) = pressing.follow(at_end) {
                break unsettled;
            }
            self.stages[part].clone_from(&start.stage);
            self.force.clone_from(&start.force);
            if let Some(curved) = self.curved.get_mut(part) {
                curved.clone_from(&start.curved);
            }
            self.two_limits.clone_from(&start.two_limits);
            self.impacts.clone_from(&start.impacts);
            self.corrections.clone_from(&start.corrections);
        };
        for l in (0..L).filter(|l| unsettled[*l]) {
            self.forces[part].fail(l, end, Unsolved::Unsettled);
        }
        self.pressing = Some(pressing);
        self.start = start;
    }

    /// A limit with S of the contacts at the start or the end of a sub-step, and u and u' of the nodes at this part of it.
    #[inline(always)]
    fn pressed_limit(&self, number: usize, [part, end_step]: [usize; 2], at: f64) -> Lane<L> {
        let [start, end] = [&self.stages[part], &self.stages[part + 1]];
        let stage = if at > 0.0 { end } else { start };
        let motion = |node: usize, l: usize| {
            let row = self.prepared.place[node];
            let [start, end] = [start.nodes[row], end.nodes[row]];
            [0, 1].map(|i| start[i].0[l] + (end[i].0[l] - start[i].0[l]) * at)
        };
        let force = |contact: usize, l: usize| stage.contacts[contact][2].0[l];
        self.inputs.limit(number, end_step, force, motion)
    }
}
