//! A step whose friction limits follow the forces of other parts at its end.

use super::state::Average;
use crate::lane::Lane;
use crate::solve::structure::inputs::pressing::Pressing;

impl<const L: usize> Average<'_, L> {
    /// Does a step until the limits are those of its end.
    #[cold]
    pub(super) fn repeat(&mut self, step: usize) {
        let mut start = std::mem::take(&mut self.start);
        let lists = [&self.p, &self.w, &self.moved, &self.force];
        for (kept, own) in start.lists.iter_mut().zip(lists) {
            kept.clone_from(own);
        }
        start.contacts.clone_from(&self.contacts);
        start.curved.clone_from(&self.curved);
        start.two_limits.clone_from(&self.two_limits);
        let (force_now, motion) = self.pressed_by();
        self.pressing = Some(Pressing::new(force_now, motion));
        loop {
            self.once(step);
            let (force_now, motion) = self.pressed_by();
            let inputs = (&self.inputs, step);
            let pressing = self.pressing.as_mut();
            if pressing.is_none_or(|own| own.follow(inputs, &force_now, &motion)) {
                break;
            }
            let lists = [&mut self.p, &mut self.w, &mut self.moved, &mut self.force];
            for (own, kept) in lists.into_iter().zip(&start.lists) {
                own.clone_from(kept);
            }
            self.contacts.clone_from(&start.contacts);
            self.curved.clone_from(&start.curved);
            self.two_limits.clone_from(&start.two_limits);
        }
        self.pressing = None;
        self.start = start;
    }

    /// S of the contacts, and u and u' of the nodes.
    fn pressed_by(&self) -> (Vec<Lane<L>>, Vec<[Lane<L>; 2]>) {
        let force = self.contacts.iter().map(|contact| contact.force);
        let nodes = 0..self.prepared.nodes();
        let motion = nodes.map(|node| [self.displacement(node), self.velocity(node)]);
        (force.collect(), motion.collect())
    }
}
