//! The closing speed when contact began.

use super::Free;
use crate::contact::Trial;
use crate::lane::Lane;

/// Closing speeds v0 of L contacts: 0 while a contact is open, infinite if it began without closing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ClosingSpeed<const L: usize>(pub Lane<L>);

impl<const L: usize> ClosingSpeed<L> {
    /// v0 in a step with this end without its force; infinite where the contact has no damping.
    #[inline(always)]
    pub(in crate::contact) fn of_step(&mut self, trial: &Trial<L>, free: &Free<L>) -> Lane<L> {
        let v0 = &mut self.0;
        for (l, v0) in v0.0.iter_mut().enumerate() {
            let overlap = free.overlap.0[l];
            let r = trial.displacement.0[l];
            let gap = if r > 0.0 { r } else { 0.0 };
            // Part of the step before r = 0; 0/0 of an open contact is not used.
            let part = gap / (gap + overlap);
            let start = -trial.velocity.0[l];
            let rate = start + part * (free.closing.0[l] - start);
            let speed = if rate > 0.0 { rate } else { f64::INFINITY };
            let begun = if *v0 == 0.0 { speed } else { *v0 };
            *v0 = if overlap > 0.0 { begun } else { 0.0 };
        }
        // An open contact has no force; any speed does.
        v0.map(|v0| if v0 == 0.0 { f64::INFINITY } else { v0 })
    }
}
