//! Friction with two limits in a sub-step.

use super::stages::General;
use crate::solve::structure::contacts::static_friction::StaticFriction;
use crate::solve::structure::contacts::static_in_plane::Admissible;

impl<const L: usize> General<'_, L> {
    /// Bounds of contacts with two limits: S' is the mean over the step.
    #[cold]
    pub(super) fn begin_friction(&mut self, part: usize) {
        for limits in self.two_limits.iter_mut().flat_map(StaticFriction::all) {
            let bounds = limits.begin(None);
            self.contacts[limits.contact].bound_lane(limits.lane, bounds);
            self.forces[part].bound_lane([limits.contact, limits.lane], bounds);
        }
        for limits in self.two_limits.iter_mut().flat_map(StaticFriction::planes) {
            let curved = self.curved.get_mut(part);
            if let Some(Some(curved)) = curved.and_then(|lanes| lanes.get_mut(limits.lane)) {
                curved.bound(limits.first, Admissible::Disc(limits.begin(None)));
            }
        }
        self.forces[part].hold();
    }

    /// Ends the step of contacts in a plane.
    #[cold]
    pub(super) fn end_planes(&mut self) {
        for limits in self.two_limits.iter_mut().flat_map(StaticFriction::planes) {
            let (first, l) = (limits.first, limits.lane);
            limits.end([first, first + 1].map(|c| self.force[c].0[l]));
        }
    }

    /// Finds the forces again as long as contacts break loose.
    #[cold]
    pub(super) fn break_loose(&mut self, part: usize, end: usize) {
        let Some(friction) = &mut self.two_limits else {
            return;
        };
        let (contacts, forces) = (&mut self.contacts, &mut self.forces[part]);
        for l in 0..L {
            loop {
                let bound = |c: usize, bounds: [f64; 2]| {
                    contacts[c].bound_lane(l, bounds);
                    forces.bound_lane([c, l], bounds);
                };
                if !friction.break_loose(l, |c| self.force[c].0[l], bound) {
                    break;
                }
                let size = |c: usize, l: usize| contacts[c].size.0[l];
                forces.solve_lane([l, end], &self.trial, &size, &mut self.force);
            }
        }
        for limits in friction.all() {
            limits.end(self.force[limits.contact].0[limits.lane]);
        }
    }
}
