//! A step whose friction limits follow the forces of other parts at its end.

use super::state::Average;
use crate::lane::Lane;
use crate::solve::structure::inputs::pressing::Pressing;

impl<const L: usize> Average<'_, L> {
    /// Does a step until the limits are those of its end.
    #[cold]
    pub(super) fn repeat(&mut self, step: usize) {
        let (p, w, moved) = (self.p.clone(), self.w.clone(), self.moved.clone());
        let (contacts, force) = (self.contacts.clone(), self.force.clone());
        let (curved, two_limits) = (self.curved.clone(), self.two_limits.clone());
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
            self.p.clone_from(&p);
            self.w.clone_from(&w);
            self.moved.clone_from(&moved);
            self.contacts.clone_from(&contacts);
            self.force.clone_from(&force);
            self.curved.clone_from(&curved);
            self.two_limits.clone_from(&two_limits);
        }
        self.pressing = None;
    }

    /// S of the contacts, and u and u' of the nodes.
    fn pressed_by(&self) -> (Vec<Lane<L>>, Vec<[Lane<L>; 2]>) {
        let force = self.contacts.iter().map(|contact| contact.force);
        let nodes = 0..self.prepared.nodes();
        let motion = nodes.map(|node| [self.displacement(node), self.velocity(node)]);
        (force.collect(), motion.collect())
    }
}
