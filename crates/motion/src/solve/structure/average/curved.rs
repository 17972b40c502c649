//! Laws that are not clipped lines, in a step by the constant average acceleration method.

use super::lane_state::Average;
use crate::lane::Lane;
use crate::solve::structure::contacts::curved::lanes::meet_lane;
use crate::solve::structure::contacts::forces::Found;
use crate::solve::structure::contacts::static_friction::breaks;

impl<const L: usize> Average<'_, L> {
    /// Lets lanes whose impacts may stay open be solved as clipped lines.
    #[inline(never)]
    pub(super) fn try_lines(&mut self) {
        let mut lanes = [Found::Here; L];
        for (l, curved) in self.curved.iter().enumerate() {
            let Some(curved) = curved else {
                continue;
            };
            let start = |c: usize| {
                let contact = &self.contacts[c];
                [contact.p.0[l] - 0.5 * contact.w.0[l], contact.force.0[l]]
            };
            lanes[l] = match curved.begins_open(start) {
                true => Found::HereOrElsewhere,
                false => Found::Elsewhere,
            };
        }
        self.forces.find(lanes);
    }

    /// The forces S(i+1) of lanes with laws that are not clipped lines.
    #[inline(never)]
    pub(super) fn meet_curved(&mut self, step: usize) {
        let dt = self.prepared.dt;
        for l in 0..L {
            let Some(curved) = &mut self.curved[l] else {
                continue;
            };
            let (contacts, moving) = (&self.contacts, &self.moving);
            let (p, w, along) = (&self.p, &self.w, &self.prepared.along);
            let motion = |c: usize| {
                let size = |of: &[Lane<L>]| -> f64 {
                    let terms = along.list(c).iter();
                    terms
                        .map(|(at, factor)| (of[*at].0[l] * factor).abs())
                        .sum()
                };
                let terms = [size(p) + contacts[c].gap.0[l].abs(), size(w)];
                let mut motion = contacts[c].motion(l, dt, terms);
                if let Some(moving) = moving {
                    let [by_r, by_rate] = moving.excess(c);
                    motion.change += by_r.0[l];
                    motion.rate += 2.0 * by_rate.0[l] / dt;
                }
                motion
            };
            let forces = &mut self.forces;
            if forces.found(l) == Found::HereOrElsewhere
                && curved.ends_open(|c| self.force[c].0[l], |c| motion(c).terms)
            {
                continue;
            }
            let breaks = breaks(&mut self.two_limits, l);
            meet_lane(curved, motion, &mut self.force, forces, (l, step), breaks);
        }
    }
}
