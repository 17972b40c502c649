//! The forms in which a step by the constant average acceleration method is compiled.

use super::lane_state::Average;
use slipgap_contact::for_wide;

impl<const L: usize> Average<'_, L> {
    /// One step; `step` is the number of its end.
    pub(crate) fn step(&mut self, step: usize) {
        self.step = step;
        match self.pressing.take() {
            Some(pressing) => self.repeat(step, pressing),
            None => self.once(step),
        }
    }

    /// The step with the limits that are known.
    pub(super) fn once(&mut self, step: usize) {
        // A constant, so that no form is compiled that is not used.
        match const { L == 1 } {
            true => once_alone(self, step),
            false => once_wide(self, step),
        }
    }
}

// Functions of their own: every caller would compile the step again.
for_wide! {
    fn once_wide<const L: usize>(state: &mut Average<L>, step: usize) {
        state.compute(step);
    }
}

/// One structure by itself gains nothing from wide instructions; its large blocks take them by themselves.
#[inline(never)]
fn once_alone<const L: usize>(state: &mut Average<L>, step: usize) {
    state.compute(step);
}
