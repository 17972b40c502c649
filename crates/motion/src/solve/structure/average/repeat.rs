//! A step whose friction limits follow the forces of other parts at its end.

use super::lane_state::Average;
use crate::contact::Unsolved;
use crate::lane::Lane;
use crate::solve::structure::inputs::pressing::Pressing;

impl<const L: usize> Average<'_, L> {
    /// Does a step until the limits are those of its end.
    #[cold]
    pub(super) fn repeat(&mut self, step: usize, mut pressing: Pressing<L>) {
        let mut start = std::mem::take(&mut self.start);
        let lists = [&self.p, &self.w, &self.moved, &self.force];
        for (kept, now) in start.lists.iter_mut().zip(lists) {
            kept.clone_from(now);
        }
        start.contacts.clone_from(&self.contacts);
        start.curved.clone_from(&self.curved);
        start.two_limits.clone_from(&self.two_limits);
        pressing.begin(|number| self.pressed_limit(number, step));
        let unsettled = loop {
            self.pressing = Some(pressing);
            self.once(step);
            let Some(rounds) = self.pressing.take() else {
                return;
            };
            pressing = rounds;
            if let Some(unsettled) = pressing.follow(|number| self.pressed_limit(number, step)) {
                break unsettled;
            }
            let lists = [&mut self.p, &mut self.w, &mut self.moved, &mut self.force];
            for (now, kept) in lists.into_iter().zip(&start.lists) {
                now.clone_from(kept);
            }
            self.contacts.clone_from(&start.contacts);
            self.curved.clone_from(&start.curved);
            self.two_limits.clone_from(&start.two_limits);
        };
        for l in (0..L).filter(|l| unsettled[*l]) {
            self.forces.fail(l, step, Unsolved::Unsettled);
        }
        self.pressing = Some(pressing);
        self.start = start;
    }

    /// A limit with S of the contacts, and u and u' of the nodes, as they are now.
    #[inline(always)]
    fn pressed_limit(&self, number: usize, step: usize) -> Lane<L> {
        let force = |contact: usize, l: usize| self.contacts[contact].force.0[l];
        let nodes = self.nodes();
        let motion = |node: usize, l: usize| nodes.in_lane(node, l);
        self.inputs.limit(number, step, force, motion)
    }
}
