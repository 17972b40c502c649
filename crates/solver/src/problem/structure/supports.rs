//! Motions of supports in a case.

use super::template::Support;
use crate::problem::{Case, Violation};
use crate::system::structure::{Baseline, Motion, MotionFault, Signal};

impl Support {
    /// The motion in a case; without samples, a sampled one is only checked and does not move. `metre` is the study's unit of
    /// length in m.
    ///
    /// # Errors
    /// The first rule that it breaks.
    pub fn in_case(&self, case: &Case, metre: f64, samples: bool) -> Result<Motion, Violation> {
        let delay = self.delay.as_ref();
        let delay = delay.map_or(Ok(0.0), |delay| delay.value(case))?;
        let broken = |why: MotionFault| self.acceleration.source.violation(why.to_string());
        if !samples && self.acceleration.source.is_sampled() {
            self.acceleration.check(case, metre)?;
            let rest = Signal::Sine {
                amplitude: 0.0,
                omega: 0.0,
                phase: 0.0,
            };
            return Motion::new(&rest, 0.0, delay, Baseline::None).map_err(broken);
        }
        let (signal, scale) = self.acceleration.in_case(case, metre)?;
        Motion::new(&signal, scale, delay, self.baseline).map_err(broken)
    }
}
