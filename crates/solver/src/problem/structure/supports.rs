//! Motions of supports in a case.

use super::amount::Amount;
use super::template::{Course, Scaled, Support};
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
        match &self.course {
            Course::Acceleration(acceleration) => {
                self.accelerated(acceleration, delay, (case, metre, samples))
            }
            Course::Displacement(points, (at, path)) => {
                let values = |own: &Vec<Amount>| -> Result<Vec<f64>, Violation> {
                    own.iter().map(|amount| amount.value(case)).collect()
                };
                let [t, u] = points;
                Motion::through(&values(t)?, &values(u)?, delay).map_err(|why| Violation {
                    parameter: path.clone().into(),
                    message: why.to_string(),
                    at: Some(*at),
                })
            }
        }
    }

    fn accelerated(
        &self,
        acceleration: &Scaled,
        delay: f64,
        (case, metre, samples): (&Case, f64, bool),
    ) -> Result<Motion, Violation> {
        let broken = |why: MotionFault| acceleration.source.violation(why.to_string());
        if !samples && acceleration.source.is_sampled() {
            acceleration.check(case, metre)?;
            let rest = Signal::Sine {
                amplitude: 0.0,
                omega: 0.0,
                phase: 0.0,
            };
            return Motion::new(&rest, 0.0, delay, Baseline::None).map_err(broken);
        }
        let (signal, scale) = acceleration.in_case(case, metre)?;
        Motion::new(&signal, scale, delay, self.baseline).map_err(broken)
    }
}
