//! A sub-step whose friction limits follow the forces of other parts at its end.

use super::stages::General;
use crate::lane::Lane;
use crate::solve::structure::inputs::pressing::Pressing;

impl<const L: usize> General<'_, L> {
    /// Does a sub-step until the limits are those of its end.
    #[cold]
    pub(super) fn repeat(&mut self, part: usize, end: usize) {
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
        let (force_now, motion) = self.pressed_by(part, 0.0);
        self.pressing = Some(Pressing::new(force_now, motion));
        loop {
            self.sub_step(part, end);
            let (force_now, motion) = self.pressed_by(part, acts_at);
            let inputs = (&self.inputs, end);
            let pressing = self.pressing.as_mut();
            if pressing.is_none_or(|own| own.follow(inputs, &force_now, &motion)) {
                break;
            }
            self.stages[part].clone_from(&start.stage);
            self.force.clone_from(&start.force);
            if let Some(curved) = self.curved.get_mut(part) {
                curved.clone_from(&start.curved);
            }
            self.two_limits.clone_from(&start.two_limits);
            self.impacts.clone_from(&start.impacts);
            self.corrections.clone_from(&start.corrections);
        }
        self.pressing = None;
        self.start = start;
    }

    /// S of the contacts at the start or the end of a sub-step, and u and u' of the nodes at this part of it.
    fn pressed_by(&self, part: usize, at: f64) -> (Vec<Lane<L>>, Vec<[Lane<L>; 2]>) {
        let [start, end] = [&self.stages[part], &self.stages[part + 1]];
        let own = if at > 0.0 { end } else { start };
        let force = own.contacts.iter().map(|[_, _, force]| *force);
        let motion = self.prepared.place.iter().map(|place| {
            let [start, end] = [start.nodes[*place], end.nodes[*place]];
            [0, 1].map(|i| start[i] + (end[i] - start[i]) * at)
        });
        (force.collect(), motion.collect())
    }
}
